# ranks: 1
"""The example examples/submarine_layer, shortened: a loose layer flows at once, carried by the fluid, a dense one sucks and creeps."""
import os
import re
from pathlib import Path

import numpy as np

import deck

Path("runs").mkdir(exist_ok=True)
for old in (*Path("runs").iterdir(), *Path().glob("*.csv"), *Path().glob("*.txt")):
    old.unlink()
HEIGHT = 2e-3
LOAD, SLOPE = (2500 - 1041) * 9.81 * 0.58 * HEIGHT, np.radians(25)
# a permeability that makes H^2/k that of the example
SHORT = {"N": 300, "height": HEIGHT, "factor": 0.17, "settle": 1.2, "rest": 0.2, "until": 3.0, "interval": 0.1,
         "packing": deck.ROOT / "examples" / "packing" / "plates.lmp"}


def tilt(name, settling):
    run = deck.run(os.path.relpath(deck.ROOT / "examples" / "submarine_layer" / "in.submarine_layer", deck.CASE), out=f"runs/{name}.out",
                   settling=settling, **SHORT)
    deck.expect(f"{name}: the time step is below the limit", "exceeds" not in run.text)
    names = ("time", "phi", "speed", "bottom", "top", "mean", "pressure", "shear")
    return dict(zip(names, np.loadtxt(f"runs/{name}.out")[:, 1:9].T))


loose, dense = tilt("loose", 0.6), tilt("dense", 0.02)
late = loose["time"] > 0.8
deck.expect("volume fractions of the starts", loose["phi"][0] < 0.565 and dense["phi"][0] > 0.585, f"{loose['phi'][0]:.4f} {dense['phi'][0]:.4f}")
for name, run in (("loose", loose), ("dense", dense)):
    deck.expect_close(f"{name}: the floor carries grains and fluid", run["pressure"][late].mean(), LOAD * np.cos(SLOPE), rtol=0.01)
    deck.expect(f"{name}: profiles", len(Path(f"runs/{name}.out.profile").read_text(encoding="ascii").splitlines()) > 100)
deck.expect_close("dense: and their weight along the slope", dense["shear"][late].mean(), LOAD * np.sin(SLOPE), rtol=0.1)
bottom = [run["bottom"][late].mean() / LOAD for run in (loose, dense)]
deck.expect("the fluid carries part of the loose layer and sucks at the dense one", bottom[1] < 0 < bottom[1] + 0.2 < bottom[0],
            "{0:.3f} and {1:.3f} of the weight".format(*bottom))
deck.expect("which dilates", dense["phi"][-1] < dense["phi"][0], f"{dense['phi'][0]:.4f} to {dense['phi'][-1]:.4f}")
speeds = [run["speed"][late].mean() * 1e3 for run in (loose, dense)]
deck.expect("and flows more slowly", speeds[0] > 2 * speeds[1], "{0:.3f} and {1:.3f} mm/s".format(*speeds))

text = deck.draw_example("submarine_layer", "figure.png")
deck.expect("numbers of two layers, beside the model", len(re.findall(r"^(?:loose|dense) .* s( +[-.0-9]+){6}$", text, re.MULTILINE)) == 4)
for name, run in (("loose", loose), ("dense", dense)):
    table = np.loadtxt(f"{name}.txt")
    deck.expect_close(f"{name}.txt", table, np.array([run[column] for column in ("time", "phi", "speed", "bottom")]).T, rtol=1e-3, atol=1e-3)
deck.finish()
