/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "pair_lubcontact.h"

#include "atom.h"
#include "fix_neigh_history_lubcontact.h"
#include "force.h"
#include "lubcontact_pair.h"
#include "neigh_list.h"

using namespace LAMMPS_NS;
using Lubcontact_NS::Film;
using Lubcontact_NS::Load;
using Lubcontact_NS::PairCoeffs;
using Lubcontact_NS::PairGeometry;
using Lubcontact_NS::Vec3;

// pair_load() of each combination of effects

using PresentLoad = Load (*)(const PairCoeffs &, const Film &, const PairGeometry &,
                             const double *);

template <unsigned... MASK>
static PresentLoad present_load(unsigned instance, std::integer_sequence<unsigned, MASK...>)
{
  PresentLoad load = nullptr;
  ((MASK == instance ? void(load = &Lubcontact_NS::pair_load<Lubcontact_NS::Effects<MASK>>)
                     : void()),
   ...);
  return load;
}

static PresentLoad present_load(unsigned instance)
{
  using Lubcontact_NS::ADHESION, Lubcontact_NS::REPULSION;
  switch (instance & (ADHESION | REPULSION)) {
    case 0:
      return present_load(instance, Lubcontact_NS::instances<0>());
    case ADHESION:
      return present_load(instance, Lubcontact_NS::instances<ADHESION>());
    case REPULSION:
      return present_load(instance, Lubcontact_NS::instances<REPULSION>());
    default:
      return present_load(instance, Lubcontact_NS::instances<ADHESION | REPULSION>());
  }
}

/* ----------------------------------------------------------------------
   calls visit(i, j, weight, geometry, load) for each pair in range with the forces of this step,
   and changes nothing; a pair that two processors or images see has weight 1/2 each time
------------------------------------------------------------------------- */

void PairLubcontact::visit_pairs(const Visitor &visit) const
{
  const PresentLoad load = present_load(instance);
  const double *const *x = atom->x;
  const double *radius = atom->radius;
  auto vector = [](const double *a) {
    return Vec3{a[0], a[1], a[2]};
  };

  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    const int *jlist = list->firstneigh[i];
    const char *faces_i = faces_of(i);
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      const int j = jlist[jj] & NEIGHMASK;
      if (force->special_lj[sbmask(jlist[jj])] == 0.0) continue;
      // the loop of the forces has marked the pairs in range
      if (size_history && !fix_history->firstflag[i][jj]) continue;

      const double a = effective_radius(radius[i], radius[j]);
      const PairGeometry geometry =
          Lubcontact_NS::pair_geometry(vector(x[i]), vector(x[j]), radius[i], radius[j], a);
      const int itype = atom->type[i], jtype = atom->type[j];
      const bool screened = faces_i && !faces_i[jj];
      const double end = screened ? touching_gap(coeffs[itype][jtype]) : reach[itype][jtype];
      if (!size_history && geometry.un >= end * a) continue;

      const double *history = size_history ? fix_history->firstvalue[i] + size_history * jj
                                           : nullptr;
      const double weight = force->newton_pair || j < atom->nlocal ? 1.0 : 0.5;
      visit(i, j, weight, geometry, load(coeffs[itype][jtype], *film, geometry, history));
    }
  }
}
