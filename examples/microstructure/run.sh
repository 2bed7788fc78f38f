#!/bin/bash
# Run the scene and draw its figures.
# usage: ./run.sh [RANKS [arguments of LAMMPS, for example -var phi 0.45]]
set -euo pipefail
cd "$(dirname "$0")"
tools=../../tools
ranks=${1:-2}
shift || true
"$tools/lmp.sh" -n "$ranks" -in in.microstructure -log log.lammps "$@"
"$tools/python.sh" plot.py
