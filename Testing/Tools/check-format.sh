#!/bin/sh
# Every C++ source has the format of .clang-format: check-format.sh SOURCE_DIR [CLANG_FORMAT]
set -eu
cd "$1"
find Filters Testing Examples Wrapping \( -name '*.h' -o -name '*.cpp' -o -name '*.cxx' \) -print0 |
  xargs -0 "${2:-clang-format}" --dry-run --Werror
