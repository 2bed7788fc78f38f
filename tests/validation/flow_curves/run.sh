#!/bin/bash
# The study of README.md: 45 minutes on one core; cases that results.csv holds are skipped.
# usage: ./run.sh [SEEDS]
set -euo pipefail
cd "$(dirname "$0")"
python=../../../tools/python.sh
"$python" study.py --seeds "${1:-1}" --Iv 0.1 1e-2 10 1
"$python" study.py --seeds "${1:-1}" --Iv 1e-4 --friction 0 0.1 0.2 0.3
"$python" study.py --seeds "${1:-1}" --Iv 1e-4 --friction 0.5 1 2 --strain 2
"$python" study.py --seeds "${1:-1}" --Iv 1e-3 3e-2 3e-3 0.3 --friction 0.1 0.2 1 2    # mu_of_iv has the others
"$python" study.py --seeds 2 --Iv 0.1 --friction 0.5    # how much the shapes of two runs of a state differ
"$python" judge.py
