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
#include "modify.h"
#include "pair_lubcontact.h"
#include "suspension_host.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

void BackgroundFluid::init()
{
  Suspension_NS::require_spheres(lmp, "Fix " + style);
  Suspension_NS::require_verlet(lmp, "Fix " + style);
  for (const auto &other : modify->get_fix_list())
    if (other->rigid_flag)
      error->all(FLERR, "Fix {} cannot drag the rigid bodies of fix {}", style, other->id);

  if (!elsewhere) {
    find_viscosity();
    eta.check(lmp, style.c_str(), "viscosity");
    rule->init();
    others.check(lmp, style.c_str(), "others");
    flow->init();
    if (isolated) check_isolated();
  }
  own.start(fix->groupbit);
  exclude_plates();
}

/* ---------------------------------------------------------------------- */

const double *BackgroundFluid::find_viscosity() const
{
  const double *found = eta_of_pair ? Suspension_NS::viscosity_of_pair(lmp) : &eta.value;
  if (!found)
    error->all(FLERR, "Fix {} {} pair: {}; give the viscosity instead of pair", style, eta_word,
               Suspension_NS::why_no_viscosity(lmp));
  return found;
}

/* ---------------------------------------------------------------------- */

void BackgroundFluid::exclude_plates()
{
  for (const auto &other : modify->get_fix_by_style("^rheometer/plates")) {
    const auto *cell = dynamic_cast<FixRheometerPlates *>(other);
    if (!cell) continue;
    own.forbid(cell->plate_bits(), [this, other](const std::string &who) {
      return fmt::format(
          "Fix {} acts on {} of the plates of fix {}, which are moved by that fix; use "
          "the group of the particles between the plates",
          style, who, other->id);
    });
  }
}

/* ---------------------------------------------------------------------- */

void BackgroundFluid::setup()
{
  flow->setup();
  new_step();
}

/* ---------------------------------------------------------------------- */

bool BackgroundFluid::has_variables() const
{
  return !eta.is_number() || !rule->number().is_number() || !others.is_number() ||
      flow->has_variables();
}

/* ---------------------------------------------------------------------- */

std::string BackgroundFluid::settings_text() const
{
  std::string text;
  for (const std::string &word : utils::split_words(words))
    text += (text.empty() ? "" : " ") +
        (utils::strmatch(word, "^v_") ? value_of(word.substr(2)) : word);
  return text;
}

std::string BackgroundFluid::value_of(const std::string &variable) const
{
  if (!evaluated)
    error->all(
        FLERR,
        "Suspension_scene measure cannot copy fix {}: variable {} has no value before the first "
        "run; add run 0",
        fix->id, variable);
  if (flow->is_per_atom(variable))
    error->all(FLERR,
               "Suspension_scene measure cannot copy fix {}: variable {} is atom-style; "
               "suspension_scene without measure works",
               fix->id, variable);
  std::vector<Suspension_NS::InputNumber> numbers = flow->numbers();
  numbers.push_back(eta);
  numbers.push_back(rule->number());
  numbers.push_back(others);
  const auto found = std::find_if(numbers.begin(), numbers.end(), [&](const auto &number) {
    return number.variable == variable;
  });
  return fmt::format("{}", found->value);
}

/* ---------------------------------------------------------------------- */

void BackgroundFluid::new_step()
{
  evaluate();
  if (isolated) count_partners();
}

void BackgroundFluid::evaluate()
{
  evaluated = true;
  const bool variables = has_variables();
  if (variables) modify->clearstep_compute();
  eta.evaluate(lmp);
  viscosity = *find_viscosity();
  if (!(viscosity >= 0.0) || (needs_viscosity && viscosity == 0.0))
    error->all(FLERR, "Fix {} viscosity must be {} 0, but is {} at step {}", style,
               needs_viscosity ? ">" : ">=", viscosity, update->ntimestep);
  flow->new_step();
  rule->new_step();
  others.evaluate(lmp);
  if (!(others.value >= 0.0))
    error->all(FLERR, "Fix {} others must be >= 0, but is {} at step {}", style, others.value,
               update->ntimestep);
  if (variables) modify->addstep_compute(update->ntimestep + 1);
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
            "sub-style lubcontact: assign these types to one sub-style only",
            style, i, j, styles);
    }
}

void BackgroundFluid::count_partners()
{
  const auto pairs = PairLubcontact::all(lmp);
  partners = &pairs.front()->count_partners();
  if (pairs.size() == 1) return;
  of_all_styles.assign(partners->begin(), partners->begin() + atom->nlocal);
  for (std::size_t n = 1; n < pairs.size(); n++) {
    const std::vector<double> &part = pairs[n]->count_partners();
    for (int i = 0; i < atom->nlocal; i++) of_all_styles[i] += part[i];
  }
  partners = &of_all_styles;
}

/* ---------------------------------------------------------------------- */

Fluid_NS::Drag BackgroundFluid::drag(int i) const
{
  const double full = rule->factor() * viscosity;
  if (is_isolated(i)) return Fluid_NS::drag(body, full, atom->radius[i]);
  if (others.value == 0.0) return {};
  return Fluid_NS::drag(body, others.value * full, atom->radius[i]);
}

/* ---------------------------------------------------------------------- */

double BackgroundFluid::memory_usage() const
{
  return sizeof(double) * of_all_styles.capacity() + flow->memory_usage();
}
