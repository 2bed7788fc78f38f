"""Volume fraction and friction at an imposed pressure against the screened repulsion of the particles.

usage: tools/python.sh study.py [--strength 0 0.03 ...] [--screening 0.02] [--friction 0.5] [--particles 300] [--strain 6] [--seeds 4711 11]
Runs examples/pressure_shear at Iv = 0.01 for each case, appends to results.csv, skips what it already holds. Prints
the table of the README. strength is F/(P d^2), with the largest repulsion F; screening over the radius.
"""
import argparse
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
EXAMPLES = HERE.parents[2] / "examples"
sys.path.insert(0, str(EXAMPLES / "scene"))
import cases    # noqa: E402  pylint: disable=wrong-import-position
import rheology    # noqa: E402  pylint: disable=wrong-import-position

CASE = ["strength", "screening", "friction", "N", "strain", "seed"]
FIELDS = CASE + ["from", "phi", "phi_error", "mu", "mu_error"]


def measure(case):
    data = rheology.simulate(EXAMPLES / "pressure_shear" / "in.pressure_shear", {
        "Iv": "0.01", "friction": case["friction"], "N": case["N"], "strain": case["strain"], "seed": case["seed"], "phi": "0.51",
        "image": "no", "contact": f"repulsion {4 * float(case['strength'])} {case['screening']}"})    # P = 1, d = 2
    start = rheology.steady_from(data["v_gamma"], data["v_phi_now"], data["v_sxy"])
    kept = {name: column[data["v_gamma"] >= start] for name, column in data.items()}
    row = {**case, "from": f"{start:.2f}"}
    for name, column in (("phi", "v_phi_now"), ("mu", "v_sxy")):
        row[name], row[name + "_error"] = (f"{v:.5f}" for v in rheology.estimate(kept[column]))
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--strength", nargs="+", default=["0", "0.03", "0.1", "0.3", "1", "3"])
    parser.add_argument("--screening", default="0.02")
    parser.add_argument("--friction", default="0.5")
    parser.add_argument("--particles", default="300")
    parser.add_argument("--strain", default="6")
    parser.add_argument("--seeds", nargs="+", default=["4711", "11"])
    args = parser.parse_args()
    wanted = [dict(zip(CASE, (strength, args.screening, args.friction, args.particles, args.strain, seed)))
              for seed in args.seeds for strength in args.strength]
    table = HERE / "results.csv"
    cases.run(wanted, measure, table, FIELDS)
    rows = cases.read(table)
    print("| F/(P d^2) | phi | mu |\n|---|---|---|")
    for strength in sorted({row["strength"] for row in rows}, key=float):
        phi, mu = (np.array(cases.columns([row for row in rows if row["strength"] == strength], name)[0]) for name in ("phi", "mu"))
        spread = [np.std(x, ddof=1) / np.sqrt(len(x)) if len(x) > 1 else np.nan for x in (phi, mu)]
        print(f"| {strength} | {phi.mean():.4f} +- {spread[0]:.4f} | {mu.mean():.3f} +- {spread[1]:.3f} |")


if __name__ == "__main__":
    main()
