# ranks: 1 4
"""The flip of the cell leaves forces, history and stress continuous: the run without flips is the oracle."""
import numpy as np

import deck

deck.make_state()
yes = deck.run("in.flip", flip="yes", out="yes.dump")
no = deck.run("in.flip", flip="no", out="no.dump")
t, s = yes.thermo(), no.thermo()
deck.expect("a flip happened", t["Xy"].min() < 0 < t["Xy"].max() and s["Xy"].min() > 0)
for name in t:
    if name != "Xy":
        deck.expect_close(f"thermo {name}", t[name], s[name], rtol=1e-9, atol=1e-10)
a, b = deck.read_dump("yes.dump"), deck.read_dump("no.dump")
for column in ("vy", "omegaz", "fx", "fy", "tqz"):
    deck.expect_close(column, a[column], b[column], atol=1e-8 * np.sqrt(np.mean(b[column] ** 2)))
deck.finish()
