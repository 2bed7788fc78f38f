# ranks: 4
"""A restart file written on some ranks and read on others: the same run to the rounding of sums in another order."""
import numpy as np

import deck

GRIDS = {1: "1 1 1", 2: "1 2 1", 4: "2 2 1"}

deck.make_state()
for wrote, reads in ((4, 1), (2, 4)):
    deck.run("in.write", ranks=wrote, grid=GRIDS[wrote])
    text = deck.run("in.read", ranks=reads, grid=GRIDS[reads]).text
    a, b = deck.read_dump("straight.dump"), deck.read_dump("restarted.dump")
    deck.expect(f"written on {wrote}, read on {reads}: all particles are there", np.array_equal(a["id"], b["id"]))
    for name in ("x", "vx", "omegaz", "fy", "tqz"):
        scale = np.sqrt(np.mean(a[name]**2))
        deck.expect_close(f"  {name}", b[name], a[name], atol=1e-8 * scale)
deck.finish()
