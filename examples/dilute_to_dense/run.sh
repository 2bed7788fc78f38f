#!/bin/bash
# Run the scene at each level and volume fraction, and draw the figure.
# usage: ./run.sh [arguments of study.py, for example --phi 0.3 --friction 0.5]
set -euo pipefail
cd "$(dirname "$0")"
tools=../../tools
"$tools/python.sh" study.py "$@"
"$tools/python.sh" plot.py
