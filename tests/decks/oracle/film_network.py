"""A suspension as a linear network, by linear algebra: the reference of the decks in which strains or inertia are tiny.

At a frozen configuration each film is a dashpot, in series with its spring. With v_i, w_i velocities and spins relative to the
flow (rate y, 0, 0), proportional to exp(i omega t), for each pair at the separation u (n from j to i, s = R + u/2):
    F = -Zn vn n - Zt vt,   T_i = -s_i n x (-Zt vt) - Zr w_roll - Zw w_twist n
    Z = resistance*spring/(spring + i omega resistance)
    v_rel = rate r_y ex + v_i - v_j,   vt = v_rel - vn n - (s_i w_i + s_j w_j - (s_i + s_j) rate/2 ez) x n
and -F, -s_j n x (-Zt vt) + ... on j. Newton's equations, or the balance with drag, of all particles are one complex
linear system, at omega = 0 that of Stokes flow; the stress is -sum r_x F_y/V.
"""
from dataclasses import dataclass

import numpy as np

EX, EZ = np.eye(3)[0], np.eye(3)[2]


def cross(n):
    return np.array([[0, -n[2], n[1]], [n[2], 0, -n[0]], [-n[1], n[0], 0]])


@dataclass
class Network:
    state: dict       # columns x y z radius mass
    box: tuple        # lx ly lz xy
    eta: float = 1.0
    g: float = 1e3
    kt: float = 5e2
    reach: float = 0.5    # of the films over a
    drag: float = 0       # of Stokes on particles with fewer partners, towards the flow, in place of inertia

    def resistances(self, u, a):
        """Of squeeze, shear, roll and twist (Chevremont; Frankel & Acrivos; Jeffrey & Onishi)."""
        log = np.log(a / u) if u < a else 0.0
        pi_eta = np.pi * self.eta
        return (1.5 * pi_eta * a * a / u, 0.5 * pi_eta * ((2 * a + u) * np.log((2 * a + u) / u) - 2 * a),
                pi_eta * a**3 * (0.6 + 0.504 * u / a) * log, pi_eta * a * a * u * log)

    def impedances(self, u, a, omega):
        springs = (self.g, self.kt, self.kt * a * a, self.kt * a * a)
        return [R * k / (k + 1j * omega * R) for R, k in zip(self.resistances(u, a), springs)]

    def pairs(self):
        lx, ly, lz, xy = self.box
        x, radius = np.array([self.state[c] for c in "xyz"]).T, self.state["radius"]
        for i in range(len(x)):
            d = x[i] - x[:i]
            d[:, 2] -= lz * np.round(d[:, 2] / lz)
            turns = np.round(d[:, 1] / ly)
            d[:, 1] -= ly * turns
            d[:, 0] -= xy * turns
            d[:, 0] -= lx * np.round(d[:, 0] / lx)
            u = np.linalg.norm(d, axis=1) - radius[i] - radius[:i]
            a = 2 * radius[i] * radius[:i] / (radius[i] + radius[:i])
            for j in np.flatnonzero(u < self.reach * a):
                yield i, j, d[j], d[j] / np.linalg.norm(d[j]), u[j], a[j], radius[i] + u[j] / 2, radius[j] + u[j] / 2

    def partners(self):
        number = np.zeros(len(self.state["x"]), dtype=int)
        for i, j, *_ in self.pairs():
            number[[i, j]] += 1
        return number

    def stress(self, omega=0.0):
        """sigma_xy of squeeze and shear films over the rate, complex."""
        count = len(self.state["x"])
        floating = np.eye(6 * count, dtype=complex) * 1e-10 * self.eta    # holds what floats freely
        if self.drag:
            radius = self.state["radius"]
            coefficients = np.stack([6 * np.pi * self.eta * radius, 8 * np.pi * self.eta * radius**3], 1)
            coefficients[self.partners() >= self.drag] = 0
            A = floating + np.diag(np.repeat(coefficients, 3, axis=1).ravel())
        elif omega > 0:
            inertia = np.stack([self.state["mass"], 0.4 * self.state["mass"] * self.state["radius"]**2], 1)
            A = np.diag(1j * omega * np.repeat(inertia, 3, axis=1).ravel())
        else:
            A = floating
        b, found = np.zeros(6 * count, complex), []
        for i, j, r, n, u, a, si, sj in self.pairs():
            zn, zt, zr, zw = self.impedances(u, a, omega)
            P, Q, C, zero = np.outer(n, n), np.eye(3) - np.outer(n, n), cross(n), np.zeros((3, 3))
            # velocities = matrix @ (v_i, w_i, v_j, w_j) + that of the flow at rate 1; w x n = -C w
            squeeze, squeeze0 = -zn * np.hstack([P, zero, -P, zero]), -zn * r[1] * (P @ EX)
            shear = -zt * np.hstack([Q, si * C, -Q, sj * C])
            shear0 = -zt * (r[1] * (Q @ EX) + 0.5 * (si + sj) * np.cross(EZ, n))
            couple = -(zr * Q + zw * P) @ np.hstack([zero, np.eye(3), zero, -np.eye(3)])
            rows = np.concatenate([np.arange(6 * i, 6 * i + 6), np.arange(6 * j, 6 * j + 6)])
            force, force0 = squeeze + shear, squeeze0 + shear0
            A[np.ix_(rows, rows)] -= np.vstack([force, -si * C @ shear + couple, -force, -sj * C @ shear - couple])
            b[rows] += np.concatenate([force0, -si * C @ shear0, -force0, -sj * C @ shear0])
            found.append((rows, r[0], squeeze[1], squeeze0[1], shear[1], shear0[1]))
        motion = np.linalg.solve(A, b)
        volume = self.box[0] * self.box[1] * self.box[2]
        return np.array([-sum(rx * (f @ motion[rows] + f0) for rows, rx, f, f0, _, _ in found),
                         -sum(rx * (s @ motion[rows] + s0) for rows, rx, _, _, s, s0 in found)]) / volume
