/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The network of fix pore/pressure between plates: it ends at facets between particles of the
// plates. Where these are drained, the fluid outside has the given pressure; where they are
// impermeable, the pressure of the pores behind them is on the plate by itself, as a part of D^T p.

#include "fix_pore_pressure_network.h"

using namespace LAMMPS_NS;
using Lubcontact_NS::Vec3;
using Pore_NS::Pore;

// force of a pressure on the upper plate
Vec3 PoreNetwork::on_upper(const std::vector<double> &of_pressure) const
{
  Vec3 sum;
  for (std::size_t k = 0; k < x.size(); k++)
    if (body[k] == UPPER) sum = sum + pore_force(net, flow, of_pressure, static_cast<int>(k));
  return sum;
}

/* ----------------------------------------------------------------------
   facets of one pore only, with their throats to the outside and the forces of the fluid there
------------------------------------------------------------------------- */

void PoreNetwork::shape_hull(const Fluid &fluid, double factor)
{
  hull.clear();
  flow.drain.assign(net.pores.size(), 0.0);
  const double middle = box.origin.y + 0.5 * box.yprd;
  for (int i = 0; i < static_cast<int>(net.pores.size()); i++)
    for (int corner = 0; corner < 4; corner++) {
      if (net.link_of[i][corner] >= 0) continue;
      const Pore &pore = net.pores[i];
      Hull facet = {i, corner, FREE, 0.0, area_of(flow.shape[i], corner)};
      double height = 0.0;
      for (const Pore_NS::Corner &c : facet_opposite(pore, corner)) {
        if (body[c.particle] != FREE) facet.plate = static_cast<Body>(body[c.particle]);
        height += x[c.particle].y / 3.0;
      }
      if (facet.plate == FREE) facet.plate = height < middle ? LOWER : UPPER;
      const bool upper = facet.plate == UPPER;
      if (drains[upper]) {
        const Pore_NS::Throat t = hull_throat(pore, corner, nudged, radius, edges, centers[i]);
        facet.conductance = factor / fluid.viscosity * conductance_of(t, pore, corner, radius);
        flow.drain[i] += facet.conductance;
        const Vec3 third = (-(upper ? fluid.upper : fluid.lower) / 3.0) * facet.area;
        for (const Pore_NS::Corner &c : facet_opposite(pore, corner))
          pull[c.particle] = pull[c.particle] + third;
      }
      hull.push_back(facet);
    }
}

/* ----------------------------------------------------------------------
   pressures at the plates, and what flows out there
------------------------------------------------------------------------- */

void PoreNetwork::see_hull(const Fluid &fluid)
{
  double area[2] = {}, force[2] = {}, flux[2] = {};
  for (const Hull &facet : hull) {
    const int plate = facet.plate == UPPER;
    area[plate] += facet.area.y;
    force[plate] += p[facet.pore] * facet.area.y;
    flux[plate] += facet.conductance * (p[facet.pore] - (plate ? fluid.upper : fluid.lower));
  }
  seen.lower = drains[0] ? fluid.lower : force[0] / area[0];
  seen.upper = drains[1] ? fluid.upper : force[1] / area[1];
  seen.flux = {flux[0], flux[1]};
}
