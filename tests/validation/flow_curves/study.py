"""Flow curves against viscous number and friction: one row a run in results.csv, and where its pairs point in circles.csv.

usage: tools/python.sh study.py [--friction 0 0.1 ...] [--Iv 0.1 ...] [--strain X] [--particles 500] [--seeds 1] [--table results.csv]
Appends to the tables and skips what results.csv already holds. The defaults take 40 minutes of one core.
"""
import argparse
import csv
import resource
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
EXAMPLES = HERE.parents[2] / "examples"
sys.path.insert(0, str(EXAMPLES / "scene"))
import cases    # noqa: E402  pylint: disable=wrong-import-position
import rheology    # noqa: E402  pylint: disable=wrong-import-position

FRICTIONS = ["0", "0.1", "0.2", "0.3", "0.5", "1", "2"]
STRAIN = {"10": "24", "1": "24", "0.3": "16", "0.1": "12", "3e-2": "8", "1e-2": "10", "3e-3": "6", "1e-3": "8", "1e-4": "3"}    # of the averages
TRANSIENT = 1.5    # strain left out
FRACTION = 0.25    # time step over sqrt(mass/stiffness), 1.3 times the limit that the log prints: no bias found (Howto_accuracy)
SEEDS = ["4711", "11", "23", "37"]
BINS = 24    # of the directions; as in in.flow_curves
ORIGINS = ["contact_n", "contact_t", "film_n", "film_t"]
ESTIMATED = ["phi", "mu", *ORIGINS]
NUMBERS = {"Z": 1, "rattlers": 3, "sliding": 6, "mobilized": 13}    # of compute microstructure
COUNTED = ["pairs", "contacts"]
OF_PAIRS = ["gap", "vn", "vt"]    # means over the pairs of a direction
COLUMNS = ["angle", "pairs", "contacts", "frictional", "gap", "force", "friction", "vn", "vt", *ORIGINS]    # of compute microstructure angle
CASE = ["Iv", "friction", "N", "strain", "seed"]
FIELDS = CASE + [name for quantity in ESTIMATED for name in (quantity, quantity + "_error")] + \
    ["ratio", "ratio_error", "sxx", "syy", "szz", "drift", *NUMBERS, "cpu"]


def phi_to_start(iv, friction):
    """Near the volume fraction of films alone, which are below the sqrt(Iv) of the laws at large Iv."""
    return min(0.99 * rheology.phi_m_chevremont(friction) / (1 + min(0.84 * iv**0.5, 0.63 * iv**0.36)), 0.61)


def read(folder):
    """Columns of stress.txt, of the directions, and the averages over all pairs."""
    circle = np.loadtxt(Path(folder) / "circle.txt", skiprows=4)[:, 1:]
    numbers = np.loadtxt(Path(folder) / "number.txt")[1:]
    return rheology.read_run(folder), dict(zip(COLUMNS, circle.T)), numbers


def directions(circle, rate):
    """The curves of circles.csv, over pressure (1) and rate*2 radii."""
    pairs = np.where(circle["pairs"] > 0, circle["pairs"], np.inf)
    curves = {name: circle[name] for name in COUNTED + ORIGINS}
    curves.update({name: circle[name] / pairs / (1 if name == "gap" else 2 * rate) for name in OF_PAIRS})
    return curves


def measure(case, circles):
    """One row of the table; appends the curves of the directions to circles."""
    iv = float(case["Iv"])
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    data, circle, numbers = rheology.simulate(HERE / "in.flow_curves", {
        "Iv": case["Iv"], "friction": case["friction"], "N": case["N"], "averages": case["strain"], "strain": TRANSIENT,
        "seed": case["seed"], "phi": f"{phi_to_start(iv, float(case['friction'])):.4f}", "fraction": FRACTION}, read=read)
    cpu = (resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before) / (float(case["strain"]) + TRANSIENT)
    kept = {name[2:]: column[data["v_gamma"] >= TRANSIENT] for name, column in data.items() if name.startswith("v_")}
    kept["phi"], kept["mu"] = kept["phi_now"], kept["sxy"]
    numbers_of = [x for name in ESTIMATED for x in rheology.estimate(kept[name])]
    numbers_of += rheology.ratio(kept["contact_t"], kept["contact_n"])
    numbers_of += [kept[name].mean() for name in ("sxx", "syy", "szz")]
    half = len(kept["phi"]) // 2
    numbers_of.append(kept["phi"][half:].mean() - kept["phi"][:half].mean())
    numbers_of += [numbers[n - 1] for n in NUMBERS.values()] + [cpu]
    new = not circles.exists()
    with open(circles, "a", newline="", encoding="ascii") as file:
        writer = csv.writer(file, lineterminator="\n")
        if new:
            writer.writerow(CASE + ["quantity"] + [f"b{n}" for n in range(BINS)])
        for name, curve in directions(circle, iv).items():
            writer.writerow([*case.values(), name, *(f"{x:.4g}" for x in curve)])
    return {**case, **dict(zip(FIELDS[len(CASE):], (f"{x:.5g}" for x in numbers_of)))}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--friction", nargs="+", default=FRICTIONS)
    parser.add_argument("--Iv", nargs="+", default=list(STRAIN))
    parser.add_argument("--strain", help="of the averages; by default it depends on Iv")
    parser.add_argument("--particles", default="500")
    parser.add_argument("--seeds", type=int, default=1)
    parser.add_argument("--table", type=Path, default=HERE / "results.csv")
    args = parser.parse_args()
    wanted = [dict(zip(CASE, (iv, friction, args.particles, args.strain or STRAIN[iv], seed)))
              for seed in SEEDS[:args.seeds] for iv in args.Iv for friction in args.friction]
    circles = args.table.with_name("circles.csv")
    cases.run(wanted, lambda case: measure(case, circles), args.table, FIELDS)


if __name__ == "__main__":
    main()
