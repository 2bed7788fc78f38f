"""One sphere moving along the line to a fixed one, integrated by SciPy: the reference of the decks in which
a pair squeezes a film.

Model: bulk spring g in series with a squeeze film in parallel with asperities k, all on the line,
    m un'' = -weight + P,    P = g (u - un) = k max(0, rough - u) + F0 exp(-u/length) - c u'/u,    c = (3/2) pi eta a^2,
un gap of the undeformed and u of the deformed surfaces, P > 0 the repulsion; un > reach: P = 0. Lengths and forces are
dimensional, and y = ln u is the unknown. Nothing here knows the time scale, the variable 1/u or the branches of the
C++ code.
"""
import math
from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp


@dataclass
class Pair:
    mass: float
    weight: float
    g: float
    k: float
    rough: float    # height of the asperities, length
    film: float     # c, force*time
    reach: float = math.inf
    F0: float = 0.0    # screened repulsion
    length: float = 1.0

    def rates(self, _, state):
        un, v, y = state
        u = math.exp(y)
        push = self.g * (u - un)
        held = self.k * max(0.0, self.rough - u) + self.F0 * math.exp(-u / self.length)
        return [v, (push - self.weight) / self.mass, (held - push) / self.film]

    def jacobian(self, _, state):
        u = math.exp(state[2])
        touch = self.k if u < self.rough else 0.0
        touch += self.F0 / self.length * math.exp(-u / self.length)
        return [[0.0, 1.0, 0.0],
                [-self.g / self.mass, 0.0, self.g * u / self.mass],
                [self.g / self.film, 0.0, -(self.g + touch) * u / self.film]]

    def solve(self, un, v, times, rtol=1e-8, method="Radau"):
        """SciPy's solution: y = un, v, ln u at the times; if the pair leaves its reach it ends there, status 1."""
        def leaves(_, state):
            return max(state[0] - self.reach, -1.0)    # -1: out of an infinite reach nothing leaves

        leaves.terminal, leaves.direction = True, 1.0
        u = un    # first sight of the pair: the film carries nothing
        for _ in range(50):
            u = un + self.F0 / self.g * math.exp(-u / self.length)
        more = {"jac": self.jacobian} if method == "Radau" else {}    # a step of an explicit method has no use for it
        done = solve_ivp(self.rates, (0.0, times[-1]), [un, v, math.log(u)], method=method, t_eval=times, rtol=rtol,
                         atol=[1e-3 * rtol, 0.1 * rtol, 0.1 * rtol], events=leaves, **more)
        assert done.success, done.message
        return done


def film(eta, a):
    """c of the squeeze film between equal spheres of radius a."""
    return 1.5 * np.pi * eta * a * a
