"""Table and figure of flow_curve.py."""
import csv

import numpy as np

CASE = ["deck", "settings", "variable", "value"]
RESULT = ["outcome", "max_strain", "strain", "from", "rate", "rate_error", "stress", "stress_error", "viscosity",
          "viscosity_error"]


class Unusable(ValueError):
    """What was asked for cannot be run; the text says why and what to write instead."""


def read_table(table):
    if not table.exists():
        return []
    with open(table, newline="", encoding="ascii") as file:
        rows = list(csv.DictReader(file))
    if rows and any(name not in rows[0] for name in CASE + RESULT):
        raise Unusable(f"{table} is not a table of this tool: give another name with --table")
    return rows


def write_table(table, rows):
    """All at once, so that a reader or an end in between never meets half a table."""
    names = CASE + RESULT + sorted({name for row in rows for name in row} - set(CASE + RESULT))
    rows = sorted(rows, key=lambda row: (row["deck"], row["settings"], row["variable"], float(row["value"])))
    part = table.with_suffix(".part")
    with open(part, "w", newline="", encoding="ascii") as file:
        writer = csv.DictWriter(file, names, restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    part.replace(table)


# the figure

def series(rows):
    """Lines of the figure: label -> (rows in the order of the value), of rows that have numbers."""
    lines = {}
    for row in rows:
        if row["viscosity"]:
            lines.setdefault(" ".join([row["deck"].replace("in.", "", 1), row["settings"]]).strip(), []).append(row)
    return lines


def points(rows, name):
    return np.array([float(row[name]) for row in rows]), np.array([float(row[name + "_error"]) for row in rows])


def draw(rows, name):
    """Stress against rate, viscosity and, where it changes, volume fraction against the variable."""
    import matplotlib    # pylint: disable=import-outside-toplevel
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt    # pylint: disable=import-outside-toplevel

    lines = series(rows)
    dilates = any(row.get("phi_error") and float(row["phi_error"]) > 0 for mine in lines.values() for row in mine)
    fig, axes = plt.subplots(1, 2 + dilates, figsize=(4.6 * (2 + dilates), 4.2))
    for number, (label, mine) in enumerate(lines.items()):
        value = np.array([float(row["value"]) for row in mine])
        good = np.array([row["outcome"] == "tolerance" for row in mine])
        (rate, rate_error), (stress, stress_error) = points(mine, "rate"), points(mine, "stress")
        panels = [(axes[0], rate, rate_error, stress, stress_error), (axes[1], value, None, *points(mine, "viscosity"))]
        if dilates:
            panels.append((axes[2], value, None, *points(mine, "phi")))
        for ax, x, x_error, y, y_error in panels:
            ax.errorbar(x, y, y_error, x_error, "-", color=f"C{number}", lw=0.8)
            ax.plot(x[good], y[good], "o", ms=5, color=f"C{number}", label=label)
            ax.plot(x[~good], y[~good], "o", ms=5, mfc="white", color=f"C{number}")
    axes[0].set(xscale="log", yscale="log", xlabel=r"rate $\dot\gamma$", ylabel=r"stress $\sigma_{xy}$")
    axes[1].set(xscale="log", yscale="log", ylabel=r"viscosity $\sigma_{xy}/(\eta_f\dot\gamma)$")
    for ax in axes:
        ax.tick_params(which="both", labelsize=8)
    for ax in axes[1:]:
        names = dict.fromkeys(row["variable"] for mine in lines.values() for row in mine)
        ax.set(xlabel=" / ".join(names), xscale="log")
    if dilates:
        axes[2].set(ylabel=r"volume fraction $\phi$")
    missed = any(row["outcome"] != "tolerance" for mine in lines.values() for row in mine)
    axes[1].legend(frameon=False, fontsize=8, title="open: tolerance not reached" if missed else None, title_fontsize=7)
    fig.tight_layout()
    fig.savefig(name, dpi=140)
    plt.close(fig)
