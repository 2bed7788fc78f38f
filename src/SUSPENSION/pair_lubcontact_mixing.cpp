/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Coefficients of each pair of types of pair style lubcontact: mixed, checked, made ready for the loop.

#include "pair_lubcontact.h"

#include "atom.h"
#include "error.h"
#include "lubcontact_pair.h"

#include <cmath>

using namespace LAMMPS_NS;
using Lubcontact_NS::FRICTION_NAME;
using Lubcontact_NS::FrictionLaw;
using Lubcontact_NS::PairCoeffs;

static constexpr unsigned MODE_BIT[4] = {Lubcontact_NS::SQUEEZE, Lubcontact_NS::SHEAR,
                                         Lubcontact_NS::ROLL, Lubcontact_NS::TWIST};

/* ----------------------------------------------------------------------
   effects that some pair of types uses
------------------------------------------------------------------------- */

unsigned PairLubcontact::choose_mask() const
{
  unsigned bits = 0;
  for (int m = 0; m < 4; m++)
    if (mode[m]) bits |= MODE_BIT[m];
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      if (!setflag[i][j]) continue;
      if (law[i][j] != static_cast<int>(FrictionLaw::NONE)) bits |= Lubcontact_NS::FRICTION;
      if (law[i][j] > static_cast<int>(FrictionLaw::COULOMB)) bits |= Lubcontact_NS::THRESHOLD;
      if (adhesion[i][j] > 0.0) bits |= Lubcontact_NS::ADHESION;
      if (screening[i][j] > 0.0) bits |= Lubcontact_NS::REPULSION;
    }
  return bits;
}

/* ----------------------------------------------------------------------
   mixing: springs in series, mean roughness, geometric friction, adhesion and repulsion
------------------------------------------------------------------------- */

void PairLubcontact::mix(int i, int j)
{
  auto series = [i, j](double **k) {
    return 2.0 * k[i][i] * k[j][j] / (k[i][i] + k[j][j]);
  };
  auto geometric = [i, j](double **k) {
    return sqrt(k[i][i] * k[j][j]);
  };
  g[i][j] = series(g);
  kt[i][j] = series(kt);
  asperity[i][j] = series(asperity);
  roughness[i][j] = 0.5 * (roughness[i][i] + roughness[j][j]);
  friction[i][j] = geometric(friction);
  critical[i][j] = geometric(critical);
  adhesion[i][j] = geometric(adhesion);
  repulsion[i][j] = geometric(repulsion);
  screening[i][j] = repulsion[i][j] > 0.0 ? 0.5 * (screening[i][i] + screening[j][j]) : 0.0;

  const bool none = !law[i][i] || !law[j][j];
  if (!none && law[i][i] != law[j][j])
    error->all(FLERR,
               "Types {} and {} of pair style lubcontact have different laws of friction, {} and "
               "{}: say with pair_coeff {} {} which one acts between them",
               i, j, FRICTION_NAME[law[i][i]], FRICTION_NAME[law[j][j]], i, j);
  law[i][j] = none ? 0 : law[i][i];
  did_mix = true;
}

/* ----------------------------------------------------------------------
   coefficients may be changed by fix adapt
------------------------------------------------------------------------- */

void PairLubcontact::check_pair(int i, int j) const
{
  if (!(g[i][j] > 0.0 && kt[i][j] > 0.0 && asperity[i][j] > 0.0 && roughness[i][j] >= 0.0 &&
        roughness[i][j] < hc && friction[i][j] >= 0.0 && critical[i][j] >= 0.0 &&
        repulsion[i][j] >= 0.0))
    error->all(FLERR,
               "Pair style lubcontact coefficients of types {} {} left their range: g {} kt {} "
               "asperity {} roughness {} friction {} critical load {} repulsion {}",
               i, j, g[i][j], kt[i][j], asperity[i][j], roughness[i][j], friction[i][j],
               critical[i][j], repulsion[i][j]);
  if (adhesion[i][j] > 0.0 && roughness[i][j] == 0.0)
    error->all(
        FLERR,
        "Pair style lubcontact adhesion of types {} {} is of asperities, but their roughness "
        "is now 0",
        i, j);
  if (!law[i][j] && friction[i][j] > 0.0)
    error->all(FLERR,
               "Pair style lubcontact has no friction between types {} {} that could be changed: "
               "give pair_coeff friction coulomb 0 first",
               i, j);
  if (law[i][j] <= static_cast<int>(FrictionLaw::COULOMB) && critical[i][j] > 0.0)
    error->all(FLERR,
               "Pair style lubcontact has no critical load between types {} {} that could be "
               "changed: give pair_coeff friction clm first",
               i, j);
  if (screening[i][j] == 0.0 && repulsion[i][j] > 0.0)
    error->all(FLERR,
               "Pair style lubcontact has no repulsion between types {} {} that could be changed: "
               "give pair_coeff repulsion 0 with a screening length first",
               i, j);
}

/* ----------------------------------------------------------------------
   largest gap that acts, over the effective radius: without films and repulsion that of a contact
------------------------------------------------------------------------- */

double PairLubcontact::find_reach(int i, int j) const
{
  const double eps = roughness[i][j], delta = adhesion[i][j];
  const double contact = eps + delta * (1.0 + asperity[i][j] / g[i][j]);    // bulk stretched
  const bool films = mode[SQUEEZE] || mode[SHEAR] || mode[ROLL] || mode[TWIST];
  if (!films && screening[i][j] == 0.0) return contact;
  if (delta > 0.0 && contact >= hc)
    error->all(FLERR,
               "Adhesive contacts of types {} {} break at {:.6g} effective radii, beyond the range "
               "{} of pair style lubcontact: reduce the adhesion or extend the range",
               i, j, contact, hc);
  return hc;
}

/* ---------------------------------------------------------------------- */

double PairLubcontact::init_one(int i, int j)
{
  if (setflag[i][j] == 0) mix(i, j);
  check_pair(i, j);

  const double eps = roughness[i][j], release = eps + adhesion[i][j];
  Lubcontact_NS::GapLaw gap{asperity[i][j] / g[i][j], eps, eps > 0.0 ? log(eps) : -HUGE_VAL,
                            euler != 0};
  gap.release = release;
  gap.ln_release = adhesion[i][j] > 0.0 ? log(release) : gap.ln_eps;
  PairCoeffs &c = coeffs[i][j];
  c = {{g[i][j], asperity[i][j], gap}, kt[i][j], friction[i][j]};
  c.threshold = Lubcontact_NS::make_threshold(static_cast<FrictionLaw>(law[i][j]), critical[i][j]);
  if (screening[i][j] > 0.0) c.normal.repulsion = {repulsion[i][j], 1.0 / screening[i][j]};
  reach[i][j] = find_reach(i, j);

  for (double **k : numbers()) k[j][i] = k[i][j];
  reach[j][i] = reach[i][j];
  law[j][i] = law[i][j];
  coeffs[j][i] = coeffs[i][j];

  const double ri = max_radius[i], rj = max_radius[j];
  const double gap_end = ri > 0.0 && rj > 0.0 ? reach[i][j] * effective_radius(ri, rj) : 0.0;
  longest = MAX(longest, ri + rj + gap_end);
  return ri + rj + gap_end;
}
