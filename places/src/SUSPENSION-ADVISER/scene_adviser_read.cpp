/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// suspension_scene: what is found in the system.

#include "scene_adviser.h"

#include "atom.h"
#include "domain.h"
#include "fix_deform_rheometer.h"
#include "fix_rheometer_plates.h"
#include "force.h"
#include "math_const.h"
#include "modify.h"
#include "pair_lubcontact.h"
#include "rheometer_mean.h"
#include "scene_instance.h"
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

void SceneAdviser::read_particles()
{
  double mine[3] = {}, sum[3];    // squares and cubes of the radii; volume, or area in 2d
  for (int i = 0; i < atom->nlocal; i++) {
    const double r = atom->radius[i];
    if (r == 0.0) continue;
    const double values[3] = {r * r, r * r * r, Suspension_NS::particle_volume(domain, r)};
    for (int n = 0; n < 3; n++) mine[n] += values[n];
  }
  MPI_Allreduce(mine, sum, 3, MPI_DOUBLE, MPI_SUM, world);

  const Suspension_NS::Particles all = Suspension_NS::measure_particles(lmp);
  scene.particles = all.number;
  scene.dimension = domain->dimension;
  scene.radius = all.mean;
  scene.radius_max = all.largest;
  scene.radius_min = all.smallest;
  const double a = scene.radius, square = MAX(sum[0] / all.number - a * a, 0.0);
  scene.spread = sqrt(square) / a;
  if (scene.spread > 1e-6)
    scene.skew = (sum[1] / all.number - 3.0 * a * square - a * a * a) / (square * sqrt(square));
  scene.density = all.density * force->mvv2e;
  total_mass = all.mass;
  scene.phi = sum[2] / Suspension_NS::cell_volume(domain);
  scene.dt = update->dt;
}

/* ---------------------------------------------------------------------- */

void SceneAdviser::read_box()
{
  const auto height = Suspension_NS::cell_heights(domain);
  for (int d = 0; d < domain->dimension; d++) {
    if (domain->periodicity[d])
      scene.box = known(scene.box) ? MIN(scene.box, height[d]) : height[d];
    else
      walls = true;
  }
}

/* ---------------------------------------------------------------------- */

void SceneAdviser::read_pair()
{
  const auto pairs = PairLubcontact::all(lmp);
  if (pairs.empty()) return;
  pair = pairs.front();
  law = pair->law();
  scene.viscosity = pair->viscosity();
  Scene_NS::describe_law(law, scene);
  double stiffest = 0.0;
  Scene_NS::each_pair(law, [&](int, int, const Lubcontact_NS::TypeCoeffs &c) {
    stiffest = MAX(stiffest, MAX(c.g, 3.5 * c.kt));
  });
  limit_known = pair->step_limit() > 0.0 && std::isfinite(pair->step_limit());
  if (limit_known) {    // masses may have changed since
    scene.dt_limit = pair->step_limit() * sqrt(total_mass / pair->step_limit_mass());
  } else if (overdamped()) {
    scene.dt_limit = UNKNOWN;
  } else if (stiffest > 0.0) {
    const double r = scene.radius_min;
    const double mass = 4.0 / 3.0 * MY_PI * r * r * r * scene.density;
    scene.dt_limit = 2.0 / sqrt(2.0 * MANY * stiffest / mass);
  }
}

/* ---------------------------------------------------------------------- */

void SceneAdviser::read_flow()
{
  const double stress = 1.0 / force->nktv2p;
  for (const auto &fix : modify->get_fix_by_style("^deform/rheometer$")) {
    const auto *rheometer = dynamic_cast<FixDeformRheometer *>(fix);
    const auto now = rheometer->imposed();
    if (now.holds_pressure)
      scene.pressure = now.pressure * stress;
    else
      read_pressure(rheometer->means(), stress);
    scene.rate = known(now.rate) ? now.rate : now.iv * scene.pressure / scene.viscosity;
    return;
  }
  const double rate = SceneInstance::deform_rate(lmp);
  if (rate != 0.0) scene.rate = rate;
}

/* ----------------------------------------------------------------------
   values of the last run
------------------------------------------------------------------------- */

void SceneAdviser::read_plates()
{
  const double stress = 1.0 / force->nktv2p;
  for (const auto &fix : modify->get_fix_by_style("^rheometer/plates$")) {
    walls = true;
    const auto *plates = dynamic_cast<FixRheometerPlates *>(fix);
    if (plates->phi() > 0.0) scene.phi = plates->phi();
    if (plates->rate() != 0.0) scene.rate = plates->rate();
    if (plates->gap() > 0.0) scene.height = plates->gap();
    if (plates->imposed_pressure() > 0.0)
      scene.pressure = plates->imposed_pressure() * stress;
    else
      read_pressure(plates->means(), 1.0);
  }
}

/* ----------------------------------------------------------------------
   mean over the last unit of strain; of less than SHORTEST it says nothing
------------------------------------------------------------------------- */

void SceneAdviser::read_pressure(const Rheometer_NS::StrainMeans &means, double unit)
{
  using namespace Rheometer_NS;
  const StrainBlock all = total(means);
  measured.strain = all.strain;
  if (all.strain < SHORTEST) return;
  const int half = (MEAN_BLOCKS + 1) / 2;
  measured.used = true;
  measured.deviation = deviation(all, PRESSURE_MEAN) * unit;
  scene.pressure = mean(all, PRESSURE_MEAN, UNKNOWN) * unit;
  measured.first = mean(total(means, half), PRESSURE_MEAN, UNKNOWN) * unit;
  measured.second = mean(total(means, 0, half), PRESSURE_MEAN, UNKNOWN) * unit;
}

/* ----------------------------------------------------------------------
   of all fixes together. All that it pulls on a wall or an open side presses on it, if it pulls
   straight
------------------------------------------------------------------------- */

void SceneAdviser::read_gravity()
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
  scene.gravity = g;
  const double edge[3] = {domain->xprd, domain->yprd, domain->dimension == 3 ? domain->zprd : 1.0};
  for (int d = 0; d < domain->dimension; d++)
    if (fabs(sum[d]) > 0.999 * g && !domain->periodicity[d])
      scene.bottom = total_mass * force->mvv2e * g * edge[d] / (edge[0] * edge[1] * edge[2]);
}
