"""Complex viscosity against the amplitude of strain: one run each, a table and the figure.

usage: tools/python.sh study.py [--amplitude 0.02 ... 3] [--particles 500] [--path 10] [--jobs 2] [--draw]
Each takes 10 units of strain in all, or 30 cycles. Appends to study.csv and skips the amplitudes it already holds. Four
minutes on 2 cores.
"""
import argparse
import csv
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "scene"))
import plot
import rheology

TABLE = HERE / "study.csv"
PARTS = {"all": ["v_sxy"], "contact": ["v_contact_n", "v_contact_t"], "lubrication": ["v_film_n", "v_film_t"]}
FIELDS = ["amplitude", "N"] + [f"{part}_{what}" for part in PARTS for what in ("real", "real_error", "imag", "imag_error")]


def measure(amplitude, particles, path):
    path = min(float(path), 120 * float(amplitude))    # 30 cycles at most
    data = rheology.simulate(HERE / "in.oscillation", {"amplitude": amplitude, "N": particles, "path": path})
    cycle = np.arange(len(data["TimeStep"])) + 0.5
    data["time"] = cycle * 2 * np.pi / plot.PER_CYCLE    # w = 1
    data = plot.kept(data)
    row = {"amplitude": amplitude, "N": particles}
    for part, columns in PARTS.items():
        found = plot.viscosity(data, 1.0, columns)
        for what in ("real", "imag"):
            row[f"{part}_{what}"] = f"{found[what].mean:.4f}"
            row[f"{part}_{what}_error"] = f"{found[what].error:.4f}"
    return row


def draw(rows):
    rows = sorted(rows, key=lambda row: float(row["amplitude"]))
    amplitude = [float(row["amplitude"]) for row in rows]
    fig, axes = plt.subplots(1, 2, figsize=(10, 4.2), sharex=True)
    for ax, what in zip(axes, ("real", "imag")):
        for part, color in zip(PARTS, ("k", "#1f4e79", "#b45f06")):
            values, errors = (np.array([float(row[f"{part}_{name}"]) for row in rows]) for name in (what, what + "_error"))
            ax.errorbar(amplitude, values, errors, fmt="o-", ms=4, color=color, label=part)
        ax.axhline(0, color="0.7", lw=0.7, zorder=0)
        ax.set(xscale="log", xlabel=r"strain amplitude $\gamma_0$")
    axes[0].set(ylabel=r"$\eta'/\eta_f$", ylim=(0, None))
    axes[1].set(ylabel=r"$\eta''/\eta_f$")
    axes[0].legend(frameon=False)
    fig.tight_layout()
    fig.savefig(HERE / "study.png", dpi=140)
    print("wrote study.png")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--amplitude", nargs="+", default=["0.02", "0.05", "0.1", "0.2", "0.5", "1", "3"])
    parser.add_argument("--particles", default="500")
    parser.add_argument("--path", default="10")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--draw", action="store_true")
    args = parser.parse_args()
    rows = list(csv.DictReader(TABLE.open())) if TABLE.exists() else []
    if not args.draw:
        todo = [a for a in args.amplitude if a not in {row["amplitude"] for row in rows}]
        with ThreadPoolExecutor(args.jobs) as pool:
            for row in pool.map(lambda a: measure(a, args.particles, args.path), todo):
                rows.append(row)
                print(row, flush=True)
        with TABLE.open("w", newline="", encoding="ascii") as file:
            writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)
    draw(rows)


if __name__ == "__main__":
    main()
