"""Shear thickening of spheres that repel each other: runs of in.repulsive_thickening, table and figure.

usage: tools/python.sh study.py [--phi 0.45 0.5] [--particles 400] [--strain 10] [--only N] [--jobs 1]
                                [--table study.csv] [--draw]
Appends to the table and skips the cases it already holds. --draw only draws what the table holds.
Forces in the table are over viscosity*rate*radius^2, stresses over viscosity*rate.
"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "scene"))
import cases
import rheology

PRESSURE = 20.0    # unit of stress.txt
FORCES = ["1000", "300", "100", "30", "10", "3", "1"]    # F; stress a^2/F from 0.01 to 30
MEANS = {"viscosity": "v_sxy", "Z": "v_Z", "load": "v_load", "rubs": "v_rubs"}
CASE = ["friction", "F", "phi", "N", "strain"]
FIELDS = CASE + ["from"] + [f"mean_{name}{what}" for name in MEANS for what in ("", "_error")]


def study_cases(phis):
    kinds = [("0.5", F) for F in FORCES] + [("0.5", "0"), ("0", "0"), ("0", "300"), ("0", "30")]
    return [{"friction": friction, "F": F, "phi": phi} for phi in phis for friction, F in kinds]


def measure(case):
    chosen = {name: case[name] for name in ("friction", "phi", "N", "strain")}
    data = rheology.simulate(HERE / "in.repulsive_thickening", {**chosen, "repulsion": case["F"], "pressure": f"{PRESSURE:g}"})
    data["v_sxy"] = data["v_sxy"] * PRESSURE    # over viscosity*rate
    return {**case, **rheology.steady_means(data, MEANS)}


def main():
    parser = cases.parser(__doc__, HERE / "study.csv", ["0.45", "0.5"], "400", "10")
    args = parser.parse_args()
    if not args.draw:
        todo = [{**case, "N": args.particles, "strain": args.strain} for case in study_cases(args.phi)]
        cases.run(todo[:args.only], measure, args.table, FIELDS, args.jobs)
    import plot    # pylint: disable=import-outside-toplevel
    plot.draw(cases.read(args.table), Path(args.table).parent / "figure.png")


if __name__ == "__main__":
    main()
