"""Shear thinning by load-dependent friction: runs of in.shear_thinning, table and figure.

usage: tools/python.sh study.py [--phi 0.45] [--particles 160] [--strain 4] [--only N] [--jobs 1]
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
MU = "0.27"        # under large loads
LOADS = ["2000", "200", "20", "2", "0.2"]       # F of the law brizmer; stress a^2/F from 0.01 to 100
COULOMB = ["0.27", "0.4", "0.7", "1.5", "5"]    # coefficients of Coulomb's law
MEANS = {"viscosity": "v_sxy", "Z": "v_Z", "load": "v_load", "rubs": "v_rubs"}
CASE = ["law", "mu", "F", "phi", "N", "strain"]
FIELDS = CASE + ["from"] + [f"mean_{name}{what}" for name in MEANS for what in ("", "_error")]


def study_cases(phis):
    laws = [("brizmer", MU, F) for F in LOADS] + [("coulomb", mu, "") for mu in COULOMB]
    return [{"law": law, "mu": mu, "F": F, "phi": phi} for phi in phis for law, mu, F in laws]


def measure(case):
    chosen = {name: case[name] for name in ("law", "phi", "N", "strain")}
    data = rheology.simulate(HERE / "in.shear_thinning",
                             {**chosen, "friction": case["mu"], "critical": case["F"], "pressure": f"{PRESSURE:g}"})
    data["v_sxy"] = data["v_sxy"] * PRESSURE    # over viscosity*rate
    return {**case, **rheology.steady_means(data, MEANS)}


def main():
    parser = cases.parser(__doc__, HERE / "study.csv", ["0.45"], "160", "4")
    args = parser.parse_args()
    if not args.draw:
        todo = [{**case, "N": args.particles, "strain": args.strain} for case in study_cases(args.phi)]
        cases.run(todo[:args.only], measure, args.table, FIELDS, args.jobs)
    import plot    # pylint: disable=import-outside-toplevel
    plot.draw(cases.read(args.table), Path(args.table).parent / "figure.png")


if __name__ == "__main__":
    main()
