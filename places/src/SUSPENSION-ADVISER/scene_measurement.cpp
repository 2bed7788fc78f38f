/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// suspension_scene measure: copies of the system run with everything on, and without each effect in
// turn.

#include "scene_measurement.h"

#include "background_fluid.h"
#include "error.h"
#include "exceptions.h"
#include "fix_deform_rheometer.h"
#include "fix_hydro.h"
#include "fix_pore_pressure.h"
#include "group.h"
#include "modify.h"
#include "pair_lubcontact.h"
#include "scene_laws.h"
#include "scene_sampler.h"
#include "scene_words.h"
#include "suspension_host.h"
#include "timer.h"
#include "update.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace LAMMPS_NS;
using Scene_NS::UNKNOWN;

static constexpr int COUNTED = 5;
static constexpr char COLUMNS[] = "  {:<14} {:>9} {:>9} {:>18} {:>18} {:>10}\n";

// what measuring an effect would need, where keywords of this command can give it
struct Cure {
  unsigned bit;
  const char *text;
};
static constexpr Cure CURES[] = {
    {Lubcontact_NS::FRICTION, "give its coefficient with 'friction mu'"},
    {Lubcontact_NS::THRESHOLD, "give it with 'critical F', and friction with 'friction mu'"},
    {Lubcontact_NS::ADHESION, "give the pull-off force with 'adhesion F'"},
    {Lubcontact_NS::REPULSION, "give its force and length with 'repulsion F lambda'"}};

// One line of the table; of the fluids beside the films, which are not of the pair law, the bit is
// 0. Where it shows: rows of compute stress/partition and of compute power/partition, or -1.
struct SceneMeasurement::Row {
  unsigned bit = 0;
  const char *name;
  int stress = -1, power = -1;
  const char *cure = "give its coefficients with pair_coeff";
  bool SceneInstance::Fluids::*fluid = nullptr;

  explicit Row(const Lubcontact_NS::EffectRow &effect) : bit(effect.bit), name(effect.name)
  {
    if (effect.channel < Lubcontact_NS::NUM_CHANNELS)
      stress = Lubcontact_NS::stress_row(effect.channel);
    if (effect.origin < Lubcontact_NS::NUM_ORIGINS) power = effect.origin;
    for (const Cure &one : CURES)
      if (one.bit == bit) cure = one.text;
  }
  Row(const char *fluid_name, bool SceneInstance::Fluids::*which, int stress_row, int power_row,
      const char *where) :
      name(fluid_name),
      stress(stress_row), power(power_row), cure(where), fluid(which)
  {
  }
  bool acts_in(const Case &all) const { return fluid ? all.fluids.*fluid : uses(all.law, bit); }
  Case removed_from(Case all) const
  {
    if (fluid) {
      all.fluids.*fluid = false;
      if (fluid == &SceneInstance::Fluids::far) all.law = Scene_NS::films_alone(all.law);
    } else
      all.law = without(all.law, bit);
    return all;
  }
};

// means over the blocks that count
struct SceneMeasurement::Measured {
  double stress[COUNTED] = {}, pressure[COUNTED] = {};
  double viscosity[COUNTED] = {}, phi[COUNTED] = {};    // stress over rate
  std::vector<double> parts, power;    // rows of the partitions; no power without its compute
  double seconds = 0.0;                // of CPU a step
  double strain = 0.0;
  bool history_kept = true;
};

namespace {

struct Mean {
  double value, error;
};

Mean mean(const double *x)
{
  double sum = 0.0, squares = 0.0;
  for (int n = 0; n < COUNTED; n++) sum += x[n];
  const double value = sum / COUNTED;
  for (int n = 0; n < COUNTED; n++) squares += (x[n] - value) * (x[n] - value);
  return {value, sqrt(squares / (COUNTED * (COUNTED - 1)))};
}

// relative change of the mean; both began alike, so that their blocks are compared one by one
Mean change(const double *without, const double *with)
{
  double difference[COUNTED];
  for (int n = 0; n < COUNTED; n++) difference[n] = without[n] - with[n];
  const double scale = fabs(mean(with).value);
  const Mean d = mean(difference);
  return {d.value / scale, d.error / scale};
}

// are both changes below the limit, with (1) or without (-1) twice their errors?
bool below(const std::array<Mean, 2> &by, double sign, double limit)
{
  return std::all_of(by.begin(), by.end(), [&](const Mean &x) {
    return fabs(x.value) + sign * 2.0 * x.error < limit;
  });
}

std::string percent(double x)
{
  return std::isfinite(x) ? fmt::format("{:.1f} %", 100.0 * x) : "-";
}

std::string percent(const Mean &x)
{
  return std::isfinite(x.value)
      ? fmt::format("{:+.1f} +- {:.1f} %", 100.0 * x.value, 100.0 * x.error)
      : "-";
}

void add(const std::vector<double> &x, std::vector<double> &sum)
{
  sum.resize(x.size());
  for (std::size_t n = 0; n < x.size(); n++) sum[n] += x[n];
}

double share(const std::vector<double> &parts, int row)
{
  double sum = 0.0;
  for (const double part : parts) sum += part;
  return row >= 0 && row < static_cast<int>(parts.size()) ? parts[row] / sum : NAN;
}

}    // namespace

/* ----------------------------------------------------------------------
   a copy of the system
------------------------------------------------------------------------- */

SceneMeasurement::Measured SceneMeasurement::run_copy(const Parts &parts, int nsteps,
                                                      const Case &one) const
{
  const SceneInstance copy(lmp, parts, one.law, one.fluids);
  const int block = nsteps / BLOCKS, every = MIN(block, 10);
  const bigint start = copy.lmp->update->ntimestep;
  SceneSampler sampler(copy, parts.flow, every);
  copy.one("thermo_style custom step");
  copy.one(fmt::format("run {} post no", nsteps));

  Measured result;
  result.history_kept = copy.history_kept;
  result.strain = fabs(parts.rate) * nsteps * update->dt;
  if (parts.rate == 0.0) {
    auto path = [](Fix *flow) {
      return dynamic_cast<FixDeformRheometer *>(flow)->strain_path();
    };
    result.strain = path(copy.lmp->modify->get_fix_by_id(parts.flow->id)) - path(parts.flow);
  }
  const double mine = copy.lmp->timer->get_cpu(Timer::TOTAL) / nsteps;
  MPI_Allreduce(&mine, &result.seconds, 1, MPI_DOUBLE, MPI_MAX, world);
  for (int b = 0; b < COUNTED; b++) {
    const bigint from = start + (BLOCKS - COUNTED + b) * block;
    const auto sxy = sampler.mean(from, from + block, sampler.sxy);
    const auto syy = sampler.mean(from, from + block, sampler.syy);
    const auto power = sampler.mean(from, from + block, sampler.power);
    for (const double part : sxy) result.stress[b] += part;
    for (const double part : syy) result.pressure[b] -= part;
    const auto rate = sampler.mean(from, from + block, sampler.rate);
    const auto phi = sampler.mean(from, from + block, sampler.phi);
    result.viscosity[b] = result.stress[b] / (rate.empty() ? parts.rate : rate[0]);
    result.phi[b] = phi.empty() ? UNKNOWN : phi[0];
    add(sxy, result.parts);
    add(power, result.power);
  }
  return result;
}

/* ----------------------------------------------------------------------
   lines of the script that make these effects
------------------------------------------------------------------------- */

std::string SceneMeasurement::deck_lines(const Parts &parts, const Case &one) const
{
  std::string text =
      Scene_NS::style_line(one.law, parts.pair->viscosity_word()) + Scene_NS::coeff_lines(one.law);
  auto show = [&](const Fix *fix, bool is_there, const std::string &typed) {
    text += is_there
        ? fmt::format("  fix {} {} {} {}\n", fix->id, group->names[fix->igroup], fix->style, typed)
        : fmt::format("  # and no fix {}\n", fix->id);
  };
  for (const Fix *fix : parts.drags)
    show(fix, one.fluids.drag, SceneInstance::background_of(fix)->typed());
  if (parts.pores)
    show(parts.pores, one.fluids.pores, dynamic_cast<FixPorePressure *>(parts.pores)->typed());
  if (parts.far) show(parts.far, one.fluids.far, dynamic_cast<FixHydro *>(parts.far)->typed());
  return text;
}

/* ----------------------------------------------------------------------
   suspension_scene measure N keyword values ...
------------------------------------------------------------------------- */

std::string SceneMeasurement::advice(int narg, char **arg)
{
  const Options options = parse(narg, arg);
  const Parts parts = SceneInstance::parts_of(lmp);
  check_laws(options, parts.pair->law());
  std::string text;
  try {
    text = leave_out_in_turn(parts, options);
  } catch (LAMMPSAbortException &e) {
    error->one(FLERR, "Suspension_scene measure, in its copy: {}", utils::trim(e.what()));
  } catch (LAMMPSException &e) {
    error->all(FLERR, "Suspension_scene measure, in its copy: {}", utils::trim(e.what()));
  }
  return text;
}

/* ----------------------------------------------------------------------
   what is other in a copy than with everything on, of what the flow does not hold
------------------------------------------------------------------------- */

struct SceneMeasurement::Comparison {
  const Parts &parts;
  const Measured &all;

  std::array<Mean, 2> changes(const Measured &one) const
  {
    return {parts.holds_rate ? change(one.stress, all.stress)
                             : change(one.viscosity, all.viscosity),
            parts.holds_pressure ? change(one.phi, all.phi) : change(one.pressure, all.pressure)};
  }
  std::string row(const char *name, const Measured &one, const std::string &stress = "-",
                  const std::string &power = "-") const
  {
    const auto by = changes(one);
    return fmt::format(COLUMNS, name, stress, power, percent(by[0]), percent(by[1]),
                       percent(1.0 - one.seconds / all.seconds));
  }
};

/* ----------------------------------------------------------------------
   an effect that a copy cannot do without; empty: it can
------------------------------------------------------------------------- */

std::string SceneMeasurement::why_it_stays(const Row &effect, const Parts &parts,
                                           const Case &everything)
{
  const bool moves = effect.fluid == &SceneInstance::Fluids::drag ||
      effect.fluid == &SceneInstance::Fluids::far;
  if (moves && parts.overdamped) return "where it moves the particles";
  if (effect.bit == Lubcontact_NS::SQUEEZE &&
      everything.law.settings.range == Lubcontact_NS::Range::RESIDUAL)
    return "of residual films, which are the rest of a far field";
  return "";
}

/* ----------------------------------------------------------------------
   one line of the table per effect, then the advice
------------------------------------------------------------------------- */

std::string SceneMeasurement::leave_out_in_turn(const Parts &parts, const Options &options) const
{
  const int nsteps = options.nsteps;
  const double a = Suspension_NS::measure_particles(lmp).mean;
  const SceneInstance::Fluids fluids{!parts.drags.empty(), parts.pores != nullptr,
                                     parts.far != nullptr};
  const Case deck{parts.pair->law(), fluids};
  const Case everything{Scene_NS::switched_on(deck.law, options.laws, a), fluids};
  const bool as_deck = Scene_NS::same_law(everything.law, deck.law);
  const Measured all = run_copy(parts, nsteps, everything);
  std::string text = head_of(parts, all, nsteps, as_deck);

  const Comparison compared{parts, all};
  if (!as_deck) text += compared.row("as the deck is", run_copy(parts, nsteps, deck));

  std::vector<Row> rows(std::begin(Lubcontact_NS::EFFECTS), std::end(Lubcontact_NS::EFFECTS));
  // in compute power/partition behind those of the pair law, with the kinetic energy between them
  const int power = Lubcontact_NS::NUM_ORIGINS;
  rows.emplace_back("drag", &SceneInstance::Fluids::drag, -1, power,
                    "add fix drag/background to the script");
  rows.emplace_back("pores", &SceneInstance::Fluids::pores, -1, power + 2,
                    "add fix pore/pressure to the script");
  rows.emplace_back("far field", &SceneInstance::Fluids::far, Lubcontact_NS::NUM_STRESS_ROWS + 1,
                    power + 3, "add fix hydro mean to the script");
  Case less = everything;    // without all that are idle
  int idle = 0;
  std::string undecided, missing;
  for (const Row &effect : rows) {
    if (!effect.acts_in(everything)) {
      missing += fmt::format("  {}: not measured; {}\n", effect.name, effect.cure);
      continue;
    }
    const std::string of_stress = percent(share(all.parts, effect.stress));
    const std::string of_power = percent(share(all.power, effect.power));
    const std::string stays = why_it_stays(effect, parts, everything);
    if (!stays.empty()) {
      text += fmt::format(COLUMNS, effect.name, of_stress, of_power, "-", "-", "-");
      missing += fmt::format("  {}: cannot be left out {}\n", effect.name, stays);
      continue;
    }
    const Measured one = run_copy(parts, nsteps, effect.removed_from(everything));
    text += compared.row(effect.name, one, of_stress, of_power);
    const auto by = compared.changes(one);
    if (below(by, 1.0, options.limit)) {
      less = effect.removed_from(less);
      idle++;
    } else if (below(by, -1.0, options.limit))
      undecided += std::string(" ") + effect.name;
  }
  if (idle > 1) text += compared.row("all of these", run_copy(parts, nsteps, less));
  text += missing +
      fmt::format("Input lines to use: changes below {} left out\n", percent(options.limit)) +
      deck_lines(parts, less);
  if (!undecided.empty())
    text += fmt::format("  # undecided within the scatter:{}; use more steps or particles\n",
                        undecided);
  if (all.strain < 1.0)
    text += "  # a strain below 1 shows what an effect does at once, not the structure that "
            "forms without it\n";
  return text;
}

/* ----------------------------------------------------------------------
   what is compared with, and the head of the table
------------------------------------------------------------------------- */

std::string SceneMeasurement::head_of(const Parts &parts, const Measured &all, int nsteps,
                                      bool as_deck) const
{
  const Mean stress = mean(all.stress), pressure = mean(all.pressure);
  const Mean viscosity = mean(all.viscosity), phi = mean(all.phi);
  std::string text =
      fmt::format("Suspension scene: {} steps of a copy, strain {:.4g}, means of the second half\n",
                  nsteps, all.strain);
  if (!all.history_kept)
    text += "  the pairs had no history yet: films and springs have built up in the first half "
            "(after read_restart: add run 0 before)\n";
  else if (!as_deck)
    text += "  effects missing in the script started as in new pairs\n";
  text +=
      fmt::format("  everything on{}: stress xy {:.6g} +- {:.2g}, pressure yy {:.6g} +- {:.2g}, "
                  "{:.4g} microseconds of CPU a step\n",
                  as_deck ? ", as the deck is" : "", stress.value, stress.error, pressure.value,
                  pressure.error, 1e6 * all.seconds);
  if (!parts.holds_rate)
    text += fmt::format("  the rate is not held: stress over rate {:.6g} +- {:.2g}\n",
                        viscosity.value, viscosity.error);
  if (parts.holds_pressure)
    text += fmt::format("  the volume is not held: phi {:.6g} +- {:.2g}\n", phi.value, phi.error);
  return text +
      fmt::format(COLUMNS, "left out", "of stress", "of power",
                  parts.holds_rate ? "change of stress" : "of stress/rate",
                  parts.holds_pressure ? "of phi" : "of pressure", "time saved");
}
