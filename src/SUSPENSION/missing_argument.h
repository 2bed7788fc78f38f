/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#ifndef LMP_MISSING_ARGUMENT_H
#define LMP_MISSING_ARGUMENT_H

#include "error.h"
#include "utils.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

// Stops if fewer words are given than a command or keyword needs, and says which are missing; usage
// is how it is written. Words from "..." on may be left out.
inline void require_words(const std::string &file, int line, Error *error,
                          const std::string &command, int given, const std::string &usage)
{
  const std::vector<std::string> words = utils::split_words(usage);
  std::string missing;
  for (std::size_t n = given; n < words.size() && words[n] != "..."; n++)
    missing += (missing.empty() ? "" : " ") + words[n];
  if (!missing.empty())
    error->all(file, line, Error::NOPOINTER, "Illegal {} command: missing argument: {}; write: {}",
               command, missing, usage);
}

}    // namespace LAMMPS_NS

#endif
