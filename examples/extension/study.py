"""Viscosity in extension and in shear: runs of in.extension, table and figure.

usage: tools/python.sh study.py [--phi 0.40 0.45 0.50 0.53] [--friction 0.5 0] [--particles 1000] [--strain 3.5] [--seeds 2]
                                [--only N] [--jobs 1] [--table study.csv] [--draw]
Appends to the table and skips the cases it already holds. --draw only draws what the table holds.
Stresses in the table are over viscosity*rate, rate = sqrt(2 E:E).
"""
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "scene"))
import cases
import rheology

PRESSURE = 20.0      # unit of stress.txt
TRANSIENT = 1.0      # strain that is left out
BLOCKS = 5           # of the rest; their means are taken for independent
SHARE = {"shear": 1.0, "planar": 0.5, "uniaxial": 1 / np.sqrt(3)}    # rate of the flow over sqrt(2 E:E)
CASE = ["flow", "friction", "phi", "N", "strain", "seed"]
FIELDS = CASE + ["viscosity", "viscosity_error", "pressure", "pressure_error"]


def viscosity(flow, data):
    """Relative one: driving stress over that of the fluid without particles."""
    xx, yy, zz = (PRESSURE * data[name] for name in ("v_sxx", "v_syy", "v_szz"))
    if flow == "planar":
        return 1 + (xx - yy) / (4 * SHARE[flow])
    if flow == "uniaxial":
        return 1 + (xx - 0.5 * (yy + zz)) / (3 * SHARE[flow])
    return PRESSURE * data["v_sxy"]    # with the fluid


def measure(case):
    data = rheology.simulate(HERE / "in.extension", {**case, "pressure": f"{PRESSURE:g}"})
    late = data["v_gamma"] >= TRANSIENT * SHARE[case["flow"]]
    mean = -PRESSURE / 3 * (data["v_sxx"] + data["v_syy"] + data["v_szz"])
    row = dict(case)
    for name, values in (("viscosity", viscosity(case["flow"], data)), ("pressure", mean)):
        means = np.array([block.mean() for block in np.array_split(values[late], BLOCKS)])
        row[name], row[name + "_error"] = f"{means.mean():.5g}", f"{means.std(ddof=1) / np.sqrt(BLOCKS):.2g}"
    return row


def main():
    parser = cases.parser(__doc__, HERE / "study.csv", ["0.40", "0.45", "0.50", "0.53"], "1000", "3.5")
    parser.add_argument("--friction", nargs="+", default=["0.5", "0"])
    parser.add_argument("--seeds", type=int, default=2)
    args = parser.parse_args()
    if not args.draw:
        todo = [{"flow": flow, "friction": friction, "phi": phi, "N": args.particles, "strain": args.strain, "seed": seed}
                for seed in range(1, args.seeds + 1) for friction in args.friction for phi in args.phi for flow in SHARE]
        cases.run(todo[:args.only], measure, args.table, FIELDS, args.jobs)
    import plot    # pylint: disable=import-outside-toplevel
    plot.draw(cases.read(args.table), Path(args.table).parent / "figure.png")


if __name__ == "__main__":
    main()
