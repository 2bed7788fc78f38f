# ranks: 1 2
"""range residual: two free spheres in a shear flow come as close as the exact ones; the stress that films have at rest.

Smallest gaps, and streamlines that are the same before and after: from the multipoles of two spheres of D.J. Jeffrey,
Y. Onishi, J. Fluid Mech. 139, 261 (1984), and D.J. Jeffrey, Phys. Fluids A 4, 16 (1992), without inertia and images.
"""
import sys

import numpy as np

import deck

sys.path.insert(0, str(deck.ROOT / "tests" / "kernel" / "reference"))
import make_pair_residual_reference as films

GRID = {1: "1 1 1", 2: "1 2 1"}[deck.RANKS]
PAIR_ROWS, NAMES = (1, 2, 3, 4, 6), ("xx", "yy", "zz", "xy", "xz", "yz")
ROWS = " ".join(f"c_stress[{m}][{n}]" for m in PAIR_ROWS for n in range(1, 7))
EPS, ALPHA, REACH = 0.01, 1.0, 1.0


def encounter(a2, y, z, least, error, **variables):
    """From x = -3 to x = 3. The two-body solution has no images and no inertia: a few per cent."""
    t = deck.run("in.pair", a2=a2, y=y, z=z, grid=GRID, **variables).thermo()
    a = 2 * a2 / (1 + a2)
    gap = t["c_gap"]
    steps = np.arange(len(gap))
    end = np.interp(3.0, t["v_X"], steps)
    name = f"radius {a2}, from y = {y}, z = {z}"
    deck.expect_close(f"{name}: smallest gap", np.min(gap[gap > 0]) / a, least, rtol=error)
    for n, expected in (("v_Y", y), ("v_Z", z)):
        deck.expect_close(f"{name}: back on its streamline, {n}", np.interp(end, steps, t[n]), expected, atol=4e-3)


def at_rest(cell, state):
    """Sum of the stresslets of pairs without film forces in the shear of rate 1, along n and across: derivatives of Phi."""
    strain = np.array([[0, 0.5, 0], [0.5, 0, 0], [0, 0, 0]])
    x, radius = np.array([state[n] for n in "xyz"]).T, state["radius"]
    images = np.array([(i, j, k) for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1)]) @ cell.T
    normal, across = np.zeros((3, 3)), np.zeros((3, 3))
    for i in range(len(x)):
        for j in range(i):
            ri, rj = radius[i], radius[j]
            a, delta = 2 * ri * rj / (ri + rj), (rj - ri) / (ri + rj)
            d = min(x[i] - x[j] + images, key=np.linalg.norm)
            r = np.linalg.norm(d)
            u = (r - ri - rj) / a
            if u >= REACH:
                continue
            rubs = u < EPS
            if rubs:
                u = (u + ALPHA * EPS) / (1 + ALPHA)
            c = films.coefficients(u, delta, a)
            n = d / r
            e, et = n @ strain @ n, strain @ n - (n @ strain @ n) * n
            normal += (c["C"] - c["Br"]**2 / c["A"]) / films.ETA * e * (np.outer(n, n) - np.eye(3) / 3)
            if rubs:    # the film of shear does not know of the flow
                off = c["Rsr"] / c["As"]
                left = c["Cs"] - (c["Bturn"] - off * c["Bsr"])**2 / (c["Rr"] - off**2 * c["As"])
            else:
                b = np.array([c["Bsr"], c["Bturn"]])
                left = c["Cs"] - b @ np.linalg.solve([[c["As"], c["Rsr"]], [c["Rsr"], c["Rr"]]], b)
            both = left / films.ETA * np.outer(n, et)
            across += (both + both.T) / 2
    return [s[(0, 1, 2, 0, 0, 1), (0, 1, 2, 1, 2, 2)] for s in (normal, across)]


def stress(newton):
    """The stress of pairs is the same for all that tells it; before they have moved it is known."""
    t = deck.run("in.cell", newton=newton, grid=GRID, stress=ROWS).thermo()
    rows = np.array([[t[f"c_stress[{m}][{n}]"] for n in range(1, 7)] for m in PAIR_ROWS])
    size, volume = np.max(np.abs(rows)), t["Volume"]
    name = f"newton {newton}"
    for n, component in enumerate(NAMES):
        virial, sums = -t[f"c_virial[{n + 1}]"], t[f"c_sum[{n + 1}]"] / volume
        deck.expect_close(f"{name}: {component} of rows and virial", np.sum(rows[:, n], axis=0), virial, atol=1e-12 * size)
        deck.expect_close(f"{name}: {component} of atoms and virial", sums, virial, atol=1e-12 * size)
    for k, m in enumerate(PAIR_ROWS):
        atoms = np.array([t[f"c_rows[{9 * (m - 1) + n}]"] for n in range(1, 7)]) / volume
        deck.expect_close(f"{name}: row {m} of atoms and cell", atoms, rows[k], atol=1e-12 * size)
    edge = volume[0]**(1 / 3)
    for k, part in zip((2, 3), at_rest(np.diag([edge, edge, edge]), deck.read_dump("start.dump"))):
        part /= volume[0]
        deck.expect_close(f"{name}: row {k + 1} at rest", rows[k, :, 0], part, atol=1e-9 * np.max(np.abs(part)))


if __name__ == "__main__":
    deck.make_state()
    stress("on")
    stress("off")
    if deck.RANKS == 1:
        encounter(1.0, 1.0, 0.0, 4.4551e-3, 0.03, steps=12000)
        encounter(1.0, 1.0, 0.6, 1.28089e-2, 0.03, steps=12000)
    encounter(0.5, 0.7, 0.6, 5.42054e-2, 0.04, steps=17000)
    deck.finish()
