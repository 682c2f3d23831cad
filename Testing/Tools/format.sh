#!/bin/sh
# Every C++ source has the format of .clang-format, or gets it (option -i, the build's target "format"):
#   format.sh SOURCE_DIR CLANG_FORMAT [-i]
set -eu
cd "$1"
# shellcheck disable=SC2086 # a list of words
find Filters Testing Examples Wrapping \( -name '*.h' -o -name '*.cpp' -o -name '*.cxx' \) -print0 |
  xargs -0 "$2" ${3:---dry-run --Werror --ferror-limit=1}
