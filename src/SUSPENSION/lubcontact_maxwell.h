// Maxwell element, spring and film in series, over one time step: shared by shear, roll and twist.
// dq/dt = rate - q/relaxation, q = elastic part of the displacement. Exact for a constant rate, so
// the film never limits the time step, however thin it is.

#ifndef LUBCONTACT_MAXWELL_H
#define LUBCONTACT_MAXWELL_H

#include <cmath>

namespace lubcontact {

struct Relaxation {
  double keep;    // exp(-x): what remains of the old displacement
  double gain;    // (1 - exp(-x))/x: what the displacement of this step adds
};

// x = stiffness dt/resistance; infinity (no film) leaves nothing.
inline Relaxation relaxation(double x)
{
  if (x < 1e-3) {
    const double gain = 1.0 - x * (1.0 / 2 - x * (1.0 / 6 - x * (1.0 / 24 - x / 120)));
    return {1.0 - x * gain, gain};
  }
  const double keep = std::exp(-x);
  return {keep, (1.0 - keep) / x};
}

}    // namespace lubcontact

#endif
