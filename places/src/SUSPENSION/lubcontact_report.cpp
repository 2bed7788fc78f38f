/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "lubcontact_report.h"

#include "comm.h"
#include "domain.h"
#include "force.h"
#include "lubcontact_checks.h"
#include "lubcontact_type_coeffs.h"
#include "update.h"

#include <cmath>

using namespace LAMMPS_NS;
using Lubcontact_NS::Law;
using Lubcontact_NS::Settings;
using Suspension_NS::Particles;

static constexpr int SHOWN_TYPES = 4;

/* ----------------------------------------------------------------------
   one line per effect: no, yes, or why not now
------------------------------------------------------------------------- */

static std::string effect_lines(const Law &law, unsigned effects)
{
  const Settings &s = law.settings;
  std::string text;
  for (const auto &row : Lubcontact_NS::EFFECTS) {
    if (!row.label) continue;
    std::string more;
    if (row.bit == Lubcontact_NS::SQUEEZE) more = s.euler ? ", gap euler" : ", gap exponential";
    if (row.bit == Lubcontact_NS::ROLL && s.range != Lubcontact_NS::Range::RESIDUAL)
      more = fmt::format(", coefficient {:.6g}", s.roll_coeff);
    std::string state = "no";
    if (effects & row.bit) {
      const std::string idle = lubcontact_checks::idle(law, row.bit);
      state = idle.empty() ? "yes" + more : "not now: " + idle;
    }
    text += fmt::format("  {:<14} {}\n", row.label, state);
  }
  return text;
}

static std::string particle_line(const LubcontactRun &run)
{
  const Particles &p = run.particles;
  const std::string text = p.number == 0.0
      ? std::string("none yet")
      : fmt::format("{}, radius {:.6g} to {:.6g}, mean {:.6g}, {:.6g} pairs in range", p.number,
                    p.smallest, p.largest, p.mean, run.pairs);
  return fmt::format("  particles      {}, {} history values per pair\n", text, run.history);
}

static std::string type_lines(const Law &law)
{
  std::string text;
  const int shown = MIN(law.types, SHOWN_TYPES);
  for (int i = 1; i <= shown; i++)
    for (int j = i; j <= shown; j++) {
      const auto &c = law.of(i, j);
      if (c.g == 0.0) continue;
      const bool acts = c.friction == 0.0 || can_touch(law.settings, c);
      text += fmt::format("  types {} {}      g {:.6g} kt {:.6g} {}{}\n", i, j, c.g, c.kt,
                          surface_words(c), acts ? "" : ": smooth, without friction");
    }
  if (shown < law.types) text += "  further types: see write_data pair ij\n";
  return text;
}

/* ----------------------------------------------------------------------
   shear rate of the cell, if a fix deform shears it, and its dimensionless numbers
------------------------------------------------------------------------- */

static std::string flow_line(LAMMPS *lmp, const Law &law, const Particles &p)
{
  const Domain *domain = lmp->domain;
  const bool sheared = domain->triclinic && domain->deform_flag;
  const double rate = sheared ? domain->h_rate[5] / domain->yprd : 0.0;
  if (rate == 0.0 || p.number == 0.0) return "";
  double softest = HUGE_VAL;
  for (const auto &c : law.rows)
    if (c.g != 0.0) softest = MIN(softest, c.g);
  const double eta = law.settings.viscosity;
  std::string text = fmt::format("  shear rate     {:.6g}, Ca = eta rate a/g = {:.3g}", rate,
                                 eta * fabs(rate) * p.mean / softest);
  if (eta > 0.0)
    text += fmt::format(", St = rho a^2 rate/eta = {:.3g}",
                        p.density * p.mean * p.mean * fabs(rate) / (eta * lmp->force->ftm2v));
  return text + ", a = mean radius\n";
}

/* ---------------------------------------------------------------------- */

void LAMMPS_NS::report_lubcontact(LAMMPS *lmp, const Law &law, const std::string &variable,
                                  const LubcontactRun &run)
{
  if (lmp->comm->me) return;
  const Settings &s = law.settings;
  std::string text =
      "Pair style lubcontact: what this run simulates\n" + effect_lines(law, run.effects);
  text += fmt::format("  range          {} {:.6g} effective radii, radius {}\n",
                      Lubcontact_NS::RANGE_NAME[static_cast<int>(s.range)], s.reach_a,
                      s.radius == Lubcontact_NS::Radius::HARMONIC ? "harmonic" : "mean");
  text += fmt::format("  viscosity      {:.6g}{}\n", s.viscosity,
                      variable.empty() ? (s.viscosity == 0.0 ? ": dry grains" : "")
                                       : fmt::format(" now, variable {}", variable));
  text += particle_line(run) + type_lines(law);
  const double dt = lmp->update->dt;
  text += fmt::format("  time step      {:.6g}, ", dt);
  text += std::isfinite(run.step_limit)
      ? fmt::format("{:.3g} of the stability limit {:.6g}\n", dt / run.step_limit, run.step_limit)
      : "without limit here: no pair in range of particles with inertia\n";
  utils::logmesg(lmp, text + flow_line(lmp, law, run.particles));
}
