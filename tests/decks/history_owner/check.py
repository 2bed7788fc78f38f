# ranks: 1 4
"""A record of a pair follows its particles whatever becomes of IDs, rows and ranks between two runs, or between
read_restart and the first run."""
import numpy as np
from scipy.spatial import cKDTree

import deck


def by_place(name, other):
    """Forces and torques of two dumps, particle by particle as they lie."""
    a, b = deck.read_dump(name), deck.read_dump(other)
    places = [np.column_stack([d[c] for c in "xyz"]) for d in (a, b)]
    distance, partner = cKDTree(places[1]).query(places[0])
    keep = distance < 1e-6
    columns = ("fx", "fy", "fz", "tqx", "tqy", "tqz")
    return [np.column_stack([d[c] for c in columns])[rows] for d, rows in ((a, keep), (b, partner[keep]))]


for compress in ("yes", "no"):
    run = deck.run("in.three", compress=compress)
    deck.expect_close(f"no force at rest, compress {compress}", run.tables()[1]["Fmax"], 0.0, atol=1e-12)

deck.make_state()
references = {}
for how, same in (("nothing", None), ("ids", "nothing"), ("lists", "nothing"), ("moved", "nothing"),
                  ("gone", None), ("few", "gone"), ("gone_ids", "gone"), ("fewer", None), ("reused", "fewer"),
                  ("first_gone", None), ("first", "first_gone")):
    # LAMMPS does not move or create atoms between read_restart and the first run
    for way in ("straight", "restart") if how not in ("moved", "reused") else ("straight",):
        run = deck.run("in.changed", how=how, way=way, out=f"{how}.{way}")
        reference = f"{same or how}.straight"
        if f"{how}.{way}" == reference:
            deck.expect(f"{how}: contacts carry load", run.tables()[-1]["PotEng"][0] > 0)
            energy = run.tables()[-1]["KinEng"]
            references[how] = energy
            continue
        a, b = by_place(f"{reference}.dump", f"{how}.{way}.dump")
        deck.expect(f"{how}, {way}: all particles are there", len(a) >= 178, len(a))
        deck.expect_close(f"{how}, {way}: forces", b, a, atol=1e-8 * np.sqrt(np.mean(a ** 2)))
        deck.expect_close(f"{how}, {way}: and as it goes on", run.tables()[-1]["KinEng"], references[same or how],
                          rtol=1e-6)
for again in ("before", "after"):
    run = deck.run("in.changed", how="few", way="restart", again=again, out="again")
    a, b = by_place("gone.straight.dump", "again.dump")
    deck.expect_close(f"pair_style given again {again}", b, a, atol=1e-8 * np.sqrt(np.mean(a ** 2)))
deck.finish()
