/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What command suspension_scene asks of pair style lubcontact.

#include "pair_lubcontact.h"

#include "atom.h"
#include "lubcontact_friction.h"
#include "lubcontact_pair.h"
#include "scene_history.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

const std::vector<std::string> PairLubcontact::EFFECTS = {
    "squeeze", "shear", "roll", "twist", "friction", "critical load", "adhesion", "repulsion"};

static constexpr int COULOMB = static_cast<int>(Lubcontact_NS::FrictionLaw::COULOMB);

/* ---------------------------------------------------------------------- */

bool PairLubcontact::uses(const std::string &effect) const
{
  for (int m = 0; m < NUM_MODES; m++)
    if (effect == EFFECTS[m]) return mode[m] != 0;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      if (!setflag[i][j]) continue;
      if (effect == "friction" && law[i][j] && friction[i][j] > 0.0) return true;
      if (law[i][j] > COULOMB && critical[i][j] > 0.0 &&
          effect == Lubcontact_NS::FRICTION_NAME[law[i][j]])
        return true;
      if (effect == "critical load" && law[i][j] > COULOMB && critical[i][j] > 0.0) return true;
      if (effect == "adhesion" && adhesion[i][j] > 0.0) return true;
      if (effect == "repulsion" && repulsion[i][j] > 0.0) return true;
    }
  return false;
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::leave_out(const std::string &effect)
{
  for (int m = 0; m < NUM_MODES; m++)
    if (effect == EFFECTS[m]) mode[m] = 0;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      if (effect == "friction") law[i][j] = 0;
      if (effect == "critical load") law[i][j] = MIN(law[i][j], COULOMB);
      if (!law[i][j]) friction[i][j] = 0.0;
      if (law[i][j] <= COULOMB) critical[i][j] = 0.0;
      if (effect == "adhesion") adhesion[i][j] = 0.0;
      if (effect == "repulsion") repulsion[i][j] = screening[i][j] = 0.0;
    }
}

/* ----------------------------------------------------------------------
   pull_off is that of the effective radius a; a critical load without a law is of the law step
------------------------------------------------------------------------- */

void PairLubcontact::switch_on(const Laws &laws, double a)
{
  static constexpr int STEP = static_cast<int>(Lubcontact_NS::FrictionLaw::STEP);
  auto given = [](double x) {
    return !std::isnan(x);
  };
  reported = true;    // not what the user asked for
  for (int &m : mode) m = 1;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      if (!setflag[i][j]) continue;
      if (given(laws.friction)) {
        if (!law[i][j]) law[i][j] = COULOMB;
        friction[i][j] = laws.friction;
      }
      if (given(laws.critical) && law[i][j]) {
        if (law[i][j] == COULOMB) law[i][j] = STEP;
        critical[i][j] = laws.critical;
      }
      if (given(laws.pull_off)) adhesion[i][j] = laws.pull_off / (asperity[i][j] * a);
      if (given(laws.repulsion)) {
        repulsion[i][j] = laws.repulsion;
        screening[i][j] = laws.screening;
      }
    }
}

/* ----------------------------------------------------------------------
   history of a pair at distance r, from one with the effects `from`
------------------------------------------------------------------------- */

void PairLubcontact::adopt_history(unsigned from, const double *old, int itype, int jtype,
                                   double ri, double rj, double r, double *next) const
{
  Scene_NS::adopt_history(from, instance, coeffs[itype][jtype].normal, effective_radius(ri, rj),
                          r - ri - rj, old, next);
}

/* ----------------------------------------------------------------------
   forces of the surfaces of types i and j at the effective radius a; 0: none
------------------------------------------------------------------------- */

PairLubcontact::SurfaceForces PairLubcontact::surface_forces(int i, int j, double a) const
{
  return {critical[i][j], asperity[i][j] * adhesion[i][j] * a, repulsion[i][j]};
}

/* ---------------------------------------------------------------------- */

std::string PairLubcontact::settings_text(const std::vector<std::string> &without) const
{
  std::string text = fmt::format("lubcontact {} {} {}",
                                 eta_name ? std::string("v_") + eta_name : fmt::format("{}", eta),
                                 Lubcontact_NS::RANGE_NAME[range_rule], hc);
  if (radius_rule == static_cast<int>(Lubcontact_NS::Radius::MEAN)) text += " radius mean";
  bool on[NUM_MODES];
  for (int m = 0; m < NUM_MODES; m++) {
    const bool drop = std::find(without.begin(), without.end(), EFFECTS[m]) != without.end();
    on[m] = mode[m] && !drop;
    if (!on[m]) text += " " + EFFECTS[m] + " no";
  }
  if (on[SQUEEZE] && euler) text += " gap euler";
  if (on[ROLL] && roll_coeff != 0.6) text += fmt::format(" rollcoeff {}", roll_coeff);
  return text;
}

/* ---------------------------------------------------------------------- */

std::string PairLubcontact::coeff_lines(const std::vector<std::string> &without) const
{
  std::string lines;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      if (!setflag || !setflag[i][j]) continue;
      const std::string types = atom->ntypes > 1 ? fmt::format("{} {}", i, j) : "* *";
      lines += fmt::format("  pair_coeff {} {} {} {}\n", types, g[i][j], kt[i][j],
                           coeff_words(i, j, without));
    }
  return lines;
}

/* ---------------------------------------------------------------------- */

double PairLubcontact::viscosity() const
{
  return eta;
}
