"""Friction and area fraction of discs against J (viscous) and I (inertial): many runs of in.discs_2d, a table, the figure.

usage: tools/python.sh study.py [--J 1e-3 ... 0.1] [--I 3e-3 ... 0.3] [--friction 0 0.4] [--particles 600] [--strain 10]
                                [--seeds 1] [--jobs 2] [--table discs_2d.csv] [--draw]
Appends to the table and skips the cases it already holds, so a study can be stopped and extended.
--draw only draws what the table holds. The defaults take about 25 minutes of one core.
"""
import argparse
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "scene"))
import cases
import rheology

CASE = ["regime", "number", "friction", "N", "strain", "seed"]
FIELDS = CASE + ["from", "phi", "phi_error", "mu", "mu_error", "p"]
SEEDS = [4711, 11, 23, 37, 59]


def start_phi(case):
    """Near the steady area fraction, to save strain; random packings end at 0.81."""
    most, slope = (0.84, 0.41) if float(case["friction"]) == 0 else (0.80, 0.63)
    number = float(case["number"])
    return min(most - slope * (number ** 0.5 if case["regime"] == "viscous" else 0.8 * number), 0.81)


def measure(case):
    """One row of the table: means over the steady part and their errors."""
    data = rheology.simulate(HERE / "in.discs_2d", {**case, "phi": f"{start_phi(case):.4f}"})
    start = rheology.steady_from(data["v_gamma"], data["v_phi_now"], data["v_mu"])
    kept = {name: column[data["v_gamma"] >= start] for name, column in data.items()}
    row = dict(case)
    row["from"] = f"{start:.2f}"
    for name, column in (("phi", "v_phi_now"), ("mu", "v_mu")):
        mean, error = rheology.estimate(kept[column])
        row[name], row[name + "_error"] = f"{mean:.5f}", f"{error:.5f}"
    row["p"] = f"{kept['v_p'].mean():.4f}"
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--J", nargs="*", default=["1e-3", "3e-3", "1e-2", "3e-2", "0.1"])
    parser.add_argument("--I", nargs="*", default=["3e-3", "1e-2", "3e-2", "0.1", "0.3"])
    parser.add_argument("--friction", nargs="+", default=["0", "0.4"])
    parser.add_argument("--particles", default="600")
    parser.add_argument("--strain", default="10")
    parser.add_argument("--seeds", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--table", default=str(HERE / "discs_2d.csv"))
    parser.add_argument("--draw", action="store_true")
    args = parser.parse_args()
    if not args.draw:
        wanted = [{"regime": regime, "number": number, "friction": friction, "N": args.particles, "strain": args.strain,
                  "seed": str(seed)} for regime, numbers in (("viscous", args.J), ("inertial", args.I))
                 for number in numbers for friction in args.friction for seed in SEEDS[:args.seeds]]
        wanted.sort(key=lambda case: -float(case["number"]) * (10 if case["regime"] == "viscous" else 1))    # the shortest first
        cases.run(wanted, measure, args.table, FIELDS, args.jobs)
    import plot    # pylint: disable=import-outside-toplevel
    plot.draw(cases.read(args.table), Path(args.table).with_suffix(".png"))


if __name__ == "__main__":
    main()
