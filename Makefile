# `make demo` and `make test` set up all they need: Debian packages, .venv, build/release.
SHELL := /bin/bash
.SHELLFLAGS := -eu -o pipefail -c
.DEFAULT_GOAL := help
PYTHON ?= python3
PYTHONS ?= $(PYTHON)
JOBS ?= $(shell nproc)
BIN := $(CURDIR)/.venv/bin
BUILD := build/release
export PATH := $(BIN):$(PATH)
export PIP_DISABLE_PIP_VERSION_CHECK := 1
export CCACHE_BASEDIR := $(CURDIR)
export CCACHE_NOHASHDIR := 1
export NO_MKDOCS_2_WARNING := 1
export LAPILLI_BUILD := $(CURDIR)/$(BUILD)

# What is read as prose, in British spelling.
TEXTS := README.md CONTRIBUTING.md CHANGELOG.md SECURITY.md CODE_OF_CONDUCT.md docs

# In place: the compiled part is built beside its sources, by cmake below.
INSTALL := pip install --quiet --no-build-isolation --config-settings=wheel.cmake=false \
  --config-settings=editable.mode=inplace --editable

.PHONY: help program demo test verify mutate house bench fronts verification extremes docs lint tidy wheel stubs build clean

help:  ## list the targets
	@awk -F ':.*## ' '/^[a-z]+:.*## / {printf "make %-9s %s\n", $$1, $$2}' $(MAKEFILE_LIST)

build/.packages: tools/system_packages.sh
	@PYTHON=$(PYTHON) tools/system_packages.sh
	@mkdir -p build && touch $@

.venv/.ready: pyproject.toml build/.packages
	@test -x $(BIN)/python || $(PYTHON) -m venv .venv
	@echo "Installing Python packages into .venv"
	@pip install --quiet "scikit-build-core>=0.10" "pybind11>=3.0,<3.2" "cmake>=3.25" ninja
	@$(INSTALL) '.[plot,test,docs]'
	@touch $@

$(BUILD)/build.ninja: .venv/.ready
	@cmake -S . -B $(BUILD) -G Ninja -DCMAKE_BUILD_TYPE=Release -DLAPILLI_PYTHON=ON \
	  -DPython_EXECUTABLE=$(BIN)/python \
	  $$(if command -v ccache >/dev/null; then echo -DCMAKE_CXX_COMPILER_LAUNCHER=ccache; fi) >build/configure.log \
	  || { cat build/configure.log; exit 1; }
	@touch $@

program: $(BUILD)/build.ninja  ## build library, executable and Python module
	@cmake --build $(BUILD) --parallel $(JOBS) --target lapilli-run _core

build: $(BUILD)/build.ninja  ## build everything: the program and its tests
	@cmake --build $(BUILD) --parallel $(JOBS)

demo: program  ## heat the ring: progress, frames, a picture, lapilli beside the reference
	@mkdir -p demo
	@lapilli run examples/vhfm/ring.toml --output demo/ring.vtkhdf
	@lapilli plot demo/ring.vtkhdf --save demo/ring.png
	@lapilli reproduce vhfm/ring --quick --plot demo

test: build  ## every test that is not slow (ctest, then pytest)
	@failed=0; \
	ctest --test-dir $(BUILD) --output-on-failure --parallel $(JOBS) || failed=1; \
	pytest -m 'not slow' -n $(JOBS) || failed=1; \
	exit $$failed

verify: build  ## lint, tidy, slow tests, torture, sanitizers, fuzzers, every case of the papers
	@tools/system_packages.sh clang-14 libomp-14-dev libclang-rt-14-dev llvm-14
	@python tools/verify.py --jobs $(JOBS)

mutate: .venv/.ready  ## break the kernels in small ways, one at a time: which do the tests not see?
	@python tools/mutate.py --jobs $(JOBS) --resume

house: .venv/.ready  ## includes that run up, circles, long files and functions
	@python tools/house.py

bench: build  ## throughput, and error against cost: the tables of the README
	@tools/system_packages.sh libbenchmark-dev
	@cmake -S . -B $(BUILD) -DLAPILLI_BENCH=ON >/dev/null && cmake --build $(BUILD) --parallel $(JOBS)
	@python bench/run.py

fronts: program  ## where the defaults lie between error and cost, for scenes of all methods
	@python bench/fronts.py --manual

verification: program  ## the rows of the manual's verification page
	@lapilli reproduce --quick --json docs/verification.json || test $$? -eq 4 # a bar is missed: shown

extremes: program  ## the map of stable, inaccurate and refused steps
	@lapilli extremes --plot demo --json demo/extremes.json

lint: build  ## formatting, style, types and spelling
	@tools/system_packages.sh clang-format
	@git ls-files '*.cpp' '*.hpp' | xargs /usr/bin/clang-format --dry-run --Werror
	@ruff check python tests/python tools bench
	@ruff format --check python tests/python tools bench
	@mypy
	@codespell $(TEXTS) cpp python examples tools
	@codespell --dictionary tools/american.txt $(TEXTS)

tidy: build  ## clang-tidy over all C++ sources (half an hour)
	@tools/system_packages.sh clang-tidy
	@JOBS=$(JOBS) tools/tidy.sh

stubs: program  ## write python/lapilli/_core.pyi anew
	@python tools/write_stubs.py

docs: program  ## the manual, in site/: open site/index.html
	@mkdocs build --strict

wheel: .venv/.ready  ## a wheel for each of PYTHONS that runs without compiler and -dev packages, in dist/
	@python tools/wheel.py $(PYTHONS)

clean:  ## remove everything that was built; .venv stays
	@rm -rf build dist site python/lapilli/_core*.so
