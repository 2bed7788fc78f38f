#!/bin/bash
# Make (or go on with) results.csv and judge it. usage: ./run.sh [SEEDS...]      half an hour on one quiet core for each seed
set -euo pipefail
cd "$(dirname "$0")"
python=../../../tools/python.sh
"$python" study.py --seeds "${@:-4711}"
"$python" judge.py
