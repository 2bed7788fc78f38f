/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "radical_tessellation.h"

#include "comm.h"
#include "error.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

RadicalTessellation::RadicalTessellation(LAMMPS *lmp, const std::string &who) :
    Pointers(lmp), who(who), ghosts_of_user(0.0), ghosts_raised(0.0)
{
}

RadicalTessellation::~RadicalTessellation()
{
  return_ghosts();
}

void RadicalTessellation::return_ghosts()
{
  if (ghosts_raised > 0.0 && comm->cutghostuser == ghosts_raised)
    comm->cutghostuser = ghosts_of_user;
  ghosts_raised = 0.0;
}

const char *const RadicalTessellation::NO_LIBRARY =
    "needs the library Voro++, without which this SUSPENSION was built: install it (Debian: "
    "voro++-dev) and build again, or use range cut or shifted";

#ifdef SUSPENSION_VOROPP

#include "atom.h"
#include "domain.h"
#include "lubcontact_vec3.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <voro++/voro++.hh>

using Lubcontact_NS::Vec3;

// Ghosts out to this distance decide the faces of dense suspensions. Over the largest radius.
static constexpr double GHOST_DISTANCE = 5.0;

namespace {

using VoroCell = voro::voronoicell_neighbor;

double largest(const double *values, int n)
{
  double most = 0.0;
  for (int i = 0; i < n; i++) most = std::fmax(most, values[i]);
  return most;
}

// The particles of this rank and where it knows all there are: in its subdomain and as far around
// it as ghosts reach; beyond a boundary that is not periodic there are none.
class Surroundings : protected Pointers {
 public:
  explicit Surroundings(LAMMPS *lmp);
  double radius_max;    // of owned and ghost atoms
  double reach;         // distance from any owned atom in which all are known

  double missing(const Vec3 &x, double distance) const;
  bool cut_at_boundaries(VoroCell &cell, const Vec3 &x, double unit,
                         const RadicalTessellation::Displaced *) const;
  void bounds(double *lo, double *hi, const RadicalTessellation::Displaced *) const;

 private:
  Vec3 gradient[3];     // of the box coordinates 0..1
  double inverse[3];    // its size: 1/height of the box
  double known_lo[3], known_hi[3];
  double box_coordinate(int d, const Vec3 &x) const
  {
    return dot(gradient[d], x - Vec3{domain->boxlo[0], domain->boxlo[1], domain->boxlo[2]});
  }
};

Surroundings::Surroundings(LAMMPS *lmp) :
    Pointers(lmp), radius_max(largest(atom->radius, atom->nlocal + atom->nghost)), reach(HUGE_VAL)
{
  const double *h = domain->h_inv;
  gradient[0] = {h[0], h[5], h[4]};
  gradient[1] = {0.0, h[1], h[3]};
  gradient[2] = {0.0, 0.0, h[2]};
  const bool tilted = domain->triclinic;
  for (int d = 0; d < 3; d++) {
    inverse[d] = norm(gradient[d]);
    const double scale = tilted ? 1.0 : inverse[d], origin = tilted ? 0.0 : domain->boxlo[d];
    const double *sublo = tilted ? domain->sublo_lamda : domain->sublo;
    const double *subhi = tilted ? domain->subhi_lamda : domain->subhi;
    const double lo = (sublo[d] - origin) * scale, hi = (subhi[d] - origin) * scale;
    const double ghosts = comm->cutghost[d] * scale;
    static constexpr double ROUNDING = 1e-12;
    const bool wall = !domain->periodicity[d];
    known_lo[d] = wall && lo < ROUNDING ? -HUGE_VAL : lo - ghosts;
    known_hi[d] = wall && hi > 1.0 - ROUNDING ? HUGE_VAL : hi + ghosts;
    if (d < domain->dimension) reach = std::fmin(reach, ghosts / inverse[d]);
  }
}

/* ----------------------------------------------------------------------
   how much farther ghosts would have to reach to know all around x within distance; <= 0: they do
------------------------------------------------------------------------- */

double Surroundings::missing(const Vec3 &x, double distance) const
{
  double most = -HUGE_VAL;
  for (int d = 0; d < domain->dimension; d++) {
    const double l = box_coordinate(d, x);
    most = std::fmax(most, distance + (known_lo[d] - l) / inverse[d]);
    most = std::fmax(most, distance + (l - known_hi[d]) / inverse[d]);
  }
  return most;
}

/* ----------------------------------------------------------------------
   boundaries that are not periodic, or the planes given, end all cells; false if nothing is left of
   this one
------------------------------------------------------------------------- */

bool Surroundings::cut_at_boundaries(VoroCell &cell, const Vec3 &x, double unit,
                                     const RadicalTessellation::Displaced *displaced) const
{
  for (int d = 0; d < domain->dimension; d++) {
    if (domain->periodicity[d]) continue;
    const Vec3 up = (1.0 / inverse[d]) * gradient[d];
    double above = box_coordinate(d, x) / inverse[d] / unit;
    double below = 1.0 / inverse[d] / unit - above;
    if (displaced && d == 1) {
      above = (x.y - displaced->lowest) / unit;
      below = (displaced->highest - x.y) / unit;
    }
    if (!cell.nplane(up.x, up.y, up.z, 2.0 * below, -10) ||
        !cell.nplane(-up.x, -up.y, -up.z, 2.0 * above, -10))
      return false;
  }
  return true;
}

/* ----------------------------------------------------------------------
   box for the cells: all that is known, and as far beyond again, so that a face out there is found
   and found to be unsure, and all particles
------------------------------------------------------------------------- */

void Surroundings::bounds(double *lo, double *hi,
                          const RadicalTessellation::Displaced *displaced) const
{
  double range[3][2];    // box coordinates; beyond a wall there is nothing
  for (int d = 0; d < 3; d++) {
    range[d][0] = known_lo[d] == -HUGE_VAL ? 0.0 : known_lo[d] - reach * inverse[d];
    range[d][1] = known_hi[d] == HUGE_VAL ? 1.0 : known_hi[d] + reach * inverse[d];
    lo[d] = HUGE_VAL;
    hi[d] = -HUGE_VAL;
  }
  auto include = [lo, hi](const double *x) {
    for (int d = 0; d < 3; d++) {
      lo[d] = std::fmin(lo[d], x[d]);
      hi[d] = std::fmax(hi[d], x[d]);
    }
  };
  const double *h = domain->h, *boxlo = domain->boxlo;
  for (int corner = 0; corner < 8; corner++) {
    const double l[3] = {range[0][corner & 1], range[1][corner >> 1 & 1], range[2][corner >> 2]};
    const double x[3] = {boxlo[0] + h[0] * l[0] + h[5] * l[1] + h[4] * l[2],
                         boxlo[1] + h[1] * l[1] + h[3] * l[2], boxlo[2] + h[2] * l[2]};
    include(x);
  }
  for (int i = 0; i < atom->nlocal + atom->nghost; i++) include(atom->x[i]);
  if (displaced && !domain->periodicity[1]) {
    lo[1] = std::fmin(lo[1], displaced->lowest);
    hi[1] = std::fmax(hi[1], displaced->highest);
  }
}

// Cells of the owned atoms, in units of the largest radius because Voro++ has absolute tolerances.
// In 2d a slab as thick as this unit, so that the area of a face is its length.
class Cells : protected Pointers {
 public:
  Cells(LAMMPS *lmp, const RadicalTessellation::Displaced *displaced);
  // calls shared(i, cell) for each owned atom that has a cell
  template <class F> void each_cell(const F &shared);
  double face_missing(int i, int j, const std::vector<double> &points,
                      const std::vector<int> &corners) const;
  bool is_sure(VoroCell &cell) const;
  double vertex_missing(int i, const double *point) const
  {
    return missing(i, unit * Lubcontact_NS::get_vector(point));
  }

 private:
  Surroundings surroundings;
  const RadicalTessellation::Displaced *displaced;
  double unit;
  Vec3 middle;
  std::unique_ptr<voro::container_poly> container;
  voro::particle_order owned;
  Vec3 position(int i) const
  {
    const Vec3 x = {atom->x[i][0], atom->x[i][1], domain->dimension == 3 ? atom->x[i][2] : 0.0};
    return displaced ? x + displaced->by[i] : x;
  }
  double missing(int i, const Vec3 &q) const;
};

Cells::Cells(LAMMPS *lmp, const RadicalTessellation::Displaced *displaced) :
    Pointers(lmp), surroundings(lmp), displaced(displaced), unit(surroundings.radius_max),
    owned(MAX(atom->nlocal, 1))
{
  const int nall = atom->nlocal + atom->nghost;
  const bool flat = domain->dimension == 2;
  double lo[3], hi[3], size[3];
  surroundings.bounds(lo, hi, displaced);
  middle = {0.5 * (lo[0] + hi[0]), 0.5 * (lo[1] + hi[1]), flat ? 0.0 : 0.5 * (lo[2] + hi[2])};
  for (int d = 0; d < 3; d++) size[d] = (hi[d] - lo[d]) / unit + 2.0;
  if (flat) size[2] = 1.0;
  const double per_block = voro::optimal_particles * size[0] * size[1] * size[2] / nall;
  const double edge = flat ? sqrt(per_block) : cbrt(per_block);
  int blocks[3];
  for (int d = 0; d < 3; d++) blocks[d] = flat && d == 2 ? 1 : static_cast<int>(size[d] / edge) + 1;
  container = std::make_unique<voro::container_poly>(
      -0.5 * size[0], 0.5 * size[0], -0.5 * size[1], 0.5 * size[1], -0.5 * size[2], 0.5 * size[2],
      blocks[0], blocks[1], blocks[2], false, false, false, 8);
  for (int i = 0; i < nall; i++) {
    const Vec3 x = (1.0 / unit) * (position(i) - middle);
    if (i < atom->nlocal)
      container->put(owned, i, x.x, x.y, x.z, atom->radius[i] / unit);
    else
      container->put(i, x.x, x.y, x.z, atom->radius[i] / unit);
  }
}

template <class F> void Cells::each_cell(const F &shared)
{
  VoroCell cell;
  voro::c_loop_order loop(*container, owned);
  if (!loop.start()) return;
  do {
    const int i = loop.pid();
    if (!container->compute_cell(cell, loop)) continue;    // swallowed by an overlapping one
    if (surroundings.cut_at_boundaries(cell, position(i), unit, displaced)) shared(i, cell);
  } while (loop.inc());
}

/* ----------------------------------------------------------------------
   An unknown particle takes the point x_i + q from the cell of i only from within this distance
------------------------------------------------------------------------- */

double Cells::missing(int i, const Vec3 &q) const
{
  const double most = surroundings.radius_max, r = atom->radius[i];
  return surroundings.missing(position(i) + q, sqrt(dot(q, q) + most * most - r * r));
}

/* ----------------------------------------------------------------------
   is no vertex so far away that an unknown particle could change the cell?
------------------------------------------------------------------------- */

bool Cells::is_sure(VoroCell &cell) const
{
  const double farthest = 0.5 * unit * sqrt(cell.max_radius_squared());    // twice, in Voro++
  const double most = surroundings.radius_max;
  return farthest + sqrt(farthest * farthest + most * most) < surroundings.reach;
}

/* ----------------------------------------------------------------------
   What the known particles leave of a face is all of it, or unknown ones leave less. It exists if
   one of its points is sure: where the line of centers passes through it, or the nearest of an edge
------------------------------------------------------------------------- */

double Cells::face_missing(int i, int j, const std::vector<double> &points,
                           const std::vector<int> &corners) const
{
  const bool flat = domain->dimension == 2;
  const Vec3 d = position(j) - position(i);
  const double ri = atom->radius[i], rj = atom->radius[j];
  const Vec3 foot = 0.5 * (1.0 + (ri * ri - rj * rj) / dot(d, d)) * d;
  auto corner = [&](std::size_t n) {
    const double *q = &points[3 * corners[n % corners.size()]];
    return unit * Vec3{q[0], q[1], flat ? 0.0 : q[2]};
  };

  double least = HUGE_VAL;
  bool left = false, right = false;
  for (std::size_t n = 0; n < corners.size(); n++) {
    const Vec3 a = corner(n) - foot, along = corner(n + 1) - corner(n);
    const double square = dot(along, along);
    const double part = square > 0.0 ? std::fmin(1.0, std::fmax(0.0, -dot(a, along) / square)) : 0;
    least = std::fmin(least, missing(i, foot + a + part * along));
    const double side = flat ? -dot(a, a + along) : dot(d, cross(a, a + along));
    if (side > 0.0) left = true;
    if (side < 0.0) right = true;
  }
  const bool through = flat ? left : left != right;
  return through ? std::fmin(least, missing(i, foot)) : least;
}

}    // namespace

/* ---------------------------------------------------------------------- */

bool RadicalTessellation::has_library()
{
  return true;
}

/* ---------------------------------------------------------------------- */

void RadicalTessellation::request_ghosts(double largest_radius)
{
  return_ghosts();
  if (comm->mode != Comm::SINGLE)
    error->all(FLERR,
               "{} needs ghost atoms of all types at one distance; use: comm_modify mode single",
               who);
  ghosts_of_user = comm->cutghostuser;
  ghosts_raised = MAX(ghosts_of_user, GHOST_DISTANCE * largest_radius);
  comm->cutghostuser = ghosts_raised;
}

/* ---------------------------------------------------------------------- */

void RadicalTessellation::each_cell(const std::function<void(const Cell &)> &visit,
                                    const RadicalTessellation::Displaced *displaced) const
{
  if (atom->nlocal == 0) return;
  Cells cells(lmp, displaced);
  Cell cell;
  std::vector<int> corners, polygon;
  std::vector<double> points;
  cells.each_cell([&](int i, VoroCell &found) {
    cell.owner = i;
    found.neighbors(cell.neighbors);
    found.face_areas(cell.areas);
    const bool sure = cells.is_sure(found);
    if (!sure) {
      found.vertices(points);
      found.face_vertices(corners);
    }
    cell.require_sure = [&, i, sure](std::size_t n) {
      if (sure) return;
      std::size_t at = 0;    // of the face in corners: number of them, then each
      for (std::size_t m = 0; m < n; m++) at += 1 + corners[at];
      polygon.assign(&corners[at + 1], &corners[at + 1] + corners[at]);
      const int j = cell.neighbors[n];
      const double missing = cells.face_missing(i, j, points, polygon);
      if (missing > 0.0)
        error->one(FLERR,
                   "{} cannot tell whether atoms {} and {} share a Voronoi face: there are voids, "
                   "and ghost atoms reach {:.6g} only; use: comm_modify cutoff {:.4g}",
                   who, atom->tag[i], atom->tag[j], comm->get_comm_cutoff(),
                   1.1 * (comm->get_comm_cutoff() + missing));
    };
    cell.get_vertices = [&, i, sure](std::vector<std::array<int, 3>> &vertices) {
      vertices.clear();
      for (int n = 0; n < found.p; n++) {
        const int *others = found.ne[n];
        if (*std::min_element(others, others + found.nu[n]) < 0) continue;
        if (found.nu[n] != 3) return false;
        const double missing = sure ? 0.0 : cells.vertex_missing(i, &points[3 * n]);
        if (missing > 0.0)
          error->one(FLERR,
                     "{} cannot tell which pores atom {} has: there are voids, and ghost atoms "
                     "reach {:.6g} only; use: comm_modify cutoff {:.4g}",
                     who, atom->tag[i], comm->get_comm_cutoff(),
                     1.1 * (comm->get_comm_cutoff() + missing));
        vertices.push_back({others[0], others[1], others[2]});
      }
      return true;
    };
    visit(cell);
  });
}

#else

bool RadicalTessellation::has_library()
{
  return false;
}

void RadicalTessellation::request_ghosts(double)
{
  error->all(FLERR, "{} {}", who, NO_LIBRARY);
}

void RadicalTessellation::each_cell(const std::function<void(const Cell &)> &,
                                    const Displaced *) const
{
  error->all(FLERR, "{} {}", who, NO_LIBRARY);
}

#endif
