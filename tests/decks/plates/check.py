# ranks: 1 4
"""Plane Couette cell: momentum balance, kinematics, closed forms of the free plate, newton, 2d, several runs."""
import numpy as np

import deck

NAMES = ("strain", "rate", "gap", "vx", "vy", "phi", "p_low", "p_up", "xy_low", "xy_up", "zy_low", "zy_up",
         "target_x", "target_y", "state_x", "state_y")
DT = 5e-4


def read(what="in.plates", **variables):
    tables = deck.run(what, **variables).tables()
    for table in tables:
        table.update({name: table.pop(f"f_cell[{n + 1}]") for n, name in enumerate(NAMES)})
    return tables


def momentum(what, t, area, dt=DT, tolerance=1e-12):
    """Newton's second law for the suspended particles, with the forces that the plates report.

    Velocity Verlet changes their momentum by the mean of the forces at both ends of each step, exactly.
    """
    on_plates = {"px": area * (t["xy_low"] - t["xy_up"]), "py": area * (t["p_up"] - t["p_low"]),
                 "pz": area * (t["zy_low"] - t["zy_up"])}
    for name, force in on_plates.items():
        impulse = np.concatenate([[0], np.cumsum(0.5 * dt * (force[1:] + force[:-1]))])
        change = t["v_" + name] - t["v_" + name][0]
        size = dt * np.sum(area * (np.abs(t["p_up"]) + np.abs(t["xy_up"])))
        deck.expect_close(f"{what}: {name} of the suspension", change, -impulse, atol=tolerance * size)


def surfaces(dump):
    """Mean surfaces of both plates from the dump, an independent sum."""
    plate = dump["type"] == 2
    middle = 0.5 * (dump["yu"].min() + dump["yu"].max())
    low, up = plate & (dump["yu"] < middle), plate & (dump["yu"] > middle)
    return low, up, np.mean((dump["yu"] - dump["radius"])[up]) - np.mean((dump["yu"] + dump["radius"])[low])


deck.run("state.lmp", ranks=1)
area = 1.0

# momentum, geometry, all kinds of motion
for motion in ("rate 1 gap", "rate 1 pressure 5", "stress 10 load 5 mass 5", "iv 0.2 load 5 damper 3",
               "velocity 10 pressure 20 gain 2", "oscillate 0.5 2 30 pressure 5"):
    t, = read(motion=motion)
    area = t["Lx"][0] * t["Lz"][0]
    momentum(motion, t, area)
    d = deck.read_dump("plates.dump")
    low, up, gap = surfaces(d)
    deck.expect_close(f"{motion}: gap is that of the particles", t["gap"][-1], gap, rtol=1e-12)
    solid = np.sum(4 / 3 * np.pi * d["radius"][~low & ~up] ** 3)
    deck.expect_close(f"{motion}: volume fraction", t["phi"][-1], solid / (area * gap), rtol=1e-12)
    for name, of_upper in (("vx", t["vx"][-1]), ("vy", t["vy"][-1]), ("vz", 0), ("omegaz", 0)):
        deck.expect(f"{motion}: the plates have the {name} of their bodies",
                    np.all(d[name][low] == 0) and np.all(d[name][up] == of_upper))
    deck.expect_close(f"{motion}: the gap follows Vy", np.diff(t["gap"])[:20],
                      DT * (t["vy"][1:21] if "load" not in motion else 0.5 * (t["vy"][:20] + t["vy"][1:21])),
                      atol=1e-13 if "load" not in motion else 2e-6)
    middle = 0.5 * (t["gap"][1:] + t["gap"][:-1])
    deck.expect_close(f"{motion}: strain is the sum of the rates", np.diff(t["strain"]), DT * t["rate"][1:], atol=1e-15)
    if "stress" not in motion:
        deck.expect_close(f"{motion}: Vx = rate H", t["vx"][1:], t["rate"][1:] * middle, rtol=1e-13)
    if motion == "rate 1 gap":
        deck.expect_close("strain = rate t", t["strain"], t["Time"], atol=1e-14)
        deck.expect_close("Vx = rate H exactly", t["vx"][1:], t["gap"][0], rtol=1e-15)
        deck.expect("the gap is constant", np.all(t["gap"] == t["gap"][0]))
    if motion.startswith("velocity"):
        deck.expect("Vx as given", np.all(t["vx"][1:] == 10))
    if motion.startswith("iv"):
        deck.expect_close("rate = iv P/eta", t["rate"][1:], 0.2 * 5 / 1.0, rtol=1e-15)
    if motion.startswith("oscillate"):
        deck.expect_close("strain = g0 t + g1 sin(w t)/w", t["strain"],
                          0.5 * t["Time"] + 2 / 30 * np.sin(30 * t["Time"]), atol=1e-13)
    deck.expect(f"{motion}: the plates are pushed apart", t["p_up"][50:].mean() > 0 and t["p_low"][50:].mean() > 0)
    deck.expect(f"{motion}: the suspension holds the upper plate back", t["xy_up"][20:50].mean() > 0 < t["xy_low"][20:50].mean())
    deck.expect("targets", t["target_y"][-1] == (0 if "gap" in motion else 20 if "20" in motion else 5))

# a variable: its value at the end of each step
t, = read(motion="rate v_wave gap")
wave = 1 + 0.5 * np.sin(10 * t["Time"])
deck.expect_close("rate from a variable", t["rate"][1:], wave[1:], rtol=1e-13)

# newton off, and one rank, give the same; 2d
for dim in (3, 2):
    if dim == 2:
        deck.run("state.lmp", ranks=1, dim=2, phi=0.7)
    base, = read(dim=dim)
    for what, variables in (("newton off", {"newton": "off"}), ("one rank", {"ranks": 1}), ("boundary s", {"side": "s"})):
        other, = read(dim=dim, **variables)
        for name in ("gap", "vx", "p_low", "p_up", "xy_low", "xy_up", "zy_up", "phi"):
            scale = np.max(np.abs(base[name]))
            deck.expect_close(f"{dim}d {what}: {name}", other[name], base[name], atol=1e-8 * scale)
momentum("2d", base, base["Lx"][0])
d = deck.read_dump("plates.dump")
low, up, gap = surfaces(d)
deck.expect_close("2d: area fraction", base["phi"][-1],
                  np.sum(np.pi * d["radius"][~low & ~up] ** 2) / (base["Lx"][0] * gap), rtol=1e-12)
deck.expect("2d: in the plane", np.all(base["zy_up"] == 0) and np.all(d["vz"] == 0))
deck.run("state.lmp", ranks=1)

# a plate that touches nothing: m dV/dt = -A P - c V along y, A s - c' V along x; both schemes are exact in V
P, S, M, C, DRAG = 2.0, 3.0, 40.0, 300.0, 500.0
t, = read(motion=f"stress {S} load {P} mass {M} damper {C} drag {DRAG}", lift=10)
time, steps = t["Time"], t["Step"]
deck.expect("no contact", np.all(t["p_up"] == 0) and np.all(t["xy_up"] == 0))
deck.expect_close("load and damper", t["vy"], -area * P / C * (1 - np.exp(-C * time / M)), rtol=1e-12)
deck.expect_close("stress and drag", t["vx"], area * S / DRAG * (1 - np.exp(-DRAG * time / M)), rtol=1e-12)
fall = -area * P / C * (time - M / C * (1 - np.exp(-C * time / M)))
# midpoint rule: error of the position at most time dt^2 max|V''|/24
deck.expect_close("gap", t["gap"] - t["gap"][0], fall, atol=time[-1] * DT**2 * area * P * C / M**2 / 24)
t, = read(motion="rate 0 load 2", lift=10)
d = deck.read_dump("plates.dump")
mass = np.sum(d["mass"][surfaces(d)[1]])
deck.expect_close("default mass: that of the plate's particles", t["vy"], -area * 2 / mass * t["Time"], rtol=1e-12)

# the same in units where pressure is not force/area and force not mass*acceleration: bar, eV/A, g/mol, ps
BAR, ACCELERATION = 1.6021765e6, 1 / 1.0364269e-4
P, S, M, C, DRAG = 20 * BAR, 30 * BAR, 4.0, 30.0, 50.0
t, = read(motion=f"stress {S} load {P} mass {M} damper {C} drag {DRAG}", lift=10, units="metal", dt=1e-6, steps=50)
time = t["Time"]
deck.expect_close("metal: load", t["vy"], -area * 20 / C * (1 - np.exp(-C * ACCELERATION * time / M)), rtol=1e-6)
deck.expect_close("metal: stress", t["vx"], area * 30 / DRAG * (1 - np.exp(-DRAG * ACCELERATION * time / M)), rtol=1e-6)
t, = read(motion="rate 1 gap", units="metal", dt=1e-5, steps=50)
momentum("metal", t, area / BAR * ACCELERATION, dt=1e-5, tolerance=1e-6)    # of the constants
t, = read(motion=f"iv 0.2 load {5 * BAR}", units="metal", dt=1e-5, steps=50)
deck.expect_close("metal: rate = iv P/eta", t["rate"][1:], 1.0, rtol=1e-9)

# several runs are one run; a new motion goes on from the state; a new time step
whole, = read()
first, second, third, last = read("in.split", then="stress 50", late=2e-4)
joined = {name: np.concatenate([first[name], second[name][1:], third[name][1:]]) for name in NAMES}
for name in ("strain", "gap", "vx", "p_up", "xy_low"):
    deck.expect_close(f"three runs are one: {name}", joined[name], whole[name], atol=1e-9 * np.max(np.abs(whole[name])))
for name in ("strain", "gap", "vx", "vy"):
    deck.expect(f"fix_modify keeps {name}", last[name][0] == third[name][-1])
deck.expect_close("new time step", np.diff(last["strain"]), 2e-4 * last["rate"][1:], atol=1e-15)
deck.expect("stress drive goes on smoothly", abs(last["vx"][1] / last["vx"][0] - 1) < 0.1)
last = read("in.split", then="oscillate 0 3 20", late=1e-3)[-1]
deck.expect_close("clock of oscillate runs since it was set", last["strain"] - last["strain"][0],
                  3 / 20 * np.sin(20 * (last["Time"] - last["Time"][0])), atol=1e-13)

# a minimization moves the suspension only
deck.run("in.minimize", motion="rate 1")
a, b = deck.read_dump("before.dump"), deck.read_dump("after.dump")
moved = np.abs(a["y"] - b["y"])
deck.expect("minimization: the plates stay", np.all(moved[a["type"] == 2] == 0) and moved[a["type"] == 1].max() > 1e-3)

# targets that are never reached are told once
text = deck.run("in.plates", motion="rate 100 load 5", lift=10, steps=250).text
deck.expect("a plate that presses on nothing warns once", text.count("does not reach the pressure 5:") == 1)
deck.finish()
