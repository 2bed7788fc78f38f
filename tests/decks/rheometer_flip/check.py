# ranks: 1 4
"""A flip changes nothing: two copies of the system side by side, which do not flip, are the oracle."""
import numpy as np

import deck

CASES = [{"drive": "rate 1"}, {"drive": "rate -1", "tilt": -0.45}, {"drive": "stress 30", "hold": "volume"}]


def momentum(t):
    """Mean momentum relative to the flow, over the mean of its size."""
    d = deck.read_dump("one.dump")
    rate, dilation = t["f_rheometer[2]"][-1], t["f_rheometer[8]"][-1]
    p = d["mass"] * np.array([d["vx"] - rate * d["y"], d["vy"] - dilation * d["y"], d["vz"]])
    return np.abs(p.sum(axis=1)).max() / np.abs(p).sum(axis=1).max()


deck.make_state()
single = [deck.run("in.flip", out="one.dump", **case).thermo() for case in CASES]
residual = momentum(single[-1])
deck.run("in.twice", ranks=1)
for case, one in zip(CASES, single):
    two = deck.run("in.flip", out="two.dump", **case).thermo()
    deck.expect(f"{case}: one flips", np.sum(np.abs(np.diff(one["Xy"])) > 0.5 * one["Ly"][0]) == 1)
    deck.expect(f"{case}: two do not", np.all(np.abs(np.diff(two["Xy"])) < 0.5 * one["Ly"][0]))
    for mine, partition in (("f_rheometer[4]", "v_yy"), ("f_rheometer[5]", "v_xy")):
        sign = -1 if mine == "f_rheometer[4]" else 1
        deck.expect_close(f"{case}: {mine} is the sum of the parts", one[mine], sign * one[partition],
                          atol=1e-12 * np.max(np.abs(one[mine])))
    for name in one:
        if name != "Xy":
            scale = np.max(np.abs(one[name]))
            deck.expect_close(f"{case}: {name}", one[name], two[name], atol=1e-8 * scale)
deck.expect_close("no momentum relative to the flow", residual, 0, atol=1e-11)
deck.finish()
