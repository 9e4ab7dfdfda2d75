# Everything one can do here. A target does its whole set-up: packages in .venv, the release build, rustup components.

PYTHON ?= $(shell command -v python3.11 || command -v python3)
VENV := .venv
PY := $(VENV)/bin/python
LOGS := target/logs
SOURCES := Cargo.toml Cargo.lock pyproject.toml $(shell find core python/src -name '*.rs' -o -name Cargo.toml)

# One interpreter for every cargo command, so that nothing is built twice.
export PYO3_PYTHON := $(abspath $(PY))
export VIRTUAL_ENV := $(abspath $(VENV))
export PATH := $(abspath $(VENV)/bin):$(HOME)/.cargo/bin:$(PATH)
export MPLBACKEND := Agg
export PIP_DISABLE_PIP_VERSION_CHECK := 1
unexport PYTHONPATH CONDA_PREFIX

.PHONY: help run papers test bench bench-full bench-elliptic accuracy docs wheel format lint clean setup
.NOTPARALLEL:

help: ## this list
	@sed -n 's/^\([a-z-]*\):.*## /\1 /p' $(MAKEFILE_LIST) | awk '{printf "make %-15s", $$1; $$1=""; print}'

# ---------------------------------------------------------------------------------------------- set-up

$(VENV)/.packages: requirements-dev.txt reference/requirements.txt
	@echo "packages of tests and benchmarks into $(VENV)"
	@test -x $(PY) || $(PYTHON) -m venv $(VENV)
	@$(PY) -m pip install --quiet -r requirements-dev.txt
	@touch $@

$(VENV)/.components:
	@mkdir -p $(VENV)
	@cargo fmt --version >/dev/null 2>&1 || rustup component add rustfmt
	@cargo clippy --version >/dev/null 2>&1 || rustup component add clippy
	@touch $@

$(VENV)/.built: $(VENV)/.packages $(SOURCES)
	@echo "release build of the extension"
	@mkdir -p $(LOGS)
	@maturin develop --release --locked >$(LOGS)/build.log 2>&1 || { tail -n 60 $(LOGS)/build.log; exit 1; }
	@touch $@

# A rival that cannot be had is a row `not available`, not an error. GSL and Boost are Debian's libgsl-dev, libboost-math-dev.
$(VENV)/.rivals: $(VENV)/.packages bench/requirements.txt
	@for rival in $$(sed 's/#.*//' bench/requirements.txt); do \
	  $(PY) -m pip install --quiet "$$rival" || echo "$$rival is not available"; done
	@touch $@

setup: $(VENV)/.packages $(VENV)/.components $(VENV)/.built

# ---------------------------------------------------------------------------------------------- targets

HORSLEY := --theta0 3 --length 1m --gravity 9.8 --until 10s --samples 500

run: $(VENV)/.built ## solve Horsley's pendulum: out/motion.csv, out/motion.png
	@mkdir -p out
	@libration solve $(HORSLEY) --out out/motion.csv --plot out/motion.png

papers: $(VENV)/.built ## draw the figures of the three papers and measure their claims: out/
	@libration papers

accuracy: $(VENV)/.built ## errors of libration and of the SciPy recipe on every row of the truth
	@$(PY) bench/accuracy.py

bench: $(VENV)/.built $(VENV)/.rivals ## time and error of libration and its rivals, in 15 minutes: docs/benchmarks.md
	@$(PY) bench/run.py

bench-full: $(VENV)/.built $(VENV)/.rivals ## the same with more orbits, sizes and horizons, as long as it takes
	@$(PY) bench/run.py --full

bench-elliptic: $(VENV)/.built ## elliptic functions beside SciPy's and mpmath's, in five minutes: docs/elliptic.md
	@$(PY) bench/run_elliptic.py

docs: $(VENV)/.built ## write every generated page, table and picture
	@mkdir -p out
	@libration solve $(HORSLEY) --out out/motion.csv --plot docs/motion.png
	@$(PY) docs/pictures.py
	@$(PY) bench/accuracy.py; kept=$$?; $(PY) docs/generate.py && exit $$kept

wheel: $(VENV)/.built ## a wheel for this machine in dist/
	@maturin build --release --locked --out dist

format: $(VENV)/.packages $(VENV)/.components ## write every file the way the formatters do
	@cargo fmt --all
	@ruff check --quiet --fix-only --select I .
	@ruff format --quiet .

lint: $(VENV)/.packages $(VENV)/.components ## what formatters, linters and type checks say
	$(call step,format,$(FORMAT))
	$(call step,lint-rust,$(CLIPPY))
	$(call step,lint-python,ruff check .)
	$(call step,types,$(TYPES))

test: setup ## everything a reviewer would run; what CI runs
	@rm -rf $(LOGS)/test; mkdir -p $(LOGS)/test
	$(call step,format,$(FORMAT))
	$(call step,lint-rust,$(CLIPPY))
	$(call step,lint-python,ruff check .)
	$(call step,types,$(TYPES))
	$(call step,laws,$(LAWS))
	$(call step,checks-tested,pytest $(QUIET) checks)
	$(call step,truth,$(PY) reference/check.py)
	$(call step,rust,cargo test --locked --package libration)
	$(call step,python,pytest $(QUIET) --doctest-modules python/tests python/libration)
	$(call step,pages,$(PAGES))
	$(call step,bench,$(BENCH))
	$(call step,clean-install,$(CLEAN_INSTALL))
	@cat $(LOGS)/test/*.log | grep -oE '[0-9]+ passed' | awk '{ n += $$1 } END { print n " passed, 0 failed" }'
	@echo "All passed."

clean: ## remove what the targets above have made
	rm -rf $(VENV) target out dist
	find . -name __pycache__ -type d -prune -exec rm -rf {} +
	rm -f python/libration/*.so

# ---------------------------------------------------------------------------------------------- steps of test

# One line a step; what it printed stands in target/logs/test and is shown when it fails.
step = @mkdir -p $(LOGS)/test; printf '%-16s' '$(1)'; begun=$$(date +%s); \
  if ( $(2) ) >$(LOGS)/test/$(1).log 2>&1 </dev/null; then echo "holds  $$(($$(date +%s) - begun)) s"; \
  else echo FAILED; tail -n 150 $(LOGS)/test/$(1).log; exit 1; fi

QUIET := -q -p no:cacheprovider
FORMAT := cargo fmt --all --check && ruff format --check .
CLIPPY := cargo clippy --locked --workspace --all-targets -- -D warnings
TYPES := mypy --no-error-summary python/libration
LAWS := for law in rooms names functions pages links; do $(PY) checks/$$law.py || failed=1; done; test -z "$$failed"
PAGES := $(PY) bench/accuracy.py --check && pytest $(QUIET) --doctest-glob='*.md' README.md docs && $(PY) checks/examples.py

BENCH := pytest $(QUIET) bench && $(PY) bench/run.py --check && $(PY) bench/run_elliptic.py --check

# `pip install .` as a user has it, in an environment that holds nothing else, and one call from each door.
FRESH := target/fresh
CLEAN_INSTALL := unset PYO3_PYTHON VIRTUAL_ENV && rm -rf $(FRESH) && $(PYTHON) -m venv $(FRESH) \
  && CARGO_TARGET_DIR=target/wheel $(FRESH)/bin/python -m pip install --quiet . && cd target \
  && fresh/bin/python -c 'import libration; print(libration.Pendulum(3.0).period)' \
  && fresh/bin/libration period --theta0 150deg
