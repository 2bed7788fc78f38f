"""Figure and numbers of the table of study.py.

usage: tools/python.sh study.py --draw
"""
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import FixedLocator, NullLocator, StrMethodFormatter

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "scene"))
import cases

COLORS = {"0.40": "#38761d", "0.45": "#b45f06", "0.50": "#741b47"}
EXPONENT = 0.35
LOAD = 10    # of a contact over stress a^2


def brizmer(mu, load, F):
    """Coefficient of friction at a load."""
    return mu / np.tanh(mu * (load / F) ** EXPONENT)


def of_law(rows, law, phi, by):
    """Columns of the runs with a law at a volume fraction, in the order of a column."""
    mine = sorted((r for r in rows if r["law"] == law and r["phi"] == phi), key=lambda r: float(r[by]))
    names = ("mean_viscosity", "mean_viscosity_error", "mean_load", "mu") + (("F",) if law == "brizmer" else ())
    return [np.nan_to_num(np.array(c)) for c in cases.columns(mine, *names)]


def draw(rows, name):
    fig, axes = plt.subplots(1, 3, figsize=(13.5, 4.2))
    for phi, color in COLORS.items():
        if not any(r["law"] == "brizmer" and r["phi"] == phi for r in rows):
            continue
        eta, error, load, mu, F = of_law(rows, "brizmer", phi, "F")
        stress = eta / F    # the rate and the viscosity of the fluid are 1
        effective = brizmer(mu, load, F)
        style = {"fmt": "o-", "color": color, "ms": 4, "lw": 0.8}
        print(f"    stress a^2/F {np.array2string(stress[::-1], precision=3)}")
        axes[0].errorbar(stress, eta, error, label=rf"$\phi$ = {phi}", **style)
        axes[1].plot(stress, effective, "o", color=color, ms=4, label=rf"$\phi$ = {phi}")
        axes[2].errorbar(effective, eta, error, fmt="o", color=color, ms=5, label=rf"$\phi$ = {phi}")
        ratio = load / eta
        print(f"phi {phi}: viscosity {eta[-1]:.2f} +- {error[-1]:.2f} to {eta[0]:.2f} +- {error[0]:.2f}, mean load over stress a^2 "
              f"{ratio.min():.2f} to {ratio.max():.2f}")
        known, known_error, _, coefficient = of_law(rows, "coulomb", phi, "mu")
        if len(known) < 2:
            continue
        axes[2].errorbar(coefficient, known, known_error, fmt="s-", mfc="none", color=color, ms=5, lw=0.8,
                         label=rf"Coulomb, $\phi$ = {phi}")
        for limit in (known[0], known[-1]):
            axes[0].axhline(limit, color=color, lw=0.8, ls=":")
        axes[0].text(1.1 * stress.min(), 1.02 * known[0], rf"Coulomb, $\mu$ = {coefficient[0]:g}", fontsize=7, color=color)
        axes[0].text(1.1 * stress[0], 0.99 * known[-1], rf"Coulomb, $\mu$ = {coefficient[-1]:g}", fontsize=7, color=color,
                     ha="right", va="top")
        expected = np.exp(np.interp(np.log(effective), np.log(coefficient), np.log(known)))
        print(f"    over that of Coulomb's law with the coefficient at the mean load: {np.round(eta / expected, 2)}")
        print(f"    coefficient at the mean load: {np.round(effective, 2)}")
    x = np.logspace(-2.3, 2.5, 200)
    axes[1].plot(x, brizmer(0.27, LOAD * x, 1.0), "k", lw=0.8, label=rf"$\mu(N)$ at $N = {LOAD:g}\,\sigma a^2$")
    axes[1].axhline(0.27, color="k", lw=0.8, ls=":")
    axes[0].set(xscale="log", xlabel=r"$\sigma a^2/F$", ylabel=r"$\eta/\eta_f$")
    axes[1].set(xscale="log", yscale="log", xlabel=r"$\sigma a^2/F$", ylabel=r"$\mu(\langle N \rangle)$")
    axes[2].set(xscale="log", xlabel=r"$\mu(\langle N \rangle)$, or $\mu$ of Coulomb's law",
                ylabel=r"$\eta/\eta_f$")
    for axis, ticks in ((axes[1].yaxis, (0.3, 0.5, 1, 2)), (axes[2].xaxis, (0.3, 0.5, 1, 2, 5))):
        axis.set_major_locator(FixedLocator(ticks))
        axis.set_minor_locator(NullLocator())
        axis.set_major_formatter(StrMethodFormatter("{x:g}"))
    for ax in axes:
        ax.legend(frameon=False, fontsize=8)
    fig.tight_layout()
    fig.savefig(name, dpi=130)
    plt.close(fig)
    print(f"wrote {name}")
