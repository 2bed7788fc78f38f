#!/bin/bash
# Shear layers at three Shields numbers, JOBS at a time on one rank each, and draw their figure.
# usage: ./run.sh [JOBS [arguments of LAMMPS for all, for example -var direction gradient]]
set -euo pipefail
cd "$(dirname "$0")"
jobs=${1:-2}
shift || true
mkdir -p runs

# Shields number, and the strain that the layer takes to rise
cases="
0.2 7
2 9
20 16
"
run() {
  shields=$1 rise=$2
  shift 2
  ../../tools/lmp.sh -in in.resuspension -log none -screen "runs/Sh$shields.log" -var out "runs/Sh$shields" -var shields "$shields" -var rise "$rise" "$@"
  echo "Sh $shields: done"
}
export -f run
grep . <<< "$cases" | while read -r line; do echo "$line $*"; done | xargs -P "$jobs" -I CASE bash -c "set -euo pipefail; run CASE"
../../tools/python.sh plot.py
