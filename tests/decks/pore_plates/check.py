# ranks: 1 4
"""Pore fluid between plates: Terzaghi's column, imposed dilation, the stress on the plates, momentum, restart."""
import numpy as np

import deck

PLATES = ("strain", "rate", "gap", "vx", "vy", "phi", "p_low", "p_up", "xy_low", "xy_up", "zy_low", "zy_up")
PORE = ("lower", "upper", "mean", "largest", "flux_low", "flux_up", "heat", "fx", "fy", "fz", "iterations", "residual",
        "k_min", "k_max", "step", "power")
DT = 5e-4


def read(what, **variables):
    t = deck.run(what, **variables).thermo()
    for fix, names in (("pore", PORE), ("cell", PLATES)):
        t.update({name: t[f"f_{fix}[{n + 1}]"] for n, name in enumerate(names) if f"f_{fix}[{n + 1}]" in t})
    return t


def terzaghi(time):
    """p over the load at the closed end, settlement over its last value; time T = cv t/H^2. K. Terzaghi (1923)."""
    m = (2 * np.arange(2000)[:, None] + 1) * np.pi / 2
    decay = np.exp(-m**2 * time)
    return np.sum(2 * np.sin(m) / m * decay, axis=0), 1 - np.sum(2 / m**2 * decay, axis=0)


# ---- a stack of 20 spheres settles under a load, at 0.9 of the largest time step of its contacts
# own values of the series: 4000 terms, with another program
deck.expect_close("the series", terzaghi(np.array([0.05, 0.2, 0.5])),
                  [[0.996869, 0.772312, 0.370777], [0.252313, 0.504088, 0.763950]], atol=1e-6)
MIRROR = "lower drained upper impermeable"
CASES = (    # variables, largest errors of p and of the settlement; from T = 0.02 on, or from 0.06 where the plate bounces
    ({}, 0.002, 0.002), ({"ny": 13, "until": 0.3}, 0.016, 0.002), ({"ny": 10, "until": 0.3}, 0.006, 0.002), ({"drag": 12}, 0.002, 0.002),
    ({"drag": 1240, "until": 0.04}, 0.001, 0.002), ({"solver": "solver cg", "until": 0.1}, 0.002, 0.002),
    ({"pore": MIRROR, "until": 0.2}, 0.012, 0.006),
    ({"pore": MIRROR, "until": 0.1, "motion": "load 1 mass 2", "share": 0.4, "solver": "solver cg"}, 0.006, 0.003))
for case, of_p, of_u in CASES if deck.RANKS == 1 else CASES[3:4]:
    t = read("in.column", **case)
    late = t["v_t"] > (0.06 if case.get("pore") == MIRROR and "solver" not in case else 0.02)
    time, modulus, H = t["v_t"][late], t["v_modulus"][0], t["gap"][0]
    p, settled = terzaghi(time)
    closed, leak = ("upper", "flux_low") if case.get("pore") == MIRROR else ("lower", "flux_up")
    u = (H - t["gap"][late]) / (H / modulus)
    deck.expect_close(f"{case}: pressure at the closed end", t[closed][late], p, atol=of_p)
    deck.expect_close(f"{case}: settlement", u, settled, atol=of_u)
    for plate in ("p_low", "p_up"):
        deck.expect_close(f"{case}: {plate} is the load, of fluid and spheres", t[plate][late], 1, atol=2e-3)
    deck.expect_close(f"{case}: what flows out is what the plate takes", t[leak][late], -t["vy"][late], rtol=0.05)
    on_gap = t["Ly"] / t["gap"]
    deck.expect_close(f"{case}: row 7 is minus the mean pressure", t["c_stress[7][2]"] * on_gap, -t["mean"], rtol=1e-12)
    deck.expect_close(f"{case}: stress of fluid and spheres, but for half a sphere at each plate",
                      ((t["c_stress[1][2]"] + t["c_stress[7][2]"]) * on_gap)[late], -1, atol=0.06)

# ---- a plate on which one solution a step lags says so
for mass, solver in ((2, "grid"), (2, "cg"), (2000, "grid")) if deck.RANKS == 1 else ():
    text = deck.run("in.column", pore=MIRROR, motion=f"load 1 mass {mass}", solver=f"solver {solver}", share=0.4, until=0.001, outputs=1).text
    deck.expect(f"mass {mass}, solver {solver}: the warning of a light plate", ("so light that solver grid" in text) == (mass == 2 and solver == "grid"))

# ---- spheres that part at a given rate suck: p = -(eta e/2k) (H^2 - y^2) between a closed and an open plate
RATE = 1e-3
t = read("in.column", dilation=RATE, solver="coupling off", until=0, outputs=1)
H = t["gap"][0]
size = t["v_eta"][0] * RATE * H**2 / (2 * 1e-3)
deck.expect_close("dilation: pressure at the bottom", t["lower"][0], -size, rtol=1e-7)
deck.expect_close("dilation: mean pressure, of a grid of 20", t["mean"][0], -size * (2 / 3 + 1 / (6 * 20**2) * -1), rtol=1e-6)
for n in (5, 10):
    y = np.array([n - 1, n]) / 20
    deck.expect_close(f"dilation: pressure of layer {n}", t[f"f_pore[{n}][2]"][0], -size * (1 - np.mean(y**2)), rtol=1e-7)
deck.expect_close("dilation: velocity of layer 5", t["f_pore[5][4]"][0], RATE * 4.5, rtol=1e-10)
deck.expect_close("dilation: flux of layer 10", t["f_pore[10][5]"][0], -RATE * 9.5, rtol=1e-7)

# ---- a sheared suspension: what it gains the plates and, where it is drained, the fluid outside lose
deck.run(deck.ROOT / "tests" / "decks" / "plates" / "state.lmp", ranks=1)
WALLS = {"open": "lower drained upper drained", "below closed": "lower impermeable upper drained",
         "above closed": MIRROR, "closed": "lower impermeable upper impermeable"}
OUTSIDE = 3.0


def sheared(walls, motion, pore="", **variables):
    words = f"plates cell {WALLS[walls]} {pore}" + ("" if walls == "closed" else f" pressure {OUTSIDE}")
    return read("in.sheared", before=f"fix pore between pore/pressure 1 {words}", motion=motion, **variables)


for walls, motion, pore in (("open", "rate 1 pressure 5", ""), ("below closed", "stress 10 load 5 mass 5", ""),
                            ("above closed", "stress 10 load 5 mass 5", ""), ("above closed", "rate 1 gap", "solver cg"),
                            ("closed", "rate 1 gap", ""), ("closed", "rate 1 load 5", "storage 0.01")):
    t = sheared(walls, motion, pore)
    what, area = f"{walls}, {motion}", t["Lx"][0] * t["Lz"][0]
    force = {"x": t["xy_low"] - t["xy_up"], "y": t["p_up"] - t["p_low"], "z": t["zy_low"] - t["zy_up"]}
    force["y"] = force["y"] + OUTSIDE * (("upper drained" in WALLS[walls]) - ("lower drained" in WALLS[walls]))
    scale = DT * np.sum(area * (np.abs(t["p_up"]) + np.abs(t["xy_up"])))
    for name, f in force.items():
        impulse = area * np.concatenate([[0], np.cumsum(0.5 * DT * (f[1:] + f[:-1]))])
        change = t[f"v_p{name}"] - t[f"v_p{name}"][0]
        deck.expect_close(f"{what}: p{name} of the suspension", change, -impulse, atol=1e-12 * scale)
    for plate, name in (("lower", "lower drained"), ("upper", "upper drained")):
        if name in WALLS[walls]:
            deck.expect(f"{what}: pressure at the {plate} plate as given", np.all(np.abs(t[plate] - OUTSIDE) < 1e-12))
    d = deck.read_dump("plates.dump")
    plate = d["type"] == 2
    middle = 0.5 * (d["y"].min() + d["y"].max())
    on_wall = area * (t["upper"][-1] * ("upper impermeable" in WALLS[walls]) - t["lower"][-1] * ("lower impermeable" in WALLS[walls]))
    drained = area * OUTSIDE * (("upper drained" in WALLS[walls]) - ("lower drained" in WALLS[walls]))
    size = np.sum(np.abs(d["f_pore[2]"]))
    deck.expect_close(f"{what}: forces of the fluid, on what is outside, too", np.sum(d["f_pore[2]"]) + drained, 0, atol=1e-11 * size)
    deck.expect_close(f"{what}: of them through the grid", t["fy"][-1], -on_wall - drained, atol=1e-11 * size)
    deck.expect(f"{what}: the pores act", t["largest"].max() > 1 and t["power"][1:].max() > 0)

# ranks and newton; a restart
EXACT = "tolerance 1e-12"    # of iterations that end at the default, ranks see the last digits
base = sheared("above closed", "stress 10 load 5 mass 5", EXACT)
for what, variables in (("one rank", {"ranks": 1}), ("newton off", {"newton": "off"})):
    other = sheared("above closed", "stress 10 load 5 mass 5", EXACT, **variables)
    for name in ("gap", "vx", "vy", "p_low", "p_up", "xy_low", "lower", "upper", "mean", "flux_low", "heat", "power"):
        scale = np.max(np.abs(base[name]))
        deck.expect_close(f"{what}: {name} of the first steps", other[name][:5], base[name][:5], atol=1e-10 * scale)
        deck.expect_close(f"{what}: {name}", other[name], base[name], atol=1e-8 * scale)
GRID = {1: "1 1 1", 2: "1 2 1", 4: "2 2 1"}[deck.RANKS]
whole = sheared("above closed", "stress 10 load 5 mass 5", steps=60, half="yes", grid=GRID)
again = read("in.restarted", grid=GRID, motion="stress 10 load 5 mass 5",
             before=f"fix pore between pore/pressure 1 plates cell {MIRROR} pressure {OUTSIDE}")
a, b = deck.read_dump("whole.dump"), deck.read_dump("restarted.dump")
for name in a:
    deck.expect(f"restart, bit for bit: {name}", np.array_equal(a[name], b[name]), f"{np.max(np.abs(a[name] - b[name])):.1e}")
for name in PORE + PLATES:
    deck.expect(f"restart, bit for bit: {name}", np.array_equal(whole[name][1:], again[name][1:]),
                f"{np.max(np.abs(whole[name][1:] - again[name][1:])):.1e}")
deck.finish()
