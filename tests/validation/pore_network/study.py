"""Steady viscosity with and without the pressure of the pores, on a grid and in the network.

usage: tools/python.sh study.py [--particles 150] [--strain 6] [--friction 0 0.3] [--pores none grid network100 ...] [--seeds 1 2 3 4]
Runs in.pore_network for each case, appends to results.csv, skips what it already holds. Prints the table of the README.
Stresses are over viscosity*rate, the heat of the pores over viscosity*rate^2.
"""
import argparse
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[2] / "examples" / "scene"))
import cases    # noqa: E402  pylint: disable=wrong-import-position
import rheology    # noqa: E402  pylint: disable=wrong-import-position

PORES = {"none": None, "grid": "spacing 3", "network100": "solver network tolerance 1e-6 factor 100",
         "network": "solver network tolerance 1e-6"}
CASE = ["pores", "friction", "N", "strain", "seed"]
COLUMNS = {"viscosity": "v_sxy", "contact_n": "v_contact_n", "contact_t": "v_contact_t", "film_n": "v_film_n", "film_t": "v_film_t",
           "syy": "v_syy", "heat": "v_heat", "iterations": "v_iterations"}
FIELDS = CASE + ["from"] + [name + end for name in COLUMNS for end in ("", "_error")]
FIRST = 1.5    # strain that never counts


def measure(case):
    words = PORES[case["pores"]]
    variables = {name: case[name] for name in CASE[1:]}
    if words:
        variables.update({"with": "yes", "pore": words})
    data = rheology.simulate(HERE / "in.pore_network", variables)
    start = max(FIRST, rheology.steady_from(data["v_gamma"], data["v_sxy"]))
    row = {**case, "from": f"{start:.2f}"}
    for name, column in COLUMNS.items():
        kept = data[column][data["v_gamma"] >= start]
        value, error = rheology.estimate(kept) if np.ptp(kept) > 0 else (kept[0], 0.0)
        row[name], row[name + "_error"] = f"{value:.5g}", f"{error:.2g}"
    return row


def show(rows):
    print("| N | friction | pores | viscosity | contacts | films | -sigma_yy | heat of the pores | runs |\n|---|---|---|---|---|---|---|---|---|")
    for case in sorted({(int(row["N"]), float(row["friction"]), list(PORES).index(row["pores"])) for row in rows}):
        chosen = [row for row in rows if (int(row["N"]), float(row["friction"]), list(PORES).index(row["pores"])) == case]
        of = {name: np.array(cases.columns(chosen, name)[0]) for name in COLUMNS}
        words = []
        for values in (of["viscosity"], of["contact_n"] + of["contact_t"], of["film_n"] + of["film_t"], -of["syy"], of["heat"]):
            error = np.std(values, ddof=1) / np.sqrt(len(values)) if len(values) > 1 else np.nan
            words.append(f"{values.mean():.2f} +- {error:.2f}")
        print(f"| {case[0]} | {case[1]:g} | {list(PORES)[case[2]]} | " + " | ".join(words) + f" | {len(chosen)} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--particles", default="150")
    parser.add_argument("--strain", default="6")
    parser.add_argument("--friction", nargs="+", default=["0", "0.3"])
    parser.add_argument("--pores", nargs="+", default=list(PORES))
    parser.add_argument("--seeds", nargs="+", default=["1", "2", "3", "4"])
    parser.add_argument("--table", default=str(HERE / "results.csv"))
    args = parser.parse_args()
    wanted = [dict(zip(CASE, (pores, friction, args.particles, args.strain, seed)))
              for seed in args.seeds for friction in args.friction for pores in args.pores]
    cases.run(wanted, measure, args.table, FIELDS)
    show(cases.read(args.table))


if __name__ == "__main__":
    main()
