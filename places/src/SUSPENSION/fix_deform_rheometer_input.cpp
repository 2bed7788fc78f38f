/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Arguments of fix deform/rheometer, and what it tells others.

#include "fix_deform_rheometer.h"

#include "atom.h"
#include "deform_judge.h"
#include "deform_stress.h"
#include "deform_targets.h"
#include "domain.h"
#include "error.h"
#include "list_keeper.h"
#include "memory.h"
#include "modify.h"
#include "rheometer_flow.h"
#include "rheometer_mean.h"
#include "suspension_host.h"
#include "suspension_input.h"
#include "update.h"

#include <cmath>
#include <cstring>
#include <vector>

using namespace LAMMPS_NS;

static constexpr int EVERY = 8;    // steps: far below the lag of the servos

static void need_values(LAMMPS *lmp, const std::string &style, const char *usage, int given)
{
  Suspension_NS::require_words(FLERR, lmp->error, "fix " + style, given, usage);
}

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
    flow(Rheometer_NS::SHEAR), pore(nullptr), targets(new DeformTargets(lmp, style)),
    judge(new DeformJudge(lmp, style)), keeper(new ListKeeper(lmp, this)),
    motion(new Rheometer_NS::CellMotion()), listed(new Rheometer_NS::Cell()), fresh(true),
    stepped(false), held(nullptr), from_restart(false)
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
      need_values(lmp, style, "flow shear|planar|uniaxial", narg - iarg);
      flow = parse_flow(iarg + 1, arg[iarg + 1]);
      iarg += 2;
    } else if (strcmp(arg[iarg], "start") == 0) {
      need_values(lmp, style, "start g", narg - iarg);
      start = utils::numeric(FLERR, arg[iarg + 1], false, lmp);
      iarg += 2;
    } else if (strcmp(arg[iarg], "every") == 0) {
      need_values(lmp, style, "every n", narg - iarg);
      nevery = utils::inumeric(FLERR, arg[iarg + 1], false, lmp);
      if (nevery < 1)
        error->all(FLERR, iarg + 1, "Fix {} every must be > 0, but is {}", style, arg[iarg + 1]);
      iarg += 2;
    } else {
      iarg = parse(iarg, narg, arg, true);
    }
  }
  targets->check_complete(narg, arg);
  check_directions();

  // the particles are taken to follow this flow already
  motion->rate = start;
  motion->gradient = Rheometer_NS::gradient(static_cast<Rheometer_NS::Flow>(flow),
                                            domain->dimension, start, 0.0, update->dt);
  stress = std::make_unique<DeformStress>(lmp, this);
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
  FixDeformRheometer::grow_arrays(atom->nmax);
}

/* ---------------------------------------------------------------------- */

FixDeformRheometer::~FixDeformRheometer()
{
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

int FixDeformRheometer::parse(int iarg, int narg, char **arg, bool underline)
{
  if (strcmp(arg[iarg], "lists") != 0) return targets->parse(iarg, narg, arg, underline);
  need_values(lmp, style, "lists affine|lammps", narg - iarg);
  const std::string word = arg[iarg + 1];
  if (word != "affine" && word != "lammps")
    error->all(FLERR, underline ? iarg : Error::NOPOINTER,
               "Fix {} lists must be affine or lammps, but is {}", style, word);
  keeper->allow(word == "affine");
  return iarg + 2;
}

/* ----------------------------------------------------------------------
   fix_modify ID rate ... : the flow goes on from where it is
------------------------------------------------------------------------- */

int FixDeformRheometer::modify_param(int narg, char **arg)
{
  const int next = parse(0, narg, arg, false);
  if (strcmp(arg[0], "oscillate") == 0) motion->time = 0.0;
  targets->check_variables();    // a run with "pre no" does not
  judge->start_anew();
  fresh = true;
  return next;
}

/* ----------------------------------------------------------------------
   values of variables are those of the last run
------------------------------------------------------------------------- */

FixDeformRheometer::Imposed FixDeformRheometer::imposed() const
{
  const auto drive = targets->drive();
  const double driven = targets->driven();
  const bool steady = flow == Rheometer_NS::SHEAR && drive != DeformTargets::OSCILLATE;
  Imposed now = {NAN, NAN, NAN, steady, drive == DeformTargets::RATE, targets->holds_pressure()};
  if (drive == DeformTargets::IV && driven != 0.0)
    now.iv = driven;
  else if (drive == DeformTargets::OSCILLATE)
    now.rate = fabs(driven) + fabs(targets->amplitude());
  else if (drive == DeformTargets::RATE && driven != 0.0)
    now.rate = driven;
  else if (motion->rate != 0.0)
    now.rate = motion->rate;
  const double p = targets->holds_pressure() ? targets->pressure() : stress->pressure();
  if (p > 0.0) now.pressure = p;
  return now;
}

std::string FixDeformRheometer::settings_text() const
{
  static constexpr const char *FLOW_NAME[] = {"shear", "planar", "uniaxial"};
  return fmt::format("flow {} every {} {}{}", FLOW_NAME[flow], nevery, targets->settings_text(),
                     keeper->allowed() ? "" : " lists lammps");
}

/* ---------------------------------------------------------------------- */

const Rheometer_NS::StrainMeans &FixDeformRheometer::means() const
{
  return stress->means();
}

double FixDeformRheometer::strain_path() const
{
  return motion->path;
}

/* ----------------------------------------------------------------------
   for fix pore/pressure: d ln V/dt until the next adjustment
------------------------------------------------------------------------- */

void *FixDeformRheometer::extract(const char *name, int &dimension)
{
  dimension = 0;
  return strcmp(name, "dilation") == 0 ? &motion->dilation : nullptr;
}

/* ---------------------------------------------------------------------- */

double FixDeformRheometer::compute_vector(int n)
{
  switch (n) {
    case Output::STRAIN:
      return motion->strain;
    case Output::RATE:
      return motion->rate;
    case Output::PHI:
      return stress->phi();
    case Output::PRESSURE:
      return stress->pressure();
    case Output::STRESS:
      return stress->stress();
    case Output::PRESSURE_TARGET:
      return targets->holds_pressure() ? targets->pressure() : 0.0;
    case Output::TARGET:
      return targets->driven();
    case Output::DILATION:
      return motion->dilation;
    case Output::PATH:
      return motion->path;
    case Output::STATE:
      return judge->state();
    default:
      return Rheometer_NS::mean_output(stress->means(), n - Output::MEANS, stress->pressure(),
                                       stress->stress());
  }
}
