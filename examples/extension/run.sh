#!/bin/bash
# Run the study and draw its figure.
# usage: ./run.sh [arguments of study.py]
set -euo pipefail
cd "$(dirname "$0")"
../../tools/python.sh study.py "$@"
