"""Writes table.csv from results.csv, for README.md and the manual, and draws results.png.

usage: tools/python.sh judge.py
"""
import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[2] / "examples" / "scene"))
import rheology    # noqa: E402  pylint: disable=wrong-import-position

SCATTER = 0.07    # of a single run of 500 particles between seeds, relative (examples/shear_rate/study.csv: 31 to 37)
SWOLLEN = 1.005**3    # volume of a sphere up to half the height 0.01 of the asperities, where spheres touch
COLOR = {"cut": "#1f4e79", "shifted": "#b45f06", "voronoi": "#38761d"}


def references(phi):
    found = {"Chevremont 2019": rheology.eta_chevremont(phi), "Boyer 2011": rheology.eta_boyer(phi)}
    if phi <= 0.45:
        found["Gallier 2014, fit"] = rheology.eta_gallier(phi)
    return found


def uncertainty(phi):
    """Of the logarithm of the reference: half the spread, and what 0.005 in phi means, for asperities make particles larger.

    Contact at a gap of 0.01 radii is that of spheres with radii larger by 0.005, which is 1.5 % or 0.0075 in volume fraction.
    """
    known = np.log(list(references(phi).values()))
    slope = 2 / (rheology.phi_m_chevremont(0.5) - phi)
    return np.hypot(np.ptp(known) / 2, 0.005 * slope)


def read():
    """Dict of (rule, reach) -> phi -> (mean, error) in the logarithm, over the seeds; and of the seconds of CPU."""
    rows = list(csv.DictReader((HERE / "results.csv").open(encoding="ascii")))
    values, cpu = {}, {}
    for row in rows:
        case, phi = (row["rule"], float(row["reach"])), float(row["phi"])
        relative = max(float(row["error"]) / float(row["eta_r"]) if row["error"] != "nan" else 0.0, SCATTER)
        values.setdefault(case, {}).setdefault(phi, []).append((np.log(float(row["eta_r"])), relative))
        cpu.setdefault(case, {}).setdefault(phi, []).append(float(row["cpu"]))
    merged = {case: {phi: (np.mean([v for v, _ in runs]), np.mean([e for _, e in runs]) / np.sqrt(len(runs)))
                     for phi, runs in by_phi.items()} for case, by_phi in values.items()}
    return merged, cpu


def misfit(by_phi, swollen=1.0):
    """Root mean square of ln(eta/reference) over the fractions: plain, and over its error (run and reference).

    swollen: factor of the volume fraction at which the references are taken.
    """
    plain, weighted = [], []
    for phi, (value, error) in by_phi.items():
        known = np.log(list(references(phi * swollen).values()))
        plain.append(value - known.mean())
        weighted.append(plain[-1] / np.hypot(error, uncertainty(phi)))
    return np.sqrt(np.mean(np.square(plain))), np.sqrt(np.mean(np.square(weighted)))


def main():
    merged, cpu = read()
    fractions = sorted({phi for by_phi in merged.values() for phi in by_phi})
    rows = [["range", *(f"phi {phi:.2f}" for phi in fractions), "rms of ln", "error ratio", "rms of ln, asperities counted", "CPU"]]
    for case in sorted(merged):
        cells = []
        for phi in fractions:
            value, error = merged[case].get(phi, (np.nan, np.nan))
            cells.append(f"{np.exp(value):.3g} +- {np.exp(value) * error:.2g}" if np.isfinite(value) else "")
        plain, weighted = misfit(merged[case])
        common = [phi for phi in cpu[case] if phi in cpu[("cut", 0.5)]]
        cost = np.mean([np.mean(cpu[case][phi]) / np.mean(cpu[("cut", 0.5)][phi]) for phi in common])
        rows.append([f"{case[0]} {case[1]:g}", *cells, f"{plain:.2f}", f"{weighted:.1f}", f"{misfit(merged[case], SWOLLEN)[0]:.2f}",
                     f"{cost:.1f}"])
    for name in references(0.4):
        rows.append([name, *(f"{references(phi)[name]:.3g}" if name in references(phi) else "" for phi in fractions), "", "", "", ""])
    with (HERE / "table.csv").open("w", newline="", encoding="ascii") as file:
        csv.writer(file, lineterminator="\n").writerows(rows)

    fig, axes = plt.subplots(1, 2, figsize=(10.5, 4.4))
    phi = np.linspace(0.38, 0.548, 100)
    mean = {p: np.mean(np.log(list(references(p).values()))) for p in phi}
    for name, style in (("Chevremont 2019", "-"), ("Boyer 2011", "--"), ("Gallier 2014, fit", ":")):
        x = [p for p in phi if name in references(p)]
        axes[0].plot(x, [references(p)[name] / np.exp(mean[p]) for p in x], "k" + style, lw=1.2, label=name)
    for case in sorted(merged):
        x = np.array(sorted(merged[case]))
        y = [np.exp(merged[case][p][0] - np.mean(np.log(list(references(p).values())))) for p in x]
        reach = sorted(r for rule, r in merged if rule == case[0])
        shade = 0.35 + 0.65 * reach.index(case[1]) / max(len(reach) - 1, 1)
        axes[0].errorbar(x, y, yerr=[v * merged[case][p][1] for v, p in zip(y, x)], color=COLOR[case[0]], alpha=shade, marker="o",
                         ms=3, lw=1.2, label=f"{case[0]} {case[1]:g}")
    axes[0].set(xlabel=r"$\phi$", ylabel=r"$\eta_r$ over the mean of the references", yscale="log")
    axes[0].set_yticks([0.4, 0.6, 1, 1.5, 2, 3], labels=["0.4", "0.6", "1", "1.5", "2", "3"])
    axes[0].minorticks_off()
    axes[0].set_ylim(0.4, 4)
    axes[0].legend(fontsize=7, frameon=False, ncol=2)
    for p, marker in zip((0.4, 0.5), "os"):
        for rule, color in COLOR.items():
            points = sorted((r, *by_phi[p]) for (name, r), by_phi in merged.items() if name == rule and p in by_phi)
            if points:
                r, value, error = np.array(points).T
                axes[1].errorbar(r, np.exp(value), yerr=np.exp(value) * error, color=color, marker=marker, ms=4, lw=1.2,
                                 label=rf"{rule}, $\phi$ = {p:g}")
        axes[1].axhspan(min(references(p).values()) * 0.97, max(references(p).values()) * 1.03, color="0.85", zorder=0)
    axes[1].set(xlabel="reach over the effective radius", ylabel=r"$\eta_r$", yscale="log")
    axes[1].legend(fontsize=7, frameon=False)
    fig.tight_layout()
    fig.savefig(HERE / "results.png", dpi=150)


if __name__ == "__main__":
    main()
