"""Draws falling.png, paths.png, gap.png and map.png from the tables of study.py in this folder, and prints what they say."""
import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm

sys.path.insert(0, str(Path(__file__).resolve().parent))
from pair import WEIGHT, squeezed    # noqa: E402

COLORS = ("#1f4e79", "#b45f06", "#38761d", "#741b47", "#6fa8dc", "#f0b27a", "#93c47d", "0.5")


def read(name):
    def number(word):
        try:
            return float(word)
        except ValueError:
            return word

    with open(name, encoding="ascii", newline="") as file:
        return [{key: number(word) for key, word in row.items()} for row in csv.DictReader(file)]


def select(rows, *columns, **where):
    """Columns of the rows with these values, as arrays."""
    chosen = [row for row in rows if all(row[key] == value for key, value in where.items())]
    return [np.array([row[name] for row in chosen]) for name in columns]


def distinct(rows, name):
    return list(dict.fromkeys(row[name] for row in rows))


def falling():
    falls, creep = read("falls.csv"), read("creep.csv")
    fig = plt.figure(figsize=(12, 7), constrained_layout=True)
    grid = fig.add_gridspec(2, 4)
    for n, case in enumerate(distinct(falls, "case")):
        t, un, u, un_scipy, u_scipy = select(falls, "t", "un", "u", "un_scipy", "u_scipy", case=case)
        ax = fig.add_subplot(grid[0, n])
        ax.plot(t, un / 0.1, color=COLORS[0], label="$u_n/u_0$")
        ax.plot(t, u / 0.1, color=COLORS[1], label="$u/u_0$")
        ax.plot(t[::4], un_scipy[::4] / 0.1, "k.", ms=2.5, label="SciPy")
        ax.plot(t[::4], u_scipy[::4] / 0.1, "k.", ms=2.5)
        low = min(-0.1, un.min() / 0.1 - 0.1)
        ax.set(title=case, xlabel="time / time of free fall", ylim=(low, 1.1 + 0.6 * (1.1 - low)))    # the inset above
        inset = ax.inset_axes([0.3, 0.67, 0.67, 0.3])
        inset.semilogy(t, u, color=COLORS[1], lw=1)
        inset.semilogy(t[::8], u_scipy[::8], "k.", ms=2)
        inset.tick_params(labelsize=6)
        if n == 0:
            ax.legend(frameon=False, fontsize=8, loc="center right")
        print(f"{case}: largest difference to SciPy, un {np.max(np.abs(un - un_scipy)) / 0.1:.1e} u0, "
              f"ln u {np.max(np.abs(np.log(u / u_scipy))):.1e}; smallest u {u.min():.1e}")
    ax = fig.add_subplot(grid[1, :2])
    for n, eps in enumerate(distinct([row for row in creep if row["k"] == 1e3], "eps")):
        t, u, closed = select(creep, "t", "u", "closed_form", k=1e3, eps=eps)
        ax.semilogy(t, u, ".", color=COLORS[n], ms=3, label=rf"$\varepsilon$ = {eps:g}, K = {1e3 * eps / WEIGHT:.2g}")
        ax.semilogy(t, closed, "-", color=COLORS[n], lw=0.8)
    ax.set(xlabel=r"time / $(\eta/a \rho g_0)$", ylabel="$u/a$", title="St = 0.01; lines: closed form")
    ax.legend(frameon=False, fontsize=8)
    ax = fig.add_subplot(grid[1, 2:])
    for n, k in enumerate(distinct(creep, "k")):
        rest = [(eps - WEIGHT / k, u[-1]) for eps in distinct(creep, "eps") for u in select(creep, "u", k=k, eps=eps)
                if len(u) and eps > WEIGHT / k]
        ax.loglog(*np.array(rest).T, "os"[n], color=COLORS[n], mfc="none", label=f"k = {k:g}")
        print(f"k = {k:g}: u at the end over u_eq - 1", " ".join(f"{got / expected - 1:.1e}" for expected, got in rest))
    ax.plot((1e-4, 0.05), (1e-4, 0.05), "k-", lw=0.8)
    ax.set(xlabel=r"$u_{eq}/a = \varepsilon - W/k$", ylabel="$u/a$ at the end", title="at rest")
    ax.legend(frameon=False, fontsize=8)
    fig.savefig("falling.png", dpi=110)
    plt.close(fig)
    off = [np.max(np.abs(np.log(u / closed))) for k in distinct(creep, "k") for eps in distinct(creep, "eps")
           for u, closed in [select(creep, "u", "closed_form", k=k, eps=eps)] if len(u)]
    print(f"creep: largest difference of ln u to the closed form {max(off):.1e}")


def paths():
    rows, sides = read("paths.csv"), read("off_plane.csv")
    fig, axes = plt.subplots(2, 2, figsize=(12, 7.5), constrained_layout=True)
    panels = (("smooth, Ca = 1e-4", ("smooth", "cut 0.5"), ("smooth", "cut 4"), ("smooth", "exact")),
              ("roughness 0.05", ("rough", "cut 0.5"), ("rough, friction", "cut 0.5"), ("rough", "exact")),
              ("smooth, Ca = 0.01", ("soft", "cut 0.5"), None, ("smooth", "exact")))
    for ax, (title, first, second, exact) in zip(axes.flat, panels):
        turn = np.linspace(0, np.pi, 100)
        ax.fill_between(2 * np.cos(turn), 2 * np.sin(turn), color="0.93")
        for offset in distinct(rows, "offset"):
            for style, which, color in (("-", first, COLORS[0]), ("-", second, COLORS[5]), ("--", exact, "k")):
                if which:
                    x, y = select(rows, "x", "y", panel=which[0], range=which[1], offset=offset)
                    ax.plot(x, y, style, color=color, lw=0.9 if style == "--" else 1.4)
        ax.set(title=title, xlabel="x/a", ylabel="y/a", xlim=(-4, 4), ylim=(0, 3.4))
        names = [f"package, {first[1]}"] + ([f"package, {second[1]}" if second[0] == "smooth" else "the same, friction 0.5"] if second else [])
        handles = [plt.Line2D([], [], color=color, label=name) for color, name in zip((COLORS[0], COLORS[5]), names)]
        handles.append(plt.Line2D([], [], color="k", ls="--", lw=0.9, label="exact" if exact[0] == first[0] else "exact, hard"))
        ax.legend(handles=handles, frameon=False, fontsize=8, loc="upper right")
    ax = axes[1, 1]
    for eps, color in ((0.0, COLORS[0]), (0.05, COLORS[1])):
        y, z, y_out, z_out, y_exact, z_exact = select(sides, "y", "z", "y_out", "z_out", "y_exact", "z_exact", eps=eps)
        ax.plot(z_out, y_out, "o", color=color, label=f"behind, roughness {eps:g}")
        ax.plot(z_exact, y_exact, "x", color="k", label=None if eps else "exact")
        for n, zn in enumerate(z):
            ax.plot((zn, z_out[n]), (y[n], y_out[n]), "-", color=color, lw=0.5)
        off = np.hypot(y_out - y_exact, z_out - z_exact)
        print(f"off the plane, roughness {eps:g}: distance to the exact streamline {off.min():.3f} to {off.max():.3f}")
    ax.plot(z, y, ".", color="0.5", label="before")
    ax.set(title="off the plane of shear", xlabel="z/a", ylabel="y/a", aspect="equal")
    ax.legend(frameon=False, fontsize=8, loc="center left", bbox_to_anchor=(1.02, 0.5))
    fig.savefig("paths.png", dpi=110)
    plt.close(fig)


def gaps():
    rows, torque, out = read("gap.csv"), read("two_pi.csv"), read("out.csv")
    fig, axes = plt.subplots(1, 3, figsize=(15, 5), constrained_layout=True)
    ax = axes[0]
    for n, films in enumerate(name for name in distinct(rows, "films") if name != "exact"):
        offset, least, behind = select(rows, "offset", "least_gap", "out", films=films)
        style = "^--" if films.startswith("squeeze") else "s--" if films.startswith("shifted") else "o-"
        ax.loglog(offset, least, style, color=COLORS[n], ms=3, lw=1, label=films)
        print(f"{films}: least gap {least[0]:.2e} at offset {offset[0]:g}, streamline behind off by",
              " ".join(f"{value:.4f}" for value in behind - offset))
    offset, least = select(rows, "offset", "least_gap", films="squeeze film only")
    closed = np.array([squeezed(y, 0.5) for y in offset])
    ax.loglog(offset, closed, "-", color="0.5", lw=0.8, label="the same, closed form")
    ax.loglog(*select(rows, "offset", "least_gap", films="exact"), "k-", lw=1.6, label="exact")
    print(f"squeeze film only: largest difference to the closed form {np.max(np.abs(least / closed - 1)):.1e}")
    far = read("residual.csv") if Path("residual.csv").exists() else []
    if far:
        ax.loglog(*select(far, "offset", "least_gap"), "kD", mfc="none", ms=5, label="residual 1, fix hydro grid")
    for row in far:
        print("residual 1, offset {offset:g}: least gap {least_gap:.3g}, exact {least_exact:.3g}; y from {start:.4f} to {end:.4f}".format(**row))
    ax.loglog(*select(torque, "offset", "least_gap", torque="2 pi"), "r*", ms=7, label=r"cut 4, torque with $2\pi$")
    ax.set(xlabel="offset $d_0/a$", ylabel="least gap / a")
    ax.legend(frameon=False, fontsize=8, loc="lower right")
    ax = axes[1]
    for n, films in enumerate(distinct(out, "films")):
        for offset, style in ((0.01, "-"), (0.2, "--"), (0.5, ":")):
            eps, behind = select(out, "eps", "out", films=films, offset=offset, ca=1e-4)
            ax.loglog(eps[eps > 0], behind[eps > 0], "o" + style, color=COLORS[n], ms=3, lw=1, label=films if offset == 0.01 else None)
    eps, exact = select(out, "eps", "exact", films="cut 0.5", offset=0.01, ca=1e-4)
    ax.loglog(eps[eps > 0], exact[eps > 0], "k-", lw=1.6, label="exact")
    ax.set(xlabel=r"roughness $\varepsilon$", ylabel="streamline behind / a", title="hard; offsets 0.01 -, 0.2 --, 0.5 :")
    ax.legend(frameon=False, fontsize=8)
    ax = axes[2]
    soft = [row for row in out if row["eps"] == 0]
    for n, offset in enumerate(distinct(soft, "offset")):
        ca, behind = select(soft, "ca", "out", offset=offset)
        ax.loglog(ca, behind, "o-", color=COLORS[n], ms=3, lw=1, label=f"offset {offset:g}")
        print(f"smooth, offset {offset:g}: (out^2 - offset^2)/Ca", " ".join(f"{value:.3g}" for value in (behind**2 - offset**2) / ca))
    ax.set(xlabel="Ca", title="smooth, cut 0.5")
    ax.legend(frameon=False, fontsize=8)
    fig.savefig("gap.png", dpi=110)
    plt.close(fig)
    for films in distinct(out, "films"):
        for offset in (0.01, 0.2, 0.5):
            eps, behind, exact = select(out, "eps", "out", "exact", films=films, offset=offset, ca=1e-4)
            print(f"{films}, offset {offset:g}, hard:", "  ".join(f"{e:g} {b:.3f} ({x:.3f})" for e, b, x in zip(eps, behind, exact) if e))


def streamlines():
    rows = read("map.csv")
    ca, eps = distinct(rows, "ca"), distinct(rows, "eps")
    table = np.array([row["out"] for row in rows]).reshape(len(ca), len(eps)).T - 0.01
    fig, ax = plt.subplots(figsize=(7.5, 5), constrained_layout=True)
    places = np.arange(len(eps) + 1)
    step = np.sqrt(ca[1] / ca[0])
    image = ax.pcolormesh(np.append(np.array(ca) / step, ca[-1] * step), places, table, norm=LogNorm(table.min(), table.max()), cmap="viridis")
    for m, row in enumerate(table):
        for n, value in enumerate(row):
            ax.text(ca[n], places[m] + 0.5, f"{value:.2g}", ha="center", va="center", fontsize=7,
                    color="k" if value > np.sqrt(table.min() * table.max()) else "w")
    checked = [row for row in rows if row["scipy"] != ""]
    ax.plot([row["ca"] for row in checked], [eps.index(row["eps"]) + 0.2 for row in checked], "r.", ms=4, label="SciPy, too")
    ax.set(xscale="log", xlabel="Ca", ylabel=r"roughness $\varepsilon$", title="streamline behind - offset 0.01, over a")
    ax.set_yticks(places[:-1] + 0.5, [f"{value:g}" for value in eps])
    ax.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), fontsize=8)
    fig.colorbar(image)
    fig.savefig("map.png", dpi=110)
    plt.close(fig)
    print("map: largest difference to SciPy", f"{max(abs(row['out'] - row['scipy']) for row in checked):.1e}")
    for m, value in enumerate(eps):
        print(f"  roughness {value:g}:", " ".join(f"{x:.4f}" for x in table[m]))


def film_table():
    rows = read("films.csv")
    for range_ in ("cut 0.5", "cut 4", "exact"):
        for name in distinct(rows, "films"):
            found = select(rows, "least_gap", "y_out", "z_out", range=range_, films=name)
            if len(found[0]):
                print(f"{range_}, {name}:", "; ".join(f"{u:.2e} ({y:.4f}, {z:.4f})" for u, y, z in zip(*found)))


if __name__ == "__main__":
    falling()
    paths()
    gaps()
    streamlines()
    film_table()
