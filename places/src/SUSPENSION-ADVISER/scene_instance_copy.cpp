/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// What a copy of a suspension has of the original: pair style, fixes, histories.

#include "scene_instance.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_deform_rheometer.h"
#include "fix_neigh_history_lubcontact.h"
#include "force.h"
#include "group.h"
#include "irregular.h"
#include "lubcontact_pairs.h"
#include "lubcontact_type_coeffs.h"
#include "modify.h"
#include "pair_lubcontact.h"
#include "scene_history.h"
#include "scene_laws.h"

#include <cmath>
#include <cstdio>
#include <memory>
#include <unordered_map>

using namespace LAMMPS_NS;

namespace {

using File = std::unique_ptr<FILE, int (*)(FILE *)>;

File scratch(LAMMPS *lmp)
{
  File file(lmp->comm->me == 0 ? tmpfile() : nullptr, [](FILE *fp) {
    return fp ? fclose(fp) : 0;
  });
  if (lmp->comm->me == 0 && !file)
    lmp->error->one(FLERR, "Suspension_scene cannot make a temporary file: {}",
                    utils::getsyserror());
  return file;
}

struct Sphere {
  int type;
  double radius, x[3];
};

// of all ranks, by ID: a partner may be anywhere, and between runs ghosts need not be there
std::unordered_map<tagint, Sphere> all_spheres(LAMMPS *lmp)
{
  enum { ID, TYPE, RADIUS, X, SIZE = X + 3 };
  const Atom *atom = lmp->atom;
  const int ranks = lmp->comm->nprocs;
  std::vector<double> mine;
  for (int i = 0; i < atom->nlocal; i++) {
    const double row[] = {ubuf(atom->tag[i]).d, static_cast<double>(atom->type[i]),
                          atom->radius[i],      atom->x[i][0],
                          atom->x[i][1],        atom->x[i][2]};
    mine.insert(mine.end(), std::begin(row), std::end(row));
  }
  const int length = static_cast<int>(mine.size());
  std::vector<int> lengths(ranks), starts(ranks, 0);
  MPI_Allgather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, lmp->world);
  for (int n = 1; n < ranks; n++) starts[n] = starts[n - 1] + lengths[n - 1];
  std::vector<double> all(starts.back() + lengths.back());
  MPI_Allgatherv(mine.data(), length, MPI_DOUBLE, all.data(), lengths.data(), starts.data(),
                 MPI_DOUBLE, lmp->world);

  std::unordered_map<tagint, Sphere> spheres;
  for (std::size_t n = 0; n < all.size(); n += SIZE) {
    const double *row = &all[n];
    spheres[static_cast<tagint>(ubuf(row[ID]).i)] = {
        static_cast<int>(row[TYPE]), row[RADIUS], {row[X], row[X + 1], row[X + 2]}};
  }
  return spheres;
}

}    // namespace

/* ----------------------------------------------------------------------
   the viscosity as a number, whatever it comes from
------------------------------------------------------------------------- */

void SceneInstance::adopt_law(const Lubcontact_NS::Law &law) const
{
  one("pair_style lubcontact " +
      style_words(law.settings, fmt::format("{}", law.settings.viscosity)));
  dynamic_cast<PairLubcontact *>(lmp->force->pair)->adopt(law);
}

/* ---------------------------------------------------------------------- */

void SceneInstance::copy_fixes(const Parts &parts, const Fluids &fluids) const
{
  for (const Parts::Part &part : parts.fixes) {
    Fix *fix = part.fix;
    const bool drag = background_of(fix) != nullptr, pores = fix == parts.pores;
    const bool far = fix == parts.far;    // which finds its loads anew
    if ((drag && !fluids.drag) || (pores && !fluids.pores) || (far && !fluids.far)) continue;
    one(fmt::format("fix {} {} {} {}", fix->id, original->group->names[fix->igroup], fix->style,
                    part.settings));
    if (drag || pores || dynamic_cast<FixDeformRheometer *>(fix)) copy_state(fix);
  }
}

/* ----------------------------------------------------------------------
   what a fix writes to restart files
------------------------------------------------------------------------- */

void SceneInstance::copy_state(Fix *fix) const
{
  const File file = scratch(original);
  fix->write_restart(file.get());
  int size = 0;
  std::vector<char> state;
  auto read = [&](void *to, std::size_t length) {
    if (file) utils::sfread(FLERR, to, 1, length, file.get(), nullptr, original->error);
    MPI_Bcast(to, static_cast<int>(length), MPI_CHAR, 0, original->world);
  };
  if (file) rewind(file.get());
  read(&size, sizeof(int));
  state.resize(size);
  read(state.data(), size);
  lmp->modify->get_fix_by_id(fix->id)->restart(state.data());
}

/* ----------------------------------------------------------------------
   between runs the history of a pair is kept with both particles
------------------------------------------------------------------------- */

void SceneInstance::copy_history(const PairLubcontact *from, const Lubcontact_NS::Law &law)
{
  const auto *to = dynamic_cast<PairLubcontact *>(lmp->force->pair);
  FixNeighHistoryLubcontact *source = from->neighbors().history().carrier();
  FixNeighHistoryLubcontact *target = to->neighbors().history().carrier();
  if (!target) return;
  history_kept = source != nullptr;
  if (!source) return;

  const Atom *atom = original->atom;
  const auto spheres = all_spheres(original);
  const auto names = source->present_ids();
  const int size = source->get_dnum(), new_size = target->get_dnum();
  std::vector<double> all, adopted;
  for (int i = 0; i < atom->nlocal; i++) {
    // number of partners, then ID and values of each
    all.resize(1 + (1 + size) * (source->get_maxpartner() + 2));
    source->pack_exchange(i, all.data());
    adopted.assign(1, 0.0);
    const int partners = static_cast<int>(all[0]);
    for (int n = 0; n < partners; n++) {
      const double *record = &all[1 + n * (1 + size)];
      const auto name = names.find(static_cast<tagint>(ubuf(record[0]).i));
      if (name == names.end()) continue;    // it is gone
      const Sphere &partner = spheres.at(name->second);
      double near[3];
      original->domain->closest_image(atom->x[i], partner.x, near);
      const double d[3] = {atom->x[i][0] - near[0], atom->x[i][1] - near[1],
                           atom->x[i][2] - near[2]};
      const double r = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
      adopted[0] += 1.0;
      adopted.push_back(ubuf(name->second).d);
      adopted.resize(adopted.size() + new_size);
      const auto c = Scene_NS::coeffs_between(law, atom->type[i], partner.type);
      const double ri = atom->radius[i], rj = partner.radius;
      Scene_NS::adopt_history(from->effects(), to->effects(), pair_coeffs(law.settings, c).normal,
                              effective_radius(law.settings.radius, ri, rj), r - ri - rj,
                              record + 1, adopted.data() + adopted.size() - new_size);
    }
    target->adopt(i, adopted);
  }
}

/* ----------------------------------------------------------------------
   to the ranks that own their places here
------------------------------------------------------------------------- */

void SceneInstance::migrate() const
{
  Domain *domain = lmp->domain;
  const bool lamda = domain->triclinic;
  if (lamda) domain->x2lamda(lmp->atom->nlocal);
  domain->pbc();
  domain->reset_box();
  Irregular(lmp).migrate_atoms();
  if (lamda) domain->lamda2x(lmp->atom->nlocal);
}
