# ranks: 1 2 4
"""A restarted run continues the straight run bit for bit; with fix deform as far as its order of operations allows.

In a triclinic cell LAMMPS converts positions to box coordinates and back at the set-up, which rounds them once more
than the straight run does: there the runs agree to rounding growth. The bitwise half is in an orthogonal cell.
"""
import numpy as np

import deck

LAWS = "friction brizmer 0.5 5 adhesion 0.002 repulsion 20 0.02 restitution 0.5"

deck.make_state(shape="orthogonal")
straight = deck.run("in.straight", coeffs=LAWS)
restarted = deck.run("in.restarted")
a, b = deck.read_dump("straight.dump"), deck.read_dump("restarted.dump")
for column in a:
    deck.expect(f"bit for bit: {column}", np.array_equal(a[column], b[column]),
                f"largest difference {np.max(np.abs(a[column] - b[column])):.1e}")
first = straight.thermo()
deck.expect("contacts are active", first["PotEng"][-1] > 0)
for name, values in restarted.thermo().items():
    deck.expect(f"thermo {name}", np.array_equal(values[1:], first[name][-len(values) + 1:]))

deck.make_state()
deck.run("in.straight")
deck.run("in.restarted")
a, b = deck.read_dump("straight.dump"), deck.read_dump("restarted.dump")
for column in ("vx", "omegaz", "fy", "tqz"):
    deck.expect_close(f"triclinic {column}", b[column], a[column], atol=1e-8 * np.sqrt(np.mean(a[column] ** 2)))

# the command write_restart between two runs: neither the history in memory nor that in the file may suffer
plain = deck.run("in.between", write="no").tables()
tables = deck.run("in.between", write="yes").tables()
for name in ("PotEng", "KinEng", "Pxy"):
    deck.expect_close(f"write_restart between runs, {name}", tables[1][name], plain[1][name], rtol=1e-9)
    deck.expect_close(f"and from that file, {name}", tables[2][name], plain[1][name], rtol=1e-9)
for case in ({}, {"modes": "squeeze no", "contact": "adhesion 0.002"}):    # fewer values; others
    text = deck.run("in.other_effects", fails=True, **case).text
    deck.expect(f"{case} other effects than in the file are refused", "keep the effects it was written with" in text)

# fix deform moves the cell at the end of a step, after the forces: the set-up of the restarted run sees ghosts that
# the straight run sees one step later. What remains is of the order of what happens in one step of 5e-4.
deck.run("in.straight", flow="deform")
deck.run("in.restarted", flow="deform")
a, b = deck.read_dump("straight.dump"), deck.read_dump("restarted.dump")
shift = np.max(np.abs(a["y"] - b["y"]))
print(f"with fix deform: largest difference in y {shift:.1e}, in fx {np.max(np.abs(a['fx'] - b['fx'])):.1e}")
deck.expect("with fix deform the runs stay within a fraction of a step", shift < 5e-4)
deck.finish()
