"""Figure and numbers of the table of study.py; or, without a table, of one run of in.shear_thickening.

usage: tools/python.sh study.py --draw                  the table
       tools/python.sh plot.py [--from STRAIN]          stress.txt and contacts.txt in this folder
"""
import argparse
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "scene"))
import cases
import rheology

D2 = 4.0    # square of the mean diameter
DONG = 0.13    # k of J. Dong, thesis, Lund (2020), fig. 4.5, viscous discs
LINES = {"frictionless": ("#38761d", "v"), "fixed pressure": ("#b45f06", "o"), "fixed rate": ("#741b47", "D"),
         "fixed lower rate": ("#c27ba0", "s"), "frictional": ("#1f4e79", "^")}
COLORS = {"0.50": "#38761d", "0.54": "#b45f06", "0.55": "#741b47", "0.56": "#1f4e79"}


def column(rows, *names):
    return [np.nan_to_num(np.array(c)) for c in cases.columns(rows, *names)]


def reduced(rows):
    """f^ Z = F* Z/(P d^2) and chi_f with its error, of runs with both kinds of contacts."""
    rows = [row for row in rows if 0 < float(row["load"]) < 1e6]
    load, pressure, Z, chi, error = column(rows, "load", "mean_pressure", "mean_Z", "mean_chi_f", "mean_chi_f_error")
    return rows, load * Z / (pressure * D2), chi, error


def fitted(x, chi):
    """k of chi_f = 1 - tanh(k x) by least squares, and the root mean square of what it misses."""
    ks = np.linspace(0.05, 0.3, 2501)
    missed = np.array([np.sqrt(np.mean((1 - np.tanh(k * x) - chi) ** 2)) for k in ks])
    return ks[missed.argmin()], missed.min()


def pressure_lines(rows):
    """Runs under a pressure by line: name -> rows, in the order of Iv."""
    rows = sorted((row for row in rows if row["drive"] == "iv"), key=lambda row: float(row["Iv"]))
    return {"frictionless": [row for row in rows if float(row["load"]) > 1e6],
            "frictional": [row for row in rows if float(row["load"]) == 0],
            "fixed pressure": [row for row in rows if float(row["load"]) == 6],
            "fixed rate": [row for row in rows if abs(float(row["load"]) / float(row["Iv"]) - 600) < 1],
            "fixed lower rate": [row for row in rows if abs(float(row["load"]) / float(row["Iv"]) - 2000) < 1]}


def draw_chi(ax, rows):
    _, x, chi, error = reduced(rows)
    drives = np.array([row["drive"] for row in reduced(rows)[0]])
    steady = drives != "rate"
    k, missed = fitted(x[steady], chi[steady])
    for drive, marker in (("iv", "o"), ("stress", "s"), ("rate", "D")):
        here = drives == drive
        if here.any():
            label = {"iv": "pressure", "stress": "stress, volume", "rate": "rate, volume"}[drive] + " imposed"
            ax.errorbar(1 / x[here], chi[here], error[here], fmt=marker, ms=4, label=label)
    line = np.logspace(-1.7, 1.3, 100)
    ax.plot(line, 1 - np.tanh(DONG / line), "0.5", lw=1, ls="--", label=f"Dong 2020, discs, k = {DONG}")
    ax.plot(line, 1 - np.tanh(k / line), "k", lw=1, label=f"k = {k:.3f}")
    ax.set(xscale="log", xlabel=r"$1/(\hat f Z)$,  $\hat f = F^*/(P d^2)$", ylabel=r"$\chi_f$")
    print(f"chi_f = 1 - tanh(k f^ Z): k = {k:.3f}, misses by {missed:.3f} (rms of {steady.sum()} runs)")


def draw_pressure(axes, rows):
    for name, mine in pressure_lines(rows).items():
        if not mine:
            continue
        color, marker = LINES[name]
        iv, phi, phi_error, mu, mu_error = column(mine, "Iv", "mean_phi", "mean_phi_error", "mean_mu", "mean_mu_error")
        style = {"fmt": marker + "-", "color": color, "ms": 4, "lw": 0.8, "label": name}
        axes[0].errorbar(phi, mu / iv, mu_error / iv, phi_error, **style)
        axes[1].errorbar(1 / iv, phi, phi_error, **style)
        axes[2].errorbar(1 / iv, mu, mu_error, **style)
    axes[0].set(yscale="log", xlabel=r"$\phi$", ylabel=r"$\eta/\eta_f = \mu/I_v$")
    axes[1].set(xscale="log", xlabel=r"$P/(\eta_f\dot\gamma) = 1/I_v$", ylabel=r"$\phi$")
    axes[2].set(xscale="log", xlabel=r"$P/(\eta_f\dot\gamma) = 1/I_v$", ylabel=r"$\mu$", yscale="log")


def flow_curve(rows):
    """Rate and stress over those of F*: eta rate d^2/F*, stress d^2/F*, their errors; viscosity."""
    load, rate, rate_error, mu, mu_error = column(rows, "load", "mean_rate", "mean_rate_error", "mean_mu", "mean_mu_error")
    if rows[0]["drive"] == "stress":    # the stress is 1, the rate follows
        mu, mu_error = np.ones_like(rate), np.zeros_like(rate)
    return rate * D2 / load, rate_error * D2 / load, mu * D2 / load, mu_error * D2 / load, mu / rate


def draw_flow(axes, rows):
    for phi, color in COLORS.items():
        mine = sorted((r for r in rows if r["drive"] == "stress" and r["phi"] == phi), key=lambda r: -float(r["load"]))
        if mine:
            rate, error, stress, _, viscosity = flow_curve(mine)
            axes[0].errorbar(stress, viscosity, viscosity * error / rate, fmt="o-", ms=4, lw=0.8, color=color,
                             label=rf"$\phi$ = {phi}")
            axes[1].errorbar(rate, stress, xerr=error, fmt="o-", ms=4, lw=0.8, color=color, label=rf"stress, $\phi$ = {phi}")
            print(f"phi {phi}: viscosity from {viscosity.min():.1f} to {viscosity.max():.1f}, largest slope of "
                  f"ln viscosity over ln stress {np.max(np.diff(np.log(viscosity)) / np.diff(np.log(stress))):.2f}")
        for before, marker, word in (("1e9", "v", "frictionless"), ("0", "^", "frictional")):
            mine = sorted((r for r in rows if r["drive"] == "rate" and r["phi"] == phi and r["before"] == before),
                          key=lambda r: -float(r["load"]))
            if mine:
                rate, _, stress, error, _ = flow_curve(mine)
                axes[1].errorbar(rate, stress, error, fmt=marker, ms=6, mfc="none", color=color,
                                 label=rf"rate, $\phi$ = {phi}, from {word}")
    axes[0].set(xscale="log", yscale="log", xlabel=r"$\sigma d^2/F^*$", ylabel=r"$\eta/\eta_f$")
    axes[1].set(xscale="log", yscale="log", xlabel=r"$\eta_f\dot\gamma d^2/F^*$", ylabel=r"$\sigma d^2/F^*$")


def draw(rows, name):
    fig, axes = plt.subplots(2, 3, figsize=(14, 8.2))
    draw_chi(axes[0, 0], rows)
    draw_pressure([axes[0, 1], axes[0, 2], axes[1, 0]], rows)
    draw_flow([axes[1, 1], axes[1, 2]], rows)
    for ax in axes.flat:
        if ax.get_legend_handles_labels()[0]:
            ax.legend(frameon=False, fontsize=7.5, **({"loc": "lower right"} if ax is axes[1, 2] else {}))
    fig.tight_layout()
    fig.savefig(name, dpi=130)
    plt.close(fig)
    print(f"wrote {name}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--from", dest="start", type=float)
    args = parser.parse_args()
    data = rheology.read_run()
    start = args.start if args.start is not None else rheology.steady_from(data["v_gamma"], data["v_sxy"])
    print(f"steady part: strain {start:.2f} to {data['v_gamma'][-1]:.2f}")
    for name in ("v_gamma_dot", "v_phi_now", "v_sxy", "v_syy", "v_Z", "v_chi_f"):
        mean, error = rheology.estimate(data[name][data["v_gamma"] >= start])
        print(f"  {name[2:]:10s} {mean:9.4f} +- {error:.4f}")
    fig, axes = plt.subplots(3, 1, figsize=(7, 6), sharex=True)
    for ax, column_name, label in zip(axes, ("v_sxy", "v_gamma_dot", "v_chi_f"), ("stress", "rate", r"$\chi_f$")):
        ax.plot(data["v_gamma"], data[column_name], color="#1f4e79", lw=1)
        ax.set(ylabel=label)
    axes[-1].set(xlabel="strain")
    fig.tight_layout()
    fig.savefig("run.png", dpi=130)
    print("wrote run.png")


if __name__ == "__main__":
    main()
