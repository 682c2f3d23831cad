#!/bin/sh
# Installs what RANSMeshing needs on Debian 12, as root; does nothing where all is there.
#
#   install-debian-packages.sh [tests]     tests: also the programs that its meshes are read back by
#
# ParaView's Python package conflicts with VTK's, so apt cannot hold both: ParaView's three packages
# are unpacked into a folder of their own, RANSMESHING_PARAVIEW_PREFIX (default
# /opt/ransmeshing-paraview), where CMake finds them. What they need, paraview-dev brings.
set -eu

prefix=${RANSMESHING_PARAVIEW_PREFIX:-/opt/ransmeshing-paraview}
packages="
  g++ cmake ninja-build ccache
  libvtk9-dev python3-vtk9 python3-dev python3-numpy
  libtet1.5-dev libcgal-dev libcgns-dev zlib1g-dev
  libgtest-dev libbenchmark-dev clang-format clang-tidy
  paraview-dev qttools5-dev qtxmlpatterns5-dev-tools libqt5svg5 xvfb xauth"
[ "${1:-}" != tests ] || packages="$packages gmsh python3-gmsh cgns-convert openfoam"
unpacked="paraview paraview-dev python3-paraview"

missing=""
for package in $packages; do
  status=$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null || true)
  [ "$status" = "install ok installed" ] || missing="$missing $package"
done
complete="$prefix/complete"

if [ -z "$missing" ] && [ -e "$complete" ]; then
  exit 0
fi
if [ "$(id -u)" -ne 0 ]; then
  echo "install-debian-packages.sh: must be run as root; missing:${missing:- nothing from apt}" >&2
  [ -e "$complete" ] || echo "  and ParaView's packages in $prefix" >&2
  exit 1
fi

export DEBIAN_FRONTEND=noninteractive
apt-get update -qq
if [ -n "$missing" ]; then
  # shellcheck disable=SC2086 # a list of words
  apt-get install -y -qq --no-install-recommends $missing
fi

if [ ! -e "$complete" ]; then
  download=$(mktemp -d)
  trap 'rm -rf "$download"' EXIT
  chown _apt "$download"
  cd "$download"
  # shellcheck disable=SC2086 # a list of words
  apt-get download -qq $unpacked
  mkdir -p "$prefix"
  for archive in *.deb; do
    dpkg-deb -x "$archive" "$prefix"
  done
  touch "$complete"
fi
