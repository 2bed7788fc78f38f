# ranks: 1 4
"""fix drag/background against closed forms: relaxation and terminal velocity over nine decades of St, power and energy,
order, flows, hindrance, isolated particles and the others, restart.
"""
from pathlib import Path

import numpy as np

from deck import RANKS, expect, expect_close, expect_same_bits, finish, read_dump, run

START, SPIN, PUSH = np.array([0.3, -0.7, 0.2]), np.array([0.4, 0.1, -0.5]), np.array([0.02, -0.05, 0.03])
FLUID, TURN = np.array([0.1, 0.2, -0.3]), np.array([-0.2, 0.3, 0.6])
ETA, STEP = 0.8, 0.1
V, W, X = "vx vy vz".split(), "omegax omegay omegaz".split(), "xu yu zu".split()


def vectors(table, names):
    return np.array([table[name] for name in names]).T


def words(values):
    return " ".join(str(v) for v in values)


def spheres(**variables):
    """Thermo output, and the particles at the end."""
    Path("now.txt").unlink(missing_ok=True)
    return run("in.spheres", **variables).thermo(), read_dump("now.txt")


def resistance(table, disc=False):
    """Coefficients of translation and rotation, and moments of inertia."""
    r, m = table["radius"], table["mass"]
    if disc:
        return 3 * np.pi * ETA + 0 * r, 4 * np.pi * ETA * r**2, 0.5 * m * r**2
    return 6 * np.pi * ETA * r, 8 * np.pi * ETA * r**3, 0.4 * m * r**2


def relaxation(dim, disc, steps, newton):
    """Velocities and spins are exact, whatever the ratio of the step to the relaxation time."""
    flat, upright = np.array([1, 1, dim - 2]), np.array([dim - 2, dim - 2, 1])
    start, push, fluid, spin, turn = START * flat, PUSH * flat, FLUID * flat, SPIN * upright, TURN * upright
    _, table = spheres(dim=dim, depth=10 if dim == 3 else 0.5, disc="disc" if disc else "", steps=steps, newton=newton,
                       step=STEP, start=words(start), spin=words(spin), push=words(push),
                       drag=f"{ETA} velocity {words(fluid)} spin {words(turn)}" + (" shape disc" if disc else ""))
    c, c_spin, inertia = resistance(table, disc)
    what = f"{dim}d {'discs' if disc else 'spheres'}, {steps} steps"
    ratio = STEP * c / table["mass"]
    print(f"{what}: step over relaxation time {ratio.min():.1e} to {ratio.max():.1e}")
    end = fluid + push / c[:, None]
    decay = np.exp(-steps * ratio)[:, None]
    expect_close(f"{what}: velocity", vectors(table, V), end + (start - end) * decay, atol=1e-12)
    decay = np.exp(-steps * STEP * c_spin / inertia)[:, None]
    expect_close(f"{what}: spin", vectors(table, W), turn + (spin - turn) * decay, atol=1e-12)


def power_and_energy():
    """At the terminal velocity the drag balances the other forces; nothing is lost but by the step."""
    thermo, table = spheres(drag=ETA, push=words(PUSH), step=1e3, least=1e-9)
    c = resistance(table)[0]
    expect_close("dissipated power", thermo["f_drag[1]"][-1], np.sum(PUSH @ PUSH / c), rtol=1e-12)
    expect_close("force on the particles", [thermo[f"f_drag[{n}]"][-1] for n in (2, 3, 4)], -9 * PUSH, rtol=1e-12)
    expect_close("number, hindrance", [thermo[f"f_drag[{n}]"][-1] for n in (8, 9)], [9, 1])
    thermo, table = spheres(drag=f"{ETA} velocity {words(FLUID)}", push=words(PUSH), least=1e-9)
    late = np.diff(thermo["f_drag"])[-1] / STEP
    expect_close("energy given to the fluid per time", late, np.sum(PUSH @ (FLUID + PUSH / c[:, None]).T), rtol=1e-12)

    loss = []
    for step in 0.2, 0.1:
        thermo, table = spheres(drag=ETA, start=words(START), spin=words(SPIN), least=10, step=step, steps=round(2 / step))
        inertia = resistance(table)[2]
        turning = 0.5 * inertia * (SPIN @ SPIN - np.sum(vectors(table, W)**2, axis=1))
        lost = thermo["KinEng"][0] - thermo["KinEng"][-1] + turning.sum()
        loss.append(thermo["f_drag"][-1] / lost - 1)
        expect_close("ecouple", thermo["Ecouple"][-1], thermo["f_drag"][-1], rtol=1e-14)
    expect_close(f"energy, error {loss[1]:.1e}: ratio to that of twice the step", loss[0] / loss[1], 4.0, atol=0.2)


def order():
    """A spring pulls from x = 0 to 0.1 c/k: with inertia (St > 1) second order, without it first order."""
    k = 2.0
    for least, step, duration, power in (10, 0.05, 2.0, 2), (1e-9, 0.2, 12.0, 1):
        errors = []
        for h in step, step / 2:
            _, table = spheres(drag=f"{ETA} velocity 0.1 0 0", spring=k, least=least, step=h, steps=round(duration / h))
            c, m = resistance(table)[0][0], table["mass"][0]
            b, w = c / (2 * m), np.sqrt(complex(k / m - (c / (2 * m))**2))
            decay = np.exp(-k / c * duration) if power == 1 else \
                (np.exp(-b * duration) * (np.cos(w * duration) + b / w * np.sin(w * duration))).real
            errors.append(abs(table["xu"][0] - 4 - 0.1 * c / k * (1 - decay)))
        expect_close(f"order {power}, error {errors[1]:.1e}: ratio to that of twice the step", errors[0] / errors[1],
                     2.0**power, rtol=0.06)


def flows():
    """Light particles move with the fluid."""
    def along_x(v, slope):
        zero = 0 * v
        return np.array([v, zero, zero]), np.array([zero, zero, -0.5 * slope])

    def inside(y, low, high):
        return (y > low) & (y < high)

    fields = {
        "shear 0.7": lambda x, y, z: along_x(0.7 * y, 0.7 + 0 * y),
        "couette 5 -1 13 2": lambda x, y, z: along_x(np.interp(y, [5, 13], [-1, 2]), 3 / 8 * inside(y, 5, 13)),
        "poiseuille 2 18 v_t": lambda x, y, z: along_x(0.3 * inside(y, 2, 18) * (y - 2) * (18 - y) / 64,
                                                       0.3 * inside(y, 2, 18) * (20 - 2 * y) / 64),
        "velocity v_u v_t 0.5 spin 0 v_w 0.25": lambda x, y, z: (np.array([np.sin(x), 0.3 + 0 * x, 0.5 + 0 * x]),
                                                                 np.array([0 * x, 0.1 * z, 0.25 + 0 * x]))}
    light = slice(0, 6)
    for flow, field in fields.items():
        _, table = spheres(drag=f"1e3 {flow}", least=1e-12, steps=5, step=1e-6)
        v, w = field(*vectors(table, X)[light].T)
        expect_close(f"{flow}: velocity", vectors(table, V)[light], v.T, atol=1e-5)
        expect_close(f"{flow}: spin", vectors(table, W)[light], w.T, atol=1e-5)

    # cell: erate multiplies the edges by 1 + rate t, so that v = rate (x - lo)/(1 + rate t), lo moving, too
    rates, step, steps = np.array([0.3, -0.2, 0.1]), 1e-4, 200
    _, table = spheres(drag="1e3 cell", least=1e-12, steps=steps, step=step,
                       before="fix cell all deform 1 x erate 0.3 y erate -0.2 z erate 0.1 remap v")
    x = vectors(table, X)[light]
    middle = np.array([20, 10, 0])
    expect_close("cell: velocity", vectors(table, V)[light], rates * (x - middle) / (1 + rates * step * steps), atol=1e-3)
    start = np.array([[4 * n, 20 * (0.5 + 0.45 * np.sin(3 * n)), 9 * np.cos(2 * n)] for n in range(1, 7)])
    expect_close("cell: stretched", x, middle + (start - middle) * (1 + rates * step * steps), atol=1e-5)
    thermo, table = spheres(drag="1e3 cell", least=1e-12, steps=steps, step=step, shape="triclinic",
                            before="fix cell all deform 1 xy erate 0.5 remap v")
    x = vectors(table, X)[light]
    expect_close("sheared cell: velocity", vectors(table, V)[light],
                 np.array([0.5 * x[:, 1], 0 * x[:, 1], 0 * x[:, 1]]).T, atol=1e-5)
    expect_close("sheared cell: spin", vectors(table, W)[light], np.tile([0, 0, -0.25], (6, 1)), atol=1e-5)


    # gap 3 from y = 2 on, rate 2
    for style, first in ("drag/background", "plates"), ("drag/background", "drag"), ("overdamped/sphere", "plates"):
        run("in.plates", style=style, first=first)
        table = read_dump("now.txt")
        expect_close(f"plates, {style}: velocity and spin", [table["vx"][2], table["omegaz"][2]], [3.6, -1.0], atol=1e-9)


def hindrance():
    """Factor and terminal velocity."""
    solid = np.sum(4 / 3 * np.pi * (0.5 * (1 + 0.1 * np.arange(1, 10)))**3)
    for words_, factor in (("mean", 1 / (1 - solid / 16000)), ("phi v_t", 1 / 0.7), ("0.25", 0.25)):
        thermo, table = spheres(drag=f"{ETA} hindrance {words_}", push=words(PUSH), step=10, least=1e-9)
        expect_close(f"hindrance {words_}: factor", thermo["f_drag[9]"][-1], factor, rtol=1e-12)
        expect_close(f"hindrance {words_}: velocity", table["vy"], PUSH[1] / (factor * resistance(table)[0]), rtol=1e-11)
    solid = np.sum(np.pi * (0.5 * (1 + 0.1 * np.arange(1, 10)))**2)
    thermo, _ = spheres(drag=f"{ETA} hindrance mean shape disc", dim=2, depth=0.5)
    expect_close("hindrance mean, discs: factor", thermo["f_drag[9]"][-1], 1 / (1 - solid / 800), rtol=1e-12)


def restart():
    """Half a run, a restart file, and the other half."""
    case = dict(drag=f"{ETA} shear 0.3", start=words(START), spin=words(SPIN), push=words(PUSH), least=1e-2)
    thermo, whole = spheres(**case)
    run("in.spheres", part="first", **case)
    again, table = spheres(part="second", **case)
    for name in X + V + W:
        expect_close(f"restart: {name}", table[name], whole[name], rtol=1e-12, atol=1e-12)
    expect_close("restart: energy", again["f_drag"][-1], thermo["f_drag"][-1], rtol=1e-12)


def isolated():
    """Chain of five (1 2 2 2 1 partners), tetrahedron (3 each), one alone: who has fewer than n?"""
    partners = np.array([1, 2, 2, 2, 1, 3, 3, 3, 3, 0])
    for word, n, newton in ("1", 1, "off"), ("2", 2, "on"), ("", 3, "off"), ("3", 3, "on"):
        done = run("in.clusters", few=word, newton=newton)
        dragged = read_dump("now.txt")["vx"] < 1e-3
        expect(f"isolated {word}, newton {newton}", np.array_equal(dragged, partners < n), words(dragged.astype(int)))
        expect_close("  number", done.thermo()["f_drag[8]"][-1], np.sum(partners < n))


def others():
    """Isolated particles relax with the full drag, the others with a part of it; the momentum is all accounted for."""
    push, fluid, start, turn = 1e-4, 2e-3, -1e-3, 3e-3
    crowded = np.array([0, 0, 0, 0, 0, 1, 1, 1, 1, 0], dtype=bool)
    flow = dict(flow=f"velocity {fluid} 0 0 spin 0 0 {turn}", start=start)
    share = {"3 others 0.25": 0.25, "3 others v_weak": 0.25, "3 others 0.05 hindrance 0.5": 0.05, "3 others 3": 3.0}
    for word, factor in share.items():
        newton = "on" if factor < 1 else "off"
        thermo = run("in.clusters", few=word, newton=newton, density=4.0, **flow).thermo()
        now = read_dump("now.txt")
        f = np.where(crowded, factor, 1.0) * (0.5 if "hindrance" in word else 1.0)
        c, c_spin, inertia = 6 * np.pi * f * now["radius"], 8 * np.pi * f * now["radius"]**3, 0.4 * now["mass"] * now["radius"]**2
        end = fluid + push / c
        expect_close(f"isolated {word}: velocity", now["vx"], end + (start - end) * np.exp(-c / now["mass"]), rtol=1e-9)
        expect_close("  spin", now["omegaz"], turn * (1 - np.exp(-c_spin / inertia)), rtol=1e-9)
        expect_close("  numbers", [thermo["f_drag[8]"], thermo["f_drag[14]"]], [[10] * 11, [4] * 11])
        for of, force, count in (("v_px", "f_drag[2]", 10), ("v_crowd", "f_drag[11]", 4)):
            impulse = STEP * (0.5 * (thermo[force][1:] + thermo[force][:-1]) + count * push)
            expect_close(f"  momentum of {count}", np.diff(thermo[of]), impulse, atol=1e-13)
    # at the terminal velocity: push^2/c each
    thermo = run("in.clusters", few="3 others 0.25").thermo()
    expect_close("dissipated power", thermo["f_drag[1]"][-1], push**2 / (6 * np.pi) * (6 + 4 / 0.25), rtol=1e-9)
    expect_close("sums", [thermo["f_drag[2]"][-1], thermo["f_drag[11]"][-1]], [-10 * push, -4 * push], rtol=1e-9)
    # none on the others: the bits of isolated alone
    ends = []
    for word in "3", "3 others 0":
        thermo = run("in.clusters", few=word, density=4.0, **flow).thermo()
        expect_close("no others", [thermo["f_drag[11]"][-1], thermo["f_drag[14]"][-1]], [0, 0])
        ends.append(read_dump("now.txt"))
    expect_same_bits("others 0 is isolated alone", ends[1], ends[0])

    whole = dict(few="3 others v_weak", density=4.0, **flow)
    run("in.clusters", **whole)
    at_once = read_dump("now.txt")
    run("in.clusters", part="first", **whole)
    run("in.clusters", part="second", **whole)
    expect_close("restart: velocity", read_dump("now.txt")["vx"], at_once["vx"], rtol=1e-12)


relaxation(3, False, 20, "on")
relaxation(2, True, 20, "off")
isolated()
others()
restart()
if RANKS == 1:
    relaxation(3, False, 1, "on")
    relaxation(2, False, 20, "on")
    hindrance()
    power_and_energy()
    order()
    flows()
finish()
