#!/bin/bash
# mpirun that just works: as root, in a container, with more ranks than cores. By environment, so any MPI can take it.
# usage: tools/mpirun.sh RANKS COMMAND...
set -euo pipefail
ranks=${1:?usage: mpirun.sh RANKS COMMAND...}
shift
# shellcheck source=tools/common.sh
source "$(dirname "$0")/common.sh"

export LAMMPS_PLUGIN_PATH=${LAMMPS_PLUGIN_PATH:-$build} OMP_NUM_THREADS=${OMP_NUM_THREADS:-1}
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none                # Open MPI 4
export PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe PRTE_MCA_hwloc_default_binding_policy=none    # Open MPI 5
export OMPI_MCA_btl_vader_single_copy_mechanism=none    # containers forbid it: a page of warnings otherwise
export OMPI_MCA_btl_base_warn_component_unused=0
if [ "$ranks" -gt "$(nproc)" ]; then export OMPI_MCA_mpi_yield_when_idle=1; fi
export OMPI_MCA_odls_base_sigkill_timeout=${OMPI_MCA_odls_base_sigkill_timeout:-0}    # no second of waiting after an error

# Looking for fast networks takes Open MPI 0.2 s of each start, and a daemon for a single rank 0.1 s more. Such a rank shares no
# folder in /tmp with others that start or end at the same time. Not for a rank which another mpirun or srun has started, nor
# in a batch job.
if [ -z "${OMPI_COMM_WORLD_SIZE:-}${PMI_RANK:-}${PMIX_RANK:-}${SLURM_JOB_ID:-}${PBS_JOBID:-}${LSB_JOBID:-}" ]; then
  if [ "$ranks" = 1 ]; then
    export OMPI_MCA_ess_singleton_isolated=1 OMPI_MCA_pmix=isolated OMPI_MCA_orte_create_session_dirs=0
    export OMPI_MCA_btl=${OMPI_MCA_btl:-self}
  fi
  export OMPI_MCA_pml=${OMPI_MCA_pml:-ob1} OMPI_MCA_btl=${OMPI_MCA_btl:-^ofi,openib,uct}
fi

if [ "$ranks" = 1 ]; then exec "$@"; fi
exec mpirun -np "$ranks" "$@"
