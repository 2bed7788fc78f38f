#!/bin/bash
# Shear layers at three Shields numbers, JOBS at a time on one rank each, and draw their figure.
# usage: ./run.sh [JOBS [arguments of LAMMPS for all, for example -var direction gradient]]
set -euo pipefail
cd "$(dirname "$0")"
jobs=${1:-2}
shift || true
mkdir -p runs

# Shields number, strain that the layer takes to rise, strain of the averages, inertia
cases="
0.2 7 12 0.1
2 9 9 0.05
20 16 14 0.1
"
run() {
  shields=$1 rise=$2 strain=$3 inertia=$4
  shift 4
  ../../tools/lmp.sh -in in.resuspension -log none -screen "runs/Sh$shields.log" -var out "runs/Sh$shields" -var shields "$shields" -var rise "$rise" -var strain "$strain" -var inertia "$inertia" "$@"
  echo "Sh $shields: done"
}
export -f run
grep . <<< "$cases" | while read -r line; do echo "$line $*"; done | xargs -P "$jobs" -I CASE bash -c "set -euo pipefail; run CASE"
../../tools/python.sh plot.py
