# SPDX-License-Identifier: MIT
# The short way in; CMakePresets.json is the long one. `make help` tells what there is.
SHELL := /bin/bash
PREFIX ?= /usr/local
JOBS ?= $(shell nproc)
OUT ?= out/demo

# ninja and ccache are taken where they are, and not needed.
export CMAKE_GENERATOR ?= $(if $(shell command -v ninja),Ninja,Unix Makefiles)
ifneq ($(shell command -v ccache),)
export CMAKE_CXX_COMPILER_LAUNCHER ?= ccache
endif
export CMAKE_BUILD_PARALLEL_LEVEL ?= $(JOBS)

.PHONY: all configure demo test check test-asan test-tsan test-arm64 test-web web fuzz soak bench deb install format tidy packages clean help

all: configure  ## build the programs and libraries: build/bin/odas, build/bin/odaslive, build/bin/odasserver
	cmake --build build --target programs

# A first configuration that failed leaves a cache behind, but nothing to build with: then it is done again.
configure:
	@[[ -e build/build.ninja || -e build/Makefile ]] || { scripts/install_packages.sh --check build && \
	  cmake --preset release -DODAS_BUILD_TESTS=OFF -DODAS_BUILD_BENCHES=OFF; }

demo:  ## hear the sample recording: who was where, a report, the voices, in out/demo; then the Studio (STUDIO=0: not)
	@scripts/install_packages.sh build
	@$(MAKE) --no-print-directory all
	build/bin/odas run samples/sample_4mic.flac -c configs/sample.cfg -o $(OUT)
ifneq ($(STUDIO),0)
	@echo
	@exec build/bin/odas studio configs/sample.cfg --play samples/sample_4mic.flac --loop --any-port
endif

test:  ## all that must hold: both compilers, sanitizers, arm64, style, the page, every test (CI runs this)
	@scripts/install_packages.sh build test
	@scripts/test.sh check web asan arm64-if-possible tsan

check:  ## the tests of the release build, and the style: the quick part of `make test`
	@scripts/install_packages.sh build test
	@scripts/test.sh check

test-asan test-tsan test-arm64:  ## one part of `make test`: ASan and UBSan, TSan, or arm64 under qemu
	@scripts/install_packages.sh build test
	@scripts/test.sh $(@:test-%=%)

test-web: all  ## the Studio's page: types, units, its bundle byte for byte, all of it in chromium
	@scripts/test.sh web

web:  ## build the Studio's page anew, in web/dist (Node; a build of odas needs none)
	@scripts/install_packages.sh web
	cd web && npm ci --no-audit --no-fund && npm run build

fuzz:  ## each fuzzer for an hour (FUZZ_SECONDS=3600)
	@scripts/install_packages.sh build test
	@scripts/test.sh fuzz

soak:  ## the long forms of the tests of devices and peers: minutes instead of seconds
	@scripts/install_packages.sh build test
	@scripts/test.sh soak

bench:  ## microseconds a hop of each stage, share of real time, instructions, start-up
	@scripts/install_packages.sh build bench
	cmake --preset release -DODAS_BUILD_BENCHES=ON
	cmake --build build --target programs odas_bench
	@bench/run.sh build

install: all  ## install under PREFIX (/usr/local); DESTDIR is heeded
	cmake --install build --prefix $(PREFIX)

deb:  ## Debian packages in build/packages, for this machine and for arm64 (make deb ARCH=amd64: one of them)
	@scripts/deb.sh $(ARCH)

format:  ## lay out all C++ files with clang-format 14
	@scripts/format.sh --fix

tidy:  ## clang-tidy 19 over all files
	@scripts/install_packages.sh build test
	@scripts/tidy.sh all

packages:  ## install the Debian packages that a build needs
	@scripts/install_packages.sh build

clean:  ## remove all builds
	rm -rf build build-debug build-clang build-asan-ubsan build-tsan build-arm64 build-arm64-programs

help:  ## this list
	@sed -nE 's/^([a-z0-9 -]+):[^#=]*  ## (.*)/\1\t\2/p' $(MAKEFILE_LIST) | \
	  while IFS=$$'\t' read -r name text; do printf '  make %-12s %s\n' "$$name" "$$text"; done
