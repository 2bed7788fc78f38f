# ranks: 2
"""The example examples/consolidation, shortened: the fluid carries the added load and passes it on; its figure."""
import os
import re

import numpy as np

import deck

N, MORE = 150, 2.0
deck.run(os.path.relpath(deck.ROOT / "examples" / "consolidation" / "in.consolidation", deck.CASE), N=N, aspect_y=3, rest=50, until=60,
         outputs=60, more=MORE, packing=str(deck.ROOT / "examples" / "packing" / "plates.lmp"))
now, settled, bottom, mean, flux, speed, low, up = np.loadtxt("settled.txt")[:, 1:].T
late = now > 5
deck.expect_close("the fluid carries what was added, at first", bottom[np.searchsorted(now, 2):].max(), MORE, rtol=0.1)
deck.expect("it drains", bottom[-1] < 0.7 * MORE and np.all(np.diff(bottom[late]) < 0), f"{bottom[-1]:.3f}")
deck.expect("the layer settles", settled[-1] > 0.01 and np.all(np.diff(settled[late]) > 0), f"{settled[-1]:.4f}")
deck.expect_close("total stress below", low[late], 12, rtol=0.01)
deck.expect_close("and above, where the fluid is drained", up[late], 12, rtol=0.01)
deck.expect_close("what leaves is what the plate displaces", flux[late], -speed[late], rtol=0.1)
text = deck.draw_example("consolidation", "figure.png")
off = [float(word) for word in re.search(r"largest difference: settlement (\S+), pressure (\S+)", text).groups()]
deck.expect("not far from Terzaghi", max(off) < 0.15, str(off))
deck.finish()
