"""Friction and volume fraction against the viscous number: many runs of ../pressure_shear, a table and the figure.

usage: tools/python.sh study.py [--Iv 1e-3 ... 1] [--friction 0 0.3 0.5] [--particles 500] [--strain 8] [--seeds 1]
                                [--jobs 2] [--table mu_of_iv.csv] [--draw]
Appends to the table and skips the cases it already holds, so a study can be stopped and extended.
--draw only draws what the table holds. The defaults take ten minutes on 2 cores.
"""
import argparse
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "scene"))
import cases
import rheology

PARTS = ["contact_n", "contact_t", "film_n", "film_t", "inertia"]
NORMALS = ["sxx", "syy", "szz"]
CASE = ["Iv", "friction", "N", "strain", "seed"]
FIELDS = CASE + ["from", "phi", "phi_error", "mu", "mu_error", *PARTS, *NORMALS]
SEEDS = [4711, 11, 23, 37, 59]


def measure(case):
    """One row of the table: means over the steady part and their errors."""
    iv, friction = float(case["Iv"]), float(case["friction"])
    start_phi = min(0.98 * rheology.phi_chevremont(iv, friction), 0.57)
    data = rheology.simulate(HERE.parent / "pressure_shear" / "in.pressure_shear", {
        "Iv": iv, "friction": friction, "N": case["N"], "strain": case["strain"], "seed": case["seed"],
        "phi": f"{start_phi:.4f}", "image": "no"})
    start = rheology.steady_from(data["v_gamma"], data["v_phi_now"], data["v_sxy"])
    kept = {name: column[data["v_gamma"] >= start] for name, column in data.items()}
    row = dict(case)
    row["from"] = f"{start:.2f}"
    for name, column in (("phi", "v_phi_now"), ("mu", "v_sxy")):
        mean, error = rheology.estimate(kept[column])
        row[name], row[name + "_error"] = f"{mean:.5f}", f"{error:.5f}"
    for name in PARTS + NORMALS:
        row[name] = f"{kept['v_' + name].mean():.5f}"
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--Iv", nargs="+", default=["1e-3", "3e-3", "1e-2", "3e-2", "0.1", "0.3", "1"])
    parser.add_argument("--friction", nargs="+", default=["0", "0.3", "0.5"])
    parser.add_argument("--particles", default="500")
    parser.add_argument("--strain", default="8")
    parser.add_argument("--seeds", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--table", default=str(HERE / "mu_of_iv.csv"))
    parser.add_argument("--draw", action="store_true")
    args = parser.parse_args()
    if not args.draw:
        wanted = [{"Iv": iv, "friction": friction, "N": args.particles, "strain": args.strain, "seed": str(seed)}
                 for iv in args.Iv for friction in args.friction for seed in SEEDS[:args.seeds]]
        wanted.sort(key=lambda case: float(case["Iv"]))    # the longest first
        cases.run(wanted, measure, args.table, FIELDS, args.jobs)
    import plot    # pylint: disable=import-outside-toplevel
    plot.draw(cases.read(args.table), Path(args.table).with_suffix(".png"))


if __name__ == "__main__":
    main()
