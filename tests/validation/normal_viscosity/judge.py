"""Writes results.csv and parts.csv from runs.csv: means over seeds; prints the tables of README.md and draws results.png and parts.png.

usage: tools/python.sh judge.py [--check]
  --check  fail if lambda_33 is off its line by more than 0.05 and twice its error, for volume fractions of 0.35 to 0.61
"""
import argparse
import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[2] / "examples" / "scene"))
import cases    # noqa: E402  pylint: disable=wrong-import-position
import rheology    # noqa: E402  pylint: disable=wrong-import-position
import normal_viscosity    # noqa: E402  pylint: disable=wrong-import-position
from study import COMPONENTS, ORIGINS, QUANTITIES    # noqa: E402  pylint: disable=wrong-import-position

# W. Chevremont, thesis, Grenoble (2020), table 3.1: total and the parts in the order of ORIGINS; + is tension
SIGNS = {"xx": "-----", "yy": "---++", "zz": "--+++"}
ETA = ("eta_11", "eta_22", "eta_33")
TARGET, LOW, HIGH = 0.05, 0.35, 0.61    # lambda_33 against its line
COLORS = {0.0: "k", 0.1: "#38761d", 0.3: "#b45f06", 0.5: "#1f4e79", 1.0: "#c00000"}


def merged(rows):
    """(friction, phi) -> quantity -> mean and error over the seeds."""
    groups = {}
    for row in rows:
        groups.setdefault((float(row["friction"]), float(row["phi"])), []).append(row)
    found = {}
    for key, seeds in sorted(groups.items()):
        found[key] = {}
        for name in QUANTITIES:
            values, errors = (np.array(column) for column in cases.columns(seeds, name, name + "_error"))
            errors = errors[np.isfinite(errors)]
            error = np.sqrt(np.mean(errors**2) / len(values)) if len(errors) else np.nan
            if len(values) > 1:
                error = np.nanmax([error, np.std(values, ddof=1) / np.sqrt(len(values))])
            found[key][name] = (values.mean(), error)
        found[key]["cpu"] = np.mean(cases.columns(seeds, "cpu"))
    return found


def imposed():
    """(friction, phi) -> eta_22, eta_33, lambda_11, lambda_33 under an imposed pressure, from mu_of_iv: mean and scatter of its runs."""
    groups = {}
    for row in cases.read(HERE.parent / "mu_of_iv" / "results.csv"):
        iv, phi, sxx, syy, szz = (float(row[name]) for name in ("Iv", "phi", "sxx", "syy", "szz"))
        groups.setdefault((float(row["friction"]), iv), []).append((phi, -syy / iv, sxx / syy, szz / syy))
    found = {}
    for (friction, _), runs in groups.items():
        means, errors = np.mean(runs, axis=0), np.std(runs, axis=0, ddof=1) / np.sqrt(len(runs))
        state = dict(zip(("eta_22", "lambda_11", "lambda_33"), zip(means[1:], errors[1:])))
        state["eta_33"] = tuple(means[1] * x for x in state["lambda_33"])
        found[friction, round(means[0], 4)] = state
    return found


def other_ranges():
    """(rule and reach, phi) -> lambda_33 with other ranges of the films, friction 0.5, from range: mean and scatter of its runs."""
    groups = {}
    for row in cases.read(HERE.parent / "range" / "results.csv"):
        groups.setdefault((f"{row['rule']} {row['reach']}", float(row["phi"])), []).append(float(row["szz"]) / float(row["syy"]))
    return {key: {"lambda_33": (np.mean(x), np.std(x, ddof=1) / np.sqrt(len(x)) if len(x) > 1 else np.nan)} for key, x in groups.items()}


def total(state, component):
    mean, error = state[ETA[COMPONENTS.index(component)]]
    return -mean, error


def write(found):
    with open(HERE / "results.csv", "w", newline="", encoding="ascii") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["phi", "friction", *(word for name in ETA for word in (name, name + "_error"))])
        for (friction, phi), state in found.items():
            writer.writerow([f"{phi:g}", f"{friction:g}", *(text for name in ETA for text in two(state[name]))])
    with open(HERE / "parts.csv", "w", newline="", encoding="ascii") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["phi", "friction", "origin", *(word for c in COMPONENTS for word in (c, c + "_error"))])
        for (friction, phi), state in found.items():
            for origin in ORIGINS:
                numbers = [text for c in COMPONENTS for text in two(state[f"{origin}_{c}"])]
                writer.writerow([f"{phi:g}", f"{friction:g}", origin, *numbers])


def known(state):
    """Is eta_22 above zero, so that it can be divided by?"""
    return state["eta_22"][0] > 2 * np.nan_to_num(state["eta_22"][1])


def two(estimate):
    return f"{estimate[0]:.4g}", f"{estimate[1]:.2g}"


def pm(estimate, digits=2, plus=""):
    mean, error = estimate
    return f"{mean:{plus}.{digits}f}" + (f" +- {error:.{digits}f}" if np.isfinite(error) else "")


def table_of_states(found):
    print("\n| friction | phi | phi/phi_m | eta_11 | eta_22 | eta_33 | eq. 9 | eq. 11 | lambda_11 | lambda_33 | eq. 7 | eq. 8 |")
    for (friction, phi), state in found.items():
        jam = rheology.phi_m_chevremont(friction)
        laws = [normal_viscosity.named(name, jam).eta(phi) for name in ("chevremont_22", "chevremont_22_exponential")]
        digits = 2 if state["eta_22"][0] < 20 else 1 if state["eta_22"][0] < 200 else 0
        words = [f"{friction:g}", f"{phi:g}", f"{phi / jam:.3f}", *(pm(state[name], digits) for name in ETA),
                 *(f"{law:.{digits}f}" for law in laws), *(pm(state[name], n) if known(state) else "" for name, n in (("lambda_11", 2), ("lambda_33", 3))),
                 f"{normal_viscosity.lambda_33_line(phi):.3f}", f"{normal_viscosity.lambda_33(phi):.3f}"]
        print("| " + " | ".join(words) + " |")


def verdict(mean, error, sign):
    if np.isfinite(error) and abs(mean) < 2 * error:
        return "0"
    return "as" if (mean > 0) == (sign == "+") else "opposite"


def table_of_signs(found, reach, friction=0.5, phi=0.5):
    """Table 3.1 as numbers, over eta_22, at one state; then how often each sign is that of the thesis, over all states."""
    state = found.get((friction, phi))
    if state:
        scale = state["eta_22"][0]
        print(f"\nrange {reach}, phi {phi:g}, friction {friction:g}: stress over |yy|, + is tension, in brackets the sign in the thesis")
        print("| | total | " + " | ".join(ORIGINS) + " |")
        for c in COMPONENTS:
            parts = [total(state, c)] + [state[f"{origin}_{c}"] for origin in ORIGINS]
            print(f"| {c} | " + " | ".join(f"{pm((m / scale, e / scale), 4, '+')} ({sign})" for (m, e), sign in zip(parts, SIGNS[c])) + " |")
    print(f"\nrange {reach}: states with the sign of the thesis, of all whose sign is known within two errors")
    for c in COMPONENTS:
        words = []
        for n, sign in enumerate(SIGNS[c]):
            parts = [total(s, c) if n == 0 else s[f"{ORIGINS[n - 1]}_{c}"] for (f, _), s in found.items() if f or n != 2]
            verdicts = [verdict(*part, sign) for part in parts]
            words.append(f"{verdicts.count('as')} of {len(verdicts) - verdicts.count('0')}")
        print(f"| {c} | " + " | ".join(words) + " |")


def table_of_origins(found, friction=0.5):
    """lambda_ii of contacts and of films, all over sigma_22 [thesis, figure 5]: positive is compression."""
    print(f"\nfriction {friction:g}: parts of contacts and of films over sigma_22, positive is compression")
    print("| phi | contacts 11 | 22 | 33 | films 11 | 22 | 33 |")
    for (f, phi), state in found.items():
        if f == friction and known(state):
            scale, words = state["eta_22"][0], []
            for names in (ORIGINS[:2], ORIGINS[2:]):
                for c in COMPONENTS:
                    parts = [state[f"{name}_{c}"] for name in names]
                    error = np.sqrt(np.nansum([e**2 for _, e in parts]))
                    words.append(pm((-sum(m for m, _ in parts) / scale, error / scale), 3, "+"))
            print(f"| {phi:g} | " + " | ".join(words) + " |")


def table_of_laws(found):
    """eta_ii over laws of phi/phi_m, each friction with its own phi_m, as the thesis draws them; Zarraga with his phi_m, too."""
    print("\n| phi/phi_m | friction | eta_22: eq. 9 | eq. 11 | Boyer | eta_33: eqs. 8, 9 | Boyer | Zarraga | Zarraga, phi_m 0.62 |")
    for (friction, phi), state in sorted(found.items(), key=lambda item: item[0][1] / rheology.phi_m_chevremont(item[0][0])):
        jam = rheology.phi_m_chevremont(friction)
        names = ("chevremont_22", "chevremont_22_exponential", "boyer_22", "chevremont_33", "boyer_33", "zarraga_33")
        ratios = [state["eta_" + name.split("_")[1]][0] / normal_viscosity.named(name, jam).eta(phi) for name in names]
        ratios.append(state["eta_33"][0] / normal_viscosity.named("zarraga_33").eta(phi))
        print(f"| {phi / jam:.3f} | {friction:g} | " + " | ".join(f"{ratio:.2f}" for ratio in ratios) + " |")


def table_of_jamming(found, start=0.78):
    """phi_m from eta_22^(-1/2), linear in 1/phi for the exponent 2 [thesis, eq. 5]; the exponent with phi_m of eq. 13."""
    print(f"\nstates above {start:g} phi_m\n| friction | phi_m | eq. 13 | coefficient | exponent with phi_m of eq. 13 |")
    for friction in sorted({key[0] for key in found}):
        jam = rheology.phi_m_chevremont(friction)
        phi, eta = np.array([(phi, state["eta_22"][0]) for (f, phi), state in found.items() if f == friction and phi > start * jam]).T
        if len(phi) > 2:
            slope, rest = np.polyfit(1 / phi, eta**-0.5, 1)
            exponent = -np.polyfit(np.log(1 - phi / jam), np.log(eta), 1)[0]
            print(f"| {friction:g} | {-slope / rest:.4f} | {jam:.4f} | {rest**-2:.2f} | {exponent:.2f} |")


def off_line(found):
    """States in the range of the target: phi, friction, lambda_33 minus its line [thesis, eq. 7], error."""
    return [(phi, friction, state["lambda_33"][0] - normal_viscosity.lambda_33_line(phi), state["lambda_33"][1])
            for (friction, phi), state in found.items() if LOW <= phi <= HIGH]


def report_line(found, what):
    off = off_line(found)
    worst = max(off, key=lambda state: abs(state[2]))
    inside = sum(abs(state[2]) <= TARGET for state in off)
    missed = [state for state in off if abs(state[2]) > TARGET + 2 * np.nan_to_num(state[3])]
    print(f"\n{what}: lambda_33 within {TARGET:g} of its line, phi {LOW:g} to {HIGH:g}: {inside} of {len(off)} states; "
          f"rms {np.sqrt(np.mean([state[2]**2 for state in off])):.3f}; "
          f"largest {worst[2]:+.3f} +- {worst[3]:.3f} at phi {worst[0]:g}, friction or range {worst[1]}")
    return missed


def style(friction):
    return {"color": COLORS.get(friction, "0.5"), "ms": 4, "lw": 0.8, "capsize": 2}


def series(found, friction, name):
    states = [(phi, *state[name]) for (f, phi), state in found.items() if f == friction and known(state)]
    phi, mean, error = np.array(states).T
    return phi, mean, np.nan_to_num(error)


def draw(found, pressed):
    frictions = sorted({key[0] for key in found})
    fig, axes = plt.subplots(2, 2, figsize=(11, 8.4))
    q = np.linspace(0.45, 0.98, 300)
    for ax, name in ((axes[0, 0], "22"), (axes[0, 1], "33")):
        for law, line in (("boyer", "-"), ("zarraga", "--")):
            its = normal_viscosity.named(f"{law}_{name}")
            ax.plot(q, its.eta(q * its.phi_m), color="0.6", ls=line, lw=1, label=f"{law.capitalize()}, of $\\phi/\\phi_m$")
        jam = rheology.phi_m_chevremont(0.5)
        for law, line, label in ((f"chevremont_{name}", "-", "Chevremont, eq. 9" if name == "22" else "Chevremont, eqs. 8, 9"),
                                 (f"chevremont_{name}_exponential", ":", "eq. 11" if name == "22" else "eqs. 8, 11")):
            ax.plot(q, normal_viscosity.named(law, jam).eta(q * jam), "k" + line, lw=1, label=label + ", friction 0.5")
        for friction in frictions:
            phi, eta, error = series(found, friction, "eta_" + name)
            ax.errorbar(phi / rheology.phi_m_chevremont(friction), eta, error, fmt="o-", label=f"friction {friction:g}", **style(friction))
        for friction in sorted({key[0] for key in pressed}):
            phi, eta, error = series(pressed, friction, "eta_" + name)
            ax.errorbar(phi / rheology.phi_m_chevremont(friction), eta, error, fmt="s", mfc="none", **style(friction))
        ax.set(yscale="log", xlabel=r"$\phi/\phi_m$", ylabel=rf"$\eta_{{{name}}}$", ylim=(0.02, 3e3))
        ax.legend(frameon=False, fontsize=7)
    phi = np.linspace(0.28, 0.63, 200)
    axes[1, 1].fill_between(phi, *(normal_viscosity.lambda_33_line(phi) + d for d in (-TARGET, TARGET)), color="0.9", lw=0)
    axes[1, 1].plot(phi, normal_viscosity.lambda_33_line(phi), "k-", lw=1, label="Chevremont, eq. 7, and 0.05")
    axes[1, 1].plot(phi, normal_viscosity.lambda_33(phi), "k:", lw=1, label="eq. 8")
    for ax, name in ((axes[1, 0], "lambda_11"), (axes[1, 1], "lambda_33")):
        for law, ratio, line in (("Zarraga", {"lambda_11": 1.55 / 1.36, "lambda_33": 0.62 / 1.36}[name], "--"),
                                 ("Boyer", {"lambda_33": 0.6}.get(name), "-")):
            if ratio:
                ax.axhline(ratio, color="0.6", lw=1, ls=line, label=law)
        for friction in frictions:
            ax.errorbar(*series(found, friction, name), fmt="o-", label=f"friction {friction:g}", **style(friction))
        for friction in sorted({key[0] for key in pressed}):
            ax.errorbar(*series(pressed, friction, name), fmt="s", mfc="none", **style(friction))
        ax.plot([], [], "s", mfc="none", color="0.5", ms=4, label="imposed pressure")
        ax.set(xlabel=r"$\phi$", ylabel=rf"$\{name.replace('_', '_{')}}}$")
        ax.legend(frameon=False, fontsize=7)
    fig.tight_layout()
    fig.savefig(HERE / "results.png", dpi=130)
    plt.close(fig)


def draw_parts(found, friction=0.5):
    """Each part of each component over |yy|, for one friction in full and for the others thin."""
    fig, axes = plt.subplots(2, 4, figsize=(13, 6.4))
    for column, origin in enumerate(ORIGINS):
        for c, color, fmt in (("xx", "#1f4e79", "^-"), ("yy", "#c00000", "o-"), ("zz", "#38761d", "s-")):
            states = [(phi, *(x / state["eta_22"][0] for x in state[f"{origin}_{c}"])) for (f, phi), state in found.items()
                      if f == friction and known(state)]
            if states:
                phi, mean, error = np.array(states).T
                axes[0, column].errorbar(phi, mean, np.nan_to_num(error), fmt=fmt, color=color, ms=4, lw=0.8, label=rf"$\sigma_{{{c}}}$")
            states = [(f, *(x / state["eta_22"][0] for x in state[f"{origin}_{c}"])) for (f, phi), state in found.items() if phi == 0.5]
            if states:
                x, mean, error = np.array(states).T
                axes[1, column].errorbar(x, mean, np.nan_to_num(error), fmt=fmt, color=color, ms=4, lw=0.8, label=rf"$\sigma_{{{c}}}$")
        axes[0, column].set_title(rheology.PARTS["v_" + origin][0], fontsize=9)
        for ax, label in ((axes[0, column], rf"$\phi$, friction {friction:g}"), (axes[1, column], r"friction, $\phi$ = 0.5")):
            ax.axhline(0, color="k", lw=0.6)
            ax.set_xlabel(label)
            ax.tick_params(labelsize=7)
    for row in axes:
        row[0].set_ylabel(r"part over $|\sigma_{yy}|$ (+: tension)")
    axes[0, 0].legend(frameon=False, fontsize=8)
    fig.tight_layout()
    fig.savefig(HERE / "parts.png", dpi=130)
    plt.close(fig)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    args = parser.parse_args()
    rows = cases.read(HERE / "runs.csv")
    ranges = {reach: merged([row for row in rows if row["range"] == reach]) for reach in sorted({row["range"] for row in rows})}
    found = ranges["cut 0.5"]
    write(found)
    table_of_states(found)
    for reach, states in ranges.items():
        table_of_signs(states, reach)
    for friction in sorted({key[0] for key in found}):
        table_of_origins(found, friction)
    table_of_laws(found)
    table_of_jamming(found)
    pressed = imposed()
    missed = report_line(found, "constant volume") + report_line(pressed, "imposed pressure, mu_of_iv")
    report_line(other_ranges(), "other ranges of the films, range")
    draw(found, pressed)
    draw_parts(found)
    if args.check and missed:
        sys.exit(f"lambda_33 is off its line: {missed}")


if __name__ == "__main__":
    main()
