# ranks: 1
"""The example examples/shear_thickening, shortened: a critical load thickens, chi_f follows the stress, its study runs."""
import sys

import numpy as np

import deck

ORIGIN = deck.ROOT / "examples" / "shear_thickening"
sys.path.insert(0, str(ORIGIN.parent / "scene"))
import rheology    # noqa: E402  pylint: disable=wrong-import-position

found = {}
for load in ("40", "0.4"):    # stress d^2/F* = 0.1 and 10
    deck.run_example("shear_thickening", N=120, phi=0.52, load=load, strain=2.5, stokes=0.3)
    data = rheology.read_run()
    kept = {name: column[data["v_gamma"] > 1.0] for name, column in data.items()}
    found[load] = {name: column.mean() for name, column in kept.items()}
    f_Z = float(load) * found[load]["v_Z"] / (-found[load]["v_syy"] * 4)
    # J. Dong's law; for spheres k = 0.13 to 0.15
    deck.expect_close(f"chi_f under {load}", found[load]["v_chi_f"], 1 - np.tanh(0.14 * f_Z), atol=0.05)
    deck.expect_close("the stress is held", found[load]["v_sxy"], 1.0, atol=0.05)
thick, thin = (1 / found[load]["v_gamma_dot"] for load in ("0.4", "40"))
deck.expect("more than twice as viscous under a high stress", thick > 2 * thin, f"{thin:.1f} {thick:.1f}")

# another load in the second part of a run: what rubs changes, what touches goes on
deck.run_example("shear_thickening", N=120, drive="rate", rate=1, phi=0.5, load=1e9, before=0, presheared=0.3, strain=0.2)
data = rheology.read_run()
deck.expect("nothing rubs under a load that is never reached", np.all(data["v_chi_f"] == 0))
deck.expect("nor does any contact carry a tangential force", np.all(np.abs(data["v_contact_t"]) < 1e-9),
            f"{np.abs(data['v_contact_t']).max():.1e}")
deck.expect("contacts of the first part are still there", data["v_Z"][0] > 1, f"{data['v_Z'][0]:.2f}")
deck.draw_example("shear_thickening", "run.png", options=["--from", "0.35"])

deck.study_example("shear_thickening", 4, "--parts", "pressure", "stress", "--only", "2", "--particles", "100", "--strain", "0.6")
deck.finish()
