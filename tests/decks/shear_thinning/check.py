# ranks: 1
"""The example examples/shear_thinning, shortened: friction that falls with the load thins, its study runs."""
import sys

import numpy as np

import deck

ORIGIN = deck.ROOT / "examples" / "shear_thinning"
sys.path.insert(0, str(ORIGIN.parent / "scene"))
import rheology    # noqa: E402  pylint: disable=wrong-import-position

SMALL = {"N": 120, "phi": 0.45, "strain": 2}
viscosity, coefficient = {}, {}
for load in ("2000", "0.02"):    # F over viscosity*rate*radius^2: stress a^2/F about 0.01 and 500
    deck.run_example("shear_thinning", critical=load, **SMALL)
    data = rheology.read_run()
    kept = {name: column[data["v_gamma"] > 0.8].mean() for name, column in data.items()}
    viscosity[load], N = 20 * kept["v_sxy"], kept["v_load"]
    coefficient[load] = 0.27 / np.tanh(0.27 * (N / float(load)) ** 0.35)
    deck.expect(f"F {load}: contacts carry what the stress says", 4 < N / viscosity[load] < 25, f"{N / viscosity[load]:.2f}")
deck.expect("friction is large under the small load", coefficient["2000"] > 1.3, f"{coefficient['2000']:.2f}")
deck.expect_close("and Coulomb's under the large one", coefficient["0.02"], 0.27, rtol=0.02)
deck.expect("more than 1.3 times as viscous under a small stress", viscosity["2000"] > 1.3 * viscosity["0.02"],
            f"{viscosity['0.02']:.1f} {viscosity['2000']:.1f}")

deck.study_example("shear_thinning", 2, "--phi", "0.40", "--only", "2", "--particles", "80", "--strain", "0.6")
deck.finish()
