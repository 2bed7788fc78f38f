# ranks: 1 4
"""The pressure of the pores in a periodic cell: momentum, power, ranks, restart, flip, permeameter, fluidized bed."""
import numpy as np

import deck

PORE = ("lower", "upper", "mean", "largest", "flux_low", "flux_up", "heat", "fx", "fy", "fz", "iterations", "residual",
        "k_min", "k_max", "step", "power")
GRID = {1: "1 1 1", 2: "1 2 1", 4: "2 2 1"}[deck.RANKS]
SINGLE = deck.RANKS == 1    # on several ranks: what is summed over them
FLOWS = {"shear": {}, "pressure": {"flow": "deform/rheometer rate 1 pressure 20"}}


def read(what="in.cell", **variables):
    t = deck.run(what, **variables).thermo()
    t.update({name: t.pop(f"f_pore[{n + 1}]") for n, name in enumerate(PORE) if f"f_pore[{n + 1}]" in t})
    return t


def balance(fraction, **case):
    """Defect of the balance of energy and the share of the pores, over what was put in."""
    dt, t = 5e-4 * fraction, read(fraction=fraction, steps=int(400 / fraction), **case)
    defect, heat = deck.power_balance(t, dt)
    return defect, heat[9], t


deck.make_state()
for what, case in FLOWS.items():
    t, d = read(**case), deck.read_dump("cell.dump")
    size = np.sum(np.abs([d[f"f_pore[{n}]"] for n in (1, 2, 3)]))
    deck.expect(f"{what}: the pores push", size > 100 and np.all(t["largest"] > 1), f"{size:.4g}")
    for name in ("fx", "fy", "fz"):
        deck.expect_close(f"{what}: forces add up to zero, {name}", t[name], 0, atol=1e-11 * size)
    for n in (1, 2, 3):
        deck.expect_close(f"{what}: sum of column {n}", np.sum(d[f"f_pore[{n}]"]), 0, atol=1e-11 * size)
        deck.expect_close(f"{what}: row 7 is minus the mean pressure, which is 0", t[f"c_stress[7][{n}]"], -t["mean"],
                          atol=1e-14 * t["largest"][0])
    deck.expect(f"{what}: one solution per step, the first ten iterated",
                np.all(t["iterations"][:10] > 3) and np.all(t["residual"] < 1e-8) and np.all(t["iterations"][10:] == 0))

    # ranks and newton: rounding, which then grows with the motion
    for other, variables in (("one rank", {"ranks": 1}), ("newton off", {"newton": "off"})):
        o = read(**case, **variables)
        for name in ("largest", "heat", "power", "PotEng", "KinEng", "k_min", "k_max"):
            scale = np.max(np.abs(t[name][:10]))
            deck.expect_close(f"{what}, {other}: {name} of the first steps", o[name][:10], t[name][:10], atol=1e-10 * scale)
            deck.expect_close(f"{what}, {other}: {name}", o[name], t[name], atol=1e-8 * scale)

    # a restart; also one while the first solutions are iterated
    steps = 100 if what == "shear" else 6
    whole = read(steps=steps, grid=GRID, half="yes", **case)
    again = read("in.restarted", steps=steps, grid=GRID, **case)
    deck.expect_same_bits(f"{what}: restart", deck.read_dump("restarted.dump"), deck.read_dump("whole.dump"))
    steps = range(1, steps + 1)
    deck.expect_same_bits(f"{what}: restart, output", {name: again[name][steps] for name in again},
              {name: whole[name][steps] for name in again})

# off: the pressure is known, and nothing else
for what, case in FLOWS.items() if SINGLE else list(FLOWS.items())[:1]:
    off, a = read(pore="pair cell coupling off", **case), deck.read_dump("cell.dump")
    none, b = read(**{"with": "no"}, **case), deck.read_dump("cell.dump")
    deck.expect_same_bits(f"{what}: coupling off", {name: a[name] for name in b}, b)
    deck.expect_same_bits(f"{what}: coupling off, output", {name: off[name] for name in none}, none)
    deck.expect(f"{what}: off, but it has a pressure", np.all(off["largest"] > 1) and np.all(off["power"] == 0))

# energy: what the shear puts in is stored, kinetic, or turned into heat, that of the pores included
for what, case in FLOWS.items() if SINGLE else ():
    coarse, _, _ = balance(1, **case)
    fine, share, t = balance(0.25, **case)
    without, _, _ = balance(0.25, pore="pair cell coupling off", **case)
    deck.expect(f"{what}: row 10 is value 16", np.array_equal(t["c_power[10][1]"], t["power"]))
    deck.expect(f"{what}: the pores take part", share > 0.01, f"{share:.3g}")
    deck.expect(f"{what}: the balance closes as well as without pores", fine < min(0.3 * coarse, 1.1 * without),
                f"{coarse:.1e} {fine:.1e} without {without:.1e}")
    deck.expect_close(f"{what}: they turn into heat what they are given", np.mean(t["power"][80:]),
                      np.mean((t["heat"] * t["Volume"])[80:]), rtol=0.02)

# weights that stay for some steps: their error is of the distance that particles go meanwhile, over a spacing
apart = {}
for n in (1, 5, 20) if SINGLE else ():
    t = read(pore=f"pair cell every {n}")
    if n == 1:
        anew = t
    apart[n] = [np.max(np.abs(t[name] - anew[name])) / np.max(anew[name]) for name in ("largest", "heat")]
    print(f"every {n}:", *(f"{value:.2e}" for value in apart[n]))
if SINGLE:
    deck.expect("every 20 is close to every 1, and not the same", 1e-6 < max(apart[20]) < 0.02, str(apart[20]))
    deck.expect("every 5 is closer", max(apart[5]) < 0.5 * max(apart[20]), str(apart[5]))

# a flip: the nodes are others then, and the pressure is solved anew
for flip in ("yes", "no"):
    t = read(flow=f"deform 1 xy erate 1.0 remap v flip {flip}", tilt=0.45)
    d = deck.read_dump("cell.dump")
    if flip == "yes":
        flipped, moved = t, d
at = np.argmax(np.abs(np.diff(flipped["Xy"])) > 1) + 1
deck.expect("only one flips", np.ptp(flipped["Xy"]) > 1.5 * np.ptp(t["Xy"]))
deck.expect("iterated from the step of the flip on", np.flatnonzero(flipped["iterations"])[10:].tolist() == list(range(at, at + 10)))
deck.expect_close("before the flip", flipped["heat"][:at], t["heat"][:at], rtol=1e-9)
deck.expect_close("heat of the other grid", flipped["heat"][at], t["heat"][at], rtol=0.05)
deck.expect_close("the motion goes on: kinetic energy", flipped["KinEng"], t["KinEng"], rtol=0.01)
deck.expect_close("and that of the springs", flipped["PotEng"], t["PotEng"], rtol=0.03)

# one solution per step, or iterations to the tolerance: they agree as the time step becomes small
apart = {"grid": [], "explicit": []} if SINGLE else {}
for fraction in (0.5, 0.125) if SINGLE else ():
    seen = {}
    for words in ("solver grid", "coupling explicit", "solver cg", "solver cg tolerance 1e-12"):
        t = read(fraction=fraction, steps=int(40 / fraction), pore=f"pair cell {words}")
        d = deck.read_dump("cell.dump")
        seen[words] = np.array([d[f"f_pore[{n}]"] for n in (1, 2, 3)])
        iterates = "grid" not in words
        deck.expect(f"{words}: iterations", np.all((t["iterations"][10:] > 3) == iterates))
    size = np.sqrt(np.mean(seen["solver cg"] ** 2))
    for name in apart:
        one = next(words for words in seen if name in words)
        apart[name].append(np.sqrt(np.mean((seen[one] - seen["solver cg tolerance 1e-12"]) ** 2)) / size)
    deck.expect_close("the tolerance is small enough", seen["solver cg"], seen["solver cg tolerance 1e-12"], atol=1e-7 * size)
for name, (coarse, fine) in apart.items():
    deck.expect(f"{name}, to first order", coarse < 0.1 and fine < 0.3 * coarse, f"{coarse:.3f} {fine:.4f}")

# a fluid that cannot move: what the first velocities would compress is stopped at once, and no energy comes from nowhere
for fraction in (1, 4) if SINGLE else ():
    t = read(pore="pair cell permeability constant 1e-12", flow="deform/rheometer rate 0 volume", fraction=fraction, steps=300)
    energy = t["KinEng"] + t["PotEng"]
    deck.expect(f"undrained: energy, at {t['step'][-1]:.0e} explicit steps", np.all(energy <= energy[0] * (1 + 1e-6)), f"{np.max(energy / energy[0]):.4f}")
    deck.expect("undrained: the impact is over in the next step", t["largest"][1] < 0.2 * t["largest"][0], f"{t['largest'][:2]}")

# permeameter: spheres that are held
SLOPE, ETA = -5.0, 2.0


def layers():
    """y, p, phi, u, q by layers."""
    return np.array([line.split()[1:] for line in deck.Path("layers.txt").read_text().splitlines()[4:]], dtype=float).T


def permeability(law, phi, radius):
    kozeny = 10 * phi / (1 - phi) ** 3
    drag = kozeny if law == "kozeny" else kozeny + (1 - phi) * (1 + 1.5 * np.sqrt(phi))
    return 2 * radius ** 2 / (9 * phi * drag)


d = deck.read_dump("cell.dump")
sauter = np.sum(d["radius"] ** 3) / np.sum(d["radius"] ** 2)
phi = np.sum(4 / 3 * np.pi * d["radius"] ** 3) / t["Volume"][0]
law = {name: permeability(name, phi, sauter) for name in ("beetstra", "kozeny")}
CASES = (("grid 1 1 1", law["beetstra"], 1e-12), ("grid 1 1 1 permeability beetstra", law["beetstra"], 1e-12),
         ("grid 1 1 1 permeability kozeny factor 7", 7 * law["kozeny"], 1e-12),
         ("grid 4 4 4 permeability constant 0.01 factor 3", 0.03, 1e-8), ("grid 3 3 3", law["beetstra"], 0.03),
         ("grid 4 4 4", law["beetstra"], 0.06))
for words, k, error in CASES if SINGLE else CASES[-1:]:
    t = read("in.bed", pore=f"{ETA} cell coupling off tolerance 1e-10 {words}", slope=SLOPE)
    y, p, solid, u, q = layers()
    ny = len(y)
    deck.expect_close(f"{words}: Darcy's law", np.mean(q), -k / ETA * SLOPE, rtol=error)
    deck.expect(f"{words}: an uneven packing is more permeable", np.mean(q) > -k / ETA * SLOPE * (1 - 1e-8))
    deck.expect_close(f"{words}: the gradient does what turns into heat", t["heat"], -SLOPE * np.mean(q), rtol=1e-8)
    deck.expect_close(f"{words}: layers", y, (np.arange(ny) + 0.5) / ny * t["Ly"][0], rtol=1e-14)
    deck.expect_close(f"{words}: volume fraction", np.mean(solid), phi, rtol=1e-12)
    deck.expect(f"{words}: at rest", np.all(u == 0) and abs(np.mean(p)) < 1e-10)
    d = deck.read_dump("bed.dump")
    deck.expect_close(f"{words}: force per volume is minus the gradient", np.sum(d["f_pore[2]"]) / t["Ly"][0] ** 3, -SLOPE, rtol=1e-12)
    deck.expect_close(f"{words}: and nothing across", [np.sum(d["f_pore[1]"]), np.sum(d["f_pore[3]"])], 0, atol=1e-10)
    deck.expect_close(f"{words}: as put out", t["fy"], np.sum(d["f_pore[2]"]), rtol=1e-12)

# fluidized bed: the pressure gradient carries the weight of the particles, or a part of it
PULL = 30.0
for part in (1.0, 0.6):
    t = read("in.bed", held="no", pore="2 cell grid 4 4 4", slope=-part * phi * PULL, pull=PULL, steps=100)
    volume = t["Ly"][0] ** 3
    time = t["Step"] * 5e-4
    deck.expect_close(f"{part} of the weight is carried", t["v_momentum"], -(1 - part) * phi * PULL * volume * time,
                      atol=1e-10 * phi * PULL * volume * time[-1])

# discs, whose permeability the user must know
deck.make_state(dim=2, phi=0.75)
t = read(dim=2, pore="pair cell permeability constant 0.02")
d = deck.read_dump("cell.dump")
size = np.sum(np.abs([d["f_pore[1]"], d["f_pore[2]"]]))
deck.expect("discs: the pores act in the plane", size > 1 and np.all(d["f_pore[3]"] == 0) and np.all(d["vz"] == 0), f"{size:.3g}")
deck.expect_close("discs: forces add up to zero", [t["fx"], t["fy"]], 0, atol=1e-11 * size)
deck.finish()
