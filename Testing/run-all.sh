#!/usr/bin/env bash
# Installs what is missing (as root), builds everything in build/all and runs every test.
# Its last line is ctest's; its status is 0 only if all of it passed.
#
#   Testing/run-all.sh [ctest options]
set -euo pipefail
cd "$(dirname "$0")/.."

sh Filters/CMake/install-debian-packages.sh tests
cmake --preset all
cmake --build --preset all
ctest --preset all "$@"
