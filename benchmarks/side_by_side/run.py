"""The same scenes with this package and with what LAMMPS has: how large may the time step be, and how wrong is it?

usage: tools/python.sh benchmarks/side_by_side/run.py [--work folder] [--scenes fall ...] [--draw]

Needs a LAMMPS with the packages GRANULAR, COLLOID and PLUGIN: that of tools/setup.sh, or the one of LAMMPS_EXECUTABLE.
Writes results.csv and figure.png here. 5 minutes.
"""
import argparse
import csv
import math
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
TOLERANCE = 0.1      # accurate
FILM = 1.5 * np.pi    # force u/u', of radius and viscosity 1
METHODS = [("lubcontact, gap exponential", "exponential", None), ("lubcontact, gap euler", "euler", None),
           ("granular + lubricate, inner gap 1e-2", "overlay", 1e-2), ("granular + lubricate, inner gap 1e-3", "overlay", 1e-3)]


def table(text):
    """Last thermo table, a dict of arrays; None if there is none."""
    names, rows = None, []
    for line in text.splitlines():
        words = line.split()
        if words[:1] == ["Step"]:
            names, rows = words, []
        elif line.startswith("Loop time"):
            break
        elif names and len(words) == len(names):
            try:
                rows.append([float(word) for word in words])
            except ValueError:
                pass
    return dict(zip(names, np.array(rows).T)) if rows else None


def lammps():
    """LAMMPS_EXECUTABLE with the plugin in LAMMPS_PLUGIN_PATH, or what tools/setup.sh has built."""
    lmp = os.environ.get("LAMMPS_EXECUTABLE")
    if lmp and os.environ.get("LAMMPS_PLUGIN_PATH"):
        return [lmp]
    return [str(ROOT / "tools/lmp.sh")]


def simulate(deck, work, **variables):
    """The table, and how it ended: '' or in which way it went wrong."""
    command = [*lammps(), "-in", str(HERE / deck), "-log", "none", "-nocite", "-var", "root", str(ROOT)]
    for name, value in variables.items():
        command += ["-var", name, str(value)]
    done = subprocess.run(command, cwd=work, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    error = re.search(r"^ERROR.*", done.stdout, re.MULTILINE)
    if error:
        for word, ending in (("Lost atoms", "loses atoms"), ("overlap", "stops: overlap"), ("umeric", "not a number"),
                             ("not a number", "not a number"), ("Unrecognized pair style 'lubricate'", None)):
            if word in error[0]:
                if ending is None:
                    sys.exit("This LAMMPS has no pair style lubricate: use one with the packages COLLOID and GRANULAR, e.g. that of tools/setup.sh")
                return table(done.stdout), ending
        sys.exit(done.stdout[-2000:])
    rows = table(done.stdout)
    if rows is None:
        sys.exit(done.stdout[-2000:])
    if not all(np.all(np.isfinite(column)) for column in rows.values()):
        return rows, "not a number"
    return rows, ""


def gap(rows):
    return rows["c_u"] if "c_u" in rows else rows["v_un"]


def log_error(exact):
    """Largest relative error of the gap, of what the closed form ln u(t) says; inertia is -m v/c."""
    def error(rows):
        mass = 4 / 3 * np.pi * 5e-4
        u = np.maximum(gap(rows), 1e-300)
        return np.max(np.abs(np.exp(np.log(u) - exact(rows["Time"]) + mass * rows["v_vz"] / FILM) - 1))
    return error


def fall(t):
    return math.log(0.1) - 8 / 9 * t


def squeeze(t):
    return math.log(0.1) - 0.5 * math.log(33.3) * (1 - np.cos(t))


def streamline(rows):
    """By symmetry of the flow in time smooth spheres leave on the streamline on which they came."""
    return abs(rows["v_y"][-1] / 0.5 - 1)


def way_back(rows):
    """After as long a flow in the other direction they are where they were."""
    return math.hypot(rows["v_x"][-1] + 4, rows["v_y"][-1] - 0.5)


SCENES = {    # duration, largest and smallest time step of the scan, common time step, error
    "fall": ("a sphere falls on another from a gap of 0.1 to 0.003", 3.95, 5.12e-3, 1.25e-6, 2e-5, log_error(fall)),
    "squeeze": ("pressed to and pulled off another, gap 0.1 to 0.003 and back", 2 * np.pi, 5.12e-3, 1.25e-6, 2e-5, log_error(squeeze)),
    "pass": ("two spheres pass each other in shear", 20.0, 1.28e-2, 2.5e-5, 4e-4, streamline),
    "reversal": ("two spheres meet in shear, and the flow turns round", 16.0, 1.28e-2, 2.5e-5, 4e-4, way_back),
    "suspension": ("200 spheres at a volume fraction of 0.5 in shear", 0.2, 2.56e-3, 2.5e-6, 1.6e-4, None),
}


def attempt(scene, method, inner, dt, work, reference=None):
    """(error or nan, ending, table) of one run."""
    duration, error = SCENES[scene][1], SCENES[scene][5]
    steps = max(1, round(duration / dt))
    variables = {"method": method, "dt": repr(duration / steps), "steps": steps, "rows": max(1, steps // 50)}
    if inner:
        variables["inner"] = inner
    if scene == "suspension":
        rows, ending = simulate("in.suspension", work, **variables)
        if ending or rows is None:
            return math.nan, ending, rows
        stress = -rows["Pxy"][len(rows["Pxy"]) // 2:].mean()
        return (stress / reference - 1 if reference else stress), "", rows
    rows, ending = simulate("in.pair", work, scene=scene, **variables)
    return (math.nan if ending else error(rows)), ending, rows


def scan(scene, work):
    what, _, dt_max, dt_min, common, _ = SCENES[scene]
    results = []
    for name, method, inner in METHODS:
        dts = [dt_max * 2.0**-n for n in range(int(round(math.log2(dt_max / dt_min))) + 1)]
        reference = attempt(scene, method, inner, dts[-1], work)[0] if scene == "suspension" else None
        stable = accurate = None
        errors, beyond, spin = [], "", math.nan
        for dt in dts:
            error, ending, rows = attempt(scene, method, inner, dt, work, reference)
            errors.append(error)
            if ending or not abs(error) < 1e3:
                stable = accurate = None
                beyond = ending or "error above 1000"
            elif stable is None:
                stable = dt
            if not abs(error) <= TOLERANCE:
                accurate = None
            elif accurate is None:
                accurate = dt
            if rows is not None and "c_spin" in rows and not ending:
                spin = rows["c_spin"][-1]
            if accurate and dt < common and accurate > 4 * dt:
                break
        at = [e for e, dt in zip(errors, dts) if abs(dt / common - 1) < 0.5]
        row = {"scene": scene, "what": what, "method": name, "stable dt": stable, "accurate dt": accurate, "common dt": common,
               "error there": at[0] if at else math.nan, "beyond": beyond, "mean spin over rate": spin,
               "scan": " ".join(f"{dt:.3g}:{e:.2g}" for dt, e in zip(dts, errors))}
        results.append(row)
        print({k: v for k, v in row.items() if k != "what"}, flush=True)
    return results


def draw(results):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    scenes = list(dict.fromkeys(row["scene"] for row in results))
    figure, axes = plt.subplots(1, len(scenes), figsize=(3.2 * len(scenes), 3.4), sharey=True, constrained_layout=True)
    for axis, scene in zip(np.atleast_1d(axes), scenes):
        for n, (name, _, _) in enumerate(METHODS):
            for row in results:
                if row["scene"] != scene or row["method"] != name:
                    continue
                points = np.array([[float(v) for v in pair.split(":")] for pair in row["scan"].split()])
                axis.loglog(points[:, 0], np.clip(np.abs(points[:, 1]), 1e-10, 1e3), "o-", color=f"C{n}", label=name, ms=3)
                wrong = ~np.isfinite(points[:, 1])
                axis.loglog(points[wrong, 0], np.full(wrong.sum(), 3e3 * 2.5**n), "x", color=f"C{n}")
        axis.axhline(TOLERANCE, color="gray", lw=0.5)
        axis.set(title=scene, xlabel="time step")
    np.atleast_1d(axes)[0].set_ylabel("relative error (crosses: blows up)")
    np.atleast_1d(axes)[len(scenes) // 2].legend(fontsize=6, loc="lower center")
    figure.savefig(HERE / "figure.png", dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", default="side_by_side.work")
    parser.add_argument("--scenes", nargs="+", default=list(SCENES), choices=list(SCENES))
    parser.add_argument("--draw", action="store_true", help="only the figure, from results.csv")
    args = parser.parse_args()
    if args.draw:
        with (HERE / "results.csv").open() as file:
            return draw(list(csv.DictReader(file)))
    work = Path(args.work)
    work.mkdir(parents=True, exist_ok=True)
    if "suspension" in args.scenes and not (work / "state.data").exists():
        simulate("in.state", work)
    results = []
    for scene in args.scenes:
        results += scan(scene, work)
    with (HERE / "results.csv").open("w", newline="") as file:
        writer = csv.DictWriter(file, results[0].keys())
        writer.writeheader()
        writer.writerows(results)
    draw(results)


if __name__ == "__main__":
    main()
