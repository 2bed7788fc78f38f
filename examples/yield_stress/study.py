"""Flow curves with and without adhesion and the creep under a stress: runs of in.yield_stress, tables and figure.

usage: tools/python.sh study.py [--adhesion 1e-3 ... --stiffness 1e3 --strain 5 --rates 0.01 ...] [--stress 0.005 ...]
                                [--particles 250] [--seeds 1] [--jobs 1] [--table flow.csv] [--creep creep.csv] [--draw]
Appends to the tables and skips the cases they already hold. --draw only draws what they hold.
"""
import argparse
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "scene"))
import cases
import rheology

PARTS = ["contact_n", "contact_t", "film_n", "film_t"]
CASE = ["adhesion", "stiffness", "phi", "rate", "N", "strain", "seed"]
FLOW = CASE + ["from", "sxy", "sxy_error", *PARTS, "pressure", "pressure_error"]
CREEP = CASE + ["stress", "steps", "crept", "last_rate", "last_rate_error"]
ALL = ["0.01", "0.003", "0.001", "3e-4", "1e-4", "3e-5"]
# adhesion, stiffness, strain, rates of the curves in flow.csv
CURVES = [("1e-3", "1e3", "5", ALL), ("0", "1e3", "5", ["0.01", "0.001"]), ("2e-3", "1e3", "4", ALL[:5]),
          ("5e-4", "1e3", "4", ALL[:5]), ("5e-3", "200", "4", ALL[1:5])]
SEEDS = [4711, 11, 23, 37, 59]


def run(case):
    return rheology.simulate(HERE / "in.yield_stress", {**case, "stokes": "0.05"})


def flow(case):
    """Stress at a rate."""
    data = run(case)
    start = rheology.steady_from(data["v_gamma"], data["v_sxy"])
    kept = {name: column[data["v_gamma"] >= start] for name, column in data.items()}
    row = dict(case)
    row["from"] = f"{start:.2f}"
    row["sxy"], row["sxy_error"] = (f"{v:.5f}" for v in rheology.estimate(kept["v_sxy"]))
    row["pressure"], row["pressure_error"] = (f"{v:.5f}" for v in rheology.estimate(-kept["v_syy"]))
    for name in PARTS:
        row[name] = f"{kept['v_' + name].mean():.5f}"
    return row


def creep(case):
    """Strain under a stress after flow at a rate, and the rate in the last third."""
    data = run(case)
    flowing = int(np.sum(data["v_gamma"] <= float(case["strain"])))
    strain = data["v_gamma"][flowing:]
    rate = data["v_gamma_dot"][flowing + 2 * (len(strain) // 3):]
    row = dict(case)
    row["crept"] = f"{strain[-1] - strain[0]:.5f}"
    row["last_rate"], row["last_rate_error"] = (f"{v:.3e}" for v in rheology.estimate(rate))
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rates", nargs="*", default=ALL)
    parser.add_argument("--adhesion", nargs="+", help="other curves than those of flow.csv, with --stiffness, --strain, --rates")
    parser.add_argument("--stiffness", default="1e3")
    parser.add_argument("--phi", default="0.5")
    parser.add_argument("--stress", nargs="*", default=["0.005", "0.01", "0.015", "0.03", "0.06", "0.12"])
    parser.add_argument("--creeping", default="1e-3", help="adhesion of those under a stress")
    parser.add_argument("--before", default="2", help="strain at the rate 0.001 before a stress")
    parser.add_argument("--steps", default="60000")
    parser.add_argument("--particles", default="250")
    parser.add_argument("--strain", default="5")
    parser.add_argument("--seeds", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--table", default=str(HERE / "flow.csv"))
    parser.add_argument("--creep", default=str(HERE / "creep.csv"))
    parser.add_argument("--draw", action="store_true")
    args = parser.parse_args()
    common = {"phi": args.phi, "N": args.particles}
    curves = [(a, args.stiffness, args.strain, args.rates) for a in args.adhesion] if args.adhesion else CURVES
    if not args.draw:
        todo = [{"adhesion": adhesion, "stiffness": stiffness, **common, "rate": rate, "strain": strain, "seed": str(seed)}
                for seed in SEEDS[:args.seeds] for adhesion, stiffness, strain, rates in curves for rate in rates]
        cases.run(todo, flow, args.table, FLOW, args.jobs)
        todo = [{"adhesion": args.creeping, "stiffness": args.stiffness, **common, "rate": "0.001", "strain": args.before, "seed": str(SEEDS[0]),
                 "stress": stress, "steps": args.steps} for stress in args.stress]
        cases.run(todo, creep, args.creep, CREEP, args.jobs)
    import plot    # pylint: disable=import-outside-toplevel
    plot.draw(cases.read(args.table), cases.read(args.creep), Path(args.table).parent / "figure.png")


if __name__ == "__main__":
    main()
