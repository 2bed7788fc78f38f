#!/usr/bin/python3
"""Writes pair_residual_reference.h: residual films of a pair on a prescribed way, by SciPy.

From the form of the dissipation in lubcontact_residual.h itself, Phi(w, s, sigma; E): here no variable is eliminated from it.
In series with the films are springs: g of the bulk for the gap u, kt for the displacement q of the place where the force of
the shear film acts, kt a^2 for the rolling p and the twist. The rates of the films are those for which the derivatives of Phi
are the forces of the springs; force, couples and stresslet are derivatives of Phi at these rates, the heat is 2 Phi. Histories
turn with the pair: with the tilt of n and the mean spin about it.
"""
import math
import os
import re

import numpy as np
from scipy.integrate import solve_ivp

HERE = os.path.dirname(os.path.abspath(__file__))
NAMES = ["squeeze", "push", "stretch", "shear", "slide", "extend", "roll", "lever", "twist", "turn"]
ETA, G, KT, ALPHA = 0.7, 60.0, 25.0, 1.3
E = np.array([[0.3, 0.5, -0.2], [0.5, 0.1, 0.25], [-0.2, 0.25, -0.4]])
END, ROWS = 4.0, 4
CASES = [    # radii of i and j, gap at the middle and its swing over a, height of asperities over a
    (0.6, 1.2, 0.55, 0.4, 0.0), (1.1, 0.8, 0.05, 0.1, 0.04), (1.0, 1.0, 0.5, 0.3, 0.0), (1.3, 0.4, 0.3, 0.2, 0.0)]


def fits():
    with open(os.path.join(HERE, "../../../src/SUSPENSION/lubcontact_residual_fit.h"), encoding="ascii") as file:
        text = file.read()
    text = text[text.index("RESIDUAL_FIT[10]"):]
    rows = [[float(v) for v in row.split(",")] for row in re.findall(r"\{([-+0-9.e, ]+)\}", text)]
    return np.array(rows).reshape(10, 9, 5)


FITS = fits()


def coefficients(u, delta, a):
    """of Phi: A, Br, C, As, Bsr, Cs, Rr, Rsr, Tw, Br_turn at the gap u over a."""
    t, beta = u / (1 + u), delta**2
    c = FITS @ beta**np.arange(5)
    v = dict(zip(NAMES, c[:, :6] @ t**np.arange(6) - math.log(u) * (c[:, 6:] @ t**np.arange(3))))
    pi = math.pi
    return {"A": 1.5 * pi * ETA * a * v["squeeze"] / u, "Br": ETA * a**2 * v["push"], "C": ETA * a**3 * v["stretch"],
            "As": pi * ETA * a * v["shear"], "Bsr": ETA * a**2 * v["slide"], "Cs": ETA * a**3 * v["extend"],
            "Rr": pi * ETA * a**3 * v["roll"], "Rsr": pi * ETA * a**2 * delta * v["lever"],
            "Tw": pi * ETA * a**3 * v["twist"], "Bturn": ETA * a**3 * delta * v["turn"]}


class Case:
    def __init__(self, ri, rj, middle, swing, eps):
        self.ri, self.rj, self.middle, self.swing, self.eps = ri, rj, middle, swing, eps
        self.a = 2 * ri * rj / (ri + rj)
        self.delta = (rj - ri) / (ri + rj)

    def way(self, t):
        un = self.a * (self.middle + self.swing * math.cos(1.1 * t + 0.3))
        th, ph = 0.3 * t + 0.5 * math.sin(0.9 * t), 0.4 * math.sin(0.7 * t + 0.4)
        n = np.array([math.cos(th) * math.cos(ph), math.sin(th) * math.cos(ph), math.sin(ph)])
        wi = np.array([0.6 * math.sin(1.2 * t), 0.5 * math.cos(0.8 * t), -0.4 + 0.3 * math.sin(t)])
        wj = np.array([0.4 * math.cos(0.9 * t), -0.3 * math.sin(1.4 * t + 1), 0.5 * math.cos(0.6 * t)])
        return un, n, wi, wj

    def rates(self, t):
        h = 1e-5
        (u1, n1, _, _), (u0, n0, _, _) = self.way(t + h), self.way(t - h)
        return (u1 - u0) / (2 * h), (n1 - n0) / (2 * h)

    def films(self, t, y):
        """Everything of one moment."""
        un, n, wi, wj = self.way(t)
        un_rate, n_rate = self.rates(t)
        r = un + self.ri + self.rj
        u, q, p, tw = self.a * math.exp(y[0]), y[1:4], y[4:7], y[7]
        c = coefficients(u / self.a, self.delta, self.a)
        e = n @ E @ n
        et = E @ n - e * n
        rho = wi - wj
        arms = (self.ri + un / 2) * wi + (self.rj + un / 2) * wj
        s = r * n_rate - np.cross(arms, n)
        sigma = np.cross(rho, n)
        lever = c["Rsr"] / c["As"]
        kr = KT * self.a**2
        contact = ALPHA * G * max(0.0, self.eps * self.a - u)
        # squeeze: -dPhi/dw + contact = g (u - un)
        film = G * (u - un) - contact
        w = (c["Br"] * e - film) / c["A"]
        # shear and roll: dPhi/ds = kt q, dPhi/dsigma = lever kt q + kr p x n
        right = np.array([KT * q + c["Bsr"] * et, lever * KT * q + kr * np.cross(p, n) + c["Bturn"] * et])
        sf, sigmaf = np.linalg.solve([[c["As"], c["Rsr"]], [c["Rsr"], c["Rr"]]], right)
        twf = kr * tw / c["Tw"]
        phi = (c["A"] * w**2 / 2 - c["Br"] * e * w + c["C"] * e**2 / 2 + c["As"] * sf @ sf / 2 + c["Rsr"] * sf @ sigmaf
               + c["Rr"] * sigmaf @ sigmaf / 2 - (c["Bsr"] * sf + c["Bturn"] * sigmaf) @ et + c["Cs"] * et @ et / 2
               + c["Tw"] * twf**2 / 2)
        turn = np.cross(n, n_rate) + 0.5 * (wi + wj) @ n * n
        rolled = sigma - sigmaf
        rates = np.concatenate(([w / u], np.cross(turn, q) + s + lever * sigma - sf - lever * sigmaf,
                                np.cross(turn, p) + np.cross(n, rolled), [rho @ n - twf], [2 * phi]))
        force = G * (u - un) * n - KT * q
        # on i: -dPhi/dsigma as a couple, n x of it, and the twist; the arms of the force are those of s
        couple = -np.cross(n, lever * KT * q + kr * np.cross(p, n)) - kr * tw * n
        torque_i = couple - (self.ri + un / 2) * np.cross(n, -KT * q)
        torque_j = -couple - (self.rj + un / 2) * np.cross(n, -KT * q)
        normal = (-c["Br"] * w + c["C"] * e) * (np.outer(n, n) - np.eye(3) / 3)
        across = -c["Bsr"] * sf - c["Bturn"] * sigmaf + c["Cs"] * et
        tangential = (np.outer(n, across) + np.outer(across, n)) / 2
        return rates, np.concatenate(([u / self.a], force, torque_i, torque_j,
                                      *(S[(0, 1, 2, 0, 0, 1), (0, 1, 2, 1, 2, 2)] for S in (normal, tangential)), [y[8]]))

    def solve(self):
        un = self.way(0.0)[0] / self.a
        u0 = un if un >= self.eps else (un + ALPHA * self.eps) / (1 + ALPHA)
        start = np.zeros(9)
        start[0] = math.log(u0)
        times = END * (np.arange(ROWS) + 1) / ROWS
        found = solve_ivp(lambda t, y: self.films(t, y)[0], (0, END), start, method="Radau", t_eval=times, rtol=1e-9, atol=1e-11)
        return times, [self.films(t, y)[1] for t, y in zip(times, found.y.T)]


def main():
    with open(os.path.join(HERE, "pair_residual_reference.h"), "w", encoding="ascii") as f:
        f.write("// By make_pair_residual_reference.py: residual films of a pair on a prescribed way.\n\n"
                "#ifndef PAIR_RESIDUAL_REFERENCE_H\n#define PAIR_RESIDUAL_REFERENCE_H\n\n// clang-format off\n"
                f"static constexpr double WAY_ETA = {ETA}, WAY_G = {G}, WAY_KT = {KT}, WAY_ALPHA = {ALPHA}, WAY_END = {END};\n"
                f"static constexpr int WAY_ROWS = {ROWS};\n"
                f"static constexpr double WAY_STRAIN[6] = {{{E[0, 0]}, {E[1, 1]}, {E[2, 2]}, {E[0, 1]}, {E[0, 2]}, {E[1, 2]}}};\n\n"
                "struct WayCase {\n  double radius_i, radius_j, middle, swing, eps;\n"
                "  // u/a, force on i, torques on i and j, stresslets (normal, tangential), heat so far\n"
                "  double rows[WAY_ROWS][23];\n};\n\nstatic constexpr WayCase WAY_CASES[] = {\n")
        for case in CASES:
            f.write("    {" + ", ".join(map(str, case)) + ", {\n")
            for row in Case(*case).solve()[1]:
                f.write("      {" + ", ".join(f"{v:.9g}" for v in row) + "},\n")
            f.write("    }},\n")
        f.write("};\n// clang-format on\n\n#endif\n")


if __name__ == "__main__":
    main()
