# ranks: 2
"""The example examples/normal_viscosity, shortened: parts against the virial of LAMMPS, tangential forces without a trace, signs; its figure."""
import numpy as np

import deck
from deck import expect, expect_close

ORIGINS, COMPONENTS = ("contact_n", "contact_t", "film_n", "film_t"), ("xx", "yy", "zz")
examples = deck.ROOT / "examples"
last = deck.run("in.whole", N=200, strain=3, transient=1, angles=30, sampling=0.04, scene=examples / "scene",
                packing=examples / "packing" / "packing.lmp").values

# tangential forces are orthogonal to the line of centers: r_x F_x + r_y F_y + r_z F_z = 0 for every pair
size = np.abs([last["virial_" + c] for c in COMPONENTS]).max()
for c in COMPONENTS:
    expect_close(f"{c}: the parts are the virial", sum(last[f"{origin}_{c}"] for origin in ORIGINS), last["virial_" + c], atol=1e-9 * size)
for origin in ("contact_t", "film_t"):
    expect_close(f"{origin}: no trace", sum(last[f"{origin}_{c}"] for c in COMPONENTS), 0.0, atol=1e-9 * size)

stress = deck.read_stress()
import steady    # tools/, which read_stress() adds to the path    pylint: disable=wrong-import-position
parts = steady.read_ave_time("normal.txt")
expect_close("normal.txt and stress.txt have the same lines", parts["v_gamma"], stress["v_gamma"], atol=0)
kept = stress["v_gamma"] > 1
mean = {name[2:]: column[kept].mean() for name, column in {**stress, **parts}.items() if name.startswith("v_")}
for c in COMPONENTS:
    expect_close(f"{c}: the parts are the whole but for inertia", sum(mean[f"{origin}_{c}"] for origin in ORIGINS), mean["s" + c], rtol=0.01)

# W. Chevremont, thesis, Grenoble (2020), table 3.1, without tangential lubrication (see README.md of the example)
for c, signs in (("xx", "---"), ("yy", "--+"), ("zz", "-++")):
    for origin, sign in zip(ORIGINS, signs):
        expect(f"{origin} {c}: {'tension' if sign == '+' else 'compression'}", mean[f"{origin}_{c}"] * float(sign + "1") > 0,
               f"{mean[f'{origin}_{c}']:.3f}")
expect("eta_33 < eta_22", 0.5 < mean["szz"] / mean["syy"] < 0.95, f"lambda_33 {mean['szz'] / mean['syy']:.3f}")
deck.draw_example("normal_viscosity", "figure.png")
deck.finish()
