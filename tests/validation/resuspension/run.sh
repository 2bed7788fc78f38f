#!/bin/bash
# Make (or go on with) all runs, results.csv and profiles.csv, and judge them. usage: ./run.sh [JOBS]      an hour of one quiet core
set -euo pipefail
cd "$(dirname "$0")"
../../../tools/python.sh study.py --jobs "${1:-1}" all
