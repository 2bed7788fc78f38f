#!/bin/bash
# Build LAMMPS with what SUSPENSION needs, and no more. Its sources are fetched if they are not there yet.
# usage: tools/build_lammps.sh BUILD-FOLDER [more CMake arguments]
set -euo pipefail
# shellcheck source=tools/common.sh
source "$(dirname "$0")/common.sh"
folder=${1:?usage: build_lammps.sh BUILD-FOLDER [more CMake arguments]}
shift

"$top/tools/fetch_lammps.sh" "$version" "$lammps_source"
lock "$folder.lock"

args=(-D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_FLAGS_RELEASE="-O3 -DNDEBUG" -D CMAKE_CXX_FLAGS=-fpch-preprocess
  -D BUILD_MPI=on -D BUILD_OMP=off -D PKG_GRANULAR=on -D PKG_PLUGIN=on -D PKG_COLLOID=on
  -D PKG_GRAPHICS=on    # dump image, in releases that have moved it there
  -D WITH_JPEG=off -D WITH_PNG=off -D WITH_GZIP=off -D WITH_FFMPEG=off "$@")
if [ "$sizes" = bigbig ]; then args+=(-D LAMMPS_SIZES=bigbig); fi
use_ccache "$cache"

# Up to date if it was finished with the same compiler, arguments and cmake/lammps_quick.cmake.
quick=$top/cmake/lammps_quick.cmake
key=$( (c++ --version; echo "$lammps_source ${args[*]}"; cat "$quick") | sha256sum)
if [ -x "$folder/lmp" ] && [ "$(cat "$folder/finished" 2>/dev/null)" = "$key" ]; then exit 0; fi

say "building LAMMPS $version in $folder (two or three minutes the first time)"
mkdir -p "$folder"
rm -f "$folder/finished" "$folder/CMakeCache.txt"    # no option of an earlier configuration survives
quietly "$folder/configure.log" cmake -S "$lammps_source/cmake" -B "$folder" -G Ninja \
  -D CMAKE_PROJECT_lammps_INCLUDE_BEFORE="$quick" "${args[@]}"
run_ninja LAMMPS "$folder"
echo "$key" >"$folder/finished"
