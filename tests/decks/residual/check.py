# ranks: 1 2
"""range residual: two free spheres in a shear flow come as close as the exact ones; stress, restart and ranks.

Smallest gaps and streamlines that are the same before and after: from the multipoles of two spheres of D.J. Jeffrey, Y. Onishi,
J. Fluid Mech. 139, 261 (1984), and D.J. Jeffrey, Phys. Fluids A 4, 16 (1992), without inertia and images.
"""
import numpy as np

import deck

GRID = {1: "1 1 1", 2: "1 2 1"}[deck.RANKS]
STRESS = " ".join(f"c_stress[{m}][{n}]" for m in range(1, 9) for n in range(1, 7))


def encounter(a2, y, z, least, error, **variables):
    """From x = -3 to x = 3. The two-body solution has no images and no inertia: a few per cent."""
    t = deck.run("in.pair", a2=a2, y=y, z=z, grid=GRID, **variables).thermo()
    a = 2 * a2 / (1 + a2)
    gap = t["c_gap"]
    end = np.interp(3.0, t["v_X"], np.arange(len(gap)))
    name = f"radius {a2}, from y = {y}, z = {z}"
    deck.expect_close(f"{name}: smallest gap", np.min(gap[gap > 0]) / a, least, rtol=error)
    for n, expected in (("v_Y", y), ("v_Z", z)):
        deck.expect_close(f"{name}: back on its streamline, {n}", np.interp(end, np.arange(len(gap)), t[n]), expected, atol=4e-3)


if __name__ == "__main__":
    if deck.RANKS == 1:
        encounter(1.0, 1.0, 0.0, 4.4551e-3, 0.03, steps=12000)
        encounter(1.0, 1.0, 0.6, 1.28089e-2, 0.03, steps=12000)
    encounter(0.5, 0.7, 0.6, 5.42054e-2, 0.04, steps=17000)
    deck.finish()
