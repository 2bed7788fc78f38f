# ranks: 1
"""Wet restitution of a normal collision against the Stokes number St = m v/(6 pi eta (a/2)^2) of one sphere on a fixed
equal one, film within a/2. The shape is the measured one (G.G. Joseph et al., J. Fluid Mech. 433, 329, 2001): no rebound
below St about 10, nearly the dry value, 1 for elastic spheres, above 500. Every point also against SciPy.

On the way in the film takes v ln(reach/u)/St, the same again on the way out: with u about the deflection 1e-3 a the
threshold is of the order of 2 ln(500) = 12.
"""
import numpy as np

from deck import expect, expect_close, finish, run
from oracle.normal_pair import Pair

SIZE, REACH, DURATION = 1e-3, 0.5, 10.0
STOKES = [3, 8, 15, 20, 30, 50, 100, 200, 500, 1000, 2000]


def restitution(found):
    return max(0.0, found["velocity"]) if found["separation"] > REACH else 0.0


def exact(stokes):
    pair = Pair(mass=stokes, weight=0.0, g=stokes / SIZE**2, k=0.0, rough=0.0, film=1.0, reach=REACH)
    done = pair.solve(REACH, -1.0, np.array([0.0, DURATION]))
    return done.y_events[0][0][1] if done.status == 1 else 0.0


wet = np.array([restitution(run("in.rebound", stokes=s, size=SIZE, reach=REACH, duration=DURATION).values) for s in STOKES])
reference = np.array([exact(s) for s in STOKES])
for row in zip(STOKES, wet, reference):
    print("St {:6g}  restitution {:.6f}  SciPy {:.6f}".format(*row))
# the oscillator of the collision is integrated with sqrt(g/m) dt = 1/20: second order, 1/20^2/24 = 1e-4
expect_close("restitution against SciPy", wet, reference, atol=1e-3)
expect("no rebound at St 3 and 8", wet[0] == 0 and wet[1] == 0)
expect("rises with St", np.all(np.diff(wet[1:]) > 0), np.array2string(wet, precision=3))
expect("rebound from St 15 on", wet[2] > 0, f"{wet[2]:.3f}")
expect("St 500 within 5 % of dry", wet[STOKES.index(500)] > 0.95, f"{wet[STOKES.index(500)]:.4f}")
# what the film takes at high St is exactly proportional to 1/St
lost = (1 - wet[-2:]) * np.array(STOKES[-2:])
expect_close("(1 - restitution) St tends to a constant", lost[1], lost[0], rtol=0.02)
dry = restitution(run("in.rebound", stokes=100, size=SIZE, reach=REACH, duration=2.0, eta=0).values)
expect_close("restitution without fluid", dry, 1.0, atol=1e-3)
finish()
