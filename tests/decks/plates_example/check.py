# ranks: 2
"""The example examples/plates, shortened: the pressure asked for, nothing lost, known ranges, its figure; and its start."""
import os
import subprocess
import sys

import numpy as np
from scipy.spatial import cKDTree

import deck

# the start between plates: no overlap, the volume fraction asked for, plates closed, surfaces where they are said to be
for case in ({"N": 300, "phi": 0.55}, {"N": 200, "phi": 0.3, "separation": 0.02}, {"dim": 2, "N": 150, "phi": 0.75}):
    v = deck.run("in.start", ranks=1, **case).values
    d = deck.read_dump("start.dump")
    flat = case.get("dim") == 2
    low, up, free = d["v_low"] == 1, d["v_up"] == 1, d["type"] == 1
    solid = np.pi * d["radius"] ** 2 * (1 if flat else 4 / 3 * d["radius"])
    area = v["lx"] * (1 if flat else v["lz"])
    deck.expect("groups are the types", np.array_equal(low | up, d["type"] == 2) and low.any() and up.any())
    deck.expect_close(f"{case} particles", free.sum(), case["N"])
    deck.expect_close("volume fraction", solid[free].sum() / (area * v["gap"]), case["phi"], rtol=1e-9)
    deck.expect_close("density", d["mass"], solid, rtol=1e-9)
    deck.expect_close("surface of the lower plate", np.mean((d["y"] + d["radius"])[low]), 0, atol=1e-9)
    deck.expect_close("surface of the upper plate", np.mean((d["y"] - d["radius"])[up]), v["gap"], rtol=1e-9)
    deck.expect_close("bumps", (d["y"] + d["radius"])[low].std(), 1 / np.sqrt(3), rtol=0.3)
    deck.expect("all between the plates", d["y"][free].min() > -0.1 and d["y"][free].max() < v["gap"] + 0.1)
    # gaps of all pairs but those within a plate, by an independent search periodic in x and z
    box = np.array([v["lx"], 1e3, v["lx"] if flat else v["lz"]])
    x = np.mod(np.array([d["x"], d["y"] + 100, 0 * d["z"] if flat else d["z"]]).T, box)
    pairs = cKDTree(x, boxsize=box).query_pairs(2 * d["radius"].max() + 0.1, output_type="ndarray")
    pairs = pairs[free[pairs[:, 0]] | free[pairs[:, 1]]]
    r = x[pairs[:, 0]] - x[pairs[:, 1]]
    r -= box * np.round(r / box)
    ri, rj = d["radius"][pairs].T
    gap = (np.linalg.norm(r, axis=1) - ri - rj) / (2 * ri * rj / (ri + rj))
    deck.expect("smallest gap over the effective radius", gap.min() > case.get("separation", 0) - 1e-5, f"{gap.min():.2e}")
deck.run("in.start", ranks=1, fails=True, N=200, phi=0.75)

example = deck.ROOT / "examples" / "plates"
done = deck.run(os.path.relpath(example / "in.plates", deck.CASE), N=250, strain=6, aspect_y=1.5,
                packing=str(deck.ROOT / "examples/packing/plates.lmp"))
deck.expect("no warning of a target", "does not reach" not in done.text)
data = np.loadtxt("flow.txt")[:, 1:]
late = data[data[:, 0] > 3.0]
deck.expect_close("mean pressure on the upper plate", late[:, 4].mean(), 10.0, rtol=0.02)
deck.expect_close("and on the lower plate", late[:, 3].mean(), 10.0, rtol=0.02)
deck.expect_close("shear stress is the same on both plates", late[:, 5].mean(), late[:, 6].mean(), rtol=0.02)
# the laws of Boyer 2011 and Chevremont 2019 at Iv = 0.1: phi 0.44, friction 1.08 and 1.25; few particles, wall layers
deck.expect("volume fraction between 0.38 and 0.48", 0.38 < late[:, 2].mean() < 0.48, f"{late[:, 2].mean():.3f}")
deck.expect("friction between 0.9 and 1.5", 0.9 < late[:, 6].mean() < 1.5, f"{late[:, 6].mean():.3f}")
plot = subprocess.run([sys.executable, str(example / "plot.py"), "--from", "3"], capture_output=True, text=True, check=False)
print(plot.stdout + plot.stderr)
deck.expect("figures are drawn", plot.returncode == 0 and os.path.getsize("figure.png") > 1e4)
deck.finish()
