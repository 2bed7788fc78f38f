"""Draws doc/src/hard_cases_regimes.png: SciPy's regimes as areas, those of the package as symbols; prints where spheres begin
to oscillate. By hand, in a scratch folder, with the environment of the deck tests (tests/decks/deck.py); ten minutes.
"""
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import ListedColormap

import regimes

STOKES = (1e4, 1e3, 100, 30, 10, 3)
BORDER = 0.7    # [C]: at the highest St softer spheres oscillate
EPS, K = np.logspace(-5, -1.5, 15), np.logspace(-1, 3, 17)
STYLE = {"damped": ("#9fd39f", "o", "#176117"), "bouncing": ("#a9c4ea", "s", "#123a80"),
         "oscillating": ("#f2b5ad", "^", "#8d1a10")}    # area, symbol, its color


def regime(eps, k, stokes):
    return regimes.name(*regimes.measures(*regimes.path(eps, k, stokes, rtol=1e-6), eps))


def softest(eps, stokes):
    """Largest K, up to 3, below which all spheres oscillate."""
    last = 0.05
    for k in np.logspace(-1, 0.5, 61):
        if regime(eps, k, stokes) != "oscillating":
            return last
        last = k
    return last


def area(stokes):
    print(f"St {stokes:g}", flush=True)
    return [[regimes.NAMES.index(regime(eps, k, stokes)) for eps in EPS] for k in K]


def package():
    """Regime of the package at every other point, points of similar stiffness together."""
    points = [(eps, k, stokes) for stokes in STOKES for k in K[1::3] for eps in EPS[1::3]]
    classes = {}
    for decade in range(-8, 1):
        these = [p for p in points if decade <= np.log10(p[0] / p[1]) < decade + 1]
        if these:
            un, u = regimes.simulate(these)
            for m, p in enumerate(these):
                classes[p] = regimes.name(*regimes.measures(un[m], u[m], p[0]))
    return classes


def edges(centers):
    step = np.log(centers[1] / centers[0]) / 2
    return np.exp(np.append(np.log(centers) - step, np.log(centers[-1]) + step))


found = package()
fig, axes = plt.subplots(2, 3, figsize=(11, 7.3), sharex=True, sharey=True, constrained_layout=True)
agree = 0
for ax, stokes in zip(axes.flat, STOKES):
    table = np.array(area(stokes))
    ax.pcolormesh(edges(EPS), edges(K), table, cmap=ListedColormap([STYLE[n][0] for n in regimes.NAMES]), vmin=-0.5, vmax=2.5)
    for word in regimes.NAMES:
        mine = [(p[0], p[1]) for p, w in found.items() if w == word and p[2] == stokes]
        if mine:
            ax.plot(*np.array(mine).T, STYLE[word][1], color=STYLE[word][2], ms=5)
    agree += sum(regimes.NAMES[table[np.argmin(np.abs(np.log(K / k)))][np.argmin(np.abs(np.log(EPS / eps)))]] == w
                 for (eps, k, st), w in found.items() if st == stokes)
    ax.axhline(BORDER, color="k", lw=0.8, ls="--")
    ax.set(xscale="log", yscale="log", title=f"St = {stokes:g}")
    print(f"St {stokes:g}: all oscillate below K =", " ".join(f"{softest(eps, stokes):.2f}" for eps in EPS[::3]))
for ax in axes[1]:
    ax.set_xlabel(r"roughness $\varepsilon$")
for ax in axes[:, 0]:
    ax.set_ylabel(r"contact number $K = k \varepsilon a/$weight")
fig.get_layout_engine().set(rect=(0, 0, 1, 0.96))
for word in regimes.NAMES:
    axes[0, 0].plot([], [], STYLE[word][1], color=STYLE[word][2], label=word)
axes[0, 0].plot([], [], "k--", lw=0.8, label=f"K = {BORDER:g}")
fig.legend(*axes[0, 0].get_legend_handles_labels(), loc="upper center", ncol=4, frameon=False)
print(f"package and SciPy agree at {agree} of {len(found)} points")
figure = Path(sys.argv[0]).resolve().parents[3] / "doc" / "src" / "hard_cases_regimes.png"
fig.savefig(figure, dpi=110)
