#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/test_web.sh [WORD...]: the checks of the Studio's page: its packages by the lock file, types, units, the
# bundle built anew and compared byte for byte with web/dist, its weight, and all tests in Debian's chromium, those
# against build/bin/odas too. With words: only test files whose name has one of them. Exit code 77: not possible here.
set -euo pipefail
cd "$(dirname "$0")/.."

lacks() { echo "web: $*" >&2; exit 77; }
scripts/install_packages.sh web || lacks "its packages cannot be installed here"
for program in node npm "${ODAS_CHROMIUM:=/usr/bin/chromium}"; do
  command -v "$program" >/dev/null || lacks "there is no $program here"
done
export ODAS_CHROMIUM

# npm's own record of what it has installed says whether that is what the lock file wants.
cd web
if ! cmp -s package-lock.json node_modules/.installed-by-lock; then
  npm ci --no-audit --no-fund --loglevel=error || lacks "npm ci failed: is there a package registry within reach?"
  cp package-lock.json node_modules/.installed-by-lock
fi

node test/bundle.mjs
export ODAS_PROGRAM=${ODAS_PROGRAM:-$PWD/../build/bin/odas}
exec node test/run.mjs "$@"
