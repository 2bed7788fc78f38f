# ranks: 1
"""The example examples/extension, shortened: cells are drawn out, without friction the viscosity is that of shear; its study runs."""
import sys

import numpy as np

import deck

ORIGIN = deck.ROOT / "examples" / "extension"
sys.path[:0] = [str(ORIGIN.parent / "scene"), str(ORIGIN)]
import rheology    # noqa: E402  pylint: disable=wrong-import-position
import study    # noqa: E402  pylint: disable=wrong-import-position

SMALL = {"N": 250, "phi": 0.45, "strain": 2}
viscosity = {}
for flow, share in study.SHARE.items():
    log = deck.run_example("extension", flow=flow, friction=0, **SMALL)
    data = rheology.read_run()
    viscosity[flow] = study.viscosity(flow, data)[data["v_gamma"] > 0.8 * share].mean()
    if flow == "shear":
        continue
    t = log.thermo()
    cell = np.array([t["Lx"], t["Ly"], t["Lz"]])
    # the strain is that of the edges, to the digits of the log: so the stress is over the right rate
    drawn = np.log(cell[:, -1] / cell[:, 0])
    expected = (t["v_gamma"][-1] - t["v_gamma"][0]) * np.array({"planar": [1, -1, 0], "uniaxial": [1, -0.5, -0.5]}[flow])
    deck.expect_close(f"{flow}: edges", drawn, expected, atol=1e-6)
    deck.expect_close(f"{flow}: the cell ends as it began, mirrored", cell[0, 0] * cell[0, -1], np.prod(cell[:, 0]) ** (2 / 3), rtol=1e-2)
for flow in ("planar", "uniaxial"):
    deck.expect_close(f"{flow}: viscosity over that in shear", viscosity[flow] / viscosity["shear"], 1, rtol=0.12)

deck.study_example("extension", 2, "--phi", "0.40", "--only", "2", "--particles", "80", "--strain", "1.3")
deck.finish()
