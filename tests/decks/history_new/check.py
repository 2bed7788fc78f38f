# ranks: 1 2
"""Histories that end: forgotten by command, of particles that were given another size, of sub-styles that are not where
they were; and gaps of particles that grow during a run."""
import numpy as np
from scipy.integrate import solve_ivp

import deck

COLUMNS = ("fx", "fy", "fz", "tqx", "tqy", "tqz")


def forces(name):
    dump = deck.read_dump(name)
    return np.column_stack([dump[c] for c in COLUMNS])


deck.make_state()
for how in ("forget", "restart", "size", "size_restart"):
    text = deck.run("in.forget", how=how).text
    deck.run("in.anew", diameter=2.05 if how.startswith("size") else 0)
    a, b = forces("anew.dump"), forces(f"{how}.dump")
    deck.expect_close(f"{how}: pairs begin anew", b, a, atol=1e-8 * np.sqrt(np.mean(a ** 2)))
    deck.expect(f"{how}: and the log says so", ("radii of 200 atoms were changed" if how.startswith("size") else
                "200 particles of group all begin the next run without a history") in text)
deck.run("in.forget", how="nothing")
past = forces("nothing.dump")
deck.expect("the past matters", np.max(np.abs(forces("forget.dump") - past)) > 1)
deck.run("in.forget", how="some")
part = np.max(np.abs(forces("some.dump") - past), axis=1)
deck.expect("of some particles only", np.max(part[:10]) > 1 and np.sum(part == 0) > 60, np.sum(part == 0))

NU = 1.5 * np.pi    # F = NU a^2 (du/dt)/u of the film = g (un - u) of the bulk
for g in (1e4, 1e6):
    thermo = deck.run("in.growing", g=g).thermo()
    deck.expect_close(f"g {g:g}: the gap stays", thermo["c_sum[1]"], 0.1, rtol=1e-3)
    deck.expect_close("and the film of growing spheres feels nothing", thermo["c_sum[2]"], 0.0, atol=1e-3 * NU * 0.4 / 0.1)
    thermo = deck.run("in.growing", g=g, apart=0, dt=1e-4).thermo()
    exact = solve_ivp(lambda t, ln_u: g * (0.1 - 0.4 * t - np.exp(ln_u)) / (NU * (1 + 0.2 * t)**2), (0, 0.2), [np.log(0.1)],
                      method="LSODA", rtol=1e-10, atol=1e-12, dense_output=True).sol
    t = thermo["Step"] * 1e-4
    deck.expect_close("spheres that grow towards each other squeeze it", thermo["c_sum[2]"][1:],
                      g * (np.exp(exact(t)[0]) - 0.1 + 0.4 * t)[1:], rtol=2e-4)

run = deck.run("in.hybrid")
deck.run("in.hybrid", first="no")
swapped = deck.run("in.hybrid", first="no", one=2, two=1, fails=True).text
deck.expect_error("sub-styles in another order", swapped, "do not belong to any pair of this pair style lubcontact")
for words, message in (("", "takes two words, but has 0"), ("lose all", "Unknown word lose"), ("forget nobody", "does not exist")):
    text = deck.run("in.words", words=words, fails=True).text
    deck.expect_error(words, text, message)
deck.finish()
