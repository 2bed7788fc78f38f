/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// The background fluid during a run.

#include "background_fluid.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "fix_rheometer_plates.h"
#include "input.h"
#include "modify.h"
#include "pair_lubcontact.h"
#include "suspension_host.h"
#include "update.h"
#include "variable.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

// what fix rheometer/plates calls f_ID[3] and f_ID[4]
static constexpr int GAP_OF_PLATES = 2, VELOCITY_OF_PLATES = 3;

/* ---------------------------------------------------------------------- */

void BackgroundFluid::init()
{
  Suspension_NS::require_spheres(lmp, "Fix " + style);
  Suspension_NS::require_verlet(lmp, "Fix " + style);
  for (const auto &other : modify->get_fix_list())
    if (other->rigid_flag)
      error->all(FLERR, "Fix {} cannot drag the rigid bodies of fix {}", style, other->id);

  if (eta_of_pair && !Suspension_NS::viscosity_of_pair(lmp))
    error->all(FLERR, "Fix {} eta pair: {}; give the viscosity instead of pair", style,
               Suspension_NS::why_no_viscosity(lmp));
  check_number(eta, "viscosity");
  check_number(hindered, "hindrance");
  for (const Suspension_NS::InputNumber &target : number) check_number(target, "flow");
  for (Component &c : component) check_component(c);
  if (isolated) check_isolated();
  if (profile == PLATES) find_plates();
  if (profile == CELL) check_cell();
  own.start(fix->groupbit);
  exclude_plates();
}

/* ---------------------------------------------------------------------- */

void BackgroundFluid::check_number(const Suspension_NS::InputNumber &target, const char *what)
{
  target.check(lmp, style.c_str(), what);
}

/* ----------------------------------------------------------------------
   of velocity and spin: equal-style or atom-style
------------------------------------------------------------------------- */

void BackgroundFluid::check_component(Component &c)
{
  if (c.target.is_number()) return;
  Variable *variables = input->variable;
  const std::string &name = c.target.variable;
  const int found = variables->find(name.c_str());
  if (found < 0) error->all(FLERR, "Variable {} for fix {} velocity does not exist", name, style);
  c.per_atom = variables->atomstyle(found) != 0;
  if (!c.per_atom && !variables->equalstyle(found))
    error->all(FLERR, "Variable {} for fix {} velocity is neither equal- nor atom-style", name,
               style);
}

/* ---------------------------------------------------------------------- */

void BackgroundFluid::find_plates()
{
  plates = dynamic_cast<FixRheometerPlates *>(modify->get_fix_by_id(plates_id));
  if (!plates)
    error->all(FLERR, "Fix {} plates: {} is not the ID of a fix rheometer/plates", style,
               plates_id);
}

void BackgroundFluid::exclude_plates()
{
  for (const auto &other : modify->get_fix_by_style("^rheometer/plates")) {
    const auto *cell = dynamic_cast<FixRheometerPlates *>(other);
    if (!cell) continue;
    own.forbid(cell->plate_bits(), [this, other](const std::string &who) {
      return fmt::format(
          "Fix {} acts on {} of the plates of fix {}, which moves them by itself; use "
          "the group of the particles between the plates",
          style, who, other->id);
    });
  }
}

/* ----------------------------------------------------------------------
   particles that cross the boundary must change their velocity as the flow does. Not by
   domain->deform_flag, which fix deform sets only once the run is set up
------------------------------------------------------------------------- */

void BackgroundFluid::check_cell() const
{
  const auto deform = modify->get_fix_by_style("^deform");
  if (deform.empty())
    error->all(FLERR,
               "Fix {} cell: the cell does not deform; use fix deform or fix "
               "deform/rheometer, or another flow",
               style);
  if (!domain->deform_vremap)
    error->all(FLERR,
               "Fix {} cell needs velocities that follow the cell; add to fix deform: "
               "remap v",
               style);
  if ((fix->groupbit & domain->deform_groupbit) != fix->groupbit && domain->deform_groupbit != 1)
    error->all(FLERR, "Fix {} cell: use group all for fix {}", style, deform[0]->id);
}

/* ---------------------------------------------------------------------- */

void BackgroundFluid::setup()
{
  if (profile == PLATES) plates->measure_surfaces(couette.low, couette.high);
  new_step();
}

/* ----------------------------------------------------------------------
   In each step, since particles come, go and grow. Another order of them rounds the sum differently:
   then it stays as it was, and a continued run is the same
------------------------------------------------------------------------- */

void BackgroundFluid::measure_solid()
{
  double mine = 0.0, all;
  for (int i = 0; i < atom->nlocal; i++)
    mine += Suspension_NS::particle_volume(domain, atom->radius[i]);
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  if (!Suspension_NS::is_same_sum(solid, all)) solid = all;
}

/* ---------------------------------------------------------------------- */

bool BackgroundFluid::has_variables() const
{
  if (!eta.is_number() || !hindered.is_number()) return true;
  for (const Suspension_NS::InputNumber &target : number)
    if (!target.is_number()) return true;
  for (const Component &c : component)
    if (!c.target.is_number()) return true;
  return false;
}

/* ---------------------------------------------------------------------- */

std::string BackgroundFluid::settings_text() const
{
  std::string text;
  for (const std::string &word : utils::split_words(words))
    text += (text.empty() ? "" : " ") +
        (utils::strmatch(word, "^v_") ? fmt::format("{}", value_of(word.substr(2))) : word);
  return text;
}

double BackgroundFluid::value_of(const std::string &variable) const
{
  if (!evaluated)
    error->all(
        FLERR,
        "Suspension_scene measure cannot copy fix {}: variable {} has no value before the first "
        "run; add run 0",
        fix->id, variable);
  for (const Component &c : component)
    if (c.per_atom && c.target.variable == variable)
      error->all(
          FLERR,
          "Suspension_scene measure cannot copy fix {}: variable {} is atom-style; the advice "
          "without the word measure works here, too",
          fix->id, variable);
  std::vector<Suspension_NS::InputNumber> targets = {eta, hindered};
  targets.insert(targets.end(), std::begin(number), std::end(number));
  for (const Component &c : component) targets.push_back(c.target);
  const auto found =
      std::find_if(targets.begin(), targets.end(), [&](const Suspension_NS::InputNumber &t) {
        return t.variable == variable;
      });
  return found->value;
}

/* ---------------------------------------------------------------------- */

void BackgroundFluid::new_step()
{
  evaluated = true;
  const bool variables = has_variables();
  if (variables) modify->clearstep_compute();
  eta.evaluate(lmp);
  const double *of_pair = eta_of_pair ? Suspension_NS::viscosity_of_pair(lmp) : &eta.value;
  if (!of_pair)
    error->all(FLERR, "Fix {} eta pair: {}", style, Suspension_NS::why_no_viscosity(lmp));
  viscosity = *of_pair;
  if (!(viscosity >= 0.0))
    error->all(FLERR, "Fix {} viscosity must be >= 0, but is {} at step {}", style, viscosity,
               update->ntimestep);
  update_profile();
  update_hindrance();
  if (variables) modify->addstep_compute(update->ntimestep + 1);
  if (isolated) count_partners();
}

/* ----------------------------------------------------------------------
   over all sub-styles lubcontact, of which no two may act between the same particles
------------------------------------------------------------------------- */

void BackgroundFluid::check_isolated() const
{
  const auto pairs = PairLubcontact::all(lmp);
  if (pairs.empty())
    error->all(FLERR,
               "Fix {} isolated counts partners in range of pair style lubcontact, which is "
               "not defined",
               style);
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      int styles = 0;
      for (PairLubcontact *pair : pairs)
        if (pair->setflag[i][j]) styles++;
      if (styles > 1)
        error->all(
            FLERR,
            "Fix {} isolated would count the partners of types {} {} {} times, once for each "
            "sub-style lubcontact: give the types one of them",
            style, i, j, styles);
    }
}

void BackgroundFluid::count_partners()
{
  partners.assign(atom->nlocal, 0.0);
  std::vector<double> part;
  for (PairLubcontact *pair : PairLubcontact::all(lmp)) {
    pair->count_partners(part);
    for (int i = 0; i < atom->nlocal; i++) partners[i] += part[i];
  }
}

/* ---------------------------------------------------------------------- */

void BackgroundFluid::update_profile()
{
  for (Suspension_NS::InputNumber &target : number) target.evaluate(lmp);
  if (profile == VELOCITY) update_components();
  if (profile == PLATES) {
    // lower plate at rest; a gap of zero is not yet known
    const double gap = plates->compute_vector(GAP_OF_PLATES);
    if (gap > 0.0) couette.high = couette.low + gap;
    couette.v_high = plates->compute_vector(VELOCITY_OF_PLATES);
  }
  if (profile == COUETTE)
    couette = {number[0].value, number[1].value, number[2].value, number[3].value};
  if (profile == POISEUILLE) poiseuille = {number[0].value, number[1].value, number[2].value};

  const double low = profile == COUETTE ? couette.low : poiseuille.low;
  const double high = profile == COUETTE ? couette.high : poiseuille.high;
  if ((profile == COUETTE || profile == POISEUILLE) && !(high > low))
    error->all(FLERR,
               "Fix {}: the upper wall must be above the lower one at y = {}, but is at {} "
               "at step {}",
               style, low, high, update->ntimestep);
}

/* ---------------------------------------------------------------------- */

void BackgroundFluid::update_components()
{
  for (Component &c : component) {
    if (!c.per_atom) {
      c.target.evaluate(lmp);
      continue;
    }
    if (static_cast<int>(c.value.size()) < atom->nlocal) c.value.resize(atom->nmax);
    input->variable->compute_atom(input->variable->find(c.target.variable.c_str()), fix->igroup,
                                  c.value.data(), 1, 0);
  }
}

/* ---------------------------------------------------------------------- */

void BackgroundFluid::update_hindrance()
{
  hindered.evaluate(lmp);
  double phi = hindered.value;
  if (rule == MEASURED) measure_solid();
  if (rule == MEASURED) phi = solid / Suspension_NS::cell_volume(domain);
  if (rule != CONSTANT && !(phi >= 0.0 && phi < 1.0))
    error->all(FLERR,
               "Fix {} hindrance: the volume fraction must be >= 0 and < 1, but is {} at "
               "step {}",
               style, phi, update->ntimestep);
  if (rule == CONSTANT && !(phi >= 0.0))
    error->all(FLERR, "Fix {} hindrance must be >= 0, but is {} at step {}", style, phi,
               update->ntimestep);
  factor = rule == CONSTANT ? hindered.value : 1.0 / (1.0 - phi);
}

/* ---------------------------------------------------------------------- */

Lubcontact_NS::Flow BackgroundFluid::flow(int i) const
{
  using namespace Lubcontact_NS;
  const double *x = atom->x[i];
  switch (profile) {
    case SHEAR:
      return shear_flow(number[0].value, x[1]);
    case PLATES:
    case COUETTE:
      return couette_flow(couette, x[1]);
    case POISEUILLE:
      return poiseuille_flow(poiseuille, x[1]);
    case CELL: {
      const double *lo = domain->boxlo, *rate = domain->h_ratelo;
      return cell_flow(domain->h_rate, domain->h_inv, {x[0], x[1], x[2]}, {lo[0], lo[1], lo[2]},
                       {rate[0], rate[1], rate[2]});
    }
    case VELOCITY: {
      double u[6];
      for (int n = 0; n < 6; n++) {
        const Component &c = component[n];
        u[n] = c.per_atom ? c.value[i] : c.target.value;
      }
      return {{u[0], u[1], u[2]}, {u[3], u[4], u[5]}};
    }
    default:
      return {};
  }
}

/* ---------------------------------------------------------------------- */

Lubcontact_NS::Drag BackgroundFluid::drag(int i) const
{
  if (isolated && partners[i] >= isolated) return {};
  return Lubcontact_NS::drag(body, factor * viscosity, atom->radius[i]);
}

/* ---------------------------------------------------------------------- */

double BackgroundFluid::memory_usage() const
{
  double bytes = sizeof(double) * partners.capacity();
  for (const Component &c : component) bytes += sizeof(double) * c.value.capacity();
  return bytes;
}
