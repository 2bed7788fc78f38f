"""Relative viscosity against the volume fraction at each level of the far field.

usage: tools/python.sh study.py [--phi 0.05 0.1 ...] [--friction 0.5 ...] [--roughness 0.01 ...]
                                [--levels none:cut:0.5 mean:cut:0.5 grid:residual:1]
                                [--solve 0.0025] [--particles 200] [--strain 4] [--seeds 1] [--jobs 1] [--table study.csv]
Runs in.dilute_to_dense for each case, appends to the table, skips what it already holds. The defaults take a quarter of an hour.
"""
import argparse
import resource
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "scene"))
import cases
import rheology

PARTS = ["contact_n", "contact_t", "film_n", "film_t", "stresslet", "sxx", "syy", "szz"]
CASE = ["level", "rule", "range", "solve", "phi", "friction", "roughness", "N", "strain", "seed"]    # solve: strain between two solutions of grid
FIELDS = CASE + ["eta_r", "error", *PARTS, "cpu"]
SEEDS = ["4711", "11", "23", "37", "59"]
LEVELS = ["none:cut:0.5", "mean:cut:0.5", "grid:residual:1"]
FRACTIONS = ["0.05", "0.1", "0.2", "0.3", "0.35", "0.4", "0.45", "0.5", "0.55"]
TRANSIENT = 1.5    # strain left out
DENSE = 0.52    # above, ten times the stiffness: the loads must not crush the asperities


def stiffness(case):
    """Over viscosity*rate*radius; asperities of a tenth of the height need ten times of it."""
    return 1e4 / float(case["roughness"]) * (10 if float(case["phi"]) > DENSE else 1)


def measure(case):
    """One row of the table: means after the transient, over viscosity*rate, and CPU seconds per unit of strain."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    data = rheology.simulate(HERE / "in.dilute_to_dense", {
        **{name: case[name] for name in ("level", "phi", "friction", "roughness", "N", "strain", "seed")},
        "range": f"{case['rule']} {case['range']}", "stiffness": f"{stiffness(case):g}",
        **({"far": f"strain {case['solve']}"} if case["level"] == "grid" else {})})
    cpu = (resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before) / float(case["strain"])
    kept = {name[2:]: column[data["v_gamma"] >= TRANSIENT] for name, column in data.items() if name.startswith("v_")}
    numbers = [*rheology.estimate(kept["sxy"]), *(kept[name].mean() for name in PARTS), cpu]
    return {**case, **dict(zip(FIELDS[len(CASE):], (f"{x:.4g}" for x in numbers)))}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--phi", nargs="+", default=FRACTIONS)
    parser.add_argument("--friction", nargs="+", default=["0.5"])
    parser.add_argument("--roughness", nargs="+", default=["0.01"])
    parser.add_argument("--levels", nargs="+", default=LEVELS)
    parser.add_argument("--solve", default="0.0025", help="strain between two solutions of grid (0.0025)")
    parser.add_argument("--particles", default="200")
    parser.add_argument("--strain", default="4")
    parser.add_argument("--seeds", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--table", default=str(HERE / "study.csv"))
    args = parser.parse_args()
    wanted = [dict(zip(CASE, (*level.split(":"), args.solve if level.startswith("grid") else "0", phi, friction, roughness, args.particles, args.strain, seed)))
              for seed in SEEDS[:args.seeds] for friction in args.friction for roughness in args.roughness for phi in args.phi for level in args.levels]
    cases.run(wanted, measure, args.table, FIELDS, args.jobs)


if __name__ == "__main__":
    main()
