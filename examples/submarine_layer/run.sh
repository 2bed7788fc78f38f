#!/bin/bash
# Run the three layers, JOBS at a time on one rank each, and draw their figure.
# usage: ./run.sh [JOBS [arguments of LAMMPS for all, for example -var until 30]]
set -euo pipefail
cd "$(dirname "$0")"
jobs=${1:-2}
shift || true
mkdir -p runs

# name, and friction while the grains settle, which decides how dense they lie
starts="
dense 0.09
loose 0.45
medium 0.2
"
run() {
  name=$1 settling=$2
  shift 2
  ../../tools/lmp.sh -in in.submarine_layer -log none -screen "runs/$name.log" -var out "runs/$name.out" "$@" -var settling "$settling"
  echo "$name: done"
}
export -f run
grep . <<< "$starts" | while read -r line; do echo "$line $*"; done | xargs -P "$jobs" -I CASE bash -c "set -euo pipefail; run CASE"
../../tools/python.sh plot.py
