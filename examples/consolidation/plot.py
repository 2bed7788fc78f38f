"""Settlement and pore pressure of the layer, from what in.consolidation writes, beside Terzaghi's theory."""
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))
import steady

MODES = (2 * np.arange(500)[:, None] + 1) * np.pi / 2


def settlement(time):
    """U over its last value, K. Terzaghi (1923): T = k E t/(eta H^2), fluid escapes at the top only."""
    return 1 - np.sum(2 / MODES**2 * np.exp(-MODES**2 * np.atleast_1d(time)), axis=0)


def pressure(y, time):
    """p over the load that was added, at the height y over H."""
    return np.sum(2 * np.sin(MODES) / MODES * np.cos(MODES * np.atleast_1d(y)) * np.exp(-MODES**2 * time), axis=0)


def permeability(phi, radius):
    """The law beetstra of fix pore/pressure."""
    return 2 * radius**2 / (9 * phi * (10 * phi / (1 - phi) ** 3 + (1 - phi) * (1 + 1.5 * np.sqrt(phi))))


def read_profiles():
    """Frames of profile.txt: step -> rows of y, p, phi, u, q."""
    frames, lines = {}, [line.split() for line in Path("profile.txt").read_text(encoding="ascii").splitlines() if line[0] != "#"]
    while lines:
        step, rows = map(int, lines[0])
        frames[step] = np.array(lines[1:rows + 1], dtype=float)[:, 1:]
        lines = lines[rows + 1:]
    return frames


def modulus(scene, time, settled):
    """Of the packing, E = load H/last settlement, and the time of drainage H^2/cv; the last settlement is a little more than seen."""
    whole = settled[-1]
    for _ in range(50):
        e = scene["more"] * scene["gap"] / whole
        tau = scene["viscosity"] * scene["gap"] ** 2 / (permeability(scene["phi"], scene["radius"]) * e)
        whole = settled[-1] / settlement(time[-1] / tau)[0]
    return e, tau, whole


def main():
    words = Path("scene.txt").read_text(encoding="ascii").split()
    scene = dict(zip(words[::2], map(float, words[1::2])))
    data = steady.read_ave_time("settled.txt")
    time, settled = data["v_now"], data["v_settled"]
    e, tau, whole = modulus(scene, time, settled)
    bottom = data["f_pores[1]"] / scene["more"]
    print(f"volume fraction {scene['phi']:.4f}, gap {scene['gap']:.2f}, permeability {permeability(scene['phi'], scene['radius']):.5f}")
    print(f"modulus {e:.0f}, settlement {whole:.4f}, time of drainage {tau:.1f}")
    for at in (0.1, 0.2, 0.5, 1.0):
        if at * tau > time[-1]:
            continue
        u, p = (np.interp(at * tau, time, values) for values in (settled / whole, bottom))
        print(f"T {at:4.1f}: settlement {u:.3f}, Terzaghi {settlement(at)[0]:.3f}; pressure {p:.3f}, Terzaghi {pressure(0, at)[0]:.3f}")
    late = time > 0.02 * tau
    print(f"largest difference: settlement {np.max(np.abs(settled / whole - settlement(time / tau))[late]):.3f}, "
          f"pressure {np.max(np.abs(bottom - np.array([pressure(0, t)[0] for t in time / tau]))[late]):.3f}")
    total = data["f_cell[7]"][late]
    print(f"total stress on the lower plate {total.mean():.4f} +- {total.std():.4f}, load {scene['load'] + scene['more']:g}")

    fig, axes = plt.subplots(1, 2, figsize=(10, 4.2))
    line = np.linspace(0, time[-1], 400)
    axes[0].plot(time, settled / whole, color="#b45f06", label="settlement, over the last")
    axes[0].plot(time, bottom, color="#1f4e79", label="pressure at the bottom, over the added load")
    axes[0].plot(line, settlement(line / tau), color="0.3", ls="--", lw=1, label="Terzaghi, modulus from the last settlement")
    axes[0].plot(line[1:], [pressure(0, t)[0] for t in line[1:] / tau], color="0.3", ls="--", lw=1)
    axes[0].set(xlabel="time", xlim=(0, time[-1]), ylim=(0, 1.15))
    axes[0].legend(fontsize=8, frameon=False, loc="center right")
    frames = read_profiles()
    heights = np.linspace(0, 1, 100)
    for at, color in ((0.05, "#0b2545"), (0.2, "#1f4e79"), (0.5, "#6fa8dc"), (1.0, "#b6d0ea")):
        step = min((s for s in frames if s > 0), key=lambda s, t=at * tau: abs(s * scene["dt"] - t))
        rows = frames[step]
        seen = step * scene["dt"] / tau
        axes[1].plot(rows[:, 1] / scene["more"], rows[:, 0] / scene["gap"], "o", ms=4, color=color, label=f"T = {seen:.2f}")
        axes[1].plot(pressure(heights, seen), heights, color=color, ls="--", lw=1)
    axes[1].set(xlabel="pressure over the added load", ylabel="y / H", xlim=(0, 1.15), ylim=(0, 1))
    axes[1].legend(fontsize=8, frameon=False, loc="upper right")
    fig.tight_layout()
    fig.savefig("figure.png", dpi=120)
    print("wrote figure.png")


if __name__ == "__main__":
    main()
