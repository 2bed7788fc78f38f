"""No line of our C++ is longer than 100 columns. clang-format keeps code below, but wraps no comment."""
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SOURCES = sorted(path for folder in ("src", "tests", "benchmarks") for path in (ROOT / folder).rglob("*")
                 if path.suffix in (".h", ".cpp"))
GENERATED = ("pore_reference.h", "pair_residual_reference.h")    # tables that a script writes


class Width(unittest.TestCase):
    def test_at_most_100_columns(self):
        self.assertGreater(len(SOURCES), 150)
        wide = [f"{path.relative_to(ROOT)}:{number}: {len(line)}" for path in SOURCES if not path.name.startswith(GENERATED)
                for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1) if len(line) > 100]
        self.assertEqual(wide, [])


if __name__ == "__main__":
    unittest.main()
