"""The figure of pairs.py: error against work in two scenes, and the distance to the exact hydrodynamics."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

LINES = {"exponential": "o-", "euler": "s--"}
FALLING = {"smooth": "C0", "crushed": "C2", "g / 10": "C1", "g x 10": "C3"}
ENCOUNTER = {"smooth": "C0", "rough": "C2", "rough, friction": "C4", "meets": "C1"}
LABEL = {"crushed": "rough, asperities crushed", "g / 10": "smooth, g / 10", "g x 10": "smooth, g x 10",
         "rough": "rough, no friction", "rough, friction": "rough, friction 0.5", "meets": "smooth, comes into range in the run"}


def curves(axes, rows, scene, settings, what, top):
    """One line per setting and scheme; failed points are crosses at the top."""
    for setting, color in settings.items():
        for scheme, line in LINES.items():
            mine = [row for row in rows if (row["scene"], row["setting"], row["gap"]) == (scene, setting, scheme)]
            good = sorted((row["cpu_us"], row[what]) for row in mine if not row["failed"])
            filled = color if scheme == "exponential" else "none"
            axes.loglog(*np.transpose(good), line, color=color, ms=4, lw=1.2, mfc=filled,
                        label=LABEL.get(setting, setting) if scheme == "exponential" else None)
            bad = [row["cpu_us"] for row in mine if row["failed"]]
            axes.plot(bad, [top * (1 if scheme == "exponential" else 0.5)] * len(bad), "x" if scheme == "exponential" else "+",
                      color=color, ms=6, clip_on=False)


def slope(axes, x, y, order, name):
    """A short line of that order; error falls with work."""
    ends = np.array([x, 5 * x])
    axes.loglog(ends, y * (ends / x)**-order, color="0.6", lw=3, alpha=0.7)
    axes.annotate(name, (2.2 * x, y * 2.2**-order), (4, 3), textcoords="offset points", color="0.3", fontsize=8)


def decorate(axes, title, ylabel):
    axes.set_title(title, fontsize=10, loc="left")
    axes.set_xlabel("work: CPU time of the pair style [microseconds]")
    axes.set_ylabel(ylabel)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=7.5, loc="lower left")


def models(axes, known):
    """Horizontal bars: distance of gap and streamline to the exact hydrodynamics."""
    places = np.arange(len(known))[::-1]
    axes.plot([abs(np.log(row["least_gap"] / row["gap_exact"])) for row in known], places, "D", color="C4", ms=5,
              label="smallest gap, |ln ratio|")
    axes.plot([abs(row["error_y"]) for row in known], places, "o", color="C0", ms=5, label="streamline after the encounter, over a")
    axes.set_yticks(places, [row["setting"] for row in known], fontsize=7)
    axes.set_xscale("log")
    axes.set_xlabel("distance to the exact hydrodynamics")
    axes.set_title("(d) pair in shear: error of the model", fontsize=10, loc="left")
    axes.grid(alpha=0.3)
    axes.set_ylim(-4, len(known))
    axes.legend(fontsize=7.5, loc="lower right")


def draw(rows, known, model_error, path):
    """model_error: of the smallest gap (|ln ratio|) and of the streamline, in the scene of panels b and c."""
    figure, ((a, b), (c, d)) = plt.subplots(2, 2, figsize=(11, 9))
    figure.subplots_adjust(0.07, 0.085, 0.985, 0.965, 0.32, 0.22)
    curves(a, rows, "falling sphere", FALLING, "error_gap", 0.5)
    slope(a, 900, 1.2e-7, 2, "order 2")
    slope(a, 2000, 5e-3, 1, "order 1")
    decorate(a, "(a) falling sphere: gap", "largest error of ln u over the run")
    for axes, what, level, letter, name in ((b, "error_least", model_error[0], "b", "smallest gap: |ln ratio|"),
                                            (c, "error_path", model_error[1], "c", "streamline after the encounter, over a")):
        curves(axes, rows, "pair in shear", ENCOUNTER, what, 6.0 if letter == "b" else 0.6)
        axes.axhline(level, color="k", lw=1)
        axes.annotate("error of the model (smooth)", (1, level), (-4, 2), xycoords=axes.get_yaxis_transform(),
                      textcoords="offset points", ha="right", fontsize=8)
        decorate(axes, f"({letter}) pair in shear: {name.split(':')[0].split(',')[0]}", "error of " + name)
    slope(b, 1500, 2e-9, 2, "order 2")
    slope(c, 900, 4e-9, 2, "order 2")
    for axes, bottom in ((b, 2e-11), (c, 1e-12)):
        slope(axes, 4000, 2e-3 if axes is b else 1.5e-3, 1, "order 1")
        axes.set_ylim(bottom=bottom)
    models(d, known)
    figure.text(0.5, 0.012, "full symbols: gap exponential; open, dashed: gap euler; at the top what failed: x exponential, + euler", ha="center",
                fontsize=9)
    figure.savefig(path, dpi=110)
