# ranks: 1 2
"""Walls made of particles, at rest or moved by LAMMPS' own fixes: the film acts between them and the others as between all."""
import numpy as np

import deck
from deck import expect, expect_close, finish, read_dump, run


def plates():
    """Plates that fix move moves, and that fix freeze or nobody holds, do what those of fix rheometer/plates do."""
    deck.run(deck.ROOT / "tests" / "decks" / "plates" / "state.lmp", ranks=1)
    run("in.plates")
    expected = read_dump("rheometer.txt")
    free = expected["type"] == 1
    for how in "move", "freeze", "setforce":
        run("in.plates", plates=how)
        d = read_dump(f"{how}.txt")
        if how == "setforce":
            expect("fix setforce holds no spin: particles of the plate roll", np.max(np.abs(d["omegaz"][~free])) > 0.1)
            expect("and the plate slips", np.max(np.abs(d["xu"] - expected["xu"])[free]) > 1e-2)
            continue
        for name in ("xu", "yu", "zu", "vx", "vy", "omegaz"):
            size = np.sqrt(np.mean(expected[name][free]**2))
            expect_close(f"{how}: {name}", d[name][free], expected[name][free], atol=1e-9 * size)
        expect_close(f"{how}: plates do not turn", d["omegaz"][~free], 0)


def floor():
    """A frozen sphere of radius L is a plane for the film: weight = 6 pi eta R^2 u'/u / (1 + R/L)^2."""
    for large in 1e2, 1e3:
        t = run("in.floor", large=large).thermo()
        rate = 4 / 3 * np.pi / (6 * np.pi) * (1 + 1 / large)**2
        late = t["Time"] > 1
        slope = np.polyfit(t["Time"][late], np.log(t["c_gap"][late]), 1)[0]
        expect_close(f"settling on a sphere of radius {large:.0f}: rate", -slope, rate, rtol=1e-5)


def rotation():
    t = run("in.turn", scene="body", steps=2000).thermo()
    for n, what in enumerate(("torque", "force along x", "force along y")):
        expect_close(f"fix move rotate turns particles as one body: {what}", t[f"c_most[{n + 1}]"], 0.0, atol=1e-9)

    step = 2e-3
    t = run("in.turn", scene="drum", step=step, steps=1200).thermo()
    torque = t["c_free[2]"]
    expect_close("drum: its torque and that on the others", t["c_drum"], -torque, atol=1e-10 * np.max(np.abs(torque)))
    gained = np.concatenate([[0], np.cumsum(0.5 * (torque[1:] + torque[:-1]))]) * step
    expect("drum: it carries them along", gained[-1] > 100, f"{gained[-1]:.1f}")
    expect_close("drum: angular momentum of the others", t["c_free[1]"] - t["c_free[1]"][0], gained, atol=1e-9 * gained[-1])


plates()
floor()
rotation()
finish()
