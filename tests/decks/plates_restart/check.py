# ranks: 1 4
"""A restarted plane Couette cell continues the straight run bit for bit, whatever moves the plate."""
import numpy as np

import deck

deck.run("../plates/state.lmp", ranks=1)
for motion in ("rate 1 pressure 5", "stress 30 load 5 damper 2 drag 3", "oscillate 0.5 2 30 gap"):
    straight = deck.run("in.straight", motion=motion).thermo()
    restarted = deck.run("in.restarted", motion=motion).thermo()
    a, b = deck.read_dump("straight.dump"), deck.read_dump("restarted.dump")
    for column in a:
        deck.expect(f"{motion}: bit for bit: {column}", np.array_equal(a[column], b[column]),
                    f"largest difference {np.max(np.abs(a[column] - b[column])):.1e}")
    for name, values in restarted.items():
        if name != "Time":    # LAMMPS itself rounds it differently after a restart
            deck.expect(f"{motion}: {name}", np.array_equal(values, straight[name][-len(values):]))
    deck.expect(f"{motion}: contacts are active", straight["f_cell[8]"].max() > 0)
    deck.expect(f"{motion}: it moves", abs(straight["f_cell[4]"][-1]) > 0.1)
# another drive than in the file begins anew
deck.run("in.straight", motion="rate 1 gap")
t = deck.run("in.restarted", motion="oscillate 0 1 10 gap").thermo()
since = t["Time"] - t["Time"][0]
deck.expect_close("oscillation from the restart on", t["f_cell[1]"] - t["f_cell[1]"][0], 0.1 * np.sin(10 * since), atol=1e-12)
deck.finish()
