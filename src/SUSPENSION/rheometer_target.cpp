/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "rheometer_target.h"

#include "error.h"
#include "force.h"
#include "input.h"
#include "lammps.h"
#include "pair.h"
#include "variable.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

RheometerTarget::RheometerTarget(LAMMPS *lmp, const char *word)
{
  if (utils::strmatch(word, "^v_"))
    variable = word + 2;
  else
    value = utils::numeric(FLERR, word, false, lmp);
}

/* ---------------------------------------------------------------------- */

void RheometerTarget::check(LAMMPS *lmp, const char *style, const char *keyword) const
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

bool RheometerTarget::evaluate(LAMMPS *lmp)
{
  if (is_number()) return false;
  Variable *variables = lmp->input->variable;
  value = variables->compute_equal(variables->find(variable.c_str()));
  return true;
}

/* ---------------------------------------------------------------------- */

Pair *LAMMPS_NS::find_lubcontact(LAMMPS *lmp)
{
  Pair *pair = lmp->force->pair_match("^lubcontact", 0);
  return pair ? pair : lmp->force->pair_match("^lubcontact", 0, 1);
}

const double *LAMMPS_NS::viscosity_of_pair(LAMMPS *lmp)
{
  Pair *pair = find_lubcontact(lmp);
  int dim;
  return pair ? static_cast<const double *>(pair->extract("eta", dim)) : nullptr;
}
