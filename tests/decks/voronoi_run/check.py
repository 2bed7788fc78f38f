# ranks: 1 4
"""Runs with range voronoi: any number of ranks, newton on or off, flips of the cell and restarts give the same run."""
import numpy as np

import deck

VORONOI = {"range": "voronoi 1.5"}


def same(what, one, other, columns=("yu", "vx", "vy", "omegaz", "fx", "tqz")):
    a, b = deck.read_dump(one), deck.read_dump(other)
    for column in columns:
        deck.expect_close(f"{what}, {column}", b[column], a[column], atol=1e-8 * np.sqrt(np.mean(a[column] ** 2)))


deck.make_state()
one = deck.run("../ranks/in.ranks", ranks=1, out="one.dump", **VORONOI).thermo()
many = deck.run("../ranks/in.ranks", out="many.dump", newton="off", **VORONOI).thermo()
same("one rank, and ranks without newton", "one.dump", "many.dump")
for name, values in one.items():
    deck.expect_close(f"thermo {name}", many[name], values, rtol=1e-8, atol=1e-10)
deck.run("../ranks/in.ranks", ranks=1, out="cut.dump", range="cut 1.5")
a, b = deck.read_dump("one.dump"), deck.read_dump("cut.dump")
deck.expect("screening acts", np.max(np.abs(a["fx"] - b["fx"])) > 1)
deck.run("../ranks/in.ranks", out="half.dump", range="voronoi 0.5")
deck.run("../ranks/in.ranks", out="cut.dump", range="cut 0.5")
same("nobody stands between spheres of nearly equal size at a gap of 0.5", "cut.dump", "half.dump")

deck.run("in.flip", flip="yes", out="yes.dump", **VORONOI)
deck.run("in.flip", flip="no", out="no.dump", **VORONOI)
same("flip", "yes.dump", "no.dump", ("vx", "vy", "omegaz", "fx", "tqz"))

deck.make_state(shape="orthogonal")
straight = deck.run("../restart/in.straight", **VORONOI)
restarted = deck.run("../restart/in.restarted")
deck.expect("the rule is in the restart file", "range          voronoi 1.5" in restarted.text)
a, b = deck.read_dump("straight.dump"), deck.read_dump("restarted.dump")
for column in a:
    deck.expect(f"restart bit for bit: {column}", np.array_equal(a[column], b[column]),
                f"largest difference {np.max(np.abs(a[column] - b[column])):.1e}")
deck.finish()
