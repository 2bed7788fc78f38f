"""Shear thickening by the critical-load law: runs of in.shear_thickening, table and figure.

usage: tools/python.sh study.py [--parts pressure stress rate] [--particles 250] [--strain 5] [--seeds 1] [--jobs 1]
                                [--table study.csv] [--draw]
  pressure  imposed pressure: frictionless, frictional, at fixed pressure, at fixed rate
  stress    flow curves at imposed stress and volume
  rate      the same at imposed rate, started from frictionless and from frictional flow
Appends to the table and skips the cases it already holds. --draw only draws what the table holds.
Forces in the table are over pressure*radius^2, with drive rate over viscosity*rate*radius^2.
"""
import argparse
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "scene"))
import cases
import rheology

MEANS = {"rate": "v_gamma_dot", "phi": "v_phi_now", "mu": "v_sxy", "pressure": "v_syy", "Z": "v_Z", "chi_f": "v_chi_f"}
CASE = ["drive", "Iv", "phi", "before", "load", "N", "strain", "seed"]
FIELDS = CASE + ["from", "crept"] + [f"mean_{name}{what}" for name in MEANS for what in ("", "_error")]
SEEDS = [4711, 11, 23, 37, 59]
NEVER = "1e9"    # load that no contact reaches: frictionless

IVS = ["0.1", "0.03", "0.01", "0.003", "0.001"]
LOAD, IV0 = 6.0, 0.01    # the lines of fixed pressure and of fixed rate meet here,
SLOW = 0.003             # and here at a lower rate
STRESSES = ["0.1", "0.3", "0.6", "1", "1.6", "3", "10"]    # stress*d^2/F*, d = 2
PHIS = ["0.50", "0.54", "0.55", "0.56"]
RATES = {"0.55": ["0.006"], "0.56": ["0.0035", "0.0045", "0.002", "0.007"]}    # viscosity*rate*d^2/F*


def pressure_cases():
    lines = [("0.01", str(load)) for load in (1, 4, 8)]
    lines += [(iv, f"{LOAD * float(iv) / SLOW:g}") for iv in ("0.03", "0.01", "0.001")]
    for iv in IVS:
        lines += [(iv, load) for load in ("0", NEVER, f"{LOAD:g}", f"{LOAD * float(iv) / IV0:g}")]
    return [{"drive": "iv", "Iv": iv, "phi": "", "before": load, "load": load} for iv, load in dict.fromkeys(lines)]


def stress_cases():
    return [{"drive": "stress", "Iv": "", "phi": phi, "before": f"{4 / float(s):.5g}", "load": f"{4 / float(s):.5g}"}
            for phi in PHIS for s in STRESSES]


def rate_cases():
    return [{"drive": "rate", "Iv": "", "phi": phi, "before": start, "load": f"{4 / float(rate):.5g}"}
            for phi, rates in RATES.items() for rate in rates for start in ("0", NEVER)]


def variables(case):
    """Index variables of the deck for a case."""
    chosen = {name: case[name] for name in ("drive", "before", "load", "N", "strain", "seed")}
    if case["drive"] == "iv":
        phi = rheology.phi_to_start(float(case["Iv"]), 1 - np.tanh(0.13 * float(case["load"])))
        return {**chosen, "Iv": case["Iv"], "phi": f"{phi:.4f}", "steps": 10000000}
    chosen["phi"] = case["phi"]
    if case["drive"] == "rate":    # hard also at the stress of the branch, and in a packing that starts frictional
        stiffness = "5e7" if case["before"] == "0" else "5e6"
        return {**chosen, "rate": 1, "stiffness": stiffness, "presheared": 1, "steps": 10000000}
    return {**chosen, "rate": 0.02, "stokes": 0.1, "steps": 250000}


def measure(case):
    data = rheology.simulate(HERE / "in.shear_thickening", variables(case))
    strain = data["v_gamma"]
    data["v_syy"] = -data["v_syy"]
    means = rheology.steady_means(data, MEANS, ("v_phi_now" if case["drive"] == "iv" else "v_gamma_dot", "v_sxy"))
    return {**case, **means, "crept": f"{strain[-1] - strain[0]:.2f}"}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--parts", nargs="+", default=["pressure", "stress", "rate"])
    parser.add_argument("--only", type=int, help="the first cases of each part")
    parser.add_argument("--particles", default="250")
    parser.add_argument("--strain", default="5", help="of part rate at most 3")
    parser.add_argument("--seeds", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--table", default=str(HERE / "study.csv"))
    parser.add_argument("--draw", action="store_true")
    args = parser.parse_args()
    if not args.draw:
        parts = {"pressure": pressure_cases(), "stress": stress_cases(), "rate": rate_cases()}
        strain = {part: args.strain if part != "rate" or float(args.strain) < 3 else "3" for part in parts}
        todo = [{**case, "N": args.particles, "strain": strain[part], "seed": str(seed)}
                for seed in SEEDS[:args.seeds] for part in args.parts for case in parts[part][:args.only]]
        cases.run(todo, measure, args.table, FIELDS, args.jobs)
    import plot    # pylint: disable=import-outside-toplevel
    plot.draw(cases.read(args.table), Path(args.table).parent / "figure.png")


if __name__ == "__main__":
    main()
