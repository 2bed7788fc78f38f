# ranks: 1 4
"""A layer whose pores are known in the mean only (solver mean): relaxation, what plates feel, energy, restart; a cell, discs."""
import numpy as np

import deck

GRID = {1: "1 1 1", 2: "1 2 1", 4: "1 4 1"}[deck.RANKS]
CELL_GRID = {1: "1 1 1", 2: "1 2 1", 4: "2 2 1"}[deck.RANKS]
PLATES = {"gap": 3, "vy": 5, "p_low": 7, "p_up": 8}
PORE = {"lower": 1, "upper": 2, "mean": 3, "largest": 4, "flux_low": 5, "flux_up": 6, "heat": 7, "k_min": 13, "k_max": 14, "power": 16}
AREA, N, STIFF = 2.1 ** 2, 20, 1000.0
MODULUS = STIFF / AREA
SOLID = N * np.pi / 6


def beetstra(phi, radius=0.5):
    drag = 10 * phi / (1 - phi) ** 3 + (1 - phi) * (1 + 1.5 * np.sqrt(phi))
    return 2 * radius ** 2 / (9 * phi * drag)


def read(deck_name="in.column", tables=False, **variables):
    found = []
    for t in deck.run(deck_name, **variables).tables():
        t.update({name: t[f"f_cell[{n}]"] for name, n in PLATES.items() if f"f_cell[{n}]" in t})
        t.update({name: t[f"f_pore[{n}]"] for name, n in PORE.items() if f"f_pore[{n}]" in t})
        found.append(t)
    return found if tables else found[-1]


def relax(gap, time, load, resistance):
    """The gap: (resistance/H) dH/dt = stress of the springs - load, by Runge and Kutta's rule."""
    def rate(h):
        return -h * (load - MODULUS * (N - h) / N) / resistance(h)
    found = [gap]
    for step in np.diff(time):
        h, k = found[-1], [0.0]
        for part in (0, 0.5, 0.5, 1):
            k.append(rate(h + part * step * k[-1]))
        found.append(h + step * (k[1] + 2 * k[2] + 2 * k[3] + k[4]) / 6)
    return np.array(found)


# ---- a step of the load relaxes within eta H^2/(3 k E), a quarter of that if both plates drain
K, ETA = 0.3, 300.0
CONSTANT = f"permeability constant {K}"
BELOW, ABOVE, BOTH = ("lower impermeable upper drained", "lower drained upper impermeable", "lower drained upper drained")
CASES = {
    "drains above": (f"{BELOW} {CONSTANT}", "load", 1, lambda h: ETA * h ** 2 / (3 * K)),
    "drains below": (f"{ABOVE} {CONSTANT}", "load", 1, lambda h: ETA * h ** 2 / (3 * K)),
    "drains on both sides": (f"{BOTH} {CONSTANT}", "load", 2, lambda h: ETA * (h / 2) ** 2 / (3 * K)),
    "servo": (f"{BELOW} {CONSTANT}", "pressure", 1, lambda h: ETA * h ** 2 / (3 * K)),
    "servo, closed above": (f"{ABOVE} {CONSTANT}", "pressure", 1, lambda h: ETA * h ** 2 / (3 * K)),
    "beetstra": (f"{BELOW} factor 2", "load", 1, lambda h: ETA * h ** 2 / (3 * 2 * beetstra(SOLID / (AREA * h)))),
}
seen = {}
for what, (pore, load, outlets, resistance) in CASES.items() if deck.RANKS == 1 else list(CASES.items())[:1]:
    tau = resistance(N) / MODULUS
    t = seen[what] = read(pore=pore, load=load, more="gain 1e6" if load == "pressure" else "", time=1.5 * tau, outputs=300, grid=GRID)
    time, e = t["Time"], t["vy"] / t["gap"]
    settled = (N - t["gap"]) / (N / MODULUS)
    deck.expect_close(f"{what}: 1/e of the step is left after eta H^2/(3 k E n^2), n = {outlets}",
                      np.interp(tau, time, settled), 1 - np.exp(-1), atol=3e-3)
    deck.expect_close(f"{what}: the whole way", t["gap"], relax(t["gap"][0], time, 1.0, resistance), atol=2e-3 * N / MODULUS)
    late = time > 0.05 * tau
    deck.expect_close(f"{what}: the plates hold the load, of particles and fluid", t["p_up"][late], 1, atol=1e-3)
    deck.expect_close(f"{what}: also the lower one, but for waves in the springs", t["p_low"][late], 1, atol=0.02)
    deck.expect_close(f"{what}: mean pressure of the fluid", t["mean"], -resistance(t["gap"]) * e, rtol=1e-10)
    for plate in ("lower", "upper"):
        closed = f"{plate} impermeable" in pore
        deck.expect_close(f"{what}: pressure at the {plate} plate", t[plate], 1.5 * closed * t["mean"], rtol=1e-12)
    deck.expect_close(f"{what}: the largest one", t["largest"], 1.5 * np.abs(t["mean"]), rtol=1e-12)
    out = {"flux_low": "lower drained" in pore, "flux_up": "upper drained" in pore}
    for name, open_ in out.items():
        deck.expect_close(f"{what}: {name}", t[name], -open_ * t["vy"] / outlets, rtol=1e-12)
    deck.expect_close(f"{what}: heat", t["heat"], resistance(t["gap"]) * e ** 2, rtol=1e-10)
    deck.expect("  and only one permeability", np.array_equal(t["k_min"], t["k_max"]))
    profile = [t[f"f_pore[1][{n}]"] for n in range(1, 6)]
    deck.expect_close(f"{what}: one layer, y", profile[0], t["gap"] / 2, atol=1e-10)
    deck.expect("  p", np.array_equal(profile[1], t["mean"]))
    deck.expect_close("  phi", profile[2], SOLID / (AREA * t["gap"]), rtol=1e-12)
    deck.expect_close("  u", profile[3], t["vy"] / 2, rtol=1e-12)
    deck.expect_close("  q, the mean of -(k/eta) dp/dy", profile[4], t["k_min"] / ETA * (t["lower"] - t["upper"]) / t["gap"], atol=1e-12)
    deck.expect_close(f"{what}: row 7", t["c_stress[7][2]"] * t["Volume"], -t["mean"] * AREA * t["gap"], rtol=1e-10)
    deck.expect_close(f"{what}: its shares", t["c_share"], t["c_stress[7][2]"] * t["Volume"], rtol=1e-12)
    deck.expect("  row 10 is value 16", np.array_equal(t["c_power[10][1]"], t["power"]))

    # what the load does is stored, kinetic, or turned into heat by the fluid: a trapezoid between outputs
    if load == "load":
        done = AREA * (t["gap"][0] - t["gap"])
        heat = np.concatenate([[0], np.cumsum(0.5 * (t["power"][1:] + t["power"][:-1]) * np.diff(time))])
        stored = t["PotEng"] + t["KinEng"]
        left = done - done[1] - (heat - heat[1]) - (stored - stored[1])
        deck.expect_close(f"{what}: energy", left[1:], 0, atol=2e-3 * done[-1])
        deck.expect("  the fluid takes part", heat[-1] > 0.3 * done[-1], f"{heat[-1] / done[-1]:.3g}")
if deck.RANKS == 1:
    same = ("gap", "vy", "p_low", "p_up", "mean", "heat", "power")
    deck.expect_same_bits("the closed side does not matter to the plates", {n: seen["drains above"][n] for n in same}, {n: seen["drains below"][n] for n in same})

# nothing moves, nothing flows; a fluid that is not felt changes nothing
t = read(pore=f"lower impermeable upper impermeable {CONSTANT}", load="gap", step="", time=5)
deck.expect("closed: no pressure at a given gap", np.all(t["mean"] == 0) and np.all(t["heat"] == 0))
dry, off = read(time=5, **{"with": "no"}), read(time=5, pore=f"{BELOW} {CONSTANT} coupling off")
deck.expect_same_bits("coupling off", {n: off[n] for n in dry}, dry)
deck.expect("coupling off: but it has a pressure", np.all(np.abs(off["mean"][1:]) > 1))
slow = read(time=5)
deck.expect("it is felt", np.all(np.abs(slow["vy"][1:]) < 0.05 * np.max(np.abs(dry["vy"]))))

# a fluid of any viscosity: the time step is that of the contacts
for viscosity in (1e8, 1e-30) if deck.RANKS == 1 else ():
    t = read(time=5, viscosity=viscosity)
    if viscosity > 1:
        tau = viscosity * N ** 2 / (3 * K * MODULUS)
        deck.expect_close(f"viscosity {viscosity:g}: it creeps", (N - t["gap"][-1]) / (N / MODULUS), t["Time"][-1] / tau, rtol=1e-3)
    else:
        for name in ("gap", "vy", "p_up", "PotEng"):
            deck.expect_close(f"viscosity {viscosity:g}: as dry, {name}", t[name], dry[name], atol=1e-20)

# a restart, and another number of ranks
for load in ("load", "pressure"):
    case = {"load": load, "time": 10, "outputs": 20, "grid": GRID, "pore": f"{BELOW} factor 2"}
    whole = read(half="yes", tables=True, **case)[-1]
    again = read(restarted="yes", **case)
    deck.expect_same_bits(f"{load}: restart", {n: again[n][1:] for n in again}, {n: whole[n][1:] for n in again})
    one = read(ranks=1, **{**case, "grid": "* * *"})
    here = read(**case)
    for name in ("gap", "vy", "p_up", "mean", "power", "c_share"):
        deck.expect_close(f"{load}, one rank: {name}", one[name], here[name], atol=1e-10 * np.max(np.abs(here[name])))

# ---- a periodic cell: the mean pressure alone
HELD, MORE = "deform/rheometer rate 1 pressure 20", "f_flow[3] f_flow[4] f_flow[8] f_pore[1][1] f_pore[1][2] f_pore[1][3]"
deck.make_state()
CELL = "../pore_cell/in.cell"


def motion(t):
    return {name: t[name] for name in ("PotEng", "KinEng", "Volume", "f_flow[8]")}


layer = read(CELL, flow=HELD, pore="pair cell mean layer 4 solver mean", more=MORE, grid=CELL_GRID, half="yes", steps=100, tables=True)
whole, layer = layer[1], layer[0]
d = deck.read_dump("whole.dump")
sauter = np.sum(d["radius"] ** 3) / np.sum(d["radius"] ** 2)
resistance = 4 ** 2 / (3 * beetstra(layer["f_flow[3]"], sauter))
deck.expect_close("cell: mean pressure", layer["f_pore[3]"][1:], -resistance[1:] * layer["f_flow[8]"][:-1], rtol=1e-9, atol=1e-9)
deck.expect("cell: there is some", np.ptp(layer["f_pore[3]"]) > 1, f"{np.ptp(layer['f_pore[3]']):.3g}")
deck.expect("cell: no forces", all(np.all(layer[f"f_pore[{n}]"] == 0) for n in (8, 9, 10)) and np.all(d["f_pore[1]"] == 0))
deck.expect_close("cell: one layer, y", layer["f_pore[1][1]"], layer["Ly"] / 2, rtol=1e-12)
deck.expect("  p", np.array_equal(layer["f_pore[1][2]"], layer["f_pore[3]"]))
deck.expect_close("  phi", layer["f_pore[1][3]"], layer["f_flow[3]"], rtol=1e-12)
again = read("../pore_cell/in.restarted", flow=HELD, pore="pair cell mean layer 4 solver mean", more=MORE, grid=CELL_GRID, steps=100)
deck.expect_same_bits("cell: restart", {n: again[n][1:] for n in again}, {n: whole[n][1:] for n in again})
closed = read(CELL, flow=HELD, pore="pair cell storage 0.005 mean undrained solver mean", more=MORE, steps=50)
none = read(CELL, flow=HELD, more="f_flow[3] f_flow[4] f_flow[8]", steps=50, **{"with": "no"})
deck.expect_same_bits("undrained: the particles feel nothing", motion(closed), motion(none))
deck.expect_close("undrained: dp = -dlnV/S", closed["f_pore[3]"], -np.log(closed["Volume"] / closed["Volume"][0]) / 0.005, atol=1e-11)

STRESS = [f"c_stress[{m}][{n}]" for m in range(1, 8) for n in (2, 7) if (m, n) not in ((2, 2), (7, 2))]    # yy, yx


# energy: the cell works against the total pressure; what the layer takes of that is heat, L e^2 V
def balance(fraction, pore, what="", **case):
    t = read(CELL, flow=HELD.replace("rheometer", "rheometer every 1"), pore=pore, more=" ".join(["f_flow[3] f_flow[4] f_flow[8]"] + STRESS), fraction=fraction, steps=int(200 / fraction), **case)
    dt = 5e-4 * fraction
    defect, heat = deck.power_balance(t, dt)
    return defect, heat[9], t


LAYERS = {"layer": "pair cell mean layer 4 solver mean", "layer and grid": "pair cell mean layer 4", "undrained": "pair cell storage 0.005 mean undrained solver mean"}
for what, pore in LAYERS.items() if deck.RANKS == 1 else list(LAYERS.items())[:1]:
    coarse, _, _ = balance(1, pore)
    fine, share, t = balance(0.25, pore)
    without, _, _ = balance(0.25, f"pair cell coupling off {pore[9:]}")
    deck.expect(f"energy, {what}: the balance closes as well as without pores", fine < min(0.3 * coarse, 1.5 * without),
                f"{coarse:.1e} {fine:.1e} without {without:.1e}")
    deck.expect(f"energy, {what}: the fluid takes part", abs(share) > 0.005, f"{share:.3g}")
    volume, p = t["Volume"], t["f_pore[3]"]
    of_step = p[1:] if "layer" in what else 0.5 * (p[1:] + p[:-1])
    given = -of_step * np.diff(volume) / (5e-4 * 0.25)
    if what != "layer and grid":    # whose fluid takes from the particles, too
        deck.expect_close(f"energy, {what}: row 10 is -p dV/dt", t["c_power[10][1]"][1:], given, rtol=1e-8, atol=1e-8)
    if what == "layer":
        resistance, e = 4 ** 2 / (3 * beetstra(t["f_flow[3]"], sauter)), t["f_flow[8]"]
        deck.expect_close("energy, layer: heat of the layer", t["c_power[10][1]"][1:], (resistance * volume)[1:] * e[:-1] ** 2, rtol=1e-4, atol=1e-4)
        deck.expect_close("energy, layer: value 7 is the same per volume", t["f_pore[7]"][1:] * volume[1:], t["c_power[10][1]"][1:], rtol=1e-4, atol=1e-4)
        yy, yx = (sum(t[f"c_stress[{m}][{n}]"] for m in range(1, 8)) for n in (2, 7))
        deck.expect_close("energy, layer: the input is that of the total stress, of which fix deform/rheometer has the pressure",
                          yy[1:], -t["f_flow[4]"][1:], rtol=1e-9)
        deck.expect_close("  in the flow of the next step", t["c_power"][1:], (volume * (yx + yy * e))[1:], rtol=1e-4)

# discs, in the plane: a cell, the pressure of a layer per length
deck.make_state(dim=2, phi=0.75)
for solver in ("", "solver mean"):
    t = read(CELL, dim=2, flow=HELD, pore=f"pair cell permeability constant 0.02 mean layer 4 {solver}", more="f_flow[4] f_flow[8]", steps=50)
    deck.expect_close(f"discs, {solver}: mean pressure", t["f_pore[3]"][1:], -(4 ** 2 / (3 * 0.02)) * t["f_flow[8]"][:-1], rtol=1e-10, atol=1e-10)
    deck.expect("  there is some", np.ptp(t["f_pore[3]"]) > 1, f"{np.ptp(t['f_pore[3]']):.3g}")
    deck.expect_close("  row 7 is minus that, along x and y", t["c_stress[7][1]"], -t["f_pore[3]"], rtol=1e-10, atol=1e-10)
deck.finish()
