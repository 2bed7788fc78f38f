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
#include "pair_lubcontact.h"
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

std::vector<PairLubcontact *> LAMMPS_NS::all_lubcontact(LAMMPS *lmp)
{
  Force *force = lmp->force;
  std::vector<PairLubcontact *> found;
  if (Pair *only = force->pair_match("^lubcontact", 0)) {
    found.push_back(dynamic_cast<PairLubcontact *>(only));
  } else {    // several under hybrid
    for (int nsub = 1; Pair *pair = force->pair_match("^lubcontact", 0, nsub); nsub++)
      found.push_back(dynamic_cast<PairLubcontact *>(pair));
  }
  return found;
}

/* ---------------------------------------------------------------------- */

const double *LAMMPS_NS::viscosity_of_pair(LAMMPS *lmp)
{
  const double *found = nullptr;
  int dim;
  for (PairLubcontact *pair : all_lubcontact(lmp)) {
    const auto *eta = static_cast<const double *>(pair->extract("eta", dim));
    if (!eta || (found && *found != *eta)) return nullptr;
    found = eta;
  }
  return found;
}

std::string LAMMPS_NS::why_no_viscosity(LAMMPS *lmp)
{
  const auto pairs = all_lubcontact(lmp);
  if (pairs.empty()) return "there is no pair style lubcontact";
  std::string values;
  int dim;
  for (PairLubcontact *pair : pairs) {
    const auto *eta = static_cast<const double *>(pair->extract("eta", dim));
    if (!eta) return "the viscosity of pair style lubcontact is a variable";
    values += fmt::format("{}{}", values.empty() ? "" : " and ", *eta);
  }
  return "the sub-styles lubcontact have different viscosities, " + values;
}
