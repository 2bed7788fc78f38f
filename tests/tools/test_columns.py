"""No file knows by number what a fix puts into which column of its output: it asks the fix by name."""
import re
import unittest
from pathlib import Path

SOURCES = sorted((Path(__file__).resolve().parents[2] / "src").rglob("*.[ch]*"))
BY_NUMBER = re.compile(r"(->|\.)compute_vector\(|compute_vector\(\s*\d|f_[\w{}]*\[\d+\]")


def found(text):
    """Lines that know a column."""
    return [line.strip() for line in text.splitlines() if BY_NUMBER.search(line.split("//")[0])]


class Columns(unittest.TestCase):
    def test_finds_what_it_looks_for(self):
        for line in ('x = fix->compute_vector(PATH);', 'compute_vector(4)', 'watch(fmt::format("f_{}[2]", id), rate);'):
            self.assertEqual(found(line), [line])
        self.assertEqual(found('double mean_power() { return compute_vector(MEAN_POWER); }  // f_ID[n]'), [])

    def test_none(self):
        self.assertGreater(len(SOURCES), 100)
        lines = [f"{path.name}: {line}" for path in SOURCES for line in found(path.read_text(encoding="utf-8"))]
        self.assertEqual(lines, [])


if __name__ == "__main__":
    unittest.main()
