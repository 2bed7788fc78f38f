/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifndef LMP_RESTART_SEAL_H
#define LMP_RESTART_SEAL_H

// Checksum of what a style writes to restart files: a disk or a transfer that has changed a byte of
// it gives an error instead of another simulation. FNV-1a (Fowler, Noll, Vo) of 64 bits, of which a
// double holds 52 as a whole number.

#include <cstddef>
#include <cstdint>

namespace suspension {

inline double seal(const void *data, std::size_t size)
{
  const auto *byte = static_cast<const unsigned char *>(data);
  std::uint64_t sum = 14695981039346656037ULL;
  for (std::size_t n = 0; n < size; n++) sum = (sum ^ byte[n]) * 1099511628211ULL;
  return static_cast<double>(sum >> 12);
}

// Part n of what the fixes keep of an atom, of total values: each part begins with its length. Null
// if a damaged length leads out of them.
inline const double *part_of_atom(const double *values, int n, int total)
{
  double begin = 0.0;
  for (int part = 0; part < n; part++) {
    const double length = values[static_cast<int>(begin)];
    if (!(length >= 1.0 && begin + length < total)) return nullptr;
    begin += length;
  }
  return values + static_cast<int>(begin);
}

}    // namespace suspension

#endif
