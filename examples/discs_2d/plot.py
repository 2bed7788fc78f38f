"""Figure of the table of study.py: friction and area fraction against J and I, with the laws of the literature.

usage: tools/python.sh study.py --draw
"""
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import curve_fit

COLORS = {"0": "#1f4e79", "0.4": "#b45f06"}
NAMES = {"viscous": r"$J = \eta_f\dot\gamma/P$", "inertial": r"$I = \dot\gamma d\,\sqrt{\rho/P}$"}
LARGEST = {"viscous": 0.03, "inertial": 0.1}    # beyond, no power law holds
MU_C = {"0": 0.09, "0.4": 0.28}    # Dong, thesis, Lund University (2020)


def columns(rows, *names):
    """Columns of the table; an unknown error is drawn as none."""
    return tuple(np.nan_to_num([float(row[name]) for row in rows]) for name in names)


def power_law(x, limit, slope, exponent):
    return limit + slope * x**exponent


def extrapolate(x, y, errors):
    """Fit of limit + slope x^exponent and its errors; None with fewer than 4 points."""
    if len(x) < 4:
        return None
    scale = np.where(errors > 0, errors, np.max(errors))
    start = [y[np.argmin(x)], y[np.argmax(x)] - y[np.argmin(x)], 0.5]
    bounds = ([-1, -10, 0.2], [2, 10, 1.5])
    fit, covariance = curve_fit(power_law, x, y, np.clip(start, *bounds), sigma=scale, absolute_sigma=True, bounds=bounds)
    return fit, np.sqrt(np.diag(covariance))


def collapse(rows, friction):
    """One law for both regimes, phi = phi_c - a K^n with K = J + alpha I^2 (Dong 2020): the four numbers, and how far rows are off."""
    mine = [row for row in rows if row["friction"] == friction and float(row["number"]) <= LARGEST[row["regime"]]]
    if len({row["regime"] for row in mine}) < 2 or len(mine) < 6:
        return None
    number, phi = columns(mine, "number", "phi")
    viscous = np.array([row["regime"] == "viscous" for row in mine])
    J, I2 = np.where(viscous, number, 0.0), np.where(viscous, 0.0, number**2)
    return curve_fit(lambda x, limit, slope, exponent, alpha: limit - slope * (x[0] + alpha * x[1])**exponent, (J, I2), phi,
                     [0.83, 0.5, 0.4, 0.2], bounds=([0, 0, 0.1, 0], [1, 5, 2, 10]), full_output=True)


def draw(rows, name):
    fig, axes = plt.subplots(2, 2, figsize=(9.5, 7), sharey="row")
    for column, regime in enumerate(NAMES):
        for friction in sorted({row["friction"] for row in rows}, key=float):
            mine = [row for row in rows if row["regime"] == regime and row["friction"] == friction]
            if not mine:
                continue
            x, mu, mu_error, phi, phi_error = columns(mine, "number", "mu", "mu_error", "phi", "phi_error")
            color = COLORS.get(friction, "k")
            for ax, y, error, what in ((axes[0, column], mu, mu_error, "mu"), (axes[1, column], phi, phi_error, "phi")):
                small = x <= LARGEST[regime]
                found = extrapolate(x[small], y[small], error[small])
                label = f"friction {friction}"
                if found:
                    fit, spread = found
                    grid = np.logspace(np.log10(x.min()), np.log10(LARGEST[regime]))
                    ax.plot(grid, power_law(grid, *fit), color=color, lw=0.8)
                    label += f": {fit[0]:.3f} $\\pm$ {spread[0]:.3f} at 0"
                    print(f"{regime} friction {friction}: {what} = {fit[0]:.4f} + {fit[1]:.4f} x^{fit[2]:.3f}, "
                          f"limit +- {spread[0]:.4f}, exponent +- {spread[2]:.3f}")
                ax.errorbar(x, y, error, fmt="o", ms=4, color=color, label=label)
            if friction in MU_C:
                axes[0, column].axhline(MU_C[friction], color=color, lw=0.8, ls="--")
        axes[1, column].set_xlabel(NAMES[regime])
        axes[0, column].set_title({"viscous": "viscous, no inertia", "inertial": "dry, inertial"}[regime])
    for friction in sorted({row["friction"] for row in rows}, key=float):
        found = collapse(rows, friction)
        if found:
            fit, off = found[0], found[2]["fvec"]
            print(f"friction {friction}: phi = {fit[0]:.4f} - {fit[1]:.3f} (J + {fit[3]:.3f} I^2)^{fit[2]:.3f} in both regimes, "
                  f"off by {np.sqrt(np.mean(off**2)):.4f} (rms)")
    for ax, place in zip(axes.flat, ["upper left"] * 2 + ["lower left"] * 2):
        ax.set_xscale("log")
        if ax.get_legend_handles_labels()[0]:
            ax.legend(frameon=False, fontsize=8, loc=place)
    axes[0, 0].set_ylabel(r"$\mu = \sigma_{xy}/P$  (dashed: limits of Dong 2020)")
    axes[1, 0].set_ylabel(r"area fraction $\phi$")
    axes[0, 0].set_ylim(bottom=0)
    fig.tight_layout()
    fig.savefig(Path(name), dpi=140)
    plt.close(fig)
    print(f"wrote {name}")
