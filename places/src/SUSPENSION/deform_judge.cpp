/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "deform_judge.h"

#include "comm.h"
#include "deform_stress.h"
#include "deform_targets.h"
#include "error.h"

#include <cmath>

using namespace LAMMPS_NS;
using namespace Rheometer_NS;

/* ---------------------------------------------------------------------- */

DeformJudge::DeformJudge(LAMMPS *lmp, const char *style_of_fix) :
    Pointers(lmp), style(style_of_fix), verdict(IDLE), warned(false), warned_every(false)
{
}

void DeformJudge::start_anew()
{
  watched = {};
  warned = false;
}

void DeformJudge::warn(const std::string &what)
{
  if (!warned && comm->me == 0) error->warning(FLERR, "Fix {}: {}", style, what);
  warned = true;
}

/* ---------------------------------------------------------------------- */

void DeformJudge::judge(const DeformTargets &targets, const DeformStress &measured, double rate,
                        double dilation, double trouton, double dt)
{
  verdict = IDLE;
  const bool drives = targets.drive() == DeformTargets::STRESS;
  if (!warned_every && (targets.holds_pressure() || drives) && fabs(rate) * dt > 0.5 * LAG) {
    if (comm->me == 0)
      error->warning(FLERR,
                     "Fix {}: the strain {:.3g} between two adjustments of the flow exceeds half "
                     "the time lag of the servos, {}: reduce every, or the time step",
                     style, fabs(rate) * dt, LAG);
    warned_every = true;
  }
  if (targets.holds_pressure()) judge_pressure(targets, measured, rate, dilation, dt);
  if (drives) judge_stress(targets, measured, rate, trouton, dt);
}

/* ---------------------------------------------------------------------- */

void DeformJudge::judge_pressure(const DeformTargets &targets, const DeformStress &measured,
                                 double rate, double dilation, double dt)
{
  const Material &material = measured.material();
  const double target = targets.pressure();
  const double w = servo_rate(material, rate, target, PRESSURE_FLOOR);
  watched.pressure = watch(watched.pressure, measured.pressure() / target - 1.0, w, dt);
  verdict = fabs(dilation) < dilation_limit(material, target, rate, targets.gain()) ? FOLLOWING
                                                                                    : LIMITED;
  if (!unreachable(watched.pressure)) return;
  verdict = UNREACHABLE;
  warn(fmt::format("the pressure, now {:.4g}, has been far from its target {:.4g} for {:.3g} units "
                   "of strain: this system cannot reach it",
                   measured.pressure(), target, watched.pressure.age));
}

/* ----------------------------------------------------------------------
   out of reach: nothing resists enough. Jammed: the stress is carried without flow
------------------------------------------------------------------------- */

void DeformJudge::judge_stress(const DeformTargets &targets, const DeformStress &measured,
                               double rate, double trouton, double dt)
{
  const Material &material = measured.material();
  const double target = targets.driven();
  const double creep = STRESS_FLOOR * rearrangement_rate(material, target);
  if (verdict == IDLE) verdict = FOLLOWING;
  if (creep == 0.0) return;
  const double w = servo_rate(material, rate, target, STRESS_FLOOR);
  const double total = measured.stress() + trouton * material.eta * rate;
  watched.stress = watch(watched.stress, total / target - 1.0, w, dt);
  if (unreachable(watched.stress)) {
    verdict = UNREACHABLE;
    warn(fmt::format("the stress, now {:.4g} at the rate {:.4g}, has been far from its target "
                     "{:.4g} for {:.3g} units of strain: this system cannot reach it",
                     total, rate, target, watched.stress.age));
  }
  watched.rate = watch(watched.rate, fabs(rate) / creep, w, dt);
  if (!jammed(watched.rate)) return;
  verdict = UNREACHABLE;
  warn(fmt::format("jammed, the particles carry the stress {:.4g} without flowing; mean rate "
                   "{:.3g}",
                   target, watched.rate.deviation * creep));
}
