"""Normal viscosities and their parts against volume fraction and friction.

usage: tools/python.sh study.py [--friction 0 ...] [--phi 0.4 ...] [--range "cut 0.5" ...] [--particles 500]
                                [--strain X] [--seeds 1] [--table runs.csv]
Runs examples/normal_viscosity for each case, appends to the table, skips what it already holds. An hour of one core.
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

FRICTIONS = ["0.5", "0", "0.1", "0.3", "1"]
COMMON = ["0.5", "0.35", "0.4", "0.45", "0.3"]    # volume fractions, for all frictions
DENSE = {"0": ["0.55", "0.585", "0.61"], "0.1": ["0.55", "0.575", "0.594"], "0.3": ["0.53", "0.55", "0.57"],
         "0.5": ["0.53", "0.55"], "1": ["0.52", "0.53"]}    # up to 0.97 of jamming
SEEDS = ["4711", "11", "23", "37"]
ORIGINS, COMPONENTS = ("contact_n", "contact_t", "film_n", "film_t"), ("xx", "yy", "zz")
PARTS = [f"{origin}_{component}" for component in COMPONENTS for origin in ORIGINS]
QUANTITIES = ["eta_11", "eta_22", "eta_33", "lambda_11", "lambda_33", *PARTS, "sxy"]
CASE = ["friction", "phi", "range", "N", "strain", "seed"]
FIELDS = CASE + [name for quantity in QUANTITIES for name in (quantity, quantity + "_error")] + ["other", "cpu"]
TRANSIENT = 1.5    # strain left out
FRACTION = 0.25    # time step over sqrt(mass/stiffness), 1.3 times the limit that the log prints: no bias found (Howto_accuracy)


def stiffness(case):
    """Over viscosity*rate*radius; more where the loads would crush the asperities."""
    near = float(case["phi"]) / rheology.phi_m_chevremont(float(case["friction"]))
    return 1e6 if near < 0.9 else 3e6 if near < 0.95 else 1e7


def measure(case):
    """One row of the table: means after the transient and their errors, over viscosity*rate; CPU seconds per unit of strain."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    data = rheology.simulate(EXAMPLES / "normal_viscosity" / "in.normal_viscosity",
                             {**case, "stiffness": f"{stiffness(case):g}", "fraction": FRACTION, "transient": TRANSIENT,
                              "angles": 0})
    cpu = (resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before) / float(case["strain"])
    kept = {name[2:]: column[data["v_gamma"] >= TRANSIENT] for name, column in data.items() if name.startswith("v_")}
    found = {f"eta_{i}{i}": rheology.estimate(-kept[name]) for i, name in enumerate(("sxx", "syy", "szz"), 1)}
    found.update({"lambda_11": rheology.ratio(kept["sxx"], kept["syy"]), "lambda_33": rheology.ratio(kept["szz"], kept["syy"])})
    found.update({name: rheology.estimate(kept[name]) for name in [*PARTS, "sxy"]})
    other = max((abs((kept["s" + c] - sum(kept[f"{origin}_{c}"] for origin in ORIGINS)).mean()) for c in COMPONENTS))
    numbers = [x for quantity in QUANTITIES for x in found[quantity]] + [other, cpu]
    return {**case, **dict(zip(FIELDS[len(CASE):], (f"{x:.5g}" for x in numbers)))}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--friction", nargs="+", default=FRICTIONS)
    parser.add_argument("--phi", nargs="+")
    parser.add_argument("--range", nargs="+", default=["cut 0.5"], help="of the films")
    parser.add_argument("--particles", default="500")
    parser.add_argument("--strain", help="default 8, and 6 where a unit of it costs several times as much")
    parser.add_argument("--seeds", type=int, default=1)
    parser.add_argument("--table", default=str(HERE / "runs.csv"))
    args = parser.parse_args()
    wanted = [dict(zip(CASE, (friction, phi, reach, args.particles, args.strain or ("8" if phi in COMMON else "6"), seed)))
              for seed in SEEDS[:args.seeds] for reach in args.range for friction in args.friction
              for phi in args.phi or COMMON + DENSE.get(friction, [])]
    cases.run(wanted, measure, args.table, FIELDS)


if __name__ == "__main__":
    main()
