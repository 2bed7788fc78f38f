"""A sphere settles on a fixed one that repels it: alone and with asperities against SciPy; at rest F0 exp(-u/lambda) and
k (eps a - u) carry the weight. Frictionless elastic spheres with repulsion can be minimized to the same rest."""
import numpy as np
from scipy.optimize import brentq

from deck import PAIR, expect, expect_close, finish, run
from oracle.normal_pair import Pair, film

ETA, DENSITY, G, K, U0, DURATION = 1.0, 5e-4, 5e3, 1e3, 0.1, 12.0
MASS, WEIGHT = 4 / 3 * np.pi * DENSITY, 4 / 3 * np.pi
F0, LENGTH = 50.0, 0.01


def settle(what, eps, atol):
    rows = run(PAIR / "in.fall", eta=ETA, a=1.0, density=DENSITY, g=G, k=K, eps=eps, u0=U0,
               duration=DURATION, more=f"repulsion {F0} {LENGTH}").thermo()
    t, u, un, v = rows["Time"], rows["c_u"], rows["v_un"], rows["v_v"]
    exact = Pair(MASS, WEIGHT, G, K, eps, film(ETA, 1.0), F0=F0, length=LENGTH).solve(U0, 0.0, t).y
    expect_close(f"{what}: ln u against SciPy", np.log(u), exact[2], atol=atol)
    expect_close(f"{what}: un against SciPy", un, exact[0], atol=atol * U0)
    rest = brentq(lambda x: F0 * np.exp(-x / LENGTH) + K * max(0, eps - x) - WEIGHT, 1e-9, 1, xtol=1e-15)
    expect_close(f"{what}: u at rest", u[-1], rest, rtol=1e-6)
    expect_close(f"{what}: un at rest = u - W/g", un[-1], rest - WEIGHT / G, rtol=1e-6)
    expect_close(f"{what}: at rest", v[-1], 0.0, atol=1e-9)


# the first oscillations on the bulk spring: as in falling_sphere
settle("smooth", 0.0, 1e-6)
expect_close("closed form of the rest: lambda ln(F0/W)", brentq(lambda x: F0 * np.exp(-x / LENGTH) - WEIGHT, 0, 1, xtol=1e-15),
             LENGTH * np.log(F0 / WEIGHT), rtol=1e-9)
settle("rough", 0.026, 1e-6)
finish()
