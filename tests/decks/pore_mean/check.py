# ranks: 1 4
"""The mean pressure of the pores in a periodic cell: a layer that drains, and one that cannot."""
import itertools

import numpy as np

import deck

CELL = "../pore_cell/in.cell"
GRID = {1: "1 1 1", 2: "1 2 1", 4: "2 2 1"}[deck.RANKS]
MORE = "f_flow[3] f_flow[4] f_flow[8]"
HELD = "deform/rheometer rate 1 pressure 20"
SPRING, EDGE, DT = 1000.0, 2.8, 4e-3
NEIGHBORS = np.array([n for n in itertools.product((-1, 0, 1), repeat=3) if sum(map(abs, n)) == 2]) * EDGE / 2


def beetstra(phi, radius=1.0):
    drag = 10 * phi / (1 - phi) ** 3 + (1 - phi) * (1 + 1.5 * np.sqrt(phi))
    return 2 * radius ** 2 / (9 * phi * drag)


# ---- a lattice of springs under a step of the pressure: (C + L) dlnV/dt = p - P with its own p(V)
def of_springs(flow, log_volume):
    """Pressure of the face-centered lattice, of which a shear changes y alone, and an extension all edges."""
    strain = np.multiply.outer(log_volume, (0, 1, 0) if flow == "shear" else (1 / 3, 1 / 3, 1 / 3))
    bonds = NEIGHBORS * np.exp(strain)[..., None, :]
    length = np.linalg.norm(bonds, axis=-1)
    sums = np.einsum("...n,...nd->...d", SPRING * (2 - length) / length, bonds ** 2) / (2 * EDGE ** 3 / 4 * np.exp(np.asarray(log_volume)[..., None]))
    return sums[..., 1] if flow == "shear" else np.mean(sums, axis=-1)


def modulus(flow):
    """-dp/dlnV of the lattice at the start."""
    return (of_springs(flow, -1e-5) - of_springs(flow, 1e-5)) / 2e-5


def relax(flow, drainage, log_volume, target, time):
    """ln V at these times, by Runge and Kutta's rule."""
    dashpot = np.sqrt(8 * 4 * target)    # of the piston, whose gain is large: its mass is 4

    def rate(z):
        return (of_springs(flow, z) - target) / (dashpot + drainage(z))
    found = [log_volume]
    for h in np.diff(time):
        z, k = found[-1], [0.0]
        for part in (0, 0.5, 0.5, 1):
            k.append(rate(z + part * h * k[-1]))
        found.append(z + h * (k[1] + 2 * k[2] + 2 * k[3] + k[4]) / 6)
    return np.array(found)


PHI = 4 * 4 / 3 * np.pi / EDGE ** 3
LAYERS = {"constant": ("2 permeability constant 0.02 mean layer 10", lambda z: 2 * 10 ** 2 / (3 * 0.02) + 0 * z),
          "beetstra": ("1 factor 3 mean layer 4", lambda z: 4 ** 2 / (3 * 3 * beetstra(PHI * np.exp(-z))))}
for flow, law in (("shear", "constant"), ("shear", "beetstra"), ("uniaxial", "constant")) if deck.RANKS == 1 else (("shear", "beetstra"),):
    what, (pore, drainage), P, AFTER = f"{flow}, {law}", LAYERS[law], 16.0, 12.0
    tau = drainage(0.0) / modulus(flow)
    steps = int(round(3 * tau / DT / 10)) * 10
    tables = deck.run("in.lattice", flow=flow, pore=pore, pressure=P, after=AFTER, steps=steps).tables()
    for t, target in zip(tables, (P, AFTER)):
        z, time = np.log(t["Volume"] / (4 * EDGE) ** 3), (t["Step"] - t["Step"][0]) * DT
        step = of_springs(flow, z[0]) - target
        left = (of_springs(flow, z) - target) / step
        at = np.argmin(np.abs(time - tau))
        deck.expect_close(f"{what}: 1/e of the step to {target:g} is left after eta H^2/(3 k E)", left[at], np.exp(-1), rtol=0.03)
        deck.expect_close(f"{what}: the whole way", z, relax(flow, drainage, z[0], target, time), atol=5e-3 * abs(z[-1] - z[0]))
        deck.expect(f"{what}: it does not ring", np.all(np.diff(left) <= 1e-12))
        fluid, total = t["f_pore[3]"][1:], t["f_flow[4]"][1:]
        deck.expect_close(f"{what}: the pressure held is that of particles and fluid", total, of_springs(flow, z[1:]) + fluid,
                          atol=1e-8 * target)
        late = time[1:] > 0.1 * tau
        deck.expect_close(f"{what}: and is held", total[late], target, atol=0.02 * abs(step))
        rate = np.gradient(z, time)[1:-1]
        deck.expect_close(f"{what}: the fluid resists the change of volume", fluid[:-1][late[:-1]], (-drainage(z[1:-1]) * rate)[late[:-1]],
                          atol=3e-3 * abs(step))
        deck.expect_close(f"{what}: it is even", np.abs(fluid), t["f_pore[4]"][1:], atol=1e-8)
        deck.expect("and called so", np.array_equal(t["f_pore[1]"], t["f_pore[3]"]))

# ---- a sheared suspension
deck.make_state()
LAYER, CLOSED = "pair cell mean layer 4", "pair cell storage 0.005 mean undrained"
steps = 200
layer = deck.run(CELL, flow=HELD, pore=LAYER, more=MORE, steps=steps).thermo()
d = deck.read_dump("cell.dump")
radius = np.sum(d["radius"] ** 3) / np.sum(d["radius"] ** 2)
resistance = 4 ** 2 / (3 * beetstra(layer["f_flow[3]"], radius))
deck.expect_close("layer: the mean pressure is minus the resistance times the dilation", layer["f_pore[3]"][1:],
                  -(resistance[1:] * layer["f_flow[8]"][:-1]), rtol=1e-9, atol=1e-9)
deck.expect("layer: there is some", np.ptp(layer["f_pore[3]"]) > 1, f"{np.ptp(layer['f_pore[3]']):.3g}")
drained = deck.run(CELL, flow=HELD, more=MORE, steps=steps).thermo()
deck.expect("layer: it slows the change of volume", np.ptp(layer["Volume"]) < 0.5 * np.ptp(drained["Volume"]),
            f"{np.ptp(layer['Volume']):.3g} {np.ptp(drained['Volume']):.3g}")
closed = deck.run(CELL, flow=HELD, pore=CLOSED, more=MORE, steps=steps).thermo()
for what, flow in {"undrained": HELD, "undrained, fix deform": "deform 1 y erate 0.05 remap v"}.items():
    t = closed if flow == HELD else deck.run(CELL, flow=flow, pore=CLOSED, steps=steps).thermo()
    change = -np.log(t["Volume"] / t["Volume"][0]) / 0.005
    deck.expect(f"{what}: the volume changes", np.ptp(change) > 0.1, f"{np.ptp(change):.3g}")
    late = flow != HELD    # fix deform moves the cell after the forces are known
    deck.expect_close(f"{what}: dp = -dlnV/S", t["f_pore[3]"][late:], change[:len(change) - late], atol=1e-11)
for what, t in {"layer": layer, "undrained": closed}.items():
    for n in (1, 2, 3):
        deck.expect_close(f"{what}: row 7 is minus the mean pressure, {n}", t[f"c_stress[7][{n}]"], -t["f_pore[3]"], rtol=1e-12, atol=1e-12)
    deck.expect(f"{what}: the largest pressure contains it", np.all(t["f_pore[4]"] >= np.abs(t["f_pore[3]"]) * (1 - 1e-12)))

# what is held is the pressure of the particles but for a layer; a fluid that is not felt changes nothing
def motion(t):
    return {name: t[name] for name in ("PotEng", "KinEng", "Volume", "f_flow[4]", "f_flow[8]")}


deck.expect_same_bits("undrained: the cell moves as if drained", motion(closed),
          motion(deck.run(CELL, flow=HELD, pore=CLOSED.replace("undrained", "drained"), more=MORE, steps=steps).thermo()))
words = "pair cell mean drained"
deck.expect_same_bits("drained is the default", deck.run(CELL, flow=HELD, pore=words, more=MORE, steps=steps).thermo(), drained)
volume = HELD.replace("pressure 20", "volume")
deck.expect_same_bits("constant volume: no mean pressure", motion(deck.run(CELL, flow=volume, pore=LAYER, more=MORE, steps=50).thermo()),
          motion(deck.run(CELL, flow=volume, more=MORE, steps=50).thermo()))
off = {words: deck.run(CELL, flow=HELD, pore=f"pair cell coupling off mean {words}", more=MORE, steps=50).thermo()
       for words in ("drained", "layer 4")}
deck.expect_same_bits("coupling off: not felt", motion(off["layer 4"]), motion(off["drained"]))
deck.expect("coupling off: but it has a pressure", np.ptp(off["layer 4"]["f_pore[3]"]) > 1 and np.all(off["layer 4"]["c_stress[7][1]"] == 0))

# high layers, whose fluid carries at once what the particles do not: the cell keeps its volume, and nothing rings
change = []
for height in (40, 4000) if deck.RANKS == 1 else ():
    t = deck.run(CELL, flow=HELD, pore=f"pair cell mean layer {height}", more=MORE, steps=400).thermo()
    change.append(np.ptp(t["Volume"]))
    deck.expect_close(f"layer of {height}: the total pressure is held", t["f_flow[4]"][24:], 20, rtol=0.015)
    deck.expect(f"layer of {height}: the particles press less", np.all(t["f_pore[3]"][24:] > 10))
if change:
    deck.expect_close("the change of volume is as 1/H^2", change[0] / change[1], 1e4, rtol=0.01)

# ---- a restart
for what, pore in {"layer": LAYER, "undrained": CLOSED}.items():
    for half in (100, 6):
        case = {"flow": HELD, "pore": pore, "more": MORE, "grid": GRID, "steps": half}
        whole = deck.run(CELL, half="yes", **case).thermo()
        again = deck.run("../pore_cell/in.restarted", **case).thermo()
        deck.expect_same_bits(f"{what}: restart after {half} steps", deck.read_dump("restarted.dump"), deck.read_dump("whole.dump"))
        deck.expect_same_bits(f"{what}: restart after {half} steps, output", {name: again[name][1:] for name in again},
                               {name: whole[name][1:] for name in again})
        deck.expect_close(f"{what}: and its first pressure", again["f_pore[3]"][0], whole["f_pore[3]"][0])
deck.finish()
