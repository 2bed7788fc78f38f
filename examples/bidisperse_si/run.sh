#!/bin/bash
# Two sizes, in two decks of which the second goes on from a restart file; one size for comparison; the figure.
# usage: ./run.sh [RANKS [arguments of LAMMPS, for example -var Iv 0.03]]
set -euo pipefail
cd "$(dirname "$0")"
tools=../../tools
ranks=${1:-2}
shift || true
"$tools/lmp.sh" -n "$ranks" -in in.bidisperse_si -log log.start "$@"
"$tools/lmp.sh" -n "$ranks" -in in.continue -log log.continue "$@"
mkdir -p one_size
(cd one_size && "../$tools/lmp.sh" -n "$ranks" -in ../in.bidisperse_si -log log.lammps -var ratio 1 -var strain 12 \
  -var scene ../../scene "$@")
"$tools/python.sh" plot.py --from 2
