/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// suspension_scene measure: copies of the system run with everything on, and without each effect in
// turn.

#include "suspension_scene.h"

#include "atom.h"
#include "background_fluid.h"
#include "comm.h"
#include "error.h"
#include "exceptions.h"
#include "fix.h"
#include "force.h"
#include "group.h"
#include "lubcontact_channels.h"
#include "lubcontact_power.h"
#include "modify.h"
#include "scene_instance.h"
#include "scene_sampler.h"
#include "scene_verdict.h"
#include "suspension_input.h"
#include "timer.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using Scene_NS::UNKNOWN;
using Effects = SceneInstance::Effects;

static constexpr int BLOCKS = 10;    // of a run; the second half counts
static constexpr int COUNTED = 5;
static constexpr int PATH = 8;    // sum of |strain| in the output of fix deform/rheometer
static constexpr char COLUMNS[] = "  {:<14} {:>9} {:>9} {:>18} {:>18} {:>10}\n";

// where an effect shows: rows of compute stress/partition and of compute power/partition; and what
// measuring it would need
struct Row {
  const char *effect;
  int stress, power;
  const char *cure;
};
static constexpr Row ROWS[] = {
    {"squeeze", Lubcontact_NS::LUBRICATION_NORMAL, Lubcontact_NS::SQUEEZE_FILM, ""},
    {"shear", Lubcontact_NS::LUBRICATION_TANGENTIAL, Lubcontact_NS::SHEAR_FILM, ""},
    {"roll", -1, Lubcontact_NS::ROLL_FILM, ""},
    {"twist", -1, Lubcontact_NS::TWIST_FILM, ""},
    {"friction", Lubcontact_NS::CONTACT_TANGENTIAL, Lubcontact_NS::FRICTION_CONTACT,
     "give its coefficient with 'friction mu'"},
    {"critical load", -1, -1, "give it with 'critical F', and friction with 'friction mu'"},
    {"adhesion", -1, Lubcontact_NS::NORMAL_CONTACT, "give the pull-off force with 'adhesion F'"},
    {"repulsion", 5, Lubcontact_NS::REPULSIVE_FORCE,
     "give its force and length with 'repulsion F lambda'"},
    {SceneInstance::DRAG, -1, Lubcontact_NS::NUM_ORIGINS, "add fix drag/background to the script"}};

// means over the blocks that count
struct SuspensionScene::Measured {
  double stress[COUNTED] = {}, pressure[COUNTED] = {};
  double viscosity[COUNTED] = {}, phi[COUNTED] = {};    // stress over rate
  std::vector<double> parts, power;    // rows of the partitions; no power without its compute
  double seconds = 0.0;                // of CPU a step
  double strain = 0.0;
  bool history_kept = true;
  std::vector<std::string> on;    // effects
  std::string deck;               // lines that make them
};

// what the script asks for
struct SuspensionScene::Options {
  int nsteps = 0;
  double limit = 0.02;
  Effects all;
  int critical_word = 0, adhesion_word = 0;    // where they are, 0: nowhere
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
bool below(const Mean *by, double sign, double limit)
{
  return std::all_of(by, by + 2, [&](const Mean &x) {
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

bool contains(const std::vector<std::string> &all, const std::string &one)
{
  return std::find(all.begin(), all.end(), one) != all.end();
}

double share(const std::vector<double> &parts, int row)
{
  double sum = 0.0;
  for (const double part : parts) sum += part;
  return row >= 0 && row < static_cast<int>(parts.size()) ? parts[row] / sum : NAN;
}

}    // namespace

/* ----------------------------------------------------------------------
   a copy of the system, run with these effects
------------------------------------------------------------------------- */

SuspensionScene::Measured SuspensionScene::run_copy(const SceneInstance::Plan &plan, int nsteps,
                                                    const Effects &effects) const
{
  const SceneInstance copy(lmp, plan, effects);
  const int block = nsteps / BLOCKS, every = MIN(block, 10);
  const bigint start = copy.lmp->update->ntimestep;
  SceneSampler sampler(copy, plan.flow, every);
  copy.one("thermo_style custom step");
  copy.one(fmt::format("run {} post no", nsteps));

  Measured result;
  const auto *style = dynamic_cast<PairLubcontact *>(copy.lmp->force->pair);
  const bool drag = !plan.drags.empty() && !contains(effects.without, SceneInstance::DRAG);
  for (const Row &row : ROWS)
    if (row.effect == SceneInstance::DRAG ? drag : style->uses(row.effect))
      result.on.emplace_back(row.effect);
  result.deck = deck_lines_of(style, plan, drag);
  result.history_kept = copy.history_kept;
  result.strain = fabs(plan.rate) * nsteps * update->dt;
  if (plan.rate == 0.0) {
    Fix *flow = copy.lmp->modify->get_fix_by_id(plan.flow->id);
    result.strain = flow->compute_vector(PATH) - plan.flow->compute_vector(PATH);
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
    result.viscosity[b] = result.stress[b] / (rate.empty() ? plan.rate : rate[0]);
    result.phi[b] = phi.empty() ? UNKNOWN : phi[0];
    add(sxy, result.parts);
    add(power, result.power);
  }
  return result;
}

/* ----------------------------------------------------------------------
   lines of the script that make these effects
------------------------------------------------------------------------- */

std::string SuspensionScene::deck_lines_of(const PairLubcontact *style,
                                           const SceneInstance::Plan &plan, bool drag) const
{
  std::string text = "  pair_style " + style->settings_text({}) + "\n" + style->coeff_lines({});
  for (const Fix *fix : plan.drags)
    text += drag ? fmt::format("  fix {} {} {} {}\n", fix->id, group->names[fix->igroup],
                               fix->style, SceneInstance::background_of(fix)->typed())
                 : fmt::format("  # and no fix {}\n", fix->id);
  return text;
}

/* ----------------------------------------------------------------------
   suspension_scene measure N keyword values ...
------------------------------------------------------------------------- */

void SuspensionScene::measure(int narg, char **arg)
{
  read_particles();
  const Options options = parse_measure(narg, arg);
  const SceneInstance::Plan plan = SceneInstance::plan(lmp);
  check_laws(options, plan.pair);
  std::string text;
  try {
    text = leave_out_in_turn(plan, options);
  } catch (LAMMPSAbortException &e) {
    error->one(FLERR, "Suspension_scene measure, in its copy: {}", utils::trim(e.what()));
  } catch (LAMMPSException &e) {
    error->all(FLERR, "Suspension_scene measure, in its copy: {}", utils::trim(e.what()));
  }
  if (comm->me == 0) utils::logmesg(lmp, text);
}

/* ---------------------------------------------------------------------- */

SuspensionScene::Options SuspensionScene::parse_measure(int narg, char **arg) const
{
  Suspension_NS::require_words(FLERR, error, "suspension_scene", narg, "measure N ...");
  Options options;
  if (!utils::is_integer(arg[1]))
    error->all(FLERR, 1, "Suspension_scene measure needs a number of steps before keywords, not {}",
               arg[1]);
  options.nsteps = utils::inumeric(FLERR, arg[1], false, lmp);
  if (options.nsteps < BLOCKS || options.nsteps % BLOCKS)
    error->all(FLERR, 1,
               "Suspension_scene measure takes a number of steps that is a multiple of {}, but not "
               "{}",
               BLOCKS, arg[1]);
  options.all.radius = scene->radius;
  PairLubcontact::Laws &laws = options.all.laws;
  laws = {UNKNOWN, UNKNOWN, UNKNOWN, UNKNOWN, UNKNOWN};
  const struct {
    const char *name, *usage;
    std::vector<double *> values;
  } keywords[] = {{"change", "change f", {&options.limit}},
                  {"friction", "friction mu", {&laws.friction}},
                  {"critical", "critical F", {&laws.critical}},
                  {"adhesion", "adhesion F", {&laws.pull_off}},
                  {"repulsion", "repulsion F0 lambda", {&laws.repulsion, &laws.screening}}};
  int places[std::size(keywords)] = {};
  for (int iarg = 2; iarg < narg;) {
    const auto *found = std::find_if(std::begin(keywords), std::end(keywords), [&](const auto &k) {
      return strcmp(arg[iarg], k.name) == 0;
    });
    if (found == std::end(keywords))
      error->all(FLERR, iarg,
                 "Unknown suspension_scene measure keyword: {}; those that exist: change, "
                 "friction, critical, adhesion, repulsion",
                 arg[iarg]);
    places[found - keywords] = iarg;
    const int count = static_cast<int>(found->values.size());
    Suspension_NS::require_words(FLERR, error, "suspension_scene measure", narg - iarg,
                                 found->usage);
    for (int n = 1; n <= count; n++) {
      const double value = utils::numeric(FLERR, arg[iarg + n], false, lmp);
      if (!(value > 0.0))
        error->all(FLERR, iarg + n, "Suspension_scene measure {} must be > 0, but is {}", arg[iarg],
                   arg[iarg + n]);
      *found->values[n - 1] = value;
    }
    iarg += 1 + count;
  }
  options.critical_word = places[2];
  options.adhesion_word = places[3];
  return options;
}

/* ---------------------------------------------------------------------- */

void SuspensionScene::check_laws(const Options &options, const PairLubcontact *style) const
{
  if (options.critical_word && std::isnan(options.all.laws.friction) && !style->uses("friction"))
    error->all(FLERR, options.critical_word,
               "Suspension_scene measure critical cannot act without friction: give friction mu, "
               "too");
  if (!options.adhesion_word) return;
  int dim;
  const auto *const *roughness = static_cast<double **>(force->pair->extract("roughness", dim));
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++)
      if (style->setflag[i][j] && roughness[i][j] == 0.0)
        error->all(FLERR, options.adhesion_word,
                   "Suspension_scene measure adhesion is of asperities, but types {} {} have none: "
                   "give them a roughness > 0",
                   i, j);
}

/* ----------------------------------------------------------------------
   one line of the table per effect, then the advice
------------------------------------------------------------------------- */

std::string SuspensionScene::leave_out_in_turn(const SceneInstance::Plan &plan,
                                               const Options &options) const
{
  const int nsteps = options.nsteps;
  const Measured all = run_copy(plan, nsteps, options.all);
  const bool as_deck = all.deck == deck_lines_of(plan.pair, plan, true);
  std::string text = head_of(plan, all, nsteps, as_deck);

  struct Changes {
    Mean by[2];
  };
  auto changes = [&plan, &all](const Measured &one) {    // of what the flow does not hold
    const Mean resistance = plan.holds_rate ? change(one.stress, all.stress)
                                            : change(one.viscosity, all.viscosity);
    return Changes{resistance,
                   plan.holds_pressure ? change(one.phi, all.phi)
                                       : change(one.pressure, all.pressure)};
  };
  auto row = [&](const char *name, const Measured &one, const std::string &stress,
                 const std::string &power) {
    const Changes c = changes(one);
    text += fmt::format(COLUMNS, name, stress, power, percent(c.by[0]), percent(c.by[1]),
                        percent(1.0 - one.seconds / all.seconds));
  };
  if (!as_deck) {
    Effects deck;
    deck.everything = false;
    row("as the deck is", run_copy(plan, nsteps, deck), "-", "-");
  }
  Effects less = options.all;    // and less the idle ones
  std::string undecided, missing, lines = all.deck;
  for (const Row &effect : ROWS) {
    const std::string name = effect.effect;
    if (!contains(all.on, name)) {
      missing += fmt::format("  {}: not measured; {}\n", name, effect.cure);
      continue;
    }
    const std::string of_stress = percent(share(all.parts, effect.stress));
    const std::string of_power = percent(share(all.power, effect.power));
    if (name == SceneInstance::DRAG && plan.overdamped) {
      text += fmt::format(COLUMNS, name, of_stress, of_power, "-", "-", "-");
      missing += "  drag: cannot be left out where it moves the particles\n";
      continue;
    }
    Effects without = options.all;
    without.without = {name};
    const Measured one = run_copy(plan, nsteps, without);
    row(effect.effect, one, of_stress, of_power);
    const Changes c = changes(one);
    if (below(c.by, 1.0, options.limit)) {
      less.without.push_back(name);
      lines = one.deck;
    } else if (below(c.by, -1.0, options.limit))
      undecided += " " + name;
  }
  if (less.without.size() > 1) {
    const Measured one = run_copy(plan, nsteps, less);
    row("all of these", one, "-", "-");
    lines = one.deck;
  }
  text += missing +
      fmt::format("Deck lines to use: changes below {} left out\n", percent(options.limit)) + lines;
  if (!undecided.empty())
    text += fmt::format("  # within its scatter undecided:{}; more steps or particles tell\n",
                        undecided);
  if (all.strain < 1.0)
    text += "  # a strain below 1 shows what an effect does at once, not the structure that "
            "forms without it\n";
  return text;
}

/* ----------------------------------------------------------------------
   what is compared with, and the head of the table
------------------------------------------------------------------------- */

std::string SuspensionScene::head_of(const SceneInstance::Plan &plan, const Measured &all,
                                     int nsteps, bool as_deck) const
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
    text += "  what the deck lacks began as in pairs that have just met\n";
  text +=
      fmt::format("  everything on{}: stress xy {:.6g} +- {:.2g}, pressure yy {:.6g} +- {:.2g}, "
                  "{:.4g} microseconds of CPU a step\n",
                  as_deck ? ", as the deck is" : "", stress.value, stress.error, pressure.value,
                  pressure.error, 1e6 * all.seconds);
  if (!plan.holds_rate)
    text += fmt::format("  the rate is not held: stress over rate {:.6g} +- {:.2g}\n",
                        viscosity.value, viscosity.error);
  if (plan.holds_pressure)
    text += fmt::format("  the volume is not held: phi {:.6g} +- {:.2g}\n", phi.value, phi.error);
  return text +
      fmt::format(COLUMNS, "left out", "of stress", "of power",
                  plan.holds_rate ? "change of stress" : "of stress/rate",
                  plan.holds_pressure ? "of phi" : "of pressure", "time saved");
}
