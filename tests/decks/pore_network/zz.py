# ranks: 1 2 4
"""The pressure in the network of the pores: permeability, momentum, power, ranks, restart, flip."""
import numpy as np

import deck

PORE = ("lower", "upper", "mean", "largest", "flux_low", "flux_up", "heat", "fx", "fy", "fz", "iterations", "residual",
        "k_min", "k_max", "step", "power")
GRID = {1: "1 1 1", 2: "1 2 1", 4: "2 2 1"}[deck.RANKS]
SINGLE = deck.RANKS == 1
FLOWS = {"shear": {}, "pressure": {"flow": "deform/rheometer rate 1 pressure 20"}}
NETWORK = "pair cell solver network"


def read(what="../pore_cell/in.cell", **variables):
    t = deck.run(what, **{"pore": NETWORK, **variables}).thermo()
    t.update({name: t.pop(f"f_pore[{n + 1}]") for n, name in enumerate(PORE) if f"f_pore[{n + 1}]" in t})
    return t


def same_bits(what, a, b):
    wrong = [f"{name} {np.max(np.abs(a[name] - b[name])):.1e}" for name in a if not np.array_equal(a[name], b[name])]
    deck.expect(f"{what}: bit for bit", not wrong, " ".join(wrong))


deck.run(deck.ROOT / "tests" / "decks" / "plates" / "state.lmp", ranks=1)
WALLS = {"open": "lower drained upper drained", "below closed": "lower impermeable upper drained",
         "above closed": "lower drained upper impermeable", "closed": "lower impermeable upper impermeable"}
OUTSIDE = 3.0


def sheared(walls, motion, what="in.sheared", **variables):
    words = f"plates cell {WALLS[walls]} solver network tolerance 1e-10" + ("" if walls == "closed" else f" pressure {OUTSIDE}")
    return read("../pore_plates/" + what, before=f"fix pore all pore/pressure 1 {words}", motion=motion, **variables)


for walls, motion in (("open", "rate 1 pressure 5"), ("below closed", "stress 10 load 5 mass 5"),
                      ("above closed", "stress 10 load 5 mass 5"), ("closed", "rate 1 gap")) if SINGLE else (("open", "rate 1 pressure 5"),):
    t, d = sheared(walls, motion, steps=60), deck.read_dump("plates.dump")
    size = np.sum(np.abs([d[f"f_pore[{n}]"] for n in (1, 2, 3)]))
    area = t["Lx"] * t["Lz"]
    out = OUTSIDE * area * {"open": 0, "closed": 0, "below closed": -1, "above closed": 1}[walls]
    for name, force in (("fx", 0), ("fy", out), ("fz", 0)):
        deck.expect_close(f"{walls}: {name} of all", t[name], force, atol=1e-12 * size)
    flux = t["flux_low"] + t["flux_up"]
    speed = t["f_cell[5]"]
    late = range(2, 61)
    if walls in ("open", "closed"):
        deck.expect_close(f"{walls}: what leaves is what the plate takes", flux[late], -speed[late], atol=1e-6 * np.max(np.abs(flux)))
    else:    # the velocity is that in the middle of the step, by the forces of the pressure, too
        deck.expect_close(f"{walls}: what leaves is what the plate takes", np.mean(flux[late]), -np.mean(speed[late]), rtol=0.05)
    if walls in ("open", "above closed"):
        deck.expect_close(f"{walls}: pressure of the drained plate", t["lower"], OUTSIDE, rtol=1e-14)
    one = sheared(walls, motion, steps=60, ranks=1 if not SINGLE else 2)
    for name in ("largest", "heat", "KinEng"):
        deck.expect_close(f"{walls}, other ranks: {name}", one[name], t[name], atol=1e-10 * np.max(np.abs(t[name])))
    whole = sheared(walls, motion, steps=60, half="yes", grid=GRID)
    again = sheared(walls, motion, "in.restarted", grid=GRID)
    same_bits(f"{walls}: restart", deck.read_dump("restarted.dump"), deck.read_dump("whole.dump"))
deck.finish()
