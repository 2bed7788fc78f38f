#!/bin/bash
# Make two packings and draw them.
# usage: ./run.sh [RANKS]
set -euo pipefail
cd "$(dirname "$0")"
tools=../../tools
ranks=${1:-1}
"$tools/lmp.sh" -n "$ranks" -in in.packing -log log.lammps -var phi 0.62 -var name spheres
"$tools/lmp.sh" -n "$ranks" -in in.packing -log log.lammps -var dim 2 -var phi 0.8 -var sizes flat -var N 500 -var name discs
"$tools/python.sh" plot.py
