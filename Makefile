# Everything one can do here. A target does its whole set-up: packages in .venv, the release build, rustup components.
# Times are of two cores that do nothing else, from a fresh clone; the second time a target has less to do.

PYTHON ?= $(shell command -v python3.11 || command -v python3)
VENV := .venv
PY := $(VENV)/bin/python
PIP := $(PY) -m pip install --quiet
LOGS := target/logs
SOURCES := Cargo.toml Cargo.lock pyproject.toml $(shell find core/src fit/src python/src -name '*.rs') core/Cargo.toml fit/Cargo.toml python/Cargo.toml

# One interpreter for every cargo command, so that nothing is built twice.
export PYO3_PYTHON := $(abspath $(PY))
export VIRTUAL_ENV := $(abspath $(VENV))
export PATH := $(abspath $(VENV)/bin):$(HOME)/.cargo/bin:$(PATH)
export MPLBACKEND := Agg
export PIP_DISABLE_PIP_VERSION_CHECK := 1
# Tests and pages are in English, whatever the system speaks.
export LC_ALL := C.UTF-8
unexport PYTHONPATH CONDA_PREFIX

# Two at a time: what waits for the network or for one long file leaves a core to the other.
MAKEFLAGS += -j2
unexport MAKEFLAGS
ifneq ($(filter clean,$(MAKECMDGOALS)),)
.NOTPARALLEL:
endif

MODULES := simd scalar second fit motions
.PHONY: $(MODULES:%=module-%) wasm help run quick quick-python papers page lab accuracy site test test-arm test-widget test-notebooks test-jax test-torch test-rows fuzz bench bench-full bench-elliptic bench-damped bench-oscillators bench-ensemble docs examples format lint clean kernels labdata

help: ## this list
	@sed -n 's/^\([a-z-]*\):.*## /\1 /p' $(MAKEFILE_LIST) | awk '{printf "make %-15s", $$1; $$1=""; print}'

# ---------------------------------------------------------------------------------------------- set-up

$(PY):
	@$(PYTHON) -m venv $(VENV)

$(VENV)/.needed: requirements.txt | $(PY)
	@echo "packages to build, run and draw into $(VENV)"
	@$(PIP) -r requirements.txt
	@touch $@

$(VENV)/.packages: requirements-dev.txt reference/requirements.txt $(VENV)/.needed
	@echo "packages of tests and benchmarks into $(VENV)"
	@$(PIP) -r requirements-dev.txt
	@touch $@

$(VENV)/.components: | $(PY)
	@cargo fmt --version >/dev/null 2>&1 || rustup component add rustfmt
	@cargo clippy --version >/dev/null 2>&1 || rustup component add clippy
	@rustup target list --installed | grep -q $(ARM) || rustup target add $(ARM)
	@touch $@

# Needs no Python, so it goes on while pip loads packages.
kernels:
	@mkdir -p $(LOGS)
	@cargo build --release --locked >$(LOGS)/kernels.log 2>&1 || { tail -n 60 $(LOGS)/kernels.log; exit 1; }

$(VENV)/.built: $(SOURCES) $(VENV)/.needed | kernels
	@echo "release build of the extension"
	@rm -f python/libration/_core.*.so
	@maturin develop --release --locked >$(LOGS)/build.log 2>&1 || { tail -n 60 $(LOGS)/build.log; exit 1; }
	@touch $@

# Modules of WebAssembly, with vectors and without. Loops are written out for vectors where it pays, and nowhere else.
NPM := wasm/npm
DIST := $(NPM)/dist
# The linker writes short calls where it is asked to.
WASM_FLAGS := -C no-vectorize-loops -C no-vectorize-slp -C link-arg=--compress-relocations
module-simd: WASM_FLAGS += -C target-feature=+simd128
# What a page does not need at first.
module-second: WHOLE := --features whole
CRATE := libration-wasm
PROFILE := wasm
# The fit, with vectors, the reader, g from a period: packages of their own on the same libraries.
module-fit: WASM_FLAGS += -C target-feature=+simd128
module-fit: CRATE := libration-wasm-fit
module-fit: BESIDE := reader period
module-fit: PROFILE := wasm-fit
# Springs and friction: a package of its own.
module-motions: CRATE := libration-wasm-motions
.PHONY: wasm-target
wasm-target:
	@rustup target list --installed | grep -q wasm32-unknown-unknown || rustup target add wasm32-unknown-unknown
$(MODULES:%=module-%): module-%: | wasm-target
	@mkdir -p $(LOGS) $(DIST)
	@RUSTFLAGS='$(WASM_FLAGS)' CARGO_TARGET_DIR=target/wasm-$* cargo build --locked --package $(CRATE) $(BESIDE:%=--package libration-wasm-%) --profile $(PROFILE) \
	  --target wasm32-unknown-unknown $(WHOLE) >$(LOGS)/$@.log 2>&1 || { tail -n 60 $(LOGS)/$@.log; exit 1; }
	@cd target/wasm-$*/wasm32-unknown-unknown/$(PROFILE) && cp $(subst -,_,$(CRATE)).wasm $(abspath $(DIST))/libration-$*.wasm && \
	  $(foreach each,$(BESIDE),cp libration_wasm_$(each).wasm $(abspath $(DIST))/libration-$(each).wasm &&) true

$(NPM)/node_modules/.package-lock.json: $(NPM)/package-lock.json
	@npm --prefix $(NPM) ci --no-audit --no-fund --loglevel=error
	@touch $@

# A rival that cannot be had is a row `not available`, not an error. GSL and Boost are Debian's libgsl-dev, libboost-math-dev.
$(VENV)/.rivals: $(VENV)/.packages bench/requirements.txt
	@for rival in $$(sed 's/#.*//' bench/requirements.txt); do $(PIP) "$$rival" || echo "$$rival is not available"; done
	@touch $@

# ---------------------------------------------------------------------------------------------- targets

HORSLEY := --theta0 3 --length 1m --gravity 9.8 --until 10s --samples 500

run: $(VENV)/.built ## solve Horsley's pendulum: out/motion.csv, out/motion.png (100 s)
	@mkdir -p out
	@libration solve $(HORSLEY) --out out/motion.csv --plot out/motion.png

# One instruction set and every check of the compiler, in a folder of its own.
QUICK := CARGO_TARGET_DIR=target/quick RUSTFLAGS='--cfg one_instruction_set'

quick: ## build for one instruction set and run the Rust tests named: make quick test=NAME (30 s, then 10 s)
	@mkdir -p $(LOGS)
	@$(QUICK) cargo test --quiet --locked --lib --test suite $(if $(test),-- $(test),--no-run) >$(LOGS)/quick.log 2>&1; \
	  kept=$$?; cat $(LOGS)/quick.log; test $$kept = 0
	@$(if $(test),grep -qE '[1-9][0-9]* passed' $(LOGS)/quick.log || { echo "no test has $(test) in its name"; exit 1; })

quick-python: $(VENV)/.packages ## the same for Python: make quick-python test=python/tests/FILE.py::NAME (60 s, then 10 s)
	@rm -f $(VENV)/.built python/libration/_core.*.so
	@$(QUICK) maturin develop --quiet --locked
	@$(if $(test),pytest $(QUIET) '$(test)')

papers: $(VENV)/.packages $(VENV)/.built ## draw the figures of the three papers and measure their claims: out/ (a minute)
	@libration papers

accuracy: $(VENV)/.packages $(VENV)/.built ## errors of libration and of the SciPy recipe on every row of the truth (20 s)
	@$(PY) bench/accuracy.py && $(PY) bench/accuracy_springs.py

bench: $(VENV)/.built $(VENV)/.rivals ## time and error of libration and its rivals, promised times: docs/benchmarks.md (15 minutes)
	@$(PY) bench/run.py
	@$(PY) bench/run_calls.py

bench-full: $(VENV)/.built $(VENV)/.rivals ## the same with more orbits, sizes and horizons (hours)
	@$(PY) bench/run.py --full

bench-elliptic: $(VENV)/.built $(VENV)/.rivals ## elliptic functions beside SciPy's and mpmath's: docs/elliptic.md (5 minutes)
	@$(PY) bench/run_elliptic.py

bench-oscillators: $(VENV)/.built ## oscillators beside the pendulum: docs/benchmarks-oscillators.md (1 minute)
	@$(PY) bench/run_oscillators.py

bench-damped: $(VENV)/.built $(VENV)/.rivals ## motions with friction beside heyoka and SciPy: docs/benchmarks-damped.md (5 minutes)
	@$(PY) bench/run_damped.py

bench-ensemble: $(VENV)/.built $(VENV)/.rivals ## ensembles beside NumPy and heyoka: docs/benchmarks-ensembles.md (5 minutes)
	@$(PY) bench/run_ensemble.py

labdata: $(VENV)/.packages $(VENV)/.built ## fit the measured pendulums of folder=../shared/labdata: asked, came out, holds (2 minutes)
	@$(PY) bench/labdata.py '$(or $(folder),../shared/labdata)'

examples: $(VENV)/.packages $(VENV)/.built ## draw the pictures of docs/ensembles-examples.md by the scripts of examples/ (a minute)
	@$(PY) docs/ensemble_pictures.py

docs: examples ## write every generated page, table and picture (2 minutes)
	@mkdir -p out
	@libration solve $(HORSLEY) --out out/motion.csv --plot docs/motion.png
	@$(PY) docs/pictures.py
	@$(PY) bench/accuracy.py; kept=$$?; $(PY) docs/generate.py && exit $$kept

# The pages, the lab, and what cargo and typedoc say of Rust and TypeScript; each language has a folder.
site: $(VENV)/.packages $(VENV)/.built page ## the documentation as a site, with the lab, in three languages: out/site (3 minutes)
	@rm -rf out/site out/site-parts && mkdir -p out/site-parts
	@cp -r lab/dist out/site-parts/lab
	@cargo doc --quiet --locked --no-deps --lib -p libration -p libration-fit && cp -r target/doc out/site-parts/rust
	@cd docs/typescript && npm ci --silent --no-audit --no-fund && npm run --silent pages
	@$(SITE) docs out/site && for language in pt_BR es; do $(SITE) -D language=$$language docs out/site/$$language || exit 1; done
# What is wrong in a page or leads nowhere is an error.
SITE := sphinx-build --quiet --fail-on-warning --nitpicky --builder html

wasm: $(MODULES:%=module-%) $(NPM)/node_modules/.package-lock.json ## the npm package, for browsers and Node: wasm/npm/dist (a minute)
	@cd $(NPM) && npx tsc -p tsconfig.json

# npm's packages are those of the lock file; the core is built by `wasm`.
# Debian's browser, for the tests of the page. CHROMIUM names another one.
.PHONY: chromium
chromium:
	@test -n "$$CHROMIUM" || command -v chromium >/dev/null || command -v google-chrome >/dev/null || { \
	  echo "installing Debian's chromium"; sudo=; test $$(id -u) = 0 || sudo=sudo; $$sudo apt-get -qq update && $$sudo apt-get -qq -y install chromium >/dev/null; }

# Debian's Octave and R, for the texts of code (70 s). After the browser: two installations at once do not go.
.PHONY: octave-and-r
octave-and-r: chromium
	@command -v octave >/dev/null && command -v Rscript >/dev/null || { \
	  echo "installing Debian's octave and r-base-core"; sudo=; test $$(id -u) = 0 || sudo=sudo; \
	  $$sudo apt-get -qq update && $$sudo apt-get -qq -y install --no-install-recommends octave r-base-core >/dev/null; }

lab/node_modules/.needed: lab/package-lock.json
	@cd lab && npm ci --silent --no-audit --no-fund
	@touch $@

page: wasm lab/node_modules/.needed ## build the page into lab/dist, with lab/dist/offline.html, and into the package (a minute)
	@mkdir -p $(LOGS)
	@cd lab && npm run build >../$(LOGS)/page.log 2>&1 || { tail -n 40 ../$(LOGS)/page.log; exit 1; }
	@rm -rf python/libration/page && cp -r lab/dist python/libration/page

lab: page ## build the page and serve it at 127.0.0.1
	@cd lab && npm run --silent serve

format: $(VENV)/.packages $(VENV)/.components ## write every file the way the formatters do (2 s)
	@cargo fmt --all
	@ruff check --quiet --fix-only --select I .
	@ruff format --quiet .

lint: test/format test/lint-rust test/lint-python test/types ## what formatters, linters and type checks say (a minute)

clean: ## remove what the targets above have made
	rm -rf $(VENV) target out dist $(DIST) $(NPM)/build $(NPM)/node_modules
	find . -name __pycache__ -type d -prune -exec rm -rf {} +
	rm -f python/libration/*.so

# ---------------------------------------------------------------------------------------------- steps of test

STEPS := python rust wasm truth rust-checked lint-rust format lint-python types laws checks-tested pages site bench lab snippets clean-install

test: $(STEPS:%=test/%) ## everything a reviewer would run; what CI runs (7 minutes)
	@cat $(STEPS:%=$(LOGS)/%.log) | grep -oE '[0-9]+ passed' | awk '{ n += $$1 } END { print n " passed, 0 failed" }'
	@echo "All passed."

# One line a step; what it printed stands in target/logs and is shown when it fails.
step = @mkdir -p $(LOGS); begun=$$(date +%s); \
  if ( $(1) ) >$(LOGS)/$(@F).log 2>&1 </dev/null; then printf '%-16s holds  %s s\n' $(@F) $$(($$(date +%s) - begun)); \
  else echo '$(@F) FAILED'; tail -n 150 $(LOGS)/$(@F).log; exit 1; fi

QUIET := -q -p no:cacheprovider
TOOLS := $(VENV)/.packages $(VENV)/.components

.PHONY: $(STEPS:%=test/%)

test/format: $(TOOLS)
	$(call step,cargo fmt --all --check && ruff format --check .)

test/lint-rust: $(TOOLS)
	$(call step,cargo clippy --locked --workspace --all-targets -- -D warnings && \
	  cargo clippy --locked -p libration --target $(ARM) -- -D warnings)

test/lint-python: $(TOOLS)
	$(call step,ruff check .)

test/types: $(TOOLS)
	$(call step,mypy --no-error-summary python/libration)

test/laws: $(TOOLS) $(VENV)/.built
	$(call step,for law in $(LAWS); do $(PY) checks/$$law.py || failed=1; done; test -z "$$failed")
LAWS := rooms circles names typescript_names type_names functions pages links versions

test/checks-tested: $(TOOLS) $(VENV)/.built
	$(call step,pytest $(QUIET) checks)

test/truth: $(TOOLS)
	$(call step,$(PY) reference/check.py)

# The code that is shipped, on every instruction set of this processor.
test/rust: kernels
	$(call step,cargo test --release --locked --test suite && cargo test --release --locked --doc)

# The page: its lint, its tests without a browser and in one; its types are checked by its build, its budgets by `npm run weigh`.
test/lab: chromium page
	$(call step,cd lab && npm run --silent lint && npm run --silent weigh && npm test --silent && npm run --silent stories)

# The texts of code that the page gives, run by Octave and R; those in Python are in test/python.
test/snippets: $(TOOLS) $(VENV)/.built octave-and-r
	$(call step,pytest $(QUIET) python/tests/octave_and_r.py)

# The same tests and those inside the files with checks of overflow and of every assertion, on one instruction set.
test/rust-checked:
	$(call step,$(QUICK) cargo test --locked --lib --test suite -p libration -p libration-fit)

test/python: $(TOOLS) $(VENV)/.built
	$(call step,pytest $(QUIET) -n 2 --dist worksteal --doctest-modules --ignore=python/libration/torch python/tests python/libration)

# The package as it is published, against the truth that the native core is held to: with vectors and without.
test/wasm: wasm
	$(call step,cd $(NPM) && npx tsc -p tsconfig.test.json && for module in simd scalar; do \
	  LIBRATION_MODULE=$$module node --test build/test/*.test.js || failed=1; done; test -z "$$failed")

test/pages: $(TOOLS) $(VENV)/.built
	$(call step,$(PY) bench/accuracy.py --check && pytest $(QUIET) --doctest-glob='*.md' README.md docs && $(PY) checks/examples.py)

# Every link and anchor of the site, every name that its reference shows, and every message of the pages that are translated.
test/site: $(TOOLS) $(VENV)/.built
	$(call step,$(SITE) docs target/site && sphinx-build --quiet -b gettext docs target/messages && \
	  $(PY) docs/languages.py target/messages && $(PY) docs/sentences.py)

test/bench: $(TOOLS) $(VENV)/.built
	$(call step,pytest $(QUIET) bench && $(PY) bench/run.py --check && $(PY) bench/run_elliptic.py --check && $(PY) bench/run_damped.py --check && $(PY) bench/run_ensemble.py --check)

# The wheel as `pip install .` makes it, in an environment that holds nothing else: every door, and the truth.
FRESH := target/fresh
test/clean-install: $(TOOLS) $(VENV)/.built page
	$(call step,$(CLEAN_INSTALL))
CLEAN_INSTALL = rm -rf $(FRESH) && $(PY) -m pip wheel --quiet --no-deps --no-build-isolation --wheel-dir $(FRESH)/wheel . \
  && $(PYTHON) -m venv $(FRESH) && $(FRESH)/bin/python -m pip install --quiet $(FRESH)/wheel/*.whl && cd target \
  && fresh/bin/python ../packages/exercise.py

# aarch64 by qemu: Debian's qemu-user and gcc-aarch64-linux-gnu.
ARM := aarch64-unknown-linux-gnu
export CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER := aarch64-linux-gnu-gcc
export CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_RUNNER := qemu-aarch64 -L /usr/aarch64-linux-gnu

# cargo-fuzz in a folder of its own. A found input stands in fit/fuzz/artifacts; seeds begin with a byte that states options.
FUZZ_TOOLS := target/fuzz-tools
fuzz: ## ten minutes of random bytes for the reader of files; seconds=N for less (needs the nightly compiler; 5 minutes more the first time)
	@test -x $(FUZZ_TOOLS)/bin/cargo-fuzz || cargo install --quiet --locked --root $(FUZZ_TOOLS) cargo-fuzz
	@rustup toolchain list | grep -q nightly || rustup toolchain install nightly --profile minimal
	@mkdir -p fit/fuzz/corpus
	@cd fit/fuzz && PATH=$(abspath $(FUZZ_TOOLS))/bin:$$PATH CARGO_TARGET_DIR=$(abspath target/fuzz) cargo +nightly fuzz run read corpus seeds -- \
	  -max_len=65536 -timeout=5 -malloc_limit_mb=64 -max_total_time=$(or $(seconds),600)

test-rows: ## the tests of columns against the careful code with times=N (30) as many random rows, a million and more (minutes)
	ROWS_TIMES=$(or $(times),30) cargo test --release --locked -p libration --lib --test suite -- own_ row_tests --nocapture

test-jax: $(VENV)/.packages $(VENV)/.built ## gradients by JAX in every stratum, second derivatives too: its compiler takes most of the time (3 minutes)
	@$(PY) -m pytest -q python/tests_jax

# In an environment of its own: on Linux its wheels are those for GPUs, 5 GB.
TORCH := target/torch
$(TORCH)/.packages: requirements-torch.txt
	@$(PYTHON) -m venv $(TORCH)
	@$(TORCH)/bin/python -m pip install --quiet -r requirements-torch.txt
	@touch $@

test-torch: $(TORCH)/.packages $(VENV)/.built ## gradients by PyTorch; installs it, 5 GB, the first time (10 minutes, then 1)
	@PYTHONPATH=python $(TORCH)/bin/python -m pytest -q -o pythonpath=python/tests_jax --doctest-modules python/tests_torch python/libration/torch

# JupyterLab and marimo in an environment of their own, over that of the tests.
NOTEBOOKS := target/notebooks
$(NOTEBOOKS)/.packages: requirements-notebooks.txt $(VENV)/.built
	@$(PYTHON) -m venv $(NOTEBOOKS)
	@$(NOTEBOOKS)/bin/python -m pip install --quiet -r requirements.txt -r requirements-notebooks.txt
	@touch $@

test-widget: $(NOTEBOOKS)/.packages chromium page ## a pendulum in JupyterLab, in Chromium: draws, and its sliders write to Python (2 minutes)
	@PYTHONPATH=$(abspath python) $(NOTEBOOKS)/bin/python lab/tests/widget/run.py target/widget.png

test-notebooks: $(NOTEBOOKS)/.packages page ## the notebooks as Jupyter reads them, and the apps in marimo (a minute)
	@PYTHONPATH=$(abspath python) $(NOTEBOOKS)/bin/python -m pytest -q -p no:cacheprovider python/tests_notebooks

test-arm: $(VENV)/.components ## the Rust tests through NEON, by Debian's qemu-user and gcc-aarch64-linux-gnu (20 minutes)
	@command -v qemu-aarch64 >/dev/null && command -v $(CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER) >/dev/null || { \
	  echo "installing Debian's qemu-user and gcc-aarch64-linux-gnu"; sudo=; test $$(id -u) = 0 || sudo=sudo; \
	  $$sudo apt-get -qq update && $$sudo apt-get -qq -y install qemu-user gcc-aarch64-linux-gnu libc6-dev-arm64-cross >/dev/null; }
	CARGO_TARGET_DIR=target/arm cargo test --release --locked --target $(ARM) --test suite -- --nocapture

include packages/targets.mk
