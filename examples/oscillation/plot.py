"""Complex viscosity and the loop of stress against rate, from stress.txt of in.oscillation.

usage: tools/python.sh plot.py [--skip CYCLES]    cycles left out, default: the first third
"""
import argparse
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "scene"))
import rheology
from rheology import steady

PER_CYCLE = 80


def read(folder="."):
    """Columns of stress.txt, with time, and scene.txt as a dict of numbers."""
    words = (Path(folder) / "scene.txt").read_text(encoding="ascii").split()
    scene = dict(zip(words[::2], map(float, words[1::2])))
    data = steady.read_ave_time(Path(folder) / "stress.txt")
    data["time"] = data["TimeStep"] * scene["dt"]
    return data, scene


def kept(data, skip=None):
    cycles = len(data["time"]) // PER_CYCLE
    first = (cycles // 3 if skip is None else skip) * PER_CYCLE
    return {name: column[first:] for name, column in data.items()}


def viscosity(data, omega, columns=("v_sxy",)):
    """Complex viscosity of the sum of columns."""
    return steady.complex_viscosity(data["time"], data["v_gamma_dot"], sum(data[name] for name in columns), omega)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--skip", type=int, default=None)
    args = parser.parse_args()
    data, scene = read()
    data = kept(data, args.skip)
    omega, amplitude = scene["w"], scene["amplitude"]
    print(f"strain amplitude {amplitude:g}; over the viscosity of the fluid")
    for name, columns in [("all", ["v_sxy"]), ("contact", ["v_contact_n", "v_contact_t"]),
                          ("lubrication", ["v_film_n", "v_film_t"])]:
        found = viscosity(data, omega, columns)
        print(f"  {name:12s}" + "".join(f"  {part} {found[part].mean:8.3f} +- {found[part].error:.3f}"
                                        for part in ("real", "imag", "third")))
    weighted = steady.weighted_mean(-data["v_syy"], data["v_gamma_dot"], PER_CYCLE)
    print(f"  rate-weighted particle pressure -syy {weighted.mean:.2f} +- {weighted.error:.2f}")
    mu = steady.friction(data["v_gamma_dot"], data["v_sxy"], -data["v_syy"], PER_CYCLE)
    print(f"  friction <|rate| sxy sign(rate)>/<|rate| (-syy)> {mu.mean:.3f} +- {mu.error:.3f}")

    cycle = np.arange(len(data["time"])) % PER_CYCLE
    mean = {name: np.array([column[cycle == n].mean() for n in range(PER_CYCLE)]) for name, column in data.items()}
    closed = np.append(np.arange(PER_CYCLE), 0)
    fig, axes = plt.subplots(1, 2, figsize=(10, 4.2))
    middle = 0.5 * (data["v_gamma"].max() + data["v_gamma"].min())
    for ax, name, scale, label in [(axes[0], "v_gamma_dot", amplitude * omega, r"$\dot\gamma/\dot\gamma_0$"),
                                   (axes[1], "v_gamma", amplitude, r"$\gamma/\gamma_0$")]:
        x = (mean[name] - (middle if name == "v_gamma" else 0)) / scale
        for columns, color, text in [(["v_sxy"], "k", "total"), (["v_contact_n", "v_contact_t"], "#1f4e79", "contact"),
                                     (["v_film_n", "v_film_t"], "#b45f06", "lubrication")]:
            y = sum(mean[column] for column in columns) / (amplitude * omega)
            ax.plot(x[closed], y[closed], color=color, label=text)
        ax.set(xlabel=label)
        ax.axhline(0, color="0.7", lw=0.7, zorder=0)
    axes[0].set(ylabel=r"$\sigma_{xy}/(\eta_f\dot\gamma_0)$")
    axes[0].legend(frameon=False, fontsize=8)
    fig.suptitle(rf"strain amplitude {amplitude:g}, mean over cycles", fontsize=10)
    fig.tight_layout()
    fig.savefig("figure.png", dpi=150)
    print("wrote figure.png")


if __name__ == "__main__":
    main()
