#!/bin/bash
# Let a cloud settle, then suspensions (study.csv has them already), and draw the figure.
# usage: ./run.sh [RANKS [arguments of LAMMPS, for example -var phi 0.05]]
set -euo pipefail
cd "$(dirname "$0")"
tools=../../tools
ranks=${1:-2}
shift || true
"$tools/lmp.sh" -n "$ranks" -in in.sedimentation -log log.lammps -var N 250 -var cloud 2 -var path 0.03 -var until 20 "$@"
"$tools/python.sh" study.py
"$tools/python.sh" plot.py
