# ranks: 1 2 4
"""fix hydro grid: the loads of spheres against a full matrix."""
import numpy as np

import deck
from oracle import far_field
from oracle.spheres import random_spheres, write_spheres

OUTPUT = ["iterations", "residual"] + ["xx", "yy", "zz", "xy", "xz", "yz"] + ["heat", "fx", "fy", "fz", "solutions", "phi"]
GRIDS = {1: ["1 1 1"], 2: ["1 1 2", "2 1 1"], 4: ["2 2 1", "1 1 4"]}[deck.RANKS]
EXACT = "tol 1e-10 spacing 0.5 support 7 reach 9"
ETA = 0.7


def spheres(rnd, edges, tilts, radius):
    """Spheres that do not overlap at random places of a cell, with velocities and spins."""
    a, b, c = edges
    xy, xz, yz = tilts
    cell = np.array([[a, xy, xz], [0, b, yz], [0, 0, c]], dtype=float)
    x = random_spheres(rnd, cell, radius, factor=1.02)
    v, w = rnd.normal(size=x.shape), rnd.normal(size=x.shape)
    write_spheres("spheres.data", cell, x, radius, v, w)
    return cell, x, v, w


def instant(**variables):
    t = deck.run("in.instant", eta=ETA, **variables).thermo()
    d = deck.read_dump("instant.dump")
    return ({name: t[f"f_far[{n + 1}]"][-1] for n, name in enumerate(OUTPUT)},
            -np.array([d[f"f_far[{n}]"] for n in (1, 2, 3)]).T, -np.array([d[f"f_far[{n}]"] for n in (4, 5, 6)]).T)


def against_the_matrix(what, edges, tilts, radius, rate, seed, **variables):
    """Forces, torques, stress and heat of one moment; in a cell with a tilt, which shears."""
    rnd = np.random.default_rng(seed)
    cell, x, v, w = spheres(rnd, edges, tilts, radius)
    edges_move = np.zeros((3, 3))
    edges_move[0, 1] = rate * edges[1]
    gradient = edges_move @ np.linalg.inv(cell)
    strain = (gradient + gradient.T) / 2
    flow = f"fix flow all deform 1 xy erate {rate:.17g} remap v" if rate else ""
    flow_v = x @ gradient.T
    flow_w = np.array([0, gradient[0, 2] / 2, -gradient[0, 1] / 2])
    loads = [ETA * load for load in far_field.loads(cell, x, radius, v - flow_v, w - flow_w, strain)]
    scale = [np.max(np.abs(load)) for load in loads]
    for grid in GRIDS:
        t, force, torque = instant(grid=grid, flow=flow, hydro=f"grid every 1 {EXACT}", **variables)
        name = f"{what}, ranks {grid}"
        deck.expect_close(f"{name}: forces", force / scale[0], loads[0] / scale[0], atol=3e-7)
        deck.expect_close(f"{name}: torques", torque / scale[1], loads[1] / scale[1], atol=3e-7)
        stress = -np.sum(loads[2], axis=0) / np.linalg.det(cell)
        found = np.array([t[n] for n in ("xx", "yy", "zz", "xy", "xz", "yz")])
        expected = stress[(0, 1, 2, 0, 0, 1), (0, 1, 2, 1, 2, 2)]
        deck.expect_close(f"{name}: stress", found / np.max(np.abs(stress)), expected / np.max(np.abs(stress)), atol=1e-6)
        heat = np.sum(loads[0] * (v - flow_v)) + np.sum(loads[1] * (w - flow_w)) - np.sum(loads[2] * strain)
        deck.expect_close(f"{name}: heat", t["heat"], heat, rtol=1e-6)
        deck.expect_close(f"{name}: sum of forces", [t[n] for n in ("fx", "fy", "fz")], -np.sum(loads[0], axis=0),
                          atol=1e-6 * scale[0])


if __name__ == "__main__":
    equal, mixed = np.ones(14), np.array([1.0] * 4 + [0.5] * 6 + [0.4] * 6)
    against_the_matrix("equal spheres, orthogonal", (7, 6, 8), (0, 0, 0), equal, 0.0, 1)
    against_the_matrix("two sizes and a third, triclinic", (6, 6.5, 7), (2.1, -0.7, 1.1), mixed, 0.0, 2)
    against_the_matrix("equal spheres, sheared", (7, 6, 8), (2.4, 0, 0), equal, 1.3, 3)
    against_the_matrix("newton off", (6, 6.5, 7), (2.1, -0.7, 1.1), mixed, 0.8, 4, newton="off")
    deck.finish()
