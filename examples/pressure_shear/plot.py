"""Volume fraction, friction and their parts with error bars, and the figures, from in.pressure_shear.

usage: tools/python.sh plot.py [--from STRAIN]    steady part of the run; default: found
"""
import argparse
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "scene"))
import rheology
from rheology import steady

ROWS = ["v_sxy", "v_contact_n", "v_contact_t", "v_film_n", "v_film_t", "v_inertia", "v_sxx", "v_syy", "v_szz", "v_phi_now"]


def draw(axes, data, start, iv):
    strain = data["v_gamma"]
    phi, friction = (rheology.estimate(data[name][strain >= start]) for name in ("v_phi_now", "v_sxy"))
    rheology.stack_parts(axes[0], strain, data)
    axes[0].plot([start, strain[-1]], [friction[0]] * 2, "k--", lw=1)
    axes[0].set(ylabel=r"$\sigma_{xy}/P$", ylim=(0, 1.45 * data["v_sxy"][3:].max()), xlim=(0, strain[-1]))
    axes[0].set_title(rf"$I_v$ = {iv:g}: $\mu$ = {friction[0]:.3f} $\pm$ {friction[1]:.3f}, "
                      rf"$\phi$ = {phi[0]:.4f} $\pm$ {phi[1]:.4f}", fontsize=10)
    rheology.legend(axes[0], ncol=3, loc="upper right")
    axes[1].plot(strain, data["v_phi_now"], color="#38761d", label="cell")
    axes[1].plot([start, strain[-1]], [phi[0]] * 2, "k--", lw=1, label="mean")
    axes[1].axhline(rheology.phi_boyer(iv), color="0.5", ls=":", label="Boyer 2011")
    axes[1].axhline(rheology.phi_chevremont(iv, 0.5), color="0.5", ls="-.", label="Chevremont 2019")
    axes[1].legend(frameon=False, fontsize=8, ncol=4)
    axes[1].set(xlabel="strain", ylabel=r"$\phi$", xlim=(0, strain[-1]))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--from", dest="start", type=float, default=None)
    args = parser.parse_args()
    data = steady.read_ave_time("stress.txt")
    iv = float(Path("scene.txt").read_text(encoding="ascii").split()[1])
    strain = data["v_gamma"]
    start = args.start
    if start is None:
        start = rheology.steady_from(strain, data["v_phi_now"], data["v_sxy"])

    print(f"steady part: strain {start:.2f} to {strain[-1]:.2f}; Iv = {iv:g}, stresses over the pressure")
    for name in ROWS:
        mean, error = rheology.estimate(data[name][strain >= start])
        print(f"  {name[2:]:12s} {mean:9.4f} +- {error:.4f}")
    print(f"  Boyer 2011: phi {rheology.phi_boyer(iv):.4f}, mu {rheology.mu_boyer(iv):.3f}; Chevremont 2019 at friction 0.5: "
          f"phi {rheology.phi_chevremont(iv, 0.5):.4f}, mu {rheology.mu_chevremont(iv, 0.5):.3f}")

    fig, axes = plt.subplots(2, 1, figsize=(7.5, 6), height_ratios=[1.6, 1], sharex=True)
    draw(axes, data, start, iv)
    fig.tight_layout()
    fig.savefig("figure.png", dpi=150)
    print("wrote figure.png")
    if rheology.image() is not None:
        print("wrote particles.png")


if __name__ == "__main__":
    main()
