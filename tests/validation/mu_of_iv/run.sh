#!/bin/bash
# Make (or go on with) results.csv and judge it. usage: ./run.sh [JOBS]      one hour on one core
set -euo pipefail
cd "$(dirname "$0")"
study=../../../examples/mu_of_iv/study.py
python=../../../tools/python.sh
"$python" "$study" --Iv 1e-3 1e-2 0.1 1 --friction 0 0.3 0.5 --particles 1000 --strain 12 --seeds 2 \
  --jobs "${1:-2}" --table "$PWD/results.csv"
"$python" judge.py
