# ranks: 1 2
"""Under hybrid/overlay the style gives what it gives alone: forces, stress by origin, history."""
import numpy as np

import deck

deck.make_state()
alone = deck.run("in.hybrid", way="alone", out="alone.dump")
hybrid = deck.run("in.hybrid", way="hybrid", out="hybrid.dump")
a, b = deck.read_dump("alone.dump"), deck.read_dump("hybrid.dump")
for column in ("x", "vx", "fx", "tqz"):
    deck.expect_close(column, b[column], a[column], atol=1e-9 * np.sqrt(np.mean(a[column] ** 2)))
for name, values in alone.thermo().items():
    deck.expect_close(name, hybrid.thermo()[name], values, rtol=1e-9, atol=1e-10)
deck.finish()
