#!/bin/bash
# Set everything up: Debian packages, LAMMPS, plugin, tests. Run it as often as you like, what is done is kept.
# usage: tools/setup.sh      (see tools/common.sh for the environment variables)
set -euo pipefail
# shellcheck source=tools/common.sh
source "$(dirname "$0")/common.sh"

packages="g++ make cmake ninja-build ccache libopenmpi-dev openmpi-bin python3 python3-numpy python3-scipy
  python3-matplotlib python3-pil libgtest-dev libbenchmark-dev voro++-dev valgrind xz-utils curl ca-certificates"

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
  if grep -q LAMMPS_BIGBIG <<<"$help"; then sizes=bigbig; fi
}

build_plugin() {
  local python
  python=$(find_python)
  local args=(-G Ninja -D LAMMPS_SOURCE_DIR="$lammps_source" -D LAMMPS_EXECUTABLE="$lammps_executable"
    -D LAMMPS_SIZES="$sizes" -D Python3_EXECUTABLE="$python"
    -D SUSPENSION_LAMMPS="$version" -D SUSPENSION_CACHE="$cache")
  use_ccache "$top"
  lock "$build/lock"
  if [ ! -f "$build/build.ninja" ] || [ "$(cat "$build/configured" 2>/dev/null)" != "${args[*]}" ]; then
    quietly "$build/configure.log" cmake -S "$top" -B "$build" "${args[@]}"
    echo "${args[*]}" >"$build/configured"
  fi
  run_ninja "$build"
}

install_packages
sizes=smallbig
if [ "$version" = own ]; then check_own_lammps; else "$top/tools/build_lammps.sh" "$cache/lammps-$version/build"; fi
build_plugin
say "ready: $build/suspensionplugin.so for $lammps_executable"
