"""What fix deform/rheometer adds to a step, against fix deform and no fix on the same state.

usage: tools/python.sh benchmarks/rheometer.py [--ranks 2] [--rounds 20] [--particles 1000]

Segments of the variants alternate in one process, so that what else the machine does spreads over all of them. The fix
costs time in the sections Pair (the virial) and Modify of LAMMPS' table; on several ranks Modify also holds the waiting for
the slower rank, which the others do in Comm. Rebuilding the neighbor list is what shearing costs, with any fix.
"""
import argparse
import re
import subprocess
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
VARIANTS = ["none", "deform", "rate", "pressure"]


def segments(text):
    """Lists of (total, Pair + Modify) seconds of the segments of each variant."""
    found = {variant: [] for variant in VARIANTS}
    for name, body in re.findall(r"^variant (\w+)\n(.*?)^Dangerous", text, re.MULTILINE | re.DOTALL):
        total = float(re.search(r"^Loop time of (\S+)", body, re.MULTILINE)[1])
        parts = [float(re.search(rf"^{part} *\|[^|]*\| *(\S+)", body, re.MULTILINE)[1]) for part in ("Pair", "Modify")]
        found[name].append((total, sum(parts)))
    return {name: np.array(rows) for name, rows in found.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ranks", default="2")
    parser.add_argument("--rounds", default="20")
    parser.add_argument("--particles", default="1000")
    args = parser.parse_args()
    command = [HERE.parent / "tools/lmp.sh", "-n", args.ranks, "-in", "in.rheometer", "-log", "none", "-var", "rounds",
               args.rounds, "-var", "N", args.particles]
    run = subprocess.run([str(word) for word in command], cwd=HERE, capture_output=True, text=True, check=False)
    if run.returncode:
        sys.exit(run.stdout[-2000:] + run.stderr)
    found = segments(run.stdout)
    step = np.median(found["deform"][:, 0])
    print(f"{args.particles} particles, {args.ranks} ranks, {len(found['deform'])} segments of each variant")
    print("over the time of a step with fix deform, in per cent: medians, and quartiles of the difference to fix deform")
    for name in VARIANTS:
        text = f"  {name:9s}"
        for column, what in enumerate(("step", "Pair and Modify")):
            low, middle, high = 100 * np.percentile((found[name] - found["deform"])[:, column] / step, [25, 50, 75])
            text += f"  {what} {100 * np.median(found[name][:, column]) / step:6.1f}, {middle:+5.1f} ({low:+.1f} to {high:+.1f})"
        print(text)


if __name__ == "__main__":
    main()
