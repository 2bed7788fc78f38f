"""What moves the viscosity: one setting at a time around a base case, with error bars.

usage: tools/python.sh study.py [--strain 6] [--particles 500] [--jobs 2]
Runs in.shear_rate for each case (about 40 runs), appends to study.csv, skips the cases it
already holds, draws study.png, and writes the two tables of the manual, viscosity.csv and laws.csv.
"""
import argparse
import csv
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "scene"))
import rheology
from rheology import steady

FIELDS = ["knob", "value", "eta_r", "error", "contact_n", "contact_t", "film_n", "film_t", "N1", "N2", "sigma_yy"]

# knob -> list of (value shown, index variables of the deck)
CASES = {
    "base": [("", {})],
    "seed": [(s, {"seed": s}) for s in ("11", "23", "37")],
    "range": [(r, {"range": r}) for r in ("cut 0.1", "cut 0.25", "cut 1", "cut 1.5", "cut 2", "shifted 0.25",
                                          "shifted 0.5", "shifted 1", "shifted 2", "shifted 3")],
    "roll coefficient": [("no torque", {"modes": "roll no"})] +
                        [(c, {"modes": f"rollcoeff {c}"}) for c in ("0.15", "1.5")],
    "modes off": [(m, {"modes": f"{m} no"}) for m in ("shear", "twist", "squeeze")],
    "particles": [(n, {"N": n}) for n in ("200", "2000")],
    "stiffness": [(g, {"stiffness": g}) for g in ("1e4", "1e5", "1e7")],
    "Stokes number": [(s, {"stokes": s}) for s in ("5e-1", "5e-3")],
    "roughness": [(e, {"roughness": e}) for e in ("1e-3", "3e-3", "2e-2", "5e-2")],
    "friction": [(m, {"friction": m}) for m in ("0", "0.2", "1")],
    "size spread": [(s, {"spread": s}) for s in ("0", "0.1", "0.2")],
    "time step": [("half", {"fraction": "0.075"})],
    "gap integrator": [("euler", {"modes": "gap euler"})],
    "effective radius": [("mean", {"modes": "radius mean"})],
    "volume fraction": [(p, {"phi": p}) for p in ("0.3", "0.4", "0.45", "0.54")],
}


def measure(knob, value, variables):
    data = rheology.simulate(HERE / "in.shear_rate", {**variables, "image": "no"})
    kept = {name[2:]: column[data["v_gamma"] >= 0.25 * data["v_gamma"][-1]] for name, column in data.items()}
    found = steady.mean_error(kept["sxy"])
    means = {name: column.mean() for name, column in kept.items()}
    numbers = [found.mean, found.error, *(means[part] for part in ("contact_n", "contact_t", "film_n", "film_t")),
               means["sxx"] - means["syy"], means["syy"] - means["szz"], means["syy"]]
    return dict(zip(FIELDS, [knob, value] + [f"{x:.3f}" for x in numbers]))


# knob of study.csv -> setting in viscosity.csv
SETTING = {"base": "base case", "range": "range of the films", "roll coefficient": "rolling coefficient",
           "modes off": "film switched off", "gap integrator": "integrator of the gap"}


def pm(mean, error):
    """Mean and standard error; the error has two digits, or one if these are 2.0 or more."""
    digits = 0 if error >= 2 else 1 if error >= 0.2 else 2
    return f"{mean:.{digits}f} +- {error:.{digits}f}"


def write_tables(rows):
    """viscosity.csv: every case at a volume fraction of 0.5; laws.csv: every volume fraction, with laws."""
    seeds = np.array([float(r["eta_r"]) for r in rows if r["knob"] in ("base", "seed")])
    base = pm(seeds.mean(), seeds.std(ddof=1) / np.sqrt(len(seeds)))
    with (HERE / "viscosity.csv").open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["setting", "value", "relative viscosity", "of which contacts", "of which films"])
        writer.writerow(["base case", f"mean of {len(seeds)} seeds", base, "", ""])
        for r in rows:
            if r["knob"] in ("seed", "volume fraction"):
                continue
            parts = (float(r["contact_n"]) + float(r["contact_t"]), float(r["film_n"]) + float(r["film_t"]))
            writer.writerow([SETTING.get(r["knob"], r["knob"]), r["value"] or "one seed",
                             pm(float(r["eta_r"]), float(r["error"])), *(f"{p:.1f}" for p in parts)])
    with (HERE / "laws.csv").open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["volume fraction", "relative viscosity", "Chevremont et al. 2019", "Boyer et al. 2011"])
        found = {float(r["value"]): pm(float(r["eta_r"]), float(r["error"]))
                 for r in rows if r["knob"] == "volume fraction"}
        for phi, eta in sorted({**found, 0.5: base}.items()):
            writer.writerow([phi, eta, f"{rheology.eta_chevremont(phi):.1f}", f"{rheology.eta_boyer(phi):.1f}"])


def draw(rows):
    knobs = [k for k in CASES if k not in ("base", "volume fraction")]
    base = next(r for r in rows if r["knob"] == "base")
    labels, means, errors, colors = ["base case"], [float(base["eta_r"])], [float(base["error"])], ["k"]
    palette = plt.get_cmap("tab10")
    for n, knob in enumerate(knobs):
        for row in rows:
            if row["knob"] == knob:
                labels.append(f"{knob}: {row['value']}")
                means.append(float(row["eta_r"]))
                errors.append(float(row["error"]))
                colors.append(palette(n % 10))
    fig, ax = plt.subplots(figsize=(7, 0.2 * len(labels) + 1))
    y = -np.arange(len(labels))
    ax.barh(y, means, xerr=errors, color=colors, height=0.7, error_kw={"lw": 1})
    ax.axvline(means[0], color="k", lw=0.8, ls="--")
    ax.axvline(rheology.eta_chevremont(0.5), color="0.4", lw=0.8, ls=":")
    ax.text(rheology.eta_chevremont(0.5) - 0.5, 1.1, "laws of 2011 and 2019", fontsize=7, ha="right", color="0.3")
    ax.set(yticks=y, xlabel=r"$\eta_r$ at $\phi$ = 0.5", ylim=(y[-1] - 0.7, 2))
    ax.set_yticklabels(labels, fontsize=7)
    fig.tight_layout()
    fig.savefig(HERE / "study.png", dpi=150)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--strain", default="6")
    parser.add_argument("--particles", default="500")
    parser.add_argument("--jobs", type=int, default=2)
    args = parser.parse_args()
    table = HERE / "study.csv"
    rows = list(csv.DictReader(table.open())) if table.exists() else []
    done = {(r["knob"], r["value"]) for r in rows}
    todo = [(k, v, {"N": args.particles, "strain": args.strain, **variables})
            for k, cases in CASES.items() for v, variables in cases if (k, v) not in done]
    with ThreadPoolExecutor(args.jobs) as pool:
        for row in pool.map(lambda case: measure(*case), todo):
            rows.append(row)
            print(" ".join(f"{row[f]:>10s}" for f in FIELDS), flush=True)
            with table.open("w", newline="") as file:
                writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
                writer.writeheader()
                writer.writerows(rows)
    draw(rows)
    write_tables(rows)


if __name__ == "__main__":
    main()
