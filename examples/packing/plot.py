"""Pictures of the two packings of run.sh, and the distribution of their gaps."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from scipy.spatial import cKDTree


def read(name):
    """Positions, radii and box of a text dump."""
    lines = open(name, encoding="ascii").read().splitlines()
    box = np.array([line.split() for line in lines[5:8]], dtype=float)
    rows = np.array([line.split() for line in lines[9:]], dtype=float)
    return rows[:, 1:4] - box[:, 0], rows[:, 4], box[:, 1] - box[:, 0]


def gaps(x, radius, box):
    """Surface gaps of near pairs over the effective radius, through the periodic boundaries."""
    tree = cKDTree(np.mod(x, box), boxsize=box)
    i, j = tree.query_pairs(2 * radius.max() + 0.5, output_type="ndarray").T
    r = x[i] - x[j]
    r -= box * np.round(r / box)
    return (np.linalg.norm(r, axis=1) - radius[i] - radius[j]) * (radius[i] + radius[j]) / (2 * radius[i] * radius[j])


fig, axes = plt.subplots(1, 3, figsize=(11, 3.7))
for ax, name, dim in zip(axes, ("spheres", "discs"), (3, 2)):
    x, radius, box = read(f"{name}.dump")
    solid = np.sum(4 / 3 * np.pi * radius**3) if dim == 3 else np.sum(np.pi * radius**2)
    ax.imshow(plt.imread(f"{name}.ppm"))
    ax.set_axis_off()
    ax.set_title(rf"{len(radius)} {name}, $\phi$ = {solid / box[:dim].prod():.2f}", fontsize=10)
    gap = gaps(x[:, :dim], radius, box[:dim])
    print(f"{name}: smallest gap {gap.min():.1e}, pairs closer than 1e-3: {np.count_nonzero(gap < 1e-3) / len(radius):.2f} a particle")
    gap = np.sort(np.maximum(gap, 1e-7))
    axes[2].plot(gap, np.arange(1, len(gap) + 1) / len(radius), label=name)
axes[2].set(xscale="log", xlim=(1e-7, 0.5), xlabel="gap over effective radius", ylabel="pairs a particle, closer than")
axes[2].set_ylim(0, 6)
axes[2].legend(frameon=False)
fig.tight_layout()
fig.savefig("figure.png", dpi=150)
print("wrote figure.png")
