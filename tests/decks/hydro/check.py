# ranks: 1 4
"""fix hydro grid: the loads of spheres against a full matrix; on several ranks against those of one."""
import numpy as np

import deck
from oracle import far_field
from oracle.spheres import cell_of, random_spheres, write_spheres

SIX = ["xx", "yy", "zz", "xy", "xz", "yz"]
OUTPUT = ["iterations", "residual"] + SIX + ["heat", "fx", "fy", "fz", "solutions", "phi"]
GRIDS = {1: ["1 1 1"], 4: ["2 2 1", "1 1 4"]}[deck.RANKS]
EXACT = "tol 1e-10 spacing 0.5 points 12 reach 9"
ETA = 0.7


def spheres(rnd, edges, tilts, radius):
    """Random places, velocities and spins; cell, centers and these."""
    cell = cell_of(edges, tilts)
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
    """Forces, torques, stress and heat of one moment, also in a cell with a tilt, which shears."""
    rnd = np.random.default_rng(seed)
    cell, x, v, w = spheres(rnd, edges, tilts, radius)
    edges_move = np.zeros((3, 3))
    edges_move[0, 1] = rate * edges[1]
    gradient = edges_move @ np.linalg.inv(cell)
    strain = (gradient + gradient.T) / 2
    flow = f"fix flow all deform 1 xy erate {rate:.17g} remap v" if rate else ""
    flow_v = x @ gradient.T
    flow_w = np.array([0, gradient[0, 2] / 2, -gradient[0, 1] / 2])
    if deck.RANKS == 1:
        loads = [ETA * load for load in far_field.loads(cell, x, radius, v - flow_v, w - flow_w, strain)]
        stress = -np.sum(loads[2], axis=0)[(0, 1, 2, 0, 0, 1), (0, 1, 2, 1, 2, 2)] / np.linalg.det(cell)
        heat = np.sum(loads[0] * (v - flow_v)) + np.sum(loads[1] * (w - flow_w)) - np.sum(loads[2] * strain)
    else:    # which the matrix judges in the test on one rank
        t, *loads = instant(ranks=1, grid="* * *", flow=flow, hydro=f"grid every 1 {EXACT}", **variables)
        stress, heat = np.array([t[n] for n in SIX]), t["heat"]
    scale = [np.max(np.abs(load)) for load in loads]
    few = 1 if deck.RANKS == 1 else 1e-3    # between ranks digits at the end differ
    for grid in GRIDS:
        t, force, torque = instant(grid=grid, flow=flow, hydro=f"grid every 1 {EXACT}", **variables)
        name = f"{what}, ranks {grid}"
        deck.expect_close(f"{name}: forces", force / scale[0], loads[0] / scale[0], atol=3e-7 * few)
        deck.expect_close(f"{name}: torques", torque / scale[1], loads[1] / scale[1], atol=3e-7 * few)
        found = np.array([t[n] for n in SIX])
        deck.expect_close(f"{name}: stress", found / np.max(np.abs(stress)), stress / np.max(np.abs(stress)), atol=1e-6 * few)
        deck.expect_close(f"{name}: heat", t["heat"], heat, rtol=1e-6 * few)
        deck.expect_close(f"{name}: sum of forces", [t[n] for n in ("fx", "fy", "fz")], -np.sum(loads[0], axis=0),
                          atol=1e-6 * few * scale[0])


def same(what, found, expected):
    """Stress and heat, forces, torques, of two descriptions of one thing; the error of the grid is left."""
    for name, one, other in zip(("output", "forces", "torques"), found, expected):
        one, other = (np.array([v[n] for n in SIX + ["heat"]]) if isinstance(v, dict) else v for v in (one, other))
        scale = np.max(np.abs(other))
        deck.expect_close(f"{what}: {name}", one / scale, other / scale, atol=1e-6)


def described_anew():
    """Another frame, another cell of the same lattice, another order: the same spheres."""
    rnd = np.random.default_rng(5)
    radius = np.array([1.0] * 6 + [0.6] * 8)
    hydro = {"hydro": f"grid every 1 {EXACT}"}

    def found(cell, x, v, w, rotation=np.eye(3), order=None, flow=""):
        write_spheres("spheres.data", cell, x, radius, v, w, order=order)
        t, force, torque = instant(grid=GRIDS[0], flow=flow, **hydro)
        s = rotation.T @ np.array([[t[n] for n in row] for row in (("xx", "xy", "xz"), ("xy", "yy", "yz"), ("xz", "yz", "zz"))]) @ rotation
        t.update(dict(zip(SIX, s[(0, 1, 2, 0, 0, 1), (0, 1, 2, 1, 2, 2)])))
        return t, force @ rotation, torque @ rotation

    cell, x, v, w = spheres(rnd, (7, 6.5, 8), (2.1, -0.7, 1.1), radius)
    before = found(cell, x, v, w)
    order = rnd.permutation(len(x))
    again = found(cell, x, v, w, order=order)
    deck.expect_close("order of particles: forces", again[1], before[1], atol=1e-10 * np.max(np.abs(before[1])))
    # the third edge along x: a frame with no axis in common
    turned = cell[:, (2, 0, 1)]
    q, r = np.linalg.qr(turned)
    sign = np.diag(np.sign(np.diag(r)))
    q, r = q @ sign, sign @ r
    deck.expect("no reflection", np.linalg.det(q) > 0)
    same("frame", found(r, x @ q, v @ q, w @ q, q.T), before)
    # one more edge on another
    for other in ([[1, 1, 0], [0, 1, 0], [0, 0, 1]], [[1, 0, 0], [0, 1, 1], [0, 0, 1]], [[1, 0, -1], [0, 1, 0], [0, 0, 1]]):
        same(f"cell tilted by an edge {other}", found(cell @ other, x, v, w), before)

    # in shear: axes in turn, and all spheres moved through the flow
    rate, tilted = 1.3, (1.0, 0, 0)
    cell, x, v, w = spheres(rnd, (7, 6.5, 8), tilted, radius)
    before = found(cell, x, v, w, flow=f"fix flow all deform 1 xy erate {rate} remap v")
    axes = np.eye(3)[:, (2, 0, 1)]    # x is y now
    same("axes", found(cell_of((8, 7, 6.5), (0, 0, 1.0)), x @ axes, v @ axes, w @ axes, axes.T,
                       flow=f"fix flow all deform 1 yz erate {rate} remap v"), before)
    y = x + [2.3, 4.1, -3.7]
    y -= np.floor(y @ np.linalg.inv(cell).T) @ cell.T
    with_flow = v + np.outer(y[:, 1] - x[:, 1], [rate, 0, 0])
    same("moved with the flow", found(cell, y, with_flow, w, flow=f"fix flow all deform 1 xy erate {rate} remap v"), before)


if __name__ == "__main__":
    equal, mixed = np.ones(14), np.array([1.0] * 4 + [0.5] * 6 + [0.4] * 6)
    against_the_matrix("equal spheres, orthogonal", (7, 6, 8), (0, 0, 0), equal, 0.0, 1)
    against_the_matrix("two sizes and a third, triclinic", (6, 6.5, 7), (2.1, -0.7, 1.1), mixed, 0.0, 2)
    against_the_matrix("equal spheres, sheared", (7, 6, 8), (2.4, 0, 0), equal, 1.3, 3)
    mixed = np.array([1.0] * 4 + [0.7] * 3 + [0.5] * 6)    # the matrix of smaller ones takes longer
    against_the_matrix("newton off", (6, 6.5, 7), (2.1, -0.7, 1.1), mixed, 0.8, 4, newton="off")
    if deck.RANKS == 1:
        described_anew()
    deck.finish()
