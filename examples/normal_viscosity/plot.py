"""Normal viscosities of a sheared suspension by origin, which directions carry them, and laws, from the files of in.normal_viscosity.

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
import normal_viscosity    # tools/, which rheology adds to the path

ORIGINS = ("contact_n", "contact_t", "film_n", "film_t")
COMPONENTS = ("xx", "yy", "zz")
# W. Chevremont, thesis, Grenoble (2020), table 3.1: total, and the parts in the order of ORIGINS; + is tension
SIGNS = {"xx": "-----", "yy": "---++", "zz": "--+++"}
BAND = 2 * 0.3    # of the cut: what a density per radian has to be divided by to be one per steradian


def read_scene():
    words = Path("scene.txt").read_text(encoding="ascii").split()
    return dict(zip(words[::2], map(float, words[1::2])))


def signed(mean, error, sign):
    """Number with its error; whether it has the sign that is expected: yes, no, or within twice the error of 0."""
    if not abs(mean) > 2 * error:
        return f"{mean:+8.3f} +- {error:.3f} (0?)"
    return f"{mean:+8.3f} +- {error:.3f} ({'yes' if (mean > 0) == (sign == '+') else 'NO'})"


def report(stress):
    """Table 3.1 as numbers."""
    print("stress over viscosity*rate, + is tension; in brackets: sign as in the thesis?")
    print("    " + "".join(f"{name:>26s}" for name in ("total", *ORIGINS)))
    for c in COMPONENTS:
        names = ["s" + c] + [f"{origin}_{c}" for origin in ORIGINS]
        print(f"{c}  " + "".join(f"{signed(*rheology.estimate(stress[name]), sign):>26s}" for name, sign in zip(names, SIGNS[c])))
    eta = {i: -stress["s" + c].mean() for i, c in enumerate(COMPONENTS, 1)}
    print("normal viscosities: " + "  ".join(f"eta_{i}{i} {value:.2f}" for i, value in eta.items()))
    for i, c in ((1, "xx"), (3, "zz")):
        found = rheology.ratio(stress["s" + c], stress["syy"])
        print(f"lambda_{i}{i} {found[0]:.3f} +- {found[1]:.3f}")
    return eta


def draw_parts(ax, stress, origins, **limits):
    """Bars by component, each part in the color that it has in the other examples."""
    scale, width = -stress["syy"].mean(), 0.8 / len(origins)
    for n, origin in enumerate(origins):
        label, color = rheology.PARTS["v_" + origin]
        places = np.arange(3) + width * (n - 0.5 * (len(origins) - 1))
        means, errors = np.array([rheology.estimate(stress[f"{origin}_{c}"] / scale) for c in COMPONENTS]).T
        ax.bar(places, means, width, yerr=np.nan_to_num(errors), color=color, label=label, error_kw={"lw": 0.8})
    ax.axhline(0, color="k", lw=0.6)
    ax.set(xticks=range(3), xticklabels=[rf"$\sigma_{{{c}}}$" for c in COMPONENTS], ylabel=r"part over $|\sigma_{yy}|$ (+: tension)", **limits)
    ax.legend(frameon=False, fontsize=7, loc="lower right")


def draw_laws(ax, phi, friction, eta):
    jam = rheology.phi_m_chevremont(friction)
    x = np.linspace(0.25, 0.98 * jam, 300)
    for name, color, line, label in (("boyer_22", "0.6", "-", "Boyer 22"), ("boyer_33", "0.6", "--", "Boyer 33"),
                                     ("zarraga_22", "#b45f06", "-", "Zarraga 22"), ("zarraga_33", "#b45f06", "--", "Zarraga 33"),
                                     ("chevremont_22", "k", "-", "Chevremont 22, eq. 9"),
                                     ("chevremont_22_exponential", "k", ":", "22, eq. 11"),
                                     ("chevremont_33", "k", "--", "33, eqs. 8, 9")):
        own = jam if name.startswith("chevremont") else None
        ax.plot(x, normal_viscosity.named(name, own).eta(x), color=color, ls=line, lw=1, label=label)
    for i, marker in ((1, "^"), (2, "o"), (3, "s")):
        ax.plot(phi, eta[i], marker, color="#c00000", label=rf"$\eta_{{{i}{i}}}$ of this run")
    ax.set(yscale="log", xlabel=r"$\phi$", ylabel=r"$\eta_{ii}$", xlim=(0.25, jam), ylim=(0.03, 3e3))
    ax.legend(frameon=False, fontsize=6.5, ncol=2)


def read_angles():
    """Angles, and the four parts of xx and of yy in each direction of the cut."""
    rows = np.loadtxt("angles.txt", skiprows=4)[:, 1:]
    half = rows.shape[1] // 2
    return rows[:, 0], {"xx": rows[:, 9:13].T, "yy": rows[:, half + 9:half + 13].T}


def draw_cut(ax, angle, cut, origin, scale):
    """One part of xx and of yy over the direction of the pair: thin where it is compression, thick where tension."""
    around = np.concatenate([angle, angle + np.pi, angle[:1]])
    for component, color in (("xx", "#1f4e79"), ("yy", "#c00000")):
        part = cut[component][ORIGINS.index(origin)] / (BAND * scale)
        ring = np.concatenate([part, part, part[:1]])
        ax.plot(around, np.where(ring < 0, -ring, np.nan), color=color, lw=1, label=rf"$\sigma_{{{component}}}$")
        ax.plot(around, np.where(ring > 0, ring, np.nan), color=color, lw=2.5)
    ax.set_title(rheology.PARTS["v_" + origin][0] + r", over $|\sigma_{yy}|$", fontsize=8)
    ax.tick_params(labelsize=6)
    ax.yaxis.set_major_locator(plt.MaxNLocator(3))


def report_cut(angle, cut):
    print("pairs near the shear plane, angles from the flow towards its gradient in degrees")
    for component, parts in cut.items():
        for origin, part in zip(ORIGINS, parts):
            print(f"  {component} {origin:10s} sum {part.mean() * 2 * np.pi:+8.3f}, most negative {part.min():+7.3f} at "
                  f"{np.degrees(angle[part.argmin()]):3.0f}, most positive {part.max():+7.3f} at {np.degrees(angle[part.argmax()]):3.0f}")


def main():
    scene = read_scene()
    data = rheology.read_run()
    kept = data["v_gamma"] >= scene["transient"]
    stress = {name[2:]: column[kept] for name, column in data.items() if name.startswith("v_")}
    print(f"phi {scene['phi']:g}, friction {scene['friction']:g}, strain {scene['transient']:g} to {data['v_gamma'][-1]:.1f}")
    eta = report(stress)

    cuts = Path("angles.txt").exists()
    fig = plt.figure(figsize=(11.5, 6.8 if cuts else 3.6))
    grid = fig.add_gridspec(2 if cuts else 1, 12)
    draw_parts(fig.add_subplot(grid[0, :3]), stress, ORIGINS[:1])
    draw_parts(fig.add_subplot(grid[0, 3:7]), stress, ORIGINS[1:])
    draw_laws(fig.add_subplot(grid[0, 7:]), scene["phi"], scene["friction"], eta)
    if cuts:
        angle, cut = read_angles()
        report_cut(angle, cut)
        for n, origin in enumerate(ORIGINS):
            ax = fig.add_subplot(grid[1, 3 * n:3 * n + 3], projection="polar")
            draw_cut(ax, angle, cut, origin, eta[2])
        ax.legend(frameon=False, fontsize=7, loc="lower left", bbox_to_anchor=(-0.25, -0.2))
    fig.tight_layout()
    fig.savefig("figure.png", dpi=130)
    print("wrote figure.png")


if __name__ == "__main__":
    main()
