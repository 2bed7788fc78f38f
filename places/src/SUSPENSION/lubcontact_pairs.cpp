/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "lubcontact_pairs.h"

#include "atom.h"
#include "error.h"
#include "force.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;
using Lubcontact_NS::Film;
using Lubcontact_NS::Load;
using Lubcontact_NS::PairCoeffs;
using Lubcontact_NS::PairGeometry;
using Lubcontact_NS::Range;
using Lubcontact_NS::RangeOf;
using Lubcontact_NS::Settings;
using Lubcontact_NS::Vec3;

/* ---------------------------------------------------------------------- */

LubcontactPairs::LubcontactPairs(LAMMPS *lmp) :
    Pointers(lmp), memory_of_pairs(lmp), neighbors(nullptr),
    tessellation(lmp, "Pair style lubcontact range voronoi")
{
}

/* ---------------------------------------------------------------------- */

void LubcontactPairs::request_ghosts(const Settings &settings, double largest_radius)
{
  tessellation.return_ghosts();
  if (settings.range == Range::VORONOI) tessellation.request_ghosts(largest_radius);
}

void LubcontactPairs::find_faces(const Settings &settings)
{
  common_faces.clear();
  if (settings.range == Range::VORONOI && settings.films)
    tessellation.mark_faces(neighbors, common_faces);
}

/* ---------------------------------------------------------------------- */

RangeOf LubcontactPairs::around(int i) const
{
  return ranges.around(atom->type[i], atom->radius[i], common_faces.of(i));
}

bool LubcontactPairs::acts_by_special(int entry) const
{
  return force->special_lj[entry >> SBBITS & 3] != 0.0;
}

double LubcontactPairs::acting(int i, int n) const
{
  const int entry = neighbors->firstneigh[i][n], j = entry & NEIGHMASK;
  if (!acts_by_special(entry)) return 0.0;
  const Vec3 d = Lubcontact_NS::get_vector(atom->x[i]) - Lubcontact_NS::get_vector(atom->x[j]);
  return around(i).acting(dot(d, d), atom->radius[j], atom->type[j], n);
}

double LubcontactPairs::share(int j) const
{
  return force->newton_pair || j < atom->nlocal ? 1.0 : 0.5;
}

/* ---------------------------------------------------------------------- */

void LubcontactPairs::each(const Entries &visit) const
{
  for (int ii = 0; ii < neighbors->inum; ii++) {
    const int i = neighbors->ilist[ii];
    for (int n = 0; n < neighbors->numneigh[i]; n++) {
      const double a = acting(i, n);
      if (a == 0.0) continue;
      const int j = neighbors->firstneigh[i][n] & NEIGHMASK;
      visit({i, j, n, share(j), a});
    }
  }
}

PairGeometry LubcontactPairs::geometry(int i, int j, double a) const
{
  return Lubcontact_NS::pair_geometry(Lubcontact_NS::get_vector(atom->x[i]),
                                      Lubcontact_NS::get_vector(atom->x[j]), atom->radius[i],
                                      atom->radius[j], a);
}

/* ---------------------------------------------------------------------- */

void LubcontactPairs::visit(unsigned instance, const Film &film, const Visitor &visit) const
{
  Load (*present)(const PairCoeffs &, const Film &, const PairGeometry &, const double *) = nullptr;
  auto take = [&present](auto effects) {
    present = &Lubcontact_NS::pair_load<decltype(effects)>;
  };
  if (film.residual)
    Lubcontact_NS::with_residual_effects(instance, take);
  else
    Lubcontact_NS::with_effects(instance, take);
  const int size = memory_of_pairs.size();
  each([&](const Acting &pair) {
    // the loop of the forces has marked the pairs that it knows
    if (size && !memory_of_pairs.known(pair.i)[pair.n]) return;
    const PairGeometry g = geometry(pair.i, pair.j, pair.a);
    const PairCoeffs &coeffs = ranges.of(atom->type[pair.i], atom->type[pair.j]);
    const double *values = size ? memory_of_pairs.values(pair.i) + size * pair.n : nullptr;
    visit(pair.i, pair.j, pair.weight, g, present(coeffs, film, g, values));
  });
}

/* ----------------------------------------------------------------------
   A compute with a list of its own may see a pair from the side of the other particle
------------------------------------------------------------------------- */

bool LubcontactPairs::find_entry(int i, int j, Entry &entry) const
{
  auto search = [this, &entry](int owner, int partner, bool swapped, bool by_id) {
    if (owner < 0 || owner >= atom->nlocal) return false;
    const int *jlist = neighbors->firstneigh[owner];
    for (int n = 0; n < neighbors->numneigh[owner]; n++) {
      const int k = jlist[n] & NEIGHMASK;
      if (by_id ? atom->tag[k] != atom->tag[partner] : k != partner) continue;
      entry = {owner, n, swapped};
      return true;
    }
    return false;
  };
  if (!neighbors || neighbors->inum == 0) return false;
  if (search(i, j, false, false) || search(j, i, true, false)) return true;
  if (atom->map_style != Atom::MAP_NONE && search(atom->map(atom->tag[j]), i, true, true))
    return true;
  if (force->newton_pair && !excluded(i, j))
    error->one(FLERR,
               "The history of the pair of atoms {} and {} is on another rank, where the compute "
               "cannot access it: use atom_modify map yes on one rank, or newton off",
               atom->tag[i], atom->tag[j]);
  return false;
}

/* ----------------------------------------------------------------------
   by neigh_modify exclude
------------------------------------------------------------------------- */

bool LubcontactPairs::excluded(int i, int j) const
{
  if (!neighbor->exclude) return false;
  const int *type = atom->type, *bits = atom->mask;
  for (int m = 0; m < neighbor->nex_type; m++) {
    const int a = neighbor->ex1_type[m], b = neighbor->ex2_type[m];
    if ((type[i] == a && type[j] == b) || (type[i] == b && type[j] == a)) return true;
  }
  for (int m = 0; m < neighbor->nex_group; m++) {
    const int a = neighbor->ex1_bit[m], b = neighbor->ex2_bit[m];
    if ((bits[i] & a && bits[j] & b) || (bits[i] & b && bits[j] & a)) return true;
  }
  return neighbor->nex_mol > 0;    // by molecule: perhaps
}

/* ---------------------------------------------------------------------- */

const double *LubcontactPairs::find_history(const Entry &entry, double *buffer) const
{
  if (!memory_of_pairs.size() || !memory_of_pairs.known(entry.owner)[entry.n]) return nullptr;
  const double *found = memory_of_pairs.values(entry.owner) + memory_of_pairs.size() * entry.n;
  if (!entry.swapped) return found;
  memory_of_pairs.exchange(found, buffer);
  return buffer;
}

/* ---------------------------------------------------------------------- */

void LubcontactPairs::follow_radii(bool has_gap)
{
  const double *radius = atom->radius;
  const std::size_t nall = atom->nlocal + atom->nghost;
  const bool followed = neighbor->ago != 0 && !update->setupflag && radii.size() == nall;
  if (followed && std::equal(radii.begin(), radii.end(), radius)) return;
  if (followed && has_gap)
    for (int ii = 0; ii < neighbors->inum; ii++) {
      const int i = neighbors->ilist[ii];
      for (int n = 0; n < neighbors->numneigh[i]; n++) {
        const int j = neighbors->firstneigh[i][n] & NEIGHMASK;
        if (!memory_of_pairs.known(i)[n]) continue;
        if (radius[i] == radii[i] && radius[j] == radii[j]) continue;
        Lubcontact_NS::rescale_gap(
            Lubcontact_NS::effective_radius(ranges.rule, radii[i], radii[j]) /
                Lubcontact_NS::effective_radius(ranges.rule, radius[i], radius[j]),
            memory_of_pairs.values(i) + memory_of_pairs.size() * n);
      }
    }
  radii.assign(radius, radius + nall);
}

/* ---------------------------------------------------------------------- */

double LubcontactPairs::memory_usage() const
{
  return common_faces.memory_usage() + static_cast<double>(radii.capacity() * sizeof(double)) +
      static_cast<double>(ranges.coeffs.size() * (sizeof(PairCoeffs) + sizeof(double)));
}
