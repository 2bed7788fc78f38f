"""Error against work of two pairs: a sphere that falls on another one, and two that pass each other in a shear flow.

usage: tools/python.sh benchmarks/accuracy_cost/pairs.py [-o FOLDER]      # 2 minutes

Writes pairs.csv (all points, the failed ones with how), pairs_model.csv (distance to the exact hydrodynamics),
pairs_table.csv (for the manual), pairs.png, and prints the orders of convergence and what an error costs. pairs.md says what is measured and how to read it.
"""
import argparse
import csv
import functools
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PAIR = ROOT / "examples" / "pair"
sys.path.insert(0, str(ROOT / "tests" / "decks"))
from deck import Run
from oracle import exact_pair, normal_pair, sheared_pair

SCHEMES = "exponential", "euler"
WEIGHT = 4 / 3 * np.pi              # of the falling sphere: lengths in a, times in eta/(a rho gravity), viscosity 1
EPS = 0.02                          # roughness

# name: first gap, density, stiffness g, roughness, stiffness k of the asperities, duration, outputs, which error is judged
FALLING = {
    "smooth": (0.1, 5e-3, 500.0, 0.0, 500.0, 8.0, 48, "gap"),
    "rough": (0.025, 5e-3, 500.0, EPS, 2 * WEIGHT / EPS, 8.0, 48, "gap"),        # rests on its asperities
    "crushed": (0.025, 5e-3, 500.0, EPS, 0.5 * WEIGHT / EPS, 8.0, 48, "gap"),    # too heavy for them
    "g / 10": (0.1, 5e-3, 50.0, 0.0, 50.0, 8.0, 48, "gap"),
    "g x 10": (0.1, 5e-3, 5e3, 0.0, 5e3, 8.0, 48, "gap"),
    "St 30": (0.1, 4500.0, WEIGHT / 0.05, 0.0, WEIGHT / 0.05, 376.0, 12, "path"),    # swings four times on its bulk spring
}

# lengths in a, times in 1/rate, viscosity 1; both are in range from the beginning (but for "meets") to the end
X_START, Y_START, X_END, SPACING = -2.4, 0.5, 2.2, 0.1
ENCOUNTER = {
    "smooth": {},
    "rough": {"eps": 0.02},
    "rough, friction": {"eps": 0.02, "mu": 0.5},
    "Ca 1e-2": {"g": 1e2},
    "Ca 1e-4": {"g": 1e4},
    "St 0.002": {"density": 0.002},
    "St 0.2": {"density": 0.2},
    "reach 4": {"reach": 4.0, "x0": -5.8},
    "meets": {"x0": -5.8},    # comes into range during the run
}
USUAL = {"density": 0.02, "g": 1e3, "eps": 0.0, "mu": 0.0, "reach": 0.5, "x0": X_START}

FINE = [1.0, 0.3, 0.1, 0.03, 0.01, 0.003]    # steps over the limit that the pair style reports
COARSE = [1.5, 2.0, 2.5, 3.0, 4.0, 6.0, 10.0]
ALL_FILMS = ["cut 0.5", "roughness 0.0"]

# name: pair_style, variables of the deck; all from x0 = -5.8, y at x = 5
MODELS = {
    "cut 0.5": {}, "cut 0.25": {"reach": 0.25}, "cut 1": {"reach": 1.0}, "cut 2": {"reach": 2.0}, "cut 4": {"reach": 4.0},
    "shifted 0.5": {"rule": "shifted"}, "shifted 1.5": {"rule": "shifted", "reach": 1.5},
    "squeeze only": {"more": "shear no roll no twist no"}, "no roll, no twist": {"more": "roll no twist no"},
    "Ca 1e-2": {"g": 1e2}, "Ca 1e-4": {"g": 1e4},
    "St 0.002": {"density": 0.002}, "St 0.2": {"density": 0.2}, "overdamped": {"motion": "overdamped"},
    "roughness 0.005": {"eps": 0.005}, "roughness 0.02": {"eps": 0.02}, "roughness 0.05": {"eps": 0.05},
    "rough 0.02, friction 0.5": {"eps": 0.02, "mu": 0.5},
}
ROLLS = {"rollcoeff 0.6": "rollcoeff 0.6", "rollcoeff 0.15": "rollcoeff 0.15", "rollcoeff 1.5": "rollcoeff 1.5",
         "no roll": "roll no", "no roll, no twist": "roll no twist no"}

# what LAMMPS says last: what happened
BLOWN_UP = {"Lost atoms": "thrown out of the box", "effective radii at step": "through the partner (the style stops)",
            "Non-numeric": "NaN", "Out of range atoms": "thrown out of the box"}


def lammps(deck, **variables):
    """A run that may fail."""
    if "MPIRUN" in os.environ and "LAMMPS_EXECUTABLE" in os.environ:
        environment = dict(os.environ)
        command = [environment["MPIRUN"], "1", environment.pop("LAMMPS_EXECUTABLE")]
    else:
        environment, command = None, [str(ROOT / "tools" / "lmp.sh")]
    command += ["-in", str(deck), "-log", "none", "-nocite"]
    for name, value in variables.items():
        command += ["-var", name, str(value)]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, env=environment)
    return Run(done.stdout, done.returncode)


def why(run):
    """How a run failed, or nothing; one that does not even begin ends the program."""
    if run.code == 0:
        return "NaN" if re.search(r"\bnan\b", run.text) else ""
    for words, how in BLOWN_UP.items():
        if words in run.text:
            return how
    sys.exit(run.text[-2000:])


def outputs_apart(spacing, step):
    """Steps from one output to the next, and the step that fits."""
    every = int(np.ceil(spacing / step * (1 - 1e-9)))
    return every, spacing / every


def stiffness_limit(mass, g, kt, partners=1):
    """The limit of the time step as the pair style reports it."""
    return 2 / np.sqrt(2 * partners * max(g, 3.5 * kt) / mass)


# ---- the falling sphere

@functools.lru_cache(None)
def falling_reference(name):
    u0, density, g, eps, k, duration, rows, _ = FALLING[name]
    pair = normal_pair.Pair(4 / 3 * np.pi * density, WEIGHT, g, k, eps, normal_pair.film(1.0, 1.0))
    stiff = name == "St 30"    # where the film closes to nothing
    times = np.linspace(0.0, duration, rows + 1)
    return pair.solve(u0, 0.0, times, **({"rtol": 1e-9} if stiff else {"rtol": 1e-12, "method": "DOP853"})).y


def falling(name, scheme, fraction):
    u0, density, g, eps, k, duration, rows, judged = FALLING[name]
    mass = 4 / 3 * np.pi * density
    limit = stiffness_limit(mass, g, g)
    every, step = outputs_apart(duration / rows, fraction * limit)
    run = lammps(PAIR / "in.fall", density=density, g=g, k=k, eps=eps, u0=u0, gap=scheme,
                 duration=duration, rows=rows, courant=step / np.sqrt(mass / (2 * g)) * (1 + 1e-9))
    row = {"scene": "falling sphere", "setting": name, "gap": scheme, "dt_over_limit": step / limit, "steps": every * rows}
    failed = why(run)
    if not failed:
        table, reference = run.thermo(), falling_reference(name)
        row["error_gap"] = np.max(np.abs(np.log(table["c_u"]) - reference[2]))
        row["error_path"] = np.max(np.abs(table["v_un"] - reference[0])) / u0
        if row["error_" + judged] > (np.log(2) if judged == "gap" else 1.0):
            failed = f"{judged} wrong by > 100 %"
    return {**row, "judged": judged, "failed": failed}


# ---- the pair in shear

def of_encounter(name):
    return {**USUAL, **ENCOUNTER[name]}


@functools.lru_cache(None)
def encounter_reference(name):
    """Times, x, y, and the gap where in range."""
    set_ = of_encounter(name)
    pair = sheared_pair.Pair(rate=1.0, eta=1.0, density=set_["density"], g=set_["g"], kt=0.5 * set_["g"], reach=set_["reach"],
                             k=set_["g"], eps=set_["eps"], mu=set_["mu"])
    times = np.arange(0.0, 60.0, SPACING)
    last = 12.0 if set_["x0"] == X_START else 30.0
    times = times[times < last]
    states, _ = pair.solve((0, 0, 0), (set_["x0"], Y_START, 0), times, 1e-8)
    x, y = (states[sheared_pair.XJ] - states[sheared_pair.XI])[:2]
    passed = np.argmax(x > X_END) + 1    # one output beyond
    assert passed > 1, name
    return times[:passed], x[:passed], y[:passed], np.exp(states[sheared_pair.GAP, :passed])


def encounter_variables(set_):
    friction = f"coulomb {set_['mu']}" if set_["mu"] else "none"
    found = {"density": set_["density"], "g": set_["g"], "k": set_["g"], "kt": 0.5 * set_["g"], "eps": set_["eps"],
             "friction": friction, "reach": set_["reach"], "x0": set_["x0"], "y0": Y_START}
    return {**found, **{name: set_[name] for name in ("rule", "motion") if name in set_}}


def encounter(name, scheme, fraction):
    set_ = of_encounter(name)
    limit = stiffness_limit(4 / 3 * np.pi * set_["density"], set_["g"], 0.5 * set_["g"])
    every, step = outputs_apart(SPACING, fraction * limit)
    times, x, y, u = encounter_reference(name)
    run = lammps(PAIR / "in.shear", step=step, every=every, rows=len(times) - 1,
                 more=f"gap {scheme}", **encounter_variables(set_))
    row = {"scene": "pair in shear", "setting": name, "gap": scheme, "dt_over_limit": step / limit,
           "steps": every * (len(times) - 1)}
    failed = why(run)
    if not failed:
        table = run.thermo()
        near = np.isfinite(u) & (table["c_u"] > 0)
        row["error_gap"] = np.max(np.abs(np.log(table["c_u"][near] / u[near])))
        row["error_least"] = abs(np.log(np.min(table["c_u"][near]) / np.min(u[near])))
        # y where the pair has passed: of two runs interpolated alike
        row["error_path"] = abs(y_at(X_END, table["v_X"], table["v_Y"]) - y_at(X_END, x, y))
        if not row["error_path"] < Y_START:
            failed = "streamline wrong by > 100 %"
        elif row["error_least"] > np.log(2):
            failed = "smallest gap wrong by > 100 %"
    return {**row, "judged": "least", "failed": failed}


def y_at(x_end, x, y):
    """y on the way out; NaN if it does not come there."""
    if x[-1] < x_end:
        x, y = np.append(x, x[-1] + (x[-1] - x[-2])), np.append(y, 2 * y[-1] - y[-2])    # a run late by less than one output
    n = np.argmax(x > x_end)
    return y[n - 1] + (x_end - x[n - 1]) * (y[n] - y[n - 1]) / (x[n] - x[n - 1]) if n else np.nan


# ---- what the steps cost

def cost(style, coeff):
    """CPU nanoseconds of a pair and step in the pair style."""
    text = lammps(HERE / "in.pair_cost", style=style, coeff=coeff).text
    pairs = int(re.search(r"(\d+) pairs in range", text)[1])
    loop, steps = re.search(r"Loop time of (\S+) on 1 procs for (\d+) steps", text).groups()
    busy = float(re.search(r"([\d.]+)% CPU use", text)[1]) / 100
    share = float(re.search(r"^Pair .*\| *([\d.]+)$", text, re.MULTILINE)[1]) / 100
    return float(loop) * busy * share / int(steps) / pairs * 1e9


def costs(rounds=3):
    """The best of the rounds, which go through all variants in turn."""
    rough = f"roughness {EPS} friction coulomb 0.5"
    variants = {(scheme, smooth): ("cut 0.5 gap " + scheme, ALL_FILMS[1] if smooth else rough)
                for scheme in SCHEMES for smooth in (True, False)}
    variants.update({"shifted": ("shifted 0.5", ALL_FILMS[1]), "no roll": ("cut 0.5 roll no twist no", ALL_FILMS[1]),
                     "squeeze": ("cut 0.5 shear no roll no twist no", ALL_FILMS[1])})
    found = [{name: cost(*variant) for name, variant in variants.items()} for _ in range(rounds)]
    return {name: min(row[name] for row in found) for name in variants}


# ---- all together

def sweep(scene, names, fine, coarse):
    """All points of a scene; coarse steps end where both schemes have failed, equal steps are taken once."""
    rows = []
    for name in names:
        for scheme in SCHEMES:
            seen = set()
            for fraction in fine + coarse:
                row = scene(name, scheme, fraction)
                if row["steps"] in seen:
                    continue
                seen.add(row["steps"])
                rows.append(row)
                if row["failed"] and fraction > 1:
                    break
    return rows


def order(rows, what, below=0.15):
    """Slope of the error against the step where the steps are below that fraction of the limit; NaN without two points."""
    points = [(row["dt_over_limit"], row[what]) for row in rows if row["dt_over_limit"] < below and not row["failed"]]
    if len(points) < 2:
        return np.nan
    return np.polyfit(*np.log(np.array(points)).T, 1)[0]


def work_for(error, rows, what):
    """Work at which the error is reached, between the points in double logarithmic scales; NaN: not on the way."""
    points = sorted((row["cpu_us"], row[what]) for row in rows if not row["failed"])
    for (w1, e1), (w2, e2) in zip(points[-2::-1], points[:0:-1]):    # from the most work down
        if e2 <= error < e1:
            return np.exp(np.log(w1) + np.log(w2 / w1) * np.log(error / e1) / np.log(e2 / e1))
    return points[0][0] if points and points[0][1] <= error else np.nan


def curve(rows, scene, setting, scheme):
    return [row for row in rows if (row["scene"], row["setting"], row["gap"]) == (scene, setting, scheme)]


def model_row(name, set_, exact_y, ns):
    """How far the model is from the exact hydrodynamics, with a step of a tenth of the limit."""
    set_ = {**USUAL, "x0": -5.8, **set_}
    every, step = outputs_apart(SPACING, 0.1 * stiffness_limit(4 / 3 * np.pi * set_["density"], set_["g"], 0.5 * set_["g"]))
    run = lammps(PAIR / "in.shear", step=step, every=every, rows=450,
                 more=set_.get("more", "gap exponential"), **encounter_variables(set_))
    table = run.thermo()
    gap = np.min(table["c_u"][table["c_u"] > 0])
    y = np.interp(5.0, table["v_X"], table["v_Y"])
    return {"setting": name, "least_gap": gap, "y": y, "y_exact": exact_y, "error_y": y - exact_y, "ns": ns}


def models(ns):
    smooth = ns["exponential", True]
    price = {"shifted 0.5": ns["shifted"], "shifted 1.5": ns["shifted"], "squeeze only": ns["squeeze"],
             "no roll, no twist": ns["no roll"]}
    rows = []
    for name, set_ in MODELS.items():
        eps = set_.get("eps", 0.0)
        gap, y = exact_pair.encounter(-5.8, Y_START, 5.0)
        if eps:
            gap, y = eps, exact_pair.leave_contact(eps, 5.0)
        row = model_row(name, set_, y, price.get(name, ns["exponential", not eps]))
        rows.append({**row, "gap_exact": gap, "cost": row["ns"] / smooth})
    return rows


def distance_of_model():
    """The same of the reference in the scene of the points, smooth."""
    _, x, y, u = encounter_reference("smooth")
    gap, y_exact = exact_pair.encounter(X_START, Y_START, X_END)
    return abs(np.log(np.min(u) / gap)), abs(y_at(X_END, x, y) - y_exact)


def rolls():
    """What the torques change for radii 1 and 0.7 off the plane, where the pair rolls and twists."""
    rows = []
    for name, more in ROLLS.items():
        table = lammps(PAIR / "in.shear", density=0.02, g=1e3, k=1e3, kt=500.0, reach=0.5, a2=0.7,
                       x0=-4.8, y0=0.6, z0=0.4, step=1e-3, every=100, rows=300, more=more).thermo()
        rows.append({"setting": name, "least_gap": np.min(table["c_u"][table["c_u"] > 0]),
                     "y": np.interp(4.0, table["v_X"], table["v_Y"]), "z": np.interp(4.0, table["v_X"], table["v_Z"])})
    return rows


def write(path, rows):
    def shown(value):
        return f"{value:.4g}" if isinstance(value, float) else value

    names = list(dict.fromkeys(name for row in rows for name in row))
    with open(path, "w", newline="", encoding="ascii") as file:
        writer = csv.DictWriter(file, names, delimiter=";", lineterminator="\n")
        writer.writeheader()
        writer.writerows({name: shown(value) for name, value in row.items()} for row in rows)


def read(path):
    """What write() wrote, numbers as numbers."""
    def number(word):
        try:
            return float(word)
        except ValueError:
            return word

    with open(path, encoding="ascii") as file:
        return [{name: number(word) for name, word in row.items()} for row in csv.DictReader(file, delimiter=";")]


def summary(rows):
    """One line per scene and setting: orders, error at the limit, what an error of 1e-3 costs, the smallest step that failed."""
    lines = []
    for scene, names in (("falling sphere", FALLING), ("pair in shear", ENCOUNTER)):
        for name in names:
            line = {"scene": scene, "setting": name}
            for scheme in SCHEMES:
                points = curve(rows, scene, name, scheme)
                what = "error_" + points[0]["judged"]
                line[f"order_{scheme}"] = order(points, "error_path" if what == "error_path" else "error_gap")
                line[f"at_limit_{scheme}"] = next(row[what] for row in points if row["dt_over_limit"] > 0.5)
                line[f"us_{scheme}"] = work_for(1e-3, points, what)
                line[f"fails_{scheme}"] = min([row["dt_over_limit"] for row in points if row["failed"]], default=np.nan)
            lines.append(line)
    return lines


# (scene, setting) of the summary -> row of the table in the manual
SHOWN = {("falling sphere", "smooth"): "falling sphere: smooth",
         ("falling sphere", "rough"): "rough, rests on its asperities",
         ("falling sphere", "crushed"): "rough, asperities crushed",
         ("falling sphere", "g / 10"): "smooth, stiffness / 10",
         ("falling sphere", "g x 10"): "smooth, stiffness x 10",
         ("falling sphere", "St 30"): "smooth, St 30: oscillates",
         ("pair in shear", "smooth"): "pair in shear: smooth",
         ("pair in shear", "rough"): "rough, no friction",
         ("pair in shear", "rough, friction"): "rough, friction 0.5",
         ("pair in shear", "reach 4"): "cut 4",
         ("pair in shear", "meets"): "comes into range during the run"}


def table(lines):
    """Rows of pairs_table.csv: the summary with few digits."""
    def digits(x, form=".2g"):
        return "none" if np.isnan(x) else f"{x:{form}}"

    def order_of(line, scheme):
        return "none" if scheme == "euler" and line["setting"] == "St 30" else digits(line[f"order_{scheme}"], ".2f")

    rows = []
    for line in lines:
        row = {"case": SHOWN.get((line["scene"], line["setting"]), line["setting"])}
        for what, value in (("order", order_of), ("error at the limit", lambda x, s: digits(x[f"at_limit_{s}"])),
                            ("work for 1e-3", lambda x, s: digits(x[f"us_{s}"], ".0f")),
                            ("first failure", lambda x, s: digits(x[f"fails_{s}"]))):
            row.update({f"{what}, {scheme}": value(line, scheme) for scheme in SCHEMES})
        rows.append(row)
    return rows


def measure(folder):
    ns = costs()
    rows = sweep(falling, ["smooth", "rough", "crushed"], FINE, COARSE)
    rows += sweep(falling, ["g / 10", "g x 10", "St 30"], FINE[:5], COARSE)
    rows += sweep(encounter, ["smooth", "rough", "rough, friction"], FINE, COARSE)
    rows += sweep(encounter, list(ENCOUNTER)[3:], FINE[:5], COARSE[-4:])
    for row in rows:
        row["ns_per_pair_step"] = ns[row["gap"], row["setting"] not in ("rough", "rough, friction", "crushed")]
        row["cpu_us"] = row["steps"] * row["ns_per_pair_step"] / 1e3
    write(folder / "pairs.csv", rows)
    write(folder / "pairs_model.csv", models(ns))
    write(folder / "pairs_roll.csv", rolls())


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", default=HERE, type=Path, metavar="FOLDER")
    parser.add_argument("--draw", action="store_true", help="only the figure and the orders, from the tables in FOLDER")
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)    # now, not after the runs
    if not arguments.draw:
        measure(arguments.output)
    rows = read(arguments.output / "pairs.csv")
    lines = summary(rows)
    write(arguments.output / "pairs_summary.csv", lines)
    write(arguments.output / "pairs_table.csv", table(lines))
    for line in lines:
        print("  ".join(f"{key} {value:.3g}" if isinstance(value, float) else str(value) for key, value in line.items()))
    import pairs_figure
    pairs_figure.draw(rows, read(arguments.output / "pairs_model.csv"), distance_of_model(), arguments.output / "pairs.png")


if __name__ == "__main__":
    main()
