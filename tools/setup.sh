#!/bin/bash
# Set everything up: Debian packages, LAMMPS, plugin. Run it as often as you like, what is done is kept.
# usage: tools/setup.sh [--tests]      (see tools/common.sh for the environment variables)
#   --tests   build what the tests need, too; warnings are errors
set -euo pipefail
# shellcheck source=tools/common.sh
source "$(dirname "$0")/common.sh"

packages="g++ make cmake ninja-build ccache libopenmpi-dev openmpi-bin python3 python3-numpy python3-scipy
  python3-matplotlib python3-pil voro++-dev libfftw3-dev xz-utils curl ca-certificates"
tests=OFF
case "$#:${1:-}" in
  0:) ;;
  1:--tests) tests=ON packages="$packages libgtest-dev libbenchmark-dev libeigen3-dev valgrind clang python3-sphinx libjs-mathjax" ;;
  *) die "unknown arguments: $*; usage: tools/setup.sh [--tests]" ;;
esac

# SUSPENSION_SKIP_PACKAGES=1: trust that compiler, MPI and so on come from elsewhere (modules of a cluster, conda).
install_packages() {
  if [ -n "${SUSPENSION_SKIP_PACKAGES:-}" ]; then return; fi
  command -v dpkg-query >/dev/null || { say "not a Debian system; needed here: $packages"; return; }
  local installed package missing=()
  # shellcheck disable=SC2086 # a list
  installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' $packages 2>/dev/null || true)
  for package in $packages; do
    grep -qxF "$package installed" <<<"$installed" || missing+=("$package")
  done
  if [ ${#missing[@]} -eq 0 ]; then return; fi
  [ "$(id -u)" = 0 ] || die "missing packages. Please run:
  sudo apt-get update && sudo apt-get install --no-install-recommends ${missing[*]}"
  say "installing ${missing[*]}"
  export DEBIAN_FRONTEND=noninteractive
  apt-get -q update || say "apt-get update failed for some source, going on"
  apt-get -qy install --no-install-recommends "${missing[@]}"
}

# A LAMMPS which others have built: can it load plugins, and which integer sizes has it?
check_own_lammps() {
  local help
  help=$("$lammps_executable" -h) || die "LAMMPS_EXECUTABLE=$lammps_executable does not run"
  grep -qw plugin <<<"$help" ||
    die "$lammps_executable cannot load plugins: build it with PKG_PLUGIN=on, or use cmake/suspension_in_lammps.cmake"
  if grep -q LAMMPS_BIGBIG <<<"$help"; then sizes=bigbig; else sizes=smallbig; fi
}

# A build folder that has been set up for tests stays so: without --tests only less of it is built.
build_plugin() {
  local python what="plugin and tests" configured=ON targets=()
  python=$(find_python)
  if [ "$tests" = OFF ]; then
    what=plugin targets=(suspensionplugin)
    grep -qs '^SUSPENSION_TESTS:BOOL=ON' "$build/CMakeCache.txt" || configured=OFF
  fi
  local args=(-G Ninja -D LAMMPS_SOURCE_DIR="$lammps_source" -D LAMMPS_EXECUTABLE="$lammps_executable"
    -D LAMMPS_SIZES="$sizes" -D Python3_EXECUTABLE="$python"
    -D SUSPENSION_TESTS="$configured" -D SUSPENSION_WERROR="$configured"
    -D SUSPENSION_LAMMPS="$version" -D SUSPENSION_CACHE="$cache")
  use_ccache "$top"
  lock "$build/lock"
  if [ ! -f "$build/build.ninja" ] || [ "$(cat "$build/configured" 2>/dev/null)" != "${args[*]}" ]; then
    quietly "$build/configure.log" cmake -S "$top" -B "$build" "${args[@]}"
    echo "${args[*]}" >"$build/configured"
  fi
  run_ninja "$what" "$build" "${targets[@]}"
}

install_packages
if [ "$version" = own ]; then
  check_own_lammps
  build_plugin
else
  # Side by side: the plugin needs LAMMPS' headers only. The job gets a process group, to be stopped as a whole.
  "$top/tools/fetch_lammps.sh" "$version" "$lammps_source"
  set -m
  "$top/tools/build_lammps.sh" "$cache/lammps-$version/build$of_sizes" &
  lammps=$!
  set +m
  trap 'kill -- "-$lammps" 2>/dev/null || true' EXIT
  build_plugin
  wait "$lammps"
  trap - EXIT
fi
say "ready: $build/suspensionplugin.so for $lammps_executable"
