"""Volume fraction and friction against the fraction of rough particles: runs of in.binary_mixture, table and figure.

usage: tools/python.sh study.py [--Iv 0.1 0.01 0.001] [--x 0 0.25 0.5 0.75 1] [--particles 300] [--strain 6]
                                [--seeds 1] [--jobs 1] [--table study.csv] [--draw]
Appends to the table and skips the cases it already holds. --draw only draws what the table holds.
"""
import argparse
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "scene"))
import cases
import rheology

MEANS = {"phi": "v_phi_now", "mu": "v_sxy", "Z": "v_Z", "chi_f": "v_chi_f"}
FIELDS = ["Iv", "x", "N", "strain", "seed", "from"] + [name + what for name in MEANS for what in ("", "_error")]
SEEDS = [4711, 11, 23, 37, 59]


def measure(case):
    start_phi = rheology.phi_to_start(float(case["Iv"]), float(case["x"]) ** 2)
    variables = {name: value for name, value in case.items() if name in ("Iv", "x", "N", "strain", "seed")}
    data = rheology.simulate(HERE / "in.binary_mixture", {**variables, "phi": f"{start_phi:.4f}"})
    start = rheology.steady_from(data["v_gamma"], data["v_phi_now"], data["v_sxy"])
    row = dict(case)
    row["from"] = f"{start:.2f}"
    for name, column in MEANS.items():
        row[name], row[name + "_error"] = (f"{v:.5f}" for v in rheology.estimate(data[column][data["v_gamma"] >= start]))
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--Iv", nargs="+", default=["0.1", "0.01", "0.001"])
    parser.add_argument("--x", nargs="+", default=["0", "0.25", "0.5", "0.75", "1"])
    parser.add_argument("--particles", default="300")
    parser.add_argument("--strain", default="6")
    parser.add_argument("--seeds", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--table", default=str(HERE / "study.csv"))
    parser.add_argument("--draw", action="store_true")
    args = parser.parse_args()
    if not args.draw:
        todo = [{"Iv": iv, "x": x, "N": args.particles, "strain": args.strain, "seed": str(seed)}
                for seed in SEEDS[:args.seeds] for iv in args.Iv for x in args.x]
        cases.run(todo, measure, args.table, FIELDS, args.jobs)
    import plot    # pylint: disable=import-outside-toplevel
    plot.draw(cases.read(args.table), Path(args.table).parent / "figure.png")


if __name__ == "__main__":
    main()
