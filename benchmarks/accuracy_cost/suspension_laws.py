"""What the runs of suspension.py say: laws of the errors, tables of the manual, and the figure.

usage: tools/python.sh suspension_laws.py table | draw
The laws are the constants of src/SUSPENSION-ADVISER/scene_accuracy.h.
"""
import csv
import math
import re
import sys
from pathlib import Path

import numpy as np

from suspension import BASE, FIELDS, HELD, SCATTER, SETTLE, SHORT, SHORTS, SIZES, SMALL, STEPS, TABLE

MANUAL = Path(__file__).resolve().parents[2] / "doc" / "src"


def read():
    """Rows of the table, numbers as such; those that failed apart."""
    rows = list(csv.DictReader(TABLE.open(encoding="ascii")))
    for row in rows:
        for key in set(FIELDS) - {"set", "knob", "value", "quarters", "failed"}:
            row[key] = float(row[key]) if row[key] else math.nan
    return [row for row in rows if not row["failed"]], [row for row in rows if row["failed"]]


def of(rows, *key):
    """Rows of a set, knob and value by seed."""
    return {row["seed"]: row for row in rows if (row["set"], row["knob"], row["value"])[:len(key)] == key}


def own_error(rows, row):
    """Relative error of a run; that of its strain, if it was too short to tell its own."""
    strain = row["cpu"] / (1e-6 * row["us"] * row["particles"]) - SETTLE
    return row["error"] / row["eta_r"] if row["error"] == row["error"] else \
        scatter(rows, "0.5")[0] / math.sqrt(row["particles"] * strain)


def change(rows, key, base=("strain", "base", "")):
    """Relative change of the viscosity against the base and its error, from the seeds that both have: a system and its
    twin share their particles. The error is that of the runs or the scatter of the differences, whichever is larger."""
    these, those = of(rows, *key), of(rows, *base)
    seeds = sorted(set(these) & set(those))
    off = np.array([these[s]["eta_r"] / those[s]["eta_r"] - 1 for s in seeds])
    errors = [math.hypot(own_error(rows, these[s]), own_error(rows, those[s])) for s in seeds]
    error = math.sqrt(sum(e * e for e in errors)) / len(seeds)
    if len(seeds) > 2:
        error = max(error, off.std(ddof=1) / math.sqrt(len(seeds)))
    return off.mean(), error


def fit(x, changes):
    """Coefficient c of change = c x and its error, which grows if the fit is bad."""
    x, (y, error) = np.asarray(x), np.asarray(changes).T
    c = np.sum(x * y / error**2) / np.sum((x / error) ** 2)
    chi2 = np.sum(((y - c * x) / error) ** 2) / max(len(y) - 1, 1)
    return c, math.sqrt(max(chi2, 1) / np.sum((x / error) ** 2))


def scatter(rows, phi):
    """Scatter C of the mean of a run over a strain, as C/sqrt(N strain), and its error: from the means of the seeds or from
    those of all quarters of their strain, whichever is larger."""
    quarters = np.array([[float(x) for x in row["quarters"].split()] for row in of(rows, "scatter", "phi", phi).values()])
    strain = SCATTER[phi][1]["strain"] - SETTLE
    seeds = len(quarters)
    whole = quarters.mean(axis=1).std(ddof=1) * math.sqrt(BASE["N"] * strain) / quarters.mean()
    parts = quarters.std(ddof=1) * math.sqrt(BASE["N"] * strain / 4) / quarters.mean()
    return (whole, whole / math.sqrt(2 * seeds - 2)) if whole > parts else (parts, parts / math.sqrt(8 * seeds - 2))


def parts(rows, phi):
    """Share of the stress and its scatter C, between seeds, of all contacts and of all films."""
    runs = list(of(rows, "scatter", "phi", phi).values())
    root = math.sqrt(BASE["N"] * (SCATTER[phi][1]["strain"] - SETTLE))
    eta = np.mean([row["eta_r"] for row in runs])
    found = {}
    for name in ("contact", "film"):
        values = np.array([row[f"{name}_n"] + row[f"{name}_t"] for row in runs])
        found[name] = values.mean() / eta, values.std(ddof=1) / values.mean() * root
    return found


def pressure(rows):
    """Of the particles in the base case: the runs were told a stiffness, suspension_scene is told a pressure."""
    return -np.mean([row["syy"] for row in of(rows, "strain", "base", "").values()])


def size_changes(rows):
    """(knob, value) -> change and error: small cells against the base case, others against N = 500 at the cheap settings."""
    c = scatter(rows, "0.5")[0]

    def mean(runs, particles, strain):
        return np.mean([row["eta_r"] for row in runs.values()]), c / math.sqrt(len(runs) * particles * (strain - SETTLE))
    base = mean(of(rows, "strain", "base", ""), BASE["N"], BASE["strain"])
    cheap = mean(of(rows, "scatter", "phi", "0.5"), BASE["N"], SCATTER["0.5"][1]["strain"])
    found = {}
    for knob, sizes, (eta, spread) in (("particles, base", SMALL, base), ("particles", SIZES, cheap)):
        for value, how in sizes.items():
            here = mean(of(rows, "size", knob, value), *how)
            found[knob, value] = here[0] / eta - 1, math.hypot(here[1], spread)
    return found


def size_law(rows):
    """Of 1/N, without those that broke down."""
    found = {key: off for key, off in size_changes(rows).items() if key not in (("particles", "100"), ("particles", "200"))}
    x = np.array([1 / float(value) for _, value in found])
    return (*fit(x - 1 / BASE["N"], list(found.values())), x.min(), x.max())


def laws(rows):
    """Cause -> (coefficient, error, smallest and largest x measured) of change = coefficient x, as in scene_accuracy.h."""
    found = {}
    short = [row for row in rows if row["set"] == "short" and "euler" not in row["knob"] and row["step"] > 0.11]
    x = np.array([SHORT / row["steps"] for row in short])
    slope = np.array([row["off"] for row in short]) / x
    found["time step"] = (slope.mean(), slope.std(ddof=1), x.min(), x.max())

    def against_base(knob, values, x_of, base, exponent=1):
        x = np.array([x_of(float(v)) for v in values])
        c, error = fit(x**exponent - x_of(base) ** exponent, [change(rows, ("strain", knob, v)) for v in values])
        return c, error, x.min(), x.max()
    p = pressure(rows)
    found["stiffness"] = against_base("stiffness", ("1e5", "2e5", "3e5", "1e7"), lambda g: p / (0.01 * g), BASE["stiffness"])
    found["particle inertia"] = against_base("Stokes number", ("0.05", "1", "2", "5"), float, BASE["stokes"], 2)
    found["few particles"] = size_law(rows)
    found["twisting film left out"] = (*change(rows, ("strain", "left out", "twist")), 1.0, 1.0)
    return found


def converged(rows):
    """Viscosity of the base case without its errors, and its relative error: of the runs at the base settings with any time
    step and of those at g 1e5, each freed of what the laws say."""
    law = laws(rows)
    p = pressure(rows)
    found = []
    for runs, g in ([[row for row in rows if row["set"] == "strain" and row["knob"] in ("base", "time step")], BASE["stiffness"]],
                    [list(of(rows, "scatter", "phi", "0.5").values()), 1e5]):
        x = {"stiffness": p / (0.01 * g), "particle inertia": BASE["stokes"] ** 2, "few particles": 1 / BASE["N"]}
        by_seed = {}
        for row in runs:
            by_seed.setdefault(row["seed"], []).append(row["eta_r"])
        means = np.array([np.mean(values) for values in by_seed.values()])
        bias = sum(law[cause][0] * x[cause] for cause in x)
        doubt = math.sqrt(sum((law[cause][1] * x[cause]) ** 2 for cause in x))
        strain = np.mean([row["cpu"] / (1e-6 * row["us"] * BASE["N"]) - SETTLE for row in runs])
        spread = scatter(rows, "0.5")[0] / math.sqrt(len(means) * BASE["N"] * strain)
        found.append((means.mean() / (1 + bias), math.hypot(spread, doubt)))
    value, error = np.array(found).T
    weight = 1 / error**2
    return np.sum(weight * value) / np.sum(weight), 1 / math.sqrt(np.sum(weight))


def seconds(rows):
    """CPU seconds of a particle for a unit of strain and for a step, fitted to all runs with all films at range cut 0.5."""
    runs = [row for row in rows if row["set"] in ("strain", "scatter") and row["particles"] == 500 and row["eta_r"] < 60
            and row["knob"] not in ("left out", "range", "gap euler, time step")]
    us, cpu, steps = np.array([[row[name] for name in ("us", "cpu", "steps")] for row in runs]).T
    strain = cpu / (1e-6 * us * BASE["N"])
    terms = np.vstack([np.ones(len(us)), steps / strain]).T
    return np.linalg.lstsq(terms / us[:, None], np.ones(len(us)), rcond=None)[0] * 1e-6    # of relative errors


def remark(runs):
    """What is wrong with a run that did not stop."""
    film, contact = (np.mean([row[name] for row in runs]) for name in ("film_n", "contact_n"))
    if film > contact:
        return "fails: asperities crushed flat, films carry the stress"
    return "above the limit" if np.mean([row["step"] for row in runs]) > 1 else ""


NAMES = {"base": "base", "time step": "time step over sqrt(m/g), 0.15", "stiffness": "stiffness, 1e6",
         "Stokes number": "St, 0.5", "left out": "film switched off", "range": "range, cut 0.5", "roughness": "roughness, 0.01",
         "roll coefficient": "rolling coefficient, 0.6", "effective radius": "radius, harmonic",
         "gap euler, time step": "gap euler, time step", "particles, base": "N, 500", "particles": "N at stiffness 1e5, 500"}


def table(rows, lost):
    """Prints the laws and the scatter; writes for the manual each knob with its change, its cost and that over the base."""
    for cause, (c, error, low, high) in laws(rows).items():
        print(f"law {cause}: {c:.3g} +- {error:.2g}, from {low:.2g} to {high:.2g}")
    for phi in sorted(SCATTER):
        print("scatter phi {}: {:.2f} +- {:.2f}".format(phi, *scatter(rows, phi)), end="; ")
        print(", ".join(f"{name} {100 * share:.0f} % of the stress, C = {c:.1f}" for name, (share, c) in parts(rows, phi).items()))
    print("CPU of a particle: {:.3g} s a unit of strain, {:.3g} s a step".format(*seconds(rows)))
    print("converged viscosity: {:.2f}, relative error {:.3f}".format(*converged(rows)))
    cost = np.mean([row["us"] for row in of(rows, "strain", "base", "").values()])
    sizes = size_changes(rows)
    lines = ["setting, base case; value; dt/limit; viscosity; contacts; films; change, %; CPU, us; over the base; remark"]
    seen = dict.fromkeys((row["set"], row["knob"], row["value"]) for row in rows if row["set"] in ("strain", "size"))
    order = list(NAMES)

    def place(key):
        number = re.sub("[^0-9e.-]", "", key[2].split()[-1] if key[2] else "")
        return order.index(key[1]), float(number) if re.fullmatch(r"[\d.]+(e-?\d+)?", number) else 0
    for key in sorted(seen, key=place):
        runs = list(of(rows, *key).values())
        eta, us, step = (np.mean([row[name] for row in runs]) for name in ("eta_r", "us", "step"))
        off, error = sizes[key[1:]] if key[0] == "size" else change(rows, key)
        shown = "" if key[1] == "base" else f"{100 * off:+.0f} +- {100 * error:.0f}"
        contact, film = (np.mean([row[f"{name}_n"] + row[f"{name}_t"] for row in runs]) for name in ("contact", "film"))
        lines.append(f"{NAMES[key[1]]}; {key[2]}; {step:.2g}; {eta:.1f}; {contact:.1f}; {film:.1f}; {shown}; {us:.0f}; {us / cost:.2f}; {remark(runs)}")
    lines += [f"{NAMES[row['knob']]}; {row['value']}; {row['step']:.2g}; ; ; ; ; ; ; fails: {row['failed'].split(': ', 1)[-1].split(' at step')[0]}" for row in lost]
    (MANUAL / "accuracy_suspension.csv").write_text("\n".join(lines) + "\n", encoding="ascii")
    print("\n".join(lines))
    lines = ["setting; volume fraction; viscosity; CPU, us"]
    for value in HELD:
        for row in of(rows, "pressure", "pressure 45", value).values():
            error = f" +- {row['phi_error']:.4f}" if row["phi_error"] == row["phi_error"] else ""
            lines.append(f"{value}; {row['phi']:.4f}{error}; {row['eta_r']:.1f}; {row['us']:.0f}")
    (MANUAL / "accuracy_pressure.csv").write_text("\n".join(lines) + "\n", encoding="ascii")
    print("\n".join(lines))


def draw_steps(ax, rows):
    """Short runs that begin alike: error against the finest step."""
    for kind, color in zip(SHORTS, ("k", "C3", "C0", "C2")):
        steps = [v for v in STEPS if of(rows, "short", kind, v)]
        us, off, places = ([np.mean([abs(row[name]) for row in of(rows, "short", kind, v).values()]) for v in steps]
                           for name in ("us", "off", "off_x"))
        ax.loglog(us, off, "o-", color=color, ms=4, lw=0.8, label=kind)
        ax.loglog(us, places, "x--", color=color, ms=4, lw=0.8)
    ax.set_title("time step: strain 0.1 from the same state", fontsize=9)
    ax.set(ylabel="relative error of stress (o), of positions/radius (x)")
    ax.legend(frameon=False, fontsize=7, title="gap, St 0.5, g 1e6 if not said", title_fontsize=7)


def draw_knobs(ax, rows):
    """Change of the steady viscosity by each source of error; an arrow where it is less than its error."""
    marks = {"time step": ("C0", "o"), "stiffness": ("C2", "s"), "Stokes number": ("C1", "^"), "left out": ("C3", "D")}
    seen = dict.fromkeys((row["set"], row["knob"], row["value"]) for row in rows if row["set"] == "strain" and row["knob"] in marks)
    for n, key in enumerate(seen):
        color, mark = marks[key[1]]
        off, error = change(rows, key)
        runs = of(rows, *key).values()
        us = np.mean([row["us"] for row in runs])
        mark = "X" if remark(runs).startswith("fails") else mark
        hidden = abs(off) < error
        y = error if hidden else abs(off)
        ax.errorbar(us, y, yerr=0.4 * y if hidden else [[min(error, 0.7 * y)], [error]], uplims=hidden, fmt=mark, ms=4, color=color,
                    lw=0.8, mfc="w" if hidden else color)
        ax.annotate(key[2], (us, y), fontsize=6.5, xytext=(4, 3) if n % 2 else (-16, 3), textcoords="offset points", color=color)
    for knob, (color, mark) in marks.items():
        ax.plot([], [], mark, ms=4, color=color, label={"time step": "time step over sqrt(m/g)", "left out": "film switched off",
                                                       "stiffness": "stiffness g"}.get(knob, knob))
    ax.plot([], [], "X", color="0.3", ms=4, label="fails: asperities crushed flat")
    ax.set(xscale="log", yscale="log", ylim=(5e-3, 20), ylabel=r"$|$change of $\eta_r|/\eta_r$ against the base (0.15, 1e6, 0.5)")
    ax.set_title("steady viscosity (open, arrow: not more than its error)", fontsize=9)
    ax.legend(frameon=False, fontsize=7, loc="upper right")


def draw_scatter(ax, rows):
    """Scatter between seeds over windows of their strain, and C/sqrt(N strain)."""
    us = np.mean([row["us"] for row in of(rows, "scatter", "phi", "0.5").values()])
    for phi, color in zip(sorted(SCATTER), ("C0", "C1", "k", "C3")):
        runs = list(of(rows, "scatter", "phi", phi).values())
        quarters = np.array([[float(x) for x in row["quarters"].split()] for row in runs])
        quarter = 0.25 * (SCATTER[phi][1]["strain"] - SETTLE)
        for many in (1, 2, 4):
            means = quarters.reshape(len(runs), -1, many).mean(axis=2)
            spread = means.std(axis=0, ddof=1).mean() / means.mean()
            ax.plot(many * quarter * BASE["N"] * us * 1e-6, spread, "o", ms=4, color=color)
        cost = np.array([0.3, 300])
        c, error = scatter(rows, phi)
        ax.loglog(cost, c / np.sqrt(cost / us * 1e6), color=color, lw=0.8, label=rf"$\phi$ {phi}: C = {c:.1f} $\pm$ {error:.1f}")
    ax.set_title(r"how long: scatter between seeds, C/$\sqrt{N\gamma}$ at g 1e5", fontsize=9)
    ax.set(xlabel="CPU seconds of the whole run", ylabel=r"relative standard error of $\eta_r$")
    ax.legend(frameon=False, fontsize=7)


def draw_held(ax, rows):
    """Volume fraction under an imposed pressure."""
    for n, value in enumerate(HELD):
        for row in of(rows, "pressure", "pressure 45", value).values():
            error = row["phi_error"] if row["phi_error"] == row["phi_error"] else 0.002
            ax.errorbar(row["us"], row["phi"], yerr=error, fmt="o", ms=4, color=f"C{n}", lw=0.8)
            place, side = {"base": ((4, -9), "left"), "time step 0.3": ((-5, -3), "right"), "St 0.05": ((0, -14), "right"),
                           "range cut 1": ((0, 6), "right")}.get(value, ((4, 4), "left"))
            ax.annotate(value, (row["us"], row["phi"]), fontsize=6.5, xytext=place, textcoords="offset points", color=f"C{n}", ha=side)
    ax.set(xscale="log", ylabel=r"$\phi$ at pressure 45 $\eta\dot\gamma$")
    ax.set_title("imposed pressure", fontsize=9)


def draw(rows, _lost):
    import matplotlib    # pylint: disable=import-outside-toplevel
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt    # pylint: disable=import-outside-toplevel
    fig, axes = plt.subplots(2, 2, figsize=(11, 8.5))
    for ax, panel in zip(axes.flat, (draw_steps, draw_knobs, draw_scatter, draw_held)):
        ax.set_xlabel("CPU microseconds per particle and unit of strain")
        panel(ax, rows)
        if ax is not axes[1, 0]:
            ax.set_xticks([n * 10**k for k in (2, 3, 4, 5) for n in (1, 2, 5) if ax.get_xlim()[0] < n * 10**k < ax.get_xlim()[1]])
            ax.xaxis.set_major_formatter("{x:g}")
        ax.minorticks_off()
        ax.tick_params(labelsize=8)
    fig.tight_layout()
    fig.savefig(TABLE.with_suffix(".png"), dpi=130)


if __name__ == "__main__":
    {"table": table, "draw": draw}[sys.argv[1]](*read())
