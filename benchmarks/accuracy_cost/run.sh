#!/bin/bash
# What accuracy costs: runs what the tables lack and draws the figures.
# usage: ./run.sh
set -euo pipefail
cd "$(dirname "$0")"
../../tools/python.sh suspension.py
../../tools/python.sh suspension_laws.py draw
../../tools/python.sh suspension_laws.py table
../../tools/python.sh promise.py
../../tools/python.sh pairs.py
../../tools/python.sh pore.py
../../tools/python.sh hydro.py
