"""Spheres that do not overlap in a periodic cell, columns of cell its edges; and their data file for LAMMPS."""
import numpy as np


def images(cell):
    """Of the cell itself and its 26 neighbors."""
    return np.array([(i, j, k) for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1)]) @ cell.T


def added_in_turn(rnd, cell, radius, gap=0.02):
    """Centers, one after the other at random places; smallest gap over the mean radius of a pair, over 2."""
    x, around = [], images(cell)
    while len(x) < len(radius):
        new, r = cell @ rnd.random(3), radius[len(x)]
        if all(np.min(np.linalg.norm(new - old + around, axis=1)) > (1 + gap) * (r + s) for old, s in zip(x, radius)):
            x.append(new)
    return np.array(x)


def cell_of(edges, tilts=(0, 0, 0)):
    """Edges along x, in the plane xy, and above it."""
    return np.array([[edges[0], tilts[0], tilts[1]], [0, edges[1], tilts[2]], [0, 0, edges[2]]], dtype=float)


def write_spheres(name, cell, x, radius, v=None, w=None, density=1.0, order=None, triclinic=False):
    """A data file; order: lines in which the spheres appear. Ids are those of the arrays, from 1. triclinic: also without tilt."""
    def text(*numbers):
        return " ".join(f"{number:.17g}" for number in numbers)

    order = range(len(x)) if order is None else order
    with open(name, "w", encoding="ascii") as file:
        file.write(f"spheres\n\n{len(x)} atoms\n1 atom types\n")
        for n, axis in enumerate("xyz"):
            file.write(f"0 {cell[n, n]:.17g} {axis}lo {axis}hi\n")
        if triclinic or np.any(cell != np.diag(np.diag(cell))):
            file.write(text(cell[0, 1], cell[0, 2], cell[1, 2]) + " xy xz yz\n")
        file.write("\nAtoms # sphere\n\n")
        for n in order:
            file.write(f"{n + 1} 1 {text(2 * radius[n], density, *x[n])}\n")
        if v is not None:
            file.write("\nVelocities\n\n")
            for n in order:
                file.write(f"{n + 1} {text(*v[n], *w[n])}\n")


def equilibrium(rnd, number, phi, sweeps=1000):
    """Hard spheres of radius 1 by Monte Carlo in a cube, compressed from a volume fraction of 0.25; edge and centers."""
    volume = 4 / 3 * np.pi * number
    edge, last = (volume / min(phi, 0.25)) ** (1 / 3), (volume / phi) ** (1 / 3)
    x, step, done = added_in_turn(rnd, edge * np.eye(3), np.ones(number), 0.0), 0.5, 0
    while done < sweeps:
        accepted = 0
        for n, move in zip(rnd.integers(0, number, number), step * rnd.uniform(-1, 1, (number, 3))):
            new = x[n] + move
            d = x - new
            d -= edge * np.round(d / edge)
            r2 = np.einsum("na,na->n", d, d)
            r2[n] = 9
            if np.min(r2) > 4:
                x[n] = new
                accepted += 1
        step = min(edge / 4, max(0.02, step * (1.05 if accepted > 0.4 * number else 0.95)))
        if edge > last:
            d = x[:, None] - x
            d -= edge * np.round(d / edge)
            r = np.linalg.norm(d, axis=2)[np.triu_indices(number, 1)]
            new = max(last, edge * max(2.0000001 / np.min(r), 0.99))
            x, edge = x * (new / edge), new
        else:
            done += 1
    return edge, x - edge * np.floor(x / edge)
