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
        (pairs.encounter, "smooth", "exponential", (0.1, 0.03), "error_gap", 2.0, 0.1),
        (pairs.encounter, "smooth", "euler", (0.1, 0.03), "error_gap", 1.0, 0.05)):
    rows = [scene(name, scheme, fraction) for fraction in fractions]
    print(f"{rows[0]['scene']}, {name}, {scheme}: errors {rows[0][what]:.2e} {rows[1][what]:.2e}")
    expect_close("  order", pairs.order(rows, what), expected, atol=tolerance)

with open(FOLDER / "pairs.csv", encoding="ascii") as file:
    listed = list(csv.DictReader(file, delimiter=";"))


def smallest_failure(scene, setting, scheme):
    """Step over the limit, and how."""
    rows = [row for row in listed if (row["scene"], row["setting"], row["gap"]) == (scene, setting, scheme) and row["failed"]]
    return min((float(row["dt_over_limit"]), row["failed"]) for row in rows)


# what a run that has blown up does last depends on the compiler: only that it fails is judged
for name, scene in (("falling sphere", pairs.falling), ("pair in shear", pairs.encounter)):
    fraction, how = smallest_failure(name, "smooth", "exponential")
    got = scene("smooth", "exponential", 1.0001 * fraction)["failed"]
    expect(f"{name}, exponential: fails at {fraction} of the limit", got, f"listed: {how}; got: {got}")
_, how = smallest_failure("falling sphere", "St 30", "euler")
got = [pairs.falling("St 30", scheme, 0.25)["failed"] for scheme in pairs.SCHEMES]
expect("swing on the bulk spring at a quarter of the limit: euler fails, exponential does not", got == ["", how],
       f"listed: {how}; got: {got[1]}")
expect("listed: exponential does not fail up to the limit",
       not any(row["failed"] for row in listed if row["gap"] == "exponential" and float(row["dt_over_limit"]) <= 1.0))

expect_close("exact hydrodynamics: smallest gap as y0 -> 0", exact_pair.encounter(-30.0, 0.01, 5.0)[0], exact_pair.CLOSEST,
             rtol=0.05)
finish()
