"""What the pressure of the pores costs: fix pore/pressure in a sheared cell, against the same cell without it.

usage: tools/python.sh benchmarks/pore.py [--repetitions 2]

Runs in.lists with copies of one sheared state at the step that users take, without the fix and with grids of several spacings,
in turns; writes pore.csv. CPU times of one rank count. See README.md.
"""

import argparse
import csv
from pathlib import Path

import run

HERE = Path(__file__).resolve().parent
SIZES = {1000: ("1 1 1", 1000), 4000: ("1 1 1", 400), 108000: ("3 3 3", 60)}    # copies of a state, steps
SPACINGS = ["0", "3.0", "4.0"]    # radii of the particles; 0: without
NETWORK = {1000: 40}    # steps of the network of pores
FIELDS = ["particles", "spacing", "step", "modify", "over_without"]


def measure(state, particles, spacing):
    """CPU time of a particle-step, all of it and that of the fixes, in ns."""
    copies, steps = SIZES[particles]
    solver = f"cell spacing {spacing}"
    if spacing == "network":
        solver, steps = "solver network", NETWORK[particles]
    words = [] if spacing == "0" else ["-var", "pores", 1, "-var", "solver", solver]
    text = run.lammps(1, "-in", "in.lists", "-var", "state", state, "-var", "copies", copies, *words,
                      "-var", "steps", steps, "-var", "warm", 20)
    sections = run.read_sections(text.split("measured from here")[-1], 1)
    return {"particles": particles, "spacing": spacing, "step": sum(sections[name] for name in run.SECTIONS) / particles,
            "modify": sections["Modify"] / particles}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--repetitions", type=int, default=2, help="of every case, of which the best counts (2)")
    args = parser.parse_args()
    rows = []
    for particles in SIZES:
        state = run.make_state(run.build_folder(), min(particles, 4000))
        found = {spacing: [] for spacing in SPACINGS + ["network"] * (particles in NETWORK)}
        for _ in range(args.repetitions):
            for spacing in found:
                found[spacing].append(measure(state, particles, spacing))
        best = {spacing: min(runs, key=lambda row: row["step"]) for spacing, runs in found.items()}
        for row in best.values():
            ratio = row["step"] / best["0"]["step"]
            rows.append({**row, "step": f"{row['step']:.0f}", "modify": f"{row['modify']:.0f}", "over_without": f"{ratio:.2f}"})
            print("  ".join(f"{name} {value}" for name, value in rows[-1].items()), flush=True)
    with open(HERE / "pore.csv", "w", newline="", encoding="ascii") as file:
        writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


if __name__ == "__main__":
    main()
