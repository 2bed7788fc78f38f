"""What a step costs: pair style lubcontact, effect by effect, against LAMMPS' own styles.

usage: tools/python.sh benchmarks/run.py [--quick] [--ranks N] [--instructions] [-o results.json]

Every variant of in.speed runs once, then all of them again, and so on: what else the machine does
spreads over all of them. Times are CPU times; the best repetition counts. Writes run.csv and
figure.png, with --quick to the build folder. See README.md.
"""

import argparse
import csv
import json
import os
import platform
import re
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
TOP = HERE.parent

LUBCONTACT = ["all", "no_squeeze", "no_shear", "no_roll", "no_twist", "no_friction",
              "squeeze_friction", "squeeze", "contact_friction", "contact"]
LAMMPS = ["gran", "overlay"]
LABEL = {"all": "all effects", "no_squeeze": "without squeeze", "no_shear": "without shear",
         "no_roll": "without roll", "no_twist": "without twist", "no_friction": "without friction",
         "squeeze_friction": "contact, squeeze, friction", "squeeze": "contact, squeeze",
         "contact_friction": "contact, friction", "contact": "contact",
         "gran": "gran/hooke/history", "overlay": "gran/hooke/history + lubricate"}
NUM_PAIRS = 4096    # of kernel.cpp
USUAL_STEP = 2e-4   # which users take; the overlay is not stable there, so that the table is made at a tenth of it
SECTIONS = ["Pair", "Neigh", "Comm", "Modify", "Output", "Other"]
# run.csv: million particle-steps/s (speed) and ns a particle-step (step), ns a pair and so on, as the columns of the table
DIGITS = {"speed": ".2f", "speed_usual": ".2f", "step": ".0f", "step_median": ".0f", "pairs": ".2f", "pair": ".0f",
          "pair_median": ".0f", "pair_over_gran": ".2f", "speed_over_gran": ".2f", "speed_over_overlay": ".2f",
          "bytes": ".0f", "history": "d", "kernel": ".0f", "instructions": ".0f"}


def build_folder():
    version = os.environ.get("SUSPENSION_LAMMPS", "4Feb2025")
    if os.environ.get("LAMMPS_EXECUTABLE"):
        version = "own"
    return TOP / ("build" if version == "4Feb2025" else f"build-{version}")


def lammps(ranks, *arguments):
    command = [TOP / "tools/lmp.sh", "-n", str(ranks), "-log", "none", *arguments]
    run = subprocess.run([str(word) for word in command], cwd=HERE, capture_output=True, text=True)
    if run.returncode:
        sys.exit(f"{' '.join(map(str, command))}\n{run.stdout[-2000:]}{run.stderr}")
    return run.stdout


def read_sections(measured, ranks):
    """CPU nanoseconds per step by section, of all ranks, from LAMMPS' own table of one run."""
    steps, particles = re.search(r"Loop time of .* for (\d+) steps with (\d+) atoms", measured).groups()
    to_ns = float(re.search(r"([\d.]+)% CPU use", measured)[1]) / 100 * ranks / int(steps) * 1e9
    result = {"particles": int(particles)}
    for section in SECTIONS:
        row = re.search(rf"^{section} *\|([^|]*)\| *([\d.e+-]+)", measured, re.MULTILINE)
        result[section] = float(row[2]) * to_ns
    return result


def make_state(build, particles, ranks=1, strain=1):
    """The sheared state of in.state, made once."""
    state = build / f"benchmark_state_{particles}.data"
    if not state.exists():
        print("making the state", file=sys.stderr)
        lammps(ranks, "-in", "in.state", "-var", "state", state, "-var", "N", particles, "-var", "strain", strain)
    return state


def read_speed(text, ranks):
    """One run of in.speed: CPU nanoseconds per step by section and memory, of all ranks; pairs in range."""
    setup, measured = text.split("measured from here")[-2:]
    measured, after = measured.split("measured to here")[:2]
    result = read_sections(measured, ranks)
    result["step"] = sum(result[section] for section in SECTIONS)
    result["pairs"] = statistics.mean(float(pairs) for pairs in
                                      re.findall(r"^pairs in range (\d+)", setup + after, re.MULTILINE))
    result["megabytes"] = ranks * float(re.search(r"allocation \(min/avg/max\) = \S+ \| (\S+)", setup)[1])
    history = re.search(r"(\d+) history values per pair", setup)
    result["history"] = 8 * int(history[1]) if history else 8 * 3    # gran/hooke/history
    return result


def measure_lammps(state, ranks, steps, repetitions):
    """All runs of each variant: at the small step of the overlay, and at the usual one."""
    runs = {name: [] for name in LUBCONTACT + LAMMPS}
    usual = {name: [] for name in LUBCONTACT + ["gran"]}
    for n in range(repetitions):
        for name in runs:
            if sys.stderr.isatty():
                print(f"\r{n + 1}/{repetitions} {LABEL[name]:40}", end="", file=sys.stderr, flush=True)
            words = ["-in", "in.speed", "-var", "state", state, "-var", "style", name, "-var", "steps", steps]
            runs[name].append(read_speed(lammps(ranks, *words), ranks))
            if name in usual:
                flow = "deform" if name == "gran" else "rheometer"
                text = lammps(ranks, *words, "-var", "dt", USUAL_STEP, "-var", "flow", flow)
                usual[name].append(read_speed(text, ranks))
    return runs, usual


def build_kernel(build):
    """The micro-benchmark, or None where Google Benchmark is not installed."""
    made = subprocess.run(["cmake", "--build", build, "--target", "kernel_benchmark"],
                          capture_output=True, text=True)
    program = build / "benchmarks/kernel_benchmark"
    if made.returncode or not program.exists():
        print("no kernel_benchmark: run tools/setup.sh --tests first; it needs Google Benchmark", file=sys.stderr)
        return None
    return program


def measure_kernel(program, repetitions):
    """CPU nanoseconds per pair: list of all repetitions."""
    run = subprocess.run([program, f"--benchmark_repetitions={repetitions}", "--benchmark_min_time=0.1",
                          "--benchmark_enable_random_interleaving=true", "--benchmark_format=json"],
                         capture_output=True, text=True, check=True)
    times = {}
    for row in json.loads(run.stdout)["benchmarks"]:
        if row["run_type"] == "iteration":
            times.setdefault(row["run_name"].split("/")[0], []).append(1e9 * row["pair"])
    return times


def count_instructions(program):
    """Instructions per pair and step, by callgrind: repeatable to the last digit."""
    counts = {}
    for name in LUBCONTACT:
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "callgrind.out"
            subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", program,
                            "--benchmark_min_time=0.05", f"--benchmark_filter=^{name}$"],
                           capture_output=True, check=True)
            text = out.read_text()
        function = re.search(r"fn=(\(\d+\)) .*one_step", text)[1]
        calls = re.findall(rf"^cfn={re.escape(function)}.*\ncalls=(\d+) .*\n\S+ (\d+)", text, re.MULTILINE)
        counts[name] = sum(int(cost) for _, cost in calls) / sum(int(n) for n, _ in calls) / NUM_PAIRS
    return counts


def describe(build):
    """Machine, compiler and versions."""
    cpu = platform.processor()
    if Path("/proc/cpuinfo").exists():
        cpu = re.search(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text())[1]
    cache = dict(re.findall(r"^(\w+):\w+=(.*)$", (build / "CMakeCache.txt").read_text(), re.MULTILINE))
    release = cache.get(f"CMAKE_CXX_FLAGS_{cache['CMAKE_BUILD_TYPE'].upper()}", "")
    native = " -march=native" if cache.get("SUSPENSION_NATIVE") == "ON" else ""
    compiler = subprocess.run([cache["CMAKE_CXX_COMPILER"], "--version"], capture_output=True,
                              text=True).stdout.splitlines()[0]
    flags = f"{cache.get('CMAKE_CXX_FLAGS', '')} {release}{native}".strip()
    version = re.search(r"Simulator - (.*)", lammps(1, "-help"))[1]
    return {"machine": f"{cpu}, {os.cpu_count()} cores, {platform.system()} {platform.machine()}",
            "compiler": f"{compiler}, {flags}", "LAMMPS": version}


def summarize(runs, usual, kernel, instructions):
    rows = []
    for name, all_runs in runs.items():
        particles = all_runs[0]["particles"]
        pairs = statistics.mean(run["pairs"] for run in all_runs)
        steps = [run["step"] / particles for run in all_runs]
        best = min(all_runs, key=lambda run: run["step"])
        steps_usual = [run["step"] / particles for run in usual.get(name, [])]
        rows.append({"name": name, "step": min(steps), "step_median": statistics.median(steps),
                     "step_usual": min(steps_usual) if steps_usual else None,
                     "pair": min(run["Pair"] for run in all_runs) / pairs,
                     "pair_median": statistics.median(run["Pair"] for run in all_runs) / pairs,
                     "pairs": pairs / particles, "sections": {s: best[s] / particles for s in SECTIONS},
                     "bytes": best["megabytes"] * 2**20 / particles, "history": best["history"],
                     "kernel": min(kernel[name]) if name in kernel else None,
                     "kernel_median": statistics.median(kernel[name]) if name in kernel else None,
                     "instructions": instructions.get(name)})
    by_name = {row["name"]: row for row in rows}
    for row in rows:
        row["pair_over_gran"] = row["pair"] / by_name["gran"]["pair"]
        row["speed_over_gran"] = by_name["gran"]["step"] / row["step"]
        row["speed_over_overlay"] = by_name["overlay"]["step"] / row["step"]
        row["speed"] = 1e3 / row["step"]
        row["speed_usual"] = 1e3 / row["step_usual"] if row["step_usual"] else None
    return rows


def write_table(rows, name):
    with open(name, "w", newline="", encoding="ascii") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["name", *DIGITS])
        for row in rows:
            writer.writerow([row["name"], *("" if row[key] is None else format(row[key], form) for key, form in DIGITS.items())])


def table(rows):
    def optional(value, form):
        return "" if value is None else format(value, form)

    lines = ["| variant | million particle-steps/s per core | at the usual step | ns per particle-step, best (median) "
             "| pairs in range per particle | ns per pair, best (median) | pair cost / gran "
             "| speed / gran | speed / overlay | bytes per particle | history bytes per pair "
             "| kernel, ns per pair | instructions |", "|---" + "|---:" * 12 + "|"]
    for row in rows:
        lines.append(f"| {LABEL[row['name']]} | {row['speed']:.2f} | {optional(row['speed_usual'], '.2f')} "
                     f"| {row['step']:.0f} ({row['step_median']:.0f}) | {row['pairs']:.2f} "
                     f"| {row['pair']:.0f} ({row['pair_median']:.0f}) | {row['pair_over_gran']:.2f} "
                     f"| {row['speed_over_gran']:.2f} | {row['speed_over_overlay']:.2f} "
                     f"| {row['bytes']:.0f} | {row['history']} "
                     f"| {optional(row['kernel'], '.0f')} | {optional(row['instructions'], '.0f')} |")
    return "\n".join(lines)


def draw(rows, file):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(8, 4.5), layout="constrained")
    left = [0.0] * len(rows)
    for sections, label, color in [(["Pair"], "pair forces", "#3465a4"),
                                   (["Neigh"], "neighbor list", "#f57900"),
                                   (["Comm", "Modify", "Output", "Other"], "everything else", "#babdb6")]:
        width = [sum(row["sections"][s] for s in sections) for row in rows]
        axes.barh([LABEL[row["name"]] for row in rows], width, left=left, label=label, color=color)
        left = [a + b for a, b in zip(left, width)]
    for n, row in enumerate(rows):
        axes.text(left[n], n, f" {row['step']:.0f}", va="center")
    axes.axhline(len(LUBCONTACT) - 0.5, color="black", linewidth=0.8)
    axes.invert_yaxis()
    axes.set_xlim(0, 1.1 * max(left))
    axes.set_xlabel("CPU time per particle and step (ns)")
    axes.legend(frameon=False, loc="upper right")
    axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(file, dpi=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="small, for a look: 1000 particles, twice")
    parser.add_argument("--ranks", type=int, default=1, help="MPI ranks (1)")
    parser.add_argument("--repetitions", type=int, help="of every variant (7)")
    parser.add_argument("--instructions", action="store_true", help="count them, too, with valgrind")
    parser.add_argument("--figure", help="where it goes (benchmarks/figure.png; with --quick the build folder)")
    parser.add_argument("-o", "--output", help="file for all results, JSON")
    args = parser.parse_args()
    repetitions = args.repetitions or (2 if args.quick else 7)
    particles, strain, steps = (1000, 0.3, 300) if args.quick else (4000, 1, 1000)

    build = build_folder()
    about = describe(build)
    for key, value in about.items():
        print(f"{key}: {value}")
    state = make_state(build, particles, args.ranks, strain)
    program = build_kernel(build)
    kernel = measure_kernel(program, repetitions) if program else {}
    instructions = count_instructions(program) if program and args.instructions else {}
    runs, usual = measure_lammps(state, args.ranks, steps, repetitions)
    rows = summarize(runs, usual, kernel, instructions)

    print(f"{particles} particles, {steps} steps, {repetitions} repetitions, {args.ranks} rank(s)\n")
    print(table(rows))
    folder = build if args.quick else HERE
    write_table(rows, folder / "run.csv")
    draw(rows, args.figure or folder / "figure.png")
    if args.output:
        results = {"about": about, "rows": rows, "runs": runs, "usual": usual, "kernel": kernel}
        Path(args.output).write_text(json.dumps(results, indent=1))


if __name__ == "__main__":
    main()
