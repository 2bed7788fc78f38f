"""The tables of this folder: two spheres that fall on each other or pass each other, each beside its solution.

usage: tools/python.sh study.py [-o FOLDER] [PART ...]    # all parts: two minutes of CPU; plot.py draws the tables
"""
import argparse
import csv
from pathlib import Path

import numpy as np

import pair
from pair import Encounter, Fall, encounters
from oracle import exact_pair

HARD, SLOW = 1e-4, 1e-3    # Ca and St where spheres shall be hard and without inertia
OFFSETS = (0.01, 0.02, 0.05, 0.1, 0.2, 0.35, 0.5, 0.75, 1.0, 1.5)
PATHS = (0.1, 0.3, 0.6, 1.0, 1.5)
ANGLES = (15, 30, 45, 60, 75, 90)    # from the vorticity
FAR = 30.0                 # from where and to where the exact paths go

# how they end: St, roughness, contact number K = k eps a/weight
FALLS = {"damped": (10, 1e-4, 50), "oscillating": (100, 1e-2, 0.2), "bouncing": (100, 1e-2, 50), "mixed": (100, 1e-2, 2)}
# rough spheres that creep down: stiffness, roughnesses
CREEP = {1e3: (0.0, 1e-3, 3e-3, 5e-3, 1e-2, 3e-2), 1e4: (1e-3, 3e-3, 1e-2)}
RANGES = {"cut 0.25": {"reach": 0.25}, "cut 0.5": {"reach": 0.5}, "cut 1": {"reach": 1.0}, "cut 2": {"reach": 2.0},
          "cut 4": {"reach": 4.0}, "shifted 0.5": {"rule": "shifted", "reach": 0.5}, "shifted 1.5": {"rule": "shifted", "reach": 1.5}}
SQUEEZE = "shear no roll no twist no"
FILMS = {"all films": {}, "no rolling film": {"more": "roll no"}, "no twisting film": {"more": "twist no"},
         "no shear film": {"more": "shear no"}, "squeeze film only": {"more": SQUEEZE}, "all films, no rotation": {"motion": "no_spin"},
         "squeeze film only, no rotation": {"more": SQUEEZE, "motion": "no_spin"}}
OUT_RANGES, FILM_RANGES = ("cut 0.25", "cut 0.5", "cut 4"), ("cut 0.5", "cut 4")
STARTS = ((0.2, 0.0), (0.5, 0.0), (0.35, 0.35))
ROUGH = (1e-3, 2e-3, 5e-3, 0.01, 0.02, 0.05, 0.1)
SOFT = (1e-5, 1e-4, 1e-3, 3e-3, 1e-2, 3e-2)
TWO_PI = {"2 pi": (0.01, 0.05, 0.2, 0.5, 1.0), "right": (0.01, 0.2, 0.5, 1.0)}    # offsets
# the map: one run for each Ca, all roughnesses; SciPy at some of the points
MAP_CA, MAP_EPS, MAP_OFFSET, MAP_STOKES = np.logspace(-5, -1, 9), (0.0, 1e-3, 3e-3, 6e-3, 0.01, 0.02, 0.05, 0.1), 0.01, 3e-4
MAP_SCIPY = [(MAP_CA[n], eps) for n, eps in ((0, 0.0), (0, 0.1), (2, 0.01), (4, 0.0), (4, 0.02), (6, 0.05), (8, 0.0), (8, 0.1))]


def falls():
    for name, (stokes, eps, K) in FALLS.items():
        fall = Fall(stokes, eps, K * pair.WEIGHT / eps, duration=8 * stokes)
        t, un, u = fall.run()
        exact = fall.solve(t)
        for row in zip(t / stokes, un, u, *exact):
            yield dict(zip(("case", "t", "un", "u", "un_scipy", "u_scipy"), (name, *row)))


def creep():
    for k, roughnesses in CREEP.items():
        for eps in roughnesses:
            fall = Fall(0.01, eps, k, rows=96)
            t, _, u = fall.run()
            for row in zip(t, u, fall.viscous(t)):
                yield dict(zip(("k", "eps", "t", "u", "closed_form"), (k, eps, *row)))


def thin(path, x_end=4.0, spacing=0.06):
    """Rows x, y of the part near the other sphere, no nearer than spacing to each other."""
    last = None
    for x, y in zip(path[0], path[1]):
        if abs(x) < x_end and (last is None or np.hypot(x - last[0], y - last[1]) > spacing):
            last = x, y
            yield last


def paths():
    """In the plane of shear."""
    for panel, range_, surfaces in (("smooth", "cut 0.5", {}), ("smooth", "cut 4", {}), ("rough", "cut 0.5", {"eps": 0.05}),
                                    ("rough, friction", "cut 0.5", {"eps": 0.05, "friction": 0.5}), ("soft", "cut 0.5", {"ca": 0.01})):
        settings = {"ca": HARD, **surfaces}
        found = encounters([Encounter(y, **settings) for y in PATHS], stokes=SLOW, **RANGES[range_])
        for offset, passage in zip(PATHS, found):
            for point in thin((passage.x, passage.y)):
                yield dict(zip(("panel", "range", "offset", "x", "y"), (panel, range_, offset, *point)))
    for panel, eps in (("smooth", 0.0), ("rough", 0.05)):
        for offset in PATHS:
            for point in thin(exact_pair.path((-FAR, offset), FAR, eps, fine=True)[0]):
                yield dict(zip(("panel", "range", "offset", "x", "y"), (panel, "exact", offset, *point)))


def off_plane():
    """Starts at 0.5 from the axis; where they come out."""
    angles = np.radians(ANGLES)
    for eps in (0.0, 0.05):
        starts = [(0.5 * np.sin(angle), 0.5 * np.cos(angle)) for angle in angles]
        found = encounters([Encounter(y, z, eps=eps, ca=HARD) for y, z in starts], stokes=SLOW)
        for angle, start, passage in zip(angles, starts, found):
            exact = exact_pair.path((-FAR, *start), FAR, eps)[0][1:, -1]
            yield dict(zip(("angle", "eps", "y", "z", "y_out", "z_out", "y_exact", "z_exact"),
                           (np.degrees(angle), eps, *start, *passage.out, *exact)))


def gap():
    """Smallest gap and streamline behind against the offset, for each range of the films."""
    names = ("films", "offset", "least_gap", "out")
    for films, settings in {**RANGES, "squeeze film only": {"reach": 0.5, "more": SQUEEZE}}.items():
        found = encounters([Encounter(y, ca=HARD) for y in OFFSETS], stokes=SLOW, **settings)
        for offset, passage in zip(OFFSETS, found):
            yield dict(zip(names, (films, offset, passage.least, passage.out[0])))
    for offset in OFFSETS:
        yield dict(zip(names, ("exact", offset, *exact_pair.encounter(-FAR, offset, FAR))))


def two_pi():
    """The films to 4 a as in Yade, with the torque of its script and with the right one, by SciPy."""
    names = ("torque", "offset", "least_gap", "out")
    for torque, model in (("2 pi", pair.TwoPi), ("right", pair.Published)):
        for offset in TWO_PI[torque]:
            least, y, _ = Encounter(offset, ca=HARD).solve(reach=4.0, stokes=SLOW, pair=model)
            yield dict(zip(names, (torque, offset, least, y)))


def out():
    """Streamlines behind of rough and of soft spheres."""
    names = ("films", "offset", "eps", "ca", "least_gap", "out", "exact")
    for films in OUT_RANGES:
        pairs = [Encounter(offset, eps=eps, ca=HARD) for offset in (0.01, 0.2, 0.5) for eps in ROUGH]
        for each, passage in zip(pairs, encounters(pairs, stokes=SLOW, **RANGES[films])):
            exact = exact_pair.leave_contact(each.eps, FAR)    # the exact path comes closer than all of these
            yield dict(zip(names, (films, each.y, each.eps, HARD, passage.least, passage.out[0], exact)))
    for ca in SOFT:
        offsets = (0.01, 0.2, 0.5, 1.0)
        for offset, passage in zip(offsets, encounters([Encounter(y, ca=ca) for y in offsets], stokes=SLOW)):
            yield dict(zip(names, ("cut 0.5", offset, 0.0, ca, passage.least, passage.out[0], offset)))


def films():
    for range_ in FILM_RANGES:
        for name, settings in FILMS.items():
            found = encounters([Encounter(y, z, ca=HARD) for y, z in STARTS], stokes=SLOW, **RANGES[range_], **settings)
            for (y, z), passage in zip(STARTS, found):
                yield dict(zip(("range", "films", "y", "z", "least_gap", "y_out", "z_out"), (range_, name, y, z, passage.least, *passage.out)))
    for y, z in STARTS:
        path, least = exact_pair.path((-FAR, y, z), FAR)
        yield dict(zip(("range", "films", "y", "z", "least_gap", "y_out", "z_out"), ("exact", "exact", y, z, least, *path[1:, -1])))


def residual():
    """Films of range residual with the far field of fix hydro grid, in a cell of 24 a: from x = -3 a to 3 a."""
    for offset, steps in ((0.1, 40000), (0.2, 40000), (0.35, 30000), (0.5, 24000), (0.75, 18000), (1.0, 12000), (1.5, 8000)):
        exact, _ = exact_pair.path((-FAR, offset), FAR, fine=True)
        least = exact_pair.encounter(-FAR, offset, FAR)[0]
        start = np.interp(-3.0, exact[0], exact[1])
        table = pair.lammps(pair.ROOT / "tests" / "decks" / "residual" / "in.pair", pair.HERE, y=start, steps=steps).thermo()
        gaps = table["c_gap"][table["c_gap"] > 0]
        yield dict(zip(("offset", "start", "least_gap", "end", "least_exact"),
                       (offset, start, np.min(gaps), np.interp(3.0, table["v_X"], table["v_Y"]), least)))


def streamline_map():
    """Streamline behind of nearly coaxial spheres against roughness and Ca."""
    for ca in MAP_CA:
        found = encounters([Encounter(MAP_OFFSET, eps=eps, ca=ca) for eps in MAP_EPS], stokes=MAP_STOKES)
        for eps, passage in zip(MAP_EPS, found):
            row = {"ca": ca, "eps": eps, "out": passage.out[0], "scipy": ""}
            if (ca, eps) in MAP_SCIPY:
                row["scipy"] = Encounter(MAP_OFFSET, eps=eps, ca=ca).solve(stokes=MAP_STOKES)[1]
            yield row


PARTS = {"falls": falls, "creep": creep, "paths": paths, "off_plane": off_plane, "gap": gap, "two_pi": two_pi, "out": out,
         "films": films, "residual": residual, "map": streamline_map}


def write(path, rows):
    rows = list(rows)
    with open(path, "w", newline="", encoding="ascii") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows({name: f"{value:.5g}" if isinstance(value, float) else value for name, value in row.items()} for row in rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", default=pair.HERE, type=Path, metavar="FOLDER")
    parser.add_argument("parts", nargs="*", metavar="PART", help=" ".join(PARTS))
    arguments = parser.parse_args()
    for name in arguments.parts or PARTS:
        write(arguments.output / f"{name}.csv", PARTS[name]())
        print(f"wrote {name}.csv", flush=True)


if __name__ == "__main__":
    main()
