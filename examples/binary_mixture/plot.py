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


def mean_ends(mine, name):
    """Means over the seeds at the smallest and the largest x."""
    ends = [min(mine, key=lambda row: float(row["x"]))["x"], max(mine, key=lambda row: float(row["x"]))["x"]]
    return [np.mean([float(row[name]) for row in mine if row["x"] == x]) for x in ends]


def straight(mine, name, chi):
    """Straight line in chi_f between the ends."""
    (first, last), (low, high) = mean_ends(mine, name), mean_ends(mine, "chi_f")
    return first + (last - first) * (chi - low) / (high - low)


def load_share(chi):
    """Share of the load that contacts above F* carry if a fraction chi of them, chi = 1 - tanh(k F*), is above it."""
    kF = np.arctanh(1 - np.clip(chi, 1e-6, 1 - 1e-12))
    return (kF * chi + np.log(1 + np.exp(-2 * kF))) / np.log(2)


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
        if len({row["x"] for row in mine}) > 2:
            for ax, values in ((axes[1], "phi"), (axes[2], "mu")):
                ax.plot(chi, straight(mine, values, chi), color=style["color"], lw=0.8)
            print(f"Iv {iv}: chi_f - x^2 at most {np.abs(chi - x * x).max():.3f}; phi, mu miss the straight line by at most "
                  f"{np.abs(phi - straight(mine, 'phi', chi)).max():.4f}, {np.abs(mu - straight(mine, 'mu', chi)).max():.3f}")
        same = [row for row in clm if float(row["Iv"]) == float(iv) and 0 < float(row["load"]) < 1e6]
        if same:
            chi, phi, phi_error, mu, mu_error = column(same, *("mean_" + n for n in (
                "chi_f", "phi", "phi_error", "mu", "mu_error")))
            for fmt, where, label in (("x", chi, "critical load"), ("+", load_share(chi), "its share of the load")):
                style.update(fmt=fmt, ms=6, label=label if iv == "0.01" else None)
                axes[1].errorbar(where, phi, phi_error, **style)
                axes[2].errorbar(where, mu, mu_error, **style)
                missed = phi - straight(mine, "phi", where)
                print(f"  {label}: phi misses the line of the mixture by {missed.mean():.4f}, rms {np.sqrt(np.mean(missed**2)):.4f}")
    line = np.linspace(0, 1, 50)
    axes[0].plot(line, line**2, "0.5", lw=1, label="$x^2$")
    axes[0].set(xlabel="fraction of rough particles $x$", ylabel=r"$\chi_f$")
    axes[1].set(xlabel=r"$\chi_f$, or share of the load", ylabel=r"$\phi$")
    axes[2].set(xlabel=r"$\chi_f$, or share of the load", ylabel=r"$\mu$", yscale="log")
    axes[1].set(ylim=(0.38, None))
    for ax, place in zip(axes, ("upper left", "lower left")):
        ax.legend(frameon=False, fontsize=8, loc=place)
    fig.tight_layout()
    fig.savefig(name, dpi=140)
    plt.close(fig)
    print(f"wrote {name}")
