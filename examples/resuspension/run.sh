#!/bin/bash
# Shear layers at three Shields numbers, JOBS at a time on one rank each, and draw their figure.
# usage: ./run.sh [JOBS [arguments of LAMMPS for all, for example -var direction gradient]]
set -euo pipefail
cd "$(dirname "$0")"
jobs=${1:-2}
shift || true
mkdir -p runs

# Shields number, strain that the layer takes to rise, strain of the averages, inertia then and before
cases="
0.2 7 8 0.1 0.4
2 9 9 0.05 0.2
20 16 8 0.1 0.4
"
run() {
  shields=$1 rise=$2 strain=$3 inertia=$4 haste=$5
  shift 5
  ../../tools/lmp.sh -in in.resuspension -log none -screen "runs/Sh$shields.log" "$@" -var out "runs/Sh$shields" \
    -var shields "$shields" -var rise "$rise" -var strain "$strain" -var inertia "$inertia" -var haste "$haste"
  echo "Sh $shields: done"
}
export -f run
grep . <<< "$cases" | while read -r line; do echo "$line $*"; done | xargs -P "$jobs" -I CASE bash -c "set -euo pipefail; run CASE"
../../tools/python.sh plot.py
