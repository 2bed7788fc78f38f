#!/usr/bin/python3
"""Writes src/SUSPENSION/lubcontact_residual_fit.h and residual_reference.h: what the films between two spheres add to a far
field in which each sphere is a force, a torque and a stresslet with Gaussian envelopes (force coupling).

Exact: the moments of D.J. Jeffrey and Y. Onishi, J. Fluid Mech. 139, 261 (1984), and, for a straining flow, of D.J. Jeffrey,
Phys. Fluids A 4, 16 (1992). Their series in the radii over the distance solve linear systems for the multipoles of the two
spheres; here the systems are solved themselves, with as many multipoles as the gap needs. Force coupling: S. Lomholt and
M.R. Maxey, J. Comput. Phys. 184, 381 (2003), with the stresslets that keep the spheres rigid.

Radii 1 (sphere 1, "j" in the pair law) and lam <= 1 (sphere 2, "i"), n along x from 1 to 2, viscosity 1. The resistance is a
quadratic form of velocities and strain E, twice the dissipation it is F.v + T.omega - S:E. Relative motion: w along n, slip s
with the arms R + gap/2, rho = omega_2 - omega_1, sigma = rho x n. What remains, translation and rotation of the pair as a
whole, is eliminated: no external force or torque. The residual is the exact form minus that of force coupling,
    A w^2 - 2 B r w e + C e^2                                           e = n.E.n, r distance of the centers
    As s^2 + 2 Rsr s sigma + Rr sigma^2 - 2 (Bs r s + Br sigma) e_t + Cs e_t^2     e_t = (1 - nn).E.n
    Tw rho_n^2
so that a pair answers to any forces between its spheres as the exact one does. Bs, Br, Cs are not the differences: translation
and rotation of the pair follow force coupling, whose rotation in a strain is not exact. They are such that the centers of a
free pair, and its spins, move relative to each other in any flow as the exact ones do, and that its stresslet is exact.
Dimensionless by a = 2 lam/(1 + lam), x = gap/a and delta = (1 - lam)/(1 + lam):
    A x/(1.5 pi a), B r/a^2, C/a^3, As/(pi a), Bs r/a^2, Cs/a^3, Rr/(pi a^3), Rsr/(pi a^2 delta), Tw/(pi a^3), Br/(a^3 delta)
"""
import math
import os

import numpy as np
from scipy.special import erf, gammaln

NAMES = ["squeeze", "push", "stretch", "shear", "slide", "extend", "roll", "lever", "twist", "turn"]
LOGARITHM = {3: [1, 0.6], 6: [0.6], 7: [0.6]}    # factor of ln(1/x) for x -> 0, powers of beta
FLOW = (4, 5, 9)    # chosen for the motion of a free pair: their logarithms are fitted
X_END, BETA_END = 2.0, 0.36    # beta = delta^2: size ratios to 4
ORDER_P, ORDER_Q, ORDER_BETA = 6, 3, 5
MARGIN = 1.12    # of the fit beyond X_END


def couplings(t1, t2, L, m):
    """What the multipoles 1..L of the other sphere contribute to those of one, azimuthal number m; t: radii over distance."""
    n, s = np.arange(1.0, L + 1)[:, None], np.arange(1.0, L + 1)[None, :]
    shift = 1 if m else 0
    W = np.exp(gammaln(n + s + 1) - gammaln(n + 1 + shift) - gammaln(s + 1 - shift) + n * math.log(t1) + s * math.log(t2))
    if m == 0:
        PP = W * (n * (2 * n + 1) * (2 * n * s - n - s + 2) / (2 * (n + 1) * (2 * s - 1) * (n + s)) / t1
                  - n * (2 * n - 1) / (2 * (n + 1)) * t1)
        PV = -W * n * (4 * n * n - 1) / (2 * (n + 1) * (2 * s + 1)) * t2 * t2 / t1
        VP = -W * 2 * n / ((n + 1) * (2 * n + 3)) * t1
        return PP, PV, VP, 0 * W, 0 * W, 0 * W
    PP = W * ((2 * n + 1) / (2 * (n + 1)) * (3 * (n + s) - (n * s + 1) * (2 * n * s - s - n + 2))
              / (s * (n + s) * (2 * s - 1)) / t1 + n * (2 * n - 1) / (2 * (n + 1)) * t1)
    PV = W * n * (4 * n * n - 1) / (2 * (n + 1) * (2 * s + 1)) * t2 * t2 / t1
    PQ = -W * 2 * (4 * n * n - 1) / (3 * (n + 1)) * t2 / t1
    VP = W * 2 * n / ((n + 1) * (2 * n + 3)) * t1
    return PP, PV, VP, PQ, W * s / (n + 1) * t2, -W * 3 / (2 * n * s * (n + 1))


def moments(lam, gap, L, m):
    """(P1, Q1, P2) of both spheres, rows, for a unit translation, rotation and strain of each, columns."""
    t = 1 / (1 + lam + gap), lam / (1 + lam + gap)
    K = couplings(t[0], t[1], L, m), couplings(t[1], t[0], L, m)
    A, I, Z = np.zeros((4 * L, 4 * L)), np.eye(L), np.zeros((L, L))
    for one in range(2):
        PP, PV, _, PQ, QQ, QP = K[one]
        own, other = slice(2 * L * one, 2 * L * (one + 1)), slice(2 * L * (1 - one), 2 * L * (2 - one))
        A[own, own] = np.block([[I - PV @ K[1 - one][2], Z], [Z, I]])
        A[own, other] = -np.block([[PP + PV, PQ], [QP, QQ]])
    place = [0, L, 1, 2 * L, 3 * L, 2 * L + 1]
    B = np.zeros((4 * L, 6))
    B[place, range(6)] = 1
    if m == 0:    # no Q
        use = np.r_[0:L, 2 * L:3 * L]
        X = np.zeros((4 * L, 6))
        X[use] = np.linalg.solve(A[np.ix_(use, use)], B[use])
        return X[place]
    return np.linalg.solve(A, B)[place]


def twist_moments(lam, gap, L):
    t1, t2 = 1 / (1 + lam + gap), lam / (1 + lam + gap)
    n, s = np.arange(1.0, L + 1)[:, None], np.arange(1.0, L + 1)[None, :]
    log = gammaln(n + s + 1) - gammaln(n + 1) - gammaln(s + 1)
    W = [s / (n + 1) * np.exp(log + n * math.log(a) + (s + 1) * math.log(b)) for a, b in ((t1, t2), (t2, t1))]
    A = np.block([[np.eye(L), W[0]], [W[1], np.eye(L)]])
    B = np.zeros((2 * L, 2))
    B[0, 0] = B[L, 1] = 1
    return np.linalg.solve(A, B)[[0, L]]


def exact(lam, gap, L):
    """Forms of (U1, U2, -e), of (U1, U2, omega1, omega2, -2 e_t) and of (omega1, omega2) along n."""
    a, sign, pi = (1.0, lam), (1, -1), math.pi    # in the series the axis of each sphere points to the other
    X, Y, Q = moments(lam, gap, L, 0), moments(lam, gap, L, 1), twist_moments(lam, gap, L)
    R, T, W = np.zeros((3, 3)), np.zeros((5, 5)), np.zeros((2, 2))
    for i in range(2):
        for j in range(2):
            x, y = X[3 * i:3 * i + 3, 3 * j:3 * j + 3], Y[3 * i:3 * i + 3, 3 * j:3 * j + 3]
            R[i, j] = 6 * pi * a[i] * sign[i] * sign[j] * x[0, 0]
            R[2, j] += 3 * pi * a[i]**2 * sign[j] * x[2, 0]
            R[2, 2] += 10 * pi * a[i]**2 * a[j] * x[2, 2]
            T[i, j] = 6 * pi * a[i] * sign[i] * sign[j] * y[0, 0]
            T[2 + i, j] = -8 * pi * a[i]**2 * sign[j] * y[1, 0]
            T[2 + i, 2 + j] = 8 * pi * a[i]**2 * a[j] * y[1, 1]
            T[4, j] += 3 * pi * a[i]**2 * sign[j] * y[2, 0]
            T[4, 2 + j] -= 3 * pi * a[i]**2 * a[j] * y[2, 1]
            T[4, 4] += 10 / 3 * pi * a[i]**2 * a[j] * y[2, 2]
            W[i, j] = 8 * pi * a[i]**2 * a[j] * Q[i, j]
    R[:2, 2] = R[2, :2]
    T[:2, 2:4] = T[2:4, :2].T
    T[:4, 4] = T[4, :4]
    return R, T, W


def green(x, q):
    """Velocity at x of a unit force with a Gaussian envelope of variance q, and its first and second gradients."""
    r, D = np.linalg.norm(x), np.eye(3)
    Q = erf(r / math.sqrt(2 * q))
    d = math.sqrt(2 / math.pi / q) * math.exp(-r * r / 2 / q)
    # (1/r d/dr)^n of h and of its Laplacian p = 2 Q/r
    h = [0, (1 / r - q / r**3) * Q + q * d / r**2, (-1 / r**3 + 3 * q / r**5) * Q - 3 * q * d / r**4,
         (3 / r**5 - 15 * q / r**7) * Q + (2 / r**4 + 15 * q / r**6) * d,
         (-15 / r**7 + 105 * q / r**9) * Q - (20 / r**6 + 105 * q / r**8 + 2 / (q * r**4)) * d]
    p = [2 * Q / r, -2 * Q / r**3 + 2 * d / r**2, 6 * Q / r**5 - (6 / r**4 + 2 / (q * r * r)) * d]

    def sym(rules, *of):
        return sum(np.einsum(rule + "->" + "".join(sorted(rule.replace(",", ""))), *of) for rule in rules.split())

    h2 = D * h[1] + np.outer(x, x) * h[2]
    h3 = sym("ab,c ac,b bc,a", D, x) * h[2] + sym("a,b,c", x, x, x) * h[3]
    h4 = (sym("ab,cd ac,bd ad,bc", D, D) * h[2] + sym("a,b,c,d", x, x, x, x) * h[4]
          + sym("ab,c,d ac,b,d ad,b,c bc,a,d bd,a,c cd,a,b", D, x, x) * h[3])
    return ((D * p[0] - h2) / 8 / math.pi, (sym("ab,c", D, x) * p[1] - h3) / 8 / math.pi,
            (sym("ab,cd", D, D * p[1] + np.outer(x, x) * p[2]) - h4) / 8 / math.pi)


def force_coupling(lam, gap):
    """The same three forms."""
    a, pi, D = (1.0, lam), math.pi, np.eye(3)
    force = [r * r / pi for r in a]    # variances of the envelopes of the force, and of torque and stresslet
    couple = [r * r / (6 * math.sqrt(pi))**(2 / 3) for r in a]
    eps = np.zeros((3, 3, 3))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        eps[i, j, k], eps[i, k, j] = 1, -1
    along = np.diag([2, -1, -1]) / 3    # the stresslets whose power is -e and -2 e_t
    across = np.zeros((3, 3))
    across[0, 1] = across[1, 0] = 1
    none = np.zeros(3)
    loads = [(D[0], 0 * D), (D[1], 0 * D), (none, -eps[:, :, 0] / 2), (none, -eps[:, :, 2] / 2), (none, along), (none, across)]
    M = np.zeros((12, 12))
    for i in range(2):
        for j in range(2):
            for l, (F, C) in enumerate(loads):
                if i == j:
                    u, grad = F / (6 * pi * a[i]), 3 / (20 * pi * a[i]**3) * C
                    w = -np.einsum("jkm,jk->m", eps, C) / (8 * pi * a[i]**3)
                else:
                    x = np.array([(i - j) * (1 + lam + gap), 0, 0])
                    u = green(x, force[i] + force[j])[0] @ F - np.einsum("bc,abc->a", C, green(x, force[i] + couple[j])[1])
                    grad = (np.einsum("abd,b->ad", green(x, couple[i] + force[j])[1], F)
                            - np.einsum("bc,abcd->ad", C, green(x, couple[i] + couple[j])[2]))
                    w = np.einsum("mda,ad->m", eps, grad) / 2
                M[6 * i:6 * i + 6, 6 * j + l] = [u[0], u[1], w[0], w[2], np.sum(along * grad), np.sum(across * grad)]
    R = np.linalg.inv(M)
    both = np.zeros((12, 10))    # one strain for both
    for row, column in ((0, 0), (6, 1), (4, 2), (10, 2), (1, 3), (7, 4), (3, 5), (9, 6), (5, 7), (11, 7), (2, 8), (8, 9)):
        both[row, column] = 1
    R = both.T @ R @ both
    return R[:3, :3], R[3:8, 3:8], R[8:, 8:]


def eliminate(form, k):
    return form[k:, k:] - form[k:, :k] @ np.linalg.solve(form[:k, :k], form[:k, k:])


def relative_motion(lam, gap, R, T, W):
    """The forms of (translation, w, e), of (translation, rotation, s, sigma, e_t) and of (spin of both, rho_n)."""
    r, arm = 1 + lam + gap, lam + gap / 2
    N = np.array([[1, 0, 0], [1, 1, -r], [0, 0, -1]])
    M = np.array([[1, 0, 0, 0, 0], [1, r, 1, arm, -r], [0, 1, 0, 0, 0], [0, 1, 0, 1, 0], [0, 0, 0, 0, -2]])
    K = np.array([[1, 0], [1, 1]])
    return N.T @ R @ N, M.T @ T @ M, K.T @ W @ K


def both(lam, x, L=None):
    """The ten dimensionless residuals, and what the exact resistance has in their place."""
    a, delta, pi = 2 * lam / (1 + lam), (1 - lam) / (1 + lam), math.pi
    gap = a * x
    L = L or int(min(max(40, 34 / math.sqrt(x)), 420))
    full = relative_motion(lam, gap, *exact(lam, gap, L))
    far = relative_motion(lam, gap, *force_coupling(lam, gap))
    f = eliminate(full[0], 1), eliminate(full[1], 2), eliminate(full[2], 1)[0, 0]
    d = f[0] - eliminate(far[0], 1), f[1] - eliminate(far[1], 2), f[2] - eliminate(far[2], 1)[0, 0]

    # a free pair in a flow with e_t = 1: centers and spins shall move relative to each other as the exact ones
    free = -np.linalg.solve(full[1][:4, :4], full[1][:4, 4])
    centers = np.array([0, 1 + lam + gap, 1, lam + gap / 2])
    P, p = far[1][:4, :4], far[1][:4, 4]
    y = np.linalg.solve(np.vstack([P[:2], centers, [0, 0, 0, 1]]), np.r_[-p[:2], centers @ free, free[3]])
    push = (P @ y + p)[2:] + d[1][:2, :2] @ y[2:]
    stress = full[1][4, :4] @ free + full[1][4, 4] - (p @ y + far[1][4, 4]) + push @ y[2:]

    odd = delta if delta > 0 else math.nan
    unit = np.array([1.5 * pi * a**2 / gap, a**2, a**3, pi * a, a**2, a**3, pi * a**3, pi * a**2 * odd, pi * a**3, a**3 * odd])

    def functions(along, across, twist, push, stress):
        return np.array([along[0, 0], -along[0, 1], along[1, 1], across[0, 0], push[0], stress, across[1, 1], across[0, 1], twist,
                         push[1]]) / unit

    return functions(*d, push, stress), functions(*f, -f[1][:2, 2], f[1][2, 2])


def basis(x, beta, part):
    """P(t, beta) + ln(1/x) Q(t, beta), t = x/(1 + x): columns of the free coefficients, and what theory fixes."""
    t, log = x / (1 + x), -np.log(x)
    columns = [t**m * beta**l for m in range(ORDER_P) for l in range(ORDER_BETA)]
    columns += [log * t**m * beta**l for m in range(ORDER_Q) for l in range(ORDER_BETA)]
    free, given = fixed(part)
    return np.array(columns)[free].T, np.array(columns).T @ given


def fixed(part):
    """Which coefficients are free, and the values of the others: the limit, and the logarithms of lubrication."""
    rows = ORDER_P + ORDER_Q
    free, given = np.ones((rows, ORDER_BETA), bool), np.zeros((rows, ORDER_BETA))
    if part == 0:
        free[0], given[0, 0] = False, 1
    if part not in FLOW:
        free[ORDER_P] = False
        given[ORDER_P, :len(LOGARITHM.get(part, []))] = LOGARITHM.get(part, [])
    return free.ravel(), given.ravel()


def fit(part, x, beta, value, full):
    """Coefficients [P0.. P5, Q0.. Q2][beta]; the error is weighed against the residual and a hundredth of the whole."""
    use = np.isfinite(value)
    x, beta, value, full = x[use], beta[use], value[use], full[use]
    weight = 1 / (abs(value) + 0.01 * abs(full))
    M, known = basis(x, beta, part)
    M, scale = M * weight[:, None], np.linalg.norm(M * weight[:, None], axis=0)
    c = np.linalg.lstsq(M / scale, (value - known) * weight, rcond=1e-13)[0] / scale
    error = abs(M @ c / weight + known - value)
    print(f"{NAMES[part]:8s} error over the exact function {np.max(error / abs(full)):.1e}")
    free, coeffs = fixed(part)
    coeffs[free] = c
    return coeffs.reshape(-1, ORDER_BETA)


HEAD = """/* -*- c++ -*- ----------------------------------------------------------
   SUSPENSION: dense non-Brownian suspensions in LAMMPS
   Package for LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License, version 2.
   See the LICENSE file in the top-level directory.
------------------------------------------------------------------------- */

// Coefficients of lubcontact_residual.h, by tests/kernel/reference/make_residual_reference.py: rows
// P0 to P5, Q0 to Q2, columns powers of beta; one block per part.

#ifndef LUBCONTACT_RESIDUAL_FIT_H
#define LUBCONTACT_RESIDUAL_FIT_H

namespace LAMMPS_NS::Lubcontact_NS {

// clang-format off
"""


def write_fit(path, coeffs):
    with open(path, "w", encoding="ascii") as f:
        f.write(HEAD)
        f.write(f"inline constexpr double RESIDUAL_FIT[{len(coeffs)}][{ORDER_P + ORDER_Q}][{ORDER_BETA}] = {{\n")
        for name, c in zip(NAMES, coeffs):
            f.write(f"    {{    // {name}\n")
            for row in c:
                f.write("        {" + ", ".join(format(v, ".9g") for v in row) + "},\n")
            f.write("    },\n")
        f.write("};\n// clang-format on\n\n}    // namespace LAMMPS_NS::Lubcontact_NS\n\n#endif\n")


def write_reference(path):
    lams, xs = (1, 0.77, 0.5, 1 / 3, 0.26), (0.007, 0.02, 0.05, 0.15, 0.4, 0.75, 1, 1.4, 2)
    with open(path, "w", encoding="ascii") as f:
        f.write("// By make_residual_reference.py: size ratio, gap over a, residuals and exact functions in the\n"
                "// order of ResidualPart.\n\n#ifndef RESIDUAL_REFERENCE_H\n#define RESIDUAL_REFERENCE_H\n\n"
                "// clang-format off\nstruct ResidualCase {\n  double ratio, u_a, residual[10], exact[10];\n};\n\n"
                "static constexpr ResidualCase RESIDUAL_CASES[] = {\n")
        for lam in lams:
            for x in xs:
                numbers = [", ".join(format(0.0 if math.isnan(v) else v, ".8g") for v in half)
                           for of in both(lam, x) for half in (of[:5], of[5:])]
                f.write(f"    {{{lam!r}, {x!r},\n     {{{numbers[0]},\n      {numbers[1]}}},\n"
                        f"     {{{numbers[2]},\n      {numbers[3]}}}}},\n")
        f.write("};\n// clang-format on\n\n#endif\n")


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    ends = 0.006**0.4, (MARGIN * X_END)**0.4
    xs = (ends[0] + (ends[1] - ends[0]) * (0.5 - 0.5 * np.cos(math.pi * (np.arange(30) + 0.5) / 30)))**2.5
    betas = BETA_END * (0.5 - 0.5 * np.cos(math.pi * np.arange(8) / 7))
    points, values, fulls = [], [], []
    for beta in betas:
        delta = math.sqrt(beta)
        for x in xs:
            residual, full = both((1 - delta) / (1 + delta), x)
            points.append((x, beta))
            values.append(residual)
            fulls.append(full)
    x, beta = np.array(points).T
    values, fulls = np.array(values), np.array(fulls)
    coeffs = [fit(part, x, beta, values[:, part], fulls[:, part]) for part in range(len(NAMES))]
    write_fit(os.path.join(here, "../../../src/SUSPENSION/lubcontact_residual_fit.h"), coeffs)
    write_reference(os.path.join(here, "residual_reference.h"))


if __name__ == "__main__":
    main()
