/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "background_flow.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "fix_rheometer_plates.h"
#include "input.h"
#include "modify.h"
#include "update.h"
#include "variable.h"

#include <algorithm>
#include <array>

using namespace LAMMPS_NS;
using Fluid_NS::Flow;
using Suspension_NS::InputNumber;

/* ---------------------------------------------------------------------- */

BackgroundFlow::BackgroundFlow(LAMMPS *lmp, const Words &words, int count) :
    Pointers(lmp), fix(words.fix)
{
  for (int n = 0; n < count; n++) number.emplace_back(lmp, words.arg[words.iarg + 1 + n]);
}

void BackgroundFlow::init()
{
  for (const InputNumber &value : number) value.check(lmp, fix->style, "flow");
}

void BackgroundFlow::new_step()
{
  for (InputNumber &value : number) value.evaluate(lmp);
}

bool BackgroundFlow::has_variables() const
{
  return std::any_of(number.begin(), number.end(), [](const InputNumber &value) {
    return !value.is_number();
  });
}

/* ---------------------------------------------------------------------- */

namespace {

using Words = BackgroundFlow::Words;

class RestFlow : public BackgroundFlow {
 public:
  RestFlow(LAMMPS *lmp, const Words &words) : BackgroundFlow(lmp, words, 0) {}
  Flow at(int /*i*/) const override { return {}; }
};

/* ---------------------------------------------------------------------- */

class ShearFlow : public BackgroundFlow {
 public:
  ShearFlow(LAMMPS *lmp, const Words &words) : BackgroundFlow(lmp, words, 1) {}
  Flow at(int i) const override { return Fluid_NS::shear_flow(number[0].value, atom->x[i][1]); }
};

/* ----------------------------------------------------------------------
   particles that cross the boundary must change their velocity as the flow does. Not by
   domain->deform_flag, which fix deform sets only once the run is set up
------------------------------------------------------------------------- */

class CellFlow : public BackgroundFlow {
 public:
  CellFlow(LAMMPS *lmp, const Words &words) : BackgroundFlow(lmp, words, 0) {}

  void init() override
  {
    const auto deform = modify->get_fix_by_style("^deform");
    if (deform.empty())
      error->all(FLERR,
                 "Fix {} cell: the cell does not deform; use fix deform or fix "
                 "deform/rheometer, or another flow",
                 fix->style);
    if (!domain->deform_vremap)
      error->all(FLERR,
                 "Fix {} cell needs velocities that follow the cell; add to fix deform: "
                 "remap v",
                 fix->style);
    if ((fix->groupbit & domain->deform_groupbit) != fix->groupbit && domain->deform_groupbit != 1)
      error->all(FLERR, "Fix {} cell: use group all for fix {}", fix->style, deform[0]->id);
  }

  Flow at(int i) const override
  {
    const double *x = atom->x[i], *lo = domain->boxlo, *rate = domain->h_ratelo;
    return Fluid_NS::cell_flow(domain->h_rate, domain->h_inv, {x[0], x[1], x[2]},
                               {lo[0], lo[1], lo[2]}, {rate[0], rate[1], rate[2]});
  }
};

/* ---------------------------------------------------------------------- */

class CellOrRest : public CellFlow {
 public:
  using CellFlow::CellFlow;

  void init() override
  {
    deforms = !modify->get_fix_by_style("^deform").empty();
    if (deforms) CellFlow::init();
  }
  Flow at(int i) const override { return deforms ? CellFlow::at(i) : Flow{}; }

 private:
  bool deforms = false;
};

/* ---------------------------------------------------------------------- */

class PlatesFlow : public BackgroundFlow {
 public:
  PlatesFlow(LAMMPS *lmp, const Words &words) :
      BackgroundFlow(lmp, words, 0), id(words.arg[words.iarg + 1])
  {
  }

  void init() override
  {
    plates = dynamic_cast<FixRheometerPlates *>(modify->get_fix_by_id(id));
    if (!plates)
      error->all(FLERR, "Fix {} plates: {} is not the ID of a fix rheometer/plates", fix->style,
                 id);
  }

  void setup() override { plates->measure_surfaces(between.low, between.high); }

  void new_step() override
  {
    // lower plate at rest; a gap of zero is not yet known
    if (plates->gap() > 0.0) between.high = between.low + plates->gap();
    between.v_high = plates->velocity();
  }

  Flow at(int i) const override { return Fluid_NS::couette_flow(between, atom->x[i][1]); }

 private:
  std::string id;
  FixRheometerPlates *plates = nullptr;
  Fluid_NS::Couette between{0.0, 0.0, 0.0, 0.0};
};

/* ----------------------------------------------------------------------
   between walls, whose places are two of its numbers
------------------------------------------------------------------------- */

class WalledFlow : public BackgroundFlow {
 public:
  WalledFlow(LAMMPS *lmp, const Words &words, int count, int lower, int upper) :
      BackgroundFlow(lmp, words, count), low(lower), high(upper)
  {
    const InputNumber &bottom = number[low], &top = number[high];
    char **values = words.arg + words.iarg + 1;
    if (bottom.is_number() && top.is_number() && !(top.value > bottom.value))
      error->all(FLERR, words.iarg + 1 + high,
                 "Fix {} {}: the upper wall must be above the lower one at y = {}, but is at {}",
                 fix->style, words.arg[words.iarg], values[low], values[high]);
  }

  void new_step() override
  {
    BackgroundFlow::new_step();
    if (!(number[high].value > number[low].value))
      error->all(FLERR,
                 "Fix {}: the upper wall must be above the lower one at y = {}, but is at {} "
                 "at step {}",
                 fix->style, number[low].value, number[high].value, update->ntimestep);
  }

 private:
  int low, high;
};

class CouetteFlow : public WalledFlow {
 public:
  CouetteFlow(LAMMPS *lmp, const Words &words) : WalledFlow(lmp, words, 4, 0, 2) {}
  Flow at(int i) const override
  {
    return Fluid_NS::couette_flow(
        {number[0].value, number[1].value, number[2].value, number[3].value}, atom->x[i][1]);
  }
};

class PoiseuilleFlow : public WalledFlow {
 public:
  PoiseuilleFlow(LAMMPS *lmp, const Words &words) : WalledFlow(lmp, words, 3, 0, 1) {}
  Flow at(int i) const override
  {
    return Fluid_NS::poiseuille_flow({number[0].value, number[1].value, number[2].value},
                                     atom->x[i][1]);
  }
};

/* ----------------------------------------------------------------------
   velocity and spin by numbers, equal- or atom-style variables
------------------------------------------------------------------------- */

class VelocityFlow : public BackgroundFlow {
 public:
  VelocityFlow(LAMMPS *lmp, const Words &words) : BackgroundFlow(lmp, words, 3)
  {
    number.resize(6);    // without spin
  }

  bool take_spin(char **values) override
  {
    for (int n = 0; n < 3; n++) number[3 + n] = InputNumber(lmp, values[n]);
    return true;
  }

  void init() override
  {
    Variable *variables = input->variable;
    for (int n = 0; n < 6; n++) {
      if (number[n].is_number()) continue;
      const std::string &name = number[n].variable;
      const int found = variables->find(name.c_str());
      if (found < 0)
        error->all(FLERR, "Variable {} for fix {} velocity does not exist", name, fix->style);
      per_atom[n] = variables->atomstyle(found) != 0;
      if (!per_atom[n] && !variables->equalstyle(found))
        error->all(FLERR, "Variable {} for fix {} velocity is neither equal- nor atom-style", name,
                   fix->style);
    }
  }

  void new_step() override
  {
    for (int n = 0; n < 6; n++) {
      if (!per_atom[n]) {
        number[n].evaluate(lmp);
        continue;
      }
      auto &to = values[n];
      if (static_cast<int>(to.size()) < atom->nlocal) to.resize(atom->nmax);
      const int variable = input->variable->find(number[n].variable.c_str());
      input->variable->compute_atom(variable, fix->igroup, to.data(), 1, 0);
    }
  }

  Flow at(int i) const override
  {
    double u[6];
    for (int n = 0; n < 6; n++) u[n] = per_atom[n] ? values[n][i] : number[n].value;
    return {{u[0], u[1], u[2]}, {u[3], u[4], u[5]}};
  }

  bool is_per_atom(const std::string &variable) const override
  {
    for (int n = 0; n < 6; n++)
      if (per_atom[n] && number[n].variable == variable) return true;
    return false;
  }

  double memory_usage() const override
  {
    double bytes = 0.0;
    for (const auto &each : values) bytes += sizeof(double) * each.capacity();
    return bytes;
  }

 private:
  std::array<bool, 6> per_atom{};
  std::array<std::vector<double>, 6> values;
};

/* ---------------------------------------------------------------------- */

template <class F> std::unique_ptr<BackgroundFlow> make(LAMMPS *lmp, const Words &words)
{
  return std::make_unique<F>(lmp, words);
}

}    // namespace

const std::vector<BackgroundFlow::Style> &BackgroundFlow::styles()
{
  static const std::vector<Style> STYLES = {
      {"shear", "rate", make<ShearFlow>},
      {"cell", "", make<CellFlow>},
      {"plates", "fix-ID", make<PlatesFlow>},
      {"couette", "y_low v_low y_high v_high", make<CouetteFlow>},
      {"poiseuille", "y_low y_high v_most", make<PoiseuilleFlow>},
      {"velocity", "vx vy vz", make<VelocityFlow>}};
  return STYLES;
}

std::unique_ptr<BackgroundFlow> BackgroundFlow::at_rest(LAMMPS *lmp, Fix *fix)
{
  return make<RestFlow>(lmp, {fix, nullptr, 0});
}

std::unique_ptr<BackgroundFlow> BackgroundFlow::of_cell(LAMMPS *lmp, Fix *fix)
{
  return make<CellOrRest>(lmp, {fix, nullptr, 0});
}
