"""The example examples/bidisperse_si, shortened: what other units give, going on from the restart file, the dump, the figure."""
import os
import shutil

import numpy as np

import deck

SHORT = {"N": 200, "strain": 0.05, "frames": 5, "sampling": 0.005}
EXAMPLE = deck.ROOT / "examples" / "bidisperse_si"
COLUMNS = ("v_phi_now", "v_sxy", "v_syy")


def thermo(name="in.bidisperse_si", **variables):
    result = deck.run(os.path.relpath(EXAMPLE / name, deck.CASE), scene=deck.ROOT / "examples" / "scene", **{**SHORT, **variables})
    deck.expect(f"{name} {variables}: no warning", "WARNING" not in result.text)
    return result.thermo()


# the same numbers without dimension in units lj, lengths in fine radii and stresses in the pressure
first = thermo()
lj = thermo(units="lj", fine=1.0, viscosity=1.0, pressure=1.0)
for column in COLUMNS:
    deck.expect_close(f"units si and lj: {column}", first[column], lj[column], rtol=1e-6, atol=1e-6)
deck.expect_close("units si and lj: rate of dilation", first["f_shear[8]"] / 10.0, lj["f_shear[8]"] / 0.1, rtol=1e-6, atol=1e-6)
deck.expect_close("strain", first["v_gamma"][-1], 0.05, rtol=0.01)
deck.expect_close("time, s, at the rate Iv P/eta = 10/s", first["Time"][-1], 0.05 / 10.0, rtol=0.01)

# beads of two sizes, 30 % of the volume fine
first = thermo()
d = deck.read_dump("bidisperse_si.dump")
deck.expect_close("radii, m, by type", d["radius"], np.where(d["type"] == 1, 50e-6, 100e-6), rtol=1e-9)
volume = d["radius"]**3
deck.expect_close("share of the fine beads", volume[d["type"] == 1].sum() / volume.sum(), 0.3, atol=0.01)
frames = open("bidisperse_si.dump", encoding="ascii").read().count("ITEM: TIMESTEP")

# going on is what a single run does
second = thermo("in.continue")
deck.expect("the dump goes on", open("bidisperse_si.dump", encoding="ascii").read().count("ITEM: TIMESTEP") >= 2 * frames - 1)
step_of_strain = 10.0 * first["Time"][-1] / first["Step"][-1]
straight = thermo(strain=(second["Step"][-1] - 0.5) * step_of_strain)
deck.expect_close("last step", straight["Step"][-1], second["Step"][-1])
for column in (*COLUMNS, "v_gamma"):
    deck.expect_close(f"restarted and in one run: {column}", second[column][-1], straight[column][-1], rtol=1e-6, atol=1e-6)

os.makedirs("one_size", exist_ok=True)
shutil.copy("stress.txt", "one_size/stress.txt")
deck.draw_example("bidisperse_si", "figure.png", options=["--from", "0.01"])
deck.finish()
