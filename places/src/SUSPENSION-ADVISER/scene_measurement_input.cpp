/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Arguments of suspension_scene measure.

#include "scene_measurement.h"

#include "error.h"
#include "scene_laws.h"
#include "suspension_input.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

SceneMeasurement::Options SceneMeasurement::parse(int narg, char **arg) const
{
  Suspension_NS::require_words(FLERR, error, "suspension_scene", narg, "measure N ...");
  Options options;
  if (!utils::is_integer(arg[1]))
    error->all(FLERR, 1, "Suspension_scene measure needs a number of steps before keywords, not {}",
               arg[1]);
  options.nsteps = utils::inumeric(FLERR, arg[1], false, lmp);
  if (options.nsteps < BLOCKS || options.nsteps % BLOCKS)
    error->all(FLERR, 1,
               "Suspension_scene measure takes a number of steps that is a multiple of {}, but not "
               "{}",
               BLOCKS, arg[1]);
  Scene_NS::SurfaceLaws &laws = options.laws;
  const struct {
    const char *name, *usage;
    std::vector<double *> values;
  } keywords[] = {{"change", "change f", {&options.limit}},
                  {"friction", "friction mu", {&laws.friction}},
                  {"critical", "critical F", {&laws.critical}},
                  {"adhesion", "adhesion F", {&laws.pull_off}},
                  {"repulsion", "repulsion F0 lambda", {&laws.repulsion, &laws.screening}}};
  int places[std::size(keywords)] = {};
  for (int iarg = 2; iarg < narg;) {
    const auto *found = std::find_if(std::begin(keywords), std::end(keywords), [&](const auto &k) {
      return strcmp(arg[iarg], k.name) == 0;
    });
    if (found == std::end(keywords))
      error->all(FLERR, iarg,
                 "Unknown suspension_scene measure keyword: {}; those that exist: change, "
                 "friction, critical, adhesion, repulsion",
                 arg[iarg]);
    places[found - keywords] = iarg;
    const int count = static_cast<int>(found->values.size());
    Suspension_NS::require_words(FLERR, error, "suspension_scene measure", narg - iarg,
                                 found->usage);
    for (int n = 1; n <= count; n++) {
      const double value = utils::numeric(FLERR, arg[iarg + n], false, lmp);
      if (!(value > 0.0))
        error->all(FLERR, iarg + n, "Suspension_scene measure {} must be > 0, but is {}", arg[iarg],
                   arg[iarg + n]);
      *found->values[n - 1] = value;
    }
    iarg += 1 + count;
  }
  options.critical_word = places[2];
  options.adhesion_word = places[3];
  return options;
}

/* ---------------------------------------------------------------------- */

void SceneMeasurement::check_laws(const Options &options, const Lubcontact_NS::Law &law) const
{
  if (options.critical_word && std::isnan(options.laws.friction) &&
      !uses(law, Lubcontact_NS::FRICTION))
    error->all(FLERR, options.critical_word,
               "Suspension_scene measure critical cannot act without friction: give friction mu, "
               "too");
  if (!options.adhesion_word) return;
  Scene_NS::each_pair(law, [&](int i, int j, const Lubcontact_NS::TypeCoeffs &c) {
    if (c.roughness_a == 0.0)
      error->all(FLERR, options.adhesion_word,
                 "Suspension_scene measure adhesion acts between asperities, but types {} {} have "
                 "none: give them a roughness > 0",
                 i, j);
  });
}
