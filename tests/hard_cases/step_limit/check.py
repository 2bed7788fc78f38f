# ranks: 1
"""The stability limit that the log prints holds: at 0.9 of it the energy of spheres on their springs stays within what
velocity Verlet allows, 1/(1 - 0.9^2) of it, for sizes up to 1:20, light and heavy partners, films at a gap, and both effective
radii; and it is not a limit for nothing: 1.5 times the step blows up.
"""
import re

import numpy as np

import deck

CASES = [{"size": size, "rule": rule} for size in (1, 2, 20) for rule in ("harmonic", "mean") if size > 1 or rule == "mean"]
CASES += [{"size": 1, "gap": 0.45, "kt": 1000}, {"size": 5, "weight": 0.05}, {"size": 3, "kt": 10}]


def growth(step, **case):
    energy = deck.run("in.limit", step=step, steps=2000, **case).thermo()["v_energy"]
    return np.max(np.nan_to_num(energy, nan=np.inf)) / energy[0]


for case in CASES:
    what = " ".join(f"{name} {value}" for name, value in case.items())
    limit = float(re.search(r"of the stability limit (\S+)\n", deck.run("in.limit", **case).text).group(1))
    most = growth(0.9 * limit, **case)
    deck.expect(f"{what}: limit {limit:.4g}, energy at 0.9 of it is bounded", most < 1.02 / (1 - 0.81), f"{most:.3g}")
most = growth(1.5 * limit, **case)
deck.expect(f"{what}: at 1.5 times the limit it is not", most > 100, f"{most:.3g}")
deck.finish()
