/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What a copy of a suspension would leave out: it is refused with its name.

#include "atom.h"
#include "bond.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "kspace.h"
#include "neighbor.h"
#include "pair_lubcontact.h"
#include "scene_instance.h"
#include "update.h"

#include <cmath>

using namespace LAMMPS_NS;

namespace {

// a member of LAMMPS' own class that is protected
struct Ghosts : Comm {
  static bool of_a_group(Comm *comm) { return comm->*(&Ghosts::bordergroup) != 0; }
};

}    // namespace

/* ----------------------------------------------------------------------
   what acts beside pair style and fixes; empty: nothing
------------------------------------------------------------------------- */

static std::string not_copied(LAMMPS *lmp)
{
  Atom *atom = lmp->atom;
  const Neighbor *neighbor = lmp->neighbor;
  Force *force = lmp->force;
  const struct {
    bool there;
    std::string name;
  } table[] = {
      {atom->nbonds > 0 || force->bond,
       fmt::format("bonds{}",
                   force->bond_style ? fmt::format(" of bond_style {}", force->bond_style) : "")},
      {atom->nangles > 0 || force->angle, "angles"},
      {atom->ndihedrals > 0 || force->dihedral, "dihedrals"},
      {atom->nimpropers > 0 || force->improper, "impropers"},
      {force->kspace != nullptr,
       fmt::format("kspace_style {}", force->kspace_style ? force->kspace_style : "")},
      {!utils::strmatch(atom->get_style(), "^sphere"),
       fmt::format("what particles of atom_style {} have beside those of atom_style sphere",
                   atom->get_style())},
      {!utils::strmatch(lmp->update->integrate_style, "^verlet"),
       fmt::format("run_style {}", lmp->update->integrate_style)},
      {force->pair->compute_flag == 0, "pair_modify compute no"},
      {neighbor->nex_type || neighbor->nex_group || neighbor->nex_mol, "neigh_modify exclude"},
      {neighbor->includegroup != 0, "neigh_modify include"},
      {neighbor->build_once != 0, "neigh_modify once yes"},
      {neighbor->style != Neighbor::NSQ && neighbor->style != Neighbor::BIN &&
           neighbor->style != Neighbor::MULTI,
       "neighbor multi/old"},
      {lmp->comm->mode != Comm::SINGLE && lmp->comm->mode != Comm::MULTI,
       "comm_modify mode multi/old"},
      {Ghosts::of_a_group(lmp->comm), "comm_modify group"},
  };
  std::string names;
  for (const auto &row : table)
    if (row.there) names += (names.empty() ? "" : ", ") + row.name;
  return names;
}

/* ---------------------------------------------------------------------- */

void SceneInstance::check_system(LAMMPS *lmp)
{
  const std::string names = not_copied(lmp);
  if (!names.empty())
    lmp->error->all(FLERR, "Suspension_scene measure cannot copy {}; {}", names, CURE);
  const auto *pair = dynamic_cast<PairLubcontact *>(lmp->force->pair);
  if (std::isnan(pair->viscosity()))
    lmp->error->all(FLERR,
                    "Suspension_scene measure does not know the viscosity of the pair style before "
                    "the first run: add run 0");
}
