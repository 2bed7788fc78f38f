#!/bin/bash
# Make the tables and draw their figures.
# usage: ./run.sh [PARTS of study.py]
set -euo pipefail
cd "$(dirname "$0")"
../../tools/python.sh study.py "$@"
../../tools/python.sh plot.py
