"""Transients of a layer of grains in a fluid, from what in.pore_transient writes (run.sh), beside a model of one dimension.

Cases in runs/ replace those of transient.csv and profiles.csv; figure.png and the numbers are drawn from these tables.
"""
import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import FuncFormatter

sys.path[:0] = [str(Path(__file__).resolve().parents[2] / "tools"), str(Path(__file__).resolve().parent)]
import model
import steady

COLUMNS = ("strain", "phi", "pore_low", "pore_mean", "solid_low", "shear_low", "shear_up")
NAMES = ("f_cell[1]", "f_cell[6]", "v_pore_low", "v_pore_mean", "v_solid_low", "v_shear_low", "v_shear_up")
KINDS = ("fast", "slow", "loose")
TITLES = ("dense start, Iv = 0.1", "dense start, Iv = 0.01", "loose start, Iv = 0.01")
STYLES = {"off": ("0.55", "pressure exerts no force"), "100": ("#1f4e79", "permeability x 100"), "100_2H": ("#6fa8dc", "the same, twice as high"),
          "1": ("#b45f06", "permeability of the packing"), "1_2H": ("#f0b27a", "the same, twice as high")}
PROFILE_AT = 0.5    # strain
PLAIN = FuncFormatter(lambda value, _: f"{value:g}" if f"{value:.0e}"[0] in "125" else "")


def read_scene(name):
    words = Path(name).read_text(encoding="ascii").split()
    return dict(zip(words[::2], map(float, words[1::2])))


def thin(data):
    """Means over 0.02 of strain up to 0.5, then over 0.1."""
    strain = data["f_cell[1]"]
    edges = np.append(np.arange(0, 0.499, 0.02), np.arange(0.5, strain[-1] + 1e-3, 0.1))
    for low, high in zip(edges[:-1], edges[1:]):
        inside = (strain > low) & (strain <= high)
        if inside.any():
            yield [data[name][inside].mean() for name in NAMES]


def profile(name, scene, data):
    """y/H and vx/V in rows, means over the frame that ends at PROFILE_AT."""
    steps, gaps = data["TimeStep"], data["f_cell[3]"]
    frames, lines = {}, [line.split() for line in Path(name).read_text(encoding="ascii").splitlines() if line[0] != "#"]
    while lines:
        step, count = int(lines[0][0]), int(lines[0][1])
        frames[step] = np.array(lines[1:count + 1], dtype=float)
        lines = lines[count + 1:]
    step = min(frames, key=lambda s: abs(s * scene["dt"] * scene["rate"] - PROFILE_AT))
    rows, gap = frames[step], np.interp(step, steps, gaps)
    rows = rows[(rows[:, 2] > 3) & (rows[:, 1] > 0) & (rows[:, 1] < gap)]
    return rows[:, 1] / gap, rows[:, 3] / (scene["rate"] * gap)


def collect():
    """Puts the runs into the two tables."""
    tables = {"transient.csv": (("case", "iv", "factor", "height", "phi0", *COLUMNS), {}), "profiles.csv": (("case", "y_over_H", "vx_over_V"), {})}
    for name, (_, cases) in tables.items():
        if Path(name).exists():
            with open(name, encoding="ascii", newline="") as file:
                for row in list(csv.reader(file))[1:]:
                    cases.setdefault(row[0], []).append(row[1:])
    for path in sorted(Path("runs").glob("*.txt")):
        scene, data = read_scene(f"{path}.scene"), steady.read_ave_time(path)
        height = scene["gap"] / scene["radius"]
        head = [f"{scene['iv']:g}", f"{scene['factor']:g}", f"{height:.3f}", f"{scene['phi']:.4f}"]
        tables["transient.csv"][1][path.stem] = [head + [f"{v:.4g}" for v in row] for row in thin(data)]
        tables["profiles.csv"][1][path.stem] = [[f"{v:.4f}" for v in row] for row in zip(*profile(f"{path}.profile", scene, data))]
    for name, (header, cases) in tables.items():
        with open(name, "w", encoding="ascii", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(header)
            writer.writerows([case, *row] for case in sorted(cases) for row in cases[case])
    numbers = {case: np.array(rows, dtype=float).T for case, rows in tables["transient.csv"][1].items()}
    return ({case: dict(zip(("iv", "factor", "height", "phi0", *COLUMNS), rows)) for case, rows in numbers.items()},
            {case: np.array(rows, dtype=float).T for case, rows in tables["profiles.csv"][1].items()})


def last(case):
    """Mean volume fraction and shear stress of the last third."""
    late = case["strain"] > case["strain"][-1] * 2 / 3
    return case["phi"][late].mean(), case["shear_low"][late].mean()


def predict(case, steady_phi, shared):
    """The model from a start as far from its steady flow as that of the run: strain, pore_low, shear_low, phi (shifted)."""
    iv = case["iv"][0]
    shift = steady_phi - model.phi_equal(iv)
    strain, p, tau, phi = model.layer(case["phi0"][0] - shift, iv, case["height"][0], case["factor"][0], case["strain"][-1], shared)
    return strain, p, tau, phi + shift


def half(strain, phi, start, end):
    """Strain at which half of the way is over."""
    over = (phi - end) / (start - end) < 0.5
    return strain[np.argmax(over)] if over.any() else np.nan


def numbers(name, strain, p, tau, phi, start, end):
    worst = np.argmax(np.abs(p))
    middle = p[(strain > 0.5) & (strain <= 1.5)]
    at = (np.interp(0.1, strain, p), middle.mean() if len(middle) else np.nan)
    print(f"{name:22s} {at[0]:8.2f} {at[1]:8.2f} {p[worst]:8.2f} at {strain[worst]:5.2f} {half(strain, phi, start, end):6.2f} "
          f"{tau.max():7.2f} {tau.min():7.2f} {np.mean(tau[strain > strain[-1] * 2 / 3]):7.2f} {phi[-1]:7.3f}")


def draw(cases, profiles):
    fig, axes = plt.subplots(3, 4, figsize=(13.5, 9), sharex=False)
    for column, kind in enumerate(KINDS):
        for style, (color, label) in STYLES.items():
            name = f"{kind}_{style}"
            if name not in cases:
                continue
            case, off = cases[name], cases.get(f"{kind}_off", cases[name])
            lines = {"color": color, "label": label}
            axes[0, column].plot(case["strain"], case["shear_low"], lw=1.3, **lines)
            axes[1, column].plot(case["strain"], case["pore_low"] if style != "off" else 0 * case["strain"], lw=1.3, **lines)
            axes[2, column].plot(case["strain"], case["phi"], lw=1.3, **lines)
            k = case["factor"][0] * model.kozeny(case["phi0"][0])
            print(f"\n{name}: Iv {case['iv'][0]:g}, H {case['height'][0]:.1f} radii, start at {case['phi0'][0]:.4f}, "
                  f"Pi {case['iv'][0] * case['height'][0] ** 2 / k:.3g}")
            ends = (case["phi0"][0], last(off)[0])
            print(f"{'':22s} {'p(.1)/P':>8s} {'p(~1)/P':>8s} {'largest':>8s} {'':8s} {'half':>6s} {'max':>7s} {'min':>7s} {'end':>7s} {'phi':>7s}")
            numbers("run", case["strain"], case["pore_low"], case["shear_low"], case["phi"], *ends)
            if style != "off":
                for shared in ("stress", "rate"):
                    strain, p, tau, phi = predict(case, ends[1], shared)
                    numbers(f"model, the same {shared}", strain, p, tau, phi, *ends)
                    if shared == "stress":
                        for row, values in enumerate((tau, p, phi)):
                            axes[row, column].plot(strain, values, color=color, ls="--", lw=0.8)
            if name in profiles:
                axes[column, 3].plot(profiles[name][1], profiles[name][0], "o-", ms=3, lw=1, **lines)
        axes[0, column].set(title=TITLES[column], yscale="log", ylabel=r"shear stress below / $P$")
        axes[1, column].set(ylabel=r"pressure of the fluid below / $P$")
        if kind != "loose":
            axes[1, column].set_yscale("symlog", linthresh=1)
        axes[0, column].yaxis.set_major_formatter(PLAIN)
        axes[0, column].yaxis.set_minor_formatter(PLAIN)
        axes[0, column].tick_params(axis="y", which="both", labelsize=8)
        axes[2, column].set(ylabel="volume fraction", xlabel="strain")
        for ax in axes[:, column]:
            ax.set_xlim(left=0)
        axes[column, 3].plot([0, 1], [0, 1], color="0.7", ls=":", lw=1)
        axes[column, 3].set(title=TITLES[column], xlabel=f"velocity / V at strain {PROFILE_AT:g}", ylabel="y / H", xlim=(0, 1), ylim=(0, 1))
    handles = [plt.Line2D([], [], color=color, label=label) for color, label in STYLES.values()]
    fig.legend(handles=[*handles, plt.Line2D([], [], color="0.3", ls="--", lw=0.8, label="model.py")], loc="upper center", ncol=6,
               fontsize=9, frameon=False)
    fig.tight_layout(rect=(0, 0, 1, 0.97))
    fig.savefig("figure.png", dpi=110)
    print("wrote transient.csv, profiles.csv, figure.png")


if __name__ == "__main__":
    draw(*collect())
