#!/bin/bash
# Run the cases, JOBS at a time on one rank each, and draw their figure.
# usage: ./run.sh [JOBS [arguments of LAMMPS for all cases, for example -var seed 1]]
set -euo pipefail
cd "$(dirname "$0")"
jobs=${1:-2}
shift || true
mkdir -p runs

# name and settings; 2H: twice the height and the particles, the same width
high="-var N 840 -var aspect_y 4"
slow="-var iv 0.01 -var strain 4"
cases="
fast_1       -var iv 0.1 -var strain 5 -var factor 1
fast_100_2H  -var iv 0.1 -var strain 5 -var factor 100 $high
fast_off     -var iv 0.1 -var strain 5 -var factor 100 -var coupling off
fast_100     -var iv 0.1 -var strain 5 -var factor 100
slow_1_2H    $slow -var factor 1 $high
slow_100_2H  $slow -var factor 100 $high
slow_off     $slow -var factor 100 -var coupling off
slow_100     $slow -var factor 100
slow_1       $slow -var factor 1
loose_off    $slow -var factor 100 -var coupling off -var start loose -var phi 0.45 -var prepare 4
loose_100    $slow -var factor 100 -var start loose -var phi 0.45 -var prepare 4
loose_1      $slow -var factor 1 -var start loose -var phi 0.45 -var prepare 4
"
run() {
  name=$1
  shift
  ../../tools/lmp.sh -in in.pore_transient -log none -screen "runs/$name.log" -var out "runs/$name.txt" "$@"
  echo "$name: done"
}
export -f run
# of two settings of a variable the first one counts
grep . <<< "$cases" | while read -r line; do echo "${line%% *} $* ${line#* }"; done | xargs -P "$jobs" -I CASE bash -c "set -euo pipefail; run CASE"
../../tools/python.sh plot.py
