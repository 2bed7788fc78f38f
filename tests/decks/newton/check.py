# ranks: 1 4
"""newton off gives the trajectory of newton on, and the same stress by origin."""
import numpy as np

import deck

deck.make_state()
on = deck.run("../ranks/in.ranks", out="on.dump", newton="on")
off = deck.run("../ranks/in.ranks", out="off.dump", newton="off")
a, b = deck.read_dump("on.dump"), deck.read_dump("off.dump")
for column in ("yu", "vx", "vy", "omegaz", "fx", "tqz"):
    deck.expect_close(column, b[column], a[column], atol=1e-8 * np.sqrt(np.mean(a[column] ** 2)))
for name, values in on.thermo().items():
    deck.expect_close(f"thermo {name}", off.thermo()[name], values, rtol=1e-8, atol=1e-10)
deck.finish()
