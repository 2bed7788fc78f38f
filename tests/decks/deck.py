"""Runs decks of LAMMPS for the tests and judges numbers.

A case is a folder with decks in.* and a check.py, which ctest runs in a scratch folder. The
environment says what to run: LAMMPS_EXECUTABLE, MPIRUN (a wrapper: MPIRUN ranks command), RANKS,
LAMMPS_PLUGIN_PATH.
"""
import csv
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np

CASE = Path(sys.argv[0]).resolve().parent
ROOT = Path(__file__).resolve().parents[2]
PAIR = ROOT / "examples" / "pair"    # decks of two spheres: in.fall, in.shear
RANKS = int(os.environ.get("RANKS", "1"))
_failures = []


class Run:
    """What a deck printed: text, thermo tables, and lines 'RESULT name value'."""

    def __init__(self, text, code):
        self.text = text
        self.code = code
        pairs = re.findall(r"^RESULT (\S+) (\S+)$", text, re.MULTILINE)
        self.values = {name: float(value) for name, value in pairs}

    def tables(self):
        """Thermo tables in order, each a dict of column name -> array."""
        tables, rows, names = [], [], None
        for line in self.text.splitlines():
            words = line.split()
            if words and words[0] == "Step":
                names, rows = words, []
            elif names and line.startswith("Loop time"):
                tables.append(dict(zip(names, np.array(rows, dtype=float).T)))
                names = None
            elif names and len(words) == len(names):
                rows.append(words)
        return tables

    def thermo(self):
        return self.tables()[-1]


def command_line(deck, ranks=None, **variables):
    """Command that runs CASE/deck, or a deck by its full path, with index variables; and its environment."""
    ranks = RANKS if ranks is None else ranks
    environment = dict(os.environ)
    lmp = environment.pop("LAMMPS_EXECUTABLE")    # for the set-up tools it would mean a LAMMPS of the user
    command = [os.environ["MPIRUN"], str(ranks), lmp, "-in",
               str(CASE / deck), "-log", "none", "-nocite", "-var", "root", str(ROOT)]
    for name, value in variables.items():
        command += ["-var", name] + ([str(v) for v in value] if isinstance(value, (list, tuple)) else [str(value)])
    return command, environment


def run(deck, ranks=None, fails=False, **variables):
    """Runs a deck, see command_line(); stops the test if it fails, or if fails=True and it does not."""
    command, environment = command_line(deck, ranks, **variables)
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          check=False, env=environment)
    if "needs the library FFTW" in done.stdout:
        print("SKIPPED: built without FFTW")
        sys.exit(77)
    if (done.returncode != 0) != fails:
        print(done.stdout[-4000:])
        print("FAILED: " + " ".join(command[3:]) + f" ended with code {done.returncode}")
        sys.exit(1)
    return Run(done.stdout, done.returncode)


def make_state(**variables):
    """state.data for the decks that include sheared.lmp: 200 spheres at 0.5, or discs with dim=2, phi=0.75."""
    run(ROOT / "tests" / "decks" / "state.lmp", ranks=1, **variables)


def run_example(name, **variables):
    """Runs the deck of examples/name here with other variables."""
    examples = ROOT / "examples"
    return run(os.path.relpath(examples / name / f"in.{name}", CASE), scene=examples / "scene",
               packing=examples / "packing" / "packing.lmp", **variables)


def read_stress():
    """Columns of stress.txt, which the examples write, as a dict."""
    sys.path.insert(0, str(ROOT / "tools"))
    import steady
    return steady.read_ave_time("stress.txt")


def draw_example(name, *figures, options=()):
    """Runs plot.py of examples/name here; what it prints. The figures must be there."""
    for figure in figures:
        Path(figure).unlink(missing_ok=True)
    done = subprocess.run([sys.executable, str(ROOT / "examples" / name / "plot.py"), *options],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    print(done.stdout)
    expect("plot.py runs", done.returncode == 0)
    for figure in figures:
        expect(f"{figure} is drawn", Path(figure).exists() and Path(figure).stat().st_size > 1e4)
    return done.stdout


def study_example(name, rows, *options):
    """Runs the study.py of an example with these options, shortened: the rows that it must make, and its figure."""
    Path("short.csv").unlink(missing_ok=True)
    done = subprocess.run([sys.executable, str(ROOT / "examples" / name / "study.py"), *options, "--table", "short.csv"],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    print(done.stdout)
    expect("study runs", done.returncode == 0)
    with open("short.csv", encoding="ascii") as file:
        expect("one row a case", len(list(csv.DictReader(file))) == rows)
    expect("figure is drawn", Path("figure.png").stat().st_size > 1e4)


def read_dump(name):
    """Columns of the last frame of a text dump, sorted by the column id, as a dict of arrays."""
    lines = Path(name).read_text().splitlines()
    start = max(n for n, line in enumerate(lines) if line.startswith("ITEM: ATOMS"))
    names = lines[start].split()[2:]
    rows = np.array([line.split() for line in lines[start + 1:]], dtype=float)
    rows = rows[np.argsort(rows[:, names.index("id")])]
    return dict(zip(names, rows.T))


def expect(what, condition, shown=""):
    print(f"{what}: {shown} {'ok' if condition else 'WRONG'}")
    if not condition:
        _failures.append(what)


def expect_close(what, got, expected, rtol=0.0, atol=0.0):
    """|got - expected| <= rtol |expected| + atol, everywhere; prints the largest error."""
    got, expected = np.broadcast_arrays(np.asarray(got, dtype=float), np.asarray(expected, dtype=float))
    error = np.abs(got - expected)
    limit = rtol * np.abs(expected) + atol
    worst = np.unravel_index(np.argmax(error - limit), error.shape)
    good = bool(np.all(error <= limit))
    shown = f"expected {expected[worst]:.10g} got {got[worst]:.10g} error {error[worst]:.2e} limit {limit[worst]:.2e}"
    expect(what, good, shown)


def expect_same_bits(what, got, expected):
    """Of two dumps or tables, all columns of the first one."""
    wrong = [f"{name} {np.max(np.abs(got[name] - expected[name])):.1e}" for name in got if not np.array_equal(got[name], expected[name])]
    expect(f"{what}: bit for bit", not wrong, " ".join(wrong))


def power_balance(table, dt, power="c_power"):
    """From the output of each step: defect of the balance of energy at its worst, and heat by rows, over the largest work."""
    rows = [m for m in range(1, 20) if f"{power}[{m}][1]" in table]
    heat, stored = (np.array([table[f"{power}[{m}][{n}]"] for m in rows]) for n in (1, 2))
    put = table[power]
    work = np.concatenate(([0.0], np.cumsum(0.5 * (put[1:] + put[:-1])))) * dt
    lost = np.concatenate(([0.0], np.cumsum(np.sum(heat[:, 1:], axis=0)))) * dt
    total = np.sum(stored, axis=0)
    scale = np.max(np.abs(work))
    return np.max(np.abs(work - lost - total + total[0])) / scale, np.sum(heat, axis=1) * dt / scale


def expect_error(what, text, message, word=None):
    """LAMMPS stopped with this message, and underlined word if one is given."""
    lines = text.splitlines()
    shown = next((line for line in lines if line.startswith("ERROR")), "no error")
    expect(what, message in shown, shown)
    if word:
        last = next(n for n, line in enumerate(lines) if line.startswith("Last input line: "))
        carets = lines[last + 1]
        marked = lines[last][carets.index("^"):carets.rindex("^") + 1] if "^" in carets else ""
        expect(f"  underlined: {word}", marked == word, marked)


def finish():
    if _failures:
        print(f"{len(_failures)} wrong: " + ", ".join(_failures))
    sys.exit(1 if _failures else 0)
