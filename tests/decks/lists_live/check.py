# ranks: 1 4
"""Neighbor lists that live as long as the flow allows miss no pair, against lists that are made in every step: the same
pairs in range in each step, and the same trajectory to rounding. And they do live longer than LAMMPS' own."""
import re
from pathlib import Path

import numpy as np

import deck


def builds(text):
    return int(re.findall(r"^Neighbor list builds = (\d+)", text, re.MULTILINE)[0])


def pairs(name):
    """Number of pairs in range, of each step, from fix ave/histo."""
    return [line.split()[2] for line in Path(f"{name}.pairs").read_text().splitlines() if len(line.split()) == 6]


def run(case, lists, **variables):
    """One run with lists as they say; the words of the motion of plates end in the same."""
    if "motion" in variables:
        variables["motion"] += f" lists {lists}"
    return deck.run(case, lists=lists, **variables).text


def compare(what, case, fewer=None, **variables):
    """Lists that live, and new ones in every step; fewer: how much longer than those of LAMMPS."""
    if deck.RANKS > 1:
        variables = {"steps": 120, **variables}
    mine = builds(run(case, "affine", **variables))
    run(case, "lammps", **{**variables, "modify": "check no"})
    a, b = deck.read_dump("affine.dump"), deck.read_dump("lammps.dump")
    for column in ("x", "y", "z", "vx", "vy", "vz", "omegaz", "fx", "fy", "fz", "tqz"):
        scale = np.sqrt(np.mean(b[column] ** 2)) or 1.0
        deck.expect_close(f"{what}: {column}", a[column], b[column], atol=1e-7 * scale)
    deck.expect(f"{what}: pairs of all steps", pairs("affine") == pairs("lammps"), len(pairs("affine")))
    if not fewer or deck.RANKS > 1:    # all ranks make their lists in the same steps
        print(f"{what}: {mine} builds")
        return
    theirs = builds(run(case, "lammps", **variables))
    deck.expect(f"{what}: lists live {fewer} times as long", mine * fewer <= theirs, f"{theirs} and {mine} builds")


deck.make_state()
text = deck.run("in.cell", lists="slow", fails=True).text
deck.expect_error("a wrong word", text, "lists must be affine or lammps, but is slow")
compare("shear", "in.cell", fewer=3)
compare("held pressure", "in.cell", flow="rate 5 pressure 40 start 5")
compare("a longer cut-off of another style", "in.cell", other="style")
if deck.RANKS == 1:
    compare("drifting", "in.cell", drift=20)
    compare("oscillation", "in.cell", flow="oscillate 0 5 30 volume")
    compare("a compute with a list of its own", "in.cell", other="list")
    a, b = (np.loadtxt([line for line in Path(f"{name}.rdf").read_text().splitlines() if len(line.split()) > 3])
            for name in ("affine", "lammps"))
    deck.expect_close("  whose result is the same", a, b, atol=1e-9)
    compare("delayed lists", "in.cell", modify="every 4 delay 40 check yes")
    runs = [deck.run("in.cell", lists=lists, range="voronoi 1.5", steps=40) for lists in ("affine", "lammps")]
    deck.expect("range voronoi, which makes its faces with the list, leaves it to LAMMPS",
                builds(runs[0].text) == builds(runs[1].text) > 10, builds(runs[0].text))
deck.make_state(dim=2, phi=0.75)
compare("discs", "in.cell", dim=2, fewer=2)
deck.make_state(shape="orthogonal")
compare("extension", "in.cell", flow="flow planar rate 2 volume start 2", steps=150)
deck.run(deck.ROOT / "tests" / "decks" / "plates" / "state.lmp", ranks=1)
compare("plates", "in.plates", fewer=2, motion="rate 4 gap")
compare("plates under pressure", "in.plates", motion="rate 4 pressure 30")
compare("plates that start", "in.plates", motion="velocity 200 gap", steps=100)
deck.finish()
