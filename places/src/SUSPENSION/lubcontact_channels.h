/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Where a pair force comes from. This one list feeds the kernel, the computes and the manual.

#ifndef LUBCONTACT_CHANNELS_H
#define LUBCONTACT_CHANNELS_H

namespace LAMMPS_NS::Lubcontact_NS {

enum Channel {
  CONTACT_NORMAL,
  CONTACT_TANGENTIAL,
  LUBRICATION_NORMAL,
  LUBRICATION_TANGENTIAL,
  SCREENED_REPULSION,
  NUM_CHANNELS
};

inline constexpr const char *CHANNEL_NAME[NUM_CHANNELS] = {"contact/normal", "contact/tangential",
                                                           "lubrication/normal",
                                                           "lubrication/tangential", "repulsion"};

// Rows of the stress by origin as the computes show them: inertia stands before the repulsion.
inline constexpr int INERTIA_ROW = SCREENED_REPULSION, NUM_STRESS_ROWS = NUM_CHANNELS + 1;

constexpr int stress_row(int channel)
{
  return channel < INERTIA_ROW ? channel : channel + 1;
}

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
