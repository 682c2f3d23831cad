#!/usr/bin/env bash
# Computes one of the published flows on a mesh of this project's, from a bare Debian 12 on: installs what is missing (as
# root), builds, meshes, solves, compares. Prints the deviations; leaves a picture and figures.json in the folder.
#
#   Examples/Validation/run.sh turbulent_plate|laminar_plate|cavity [FOLDER [--quick]]    default: build/validation/...
set -euo pipefail
cd "$(dirname "$0")/../.."
name=${1:?which one: turbulent_plate, laminar_plate or cavity}
folder=${2:-build/validation/$name}

sh Filters/CMake/install-debian-packages.sh
sh Examples/Validation/install-solvers.sh
cmake --preset quick-start
cmake --build --preset quick-start
mkdir -p "$folder"
PYTHONPATH="$PWD/build/quick-start/lib/python3/dist-packages" \
  /usr/bin/python3 -B "Examples/Validation/$name.py" "$folder" "${@:3}"
