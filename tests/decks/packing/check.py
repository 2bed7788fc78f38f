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

# the same packing in any units, whatever the size of particles
def packed(**variables):
    v = deck.run("in.units", **variables).values
    d = deck.read_dump("packing.dump")
    size = v["radius_mean"]
    return np.array([d["x"], d["y"], d["z"], d["radius"]]) / size, v


for generator in "packing", "plates":
    for dim, phi in (3, 0.45), (2, 0.6):
        case = {"generator": generator, "dim": dim, "phi": phi, "N": 200, "aspect_y": 1 if generator == "packing" else 2}
        expected, _ = packed(**case)
        for units, radius in ("si", 2e-5), ("si", 1.0), ("micro", 40), ("nano", 500), ("cgs", 1e-3), ("real", 100), ("lj", 1e3):
            if (generator == "plates" or deck.RANKS > 1) and units not in ("si", "micro"):
                continue
            got, v = packed(**case, units=units, radius=radius)
            what = f"{generator} in {dim}d, units {units}, mean radius {radius}"
            deck.expect_close(f"{what}: that of lj", got, expected, atol=1e-6)
            deck.expect_close("  the time step of before", v["dt"], 0.1234, rtol=1e-12)

# a scene: sizes of the user's variable, the default with its radius and spread; found from any folder
def scene(**variables):
    deck.run("in.scene", **{"N": 200, "scene": deck.ROOT / "examples/scene", **variables})
    return deck.read_dump("scene.dump")


ratio = scene(sizes="1+0.4*(id%2)")["radius"]
deck.expect_close("variable particle_radius in suspension.lmp", np.unique(ratio), [1.0, 1.4], rtol=1e-12)
default = scene(radius=3e-3, spread=0.2, rate=2.0, units="si")
radius = default["radius"]
deck.expect_close("mean radius and spread", [radius.mean(), radius.std()], [3e-3, 6e-4], rtol=0.15)
deck.expect_close("density for St = 0.05", default["mass"] / (4 / 3 * np.pi * radius**3), 0.05 * 1.0 / (2.0 * radius.mean()**2), rtol=1e-9)
deck.expect_close("a density that is given", scene(density=7.5)["mass"] / (4 / 3 * np.pi * scene(density=7.5)["radius"]**3), 7.5, rtol=1e-9)
for variables, message in (({"scene": deck.ROOT / "examples/scene"}, None), ({}, "say where this folder is: variable scene index FOLDER"),
                           ({"packing": deck.ROOT / "examples/packing/packing.lmp"}, None)):
    text = deck.run("in.scene", N=50, place=deck.ROOT / "examples/scene", fails=message is not None, **variables).text
    deck.expect(f"suspension.lmp from another folder with {list(variables)}", message is None or message in text)
os.environ["SUSPENSION_EXAMPLES"] = str(deck.ROOT / "examples")
deck.run("in.scene", N=50, place=deck.ROOT / "examples/scene")
del os.environ["SUSPENSION_EXAMPLES"]

# the example, smaller
example = deck.ROOT / "examples" / "packing"
deck.run(str(example / "in.packing"), packing=str(example / "packing.lmp"), name="spheres", N=200)
deck.run(str(example / "in.packing"), packing=str(example / "packing.lmp"), name="discs", N=200, dim=2, phi=0.8, sizes="flat")
subprocess.run([sys.executable, str(example / "plot.py")], check=True)
deck.expect("the figure is drawn", os.path.getsize("figure.png") > 1e4)
deck.finish()
