# ranks: 1 2
"""What is no number, a lost particle, a step far over the limit: the run stops at once, with an error that names the cause,
and the last restart file written before goes on.
"""
from pathlib import Path

import numpy as np

import deck

NAN, LIMIT = "is not a number: reduce the time step", "the stability limit of the contact springs"
CASES = [    # command in the middle of the run, time step, errors of which one is due, latest step, warned before
    ("set atom 8 vx v_bad", 5e-4, [NAN], 81, False),
    ("set atom 8 x v_bad", 5e-4, [NAN, "Non-numeric atom coords"], 80, False),
    ("set atom 8 omega 0 0 v_bad", 5e-4, [NAN], 82, False),
    ("fix bad all addforce v_bad 0 0", 5e-4, [NAN], 81, False),
    ("fix bad all addforce 1e300 0 0", 5e-4, ["Lost atoms", NAN], 90, False),
    ("set atom 8 x 1e300", 5e-4, ["Lost atoms"], 90, False),
    ("print nothing", 5e-3, ["reduce the time step, stiffen the contact"], 100, True),
    ("print nothing", 0.1, ["reduce the time step, stiffen the contact"], 100, True),
    ("print nothing", 10, ["the cell would move by more than half its length"], 81, True),
    ("print nothing", 1e10, ["the cell would move by more than half its length"], 81, True),
]
deck.make_state()
for what, dt, messages, latest, warned in CASES[deck.RANKS - 1::2]:
    name = f"{what}, time step {dt}"
    for path in (Path("restart_a"), Path("restart_b")):
        path.unlink(missing_ok=True)
    text = deck.run("in.nan", fails=True, what=what, dt=dt).text
    shown = next((line for line in text.splitlines() if line.startswith("ERROR")), "no error")
    deck.expect(name, any(message in shown for message in messages), shown)
    deck.expect("  warned of the step", (LIMIT in text) == warned)
    steps = [int(line.split()[0]) for line in text.splitlines() if line.strip().split(" ")[0].isdigit() and len(line.split()) == 5]
    deck.expect("  at once", max(steps) <= latest, max(steps))
    v = deck.run("in.again", file="restart_b").values
    deck.expect("  the last restart file goes on", v["step"] == 80 and np.isfinite(v["energy"]), v["energy"])

# a particle that LAMMPS would not look at: no list is rebuilt
text = deck.run("in.nan", fails=True, what="set atom 8 vx v_bad", drive="no", extra="neigh_modify every 100000 delay 100000 check no").text
deck.expect("without a rebuild of the neighbor list", NAN in text)
deck.finish()
