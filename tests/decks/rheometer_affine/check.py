# ranks: 1 4
"""A lattice in the flow and a cloud without forces keep their places in the cell, whatever the rates do.

The oracle knows the edges of the cell only: contacts of the lattice are edges/n, and change at the rate of the edges.
"""
import itertools

import numpy as np

import deck

DT, STIFFNESS, DAMPING = 1e-3, 1000.0, 50.0
CORNER = np.array([-3, 2, -1])


def edges(t):
    h = np.zeros((len(t["Lx"]), 3, 3))
    h[:, 0, 0], h[:, 1, 1], h[:, 2, 2], h[:, 0, 1] = t["Lx"], t["Ly"], t["Lz"], t["Xy"]
    return h


def lattice(what, n=4, dim=3, flow="shear", flips=0, **variables):
    t = deck.run("in.lattice", n=n, dim=dim, flow=flow, **variables).thermo()
    h = edges(t)
    turns = np.cumsum(np.append(0, np.round(-np.diff(t["Xy"]) / t["Lx"][1:])))
    h[:, :, 1] += turns[:, None] * h[:, :, 0]    # the same contacts after a flip
    deck.expect(f"{what}: flips", abs(turns[-1]) == flips, f"{turns[-1]:g}")
    mass = 4 / 3 * np.pi
    stress = np.zeros((len(h) - 1, 3, 3))
    for steps in itertools.product(*[range(-2, 3)] * dim):
        steps = np.array(steps + (0,) * (3 - dim))
        if not steps.any():
            continue
        r, rate = h[1:] @ steps / n, np.diff(h, axis=0) @ steps / DT / n
        distance = np.linalg.norm(r, axis=1)
        normal = r / distance[:, None]
        force = STIFFNESS * (2 - distance) - DAMPING * mass / 2 * np.sum(normal * rate, axis=1)
        force[distance >= 2] = 0
        stress -= 0.5 * force[:, None, None] * normal[:, :, None] * r[:, None, :] * n ** dim
    size = t["Lx"] * t["Ly"] * (t["Lz"] if dim == 3 else 1)
    stress /= size[1:, None, None]
    xx, yy, zz, xy = stress[:, 0, 0], stress[:, 1, 1], stress[:, 2, 2], stress[:, 0, 1]
    pressure, driving = {"shear": (-yy, xy), "planar": (-(xx + yy + zz) / dim, xx - yy),
                         "uniaxial": (-(xx + yy + zz) / dim, xx - 0.5 * (yy + zz))}[flow]
    scale = np.max(np.abs(stress))
    deck.expect_close(f"{what}: pressure", t["f_rheometer[4]"][1:], pressure, atol=1e-9 * scale)
    deck.expect_close(f"{what}: driving stress", t["f_rheometer[5]"][1:], driving, atol=1e-9 * scale)
    # rate and dilation of the thermo output are those of the next step
    rate = np.diff(t["f_rheometer[1]"]) / DT
    deck.expect_close(f"{what}: strain follows the rate", rate, t["f_rheometer[2]"][:-1], atol=1e-9)
    deck.expect_close(f"{what}: volume follows the dilation", np.diff(np.log(size)) / DT, t["f_rheometer[8]"][:-1],
                      atol=1e-9)
    return t


def affine(name, h, rate):
    """Velocities relative to the flow, spins relative to its vorticity, and places in the cell."""
    dump = deck.read_dump(name)
    x = np.array([dump[c] for c in "xyz"]).T - CORNER
    v = np.array([dump["v" + c] for c in "xyz"]).T
    spin = np.array([dump["omega" + c] for c in "xyz"]).T
    gradient = rate @ np.linalg.inv(h)
    spin[:, 2] += 0.5 * gradient[0, 1]
    return v - x @ gradient.T, spin, x @ np.linalg.inv(h).T, v


def cloud(what, dim=3, members=1000, **variables):
    run = deck.run("in.cloud", dim=dim, members=members, **variables)
    deck.expect(f"{what}: warnings", run.text.count("this system cannot reach it") == ("cannot" in what))
    tables = run.tables()
    h = edges(tables[-1])
    rate = (h[1] - h[0]) / DT
    deviation, spin, place, v = affine("last.dump", h[0], rate)
    first = edges(tables[0])[0]
    before = affine("first.dump", first, 0 * first)[2]
    flowing = np.arange(1, len(v) + 1) <= members
    change = (place - before)[flowing][:, 1:dim]
    deck.expect_close(f"{what}: places in the cell stay", change, np.round(change), atol=1e-12)
    deck.expect_close(f"{what}: velocities follow the flow", deviation[flowing], 0,
                      atol=1e-12 * (1 + np.max(np.abs(rate))))
    deck.expect_close(f"{what}: spins follow the flow", spin[flowing], 0, atol=1e-12)
    if members < len(v):
        deck.expect_close(f"{what}: the others do not", v[~flowing], 0)
    return tables


lattice("shear", drive="rate 1", steps=300)
lattice("random rates", drive="rate v_chance", newton="off")
for sign in (1, -1):
    lattice(f"flip {sign}", drive=f"rate {sign}", tilt=0.4 * sign, flips=1)
t = lattice("oscillation", drive="oscillate 0.5 2 30")
time = DT * t["Step"]
deck.expect_close("oscillation: strain", t["f_rheometer[1]"], 0.5 * time + 2 / 30 * np.sin(30 * time), atol=1e-13)
deck.expect_close("oscillation: tilt", t["Xy"] / t["Ly"], t["f_rheometer[1]"], atol=1e-13)
t = lattice("oscillation of growing amplitude", drive="oscillate 0 v_growing v_thirty")
step = t["Step"]    # the mean over a step in which the amplitude is that of its beginning
mean = np.cos(30 * DT * (step + 0.5)) * np.sinc(0.5 * 30 * DT / np.pi)
deck.expect_close("oscillation: growing rate", t["f_rheometer[2]"][1:], (0.01 * step * mean)[1:], atol=1e-12)
t = lattice("expanding flip", drive="rate 1", tilt=0.4, hold="pressure 1 gain 0.1", flips=1)
limited = t["f_rheometer[8]"][:-1] >= (1 - 1e-12) / np.hypot(1 / 0.1, np.sqrt(8 * 4))    # P/C of the servo
deck.expect("state at the limit of the dilation", np.array_equal(t["f_rheometer[10]"][1:], np.where(limited, 2, 1)),
            f"{limited.sum()} steps")
deck.expect("the limit is met", limited.any())
deck.expect("it expands", t["Ly"][-1] > 1.02 * t["Ly"][0], f"{t['Ly'][-1] / t['Ly'][0]:.3f}")
t = lattice("compressing flip", drive="rate 1", tilt=0.4, hold="pressure 1e4 gain 0.1", flips=1, newton="off")
deck.expect("it is compressed", t["Ly"][-1] < 0.98 * t["Ly"][0], f"{t['Ly'][-1] / t['Ly'][0]:.3f}")
lattice("random rates and dilations", drive="rate v_chance", hold="pressure 1e4 gain 0.1")
lattice("2d", dim=2, drive="rate 2", tilt=0.4, hold="pressure 1e4 gain 0.1", flips=1)
lattice("planar", flow="planar", drive="rate 0.3")
lattice("planar, random rates", flow="planar", drive="rate v_chance", hold="pressure 1e4 gain 0.1")
lattice("planar 2d", flow="planar", dim=2, drive="rate 0.3", hold="pressure 1e4 gain 0.1")
lattice("uniaxial", flow="uniaxial", drive="rate -0.3", newton="off")
lattice("uniaxial, random rates", flow="uniaxial", drive="rate v_chance", hold="pressure 1 gain 0.1")

def free_flight(rate=2.0, time=2.0):
    """v'_y stays and v'_x = -rate v'_y t for particles that cross the boundary in the step of a flip, as in any other."""
    tables = deck.run("in.cloud", start=rate, drive=f"rate {rate}", then=f"rate {rate}", heat=100,
                      neighbors="every 20 check no", steps=int(time / DT)).tables()
    first, last = [affine(name, h, rate * np.array([[0, h[1, 1], 0], [0, 0, 0], [0, 0, 0]]))[0]
                   for name, h in (("first.dump", edges(tables[0])[0]), ("last.dump", edges(tables[-1])[0]))]
    first[:, 0] -= rate * time * first[:, 1]
    deck.expect_close("free flight", last, first, atol=1e-9)
    # without walls and boundaries it is a straight line
    first, last = deck.read_dump("first.dump"), deck.read_dump("last.dump")
    for axis in "xyz":
        there = first[f"{axis}u"] + time * first[f"v{axis}"]
        deck.expect_close(f"free flight, {axis}", last[f"{axis}u"], there, atol=1e-9)


def film(what, dim=3, rate=0.01, flips=0, **variables):
    """The film of nu_t between neighbors sees the velocity rate d/2: half of it is the flow, half the spin."""
    t = deck.run("in.film", dim=dim, rate=rate, **variables).thermo()
    a, gap, eta = 1.0, 0.1, 3.0
    nu = 0.5 * np.pi * eta * (-2 * a + (2 * a + gap) * np.log((2 * a + gap) / gap))
    d = 2 * a + gap
    stress = nu * rate * d / 2 * d / d ** dim
    deck.expect(f"{what}: flips", np.sum(np.diff(t["Xy"]) * rate < 0) == flips)
    deck.expect_close(what, t["f_rheometer[5]"][2:], stress, rtol=2e-3)


film("film")
film("film before and after a flip", tilt=4.2 - 50 * 1e-3 * 0.01 * 8.4, flips=1)
film("film before and after a flip backwards", tilt=-4.2 + 50 * 1e-3 * 0.01 * 8.4, flips=1, rate=-0.01)
film("film in 2d", dim=2, rate=-0.01)
free_flight()
compressing = "pressure 1 gain 0.05"
for dim in (3, 2):
    cloud(f"cloud {dim}d", dim=dim)
    cloud(f"cloud {dim}d, dilation", dim=dim, hold=compressing, then="rate -3")
cloud("half of the cloud", members=200, hold=compressing)
cloud("stop", drive="rate 5", then="rate 0", hold=compressing)
cloud("reversal", drive="rate 5", then="rate -5")
tables = cloud("a pressure that cannot be reached", drive="rate 15", hold=compressing, then="rate 15")
deck.expect("is judged so", tables[1]["f_rheometer[10]"][-1] == 3)
deck.expect("fix_modify begins anew", tables[-1]["f_rheometer[10]"][-1] == 1, tables[-1]["f_rheometer[10]"])
cloud("ramp", drive="rate v_ramp", hold=compressing, then="rate 0")
cloud("oscillation", drive="oscillate 1 5 20", hold=compressing, then="oscillate 0 3 100")
cloud("oscillation of growing amplitude", drive="oscillate 0 v_ramp 20", hold=compressing, then="rate 0")
for flow in ("planar", "uniaxial"):
    cloud(flow, flow=flow, drive="rate v_ramp", hold=compressing, steps=200, then="rate -1")
deck.finish()
