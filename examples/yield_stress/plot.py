"""Figure and numbers of the tables of study.py: flow curves, their yield stress, creep.

usage: tools/python.sh study.py --draw
"""
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import curve_fit

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "scene"))
import cases

COLORS = ["#1f4e79", "#b45f06", "#38761d", "#741b47", "0.4"]    # from the last curve to the first
UNKNOWN = 0.1    # relative error of a run that is too short to tell it


def herschel_bulkley(rate, yield_stress, factor, power):
    return yield_stress + factor * rate**power


def curves(rows):
    """Flow curves: (adhesion, stiffness) -> rate, stress, its error, in the order of the rate; means over seeds."""
    found = {}
    for key in sorted({(row["adhesion"], row["stiffness"]) for row in rows}, key=lambda k: (float(k[0]), float(k[1]))):
        mine = sorted((row for row in rows if (row["adhesion"], row["stiffness"]) == key), key=lambda row: float(row["rate"]))
        rate, stress, error = (np.array(c) for c in cases.columns(mine, "rate", "sxy", "sxy_error"))
        error = np.where(np.isfinite(error) & (error > 0), error, UNKNOWN * stress)
        found[key] = rate, stress, error
    return found


def fit(rate, stress, error):
    """Herschel-Bulkley's parameters and their errors; those grow if the fit misses more than the errors say."""
    best, covariance = curve_fit(herschel_bulkley, rate, stress, p0=(0.8 * stress[0], stress[-1] / rate[-1] ** 0.8, 0.8),
                                 sigma=error, absolute_sigma=True, bounds=([0, 0, 0.2], [np.inf, np.inf, 1.5]))
    chi2 = np.sum(((herschel_bulkley(rate, *best) - stress) / error) ** 2) / max(len(rate) - 3, 1)
    return best, np.sqrt(np.diag(covariance) * max(chi2, 1)), chi2


def draw_curves(axes, rows):
    for ((adhesion, stiffness), (rate, stress, error)), color in zip(curves(rows).items(), COLORS[::-1] + ["k"]):
        pull = float(adhesion) * float(stiffness)
        label = "no adhesion" if pull == 0 else rf"$\delta$ = {adhesion}, $k$ = {stiffness}"
        axes[0].errorbar(rate, stress, error, fmt="o", ms=4, color=color, label=label)
        if pull > 0:
            axes[1].errorbar(rate / pull, stress / pull, error / pull, fmt="o", ms=4, color=color, label=label)
        if pull > 0 and len(rate) > 3:
            (sy, factor, power), (sy_error, _, power_error), chi2 = fit(rate, stress, error)
            line = np.logspace(np.log10(rate[0]), np.log10(rate[-1]), 50)
            axes[0].plot(line, herschel_bulkley(line, sy, factor, power), color=color, lw=0.8)
            print(f"adhesion {adhesion} stiffness {stiffness}: yield stress {sy:.4f} +- {sy_error:.4f}, over the pull-off "
                  f"{sy / pull:.4f} +- {sy_error / pull:.4f}; power {power:.2f} +- {power_error:.2f}, chi2/dof {chi2:.1f}")
        elif pull == 0:
            viscosity = np.average(stress / rate, weights=(rate / error) ** 2)
            axes[0].plot(rate, viscosity * rate, color=color, lw=0.8)
            print(f"no adhesion: viscosity {viscosity:.1f}, stress/rate " + " ".join(f"{v:.1f}" for v in stress / rate))
    axes[0].set(xscale="log", yscale="log", xlabel=r"$\dot\gamma$", ylabel=r"$\sigma_{xy}$")
    axes[1].set(xscale="log", yscale="log", xlabel=r"$\eta_f\dot\gamma a^2/F_c$", ylabel=r"$\sigma_{xy} a^2/F_c$")


def draw_creep(ax, rows):
    rows = sorted(rows, key=lambda row: float(row["stress"]))
    if not rows:
        return
    stress, rate, crept = (np.array(c) for c in cases.columns(rows, "stress", "last_rate", "crept"))
    ax.plot(stress, np.maximum(rate, 1e-8), "o", color=COLORS[0], label=f"creep, $\\delta$ = {rows[0]['adhesion']}")
    for s, r, c in zip(stress, rate, crept):
        print(f"creep under {s:g}: strain {c:.3f}, rate at the end {r:.2e}")
    ax.set(yscale="log", xlabel=r"$\sigma_{xy}$ imposed", ylabel=r"$\dot\gamma$ at the end")


def draw(rows, creep_rows, name):
    fig, axes = plt.subplots(1, 3, figsize=(13, 4.2))
    draw_curves(axes, rows)
    draw_creep(axes[2], creep_rows)
    if creep_rows:
        key = creep_rows[0]["adhesion"], creep_rows[0]["stiffness"]
        if key in curves(rows):
            rate, stress, error = curves(rows)[key]
            axes[2].errorbar(stress, rate, xerr=error, fmt="s-", ms=4, lw=0.8, mfc="none", color=COLORS[1], label="rate imposed")
            axes[2].set(xlim=(0, 1.15 * max(float(row["stress"]) for row in creep_rows)))
    for ax in axes:
        if ax.get_legend_handles_labels()[0]:
            ax.legend(frameon=False, fontsize=8)
    fig.tight_layout()
    fig.savefig(name, dpi=140)
    plt.close(fig)
    print(f"wrote {name}")
