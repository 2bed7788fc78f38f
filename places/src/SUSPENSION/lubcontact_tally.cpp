/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "lubcontact_tally.h"

#include "atom.h"
#include "compute.h"
#include "modify.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;
using Lubcontact_NS::Energies;
using Lubcontact_NS::Load;
using Lubcontact_NS::NUM_CHANNELS;
using Lubcontact_NS::PairGeometry;
using Lubcontact_NS::Vec3;

/* ---------------------------------------------------------------------- */

LubcontactTally::LubcontactTally(LAMMPS *lmp) :
    Pointers(lmp), stress_now(false), atoms_now(false), power_now(false), step_made(false),
    stress_step(-1), atoms_step(-1), power_step(-1), sums()
{
}

/* ---------------------------------------------------------------------- */

void LubcontactTally::find_clients()
{
  stress_clients = modify->get_compute_by_style("^stress/partition$");
  atom_clients = modify->get_compute_by_style("^stress/partition/atom");
  power_clients = modify->get_compute_by_style("^power/partition$");
}

/* ---------------------------------------------------------------------- */

bool LubcontactTally::announced(const std::vector<Compute *> &computes) const
{
  bool any = false;    // each is asked: it forgets the step
  for (Compute *compute : computes)
    if (compute->matchstep(update->ntimestep)) any = true;
  return any;
}

void LubcontactTally::start_step()
{
  const bigint step = update->ntimestep;
  power_now = announced(power_clients);
  stress_now = announced(stress_clients) || power_now;    // the power put in is of the stress
  atoms_now = announced(atom_clients);
  if (stress_now) {
    sums = {};
    stress_step = step;
  }
  if (atoms_now) {
    atoms.assign(atom->nlocal + atom->nghost, {});
    atoms_step = step;
  }
  if (power_now) {
    lost = kept = {};
    power_step = step;
    step_made = !update->setupflag;
  }
}

/* ---------------------------------------------------------------------- */

void LubcontactTally::add_stress(int i, int j, double weight, const PairGeometry &geometry,
                                 const Load &load)
{
  const auto force_of = Lubcontact_NS::force_by_channel(geometry, load);
  const Vec3 d = geometry.r * geometry.n;
  for (int m = 0; m < NUM_CHANNELS; m++) {
    const Vec3 &f = force_of.of[m];
    const double product[NUM_COMPONENTS] = {d.x * f.x, d.y * f.y, d.z * f.z, d.x * f.y, d.x * f.z,
                                            d.y * f.z, d.y * f.x, d.z * f.x, d.z * f.y};
    add(i, j, weight, static_cast<Lubcontact_NS::Channel>(m), product);
  }
}

void LubcontactTally::add(int i, int j, double weight, Lubcontact_NS::Channel m,
                          const double *product)
{
  if (stress_now)
    for (int n = 0; n < NUM_COMPONENTS; n++) sums[m][n] += weight * product[n];
  if (atoms_now)
    for (int n = 0; n < NUM_COMPONENTS; n++) {
      atoms[i][m][n] += 0.5 * product[n];
      atoms[j][m][n] += 0.5 * product[n];
    }
}

/* ----------------------------------------------------------------------
   forces that repel are positive: minus the stresslet
------------------------------------------------------------------------- */

void LubcontactTally::add_stresslet(int i, int j, double weight,
                                    const Lubcontact_NS::FilmStresslet &stresslet)
{
  auto add_part = [&](Lubcontact_NS::Channel m, const Lubcontact_NS::SymmetricTensor &s) {
    const double product[NUM_COMPONENTS] = {-s.xx, -s.yy, -s.zz, -s.xy, -s.xz,
                                            -s.yz, -s.xy, -s.xz, -s.yz};
    add(i, j, weight, m, product);
  };
  add_part(Lubcontact_NS::LUBRICATION_NORMAL, stresslet.normal);
  add_part(Lubcontact_NS::LUBRICATION_TANGENTIAL, stresslet.tangential);
}

/* ---------------------------------------------------------------------- */

static void add_to(double weight, const Energies &energies, Energies &sum)
{
  for (int m = 0; m < Lubcontact_NS::NUM_ORIGINS; m++) sum.of[m] += weight * energies.of[m];
}

void LubcontactTally::add_stored(double weight, const Energies &energies)
{
  add_to(weight, energies, kept);
}

void LubcontactTally::add_heat(double weight, const Energies &energies)
{
  add_to(weight, energies, lost);
}

/* ---------------------------------------------------------------------- */

bool LubcontactTally::has_stress() const
{
  return stress_step == update->ntimestep;
}

bool LubcontactTally::has_atoms() const
{
  return atoms_step == update->ntimestep &&
      static_cast<int>(atoms.size()) == atom->nlocal + atom->nghost;
}

bool LubcontactTally::has_power() const
{
  return power_step == update->ntimestep;
}

/* ---------------------------------------------------------------------- */

double LubcontactTally::memory_usage() const
{
  return static_cast<double>(atoms.capacity() * sizeof(Stress));
}
