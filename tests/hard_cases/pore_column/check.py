# ranks: 1
"""A column full of fluid: loads and given pressures that jump, fluid that cannot move or moves freely, a plate that opens, start and
stop, other ranks.
"""
import numpy as np

from deck import Path, expect, expect_close, finish, run

ABOVE, BELOW = "lower drained upper impermeable", "lower impermeable upper drained"
PLATES = {"gap": 3, "vy": 5, "p_low": 7, "p_up": 8}
PORE = {"lower": 1, "upper": 2, "mean": 3, "largest": 4, "flux_low": 5, "flux_up": 6, "heat": 7, "fy": 9, "iterations": 11}
AREA = 2.1 ** 2


def read(**variables):
    done = run("in.column", **variables)
    tables = done.tables()
    for t in tables:
        for fix, names in (("cell", PLATES), ("pore", PORE)):
            t.update({name: t[f"f_{fix}[{n}]"] for name, n in names.items() if f"f_{fix}[{n}]" in t})
    return tables, done.text


# ---- jumps: what is given at a drained plate acts at once, in the whole layer
for solver in ("solver grid", "solver cg"):
    (before, t), _ = read(pore=f"{BELOW} pressure v_given {solver}")
    rise = t["lower"][1:] - before["lower"][-1]
    expect_close(f"{solver}: a given pressure jumps by 2, and at once so does that at the closed plate", rise[:20], 2, atol=0.01)
    (_, without), _ = read(pore=f"{BELOW} {solver}")
    expect_close("  and goes on as if it had not", t["lower"][1:] - 2, without["lower"][1:], atol=3e-4)
    expect("  iterated", np.all(t["iterations"][1:9] > 0) and ((t["iterations"][20] > 0) == (solver == "solver cg")))

# ---- a load that jumps acts through the inertia of the plate: one solution a step follows it, if the plate is not too light
def jump(mass, solver):
    tables, text = read(pore=f"{ABOVE} {solver}", motion=f"load 1 mass {mass}", change="fix_modify cell load 2", settle=0.6)
    return tables[1], "lets the pressure lag" in text


for mass, light in ((20, True), (200, False), (2000, False)):
    one, warned = jump(mass, "solver grid")
    all_, never = jump(mass, "solver cg")
    expect(f"plate of {mass}: warning of a light plate", warned == light and not never, f"{warned}")
    apart = np.max(np.abs(one["upper"] - all_["upper"]))
    expect(f"plate of {mass}: one solution a step, and cg", (apart > 0.1) == light, f"{apart:.3f} of the jump")
    if not light:
        expect("  nearly the same", apart < 0.1, f"{apart:.3f}")
    if mass < 2000:    # which swings for longer
        expect_close(f"plate of {mass}: cg, load of fluid and spheres in the end", np.mean(all_["p_low"][150:]), 2, atol=0.06)

# ---- a fluid that cannot move: the grid leaves it the spheres next to the drained plate. And one that moves as if it were not there
for k, drag in ((1e-12, 1e10), (1e-15, 1e13)):
    (_, t), _ = read(k=k, drag=drag, settle=2e-3 / drag, steps=2000, every=20)
    moved = t["gap"][0] - t["gap"]
    expect_close(f"k {k:g}: the fluid carries the load", t["lower"][-30:], 1, atol=1e-4)
    expect("  the springs do not settle", np.all(moved < 0.05 * 20 * AREA / 1000), f"{np.max(moved):.1e}")
    energy, given = t["PotEng"] + t["KinEng"], AREA * moved
    expect("  energy: no more than the load has given", np.max(energy) <= np.max(given), f"{np.max(energy):.2e} {np.max(given):.2e}")
    expect_close("  at rest", t["KinEng"][-1], 0, atol=1e-12)
(_, t), _ = read(k=1, drag=1e-30, settle=2e27, steps=100)
(_, dry), _ = read(k=1, drag=1e-30, settle=2e27, steps=100, **{"with": "no"})
for name in ("gap", "vy", "PotEng"):
    expect_close(f"no drag: as dry, {name}", t[name], dry[name], atol=1e-20)

# ---- a plate that opens: clear fluid beside the packing. Spheres are held: Darcy's law layer by layer
(_, t), _ = read(held="yes", motion="load -1 damper 30", pore=ABOVE + " solver cg", law="kozeny", settle=1e-3, steps=3000, every=100, drag=1e-4)
lines = [line.split() for line in Path("layers.txt").read_text().splitlines() if not line.startswith("#")]
y, p, phi, u, q = np.array(lines[-int(lines[-1][0]):], dtype=float)[:, 1:].T
height = t["gap"][-1] / len(y)
k = 2 * 0.25 * (1 - np.maximum(phi, 0.02)) ** 3 / (9 * np.maximum(phi, 0.02) * 10 * np.maximum(phi, 0.02))
eta = 1e-4 * 1e-3 / (0.9 / np.sqrt(1000)) / AREA
expect("the plate has opened: a layer of clear fluid", t["gap"][-1] > 24 and phi[-1] < 1e-3, f"{t['gap'][-1]:.3g} {phi[-1]:.1e}")
expect("  contrast of permeability", k.max() / k.min() > 30, f"{k.max() / k.min():.3g}")
expect_close("  suction at the plate, of the flow that follows it", t["upper"][-1], -eta * t["vy"][-1] * np.sum(height / k), rtol=2e-3)
expect_close("  the same flux everywhere", q, t["vy"][-1], rtol=2e-3)
expect_close("  it enters below", -t["flux_low"][-1], t["vy"][-1], rtol=2e-3)

# ---- start and stop: 150 steps and 150 more are 300; a load of which most is taken off again
OFTEN = BELOW + " every 1"
(_, whole), _ = read(pore=OFTEN)
ends = read(pore=OFTEN, steps=150, change="run 150")[0][-1]
for name in ("gap", "vy", "lower", "p_up", "PotEng"):
    expect_close(f"two runs for one: {name}", ends[name][-1], whole[name][-1], rtol=1e-7, atol=1e-12)
(_, t), _ = read(change="fix_modify cell load 0.2", settle=0.5, steps=9000, every=90)
expect("a load that is taken off: the fluid is sucked in, not out", np.min(t["lower"]) < -0.3, f"{np.min(t['lower']):.3f}")
expect_close("  and the column rises to the height of the load that is left", t["gap"][-1], 20 - 0.2 * 20 * AREA / 1000, atol=0.06 * 0.8 * 20 * AREA / 1000)

# ---- a restart on other ranks
run("in.column", ranks=1, write="yes", pore=OFTEN)
(one,), _ = read(restarted="yes", pore=OFTEN)
(four,), _ = read(restarted="yes", pore=OFTEN, ranks=4, grid="1 4 1")
for name in ("gap", "vy", "lower", "mean", "p_up", "heat"):
    expect_close(f"restart on four ranks: {name}", four[name], one[name], atol=1e-9 * np.max(np.abs(one[name])))
    expect_close(f"  as the run that goes on: {name}", one[name][1:], whole[name][1:], atol=1e-10 * np.max(np.abs(one[name])))
finish()
