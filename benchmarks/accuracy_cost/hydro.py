"""Error of fix hydro grid, one knob at a time: the loads of one moment, and the viscosity of a sheared suspension.

usage: tools/python.sh hydro.py [PART ...] [--jobs 1]      parts: moment, flow, by default all
Runs in.hydro and examples/dilute_to_dense, appends to hydro.csv what it lacks, draws hydro.png. See README.md.
"""
import argparse
import resource
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt    # noqa: E402
import numpy as np    # noqa: E402

import pore    # noqa: E402

HERE = Path(__file__).resolve().parent
EXAMPLES = HERE.parents[1] / "examples"
sys.path.insert(0, str(EXAMPLES / "dilute_to_dense"))
import study    # noqa: E402  pylint: disable=wrong-import-position
from study import cases, rheology    # noqa: E402  pylint: disable=wrong-import-position

TABLE = HERE / "hydro.csv"
CASE = ["part", "knob", "value", "phi", "seed"]
# moment: error of the power and of the stress of the stresslets against the finest settings; flow: relative viscosity and its error
FIELDS = CASE + ["first", "second", "iterations", "cpu"]
FINEST = "spacing 0.5 points 12 reach 9 tol 1e-9"
MOMENT = {"tol": [0.3, 0.1, 0.03, 0.01, 1e-3, 1e-4], "spacing": [1.0, 0.9, 0.82, 0.69, 0.5], "points": [4, 6, 8, 10, 12],
          "reach": [3, 4, 5, 6, 7], "width": [0.8, 0.9, 1, 1.1, 1.25]}
FLOW = {"strain": [0.01, 0.0025, 0.005, 0.02, 0.00125], "tol": [0.1, 0.03], "hold": ["20 4"]}    # others: the base
BASE = {"strain": "0.0025", "tol": "0.01", "hold": "auto"}
PARTICLES, STRAIN = 500, 6


def moment(far, phi, seed):
    """Power of the fluid, stress of the stresslets, iterations from nothing."""
    text = pore.lammps(HERE, HERE / "in.hydro", far=far, phi=phi, seed=seed, scene=EXAMPLES / "scene",
                       packing=EXAMPLES / "packing" / "packing.lmp")
    t = pore.thermo(text)
    return t["f_far[9]"][0], t["f_far[6]"][0], t["f_far[1]"][0]


def of_moment(case):
    """Errors of the power and of the stress: those of the knob alone, the default of all others solved to rounding."""
    far = f"{case['knob']} {case['value']}" + (" tol 1e-9" if case["knob"] != "tol" else "")
    power, stress, iterations = moment(far, case["phi"], case["seed"])
    best = moment(FINEST if case["knob"] != "tol" else "tol 1e-9", case["phi"], case["seed"])
    return {**case, "first": f"{power / best[0] - 1:.2e}", "second": f"{stress / best[1] - 1:.2e}", "iterations": f"{iterations:.0f}", "cpu": ""}


def of_flow(case):
    """Relative viscosity, its error, CPU seconds per unit of strain."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    far = " ".join(f"{name} {value}" for name, value in {**BASE, case["knob"]: case["value"]}.items())
    data = rheology.simulate(study.HERE / "in.dilute_to_dense", {
        "level": "grid", "range": "residual 1", "far": far, "friction": 0.5, "roughness": 0.01, "stiffness": 1e6, "phi": case["phi"],
        "seed": case["seed"], "N": PARTICLES, "strain": STRAIN})
    cpu = (resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before) / STRAIN
    eta, error = rheology.estimate(data["v_sxy"][data["v_gamma"] >= study.TRANSIENT])
    return {**case, "first": f"{eta:.4g}", "second": f"{error:.2g}", "iterations": "", "cpu": f"{cpu:.3g}"}


def draw():
    rows = cases.read(TABLE)

    def of(part, knob, phi, *columns):
        found = [row for row in rows if (row["part"], row["knob"], row["phi"]) == (part, knob, phi)]
        return [np.array(column) for column in zip(*sorted(zip(*cases.columns(found, "value", *columns))))]

    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6))
    for knob, mark in (("tol", "o"), ("points", "s"), ("reach", "^"), ("spacing", "D"), ("width", "v")):
        value, power, stress = of("moment", knob, "0.5", "first", "second")
        left.loglog(value, np.maximum(np.abs(power), np.abs(stress)), mark + "-", ms=4, label=knob)
    left.set(xlabel="value", ylabel="relative error of a solution", ylim=(1e-7, 1))
    left.legend(frameon=False, fontsize=7)
    value, eta, error, cpu = of("flow", "strain", "0.45", "first", "second", "cpu")
    right.errorbar(value, eta, error, fmt="o-", ms=4, color="C0")
    right.set(xscale="log", xlabel="strain between two solutions", ylabel="relative viscosity", ylim=(0, None))
    right.set_xticks(value, [f"{x:g}" for x in value])
    right.minorticks_off()
    cost = right.twinx()
    cost.plot(value, cpu, "s--", ms=4, color="0.5")
    cost.set_ylabel("CPU seconds per unit of strain", color="0.5")
    cost.set_ylim(bottom=0)
    figure.tight_layout()
    figure.savefig(HERE / "hydro.png", dpi=150)


def wanted(part):
    if part == "moment":
        return [dict(zip(CASE, (part, knob, str(value), phi, "4711"))) for phi in ("0.3", "0.5") for knob, values in MOMENT.items() for value in values]
    return [dict(zip(CASE, (part, knob, str(value), "0.45", "4711"))) for knob, values in FLOW.items() for value in values]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="*", default=["moment", "flow"])
    parser.add_argument("--jobs", type=int, default=1)
    args = parser.parse_args()
    for part, measure in (("moment", of_moment), ("flow", of_flow)):
        if part in args.parts:
            cases.run(wanted(part), measure, TABLE, FIELDS, args.jobs)
    draw()


if __name__ == "__main__":
    main()
