"""Spheres at random places of a periodic cell, and data files of them."""
import numpy as np


def random_spheres(rnd, cell, radius, gap=0.0, factor=1.0):
    """Centers, no two nearer than the sum of their radii, times factor, plus gap; columns of cell are its edges."""
    images = np.array([(i, j, k) for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1)]) @ cell.T
    x = np.zeros((0, 3))
    while len(x) < len(radius):
        new, r = cell @ rnd.random(3), radius[len(x)]
        far = np.linalg.norm(new - x[:, None] + images, axis=2).min(axis=1, initial=np.inf)
        if np.all(far > factor * (r + radius[:len(x)]) + gap):
            x = np.vstack([x, new])
    return x


def write_spheres(name, cell, x, radius, v, w, density=1e4, triclinic=False):
    """A data file of atom_style sphere, with velocities and spins."""
    a, b, c = np.diag(cell)
    xy, xz, yz = cell[0, 1], cell[0, 2], cell[1, 2]

    def words(values):
        return " ".join(f"{value:.17g}" for value in values)
    with open(name, "w", encoding="ascii") as file:
        file.write(f"spheres\n\n{len(x)} atoms\n1 atom types\n0 {a:.17g} xlo xhi\n0 {b:.17g} ylo yhi\n0 {c:.17g} zlo zhi\n")
        if triclinic or np.any([xy, xz, yz]):
            file.write(f"{xy} {xz} {yz} xy xz yz\n")
        file.write("\nAtoms # sphere\n\n")
        for n, (p, r) in enumerate(zip(x, radius)):
            file.write(f"{n + 1} 1 {2 * r:.17g} {density} {words(p)}\n")
        file.write("\nVelocities\n\n")
        for n, (p, q) in enumerate(zip(v, w)):
            file.write(f"{n + 1} {words((*p, *q))}\n")
