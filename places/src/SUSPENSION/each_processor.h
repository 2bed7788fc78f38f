/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// One binary for all processors: the vectors are as wide as the processor that runs it has them.
// Only where our CMake files say that nothing is fused, so that all give the same bits.

#ifndef LMP_EACH_PROCESSOR_H
#define LMP_EACH_PROCESSOR_H

#if defined(SUSPENSION_UNFUSED) && defined(__x86_64__) && defined(__GLIBC__) && \
    defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 12 && !defined(__AVX2__)
#define LUBCONTACT_EACH_PROCESSOR gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default"),
#else
#define LUBCONTACT_EACH_PROCESSOR
#endif

#endif
