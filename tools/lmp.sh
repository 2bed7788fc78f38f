#!/bin/bash
# LAMMPS with the SUSPENSION plugin, from any folder.
# usage: tools/lmp.sh [-n RANKS] ARGUMENTS-OF-LAMMPS...      for example tools/lmp.sh -n 4 -in in.file
set -euo pipefail
# shellcheck source=tools/common.sh
source "$(dirname "$0")/common.sh"

ranks=1
if [ "${1:-}" = -n ]; then
  ranks=${2:?usage: lmp.sh [-n RANKS] ...}
  shift 2
fi
if [ ! -x "$lammps_executable" ] || [ ! -f "$build/suspensionplugin.so" ]; then die "run tools/setup.sh first"; fi
export LAMMPS_POTENTIALS=$top/potentials${LAMMPS_POTENTIALS:+:$LAMMPS_POTENTIALS}
export SUSPENSION_EXAMPLES=$top/examples    # where examples/scene/suspension.lmp finds the packing
exec "$top/tools/mpirun.sh" "$ranks" "$lammps_executable" "$@"
