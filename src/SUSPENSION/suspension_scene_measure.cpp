/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// suspension_scene measure: copies of the system run with all effects on, and without each in turn.

#include "suspension_scene.h"

#include "comm.h"
#include "compute.h"
#include "error.h"
#include "exceptions.h"
#include "fix.h"
#include "lubcontact_channels.h"
#include "modify.h"
#include "pair_lubcontact.h"
#include "scene_instance.h"
#include "scene_verdict.h"
#include "timer.h"
#include "update.h"

#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

static constexpr int BLOCKS = 10;    // of a run; the second half counts
static constexpr int COUNTED = 5;
static constexpr int PATH = 8;    // sum of |strain| in the output of fix deform/rheometer
static constexpr char COLUMNS[] = "  {:<14} {:>9} {:>9} {:>18} {:>18} {:>10}\n";

// where an effect shows: rows of compute stress/partition and of compute power/partition
struct Rows {
  const char *effect;
  int stress, power;
};
static constexpr Rows ROWS[] = {{"squeeze", lubcontact::LUBRICATION_NORMAL, 2},
                                {"shear", lubcontact::LUBRICATION_TANGENTIAL, 3},
                                {"roll", -1, 4},
                                {"twist", -1, 5},
                                {"friction", lubcontact::CONTACT_TANGENTIAL, 1},
                                {"critical load", -1, -1},
                                {"adhesion", -1, 0},
                                {"repulsion", 5, 6}};

// means over the blocks that count
struct SuspensionScene::Measured {
  double stress[COUNTED] = {}, pressure[COUNTED] = {};
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

Fix *there(const SceneInstance &copy, const Fix *fix)
{
  return copy.lmp->modify->get_fix_by_id(fix->id);
}

double share(const std::vector<double> &parts, int row)
{
  double sum = 0.0;
  for (const double part : parts) sum += part;
  return row >= 0 && row < static_cast<int>(parts.size()) ? parts[row] / sum : NAN;
}

// collects the parts of stress and power in a copy
class Sampler {
 public:
  Sampler(const SceneInstance &copy, int every) : interval(every)
  {
    Modify *modify = copy.lmp->modify;
    std::string values;
    auto watch = [&](const char *name, int row, int column, std::vector<int> &where) {
      const std::string value = fmt::format("scene_{}_{}_{}", name, row, column);
      copy.one(fmt::format("variable {} equal c_scene_{}[{}][{}]", value, name, row, column));
      values += " v_" + value;
      where.push_back(size++);
    };
    copy.one("compute scene_stress all stress/partition");
    const int rows = modify->get_compute_by_id("scene_stress")->size_array_rows;
    for (int row = 1; row <= rows; row++) {
      watch("stress", row, 4, sxy);
      watch("stress", row, 2, syy);
    }
    if (modify->compute_map->count("power/partition")) {
      copy.one("compute scene_power all power/partition");
      const int channels = modify->get_compute_by_id("scene_power")->size_array_rows;
      for (int row = 1; row <= channels; row++) watch("power", row, 1, power);
    }
    copy.one(fmt::format("fix scene_samples all vector {}{}", every, values));
    samples = modify->get_fix_by_id("scene_samples");
    const bigint now = copy.lmp->update->ntimestep;
    first = (now + every - 1) / every * every;
  }

  // of these columns, over the steps after from and up to the end
  std::vector<double> mean(bigint from, bigint end, const std::vector<int> &columns) const
  {
    std::vector<double> means(columns.size(), 0.0);
    const int begin = static_cast<int>((from - first) / interval + (from >= first ? 1 : 0));
    const int stop = static_cast<int>((end - first) / interval + 1);
    for (int n = begin; n < stop; n++)
      for (std::size_t m = 0; m < columns.size(); m++)
        means[m] += samples->compute_array(n, columns[m]) / (stop - begin);
    return means;
  }

  std::vector<int> sxy, syy, power;    // columns

 private:
  Fix *samples;
  bigint first;    // step of the first sample
  int interval, size = 0;
};

}    // namespace

/* ----------------------------------------------------------------------
   a copy of the system, run without some effects
------------------------------------------------------------------------- */

SuspensionScene::Measured SuspensionScene::run_copy(int nsteps,
                                                    const std::vector<std::string> &without) const
{
  const SceneInstance::Plan plan = SceneInstance::plan(lmp);
  const SceneInstance copy(lmp, plan, without);
  const int block = nsteps / BLOCKS, every = MIN(block, 10);
  const bigint start = copy.lmp->update->ntimestep;
  Sampler sampler(copy, every);
  copy.one("thermo_style custom step");
  copy.one(fmt::format("run {} post no", nsteps));

  Measured result;
  result.history_kept = copy.history_kept;
  result.strain = fabs(plan.rate) * nsteps * update->dt;
  if (plan.rate == 0.0)
    result.strain = there(copy, plan.flow)->compute_vector(PATH) - plan.flow->compute_vector(PATH);
  const double mine = copy.lmp->timer->get_cpu(Timer::TOTAL) / nsteps;
  MPI_Allreduce(&mine, &result.seconds, 1, MPI_DOUBLE, MPI_MAX, world);
  for (int b = 0; b < COUNTED; b++) {
    const bigint from = start + (BLOCKS - COUNTED + b) * block;
    const auto sxy = sampler.mean(from, from + block, sampler.sxy);
    const auto syy = sampler.mean(from, from + block, sampler.syy);
    const auto power = sampler.mean(from, from + block, sampler.power);
    for (const double part : sxy) result.stress[b] += part;
    for (const double part : syy) result.pressure[b] -= part;
    add(sxy, result.parts);
    add(power, result.power);
  }
  return result;
}

/* ----------------------------------------------------------------------
   suspension_scene measure N keyword value ...
------------------------------------------------------------------------- */

void SuspensionScene::measure(int narg, char **arg)
{
  if (narg < 2) utils::missing_cmd_args(FLERR, "suspension_scene measure", error);
  const int nsteps = utils::inumeric(FLERR, arg[1], false, lmp);
  if (nsteps < BLOCKS || nsteps % BLOCKS)
    error->all(FLERR, 1, "Suspension_scene measure takes a multiple of {} steps, but not {}",
               BLOCKS, arg[1]);
  double limit = 0.02;
  for (int iarg = 2; iarg < narg; iarg += 2) {
    if (strcmp(arg[iarg], "change") != 0)
      error->all(FLERR, iarg,
                 "Unknown suspension_scene measure keyword: {}; the only one is change", arg[iarg]);
    if (iarg + 1 >= narg) utils::missing_cmd_args(FLERR, "suspension_scene measure change", error);
    limit = utils::numeric(FLERR, arg[iarg + 1], false, lmp);
    if (!(limit > 0.0))
      error->all(FLERR, iarg + 1, "Suspension_scene measure change must be > 0, but is {}",
                 arg[iarg + 1]);
  }

  const PairLubcontact *style = SceneInstance::plan(lmp).pair;
  std::string text;
  try {
    text = leave_out_in_turn(style, nsteps, limit);
  } catch (LAMMPSAbortException &e) {
    error->one(FLERR, "Suspension_scene measure, in its copy: {}", utils::trim(e.what()));
  } catch (LAMMPSException &e) {
    error->all(FLERR, "Suspension_scene measure, in its copy: {}", utils::trim(e.what()));
  }
  if (comm->me == 0) utils::logmesg(lmp, text);
}

/* ----------------------------------------------------------------------
   one line of the table per effect, then the advice
------------------------------------------------------------------------- */

std::string SuspensionScene::leave_out_in_turn(const PairLubcontact *style, int nsteps,
                                               double limit) const
{
  const Measured all = run_copy(nsteps, {});
  const Mean stress = mean(all.stress), pressure = mean(all.pressure);
  std::string text =
      fmt::format("Suspension scene: {} steps of a copy, strain {:.4g}, means of the second half\n",
                  nsteps, all.strain);
  if (!all.history_kept)
    text += "  the pairs had no history yet: films and springs have built up in the first half\n";
  text +=
      fmt::format("  as it is: stress xy {:.6g} +- {:.2g}, pressure yy {:.6g} +- {:.2g}, "
                  "{:.4g} microseconds of CPU a step\n",
                  stress.value, stress.error, pressure.value, pressure.error, 1e6 * all.seconds);
  text += fmt::format(COLUMNS, "left out", "of stress", "of power", "change of stress",
                      "of pressure", "time saved");

  std::vector<std::string> idle;
  std::string undecided;
  for (const Rows &row : ROWS) {
    if (!style->uses(row.effect)) continue;
    const Measured one = run_copy(nsteps, {row.effect});
    const Mean by[2] = {change(one.stress, all.stress), change(one.pressure, all.pressure)};
    text += fmt::format(COLUMNS, row.effect, percent(share(all.parts, row.stress)),
                        percent(share(all.power, row.power)), percent(by[0]), percent(by[1]),
                        percent(1.0 - one.seconds / all.seconds));
    auto below = [&by, limit](double sign) {
      return fabs(by[0].value) + sign * 2.0 * by[0].error < limit &&
          fabs(by[1].value) + sign * 2.0 * by[1].error < limit;
    };
    if (below(1.0))
      idle.emplace_back(row.effect);
    else if (below(-1.0))
      undecided += std::string(" ") + row.effect;
  }
  if (idle.size() > 1) {
    const Measured one = run_copy(nsteps, idle);
    text += fmt::format(COLUMNS, "all of these", "-", "-", percent(change(one.stress, all.stress)),
                        percent(change(one.pressure, all.pressure)),
                        percent(1.0 - one.seconds / all.seconds));
  }

  text += fmt::format("Deck lines to use: changes below {} left out\n", percent(limit));
  text += "  pair_style " + style->settings_text(idle) + "\n";
  text += style->coeff_lines(idle);
  if (!undecided.empty())
    text += fmt::format("  # within its scatter undecided:{}; more steps or particles tell\n",
                        undecided);
  if (all.strain < 1.0)
    text += "  # a strain below 1 shows what an effect does at once, not the structure that "
            "forms without it\n";
  return text;
}
