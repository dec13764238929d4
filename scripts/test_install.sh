#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/test_install.sh BUILD: installs a build into a folder of its own, and uses it as a stranger would:
# the programs from there, and examples/hello_core against the CMake package.
set -euo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
build=$(cd "$1" && pwd)
prefix=$build/install-test
rm -rf "$prefix"
cmake --install "$build" --prefix "$prefix" >/dev/null

"$prefix/bin/odas" --version
"$prefix/bin/odaslive" -h >/dev/null
"$prefix/bin/odas" check "$prefix/share/odas/configs/sample.cfg" >/dev/null
for file in share/man/man1/odas.1 share/bash-completion/completions/odas share/doc/odas/LICENSE; do
  [[ -s $prefix/$file ]] || { echo "install: $file is missing" >&2; exit 1; }
done

cmake -S "$source/examples/hello_core" -B "$prefix/hello" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_BUILD_TYPE=Release \
  >/dev/null
cmake --build "$prefix/hello" >/dev/null
heard=$("$prefix/hello/hello_core" | tail -1)
echo "hello_core: $heard"
[[ $heard =~ azimuth\ (3[789]|4[0123]), ]] || { echo "install: the example hears a sound from 40 elsewhere" >&2; exit 1; }
