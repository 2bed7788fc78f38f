"""What each effect costs and what it changes: a ladder from bare contact to everything, on the same state.

usage: tools/python.sh benchmarks/ladder.py [--strain 6] [--rounds 5] [-o ladder.csv]

Rung by rung: CPU time of a particle-step (best of the rounds, which go through all rungs in turn), relative viscosity
and coordination number with their errors over the strain after the first third. See README.md.
"""
import argparse
import csv
import re
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "tools"))
import steady

DRY = "squeeze no shear no roll no twist no"
RUBS = "friction coulomb 0.5"
DRAG = "fix drag all drag/background 1 cell"
# name: pair style, pair_coeff, a further line; each rung adds to the one above, the last ones to "+ twist"
RUNGS = {
    "contact": (f"cut 0.5 {DRY}", "friction none", ""),
    "+ friction": (f"cut 0.5 {DRY}", RUBS, ""),
    "+ squeeze": ("cut 0.5 shear no roll no twist no", RUBS, ""),
    "+ shear": ("cut 0.5 roll no twist no", RUBS, ""),
    "+ roll": ("cut 0.5 twist no", RUBS, ""),
    "+ twist: all films": ("cut 0.5", RUBS, ""),
    "all films, drag": ("cut 0.5", RUBS, DRAG),
    "all films, critical load": ("cut 0.5", "friction clm step 0.5 20", ""),
    "all films, adhesion": ("cut 0.5", RUBS + " adhesion 1e-5", ""),
    "all films, repulsion": ("cut 0.5", RUBS + " repulsion 10 0.02", ""),
    "all films, voronoi 1.5": ("voronoi 1.5", RUBS, ""),
}


def run(folder, *variables):
    command = [HERE.parent / "tools/lmp.sh", "-in", HERE / "in.ladder", "-log", "none"]
    for name, value in variables:
        command += ["-var", name, value]
    done = subprocess.run([str(word) for word in command], cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout[-2000:]}{done.stderr}")
    return done.stdout


def time_of(text):
    """CPU nanoseconds of a particle-step between the marks."""
    part = text.split("measured from here")[-1].split("measured to here")[0]
    steps, particles = re.search(r"for (\d+) steps with (\d+) atoms", part).groups()
    seconds = float(re.search(r"Loop time of (\S+)", part)[1]) * float(re.search(r"([\d.]+)% CPU use", part)[1]) / 100
    return seconds / int(steps) / int(particles) * 1e9


def mean(values):
    """Mean and its error; a run with too few independent values has no error."""
    try:
        return tuple(steady.mean_error(values))[:2]
    except steady.TooShort:
        return values.mean(), float("nan")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--strain", type=float, default=6.0)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--particles", type=int, default=500)
    parser.add_argument("-o", "--output", default=HERE / "ladder.csv")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        run(folder, ("make", "yes"), ("N", arguments.particles),
            ("scene", HERE.parent / "examples/scene"), ("packing", HERE.parent / "examples/packing/packing.lmp"))
        times = {name: [] for name in RUNGS}
        rows = []
        for number in range(arguments.rounds):
            for name, (style, contact, more) in RUNGS.items():
                last = number == arguments.rounds - 1
                strain = arguments.strain if last else 0
                text = run(folder, ("style", style), ("contact", contact), ("more", more), ("strain", strain))
                times[name].append(time_of(text))
                if not last:
                    continue
                data = steady.read_ave_time(Path(folder) / "ladder.txt")
                late = data["v_gamma"] > arguments.strain / 3
                eta, z = (mean(data[column][late]) for column in ("v_eta", "c_z"))
                rows.append({"rung": name, "ns": f"{min(times[name]):.0f}", "eta_r": f"{eta[0]:.2f}",
                             "error": f"{eta[1]:.2f}", "Z": f"{z[0]:.3f}", "error_Z": f"{z[1]:.3f}"})
                print("  ".join(f"{key} {value}" for key, value in rows[-1].items()), flush=True)
    with open(arguments.output, "w", newline="", encoding="ascii") as file:
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


if __name__ == "__main__":
    main()
