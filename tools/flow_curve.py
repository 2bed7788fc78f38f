"""Flow curves: one run of a deck for each value of one of its variables, each as long as its error bar asks for.

usage: tools/python.sh tools/flow_curve.py DECK VARIABLE VALUE ... [--set NAME=VALUE ...] [--tolerance 0.05]
                       [--max-strain 50] [--min-strain 2] [--skip 0] [-n 1] [--jobs 1] [--table NAME.csv] [--draw]
  DECK          name of an example, such as shear_thickening, or path of a deck that writes stress.txt as
                examples/scene/stress.lmp does
  VARIABLE      index variable of the deck that differs from run to run: rate, Iv, load, phi, ...
  --set         other index variables of the deck, the same in all runs
  --tolerance   a run ends when the relative error of its viscosity (stress over rate) is that small
  --max-strain  or at this strain at the latest; a run whose deck ends before is taken as it is
  --skip        strain at the start that is left out in any case, such as a first part of another kind
  -n            ranks of a run
  --jobs        runs at the same time
  --table       one row a run; the figure NAME.png and the runs, NAME.runs, are beside it; default flow_curve.csv
  --draw        only draw the table
What the table already holds, at this tolerance or at this strain, is not repeated. Exit status 1: a run failed.
The manual page is Tools_flow_curve.
"""
import argparse
import os
import re
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

import flow_table
import steady
from flow_table import Unusable

TOOLS = Path(__file__).resolve().parent
EXAMPLES = TOOLS.parent / "examples"
GROWTH = 1.25           # of the strain between two looks at the error
INDEPENDENT = 10        # samples that an error needs before a run may end on it
STRESSES = ["sxx", "syy", "szz", "contact_n", "contact_t", "film_n", "film_t", "inertia"]
NEEDED = ["TimeStep", "v_gamma", "v_gamma_dot", "v_sxy"]


# the deck

def find_deck(name):
    """Path of a deck from its own name or that of an example."""
    for path in (Path(name), EXAMPLES / name / f"in.{name}"):
        if path.is_file():
            return path.resolve()
    known = sorted(path.parent.name for path in EXAMPLES.glob("*/in.*") if writes_stress(path))
    raise Unusable(f"no deck {name}: give the path of one or the name of an example: " + ", ".join(known))


def included(path, places):
    """The deck and what it includes, as far as found."""
    yield path
    for name in re.findall(r"^\s*include\s+(\S+)", path.read_text(encoding="utf-8"), re.MULTILINE):
        for variable, place in places.items():
            name = name.replace("${" + variable + "}", str(place))
        if (path.parent / name).is_file():
            yield from included(path.parent / name, places)


def places_of_examples():
    return {"scene": EXAMPLES / "scene", "packing": EXAMPLES / "packing" / "packing.lmp"}


def index_variables(deck):
    """Names of the variables that -var can set."""
    found = {}
    for path in included(deck, places_of_examples()):
        found.update(dict.fromkeys(re.findall(r"\bvariable\s+(\w+)\s+index\b", path.read_text(encoding="utf-8"))))
    return list(found)


def writes_stress(deck):
    return any(path.name == "stress.lmp" for path in included(deck, places_of_examples()))


def read_settings(words, variable, known):
    """Dict of NAME=VALUE words; Unusable if the deck would ignore one."""
    settings = {}
    for word in words:
        name, equal, value = word.partition("=")
        if not equal or not name or not value:
            raise Unusable(f"--set {word}: write NAME=VALUE, for example --set phi=0.54")
        settings[name] = value
    for name in [variable, *settings]:
        if name not in known:
            raise Unusable(f"the deck has no index variable {name}, but " + " ".join(known))
    if variable in settings:
        raise Unusable(f"--set {variable}=...: its values are the ones that differ from run to run")
    return settings


# a run

def command(args, case_variables):
    """Command of a run and its environment."""
    environment = dict(os.environ)
    lmp = environment.pop("LAMMPS_EXECUTABLE", None)    # the tests say which; for the tools it would be one of the user
    words = [environment["MPIRUN"], str(args.ranks), lmp] if lmp and "MPIRUN" in environment else \
        [str(TOOLS / "lmp.sh"), "-n", str(args.ranks)]
    words += ["-in", str(args.deck), "-log", "log.lammps", "-screen", "none"]
    for name, value in case_variables.items():
        words += ["-var", name, str(value)]
    return words, environment


def variables_of(args, value):
    """Index variables of a run: what was asked for, long enough, without pictures."""
    chosen = {name: place for name, place in places_of_examples().items() if name in args.known}
    if "strain" in args.known:
        chosen["strain"] = args.max_strain
    if "image" in args.known:
        chosen["image"] = "no"
    return {**chosen, **args.settings, args.variable: value}


def looks(first, last):
    """Strains at which the error is looked at."""
    strains = [first]
    while strains[-1] < last:
        strains.append(min(strains[-1] * GROWTH, last))
    return strains


def crept(data):
    """Path of the strain, up to each line."""
    return np.abs(data["v_gamma"][0]) + np.concatenate([[0.0], np.cumsum(np.abs(np.diff(data["v_gamma"])))])


def mean(values, needs_error):
    """Estimate of the mean; of what is not needed, without error where it is too short for one."""
    try:
        return steady.mean_error(values)
    except steady.TooShort:
        if needs_error:
            raise
        return steady.Estimate(float(np.mean(values)), float("nan"), float("nan"), 0.0, len(values), 0.0)


def evaluate(data, until, skip):
    """Estimates of viscosity and columns over the steady part up to a strain; raises as steady does."""
    path = crept(data)
    kept = (path > skip) & (path <= until * (1 + 1e-9))
    columns = {name: column[kept] for name, column in data.items()}
    if not len(columns["v_sxy"]):
        raise steady.TooShort("no line yet")
    watched = [columns[name] for name in ("v_sxy", "v_gamma_dot", "v_phi_now") if name in columns]
    start = steady.steady_start(*watched)
    columns = {name: column[start:] for name, column in columns.items() if name.startswith("v_")}
    found = {name[2:]: mean(column, name in NEEDED) for name, column in columns.items() if name != "v_gamma"}
    found["viscosity"] = steady.ratio(columns["v_sxy"], columns["v_gamma_dot"])
    found["from"] = columns["v_gamma"][0]
    return found


def units(file):
    """Unit of the stresses and viscosity of the fluid, from the title that scene/stress.lmp gives stress.txt."""
    with open(file, encoding="ascii", errors="replace") as text:
        title = text.readline()
    found = re.match(r"# stresses over (\S+), viscosity of the fluid (\S+)", title)
    return (float(found[1]), float(found[2])) if found else (1.0, 1.0)


def read_so_far(file):
    """Columns of stress.txt of a run that may not have written it yet; None then."""
    try:
        data = steady.read_ave_time(file)
    except (OSError, ValueError):
        return None
    missing = [name for name in NEEDED if name not in data]
    if missing:
        raise Unusable(f"{file} has no column {', '.join(missing)}: the deck must include examples/scene/stress.lmp")
    return data


def reached(found, tolerance):
    """Is the error small enough, and of enough independent samples of what fluctuates, the stress or the rate?"""
    viscosity, independent = found["viscosity"], min(found["sxy"].independent, found["gamma_dot"].independent)
    return viscosity.error <= tolerance * abs(viscosity.mean) and independent >= INDEPENDENT


def judge(data, args, planned):
    """Looks that the run has passed: (outcome, strain, estimates) of the first good enough, or of the last one."""
    path = crept(data)[-1]
    for strain in planned:
        if path < strain:
            break
        try:
            found = evaluate(data, strain, args.skip)
        except (steady.NotSteady, steady.TooShort):
            continue
        if reached(found, args.tolerance):
            return "tolerance", strain, found
    return None


def stop(process):
    """Ends a run that has shown enough."""
    process.terminate()
    try:
        process.wait(20)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


def follow(process, folder, args):
    """Waits until a run has reached the tolerance or the largest strain, then ends it; what judge() found."""
    planned, seen = looks(args.min_strain + args.skip, args.max_strain), 0
    try:
        while process.poll() is None:
            time.sleep(args.wait)
            data = read_so_far(folder / "stress.txt")
            if data is None or len(data["TimeStep"]) == seen:
                continue
            seen = len(data["TimeStep"])
            verdict = judge(data, args, planned)
            if verdict or crept(data)[-1] >= args.max_strain:
                return verdict
    finally:
        if process.poll() is None:
            stop(process)
    if process.returncode != 0:
        raise Unusable(last_error(folder))
    data = read_so_far(folder / "stress.txt")
    if data is None:
        raise Unusable("the deck wrote no lines to stress.txt: it must include examples/scene/stress.lmp and run")
    return judge(data, args, planned)


def last_error(folder):
    """What LAMMPS said last."""
    log = folder / "log.lammps"
    lines = log.read_text(errors="replace").splitlines() if log.exists() else []
    errors = [n for n, line in enumerate(lines) if line.startswith("ERROR")]
    return "LAMMPS stopped: " + (" / ".join(lines[errors[-1]:errors[-1] + 2]) if errors else f"see {log}")


def run(args, value):
    """Runs the deck for a value; its row of the table."""
    folder = args.table.with_suffix(".runs") / re.sub(r"[^\w.=+-]+", "_", "_".join(
        [args.deck.name, *(f"{n}={v}" for n, v in args.settings.items()), f"{args.variable}={value}"]))
    folder.mkdir(parents=True, exist_ok=True)
    for old in ("stress.txt", "contacts.txt", "log.lammps"):
        (folder / old).unlink(missing_ok=True)
    words, environment = command(args, variables_of(args, value))
    with open(folder / "screen.txt", "w", encoding="utf-8") as screen:
        with subprocess.Popen(words, cwd=folder, env=environment, stdout=screen, stderr=screen) as process:
            verdict = follow(process, folder, args)
    data = steady.read_ave_time(folder / "stress.txt")
    return row_of(args, value, verdict, data, units(folder / "stress.txt"))


def row_of(args, value, verdict, data, scales):
    unit, fluid = scales
    end = min(crept(data)[-1], args.max_strain)
    row = {"deck": args.deck.name, "settings": "; ".join(f"{n}={v}" for n, v in sorted(args.settings.items())),
           "variable": args.variable, "value": value, "max_strain": f"{args.max_strain:g}"}
    if verdict:
        row["outcome"], end, found = verdict
    else:
        row["outcome"] = "max strain" if end >= 0.99 * args.max_strain else "deck ended"
        try:
            found = evaluate(data, end, args.skip)
        except (steady.NotSteady, steady.TooShort) as problem:
            return {**row, "outcome": str(problem).replace(",", ";"), "strain": f"{end:.4g}"}
    row.update({"strain": f"{end:.4g}", "from": f"{found.pop('from'):.4g}"})
    renamed = {"gamma_dot": ("rate", 1.0), "phi_now": ("phi", 1.0), "sxy": ("stress", unit),
               "viscosity": ("viscosity", unit / fluid), **{name: (name, unit) for name in STRESSES}}
    for name, estimate in found.items():
        name, scale = renamed.get(name, (name, 1.0))
        row[name], row[name + "_error"] = f"{scale * estimate.mean:.6g}", f"{scale * estimate.error:.2g}"
    return row


# what the table holds

def same_case(row, args, value):
    settings = dict(word.split("=", 1) for word in row["settings"].split("; ") if word)
    return (row["deck"], row["variable"], float(row["value"]), settings) == \
        (args.deck.name, args.variable, float(value), args.settings)


def is_done(row, args):
    """Was the case run to this tolerance, or as far as allowed now?"""
    if row["outcome"] == "deck ended" or float(row["max_strain"]) >= args.max_strain and row["outcome"] != "tolerance":
        return True
    return bool(row["viscosity"]) and float(row["viscosity_error"]) <= args.tolerance * abs(float(row["viscosity"]))


def run_all(args):
    """Runs what the table lacks; number of runs that failed."""
    rows, lock, failed = flow_table.read_table(args.table), threading.Lock(), []
    todo = []
    for value in args.values:
        old = [row for row in rows if same_case(row, args, value)]
        if old and is_done(old[-1], args):
            print(f"{args.variable} {value}: in the table ({old[-1]['outcome']})", flush=True)
        else:
            todo.append(value)

    def work(value):
        try:
            row = run(args, value)
        except (Unusable, OSError, ValueError) as problem:
            failed.append(value)
            print(f"{args.variable} {value}: FAILED: {problem}", file=sys.stderr, flush=True)
            return
        with lock:
            rows[:] = [other for other in rows if not same_case(other, args, value)] + [row]
            flow_table.write_table(args.table, rows)
            numbers = f"{row.get('viscosity', '?')} +- {row.get('viscosity_error', '?')}"
            print(f"{args.variable} {value}: viscosity {numbers}, strain {row['strain']}, {row['outcome']}", flush=True)

    with ThreadPoolExecutor(args.jobs) as pool:
        try:
            list(pool.map(work, todo))
        except KeyboardInterrupt:
            pool.shutdown(cancel_futures=True)
            raise
    return len(failed)


# the command

def parse(words):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("deck")
    parser.add_argument("variable")
    parser.add_argument("values", nargs="+")
    parser.add_argument("--set", dest="settings", nargs="+", default=[], action="extend")
    parser.add_argument("--tolerance", type=float, default=0.05)
    parser.add_argument("--max-strain", type=float, default=50.0)
    parser.add_argument("--min-strain", type=float, default=2.0)
    parser.add_argument("--skip", type=float, default=0.0)
    parser.add_argument("-n", dest="ranks", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--wait", type=float, default=1.0, help="seconds between two looks at a run")
    parser.add_argument("--table", type=Path, default=Path("flow_curve.csv"))
    parser.add_argument("--draw", action="store_true")
    return parser.parse_args(words)


def check(args):
    """Unusable if a number makes no sense; finds the deck and its variables."""
    for value in args.values:
        try:
            float(value)
        except ValueError:
            raise Unusable(f"{args.variable} {value}: not a number") from None
    if len({float(value) for value in args.values}) < len(args.values):
        raise Unusable("a value occurs twice: " + " ".join(args.values))
    if not 0 < args.tolerance < 1:
        raise Unusable(f"--tolerance {args.tolerance:g}: a relative error between 0 and 1, for example 0.05")
    if not 0 < args.min_strain <= args.max_strain or not 0 <= args.skip < args.max_strain:
        raise Unusable(f"strains must fit: 0 < --min-strain ({args.min_strain:g}) <= --max-strain "
                       f"({args.max_strain:g}) > --skip ({args.skip:g}) >= 0")
    if args.ranks < 1 or args.jobs < 1:
        raise Unusable("-n and --jobs must be 1 or more")
    args.deck = find_deck(args.deck)
    args.known = index_variables(args.deck)
    args.settings = read_settings(args.settings, args.variable, args.known)
    args.table = args.table.with_suffix(".csv") if not args.table.suffix else args.table


def main(words=None):
    args = parse(words)
    try:
        check(args)
        failed = 0 if args.draw else run_all(args)
        rows = flow_table.read_table(args.table)
    except Unusable as problem:
        sys.exit(f"flow_curve.py: {problem}")
    if flow_table.series(rows):
        flow_table.draw(rows, args.table.with_suffix(".png"))
        print(f"wrote {args.table} and {args.table.with_suffix('.png')}")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
