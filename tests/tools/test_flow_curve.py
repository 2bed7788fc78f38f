"""Flow curves from a LAMMPS that is played: runs of known viscosity, noise and transient."""
import contextlib
import csv
import io
import os
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import flow_curve

# Stands for "mpirun ranks lmp ...": a line of stress.txt each 0.02 of strain, viscosity 12/sqrt(rate) in units of 2.5 and 2,
# noise of 30 % that relaxes in 0.1 of strain, a transient at the start.
PLAYED = '''#!{python}
import random, sys, time
words = sys.argv[1:]
var = dict((words[n + 1], words[n + 2]) for n, w in enumerate(words) if w == "-var")
open("{counter}", "a").write(var["rate"] + " " + str(var) + "\\n")
if var.get("fault"):
    open("log.lammps", "w").write("ERROR: lost atoms (thermo.cpp:1)\\nLast input line: run 5\\n")
    sys.exit(1)
rate, noise, random.seed = float(var["rate"]), 0.0, random.seed(float(var["rate"]))
with open("stress.txt", "w") as file:
    file.write("# stresses over 2.5, viscosity of the fluid 2\\n# TimeStep v_gamma v_gamma_dot v_phi_now v_sxy\\n")
    for line in range(1, int(float(var.get("ends", var["strain"])) / 0.02) + 2):
        memory = 0.8 if var.get("imposed") != "stress" else 0.98
        noise = memory * noise + (1 - memory**2)**0.5 * random.gauss(0, 1)
        flow, stress = rate, 12 * rate**0.5 * 2 / 2.5 * (1 + 0.3 * noise + 2 * 2.718**(-line / 10))
        if var.get("imposed") == "stress":
            flow, stress = rate * (1 + 0.1 * noise), 12 * rate**0.5 * 2 / 2.5 + random.gauss(0, 1e-6)
        file.write(f"{{100 * line}} {{0.02 * line}} {{flow}} 0.5 {{stress}}\\n")
        if line % 100 == 0:
            file.flush()
            time.sleep(0.004)
open("ended", "w")
'''
DECK = "variable imposed index rate\nvariable rate index 1\nvariable strain index 3\nvariable ends index 1\nvariable fault index 0\n" \
       "include ${scene}/stress.lmp\n"


class FlowCurves(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        (self.folder / "mpirun").write_text(PLAYED.format(python=sys.executable, counter=self.folder / "count"))
        (self.folder / "mpirun").chmod(0o755)
        (self.folder / "in.played").write_text(DECK)
        self.table = self.folder / "curve.csv"
        played = mock.patch.dict(os.environ, MPIRUN=str(self.folder / "mpirun"), LAMMPS_EXECUTABLE="lmp")
        played.start()
        self.addCleanup(played.stop)

    def curve(self, *words, deck=None, wait="0.01"):
        """Exit status or message, what was printed, and rows by value."""
        out = io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out), self.assertRaises(SystemExit) as end:
            flow_curve.main([deck or str(self.folder / "in.played"), *words, "--table", str(self.table), "--wait", wait])
        lines = self.table.read_text().splitlines() if self.table.exists() else []
        return end.exception.code, out.getvalue(), {row.get("value"): row for row in csv.DictReader(lines)}

    def started(self):
        count = self.folder / "count"
        return len(count.read_text().splitlines()) if count.exists() else 0

    def test_runs_end_at_the_tolerance(self):
        code, text, rows = self.curve("rate", "0.25", "1", "4", "--tolerance", "0.03", "--max-strain", "3000", "--jobs", "3")
        self.assertEqual(code, 0, text)
        self.assertEqual(len(rows), 3)
        for value, row in rows.items():
            found, error, truth = float(row["viscosity"]), float(row["viscosity_error"]), 12 / float(value) ** 0.5
            self.assertEqual(row["outcome"], "tolerance")
            self.assertLess(abs(found - truth), 4 * error)
            self.assertLessEqual(error, 0.03 * found)
            # 30 % noise with nine samples to one independent: that error takes a strain of 18
            self.assertTrue(6 < float(row["strain"]) < 60, row)
            self.assertAlmostEqual(float(row["stress"]) / (2 * float(row["rate"])) / found, 1, delta=5e-3)    # the ratio is one of whole blocks
            run = self.folder / "curve.runs" / f"in.played_rate={value}"
            self.assertFalse((run / "ended").exists(), "ran to its end")
        self.assertGreater((self.folder / "curve.png").stat().st_size, 1e4)

    def test_slow_rate_under_a_stress(self):
        code, text, rows = self.curve("rate", "1", "--set", "imposed=stress", "--tolerance", "0.2", "--max-strain", "400")
        self.assertEqual((code, rows["1"]["outcome"]), (0, "tolerance"), text)
        self.assertGreater(float(rows["1"]["strain"]), 12)    # ten times the correlation length of 2, but for its scatter
        self.assertLess(abs(float(rows["1"]["viscosity"]) - 12), 4 * float(rows["1"]["viscosity_error"]))

    def test_result_does_not_depend_on_when_one_looks(self):
        words = ("rate", "1", "--tolerance", "0.05", "--max-strain", "400")
        first = self.curve(*words, wait="0.002")[2]["1"]
        self.table.unlink()
        self.assertEqual(first, self.curve(*words, wait="0.7")[2]["1"])

    def test_what_is_there_is_not_repeated(self):
        words = ("--max-strain", "20", "--tolerance")
        self.curve("rate", "1", *words, "0.2")
        self.assertEqual(self.started(), 1)
        self.curve("rate", "1.0", "4", *words, "0.2")
        self.assertEqual(self.started(), 2)
        rows = self.curve("rate", "1", "4", *words, "0.001")[2]    # not to be had within a strain of 20
        self.assertEqual(self.started(), 4)
        self.assertEqual({row["outcome"] for row in rows.values()}, {"max strain"})
        self.assertEqual(len(rows), 2)
        self.curve("rate", "1", "4", *words, "0.001")
        self.assertEqual(self.started(), 4)
        self.curve("rate", "1", "--max-strain", "25", "--tolerance", "0.001")
        self.assertEqual(self.started(), 5)
        self.curve("rate", "1", *words, "0.2", "--set", "fault=")    # refused
        for _ in range(2):
            self.curve("rate", "1", *words, "0.2", "--set", "ends=20", "output=two words")    # another case
        self.assertEqual(self.started(), 6)

    def test_a_deck_that_ends_before(self):
        code, _, rows = self.curve("rate", "1", "--set", "ends=5", "--tolerance", "0.001")
        self.assertEqual((code, rows["1"]["outcome"], self.started()), (0, "deck ended", 1))
        self.assertAlmostEqual(float(rows["1"]["strain"]), 5, delta=0.05)
        rows = self.curve("rate", "4", "--set", "ends=0.5")[2]    # no numbers, but the reason
        self.assertIn("only 2", rows["4"]["outcome"])
        self.assertEqual(rows["4"]["viscosity"], "")

    def test_a_run_that_fails(self):
        code, text, rows = self.curve("rate", "1", "2", "--set", "fault=1")
        self.assertEqual((code, rows), (1, {}))
        self.assertIn("rate 1: FAILED: LAMMPS stopped: ERROR: lost atoms (thermo.cpp:1) / Last input line: run 5", text)
        self.assertIn("rate 2: FAILED", text)

    def test_refusals_say_what_to_write(self):
        for words, deck, message in (
                (("rat", "1"), None, "no index variable rat, but imposed rate strain ends fault output sampling"),
                (("rate", "1", "--set", "phy=0.5"), None, "no index variable phy, but imposed rate"),
                (("rate", "1", "--set", "rate=2"), None, "differ from run to run"),
                (("rate", "1", "--set", "phi"), None, "write NAME=VALUE"),
                (("rate", "fast"), None, "rate fast: not a number"),
                (("rate", "1", "1.0"), None, "occurs twice"),
                (("rate", "1", "--tolerance", "5"), None, "between 0 and 1"),
                (("rate", "1", "--max-strain", "1"), None, "strains must fit"),
                (("rate", "1", "--jobs", "0"), None, "must be 1 or more"),
                (("rate", "1"), "shear_rat", "name of an example: .*pressure_shear, .*shear_rate")):
            self.assertRegex(str(self.curve(*words, deck=deck)[0]), message)
        self.table.write_text("a,b\n1,2\n")
        self.assertRegex(str(self.curve("rate", "1")[0]), "not a table of this tool")
        self.assertEqual(self.started(), 0)

    def test_variables_of_the_examples(self):
        for name in ("shear_rate", "pressure_shear", "shear_thickening", "yield_stress", "binary_mixture"):
            known = flow_curve.index_variables(flow_curve.find_deck(name))
            for variable in ("phi", "N", "strain", "friction", "seed", "sampling"):
                self.assertIn(variable, known, name)


if __name__ == "__main__":
    unittest.main()
