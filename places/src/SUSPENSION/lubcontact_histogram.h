/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Histogram on [lo, hi) that keeps count of what falls outside.

#ifndef LUBCONTACT_HISTOGRAM_H
#define LUBCONTACT_HISTOGRAM_H

#include <cstddef>
#include <vector>

namespace LAMMPS_NS::Lubcontact_NS {

struct Histogram {
  double lo, hi;
  std::vector<double> weight;    // of each bin, then below lo, then not below hi

  Histogram(double lo_, double hi_, int bins) : lo(lo_), hi(hi_), weight(place(bins + 2), 0.0) {}

  int bins() const { return static_cast<int>(weight.size()) - 2; }
  double width() const { return (hi - lo) / bins(); }
  double center(int bin) const { return lo + (bin + 0.5) * width(); }
  double below() const { return weight[place(bins())]; }
  double above() const { return weight[place(bins() + 1)]; }

  void add(double w, double x)
  {
    int bin;
    if (x < lo)
      bin = bins();
    else if (!(x < hi))
      bin = bins() + 1;
    else {
      bin = static_cast<int>((x - lo) / width());
      if (bin >= bins()) bin = bins() - 1;    // rounding just below hi
    }
    weight[place(bin)] += w;
  }

  double total() const
  {
    double sum = 0.0;
    for (const double w : weight) sum += w;
    return sum;
  }

  // probability per unit of x: its integral and the shares outside add up to one
  double density(int bin) const
  {
    const double all = total();
    return all > 0.0 ? weight[place(bin)] / (all * width()) : 0.0;
  }

  static std::size_t place(int bin) { return static_cast<std::size_t>(bin); }
};

}    // namespace LAMMPS_NS::Lubcontact_NS

#endif
