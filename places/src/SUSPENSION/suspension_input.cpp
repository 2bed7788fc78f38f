/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "suspension_input.h"

#include "error.h"
#include "input.h"
#include "lammps.h"
#include "variable.h"

#include <vector>

using namespace LAMMPS_NS;
using Suspension_NS::InputNumber;

/* ---------------------------------------------------------------------- */

InputNumber::InputNumber(LAMMPS *lmp, const char *word)
{
  if (utils::strmatch(word, "^v_"))
    variable = word + 2;
  else
    value = utils::numeric(FLERR, word, false, lmp);
}

/* ---------------------------------------------------------------------- */

void InputNumber::check(LAMMPS *lmp, const char *style, const char *keyword) const
{
  if (is_number()) return;
  const int found = lmp->input->variable->find(variable.c_str());
  if (found < 0)
    lmp->error->all(FLERR, "Variable {} for fix {} {} does not exist", variable, style, keyword);
  if (!lmp->input->variable->equalstyle(found))
    lmp->error->all(FLERR, "Variable {} for fix {} {} is not equal-style", variable, style,
                    keyword);
}

/* ---------------------------------------------------------------------- */

bool InputNumber::evaluate(LAMMPS *lmp)
{
  if (is_number()) return false;
  Variable *variables = lmp->input->variable;
  value = variables->compute_equal(variables->find(variable.c_str()));
  return true;
}

/* ---------------------------------------------------------------------- */

void Suspension_NS::require_words(const std::string &file, int line, Error *error,
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
