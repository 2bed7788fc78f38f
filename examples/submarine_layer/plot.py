"""Layers on a slope under a fluid, from what in.submarine_layer writes (run.sh), beside a model of one dimension.

Runs in runs/ replace loose.txt, medium.txt, dense.txt, starts.csv and profiles.csv; figure.png and the numbers are drawn from these files.
"""
import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

sys.path[:0] = [str(Path(__file__).resolve().parents[2] / "tools"), str(Path(__file__).resolve().parent)]
import model
import steady

STARTS = ("loose", "medium", "dense")
COLORS = dict(zip(STARTS, ("#b45f06", "#6aa84f", "#1f4e79")))
SCENE = ("start", "depth", "weight", "slope", "viscosity", "radius", "modulus", "factor")
NAMES = ("v_now", "v_solid", "v_speed", "f_pores[1]")
AT = (5, 115)    # s, of the profiles
SPANS = ((0.5, 2), (2, 10), (20, 40), (50, 70), (100, 120))
STEADY = "medium"    # whose last quarter gives the model its steady flow


def read_frames(name):
    """Frames of a file of fix ave/time vectors or ave/chunk: step -> rows."""
    frames, lines = {}, [line.split() for line in Path(name).read_text(encoding="ascii").splitlines() if line[0] != "#"]
    while lines:
        step, rows = int(lines[0][0]), int(lines[0][1])
        frames[step] = np.array(lines[1:rows + 1], dtype=float)
        lines = lines[rows + 1:]
    return frames


def read_scene(name):
    words = Path(name).read_text(encoding="ascii").split()
    return dict(zip(words[::2], map(float, words[1::2])))


def read_csv(name, keys):
    """Rows of numbers by their first keys columns."""
    rows = {}
    if Path(name).exists():
        with open(name, encoding="ascii", newline="") as file:
            for row in list(csv.reader(file))[1:]:
                rows.setdefault(tuple(row[:keys]), []).append([float(v) for v in row[keys:]])
    return rows


def write_csv(name, header, rows):
    with open(name, "w", encoding="ascii", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows([*key, *(f"{v:.5g}" for v in row)] for key in sorted(rows) for row in rows[key])


def profile(path, at, dt):
    """y, velocity, pressure, volume fraction at the time at, means over the eight frames before it."""
    frames, speeds = read_frames(f"{path}.profile"), read_frames(f"{path}.speeds")
    steps = sorted(step for step in speeds if step * dt <= at)[-8:]
    v, p = (np.mean([table[step] for step in steps], axis=0) for table in (speeds, frames))
    v = v[(v[:, 2] > 5) & (v[:, 1] > 0)]
    return [[y, u, np.interp(y, p[:, 1], p[:, 2]), np.interp(y, p[:, 1], p[:, 3])] for y, u in v[:, [1, 3]]]


def collect():
    """Puts the runs into the tables: what each layer is, its columns, and profiles."""
    starts, profiles = read_csv("starts.csv", 1), read_csv("profiles.csv", 2)
    for start in STARTS:
        path = Path("runs") / f"{start}.out"
        if not path.exists():
            continue
        scene, data = read_scene(f"{path}.scene"), steady.read_ave_time(path)
        starts[start,] = [[scene[name] for name in SCENE]]
        rows = np.array([data[name] for name in NAMES]).T
        head = (f"A layer with the volume fraction {scene['start']:.4f} at the start, in.submarine_layer: means over "
                f"{data['v_now'][2] - data['v_now'][1]:.2g} s\ntime (s), volume fraction, velocity of the surface (m/s), excess pressure at the base (Pa)")
        np.savetxt(f"{start}.txt", rows, fmt=("%.3f", "%.5f", "%.4e", "%.4g"), header=head)
        for at in AT:
            if at <= data["v_now"][-1]:
                profiles[start, f"{at:g}"] = profile(path, at, scene["dt"])
    write_csv("starts.csv", ("layer", *SCENE), starts)
    write_csv("profiles.csv", ("layer", "time", "y", "velocity", "pressure", "phi"), profiles)
    return ({start: (dict(zip(SCENE, starts[start,][0])), np.loadtxt(f"{start}.txt").T) for start in STARTS if Path(f"{start}.txt").exists()},
            {key: np.array(rows).T for key, rows in profiles.items()})


def number(scene, speed):
    """Viscous number of a flow in which it is the same everywhere: speed = I W cos(slope) H/(2 eta)."""
    return 2 * scene["viscosity"] * speed / (scene["weight"] * np.cos(np.radians(scene["slope"])) * scene["depth"])


def last(run, part=0.25):
    late = run[0] > run[0][-1] * (1 - part)
    return [values[late].mean() for values in run[1:]]


def smooth(time, values, span=2.0):
    """Means over the time span, at its middle."""
    rows = max(1, round(span / (time[1] - time[0])))
    return tuple(np.convolve(column, np.ones(rows) / rows, "valid") for column in (time, values))


def numbers(name, run, wanted):
    """Means over spans of time, of run and model."""
    for low, high in SPANS:
        inside, there = ((rows[0] > low) & (rows[0] <= high) for rows in (run, wanted))
        if inside.any():
            pairs = " ".join(f"{run[n][inside].mean() * unit:9.{digits}f} {wanted[n][there].mean() * unit:9.{digits}f}"
                             for n, unit, digits in ((2, 1e3, 2), (3, 1, 1), (1, 1, 4)))
            print(f"{name:7s} {low:4g} to {high:4g} s {pairs}")


def main():
    runs, profiles = collect()
    scene, run = runs[STEADY if STEADY in runs else next(iter(runs))]
    flow = last(run)
    i = number(scene, flow[1])
    print(f"steady flow: I {i:.4g}, volume fraction {flow[0]:.4f}, surface {flow[1] * 1e3:.3f} mm/s, weight {scene['weight']:.2f} Pa")
    print(f"{'':20s} " + " ".join(f"{name:>9s} {'model':>9s}" for name in ("v, mm/s", "p, Pa", "phi")))
    fig, axes = plt.subplots(2, 2, figsize=(11, 7.5))
    for start, (scene, run) in runs.items():
        color = COLORS[start]
        layer = model.Layer(scene["start"], scene["depth"], scene["weight"], np.radians(scene["slope"]), scene["viscosity"], scene["radius"],
                            (i, flow[0]), modulus=scene["modulus"], factor=scene["factor"])
        wanted = layer.run(run[0][-1])
        numbers(start, run, wanted)
        for ax, n, unit in zip(axes.flat, (2, 3, 1), (1e3, 1, 1)):
            ax.plot(run[0], run[n] * unit, color=color, lw=0.5, alpha=0.4)
            ax.plot(*smooth(run[0], run[n] * unit), color=color, lw=1.4, label=f"{start}, {scene['start']:.3f}")
            ax.plot(wanted[0], wanted[n] * unit, color=color, lw=1, ls="--")
    for (start, at), rows in profiles.items():
        axes[1, 1].plot(rows[1] * 1e3, rows[0] * 1e3, color=COLORS[start], lw=1.2, ls=":" if at == f"{AT[0]:g}" else "-", label=f"{start}, {at} s")
    for ax, text in zip(axes.flat, ("velocity of the surface, mm/s", "excess pressure at the base, Pa", "volume fraction")):
        ax.set(xlabel="time, s", ylabel=text, xlim=(0, None))
    axes[0, 0].plot([], [], color="0.3", ls="--", lw=1, label="model.py")
    axes[0, 0].set_ylim(bottom=0)
    axes[0, 0].legend(fontsize=8, frameon=False)
    axes[0, 1].axhline(0, color="0.7", lw=0.8)
    axes[1, 1].set(xlabel="velocity, mm/s", ylabel="height, mm", xlim=(0, None), ylim=(0, None))
    if profiles:
        axes[1, 1].legend(fontsize=8, frameon=False)
    fig.tight_layout()
    fig.savefig("figure.png", dpi=110)
    print("wrote figure.png")


if __name__ == "__main__":
    main()
