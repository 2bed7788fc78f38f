# ranks: 1 4
"""Stress of contact, lubrication, inertia and repulsion adds up to LAMMPS' pressure tensor to rounding, in 3d and 2d."""
import numpy as np

import deck

LAWS = "friction clm ramp 0.5 10 adhesion 0.002 repulsion 20 0.02"
for case in ({"dim": 3}, {"dim": 3, "newton": "off"}, {"dim": 2}):
    case = dict(case, coeffs=LAWS)
    deck.make_state(dim=case["dim"], phi=0.5 if case["dim"] == 3 else 0.75)
    t = deck.run("in.partition", **case).thermo()
    scale = np.max(np.abs(t["v_xy"]))
    for n, name in enumerate(("xx", "yy", "zz", "xy", "xz", "yz"), start=1):
        if case["dim"] == 2 and "z" in name:
            continue
        deck.expect_close(f"{case} {name}", t[f"v_{name}"], -t[f"c_p[{n}]"], atol=1e-13 * scale * 10)
    for n, name in ((1, "contact normal"), (2, "contact tangential"), (3, "lubrication normal"),
                    (4, "lubrication tangential"), (6, "repulsion")):
        deck.expect(f"{name} takes part", np.max(np.abs(t[f"c_s[{n}][4]"])) > 0.01 * scale)
    # central forces have a symmetric stress
    deck.expect_close("contact normal xy = yx", t["c_s[1][7]"], t["c_s[1][4]"], atol=1e-12 * scale)
    deck.expect_close("repulsion xy = yx", t["c_s[6][7]"], t["c_s[6][4]"], atol=1e-12 * scale)
    deck.expect_close("lubrication normal xy = yx", t["c_s[3][7]"], t["c_s[3][4]"], atol=1e-12 * scale)

    # the short way of a step that asks for the virial alone
    deck.run("in.virial", all="no", **case)
    deck.run("in.virial", all="yes", **case)
    alone, virial, parts = (np.loadtxt(name)[:, 1:] for name in ("virial.no", "virial.yes", "parts"))
    deck.expect("virial at every output", alone.shape == (21, 6))
    deck.expect("bit for bit, whatever else the step asks for", np.array_equal(alone, virial),
                f"largest difference {np.max(np.abs(alone - virial)):.1e}")
    size = np.max(np.abs(parts), axis=1, keepdims=True)
    deck.expect_close("virial = sum of the parts", alone / size, -parts / size, atol=1e-12)
deck.finish()
