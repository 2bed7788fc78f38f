# ranks: 1 4
"""The films of range voronoi join the pairs that share a face of the radical tessellation, and no others.

Oracle: the lower convex hull of the periodic images lifted to |x|^2 - R^2 (SciPy), for equal spheres Delaunay's
triangulation. Mirror images stand for a boundary that is not periodic.
"""
import itertools
from pathlib import Path

import numpy as np
from scipy.spatial import ConvexHull, Delaunay

import deck

EPS = 0.01


def images(found, x, dim, walls):
    """Positions and owner of the particles and of all their images near the cell."""
    cell = np.diag([found["lx"], found["ly"], found["lz"]])[:dim, :dim]
    cell[1, 0] = found["xy"]
    shifts = [range(-2, 3) if d == 0 else (0,) if d == 1 and walls else range(-1, 2) for d in range(dim)]
    copies = [x + np.array(n) @ cell for n in itertools.product(*shifts)]
    if walls:
        copies = [c for copy in copies for c in (copy, *(np.column_stack([copy[:, 0], 2 * found[w] - copy[:, 1], copy[:, 2:]])
                                                         for w in ("ylo", "yhi")))]
    points = np.vstack(copies)
    owner = np.tile(np.arange(len(x)), len(copies))
    near = np.all((points > x.min(axis=0) - 6.5) & (points < x.max(axis=0) + 6.5), axis=1)
    real = np.zeros(len(points), dtype=bool)
    n = next(k for k, c in enumerate(copies) if c is x or np.array_equal(c, x))
    real[n * len(x):(n + 1) * len(x)] = True
    return points[near], owner[near], real[near]


def edges(points, radius):
    """Pairs of points that share a face: edges of the regular triangulation."""
    if np.ptp(radius) == 0:
        simplices = Delaunay(points).simplices
    else:
        hull = ConvexHull(np.column_stack([points, np.sum(points**2, axis=1) - radius**2]))
        simplices = hull.simplices[hull.equations[:, -2] < 0]
    pairs = np.vstack([simplices[:, list(two)] for two in itertools.combinations(range(simplices.shape[1]), 2)])
    return np.unique(np.sort(pairs, axis=1), axis=0)


def faces(found, atoms, dim=3, walls=False):
    """Pairs of IDs that share a face, with the distance of the centers."""
    x = np.column_stack([atoms["x"], atoms["y"], atoms["z"]])[:, :dim]
    points, owner, real = images(found, x, dim, walls)
    shared = {}
    for a, b in edges(points, atoms["radius"][owner]):
        if real[a] or real[b]:
            pair = tuple(sorted((int(atoms["id"][owner[a]]), int(atoms["id"][owner[b]]))))
            r = np.linalg.norm(points[a] - points[b])
            shared[pair] = min(r, shared.get(pair, r))
    return shared


def pairs_of(name):
    """Dict of IDs -> values of compute pair/local, from the last frame of its dump."""
    lines = Path(name).read_text().splitlines()
    start = max(n for n, line in enumerate(lines) if line.startswith("ITEM: ENTRIES"))
    rows = np.array([line.split() for line in lines[start + 1:]], dtype=float)
    return {tuple(sorted((int(r[0]), int(r[1])))): r[2:] for r in rows}


def judge(what, hc, dim=3, walls=False, ghosts=0.0, **variables):
    """Runs the deck and compares the pairs that act with those that should."""
    run = deck.run("in.voronoi", hc=hc, dim=dim, ghosts=ghosts, walls="yes" if walls else "no", **variables)
    atoms = deck.read_dump("atoms.dump")
    cutoff = float(run.text.split("ghost atom cutoff = ")[1].split()[0])
    deck.expect(f"{what}: ghosts out to five radii", cutoff >= max(ghosts, 5 * atoms["radius"].max()) * (1 - 1e-6), str(cutoff))
    shared = faces(run.values, atoms, dim, walls)
    radius = dict(zip(atoms["id"].astype(int), atoms["radius"]))
    acting, expected, screened = set(), set(), 0
    for (i, j), (un, *forces) in pairs_of("pairs.dump").items():
        a = 2 * radius[i] * radius[j] / (radius[i] + radius[j])
        face = (i, j) in shared and shared[i, j] < radius[i] + radius[j] + un + 1e-3
        if np.any(np.abs(forces) > 1e-10):    # beyond rounding
            acting.add((i, j))
        if un < EPS * a or (face and un < hc * a):
            expected.add((i, j))
        screened += not face and un < hc * a
    shown = f"{len(expected)} pairs, {screened} screened; wrong: {sorted(acting ^ expected)[:6]}"
    deck.expect(f"{what}: the pairs of the tessellation, hc {hc}", acting == expected, shown)
    deck.expect("  and some are screened", screened > 10, str(screened))
    return acting


deck.make_state()
reference = judge("unequal spheres", 1.5)
deck.expect("newton off: the same pairs", reference == judge("newton off", 1.5, newton="off"))
judge("a tilted cell", 1.5, tilt=0.45)
judge("sizes of 1 to 3", 2.0, shrink=0.6, ghosts=8.0)
deck.make_state(shape="orthogonal")
judge("between walls", 1.5, walls=True)
deck.make_state(dim=2, phi=0.75)
judge("in 2d", 1.5, dim=2)

# three spheres screen two others, then give way while the list stays as it is: the two act when they touch
for what, steps, every, gap, contact, film in (("screened", 400, 100000, 0.2, 0, 0), ("a new list", 400, 1, 0.2, 0, 45),
                                               ("touching", 520, 100000, -0.04, 65, 374)):
    deck.run("in.touch", steps=steps, every=every)
    deck.expect_close(what + ": gap, contact force, film force", pairs_of("touch.dump")[1, 2], [gap, contact, film],
                      rtol=0.02, atol=1e-3)

text = deck.run("in.lattice").text
deck.expect("simple cubic: 6 faces a sphere, no ties", " 648 pairs in range" in text)

# two spheres far apart, half screened by a third, next to a boundary: what is beyond decides
text = deck.run("in.void", cutoff=0.0, fails=True).text
deck.expect("voids: the error names the cure", "between atoms" not in text and "use: comm_modify cutoff" in text)
beyond = deck.run("in.void", cutoff=0.0, third=18.5, fails=True).text
deck.expect("  also if all of the face is beyond the ghosts", "use: comm_modify cutoff" in beyond)
cure = float(text.split("use: comm_modify cutoff")[1].split()[0])
for y, pairs in ((5.0, 4), (12.0, 3)):
    text = deck.run("in.void", cutoff=cure, y=y).text
    deck.expect(f"  which works: {pairs} pairs, the fourth sphere at {y}", f" {pairs} pairs in range" in text)

reach = {}
for first in ("cut", "voronoi"):
    text = deck.run("in.after", first=first).text
    reach[first] = [float(line.split()[1]) for line in text.splitlines() if line.startswith("Nghost:")]
deck.expect("ghost atoms reach farther for range voronoi", reach["voronoi"][0] > reach["cut"][0], reach)
deck.expect("and no farther for another range afterwards", reach["voronoi"][1] == reach["cut"][1], reach)
deck.finish()
