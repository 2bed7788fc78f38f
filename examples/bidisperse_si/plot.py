"""Volume fraction and friction of two sizes and of one, and the figure, from run.sh.

usage: tools/python.sh plot.py [--from STRAIN]    steady part of the runs; default: found
"""
import argparse
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "scene"))
import rheology
from rheology import steady

RUNS = {"two sizes, 1:2": (".", "#b45f06"), "one size": ("one_size", "#1155cc")}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--from", dest="start", type=float, default=None)
    args = parser.parse_args()
    words = Path("scene.txt").read_text(encoding="ascii").split()
    iv, restart = float(words[1]), float(words[3])

    fig, axes = plt.subplots(2, 1, figsize=(7.5, 5.5), sharex=True)
    for label, (folder, color) in RUNS.items():
        data = steady.read_ave_time(str(Path(folder) / "stress.txt"))
        strain = data["v_gamma"]
        start = args.start
        if start is None:
            start = rheology.steady_from(strain, data["v_phi_now"], data["v_sxy"])
        text = f"{label}: steady from strain {start:.1f};"
        for ax, name, symbol in (axes[0], "v_phi_now", r"\phi"), (axes[1], "v_sxy", r"\sigma_{xy}/P"):
            mean, error = rheology.estimate(data[name][strain >= start])
            text += f" {name[2:]} {mean:.4f} +- {error:.4f}"
            ax.plot(strain, data[name], color=color, lw=1.2, label=rf"{label}: ${symbol}$ = {mean:.3f} $\pm$ {error:.3f}")
            ax.plot([start, strain[-1]], [mean] * 2, color=color, ls="--", lw=1)
        print(text)
    for ax, law, name in (axes[0], rheology.phi_boyer, r"$\phi$"), (axes[1], rheology.mu_boyer, r"$\sigma_{xy}/P$"):
        ax.axhline(law(iv), color="0.5", ls=":", label="Boyer 2011, one size")
        ax.axvline(restart, color="0.8", lw=1, zorder=0)
        ax.set(ylabel=name)
        rheology.legend(ax, loc="lower center" if ax is axes[1] else "upper center")
    axes[0].set_title(rf"$I_v$ = {iv:g}, imposed pressure", fontsize=10)
    axes[0].text(restart, axes[0].get_ylim()[0], " restart", color="0.5", fontsize=8, va="bottom")
    axes[1].set(xlabel="strain", xlim=(0, strain[-1]), ylim=(0, None))
    fig.tight_layout()
    fig.savefig("figure.png", dpi=150)
    print("wrote figure.png")


if __name__ == "__main__":
    main()
