/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// suspension_scene: what is found in the system.

#include "suspension_scene.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix_deform_rheometer.h"
#include "fix_rheometer_plates.h"
#include "force.h"
#include "math_const.h"
#include "modify.h"
#include "pair_lubcontact.h"
#include "rheometer_mean.h"
#include "scene_instance.h"
#include "scene_numbers.h"
#include "suspension_host.h"
#include "update.h"

#include <cmath>

using namespace LAMMPS_NS;
using MathConst::MY_PI;
using Scene_NS::known;
using Scene_NS::UNKNOWN;

static constexpr double MANY = 12.0;       // neighbors of a crowded particle
static constexpr double SHORTEST = 0.1;    // strain of a mean: less is a snapshot

/* ---------------------------------------------------------------------- */

void SuspensionScene::read_particles()
{
  // number, radii, their squares and cubes, volume, area or volume, mass
  double mine[7] = {}, sum[7];
  double mine_max[2] = {-HUGE_VAL, -HUGE_VAL}, max[2];
  for (int i = 0; i < atom->nlocal; i++) {
    const double r = atom->radius[i];
    if (r == 0.0) continue;
    const double volume = 4.0 / 3.0 * MY_PI * r * r * r;    // discs have the mass of spheres
    const double values[7] = {1.0,           r,      r * r,
                              r * r * r,     volume, Suspension_NS::particle_volume(domain, r),
                              atom->rmass[i]};
    for (int n = 0; n < 7; n++) mine[n] += values[n];
    mine_max[0] = MAX(mine_max[0], r);
    mine_max[1] = MAX(mine_max[1], -r);
  }
  MPI_Allreduce(mine, sum, 7, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(mine_max, max, 2, MPI_DOUBLE, MPI_MAX, world);
  if (sum[0] == 0.0) error->all(FLERR, "Suspension_scene: no particle has a radius");

  scene->particles = sum[0];
  scene->dimension = domain->dimension;
  scene->radius = sum[1] / sum[0];
  scene->radius_max = max[0];
  scene->radius_min = -max[1];
  const double a = scene->radius, square = MAX(sum[2] / sum[0] - a * a, 0.0);
  scene->spread = sqrt(square) / a;
  if (scene->spread > 1e-6)
    scene->skew = (sum[3] / sum[0] - 3.0 * a * square - a * a * a) / (square * sqrt(square));
  scene->density = sum[6] / sum[4] * force->mvv2e;
  total_mass = sum[6];
  scene->phi = sum[5] / Suspension_NS::cell_volume(domain);
  scene->dt = update->dt;
}

/* ---------------------------------------------------------------------- */

void SuspensionScene::read_box()
{
  const auto height = Suspension_NS::cell_heights(domain);
  for (int d = 0; d < domain->dimension; d++) {
    if (domain->periodicity[d])
      scene->box = known(scene->box) ? MIN(scene->box, height[d]) : height[d];
    else
      walls = true;
  }
}

/* ----------------------------------------------------------------------
   of several types the softest, the smoothest and the roughest
------------------------------------------------------------------------- */

void SuspensionScene::read_pair()
{
  const auto pairs = PairLubcontact::all(lmp);
  if (pairs.empty()) return;
  pair = pairs.front();
  scene->viscosity = pair->viscosity();
  int dim;
  const auto *const *g = static_cast<double **>(pair->extract("g", dim));
  const auto *const *kt = static_cast<double **>(pair->extract("kt", dim));
  const auto *const *roughness = static_cast<double **>(pair->extract("roughness", dim));
  const auto *const *friction = static_cast<double **>(pair->extract("friction", dim));
  double stiffest = 0.0;
  auto less = [](double a, double b) {
    return !known(a) || b < a ? b : a;
  };
  for (int i = 1; g && i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      if (!pair->setflag[i][j]) continue;
      scene->g = less(scene->g, g[i][j]);
      scene->roughness = less(scene->roughness, roughness[i][j]);
      scene->friction = -less(-scene->friction, -friction[i][j]);
      stiffest = MAX(stiffest, MAX(g[i][j], 3.5 * kt[i][j]));
      const auto forces = pair->surface_forces(i, j, scene->radius);
      if (forces.critical > 0.0) {
        scene->critical = less(scene->critical, forces.critical);
        scene->critical_max = -less(-scene->critical_max, -forces.critical);
      } else if (friction[i][j] > 0.0) {
        scene->rubs_always = true;
      }
      if (forces.pull_off > 0.0) scene->adhesion = -less(-scene->adhesion, -forces.pull_off);
      if (forces.repulsion > 0.0) scene->repulsion = -less(-scene->repulsion, -forces.repulsion);
    }
  if (pair->uses("clm shift")) scene->critical_law = Scene_NS::SHIFT_LAW;
  if (pair->uses("clm ramp")) scene->critical_law = Scene_NS::RAMP_LAW;
  limit_known = pair->dt_limit > 0.0 && std::isfinite(pair->dt_limit);
  if (limit_known) {    // masses may have changed since
    scene->dt_limit = pair->dt_limit * sqrt(total_mass / pair->dt_limit_mass);
  } else if (overdamped()) {
    scene->dt_limit = UNKNOWN;
  } else if (stiffest > 0.0) {
    const double r = scene->radius_min;
    const double mass = 4.0 / 3.0 * MY_PI * r * r * r * scene->density;
    scene->dt_limit = 2.0 / sqrt(2.0 * MANY * stiffest / mass);
  }
}

/* ---------------------------------------------------------------------- */

void SuspensionScene::read_flow()
{
  const double stress = 1.0 / force->nktv2p;
  for (const auto &fix : modify->get_fix_by_style("^deform/rheometer$")) {
    const auto *rheometer = dynamic_cast<FixDeformRheometer *>(fix);
    const auto now = rheometer->imposed();
    if (now.holds_pressure)
      scene->pressure = now.pressure * stress;
    else
      read_pressure(rheometer->means(), stress);
    scene->rate = known(now.rate) ? now.rate : now.iv * scene->pressure / scene->viscosity;
    return;
  }
  const double rate = SceneInstance::deform_rate(lmp);
  if (rate != 0.0) scene->rate = rate;
}

/* ----------------------------------------------------------------------
   values of the last run
------------------------------------------------------------------------- */

void SuspensionScene::read_plates()
{
  enum { RATE = 1, PHI = 5, TARGET = 13 };
  const double stress = 1.0 / force->nktv2p;
  for (const auto &fix : modify->get_fix_by_style("^rheometer/plates$")) {
    walls = true;
    if (fix->compute_vector(PHI) > 0.0) scene->phi = fix->compute_vector(PHI);
    if (fix->compute_vector(RATE) != 0.0) scene->rate = fix->compute_vector(RATE);
    const double target = fix->compute_vector(TARGET);
    if (target > 0.0)
      scene->pressure = target * stress;
    else
      read_pressure(dynamic_cast<FixRheometerPlates *>(fix)->means(), 1.0);
  }
}

/* ----------------------------------------------------------------------
   mean over the last unit of strain; of less than SHORTEST it says nothing
------------------------------------------------------------------------- */

void SuspensionScene::read_pressure(const Rheometer_NS::StrainMeans &means, double unit)
{
  using namespace Rheometer_NS;
  const StrainBlock all = total(means);
  measured.strain = all.strain;
  if (all.strain < SHORTEST) return;
  const int half = (MEAN_BLOCKS + 1) / 2;
  measured.used = true;
  measured.deviation = deviation(all, PRESSURE_MEAN) * unit;
  scene->pressure = mean(all, PRESSURE_MEAN, UNKNOWN) * unit;
  measured.first = mean(total(means, half), PRESSURE_MEAN, UNKNOWN) * unit;
  measured.second = mean(total(means, 0, half), PRESSURE_MEAN, UNKNOWN) * unit;
}

/* ----------------------------------------------------------------------
   of all fixes together. All that it pulls on a wall or an open side presses on it, if it pulls straight
------------------------------------------------------------------------- */

void SuspensionScene::read_gravity()
{
  double sum[3] = {};
  for (const auto &fix : modify->get_fix_by_style("^gravity")) {
    int dim;
    const auto *g = static_cast<double *>(fix->extract("gvec", dim));
    for (int d = 0; g && d < 3; d++) sum[d] += g[d];
    gravity += fmt::format("{}fix {}", gravity.empty() ? "" : ", ", fix->id);
  }
  if (!modify->get_fix_by_style("^wall").empty()) walls = true;
  const double g = sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
  if (g == 0.0) return;
  scene->gravity = g;
  const double edge[3] = {domain->xprd, domain->yprd, domain->dimension == 3 ? domain->zprd : 1.0};
  for (int d = 0; d < domain->dimension; d++)
    if (fabs(sum[d]) > 0.999 * g && !domain->periodicity[d])
      scene->bottom = total_mass * force->mvv2e * g * edge[d] / (edge[0] * edge[1] * edge[2]);
}
