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
#include "lubcontact_pair.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

const std::vector<std::string> PairLubcontact::EFFECTS = {"squeeze", "shear", "roll", "twist",
                                                          "friction"};

/* ---------------------------------------------------------------------- */

bool PairLubcontact::uses(const std::string &effect) const
{
  for (int m = 0; m < NUM_MODES; m++)
    if (effect == EFFECTS[m]) return mode[m] != 0;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++)
      if (setflag[i][j] && coulomb[i][j] && friction[i][j] > 0.0) return true;
  return false;
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::leave_out(const std::string &effect)
{
  for (int m = 0; m < NUM_MODES; m++)
    if (effect == EFFECTS[m]) mode[m] = 0;
  if (effect != "friction") return;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      coulomb[i][j] = 0;
      friction[i][j] = 0.0;
    }
}

/* ---------------------------------------------------------------------- */

std::string PairLubcontact::settings_text(const std::vector<std::string> &without) const
{
  std::string text = fmt::format(
      "lubcontact {} {} {}", eta_name ? std::string("v_") + eta_name : fmt::format("{}", eta),
      range_rule == static_cast<int>(lubcontact::Range::SHIFTED) ? "shifted" : "cut", hc);
  if (radius_rule == static_cast<int>(lubcontact::Radius::MEAN)) text += " radius mean";
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

double PairLubcontact::viscosity() const
{
  return eta_name && eta == 0.0 ? NAN : eta;
}
