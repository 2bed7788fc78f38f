# ranks: 1 4
"""The rheometer in the company of other commands: other pair styles, grids of ranks, pauses, rerun, variables of itself."""
import numpy as np

import deck


def same(what, one, other, names=None):
    for name in names or one:
        scale = np.max(np.abs(one[name]))
        deck.expect_close(f"{what}: {name}", other[name][-1], one[name][-1], atol=1e-8 * scale)


OUTPUT = ["PotEng", "KinEng", "Pxy", "Ly", "Xy"]
for dim, phi in ((2, 0.75), (3, 0.5)):
    deck.make_state(dim=dim, phi=phi)
    plain = deck.run("in.company", ranks=1, dim=dim).thermo()
    deck.expect(f"{dim}d: the pressure acts", np.ptp(plain["Ly"]) > 0.01)
    same(f"{dim}d, hybrid and newton off", plain, deck.run("in.company", dim=dim, pair="hybrid", newton="off").thermo())
    for grid in ("1 * 1", "* 1 1"):
        same(f"{dim}d, processors {grid}", plain, deck.run("in.company", dim=dim, before=f"processors {grid}").thermo())
same("clear", plain, deck.run("in.company", between="clear").thermo())
same("two runs", plain, deck.run("in.company", between="pause").thermo(), OUTPUT)
constant = deck.run("in.company", hold="volume").thermo()
same("run every", constant, deck.run("in.company", between="every", hold="volume").thermo(), OUTPUT)
same("unfix and fix again", constant, deck.run("in.company", between="refix", hold="volume").thermo(), OUTPUT)

frames = [deck.run("in.rerun", fix=fix).thermo() for fix in ("rheometer", "deform")]
same("rerun", frames[1], frames[0])
for column, value in ((1, 0), (2, 1), (8, 0)):
    deck.expect_close(f"rerun: the flow stays as it is, {column}", frames[0][f"f_flow[{column}]"], value)

LONG, OVERWRITES = "exceeds half the time lag of the servos", "overwrites the velocities of the flow"
run = deck.run("in.minimize")
first, relaxed, second = run.tables()
deck.expect("no warning", LONG not in run.text and OVERWRITES not in run.text)
text = deck.run("in.minimize", style="fire", every=25).text    # strain 0.0125 between two adjustments
deck.expect("a minimizer that overwrites velocities warns", text.count(OVERWRITES) == 1)
deck.expect("long adjustments warn once", text.count(LONG) == 1)
deck.expect("minimize: the energy falls", relaxed["PotEng"][-1] < 0.9 * relaxed["PotEng"][0])
for name in ("Lx", "Ly", "Xy", "f_rheometer[1]", "f_rheometer[2]", "f_rheometer[8]"):
    deck.expect_close(f"minimize: {name} as before", second[name][0], first[name][-1], rtol=1e-12)
deck.expect_close("minimize: and the flow goes on", second["f_rheometer[1]"][-1], 0.1, rtol=1e-12)

growing, iv, constant = deck.run("in.strain").tables()
dt = 5e-4
deck.expect_close("rate by strain", growing["f_rheometer[1]"][-1], (1 + dt) ** 100 - 1, rtol=1e-12)
deck.expect_close("rate by strain, target", growing["f_rheometer[7]"][-1], (1 + dt) ** 100, rtol=1e-12)
deck.expect_close("rate by a viscosity that grows", iv["f_rheometer[2]"], 0.1 * 20 / np.array([3, 4]), rtol=1e-12)
deck.expect_close("target pressure", iv["f_rheometer[6]"], 20)
deck.expect("pressure acts", np.ptp(iv["Ly"]) > 1e-3)
deck.expect_close("volume after pressure", constant["Ly"], iv["Ly"][-1], rtol=1e-15)
deck.finish()
