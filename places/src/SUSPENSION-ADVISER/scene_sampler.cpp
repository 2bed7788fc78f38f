/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "scene_sampler.h"

#include "compute.h"
#include "fix_deform_rheometer.h"
#include "modify.h"
#include "scene_instance.h"
#include "update.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

SceneSampler::SceneSampler(const SceneInstance &copy, const Fix *flow, int every) : interval(every)
{
  Modify *modify = copy.lmp->modify;
  std::string values;
  int size = 0;
  auto watch = [&](const std::string &what, std::vector<int> &where) {
    copy.one(fmt::format("variable scene_{} equal {}", size, what));
    values += fmt::format(" v_scene_{}", size);
    where.push_back(size++);
  };
  copy.one("compute scene_stress all stress/partition");
  const int rows = modify->get_compute_by_id("scene_stress")->size_array_rows;
  for (int row = 1; row <= rows; row++) {
    watch(fmt::format("c_scene_stress[{}][4]", row), sxy);
    watch(fmt::format("c_scene_stress[{}][2]", row), syy);
  }
  if (modify->compute_map->count("power/partition")) {
    copy.one("compute scene_power all power/partition");
    const int channels = modify->get_compute_by_id("scene_power")->size_array_rows;
    for (int row = 1; row <= channels; row++)
      watch(fmt::format("c_scene_power[{}][1]", row), power);
  }
  if (utils::strmatch(flow->style, "^deform/rheometer")) {
    using Output = FixDeformRheometer::Output;
    watch(fmt::format("f_{}[{}]", flow->id, 1 + Output::RATE), rate);
    watch(fmt::format("f_{}[{}]", flow->id, 1 + Output::PHI), phi);
  }
  copy.one(fmt::format("fix scene_samples all vector {}{}", every, values));
  samples = modify->get_fix_by_id("scene_samples");
  const bigint now = copy.lmp->update->ntimestep;
  first = (now + every - 1) / every * every;
}

/* ---------------------------------------------------------------------- */

std::vector<double> SceneSampler::mean(bigint from, bigint end,
                                       const std::vector<int> &columns) const
{
  std::vector<double> means(columns.size(), 0.0);
  const int begin = static_cast<int>((from - first) / interval + (from >= first ? 1 : 0));
  const int stop = static_cast<int>((end - first) / interval + 1);
  for (int n = begin; n < stop; n++)
    for (std::size_t m = 0; m < columns.size(); m++)
      means[m] += samples->compute_array(n, columns[m]) / (stop - begin);
  return means;
}
