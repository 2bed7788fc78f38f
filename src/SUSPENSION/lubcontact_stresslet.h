/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// RESIDUAL: what the films of a pair do in a flow beside the forces between its spheres: stresslet
// and its heat. From the form Phi of lubcontact_residual.h: the stresslet is dPhi/dE, and where the
// rates are eliminated in favor of the forces it has no singular term. With F the force of the
// squeeze film, f of the shear film, h = T x n of the rolling torque T, all on i,
//     n.S.n = part F + stretch e,  (1-nn).S.n = slide f + turn h + extend e_t
// without a trace, which does no work in a flow that keeps the volume. `stretch` and `extend` may
// be negative at wide gaps: the heat together with that of the far field is not.

#ifndef LUBCONTACT_STRESSLET_H
#define LUBCONTACT_STRESSLET_H

#include "lubcontact_defs.h"
#include "lubcontact_film.h"
#include "lubcontact_geometry.h"

namespace LAMMPS_NS::Lubcontact_NS {

struct FlowResponse {
  double part;           // dr/dt without a force over e, length
  double stretch;        // heat at rest of the film over e^2, pressure*time*volume
  double slide, turn;    // as in TangentialResidual; a rubbing contact has no slide
  double extend;         // heat over e_t^2
};

LUBCONTACT_FN inline FlowResponse flow_response(const Film &f, const PairGeometry &g, double u_a,
                                                double ln_u, bool rubs)
{
  const double delta = size_difference(g);
  const ResidualPlace p = residual_place(u_a, ln_u, delta);
  const TangentialResidual t = residual_films(f, g.a, delta, p);
  const double eta = f.viscosity, volume = eta * g.a * g.a * g.a;
  const double push = residual<RESIDUAL_PUSH>(p);
  const double squeeze = larger(1e-6, residual<RESIDUAL_SQUEEZE>(p));
  const double part_a = push * p.u_a / (1.5 * PI * squeeze);
  const double slide = rubs ? 0.0 : t.slide;
  const double left =
      volume * residual<RESIDUAL_EXTEND>(p) - t.shear * slide * slide - t.roll * t.turn * t.turn;
  return {g.a * part_a, volume * (residual<RESIDUAL_STRETCH>(p) - push * part_a), slide, t.turn,
          f.shear_end > 0.0 ? 0.0 : left};
}

// By origin.
struct FilmStresslet {
  SymmetricTensor normal, tangential;
};

// squeeze: force along n, shear: across n, couple: of the rolling film; on i
LUBCONTACT_FN inline FilmStresslet film_stresslet(const FlowResponse &r, const Strain &E,
                                                  const Vec3 &n, double squeeze, const Vec3 &shear,
                                                  const Vec3 &couple)
{
  const PairStrain flow = pair_strain(E, n);
  const double along = r.part * squeeze + r.stretch * flow.along, third = along / 3.0;
  const Vec3 across = 0.5 * (r.slide * shear + r.turn * cross(couple, n) + r.extend * flow.across);
  return {{along * n.x * n.x - third, along * n.y * n.y - third, along * n.z * n.z - third,
           along * n.x * n.y, along * n.x * n.z, along * n.y * n.z},
          {2.0 * across.x * n.x, 2.0 * across.y * n.y, 2.0 * across.z * n.z,
           across.x * n.y + across.y * n.x, across.x * n.z + across.z * n.x,
           across.y * n.z + across.z * n.y}};
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
