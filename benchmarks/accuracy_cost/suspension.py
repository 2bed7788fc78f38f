"""Error against CPU time of a sheared dense suspension, one knob at a time.

usage: tools/python.sh suspension.py [SET ...] [--states FOLDER]      sets: those of ORDER, by default all
Runs in.suspension for each case, one after the other, appends to suspension.csv, skips what it already holds. See README.md.
"""
import argparse
import csv
import math
import os
import re
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
TOP = HERE.parents[1]
sys.path.insert(0, str(TOP / "examples" / "scene"))
import rheology    # noqa: E402  pylint: disable=wrong-import-position

TABLE = HERE / "suspension.csv"
# what the row is about; the result; and what it took. step: time step over its limit as the pair style prints it;
# off: relative error of the mean stress of a short run against the finest step; off_x: of positions, over the radius;
# quarters: viscosity in each quarter of the strain
FIELDS = ["set", "knob", "value", "seed", "particles", "phi", "eta_r", "error", "contact_n", "contact_t", "film_n", "film_t",
          "sxx", "syy", "szz", "phi_error", "off", "off_x", "step", "steps", "cpu", "us", "quarters", "failed"]
BASE = {"N": 500, "phi": 0.5, "stokes": 0.5, "stiffness": 1e6, "fraction": 0.15, "strain": 9}
SEEDS = (1, 2, 3, 4, 5, 6)
SETTLE = 1.0     # strain after the change of a knob that is left out
SETTLED = 2.0    # strain after which a packing flows steadily
SHORT = 0.1      # strain of the runs that are compared line by line
FINEST = 0.005   # fraction of their reference

CHEAP = {"stiffness": "1e5"}     # a third of the cost: for scatter and size

# set -> knob -> {value: variables of the deck}; what costs less a unit of strain runs longer
KNOBS = {
    "base": {"base": {"": {}}},
    "time step": {"time step": {f: {"fraction": f, "strain": strain} for f, strain in
                                (("0.075", 9), ("0.2", 12), ("0.25", 10), ("0.3", 10), ("0.4", 10), ("0.5", 6), ("0.7", 6), ("1.4", 6))}},
    "stiffness": {"stiffness": {"1e5": {"stiffness": "1e5", "strain": 18}, "3e5": {"stiffness": "3e5"}, "2e5": {"stiffness": "2e5"},
                                "3e4": {"stiffness": "3e4", "strain": 27}, "1e4": {"stiffness": "1e4", "strain": 6},
                                "1e7": {"stiffness": "1e7", "strain": 4}}},
    "Stokes number": {"Stokes number": {"0.05": {"stokes": "0.05", "strain": 4}, "1": {"stokes": "1"},
                                        "2": {"stokes": 2, "fraction": 0.2, "strain": 18},
                                        "5": {"stokes": "5"}, "20": {"stokes": "20"}}},
    "left out": {"left out": {m: {"modes": f"{m} no"} for m in ("twist", "squeeze", "roll", "shear")}},
    "choices": {
        "range": {r: {"range": r} for r in ("cut 0.25", "cut 1", "shifted 1")},
        "roughness": {e: {"roughness": e} for e in ("3e-3", "2e-2")},
        "roll coefficient": {c: {"modes": f"rollcoeff {c}"} for c in ("0.15", "1.5")},
        "effective radius": {"mean": {"modes": "radius mean"}},
        "gap euler, time step": {f: {"fraction": f, "modes": "gap euler"} for f in ("0.15", "0.3")}},
}
SMALL = {"200": (200, 22), "100": (100, 40)}    # at the base settings: soft ones break down in a small cell
SIZES = {"100": (100, 45), "200": (200, 25), "1000": (1000, 9), "2000": (2000, 6)}
FRACTIONS = {"0.4": {"phi": "0.4"}, "0.45": {"phi": "0.45"}, "0.54": {"phi": "0.54", "stiffness": "6e6", "strain": 6}}
# many seeds of a cheap setting: the scatter between independent systems
SCATTER = {"0.5": (10, {"strain": 11}), "0.4": (5, {"strain": 11}), "0.45": (5, {"strain": 11}),
           "0.54": (5, {"stiffness": "8e5", "strain": 11})}
HELD = {"base": {}, "time step 0.075": {"fraction": "0.075", "strain": 7}, "time step 0.3": {"fraction": "0.3"},
        "stiffness 1e5": {"stiffness": "1e5"}, "stiffness 3e4": {"stiffness": "3e4"}, "St 0.05": {"stokes": "0.05", "strain": 5},
        "St 5": {"stokes": "5"}, "left out twist": {"modes": "twist no"}, "left out roll": {"modes": "roll no"},
        "range cut 1": {"range": "cut 1"}}
# the squeeze film left out near jamming, with and without inertia
SQUEEZE = {("0.54", "0.05"): (1, "8e5", 6), ("0.54", "0.5"): (1, "8e5", 7), ("0.5", "0.05"): (1, "1e5", 7)}
SHORTS = {"exponential": {}, "euler": {"modes": "gap euler"}, "exponential, St 0.05": {"stokes": "0.05"},
          "exponential, g 1e5": {"stiffness": "1e5"}}
STEPS = ("0.01", "0.019", "0.0375", "0.075", "0.15", "0.2", "0.25", "0.3")


def launch(folder, variables, deck=HERE / "in.suspension"):
    """Runs the deck in the folder; its output, CPU seconds, and what it says if it fails."""
    lmp = os.environ.get("LAMMPS_EXECUTABLE")
    command = [lmp] if lmp else [str(TOP / "tools" / "lmp.sh")]
    command += ["-in", str(deck), "-log", "none", "-nocite"]
    places = {"scene": TOP / "examples" / "scene", "packing": TOP / "examples" / "packing" / "packing.lmp"}
    for name, value in {**places, **variables}.items():
        command += ["-var", name, str(value)]
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    cpu = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    failed = next((line for line in done.stdout.splitlines() if line.startswith("ERROR")), "killed") if done.returncode else ""
    return done.stdout, cpu, failed


def state(states, particles, phi, seed, stiffness, stokes):
    """Restart file of a steady state, made once: packing, then strain 2 (small systems: 3) at the base settings."""
    file = states / f"{particles}_{phi}_{float(stiffness):g}_{stokes}_{seed}.restart"
    if not file.exists():
        text, _, failed = launch(states, {"make": "yes", "N": particles, "phi": phi, "seed": 1000 + 37 * int(seed), "state": file,
                                          "stokes": stokes, "stiffness": stiffness,
                                          "strain": 3 if particles < 200 else 2})
        if failed:
            sys.exit(f"no state {file}: {failed}\n{text[-2000:]}")
    return file


def measure(states, name, knob, value, seed, variables):
    """A row of the table."""
    v = {**BASE, **variables}
    own = name in ("volume fraction", "short", "scatter", "size", "squeeze")    # the others begin at the base settings
    file = state(states, v["N"], v["phi"], seed, (v if own else BASE)["stiffness"], (v if name in ("scatter", "size") else BASE)["stokes"])
    row = dict.fromkeys(FIELDS, "")
    row.update({"set": name, "knob": knob, "value": value, "seed": seed, "particles": v["N"], "phi": v["phi"]})
    with tempfile.TemporaryDirectory() as folder:
        text, cpu, failed = launch(folder, {**v, "state": file})
        step = re.findall(r"time step .*?, (\S+) of the stability limit", text)
        row.update({"step": step[-1] if step else "", "cpu": f"{cpu:.2f}", "failed": failed})
        if failed:
            return row
        data = rheology.read_run(folder)
        if name == "short":
            frame = np.loadtxt(Path(folder) / "frame.txt", skiprows=9)[:, 1:]
            row["curve"] = data["v_sxy"], frame
    steps = int(re.findall(r"for (\d+) steps with", text)[-1])
    row.update({"steps": steps, "us": f"{cpu / v['N'] / float(v['strain']) * 1e6:.0f}"})
    begin = data["v_gamma"][0] + (0 if name == "short" else max(SETTLE, float(v.get("settle", 0))))
    kept = {key[2:]: column[data["v_gamma"] >= begin] for key, column in data.items() if key.startswith("v_")}
    mean, error = rheology.estimate(kept["sxy"])
    row.update({"eta_r": f"{mean:.4f}", "error": f"{error:.4f}"})
    row.update({part: f"{kept[part].mean():.3f}" for part in FIELDS[8:15]})
    row["quarters"] = " ".join(f"{part.mean():.3f}" for part in np.array_split(kept["sxy"], 4))
    if "hold" in v:
        mean, error = rheology.estimate(kept["phi_now"])
        row.update({"phi": f"{mean:.6f}", "phi_error": f"{error:.6f}"})
    return row


def cases(wanted):
    """(set, knob, value, seed, variables) of the runs, cheap and important first."""
    for name in wanted:
        if name == "short":
            for seed in SEEDS[:3]:
                for kind, variables in SHORTS.items():
                    for fraction in (str(FINEST), *STEPS):
                        yield name, kind, fraction, seed, {"strain": SHORT, "lines": 50, "frames": "yes", **variables,
                                                           "fraction": fraction}
        elif name == "size":
            for value, (particles, strain) in SMALL.items():
                for seed in SEEDS[:4]:
                    yield name, "particles, base", value, seed, {"N": particles, "strain": strain}
            for value, (particles, strain) in SIZES.items():
                for seed in SEEDS[:1 if particles > 1000 else 2]:
                    yield name, "particles", value, seed, {**CHEAP, "N": particles, "strain": strain}
        elif name == "scatter":
            for value, (seeds, variables) in SCATTER.items():
                for seed in range(1, seeds + 1):
                    yield name, "phi", value, seed, {**CHEAP, "phi": value, **variables}
        elif name == "squeeze":
            for (phi, stokes), (seeds, stiffness, strain) in SQUEEZE.items():
                for seed in SEEDS[:seeds]:
                    for value, modes in (("on", ""), ("off", "squeeze no")):
                        yield name, f"phi {phi}, St {stokes}", value, seed, {"phi": phi, "stokes": stokes, "stiffness": stiffness,
                                                                             "strain": strain, "modes": modes}
        elif name == "volume fraction":
            for value, variables in FRACTIONS.items():
                for seed in SEEDS[:1]:
                    yield name, "phi", value, seed, variables
        elif name == "pressure":
            for value, variables in HELD.items():
                yield name, "pressure 45", value, 1, {"hold": "pressure 45", "strain": 11, "settle": 3, **variables}
        else:
            for knob, values in KNOBS[name].items():
                for value, variables in values.items():
                    for seed in SEEDS[:RUNS.get(value, RUNS.get(name, 2))]:
                        yield "strain", knob, value, seed, variables


# seeds, of a set or of a value; two of all others
RUNS = {"base": 6, "stiffness": 3, "choices": 1, "1e5": 6,
        **dict.fromkeys(("1e7", "3e4", "1e4", "0.05", "20", "0.25", "0.3", "0.4", "0.5", "0.7", "1.4", "squeeze", "roll", "shear"), 1)}
ORDER = ["base", "short", "stiffness", "Stokes number", "scatter", "left out", "size", "time step", "choices", "pressure",
         "volume fraction", "squeeze"]


def compare(row, reference):
    """Adds to a short run what it is off from the finest one."""
    (stress, place), (exact, exact_place) = row.pop("curve"), reference
    row["off"] = f"{stress.mean() / exact.mean() - 1:.3e}"
    row["off_x"] = f"{math.sqrt(np.mean(np.sum((place - exact_place) ** 2, axis=1))):.3e}"


def run(wanted, states):
    states.mkdir(parents=True, exist_ok=True)
    rows = list(csv.DictReader(TABLE.open(encoding="ascii"))) if TABLE.exists() else []
    done = {tuple(row[f] for f in FIELDS[:4]) for row in rows}
    references = {}
    for name, knob, value, seed, variables in cases(wanted):
        if (name, knob, value, str(seed)) in done and not (value == str(FINEST) and (name, knob, STEPS[-1], str(seed)) not in done):
            continue
        row = measure(states, name, knob, value, seed, variables)
        if "curve" in row:
            if value == str(FINEST):
                references[knob, seed] = row["curve"]
            compare(row, references[knob, seed])
        if (name, knob, value, str(seed)) in done:
            continue
        print(" ".join(str(row[f]) for f in FIELDS), flush=True)
        new = not TABLE.exists()
        with TABLE.open("a", newline="", encoding="ascii") as file:
            writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
            if new:
                writer.writeheader()
            writer.writerow(row)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("sets", nargs="*", default=ORDER)
    parser.add_argument("--states", type=Path, default=Path(tempfile.gettempdir()) / "accuracy_cost")
    arguments = parser.parse_args()
    run(arguments.sets, arguments.states)


if __name__ == "__main__":
    main()
