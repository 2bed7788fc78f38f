"""Viscosity with error bar, its parts, and the figures, from stress.txt of in.shear_rate.

usage: tools/python.sh plot.py [--from STRAIN]    steady part of the run; default: found
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


def draw_parts(ax, data, start):
    """Parts of the shear stress against strain, stacked on that of the fluid; mean from strain start on."""
    strain = data["v_gamma"]
    rheology.stack_parts(ax, strain, data)
    mean, error = rheology.estimate(data["v_sxy"][strain >= start])
    ax.plot([start, strain[-1]], [mean, mean], "k--", lw=1)
    ax.annotate(rf"$\eta_r$ = {mean:.1f} $\pm$ {error:.1f}", (strain[-1], mean), xytext=(-4, 5),
                textcoords="offset points", ha="right", weight="bold",
                bbox={"fc": "white", "ec": "none", "alpha": 0.85, "pad": 1.5})
    ax.set(xlabel="strain", ylabel=r"$\sigma_{xy}/(\eta_f\dot\gamma)$", xlim=(0, strain[-1]),
           ylim=(0, 1.3 * data["v_sxy"].max()))
    rheology.legend(ax, ncol=2, loc="upper left")


def report(data, start, phi):
    """Means and errors of the viscosity, its parts and the normal stresses."""
    values = {name[2:]: column[data["v_gamma"] >= start] for name, column in data.items() if name.startswith("v_")}
    values["N1"] = values["sxx"] - values["syy"]
    values["N2"] = values["syy"] - values["szz"]
    print(f"steady part: strain {start:.2f} to {data['v_gamma'][-1]:.2f}, phi = {phi:g}; over viscosity*rate")
    for name in ["sxy"] + [part[2:] for part in rheology.PARTS if part != "fluid"] + ["inertia", "sxx", "syy", "szz", "N1", "N2"]:
        mean, error = rheology.estimate(values[name])
        print(f"  {name:12s} {mean:8.2f} +- {error:.2f}")
    # normal viscosities eta_ii = -sigma_ii/(eta_f rate), relative
    print("  normal viscosities eta_11, eta_22, eta_33: "
          + ", ".join(f"{-values[name].mean():.1f}" for name in ("sxx", "syy", "szz")))
    print(f"  laws at this phi: Chevremont 2019 {rheology.eta_chevremont(phi):.1f}, Boyer 2011 {rheology.eta_boyer(phi):.1f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--from", dest="start", type=float, default=None)
    args = parser.parse_args()
    data = steady.read_ave_time("stress.txt")
    phi = float(Path("scene.txt").read_text(encoding="ascii").split()[1])
    start = args.start
    if start is None:
        start = rheology.steady_from(data["v_gamma"], data["v_sxy"])
    report(data, start, phi)

    fig, ax = plt.subplots(figsize=(7.5, 4.6))
    draw_parts(ax, data, start)
    fig.tight_layout()
    fig.savefig("figure.png", dpi=150)
    print("wrote figure.png")

    picture = rheology.image()
    if picture is not None:
        fig, axes = plt.subplots(1, 2, figsize=(11, 4.3), width_ratios=[1, 1.25])
        axes[0].imshow(picture)
        axes[0].set_axis_off()
        axes[0].set_title("color: velocity along the flow", fontsize=9, y=-0.08)
        draw_parts(axes[1], data, start)
        fig.tight_layout()
        fig.savefig("overview.png", dpi=120)
        print("wrote particles.png, overview.png")


if __name__ == "__main__":
    main()
