# ranks: 1 4
"""fix hydro mean: Einstein's stress, drag on spheres with few partners, films with both, balances, ranks, restart."""
import numpy as np

import deck
from oracle.film_network import Network
from oracle.spheres import random_spheres, write_spheres

OUTPUT = ("iterations", "residual", "xx", "yy", "zz", "xy", "xz", "yz", "heat", "fx", "fy", "fz", "solutions", "phi", "dragged")
STRESS = OUTPUT[2:8]
GRID = {1: "1 1 1", 4: "2 2 1"}[deck.RANKS]
SINGLE = deck.RANKS == 1    # on several ranks: what is summed over them
ETA = 0.7
CELL = deck.ROOT / "tests" / "decks" / "hydro_run"


def read(what="in.still", **variables):
    t = deck.run(what, **variables).thermo()
    t.update({name: t.pop(f"f_far[{n + 1}]") for n, name in enumerate(OUTPUT)})
    return t


def stokes(radius):
    return 6 * np.pi * ETA * radius, 8 * np.pi * ETA * radius**3


def einstein():
    """Spheres far from each other that move with the flow: 2.5 phi in shear, in every flow 20/3 pi eta a^3 of its strain."""
    rnd = np.random.default_rng(1)
    radius = np.array([1.0] * 5 + [0.6] * 8 + [0.3] * 12)
    edges, tilt = np.array([16.0, 18, 14]), 3.0
    for what, gradient, flow in (
            ("shear", [[0, 0.3, 0], [0, 0, 0], [0, 0, 0]], "deform 1 xy erate 0.3 remap v"),
            ("plane extension", [[0.2, 0, 0], [0, -0.2, 0], [0, 0, 0]], "deform 1 x erate 0.2 y erate -0.2 remap v"),
            ("expansion", [[0.3, 0, 0], [0, 0, 0], [0, 0, 0.1]], "deform 1 x erate 0.3 z erate 0.1 remap v"),
            ("shear of three", [[0, 0.1, 0.2], [0, 0, 0.3], [0, 0, 0]], "deform 1 xy erate 0.1 xz erate 0.2 yz erate 0.3 remap v")):
        gradient = np.array(gradient)
        if "extension" in what or "expansion" in what:
            cell, middle = np.diag(edges), edges / 2    # both sides move
        else:
            cell, middle = np.array([[edges[0], tilt, 0], [0, edges[1], 0], [0, 0, edges[2]]]), np.zeros(3)
        x = random_spheres(rnd, cell, radius, gap=0.8)
        spin = np.array([gradient[2, 1] - gradient[1, 2], gradient[0, 2] - gradient[2, 0], gradient[1, 0] - gradient[0, 1]]) / 2
        write_spheres("spheres.data", cell, x, radius, (x - middle) @ gradient.T, np.tile(spin, (len(x), 1)))
        t = read(flow=flow, step=1e-3, density=1e12, grid=GRID)
        volume = np.linalg.det(cell)
        strain = (gradient + gradient.T) / 2 - np.trace(gradient) / 3 * np.eye(3)
        stress = 20 / 3 * np.pi * ETA * np.sum(radius**3) * strain / volume
        expected = stress[(0, 1, 2, 0, 0, 1), (0, 1, 2, 1, 2, 2)]
        scale = np.max(np.abs(stress))
        deck.expect_close(f"{what}: stress", [t[n][0] / scale for n in STRESS], expected / scale, atol=1e-12)
        deck.expect_close(f"{what}: heat", t["heat"][0], volume * np.sum(stress * strain), rtol=1e-10)
        deck.expect_close(f"{what}: number of spheres with drag", t["dragged"][0], len(x))
        deck.expect_close(f"{what}: no forces", [t[n][0] for n in ("fx", "fy", "fz")], 0, atol=1e-9)
        phi = 4 / 3 * np.pi * np.sum(radius**3) / volume
        deck.expect_close(f"{what}: volume fraction", t["phi"][0], phi, rtol=1e-12)
        if what == "shear":
            deck.expect_close("Einstein's 2.5 phi", t["xy"][0] / (ETA * 0.3), 2.5 * phi, rtol=1e-12)
        nine = [t[f"c_stress[8][{n + 1}]"][0] for n in range(9)]
        deck.expect_close(f"{what}: row of the stress", nine, [t[STRESS[n]][0] for n in (0, 1, 2, 3, 4, 5, 3, 4, 5)],
                          atol=1e-14 * scale)
        deck.expect_close(f"{what}: sum over the particles", [t[f"c_sums[{n + 1}]"][0] / volume for n in range(9)], nine,
                          atol=1e-12 * scale)


def partners(cell, x, radius, reach):
    images = np.array([(i, j, k) for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1)]) @ cell.T
    number = np.zeros(len(x), dtype=int)
    for i, p in enumerate(x):
        for j, q in enumerate(x):
            a = 2 * radius[i] * radius[j] / (radius[i] + radius[j])
            gap = np.min(np.linalg.norm(p - q + images, axis=1)) - radius[i] - radius[j]
            number[i] += i != j and gap < reach * a
    return number


def drag():
    """Forces and torques of spheres with fewer than n partners are Stokes', others have none."""
    rnd = np.random.default_rng(2)
    radius, edges = np.array([1.0] * 24 + [0.5] * 26), (7, 7.5, 8)
    cell = np.array([[edges[0], 2.5, 0], [0, edges[1], 0], [0, 0, edges[2]]])
    x = random_spheres(rnd, cell, radius, gap=0.01)
    rate = 0.4
    write_spheres("spheres.data", cell, x, radius, rnd.normal(size=x.shape), rnd.normal(size=x.shape))
    flow_v, flow_w = np.array([rate * x[:, 1], 0 * x[:, 0], 0 * x[:, 0]]).T, np.array([0, 0, -rate / 2])
    force_of, torque_of = stokes(radius)
    for words, few, reach, newton in (("mean", 3, 0.5, "on"), ("mean isolated 1 viscosity pair", 1, 0.5, "off"),
                                      (f"mean isolated 5 viscosity {ETA}", 5, 1.0, "on")):
        number = partners(cell, x, radius, reach)
        on = (number < few)[:, None].astype(float)
        t = read(flow=f"deform/rheometer rate {rate} volume", hydro=words, range=f"cut {reach}", newton=newton, step=1e-9, density=1e6, grid=GRID)
        d = deck.read_dump("still.dump")
        v, w = (np.array([d[n] for n in names]).T for names in (("vx", "vy", "vz"), ("omegax", "omegay", "omegaz")))
        force, torque = (np.array([d[f"f_far[{n}]"] for n in names]).T for names in ((1, 2, 3), (4, 5, 6)))
        name = f"{words}, {np.sum(on)} of {len(x)}"
        deck.expect("some are dragged and some are not", 2 < np.sum(on) < 45, np.sum(on))
        deck.expect_close(f"{name}: forces", force, -on * force_of[:, None] * (v - flow_v), atol=1e-7)
        deck.expect_close(f"{name}: torques", torque, -on * torque_of[:, None] * (w - flow_w), atol=1e-7)
        deck.expect_close(f"{name}: sum of forces", [t[n][-1] for n in ("fx", "fy", "fz")], np.sum(force, axis=0), atol=1e-7)
        deck.expect_close(f"{name}: number", t["dragged"][-1], np.sum(on))
        heat = -np.sum(force * (v - flow_v)) - np.sum(torque * (w - flow_w)) + 10 / 3 * np.pi * ETA * rate**2 * np.sum(radius**3)
        deck.expect_close(f"{name}: heat", t["heat"][-1], heat, rtol=1e-8)


def network():
    """The viscosity of configurations in slow motion, against the linear system of films and drag."""
    rnd = np.random.default_rng(3)
    rate, edge = 1e-3, (40 * 4 / 3 * np.pi / 0.2) ** (1 / 3)
    cell, radius = np.diag([edge] * 3), np.ones(40)
    x = random_spheres(rnd, cell, radius, gap=0.02)
    gradient = np.array([[0, rate, 0], [0, 0, 0], [0, 0, 0]])
    write_spheres("spheres.data", cell, x, radius, x @ gradient.T, np.tile([0, 0, -rate / 2], (len(x), 1)), triclinic=True)
    for few in (3, 100):
        t = read(hydro=f"mean isolated {few}", steps=4000, every=4000)
        state = {**dict(zip("xyz", x.T)), "radius": radius}
        squeeze, shear = Network(state, (edge, edge, edge, 0), eta=ETA, g=1e6, kt=5e5, reach=0.5, drag=few).stress()
        name = f"drag below {few} partners"
        deck.expect_close(f"{name}: squeeze", t["c_stress[3][4]"][-1] / rate, squeeze.real, rtol=1e-5)
        deck.expect_close(f"{name}: shear", t["c_stress[4][4]"][-1] / rate, shear.real, rtol=1e-5)
        deck.expect_close(f"{name}: stresslets", t["xy"][-1] / rate, 0.5 * ETA, rtol=1e-9)


def coming_and_going():
    """After many steps with the same neighbor lists: the drag is on those with few partners now."""
    t = read(CELL / "in.cell", hydro="mean isolated 6", range="cut 0.5", flow="deform/rheometer rate 1.0 volume", steps=158, step=2e-3,
             grid=GRID, more="lx")
    d = deck.read_dump("cell.dump")
    cell = np.array([[t["Lx"][-1], t["Xy"][-1], 0], [0, t["Ly"][-1], 0], [0, 0, t["Volume"][-1] / (t["Lx"][-1] * t["Ly"][-1])]])
    number = partners(cell, np.array([d[n] for n in "xyz"]).T, d["radius"], 0.5)
    force = np.linalg.norm([d[f"f_far[{n}]"] for n in (1, 2, 3)], axis=0)
    deck.expect("drag where there are few partners", np.array_equal(force > 0, number < 6), np.sum(number < 6))
    deck.expect("some of them are new", np.ptp(t["dragged"]) > 5, f"{np.min(t['dragged'])} to {np.max(t['dragged'])}")


ROWS = [f"c_power[{m}][{n}]" for n in (1, 2) for m in range(1, 12)]


def balance():
    """What the shear puts in is stored, kinetic, or turned into heat; the fluid takes the momentum."""
    errors = []
    for fraction in (1, 0.25):
        dt = 5e-4 * fraction
        t = read(CELL / "in.cell", hydro="mean", range="cut 0.5", step=dt, steps=int(240 / fraction), drift=0.3, more=" ".join(["c_power", *ROWS]))
        defect, heat = deck.power_balance(t, dt)
        errors.append(defect)
        share = heat[10]
    deck.expect("the far field takes part", share > 0.1, f"{share:.3g}")
    deck.expect("the balance of energy closes", errors[1] < min(0.3 * errors[0], 1e-3), f"{errors}")
    p, f = t["v_momentum"], t["fy"]
    scale = np.max(np.abs(f)) * dt
    deck.expect_close("momentum", np.diff(p) / scale, 0.5 * dt * (f[1:] + f[:-1]) / scale, atol=1e-9)
    deck.expect("part of the spheres are dragged", 0 < np.min(t["dragged"]) <= np.max(t["dragged"]) < 200, np.mean(t["dragged"]))


def rounding():
    """Ranks and newton change digits at the end, a restart none; a level of its own after a restart of another is fine."""
    names = ("xy", "yy", "heat", "fx", "PotEng", "KinEng", "c_stress[2][4]")
    t = read(CELL / "in.cell", hydro="mean", range="cut 0.5", steps=60)
    others = [("newton off", {"newton": "off"})] + ([] if SINGLE else [("one rank", {"ranks": 1})])
    for other, variables in others:
        o = read(CELL / "in.cell", hydro="mean", range="cut 0.5", steps=60, **variables)
        for name in names:
            deck.expect_close(f"{other}: {name}", o[name], t[name], atol=1e-9 * np.max(np.abs(t[name])))
    servo = "deform/rheometer rate 1.0 pressure 40 start 1.0"
    whole = read(CELL / "in.cell", hydro="mean", range="cut 0.5", flow=servo, steps=70, grid=GRID, half="yes")
    again = read(CELL / "in.restarted", hydro="mean", flow=servo, steps=70, grid=GRID)
    del whole["v_momentum"], again["v_momentum"]
    deck.expect_same_bits("restart: particles", deck.read_dump("restarted.dump"), deck.read_dump("whole.dump"))
    deck.expect_same_bits("restart: output", again, whole)


def control():
    """The stresslets are in the stress that the rheometer measures, and a stress drives a dilute suspension as Einstein says."""
    rows = [[f"c_stress[{m}][{n}]" for m in range(1, 9)] for n in (2, 4)]
    for flow in ("rate 1.0 pressure 40 every 1 start 1.0", "stress 5 pressure 20 every 1 start 1.0"):
        t = read(CELL / "in.cell", hydro="mean", range="cut 0.5", flow="deform/rheometer " + flow, steps=100,
                 more=" ".join(["f_flow[2] f_flow[4] f_flow[5]", *rows[0], *rows[1]]))
        yy, xy = (np.sum([t[name] for name in names], axis=0) for names in rows)
        scale = np.max(np.abs(yy)) + np.max(np.abs(xy))
        deck.expect_close(f"{flow}: pressure of all rows", t["f_flow[4]"] / scale, -yy / scale, atol=1e-10)
        deck.expect_close(f"{flow}: stress of all rows", t["f_flow[5]"] / scale, xy / scale, atol=1e-10)
        deck.expect(f"{flow}: stresslets resist the dilation", np.max(np.abs(t["yy"])) > 1e-3 * scale, np.max(np.abs(t["yy"])))
    rnd = np.random.default_rng(4)
    edge, radius = 16.0, np.full(20, 1.2)
    x = random_spheres(rnd, np.diag([edge] * 3), radius, gap=0.9)
    write_spheres("spheres.data", np.diag([edge] * 3), x, radius, 0 * x, 0 * x, triclinic=True)
    t = read(flow="deform/rheometer stress 0.3 volume", step=1e-3, steps=1500, density=1e-4, g=1.0, more="f_flow[2]")
    rate = 0.3 / (ETA * (1 + 2.5 * 20 * 4 / 3 * np.pi * 1.2**3 / edge**3))
    deck.expect_close("dilute under a stress: rate", t["f_flow[2]"][-1], rate, rtol=1e-4)


if __name__ == "__main__":
    einstein()
    drag()
    deck.make_state(phi=0.3)
    rounding()
    coming_and_going()
    if SINGLE:
        network()
        balance()
        control()
    deck.finish()
