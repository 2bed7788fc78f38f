# ranks: 1
"""What the pieces of examples/scene write: a continued run appends, a new one begins anew, and the reader takes it up."""
import shutil
import sys
from pathlib import Path

import numpy as np

import deck

sys.path.insert(0, str(deck.ROOT / "tools"))
import steady    # noqa: E402  pylint: disable=wrong-import-position

FILES = ("stress.txt", "contacts.txt")


def read():
    return {name: steady.read_ave_time(name) for name in FILES}


def same(what, found, expected):
    for name in FILES:
        for column, values in expected[name].items():
            good = len(values) == len(found[name][column])
            deck.expect(f"{what}: {name}, {column}", good and np.array_equal(values, found[name][column]),
                        f"{len(found[name][column])} lines, {len(values)} expected")


deck.make_state()
for name in FILES:
    Path(name).write_text("of an older run\n")
deck.run("in.first")
straight = read()
deck.expect("a run from step 0 begins anew", "older" not in "".join(Path(name).read_text() for name in FILES))
deck.expect("ten lines of forty steps", list(straight["stress.txt"]["TimeStep"]) == [40.0 * n for n in range(1, 11)])
title = Path("stress.txt").read_text().splitlines()[0]
deck.expect("unit and viscosity are in the title", title == "# stresses over 2, viscosity of the fluid 1", title)

deck.run("in.first", steps=200)
for name in FILES:
    shutil.copy(name, "first." + name)
deck.run("in.continued")
for name in FILES:
    deck.expect(f"{name}: the old lines are still there", Path(name).read_text().startswith(Path("first." + name).read_text()))
same("continued", read(), straight)
deck.run("in.continued")    # the second half once more, as after a run that was killed
same("continued twice", read(), straight)
deck.run("in.first", again="yes")
same("asked for twice in one run", read(), straight)

deck.run("in.continued", sample=3)
try:
    steady.read_ave_time("stress.txt")
    problem = "none"
except ValueError as error:
    problem = str(error)
deck.expect("other distances between lines are refused", "not one run and its continuation" in problem, problem)
deck.run("in.continued", output="file")
deck.expect("output file begins anew", read()["stress.txt"]["TimeStep"][0] == 240)
deck.finish()
