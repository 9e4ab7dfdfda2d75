# Packages: what is published, made in dist/, and each tried where it will be used. Included by the Makefile of the root.
# The interpreters are those that this machine has; another one is tried by `make test-wheel PYTHONS=/its/path`.

.PHONY: wheel wheels wheel-x86_64 wheel-aarch64 wheel-windows sdist crates npm-package

OUT := dist
CROSS := CARGO_TARGET_DIR=$(abspath target/wheels)
TRY := $(PY) packages/try_wheel.py
# 3.11 and later, those without a lock too.
PYTHONS ?= $(shell packages/interpreters.sh)
# glibc 2.17: every Linux since 2014.
OLDEST := --compatibility manylinux2014 --zig

$(VENV)/.package-tools: packages/requirements.txt $(VENV)/.needed
	@$(PIP) -r packages/requirements.txt
	@touch $@

wheel: page $(VENV)/.built ## a wheel for this machine in dist/ (100 s)
	@maturin build --release --locked --out $(OUT)

wheels: wheel-x86_64 wheel-aarch64 wheel-windows ## wheels for Linux on x86-64 and aarch64 and for Windows, by cross-compilation (10 minutes)

wheel-x86_64 wheel-aarch64: wheel-%: page $(VENV)/.package-tools
	@rustup target list --installed | grep -q $*-unknown-linux-gnu || rustup target add $*-unknown-linux-gnu
	@$(CROSS) maturin build --release --locked --target $*-unknown-linux-gnu $(OLDEST) --out $(OUT)

# mingw-w64 links; the import library of Python is made by the build.
wheel-windows: page $(VENV)/.package-tools
	@rustup target list --installed | grep -q x86_64-pc-windows-gnu || rustup target add x86_64-pc-windows-gnu
	@command -v x86_64-w64-mingw32-gcc >/dev/null || { echo "installing Debian's gcc-mingw-w64-x86-64"; sudo=; test $$(id -u) = 0 || sudo=sudo; \
	  $$sudo apt-get -qq update && $$sudo apt-get -qq -y install --no-install-recommends gcc-mingw-w64-x86-64-win32 >/dev/null; }
	@$(CROSS) maturin build --release --locked --target x86_64-pc-windows-gnu --out $(OUT)

sdist: page $(VENV)/.needed ## the source distribution in dist/: the checkout, its truth and the page
	@maturin sdist --out $(OUT)

# A crate has the licences beside it; the README of core is that of the repository.
CRATES := --package libration --package libration-fit
crates: ## the crates as they are published, built from what is packed: target/package (3 minutes)
	@cp LICENSE-* core/ && cp LICENSE-* fit/
	@cargo package --locked --allow-dirty $(CRATES)

npm-package: wasm ## the npm package as it is published, in dist/
	@mkdir -p $(OUT) && cp LICENSE-* $(NPM)/ && cd $(NPM) && npm pack --silent --pack-destination $(abspath $(OUT))

# ---------------------------------------------------------------------------------------------- each tried

PACKAGE_TESTS := test-metadata test-wheel test-wheel-newest test-wheel-aarch64 test-wheel-windows test-sdist test-conda test-crates test-npm
.PHONY: test-packages $(PACKAGE_TESTS)
test-packages: $(PACKAGE_TESTS) ## every package, installed and tried where nothing else is: no Rust, no Node, no compiler (30 minutes)

# The newest of a platform.
WHEEL_OF = $$(ls -t $(OUT)/libration-*-abi3-*$(1).whl | head -1)
INSTALLED = $(abspath target/packages/$(1))
installed = command -v $(1) >/dev/null || test -x $(2) || { echo "installing Debian's $(3)"; sudo=; test $$(id -u) = 0 || sudo=sudo; \
  $$sudo apt-get -qq update && $$sudo apt-get -qq -y install --no-install-recommends $(3) >/dev/null; }

# The names, the classifiers and the addresses of every package; one version and one address for all.
test-metadata: sdist $(VENV)/.package-tools
	@$(PY) checks/versions.py
	@validate-pyproject pyproject.toml >/dev/null
	@cffconvert --validate >/dev/null
	@twine check --strict $(OUT)/libration-*.tar.gz

test-wheel: wheel-x86_64
	@auditwheel show $(call WHEEL_OF,manylinux*x86_64) | tr '\n' ' ' | grep -oE 'manylinux_2_(5|12|17)_x86_64' | head -1
	@abi3audit --strict --summary $(call WHEEL_OF,manylinux*x86_64)
	@$(TRY) $(call WHEEL_OF,manylinux*x86_64) $(PYTHONS)

# Seconds of a newcomer, on one screen; with nothing else at work on the machine, and pip's packages as its cache or the network has them.
.PHONY: first-answer
first-answer: ## how long it takes from an empty folder to the first answer, by the wheel in dist/ (10 s)
	@$(PYTHON) packages/first_answer.py $(or $(wheel),$(call WHEEL_OF,manylinux*x86_64)) $(PYTHON)

# The newest that Debian has, with its own library of C.
NEWEST ?= 3.15
test-wheel-newest: wheel-x86_64
	@test -x $(call INSTALLED,amd64-$(NEWEST))/usr/bin/python$(NEWEST) || packages/debian.sh amd64 $(NEWEST) $(call INSTALLED,amd64-$(NEWEST))
	@own=$(call INSTALLED,amd64-$(NEWEST)); $(TRY) $(call WHEEL_OF,manylinux*x86_64) --for x86_64 $(NEWEST) -- \
	  $$own/lib64/ld-linux-x86-64.so.2 --library-path $$own/usr/lib/x86_64-linux-gnu $$own/usr/bin/python$(NEWEST)

# By emulation: the truth through NEON.
EMULATED ?= 3.14
test-wheel-aarch64: wheel-aarch64
	@$(call installed,qemu-aarch64,/usr/bin/qemu-aarch64,qemu-user)
	@test -x $(call INSTALLED,arm64-$(EMULATED))/usr/bin/python$(EMULATED) || packages/debian.sh arm64 $(EMULATED) $(call INSTALLED,arm64-$(EMULATED))
	@$(TRY) $(call WHEEL_OF,manylinux*aarch64) --for aarch64 $(EMULATED) -- \
	  qemu-aarch64 -L $(call INSTALLED,arm64-$(EMULATED)) $(call INSTALLED,arm64-$(EMULATED))/usr/bin/python$(EMULATED)

# By Wine, with the CPython that Maven Central has. Wine 8 lacks functions of C that a newer NumPy calls.
WINE := /usr/lib/wine/wine64
test-wheel-windows: wheel-windows
	@$(call installed,wine64,$(WINE),wine64)
	@test -f $(call INSTALLED,windows)/python/python.exe || packages/windows.sh $(call INSTALLED,windows)
	@WINEPREFIX=$(call INSTALLED,wine) WINEDEBUG=-all WINEDLLOVERRIDES=mscoree,mshtml= $(TRY) $(call WHEEL_OF,win_amd64) --for win_amd64 3.13 numpy==2.1.3 -- \
	  $(WINE) $(call INSTALLED,windows)/python/python.exe

# What the source distribution builds, without Node; the truth is its own. One instruction set: what is asked is whether everything is there.
BUILT = RUSTFLAGS='--cfg one_instruction_set' CARGO_TARGET_DIR=$(abspath target/packages/built)
test-sdist: sdist $(VENV)/.packages
	@rm -rf target/packages/sdist && mkdir -p target/packages/sdist
	@tar -xzf $(OUT)/libration-*.tar.gz --strip-components 1 -C target/packages/sdist
	@cd target/packages/sdist && PATH=$(dir $(shell command -v cargo)):$(abspath $(VENV))/bin:/usr/bin:/bin \
	  $(BUILT) $(abspath $(PY)) -m pip wheel --quiet --no-deps --no-build-isolation --wheel-dir ../wheel .
	@cd target/packages/sdist && $(abspath $(PY)) packages/try_wheel.py ../wheel/libration-*.whl $(firstword $(PYTHONS))
	@cd target/packages/sdist && $(abspath $(PY)) reference/check.py complete.csv

# The recipe as rattler-build reads it, its script and its tests, on the source distribution: conda's channels are not asked.
test-conda: sdist $(VENV)/.package-tools
	@$(BUILT) $(PY) packages/try_recipe.py

test-crates: crates
	@cd target/package && for each in libration libration-fit; do ls $$each-*.crate >/dev/null || exit 1; done

# Node alone, in a folder that has nothing else.
test-npm: npm-package
	@rm -rf target/packages/npm && mkdir -p target/packages/npm
	@cd target/packages/npm && npm init -y >/dev/null && npm install --silent --no-audit --no-fund --offline $(abspath $(OUT))/libration-*.tgz \
	  && cp $(abspath packages/exercise.mjs) . && node exercise.mjs $(CURDIR)/reference/vectors/pendulum.csv
