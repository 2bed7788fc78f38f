/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The grid of fix pore/pressure: its size, and what a restart file has of it.

#include "fix_pore_pressure_field.h"

#include "domain.h"
#include "error.h"
#include "fix_pore_pressure_settings.h"

#include <cmath>

using namespace LAMMPS_NS;
using Pore_NS::Wall;

/* ----------------------------------------------------------------------
   Elements no smaller than asked for. The first run makes them; later ones, from a restart file,
   too, keep their number unless the script asks for another.
------------------------------------------------------------------------- */

int PoreField::prepare(const PoreSettings &settings, const std::array<double, 3> &height, double d)
{
  static constexpr double SPACING = 1.5;    // over the mean diameter
  Pore_NS::Grid grid = lattice;
  grid.lower = settings.lower;
  grid.upper = settings.upper;
  const bool flat = domain->dimension == 2;
  const int *given = settings.elements;
  const bool keep = made_for == settings.spacing &&
      (!given[0] || (given[0] == grid.nx && given[1] == grid.ny && given[2] == grid.nz));
  if (!keep) {
    const double wanted = settings.spacing > 0.0 ? settings.spacing : SPACING * d;
    int number[3];
    for (int k = 0; k < 3; k++)
      number[k] = given[k] ? given[k]
                           : MAX(1, static_cast<int>(height[k] / wanted * (1.0 + 1e-10)));
    grid.nx = number[0];
    grid.ny = number[1];
    grid.nz = flat ? 1 : number[2];
  }
  made_for = settings.spacing;
  const int count[3] = {grid.nx, grid.ny, grid.nz};
  for (int k = 0; k < domain->dimension; k++)
    if (height[k] / count[k] < d * (1.0 - 1e-10))
      error->all(
          FLERR,
          "Fix pore/pressure: the elements of the grid are {:.4g} along {}, smaller than the "
          "mean diameter {:.4g} of the particles, whose pores they cannot see: use a coarser "
          "grid",
          height[k] / count[k], "xyz"[k], d);
  set_grid(grid);
  return grid.ny;
}

/* ---------------------------------------------------------------------- */

PoreSolver::State PoreField::state() const
{
  State s;
  s.head = {static_cast<double>(lattice.nx),
            static_cast<double>(lattice.ny),
            static_cast<double>(lattice.nz),
            static_cast<double>(lattice.lower),
            static_cast<double>(lattice.upper),
            static_cast<double>(age),
            made_for};
  s.values = p;
  return s;
}

void PoreField::restore(const State &s, const PoreSettings &settings)
{
  Pore_NS::Grid grid;
  grid.nx = static_cast<int>(s.head[0]);
  grid.ny = static_cast<int>(s.head[1]);
  grid.nz = static_cast<int>(s.head[2]);
  grid.lower = static_cast<Wall>(static_cast<int>(s.head[3]));
  grid.upper = static_cast<Wall>(static_cast<int>(s.head[4]));
  const bool same = grid.lower == settings.lower && grid.upper == settings.upper;
  if (!same || grid.nx < 1 || s.head[5] == 0.0) return;
  made_for = s.head[6];
  set_grid(grid);
  if (s.values.size() != grid.nodes()) return;
  p = s.values;
  age = static_cast<int>(s.head[5]);
}
