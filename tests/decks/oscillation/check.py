# ranks: 2
"""The example examples/oscillation, shortened: the strain is exact, the films answer in phase with the rate."""
import re
from pathlib import Path

import numpy as np

import deck

deck.run_example("oscillation", N=100, amplitude=0.1, path=0.1, cycles=4, presheared=1)
data = deck.read_stress()
dt = float(Path("scene.txt").read_text().split()[-1])
# each line is the mean over the last ten samples of a line, (1 ... 10)/10 of it, of 80 lines a cycle
step = data["TimeStep"][:, None] - (data["TimeStep"][1] - data["TimeStep"][0]) / 10 * np.arange(10)
strain = 0.1 * np.sin(step * dt).mean(axis=1)
offset = (data["v_gamma"] - strain).mean()
deck.expect_close("strain", data["v_gamma"] - offset, strain, atol=2e-8)
text = deck.draw_example("oscillation", "figure.png")
real, imag = map(float, re.search(r"lubrication\s+real\s+(\S+) \+- \S+\s+imag\s+(\S+)", text).groups())
deck.expect("lubrication is viscous", real > 3 and abs(imag) < 0.3 * real, f"{real} {imag}")
deck.finish()
