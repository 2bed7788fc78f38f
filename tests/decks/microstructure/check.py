# ranks: 1 4
"""Every number of compute microstructure, again from the pairs that LAMMPS dumps, in 3d and 2d, newton on and off."""
from pathlib import Path

import numpy as np

import deck

MU = 0.5


def last_block(name, rows):
    """The last block of a file of fix ave/time mode vector, without the row numbers."""
    return np.array([line.split()[1:] for line in Path(name).read_text().splitlines()[-rows:]], dtype=float)


class Pairs:
    """All pairs of the last dump, with everything that can be computed from positions and compute pair/local."""

    def __init__(self, result, dim, mu):
        atoms = deck.read_dump("atoms.yes")
        lines = Path("pairs.dump").read_text().splitlines()
        start = max(n for n, line in enumerate(lines) if line.startswith("ITEM: ENTRIES"))
        rows = np.array([line.split()[1:] for line in lines[start + 1:]], dtype=float)
        # compute pair/local goes to the largest range of the pair of types
        radii = np.array([atoms["radius"][rows[:, m].astype(int) - 1] for m in (0, 1)])
        rows = rows[rows[:, 3] < 0.5 * 2 * radii[0] * radii[1] / (radii[0] + radii[1])]
        i, j = rows[:, 0].astype(int) - 1, rows[:, 1].astype(int) - 1
        self.u, self.un, self.contact, self.film = rows[:, 2], rows[:, 3], rows[:, 4], rows[:, 5]
        shear, state = rows[:, 6:9], rows[:, 9]
        x = np.array([atoms[c] for c in "xyz"]).T
        v = np.array([atoms["v" + c] for c in "xyz"]).T
        box = result.values
        d, dv = x[i] - x[j], v[i] - v[j]
        # nearest image in the sheared cell; an image above moves faster by rate ly
        if dim == 3:
            d[:, 2] -= box["lz"] * np.rint(d[:, 2] / box["lz"])
        turns = np.rint(d[:, 1] / box["ly"])
        d[:, 1] -= box["ly"] * turns
        d[:, 0] -= box["xy"] * turns
        dv[:, 0] -= 1.0 * box["ly"] * turns
        d[:, 0] -= box["lx"] * np.rint(d[:, 0] / box["lx"])
        self.i, self.j, self.d = i, j, d
        r = np.linalg.norm(d, axis=1)
        self.n = d / r[:, None]
        self.vn = np.sum(dv * self.n, axis=1)
        self.vt = np.linalg.norm(dv - self.vn[:, None] * self.n, axis=1)
        self.touch = state > 0
        self.rubs = self.touch & (mu > 0)
        self.slides = self.rubs & (state == 2)
        size = np.linalg.norm(shear, axis=1)
        cone = np.where(self.touch, mu * self.contact, 0.0)
        self.friction = np.minimum(size, cone)
        held = np.where(size > 0, self.friction / np.where(size > 0, size, 1), 1.0 * (cone > 0))[:, None] * shear
        self.mobilized = self.friction[self.rubs] / cone[self.rubs]
        self.held = held
        self.force = (self.contact[:, None] * self.n, held, self.film[:, None] * self.n, shear - held)
        self.N = len(x)
        self.volume = box["lx"] * box["ly"] * (box["lz"] if dim == 3 else 1.0)


def mean(a):
    return float(np.mean(a)) if len(a) else 0.0


def check_averages(case, p, particles):
    of_each = np.bincount(np.concatenate([p.i[p.touch], p.j[p.touch]]), minlength=p.N)[:particles]
    contacts, frictional, films = p.touch.sum(), p.rubs.sum(), (~p.touch).sum()
    carrying = of_each >= 2
    expected = [2 * contacts / particles, 2 * contacts / particles, mean(of_each[carrying]), 1 - mean(carrying),
                2 * frictional / particles, frictional / contacts, mean(p.slides[p.rubs]), 2 * films / particles,
                mean(p.u[~p.touch]), p.u.min(), mean(p.contact[p.touch]), p.contact.max(), mean(p.friction[p.rubs]),
                mean(p.mobilized), max(0, (p.u - p.un).max()), max(0, (-p.un).max())]
    got = np.loadtxt("m.txt")[-1, 1:]
    names = ("scalar Z|Z|Z of those that carry|rattlers|Z_f|chi_f|sliding|films|film gap|smallest gap|<f>|largest f|"
             "<friction>|mobilized|deflection|overlap").split("|")
    for name, a, b in zip(names, got, expected):
        deck.expect_close(f"{case} {name}", a, b, rtol=1e-11, atol=1e-14)


def check_fabric(case, p):
    components = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))

    def average(weight, other=None, norm=None):
        other = p.n if other is None else other
        products = [(weight * 0.5 * (p.n[:, a] * other[:, b] + p.n[:, b] * other[:, a])).sum() for a, b in components]
        norm = weight.sum() if norm is None else norm
        return np.array(products) / norm if norm else np.zeros(6)

    f = np.where(p.touch, p.contact, 0.0)
    expected = [average(1.0 * p.touch), average(1.0 * p.rubs), average(1.0 * ~p.touch), average(f),
                average(np.ones(len(f)), p.held, f.sum())]
    deck.expect_close(f"{case} fabric", last_block("fabric.txt", 5), expected, atol=1e-12)


def check_forces(case, p):
    columns, shares = [], []
    for f in (p.contact[p.touch], p.friction[p.rubs]):
        x = f / mean(f) if len(f) and mean(f) else f
        counts, edges = np.histogram(x, 12, (0, 1.5))
        columns.append(counts / (max(1, len(x)) * (edges[1] - edges[0])))
        shares.append((x >= 1.5).mean() if len(x) else 0)
    got = last_block("forces.txt", 12)
    deck.expect_close(f"{case} forces: bins", got[:, 0], 0.5 * (edges[1:] + edges[:-1]), rtol=1e-14)
    deck.expect_close(f"{case} forces: densities", got[:, 1:], np.array(columns).T, rtol=1e-11)
    deck.expect_close(f"{case} forces: numbers", np.loadtxt("numbers.txt")[-1, 1:],
                      [p.touch.sum(), mean(p.contact[p.touch]), 0, shares[0], p.rubs.sum(), mean(p.friction[p.rubs]),
                       shares[1]], rtol=1e-11)
    deck.expect(f"{case} forces: some are outside", shares[0] > 0)


def check_directions(case, name, p, axes, bins, stress, particles, band=1.0):
    """bins = (azimuths,) or (heights, azimuths); axes: first and second of the plane, normal."""
    n = np.where(p.n[:, axes[1], None] < 0, -p.n, p.n)[:, axes]
    azimuth = np.arctan2(n[:, 1], n[:, 0])
    inside = np.abs(n[:, 2]) <= band
    if len(bins) == 1:
        coordinates, edges = (azimuth,), (np.linspace(0, np.pi, bins[0] + 1),)
        measure = 2 * np.pi / bins[0]
    else:
        coordinates = (np.arccos(n[:, 2]), azimuth)
        edges = (np.arccos(np.linspace(-1, 1, bins[0] + 1))[::-1], np.linspace(0, np.pi, bins[1] + 1))
        measure = 4 * np.pi / np.prod(bins)

    def sums(values):
        found = np.histogramdd(np.array(coordinates).T[inside], edges, weights=values[inside])[0]
        return (found[::-1] if len(bins) == 2 else found).ravel() / measure

    ones = np.ones(len(azimuth))
    columns = [2 / particles * sums(v) for v in (ones, 1.0 * p.touch, 1.0 * p.rubs, p.u, p.contact * p.touch,
                                                 p.friction, p.vn, p.vt)]
    columns += [-sums(p.d[:, stress[0]] * f[:, stress[1]]) / p.volume for f in p.force]
    got = last_block(name + ".txt", int(np.prod(bins)))[:, len(bins):]
    columns += [np.zeros(len(got))] * (got.shape[1] - len(columns))    # origins that do not act here
    for m, column in enumerate(columns):
        deck.expect_close(f"{case} {name} {m}", got[:, m], column, atol=2e-11 * np.abs(column).max() + 1e-15)
    coordinate = last_block(name + ".txt", int(np.prod(bins)))[:, len(bins) - 1]
    deck.expect_close(f"{case} {name} azimuth", coordinate[:bins[-1]], (np.arange(bins[-1]) + 0.5) * np.pi / bins[-1],
                      rtol=1e-14)
    return got[:, 8:].sum(axis=0) * measure


def check_case(dim=3, group="all", friction=f"coulomb {MU}", **variables):
    result = deck.run("in.microstructure", dim=dim, group=group, friction=friction, **variables)
    case = " ".join([f"{dim}d", group, friction] + list(variables.values()))
    p = Pairs(result, dim, 0.0 if friction == "none" else MU)
    particles = p.N if group == "all" else p.N // 2
    check_averages(case, p, particles)
    check_fabric(case, p)
    check_forces(case, p)
    whole = {"angle": (1, check_directions(case, "angle", p, (0, 1, 2), (16,), (0, 1), particles))}
    if dim == 3:
        check_directions(case, "xz", p, (0, 2, 1), (8,), (0, 2), particles, band=0.4)
        whole["sphere"] = (2, check_directions(case, "sphere", p, (0, 1, 2), (6, 8), (1, 0), particles))
        whole["yz"] = (0, check_directions(case, "yz", p, (1, 2, 0), (4, 6), (0, 0), particles))
    if group == "all":
        parts = np.delete(last_block("s.txt", len(whole["angle"][1]) + 3), (4, 6, 7), axis=0)    # without inertia, pores, stresslets
        for name, (column, sums) in whole.items():
            for channel, (got, expected) in enumerate(zip(sums, parts[:, column])):
                deck.expect_close(f"{case} {name} stress of origin {channel + 1}", got, expected,
                                  atol=1e-13 * np.abs(parts).max())
    return np.loadtxt("m.txt")[-1, 1:]


deck.make_state()
state = Path("state.data")
state.write_text(state.read_text().replace("1 atom types", "2 atom types"))    # the second is for hybrid
base = check_case()
tables = {"m.txt": 1, "fabric.txt": 5, "forces.txt": 12, "angle.txt": 16, "sphere.txt": 48}
single = {name: last_block(name, rows) for name, rows in tables.items()}
deck.expect("enough contacts to mean something", base[0] > 1, f"Z = {base[0]}")
# the computes change nothing
deck.run("in.microstructure", watch="no")
watched, alone = Path("atoms.yes").read_text(), Path("atoms.no").read_text()
deck.expect("bit for bit the run without computes", watched == alone)

off = check_case(newton="off")
deck.expect_close("newton on and off agree", off, base, rtol=1e-8, atol=1e-14)
deck.expect("and so do the counts", np.array_equal(off[:2], base[:2]))
check_case(group="half")
check_case(newton="off", group="half")
deck.run("in.microstructure", way="hybrid")
for name, rows in tables.items():
    deck.expect_close(f"two sub-styles of hybrid agree with the style alone: {name}", last_block(name, rows),
                      single[name], rtol=1e-7, atol=1e-12 * np.abs(single[name]).max())
frictionless = check_case(friction="none")
deck.expect("without friction chi_f = 0", frictionless[0] > 0 and frictionless[5] == 0.0)

deck.make_state(dim=2, phi=0.75)
check_case(dim=2)
deck.finish()
