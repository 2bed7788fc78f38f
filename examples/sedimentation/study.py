"""Settling velocity against the volume fraction and the size of the cell: a table.

usage: tools/python.sh study.py [--phi 0.01 ... 0.5] [--spheres 200] [--seeds 3] [--until 20] [--sizes 25 ... 800] [--jobs 2]
Adds rows to study.csv and leaves out those that it already has. About ten minutes on 2 cores.
"""
import argparse
import csv
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
TABLE = HERE / "study.csv"
KEY = ["phi", "N", "seed"]
FIELDS = KEY + ["start", "steady", "up", "side"]


def read_scene(folder="."):
    words = (Path(folder) / "scene.txt").read_text(encoding="ascii").split()
    return dict(zip(words[::2], map(float, words[1::2])))


def simulate(case, until):
    """Velocity of the first moment, mean of the last two thirds, mean squares of its fluctuation up and aside."""
    command = [str(HERE.parents[1] / "tools" / "lmp.sh"), "-in", str(HERE / "in.sedimentation"), "-log", "none", "-screen", "none",
               "-var", "packing", str(HERE.parent / "packing" / "packing.lmp"), "-var", "until", str(until)]
    path = min(0.2, 0.05 * max(1, 0.1 / case["phi"]))    # far from each other
    for name, value in {**case, "path": path}.items():
        command += ["-var", name, str(value)]
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(command, cwd=folder, check=True)
        steady = np.loadtxt(Path(folder) / "settling.txt")
        steady = steady[len(steady) // 3:].mean(axis=0)
        return {**case, "start": f"{read_scene(folder)['start']:.5f}",
                **{name: f"{value:.5f}" for name, value in zip(("steady", "up", "side"), steady[2:5])}}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--phi", type=float, nargs="*", default=[0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.45, 0.5])
    parser.add_argument("--spheres", type=int, default=200)
    parser.add_argument("--sizes", type=int, nargs="*", default=[25, 50, 100, 400, 800])
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--until", type=float, default=20)
    parser.add_argument("--jobs", type=int, default=2)
    args = parser.parse_args()
    rows = list(csv.DictReader(TABLE.open(encoding="ascii"))) if TABLE.exists() else []
    known = {tuple(float(row[name]) for name in KEY) for row in rows}
    seeds = range(1, args.seeds + 1)
    cases = [({"phi": phi, "N": args.spheres, "seed": seed}, args.until) for seed in seeds for phi in args.phi]
    cases += [({"phi": 0.1, "N": size, "seed": seed}, 0.5) for size in args.sizes for seed in range(1, 4 * args.seeds + 1)
              if seed <= args.seeds * max(1, 400 / size)]
    cases = [case for case in cases if tuple(float(case[0][name]) for name in KEY) not in known]
    with ThreadPoolExecutor(args.jobs) as pool, TABLE.open("a", encoding="ascii", newline="") as file:
        table = csv.DictWriter(file, FIELDS)
        if not rows:
            table.writeheader()
        for row in pool.map(lambda case: simulate(*case), cases):
            table.writerow(row)
            file.flush()
            print(*row.values(), flush=True)


if __name__ == "__main__":
    main()
