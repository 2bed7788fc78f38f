# ranks: 1
"""A suspension at rest, shaken by a strain of 1e-4: storage and loss of each film against linear algebra.

At so small a strain each film is a dashpot in series with a spring, and the suspension a linear network. With v_i, w_i the
velocities and spins relative to the flow, exp(i omega t), for every pair at the separation u0 (n from j to i, s = R + u0/2):
    F = -Zn vn n - Zt vt,   T_i = -s_i n x (-Zt vt) - Zr w_roll - Zw w_twist n,   Z = resistance*spring/(spring + i omega resistance)
where v_rel = rate r_y ex + v_i - v_j, vt = v_rel - vn n - (s_i w_i + s_j w_j - (s_i + s_j) rate/2 ez) x n. Newton's equations for
all of them are one complex linear system; the stress is -sum r_x F_y/V.
"""
import numpy as np

from deck import expect, expect_close, finish, read_dump, run

ETA, G, KT, RANGE = 1.0, 1e3, 5e2, 0.5
EX, EZ = np.eye(3)[0], np.eye(3)[2]


def cross(n):
    return np.array([[0, -n[2], n[1]], [n[2], 0, -n[0]], [-n[1], n[0], 0]])


def resistances(u, a):
    """Of squeeze, shear, roll and twist (Chevremont; Frankel & Acrivos; Jeffrey & Onishi)."""
    log = np.log(a / u) if u < a else 0.0
    return (1.5 * np.pi * ETA * a * a / u, 0.5 * np.pi * ETA * ((2 * a + u) * np.log((2 * a + u) / u) - 2 * a),
            np.pi * ETA * a**3 * (0.6 + 0.504 * u / a) * log, np.pi * ETA * a * a * u * log)


def pairs(state, edge):
    x = np.array([state[c] for c in "xyz"]).T
    for i in range(len(x)):
        for j in range(i):
            r = x[i] - x[j]
            r -= edge * np.round(r / edge)
            length, (ri, rj) = np.linalg.norm(r), (state["radius"][i], state["radius"][j])
            u, a = length - ri - rj, 2 * ri * rj / (ri + rj)
            if u < RANGE * a:
                yield i, j, r, r / length, u, a, ri + u / 2, rj + u / 2


def response(state, edge, omega):
    """Stress by film over strain, complex: squeeze, shear."""
    N = len(state["x"])
    inertia = np.repeat(np.stack([state["mass"], 0.4 * state["mass"] * state["radius"]**2], 1), 3, axis=1).ravel()
    A, b = np.diag(1j * omega * inertia).astype(complex), np.zeros(6 * N, complex)
    rate, found = 1j * omega, []
    for i, j, r, n, u, a, si, sj in pairs(state, edge):
        rn, rt, rr, rw = resistances(u, a)
        zn, zt, zr, zw = (R * k / (k + 1j * omega * R) for R, k in ((rn, G), (rt, KT), (rr, KT * a * a), (rw, KT * a * a)))
        P, Q, C = np.outer(n, n), np.eye(3) - np.outer(n, n), cross(n)
        # slip and normal velocity = M @ (v_i, w_i, v_j, w_j) + affine part; w x n = -C w
        slip = np.hstack([Q, si * C, -Q, sj * C])
        normal = np.hstack([P, 0 * P, -P, 0 * P])
        affine = rate * r[1] * EX
        slip0 = Q @ affine - (si + sj) * np.cross(-0.5 * rate * EZ, n)
        turn = np.hstack([0 * P, np.eye(3), 0 * P, -np.eye(3)])
        force, force0 = -zn * normal - zt * slip, -zn * (P @ affine) - zt * slip0
        shear, shear0 = -zt * slip, -zt * slip0
        couple = -(zr * Q + zw * P) @ turn
        rows = np.concatenate([np.arange(6 * i, 6 * i + 6), np.arange(6 * j, 6 * j + 6)])
        A[np.ix_(rows, rows)] -= np.vstack([force, -si * C @ shear + couple, -force, -sj * C @ shear - couple])
        b[rows] += np.concatenate([force0, -si * C @ shear0, -force0, -sj * C @ shear0])
        found.append((rows, r, -zn * normal, -zn * (P @ affine), shear, shear0))
    motion = np.linalg.solve(A, b)
    squeeze = sum(-r[0] * (f @ motion[rows] + f0)[1] for rows, r, f, f0, _, _ in found)
    shear = sum(-r[0] * (s @ motion[rows] + s0)[1] for rows, r, _, _, s, s0 in found)
    return np.array([squeeze, shear]) / edge**3


def measured(t, name, omega, amplitude):
    """Complex amplitude over that of the strain, from the last cycles; strain = amplitude sin(omega t)."""
    late = t["Time"] > t["Time"][-1] - 6 * np.pi / omega
    phase = omega * t["Time"][late]
    base = np.stack([np.ones_like(phase), np.sin(phase), np.cos(phase), np.sin(2 * phase), np.cos(2 * phase)], 1)
    fit = np.linalg.lstsq(base, t[name][late], rcond=None)[0]
    return (fit[1] + 1j * fit[2]) / amplitude


edge = run("in.packing").values["lx"]
state = read_dump("state.txt")
amplitude = 1e-4
for omega in 2.0, 10.0, 100.0:
    step = min(1e-3, 2 * np.pi / omega / 200)
    t = run("in.oscillation", omega=omega, amplitude=amplitude, step=step, steps=round(10 * 2 * np.pi / omega / step)).thermo()
    expect_close(f"omega {omega}: strain", t["f_shear[1]"], amplitude * np.sin(omega * t["Time"]), atol=1e-14)
    expected = response(state, edge, omega)
    for name, value in zip(("c_stress[3][4]", "c_stress[4][4]", "v_s"), (*expected, expected.sum())):
        got = measured(t, name, omega, amplitude)
        expect_close(f"omega {omega}: {name}, storage {value.real:.4f} loss {value.imag:.4f}", abs(got / value - 1), 0, atol=4e-4)
finish()
