# ranks: 1
"""Wet restitution of a normal collision against the Stokes number St = m v/(6 pi eta (a/2)^2) of one sphere on a fixed
equal one, film within a/2. The shape is the measured one (G.G. Joseph et al., J. Fluid Mech. 433, 329, 2001): no rebound
below St about 10, nearly the dry value, 1 for elastic spheres, above 500. Every point also against SciPy.

The film takes v ln(reach/u)/St on the way in and again on the way out. With u about the roughness 1e-3 a, where the
asperities take over, the threshold is near 2 ln(500) = 12.

Smooth spheres have no asperities: all of the force goes through the film, m v' = -c u'/u, so that m v + c ln u stays
what it was, and leaving at u = reach would need the velocity of the approach. They never part.
"""
import numpy as np

from deck import expect, expect_close, finish, run
from oracle.normal_pair import Pair

SIZE, EPS, REACH, DURATION = 2e-4, 1e-3, 0.5, 5.0
STOKES = [3, 8, 15, 20, 30, 50, 100, 200, 500, 1000, 2000]


def restitution(stokes, **keywords):
    found = run("in.rebound", stokes=stokes, size=SIZE, reach=REACH, duration=DURATION, **{"eps": EPS, **keywords}).values
    return max(0.0, found["velocity"]) if found["separation"] > REACH else 0.0


def exact(stokes):
    g = stokes / SIZE**2
    pair = Pair(mass=stokes, weight=0.0, g=g, k=g, rough=EPS, film=1.0, reach=REACH)
    done = pair.solve(REACH, -1.0, np.array([0.0, DURATION]))
    return done.y_events[0][0][1] if done.status == 1 else 0.0


wet = np.array([restitution(s) for s in STOKES])
reference = np.array([exact(s) for s in STOKES])
for row in zip(STOKES, wet, reference):
    print("St {:6g}  restitution {:.6f}  SciPy {:.6f}".format(*row))
expect_close("restitution against SciPy", wet, reference, atol=1e-3)
expect("no rebound at St 3 and 8", wet[0] == 0 and wet[1] == 0)
expect("rebound at St 15", wet[2] > 0, f"{wet[2]:.3f}")
expect("rises with St", np.all(np.diff(wet[1:]) > 0))
expect("within 5 % of the dry value at St 500", wet[STOKES.index(500)] > 0.95, f"{wet[STOKES.index(500)]:.4f}")
high = [STOKES.index(100), STOKES.index(200)]
lost = (1 - wet[high]) * np.array([100, 200])
expect_close("the loss falls as 1/St", lost[1], lost[0], rtol=0.02)
# dry: half an oscillation with sqrt(g/m) dt = 0.1
expect_close("restitution without fluid", restitution(100, eta=0), 1.0, atol=1e-3)
expect("smooth spheres do not part at St 2000", restitution(2000, eps=0) == 0)
finish()
