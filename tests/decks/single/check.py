# ranks: 1 2
"""single() leaves the trajectory bit for bit, and its parts are those that the run tallied."""
from pathlib import Path

import numpy as np

import deck

deck.make_state()
looked = deck.run("in.single", look="yes", out="looked.dump")
deck.run("in.single", look="no", out="plain.dump")
a, b = deck.read_dump("looked.dump"), deck.read_dump("plain.dump")
for column in a:
    deck.expect(f"bit for bit: {column}", np.array_equal(a[column], b[column]))

lines = Path("pairs.dump").read_text().splitlines()
start = max(n for n, line in enumerate(lines) if line.startswith("ITEM: ENTRIES"))
dist, energy, u, un, ue, contact, film, sx, sy, sz, friction, shear, state = np.array(
    [line.split() for line in lines[start + 1:]], dtype=float).T
last = {name: values[-1] for name, values in looked.thermo().items()}
trace = [sum(last[f"c_stress[{row}][{n}]"] for n in (1, 2, 3)) * last["Volume"] for row in (1, 3)]
deck.expect_close("sum of r F, contact normal", -np.sum(dist * contact), trace[0], rtol=1e-12)
deck.expect_close("sum of r F, lubrication normal", -np.sum(dist * film), trace[1], rtol=1e-9)
deck.expect_close("stored energy", np.sum(energy), last["PotEng"], rtol=1e-12)
inside = un < 0.5
deck.expect_close("series model: F = -g (un - u)", (contact + film)[inside], -1e4 * ue[inside], rtol=1e-9, atol=1e-9)
deck.expect("the gap is positive", np.all(u[inside] > 0))
deck.expect_close("friction and film share the tangential force", friction + shear, np.sqrt(sx**2 + sy**2 + sz**2),
                  rtol=1e-12, atol=1e-12)
deck.expect("Coulomb", np.all(friction <= 0.5 * contact * (1 + 1e-9)))
deck.expect("all three states occur", set(state) == {0.0, 1.0, 2.0}, str(sorted(set(state))))
deck.expect("touching pairs stick or slip", np.array_equal(state > 0, contact > 0))

for newton in ("on", "off"):
    thermo = deck.run("in.screened", newton=newton).thermo()
    lines = Path("screened.dump").read_text().splitlines()
    start = max(n for n, line in enumerate(lines) if line.startswith("ITEM: ENTRIES"))
    repulsion = np.array([line.split() for line in lines[start + 1:]], dtype=float).T[2]
    deck.expect(f"newton {newton}: some pairs in range share no face", np.sum(repulsion == 0.0) > 100, np.sum(repulsion == 0.0))
    share = thermo["c_energy"] / thermo["PotEng"]
    deck.expect_close(f"newton {newton}: energy of the pairs is that of the run", share, 1.0, rtol=1e-10)
deck.finish()
