#!/bin/bash
# Build LAMMPS with our styles compiled in (no plugin) and check that it knows them. Our files without optimization, for
# it is about includes, symbols and names: the plugin's build has the same files optimized.
# usage: tools/compiled_in.sh [FOLDER with src, cmake and potentials; default: this one]
set -euo pipefail
# shellcheck source=tools/common.sh
source "$(dirname "$0")/common.sh"

sources=${1:-$top}
folder=$cache/lammps-$version/build-compiled-in$of_sizes
rm -f "$folder/finished"    # our sources change: always look again
"$top/tools/build_lammps.sh" "$folder" \
  -D CMAKE_PROJECT_lammps_INCLUDE="$sources/cmake/suspension_in_lammps.cmake" -D SUSPENSION_COMPILE_OPTIONS=-O0

help=$(LAMMPS_PLUGIN_PATH='' "$folder/lmp" -h)
grep -hE '^(Pair|Fix|Compute|Command)Style\(' "$sources"/src/SUSPENSION*/*.h | sed 's/.*(\(.*\),.*/\1/' | grep -v '^[A-Z]' | while read -r style; do
  grep -qwF "$style" <<<"$help" || die "$folder/lmp does not know $style"
  echo "compiled in: $style"
done
echo "executable: $folder/lmp"
