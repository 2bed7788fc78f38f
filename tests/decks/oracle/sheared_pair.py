"""Two spheres in a shear flow (rate y, 0, 0), integrated by SciPy: the reference of the decks with such a pair.

Spheres i, j with centres x, velocities v, spins w, radii R, masses m; d = x_i - x_j, n = d/|d|, un = |d| - R_i - R_j,
a = 2 R_i R_j/(R_i + R_j). Arms s = R + un/2. Unknowns beside the motion: y = ln u (u the gap of the deformed
surfaces) and the elastic displacements q (sliding), p (rolling), t (twisting):

    force on i              f = g (u - un) n - kt q                     on j: -f
    torque on i             -s_i n x (-kt q) - kt a^2 (p + t n)         on j: -s_j n x (-kt q) + kt a^2 (p + t n)
    drag, torque of drag    6 pi eta R (flow - v), 8 pi eta R^3 (-rate/2 z - w)
    gap                     (3/2) pi eta a^2 u'/u = g (un - u) + N,     N = k max(0, eps a - u)
    sliding                 q' = W x q + vt - (|kt q| - mu N)+ q/|q| / Rt         in contact with friction
                            q' = W x q + vt - kt q/Rt                             else
    rolling, twisting       p' = W x p + w_roll - kt a^2 p/Rr,  t' = w_twist - kt a^2 t/Rw

where vt is the tangential relative velocity of the surfaces at the middle of the gap, W = n x n' + n (w_i + w_j).n/2 the
turning of the pair, w_roll and w_twist the parts of w_i - w_j across and along n, and the films
    Rt = (pi eta/2) ((2a + u) ln((2a + u)/u) - 2a)
    Rr = pi eta a^3 (3/5 + (63/125) u/a) ln(a/u),   Rw = pi eta a^2 u ln(a/u)     where u < a, else 0 (here 1e-5 pi eta a^3)
A pair begins with u = un and no displacement when un < reach a, and is forgotten when it leaves.
"""
import math
from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp

XI, WI, XJ, WJ = slice(0, 3), slice(6, 9), slice(9, 12), slice(15, 18)    # of x_i, v_i, w_i, x_j, v_j, w_j
GAP, SLIDING, ROLLING, TWIST = 18, slice(19, 22), slice(22, 25), 25
SIZE = 26
FADED = 1e-5    # instead of no resistance to rolling and twisting, which would relax at once


def cross(a, b):
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


@dataclass
class Pair:
    rate: float
    eta: float
    density: float
    g: float
    kt: float
    reach: float            # of the films over a
    radii: tuple = (1.0, 1.0)
    k: float = 0.0
    eps: float = 0.0
    mu: float = 0.0
    roll: float = 0.6

    def __post_init__(self):
        ri, rj = self.radii
        self.a = 2 * ri * rj / (ri + rj)
        self.mass = [4 / 3 * np.pi * self.density * r**3 for r in self.radii]

    def felt(self, un):    # pylint: disable=unused-argument
        """Part of the slip velocity that the film feels; for models that are not this one."""
        return 1.0

    def separation(self, state):
        return np.linalg.norm(state[0:3] - state[9:12]) - sum(self.radii)

    def start(self, xi, xj):
        """Both move and spin with the fluid."""
        state = np.zeros(SIZE)
        for n, x in ((0, xi), (9, xj)):
            state[n:n + 3] = x
            state[n + 3] = self.rate * x[1]
            state[n + 8] = -0.5 * self.rate
        return state

    def drag(self, state, rates):
        for n, r, m in ((0, self.radii[0], self.mass[0]), (9, self.radii[1], self.mass[1])):
            v, w = state[n + 3:n + 6], state[n + 6:n + 9]
            flow = np.array([self.rate * state[n + 1], 0.0, 0.0])
            spin = np.array([0.0, 0.0, -0.5 * self.rate])
            rates[n:n + 3] = v
            rates[n + 3:n + 6] = 6 * np.pi * self.eta * r / m * (flow - v)
            rates[n + 6:n + 9] = 8 * np.pi * self.eta * r**3 / (0.4 * m * r * r) * (spin - w)

    def rates(self, _, state):
        rates = np.zeros(SIZE)
        self.drag(state, rates)
        eta, a, g, kt = self.eta, self.a, self.g, self.kt
        (ri, rj), (mi, mj) = self.radii, self.mass
        vi, wi, vj, wj = state[3:6], state[6:9], state[12:15], state[15:18]
        q, p, t, u = state[SLIDING], state[ROLLING], state[TWIST], math.exp(state[GAP])

        d = state[0:3] - state[9:12]
        r = math.sqrt(d @ d)
        n = d / r
        un = r - ri - rj
        si, sj = ri + 0.5 * un, rj + 0.5 * un
        v = vi - vj
        across = v - (v @ n) * n
        vt = self.felt(un) * (across - cross(si * wi + sj * wj, n))
        turn = cross(n, across) / r + 0.5 * ((wi + wj) @ n) * n
        twist = (wi - wj) @ n
        roll = wi - wj - twist * n

        f = g * (u - un) * n - kt * q
        couple = kt * a * a * (p + t * n)
        lever = kt * cross(n, q)
        rates[3:6] += f / mi
        rates[12:15] -= f / mj
        rates[6:9] += (si * lever - couple) / (0.4 * mi * ri * ri)
        rates[15:18] += (sj * lever + couple) / (0.4 * mj * rj * rj)

        push = self.k * max(0.0, self.eps * a - u)
        rates[GAP] = (g * (un - u) + push) / (1.5 * np.pi * eta * a * a)
        film = 0.5 * np.pi * eta * ((2 * a + u) * math.log((2 * a + u) / u) - 2 * a)
        held = 0.0
        if push > 0.0 and self.mu > 0.0:
            held = min(1.0, self.mu * push / max(kt * math.sqrt(q @ q), 1e-300))
        rates[SLIDING] = cross(turn, q) + vt - (1.0 - held) * kt * q / film
        log = math.log(a / u)
        rates[ROLLING] = cross(turn, p) + roll - kt * p / (np.pi * eta * a * max(FADED, (self.roll + 0.504 * u / a) * log))
        rates[TWIST] = twist - kt * t / (np.pi * eta * a * max(FADED, u / a * log))
        return rates

    def free(self, _, state):
        rates = np.zeros(SIZE)
        self.drag(state, rates)
        return rates

    def solve(self, xi, xj, times, rtol=1e-5, once=False):
        """States at the times, one column each, with ln u = inf out of reach; the smallest u on the way.
        once: the last column is the state at which the pair leaves its reach, where the solution ends.
        """
        def border(_, state):
            return self.separation(state) - self.reach * self.a

        def closest(t, state):
            return self.rates(t, state)[GAP]

        border.terminal, closest.direction = True, 1.0
        state, now, least = self.start(np.array(xi), np.array(xj)), 0.0, math.inf
        inside = border(now, state) < 0.0
        found = np.zeros((SIZE, len(times)))
        while now < times[-1]:
            state[GAP:] = 0.0
            if inside:
                state[GAP] = math.log(self.separation(state))
            border.direction = 1.0 if inside else -1.0
            done = solve_ivp(self.rates if inside else self.free, (now, times[-1]), state, method="Radau",
                             rtol=rtol, atol=1e-2 * rtol, max_step=(5.0 if inside else 0.25) / self.rate, dense_output=True,
                             events=[border, closest] if inside else [border])
            assert done.success, done.message
            here = (times >= now) & (times <= done.t[-1])
            if here.any():
                found[:, here] = done.sol(times[here])
            if inside:
                least = min([least] + [math.exp(s[GAP]) for s in done.y_events[1]])
            else:
                found[GAP, here] = math.inf
            state, now, inside = done.y[:, -1].copy(), done.t[-1], inside ^ (done.status == 1)
            if once and not inside and least < math.inf:
                found[:, -1] = state
                break
        return found, least
