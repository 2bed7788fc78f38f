"""Relative viscosity against the volume fraction and its parts, from study.csv, with the laws of the literature.

usage: tools/python.sh plot.py [--friction 0.5] [--table study.csv]
"""
import argparse
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "scene"))
import cases
import rheology

LEVELS = {"none": ("films alone", "s", "#b45f06"), "mean": ("fix hydro mean", "v", "#6fa8dc"), "grid": ("fix hydro grid", "o", "k")}


def draw_viscosity(ax, rows, friction):
    """eta_r - 1 over phi: 2.5 of a dilute suspension, and what is more than that."""
    phi = np.linspace(0.02, 0.56, 300)
    if friction == 0.5:
        for name, law, line in (("Boyer 2011", rheology.eta_boyer, ":"), ("Gallier 2014", rheology.eta_gallier, "-.")):
            x = phi[(phi > 0.1) & ((phi <= 0.45) | (name != "Gallier 2014"))]
            ax.plot(x, (law(x) - 1) / x, color="0.5", lw=1, ls=line, label=name)
    if friction:
        x = phi[phi > 0.1]
        ax.plot(x, (rheology.eta_chevremont(x, friction) - 1) / x, color="0.5", lw=1, label="Chevremont 2019")
    ax.axhline(2.5, color="0.8", lw=3, zorder=0, label="Einstein 1906")
    x = phi[phi < 0.15]
    ax.plot(x, 2.5 + 6.95 * x, color="0.6", lw=1, ls="--", label="Batchelor, Green 1972 (pure strain)")
    for level, (label, marker, color) in LEVELS.items():
        chosen = sorted((float(r["phi"]), float(r["eta_r"]), float(r["error"])) for r in rows if r["level"] == level)
        if chosen:
            x, eta, error = np.array(chosen).T
            ax.errorbar(x, (eta - 1) / x, np.nan_to_num(error) / x, fmt=marker + "-", color=color, ms=4, lw=0.8, label=label)
    ax.set(yscale="log", xlabel=r"$\phi$", ylabel=r"$(\eta_r - 1)/\phi$", xlim=(0, 0.57))
    ax.legend(frameon=False, fontsize=7)


def draw_parts(ax, rows):
    """Shares of what the particles add, with the whole flow around them."""
    chosen = sorted((r for r in rows if r["level"] == "grid"), key=lambda r: float(r["phi"]))
    x = np.array([float(r["phi"]) for r in chosen])
    if not len(x):
        return
    parts = {name: np.array([float(r[name[2:]]) for r in chosen]) for name in rheology.PARTS if name != "fluid"}
    total, bottom = sum(parts.values()), np.zeros_like(x)
    for name, part in parts.items():
        label, color = rheology.PARTS[name]
        ax.fill_between(x, bottom, bottom + part / total, color=color, lw=0, label=label)
        bottom = bottom + part / total
    ax.set(xlabel=r"$\phi$", ylabel=r"share of $\eta_r - 1$ with fix hydro grid", xlim=(x[0], x[-1]) if len(x) > 1 else None, ylim=(0, 1))
    rheology.legend(ax, loc="center left", bbox_to_anchor=(1, 0.5))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--friction", default="0.5")
    parser.add_argument("--table", default="study.csv")
    args = parser.parse_args()
    rows = [row for row in cases.read(args.table) if float(row["friction"]) == float(args.friction)]
    fig, axes = plt.subplots(1, 2, figsize=(11, 4.4), width_ratios=[1.25, 1])
    draw_viscosity(axes[0], rows, float(args.friction))
    draw_parts(axes[1], rows)
    fig.tight_layout()
    fig.savefig("figure.png", dpi=150)
    print("wrote figure.png")
    for row in sorted(rows, key=lambda row: (float(row["phi"]), row["level"])):
        print(f"phi {row['phi']}  {row['level']:5s}  eta_r {row['eta_r']} +- {row['error']}")


if __name__ == "__main__":
    main()
