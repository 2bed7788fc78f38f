/*---------------------------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

#include "deform_targets.h"

#include "error.h"
#include "suspension_host.h"

#include <cstring>

using namespace LAMMPS_NS;

static constexpr const char *DRIVE_NAME[] = {"", "rate", "iv", "stress", "oscillate"};

/* ---------------------------------------------------------------------- */

DeformTargets::DeformTargets(LAMMPS *lmp, const char *style_of_fix) :
    Pointers(lmp), style(style_of_fix), kind(NONE_YET), confined(OPEN), viscosity_given(false),
    pair_viscosity(nullptr), servo_gain(1.0)
{
}

/* ---------------------------------------------------------------------- */

int DeformTargets::parse(int iarg, int narg, char **arg, bool underline)
{
  const std::string key = arg[iarg];
  if (key == "rate" || key == "iv" || key == "stress" || key == "oscillate")
    return parse_drive(iarg, narg, arg, underline);

  const int where = underline ? iarg : Error::NOPOINTER;
  auto set_confinement = [&](Confinement to) {
    if (underline && confined != OPEN)
      error->all(FLERR, where, "Fix {} accepts only one of pressure, volume; remove {}", style,
                 key);
    confined = to;
  };
  auto positive = [&](const Suspension_NS::InputNumber &target, bool zero) {
    if (target.is_number() && !(zero ? target.value >= 0.0 : target.value > 0.0))
      error->all(FLERR, underline ? iarg + 1 : where, "Fix {} {} must be {} 0, but is {}", style,
                 key, zero ? ">=" : ">", arg[iarg + 1]);
  };

  if (key == "volume") {
    set_confinement(VOLUME);
    return iarg + 1;
  }
  if (key != "pressure" && key != "viscosity" && key != "gain")
    error->all(FLERR, where,
               underline ? "Unknown fix {} keyword: {}"
                         : "Fix {} {} cannot be changed by fix_modify; allowed keywords: rate, iv, "
                           "stress, oscillate, pressure, volume, viscosity, gain, lists",
               style, key);
  need_values(key == "pressure"   ? "pressure P"
                  : key == "gain" ? "gain K"
                                  : "viscosity eta",
              iarg, narg);
  if (key == "pressure") {
    set_confinement(PRESSURE);
    number[HELD] = Suspension_NS::InputNumber(lmp, arg[iarg + 1]);
    positive(number[HELD], false);
  } else if (key == "viscosity") {
    number[ETA] = Suspension_NS::InputNumber(lmp, arg[iarg + 1]);
    viscosity_given = true;
    positive(number[ETA], true);
  } else {
    Suspension_NS::InputNumber one;
    one.value = servo_gain = utils::numeric(FLERR, arg[iarg + 1], false, lmp);
    positive(one, false);
  }
  return iarg + 2;
}

/* ---------------------------------------------------------------------- */

int DeformTargets::parse_drive(int iarg, int narg, char **arg, bool underline)
{
  const std::string key = arg[iarg];
  if (underline && kind != NONE_YET)
    error->all(FLERR, iarg, "Fix {} accepts only one of rate, iv, stress, oscillate; remove {}",
               style, key);
  need_values(key == "oscillate"  ? "oscillate g0 g1 w"
                  : key == "rate" ? "rate g"
                  : key == "iv"   ? "iv v"
                                  : "stress s",
              iarg, narg);
  number[DRIVEN] = Suspension_NS::InputNumber(lmp, arg[iarg + 1]);
  kind = key == "rate" ? RATE : key == "iv" ? IV : key == "stress" ? STRESS : OSCILLATE;
  number[AMPLITUDE] = number[FREQUENCY] = Suspension_NS::InputNumber();
  if (kind != OSCILLATE) return iarg + 2;
  number[AMPLITUDE] = Suspension_NS::InputNumber(lmp, arg[iarg + 2]);
  number[FREQUENCY] = Suspension_NS::InputNumber(lmp, arg[iarg + 3]);
  return iarg + 4;
}

/* ---------------------------------------------------------------------- */

void DeformTargets::need_values(const char *usage, int iarg, int narg) const
{
  Suspension_NS::require_words(FLERR, error, "fix " + style, narg - iarg, usage);
}

/* ---------------------------------------------------------------------- */

void DeformTargets::check_complete(int narg, char **arg) const
{
  if (kind == NONE_YET)
    error->all(FLERR, "Fix {} needs one of: rate, iv, stress, oscillate", style);
  if (confined == OPEN) error->all(FLERR, "Fix {} needs one of: pressure, volume", style);
  for (int iarg = 3; iarg < narg; iarg++)
    if (confined == VOLUME && strcmp(arg[iarg], "gain") == 0)
      error->all(FLERR, iarg, "Fix {} gain cannot act at constant volume", style);
}

/* ---------------------------------------------------------------------- */

void DeformTargets::check_variables() const
{
  number[DRIVEN].check(lmp, style.c_str(), DRIVE_NAME[kind]);
  number[AMPLITUDE].check(lmp, style.c_str(), DRIVE_NAME[OSCILLATE]);
  number[FREQUENCY].check(lmp, style.c_str(), DRIVE_NAME[OSCILLATE]);
  number[HELD].check(lmp, style.c_str(), "pressure");
  number[ETA].check(lmp, style.c_str(), "viscosity");
}

/* ---------------------------------------------------------------------- */

bool DeformTargets::has_variables() const
{
  for (const Suspension_NS::InputNumber &target : number)
    if (!target.is_number()) return true;
  return false;
}

/* ----------------------------------------------------------------------
   viscosity of pair style lubcontact, alone or of all of its kind under hybrid
------------------------------------------------------------------------- */

void DeformTargets::find_viscosity()
{
  if (viscosity_given) return;
  pair_viscosity = Suspension_NS::viscosity_of_pair(lmp);
  if (pair_viscosity) return;
  const bool needed = kind == IV || kind == STRESS || confined == PRESSURE;
  const std::size_t styles = Suspension_NS::all_lubcontact(lmp).size();
  const bool several = styles > 1;
  if (styles && (needed || !several))
    error->all(FLERR,
               "Fix {} cannot take the viscosity of the pair style, {}; give it: viscosity {}",
               style, Suspension_NS::why_no_viscosity(lmp), several ? "eta" : "v_name");
  if (needed)
    error->all(FLERR, "Fix {} needs the viscosity of the fluid; add: viscosity eta (0 if dry)",
               style);
}

/* ---------------------------------------------------------------------- */

void DeformTargets::update()
{
  for (Suspension_NS::InputNumber &target : number) target.evaluate(lmp);
  if (!viscosity_given && pair_viscosity) number[ETA].value = *pair_viscosity;

  if (confined == VOLUME && kind == IV)
    error->all(FLERR,
               "Fix {} cannot impose a viscous number at constant volume, where it follows from "
               "the volume fraction: give a pressure, or a rate",
               style);
  if (confined == PRESSURE && !(number[HELD].value > 0.0))
    error->all(FLERR, "Fix {} pressure must be > 0, but is {}", style, number[HELD].value);
  if (!(number[ETA].value >= 0.0))
    error->all(FLERR, "Fix {} viscosity must be >= 0, but is {}", style, number[ETA].value);
  if (kind == IV && number[ETA].value == 0.0)
    error->all(FLERR, "Fix {} cannot impose a viscous number without viscosity: give a rate",
               style);
}

/* ---------------------------------------------------------------------- */

std::string DeformTargets::settings_text() const
{
  std::string text = fmt::format("{} {}", DRIVE_NAME[kind], number[DRIVEN].value);
  if (kind == OSCILLATE)
    text += fmt::format(" {} {}", number[AMPLITUDE].value, number[FREQUENCY].value);
  if (confined == PRESSURE)
    text += fmt::format(" pressure {} gain {}", number[HELD].value, servo_gain);
  else
    text += " volume";
  if (viscosity_given) text += fmt::format(" viscosity {}", number[ETA].value);
  return text;
}

/* ---------------------------------------------------------------------- */

DeformTargets::Saved DeformTargets::saved() const
{
  return {static_cast<double>(kind), number[DRIVEN].value,          number[AMPLITUDE].value,
          number[FREQUENCY].value,   static_cast<double>(confined), number[HELD].value};
}

bool DeformTargets::turned_from(const Saved &s) const
{
  const bool other_wave =
      (number[FREQUENCY].is_number() && number[FREQUENCY].value != s.frequency) ||
      (number[AMPLITUDE].is_number() && number[AMPLITUDE].value != s.amplitude);
  return kind != s.drive || (kind == OSCILLATE && other_wave);
}

bool DeformTargets::differ_from(const Saved &s) const
{
  return turned_from(s) || confined != s.confinement ||
      (number[DRIVEN].is_number() && number[DRIVEN].value != s.driven) ||
      (number[HELD].is_number() && number[HELD].value != s.pressure);
}
