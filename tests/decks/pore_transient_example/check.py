# ranks: 2
"""The example examples/pore_transient, shortened: a dense layer sucks and resists more, a loose one is carried by the fluid."""
import os
import re
from pathlib import Path

import numpy as np

import deck

Path("runs").mkdir(exist_ok=True)
for old in (*Path("runs").iterdir(), *Path().glob("*.csv")):
    old.unlink()
SHORT = {"N": 150, "aspect_y": 2, "prepare": 0.3, "packing": str(deck.ROOT / "examples" / "packing" / "plates.lmp")}
LOOSE = {"start": "loose", "phi": 0.42, "prepare": 1.5, "iv": 0.01, "iv_start": 0.2, "strain": 0.28}


def shear(name, **variables):
    deck.run(os.path.relpath(deck.ROOT / "examples" / "pore_transient" / "in.pore_transient", deck.CASE), out=f"runs/{name}.txt",
             **{**SHORT, "strain": 0.4, **variables})
    names = ("strain", "gap", "phi", "pore", "mean", "solid", "total_low", "total_up", "shear_low", "shear_up", "flux", "speed")
    return dict(zip(names, np.loadtxt(f"runs/{name}.txt")[:, 1:13].T))


free = shear("fast_off", factor=100, coupling="off")
dense = shear("fast_100", factor=100)
late = dense["strain"] > 0.05
deck.expect("a dense layer dilates", dense["phi"][-1] < dense["phi"][0] - 0.01, f"{dense['phi'][0]:.4f} to {dense['phi'][-1]:.4f}")
deck.expect("and sucks", dense["pore"][late].min() < -1, f"{dense['pore'].min():.3f}")
early = late & (dense["strain"] < 0.2)
deck.expect("which delays it", np.all(dense["phi"][early] > free["phi"][early]), f"{(dense['phi'] - free['phi'])[early].min():.4f}")
deck.expect("its grains carry the load and the suction", dense["solid"][late].max() > 2, f"{dense['solid'].max():.3f}")
deck.expect("so that it resists more", dense["shear_low"][late].mean() > 1.2 * free["shear_low"][late].mean(),
            f"{dense['shear_low'][late].mean():.3f}, without {free['shear_low'][late].mean():.3f}")
deck.expect_close("total stress below, mean", dense["total_low"][late].mean(), 1, rtol=0.1)
deck.expect_close("and above, where the fluid is drained", dense["total_up"][late].mean(), 1, rtol=0.1)
deck.expect_close("what comes in is what the plate leaves", dense["flux"][late], -dense["speed"][late], atol=0.02 * np.abs(dense["speed"]).max())

loose = shear("loose_100", factor=100, **LOOSE)
early = (loose["strain"] > 0.05) & (loose["strain"] < 0.15)
deck.expect("a loose layer is compacted", loose["phi"][-1] > loose["phi"][0] + 0.005, f"{loose['phi'][0]:.4f} to {loose['phi'][-1]:.4f}")
deck.expect("the fluid carries part of the load", loose["pore"][early].mean() > 0.2, f"{loose['pore'][early].mean():.3f}")
deck.expect("the grains the rest", abs((loose["pore"] + loose["solid"])[early].mean() - 1) < 0.1)
deck.expect("its resistance recovers as it drains", loose["shear_low"][-5:].mean() > 1.2 * loose["shear_low"][early].mean(),
            f"{loose['shear_low'][early].mean():.3f} to {loose['shear_low'][-5:].mean():.3f}")

text = deck.draw_example("pore_transient", "figure.png")
found = re.findall(r"^run +(\S+)", text, re.MULTILINE)
deck.expect("numbers of three cases", len(found) == 3 and float(found[1]) < -1 < 0 < float(found[2]), str(found))
deck.finish()
