"""Equal spheres without inertia, friction and contact in a periodic cell: far field and residual films, radius and viscosity 1."""
import numpy as np

from oracle import far_field, residual_film
from oracle.spheres import images


def pairs_within(cell, x, reach):
    """i, j and x_i - x_j of all pairs with gaps below reach, images of one sphere included."""
    around, found = images(cell), []
    for i in range(len(x)):
        for j in range(i):
            for d in x[i] - x[j] + around:
                if np.linalg.norm(d) < 2 + reach:
                    found.append((i, j, d))
        for d in around[len(around) // 2 + 1:]:
            if np.linalg.norm(d) < 2 + reach:
                found.append((i, i, d))
    return found


def add_films(form, cell, x, reach):
    """To a form of velocities, spins and strains: twice the dissipation of the films with gaps up to reach."""
    films, n = residual_film.Films(), len(x)
    form = form.reshape(n, 11, n, 11)
    total = np.zeros((6 * n + 5, 6 * n + 5))
    total[:6 * n, :6 * n] = form[:, :6, :, :6].reshape(6 * n, 6 * n)
    # all spheres have minus the strain of the flow
    total[:6 * n, 6 * n:] = -form[:, :6, :, 6:].sum(axis=2).reshape(6 * n, 5)
    total[6 * n:, :6 * n] = total[:6 * n, 6 * n:].T
    total[6 * n:, 6 * n:] = form[:, 6:, :, 6:].sum(axis=(0, 2))
    for i, j, d in pairs_within(cell, x, reach):
        r = np.linalg.norm(d)
        normal, f = d / r, films(r - 2)
        across, cross = np.eye(3) - np.outer(normal, normal), np.einsum("abc,c->ab", far_field.EPS, normal)    # cross w = w x n
        v, slip, turn = (np.zeros((3, 6 * n + 5)) for _ in range(3))
        for k, sign in ((i, 1), (j, -1)):
            v[:, 6 * k:6 * k + 3] += sign * np.eye(3)
            slip[:, 6 * k + 3:6 * k + 6] -= 0.5 * r * cross
            turn[:, 6 * k + 3:6 * k + 6] += sign * np.eye(3)
        strain = np.zeros((3, 6 * n + 5))    # E.n
        strain[:, 6 * n:] = np.einsum("pab,b->ap", far_field.BASIS, normal)
        v += r * strain
        slip = across @ (slip + v)
        w, e, t = normal @ v, normal @ strain, across @ strain
        rho = cross @ turn
        spin = normal @ turn
        total += f["A"] * np.outer(w, w) - f["b"] * (np.outer(w, e) + np.outer(e, w)) + f["C"] * np.outer(e, e)
        total += f["As"] * slip.T @ slip - f["bs"] * (slip.T @ t + t.T @ slip) + f["Cs"] * t.T @ t
        total += f["Rr"] * rho.T @ rho + f["Tw"] * np.outer(spin, spin)
    return total


class Dispersion:
    """Velocities and spins relative to the flow, 6 of each sphere, then 5 numbers of the strain: twice the dissipation."""

    def __init__(self, cell, x, reaches, smallest=1e-11):
        resistance = np.linalg.inv(far_field.mobility(cell, x, np.ones(len(x)), smallest))
        self.volume, self.n = np.linalg.det(cell), len(x)
        self.forms = [add_films(resistance, cell, x, reach) for reach in reaches]

    def viscosities(self):
        """Matrix of 5 by 5 for each reach: stress of free spheres over twice the strain, fluid included."""
        k = 6 * self.n
        return [np.eye(5) + (f[k:, k:] - f[k:, :k] @ np.linalg.solve(f[:k, :k], f[:k, k:])) / (2 * self.volume) for f in self.forms]

    def films(self):
        """What is of the films in each of these matrices; forms must begin with one without films."""
        found, k = [], 6 * self.n
        for f in self.forms:
            motion = np.vstack([-np.linalg.solve(f[:k, :k], f[:k, k:]), np.eye(5)])
            found.append(((f - self.forms[0]) @ motion)[k:] / (2 * self.volume))
        return found

    def mobilities(self):
        """Velocities and spins for forces and torques, n by 6 by n by 6, for each reach."""
        k = 6 * self.n
        return [np.linalg.inv(f[:k, :k]).reshape(self.n, 6, self.n, 6) for f in self.forms]

    def motions(self):
        """For each reach, over that of a sphere alone: velocity of all under equal forces, mean over directions; of one that
        is pushed alone; spin of one that is twisted alone."""
        found = []
        for m in self.mobilities():
            settling = np.trace(m[:, :3, :, :3].sum(axis=(0, 2))) / (3 * self.n)
            one = [np.einsum("nana->", m[:, part, :, part]) / (3 * self.n) for part in (slice(0, 3), slice(3, 6))]
            found.append((6 * np.pi * settling, 6 * np.pi * one[0], 8 * np.pi * one[1]))
        return found
