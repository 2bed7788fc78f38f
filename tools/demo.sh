#!/bin/bash
# Set up what is needed, then run the main example: a suspension sheared at a constant rate.
# usage: tools/demo.sh [RANKS]
set -euo pipefail
# shellcheck source=tools/common.sh
source "$(dirname "$0")/common.sh"
cores=$(nproc)
ranks=${1:-$((cores < 4 ? cores : 4))}
example=$top/examples/shear_rate

say "1/2: packages, LAMMPS and plugin, about four minutes on two cores the first time, seconds later"
"$top/tools/setup.sh"
say "2/2: 1000 spheres sheared on $ranks ranks, a minute or two (column CPULeft: seconds left)"
"$example/run.sh" "$ranks"
say "done in $((SECONDS / 60)) min $((SECONDS % 60)) s. The numbers are above. Look at:
  $example/overview.png     particles, and the parts of the viscosity against strain
  $example/figure.png       these parts alone
  $example/stress.txt       the numbers behind it, one line each 0.02 of strain
  $example/README.md        what they mean, and what moves the viscosity
  next: your own deck, tools/lmp.sh -n $ranks -in in.mydeck"
