"""A cloud that settles, from what in.sedimentation writes, and settling velocities of suspensions, from study.csv.

usage: tools/python.sh plot.py [--no-cloud] [--table study.csv]
"""
import argparse
import csv
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from study import read_scene

HERE = Path(__file__).resolve().parent
LATTICE = 1.760119    # H. Hasimoto, J. Fluid Mech. 5, 317 (1959): simple cubic, velocity 1 - 1.7601 phi^(1/3) + phi - ...
IMAGES = 2.837297     # the same of one force in a cube of edge L: 1 - 2.8373 a/L


def cubic(phi):
    """Simple cubic array, A.S. Sangani, A. Acrivos, Int. J. Multiphase Flow 8, 343 (1982)."""
    c = np.cbrt(phi)
    return 1 - 1.7601 * c + c**3 - 1.5593 * c**6 + 3.9799 * c**8 - 3.0734 * c**10


def equilibrium(phi):
    """Fit to simulations of hard spheres, R. Gilleland, S. Torquato, W.B. Russel, J. Fluid Mech. 667, 403 (2011), as quoted."""
    return 1 - 6.546 * phi * np.polyval([5.882, -10.034, 7.426, -3.348, 1], phi)


def structure(phi):
    """Structure factor of long waves of hard spheres, N.F. Carnahan, K.E. Starling, J. Chem. Phys. 51, 635 (1969)."""
    return (1 - phi) ** 4 / ((1 + 2 * phi) ** 2 + phi**3 * (phi - 4))


def viscosity(phi):
    """In the first moment; R.A. Lionberger, W.B. Russel, J. Rheol. 41, 399 (1997)."""
    x = phi * (1 + phi - 0.189 * phi**2)
    return (1 + 1.5 * x) / (1 - x)


def images(phi, spheres):
    """What the images of a periodic cell take away from a random suspension, A.J.C. Ladd, J. Chem. Phys. 93, 3484 (1990)."""
    return LATTICE * np.cbrt(phi / spheres) * structure(phi) / viscosity(phi)


def cloud_velocity(spheres, radius, edge):
    """Point forces all over a ball that keep the distance of spheres: alone, and by Faxen's law among its images."""
    r = np.linspace(2, 2 * radius, 2000)
    pairs = r**2 * (1 - 0.75 * r / radius + (r / radius) ** 3 / 16)    # distances in a ball
    alone = 1 + (spheres - 1) * np.trapz(pairs / r, r) / np.trapz(pairs, r)
    return alone, alone - IMAGES * spheres / edge + 0.8 * np.pi * spheres * radius**2 / edge**3


def by_phi(rows, spheres):
    """phi, mean and error of the mean of start and steady."""
    found = []
    for phi in sorted({float(row["phi"]) for row in rows}):
        these = [row for row in rows if float(row["phi"]) == phi and int(row["N"]) == spheres]
        if len(these) < 2:
            continue
        line = [phi]
        for name in ("start", "steady"):
            values = [float(row[name]) for row in these]
            line += [np.mean(values), np.std(values, ddof=1) / np.sqrt(len(values))]
        found.append(line)
    return np.array(found).T


def frames(name):
    """Time step and rows id x y z vx vy vz of each."""
    for text in Path(name).read_text(encoding="ascii").split("ITEM: TIMESTEP\n")[1:]:
        lines = text.splitlines()
        yield int(lines[0]), np.array([line.split() for line in lines[8:]], dtype=float)


def draw_cloud(axes):
    scene = read_scene()
    steady = np.loadtxt("settling.txt")
    radius, edge, n = scene["edge"] / scene["cloud"] / 2, scene["edge"], int(scene["N"])
    alone, lattice = cloud_velocity(n, radius, edge)
    print(f"cloud of {n} spheres, radius {radius:.2f}, cell {edge:.2f}: velocity {scene['start']:.3f}, "
          f"point forces {lattice:.3f}, without images {alone:.3f}")
    pictures = list(frames("particles.dump"))
    middle = pictures[0][1][:, 1:4].mean(axis=0)
    for ax, (step, rows) in zip(axes, pictures):
        fallen = middle[1] - rows[:, 2].mean()
        near = np.argsort(rows[:, 3])
        ax.scatter(rows[near, 1] - middle[0], rows[near, 2] - middle[1] + fallen, s=14, c=rows[near, 3], cmap="Blues_r", edgecolors="0.3",
                   linewidths=0.4)
        ax.set(xlim=(-1.6 * radius, 1.6 * radius), ylim=(-1.7 * radius, 3.4 * radius), aspect="equal", xticks=[], yticks=[])
        ax.set_title(f"fallen by {fallen / radius:.1f} R", fontsize=9)
    left = np.sum(pictures[-1][1][:, 2] > pictures[-1][1][:, 2].mean() + 1.5 * radius)
    print(f"fallen {np.trapz(steady[:, 2], steady[:, 1]) / radius:.2f} R, velocity at the end {steady[-1, 2]:.3f}, left behind {left}")


def draw_suspensions(ax, rows, spheres):
    phi, start, start_error, steady, steady_error = by_phi(rows, spheres)
    more = images(phi, spheres)
    line = np.linspace(1e-4, 0.55, 300)
    ax.plot(line, (1 - line) ** 5, color="0.6", lw=1, label=r"Richardson, Zaki: $(1-\phi)^5$")
    ax.plot(line, (1 - line) ** 4.65, color="0.6", lw=1, ls=":", label=r"$(1-\phi)^{4.65}$")
    ax.plot(line[line < 0.1], 1 - 6.546 * line[line < 0.1], color="k", ls="--", lw=1, label=r"Batchelor: $1-6.55\phi$")
    ax.plot(line, equilibrium(line), color="k", lw=1, label="hard spheres in equilibrium")
    sparse = line[line < 0.25]
    ax.plot(sparse, cubic(sparse), color="#1f4e79", ls="-.", lw=1, label="simple cubic array")
    ax.errorbar(phi, start + more, start_error, fmt="o", ms=5, color="#b45f06", label="start, in an infinite cell")
    ax.plot(phi, start, "o", ms=3, mfc="none", color="#b45f06", label=f"start, as it is with {spheres} spheres")
    ax.errorbar(phi, steady + more, steady_error, fmt="s", ms=4, color="#6aa84f", label="later, in an infinite cell")
    ax.set(xlabel="volume fraction", ylabel="settling velocity over that of one sphere", xlim=(0, 0.52), ylim=(0.008, 1.05), yscale="log")
    ax.set_yticks([0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1], ["0.01", "0.02", "0.05", "0.1", "0.2", "0.5", "1"])
    ax.minorticks_off()
    ax.legend(fontsize=8, frameon=False, loc="lower left")
    for values in zip(phi, start, start + more, start_error, steady + more, steady_error, equilibrium(phi), (1 - phi) ** 5):
        print("phi {:.2f}: {:.4f}, without images {:.4f} +- {:.4f}; later {:.4f} +- {:.4f}; equilibrium {:.4f}, Richardson, Zaki {:.4f}"
              .format(*values))


def draw_sizes(ax, rows, phi=0.1):
    sizes = sorted({int(row["N"]) for row in rows if float(row["phi"]) == phi})
    found = []
    for size in sizes:
        values = [float(row["start"]) for row in rows if float(row["phi"]) == phi and int(row["N"]) == size]
        found.append((size, np.mean(values), np.std(values, ddof=1) / np.sqrt(len(values))))
    found = np.array(found).T
    weights = 1 / found[2] ** 2
    limit = np.sum(weights * (found[1] + images(phi, found[0]))) / np.sum(weights)
    line = np.linspace(1e-3, 1.05 * np.max(found[0] ** (-1 / 3)), 50)
    ax.errorbar(found[0] ** (-1 / 3), found[1], found[2], fmt="o", ms=4, color="#b45f06")
    ax.plot(line, limit - images(phi, line ** -3), color="k", lw=1, label="images, by theory")
    ax.set(xlabel=r"(number of spheres in the cell)$^{-1/3}$", xlim=(0, None), ylabel=rf"settling velocity, start, $\phi = {phi}$")
    ax.legend(fontsize=8, frameon=False)
    print(f"phi {phi}: without images {limit:.4f}; " + ", ".join(f"N {n:.0f} {v:.4f} +- {e:.4f}" for n, v, e in found.T))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--no-cloud", action="store_true")
    parser.add_argument("--table", type=Path, default=HERE / "study.csv")
    parser.add_argument("--spheres", type=int, default=200)
    args = parser.parse_args()
    rows = list(csv.DictReader(args.table.open(encoding="ascii")))
    fig = plt.figure(figsize=(12, 7.5))
    above, below = fig.add_gridspec(2, 1, height_ratios=(1, 1.15), hspace=0.2)
    if not args.no_cloud:
        draw_cloud(above.subgridspec(1, 4).subplots())
    axes = below.subgridspec(1, 2, wspace=0.25).subplots()
    draw_suspensions(axes[0], rows, args.spheres)
    draw_sizes(axes[1], rows)
    fig.savefig("figure.png", dpi=120, bbox_inches="tight")
    print("wrote figure.png")


if __name__ == "__main__":
    main()
