"""Judges results.csv and circles.csv: writes table.csv and the tables of README.md, draws results.png, parts.png and directions.png.

usage: tools/python.sh judge.py
The runs of mu_of_iv here and in examples, made by the same deck, count as replicas of the same states.
"""
import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import curve_fit

HERE = Path(__file__).resolve().parent
EXAMPLES = HERE.parents[2] / "examples"
sys.path.insert(0, str(EXAMPLES / "scene"))
import cases    # noqa: E402  pylint: disable=wrong-import-position
import rheology    # noqa: E402  pylint: disable=wrong-import-position
import jamming    # noqa: E402  pylint: disable=wrong-import-position
from study import BINS, CASE, ORIGINS    # noqa: E402  pylint: disable=wrong-import-position

TABLES = [HERE / "results.csv", HERE.parent / "mu_of_iv" / "results.csv", EXAMPLES / "mu_of_iv" / "mu_of_iv.csv"]
QUANTITIES = ["phi", "mu", *ORIGINS, "sxx", "syy", "szz"]
PHI_M_ERROR = 0.01    # of eq. 13, as its authors say
NEAR, NEARER = 0.1, 0.01    # largest Iv of the fits
ROUGHNESS = 0.01
COLORS = dict(zip((0, 0.1, 0.2, 0.3, 0.5, 1, 2), plt.cm.viridis(np.linspace(0, 0.92, 7))))
FRICTIONAL = 0.36    # from here on the laws of mu hold, eq. 14
SHAPES = ["contacts", *ORIGINS, "gap", "vn", "vt"]
REFERENCE = (0.1, 0.5)    # Iv and friction of the state that the shapes are compared with
ANGLE = (np.arange(BINS) + 0.5) * np.pi / BINS


# states

def merge(rows):
    """Quantity -> mean over the runs of a state, by their particles*strain, and error: from the scatter of the runs or from their own errors,
    whichever is larger; nan if a run alone knows none."""
    weights = np.array([float(row["N"]) * float(row["strain"]) for row in rows])
    weights /= weights.sum()
    found = {}
    for name in QUANTITIES:
        values = np.array([float(row[name]) for row in rows])
        own = np.array([float(row.get(name + "_error") or "nan") for row in rows])
        mean = np.sum(weights * values)
        known = np.isfinite(own)
        error = np.sqrt(np.sum((weights * np.where(known, own, own[known].max() if known.any() else np.nan))**2))
        if len(rows) > 1:
            error = np.fmax(error, np.sqrt(np.sum(weights * (values - mean)**2) / (len(rows) - 1)))
        found[name] = (mean, error)
    pulled = [float(row["contact_t"]) / float(row["contact_n"]) for row in rows]
    found["ratio"] = (np.sum(weights * pulled), np.nan)
    found["runs"] = len(rows)
    return found


def states(tables=None):
    """(friction, Iv) -> merged runs, with an error of phi in each: the largest at this Iv where a state knows none."""
    groups = {}
    for table in tables or TABLES:
        for row in cases.read(table):
            groups.setdefault((float(row["friction"]), float(row["Iv"])), []).append(row)
    found = {key: merge(rows) for key, rows in sorted(groups.items())}
    for (_, iv), state in found.items():
        if not np.isfinite(state["phi"][1]):
            errors = [other["phi"][1] for (_, x), other in found.items() if x == iv and np.isfinite(other["phi"][1])]
            state["phi"] = (state["phi"][0], max(errors, default=3e-3))
    return found


def frictions(found):
    return sorted({key[0] for key in found})


def numbers(found):
    return sorted({key[1] for key in found})


def curve(found, friction, *names, least=0.0, largest=np.inf):
    """Iv and means and errors of these quantities, of one friction, as arrays."""
    chosen = [(iv, state) for (f, iv), state in found.items() if f == friction and least <= iv <= largest]
    return [np.array([iv for iv, _ in chosen])] + [np.array([state[name] for _, state in chosen]).T for name in names]


def fluid_part(state, iv):
    return state["film_n"][0] + state["film_t"][0] + iv


def contact_part(state):
    return state["contact_n"][0] + state["contact_t"][0]


# jamming

def fit(found, friction, largest=NEAR, **kept):
    iv, (phi, error) = curve(found, friction, "phi", largest=largest)
    return jamming.fit(iv, phi, error, **kept)


def fit_viscosity(found, friction, largest=NEAR, **kept):
    """phi against the inverse of the viscosity mu/Iv, with the errors of both."""
    iv, (phi, phi_error), (mu, mu_error) = curve(found, friction, "phi", "mu", largest=largest)
    return jamming.fit(iv / mu, phi, phi_error, iv / mu * np.nan_to_num(mu_error / mu, nan=0.01), **kept)


def slope(x, y):
    return np.polyfit(np.log(x), np.log(y), 1)[0]


def exponent_of_viscosity(found, friction, phi_m, near, far):
    """Exponent of eta_r over 1 - phi/phi_m in a range of that distance; nan with fewer than two points."""
    iv, (phi, _), (mu, _) = curve(found, friction, "phi", "mu")
    distance = 1 - phi / phi_m
    inside = (distance >= near) & (distance < far)
    return -slope(distance[inside], mu[inside] / iv[inside]) if inside.sum() > 1 else np.nan


def of_friction(friction, smooth, fall, scale):
    """The form of eq. 13."""
    return smooth - fall * (1 - np.exp(-np.asarray(friction) / scale))


def fit_of_friction(fits):
    """Parameters of that form and their errors, to phi_m of the fits."""
    x = np.array(sorted(fits))
    values, errors = np.array([(fits[f].phi_m, max(fits[f].phi_m_error, 2e-4)) for f in x]).T
    best, covariance = curve_fit(of_friction, x, values, (0.63, 0.08, 0.4), errors)
    return best, np.sqrt(np.diag(covariance))


# tables; each is a list of lines

def head(*words):
    return ["| " + " | ".join(words) + " |", "|---" * len(words) + "|"]


def line(*words):
    return "| " + " | ".join(words) + " |"


def pm(mean, error, digits):
    return f"{mean:.{digits}f}" + (f" +- {error:.{digits}f}" if np.isfinite(error) else "")


def table_phi(found):
    lines = head("Iv", *(f"friction {f:g}" for f in frictions(found)))
    for iv in numbers(found):
        words = []
        for f in frictions(found):
            state = found.get((f, iv))
            words.append(f"{pm(*state['phi'], 4)} ({rheology.phi_chevremont(iv, f):.3f})" if state else "")
        lines.append(line(f"{iv:g}", *words))
    return lines


def table_mu(found):
    lines = head("Iv", *(f"friction {f:g}" for f in frictions(found)), "Chevremont 14", "Boyer")
    for iv in numbers(found):
        words = [pm(*found[f, iv]["mu"], 3 if iv < 1 else 2) if (f, iv) in found else "" for f in frictions(found)]
        lines.append(line(f"{iv:g}", *words, f"{rheology.mu_chevremont(iv, 0.5):.3f}", f"{rheology.mu_boyer(iv):.3f}"))
    return lines


def table_jamming(found):
    lines = head("friction", "eq. 13", f"phi_m, n = 1/2 kept, Iv to {NEAR:g}", "b", "chi2/dof", f"phi_m, n free, to {NEAR:g}", "n", "b", "chi2/dof",
                 "change of n with phi_m + 0.001", f"phi_m, n free, to {NEARER:g}", "n")
    for f in frictions(found):
        kept, free = fit(found, f, n=0.5), fit(found, f)
        try:
            nearer = fit(found, f, largest=NEARER)
            near = [pm(nearer.phi_m, nearer.phi_m_error, 4), pm(nearer.n, nearer.n_error, 2)]
        except jamming.Unusable:    # too few runs yet
            near = ["", ""]
        lines.append(line(f"{f:g}", f"{rheology.phi_m_chevremont(f):.4f}", pm(kept.phi_m, kept.phi_m_error, 4), pm(kept.b, kept.b_error, 2),
                          per_dof(kept), pm(free.phi_m, free.phi_m_error, 4), pm(free.n, free.n_error, 3), pm(free.b, free.b_error, 2), per_dof(free),
                          f"{0.001 * free.per_phi_m:+.3f}", *near))
    return lines


def per_dof(found):
    return f"{found.chi2 / found.dof:.1f}" if found.dof else ""


def table_friction(found):
    lines = head("phi_m from", "frictionless", "fall", "scale of friction", "largest distance to eq. 13")
    lines.append(line("eq. 13", "0.6301 +- 0.01", "0.0794", "0.4032", ""))
    for words, fits in (("n = 1/2 kept", {f: fit(found, f, n=0.5) for f in frictions(found)}),
                        ("n free", {f: fit(found, f) for f in frictions(found)})):
        best, errors = fit_of_friction(fits)
        off = max((fits[f].phi_m - rheology.phi_m_chevremont(f) for f in fits), key=abs)
        lines.append(line(words, *(pm(b, e, 4) for b, e in zip(best, errors)), f"{off:+.4f}"))
        best[:2] *= (1 + ROUGHNESS / 2)**3
        lines.append(line(words + ", as they touch", *(f"{b:.4f}" for b in best), ""))
    return lines


def table_viscosity(found):
    lines = head("friction", "1/n, phi_m fitted", "phi_m", "-d ln eta/d ln(1 - phi/phi_m) with it, 0.1 to 0.3", "below 0.1", "phi_m of eq. 13, 0.1 to 0.3", "below 0.1",
                 "eq. 13 - 0.01", "+ 0.01")
    for f in frictions(found):
        free, jam = fit_viscosity(found, f), rheology.phi_m_chevremont(f)
        words = [f"{exponent_of_viscosity(found, f, free.phi_m, *window):.2f}" for window in ((0.1, 0.3), (1e-9, 0.1))]
        words += [f"{exponent_of_viscosity(found, f, jam, *window):.2f}" for window in ((0.1, 0.3), (1e-9, 0.1))]
        words += [f"{exponent_of_viscosity(found, f, jam + off, 1e-9, 0.1):.2f}" for off in (-PHI_M_ERROR, PHI_M_ERROR)]
        lines.append(line(f"{f:g}", pm(1 / free.n, free.n_error / free.n**2, 2), pm(free.phi_m, free.phi_m_error, 4), *(w.replace("nan", "") for w in words)))
    return lines


def table_master(found):
    lines = head("Iv", "1/(1 + sqrt(Iv))", "phi/phi_m of eq. 13: mean", "least", "largest", "phi/phi_m, n = 1/2 kept: mean", "least", "largest")
    for iv in numbers(found):
        here = [f for f in frictions(found) if (f, iv) in found]
        words = []
        for jam in (rheology.phi_m_chevremont, lambda f: fit(found, f, n=0.5).phi_m):
            over = [found[f, iv]["phi"][0] / jam(f) for f in here]
            words += [f"{np.mean(over):.3f}", f"{min(over):.3f}", f"{max(over):.3f}"]
        lines.append(line(f"{iv:g}", f"{1 / (1 + iv**0.5):.3f}", *words))
    return lines


def table_tangential(found):
    rough = [f for f in frictions(found) if f]
    lines = head("Iv", *(f"friction {f:g}" for f in rough), "films, all frictions")
    for iv in numbers(found):
        films = [s["film_t"][0] / (s["film_n"][0] + s["film_t"][0]) for (_, x), s in found.items() if x == iv]
        lines.append(line(f"{iv:g}", *(f"{found[f, iv]['ratio'][0]:.3f}" if (f, iv) in found else "" for f in rough), f"{min(films):.2f} to {max(films):.2f}"))
    return lines


def table_parts(found):
    names = list(rheology.SPLITS)
    lines = head("Iv", "contacts, frictions 0.5, 1, 2", *names, "films and fluid", *names)
    for iv in numbers(found):
        words, here = [f"{iv:g}"], [(f, found[f, iv]) for f in (0.5, 1, 2) if (f, iv) in found]
        for n, part in enumerate((contact_part, lambda state: fluid_part(state, iv))):    # pylint: disable=cell-var-from-loop
            digits = 3 if iv >= 1e-3 or not n else 5
            words.append(", ".join(f"{part(state):.{digits}f}" for _, state in here))
            words += [f"{split(iv)[n]:.{digits}f}" for split in rheology.SPLITS.values()]
        lines.append(line(*words))
    return lines


def table_weak(found):
    """Contacts where friction is low, over the law for friction."""
    chosen = [f for f in frictions(found) if f <= 0.5]
    lines = head("Iv", *(f"friction {f:g}" for f in chosen), "Chevremont")
    for iv in numbers(found):
        lines.append(line(f"{iv:g}", *(f"{contact_part(found[f, iv]):.3f}" if (f, iv) in found else "" for f in chosen),
                          f"{rheology.split_chevremont(iv)[0]:.3f}"))
    return lines


def crossing(found, friction, with_fluid):
    """Viscous number where contacts bear as much as films, with the fluid or without it."""
    chosen = [(iv, state) for (f, iv), state in found.items() if f == friction]
    logs = [np.log((fluid_part(state, iv) - (0 if with_fluid else iv)) / contact_part(state)) for iv, state in chosen]
    return np.exp(np.interp(0.0, logs, np.log([iv for iv, _ in chosen])))


def table_crossing(found):
    lines = head("friction", "Iv where contacts = films", "with the fluid", "phi/phi_m there (eq. 13)")
    for f in frictions(found):
        iv, (phi, _) = curve(found, f, "phi")
        at = crossing(found, f, True)
        over = np.interp(np.log(at), np.log(iv), phi) / rheology.phi_m_chevremont(f)
        lines.append(line(f"{f:g}", f"{crossing(found, f, False):.2f}", f"{at:.2f}", f"{over:.2f}"))
    return lines


# directions

def read_circles():
    """(Iv, friction, seed) -> quantity -> curve; of runs that were made twice the last."""
    found = {}
    for row in cases.read(HERE / "circles.csv"):
        key = (float(row["Iv"]), float(row["friction"]), row["seed"])
        found.setdefault(key, {})[row["quantity"]] = np.array([float(row[f"b{n}"]) for n in range(BINS)])
    return found


def harmonic(values, order=2):
    return np.sum(values * np.exp(1j * order * ANGLE)) / np.sum(np.abs(values))


def axis(values):
    """Axis of the second harmonic, in degrees from the flow towards the gradient."""
    return np.degrees(0.5 * np.angle(harmonic(values))) % 180


def lobe(values):
    """The lobe in extension of a curve that has another one 90 degrees from it: from the fourth harmonic, in degrees."""
    return np.degrees(0.25 * np.angle(-harmonic(values, 4)) - np.pi / 4) % 90


def half(values):
    """Weight in the quadrants of compression."""
    return np.sum(np.abs(values[ANGLE > np.pi / 2])) / np.sum(np.abs(values))


def distance(values, other):
    """Half of the area between two curves of area 1: 0 are equal, 1 share nothing."""
    return 0.5 * np.sum(np.abs(values / np.sum(np.abs(values)) - other / np.sum(np.abs(other))))


def table_axes(circles, seed):
    lines = head("friction", "Iv", "contacts", "contact_n", "contact_t", "lobes of film_n", "film_t", "films, sum", "larger lobe over smaller one")
    for (iv, f, s), of in sorted(circles.items(), key=lambda item: (item[0][1], item[0][0])):
        if s == seed and (f == REFERENCE[1] or iv == REFERENCE[0]):
            words = [f"{axis(of[name]):.0f}" if np.any(of[name]) else "" for name in ("contacts", "contact_n", "contact_t")]
            words += [f"{lobe(of['film_n']):.0f}, {lobe(of['film_n']) + 90:.0f}", f"{axis(of['film_t']):.0f}"]
            films = of["film_n"] + of["film_t"]
            lobes = sorted((1 - half(films), half(films)))
            words += [f"{axis(films):.0f}", f"{lobes[1] / lobes[0]:.2f} ({'compression' if half(films) > 0.5 else 'extension'})"]
            lines.append(line(f"{f:g}", f"{iv:g}", *words))
    return lines


def table_shapes(circles, seed):
    """How far the shapes are from those of the reference."""
    reference = circles[(*REFERENCE, seed)]
    lines = head("friction", "Iv", *SHAPES)
    for (iv, f, s), of in sorted(circles.items(), key=lambda item: (item[0][1] != REFERENCE[1], item[0][2] != seed, item[0][1], item[0][0])):
        if (iv, f, s) != (*REFERENCE, seed) and (f == REFERENCE[1] or iv == REFERENCE[0]):
            words = [f"{distance(of[name], reference[name]):.3f}" if np.any(of[name]) else "" for name in SHAPES]
            lines.append(line(f"{f:g}", f"{iv:g}" + ("" if s == seed else ", other seed"), *words))
    return lines


# figures

def draw_curves(found):
    fig, axes = plt.subplots(2, 3, figsize=(15, 9))
    wide, jam = np.logspace(-4.2, 1.2, 200), rheology.phi_m_chevremont
    free = {f: fit(found, f) for f in frictions(found)}
    kept = {f: fit(found, f, n=0.5) for f in frictions(found)}
    for f in frictions(found):
        iv, (phi, phi_error), (mu, mu_error) = curve(found, f, "phi", "mu")
        style = {"fmt": "o", "ms": 4, "color": COLORS[f], "label": f"friction {f:g}"}
        axes[0, 0].errorbar(iv, mu, np.nan_to_num(mu_error), **style)
        axes[0, 1].errorbar(iv, phi, phi_error, **style)
        axes[0, 1].plot(wide, rheology.phi_chevremont(wide, f), color=COLORS[f], lw=0.7)
        axes[0, 2].plot(iv, phi / jam(f), "o", ms=4, color=COLORS[f])
        axes[1, 1].plot(iv, 1 - phi / jam(f), "o", ms=4, mfc="none", color=COLORS[f])
        axes[1, 1].plot(iv, 1 - phi / free[f].phi_m, "o", ms=4, color=COLORS[f])
        axes[1, 2].plot(1 - phi / jam(f), mu / iv, "o", ms=4, mfc="none", color=COLORS[f])
        axes[1, 2].plot(1 - phi / free[f].phi_m, mu / iv, "o", ms=4, color=COLORS[f])
    axes[0, 0].plot(wide, rheology.mu_chevremont(wide, 0.5), color="0.4", lw=1, label="Chevremont 2019")
    axes[0, 0].plot(wide, rheology.mu_boyer(wide), color="0.4", lw=1, ls="--", label="Boyer 2011")
    axes[0, 0].set(ylabel=r"$\mu$", xscale="log", yscale="log", ylim=(0.08, 40))
    axes[0, 1].set(ylabel=r"$\phi$ (lines: Chevremont 2019)", xscale="log")
    axes[0, 2].plot(wide, 1 / (1 + wide**0.5), "k", lw=1, label=r"$1/(1+\sqrt{I_v})$")
    axes[0, 2].set(ylabel=r"$\phi/\phi_m$, $\phi_m$ of eq. 13", xscale="log")
    x = np.linspace(0, 2.1, 200)
    axes[1, 0].fill_between(x, jam(x) - PHI_M_ERROR, jam(x) + PHI_M_ERROR, color="0.85", label="eq. 13 and its error")
    axes[1, 0].plot(x, jam(x), color="0.4", lw=1)
    for fits, color, words in ((free, "C3", "$n$ free"), (kept, "C0", "$n = 1/2$ kept")):
        axes[1, 0].errorbar(list(fits), [fits[f].phi_m for f in fits], [fits[f].phi_m_error for f in fits], fmt="o", ms=5, color=color, label=words)
        axes[1, 0].plot(x, of_friction(x, *fit_of_friction(fits)[0]), color=color, lw=0.8)
    axes[1, 0].set(xlabel="friction of the particles", ylabel=r"$\phi_m$")
    axes[1, 1].plot(wide, wide**0.5, "k", lw=1, label=r"$\sqrt{I_v}$")
    axes[1, 1].plot(wide[wide < 1], 0.75 * wide[wide < 1]**0.4, "k--", lw=1, label=r"$0.75\,I_v^{0.4}$")
    axes[1, 1].set(ylabel=r"$1-\phi/\phi_m$ (open: $\phi_m$ of eq. 13, full: fitted, $n$ free)", xscale="log", yscale="log", ylim=(2e-3, 1))
    x = np.logspace(-2.5, 0, 50)
    axes[1, 2].plot(x, 0.8 * x**-2.0, "k", lw=1, label="exponent -2")
    axes[1, 2].plot(x, 40 * x**-1.0, "k:", lw=1, label="exponent -1")
    axes[1, 2].set(xlabel=r"$1-\phi/\phi_m$", ylabel=r"$\eta_r$", xscale="log", yscale="log", ylim=(1, 2e4))
    for ax in (*axes[0], axes[1, 1]):
        ax.set_xlabel(r"$I_v$")
    for ax in axes.flat:
        ax.legend(frameon=False, fontsize=7.5)
    fig.tight_layout()
    fig.savefig(HERE / "results.png", dpi=120)
    plt.close(fig)


def draw_parts(found):
    fig, axes = plt.subplots(1, 3, figsize=(15, 4.6))
    wide = np.logspace(-4.2, 1.2, 200)
    for f in frictions(found):
        iv = curve(found, f)[0]
        of = [found[f, x] for x in iv]
        style = {"ms": 4, "color": COLORS[f], "label": f"friction {f:g}"}
        axes[0].plot(iv, [contact_part(s) for s in of], "o", **style)
        axes[1].plot(iv, [fluid_part(s, x) / x for x, s in zip(iv, of)], "o", **style)
        if f:
            axes[2].plot(iv, [s["ratio"][0] for s in of], "o-", lw=0.8, **style)
    for (name, split), ls in zip(rheology.SPLITS.items(), ("-", "--", ":", "-.")):
        contact, fluid = split(wide)
        axes[0].plot(wide, contact, color="k", ls=ls, lw=1, label=name)
        axes[1].plot(wide, fluid / wide, color="k", ls=ls, lw=1, label=name)
    axes[0].set(ylabel=r"contact part of $\mu$", yscale="log", ylim=(0.1, 3))
    axes[1].set(ylabel=r"part of films and fluid over $I_v$", yscale="log", ylim=(0.3, 400))
    axes[2].axhline(0.1, color="k", lw=1, ls="--", label="a decade")
    axes[2].set(ylabel="tangential over normal contact stress", ylim=(0, 0.6))
    for ax in axes:
        ax.set(xscale="log", xlabel=r"$I_v$")
        ax.legend(frameon=False, fontsize=7.5, ncol=2)
    fig.tight_layout()
    fig.savefig(HERE / "parts.png", dpi=120)
    plt.close(fig)


def draw_directions(circles, seed):
    """Each shape against Iv (upper row) and friction (lower row)."""
    chosen = ["contacts", *ORIGINS, "gap"]
    fig, axes = plt.subplots(2, len(chosen), figsize=(18, 6.4), sharex=True)
    rows = ([(iv, f) for iv, f, s in sorted(circles) if f == REFERENCE[1] and s == seed],
            [(iv, f) for iv, f, s in sorted(circles) if iv == REFERENCE[0] and s == seed])
    for row, keys, words in zip(axes, rows, ("Iv {0:g}", "friction {1:g}")):
        shades = plt.cm.plasma(np.linspace(0, 0.85, len(keys)))
        for ax, name in zip(row, chosen):
            for (iv, f), color in zip(keys, shades):
                values = circles[iv, f, seed][name]
                if np.any(values):
                    scale = np.sum(np.abs(values)) * np.pi / BINS
                    ax.plot(np.degrees(ANGLE), values / scale, color=color, lw=1.2, label=words.format(iv, f))
            ax.axhline(0, color="k", lw=0.5)
            ax.set(xticks=(0, 45, 90, 135, 180))
            ax.title.set_fontsize(9)
    titles = {"contacts": "contacts", "contact_n": "normal contact stress", "contact_t": "tangential contact stress", "film_n": "normal film stress",
              "film_t": "tangential film stress", "gap": "mean gap"}
    for ax, name in zip(axes[0], chosen):
        ax.set_title(f"{titles[name]}, friction {REFERENCE[1]:g}", fontsize=9)
    for ax, name in zip(axes[1], chosen):
        ax.set_title(f"{titles[name]}, Iv {REFERENCE[0]:g}", fontsize=9)
        ax.set_xlabel("angle from the flow, degrees")
    for row in axes:
        row[0].legend(frameon=False, fontsize=7)
        row[0].set_ylabel("per radian, area 1")
    fig.tight_layout()
    fig.savefig(HERE / "directions.png", dpi=120)
    plt.close(fig)


def write(found):
    with open(HERE / "table.csv", "w", newline="", encoding="ascii") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["friction", "Iv", *(word for name in QUANTITIES for word in (name, name + "_error")), "ratio", "runs"])
        for (friction, iv), state in found.items():
            writer.writerow([f"{friction:g}", f"{iv:g}", *(text for name in QUANTITIES for text in (f"{state[name][0]:.5g}", f"{state[name][1]:.2g}")),
                             f"{state['ratio'][0]:.3g}", state["runs"]])


def main():
    found, circles = states(), read_circles()
    seed = cases.read(HERE / "circles.csv")[0][CASE[-1]]
    write(found)
    cases.write_tables(HERE / "README.md", {
        "phi": table_phi(found), "mu": table_mu(found), "jamming": table_jamming(found), "of friction": table_friction(found),
        "viscosity": table_viscosity(found), "master": table_master(found), "tangential": table_tangential(found), "parts": table_parts(found),
        "weak friction": table_weak(found), "crossing": table_crossing(found), "axes": table_axes(circles, seed), "shapes": table_shapes(circles, seed)})
    draw_curves(found)
    draw_parts(found)
    draw_directions(circles, seed)


if __name__ == "__main__":
    main()
