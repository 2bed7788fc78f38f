/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "fix_deform_rheometer.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "list_keeper.h"
#include "memory.h"
#include "modify.h"
#include "rheometer_flow.h"
#include "rheometer_mean.h"
#include "rheometer_servo.h"
#include "suspension_host.h"
#include "suspension_input.h"
#include "update.h"

#include <cmath>
#include <cstring>
#include <vector>

using namespace LAMMPS_NS;

static constexpr int EVERY = 8;    // steps: far below the lag of the servos

/* ----------------------------------------------------------------------
   what the parent is told: the directions that may move, so that no other fix moves them, too
------------------------------------------------------------------------- */

static std::vector<char *> parent_args(LAMMPS *lmp, int narg, char **arg)
{
  Suspension_NS::require_words(FLERR, lmp->error, "fix deform/rheometer", narg + 1,
                               "fix ID group deform/rheometer rate|iv|stress|oscillate ...");
  std::string flow = "shear";
  for (int iarg = 3; iarg + 1 < narg; iarg++)
    if (strcmp(arg[iarg], "flow") == 0) flow = arg[iarg + 1];
  if (flow == "shear" && !lmp->domain->triclinic)
    lmp->error->all(FLERR,
                    "Fix deform/rheometer shears a triclinic cell; add: change_box all triclinic");

  std::vector<const char *> words = {"1"};
  auto moves = [&words](const char *direction) {
    for (const char *word : {direction, "vel", "0"}) words.push_back(word);
  };
  if (flow != "shear") moves("x");
  moves("y");
  if (flow != "shear" && lmp->domain->dimension == 3) moves("z");
  if (flow == "shear") moves("xy");
  for (const char *word : {"remap", "v", "units", "box", "flip", "yes"}) words.push_back(word);

  std::vector<char *> args(arg, arg + 3);
  for (const char *word : words) args.push_back(const_cast<char *>(word));
  return args;
}

/* ----------------------------------------------------------------------
   fix ID group deform/rheometer keyword value ...
------------------------------------------------------------------------- */

FixDeformRheometer::FixDeformRheometer(LAMMPS *lmp, int narg, char **arg) :
    FixDeformRheometer(lmp, narg, arg, parent_args(lmp, narg, arg))
{
}

FixDeformRheometer::FixDeformRheometer(LAMMPS *lmp, int narg, char **arg,
                                       std::vector<char *> args) :
    FixDeform(lmp, static_cast<int>(args.size()), args.data()),
    flow(Rheometer_NS::SHEAR), drive(NONE_YET), confinement(OPEN), viscosity_given(false),
    pair_viscosity(nullptr), gain(1.0), strain(0.0), path(0.0), time(0.0), rate(0.0), dilation(0.0),
    gradient(new Rheometer_NS::Gradient()), cell_rate(new Rheometer_NS::Cell()), moved(0.0),
    watch_pressure(new Rheometer_NS::Watch()), watch_stress(new Rheometer_NS::Watch()),
    watch_rate(new Rheometer_NS::Watch()), averages(new Rheometer_NS::StrainMeans()),
    measured_pressure(0.0), measured_stress(0.0), state(Rheometer_NS::IDLE), fresh(true),
    stepped(false), warned(false), warned_every(false), particles(),
    material(new Rheometer_NS::Material()), pair_virial(nullptr), keeper(new ListKeeper(lmp, this)),
    listed(new Rheometer_NS::Cell()), held(nullptr), from_restart(false)
{
  Suspension_NS::require_spheres(lmp, "Fix deform/rheometer");
  vector_flag = 1;
  size_vector = Output::MEANS + Rheometer_NS::MEAN_OUTPUTS;
  extvector = 0;
  global_freq = 1;
  nevery = EVERY;
  dynamic_group_allow = 0;
  restart_peratom = 1;
  maxexchange = 3;
  force_reneighbor = 1;    // the parent asks for lists only where a cell tilts
  next_reneighbor = -1;

  double start = 0.0;
  for (int iarg = 3; iarg < narg;) {
    if (strcmp(arg[iarg], "flow") == 0) {
      need_values("flow shear|planar|uniaxial", iarg, narg);
      flow = parse_flow(iarg + 1, arg[iarg + 1]);
      iarg += 2;
    } else if (strcmp(arg[iarg], "start") == 0) {
      need_values("start g", iarg, narg);
      start = utils::numeric(FLERR, arg[iarg + 1], false, lmp);
      iarg += 2;
    } else if (strcmp(arg[iarg], "every") == 0) {
      need_values("every n", iarg, narg);
      nevery = utils::inumeric(FLERR, arg[iarg + 1], false, lmp);
      if (nevery < 1)
        error->all(FLERR, iarg + 1, "Fix {} every must be > 0, but is {}", style, arg[iarg + 1]);
      iarg += 2;
    } else {
      iarg = parse(iarg, narg, arg, true);
    }
  }
  if (drive == NONE_YET)
    error->all(FLERR, "Fix {} needs one of: rate, iv, stress, oscillate", style);
  if (confinement == OPEN) error->all(FLERR, "Fix {} needs one of: pressure, volume", style);
  for (int iarg = 3; iarg < narg; iarg++)
    if (confinement == VOLUME && strcmp(arg[iarg], "gain") == 0)
      error->all(FLERR, iarg, "Fix {} gain cannot act at constant volume", style);
  check_directions();

  // the particles are taken to follow this flow already
  rate = start;
  *gradient = Rheometer_NS::gradient(static_cast<Rheometer_NS::Flow>(flow), domain->dimension,
                                     start, 0.0, update->dt);
  virial_id = std::string(id) + "_virial";
  pair_virial = modify->add_compute(virial_id + " all pressure NULL pair");
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
  FixDeformRheometer::grow_arrays(atom->nmax);
}

/* ---------------------------------------------------------------------- */

FixDeformRheometer::~FixDeformRheometer()
{
  if (modify->get_compute_by_id(virial_id)) modify->delete_compute(virial_id);
  if (modify->get_fix_by_id(id)) {
    atom->delete_callback(id, Atom::GROW);
    atom->delete_callback(id, Atom::RESTART);
  }
  memory->destroy(held);
}

/* ---------------------------------------------------------------------- */

int FixDeformRheometer::parse_flow(int iarg, const char *word) const
{
  if (strcmp(word, "shear") == 0) return Rheometer_NS::SHEAR;
  if (strcmp(word, "planar") == 0) return Rheometer_NS::PLANAR;
  if (strcmp(word, "uniaxial") == 0) {
    if (domain->dimension == 2)
      error->all(FLERR, iarg, "Fix {}: no uniaxial flow in 2d; use planar", style);
    return Rheometer_NS::UNIAXIAL;
  }
  error->all(FLERR, iarg, "Fix {} flow must be shear, planar or uniaxial, but is {}", style, word);
  return 0;
}

/* ---------------------------------------------------------------------- */

void FixDeformRheometer::check_directions() const
{
  const int *periodic = domain->periodicity;
  const bool z = flow == Rheometer_NS::SHEAR || domain->dimension == 2 || periodic[2];
  if (!periodic[0] || !periodic[1] || !z)
    error->all(FLERR,
               "Fix {} needs a cell that is periodic in the directions of the flow; for walls see "
               "fix rheometer/plates",
               style);
}

/* ----------------------------------------------------------------------
   one keyword with its values, of fix or fix_modify; returns the next position
------------------------------------------------------------------------- */

int FixDeformRheometer::parse(int iarg, int narg, char **arg, bool pointer)
{
  const std::string key = arg[iarg];
  if (key == "rate" || key == "iv" || key == "stress" || key == "oscillate")
    return parse_drive(iarg, narg, arg, pointer);

  const int where = pointer ? iarg : Error::NOPOINTER;
  auto set_confinement = [&](Confinement to) {
    if (pointer && confinement != OPEN)
      error->all(FLERR, where, "Fix {} takes one of pressure, volume; {} is one too many", style,
                 key);
    confinement = to;
  };
  auto positive = [&](const Suspension_NS::InputNumber &target, bool zero) {
    if (target.is_number() && !(zero ? target.value >= 0.0 : target.value > 0.0))
      error->all(FLERR, pointer ? iarg + 1 : where, "Fix {} {} must be {} 0, but is {}", style, key,
                 zero ? ">=" : ">", arg[iarg + 1]);
  };

  if (key == "volume") {
    set_confinement(VOLUME);
    return iarg + 1;
  }
  if (key == "lists") {
    need_values("lists affine|lammps", iarg, narg);
    keeper->on = parse_lists(where, arg[iarg + 1]);
    return iarg + 2;
  }
  if (key != "pressure" && key != "viscosity" && key != "gain")
    error->all(FLERR, where,
               pointer
                   ? "Unknown fix {} keyword: {}"
                   : "Fix {} {} cannot be changed by fix_modify; what can is: rate, iv, stress, "
                     "oscillate, pressure, volume, viscosity, gain, lists",
               style, key);
  need_values(key == "pressure"   ? "pressure P"
                  : key == "gain" ? "gain K"
                                  : "viscosity eta",
              iarg, narg);
  if (key == "pressure") {
    set_confinement(PRESSURE);
    pressure = Suspension_NS::InputNumber(lmp, arg[iarg + 1]);
    positive(pressure, false);
  } else if (key == "viscosity") {
    viscosity = Suspension_NS::InputNumber(lmp, arg[iarg + 1]);
    viscosity_given = true;
    positive(viscosity, true);
  } else {
    Suspension_NS::InputNumber number;
    number.value = gain = utils::numeric(FLERR, arg[iarg + 1], false, lmp);
    positive(number, false);
  }
  return iarg + 2;
}

/* ----------------------------------------------------------------------
   who decides when neighbor lists are made anew
------------------------------------------------------------------------- */

bool FixDeformRheometer::parse_lists(int where, const char *word) const
{
  if (strcmp(word, "affine") == 0) return true;
  if (strcmp(word, "lammps") != 0)
    error->all(FLERR, where, "Fix {} lists must be affine or lammps, but is {}", style, word);
  return false;
}

/* ---------------------------------------------------------------------- */

int FixDeformRheometer::parse_drive(int iarg, int narg, char **arg, bool pointer)
{
  const std::string key = arg[iarg];
  if (pointer && drive != NONE_YET)
    error->all(FLERR, iarg, "Fix {} takes one of rate, iv, stress, oscillate; {} is one too many",
               style, key);
  need_values(key == "oscillate"  ? "oscillate g0 g1 w"
                  : key == "rate" ? "rate g"
                  : key == "iv"   ? "iv v"
                                  : "stress s",
              iarg, narg);
  driven = Suspension_NS::InputNumber(lmp, arg[iarg + 1]);
  drive = key == "rate" ? RATE : key == "iv" ? IV : key == "stress" ? STRESS : OSCILLATE;
  amplitude = frequency = Suspension_NS::InputNumber();
  if (drive != OSCILLATE) return iarg + 2;
  time = 0.0;    // of the oscillation
  amplitude = Suspension_NS::InputNumber(lmp, arg[iarg + 2]);
  frequency = Suspension_NS::InputNumber(lmp, arg[iarg + 3]);
  return iarg + 4;
}

/* ---------------------------------------------------------------------- */

void FixDeformRheometer::need_values(const char *usage, int iarg, int narg) const
{
  Suspension_NS::require_words(FLERR, error, std::string("fix ") + style, narg - iarg, usage);
}

/* ---------------------------------------------------------------------- */

void FixDeformRheometer::check_variables() const
{
  static constexpr const char *NAME[] = {"", "rate", "iv", "stress", "oscillate"};
  driven.check(lmp, style, NAME[drive]);
  amplitude.check(lmp, style, NAME[OSCILLATE]);
  frequency.check(lmp, style, NAME[OSCILLATE]);
  pressure.check(lmp, style, "pressure");
  viscosity.check(lmp, style, "viscosity");
}

/* ---------------------------------------------------------------------- */

bool FixDeformRheometer::has_variables() const
{
  for (const Suspension_NS::InputNumber *target :
       {&driven, &amplitude, &frequency, &pressure, &viscosity})
    if (!target->is_number()) return true;
  return false;
}

/* ----------------------------------------------------------------------
   fix_modify ID rate ... : the flow goes on from where it is
------------------------------------------------------------------------- */

int FixDeformRheometer::modify_param(int narg, char **arg)
{
  const int next = parse(0, narg, arg, false);
  check_variables();    // a run with "pre no" does not
  *watch_pressure = Rheometer_NS::Watch();
  *watch_stress = Rheometer_NS::Watch();
  *watch_rate = Rheometer_NS::Watch();
  fresh = true;
  warned = false;
  return next;
}

/* ----------------------------------------------------------------------
   values of variables are those of the last run
------------------------------------------------------------------------- */

FixDeformRheometer::Imposed FixDeformRheometer::imposed() const
{
  const bool steady = flow == Rheometer_NS::SHEAR && drive != OSCILLATE;
  Imposed now = {NAN, NAN, NAN, steady, drive == RATE, confinement == PRESSURE};
  if (drive == IV && driven.value != 0.0)
    now.iv = driven.value;
  else if (drive == OSCILLATE)
    now.rate = fabs(driven.value) + fabs(amplitude.value);
  else if (drive == RATE && driven.value != 0.0)
    now.rate = driven.value;
  else if (rate != 0.0)
    now.rate = rate;
  const double p = confinement == PRESSURE ? pressure.value : measured_pressure;
  if (p > 0.0) now.pressure = p;
  return now;
}

std::string FixDeformRheometer::settings_text() const
{
  static constexpr const char *FLOW_NAME[] = {"shear", "planar", "uniaxial"};
  static constexpr const char *DRIVE_NAME[] = {"", "rate", "iv", "stress", "oscillate"};
  std::string text = fmt::format("flow {} every {} {} {}", FLOW_NAME[flow], nevery,
                                 DRIVE_NAME[drive], driven.value);
  if (drive == OSCILLATE) text += fmt::format(" {} {}", amplitude.value, frequency.value);
  if (confinement == PRESSURE)
    text += fmt::format(" pressure {} gain {}", pressure.value, gain);
  else
    text += " volume";
  if (viscosity_given) text += fmt::format(" viscosity {}", viscosity.value);
  if (!keeper->on) text += " lists lammps";
  return text;
}
