"""The constants of scene_accuracy.h are those that benchmarks/accuracy_cost measured: each is fitted anew from its table."""
import csv
import re
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmarks" / "accuracy_cost"))
import suspension_laws    # noqa: E402  pylint: disable=wrong-import-position
from suspension import SCATTER, SETTLED    # noqa: E402  pylint: disable=wrong-import-position

HEADER = (ROOT / "src" / "SUSPENSION-ADVISER" / "scene_accuracy.h").read_text(encoding="ascii")
ROWS, _ = suspension_laws.read()


def block(name):
    """Rows of numbers of a table of the header."""
    text = re.search(rf"{name}\[[A-Z_]*\] = \{{(.*?)\}};", HEADER, re.DOTALL).group(1)
    inner = re.findall(r"\{([^{}]*)\}", text) or [text]
    return [[float(word) for word in row.split(",")] for row in inner]


def constant(name):
    return float(re.search(rf"double {name} = (\S+);", HEADER).group(1))


def causes():
    text = re.search(r"CAUSE_NAME\[NUM_CAUSES\] = \{(.*?)\};", HEADER, re.DOTALL).group(1)
    return re.findall(r'"([^"]*)"', text)


class Constants(unittest.TestCase):
    def assert_rounded(self, got, measured, digits=2):
        """The number of the header is the measured one, rounded to digits."""
        self.assertAlmostEqual(got, float(f"{measured:.{digits - 1}e}"), delta=1e-9 * abs(measured))

    def test_laws(self):
        laws = suspension_laws.laws(ROWS)
        table = dict(zip(causes(), block("LAW")))
        self.assertEqual(list(table), list(laws))
        for cause, (coefficient, error, exponent, low, high) in table.items():
            with self.subTest(cause):
                for got, measured in zip((coefficient, error, low, high), laws[cause]):
                    self.assert_rounded(got, measured)
                self.assertEqual(exponent, 2.0 if cause == "particle inertia" else 1.0)

    def test_scatter(self):
        self.assertEqual(sorted(phi for phi, _ in block("SCATTER")), sorted(map(float, SCATTER)))
        for phi, value in block("SCATTER"):
            self.assert_rounded(value, suspension_laws.scatter(ROWS, next(p for p in SCATTER if float(p) == phi))[0])

    def test_cost(self):
        for name, measured in zip(("STRAIN_SECONDS", "STEP_SECONDS"), suspension_laws.seconds(ROWS)):
            self.assert_rounded(constant(name), measured)

    def test_squeeze_film_left_out(self):
        """The threshold of the adviser quotes what leaving the squeeze film out changes."""
        verdicts = (ROOT / "src" / "SUSPENSION-ADVISER" / "scene_verdict.h").read_text(encoding="ascii")
        source = "".join(re.findall(r'"([^"]*)"', re.search(r'\{"St", 0\.05,(.*?)\}', verdicts, re.DOTALL).group(1)))
        pairs = [(("squeeze", f"phi 0.54, St {stokes}", "off"), ("squeeze", f"phi 0.54, St {stokes}", "on")) for stokes in ("0.05", "0.5")]
        for key, base in (*pairs, (("strain", "left out", "squeeze"), ("strain", "base", ""))):
            off, error = suspension_laws.change(ROWS, key, base)
            self.assertIn(f"{100 * off:+.0f} +- {100 * error:.0f} %", source)

    def test_far_field(self):
        """What the adviser says is missing without it."""
        verdicts = (ROOT / "src" / "SUSPENSION-ADVISER" / "scene_verdict.h").read_text(encoding="ascii")
        with (ROOT / "tests" / "validation" / "far_field" / "results.csv").open(encoding="ascii", newline="") as file:
            eta = {(row["level"], row["range"], float(row["phi"])): float(row["eta_r"]) for row in csv.DictReader(file) if row["friction"] == "0.5"}
        phis, lows = (list(map(float, re.search(rf"double {name}\[NUM\] = \{{(.*?)\}}", verdicts).group(1).split(","))) for name in ("PHI", "LOW"))
        for phi, low in zip(phis, lows):
            self.assertAlmostEqual(low, 1 - eta["none", "0.5", phi] / eta["grid", "1", phi], delta=0.0051)
        sources = re.sub(r'"\s*"', "", verdicts)
        for level, words in (("none", "films alone"), ("mean", "level mean")):
            text = re.search(rf"far_field: {words} (.*?)\"", sources).group(1)
            for percent, phi in re.findall(r"(\d+) %[a-z ]*at (0\.\d+)", text):
                self.assertAlmostEqual(float(percent), 100 * (1 - eta[level, "0.5", float(phi)] / eta["grid", "1", float(phi)]), delta=0.51)

    def test_options_are_within_what_was_run(self):
        laws = suspension_laws.laws(ROWS)
        run = [row["step"] for row in ROWS if row["set"] == "strain" and row["knob"] == "time step"]
        self.assertLessEqual(constant("STEP_OF_LIMIT"), max(run))
        for name, cause in (("SOFTNESSES", "stiffness"), ("INERTIAS", "particle inertia")):
            self.assertLessEqual(max(block(name)[0]), laws[cause][3])
        self.assertLessEqual(1 / min(block("SIZES")[0]), laws["few particles"][3])
        self.assertGreaterEqual(1 / max(block("SIZES")[0]), 0.999 * laws["few particles"][2])

    def test_settling(self):
        self.assertEqual(constant("SETTLE"), SETTLED)


if __name__ == "__main__":
    unittest.main()
