"""Gap, volume fraction, friction, and profiles across the gap, from what in.plates writes; the bulk laws beside them.

usage: tools/python.sh plot.py [--from STRAIN]    part to average, default: the last three quarters
"""
import argparse
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))
import steady

BULK = (0.25, 0.75)    # middle part of the gap that counts as bulk


def law_chevremont(iv, phi_m=0.6301 - 0.0794 * (1 - np.exp(-0.5 / 0.4032))):
    """phi and friction at friction coefficient 0.5, W. Chevremont, B. Chareyre, H. Bodiguel (2019), eqs. 13-15."""
    phi = phi_m / (1 + np.sqrt(iv))
    return phi, 0.36 + 0.34 / (1 + 0.0133 / iv) + iv * (1 - phi) ** -2.5


def law_boyer(iv, phi_m=0.585):
    """phi and friction, F. Boyer, E. Guazzelli, O. Pouliquen, Phys. Rev. Lett. 107, 188301 (2011)."""
    return (phi_m / (1 + np.sqrt(iv)),
            0.32 + 0.38 / (1 + 0.005 / iv) + iv * (1 + 2.5 * phi_m / np.sqrt(iv)))


def read_scene():
    words = Path("scene.txt").read_text(encoding="ascii").split()
    return dict(zip(words[::2], map(float, words[1::2])))


def read_profile(scene):
    """Last profile: center of layer, volume of the particles with centers in it over its own, velocity."""
    lines = Path("profile.txt").read_text(encoding="ascii").splitlines()
    start = max(n for n, line in enumerate(lines) if not line.startswith("#") and len(line.split()) == 3)
    rows = np.array([line.split() for line in lines[start + 1:]], dtype=float)
    rows = rows[(rows[:, 1] > -3) & (rows[:, 1] < scene["gap"] + 3)]
    cell = scene["layer"] * scene["width"] * scene["depth"]
    return rows[:, 1], rows[:, 2] * rows[:, 3] / cell, np.where(rows[:, 2] > 0.02, rows[:, 4], np.nan)


def fill(y, density, radius=1.0):
    """Volume fraction in the plane y from that of the centers: each sphere spread over its height."""
    away = np.abs(y[:, None] - y[None, :])
    kernel = np.where(away < radius, radius**2 - away**2, 0.0)
    return kernel @ density / kernel[len(y) // 2].sum()


def bulk(scene, y, density, velocity, gap):
    """Shear rate and volume fraction in the middle of the gap."""
    inside = (y > BULK[0] * gap) & (y < BULK[1] * gap)
    return np.polyfit(y[inside], velocity[inside], 1)[0], density[inside].mean()


def estimate(name, values):
    """Mean and error; without error if the run is too short to tell."""
    try:
        return steady.mean_error(values)
    except steady.TooShort as short:
        print(f"{name}: no error bar, {short}")
        return steady.Estimate(values.mean(), np.nan, np.nan, np.nan, len(values), np.nan)


def report(estimates, scene, y, density, velocity):
    gap, rate = estimates["gap"].mean, scene["rate"]
    for name, e in estimates.items():
        print(f"  {name:28s} {e.mean:8.4f} +- {e.error:.4f}")
    local, phi = bulk(scene, y, density, velocity, gap)
    iv = scene["viscosity"] * local / scene["pressure"]
    shear = estimates["friction, upper plate"].mean - scene["iv"] + iv    # the fluid shears with the bulk
    print(f"middle half of the gap: shear rate {local / rate:.3f} V/H, Iv {iv:.4f}, phi {phi:.4f}, friction {shear:.3f}")
    for name, law in (("Chevremont 2019", law_chevremont), ("Boyer 2011", law_boyer)):
        for where, x in (("nominal", scene["iv"]), ("bulk", iv)):
            print(f"  {name:16s} at the {where:8s} Iv {x:.4f}: phi {law(x)[0]:.4f}, friction {law(x)[1]:.3f}")
    return local, phi


def draw_history(axes, strain, data, start, scene):
    axes[0].plot(strain, data["f_cell[6]"], color="#1f4e79")
    axes[0].set(ylabel="volume fraction", xlim=(0, strain[-1]))
    axes[0].axhline(law_boyer(scene["iv"])[0], color="0.5", ls=":", lw=1)
    axes[0].axhline(law_chevremont(scene["iv"])[0], color="0.5", ls="--", lw=1)
    twin = axes[0].twinx()
    twin.plot(strain, data["f_cell[3]"], color="#b45f06")
    twin.set_ylabel("gap / radius", color="#b45f06")
    axes[1].plot(strain, data["f_cell[8]"] / scene["pressure"], color="0.7", label=r"$p/P$, upper plate")
    axes[1].plot(strain, data["v_mu_low"], color="#6fa8dc", label=r"$\sigma_{xy}/P$, lower plate")
    axes[1].plot(strain, data["v_mu"], color="#1f4e79", label=r"$\sigma_{xy}/P$, upper plate")
    axes[1].axhline(law_boyer(scene["iv"])[1], color="0.5", ls=":", lw=1, label="Boyer 2011")
    axes[1].axhline(law_chevremont(scene["iv"])[1], color="0.5", ls="--", lw=1, label="Chevremont 2019")
    axes[1].axvline(strain[start], color="0.8", lw=1)
    axes[1].set(xlabel="strain", ylabel="over the pressure $P$", xlim=(0, strain[-1]), ylim=(0, 2.2))
    axes[1].legend(fontsize=7, ncol=2, frameon=False, loc="upper right")


def draw_profiles(axes, y, density, velocity, gap, scene, local, phi):
    top = scene["rate"] * gap
    axes[0].plot(velocity / top, y, color="#1f4e79")
    axes[0].plot([0, 1], [0, gap], color="0.5", ls=":", lw=1, label="linear")
    middle = np.array(BULK) * gap
    offset = np.nanmean((velocity - local * y)[(y > middle[0]) & (y < middle[1])])
    axes[0].plot((offset + local * np.array([0, gap])) / top, [0, gap], color="#b45f06", lw=1, label="slope of the bulk")
    axes[0].set(xlabel="velocity / V", ylabel="y / radius", ylim=(-1.5, gap + 1.5), xlim=(0, 1))
    axes[0].legend(fontsize=8, frameon=False, loc="upper left")
    axes[1].plot(fill(y, density), y, color="#1f4e79")
    axes[1].plot([phi, phi], middle, color="#b45f06", lw=1, label=f"bulk, {phi:.3f}")
    axes[1].set(xlabel="volume fraction", ylim=(-1.5, gap + 1.5), xlim=(0, 0.8))
    axes[1].legend(fontsize=8, frameon=False, loc="upper right")
    for ax in axes:
        ax.axhspan(-1.5, 0, color="0.9")
        ax.axhspan(gap, gap + 1.5, color="0.9")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--from", dest="start", type=float, default=None)
    args = parser.parse_args()
    scene = read_scene()
    data = steady.read_ave_time("flow.txt")
    strain = data["f_cell[1]"]
    columns = {"gap": "f_cell[3]", "volume fraction": "f_cell[6]", "pressure, lower plate": "f_cell[7]",
               "pressure, upper plate": "f_cell[8]", "friction, lower plate": "v_mu_low",
               "friction, upper plate": "v_mu", "stress along z, upper plate": "f_cell[12]"}
    start = int(np.searchsorted(strain, 0.25 * strain[-1] if args.start is None else args.start))
    try:
        found = steady.steady_start(data["f_cell[3]"], data["v_mu"])
        print(f"steady from strain {strain[found]:.2f} on, by tools/steady.py")
    except ValueError as why:
        print(f"tools/steady.py: {why}")
    print(f"means over strain {strain[start]:.2f} to {strain[-1]:.2f}")
    estimates = {name: estimate(name, data[column][start:]) for name, column in columns.items()}
    y, density, velocity = read_profile(scene)
    local, phi = report(estimates, scene, y, density, velocity)

    fig = plt.figure(figsize=(11, 4.6))
    grid = fig.add_gridspec(2, 3, width_ratios=[1.5, 1, 1])
    draw_history([fig.add_subplot(grid[0, 0]), fig.add_subplot(grid[1, 0])], strain, data, start, scene)
    draw_profiles([fig.add_subplot(grid[:, 1]), fig.add_subplot(grid[:, 2])], y, density, velocity,
                  estimates["gap"].mean, scene, local, phi)
    fig.tight_layout()
    fig.savefig("figure.png", dpi=130)
    print("wrote figure.png")
    if Path("particles.ppm").exists():
        plt.imsave("particles.png", plt.imread("particles.ppm"))
        print("wrote particles.png")


if __name__ == "__main__":
    main()
