/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What the statistics of pairs need to know of one pair, and averages over all pairs: coordination
// numbers, shares of frictional and sliding contacts, mean forces and gaps.
//   Z = 2 contacts/N, chi_f = frictional contacts/contacts: J. Dong, thesis, sec. 4
//   Z of the particles that can carry a force: C. Thornton, Geotechnique 50, 43 (2000)

#ifndef LUBCONTACT_CONTACTS_H
#define LUBCONTACT_CONTACTS_H

#include "lubcontact_pair.h"

#include <limits>

namespace LAMMPS_NS::Lubcontact_NS {

struct PairView {
  bool contact;       // the asperities touch
  bool frictional;    // and can hold a tangential force at this load
  bool sliding;       // and hold all they can
  double normal;      // repulsion of the asperities, force
  double friction;    // size of the friction force
  double cone;        // largest friction force
  double u;           // gap of the deformed surfaces, length
  double un;          // gap of the undeformed surfaces, length
  Vec3 n;             // unit vector from j to i
};

inline PairView view(const PairGeometry &g, const Load &load)
{
  const ShearSplit parts = split(load);
  const bool contact = parts.state != ContactState::NONE;
  const bool frictional = contact && load.cone > 0.0;
  const bool sliding = frictional && parts.state == ContactState::SLIP;
  const double friction = frictional ? parts.contact * norm(load.shear) : 0.0;
  return {contact,  frictional,
          sliding,  contact ? load.contact : 0.0,
          friction, frictional ? load.cone : 0.0,
          load.u,   g.un,
          g.n};
}

// Sums over pairs, which add up over processors, and extremes, of which the largest counts. A pair
// that is seen twice comes with weight 1/2.
struct PairSums {
  enum Sum {
    PAIRS,
    CONTACTS,
    FRICTIONAL,
    SLIDING,
    NORMAL,
    FRICTION_FORCE,
    MOBILIZED,
    FILM_GAP,
    NUM_SUMS
  };
  enum Extreme { LARGEST_NORMAL, CLOSEST, DEFLECTION, OVERLAP, NUM_EXTREMES };
  static constexpr double NOTHING = -std::numeric_limits<double>::max();

  double sum[NUM_SUMS] = {};
  double extreme[NUM_EXTREMES] = {NOTHING, NOTHING, NOTHING, NOTHING};    // CLOSEST: -u

  void add(double weight, const PairView &p)
  {
    sum[PAIRS] += weight;
    if (!p.contact) sum[FILM_GAP] += weight * p.u;
    if (p.contact) {
      sum[CONTACTS] += weight;
      sum[NORMAL] += weight * p.normal;
      extreme[LARGEST_NORMAL] = larger(extreme[LARGEST_NORMAL], p.normal);
    }
    if (p.frictional) {
      sum[FRICTIONAL] += weight;
      sum[FRICTION_FORCE] += weight * p.friction;
      sum[MOBILIZED] += weight * p.friction / p.cone;
      if (p.sliding) sum[SLIDING] += weight;
    }
    extreme[CLOSEST] = larger(extreme[CLOSEST], -p.u);
    extreme[DEFLECTION] = larger(extreme[DEFLECTION], p.u - p.un);
    extreme[OVERLAP] = larger(extreme[OVERLAP], -p.un);
  }
};

inline double ratio(double a, double b)
{
  return b > 0.0 ? a / b : 0.0;
}

// The columns of mode contacts, in this order.
struct Averages {
  enum {
    Z,
    Z_CARRYING,
    RATTLERS,
    Z_FRICTIONAL,
    CHI_F,
    SLIDING,
    FILMS,
    FILM_GAP,
    SMALLEST_GAP,
    NORMAL,
    LARGEST_NORMAL,
    FRICTION_FORCE,
    MOBILIZED,
    DEFLECTION,
    OVERLAP,
    SIZE
  };
  double value[SIZE] = {};
};

// Of N particles; `rattlers` of them have no or one contact, `single` have one.
inline Averages averages(const PairSums &s, double particles, double rattlers, double single)
{
  using S = PairSums;
  auto sum = [&s](S::Sum m) {
    return s.sum[m];
  };
  auto extreme = [&s](S::Extreme m) {
    return s.extreme[m] == S::NOTHING ? 0.0 : s.extreme[m];
  };
  Averages a;
  a.value[a.Z] = ratio(2.0 * sum(S::CONTACTS), particles);
  a.value[a.Z_CARRYING] = ratio(2.0 * sum(S::CONTACTS) - single, particles - rattlers);
  a.value[a.RATTLERS] = ratio(rattlers, particles);
  a.value[a.Z_FRICTIONAL] = ratio(2.0 * sum(S::FRICTIONAL), particles);
  a.value[a.CHI_F] = ratio(sum(S::FRICTIONAL), sum(S::CONTACTS));
  a.value[a.SLIDING] = ratio(sum(S::SLIDING), sum(S::FRICTIONAL));
  const double films = sum(S::PAIRS) - sum(S::CONTACTS);
  a.value[a.FILMS] = ratio(2.0 * films, particles);
  a.value[a.FILM_GAP] = ratio(sum(S::FILM_GAP), films);
  a.value[a.SMALLEST_GAP] = -extreme(S::CLOSEST);
  a.value[a.NORMAL] = ratio(sum(S::NORMAL), sum(S::CONTACTS));
  a.value[a.LARGEST_NORMAL] = extreme(S::LARGEST_NORMAL);
  a.value[a.FRICTION_FORCE] = ratio(sum(S::FRICTION_FORCE), sum(S::FRICTIONAL));
  a.value[a.MOBILIZED] = ratio(sum(S::MOBILIZED), sum(S::FRICTIONAL));
  a.value[a.DEFLECTION] = larger(0.0, extreme(S::DEFLECTION));
  a.value[a.OVERLAP] = larger(0.0, extreme(S::OVERLAP));
  return a;
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
