# ranks: 1 4
"""One, two and three particles: at any corner of a cell that flips, on more ranks than particles, in 3d and 2d; alone under
imposed pressure and stress.

A flow with a homogeneous gradient has no place of its own: what two particles do to each other is the same in the middle of
the cell and across its faces, edges and corners, before and after flips, on one rank and on many.
"""
import numpy as np

from deck import RANKS, expect, expect_close, expect_error, finish, run

STRESS = ["c_stress[1][2]", "c_stress[2][4]", "c_stress[3][4]", "c_stress[4][4]", "c_stress[4][7]", "PotEng", "c_wz"]


def nearest(t, names, dim):
    """Relative position in the nearest image, by the edges of the cell (the tilt changes by whole edges)."""
    d = np.array([t[name] for name in names])
    if dim == 3:
        d[2] -= t["Lz"] * np.round(d[2] / t["Lz"])
    turns = np.round(d[1] / t["Ly"])
    d[1] -= turns * t["Ly"]
    d[0] -= turns * t["Xy"]
    d[0] -= t["Lx"] * np.round(d[0] / t["Lx"])
    return d


def corners():
    for N, dim in (2, 3), (3, 3), (2, 2), (3, 2):
        middle = run("in.cluster", ranks=1, N=N, dim=dim).thermo()
        expect(f"{N} particles in {dim}d: the cell flips", middle["Xy"].min() < -4 and middle["Xy"].max() > 4)
        expect(f"{N} particles in {dim}d: they meet and touch", np.max(np.abs(middle["c_stress[1][2]"])) > 1e-3,
               np.max(np.abs(middle["c_stress[1][2]"])))
        places = [(0.0, 0.0, 0.0), (11.999, 0.0, 6.0), (0.0, 11.999, 11.999)] if (N, dim) == (3, 3) else [(11.999, 0.0, 0.0)]
        for place in places:
            t = run("in.cluster", N=N, dim=dim, at_x=place[0], at_y=place[1], at_z=place[2],
                    newton="off" if place[0] > 0 else "on").thermo()
            what = f"{N} particles in {dim}d at {place}"
            for names in (["v_dx", "v_dy", "v_dz"], ["v_ex", "v_ey", "v_ez"]):
                expect_close(f"{what}: path", nearest(t, names, dim), nearest(middle, names, dim), atol=1e-8)
            for name in STRESS:
                expect_close(f"{what}: {name}", t[name], middle[name], atol=1e-8 * np.max(np.abs(middle[name])))


def alone_in_shear():
    """No stress at all, and the path of the flow; a kick dies out by Stokes' drag."""
    t = run("in.alone").thermo()
    expect_close("alone: follows the flow", t["c_at[1]"], 6 + 11.5 * t["Time"], rtol=1e-12)
    for name in [f"c_stress[{row}][{column}]" for row, column in ((1, 2), (1, 4), (3, 4), (4, 4), (5, 2), (5, 4))]:
        expect_close(f"alone: {name}", t[name], 0.0, atol=1e-24)
    expect_close("alone: volume fraction", t["f_shear[3]"], 4 / 3 * np.pi / 12**3, rtol=1e-14)

    kick, lag = 0.5, 4 / 3 * np.pi * 0.05 / (6 * np.pi)
    t = run("in.alone", kick=kick, fluid="fix fluid all drag/background pair cell", step=1e-4, steps=600).thermo()
    time, decay = t["Time"], np.exp(-t["Time"] / lag)
    # m w' = -c w - m rate vy for w = vx - rate y
    expect_close("kick: across", t["v_vy"], kick * decay, rtol=1e-10)
    expect_close("kick: height", t["c_at[2]"], 11.5 + kick * lag * (1 - decay), atol=1e-6)
    expect_close("kick: along", t["v_vx"] - t["c_at[2]"], kick * (1 - time) * decay, atol=1e-5)


def nobody():
    """An empty cell runs; the rheometer has nothing to measure and says so."""
    run("in.nobody")
    done = run("in.nobody", flow="fix shear all deform/rheometer rate 1 volume", fails=True)
    expect_error("empty cell", done.text, "Fix deform/rheometer: no particles with a radius in its group")


def alone_under_targets():
    """Nothing resists: dilation and rate follow the equations of the servos, solved here with no stress."""
    inertia, rest = 0.05 * 2**2, 1 / (1 + 2 * np.sqrt(0.05))    # I0 = rho d^2; rate of rearrangement at P = eta = 1
    w = np.hypot(1.0, 1e-4 * rest)
    dashpot, mass = np.hypot(1 / w, np.sqrt(8 * inertia)), 0.02 / w**2 + inertia
    dt = 1e-3
    done = run("in.alone", flow="rate 1 pressure 1 start 1 every 1", steps=1500)
    t = done.thermo()
    steps = np.arange(1501)
    dilation = -(1 - np.exp(-dashpot * steps * dt / mass)) / dashpot
    height = 12 * np.exp(dt * np.concatenate([[0], np.cumsum(dilation[:-1])]))
    expect_close("pressure on nothing: dilation", t["f_shear[8]"], dilation[::20], atol=1e-10)
    expect_close("pressure on nothing: phi(t)", t["f_shear[3]"], 4 / 3 * np.pi / (144 * height[::20]), rtol=1e-10)
    expect_close("pressure on nothing: affine", t["c_at[2]"], 11.5 / 12 * t["Ly"], rtol=1e-10)
    text = run("in.alone", flow="rate 1 pressure 1 start 1", steps=3000, fails=True).text
    expect("pressure on nothing: stops before the cell is too small", "has come below twice the cutoff 2.5" in text)

    t = run("in.alone", flow="stress 0.7 volume", steps=8000).thermo()
    expect_close("stress on nothing but fluid: rate s/eta", t["f_shear[2]"][-1], 0.7, rtol=1e-6)


corners()
alone_in_shear()
if RANKS == 1:
    alone_under_targets()
    nobody()
finish()
