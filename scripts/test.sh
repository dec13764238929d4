#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/test.sh PART...: builds and runs parts of `make test`: asan, tsan, arm64, arm64-if-possible, check, web; or
# the long runs: fuzz, soak.
set -euo pipefail
cd "$(dirname "$0")/.."
jobs=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}

step() { printf '\n== %s (%d s since the start)\n' "$*" "$SECONDS"; }

run_ctest() { ctest --test-dir "$1" --output-on-failure --no-tests=error -j "$jobs" "${@:2}" | quiet; }

# Hundreds of passed tests say nothing; the others and the counts do.
quiet() { grep -vE "^ *[0-9]+/[0-9]+ Test .* Passed |^ *Start +[0-9]+: |^Internal ctest|^Test project" || true; }

# Tests wait more than they work: those of one build after another's run while the next is compiled, and come first
# where both want a core. `settle` shows what they say.
compile() { nice -n 5 cmake --build "$@"; }
running=() said=$(mktemp -d)
trap 'kill $(jobs -p) 2>/dev/null || true; rm -rf "$said"' EXIT
meanwhile() {
  { flock 9 && "$@" 9>&-; } 9>"$said/one at a time" >"$said/$1" 2>&1 &
  running+=("$1:$!")
}
settle() {
  local status=0 name
  for job in "${running[@]}"; do
    name=${job%:*}
    step "what ${name//_/ } said"
    tail -n +1 -f --pid="${job#*:}" "$said/$name"
    wait "${job#*:}" || status=$?
  done
  running=()
  return "$status"
}

asan() {
  step "clang 14 builds everything; ASan and UBSan watch all tests"
  cmake --preset asan-ubsan -DODAS_BUILD_BENCHES=OFF >/dev/null
  compile build-asan-ubsan
  meanwhile asan_tests
}
asan_tests() {
  LSAN_OPTIONS="suppressions=$PWD/scripts/lsan.supp:print_suppressions=0" run_ctest build-asan-ubsan -LE tree
}

tsan() {
  step "TSan watches base, engine and io"
  cmake --preset tsan -DODAS_BUILD_BENCHES=OFF -DODAS_WITH_STUDIO=OFF >/dev/null
  compile build-tsan --target base_test engine_test io_test
  meanwhile tsan_tests
}
tsan_tests() {
  for room in base engine io; do
    build-tsan/bin/${room}_test --gtest_brief=1 || return
  done
}

arm64() {
  step "odas_core for arm64; its tests run under qemu"
  scripts/install_packages.sh arm64
  cmake --preset arm64 >/dev/null
  compile build-arm64
  meanwhile arm64_tests
}
arm64_tests() { run_ctest build-arm64; }

# Without a network, or on another system, the packages of the other architecture may be out of reach.
arm64-if-possible() {
  if scripts/install_packages.sh arm64 && command -v aarch64-linux-gnu-g++ >/dev/null; then
    arm64
  else
    step "SKIPPED: arm64, since its packages cannot be installed here"
  fi
}

fuzz() {
  step "fuzzers, ${FUZZ_SECONDS:=3600} s each"
  cmake --preset asan-ubsan >/dev/null
  cmake --build build-asan-ubsan
  scripts/fuzz.sh build-asan-ubsan "$FUZZ_SECONDS"
}

soak() {
  step "the long forms of the tests"
  cmake --preset release -DODAS_BUILD_TESTS=ON >/dev/null
  cmake --build build
  ODAS_SOAK=1 run_ctest build -L soak
  export ODAS_SOAK=1
  page sound
}

check() {
  step "release build with g++; all tests, and the checks of the tree"
  cmake --preset release -DODAS_BUILD_TESTS=ON >/dev/null
  compile build
  meanwhile release_tests
}
release_tests() { run_ctest build; }

# Of the programs it needs a build that is there: `check`, or `make`.
web() { meanwhile page; }
# With words: only such test files.
page() {
  step "the Studio's page: types, units, its bundle, and all of it in chromium"
  local status=0
  scripts/test_web.sh "$@" || status=$?
  if ((status == 77)); then step "SKIPPED: the page, for the reason above"; return 0; fi
  return "$status"
}

for part in "$@"; do "$part"; done
settle
