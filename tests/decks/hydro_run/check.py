# ranks: 1 4
"""fix hydro grid in runs: arrays that settle and shear, solutions that are held, ranks, restart, flip."""
import numpy as np

import deck
from oracle.spheres import write_spheres

OUTPUT = ("iterations", "residual", "xx", "yy", "zz", "xy", "xz", "yz", "heat", "fx", "fy", "fz", "solutions", "phi")
GRID = {1: "1 1 1", 4: "2 2 1"}[deck.RANKS]
SINGLE = deck.RANKS == 1    # on several ranks: what is summed over them
EXACT = "tol 1e-8 spacing 0.5 points 12 reach 8"


def read(what="in.cell", **variables):
    t = deck.run(what, **variables).thermo()
    t.update({name: t.pop(f"f_far[{n + 1}]") for n, name in enumerate(OUTPUT)})
    return t


def settling():
    """Terminal velocity of a simple cubic array after 32 solutions, also if they are held for many steps."""
    for phi, drag in ((0.001, 1.212205), (0.125, 4.18047), (0.343, 11.74646)):
        for every in (1, 25):
            t = read("in.array", phi=phi, push=6 * np.pi, hydro=f"grid every {every} {EXACT}", steps=32 * every)
            name = f"simple cubic array, phi {phi}, a solution every {every}"
            deck.expect_close(f"{name}: velocity", t["v_v"][-1], 1 / drag, rtol=2e-5)
            deck.expect_close(f"{name}: the fluid carries the force", t["fx"][-1], -6 * np.pi, rtol=2e-5)
            deck.expect_close(f"{name}: heat", t["heat"][-1], 6 * np.pi / drag, rtol=4e-5)
            deck.expect("never faster", np.max(t["v_v"]) < 1.3 / drag, f"{np.max(t['v_v']):.3g} of {1 / drag:.3g}")


def relaxation():
    """One sphere, solved in every step, decays as the exact solution of its drag."""
    phi, drag, step, density = 0.027, 2.009051, 0.002, 0.2
    t = read("in.array", phi=phi, v0=1.0, hydro=f"grid every 1 {EXACT} hold {drag} 2", step=step, density=density, steps=300)
    rate = 6 * np.pi * drag / (4 / 3 * np.pi * density)
    deck.expect_close("a sphere comes to rest", t["v_v"], np.exp(-rate * step * t["Step"]), atol=2e-5)


def viscosity():
    """Arrays of free spheres: FCM alone, by an independent program."""
    for basis, number, phi, shear in (("sc 1", 1, 0.1, 1.241567), ("bcc 1", 2, 0.05, 1.134932), ("sc 1", 1, 0.3, 1.787527)):
        t = read("in.array", basis=basis, phi=phi, shear=1.0, flow="fix flow all deform 1 xy erate 1.0 remap v",
                 hydro=f"grid every 1 {EXACT}", step=1e-6, steps=1)
        name = f"{basis[:-2]} array, phi {phi}"
        deck.expect_close(f"{name}: viscosity", 1 + t["xy"][0], shear, atol=1e-5 * shear)
        deck.expect_close(f"{name}: heat", t["heat"][0], (shear - 1) * number * 4 / 3 * np.pi / phi, rtol=1e-4)
        deck.expect_close(f"{name}: volume fraction", t["phi"][0], phi, rtol=1e-12)


def rounding():
    """Ranks and newton change nothing but digits at the end, those of the solution to its tolerance; a restart no bit."""
    names = ("xy", "yy", "heat", "PotEng", "KinEng")
    t = read(steps=60)
    others = [("newton off", {"newton": "off"})] + ([] if SINGLE else [("one rank", {"ranks": 1})])
    for other, variables in others:
        o = read(steps=60, **variables)
        for name in names:
            deck.expect_close(f"{other}: {name}", o[name], t[name], atol=1e-7 * np.max(np.abs(t[name])))
        deck.expect(f"{other}: iterations", np.array_equal(o["iterations"], t["iterations"]))
    servo = "deform/rheometer rate 1.0 pressure 40 start 1.0"
    now = {"flow": servo, "steps": 72, "grid": GRID}    # between two solutions
    whole, again = read(half="yes", **now), read("in.restarted", **now)
    deck.expect_same_bits("restart: particles", deck.read_dump("restarted.dump"), deck.read_dump("whole.dump"))
    deck.expect_same_bits("restart: output", again, whole)
    # under LAMMPS' own fix deform the last digits differ
    now = {"hydro": "grid every 7", "steps": 72, "grid": GRID}
    whole, again = read(half="yes", **now), read("in.restarted", **now)
    for name in names:
        deck.expect_close(f"restart, fix deform: {name}", again[name], whole[name], rtol=1e-9)
    deck.expect("restart, fix deform: solutions", np.array_equal(again["solutions"], whole["solutions"]))


def flip():
    """The cell that has flipped is the same: but for the error of its grid."""
    found = {f: read(steps=120, tilt=0.46, hydro="grid tol 1e-3", flow=f"deform 1 xy erate 1.0 remap v flip {f}") for f in ("yes", "no")}
    yes, no = found["yes"], found["no"]
    deck.expect("only one flips", np.ptp(yes["Xy"]) > 1.5 * np.ptp(no["Xy"]))
    for name in ("xy", "heat", "PotEng"):
        deck.expect_close(f"flip: {name}", yes[name], no[name], rtol=2e-3)
    deck.expect("flip: no solution because of it", np.array_equal(yes["solutions"], no["solutions"]))


ROWS = [f"c_power[{m}][{n}]" for n in (1, 2) for m in range(1, 12)]


def balance():
    """What the shear puts in is stored, kinetic, or turned into heat: by films, contacts and far field."""
    stress = "c_stress[8][1] c_stress[8][2] c_stress[8][3] c_stress[8][4] c_stress[8][5] c_stress[8][6]"
    errors = []
    for fraction in (1, 0.25):
        dt = 5e-4 * fraction
        t = read(step=dt, steps=int(240 / fraction), more=" ".join(["c_power", *ROWS, stress]))
        defect, heat = deck.power_balance(t, dt)
        errors.append(defect)
        share = heat[10]
    deck.expect("the far field takes part", share > 0.1, f"{share:.3g}")
    deck.expect("the balance of energy closes", errors[1] < min(0.3 * errors[0], 1e-3), f"{errors}")
    for n, name in enumerate(("xx", "yy", "zz", "xy", "xz", "yz")):
        deck.expect_close(f"row 8 is the stress of the fix: {name}", t[f"c_stress[8][{n + 1}]"], t[name], atol=1e-12)


def held():
    """Solutions every .01 of strain against those of every step."""
    t = {words: read(steps=200, hydro=words) for words in ("grid every 1 tol 1e-3", "grid strain 0.01", "grid strain 0.0025")}
    exact = t["grid every 1 tol 1e-3"]
    deck.expect("solutions every .01 of strain", np.array_equal(np.flatnonzero(np.diff(t["grid strain 0.01"]["solutions"])) + 1,
                                                               np.arange(20, 201, 20)))
    late = slice(100, None)
    for name in ("xy", "PotEng"):
        coarse, fine = (abs(np.mean(t[w][name][late]) / np.mean(exact[name][late]) - 1) for w in ("grid strain 0.01", "grid strain 0.0025"))
        print(f"held: {name} {coarse:.4f} {fine:.4f}")
        deck.expect(f"held: {name}", fine < 0.5 * coarse, f"{coarse:.4f} {fine:.4f}")


def cloud():
    """A ball of spheres in a cell that is empty elsewhere: what is held follows the spheres about a sphere, not those of the cell."""
    edge, n = 18.0, 2.2 * np.arange(-3, 4)
    x = np.array([(i, j, k) for i in n for j in n for k in n])
    x = x[np.linalg.norm(x, axis=1) < 4.6]
    x = x + np.random.default_rng(5).uniform(-0.08, 0.08, size=x.shape) + edge / 2
    write_spheres("spheres.data", np.diag([edge] * 3), x, np.ones(len(x)), 0 * x, 0 * x)
    d = x[:, None] - x + np.eye(len(x))[:, :, None]
    r = np.linalg.norm(d, axis=2)
    alone = np.eye(len(x)) + (1 - np.eye(len(x))) * 0.75 * (1 / r + d[:, :, 1]**2 / r**3)    # points in an unbounded fluid
    t = read("in.cloud")
    deck.expect("a cloud falls faster and faster", np.all(np.diff(t["v_v"]) > 0))
    deck.expect("faster than a sphere, slower than without images", 2 < t["v_v"][-1] < np.mean(alone.sum(axis=1)), t["v_v"][-1])
    deck.expect("no sphere is too fast", np.max(t["c_fastest"]) < 2 * t["v_v"][-1], np.max(t["c_fastest"]))


if __name__ == "__main__":
    deck.make_state()
    rounding()
    flip()
    if SINGLE:
        settling()
        relaxation()
        viscosity()
        balance()
        held()
        cloud()
    deck.finish()
