"""Mixed coefficients: springs in series, mean roughness, geometric friction; the same after a restart."""
import re
from pathlib import Path

import numpy as np

import deck

deck.run("in.mixing")


def coefficients(name):
    section = Path(name).read_text().split("PairIJ Coeffs")[1].split("Atoms")[0]
    rows = re.findall(r"^(\d) (\d) (\S+) (\S+) asperity (\S+) roughness (\S+)(?: friction coulomb (\S+))?$", section, re.MULTILINE)
    return {(r[0], r[1]): [float(x) if x else -1.0 for x in r[2:]] for r in rows}


found = coefficients("mixed.data")
expected = {    # g, kt, asperity, roughness, friction (-1: none)
    ("1", "1"): [1000, 300, 1000, 0.01, 0.4],
    ("1", "2"): [1500, 375, 1200, 0.02, 0.6],    # 2ab/(a+b), sqrt(0.4*0.9)
    ("1", "3"): [111, 22, 111, 0.05, -1],        # given
    ("2", "2"): [3000, 500, 1500, 0.03, 0.9],
    ("2", "3"): [2400, 4000 / 9, 12000 / 7, 0.015, -1],    # no friction, because 3 has none
    ("3", "3"): [2000, 400, 2000, 0, -1],
}
for pair, values in expected.items():
    deck.expect_close(f"pair {pair}", found[pair], values, rtol=1e-12)
again = coefficients("again.data")
deck.expect("the same after a restart", all(np.array_equal(found[p], again[p]) for p in expected))
deck.finish()
