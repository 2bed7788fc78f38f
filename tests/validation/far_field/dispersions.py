"""Random equilibrium dispersions of hard spheres in one moment: viscosity against the range of the residual films, and motions.

usage: tools/python.sh dispersions.py [--configurations 10] [--spheres 40] [--phi 0.1 ... 0.5] [--table dispersions.csv] [--no-package]

A dense program (tests/decks/oracle): force coupling by a sum over all waves, films by linear algebra from the exact two-sphere
resistance, hard spheres by Monte Carlo. The first configuration is given to the package, too: xy of the viscosity by both.
Adds rows to the table. A quarter of an hour with the reference BLAS, two minutes with OpenBLAS.
"""
import argparse
import csv
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(ROOT / "tests" / "decks"))
from oracle import free_spheres, spheres    # noqa: E402  pylint: disable=wrong-import-position

RANGES = (0, 0.25, 0.5, 1, 2)
WHAT = ("viscosity", "settling", "self", "rotation")
FIELDS = (["phi", "spheres", "configurations", "range"] + [f"{what}{suffix}" for what in WHAT for suffix in ("", "_error")]
          + ["dense_xy", "package_xy"])
RATE = 1e-5


def configuration(number, phi, seed):
    edge, x = spheres.equilibrium(np.random.default_rng([seed, int(1000 * phi)]), number, phi)
    return edge * np.eye(3), x


def solved(cell, x):
    """For each range: mean viscosity of the five strains, and the motions of free_spheres; and xy alone."""
    one = free_spheres.Dispersion(cell, x, RANGES, smallest=1e-8)
    eta = one.viscosities()
    return np.array([(np.trace(v) / 5, *m) for v, m in zip(eta, one.motions())]), [v[0, 0] for v in eta]


def by_the_package(cell, x, reach):
    """None for a range that the pair style does not take in this cell."""
    if reach == 0 or 2 * (2 + reach) >= cell[0, 0]:
        return None
    deck = ROOT / "tests" / "decks" / "dispersions" / "in.moment"
    n = len(x)
    with tempfile.TemporaryDirectory() as folder:
        spheres.write_spheres(Path(folder) / "spheres.data", cell, x, np.ones(n), np.outer(x[:, 1], [RATE, 0, 0]),
                              np.outer(np.ones(n), [0, 0, -RATE / 2]), 0.08, triclinic=True)
        subprocess.run([str(ROOT / "tools" / "lmp.sh"), "-in", str(deck), "-log", "log", "-screen", "none", "-var", "range",
                        f"residual {reach}", "-var", "rate", str(RATE)], cwd=folder, check=True)
        rows = [line.split() for line in (Path(folder) / "log").read_text(encoding="ascii").splitlines()]
        return float([row for row in rows if len(row) == 6 and row[0] == "200"][-1][1])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--configurations", type=int, default=10)
    parser.add_argument("--spheres", type=int, default=40)
    parser.add_argument("--phi", type=float, nargs="+", default=[0.1, 0.2, 0.3, 0.4, 0.45, 0.5])
    parser.add_argument("--table", type=Path, default=HERE / "dispersions.csv")
    parser.add_argument("--no-package", action="store_true")
    args = parser.parse_args()
    new = not args.table.exists()
    with open(args.table, "a", encoding="ascii", newline="") as file:
        table = csv.DictWriter(file, FIELDS)
        if new:
            table.writeheader()
        for phi in args.phi:
            cells = [configuration(args.spheres, phi, seed) for seed in range(args.configurations)]
            found, xy = zip(*(solved(*one) for one in cells))
            mean = np.mean(found, axis=0)
            error = np.std(found, axis=0, ddof=1) / np.sqrt(args.configurations)
            for reach, values, errors, dense in zip(RANGES, mean, error, xy[0]):
                row = {"phi": phi, "spheres": args.spheres, "configurations": args.configurations, "range": reach}
                for what, value, e in zip(WHAT, values, errors):
                    row[what], row[f"{what}_error"] = f"{value:.4f}", f"{e:.4f}"
                other = None if args.no_package else by_the_package(*cells[0], reach)
                row["dense_xy"], row["package_xy"] = f"{dense:.5f}", "" if other is None else f"{other:.5f}"
                table.writerow(row)
                print(*row.values(), flush=True)


if __name__ == "__main__":
    main()
