/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What there is to know of the pressure on the grid.

#include "fix_pore_pressure_field.h"

#include "atom.h"

#include <cmath>

using namespace LAMMPS_NS;
using Lubcontact_NS::Vec3;
using Pore_NS::Lanes;
using Pore_NS::Motion;

/* ---------------------------------------------------------------------- */

void PoreField::see(const Fluid &fluid)
{
  seen.outside = fluid;
  seen.given_mean = fluid.mean;
  seen.mean = mean_pressure(lattice, p) + fluid.mean;
  seen.largest = 0.0;
  for (const double value : p) seen.largest = MAX(seen.largest, fabs(value + fluid.mean));
  const bool plates = lattice.has_plates();
  seen.lower = plates ? layer_mean(lattice, p, 0) : seen.mean;
  seen.upper = plates ? layer_mean(lattice, p, lattice.ny) : seen.mean;
  seen.k_min = HUGE_VAL;
  seen.k_max = 0.0;
  for (const Pore_NS::Element &e : elements) {
    seen.k_min = MIN(seen.k_min, e.permeability);
    seen.k_max = MAX(seen.k_max, e.permeability);
  }
}

/* ---------------------------------------------------------------------- */

double PoreField::dissipation() const
{
  return elements.empty()
      ? 0.0
      : Pore_NS::dissipation(lattice, matrix, mobility, seen.outside.gradient, p);
}

/* ---------------------------------------------------------------------- */

std::vector<double> PoreField::pressure_shares() const
{
  std::vector<double> shares(atom->nlocal, 0.0);
  if (atom->nlocal != nlocal) return shares;
  std::vector<double> integrals = element_means(lattice, p);
  for (double &of_element : integrals)
    of_element = lattice.element_volume() * (of_element + seen.given_mean);
  for (std::size_t n = 0; n < particles.size(); n++)
    shares[particles[n].i] = share_of(stencils[n], integrals);
  return shares;
}

/* ----------------------------------------------------------------------
   what advance() has used are velocities that it has predicted from the pressure before
------------------------------------------------------------------------- */

void PoreField::measure_flow(const Vec3 &upper_plate)
{
  if (measured || atom->nlocal != nlocal) return;
  measured = true;
  of_deposit.velocity = upper_plate;
  predict_motion(0.0, {}, of_deposit);
  const Pore_NS::WallFlux flux = wall_flux(
      lattice, imbalance(lattice, matrix, mobility, motion, wall, seen.outside.gradient, p));
  seen.flux = {flux.lower, flux.upper};
}

/* ---------------------------------------------------------------------- */

std::vector<PoreField::Layer> PoreField::profile() const
{
  std::vector<Layer> layers(lattice.ny);
  if (elements.empty()) return layers;
  const std::vector<Lanes> gradient = gradients(lattice, p, seen.outside.gradient);
  const int size = lattice.layer_size();
  for (int j = 0; j < lattice.ny; j++) {
    Layer &layer = layers[j];
    const int up = j + 1 < lattice.layers() ? j + 1 : 0;
    layer.y = lattice.cell.origin.y + (j + 0.5) / lattice.ny * lattice.cell.yprd;
    layer.p = 0.5 * (layer_mean(lattice, p, j) + layer_mean(lattice, p, up)) + seen.given_mean;
    layer.phi = layer.u_y = layer.q_y = 0.0;
    for (int n = j * size; n < (j + 1) * size; n++) {
      layer.phi += elements[n].phi / size;
      layer.u_y += motion.empty() ? 0.0 : motion[n].velocity.y / size;
      layer.q_y -= mobility[n] * gradient[n].y / size;
    }
  }
  return layers;
}

/* ---------------------------------------------------------------------- */

double PoreField::memory_usage() const
{
  return static_cast<double>(lattice.elements() *
                                 (2 * sizeof(Pore_NS::Moments) + sizeof(Pore_NS::Element) +
                                  3 * sizeof(Motion) + sizeof(Vec3) + 3 * sizeof(double)) +
                             6 * lattice.nodes() * sizeof(double) +
                             particles.capacity() *
                                 (sizeof(Particle) + sizeof(Pore_NS::Stencil) + 2 * sizeof(Lanes)) +
                             pushed.capacity() * sizeof(Vec3));
}
