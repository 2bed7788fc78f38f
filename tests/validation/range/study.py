"""Relative viscosity for each rule and reach of the range of lubrication, over the volume fraction.

usage: tools/python.sh study.py [--particles 500] [--strain 6.5] [--seeds 4711]
Runs examples/shear_rate for each case, one after the other, appends to results.csv, skips what it already holds.
"""
import argparse
import csv
import resource
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
EXAMPLES = HERE.parents[2] / "examples"
sys.path.insert(0, str(EXAMPLES / "scene"))
import rheology    # noqa: E402  pylint: disable=wrong-import-position

TABLE = HERE / "results.csv"
FIELDS = ["phi", "rule", "reach", "seed", "eta_r", "error", "contact_n", "contact_t", "film_n", "film_t", "sxx", "syy",
          "szz", "cpu"]
RANGES = [("cut", "0.5"), ("cut", "0.25"), ("shifted", "1"), ("cut", "1"), ("voronoi", "1.5"), ("cut", "0.75"), ("shifted", "1.5"),
          ("voronoi", "1"), ("shifted", "0.5"), ("voronoi", "3"), ("shifted", "2")]
FRACTIONS = ["0.4", "0.54", "0.45", "0.5"]
TRANSIENT = 1.5    # strain left out


def measure(phi, rule, reach, seed, particles, strain):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    data = rheology.simulate(EXAMPLES / "shear_rate" / "in.shear_rate",
                             {"phi": phi, "range": f"{rule} {reach}", "seed": seed, "N": particles, "strain": strain,
                              "image": "no"})
    cpu = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    kept = {name[2:]: column[data["v_gamma"] >= TRANSIENT] for name, column in data.items() if name.startswith("v_")}
    numbers = [*rheology.estimate(kept["sxy"]), *(kept[name].mean() for name in FIELDS[6:13]), cpu]
    return dict(zip(FIELDS, [phi, rule, reach, seed] + [f"{x:.3f}" for x in numbers]))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--particles", default="500")
    parser.add_argument("--strain", default="6.5")
    parser.add_argument("--seeds", nargs="+", default=["4711"])
    args = parser.parse_args()
    rows = list(csv.DictReader(TABLE.open(encoding="ascii"))) if TABLE.exists() else []
    done = {tuple(row[f] for f in FIELDS[:4]) for row in rows}
    for case in [(phi, *which, seed) for seed in args.seeds for which in RANGES for phi in FRACTIONS]:
        if case in done:
            continue
        rows.append(measure(*case, args.particles, args.strain))
        print(" ".join(f"{rows[-1][f]:>9s}" for f in FIELDS), flush=True)
        with TABLE.open("w", newline="", encoding="ascii") as file:
            writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)


if __name__ == "__main__":
    main()
