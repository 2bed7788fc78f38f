/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "compute_microstructure.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "force.h"
#include "group.h"
#include "lubcontact_contacts.h"
#include "lubcontact_fabric.h"
#include "lubcontact_histogram.h"
#include "lubcontact_orientation.h"
#include "pair_lubcontact.h"
#include "suspension_host.h"

#include <algorithm>

using namespace LAMMPS_NS;
using Lubcontact_NS::Fabric;
using Lubcontact_NS::Histogram;
using Lubcontact_NS::Load;
using Lubcontact_NS::NUM_CHANNELS;
using Lubcontact_NS::PairGeometry;
using Lubcontact_NS::PairSums;
using Lubcontact_NS::PairView;
using Lubcontact_NS::Vec3;

/* ----------------------------------------------------------------------
   the pairs of which both atoms are in the group, of every sub-style
------------------------------------------------------------------------- */

template <class Visit> void ComputeMicrostructure::visit(Visit look)
{
  const int *mask = atom->mask;
  for (const auto &pair : pairs)
    pair->visit_pairs([&](int i, int j, double w, const PairGeometry &g, const Load &load) {
      if ((mask[i] & groupbit) && (mask[j] & groupbit)) look(i, j, w, g, load);
    });
}

void ComputeMicrostructure::sum_over_ranks(std::vector<double> &sums) const
{
  MPI_Allreduce(MPI_IN_PLACE, sums.data(), static_cast<int>(sums.size()), MPI_DOUBLE, MPI_SUM,
                world);
}

/* ----------------------------------------------------------------------
   averages over all pairs
------------------------------------------------------------------------- */

void ComputeMicrostructure::compute_contacts()
{
  PairSums mine, all;
  per_atom.assign(static_cast<std::size_t>(atom->nlocal) + atom->nghost, 0.0);
  visit([&](int i, int j, double w, const PairGeometry &g, const Load &load) {
    const PairView p = Lubcontact_NS::view(g, load);
    mine.add(w, p);
    if (!p.contact) return;
    per_atom[i] += 1.0;
    if (force->newton_pair || j < atom->nlocal) per_atom[j] += 1.0;
  });
  MPI_Allreduce(mine.sum, all.sum, PairSums::NUM_SUMS, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(mine.extreme, all.extreme, PairSums::NUM_EXTREMES, MPI_DOUBLE, MPI_MAX, world);

  double rattlers, single;
  count_rattlers(rattlers, single);
  const auto particles = static_cast<double>(group->count(igroup));
  const Lubcontact_NS::Averages averages =
      Lubcontact_NS::averages(all, particles, rattlers, single);
  std::copy(averages.value, averages.value + averages.SIZE, vector);
}

/* ----------------------------------------------------------------------
   particles without or with a single contact, from the contacts of each
------------------------------------------------------------------------- */

void ComputeMicrostructure::count_rattlers(double &rattlers, double &single)
{
  if (force->newton_pair) comm->reverse_comm(this);
  std::vector<double> counts(2, 0.0);
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    if (per_atom[i] < 1.5) counts[0] += 1.0;
    if (per_atom[i] > 0.5 && per_atom[i] < 1.5) counts[1] += 1.0;
  }
  sum_over_ranks(counts);
  rattlers = counts[0];
  single = counts[1];
}

/* ---------------------------------------------------------------------- */

void ComputeMicrostructure::compute_fabric()
{
  enum { CONTACT, FRICTIONAL, FILM, NORMAL, FRICTION };
  Fabric fabric[FABRIC_ROWS];
  visit([&](int, int, double w, const PairGeometry &g, const Load &load) {
    const PairView p = Lubcontact_NS::view(g, load);
    if (!p.contact) {
      fabric[FILM].add(w, p.n);
      return;
    }
    fabric[CONTACT].add(w, p.n);
    if (p.frictional) fabric[FRICTIONAL].add(w, p.n);
    fabric[NORMAL].add(w * p.normal, p.n);
    const Vec3 friction =
        Lubcontact_NS::force_by_channel(g, load).of[Lubcontact_NS::CONTACT_TANGENTIAL];
    fabric[FRICTION].add(w, p.n, friction, w * p.normal);
  });
  std::vector<double> sums;
  for (const Fabric &f : fabric) sums.insert(sums.end(), std::begin(f.sum), std::end(f.sum));
  sum_over_ranks(sums);
  for (int row = 0; row < FABRIC_ROWS; row++) {
    Fabric total;
    std::copy_n(&sums[row * (Lubcontact_NS::FABRIC_SIZE + 1)], Lubcontact_NS::FABRIC_SIZE + 1,
                total.sum);
    for (int m = 0; m < Lubcontact_NS::FABRIC_SIZE; m++) array[row][m] = total.mean(m);
  }
}

/* ----------------------------------------------------------------------
   probability densities of normal and friction force, each over its mean
------------------------------------------------------------------------- */

void ComputeMicrostructure::compute_forces()
{
  struct Sample {
    double weight, normal, friction;    // friction < 0: none possible
  };
  std::vector<Sample> samples;
  std::vector<double> sums(4, 0.0);    // contacts, their force, those with friction, their force
  visit([&](int, int, double w, const PairGeometry &g, const Load &load) {
    const PairView p = Lubcontact_NS::view(g, load);
    if (!p.contact) return;
    samples.push_back({w, p.normal, p.frictional ? p.friction : -1.0});
    sums[0] += w;
    sums[1] += w * p.normal;
    if (!p.frictional) return;
    sums[2] += w;
    sums[3] += w * p.friction;
  });
  sum_over_ranks(sums);
  const double mean = Lubcontact_NS::ratio(sums[1], sums[0]);
  const double mean_friction = Lubcontact_NS::ratio(sums[3], sums[2]);

  Histogram normal(0.0, largest, bins), friction(0.0, largest, bins);
  for (const Sample &s : samples) {
    normal.add(s.weight, mean != 0.0 ? s.normal / mean : 0.0);
    if (s.friction >= 0.0)
      friction.add(s.weight, mean_friction > 0.0 ? s.friction / mean_friction : 0.0);
  }
  sum_over_ranks(normal.weight);
  sum_over_ranks(friction.weight);
  for (int bin = 0; bin < bins; bin++) {
    array[bin][0] = normal.center(bin);
    array[bin][1] = normal.density(bin);
    array[bin][2] = friction.density(bin);
  }
  const double numbers[FORCE_NUMBERS] = {sums[0],
                                         mean,
                                         Lubcontact_NS::ratio(normal.below(), sums[0]),
                                         Lubcontact_NS::ratio(normal.above(), sums[0]),
                                         sums[2],
                                         mean_friction,
                                         Lubcontact_NS::ratio(friction.above(), sums[2])};
  std::copy(std::begin(numbers), std::end(numbers), vector);
}

/* ----------------------------------------------------------------------
   densities over the direction of the pair
------------------------------------------------------------------------- */

void ComputeMicrostructure::compute_directions()
{
  const int coordinates = mode == SPHERE ? 2 : 1;
  const int columns = size_array_cols - coordinates;
  std::vector<double> sums(static_cast<std::size_t>(size_array_rows) * columns, 0.0);
  share_velocities();
  visit([&](int i, int j, double w, const PairGeometry &g, const Load &load) {
    const int row = directions->find(g.n);
    if (row >= 0) add_direction(w, i, j, g, load, &sums[static_cast<std::size_t>(row) * columns]);
  });
  sum_over_ranks(sums);

  // per particle and angle, so that the integral over all directions is the sum over all neighbors
  const double measure = mode == SPHERE ? directions->measure_sphere()
                                        : directions->measure_circle();
  const double volume = Suspension_NS::cell_volume(domain);
  const double per_particle =
      Lubcontact_NS::ratio(2.0 / measure, static_cast<double>(group->count(igroup)));
  const double stress = -force->nktv2p / (volume * measure);
  for (int row = 0; row < size_array_rows; row++) {
    if (mode == SPHERE) array[row][0] = directions->polar_angle(row);
    array[row][coordinates - 1] = directions->azimuth(row);
    const double *sum = &sums[static_cast<std::size_t>(row) * columns];
    for (int m = 0; m < columns; m++)
      array[row][coordinates + m] = sum[m] * (m < DIRECTION_SUMS ? per_particle : stress);
  }
}

void ComputeMicrostructure::add_direction(double w, int i, int j, const PairGeometry &g,
                                          const Load &load, double *sum) const
{
  const PairView p = Lubcontact_NS::view(g, load);
  const double *vi = &per_atom[3 * static_cast<std::size_t>(i)];
  const double *vj = &per_atom[3 * static_cast<std::size_t>(j)];
  const Vec3 v = {vi[0] - vj[0], vi[1] - vj[1], vi[2] - vj[2]};
  *sum++ += w;
  *sum++ += p.contact ? w : 0.0;
  *sum++ += p.frictional ? w : 0.0;
  *sum++ += w * p.u;
  *sum++ += w * p.normal;
  *sum++ += w * p.friction;
  *sum++ += w * dot(v, g.n);
  *sum++ += w * norm(Lubcontact_NS::tangential(v, g.n));

  auto component = [](const Vec3 &a, int m) {
    return m == 0 ? a.x : (m == 1 ? a.y : a.z);
  };
  const double lever = w * g.r * component(g.n, stress_a);
  for (const Vec3 &f : Lubcontact_NS::force_by_channel(g, load).of)
    *sum++ += lever * component(f, stress_b);
}
