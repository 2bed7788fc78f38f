#!/bin/bash
# The study of README.md: an hour on one core; cases that runs.csv holds are skipped.
# usage: ./run.sh [SEEDS]
set -euo pipefail
cd "$(dirname "$0")"
python=../../../tools/python.sh
"$python" study.py --seeds "${1:-1}"
"$python" study.py --friction 0.5 --phi 0.5 --range "voronoi 1.5" --strain 6
"$python" judge.py
