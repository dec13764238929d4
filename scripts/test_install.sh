#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/test_install.sh BUILD: installs a build into a folder of its own, and uses it as a stranger would:
# the programs from there, and examples/hello_core against the CMake package and with pkg-config alone.
set -euo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
build=$(cd "$1" && pwd)
prefix=$build/install-test
rm -rf "$prefix"
cmake --install "$build" --prefix "$prefix" >/dev/null

"$prefix/bin/odas" --version
"$prefix/bin/odaslive" -h >/dev/null
"$prefix/bin/odasserver" -h >/dev/null
(cd / && "$prefix/bin/odas" check sample >/dev/null && "$prefix/bin/odas" check pepper >/dev/null)
for file in share/man/man1/odas.1 share/bash-completion/completions/odas share/doc/odas/LICENSE; do
  [[ -s $prefix/$file ]] || { echo "install: $file is missing" >&2; exit 1; }
done

hears_the_sound() {
  local heard
  heard=$("$1" | tail -1)
  echo "$2: $heard"
  [[ $heard =~ azimuth\ (3[789]|4[0123]), ]] || { echo "install: the example hears a sound from 40 elsewhere" >&2; exit 1; }
}

cmake -S "$source/examples/hello_core" -B "$prefix/hello" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_BUILD_TYPE=Release \
  >/dev/null
cmake --build "$prefix/hello" >/dev/null
hears_the_sound "$prefix/hello/hello_core" "with the CMake package"

cxx=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$build/CMakeCache.txt")
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name odas_core.pc)")
export PKG_CONFIG_PATH
read -ra flags < <(pkg-config --cflags --libs odas_core)
"$cxx" -std=c++20 "$source/examples/hello_core/main.cpp" -o "$prefix/hello/hello_pc" "${flags[@]}"
hears_the_sound "$prefix/hello/hello_pc" "with pkg-config"

# The installed headers compile, and bring none of the libraries of the inside with them.
(cd "$prefix/include" && find odas -name '*.hpp' -printf '#include "%p"\n' | sort) >"$prefix/hello/headers.cpp"
read -ra flags < <(pkg-config --cflags odas)
"$cxx" -std=c++20 -fsyntax-only -MD -MF "$prefix/hello/headers.d" "$prefix/hello/headers.cpp" "${flags[@]}"
if grep -oE '/(nlohmann|hwy|CLI|fmt|spdlog|alsa|pulse)/.*|/(fftw3|samplerate|sndfile|libconfig)[^/]*$' "$prefix/hello/headers.d"; then
  echo "install: a header names a library of the inside" >&2
  exit 1
fi
