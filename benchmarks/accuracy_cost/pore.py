"""Error of fix pore/pressure, one knob at a time: a column that settles, a packing that lets through, a layer that begins to shear.

usage: tools/python.sh pore.py [PART ...]      parts: column, explicit, packing, layer, draw, by default all
Runs the decks of tests/decks and examples/pore_transient, writes pore.csv; rows of other parts stay. draw: pore.png. See README.md.
"""
import csv
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt    # noqa: E402
import numpy as np    # noqa: E402

HERE = Path(__file__).resolve().parent
TOP = HERE.parents[1]
DECKS = TOP / "tests" / "decks"
sys.path.insert(0, str(TOP / "tools"))
import steady    # noqa: E402  pylint: disable=wrong-import-position

TABLE = HERE / "pore.csv"
# value: of the knob; error and second: see MEANING; steps: largest number of iterations in a step
FIELDS = ["part", "knob", "value", "error", "second", "iterations"]
MEANING = {"column": ("largest error of the pressure", "of the settlement"), "explicit": ("largest error of the pressure", "largest pressure"),
           "packing": ("flux over that of the mean volume fraction, minus 1", "largest over smallest permeability"),
           "layer": ("largest suction over the load", "half strain of the dilation")}
SPHERES = 24    # of the column: a number with many divisors
DRAG = 62       # drag of the pores on a sphere times the time step over its mass
SHARE = 0.45    # of the largest step: at 0.9 a stack of spheres that may part gains energy by itself, without any fluid


def lammps(folder, deck, **variables):
    words = [word for name, value in variables.items() for word in ("-var", name, str(value))]
    run = subprocess.run([str(TOP / "tools/lmp.sh"), "-log", "none", "-in", str(deck), "-var", "root", str(TOP), *words],
                         cwd=folder, capture_output=True, text=True, check=False)
    if run.returncode:
        raise RuntimeError(run.stdout[-600:] + run.stderr)
    return run.stdout


def thermo(text):
    """The last table of a run, numbers by name."""
    lines = text.splitlines()
    start = max(n for n, line in enumerate(lines) if line.split()[:1] == ["Step"])
    names, rows = lines[start].split(), []
    for line in lines[start + 1:]:
        if not re.match(r"\s*[\d.+-]", line) or len(line.split()) != len(names):
            break
        rows.append([float(word) for word in line.split()])
    return dict(zip(names, np.array(rows).T))


def terzaghi(time):
    """Pressure at the closed end and settlement, over their largest values."""
    m = (2 * np.arange(2000)[:, None] + 1) * np.pi / 2
    decay = np.exp(-m**2 * time)
    return np.sum(2 * np.sin(m) / m * decay, axis=0), 1 - np.sum(2 / m**2 * decay, axis=0)


def column(folder, drag=DRAG, words="solver grid", elements=SPHERES // 2, until=0.3):
    """Errors against Terzaghi from T = 0.02 on; pressures; time step over the explicit limit."""
    text = lammps(folder, DECKS / "pore_plates" / "in.column", N=SPHERES, ny=elements, drag=drag, solver=words, share=SHARE, until=until, outputs=60,
                   columns="lz")
    t = thermo(text)
    late = t["v_t"] > 0.02
    p, settled = terzaghi(t["v_t"][late])
    moved = (t["f_cell[3]"][0] - t["f_cell[3]"][late]) / (t["f_cell[3]"][0] / t["v_modulus"][0])
    return (np.max(np.abs(t["f_pore[1]"][late] - p)), np.max(np.abs(moved - settled)), np.max(np.abs(t["f_pore[4]"])),
            np.max(t["f_pore[15]"]), np.max(t["f_pore[11]"][1:]))


def columns(folder):
    knobs = {"spacing, diameters": {f"{SPHERES / n:.3g}": {"elements": n} for n in (24, 18, 16, 12, 8, 6, 4)},
             "solver": {"cg": {"words": "solver cg"}},
             "tolerance": {t: {"words": f"solver cg tolerance {t}"} for t in ("1e-1", "1e-2", "1e-4", "1e-8")},
             "every": {n: {"words": f"solver grid every {n}"} for n in (1, 5, 20, 100)},
             "drag dt/m": {d: {"drag": d, "until": min(0.3, 20 / d)} for d in (0.62, 6.2, 62, 620)}}
    for knob, values in knobs.items():
        for value, settings in values.items():
            of_p, of_u, _, _, iterations = column(folder, **settings)
            yield knob, value, of_p, of_u, iterations


def explicit(folder):
    """The same column as the drag grows: explicit coupling until it fails, and implicit."""
    limit = column(folder, drag=1, until=0.02)[3]    # time step over the explicit limit for a drag of 1
    for over in (0.5, 0.9, 1.5, 3, 30, 300):
        for coupling in ("explicit", "implicit"):
            try:
                of_p, _, largest, _, iterations = column(folder, drag=over / limit, words=f"coupling {coupling}", until=0.1)
            except RuntimeError:
                of_p = largest = iterations = np.inf
            yield f"{coupling}, step over the explicit limit", over, of_p if of_p < 10 else np.inf, largest if of_p < 10 else np.inf, iterations


def flux(folder):
    """Mean over the layers of the grid."""
    lines = [line.split() for line in (folder / "layers.txt").read_text(encoding="ascii").splitlines()]
    return np.mean([float(words[-1]) for words in lines if len(words) == 6 and words[0] != "#"])


def packing(folder):
    lammps(folder, DECKS / "state.lmp")
    lammps(folder, DECKS / "pore_cell" / "in.bed", pore="1 cell coupling off grid 1 1 1", slope=-1)
    even = flux(folder)
    for n in (2, 3, 4, 5):
        t = thermo(lammps(folder, DECKS / "pore_cell" / "in.bed", pore=f"1 cell coupling off tolerance 1e-10 grid {n} {n} {n}", slope=-1))
        yield ("spacing, diameters", f"{t['Ly'][0] / n / 2:.3g}", flux(folder) / even - 1, t["f_pore[14]"][0] / t["f_pore[13]"][0], 0)


def layer(folder):
    knobs = {"base": {"": {}},
             "spacing, diameters": {h: {"spacing": 2 * h} for h in (1.1, 2, 3)},
             "factor on the permeability": {f: {"factor": 100 * f} for f in (0.88, 1.12)},
             "solver": {"cg": {"factor": "100 solver cg"}},
             "every": {n: {"factor": f"100 every {n}"} for n in (1, 100)}}
    for knob, values in knobs.items():
        for value, settings in values.items():
            lammps(folder, TOP / "examples" / "pore_transient" / "in.pore_transient", packing=TOP / "examples/packing/plates.lmp",
                   **{"iv": 0.01, "strain": 1, "factor": 100, **settings})
            data = steady.read_ave_time(folder / "flow.txt")
            strain, phi = data["f_cell[1]"], data["f_cell[6]"]
            half = np.interp(0.5, (phi[0] - phi) / (phi[0] - phi[strain > 0.8].mean()), strain)
            yield knob, value, -np.min(data["v_pore_low"]), half, 0


PARTS = {"column": columns, "explicit": explicit, "packing": packing, "layer": layer}


def read(parts):
    if not TABLE.exists():
        return []
    with TABLE.open(encoding="ascii", newline="") as file:
        return [row for row in csv.DictReader(file) if row["part"] in parts]


def draw():
    def of(part, knob):
        found = [(float(row["value"]), float(row["error"])) for row in read([part]) if row["knob"] == knob]
        return np.array(sorted(found)).T

    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6))
    left.loglog(*of("column", "spacing, diameters"), "o-", color="C0", ms=4, label="column that settles: pressure")
    left.loglog(*of("packing", "spacing, diameters"), "s-", color="C2", ms=4, label="flux through a packing")
    h, suction = of("layer", "spacing, diameters")
    base = next(float(row["error"]) for row in read(["layer"]) if row["knob"] == "base")
    left.loglog(h, np.abs(suction / base - 1), "^-", color="C3", ms=4, label="suction of a dense layer, from 1.5")
    left.axvline(1.5, color="0.8", lw=0.8, zorder=0)
    left.set(xlabel="spacing of the grid, diameters", ylabel="relative error", xticks=[1, 1.5, 2, 3, 4, 6])
    left.set_xticklabels(["1", "1.5", "2", "3", "4", "6"])
    left.minorticks_off()
    left.legend(frameon=False, fontsize=7)
    top = 3.0
    for coupling, color, mark in (("explicit", "C3", "X"), ("implicit", "C0", "o")):
        x, y = of("explicit", f"{coupling}, step over the explicit limit")
        fails = ~np.isfinite(y)
        right.loglog(x[~fails], y[~fails], f"{mark}-", color=color, ms=5, label=f"coupling {coupling}")
        right.loglog(x[fails], np.full(np.sum(fails), top), "X", color=color, ms=8, mfc="w")
    right.plot([], [], "X", color="C3", ms=8, mfc="w", label="explicit: fails")
    right.axvline(1, color="0.8", lw=0.8, zorder=0)
    right.set(xlabel="time step over the limit of explicit coupling", ylabel="error of the pressure, over the load")
    right.legend(frameon=False, fontsize=7)
    figure.tight_layout()
    figure.savefig(HERE / "pore.png", dpi=150)


def main():
    chosen = [part for part in sys.argv[1:] or list(PARTS) if part != "draw"]
    rows = read(set(PARTS) - set(chosen))
    for part in chosen:
        with tempfile.TemporaryDirectory() as folder:
            for knob, value, error, second, iterations in PARTS[part](Path(folder)):
                rows.append({"part": part, "knob": knob, "value": value, "error": f"{error:.3g}", "second": f"{second:.3g}",
                             "iterations": f"{iterations:.0f}"})
                print(*rows[-1].values(), sep="  ", flush=True)
    with TABLE.open("w", encoding="ascii", newline="") as file:
        writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(sorted(rows, key=lambda row: list(PARTS).index(row["part"])))
    draw()


if __name__ == "__main__":
    main()
