# ranks: 1 2
"""The packing generator: no overlaps, the volume fraction asked for, the sizes asked for, in 3d and 2d."""
import os
import subprocess
import sys

import numpy as np
from scipy.spatial import cKDTree

import deck

for case in ({"phi": 0.5, "separation": 0.01}, {"phi": 0.62, "N": 600}, {"phi": 0.55, "sizes": "flat", "N": 600},
             {"dim": 2, "phi": 0.8, "sizes": "flat", "N": 600}, {"phi": 0.4, "aspect_x": 2}):
    v = deck.run("in.packing", **case).values
    d = deck.read_dump("packing.dump")
    radius = d["radius"]
    box = np.array([v["lx"], v["ly"], v["lz"]])
    if case.get("dim") == 2:
        solid, cell, mass = np.pi * np.sum(radius**2), box[0] * box[1], np.pi * radius**2
    else:
        solid, cell, mass = 4 / 3 * np.pi * np.sum(radius**3), box.prod(), 4 / 3 * np.pi * radius**3
    deck.expect_close(f"{case} volume fraction", solid / cell, case["phi"], rtol=1e-9)
    deck.expect_close("mass at density 1", d["mass"], mass, rtol=1e-9)
    if case.get("sizes") == "flat":
        deck.expect_close("mean radius", radius.mean(), 1.0, atol=0.04)
        deck.expect_close("spread of a flat distribution", radius.std(), 1 / np.sqrt(12), rtol=0.1)
    else:
        deck.expect_close("spread of the radius", radius.std(), 0.05, rtol=0.15)
    # gaps by an independent periodic search
    x = np.array([d["x"], d["y"], d["z"]]).T
    if case.get("dim") == 2:
        x, box = x[:, :2], box[:2]
    pairs = cKDTree(np.mod(x, box), boxsize=box).query_pairs(2 * radius.max() + 0.1, output_type="ndarray")
    r = x[pairs[:, 0]] - x[pairs[:, 1]]
    r -= box * np.round(r / box)
    ri, rj = radius[pairs].T
    gap = (np.linalg.norm(r, axis=1) - ri - rj) / (2 * ri * rj / (ri + rj))
    deck.expect("smallest gap over the effective radius", gap.min() > case.get("separation", 0) - 1e-5, f"{gap.min():.2e}")
deck.run("in.packing", fails=True, phi=0.75, N=300)

# the example, smaller
example = deck.ROOT / "examples" / "packing"
deck.run(str(example / "in.packing"), packing=str(example / "packing.lmp"), name="spheres", N=200)
deck.run(str(example / "in.packing"), packing=str(example / "packing.lmp"), name="discs", N=200, dim=2, phi=0.8, sizes="flat")
subprocess.run([sys.executable, str(example / "plot.py")], check=True)
deck.expect("the figure is drawn", os.path.getsize("figure.png") > 1e4)
deck.finish()
