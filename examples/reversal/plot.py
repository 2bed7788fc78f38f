"""Parts of the shear stress before and after a reversal, from in.reversal.

usage: tools/python.sh plot.py
"""
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "scene"))
import rheology
from rheology import steady


def minimum_and_recovery(strain, viscosity, steady_value):
    """Smallest viscosity after the reversal, the strain since then, and that of the recovery to 90 %."""
    lowest = int(np.argmin(viscosity))
    recovered = np.flatnonzero((viscosity >= 0.9 * steady_value) & (np.arange(len(viscosity)) > lowest))
    return viscosity[lowest], strain[lowest], strain[recovered[0]] if len(recovered) else np.nan


def main():
    data = steady.read_ave_time("stress.txt")
    turned = int(np.argmax(data["v_gamma_dot"] < 0))    # the line in which the direction changes may hold both
    sign = np.sign(data["v_gamma_dot"])
    path = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(data["v_gamma"])))]) + data["v_gamma"][0]
    turn = data["v_gamma"].max()
    viscosity = sign * data["v_sxy"]

    before = slice(turned // 4, turned - 1)
    old, error = rheology.estimate(viscosity[before])
    low, low_strain, recovery = minimum_and_recovery(path[turned:] - turn, viscosity[turned:], old)
    contact = sign * (data["v_contact_n"] + data["v_contact_t"])
    print(f"relative viscosity before the reversal {old:.1f} +- {error:.1f}, of which contacts "
          f"{contact[before].mean():.1f}")
    print(f"smallest after it {low:.1f} at a strain of {low_strain:.2f}; 90 % again at {recovery:.2f}")
    first = path[turned:] - turn
    early = (first > 0.02) & (first < 0.1)
    print(f"between strains 0.02 and 0.1 after it: viscosity {viscosity[turned:][early].mean():.1f}, contacts "
          f"{contact[turned:][early].mean():.1f}, normal stress syy {data['v_syy'][turned:][early].mean():.1f} "
          f"(before: {data['v_syy'][before].mean():.1f})")

    fig, axes = plt.subplots(1, 2, figsize=(11, 4.2), width_ratios=[1.6, 1])
    for ax in axes:
        rheology.stack_parts(ax, path - turn, {name: sign * values for name, values in data.items()})
        ax.plot(path - turn, viscosity, "k", lw=0.8)
        ax.axvline(0, color="k", ls=":", lw=1)
        ax.set(xlabel="strain since the reversal", ylim=(0, 1.35 * viscosity.max()))
    axes[0].set(ylabel=r"$|\sigma_{xy}|/(\eta_f\dot\gamma)$", xlim=(path[0] - turn, path[-1] - turn))
    axes[1].set(xlim=(-0.1, 1.0))
    rheology.legend(axes[0], ncol=2, loc="upper left")
    fig.tight_layout()
    fig.savefig("figure.png", dpi=150)
    print("wrote figure.png")


if __name__ == "__main__":
    main()
