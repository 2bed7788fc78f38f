# ranks: 1
"""The example examples/repulsive_thickening, shortened: repelled spheres thicken where stress presses them together; its study runs."""
import sys

import deck

ORIGIN = deck.ROOT / "examples" / "repulsive_thickening"
sys.path.insert(0, str(ORIGIN.parent / "scene"))
import rheology    # noqa: E402  pylint: disable=wrong-import-position

SMALL = {"N": 120, "phi": 0.5, "strain": 2.5}
viscosity, contacts = {}, {}
for force, friction in (("1000", 0.5), ("1", 0.5), ("1000", 0)):    # F over viscosity*rate*radius^2
    deck.run_example("repulsive_thickening", repulsion=force, friction=friction, **SMALL)
    data = rheology.read_run()
    kept = {name: column[data["v_gamma"] > 1].mean() for name, column in data.items()}
    viscosity[force, friction], contacts[force, friction] = 20 * kept["v_sxy"], kept["v_Z"]
deck.expect("a large repulsion keeps asperities apart", contacts["1000", 0.5] < 0.02, f"{contacts['1000', 0.5]:.3f}")
deck.expect_close("and friction does nothing", viscosity["1000", 0.5], viscosity["1000", 0], rtol=0.02)
deck.expect("a small one is overcome", contacts["1", 0.5] > 2, f"{contacts['1', 0.5]:.2f}")
deck.expect("and the viscosity is more than twice as large", viscosity["1", 0.5] > 2 * viscosity["1000", 0.5],
            f"{viscosity['1', 0.5]:.1f} {viscosity['1000', 0.5]:.1f}")

deck.study_example("repulsive_thickening", 2, "--phi", "0.45", "--only", "2", "--particles", "80", "--strain", "0.6")
deck.finish()
