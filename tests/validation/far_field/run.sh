#!/bin/bash
# The study of README.md: hours on one core; cases that runs.csv and imposed.csv hold are skipped.
# usage: ./run.sh [SEEDS]
set -euo pipefail
cd "$(dirname "$0")"
python=../../../tools/python.sh
"$python" ../../../examples/dilute_to_dense/study.py --particles 500 --strain 4.5 --friction 0.5 0 --seeds "${1:-1}" --table runs.csv \
  --levels none:cut:0.5 mean:cut:0.5 grid:residual:0.5 grid:residual:1 grid:residual:2
"$python" imposed.py --seeds "${1:-1}"
"$python" judge.py
