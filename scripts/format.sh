#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/format.sh [--fix]: are all C++ files laid out as .clang-format says? Exit code 77: no clang-format 14.
set -euo pipefail
cd "$(dirname "$0")/.."
clang_format=$(command -v clang-format-14) || { echo "format: clang-format-14 is missing" >&2; exit 77; }
how=(--dry-run --Werror)
if [[ ${1:-} == --fix ]]; then how=(-i); fi
find src app tests bench examples \( -name '*.cpp' -o -name '*.hpp' \) -print0 | xargs -0 "$clang_format" "${how[@]}"
