"""Writes results.csv from runs.csv and imposed.csv: means over seeds; writes the tables into README.md and draws results.png.

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
import cases    # noqa: E402  pylint: disable=wrong-import-position
import rheology    # noqa: E402  pylint: disable=wrong-import-position

FIELDS = ["level", "range", "phi", "friction", "eta_r", "error"]
LEVELS = [("none", "0.5"), ("mean", "0.5"), ("grid", "0.5"), ("grid", "1"), ("grid", "2")]
LABEL = {("none", "0.5"): "films alone, to 0.5", ("mean", "0.5"): "mean, films to 0.5", ("grid", "0.5"): "grid, residual films to 0.5",
         ("grid", "1"): "grid, to 1", ("grid", "2"): "grid, to 2"}
STYLE = {("none", "0.5"): "ks--", ("mean", "0.5"): "C0v--", ("grid", "0.5"): "C1o-", ("grid", "1"): "C2D-", ("grid", "2"): "C3^-"}
ROUGHNESS = 0.01
SOLVE = 0.0025    # strain between two solutions; rows with more have a star
SHOWN = [("none", "0.5"), ("grid", "1")]    # in the table of parts
PARTS = ["contact_n", "contact_t", "film_n", "film_t", "stresslet", "syy", "cpu"]


def state(row):
    return tuple(row[name] for name in ("level", "range", "phi", "friction", "roughness"))


def most_often_solved(rows):
    """Of each state the rows with the least strain between two solutions."""
    least = {}
    for row in rows:
        least[state(row)] = min(float(row["solve"]), least.get(state(row), np.inf))
    return [row for row in rows if float(row["solve"]) == least[state(row)]]


def error_of_mean(values, errors):
    """Of several seeds: from the errors of the runs that know one, or from their scatter if that is larger."""
    known = errors[np.isfinite(errors)]
    error = np.sqrt(np.mean(known**2) / len(values)) if len(known) else np.nan
    return np.nanmax([error, np.std(values, ddof=1) / np.sqrt(len(values))]) if len(values) > 1 else error


def merged(rows, roughness=ROUGHNESS):
    """(level, range, friction) -> phi -> mean, error and parts over the seeds."""
    found = {}
    for row in rows:
        if float(row["roughness"]) != roughness:
            continue
        found.setdefault((row["level"], row["range"], row["friction"]), {}).setdefault(float(row["phi"]), []).append(row)
    for of_phi in found.values():
        for phi, seeds in of_phi.items():
            values, errors = (np.array(column) for column in cases.columns(seeds, "eta_r", "error"))
            error = error_of_mean(values, errors)
            parts = {name: np.mean(cases.columns(seeds, name)) for name in PARTS}
            of_phi[phi] = {"eta_r": values.mean(), "error": error, "seeds": len(values), "solve": float(seeds[0]["solve"]), **parts}
    return found


def laws(phi, friction):
    known = {"Chevremont": rheology.eta_chevremont(phi, friction)} if friction else {}
    if friction == 0.5:
        known["Boyer"] = rheology.eta_boyer(phi)
        if phi <= 0.45:
            known["Gallier"] = rheology.eta_gallier(phi)
    return known


def viscosities(found, friction):
    """Table of the relative viscosities, as lines."""
    chosen = [key for key in LEVELS if (*key, friction) in found]
    lines = ["| phi | " + " | ".join(LABEL[key] for key in chosen) + " | laws |", "|---" * (len(chosen) + 2) + "|"]
    for phi in sorted({phi for key in chosen for phi in found[(*key, friction)]}):
        words = [pm(found[(*key, friction)].get(phi)) for key in chosen]
        lines.append(f"| {phi:g} | " + " | ".join(words) + " | "
                     + ", ".join(f"{name} {value:.2f}" for name, value in laws(phi, float(friction)).items()) + " |")
    return lines


def parts(found, friction):
    """Table of the parts of the stress, as lines."""
    lines = ["| phi | level | contacts | films | stresslets | -sigma_yy | CPU |", "|---" * 7 + "|"]
    for phi in sorted({phi for key in SHOWN for phi in found.get((*key, friction), {})}):
        for key in SHOWN:
            f = found.get((*key, friction), {}).get(phi)
            if f:
                lines.append(f"| {phi:g} | {' '.join(key)} | {f['contact_n'] + f['contact_t']:.3f} | {f['film_n'] + f['film_t']:.3f} | "
                             f"{f['stresslet']:.3f} | {-f['syy']:.3f} | {f['cpu']:.1f} |")
    return lines


def touching(rows):
    """Table at the volume fraction of spheres as they touch, with half the asperity on each, over the laws, as lines."""
    lines = ["| phi | roughness | phi as they touch | grid, to 1 | over Chevremont | over Boyer | films alone over Chevremont |", "|---" * 7 + "|"]
    heights = sorted({row["roughness"] for row in rows}, key=float)
    found = {height: merged(rows, float(height)) for height in heights}
    for height in heights:
        grid, alone = (found[height].get((*level, "0.5"), {}) for level in (("grid", "1"), ("none", "0.5")))
        for phi in sorted(phi for phi in grid if phi >= 0.3):
            touch = phi * (1 + float(height) / 2) ** 3
            of_laws = [law(touch) for law in (rheology.eta_chevremont, rheology.eta_boyer)]
            words = [ratio(grid[phi], law) for law in of_laws] + [ratio(alone[phi], of_laws[0]) if phi in alone else ""]
            lines.append(f"| {phi:g} | {height} | {touch:.4f} | {pm(grid[phi])} | " + " | ".join(words) + " |")
    return lines


def intervals(rows):
    """Table of the states that were run with several strains between two solutions, as lines."""
    lines = ["| phi | friction | range | roughness | strain between two solutions: relative viscosity |", "|---" * 5 + "|"]
    groups = {}
    for row in rows:
        if row["level"] == "grid":
            groups.setdefault((*state(row), row["seed"]), {})[float(row["solve"])] = row
    for (_, reach, phi, friction, roughness, _), found in sorted(groups.items(), key=lambda item: (float(item[0][2]), item[0])):
        if len(found) > 1:
            words = [f"{solve:g}: {float(row['eta_r']):.2f}" + (f" +- {float(row['error']):.2f}" if row["error"] != "nan" else "") for solve, row in sorted(found.items(), reverse=True)]
            lines.append(f"| {phi} | {friction} | {reach} | {roughness} | " + "; ".join(words) + " |")
    return lines


def ratio(found, law):
    error = found["error"] / law
    return f"{found['eta_r'] / law:.2f}" + (f" +- {error:.2f}" if np.isfinite(error) else "")


def pressures(rows):
    """Table of the runs under an imposed pressure, as lines: means over the seeds."""
    lines = ["| Iv | level | phi | mu | seeds |", "|---" * 5 + "|"]
    groups = {}
    for row in rows:
        groups.setdefault((float(row["Iv"]), row["level"]), []).append(row)
    for (iv, level), seeds in sorted(groups.items(), key=lambda item: (item[0][0], ["none", "mean", "grid"].index(item[0][1]))):
        words = []
        for name in ("phi", "mu"):
            values, errors = (np.array(column) for column in cases.columns(seeds, name, name + "_error"))
            error = error_of_mean(values, errors)
            words.append(f"{values.mean():.4f} +- {error:.4f}" if np.isfinite(error) else f"{values.mean():.4f}")
        lines.append(f"| {iv:g} | {level} | " + " | ".join(words) + f" | {len(seeds)} |")
    for iv in sorted({key[0] for key in groups}):
        lines.append(f"| {iv:g} | laws | Chevremont {rheology.phi_chevremont(iv, 0.5):.4f}, Boyer {rheology.phi_boyer(iv):.4f} | "
                     f"{rheology.mu_chevremont(iv, 0.5):.3f}, {rheology.mu_boyer(iv):.3f} | |")
    return lines


def pm(found):
    if not found:
        return ""
    digits = 3 if found["eta_r"] < 2 else 2 if found["eta_r"] < 30 else 1
    return (f"{found['eta_r']:.{digits}f}" + (f" +- {found['error']:.{digits}f}" if np.isfinite(found["error"]) else "")
            + (" \\*" if found["solve"] > SOLVE else ""))


def draw(found):
    frictions = sorted({key[2] for key in found}, reverse=True)
    fig, axes = plt.subplots(1, len(frictions), figsize=(5.6 * len(frictions), 4.6), squeeze=False)
    for ax, friction in zip(axes[0], frictions):
        phi = np.linspace(0.03, 0.56, 200)
        if float(friction):
            ax.plot(phi, rheology.eta_chevremont(phi, float(friction)), color="0.5", lw=1, label="Chevremont 2019")
        if float(friction) == 0.5:
            ax.plot(phi, rheology.eta_boyer(phi), color="0.5", lw=1, ls=":", label="Boyer 2011")
            ax.plot(phi[phi <= 0.45], rheology.eta_gallier(phi[phi <= 0.45]), color="0.5", lw=1, ls="-.", label="Gallier 2014")
        ax.plot(phi[phi < 0.2], 1 + 2.5 * phi[phi < 0.2], color="0.7", lw=3, label="Einstein", zorder=0)
        for key in LEVELS:
            of_phi = found.get((*key, friction))
            if of_phi:
                x = np.array(sorted(of_phi))
                ax.errorbar(x, [of_phi[p]["eta_r"] for p in x], np.nan_to_num([of_phi[p]["error"] for p in x]), fmt=STYLE[key], ms=4, lw=0.8,
                            label=LABEL[key])
        ax.set(yscale="log", xlabel=r"$\phi$", ylabel=r"$\eta_r$", title=f"friction {friction}")
    axes[0][0].legend(frameon=False, fontsize=7)
    fig.tight_layout()
    fig.savefig(HERE / "results.png", dpi=150)


def main():
    every = cases.read(HERE / "runs.csv")
    rows = most_often_solved(every)
    found = merged(rows)
    with open(HERE / "results.csv", "w", newline="", encoding="ascii") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(FIELDS)
        for level, reach in LEVELS:
            for friction in sorted({key[2] for key in found}):
                for phi, f in sorted(found.get((level, reach, friction), {}).items()):
                    writer.writerow([level, reach, f"{phi:g}", friction, f"{f['eta_r']:.4g}", f"{f['error']:.2g}"])
    frictions = sorted({key[2] for key in found}, reverse=True)
    cases.write_tables(HERE / "README.md", {**{f"friction {f}": viscosities(found, f) for f in frictions}, "parts": parts(found, frictions[0]),
                  "touching": touching(rows), "intervals": intervals(every), "imposed": pressures(cases.read(HERE / "imposed.csv"))})
    draw(found)


if __name__ == "__main__":
    main()
