"""Targets are reached, and the same state is found whichever two of its quantities are imposed."""
import numpy as np

import deck

START = {"from": "ivdata", "start": 0.1}
NAMES = "step strain rate phi pressure stress pressure_target target dilation path state".split()


def sheared(what, out, skip=2.0, **variables):
    """Means over the strain after skip, with their standard errors from blocks of one strain unit."""
    thermo = deck.run("in.sheared", out=out, **variables).thermo()
    t = dict(zip(NAMES, np.loadtxt(out).T), thermo=thermo)
    steady = t["path"] > skip
    blocks = np.floor(t["path"][steady] - skip).astype(int)
    if t["path"][-1] < skip + 3:
        return t, None
    mean = {}
    for name in ("rate", "phi", "pressure", "stress"):
        values = np.array([t[name][steady][blocks == b].mean() for b in range(blocks.max())])
        mean[name] = values.mean()
        mean[name + "_error"] = values.std(ddof=1) / np.sqrt(len(values))
    print(what, {name: f"{value:.4f}" for name, value in mean.items()})
    return t, mean


def agree(what, name, a, b, factor=4.0):
    """Within their error bars: the blocks are correlated and few, so these are not exact."""
    error = np.hypot(a[name + "_error"], b[name + "_error"])
    deck.expect_close(f"{what}: {name}", b[name], a[name], atol=factor * error)


def shear():
    t, imposed = sheared("viscous number and pressure", "iv")
    deck.expect_close("mean pressure over ten strain units", imposed["pressure"], 1, rtol=0.01)
    deck.expect("following", np.all(t["state"][t["path"] > 2] == 1))
    stress = imposed["stress"] + 0.1    # with that of the fluid

    t, volume = sheared("rate and volume", "volume", **START, drive="rate 0.1", hold="volume", fraction=imposed["phi"])
    t, driven = sheared("stress and volume", "stress", **START, drive=f"stress {stress}", hold="volume",
                        fraction=imposed["phi"])
    t, both = sheared("stress and pressure", "both", **START, drive=f"stress {stress}", hold="pressure 1")
    for what, other in (("volume", volume), ("stress", driven), ("stress and pressure", both)):
        for name in ("rate", "phi", "pressure", "stress"):
            agree(what, name, imposed, other)
    deck.expect_close("mean stress, at constant volume", driven["stress"] + driven["rate"], stress, rtol=0.01)
    deck.expect_close("mean stress, with pressure", both["stress"] + both["rate"], stress, rtol=0.01)
    deck.expect_close("and the mean pressure with it", both["pressure"], 1, rtol=0.02)
    return volume["stress"] / 0.1


def steps():
    """New targets between two runs."""
    t, new = sheared("pressure step", "step", skip=2.5, **START, strain=1, more=5, then="pressure 2")
    deck.expect_close("after a step of the pressure", new["pressure"], 2, rtol=0.02)
    deck.expect_close("and the rate of the viscous number follows", new["rate"], 0.2, rtol=1e-5)
    t, back = sheared("reversal", "back", **START, drive="rate 0.1", strain=1, more=4.2, then="rate -0.1")
    deck.expect("after a reversal the stress has the other sign", back["stress"] < -0.8, f"{back['stress']:.2f}")
    at_once = t["stress"][(t["path"] > 1.02) & (t["path"] < 1.1)]
    deck.expect("and is small first: contacts open", np.all((at_once < 0) & (at_once > 0.75 * back["stress"])), at_once)
    deck.expect_close("the pressure returns", back["pressure"], 1, rtol=0.05)


def extension(viscosity):
    """Trouton: the stress difference is 4 or 3 times that of shear; a few percent are not expected of suspensions."""
    for flow, ratio, aspect in (("planar", 4, (0.5, 2, 1)), ("uniaxial", 3, (0.5, 1.414, 1.414))):
        case = {"extra": f"flow {flow}", "shape": "ortho", "drive": "rate 0.1", "phi": 0.444,
                **{f"aspect_{d}": a for d, a in zip("xyz", aspect)}}
        t, mean = sheared(flow, flow, skip=0.3, strain=1.3, hold="volume", **case)
        steady = t["path"] > 0.3
        deck.expect_close(f"{flow}: driving stress", t["stress"][steady].mean(), ratio * viscosity * 0.1, rtol=0.3)
        phi = t["thermo"]["f_rheometer[3]"]
        deck.expect_close(f"{flow}: volume is conserved", phi[-2], phi[0], rtol=1e-12)    # where the flow is adjusted
        t, mean = sheared(flow, flow, strain=1.3, hold="pressure 1", **case)
        # not steady yet: while the cell dilates, the dashpot of the piston adds dilation/rate to the pressure
        deck.expect_close(f"{flow}: mean pressure", t["pressure"][steady].mean(),
                          1 + t["dilation"][steady].mean() / 0.1, rtol=0.03)
        text = deck.run("in.sheared", out="thin", fails=True, strain=3, hold="volume", **case).text
        deck.expect(f"{flow}: a cell that becomes too thin", "has come below twice the cutoff" in text)


def jammed():
    run = deck.run("in.jammed")
    t = run.thermo()
    deck.expect("jammed: warns once", run.text.count("jammed, the particles carry the stress 30") == 1)
    deck.expect("jammed: says so", t["f_rheometer[10]"][-1] == 3)
    deck.expect("jammed: at rest", abs(t["f_rheometer[2]"][-1]) < 1e-5, t["f_rheometer[2]"][-1])
    deck.expect_close("jammed: the particles carry it", t["f_rheometer[5]"][-1], 30, rtol=1e-3)
    again = deck.run("in.rejammed").thermo()
    deck.expect("jammed: judged in the same step after a restart",
                again["f_rheometer[10]"][1] == 1
                and np.array_equal(again["f_rheometer[10]"][1:], t["f_rheometer[10]"][-20:]))
    deck.expect("jammed: no run away", np.all(np.abs(t["f_rheometer[1]"]) < 0.2), np.max(t["f_rheometer[1]"]))


jammed()
viscosity = shear()
steps()
extension(viscosity)
deck.finish()
