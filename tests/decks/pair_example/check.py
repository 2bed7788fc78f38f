# ranks: 1
"""The example examples/pair, shortened: spheres that fall beside SciPy and the closed form, encounters beside the exact
two-body solution, a closed form, SciPy, and two numbers of Yade 2023.02a (its implicit lubrication law with films to 4 a).
"""
import sys

import numpy as np

import deck
from deck import expect, expect_close
from oracle import exact_pair

sys.path.insert(0, str(deck.PAIR))
import pair
import study


def rows(name, *columns, **where):
    chosen = [row for row in tables[name] if all(row[key] == value for key, value in where.items())]
    return [np.array([row[column] for row in chosen]) for column in columns]


study.FALLS = {name: study.FALLS[name] for name in ("oscillating", "bouncing")}
study.CREEP = {1e3: (0.0, 1e-3, 1e-2)}
study.OFFSETS, study.PATHS, study.ANGLES = (0.05, 0.2, 1.0), (0.3,), (45,)
study.RANGES = {name: study.RANGES[name] for name in ("cut 0.25", "cut 0.5", "cut 4")}
study.OUT_RANGES = study.FILM_RANGES = ("cut 0.5",)
study.FILMS = {name: study.FILMS[name] for name in ("all films", "no rolling film", "squeeze film only")}
study.TWO_PI = {"2 pi": (0.01,), "right": (0.2,)}
study.ROUGH, study.SOFT = (0.01, 0.05), (1e-3, 1e-2)
study.MAP_CA, study.MAP_EPS = np.array((1e-3, 1e-2)), (0.0, 0.02)
study.MAP_SCIPY = [(1e-3, 0.02), (1e-2, 0.02)]
tables = {}
for part, make in study.PARTS.items():
    if part == "residual":    # deck residual
        continue
    tables[part] = list(make())
    study.write(f"{part}.csv", tables[part])

# a sphere that falls
for case in study.FALLS:
    un, u, un_scipy, u_scipy = rows("falls", "un", "u", "un_scipy", "u_scipy", case=case)
    expect_close(f"{case}: path against SciPy, over the fall", un / 0.1, un_scipy / 0.1, atol=5e-3)
    expect("  it leaves the surface" if case == "bouncing" else "  the film holds it",
           (u[len(u) // 2:].max() > 0.02) == (case == "bouncing"), f"{u[len(u) // 2:].max():.3f}")
for eps in study.CREEP[1e3]:
    u, closed = rows("creep", "u", "closed_form", eps=eps)
    expect_close(f"creeps onto roughness {eps:g}: ln u against the closed form", np.log(u), np.log(closed), atol=1e-4)

# smooth and hard: exact streamlines, least gaps of the other code
for name in ("cut 0.25", "cut 0.5"):
    offset, behind = rows("gap", "offset", "out", films=name)
    grown = (behind**2 - offset**2) / study.HARD
    expect(f"{name}: back on the streamline but for a softness of 1e-4", np.all((grown > 0) & (grown < 30)), str(grown))
least, exact = (rows("gap", "least_gap", films=name)[0] for name in ("cut 0.5", "exact"))
expect("films to 0.5 a keep spheres apart that come close", np.all(least[:2] > 50 * exact[:2]), str(least / exact))
(wrong,), (right,) = (rows("two_pi", "least_gap", torque=name)[0] for name in study.TWO_PI)
expect_close("with 2 pi in the torque as in Yade's script", wrong, 3.7e-5, rtol=0.05)
expect_close("with the right torque as Yade has it", right, 4.46e-2, rtol=0.01)

# rough: one streamline whatever the offset
behind = rows("out", "out", films="cut 0.5", eps=0.05)[0]
expect_close("roughness 0.05: streamline behind from offsets 0.01, 0.2 and 0.5", behind, np.mean(behind), rtol=1e-3)

# soft: out^2 - offset^2 grows with Ca
ca, behind, offset = rows("out", "ca", "out", "offset", eps=0.0)
grown = (behind**2 - offset**2) / ca
expect("soft: streamline behind farther out", np.all(behind > offset) and grown.min() > 8 and grown.max() < 30, str(grown))

# films: rolling does nothing to equal spheres in the plane
least, y = rows("films", "least_gap", "y_out", range="cut 0.5", films="no rolling film")
all_least, all_y = rows("films", "least_gap", "y_out", range="cut 0.5", films="all films")
expect_close("no rolling film: least gap, in the plane", least[:2], all_least[:2], rtol=1e-6)
offset, squeeze = rows("gap", "offset", "least_gap", films="squeeze film only")
expect_close("squeeze film only: least gap, closed form", squeeze, [pair.squeezed(y, 0.5) for y in offset], rtol=0.01)

# the map, beside SciPy
for row in tables["map"]:
    if row["scipy"] != "":
        expect_close(f"Ca {row['ca']:g}, roughness {row['eps']:g}: streamline behind", row["out"], row["scipy"], atol=1e-3)

# exact paths of both kinds
expect_close("exact smooth path", exact_pair.path((-30.0, 0.5), 30.0)[1], exact_pair.encounter(-30.0, 0.5, 30.0)[0], rtol=1e-2)
expect_close("exact rough path", exact_pair.path((-30.0, 0.3), 30.0, 0.05)[0][1, -1], exact_pair.leave_contact(0.05, 30.0), rtol=1e-6)

text = deck.draw_example("pair", "falling.png", "paths.png", "gap.png", "map.png")
expect("films are printed", "squeeze film only" in text)
deck.finish()
