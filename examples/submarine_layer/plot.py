"""Layers on a slope under a fluid, from what in.submarine_layer writes (run.sh), beside a model of one dimension.

Runs in runs/ replace loose.txt, medium.txt, dense.txt and profiles.csv; figure.png and the numbers are drawn from these files.
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
NAMES = ("v_now", "v_solid", "v_speed", "f_pores[1]")
AT = (5, 110)    # s, of the profiles


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


def collect():
    """Puts the runs into the tables; the scene, the columns of each start, and profiles."""
    profiles = {}
    if Path("profiles.csv").exists():
        with open("profiles.csv", encoding="ascii", newline="") as file:
            for row in list(csv.reader(file))[1:]:
                profiles.setdefault((row[0], float(row[1])), []).append([float(v) for v in row[2:]])
    scene = read_scene("scene.txt") if Path("scene.txt").exists() else {}
    for start in STARTS:
        path = Path("runs") / f"{start}.out"
        if not path.exists():
            continue
        this, data = read_scene(f"{path}.scene"), steady.read_ave_time(path)
        scene.update({name: this[name] for name in ("weight", "slope", "viscosity", "radius", "modulus")})
        scene.update({f"{name}_{start}": this[name] for name in ("start", "depth")})
        rows = np.array([data[name] for name in NAMES]).T
        head = (f"A layer with the volume fraction {this['start']:.4f} at the start: fix ave/time of in.submarine_layer, means over the last "
                f"{data['v_now'][2] - data['v_now'][1]:.2g} s\ntime (s), volume fraction, velocity of the surface (m/s), excess pressure at the base (Pa)")
        np.savetxt(f"{start}.txt", rows, fmt=("%.3f", "%.5f", "%.4e", "%.4g"), header=head)
        frames, speeds = read_frames(f"{path}.profile"), read_frames(f"{path}.speeds")
        for at in AT:
            if at > data["v_now"][-1]:
                continue
            step = min(frames, key=lambda s, at=at, dt=this["dt"]: abs(s * dt - at))
            steps = sorted(speeds)[max(0, sorted(speeds).index(step) - 7):sorted(speeds).index(step) + 1]
            v = np.mean([speeds[s] for s in steps], axis=0)
            v = v[(v[:, 2] > 5) & (v[:, 1] > 0)]
            p = np.mean([frames[s] for s in steps], axis=0)
            profiles[start, at] = [[y, u, np.interp(y, p[:, 1], p[:, 2]), np.interp(y, p[:, 1], p[:, 3])] for y, u in v[:, [1, 3]]]
    with open("profiles.csv", "w", encoding="ascii", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(("start", "time", "y", "velocity", "pressure", "phi"))
        writer.writerows([*key, *(f"{v:.5g}" for v in row)] for key in sorted(profiles) for row in profiles[key])
    Path("scene.txt").write_text("".join(f"{name} {value:.6g}\n" for name, value in sorted(scene.items())), encoding="ascii")
    runs = {start: np.loadtxt(f"{start}.txt").T for start in STARTS if Path(f"{start}.txt").exists()}
    return scene, runs, {key: np.array(rows).T for key, rows in profiles.items()}


def number(scene, speed, height):
    """Viscous number of a flow in which it is the same everywhere: speed = I W cos(slope) H/(2 eta)."""
    return 2 * scene["viscosity"] * speed / (scene["weight"] * np.cos(np.radians(scene["slope"])) * height)


def last(run, part=0.25):
    late = run[0] > run[0][-1] * (1 - part)
    return [values[late].mean() for values in run[1:]]


def when(time, values, wanted):
    """First time at which values reach wanted, on means over five rows."""
    smooth = np.convolve(values, np.ones(5) / 5, "same")
    over = smooth[2:-2] > wanted
    return time[2:-2][np.argmax(over)] if over.any() else np.inf


def numbers(name, run, top):
    early = run[0] < 10
    extreme = np.argmax(np.abs(run[3][early]))
    middle = [np.interp(5, run[0], np.convolve(run[n], np.ones(5) / 5, "same")) for n in (2, 3)]
    print(f"{name:14s} {run[1][0]:.4f} {run[3][early][extreme]:9.2f} {middle[0] * 1e3:9.3f} {middle[1]:8.2f} {when(run[0], run[2], top / 2):8.1f} "
          "{0:8.4f} {1:9.3f} {2:8.2f}".format(*(np.array(last(run)) * (1, 1e3, 1))))


def main():
    scene, runs, profiles = collect()
    flow = last(runs["medium" if "medium" in runs else next(iter(runs))])
    height = scene["depth_medium" if "medium" in runs else "depth_" + next(iter(runs))]
    i = number(scene, flow[1], height)
    print(f"steady flow: I {i:.4g}, volume fraction {flow[0]:.4f}, surface {flow[1] * 1e3:.3f} mm/s, weight {scene['weight']:.2f} Pa")
    print(f"{'':14s} {'phi':>6s} {'largest p':>9s} {'v(5 s)':>9s} {'p(5 s)':>8s} {'half v':>8s} {'last phi':>8s} {'v, mm/s':>9s} {'p, Pa':>8s}")
    fig, axes = plt.subplots(2, 2, figsize=(11, 7.5))
    for start, run in runs.items():
        color, phi = COLORS[start], scene[f"start_{start}"]
        layer = model.Layer(phi, scene[f"depth_{start}"], scene["weight"], np.radians(scene["slope"]), scene["viscosity"], scene["radius"],
                            (i, flow[0]), modulus=scene["modulus"])
        wanted = layer.run(run[0][-1])
        numbers(start, run, flow[1])
        numbers("  model", wanted, flow[1])
        for ax, n, unit in zip(axes.flat, (2, 3, 1), (1e3, 1, 1)):
            ax.plot(run[0], run[n] * unit, color=color, lw=1.2, label=f"{start}, {phi:.3f}")
            ax.plot(wanted[0], wanted[n] * unit, color=color, lw=1, ls="--")
    for (start, at), rows in profiles.items():
        axes[1, 1].plot(rows[1] * 1e3, rows[0] * 1e3, color=COLORS[start], lw=1.2, ls=":" if at == AT[0] else "-",
                        label=f"{start}, {at:g} s")
    for ax, text in zip(axes.flat, ("velocity of the surface, mm/s", "excess pressure at the base, Pa", "volume fraction")):
        ax.set(xlabel="time, s", ylabel=text, xlim=(0, None))
    axes[0, 0].plot([], [], color="0.3", ls="--", lw=1, label="model.py")
    axes[0, 0].set_ylim(bottom=0)
    axes[0, 0].legend(fontsize=8, frameon=False)
    axes[0, 1].axhline(0, color="0.7", lw=0.8)
    axes[1, 1].set(xlabel="velocity, mm/s", ylabel="height, mm", xlim=(0, None), ylim=(0, None))
    axes[1, 1].legend(fontsize=8, frameon=False)
    fig.tight_layout()
    fig.savefig("figure.png", dpi=110)
    print("wrote figure.png")


if __name__ == "__main__":
    main()
