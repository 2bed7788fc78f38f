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

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

void PairLubcontact::write_restart_settings(FILE *fp)
{
  const int length = eta_name ? static_cast<int>(strlen(eta_name)) + 1 : 0;
  fwrite(&length, sizeof(int), 1, fp);
  if (length) fwrite(eta_name, 1, length, fp);
  const double numbers[3] = {eta, hc, roll_coeff};
  const int choices[7] = {range_rule,  radius_rule, euler,      mode[SQUEEZE],
                          mode[SHEAR], mode[ROLL],  mode[TWIST]};
  fwrite(numbers, sizeof(double), 3, fp);
  fwrite(choices, sizeof(int), 7, fp);
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::read_restart_settings(FILE *fp)
{
  int length = 0;
  double numbers[3];
  int choices[7];
  const bool root = comm->me == 0;
  if (root) utils::sfread(FLERR, &length, sizeof(int), 1, fp, nullptr, error);
  MPI_Bcast(&length, 1, MPI_INT, 0, world);
  delete[] eta_name;
  eta_name = length ? new char[length] : nullptr;
  if (length) {
    if (root) utils::sfread(FLERR, eta_name, 1, length, fp, nullptr, error);
    MPI_Bcast(eta_name, length, MPI_CHAR, 0, world);
  }
  if (root) utils::sfread(FLERR, numbers, sizeof(double), 3, fp, nullptr, error);
  if (root) utils::sfread(FLERR, choices, sizeof(int), 7, fp, nullptr, error);
  MPI_Bcast(numbers, 3, MPI_DOUBLE, 0, world);
  MPI_Bcast(choices, 7, MPI_INT, 0, world);

  eta = numbers[0];
  hc = numbers[1];
  roll_coeff = numbers[2];
  range_rule = choices[0];
  radius_rule = choices[1];
  euler = choices[2];
  for (int m = 0; m < 4; m++) mode[m] = choices[3 + m];
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
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      const int flags[2] = {setflag[i][j], law[i][j]};
      fwrite(flags, sizeof(int), 2, fp);
      if (!setflag[i][j]) continue;
      for (double **k : numbers()) fwrite(&k[i][j], sizeof(double), 1, fp);
    }
}

/* ---------------------------------------------------------------------- */

void PairLubcontact::read_restart(FILE *fp)
{
  read_restart_settings(fp);
  if (!allocated) allocate();
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      int flags[2];
      if (comm->me == 0) utils::sfread(FLERR, flags, sizeof(int), 2, fp, nullptr, error);
      MPI_Bcast(flags, 2, MPI_INT, 0, world);
      setflag[i][j] = flags[0];
      law[i][j] = flags[1];
      if (!setflag[i][j]) continue;
      for (double **k : numbers()) {
        if (comm->me == 0) utils::sfread(FLERR, &k[i][j], sizeof(double), 1, fp, nullptr, error);
        MPI_Bcast(&k[i][j], 1, MPI_DOUBLE, 0, world);
      }
    }
}

/* ----------------------------------------------------------------------
   keywords of pair_coeff that say what types i and j have
------------------------------------------------------------------------- */

std::string PairLubcontact::coeff_words(int i, int j, const std::vector<std::string> &without) const
{
  using lubcontact::FrictionLaw;
  auto keeps = [&without](const char *effect) {
    return std::find(without.begin(), without.end(), effect) == without.end();
  };
  auto friction_law = static_cast<FrictionLaw>(law[i][j]);
  if (friction_law > FrictionLaw::COULOMB && !keeps("critical load"))
    friction_law = FrictionLaw::COULOMB;
  if (!keeps("friction")) friction_law = FrictionLaw::NONE;

  std::string words =
      fmt::format("asperity {} roughness {} friction {}", asperity[i][j], roughness[i][j],
                  lubcontact::FRICTION_NAME[static_cast<int>(friction_law)]);
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
