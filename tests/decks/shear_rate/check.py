# ranks: 2
"""The example examples/shear_rate, shortened: it runs, its parts add up, its viscosity is in the known range."""
import os
import subprocess
import sys

import numpy as np

import deck

example = deck.ROOT / "examples" / "shear_rate"
deck.run(os.path.relpath(example / "in.shear_rate", deck.CASE), N=400, strain=3,
         packing=str(deck.ROOT / "examples/packing/packing.lmp"))
data = np.loadtxt("stress.txt")[:, 1:]
deck.expect_close("parts and fluid add up", data[:, 1], 1 + data[:, 2:7].sum(axis=1), rtol=1e-4)
steady = data[data[:, 0] > 1.0]
eta_r = steady[:, 1].mean()
# codes give 28 to 55 at phi = 0.5, mu = 0.5 with 10-15 % scatter each; 400 particles over two strain units
deck.expect("relative viscosity between 25 and 45", 25 < eta_r < 45, f"{eta_r:.1f}")
deck.expect("contacts carry most of it", steady[:, 2:4].sum(axis=1).mean() > 0.5 * eta_r)
deck.expect("particles push: normal stress is compressive", steady[:, 7:10].mean(axis=0).max() < 0)
deck.expect("inertia is negligible", abs(steady[:, 6].mean()) < 0.01 * eta_r)
done = subprocess.run([sys.executable, str(example / "plot.py")], capture_output=True, text=True, check=True)
print(done.stdout)
deck.expect("figures are drawn", os.path.getsize("figure.png") > 1e4 and os.path.getsize("particles.png") > 1e4)
deck.finish()
