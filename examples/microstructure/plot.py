"""Contact numbers, forces and what points where, with the figures, from the files of in.microstructure.

usage: tools/python.sh plot.py
"""
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "scene"))
import rheology
from rheology import steady

COLUMNS = ("pairs", "contacts", "frictional", "gap", "force", "friction", "vn", "vt", "contact_n", "contact_t",
           "film_n", "film_t")    # after the angles
VELOCITY = 2.0    # 2 a rate: mean radius 1, rate 1
STRESSES = COLUMNS[-4:]
NUMBERS = {1: "Z", 2: "Z of carriers", 3: "rattlers", 5: "chi_f", 6: "sliding", 7: "films per particle",
           8: "gap of films", 9: "smallest gap", 10: "<f>", 11: "largest f", 12: "<f_t>", 13: "mobilized friction"}
BAND = 2 * 0.3    # of the cut: what a density per radian has to be divided by to be one per steradian
BLUE, RED, DARK, LIGHT = "#1f4e79", "#c00000", "#b45f06", "#f6b26b"


def read_table(name, angles):
    """The only block of a file of fix ave/time mode vector: angles and a dict of columns."""
    rows = np.loadtxt(name, skiprows=4)[:, 1:]
    return rows[:, :angles], dict(zip(COLUMNS, rows[:, angles:].T))


def per_pair(table, name, of="pairs"):
    """Mean of a quantity in each direction."""
    return np.divide(table[name], table[of], out=np.zeros_like(table[name]), where=table[of] > 0)


def degrees(angle):
    return f"{np.degrees(angle):.0f}"


def main_direction(angle, values):
    """Axis of the second harmonic of values."""
    return 0.5 * np.angle(np.sum(values * np.exp(2j * angle))) % np.pi


def share_in_compression(angle, values):
    return values[angle > np.pi / 2].sum() / values.sum()


def zeros(angle, values):
    """Where values change sign, around the circle of pi."""
    following = np.roll(values, -1)
    at = np.flatnonzero(values * following < 0)
    width = angle[1] - angle[0]
    return np.sort((angle[at] + width * values[at] / (values[at] - following[at])) % np.pi)


def report_numbers(data, start):
    kept = data["v_gamma"] >= start
    print(f"averages from strain {start:g} to {data['v_gamma'][-1]:.1f}; forces over viscosity*rate*radius^2")
    for m, name in NUMBERS.items():
        mean, error = rheology.estimate(data[f"c_number[{m}]"][kept])
        print(f"  {name:20s} {mean:9.4g} +- {error:.2g}")
    for name in ("fabric_xx", "fabric_yy", "fabric_zz", "fabric_xy", "film_xy", "force_xy", "friction_xy"):
        mean, error = rheology.estimate(data["v_" + name][kept])
        print(f"  {name:20s} {mean:9.4f} +- {error:.2g}")


def report_directions(angle, circle, cut, parts):
    print("in the shear plane, angles from the flow towards its gradient in degrees")
    print(f"  contacts in the quadrants of compression: {share_in_compression(angle, circle['contacts']):.3f}")
    p = cut["contacts"] / BAND
    print(f"  contacts per particle and steradian in the cut: largest {p.max():.3f} at {degrees(angle[np.argmax(p)])}, "
          f"mean {p.mean():.3f}, in the middle of extension {p[np.abs(angle - np.pi / 4) < 0.3].mean():.4f}")
    gap = per_pair(cut, "gap")
    print(f"  mean gap: largest {gap.max():.4f} at {degrees(angle[np.argmax(gap)])}, smallest {gap.min():.4f} at "
          f"{degrees(angle[np.argmin(gap)])}")
    vn = per_pair(cut, "vn") / VELOCITY
    print(f"  normal velocity/(2 a rate): {vn.max():.3f} at {degrees(angle[np.argmax(vn)])}, {vn.min():.3f} at "
          f"{degrees(angle[np.argmin(vn)])}, changes sign at {', '.join(degrees(a) for a in zeros(angle, vn))}")
    vt = per_pair(cut, "vt") / VELOCITY
    print(f"  tangential velocity/(2 a rate): largest {vt.max():.3f} at {degrees(angle[np.argmax(vt)])}, smallest "
          f"{vt.min():.3f} at {degrees(angle[np.argmin(vt)])}")
    for name, whole in zip(STRESSES, parts):
        part = circle[name]
        total, width = part.sum() * 2 * np.pi / len(part), np.abs(part).sum()
        print(f"  stress yx {name:10s} {total:7.3f} (stress/partition {whole:7.3f}), axis "
              f"{degrees(main_direction(angle, part))}, peak {degrees(angle[np.argmax(part)])}, in compression "
              f"{share_in_compression(angle, part):.2f}, negative part {-part[part < 0].sum() / width:.3f}")


def polar(ax, angle, values, color=BLUE, negative=RED, **options):
    """A closed curve; where values are negative their size, in another color."""
    around = np.concatenate([angle, angle + np.pi, angle[:1]])
    ring = np.concatenate([values, values, values[:1]])
    ax.plot(around, np.where(ring >= 0, ring, np.nan), color=color, **options)
    if (ring < 0).any():
        options.pop("label", None)
        ax.plot(around, np.where(ring < 0, -ring, np.nan), color=negative, **options)


def draw_polar(angle, cut, cutxy, pressure):
    fig, axes = plt.subplots(2, 3, figsize=(11, 7.6), subplot_kw={"projection": "polar"})
    ax = axes[0, 0]
    polar(ax, angle, cut["contacts"] / BAND, lw=2)
    ax.set_title("contacts per particle and steradian")
    ax = axes[0, 1]
    polar(ax, angle, per_pair(cut, "gap"), lw=2)
    ax.set_title("mean gap / a")
    ax = axes[0, 2]
    polar(ax, angle, per_pair(cut, "vt") / VELOCITY, color=LIGHT, lw=1.5, label="tangential")
    polar(ax, angle, per_pair(cut, "vn") / VELOCITY, lw=2, label="normal (red: approach)")
    ax.set_title(r"relative velocity / ($2a\dot\gamma$)")
    for ax, origin, name in ((axes[1, 0], "contact", "contact"), (axes[1, 1], "film", "lubrication")):
        n, t = (cut[f"{origin}_{m}"] / (BAND * pressure) for m in "nt")
        polar(ax, angle, n, lw=1, label="normal")
        polar(ax, angle, t, color=DARK, negative="#ff7f0e", lw=1, label="tangential")
        polar(ax, angle, n + t, color="k", lw=2, label="both")
        ax.set_title(rf"{name} part of $\sigma_{{yx}}/|\sigma_{{yy}}|$ per steradian (red: negative)")
    ax = axes[1, 2]
    for part, color, negative, label in (("contact_t", BLUE, RED, "contact"),
                                         ("film_t", DARK, "#ff7f0e", "lubrication")):
        polar(ax, angle, cutxy[part] / (BAND * pressure), color=color, negative=negative, lw=2, label=label)
    ax.set_title(r"tangential parts of $\sigma_{xy}/|\sigma_{yy}|$ per steradian")
    for ax in axes.flat:
        ax.tick_params(labelsize=7)
        ax.title.set_fontsize(9)
        if ax.get_legend_handles_labels()[0]:
            ax.legend(fontsize=7, loc="lower left", bbox_to_anchor=(-0.22, -0.16), frameon=False)
    fig.tight_layout()
    fig.savefig("figure.png", dpi=130)


def draw_forces(ax, forces):
    x, normal, friction = forces
    ax.semilogy(x[normal > 0], normal[normal > 0], color=BLUE, lw=2, label=r"normal, $f/\langle f\rangle$")
    ax.semilogy(x[friction > 0], friction[friction > 0], color=DARK, lw=2, label=r"friction, $f_t/\langle f_t\rangle$")
    tail = (x > 2) & (normal > 0)
    slope = np.polyfit(x[tail], np.log(normal[tail]), 1)
    ax.semilogy(x[x > 1.5], np.exp(np.polyval(slope, x[x > 1.5])), "k--", lw=1, label=f"exp({slope[0]:.2f} x)")
    ax.set(xlabel="contact force over its mean", ylabel="probability density")
    ax.legend(frameon=False, fontsize=8)
    print(f"  tail of P(f/<f>) beyond 2: exp({slope[0]:.2f} x)")


def draw_fabric(ax, data, start):
    strain = data["v_gamma"]
    for name, label, color in (("fabric_xy", "contacts", BLUE), ("force_xy", "normal force", RED),
                               ("friction_xy", "friction", DARK), ("film_xy", "films", "0.5")):
        ax.plot(strain, data["v_" + name], color=color, label=label, lw=1.2)
    ax.axvline(start, color="k", lw=0.6, ls=":")
    ax.axhline(0, color="k", lw=0.6)
    ax.set(xlabel="strain", ylabel="fabric, $xy$", xlim=(0, strain[-1]))
    ax.legend(frameon=False, fontsize=8, ncol=2)


def draw_map(ax, angles, values, title, center=False):
    """Equal-area map: azimuth against the component along the vorticity, the other half by symmetry."""
    heights = len(np.unique(angles[:, 0]))
    half = values.reshape(heights, -1)
    whole = np.hstack([half, half[::-1]])
    size = np.abs(whole).max()
    limits = {"vmin": -size, "vmax": size, "cmap": "RdBu"} if center else {"vmin": 0, "cmap": "viridis"}
    picture = ax.imshow(whole, origin="lower", extent=(0, 360, -1, 1), aspect="auto", **limits)
    ax.set(xlabel="azimuth (0: flow, 90: gradient)", ylabel="$n_z$", title=title, xticks=range(0, 361, 45))
    ax.title.set_fontsize(9)
    ax.figure.colorbar(picture, ax=ax)


def main():
    words = Path("scene.txt").read_text(encoding="ascii").split()
    scene = dict(zip(words[::2], map(float, words[1::2])))
    start = scene["transient"]
    data = steady.read_ave_time("contacts.txt")
    kept = {name: column[column.shape[0] - np.sum(data["v_gamma"] > start):]
            for name, column in steady.read_ave_time("stress.txt").items()}
    stress = {name: column.mean() for name, column in kept.items()}
    pressure = -stress["v_syy"] * scene["pressure"]
    angle, circle = read_table("circle.txt", 1)
    cut = read_table("cut.txt", 1)[1]
    angle = angle[:, 0]
    report_numbers(data, start)
    report_directions(angle, circle, cut, np.loadtxt("yx.txt", skiprows=4)[:4, 1])

    draw_polar(angle, cut, read_table("cutxy.txt", 1)[1], pressure)
    fig, axes = plt.subplots(2, 2, figsize=(10.5, 7.4))
    draw_forces(axes[0, 0], np.loadtxt("forces.txt", skiprows=4)[:, 1:].T)
    draw_fabric(axes[0, 1], data, start)
    angles, sphere = read_table("sphere.txt", 2)
    draw_map(axes[1, 0], angles, sphere["contacts"], "contacts per particle and steradian")
    draw_map(axes[1, 1], angles, sum(sphere[p] for p in STRESSES) / pressure,
             r"$\sigma_{yx}/|\sigma_{yy}|$ per steradian", center=True)
    fig.tight_layout()
    fig.savefig("distributions.png", dpi=130)
    print("wrote figure.png, distributions.png")


if __name__ == "__main__":
    main()
