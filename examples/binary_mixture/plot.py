"""Figure and numbers of the table of study.py, with the runs under a pressure of ../shear_thickening.

usage: tools/python.sh study.py --draw
"""
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "scene"))
import cases

COLORS = {"0.1": "#38761d", "0.01": "#b45f06", "0.001": "#1f4e79"}


def column(rows, *names):
    return [np.nan_to_num(np.array(c)) for c in cases.columns(rows, *names)]


def interpolate(chi, values):
    """Between the values at the smallest and at the largest chi_f, linear in chi_f."""
    first, last = chi.argmin(), chi.argmax()
    return values[first] + (values[last] - values[first]) * (chi - chi[first]) / (chi[last] - chi[first])


def draw(rows, name):
    fig, axes = plt.subplots(1, 3, figsize=(13, 4.2))
    clm = [row for row in cases.read(HERE.parent / "shear_thickening" / "study.csv") if row["drive"] == "iv"]
    for iv in sorted({row["Iv"] for row in rows}, key=float):
        mine = sorted((row for row in rows if row["Iv"] == iv), key=lambda row: float(row["x"]))
        x, chi, chi_error, phi, phi_error, mu, mu_error = column(
            mine, "x", "chi_f", "chi_f_error", "phi", "phi_error", "mu", "mu_error")
        style = {"fmt": "o", "ms": 4, "color": COLORS.get(iv, "k"), "label": rf"$I_v$ = {iv}"}
        axes[0].errorbar(x, chi, chi_error, **style)
        axes[1].errorbar(chi, phi, phi_error, **style)
        axes[2].errorbar(chi, mu, mu_error, **style)
        if len(mine) > 2:
            for ax, values in ((axes[1], phi), (axes[2], mu)):
                ax.plot(chi, interpolate(chi, values), color=style["color"], lw=0.8)
            print(f"Iv {iv}: chi_f - x^2 at most {np.abs(chi - x * x).max():.3f}; phi, mu miss the straight line by at most "
                  f"{np.abs(phi - interpolate(chi, phi)).max():.4f}, {np.abs(mu - interpolate(chi, mu)).max():.3f}")
        same = [row for row in clm if float(row["Iv"]) == float(iv) and 0 < float(row["load"]) < 1e6]
        if same:
            chi, phi, phi_error, mu, mu_error = column(same, *("mean_" + n for n in (
                "chi_f", "phi", "phi_error", "mu", "mu_error")))
            style.update(fmt="x", ms=6, label="critical load" if iv == "0.01" else None)
            axes[1].errorbar(chi, phi, phi_error, **style)
            axes[2].errorbar(chi, mu, mu_error, **style)
    line = np.linspace(0, 1, 50)
    axes[0].plot(line, line**2, "0.5", lw=1, label="$x^2$")
    axes[0].set(xlabel="fraction of rough particles $x$", ylabel=r"$\chi_f$")
    axes[1].set(xlabel=r"$\chi_f$", ylabel=r"$\phi$")
    axes[2].set(xlabel=r"$\chi_f$", ylabel=r"$\mu$", yscale="log")
    for ax in axes:
        ax.legend(frameon=False, fontsize=8)
    fig.tight_layout()
    fig.savefig(name, dpi=140)
    plt.close(fig)
    print(f"wrote {name}")
