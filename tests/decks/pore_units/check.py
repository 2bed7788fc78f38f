# ranks: 1
"""Pores in units real and metal, where pressure is not force/area and force not mass times acceleration: the numbers of units lj."""
import numpy as np

import deck

UNIT = {"lj": 1.0, "real": 68568.415, "metal": 1.6021765e6}    # pressure over force/area
MASS = {1.0: 1.0, 68568.415: 1 / 48.88821291 ** 2, 1.6021765e6: 1 / 1.0364269e-4}    # over force*time^2/length
CELL, PLATES = {"where": "cell"}, {"where": "plates", "P": 5}


def storage(S, unit):
    return f"storage {S / unit:.17g}"


def loaded(unit):
    return f"rate 1 mass {200 * MASS[unit]:.17g} load"


CASES = {
    "cell, layer": lambda unit: {**CELL, "pore": "mean layer 4"},
    "cell, undrained": lambda unit: {**CELL, "pore": f"mean undrained {storage(0.005, unit)}"},
    "cell, the mean alone": lambda unit: {**CELL, "pore": "mean layer 4 solver mean"},
    "cell, gradient": lambda unit: {**CELL, "pore": f"gradient {-3 * unit:.17g} {2 * unit:.17g} 0"},
    "plates, drained": lambda unit: {**PLATES, "hold": "rate 1 pressure", "pore": f"lower impermeable upper drained pressure {3 * unit:.17g}"},
    "plates, closed above": lambda unit: {**PLATES, "hold": loaded(unit), "pore": "lower drained upper impermeable"},
    "plates, closed": lambda unit: {**PLATES, "hold": loaded(unit), "pore": f"lower impermeable upper impermeable {storage(0.01, unit)}"},
    "plates, the mean alone": lambda unit: {**PLATES, "hold": loaded(unit), "pore": "lower drained upper impermeable solver mean"},
    "plates, the mean alone, servo": lambda unit: {**PLATES, "hold": "rate 1 pressure", "pore": "lower drained upper drained solver mean"},
}


def measured(scale, case):
    t = deck.run("in.units", scale=scale, **case(UNIT[scale])).thermo()
    return {**t, **{name: values for name, values in deck.read_dump("units.dump").items()}}


made = None
for what, case in CASES.items():
    if made != case(1)["where"]:
        made = case(1)["where"]
        deck.make_state() if made == "cell" else deck.run(deck.ROOT / "tests" / "decks" / "plates" / "state.lmp", ranks=1)
    base = measured("lj", case)
    deck.expect(f"{what}: there is a pressure", np.max(np.abs(base["v_largest"])) > 0.1, f"{np.max(np.abs(base['v_largest'])):.3g}")
    for scale in ("real", "metal"):
        other = measured(scale, case)
        for name in base:
            size = np.max(np.abs(base[name]))
            if size > 1e-9:
                # the motion doubles differences of rounding every few steps
                deck.expect_close(f"{what}, {scale}: {name}", other[name], base[name], atol=1e-7 * size)
deck.finish()
