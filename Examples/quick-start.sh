#!/usr/bin/env bash
# Installs what is missing (as root), builds, and makes the mesh of a blunted nose-cone at incidence:
# the mesh (.vtu), its pictures (.png) and the printed quality report.
#
#   Examples/quick-start.sh [FOLDER]      default: build/nosecone
set -euo pipefail
cd "$(dirname "$0")/.."
folder=${1:-build/nosecone}

sh Filters/CMake/install-debian-packages.sh
cmake --preset quick-start
cmake --build --preset quick-start

build=build/quick-start
mkdir -p "$folder"
"$build/bin/nosecone-surface" "$folder/nosecone.vtp"
PYTHONPATH="$build/lib/python3/dist-packages" xvfb-run -a -s "-screen 0 1600x1000x24 -noreset" \
  /usr/bin/python3 -B Examples/Python/nosecone.py "$folder"
