# shellcheck shell=bash disable=SC2034 # its variables are used by the others
# Sourced by the other tools: where things are. From the environment:
#   SUSPENSION_LAMMPS   LAMMPS release: 4Feb2025 (default) or 4Jul2026
#   SUSPENSION_SIZES    integer sizes of that LAMMPS: smallbig (default) or bigbig
#   SUSPENSION_JOBS     how many compilers run at a time, default: one for each core
#   SUSPENSION_CACHE    where LAMMPS is unpacked and built, default ~/.cache/suspension
#   LAMMPS_SOURCE_DIR, LAMMPS_EXECUTABLE   both: a LAMMPS of your own; then nothing is fetched and LAMMPS is not built

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
user_cache=~/.cache
cache=${SUSPENSION_CACHE:-${XDG_CACHE_HOME:-$user_cache}/suspension}

say() { echo "suspension: $*" >&2; }
die() { say "$*"; exit 1; }

jobs=${SUSPENSION_JOBS:-$(nproc)}
sizes=${SUSPENSION_SIZES:-smallbig}
case $sizes in
  smallbig) of_sizes= ;;
  bigbig) of_sizes=-bigbig ;;
  *) die "SUSPENSION_SIZES=$sizes is not one of smallbig, bigbig" ;;
esac
if [ -n "${LAMMPS_SOURCE_DIR:-}" ] && [ -n "${LAMMPS_EXECUTABLE:-}" ]; then
  version=own
  lammps_source=$(realpath "$LAMMPS_SOURCE_DIR")
  lammps_executable=$(realpath "$LAMMPS_EXECUTABLE")
elif [ -n "${LAMMPS_SOURCE_DIR:-}${LAMMPS_EXECUTABLE:-}" ]; then
  die "for a LAMMPS of your own set both LAMMPS_SOURCE_DIR and LAMMPS_EXECUTABLE; for ours set none of them"
else
  version=${SUSPENSION_LAMMPS:-4Feb2025}
  lammps_source=$cache/lammps-$version/source
  lammps_executable=$cache/lammps-$version/build$of_sizes/lmp
fi

build=$top/build-$version$of_sizes
if [ "$version" = 4Feb2025 ]; then build=$top/build$of_sizes; fi

# Only one at a time: held until the script ends.
lock() {
  mkdir -p "$(dirname "$1")"
  exec 9>"$1"
  flock -n 9 || { say "waiting for another set-up to finish"; flock 9; }
}

# Adds to args of cmake. Objects serve any folder below this one, whatever its absolute path, with -Werror or without.
use_ccache() {
  command -v ccache >/dev/null || return 0
  export CCACHE_IGNOREOPTIONS=-Werror
  export CCACHE_DIR=$cache/ccache CCACHE_BASEDIR=$1 CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=pch_defines,time_macros
  args+=(-D CMAKE_CXX_COMPILER_LAUNCHER=ccache)
}

# Silent unless it fails.
quietly() {
  local log=$1
  shift
  "$@" >"$log" 2>&1 || { tail -n 40 "$log" >&2; die "failed: $* (all of it: $log)"; }
}

# How far ninja is, every ten seconds: the last [done/all] in its log. In the background of run_ninja.
show_progress() {
  local what=$1 log=$2 begin=$SECONDS step
  while sleep 10 >/dev/null 2>&1; do    # which may outlive us: it keeps no pipe open
    step=$(grep -aoE '^\[[0-9]+/[0-9]+\]' "$log" | tail -n 1 || true)
    say "$what ${step:-[...]} after $((SECONDS - begin)) s"
  done
}

# usage: run_ninja WHAT FOLDER [TARGET...]     all of its output goes to FOLDER/build.log
run_ninja() {
  local what=$1 folder=$2 code=0 watcher
  shift 2
  : >"$folder/build.log"
  show_progress "$what" "$folder/build.log" 9>&- &
  watcher=$!
  NINJA_STATUS='[%f/%t] ' ninja -C "$folder" -j "$jobs" "$@" >>"$folder/build.log" 2>&1 || code=$?
  kill "$watcher" 2>/dev/null || true
  wait "$watcher" 2>/dev/null || true
  if [ "$code" != 0 ]; then
    grep -avE '^\[[0-9]+/[0-9]+\]' "$folder/build.log" | head -n 60 >&2
    die "$what: build failed (all of it: $folder/build.log)"
  fi
}

# The first Python that has what decks and figures need.
find_python() {
  local python
  for python in "$(command -v python3 || true)" /usr/bin/python3; do
    if [ -x "$python" ] && "$python" -c 'import numpy, scipy, matplotlib' 2>/dev/null; then
      echo "$python"
      return
    fi
  done
  die "no python3 with numpy, scipy and matplotlib found"
}
