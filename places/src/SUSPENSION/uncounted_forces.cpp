/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "uncounted_forces.h"

#include "angle.h"
#include "bond.h"
#include "comm.h"
#include "compute.h"
#include "dihedral.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "improper.h"
#include "kspace.h"
#include "modify.h"
#include "pair_hybrid.h"

#include <vector>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

void LAMMPS_NS::refuse_constraints(LAMMPS *lmp, const std::string &who)
{
  for (const auto &fix : lmp->modify->get_fix_list()) {
    if (fix->rigid_flag)
      lmp->error->all(FLERR,
                      "{} cannot count the constraint forces in the rigid bodies of fix {}; what "
                      "has them is compute pressure with fix_modify {} virial yes",
                      who, fix->id, fix->id);
    if (utils::strmatch(fix->style, "^shake") || utils::strmatch(fix->style, "^rattle"))
      lmp->error->all(
          FLERR,
          "{} cannot count the constraint forces of fix {} {}; what has them is compute "
          "pressure",
          who, fix->id, fix->style);
  }
}

/* ---------------------------------------------------------------------- */

// its sub-styles are known to its children alone
struct SubStyles : PairHybrid {
  static int number(const PairHybrid *pair) { return pair->*&SubStyles::nstyles; }
  static char **names(const PairHybrid *pair) { return pair->*&SubStyles::keywords; }
};

static void add_pairs(const Force *force, std::vector<std::string> &names)
{
  auto *hybrid = dynamic_cast<PairHybrid *>(force->pair);
  if (!hybrid) return;
  for (int m = 0; m < SubStyles::number(hybrid); m++) {
    const std::string style = SubStyles::names(hybrid)[m];
    if (!utils::strmatch(style, "^lubcontact") && !utils::strmatch(style, "^zero"))
      names.push_back("pair style " + style);
  }
}

std::string LAMMPS_NS::uncounted_forces(LAMMPS *lmp, bool other_pairs)
{
  const Force *force = lmp->force;
  std::vector<std::string> names;
  auto add = [&names](const void *acts, const char *kind, const char *style) {
    if (acts && style && !utils::strmatch(style, "^zero"))
      names.push_back(std::string(kind) + " style " + style);
  };
  if (other_pairs) add_pairs(force, names);
  add(force->bond, "bond", force->bond_style);
  add(force->angle, "angle", force->angle_style);
  add(force->dihedral, "dihedral", force->dihedral_style);
  add(force->improper, "improper", force->improper_style);
  add(force->kspace, "kspace", force->kspace_style);
  for (const auto &fix : lmp->modify->get_fix_list())
    if (fix->thermo_virial && fix->virial_global_flag)
      names.push_back(fmt::format("fix {} {}", fix->id, fix->style));

  std::string text;
  for (const std::string &name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/* ---------------------------------------------------------------------- */

void LAMMPS_NS::check_rows(LAMMPS *lmp, const Compute *compute)
{
  const std::string style = compute->style;
  refuse_constraints(lmp, "Compute " + style);
  if (utils::strmatch(lmp->force->pair_style, "^hybrid/scaled"))
    lmp->error->all(FLERR,
                    "Compute {} does not know the factors of pair_style hybrid/scaled; use: hybrid "
                    "or hybrid/overlay",
                    style);
  const Compute *first = nullptr;
  for (const auto &other : lmp->modify->get_compute_list())
    if (!first &&
        (utils::strmatch(other->style, "^stress/partition") ||
         utils::strmatch(other->style, "^power/partition")))
      first = other;
  const std::string missing = uncounted_forces(lmp, true);
  if (first == compute && !missing.empty() && lmp->comm->me == 0)
    lmp->error->warning(
        FLERR,
        "Compute {} is of pair style lubcontact and inertia alone; not in its rows, "
        "but in the pressure of LAMMPS: {}",
        style, missing);
}
