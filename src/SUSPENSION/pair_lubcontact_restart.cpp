/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What the user types for pair style lubcontact: settings, coefficients, restart, data files.

#include "pair_lubcontact.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "lubcontact_friction.h"
#include "restart_seal.h"

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;

static constexpr int MAX_LENGTH = 1 << 28;    // a million pairs of types and more

/* ----------------------------------------------------------------------
   bytes with their number and checksum in front
------------------------------------------------------------------------- */

template <class T> static void append(std::string &bytes, const T &value)
{
  bytes.append(reinterpret_cast<const char *>(&value), sizeof(T));
}

static void write_sealed(FILE *fp, const std::string &bytes)
{
  const auto length = static_cast<int>(bytes.size());
  const double sum = Suspension_NS::seal(bytes.data(), bytes.size());
  fwrite(&length, sizeof(int), 1, fp);
  fwrite(&sum, sizeof(double), 1, fp);
  fwrite(bytes.data(), 1, bytes.size(), fp);
}

// the first rank reads; all get the bytes
static std::string read_sealed(FILE *fp, LAMMPS *lmp)
{
  int length = 0;
  std::string bytes;
  if (lmp->comm->me == 0) {
    double sum = 0.0;
    utils::sfread(FLERR, &length, sizeof(int), 1, fp, nullptr, lmp->error);
    utils::sfread(FLERR, &sum, sizeof(double), 1, fp, nullptr, lmp->error);
    if (length >= 0 && length <= MAX_LENGTH) {
      bytes.resize(length);
      const bool whole = fread(&bytes[0], 1, length, fp) == bytes.size();
      if (!whole || Suspension_NS::seal(bytes.data(), bytes.size()) != sum) length = -1;
    } else
      length = -1;
  }
  MPI_Bcast(&length, 1, MPI_INT, 0, lmp->world);
  if (length < 0)
    lmp->error->all(FLERR,
                    "The part of pair style lubcontact in the restart file is damaged, or another "
                    "version of the package has written it: use another restart file");
  bytes.resize(length);
  MPI_Bcast(&bytes[0], length, MPI_CHAR, 0, lmp->world);
  return bytes;
}

// takes values from the front of bytes; zeros beyond their end
template <class T> static void take(std::string &bytes, T &value)
{
  memset(&value, 0, sizeof(T));
  memcpy(&value, bytes.data(), std::min(sizeof(T), bytes.size()));
  bytes.erase(0, sizeof(T));
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::write_restart_settings(FILE *fp)
{
  std::string bytes;
  for (const double number : {eta, hc, roll_coeff}) append(bytes, number);
  for (const int choice :
       {range_rule, radius_rule, euler, mode[SQUEEZE], mode[SHEAR], mode[ROLL], mode[TWIST]})
    append(bytes, choice);
  if (eta_name) bytes += eta_name;
  write_sealed(fp, bytes);
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::read_restart_settings(FILE *fp)
{
  std::string bytes = read_sealed(fp, lmp);
  for (double *number : {&eta, &hc, &roll_coeff}) take(bytes, *number);
  for (int *choice :
       {&range_rule, &radius_rule, &euler, &mode[SQUEEZE], &mode[SHEAR], &mode[ROLL], &mode[TWIST]})
    take(bytes, *choice);
  delete[] eta_name;
  eta_name = bytes.empty() ? nullptr : utils::strdup(bytes);
}

/* ----------------------------------------------------------------------
   coefficients per pair of types, in the order of a restart file
------------------------------------------------------------------------- */

std::array<double **, 9> PairLubcontact::numbers() const
{
  return {g, kt, asperity, roughness, friction, critical, adhesion, repulsion, screening};
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::write_restart(FILE *fp)
{
  write_restart_settings(fp);
  std::string bytes;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      append(bytes, setflag[i][j]);
      append(bytes, law[i][j]);
      if (!setflag[i][j]) continue;
      for (double **k : numbers()) append(bytes, k[i][j]);
    }
  write_sealed(fp, bytes);
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::read_restart(FILE *fp)
{
  read_restart_settings(fp);
  if (!allocated) allocate();
  std::string bytes = read_sealed(fp, lmp);
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      take(bytes, setflag[i][j]);
      take(bytes, law[i][j]);
      if (!setflag[i][j]) continue;
      for (double **k : numbers()) take(bytes, k[i][j]);
    }
}

/* ----------------------------------------------------------------------
   keywords of pair_coeff that say what types i and j have
------------------------------------------------------------------------- */

std::string PairLubcontact::coeff_words(int i, int j, const std::vector<std::string> &without) const
{
  using Lubcontact_NS::FrictionLaw;
  auto keeps = [&without](const char *effect) {
    return std::find(without.begin(), without.end(), effect) == without.end();
  };
  auto friction_law = static_cast<FrictionLaw>(law[i][j]);
  if (friction_law > FrictionLaw::COULOMB && !keeps("critical load"))
    friction_law = FrictionLaw::COULOMB;
  if (!keeps("friction")) friction_law = FrictionLaw::NONE;

  std::string words =
      fmt::format("asperity {} roughness {} friction {}", asperity[i][j], roughness[i][j],
                  Lubcontact_NS::FRICTION_NAME[static_cast<int>(friction_law)]);
  if (friction_law != FrictionLaw::NONE) words += fmt::format(" {}", friction[i][j]);
  if (friction_law > FrictionLaw::COULOMB) words += fmt::format(" {}", critical[i][j]);
  if (adhesion[i][j] > 0.0 && keeps("adhesion"))
    words += fmt::format(" adhesion {}", adhesion[i][j]);
  if (screening[i][j] > 0.0 && keeps("repulsion"))
    words += fmt::format(" repulsion {} {}", repulsion[i][j], screening[i][j]);
  return words;
}

void PairLubcontact::write_pair(FILE *fp, int i, int j) const
{
  fmt::print(fp, " {} {} {}\n", g[i][j], kt[i][j], coeff_words(i, j, {}));
}

void PairLubcontact::write_data(FILE *fp)
{
  for (int i = 1; i <= atom->ntypes; i++) {
    fmt::print(fp, "{}", i);
    write_pair(fp, i, i);
  }
}

void PairLubcontact::write_data_all(FILE *fp)
{
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      fmt::print(fp, "{} {}", i, j);
      write_pair(fp, i, j);
    }
}
