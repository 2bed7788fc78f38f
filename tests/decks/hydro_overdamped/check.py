# ranks: 1 2
"""fix overdamped/sphere hydro: arrays that settle, a shear against light particles with inertia, power, ranks, restart."""
import numpy as np

import deck

RUN = deck.ROOT / "tests" / "decks" / "hydro_run"
SINGLE = deck.RANKS == 1    # on several ranks: what is summed over them
GRID = {1: "1 1 1", 2: "1 2 1"}[deck.RANKS]
EXACT = "tol 1e-8 spacing 0.5 points 12 reach 8"
MOVE = "overdamped/sphere hydro"
ROWS = [f"c_power[{m}][{n}]" for n in (1, 2) for m in range(1, 12)]


def settling():
    """Velocity of a simple cubic array under a force, as soon as the solutions have found it."""
    for phi, drag in ((0.001, 1.212205), (0.343, 11.74646)):
        for every in (1, 10):
            t = deck.run(RUN / "in.array", move=MOVE, phi=phi, push=6 * np.pi, hydro=f"grid every {every} {EXACT}", steps=300).thermo()
            name = f"simple cubic array, phi {phi}, a solution every {every}"
            deck.expect_close(f"{name}: velocity", t["v_v"][-1], 1 / drag, rtol=2e-5)
            deck.expect_close(f"{name}: the fluid carries the force", t["f_far[10]"][-1], -6 * np.pi, rtol=1e-12)
            deck.expect_close(f"{name}: heat", t["f_far[9]"][-1], 6 * np.pi / drag, rtol=4e-5)


def cell(name, **variables):
    t = deck.run(RUN / "in.cell", out=f"{name}.dump", **variables).thermo()
    return t, deck.read_dump(f"{name}.dump")


def inertia():
    """Particles without inertia move as ever lighter ones do."""
    same = {"step": 2e-5, "steps": 1500, "every": 1500}
    deck.make_state(N=60, phi=0.35, density=1e-3)
    without, end = cell("without", move=MOVE, **same)
    errors, stress = [], []
    for density in (4e-3, 1e-3):
        deck.make_state(N=60, phi=0.35, density=density)
        t, d = cell("with", **same)
        errors.append(np.linalg.norm([d[c] - end[c] for c in "xyz"]) / np.sqrt(60))
        stress.append(abs(t["f_far[6]"][-1] / without["f_far[6]"][-1] - 1))
    print("inertia:", errors, stress)
    deck.expect("places", errors[1] < 0.4 * errors[0] and errors[1] < 0.01, errors)
    deck.expect("stresslets", stress[1] < 0.4 * stress[0] and stress[1] < 0.01, stress)


def balance():
    """First order in the step."""
    errors = []
    for fraction in (1, 0.25):
        dt = 2e-4 * fraction
        t = deck.run(RUN / "in.cell", move=MOVE, step=dt, steps=int(200 / fraction), more=" ".join(["c_power", *ROWS])).thermo()
        errors.append(deck.power_balance(t, dt)[0])
    deck.expect("the balance of energy closes", errors[1] < min(0.35 * errors[0], 0.01), f"{errors}")


def rounding():
    """Ranks and a restart change digits at the end."""
    names = ("f_far[6]", "f_far[9]", "PotEng", "c_stress[2][4]")
    whole = {"move": MOVE, "step": 2e-4, "steps": 100, "grid": GRID}
    done = deck.run(RUN / "in.cell", half="yes", **whole)
    first, t = done.tables()[-2:]
    if not SINGLE:
        one = deck.run(RUN / "in.cell", ranks=1, **{**whole, "grid": "* * *"}).thermo()
        for name in names:
            deck.expect_close(f"one rank: {name}", one[name], first[name], atol=1e-7 * np.max(np.abs(first[name])))
    again = deck.run(RUN / "in.restarted", **whole).thermo()
    for name in names:
        deck.expect_close(f"restart: {name}", again[name], t[name], atol=1e-9 * np.max(np.abs(t[name])))


if __name__ == "__main__":
    if SINGLE:
        settling()
        inertia()
    deck.make_state(N=60, phi=0.35)
    rounding()
    if SINGLE:
        balance()
    deck.finish()
