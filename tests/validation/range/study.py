"""Relative viscosity for each rule and reach of the range of lubrication, over the volume fraction.

usage: tools/python.sh study.py [--particles 500] [--strain 6.5] [--seeds 4711 11] [--ranges 'cut 0.5' ...] [--fractions 0.4 ...]
Runs examples/shear_rate for each case, one after the other, appends to results.csv, skips what it already holds.
"""
import argparse
import resource
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
EXAMPLES = HERE.parents[2] / "examples"
sys.path.insert(0, str(EXAMPLES / "scene"))
import cases    # noqa: E402  pylint: disable=wrong-import-position
import rheology    # noqa: E402  pylint: disable=wrong-import-position

FIELDS = ["phi", "rule", "reach", "seed", "eta_r", "error", "contact_n", "contact_t", "film_n", "film_t", "sxx", "syy",
          "szz", "cpu"]
RANGES = ["cut 0.5", "cut 0.75", "shifted 1.5", "shifted 1", "cut 0.25", "cut 1", "voronoi 1.5", "voronoi 1", "shifted 0.5",
          "voronoi 3", "shifted 2"]
# stiffness over viscosity*rate*radius: at 0.55 a load 10 times as high must not crush the asperities
FRACTIONS = {"0.4": "1e6", "0.45": "1e6", "0.5": "1e6", "0.54": "1e6", "0.55": "1e7"}
TRANSIENT = 1.5    # strain left out


def measure(case, particles, strain):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    data = rheology.simulate(EXAMPLES / "shear_rate" / "in.shear_rate",
                             {"phi": case["phi"], "range": f"{case['rule']} {case['reach']}", "seed": case["seed"],
                              "stiffness": FRACTIONS[case["phi"]], "N": particles, "strain": strain, "image": "no"})
    cpu = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    kept = {name[2:]: column[data["v_gamma"] >= TRANSIENT] for name, column in data.items() if name.startswith("v_")}
    numbers = [*rheology.estimate(kept["sxy"]), *(kept[name].mean() for name in FIELDS[6:13]), cpu]
    return {**case, **dict(zip(FIELDS[4:], (f"{x:.3f}" for x in numbers)))}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--particles", default="500")
    parser.add_argument("--strain", default="6.5")
    parser.add_argument("--seeds", nargs="+", default=["4711", "11"])
    parser.add_argument("--ranges", nargs="+", default=RANGES)
    parser.add_argument("--fractions", nargs="+", choices=FRACTIONS, default=list(FRACTIONS))
    args = parser.parse_args()
    wanted = [dict(zip(FIELDS, (phi, *which.split(), seed)))
              for which in args.ranges for seed in args.seeds for phi in args.fractions]
    cases.run(wanted, lambda case: measure(case, args.particles, args.strain), HERE / "results.csv", FIELDS)


if __name__ == "__main__":
    main()
