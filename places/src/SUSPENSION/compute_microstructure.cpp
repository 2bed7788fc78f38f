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
#include "error.h"
#include "lubcontact_channels.h"
#include "lubcontact_contacts.h"
#include "lubcontact_fabric.h"
#include "lubcontact_orientation.h"
#include "memory.h"
#include "pair_lubcontact.h"
#include "suspension_input.h"
#include "update.h"

#include <cstring>

using namespace LAMMPS_NS;
using Lubcontact_NS::DirectionBins;
using Lubcontact_NS::Plane;

/* ---------------------------------------------------------------------- */

ComputeMicrostructure::ComputeMicrostructure(LAMMPS *lmp, int narg, char **arg) :
    Compute(lmp, narg, arg), mode(CONTACTS), bins(0), largest(0.0),
    directions(new DirectionBins{Plane::XY, 1, 1, 1.0}), stress_a(0), stress_b(1)
{
  read_mode(narg, arg);
  set_output();
}

/* ---------------------------------------------------------------------- */

ComputeMicrostructure::~ComputeMicrostructure()
{
  delete directions;
  delete[] vector;
  memory->destroy(array);
}

/* ---------------------------------------------------------------------- */

void ComputeMicrostructure::read_mode(int narg, char **arg)
{
  const std::string word = narg > 3 ? arg[3] : "contacts";
  int next = 4;
  if (word == "contacts") {
    mode = CONTACTS;
  } else if (word == "fabric") {
    mode = FABRIC;
  } else if (word == "forces") {
    mode = FORCES;
    Suspension_NS::require_words(FLERR, error, "compute microstructure", narg - 3, "forces N hi");
    bins = read_count(4, arg);
    largest = utils::numeric(FLERR, arg[5], false, lmp);
    if (!(largest > 0.0))
      error->all(FLERR, 5,
                 "Compute microstructure forces: the largest force over the mean must be > 0, but "
                 "is {}",
                 arg[5]);
    next = 6;
  } else if (word == "angle") {
    mode = ANGLE;
    Suspension_NS::require_words(FLERR, error, "compute microstructure", narg - 3, "angle N ...");
    directions->azimuths = read_count(4, arg);
    next = 5;
  } else if (word == "sphere") {
    mode = SPHERE;
    if (domain->dimension == 2)
      error->all(FLERR, 3,
                 "Compute microstructure sphere needs three dimensions; use: angle {} in 2d",
                 narg > 5 ? arg[5] : "N");
    Suspension_NS::require_words(FLERR, error, "compute microstructure", narg - 3,
                                 "sphere Nh Na ...");
    directions->heights = read_count(4, arg);
    directions->azimuths = read_count(5, arg);
    next = 6;
  } else {
    error->all(FLERR, 3,
               "Compute microstructure mode must be contacts, fabric, forces, angle or sphere, but "
               "is {}",
               word);
  }
  if (mode == ANGLE || mode == SPHERE)
    read_directions(next, narg, arg);
  else if (narg > next)
    error->all(FLERR, next, "Unknown compute microstructure {} argument: {}", word, arg[next]);
}

/* ---------------------------------------------------------------------- */

int ComputeMicrostructure::read_count(int iarg, char **arg) const
{
  const int n = utils::inumeric(FLERR, arg[iarg], false, lmp);
  if (n < 1)
    error->all(FLERR, iarg, "Compute microstructure {}: number of bins must be >= 1, but is {}",
               arg[3], arg[iarg]);
  return n;
}

/* ----------------------------------------------------------------------
   plane, band, and the component of the stress, by default that of the plane
------------------------------------------------------------------------- */

void ComputeMicrostructure::read_directions(int iarg, int narg, char **arg)
{
  bool chosen = false;    // component of the stress
  const bool flat = domain->dimension == 2;
  auto axis = [](char letter) {
    return letter >= 'x' && letter <= 'z' ? letter - 'x' : -1;
  };
  for (; iarg < narg; iarg += 2) {
    const std::string key = arg[iarg];
    if (key != "plane" && key != "band" && key != "stress")
      error->all(FLERR, iarg, "Unknown compute microstructure {} keyword: {}", arg[3], key);
    Suspension_NS::require_words(FLERR, error, "compute microstructure", narg - iarg,
                                 key + (key == "plane" ? " xy|xz|yz" : " value"));
    const std::string value = arg[iarg + 1];
    if (key == "plane") {
      if (value != "xy" && value != "xz" && value != "yz")
        error->all(FLERR, iarg + 1, "Compute microstructure plane must be xy, xz or yz, but is {}",
                   value);
      if (flat && value != "xy")
        error->all(FLERR, iarg + 1, "Compute microstructure plane must be xy in 2d, but is {}",
                   value);
      directions->plane = value == "xy" ? Plane::XY : (value == "xz" ? Plane::XZ : Plane::YZ);
      if (!chosen) {    // an explicit component comes later and wins
        stress_a = axis(value[0]);
        stress_b = axis(value[1]);
      }
    } else if (key == "band") {
      if (mode == SPHERE || flat)
        error->all(FLERR, iarg, "Compute microstructure band needs mode angle and a 3d system");
      directions->band = utils::numeric(FLERR, arg[iarg + 1], false, lmp);
      if (!(directions->band > 0.0 && directions->band <= 1.0))
        error->all(FLERR, iarg + 1, "Compute microstructure band must be in (0, 1], but is {}",
                   value);
    } else {
      stress_a = value.size() == 2 ? axis(value[0]) : -1;
      stress_b = value.size() == 2 ? axis(value[1]) : -1;
      chosen = true;
      if (stress_a < 0 || stress_b < 0)
        error->all(FLERR, iarg + 1,
                   "Compute microstructure stress must be a component such as xy, but is {}",
                   value);
    }
  }
}

/* ---------------------------------------------------------------------- */

void ComputeMicrostructure::set_output()
{
  extscalar = extvector = extarray = 0;
  if (mode == CONTACTS) {
    scalar_flag = vector_flag = 1;
    size_vector = Lubcontact_NS::Averages::SIZE;
    comm_reverse = 1;
  } else {
    array_flag = 1;
    if (mode == FABRIC) {
      size_array_rows = FABRIC_ROWS;
      size_array_cols = Lubcontact_NS::FABRIC_SIZE;
    } else if (mode == FORCES) {
      size_array_rows = bins;
      size_array_cols = FORCE_COLUMNS;
      vector_flag = 1;
      size_vector = FORCE_NUMBERS;
    } else {
      size_array_rows = directions->size();
      size_array_cols = (mode == SPHERE ? 2 : 1) + DIRECTION_SUMS + Lubcontact_NS::NUM_CHANNELS;
      comm_forward = 3;
    }
    memory->create(array, size_array_rows, size_array_cols, "microstructure:array");
  }
  if (vector_flag) vector = new double[size_vector];
}

/* ---------------------------------------------------------------------- */

void ComputeMicrostructure::init()
{
  pairs = PairLubcontact::require(lmp, std::string("Compute ") + style);
}

/* ---------------------------------------------------------------------- */

double ComputeMicrostructure::compute_scalar()
{
  invoked_scalar = update->ntimestep;
  compute_contacts();
  scalar = vector[Lubcontact_NS::Averages::Z];
  return scalar;
}

/* ---------------------------------------------------------------------- */

void ComputeMicrostructure::compute_vector()
{
  invoked_vector = update->ntimestep;
  if (mode == CONTACTS)
    compute_contacts();
  else
    compute_forces();
}

/* ---------------------------------------------------------------------- */

void ComputeMicrostructure::compute_array()
{
  invoked_array = update->ntimestep;
  if (mode == FABRIC)
    compute_fabric();
  else if (mode == FORCES)
    compute_forces();
  else
    compute_directions();
}

/* ----------------------------------------------------------------------
   velocities at the end of the step: those of the ghosts are half a step older, and stay so
------------------------------------------------------------------------- */

void ComputeMicrostructure::share_velocities()
{
  per_atom.resize(3 * (static_cast<std::size_t>(atom->nlocal) + atom->nghost));
  if (atom->nlocal) memcpy(per_atom.data(), atom->v[0], 3 * sizeof(double) * atom->nlocal);
  comm->forward_comm(this);
}

int ComputeMicrostructure::pack_forward_comm(int n, int *list, double *buf, int pbc_flag, int *pbc)
{
  double shift[3] = {};    // of an image across a moving boundary
  if (pbc_flag && domain->deform_vremap) {
    const double *rate = domain->h_rate;
    shift[0] = pbc[0] * rate[0] + pbc[5] * rate[5] + pbc[4] * rate[4];
    shift[1] = pbc[1] * rate[1] + pbc[3] * rate[3];
    shift[2] = pbc[2] * rate[2];
  }
  int m = 0;
  for (int k = 0; k < n; k++) {
    const int i = list[k];
    const double moves = atom->mask[i] & domain->deform_groupbit ? 1.0 : 0.0;
    for (int d = 0; d < 3; d++) buf[m++] = per_atom[3 * i + d] + moves * shift[d];
  }
  return m;
}

void ComputeMicrostructure::unpack_forward_comm(int n, int first, double *buf)
{
  memcpy(per_atom.data() + 3 * static_cast<std::size_t>(first), buf, 3 * sizeof(double) * n);
}

/* ----------------------------------------------------------------------
   contacts of the ghosts belong to their owners
------------------------------------------------------------------------- */

int ComputeMicrostructure::pack_reverse_comm(int n, int first, double *buf)
{
  memcpy(buf, per_atom.data() + first, sizeof(double) * n);
  return n;
}

void ComputeMicrostructure::unpack_reverse_comm(int n, int *list, double *buf)
{
  for (int k = 0; k < n; k++) per_atom[list[k]] += buf[k];
}

/* ---------------------------------------------------------------------- */

double ComputeMicrostructure::memory_usage()
{
  auto doubles = static_cast<double>(per_atom.capacity());
  if (vector_flag) doubles += size_vector;
  if (array_flag) doubles += static_cast<double>(size_array_rows) * size_array_cols;
  return sizeof(double) * doubles;
}
