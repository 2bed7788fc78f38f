/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What the user types for pair style lubcontact: settings, coefficients, restart, data files.

#include "pair_lubcontact.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "input.h"
#include "lubcontact_pair.h"
#include "memory.h"
#include "modify.h"
#include "update.h"
#include "variable.h"

#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

static constexpr const char *MODE_NAME[4] = {"squeeze", "shear", "roll", "twist"};
static constexpr unsigned MODE_BIT[4] = {lubcontact::SQUEEZE, lubcontact::SHEAR, lubcontact::ROLL,
                                         lubcontact::TWIST};

/* ---------------------------------------------------------------------- */

void PairLubcontact::allocate()
{
  allocated = 1;
  const int n = atom->ntypes + 1;

  memory->create(setflag, n, n, "pair:setflag");
  memory->create(cutsq, n, n, "pair:cutsq");
  memory->create(g, n, n, "pair:g");
  memory->create(kt, n, n, "pair:kt");
  memory->create(asperity, n, n, "pair:asperity");
  memory->create(roughness, n, n, "pair:roughness");
  memory->create(friction, n, n, "pair:friction");
  memory->create(coulomb, n, n, "pair:coulomb");
  memory->create(coeffs, n, n, "pair:coeffs");
  memory->create(reach, n, n, "pair:reach");
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) setflag[i][j] = coulomb[i][j] = 0;
  max_radius = new double[n]();
}

/* ----------------------------------------------------------------------
   pair_style lubcontact eta range args keyword value ...
------------------------------------------------------------------------- */

void PairLubcontact::settings(int narg, char **arg)
{
  if (narg < 3) utils::missing_cmd_args(FLERR, "pair_style lubcontact", error);

  delete[] eta_name;
  eta_name = nullptr;
  if (utils::strmatch(arg[0], "^v_")) {
    eta_name = utils::strdup(arg[0] + 2);
  } else {
    eta = utils::numeric(FLERR, arg[0], false, lmp);
    if (!(eta >= 0.0))
      error->all(FLERR, 1, "Pair style lubcontact viscosity must be >= 0, but is {}", eta);
  }

  if (strcmp(arg[1], "cut") == 0)
    range_rule = static_cast<int>(lubcontact::Range::CUT);
  else if (strcmp(arg[1], "shifted") == 0)
    range_rule = static_cast<int>(lubcontact::Range::SHIFTED);
  else
    error->all(FLERR, 2, "Pair style lubcontact range must be cut or shifted, but is {}", arg[1]);
  hc = utils::numeric(FLERR, arg[2], false, lmp);
  if (!(hc > 0.0))
    error->all(FLERR, 3, "Pair style lubcontact range must be > 0 effective radii, but is {}", hc);

  euler = 0;
  radius_rule = static_cast<int>(lubcontact::Radius::HARMONIC);
  for (int &m : mode) m = 1;
  roll_coeff = 0.6;
  reported = false;
  bool roll_coeff_given = false, gap_given = false;

  for (int iarg = 3; iarg < narg; iarg += 2) {
    const std::string key = arg[iarg];
    if (iarg + 1 >= narg) utils::missing_cmd_args(FLERR, "pair_style lubcontact " + key, error);
    const std::string value = arg[iarg + 1];
    int which = -1;
    for (int m = 0; m < 4; m++)
      if (key == MODE_NAME[m]) which = m;

    if (which >= 0) {
      mode[which] = utils::logical(FLERR, value, false, lmp);
    } else if (key == "gap") {
      if (value != "exponential" && value != "euler")
        error->all(FLERR, iarg + 2,
                   "Pair style lubcontact gap must be exponential or euler, but is {}", value);
      euler = value == "euler";
      gap_given = true;
    } else if (key == "radius") {
      if (value != "mean" && value != "harmonic")
        error->all(FLERR, iarg + 2,
                   "Pair style lubcontact radius must be mean or harmonic, but is {}", value);
      radius_rule = static_cast<int>(value == "mean" ? lubcontact::Radius::MEAN
                                                     : lubcontact::Radius::HARMONIC);
    } else if (key == "rollcoeff") {
      roll_coeff = utils::numeric(FLERR, value, false, lmp);
      roll_coeff_given = true;
      if (!(roll_coeff >= 0.0))
        error->all(FLERR, iarg + 2, "Pair style lubcontact rollcoeff must be >= 0, but is {}",
                   roll_coeff);
    } else {
      error->all(FLERR, iarg + 1, "Unknown pair_style lubcontact keyword: {}", key);
    }
  }

  if (!mode[ROLL] && roll_coeff_given)
    error->all(FLERR,
               "Pair style lubcontact rollcoeff cannot act with roll no: remove one of them");
  if (!mode[SQUEEZE] && gap_given)
    error->all(FLERR, "Pair style lubcontact gap cannot act with squeeze no: remove one of them");
}

/* ----------------------------------------------------------------------
   pair_coeff I J g kt keyword value ...
------------------------------------------------------------------------- */

void PairLubcontact::coeff(int narg, char **arg)
{
  if (narg < 4) utils::missing_cmd_args(FLERR, "pair_coeff", error);
  if (!allocated) allocate();

  int ilo, ihi, jlo, jhi;
  utils::bounds(FLERR, arg[0], 1, atom->ntypes, ilo, ihi, error);
  utils::bounds(FLERR, arg[1], 1, atom->ntypes, jlo, jhi, error);

  auto number = [this, arg](int iarg, const char *name, bool zero_allowed) {
    const double value = utils::numeric(FLERR, arg[iarg], false, lmp);
    if (!(value > 0.0 || (zero_allowed && value == 0.0)) || !std::isfinite(value))
      error->all(FLERR, iarg, "Pair style lubcontact {} must be {} 0, but is {}", name,
                 zero_allowed ? ">=" : ">", arg[iarg]);
    return value;
  };

  const double g_one = number(2, "stiffness g", false);
  const double kt_one = number(3, "stiffness kt", false);
  double asperity_one = g_one, roughness_one = 0.0, friction_one = 0.0;
  int coulomb_one = 0;

  for (int iarg = 4; iarg < narg; iarg += 2) {
    const std::string key = arg[iarg];
    if (iarg + 1 >= narg) utils::missing_cmd_args(FLERR, "pair_coeff lubcontact " + key, error);
    if (key == "roughness") {
      roughness_one = number(iarg + 1, "roughness", true);
      if (roughness_one >= hc)
        error->all(FLERR, iarg + 1,
                   "Pair style lubcontact roughness must be below the range {}, but is {}", hc,
                   roughness_one);
    } else if (key == "asperity") {
      asperity_one = number(iarg + 1, "asperity stiffness", false);
    } else if (key == "friction") {
      const std::string law = arg[iarg + 1];
      if (law == "none") {
        coulomb_one = 0;
      } else if (law == "coulomb") {
        if (iarg + 2 >= narg)
          utils::missing_cmd_args(FLERR, "pair_coeff lubcontact friction coulomb", error);
        friction_one = number(iarg + 2, "coefficient of friction", true);
        coulomb_one = 1;
        iarg++;
      } else {
        error->all(FLERR, iarg + 1,
                   "Pair style lubcontact friction must be none or coulomb mu, but is {}", law);
      }
    } else {
      error->all(FLERR, iarg, "Unknown pair_coeff lubcontact keyword: {}", key);
    }
  }

  int count = 0;
  for (int i = ilo; i <= ihi; i++)
    for (int j = MAX(jlo, i); j <= jhi; j++) {
      g[i][j] = g_one;
      kt[i][j] = kt_one;
      asperity[i][j] = asperity_one;
      roughness[i][j] = roughness_one;
      friction[i][j] = friction_one;
      coulomb[i][j] = coulomb_one;
      setflag[i][j] = 1;
      count++;
    }
  if (count == 0)
    error->all(FLERR, "No pair of atom types I <= J in pair_coeff {} {}", arg[0], arg[1]);
  reported = false;
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::check_variable()
{
  if (!eta_name) return;
  eta_var = input->variable->find(eta_name);
  if (eta_var < 0)
    error->all(FLERR, "Variable {} for the viscosity of pair style lubcontact does not exist",
               eta_name);
  if (!input->variable->equalstyle(eta_var))
    error->all(FLERR, "Variable {} for the viscosity of pair style lubcontact is not equal-style",
               eta_name);
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::update_viscosity()
{
  if (eta_name) {
    modify->clearstep_compute();
    eta = input->variable->compute_equal(eta_var);
    modify->addstep_compute(update->ntimestep + 1);
    if (!(eta >= 0.0))
      error->all(FLERR, "Viscosity of pair style lubcontact must be >= 0, but variable {} is {}",
                 eta_name, eta);
  }
  *film = lubcontact::make_film(eta, hc, static_cast<lubcontact::Range>(range_rule), roll_coeff);
}

/* ----------------------------------------------------------------------
   effects that some pair of types uses
------------------------------------------------------------------------- */

unsigned PairLubcontact::choose_mask() const
{
  unsigned bits = 0;
  for (int m = 0; m < 4; m++)
    if (mode[m]) bits |= MODE_BIT[m];
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++)
      if (setflag[i][j] && coulomb[i][j]) bits |= lubcontact::FRICTION;
  return bits;
}

/* ----------------------------------------------------------------------
   mixing: springs in series, mean roughness, geometric friction
------------------------------------------------------------------------- */

double PairLubcontact::init_one(int i, int j)
{
  if (setflag[i][j] == 0) {
    auto series = [i, j](double **k) {
      return 2.0 * k[i][i] * k[j][j] / (k[i][i] + k[j][j]);
    };
    g[i][j] = series(g);
    kt[i][j] = series(kt);
    asperity[i][j] = series(asperity);
    roughness[i][j] = 0.5 * (roughness[i][i] + roughness[j][j]);
    friction[i][j] = sqrt(friction[i][i] * friction[j][j]);
    coulomb[i][j] = coulomb[i][i] && coulomb[j][j];
    did_mix = true;
  }
  if (!(g[i][j] > 0.0 && kt[i][j] > 0.0 && asperity[i][j] > 0.0 && roughness[i][j] >= 0.0 &&
        roughness[i][j] < hc && friction[i][j] >= 0.0))
    error->all(FLERR,
               "Pair style lubcontact coefficients of types {} {} left their range: g {} kt {} "
               "asperity {} roughness {} friction {}",
               i, j, g[i][j], kt[i][j], asperity[i][j], roughness[i][j], friction[i][j]);
  if (!coulomb[i][j] && friction[i][j] > 0.0)
    error->all(FLERR,
               "Pair style lubcontact has no friction between types {} {} that could be changed: "
               "give pair_coeff friction coulomb 0 first",
               i, j);

  const double eps = roughness[i][j];
  const lubcontact::GapLaw gap{asperity[i][j] / g[i][j], eps, eps > 0.0 ? log(eps) : -HUGE_VAL,
                               euler != 0};
  coeffs[i][j] = {{g[i][j], asperity[i][j], gap}, kt[i][j], coulomb[i][j] ? friction[i][j] : 0.0};
  // without any film only touching asperities act
  reach[i][j] = mode[SQUEEZE] || mode[SHEAR] || mode[ROLL] || mode[TWIST] ? hc : eps;

  g[j][i] = g[i][j];
  kt[j][i] = kt[i][j];
  asperity[j][i] = asperity[i][j];
  roughness[j][i] = roughness[i][j];
  friction[j][i] = friction[i][j];
  coulomb[j][i] = coulomb[i][j];
  coeffs[j][i] = coeffs[i][j];
  reach[j][i] = reach[i][j];

  const double ri = max_radius[i], rj = max_radius[j];
  const double gap_end = ri > 0.0 && rj > 0.0 ? reach[i][j] * effective_radius(ri, rj) : 0.0;
  longest = MAX(longest, ri + rj + gap_end);
  return ri + rj + gap_end;
}

/* ---------------------------------------------------------------------- */

void *PairLubcontact::extract(const char *name, int &dim)
{
  dim = 0;
  if (strcmp(name, "eta") == 0) return eta_name ? nullptr : &eta;
  if (strcmp(name, "rollcoeff") == 0) return &roll_coeff;
  dim = 2;
  if (strcmp(name, "g") == 0) return g;
  if (strcmp(name, "kt") == 0) return kt;
  if (strcmp(name, "asperity") == 0) return asperity;
  if (strcmp(name, "roughness") == 0) return roughness;
  if (strcmp(name, "friction") == 0) return friction;
  return nullptr;
}
