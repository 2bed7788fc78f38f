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

# a list for some of the particles only, and range voronoi
deck.make_state(types=2)
deck.run("in.hybrid", way="part", out="part.dump")
part = deck.read_dump("part.dump")
deck.expect("pairs of type 1 act", np.mean(np.abs(part["fx"][:150])) > 0.1)
deck.expect("others do not", np.all(part["fx"][150:] == 0) and np.all(part["tqz"][150:] == 0))
deck.finish()
