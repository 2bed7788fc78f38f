"""Orders of convergence of a falling sphere and of a pair in shear, and steps that fail as benchmarks/accuracy_cost/pairs.csv
says. The references are SciPy's solutions (decks/oracle); the path of a smooth pair with all hydrodynamics must end at the
published smallest gap.
"""
import csv
import sys

from deck import ROOT, expect, expect_close, finish
from oracle import exact_pair

FOLDER = ROOT / "benchmarks" / "accuracy_cost"
sys.path.insert(0, str(FOLDER))
import pairs

# the film alone: all errors are those of the scheme (velocity Verlet, exponential) or of euler
for scene, name, scheme, fractions, what, expected, tolerance in (
        (pairs.falling, "crushed", "exponential", (0.1, 0.03), "error_gap", 2.0, 0.1),
        (pairs.falling, "smooth", "euler", (0.1, 0.03), "error_gap", 1.0, 0.05),
        (pairs.encounter, "smooth", "exponential", (0.3, 0.1), "error_gap", 2.0, 0.25),
        (pairs.encounter, "smooth", "euler", (0.3, 0.1), "error_gap", 1.0, 0.1)):
    rows = [scene(name, scheme, fraction) for fraction in fractions]
    print(f"{rows[0]['scene']}, {name}, {scheme}: errors {rows[0][what]:.2e} {rows[1][what]:.2e}")
    expect_close("  order", pairs.order(rows, what), expected, atol=tolerance)

with open(FOLDER / "pairs.csv", encoding="ascii") as file:
    listed = list(csv.DictReader(file, delimiter=";"))
for name, scene in (("falling sphere", pairs.falling), ("pair in shear", pairs.encounter)):
    for scheme in pairs.SCHEMES:
        of_scene = [row for row in listed if (row["scene"], row["setting"], row["gap"]) == (name, "smooth", scheme)]
        failed = min((row for row in of_scene if row["failed"]), key=lambda row: float(row["dt_over_limit"]))
        got = scene("smooth", scheme, float(failed["dt_over_limit"]) * 1.0001)
        expect(f"{name}, {scheme}, {failed['dt_over_limit']} of the limit fails as listed", got["failed"] == failed["failed"],
               f"listed: {failed['failed']}; got: {got['failed']}")
    expect(f"{name}: no failure up to the limit", not any(row["failed"] for row in listed if row["scene"] == name and
                                                           float(row["dt_over_limit"]) <= 1.0))

expect_close("exact hydrodynamics: smallest gap as y0 -> 0", exact_pair.encounter(-30.0, 0.01, 5.0)[0], exact_pair.CLOSEST,
             rtol=0.05)
finish()
