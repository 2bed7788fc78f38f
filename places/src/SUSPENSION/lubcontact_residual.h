/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Residual films: the resistance of two spheres minus what a far field gives them in which each is
// a force, a torque and a stresslet (force coupling), translation and rotation of the pair as a
// whole eliminated. With the far field a pair without external force and torque answers to forces
// between its spheres exactly; Bs, Br and Cs are such that in a flow its centers and spins move
// relative to each other exactly, with the exact stresslet.
// Dissipation over 2, w = dr/dt, s slip, rho relative rotation, sigma = rho x n, E strain of the
// flow, e = n.E.n, e_t = (1-nn).E.n:
//     A w^2/2 - B r e w + C e^2/2
//     As s^2/2 + Rsr s.sigma + Rr sigma^2/2 - (Bs r s + Br sigma).e_t + Cs e_t^2/2 + Tw rho_n^2/2
// Exact: D.J. Jeffrey, Y. Onishi, J. Fluid Mech. 139, 261 (1984); D.J. Jeffrey, Phys. Fluids A 4,
// 16 (1992). Force coupling: S. Lomholt, M.R. Maxey, J. Comput. Phys. 184, 381 (2003). What is
// left of a film, and why relative motion only: B. Cichocki, M.L. Ekiel-Jezewska, E. Wajnryb,
// J. Chem. Phys. 111, 3265 (1999).
//
// Each is a fit P(t, beta) + ln(1/u) Q(t, beta), u = u_a, t = u/(1+u), beta = delta^2, delta =
// (R_j-R_i)/(R_i+R_j), a harmonic. The limits u -> 0 of lubrication are exact.

#ifndef LUBCONTACT_RESIDUAL_H
#define LUBCONTACT_RESIDUAL_H

#include "lubcontact_defs.h"
#include "lubcontact_residual_fit.h"

namespace LAMMPS_NS::Lubcontact_NS {

enum ResidualPart {
  RESIDUAL_SQUEEZE,    // A u/(nu a^2), nu = (3/2) pi eta: 1 in the limit
  RESIDUAL_PUSH,       // B r/(eta a^2)
  RESIDUAL_STRETCH,    // C/(eta a^3)
  RESIDUAL_SHEAR,      // As/(pi eta a)
  RESIDUAL_SLIDE,      // Bs r/(eta a^2)
  RESIDUAL_EXTEND,     // Cs/(eta a^3)
  RESIDUAL_ROLL,       // Rr/(pi eta a^3)
  RESIDUAL_LEVER,      // Rsr/(pi eta a^2 delta)
  RESIDUAL_TWIST,      // Tw/(pi eta a^3)
  RESIDUAL_TURN,       // Br/(eta a^3 delta)
  NUM_RESIDUAL_PARTS
};

// Of the fit: largest gap over a, and beta of the largest size ratio.
static constexpr double RESIDUAL_END_A = 2.0, RESIDUAL_END_BETA = 0.36;
static constexpr double RESIDUAL_SIZE_RATIO = 4.0;

// Place of a pair in the fit; beyond its ends that of the end.
struct ResidualPlace {
  double u_a, ln_u, t, beta;
};

LUBCONTACT_FN inline ResidualPlace residual_place(double u_a, double ln_u, double delta)
{
  // the fit goes on a little behind its end, where a pair in range may arrive within a step
  static constexpr double LAST_A = 1.1 * RESIDUAL_END_A, LN_LAST = 0.78845736036427028;
  const double u = smaller(u_a, LAST_A);
  return {u, smaller(ln_u, LN_LAST), u / (1.0 + u), smaller(delta * delta, RESIDUAL_END_BETA)};
}

// Coefficients as constants in the instructions, not a table in memory.
template <int PART, int ROW, int FROM = 0> LUBCONTACT_FN inline double residual_row(double beta)
{
  constexpr int WIDTH = sizeof(RESIDUAL_FIT[0][0]) / sizeof(double);
  constexpr double c = RESIDUAL_FIT[PART][ROW][FROM];
  if constexpr (FROM + 1 < WIDTH)
    return residual_row<PART, ROW, FROM + 1>(beta) * beta + c;
  else
    return c;
}

// Rows FROM to LAST as a polynomial in t.
template <int PART, int FROM, int LAST>
LUBCONTACT_FN inline double residual_rows(double t, double beta)
{
  if constexpr (FROM < LAST)
    return residual_rows<PART, FROM + 1, LAST>(t, beta) * t + residual_row<PART, FROM>(beta);
  else
    return residual_row<PART, FROM>(beta);
}

template <int PART> LUBCONTACT_FN inline double residual(const ResidualPlace &p)
{
  return residual_rows<PART, 0, 5>(p.t, p.beta) - p.ln_u * residual_rows<PART, 6, 8>(p.t, p.beta);
}

// Tangential modes, without their coupling: the force of the shear film acts off the middle of the
// gap, at arms R_i + un/2 - lever and R_j + un/2 + lever, where the films of slip and roll do not
// know of each other.
struct TangentialResidual {
  double shear;    // force/velocity of the slip there
  double roll;     // torque/angular velocity
  double twist;
  double lever;    // length
  double slide;    // slip velocity over e_t at which there is no force, length
  double turn;     // rolling rate over n x e_t without torque
};

LUBCONTACT_FN inline double residual_shear(const ResidualPlace &p)
{
  static constexpr double LEAST = 1e-12;    // of a fit that is positive
  return larger(LEAST, residual<RESIDUAL_SHEAR>(p));
}

// The lever of TangentialResidual alone.
LUBCONTACT_FN inline double residual_lever(double a, double delta, const ResidualPlace &p)
{
  return a * (residual<RESIDUAL_LEVER>(p) / residual_shear(p)) * delta;
}

LUBCONTACT_FN inline TangentialResidual tangential_residual(double viscosity, double a,
                                                            double delta, const ResidualPlace &p)
{
  static constexpr double LEAST = 1e-12;
  const double shear = residual_shear(p);
  const double off = residual<RESIDUAL_LEVER>(p) / shear;
  const double slide = residual<RESIDUAL_SLIDE>(p);
  const double roll =
      larger(LEAST, residual<RESIDUAL_ROLL>(p) - off * off * shear * (delta * delta));
  const double per_a = PI * viscosity * a;
  return {per_a * shear,
          per_a * (a * a) * roll,
          per_a * (a * a) * larger(0.0, residual<RESIDUAL_TWIST>(p)),
          a * off * delta,
          a * slide / (PI * shear),
          delta * (residual<RESIDUAL_TURN>(p) - off * slide) / (PI * roll)};
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
