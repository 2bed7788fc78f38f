"""Spheres at random places of a periodic cell, and data files of them."""
import numpy as np


def cell_of(edges, tilts=(0, 0, 0)):
    """Columns are the edges: along x, in the plane xy, and above it."""
    return np.array([[edges[0], tilts[0], tilts[1]], [0, edges[1], tilts[2]], [0, 0, edges[2]]], dtype=float)


def images(cell):
    """Of the cell itself and its 26 neighbors."""
    return np.array([(i, j, k) for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1)]) @ cell.T


def random_spheres(rnd, cell, radius, gap=0.0, factor=1.0):
    """Centers, no two nearer than the sum of their radii, times factor, plus gap; columns of cell are its edges."""
    x, around = np.zeros((0, 3)), images(cell)
    while len(x) < len(radius):
        new, r = cell @ rnd.random(3), radius[len(x)]
        far = np.linalg.norm(new - x[:, None] + around, axis=2).min(axis=1, initial=np.inf)
        if np.all(far > factor * (r + radius[:len(x)]) + gap):
            x = np.vstack([x, new])
    return x


def write_spheres(name, cell, x, radius, v, w, density=1e4, triclinic=False, order=None):
    """A data file of atom_style sphere, with velocities and spins; order: that of the lines."""
    order = range(len(x)) if order is None else order
    a, b, c = np.diag(cell)
    xy, xz, yz = cell[0, 1], cell[0, 2], cell[1, 2]

    def words(values):
        return " ".join(f"{value:.17g}" for value in values)
    with open(name, "w", encoding="ascii") as file:
        file.write(f"spheres\n\n{len(x)} atoms\n1 atom types\n0 {a:.17g} xlo xhi\n0 {b:.17g} ylo yhi\n0 {c:.17g} zlo zhi\n")
        if triclinic or np.any([xy, xz, yz]):
            file.write(f"{xy} {xz} {yz} xy xz yz\n")
        file.write("\nAtoms # sphere\n\n")
        for n in order:
            file.write(f"{n + 1} 1 {2 * radius[n]:.17g} {density} {words(x[n])}\n")
        file.write("\nVelocities\n\n")
        for n in order:
            file.write(f"{n + 1} {words((*v[n], *w[n]))}\n")


def equilibrium(rnd, number, phi, sweeps=1000):
    """Hard spheres of radius 1 by Monte Carlo in a cube, compressed from a volume fraction of 0.25; edge and centers."""
    volume = 4 / 3 * np.pi * number
    edge, last = (volume / min(phi, 0.25)) ** (1 / 3), (volume / phi) ** (1 / 3)
    x, step, done = random_spheres(rnd, edge * np.eye(3), np.ones(number)), 0.5, 0
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
