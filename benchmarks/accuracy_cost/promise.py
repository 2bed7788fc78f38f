"""Do the settings that suspension_scene tolerance proposes keep their promise? Seed after seed, against the converged viscosity.

usage: tools/python.sh promise.py
Asks tests/decks/scene_tolerance for its lines, runs them, appends to promise.csv, skips what it already holds.
"""
import csv
import re
import subprocess
import tempfile
from pathlib import Path

import numpy as np

import suspension
import suspension_laws
from suspension import rheology

TABLE = suspension.HERE / "promise.csv"
DECK = suspension.TOP / "tests" / "decks" / "scene_tolerance" / "in.scene_tolerance"
FIELDS = ["tolerance", "seed", "particles", "strain", "promised_cpu", "cpu", "eta_r"]
SEEDS = {"0.3": 8, "0.2": 20, "0.1": 6}


def launch(folder, **variables):
    return suspension.launch(folder, {"root": suspension.TOP, **variables}, DECK)


def measure(tolerance, seed):
    with tempfile.TemporaryDirectory() as folder:
        text, _, failed = launch(folder, tolerance=tolerance, seed=seed)
        lines = text[text.index("Input lines to use\n"):].splitlines()[1:]
        (Path(folder) / "proposed").write_text("\n".join(line for line in lines if line.startswith("  ")) + "\n", encoding="ascii")
        particles = re.search(r"few particles, N +(\d+)", text)[1]
        strain = re.search(r"strain averaged +(\S+)", text)[1]
        promised = re.search(r"cost: (\S+)", text)[1]
        _, cpu, failed = launch(folder, N=particles, seed=seed, lines="proposed")
        if failed:
            return dict(zip(FIELDS, [tolerance, seed, particles, strain, promised, f"{cpu:.2f}", failed]))
        data = rheology.read_run(folder)
        eta = data["v_sxy"][data["v_gamma"] > suspension.SETTLED].mean()
    return dict(zip(FIELDS, [tolerance, seed, particles, strain, promised, f"{cpu:.2f}", f"{eta:.3f}"]))


def main():
    rows = list(csv.DictReader(TABLE.open(encoding="ascii"))) if TABLE.exists() else []
    for tolerance, seeds in SEEDS.items():
        for seed in range(1, seeds + 1):
            if not any((row["tolerance"], row["seed"]) == (tolerance, str(seed)) for row in rows):
                rows.append(measure(tolerance, seed))
                with TABLE.open("w", newline="", encoding="ascii") as file:
                    writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
                    writer.writeheader()
                    writer.writerows(rows)
    reference, doubt = suspension_laws.converged(suspension_laws.read()[0])
    print(f"converged viscosity {reference:.2f}, known within {100 * doubt:.1f} %")
    for tolerance in SEEDS:
        these = [row for row in rows if row["tolerance"] == tolerance]
        off = np.array([float(row["eta_r"]) for row in these]) / reference - 1
        cost = np.mean([float(row["cpu"]) for row in these])
        print(f"tolerance {tolerance}: {np.sum(abs(off) < float(tolerance))} of {len(off)} within; off by {100 * off.mean():+.1f} +- "
              f"{100 * off.std(ddof=1):.1f} % (scatter of one), at most {100 * abs(off).max():.1f} %; {cost:.1f} s of CPU, promised "
              f"{these[0]['promised_cpu']}")


if __name__ == "__main__":
    main()
