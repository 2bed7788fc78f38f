/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "scene_instance.h"

#include "atom.h"
#include "atom_vec.h"
#include "background_fluid.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_deform_rheometer.h"
#include "fix_drag_background.h"
#include "fix_hydro.h"
#include "fix_nve_sphere.h"
#include "fix_overdamped_sphere.h"
#include "fix_pore_pressure.h"
#include "force.h"
#include "group.h"
#include "input.h"
#include "modify.h"
#include "neighbor.h"
#include "pair_lubcontact.h"
#include "scene_plugins.h"
#include "update.h"

using namespace LAMMPS_NS;

namespace {

// a member of LAMMPS' own fixes that is protected
struct Inertia : FixNVESphere {
  static bool of_disc(FixNVESphere *fix) { return fix->*(&Inertia::inertia) == 0.5; }
};

struct Deformation : FixDeform {
  static bool only_tilts(FixDeform *fix)
  {
    const auto *set = fix->*(&Deformation::set);
    for (int n = 0; n < 5; n++)
      if (set[n].style != NONE) return false;
    return set[5].style != NONE && fix->remapflag == Domain::V_REMAP;
  }
  static double rate(FixDeform *fix, const Domain *domain)
  {
    const auto &tilt = (fix->*(&Deformation::set))[5];
    if (tilt.style == ERATE || tilt.style == ERATERS) return tilt.rate;
    return (tilt.style == VEL ? tilt.vel : domain->h_rate[5]) / domain->yprd;
  }
};

// fixes that only watch
bool watches(const Fix *fix, int mask)
{
  for (const char *name : {"^NEIGH_HISTORY", "^DUMMY", "^ave/", "^print", "^vector", "^store/",
                           "^STORE", "^GROUP", "^property/atom", "^balance", "^halt"})
    if (utils::strmatch(fix->style, name)) return true;
  return mask == 0;
}

}    // namespace

/* ----------------------------------------------------------------------
   of fix deform; 0 without it, or if only a run will tell
------------------------------------------------------------------------- */

double SceneInstance::deform_rate(LAMMPS *lmp)
{
  for (const auto &fix : lmp->modify->get_fix_by_style("^deform$"))
    return Deformation::rate(dynamic_cast<FixDeform *>(fix), lmp->domain);
  return 0.0;
}

/* ---------------------------------------------------------------------- */

const BackgroundFluid *SceneInstance::background_of(const Fix *fix)
{
  if (const auto *drag = dynamic_cast<const FixDragBackground *>(fix)) return &drag->background();
  const auto *overdamped = dynamic_cast<const FixOverdampedSphere *>(fix);
  return overdamped ? &overdamped->background() : nullptr;
}

/* ----------------------------------------------------------------------
   with a fix that can be copied; false: it cannot
------------------------------------------------------------------------- */

static bool copy_part(LAMMPS *lmp, Fix *fix, SceneInstance::Parts &parts)
{
  std::string settings;
  auto *sphere = utils::strmatch(fix->style, "^nve/sphere") ? dynamic_cast<FixNVESphere *>(fix)
                                                            : nullptr;
  auto *deform = dynamic_cast<FixDeform *>(fix);
  const auto *rheometer = dynamic_cast<FixDeformRheometer *>(fix);
  const auto *pores = dynamic_cast<FixPorePressure *>(fix);
  const auto *far = dynamic_cast<FixHydro *>(fix);
  const BackgroundFluid *fluid = SceneInstance::background_of(fix);
  if (pores) {
    settings = pores->settings_text();
    parts.pores = fix;
  } else if (far) {
    settings = far->settings_text();
    parts.far = fix;
  } else if (fluid) {
    settings = fluid->settings_text();
    parts.drags.push_back(fix);
    if (utils::strmatch(fix->style, "^overdamped")) parts.overdamped = true;
  } else if (sphere) {
    if (Inertia::of_disc(sphere)) settings = "disc";
  } else if (rheometer) {
    settings = rheometer->settings_text();
    parts.flow = fix;
    const auto imposed = rheometer->imposed();
    if (!imposed.steady_shear)
      lmp->error->all(FLERR,
                      "Suspension_scene measure compares the viscosity of steady shear, but fix {} "
                      "has: {}; {}",
                      fix->id, settings, SceneInstance::CURE);
    parts.holds_rate = imposed.holds_rate;
    parts.holds_pressure = imposed.holds_pressure;
  } else if (utils::strmatch(fix->style, "^deform$") && Deformation::only_tilts(deform)) {
    parts.flow = fix;
    parts.rate = SceneInstance::deform_rate(lmp);
    if (parts.rate == 0.0)
      lmp->error->all(FLERR,
                      "Suspension_scene measure does not know the rate of fix {} before the first "
                      "run: add run 0",
                      fix->id);
    settings = fmt::format("{} xy erate {} remap v", fix->nevery, parts.rate);
  } else if (!utils::strmatch(fix->style, "^enforce2d$")) {
    return false;
  }
  parts.fixes.push_back({fix, settings});
  return true;
}

/* ---------------------------------------------------------------------- */

SceneInstance::Parts SceneInstance::parts_of(LAMMPS *lmp)
{
  Error *error = lmp->error;
  if (!lmp->domain->box_exist || lmp->atom->natoms == 0)
    error->all(FLERR, "Suspension_scene needs particles: use it after they are created");

  Parts parts;
  parts.pair = dynamic_cast<PairLubcontact *>(lmp->force->pair);
  if (!parts.pair)
    error->all(FLERR,
               "Suspension_scene measure needs pair_style lubcontact alone, but the pair style is "
               "{}; {}",
               lmp->force->pair_style ? lmp->force->pair_style : "none", CURE);
  check_system(lmp);

  const auto &fixes = lmp->modify->get_fix_list();
  for (std::size_t n = 0; n < fixes.size(); n++) {
    Fix *fix = fixes[n];
    const bool copied = copy_part(lmp, fix, parts);
    if (copied && lmp->group->dynamic[fix->igroup])
      error->all(FLERR, "Suspension_scene measure cannot copy the dynamic group {} of fix {}; {}",
                 lmp->group->names[fix->igroup], fix->id, CURE);
    if (utils::strmatch(fix->style, "^rheometer/plates"))
      error->all(FLERR,
                 "Suspension_scene measure works in periodic cells and cannot copy the plates of "
                 "fix {}; {}",
                 fix->id, CURE);
    if (!copied && !watches(fix, lmp->modify->fmask[n]))
      error->all(FLERR,
                 "Suspension_scene measure supports only sheared suspensions without other forces "
                 "and cannot copy fix {} of style {}: unfix it if it does not matter; {}",
                 fix->id, fix->style, CURE);
  }
  if (!parts.flow)
    error->all(FLERR,
               "Suspension_scene measure needs a flow: fix deform/rheometer, or fix deform of xy "
               "with remap v; {}",
               CURE);
  return parts;
}

/* ---------------------------------------------------------------------- */

SceneInstance::SceneInstance(LAMMPS *from, const Parts &parts, const Lubcontact_NS::Law &law,
                             const Fluids &fluids) :
    lmp(nullptr),
    history_kept(true), original(from)
{
  const char *words[] = {"lmp", "-log", "none", "-screen", "none", "-nocite"};
  lmp = new LAMMPS(6, const_cast<char **>(words), from->world);
  try {
    // what plugins have brought
    *lmp->force->pair_map = *from->force->pair_map;
    *lmp->modify->fix_map = *from->modify->fix_map;
    *lmp->modify->compute_map = *from->modify->compute_map;

    set_up();
    copy_box();
    copy_neighbor_style();
    copy_atoms();
    adopt_law(law);
    copy_fixes(parts, fluids);
    lmp->init();
    copy_history(parts.pair, law);
    migrate();
  } catch (...) {
    KeepPlugins keep(original);
    delete lmp;
    throw;
  }
}

/* ---------------------------------------------------------------------- */

SceneInstance::~SceneInstance()
{
  KeepPlugins keep(original);
  delete lmp;
}

/* ---------------------------------------------------------------------- */

void SceneInstance::one(const std::string &command) const
{
  lmp->input->one(command);
}

/* ---------------------------------------------------------------------- */

void SceneInstance::set_up() const
{
  const Comm *comm = original->comm;
  const Neighbor *neighbor = original->neighbor;
  auto on = [](int flag) {
    return flag ? "on" : "off";
  };
  char boundary[9];
  original->domain->boundary_string(boundary);
  one(fmt::format("units {}", original->update->unit_style));
  one(fmt::format("dimension {}", original->domain->dimension));
  one(fmt::format("newton {} off", on(original->force->newton_pair)));
  one(fmt::format("boundary {}", boundary));
  one(fmt::format("processors {} {} {}", comm->procgrid[0], comm->procgrid[1], comm->procgrid[2]));
  one("atom_style sphere");
  one(fmt::format("atom_modify map {}",
                  original->atom->map_style == Atom::MAP_HASH ? "hash" : "array"));
  one("comm_modify vel yes");
  if (comm->mode == Comm::SINGLE && comm->cutghostuser > 0.0)
    one(fmt::format("comm_modify cutoff {}", comm->cutghostuser));
  one(fmt::format("neigh_modify every {} delay {} check {} page {} one {}", neighbor->every,
                  neighbor->delay, neighbor->dist_check ? "yes" : "no", neighbor->pgsize,
                  neighbor->oneatom));
  one(fmt::format("timestep {}", original->update->dt));
  lmp->update->ntimestep = original->update->ntimestep;    // servos act in steps of their own
}

/* ----------------------------------------------------------------------
   as read_restart does
------------------------------------------------------------------------- */

void SceneInstance::copy_box() const
{
  const Domain *from = original->domain;
  Domain *to = lmp->domain;
  for (int d = 0; d < 3; d++) {
    to->boxlo[d] = from->boxlo[d];
    to->boxhi[d] = from->boxhi[d];
  }
  to->triclinic = from->triclinic;
  to->xy = from->xy;
  to->xz = from->xz;
  to->yz = from->yz;
  to->box_exist = 1;
  lmp->atom->ntypes = original->atom->ntypes;
  lmp->atom->allocate_type_arrays();
  lmp->atom->deallocate_topology();
  lmp->atom->avec->grow(static_cast<int>(lmp->atom->avec->roundup(original->atom->nlocal + 1)));
  to->set_initial_box(0);
  to->minxlo = from->minxlo;    // of shrinking sides that keep a minimum
  to->minxhi = from->minxhi;
  to->minylo = from->minylo;
  to->minyhi = from->minyhi;
  to->minzlo = from->minzlo;
  to->minzhi = from->minzhi;
  to->set_global_box();
  lmp->comm->set_proc_grid();
  to->set_local_box();
}

/* ----------------------------------------------------------------------
   how they are made; of style multi also which types or sizes share one, and how far its ghosts
   reach. Style multi counts the types of the box
------------------------------------------------------------------------- */

void SceneInstance::copy_neighbor_style() const
{
  const Neighbor *neighbor = original->neighbor;
  const Comm *comm = original->comm;
  one(fmt::format("neighbor {} {}", neighbor->skin,
                  neighbor->style == Neighbor::MULTI     ? "multi"
                      : neighbor->style == Neighbor::BIN ? "bin"
                                                         : "nsq"));
  if (neighbor->style == Neighbor::MULTI && neighbor->custom_collection_flag) {
    const bool by_size = neighbor->interval_collection_flag;
    std::string words;
    for (int m = 0; m < neighbor->ncollections; m++) {
      std::string types;
      for (int i = 1; i <= original->atom->ntypes && !by_size; i++)
        if (neighbor->type2collection[i] == m)
          types += fmt::format("{}{}", types.empty() ? "" : ",", i);
      words += by_size ? fmt::format(" {}", neighbor->collection2cut[m]) : " " + types;
    }
    one(fmt::format("neigh_modify collection/{} {}{}", by_size ? "interval" : "type",
                    neighbor->ncollections, words));
  }
  if (comm->mode != Comm::MULTI) return;
  one("comm_modify mode multi");
  for (int m = 0; comm->cutusermulti && m < comm->ncollections_cutoff; m++)
    if (comm->cutusermulti[m] > 0.0)
      one(fmt::format("comm_modify cutoff/multi {} {}", m + 1, comm->cutusermulti[m]));
}

/* ----------------------------------------------------------------------
   the particles of each rank, in their order
------------------------------------------------------------------------- */

void SceneInstance::copy_atoms() const
{
  const Atom *from = original->atom;
  Atom *to = lmp->atom;
  std::vector<std::pair<int, int>> bits;
  for (int n = 0; n < 32; n++)
    if (const char *name = original->group->names[n])
      bits.emplace_back(original->group->bitmask[n],
                        lmp->group->bitmask[lmp->group->find_or_create(name)]);

  for (int i = 0; i < from->nlocal; i++) {
    to->avec->create_atom(from->type[i], from->x[i]);
    to->tag[i] = from->tag[i];
    to->image[i] = from->image[i];
    to->radius[i] = from->radius[i];
    to->rmass[i] = from->rmass[i];
    for (int d = 0; d < 3; d++) {
      to->v[i][d] = from->v[i][d];
      to->omega[i][d] = from->omega[i][d];
    }
    to->mask[i] = 0;
    for (const auto &bit : bits)
      if (from->mask[i] & bit.first) to->mask[i] |= bit.second;
  }
  to->natoms = from->natoms;
  to->map_init();
  to->map_set();
}
