"""Dry contact is elastic, never attracts, and lasts half a period of the springs in series."""
import numpy as np

import deck

for roughness in (0.0, 0.05):
    t = deck.run("in.bounce", roughness=roughness).thermo()
    touching = t["c_contact"] > 0
    # asperities (k) and bulk (g) in series while they touch; smooth: bulk alone. Reduced mass 1/2
    stiffness = 1000.0 if roughness == 0 else 1000.0 * 500.0 / 1500.0
    # crushed flat (u = 0) beyond un = -k/g eps a: not reached here
    deck.expect_close(f"roughness {roughness}: time of contact", np.count_nonzero(touching) * 1e-4,
                      np.pi * np.sqrt(0.5 / stiffness), atol=2e-4)
    # velocity Verlet: errors of (omega dt)^2 = 2e-5
    deck.expect_close("speed after", -t["v_v1"][-1], 0.01, rtol=2e-5)
    deck.expect("no attraction", np.all(t["c_film"] == 0) and np.all(t["c_pull"] == 0) and np.all(t["c_contact"] >= 0))
    energy = t["KinEng"] + t["PotEng"]
    deck.expect_close("energy", energy, energy[0], rtol=2e-4)
    deck.expect_close("largest force", t["c_contact"].max(), 0.02 * np.sqrt(0.5 * stiffness), rtol=1e-3)
deck.finish()
