/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "background_hindrance.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "fluid_drag.h"
#include "suspension_host.h"
#include "update.h"

#include <string>

using namespace LAMMPS_NS;
using Suspension_NS::InputNumber;

/* ---------------------------------------------------------------------- */

void BackgroundHindrance::init() const
{
  given.check(lmp, fix->style, "hindrance");
}

void BackgroundHindrance::new_step()
{
  given.evaluate(lmp);
  value = next_factor();
}

/* ---------------------------------------------------------------------- */

namespace {

class NoHindrance : public BackgroundHindrance {
 public:
  NoHindrance(LAMMPS *lmp, Fix *owner, char ** = nullptr, int = 0) : BackgroundHindrance(lmp, owner)
  {
  }

 protected:
  double next_factor() override { return 1.0; }
};

/* ---------------------------------------------------------------------- */

class GivenFactor : public BackgroundHindrance {
 public:
  GivenFactor(LAMMPS *lmp, Fix *owner, char **arg, int iarg) : BackgroundHindrance(lmp, owner)
  {
    given = InputNumber(lmp, arg[iarg]);
    if (given.is_number() && !(given.value >= 0.0))
      error->all(FLERR, iarg, "Fix {} hindrance must be >= 0, but is {}", fix->style, arg[iarg]);
  }

 protected:
  double next_factor() override
  {
    if (!(given.value >= 0.0))
      error->all(FLERR, "Fix {} hindrance must be >= 0, but is {} at step {}", fix->style,
                 given.value, update->ntimestep);
    return given.value;
  }
};

/* ---------------------------------------------------------------------- */

class OfFraction : public BackgroundHindrance {
 protected:
  using BackgroundHindrance::BackgroundHindrance;
  virtual double fraction() = 0;

  double next_factor() override
  {
    const double phi = fraction();
    if (!(phi >= 0.0 && phi < 1.0))
      error->all(FLERR,
                 "Fix {} hindrance: the volume fraction must be >= 0 and < 1, but is {} at "
                 "step {}",
                 fix->style, phi, update->ntimestep);
    return Fluid_NS::mean_hindrance(phi);
  }
};

class OfGivenFraction : public OfFraction {
 public:
  OfGivenFraction(LAMMPS *lmp, Fix *owner, char **arg, int iarg) : OfFraction(lmp, owner)
  {
    given = InputNumber(lmp, arg[iarg]);
    if (given.is_number() && !(given.value >= 0.0 && given.value < 1.0))
      error->all(FLERR, iarg, "Fix {} hindrance phi must be >= 0 and < 1, but is {}", fix->style,
                 arg[iarg]);
  }

 protected:
  double fraction() override { return given.value; }
};

/* ----------------------------------------------------------------------
   Measured in each step, since particles come, go and grow. Another order of them rounds the sum
   differently: then it stays as it was, and a continued run is the same
------------------------------------------------------------------------- */

class OfMeasuredFraction : public OfFraction {
 public:
  OfMeasuredFraction(LAMMPS *lmp, Fix *owner, char ** /*arg*/, int /*iarg*/) :
      OfFraction(lmp, owner)
  {
  }
  double kept() const override { return solid; }
  void keep(double from) override { solid = from; }

 protected:
  double fraction() override
  {
    double mine = 0.0, all;
    for (int i = 0; i < atom->nlocal; i++)
      mine += Suspension_NS::particle_volume(domain, atom->radius[i]);
    MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
    if (!Suspension_NS::is_same_sum(solid, all)) solid = all;
    return solid / Suspension_NS::cell_volume(domain);
  }

 private:
  double solid = 0.0;    // volume of all particles
};

/* ---------------------------------------------------------------------- */

template <class H>
std::unique_ptr<BackgroundHindrance> make_rule(LAMMPS *lmp, Fix *owner, char **values, int iarg)
{
  return std::make_unique<H>(lmp, owner, values, iarg);
}

struct Rule {
  const char *keyword, *usage;    // and its values, from arg[iarg] on
  std::unique_ptr<BackgroundHindrance> (*make)(LAMMPS *, Fix *, char **arg, int iarg);
};

constexpr Rule RULES[] = {{"none", "", make_rule<NoHindrance>},
                          {"mean", "", make_rule<OfMeasuredFraction>},
                          {"phi", "f", make_rule<OfGivenFraction>}};

}    // namespace

/* ----------------------------------------------------------------------
   a word that is no rule is a factor
------------------------------------------------------------------------- */

std::unique_ptr<BackgroundHindrance> BackgroundHindrance::make(LAMMPS *lmp, Fix *owner, int narg,
                                                               char **arg, int &iarg)
{
  const std::string word = arg[iarg];
  for (const Rule &rule : RULES) {
    if (word != rule.keyword) continue;
    Suspension_NS::require_words(FLERR, lmp->error, std::string("fix ") + owner->style,
                                 narg - iarg + 1,
                                 std::string("hindrance ") + rule.keyword + " " + rule.usage);
    const int values = iarg + 1;
    iarg = values + static_cast<int>(utils::count_words(rule.usage));
    return rule.make(lmp, owner, arg, values);
  }
  return std::make_unique<GivenFactor>(lmp, owner, arg, iarg++);
}

std::unique_ptr<BackgroundHindrance> BackgroundHindrance::none(LAMMPS *lmp, Fix *owner)
{
  return std::make_unique<NoHindrance>(lmp, owner);
}
