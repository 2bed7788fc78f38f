"""What neighbor lists cost in a sheared cell, and what lists cost that live as long as the flow allows.

usage: tools/python.sh benchmarks/lists.py [--quick] [--ranks 1 2] [--repetitions 2]

Runs in.lists with copies of one sheared state at the step that users take, with the lists of LAMMPS and with those of fix
deform/rheometer, in turns; writes lists.csv and lists.png. CPU times count. See README.md.
"""

import argparse
import csv
import re
import sys
from pathlib import Path

import run

HERE = Path(__file__).resolve().parent
SIZES = {1000: "1 1 1", 4000: "1 1 1", 32000: "2 2 2", 256000: "4 4 4", 1008000: "6 7 6"}
FIELDS = ["particles", "ranks", "lists", "speed", "steps_per_list", "pair", "neigh", "comm", "modify"]


def measure(state, particles, ranks, lists):
    """One run: million particle-steps per CPU second, steps that a list lives, ns per particle-step by section."""
    steps = 1000 if particles < 10000 else 400 if particles < 100000 else 160 if particles < 500000 else 80
    text = run.lammps(ranks, "-in", "in.lists", "-var", "state", state, "-var", "copies", SIZES[particles],
                      "-var", "lists", lists, "-var", "steps", steps, "-var", "warm", 20)
    measured = text.split("measured from here")[-1]
    sections = run.read_sections(measured, ranks)
    builds = int(re.search(r"Neighbor list builds = (\d+)", measured)[1])
    per = {name: sections[name] / particles for name in run.SECTIONS}
    return {"particles": particles, "ranks": ranks, "lists": lists, "speed": f"{1e3 / sum(per.values()):.3f}",
            "steps_per_list": f"{steps / max(builds, 1):.1f}", "pair": f"{per['Pair']:.1f}", "neigh": f"{per['Neigh']:.1f}",
            "comm": f"{per['Comm']:.1f}", "modify": f"{per['Modify']:.1f}"}


def draw(rows, file):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(6.5, 4.2), layout="constrained")
    for lists, color in (("lammps", "#f57900"), ("affine", "#3465a4")):
        for ranks, line in ((1, "-o"), (2, "--s")):
            points = sorted((row["particles"], float(row["speed"])) for row in rows
                            if row["lists"] == lists and row["ranks"] == ranks)
            if points:
                axes.plot(*zip(*points), line, color=color, label=f"lists {lists}, {ranks} rank{'s' * (ranks > 1)}")
    axes.set_xscale("log")
    axes.set_ylim(bottom=0)
    axes.set_xlabel("particles")
    axes.set_ylabel("million particle-steps per CPU second")
    axes.legend(frameon=False)
    axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(file, dpi=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="up to 32000 particles only")
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--particles", type=int, nargs="+", choices=list(SIZES), default=list(SIZES), help="these sizes only")
    parser.add_argument("--repetitions", type=int, default=2, help="of every case, of which the best counts (2)")
    args = parser.parse_args()

    build = run.build_folder()
    rows = []
    for particles in args.particles:
        if args.quick and particles > 32000:
            continue
        state = run.make_state(build, 1000 if particles == 1000 else 4000)
        for ranks in args.ranks:
            for lists in ("lammps", "affine"):
                best = max((measure(state, particles, ranks, lists) for _ in range(args.repetitions)),
                           key=lambda row: float(row["speed"]))
                rows.append(best)
                print("  ".join(f"{name} {value}" for name, value in best.items()), flush=True)
    folder = build if args.quick else HERE
    with open(folder / "lists.csv", "w", newline="", encoding="ascii") as file:
        writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    draw(rows, folder / "lists.png")
    print(f"see {folder / 'lists.csv'} and {folder / 'lists.png'}", file=sys.stderr)


if __name__ == "__main__":
    main()
