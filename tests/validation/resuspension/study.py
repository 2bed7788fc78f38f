"""Sheared layers under gravity: runs examples/resuspension/in.resuspension for each case, then judges results.csv and profiles.csv.

usage: tools/python.sh study.py [--jobs 1] [CASES ...]     without arguments: judge what the two tables hold
A run that has ended is in runs/; its rows replace those of the tables.
"""
import argparse
import csv
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
EXAMPLE = ROOT / "examples" / "resuspension"
sys.path[:0] = [str(EXAMPLE), str(ROOT / "tools")]
import balance    # noqa: E402  pylint: disable=wrong-import-position
import normal_viscosity    # noqa: E402  pylint: disable=wrong-import-position
import resuspension    # noqa: E402  pylint: disable=wrong-import-position

# arguments of the deck; the inertia is that of the steady part
COMMON = {"N": 800}
CASES = {
    "v0.2": {"shields": 0.2, "inertia": 0.1, "rise": 7, "strain": 8},
    "v2": {"shields": 2, "inertia": 0.05, "haste": 0.2, "rise": 9, "strain": 9, "interval": 1},
    "v20": {"shields": 20, "inertia": 0.1, "rise": 16, "strain": 8},
    "g2": {"shields": 2, "inertia": 0.1, "rise": 9, "strain": 8, "direction": "gradient"},
    "v2 I 1": {"shields": 2, "inertia": 1, "haste": 1, "rise": 6, "strain": 14},
    "v20 I 1": {"shields": 20, "inertia": 1, "haste": 1, "rise": 17, "strain": 25},
    "v20 I 4": {"shields": 20, "inertia": 4, "haste": 4, "rise": 17, "strain": 25},
    "v2 loose": {"shields": 2, "inertia": 0.4, "rise": 8, "strain": 10, "phi": 0.3},
}
COMPONENT = {"vorticity": "33", "gradient": "22"}
AXIS = {"vorticity": "zz", "gradient": "yy"}


def run(name):
    out = HERE / "runs" / name.replace(" ", "_")
    if not out.with_suffix(".done").exists():
        words = [word for key, value in {**COMMON, **CASES[name]}.items() for word in ("-var", key, str(value))]
        subprocess.run([str(ROOT / "tools" / "lmp.sh"), "-in", "in.resuspension", "-log", "none", "-screen", f"{out}.log",
                        "-var", "out", str(out), *words], cwd=EXAMPLE, check=True)
        out.with_suffix(".done").touch()
        print(f"{name}: done", flush=True)


def collect():
    """Tables of all cases, from runs/ where they are there."""
    results, profiles = {}, {}
    for table, kept in (("results.csv", results), ("profiles.csv", profiles)):
        if (HERE / table).exists():
            with open(HERE / table, newline="", encoding="ascii") as file:
                for row in csv.DictReader(file):
                    kept.setdefault(row["run"], []).append(list(row.values()))
    names = []
    for name in CASES:
        out = HERE / "runs" / name.replace(" ", "_")
        if Path(f"{out}.profile").exists():
            layer = resuspension.Run(out)
            start = layer.start()
            row = {"run": name, **resuspension.result(layer, start)}
            names = list(row)
            results[name] = [list(row.values())]
            profiles[name] = list(resuspension.rows_of(name, layer, start))
    if names:
        resuspension.write_csv(HERE / "results.csv", names, [row for name in CASES for row in results.get(name, [])])
        resuspension.write_csv(HERE / "profiles.csv", resuspension.COLUMNS, [row for name in CASES for row in profiles.get(name, [])])


def bulk(profile):
    return resuspension.is_bulk(profile["z"], profile["phi"])


def judge():
    with open(HERE / "results.csv", newline="", encoding="ascii") as file:
        rows = {row["run"]: row for row in csv.DictReader(file)}
    profiles = resuspension.read_profiles(HERE / "profiles.csv")
    own = {direction: normal_viscosity.table("own", *resuspension.homogeneous(AXIS[direction])) for direction in AXIS}
    print("| run | A | (h - h0)/h0 | own law | Chevremont | phi near the floor | own law | drag, % of the weight | stress over load, rms of layers (over its error) | films | eta over own | rate |")
    print("|---|---|---|---|---|---|---|---|---|---|---|---|")
    for name, row in rows.items():
        direction, p = row["direction"], profiles[name]
        inside, a, sh = bulk(p), float(row["acrivos"]), float(row["shields"])
        law, named = own[direction], normal_viscosity.named(f"chevremont_{COMPONENT[direction]}")
        model = balance.profile(law, sh, float(row["column"]))
        low = (model.z > 2) & (model.z < 8)
        stress = sum(p[part] for part in resuspension.ORIGINS)[inside].sum()
        films = (p["film_n"] + p["film_t"])[inside].sum()
        eta = (p["load"] / p["rate"])[inside]
        ratio = np.exp(np.mean(np.log(eta / law.eta(p["phi"][inside])))) if np.all(eta > 0) else np.nan
        cells = [name, f"{a:.3g}", f"{float(row['growth']):.3f} +- {float(row['growth_error']):.3f}",
                 f"{balance.height(law, a, resuspension.PHI_REST) - 1:.3f}", f"{balance.height(named, a, resuspension.PHI_REST) - 1:.3f}",
                 f"{float(row['phi_low']):.3f}", f"{model.phi[low].mean():.3f}",
                 f"{100 * float(row['drag']):.1f} +- {100 * float(row['drag_error']):.1f}", f"{stress / p['load'][inside].sum():.3f}, {float(row['imbalance']):.3f} ({float(row['imbalance_errors']):.1f})",
                 f"{films / p['load'][inside].sum():.3f}", f"{ratio:.2f}",
                 f"{p['rate'][inside].mean():.2f}"]
        print("| " + " | ".join(cells) + " |")
    draw(rows, profiles, own)


def draw(rows, profiles, own):
    fig, axes = plt.subplots(1, 3, figsize=(13, 4.6))
    marks = dict(zip(rows, "osDhvP<>X*"))
    for name, row in rows.items():
        p, direction = profiles[name], row["direction"]
        inside = bulk(p)
        shade = {"vorticity": "#1f4e79", "gradient": "#b45f06"}[direction]
        above = p["z"] > resuspension.FLOOR + 2
        axes[0].plot(p["phi"][above], ((resuspension.surface(p["z"], p["phi"]) - p["z"]) / p["shields"])[above], marks[name], ms=3, color=shade, label=name)
        kept = inside.sum() // 3 * 3    # layers of three diameters
        axes[1].plot(*(values[inside][:kept].reshape(-1, 3).mean(axis=1) for values in (p["phi"], p["load"] / p["rate"])), marks[name], ms=4,
                     color=shade)
        axes[2].errorbar(float(row["acrivos"]), float(row["growth"]), float(row["growth_error"]), fmt=marks[name], ms=4, color=shade)
    numbers = np.geomspace(0.015, 4, 40)
    for direction, law in own.items():
        shade, named = {"vorticity": "#1f4e79", "gradient": "#b45f06"}[direction], normal_viscosity.named(f"chevremont_{COMPONENT[direction]}")
        model = balance.profile(law, 0.2, 25.0)
        axes[0].plot(model.phi, (model.height - model.z) / 0.2, "-", lw=1, color=shade)
        phi = np.linspace(0.3, 0.56, 100)
        axes[1].plot(*resuspension.homogeneous(AXIS[direction]), "s", ms=7, mfc="none", color=shade)
        axes[1].plot(phi, law.eta(phi), "-", lw=1, color=shade)
        for model, style in ((law, "-"), (named, "--")):
            axes[2].plot(numbers, [balance.height(model, number, resuspension.PHI_REST) - 1 for number in numbers], style, lw=1, color=shade,
                         label=f"{model.name} {COMPONENT[direction]}" if style == "-" else model.name)
    axes[0].set(xlabel="volume fraction", ylabel="depth / (Sh radius)", yscale="log", ylim=(300, 0.03), xlim=(0, 0.62))
    axes[1].set(xlabel="volume fraction", ylabel="weight above / (viscosity, local rate)", yscale="log", ylim=(0.1, 500), xlim=(0.25, 0.56))
    axes[2].set(xlabel="Acrivos number", ylabel=r"$(h - h_0)/h_0$", xscale="log", yscale="log")
    axes[0].legend(frameon=False, fontsize=8)
    axes[2].legend(frameon=False, fontsize=8)
    fig.tight_layout()
    fig.savefig(HERE / "results.png", dpi=110)
    print("wrote results.png")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cases", nargs="*", metavar="CASE", help="any of: " + ", ".join(CASES) + "; or all")
    parser.add_argument("--jobs", type=int, default=1)
    args = parser.parse_args()
    chosen = list(CASES) if args.cases == ["all"] else args.cases
    unknown = [name for name in chosen if name not in CASES]
    if unknown:
        sys.exit(f"study.py: no case {', '.join(unknown)}; there are {', '.join(CASES)}")
    (HERE / "runs").mkdir(exist_ok=True)
    with ThreadPoolExecutor(args.jobs) as pool:
        list(pool.map(run, chosen))
    collect()
    judge()


if __name__ == "__main__":
    main()
