"""Viscosity with error bar, its parts, and the figures, from stress.txt of in.shear_rate.

usage: tools/python.sh plot.py [--from STRAIN]    steady part of the run, default: the last three quarters
"""
import argparse
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

NAMES = ["contact, normal", "contact, tangential", "lubrication, normal", "lubrication, tangential"]


def law_chevremont(phi, phi_m=0.6301 - 0.0794 * (1 - np.exp(-0.5 / 0.4032))):
    """Relative viscosity at mu = 0.5, eqs. 13 and 16 of W. Chevremont, B. Chareyre, H. Bodiguel (2019)."""
    x = (phi_m / phi - 1) ** 2
    return 0.36 / x + 0.34 / (x + 0.0133) + (1 - phi) ** -2.5


def law_boyer(phi, phi_m=0.585):
    """Relative viscosity from F. Boyer, E. Guazzelli, O. Pouliquen, Phys. Rev. Lett. 107, 188301 (2011)."""
    iv = (phi_m / phi - 1) ** 2
    return (0.32 + 0.38 / (1 + 0.005 / iv)) / iv + 1 + 2.5 * phi_m / np.sqrt(iv)


def read(name="stress.txt"):
    """Columns strain, eta_r, four parts, inertia, sxx, syy, szz (over viscosity*rate)."""
    return np.loadtxt(name)[:, 1:]


def mean_and_error(values, blocks=8):
    """Mean and standard error from the scatter of block means."""
    means = [block.mean() for block in np.array_split(values, blocks)]
    return np.mean(values), np.std(means, ddof=1) / np.sqrt(blocks)


def draw_parts(ax, data, start):
    """Parts of the shear stress against strain, stacked on that of the fluid; mean from strain start on."""
    strain = data[:, 0]
    bottom = np.ones_like(strain)
    ax.fill_between(strain, 0, bottom, color="0.8", label="fluid", lw=0)
    colors = ["#1f4e79", "#6fa8dc", "#b45f06", "#f6b26b"]
    for name, color, part in zip(NAMES, colors, data[:, 2:6].T):
        ax.fill_between(strain, bottom, bottom + part, color=color, label=name, lw=0)
        bottom = bottom + part
    mean, error = mean_and_error(data[strain >= start, 1])
    ax.plot([start, strain[-1]], [mean, mean], "k--", lw=1)
    ax.annotate(rf"$\eta_r$ = {mean:.1f} $\pm$ {error:.1f}", (strain[-1], mean), xytext=(-4, 5),
                textcoords="offset points", ha="right", weight="bold",
                bbox={"fc": "white", "ec": "none", "alpha": 0.85, "pad": 1.5})
    ax.set(xlabel="strain", ylabel=r"$\sigma_{xy}/(\eta_f\dot\gamma)$", xlim=(0, strain[-1]),
           ylim=(0, 1.3 * data[:, 1].max()))
    handles, labels = ax.get_legend_handles_labels()
    ax.legend(handles[::-1], labels[::-1], ncol=2, fontsize=8, loc="upper left", frameon=False)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--from", dest="start", type=float, default=None)
    args = parser.parse_args()
    data = read()
    phi = float(Path("scene.txt").read_text(encoding="ascii").split()[1])
    strain = data[:, 0]
    start = args.start if args.start is not None else 0.25 * strain[-1]
    steady = data[strain >= start]

    print(f"steady part: strain {start:.2f} to {strain[-1]:.2f}, phi = {phi:g}")
    for name, column in [("eta_r", 1)] + list(zip(NAMES, range(2, 6))) + [("inertia", 6)]:
        mean, error = mean_and_error(steady[:, column])
        print(f"  {name:24s} {mean:8.2f} +- {error:.2f}")
    for name, values in [("sigma_xx", steady[:, 7]), ("sigma_yy", steady[:, 8]), ("sigma_zz", steady[:, 9]),
                         ("N1", steady[:, 7] - steady[:, 8]), ("N2", steady[:, 8] - steady[:, 9])]:
        mean, error = mean_and_error(values)
        print(f"  {name:24s} {mean:8.2f} +- {error:.2f}")
    print(f"  laws at this phi: Chevremont 2019 {law_chevremont(phi):.1f}, Boyer 2011 {law_boyer(phi):.1f}")

    fig, ax = plt.subplots(figsize=(7.5, 4.6))
    draw_parts(ax, data, start)
    fig.tight_layout()
    fig.savefig("figure.png", dpi=150)
    print("wrote figure.png")

    if Path("particles.ppm").exists():
        image = plt.imread("particles.ppm")
        plt.imsave("particles.png", image)
        fig, axes = plt.subplots(1, 2, figsize=(11, 4.3), width_ratios=[1, 1.25])
        axes[0].imshow(image[20:-20, 60:-60])
        axes[0].set_axis_off()
        axes[0].set_title("color: velocity along the flow", fontsize=9, y=-0.08)
        draw_parts(axes[1], data, start)
        fig.tight_layout()
        fig.savefig("overview.png", dpi=120)
        print("wrote particles.png, overview.png")


if __name__ == "__main__":
    main()
