#!/bin/bash
# Set everything up, then run all the tests.
# usage: tools/test.sh [arguments of ctest]      for example tools/test.sh -L kernel
set -euo pipefail
# shellcheck source=tools/common.sh
source "$(dirname "$0")/common.sh"
"$top/tools/setup.sh" --tests
exec ctest --test-dir "$build" --output-on-failure -j "$(nproc)" "$@"
