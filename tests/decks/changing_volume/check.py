# ranks: 1 2
"""Volume fractions and hindrance are those of the moment, whatever comes, goes or grows in a run."""
import numpy as np

import deck

for style in ("drag/background", "overdamped/sphere"):
    for how in ("deposit", "evaporate", "grow"):
        t = deck.run("in.drag", how=how, fix=style).thermo()
        solid = t["c_solid"]
        deck.expect(f"{style}, {how}: the volume changes", np.ptp(solid) > 0.1 * np.max(solid))
        # without inertia particles move before others come or go in the same step
        rows = t["Step"] % 20 == 10 if style == "overdamped/sphere" else slice(None)
        deck.expect_close(f"{style}, {how}: hindrance", t["f_fluid[9]"][rows], (1 / (1 - solid / t["Volume"]))[rows], rtol=2e-12)
t = deck.run("in.drag", how="lose").thermo()
deck.expect("lost particles", t["Atoms"][-1] < t["Atoms"][0])
deck.expect_close("lost: hindrance", t["f_fluid[9]"], 1 / (1 - t["c_solid"] / t["Volume"]), rtol=2e-12)

deck.make_state()
for how in ("evaporate", "deposit"):
    t = deck.run("in.rheometer", how=how).thermo()
    deck.expect(f"rheometer, {how}: particles change", np.ptp(t["Atoms"]) >= 8)
    deck.expect_close(f"rheometer, {how}: volume fraction", t["f_flow[3]"], t["c_solid"] / t["Volume"], rtol=2e-12)

t = deck.run("in.plates").thermo()
deck.expect("plates: particles go", np.ptp(t["v_n"]) >= 8)
deck.expect_close("plates: volume fraction", t["f_cell[6]"], t["v_n"] * np.pi / 6 * 1.5**3 / (144 * t["f_cell[3]"]), rtol=1e-7)
deck.finish()
