# ranks: 1
"""Stokes flow is reversible: a smooth stiff pair that passed in shear is back on its streamline. A rough pair that touched
is not.

What keeps the smooth pair off its streamline is the deflection, proportional to Ca = eta rate a/g, and inertia,
proportional to St, here 10 Ca. With the step in proportion, too, everything that is left has to shrink with Ca.
"""
import numpy as np

from deck import PAIR, expect, expect_close, finish, run
from oracle.sheared_pair import GAP, XI, XJ, Pair

REACH, KT_OVER_G = 4.0, 0.5


def passing(ca, stokes, step, y0, duration, eps=0.0, mu=0.0):
    """Outputs of the deck and relative positions and gap by SciPy."""
    every = round(0.02 / step)
    rows = run(PAIR / "in.shear", density=stokes, g=1 / ca, k=1 / ca, kt=KT_OVER_G / ca, reach=REACH, y0=y0, eps=eps,
               friction=f"coulomb {mu}" if mu else "none", step=step, every=every,
               rows=round(duration / step / every)).thermo()
    pair = Pair(rate=1.0, eta=1.0, density=stokes, g=1 / ca, kt=KT_OVER_G / ca, reach=REACH, k=1 / ca, eps=eps, mu=mu)
    states, _ = pair.solve((0, 0, 0), (-10, y0, 0), rows["Time"])
    expect("passed, and out of range", rows["v_X"][-1] > 6 and rows["c_u"][-1] == 0, f"x = {rows['v_X'][-1]:.2f}")
    return rows, states[XJ] - states[XI], np.exp(states[GAP])


# smooth. The step at which the pair meets is first order: 5 % of what is left with these steps
off = {}
for ca in 1e-3, 1e-4:
    y0 = 1.0
    rows, exact, _ = passing(ca, stokes=10 * ca, step=0.5 * ca, y0=y0, duration=22)
    off[ca] = rows["v_Y"][-1] - y0
    expect_close(f"smooth, Ca = {ca:g}: distance from the streamline", off[ca], exact[1, -1] - y0, rtol=0.05)
expect_close("smooth: distance at Ca = 1e-3 over that at 1e-4", off[1e-3] / off[1e-4], 10.0, rtol=0.05)
rest = off[1e-4] - (off[1e-3] - off[1e-4]) / 9
expect_close("smooth: distance extrapolated to Ca = 0, within the smaller step", rest, 0.0, atol=0.5e-4)

# rough with friction: the least gap of the smooth pair from y0 = 0.5, 0.109 a, is below the roughness
y0, eps = 0.5, 0.12
rows, exact, gap = passing(ca=1e-4, stokes=1e-2, step=5e-4, y0=y0, duration=36, eps=eps, mu=0.5)
near = (rows["c_u"] > 0) & np.isfinite(gap)
expect("rough: touched", np.min(rows["c_u"][near]) < eps, f"gap {np.min(rows['c_u'][near]):.5f} < {eps}")
expect_close("rough: gap", rows["c_u"][near], gap[near], rtol=1e-3)
expect_close("rough: path, within two steps", np.array([rows["v_X"], rows["v_Y"]])[:, near], exact[0:2, near], atol=1e-3)
shift = rows["v_Y"][-1] - y0
expect_close("rough: shift of the streamline, outwards", shift, exact[1, -1] - y0, atol=1e-3)
expect("rough: shift over that of the smooth pair", shift > 100 * off[1e-4], f"{shift / off[1e-4]:.0f}")
finish()
