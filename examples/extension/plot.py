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

MARKS = {"shear": ("o-", "#333333"), "planar": ("s-", "#b45f06"), "uniaxial": ("^-", "#0b5394")}


def of_flow(rows, flow, friction):
    """Volume fraction, viscosity, its error, pressure: means over seeds."""
    mine = [r for r in rows if r["flow"] == flow and r["friction"] == friction]
    found = []
    for phi in sorted({r["phi"] for r in mine}):
        these = [r for r in mine if r["phi"] == phi]
        eta, error, p = (np.array(c) for c in cases.columns(these, "viscosity", "viscosity_error", "pressure"))
        scatter = np.std(eta, ddof=1) / np.sqrt(len(eta)) if len(eta) > 1 else 0.0
        found.append((float(phi), np.mean(eta), max(scatter, np.sqrt(np.sum(error**2)) / len(eta)), np.mean(p)))
    return [np.array(c) for c in zip(*found)] if found else [np.array([])] * 4


def draw(rows, name):
    fig, (left, right) = plt.subplots(1, 2, figsize=(9.5, 4))
    for friction, fill in (("0.5", None), ("0", "none")):
        shear = of_flow(rows, "shear", friction)
        if not len(shear[0]):
            continue
        for flow, (line, color) in MARKS.items():
            phi, eta, error, p = of_flow(rows, flow, friction)
            if not len(phi):
                continue
            left.errorbar(phi, eta, error, fmt=line, mfc=fill, color=color, ms=5, lw=0.8, label=f"{flow}, friction {friction}")
            for values in zip(phi, eta, error, p):
                print("friction {}, {}, phi {:g}: viscosity {:.2f} +- {:.2f}, pressure {:.1f}".format(friction, flow, *values))
            common = [i for i, x in enumerate(phi) if x in shear[0]]
            of_shear = np.array([list(shear[0]).index(phi[i]) for i in common], dtype=int)
            if flow != "shear" and common:
                ratio = eta[common] / shear[1][of_shear]
                spread = ratio * np.hypot(error[common] / eta[common], shear[2][of_shear] / shear[1][of_shear])
                right.errorbar(phi[common], ratio, spread, fmt=line, mfc=fill, color=color, ms=5, lw=0.8, label=f"{flow}, friction {friction}")
                print(f"    over shear: {np.round(ratio, 2)} +- {np.round(spread, 2)}")
    left.set(yscale="log", xlabel="volume fraction", ylabel=r"$\eta/\eta_f$")
    right.axhline(1, color="0.5", lw=0.8, ls=":")
    right.set(xlabel="volume fraction", ylabel="viscosity over that in shear", ylim=(0, None))
    for ax in (left, right):
        ax.legend(frameon=False, fontsize=7)
    fig.tight_layout()
    fig.savefig(name, dpi=130)
    plt.close(fig)
    print(f"wrote {name}")
