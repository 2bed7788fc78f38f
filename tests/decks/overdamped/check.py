# ranks: 1 4
"""fix overdamped/sphere: forces over drag, decay of a contact and its limit of the step, a pair in shear against SciPy,
discs at imposed pressure whatever their mass, cells that deform, restart.
"""
import numpy as np

from deck import PAIR, RANKS, expect, expect_close, finish, make_state, read_dump, run
from oracle.sheared_pair import GAP, XI, XJ, Pair

PUSH, FLUID, TURN = np.array([0.02, -0.05, 0.03]), np.array([0.1, 0.2, -0.3]), np.array([-0.2, 0.3, 0.6])
ETA = 0.8
GRID = {1: "1 1 1", 2: "1 2 1", 4: "2 2 1"}[RANKS]


def words(values):
    return " ".join(str(v) for v in values)


def vectors(table, names):
    return np.array([table[name] for name in names.split()]).T


def free(dim, disc):
    """Velocity = that of the fluid and force/drag, from the first step on."""
    flat, upright = np.array([1, 1, dim - 2]), np.array([dim - 2, dim - 2, 1])
    push, fluid, turn = PUSH * flat, FLUID * flat, TURN * upright
    done = run("in.free", dim=dim, depth=10 if dim == 3 else 0.5, push=words(push),
               flow=f"{ETA} velocity {words(fluid)} spin {words(turn)}" + (" shape disc" if disc else ""))
    table, thermo = read_dump("now.txt"), done.thermo()
    c = 3 * np.pi * ETA * (np.ones(9) if disc else 2 * table["radius"])
    what = f"{dim}d {'discs' if disc else 'spheres'}"
    v = fluid + push / c[:, None]
    n = np.arange(1, 10)
    start = np.array([4 * n, 20 * (0.5 + 0.45 * np.sin(3 * n)), (dim - 2) * 9 * np.cos(2 * n)]).T
    expect_close(f"{what}: velocity", vectors(table, "vx vy vz"), v, atol=1e-14)
    expect_close(f"{what}: path", vectors(table, "xu yu zu") - start, 2.0 * v, atol=1e-12)
    expect_close(f"{what}: spin", vectors(table, "omegax omegay omegaz"), np.tile(turn, (9, 1)), atol=1e-14)
    expect_close(f"{what}: dissipated power", thermo["f_move[1]"][-1], np.sum(push @ push / c), rtol=1e-12)
    expect_close(f"{what}: drag", [thermo[f"f_move[{m}]"][-1] for m in (2, 3, 4)], -9 * push, atol=1e-13)
    expect_close(f"{what}: number, hindrance", [thermo[f"f_move[{m}]"][-1] for m in (8, 9)], [9, 1])


def contact():
    """Gap of two spheres on a spring: multiplied by 1 - k dt (1/c1 + 1/c2) in each step."""
    k, c = 100.0, 6 * np.pi * 0.25 * 2 * np.array([1.0, 0.8])
    limit = c[1] / k    # of the smaller one
    done = run("in.pair", step=1e-3)
    thermo = done.thermo()
    expect_close("contact: gap", thermo["v_gap"], -0.02 * (1 - k * 1e-3 * np.sum(1 / c))**np.arange(11), rtol=1e-6)
    expect_close("contact: dissipated power", thermo["f_move[1]"][1], (k * 0.02)**2 * np.sum(1 / c), rtol=1e-5)
    expect("limit of the step in the log", f"stability limit {limit:.6g}\n" in done.text)
    expect("no warning below", "exceeds" not in done.text)
    expect("warning above", f"exceeds {limit:.4g}, the stability limit" in run("in.pair", step=1.01 * limit).text)


def pair_in_shear():
    """The oracle has a little inertia, St = 1e-4; steps are of first order."""
    ca, kt, y0, reach = 1e-3, 5e2, 1.0, 12.0
    paths = []
    for step in 2e-3, 1e-3:
        every = round(0.1 / step)
        rows = run(PAIR / "in.shear", motion="overdamped", g=1 / ca, k=1 / ca, kt=kt, y0=y0, reach=reach,
                   step=step, every=every, rows=140).thermo()
        paths.append(np.array([rows["v_X"], rows["v_Y"], rows["c_u"]]))
    pair = Pair(rate=1.0, eta=1.0, density=1e-4, g=1 / ca, kt=kt, reach=reach)
    states, _ = pair.solve((0, 0, 0), (-10, y0, 0), rows["Time"])
    exact = np.vstack([(states[XJ] - states[XI])[:2], np.exp(states[GAP])])
    near = (paths[0][2] > 0) & (paths[1][2] > 0) & np.isfinite(exact[2])
    for path in paths:
        path[2, ~near] = exact[2, ~near]
    errors = [np.max(np.abs(path - exact)[1:]) for path in paths]
    expect_close("pair in shear: height and gap", paths[1][1:], exact[1:], atol=1e-3)
    expect_close(f"first order, error {errors[1]:.1e}: ratio to that of twice the step", errors[0] / errors[1], 2.0, atol=0.2)


def same(what, a, b, rtol):
    for name in a:
        expect_close(f"{what}: {name}", a[name], b[name], rtol=rtol, atol=rtol)


def rheometer():
    """Whatever the mass and newton; a restart goes on bit for bit."""
    make_state(dim=2, phi=0.75)
    done = run("in.rheometer", grid=GRID)
    thermo, end = done.thermo(), read_dump("end.txt")
    again = run("in.rheometer", grid=GRID, part="second").thermo()
    other = read_dump("end.txt")
    for name, column in end.items():
        expect_close(f"restart: {name}", other[name], column)
    expect_close("restart: pressure", again["f_shear[4]"][-1], thermo["f_shear[4]"][-1])
    expect_close("no inertial stress", thermo["c_parts[5][1]"], 0.0)
    heavy = run("in.rheometer", density=1e4).thermo()
    same("density 1e4 instead of 1", heavy, thermo, 1e-10)
    off = run("in.rheometer", newton="off").thermo()
    same("newton off", off, thermo, 1e-8)


def cell():
    """In a cell that shears and dilates, particles without forces keep their place in it."""
    for motion in "rate 2 volume", "flow planar rate 0.5 volume":
        thermo = run("in.free", flow="1.0 cell", steps=14, shape="triclinic" if "planar" not in motion else "ortho",
                              deform=f"fix shear all deform/rheometer {motion} viscosity 1 every 3").thermo()
        table = read_dump("now.txt")
        n = np.arange(1, 10)
        start = np.array([n / 10, 0.5 + 0.45 * np.sin(3 * n), 0.5 + 0.45 * np.cos(2 * n)]).T
        edge = {name: thermo[name][-1] for name in ("Lx", "Ly", "Lz")}
        y = table["y"] / edge["Ly"]
        tilt = 0.0 if "planar" in motion else 2.0 * 1.4 * edge["Ly"]    # without the flips
        now = np.array([(table["x"] - tilt * y) / edge["Lx"], y, (table["z"] + 10) / edge["Lz"]]).T
        expect_close(f"{motion}: place in the cell", (now - start + 0.5) % 1.0 - 0.5, 0.0, atol=1e-12)
        expect_close(f"{motion}: spin", table["omegaz"], -1.0 if "planar" not in motion else 0.0, atol=1e-14)
        expect_close(f"{motion}: no drag", thermo["f_move[1]"][-1], 0.0, atol=1e-20)


free(3, False)
free(2, True)
rheometer()
if RANKS == 1:
    contact()
    pair_in_shear()
    cell()
finish()
