# ranks: 1 2
"""A gas of pairs at volume fraction 1e-3 in a shear flow: six encounters, at corners and flips of the cell, each against
SciPy's solution of the pair alone (decks/oracle/sheared_pair.py). Nobody is in range before and after: the stress is zero.
"""
from pathlib import Path

import numpy as np

from deck import RANKS, expect, expect_close, finish, run
from oracle.sheared_pair import XI, XJ, Pair

EDGE, STEP = 36.0, 5e-4
# first particle; the second is at (-5, y0, z0) from it
PAIRS = [((1, 1, 1), (1.0, 0.2)), ((18, 9, 18), (0.8, 0.0)), ((35.5, 17, 35.5), (1.2, -0.5)), ((9, 25, 0.1), (1.5, 0.9)),
         ((0.2, 35.7, 9), (0.9, 0.4)), ((27, 18, 10), (1.8, 0.0))]
MODEL = dict(rate=1.0, eta=1.0, density=0.02, g=1e4, kt=5e3, reach=0.5, k=1e4, eps=0.03, mu=0.5)

def write_atoms():
    """The particles, inside the cell, and variables of their relative positions; the names of these."""
    lines, names = [], []
    for n, (first, (y0, z0)) in enumerate(PAIRS):
        for x in np.array(first, float), np.array(first) + [-5.0, y0, z0]:
            lines.append("create_atoms 1 single {} {} {}".format(*(x % EDGE)))
        for c in "xyz":
            lines.append(f"variable {c}{n} equal {c}[{2 * n + 2}]-{c}[{2 * n + 1}]")
            names.append(f"v_{c}{n}")
    Path("atoms.lmp").write_text("\n".join(lines) + "\n")
    return names


def relative(t, n):
    """In the nearest image; the tilt changes by whole edges."""
    d = np.array([t[f"v_{c}{n}"] for c in "xyz"])
    d[2] -= EDGE * np.round(d[2] / EDGE)
    turns = np.round(d[1] / EDGE)
    d[1] -= turns * EDGE
    d[0] -= turns * t["Xy"]
    d[0] -= EDGE * np.round(d[0] / EDGE)
    return d


t = run("in.gas", columns=" ".join(write_atoms()), newton="on" if RANKS == 1 else "off").thermo()
expect_close("volume fraction", t["f_shear[3]"], 12 * 4 / 3 * np.pi / EDGE**3, rtol=1e-12)
expect("the cell flips", np.sum(np.abs(np.diff(t["Xy"])) > 18) >= 10)
touched = 0
in_range = np.zeros(len(t["Time"]), bool)
for n, (_, (y0, z0)) in enumerate(PAIRS):
    states, least = Pair(**MODEL).solve((0, 0, 0), (-5, y0, z0), t["Time"])
    expected, got = states[XJ] - states[XI], relative(t, n)
    in_range |= np.linalg.norm(got, axis=0) < 2.5
    # they come into range within a step: it shifts heights by up to a step, and the path along x with it
    what = f"pair {n}, least gap {least:.4f}"
    expect_close(f"{what}: height and depth", got[1:], expected[1:], atol=STEP)
    expect_close(f"{what}: path", got[0], expected[0], atol=12 * STEP)
    touched += least < MODEL["eps"]
stress = np.abs(t["c_stress[1][4]"]) + np.abs(t["c_stress[3][4]"]) + np.abs(t["c_stress[4][4]"])
expect("some touch, some do not", 2 <= touched <= 4, touched)
expect("pairs act", np.all(stress[in_range] > 0) and np.sum(in_range) > 100)
expect_close("no stress and no energy while nobody is in range", (stress + t["PotEng"])[~in_range], 0.0)
expect("before and after", not in_range[0] and not in_range[-1])
finish()
