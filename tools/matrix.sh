#!/bin/bash
# What the other tests do not compile: clang++ (kernel tests, plugin, and a choice of decks with it) and, without
# optimization, all of src for a LAMMPS with bigbig integers. Warnings are errors. g++ without optimization: kernel.sanitized.
# A LAMMPS with bigbig, to run decks: SUSPENSION_SIZES=bigbig tools/test.sh.
# usage: tools/matrix.sh      after tools/setup.sh --tests
set -euo pipefail
# shellcheck source=tools/common.sh
source "$(dirname "$0")/common.sh"
command -v clang++ >/dev/null || { say "no clang++"; exit 77; }

decks='(restart|rheometer_flip|partition|dry_bounce|voronoi)\.np1|(restart|ranks)\.np4'
python=$(find_python)
common=(-G Ninja -D CMAKE_CXX_COMPILER=clang++ -D LAMMPS_SOURCE_DIR="$lammps_source" -D LAMMPS_EXECUTABLE="$lammps_executable"
  -D Python3_EXECUTABLE="$python" -D SUSPENSION_WERROR=ON)

# usage: build WHAT TARGETS OPTIONS...
build() {
  local what=$1 targets=$2 folder=$build/matrix/$1
  shift 2
  local args=("${common[@]}" "$@")
  use_ccache "$top"
  mkdir -p "$folder"
  quietly "$folder/configure.log" cmake -S "$top" -B "$folder" "${args[@]}"
  # shellcheck disable=SC2086 # a list
  run_ninja "$what" "$folder" $targets
}

build clang "suspensionplugin kernel_tests hard_kernel_cases" -D CMAKE_CXX_FLAGS_RELEASE="-O2 -DNDEBUG" -D LAMMPS_SIZES="$sizes"
ctest --test-dir "$build/matrix/clang" --output-on-failure -j "$jobs" -R "^(kernel|hard)\.[A-Z]|^deck\.($decks)"
build bigbig suspensionplugin -D CMAKE_BUILD_TYPE=Debug -D CMAKE_CXX_FLAGS_DEBUG=-O0 -D LAMMPS_SIZES=bigbig -D SUSPENSION_TESTS=OFF
