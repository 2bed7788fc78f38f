#!/bin/bash
# The manual as HTML, which needs no network: open FOLDER/index.html. Warnings and links that lead nowhere are errors.
# usage: tools/manual.sh [FOLDER]      default: build/manual
# Needs Sphinx and MathJax 2; Debian: python3-sphinx libjs-mathjax (tools/setup.sh --tests installs them).
set -euo pipefail
# shellcheck source=tools/common.sh
source "$(dirname "$0")/common.sh"

[ $# -le 1 ] || die "unknown arguments: $*; usage: tools/manual.sh [FOLDER]"
folder=${1:-$build/manual}
for sphinx in "$(command -v sphinx-build || true)" /usr/bin/sphinx-build ""; do
  if [ -x "$sphinx" ] && "$sphinx" --version >/dev/null 2>&1; then break; fi
done
[ -n "$sphinx" ] || die "no sphinx-build found; Debian: apt-get install python3-sphinx libjs-mathjax"
mkdir -p "$folder"
"$sphinx" -E -a -W --keep-going -n -q -b html -d "$folder/.doctrees" "$top/doc/src" "$folder"
say "open $folder/index.html"
