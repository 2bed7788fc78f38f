"""Volume fraction and friction under an imposed pressure, at each level of the far field.

usage: tools/python.sh imposed.py [--Iv 0.1 1] [--friction 0.5] [--particles 500] [--strain 6] [--seeds 1] [--jobs 1]
Runs examples/pressure_shear for each case, appends to imposed.csv, skips what it already holds.
"""
import argparse
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
EXAMPLES = HERE.parents[2] / "examples"
sys.path.insert(0, str(EXAMPLES / "scene"))
import cases    # noqa: E402  pylint: disable=wrong-import-position
import rheology    # noqa: E402  pylint: disable=wrong-import-position

CASE = ["level", "rule", "range", "Iv", "friction", "N", "strain", "seed"]
FIELDS = CASE + ["from", "phi", "phi_error", "mu", "mu_error", "contact_n", "contact_t", "film_n", "film_t", "stresslet"]
SEEDS = ["4711", "11", "23", "37", "59"]


def measure(case):
    """One row of the table: means over the steady part and their errors."""
    start_phi = min(0.98 * rheology.phi_chevremont(float(case["Iv"]), float(case["friction"])), 0.57)
    data = rheology.simulate(EXAMPLES / "pressure_shear" / "in.pressure_shear", {
        **{name: case[name] for name in ("level", "Iv", "friction", "N", "strain", "seed")},
        "range": f"{case['rule']} {case['range']}", "phi": f"{start_phi:.4f}", "image": "no"})
    start = max(2.0, rheology.steady_from(data["v_gamma"], data["v_phi_now"], data["v_sxy"]))
    kept = {name: column[data["v_gamma"] >= start] for name, column in data.items()}
    row = {**case, "from": f"{start:.2f}"}
    for name, column in (("phi", "v_phi_now"), ("mu", "v_sxy")):
        row[name], row[name + "_error"] = (f"{x:.4g}" for x in rheology.estimate(kept[column]))
    for name in FIELDS[FIELDS.index("contact_n"):]:
        row[name] = f"{kept['v_' + name].mean():.4g}"
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--Iv", nargs="+", default=["0.1", "1"])
    parser.add_argument("--friction", nargs="+", default=["0.5"])
    parser.add_argument("--levels", nargs="+", default=["none:cut:0.5", "mean:cut:0.5", "grid:residual:1"])
    parser.add_argument("--particles", default="500")
    parser.add_argument("--strain", default="6")
    parser.add_argument("--seeds", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    args = parser.parse_args()
    wanted = [dict(zip(CASE, (*level.split(":"), iv, friction, args.particles, args.strain, seed)))
              for seed in SEEDS[:args.seeds] for friction in args.friction for iv in args.Iv for level in args.levels]
    cases.run(wanted, measure, HERE / "imposed.csv", FIELDS, args.jobs)


if __name__ == "__main__":
    main()
