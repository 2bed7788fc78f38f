"""Figure of the table of study.py: mu(Iv), phi(Iv) and the parts of mu, over the laws of the literature.

usage: tools/python.sh study.py --draw
"""
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "scene"))
import rheology

COLORS = {"0": "#38761d", "0.3": "#b45f06", "0.5": "#1f4e79", "1": "#741b47"}
IV = np.logspace(-3.3, 0.3, 100)


def columns(rows, *names):
    """Columns of the table; an unknown error is drawn as none."""
    return (np.nan_to_num([float(row[name]) for row in rows]) for name in names)


def draw(rows, name):
    fig, axes = plt.subplots(1, 3, figsize=(15.2, 4.3))
    frictions = sorted({row["friction"] for row in rows}, key=float)
    for friction in frictions:
        mine = [row for row in rows if row["friction"] == friction]
        iv, mu, mu_error, phi, phi_error = columns(mine, "Iv", "mu", "mu_error", "phi", "phi_error")
        style = {"fmt": "o", "ms": 4, "color": COLORS.get(friction, "k"), "label": f"friction {friction}"}
        axes[0].errorbar(iv, mu, mu_error, **style)
        axes[1].errorbar(iv, phi, phi_error, **style)
        axes[1].plot(IV, rheology.phi_chevremont(IV, float(friction)), color=style["color"], lw=0.8)
    axes[0].plot(IV, rheology.mu_chevremont(IV, 0.5), color="0.4", lw=1, label="Chevremont 2019, friction > 0.36")
    axes[0].plot(IV, rheology.mu_boyer(IV), color="0.4", lw=1, ls="--", label="Boyer 2011")
    axes[1].plot(IV, rheology.phi_boyer(IV), color="0.4", lw=1, ls="--", label="Boyer 2011")
    axes[0].set(ylabel=r"$\mu = \sigma_{xy}/P$", yscale="log", ylim=(0.09, 6))
    axes[1].set(ylabel=r"$\phi$", ylim=(0.27, 0.66))

    mine = [row for row in rows if row["friction"] == "0.5"]
    iv, *parts = columns(mine, "Iv", "contact_n", "contact_t", "film_n", "film_t")
    for (label, color), part in zip(list(rheology.PARTS.values())[1:], parts):
        axes[2].plot(iv, part, "o", ms=4, color=color, label=label)
    axes[2].plot(iv, iv, "o", ms=4, color="0.6", label="fluid")
    axes[2].plot(iv, parts[0] + parts[1], "ks", mfc="none", ms=6, label="contact (laws in black)")
    axes[2].plot(iv, parts[2] + parts[3] + iv, "C3D", mfc="none", ms=6, label="films and fluid (laws in red)")
    for (law, split), style in zip(rheology.SPLITS.items(), ("-", "--", ":", "-.")):
        for part, color in zip(split(IV), ("k", "C3")):
            axes[2].plot(IV, part, ls=style, color=color, lw=1, label=law if color == "k" else None)
    axes[2].set(ylabel=r"parts of $\mu$, friction 0.5", yscale="log", ylim=(5e-4, 5))
    for ax in axes:
        ax.set(xscale="log", xlabel=r"$I_v = \eta_f\dot\gamma/P$")
        ax.legend(frameon=False, fontsize=7.5, **({"loc": "center left", "bbox_to_anchor": (1, 0.5)} if ax is axes[2] else {}))
    fig.tight_layout()
    fig.savefig(name, dpi=140)
    plt.close(fig)
    print(f"wrote {name}")
