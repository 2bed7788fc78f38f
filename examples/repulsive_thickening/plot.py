"""Figure and numbers of the table of study.py.

usage: tools/python.sh study.py --draw
"""
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "scene"))
import cases

COLORS = {"0.45": "#b45f06", "0.5": "#741b47"}


def of_kind(rows, phi, friction, repelled):
    """Columns of the runs of a coefficient of friction, with a repulsion or without."""
    mine = sorted((r for r in rows if r["phi"] == phi and r["friction"] == friction and (r["F"] != "0") == repelled),
                  key=lambda r: float(r["F"]))
    names = ("F", "mean_viscosity", "mean_viscosity_error", "mean_Z", "mean_Z_error")
    return [np.nan_to_num(np.array(c)) for c in cases.columns(mine, *names)]


def draw(rows, name):
    fig, (left, right) = plt.subplots(1, 2, figsize=(9.5, 4))
    for phi, color in COLORS.items():
        if len(of_kind(rows, phi, "0.5", True)[0]) < 2:
            continue
        F, eta, error, Z, Z_error = of_kind(rows, phi, "0.5", True)
        rough, smooth = (of_kind(rows, phi, friction, False) for friction in ("0.5", "0"))
        F0, eta0, error0, _, _ = of_kind(rows, phi, "0", True)
        stress = eta / F    # the rate and the viscosity of the fluid are 1
        left.errorbar(stress, eta, error, fmt="o-", color=color, ms=4, label=rf"$\phi$ = {phi}, friction 0.5")
        left.errorbar(eta0 / F0, eta0, error0, fmt="s", mfc="none", color=color, ms=5, label=rf"$\phi$ = {phi}, friction 0")
        for kind, line in ((rough, ":"), (smooth, "--")):
            if len(kind[1]):
                left.axhline(kind[1][0], color=color, lw=0.8, ls=line)
        right.errorbar(stress, Z, Z_error, fmt="o-", color=color, ms=4, label=rf"$\phi$ = {phi}")
        for line in zip(F, stress, eta, error, Z):
            print("phi {}, F {:g}: stress a^2/F {:.3g}, viscosity {:.1f} +- {:.1f}, contacts {:.2f}".format(phi, *line))
        for what, kind in (("0.5", rough), ("0", smooth)):
            if len(kind[1]):
                print(f"without repulsion, friction {what}: {kind[1][0]:.1f} +- {kind[2][0]:.1f}, contacts {kind[3][0]:.2f}")
        for line in zip(F0, eta0, error0):
            print("friction 0, F {:g}: viscosity {:.1f} +- {:.1f}".format(*line))
    left.set(xscale="log", xlabel=r"$\sigma a^2/F$", ylabel=r"$\eta/\eta_f$", ylim=(0, None))
    right.set(xscale="log", xlabel=r"$\sigma a^2/F$", ylabel="contacts of a sphere", ylim=(0, None))
    for ax in (left, right):
        ax.legend(frameon=False, fontsize=8, loc="upper left")
    fig.tight_layout()
    fig.savefig(name, dpi=130)
    plt.close(fig)
    print(f"wrote {name}")
