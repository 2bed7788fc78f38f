#!/bin/bash
# Set everything up, then run the main example: a suspension sheared at a constant rate.
# usage: tools/demo.sh [RANKS]
set -euo pipefail
# shellcheck source=tools/common.sh
source "$(dirname "$0")/common.sh"
cores=$(nproc)
"$top/tools/setup.sh"
exec "$top/examples/shear_rate/run.sh" "${1:-$((cores < 4 ? cores : 4))}"
