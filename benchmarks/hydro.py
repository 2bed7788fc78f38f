"""What the far field costs: levels none, mean and grid of fix hydro in a sheared cell, for growing cells, on one rank and on two.

usage: tools/python.sh benchmarks/hydro.py [--quick] [--phi 0.3 0.5] [--repetitions 2]

Runs in.hydro with copies of one sheared state at the step that users take, the largest cell at the last volume fraction alone;
writes hydro.csv and hydro.png, with --quick those up to 8000 particles to the build folder. CPU times count, all ranks
together; the speed-up of two ranks compares times of clocks and needs two free cores. See README.md.
"""

import argparse
import csv
import re
import sys
from pathlib import Path

import run

HERE = Path(__file__).resolve().parent
SIZES = {1000: ("1 1 1", 0.06, 0.2), 8000: ("2 2 2", 0.06, 0.05), 64000: ("4 4 4", 0.03, 0.01)}    # copies of a state, strain before and of it
LEVELS = ["none", "mean", "grid"]
FIELDS = ["phi", "particles", "level", "ranks", "cpu", "over_none", "iterations", "bytes", "speedup"]


def make_state(build, phi):
    state = build / f"benchmark_hydro_{phi}.data"
    if not state.exists():
        print("making the state", file=sys.stderr)
        run.lammps(1, "-in", "in.hydro", "-var", "make", 1, "-var", "phi", phi, "-var", "state", state)
    return state


def measure(state, phi, particles, level, ranks):
    """CPU seconds per unit of strain and thousand particles; iterations; bytes of a particle; seconds of the clock."""
    copies, warm, strain = SIZES[particles]
    text = run.lammps(ranks, "-in", "in.hydro", "-var", "state", state, "-var", "phi", phi, "-var", "copies", copies, "-var", "level", level,
                      "-var", "warm", warm, "-var", "strain", strain)
    measured = text.split("measured from here")[-1]
    clock, steps = re.search(r"Loop time of (\S+) on \d+ procs for (\d+) steps", measured).groups()
    sections = run.read_sections(measured, ranks)
    megabytes = ranks * float(re.search(r"allocation \(min/avg/max\) = \S+ \| (\S+)", text)[1])
    return {"cpu": sum(sections[name] for name in run.SECTIONS) * 1e-9 * int(steps) / strain / particles * 1000, "clock": float(clock),
            "iterations": float(re.search(r"^iterations (\S+)", measured, re.MULTILINE)[1]), "bytes": megabytes * 2**20 / particles}


def draw(rows, file):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(6.5, 4.2), layout="constrained")
    for level, color in zip(LEVELS, ("0.4", "#f57900", "#3465a4")):
        for phi, line in (("0.3", "--s"), ("0.5", "-o")):
            points = sorted((row["particles"], float(row["cpu"])) for row in rows if (row["level"], row["phi"], row["ranks"]) == (level, phi, 1))
            if points:
                axes.plot(*zip(*points), line, color=color, ms=4, label=f"{level}, volume fraction {phi}")
    axes.set(xscale="log", yscale="log", xlabel="particles", ylabel="CPU seconds per strain and 1000 particles")
    axes.legend(frameon=False, fontsize=8)
    axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(file, dpi=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="up to 8000 particles only")
    parser.add_argument("--phi", nargs="+", choices=["0.3", "0.5"], default=["0.3", "0.5"])
    parser.add_argument("--repetitions", type=int, default=2, help="of every case, of which the best counts (2)")
    args = parser.parse_args()
    build, rows = run.build_folder(), []
    for phi in args.phi:
        state = make_state(build, phi)
        for particles in SIZES:
            if particles > 8000 and (args.quick or phi != args.phi[-1]):
                continue
            found = {}
            for ranks in (1, 2):
                for level in LEVELS if ranks == 1 else ["grid"]:
                    runs = [measure(state, phi, particles, level, ranks) for _ in range(1 if particles > 8000 else args.repetitions)]
                    best = found[level, ranks] = {name: min(one[name] for one in runs) for name in runs[0]}
                    rows.append({"phi": phi, "particles": particles, "level": level, "ranks": ranks, "cpu": f"{best['cpu']:.3g}",
                                 "over_none": f"{best['cpu'] / found['none', 1]['cpu']:.2f}", "iterations": f"{best['iterations']:.1f}",
                                 "bytes": f"{best['bytes']:.0f}", "speedup": f"{found[level, 1]['clock'] / best['clock']:.2f}"})
                    print("  ".join(f"{name} {value}" for name, value in rows[-1].items()), flush=True)
    folder = build if args.quick else HERE
    with open(folder / "hydro.csv", "w", newline="", encoding="ascii") as file:
        writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    draw(rows, folder / "hydro.png")


if __name__ == "__main__":
    main()
