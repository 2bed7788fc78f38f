"""Profiles of sheared layers beside the suspension balance model, from what in.resuspension writes (run.sh).

Runs in runs/ replace heights.csv and profiles.csv; figure.png and the numbers are drawn from these two.
"""
import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

sys.path[:0] = [str(Path(__file__).resolve().parent), str(Path(__file__).resolve().parents[2] / "tools")]
import balance
import normal_viscosity
import resuspension

COLORS = dict(zip((0.2, 2.0, 20.0), ("#1f4e79", "#6aa84f", "#b45f06")))
PARTS = {"contact_n": ("contact, normal", "#1f4e79"), "contact_t": ("contact, tangential", "#6fa8dc"),
         "film_n": ("film, normal", "#b45f06"), "film_t": ("film, tangential", "#f6b26b")}
LAWS = {"vorticity": ("chevremont_33", "boyer_33", "zarraga_33"), "gradient": ("chevremont_22", "boyer_22", "zarraga_22")}
STYLES = ("-", "--", ":")


def collect():
    """The two tables, from runs/ if there are any."""
    heights, rows = [], []
    for scene in sorted(Path("runs").glob("*.scene")):
        run = resuspension.Run(scene.with_suffix(""))
        start = run.start()
        heights.append({"run": scene.stem, **resuspension.result(run, start)})
        rows += resuspension.rows_of(scene.stem, run, start)
    if heights:
        resuspension.write_csv("heights.csv", list(heights[0]), [row.values() for row in heights])
        resuspension.write_csv("profiles.csv", resuspension.COLUMNS, rows)
    with open("heights.csv", newline="", encoding="ascii") as file:
        return list(csv.DictReader(file)), resuspension.read_profiles("profiles.csv")


def bulk(profile):
    return resuspension.is_bulk(profile["z"], profile["phi"])


def thick(values, rows=3):
    """Means over layers of three diameters."""
    return values[:len(values) // rows * rows].reshape(-1, rows).mean(axis=1)


def laws(direction):
    component = {"vorticity": "zz", "gradient": "yy"}[direction]
    own = normal_viscosity.table("homogeneous shear", *resuspension.homogeneous(component))
    return [own] + [normal_viscosity.named(name) for name in LAWS[direction]]


def color(profile):
    return COLORS.get(profile["shields"][0], "0.4")


def main():
    heights, profiles = collect()
    direction = min((row["direction"] for row in heights), key=list(LAWS).index)
    chosen = {row["run"]: row for row in heights if row["direction"] == direction}
    own, named = laws(direction)[0], laws(direction)[1:]
    fig, axes = plt.subplots(2, 2, figsize=(11, 8.5))

    ax = axes[0, 0]    # profiles
    for name, row in chosen.items():
        p, sh = profiles[name], float(row["shields"])
        above = p["z"] > resuspension.FLOOR + 2
        ax.plot(p["phi"][above], (resuspension.surface(p["z"], p["phi"]) - p["z"][above]) / sh, "o", ms=3, color=color(p), label=f"Sh {sh:g}")
    lowest = min(float(row["shields"]) for row in chosen.values())
    for law, style in zip((own, named[0]), STYLES):
        model = balance.profile(law, lowest, float(heights[0]["column"]))
        ax.plot(model.phi, (model.height - model.z) / lowest, style, color="0.3", lw=1, label=f"model, {law.name}")
    ax.set(xlabel="volume fraction", ylabel="depth / (Sh radius)", yscale="log", xlim=(0, 0.65), ylim=(400, 0.03))
    ax.legend(frameon=False, fontsize=8)

    ax = axes[0, 1]    # who carries the weight
    name = sorted(chosen, key=lambda run: abs(np.log(float(chosen[run]["shields"]) / 2)))[0]
    p = profiles[name]
    bottom = np.zeros_like(p["z"])
    for part, (label, shade) in PARTS.items():
        ax.plot(p[part], p["z"], color=shade, lw=1.2, label=label)
        bottom = bottom + p[part]
    ax.plot(bottom + p["inertia"], p["z"], color="k", lw=1.5, label="sum")
    ax.plot(p["load"], p["z"], "--", color="firebrick", lw=1.5, label="weight above, less drag")
    ax.axvline(0, color="0.7", lw=0.8)
    ax.set(xlabel="compression / (viscosity rate)", ylabel="height / radius", ylim=(0, None), title=f"Sh {chosen[name]['shields']}")
    ax.legend(frameon=False, fontsize=8)

    ax = axes[1, 0]    # normal viscosity
    for name, row in chosen.items():
        p, inside = profiles[name], bulk(profiles[name])
        ax.plot(*(thick(values[inside]) for values in (p["phi"], p["load"] / p["rate"])), "o", ms=4, color=color(p), label=f"Sh {row['shields']}")
    ax.plot(*resuspension.homogeneous({"vorticity": "zz", "gradient": "yy"}[direction]), "s", ms=6, mfc="none", color="k", label="homogeneous shear")
    for law, style in zip(named, STYLES):
        phi = np.linspace(0.25, min(0.575, 0.99 * law.phi_m), 200)
        ax.plot(phi, law.eta(phi), style, color="0.4", lw=1, label=law.name)
    ax.set(yscale="log", xlabel="volume fraction", ylabel="normal viscosity", ylim=(0.1, 1000), xlim=(0.25, 0.6))
    ax.legend(frameon=False, fontsize=8)

    ax = axes[1, 1]    # heights
    numbers = np.geomspace(0.01, 5, 40)
    for law, style, shade in zip((own, *named), ("-", *STYLES), ("k", *["0.4"] * 3)):
        ax.plot(numbers, [balance.height(law, number, resuspension.PHI_REST) - 1 for number in numbers], style, color=shade, lw=1, label=law.name)
    for name, row in chosen.items():
        ax.errorbar(float(row["acrivos"]), float(row["growth"]), float(row["growth_error"]), fmt="o", ms=5, color=color(profiles[name]))
    ax.set(xscale="log", yscale="log", xlabel="Acrivos number", ylabel=r"$(h - h_0)/h_0$")
    ax.legend(frameon=False, fontsize=8)
    fig.tight_layout()
    fig.savefig("figure.png", dpi=110)
    print("wrote figure.png")

    print(f"{'run':8s} {'Sh':>5s} {'A':>7s} {'(h-h0)/h0':>10s} " + " ".join(f"{law.name[:14]:>14s}" for law in (own, *named)))
    for name, row in chosen.items():
        a = float(row["acrivos"])
        print(f"{name:8s} {row['shields']:>5s} {a:7.3f} {float(row['growth']):10.3f} "
              + " ".join(f"{balance.height(law, a, resuspension.PHI_REST) - 1:14.3f}" for law in (own, *named)))
    print("normal viscosity, weight above over that of homogeneous shear and of the law of Chevremont; stress of the grains over the weight above")
    for name in chosen:
        p, inside = profiles[name], bulk(profiles[name])
        eta, stress = (p["load"] / p["rate"])[inside], sum(p[part] for part in resuspension.ORIGINS)[inside]
        print(f"{name:8s} " + " ".join(f"{np.exp(np.mean(np.log(eta / law.eta(p['phi'][inside])))):6.2f}" for law in (own, named[0]))
              + f" {stress.sum() / p['load'][inside].sum():6.3f}")


if __name__ == "__main__":
    main()
