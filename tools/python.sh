#!/bin/bash
# A Python with numpy, scipy and matplotlib: not always the first one on the PATH.
# usage: tools/python.sh ARGUMENTS...
set -euo pipefail
# shellcheck source=tools/common.sh
source "$(dirname "$0")/common.sh"
python=$(find_python)
exec "$python" "$@"
