/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "suspension_scene.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "scene_adviser.h"
#include "scene_measurement.h"
#include "suspension_host.h"

#include <cstring>

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   suspension_scene brief keyword value ... | suspension_scene measure N keyword value ...
------------------------------------------------------------------------- */

void SuspensionScene::command(int narg, char **arg)
{
  if (!domain->box_exist || atom->natoms == 0)
    error->all(FLERR, "Suspension_scene needs particles: use it after they are created");
  Suspension_NS::require_spheres(lmp, "Suspension_scene");
  if (Suspension_NS::measure_particles(lmp).number == 0.0)
    error->all(FLERR, "Suspension_scene: no particle has a radius");
  const bool measure = narg > 0 && strcmp(arg[0], "measure") == 0;
  const std::string text = measure ? SceneMeasurement(lmp).advice(narg, arg)
                                   : SceneAdviser(lmp).advice(narg, arg);
  if (comm->me == 0) utils::logmesg(lmp, text);
}
