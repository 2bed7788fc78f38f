# ranks: 1 2
"""A sphere settles on a fixed one: smooth (exponential closure), rough (rests on the asperities), rough and too
heavy for them (exponential closure under what the crushed asperities leave of the weight). On two ranks as on one.

The film carries c u'/u, c = (3/2) pi eta a^2, and the weight is W = (4/3) pi a^3 rho gravity, so that
W/c = (8/9)/tc, tc = eta/(a rho gravity) = 1. With force c u'/u on the falling sphere Newton's law
m v' = -W - c u'/u integrates to
    ln(u/u0) = -(8/9) t - m v/c
whatever the stiffness: the last term, 4e-5 at most, is all that inertia and elasticity change.
"""
import numpy as np

from deck import PAIR, RANKS, expect, expect_close, finish, run
from oracle.normal_pair import Pair, film

ETA, RADIUS, DENSITY = 1.0, 1.0, 5e-4
G, K, U0, DURATION = 5e3, 1e3, 0.1, 24.0
MASS = 4 / 3 * np.pi * DENSITY * RADIUS**3
WEIGHT = 4 / 3 * np.pi
C = film(ETA, RADIUS)

# The integrators are second order, and m v/c <= 4e-5 is what they have to follow in the first oscillations on the
# bulk spring: phase error g dt^2/(12 m) = 0.7 % of it, 3e-7. The reference is good to 1e-8.
LN_U = 1e-6
UN = 1e-6 * U0


def simulate(eps, k, gap="exponential", duration=DURATION, rows=48, ranks=1):
    rows = run(PAIR / "in.fall", eta=ETA, a=RADIUS, density=DENSITY, g=G, k=k, eps=eps, u0=U0, gap=gap,
               duration=duration, rows=rows, ranks=ranks).thermo()
    return rows["Time"], np.log(rows["c_u"]), rows["v_un"], rows["v_v"]


def settle(what, eps, k):
    t, ln_u, un, v = simulate(eps, k)
    exact = Pair(MASS, WEIGHT, G, k, eps * RADIUS, C).solve(U0, 0.0, t).y
    expect_close(f"{what}: ln u against SciPy", ln_u, exact[2], atol=LN_U)
    expect_close(f"{what}: un against SciPy", un, exact[0], atol=UN)
    return t, ln_u, un, v


# on two ranks: through the first touch, as on one
if RANKS > 1:
    one, two = (simulate(2 * WEIGHT / (K * RADIUS), K, duration=6, rows=24, ranks=ranks) for ranks in (1, RANKS))
    for name, a, b in zip(("time", "ln u", "un", "v"), one, two):
        expect_close(f"ranks: {name}", b, a, atol=1e-12)
    expect("ranks: touched", one[1][-1] < np.log(2 * WEIGHT / K), f"{one[1][-1]:.3f}")
    finish()

# smooth: nine decades
t, ln_u, un, v = settle("smooth", 0.0, G)
closed_form = np.log(U0) - 8 / 9 * t
expect_close("smooth: ln u = ln u0 - (8/9) t - m v/c", ln_u, closed_form - MASS * v / C, atol=LN_U)
late = t >= 5
rate = np.polyfit(t[late], ln_u[late], 1)[0]
expect_close("smooth: rate of closure", rate, -8 / 9, rtol=1e-6)
expect("smooth: decades of u", ln_u[0] - ln_u[-1] > 9 * np.log(10), f"{(ln_u[0] - ln_u[-1]) / np.log(10):.2f}")
expect_close("smooth: deflection at the end = -W/g", un[-1] - np.exp(ln_u[-1]), -WEIGHT / G, rtol=1e-6)

# gap euler is first order
_, ln_u_euler, _, v_euler = simulate(0.0, G, gap="euler")
error, euler = [np.max(np.abs(y - closed_form + MASS * w / C)) for y, w in ((ln_u, v), (ln_u_euler, v_euler))]
expect("largest error of ln u: exponential, euler", error < 0.01 * euler, f"{error:.2e} {euler:.2e}")

# rough, K = k eps a/W = 2: 18 tc after first touch the approach exp(-k u_eq t/c) is over
eps = 2 * WEIGHT / (K * RADIUS)
t, ln_u, un, v = settle("rough", eps, K)
rest = eps * RADIUS - WEIGHT / K
expect_close("rough: u at rest = eps a - W/k", np.exp(ln_u[-1]), rest, rtol=1e-6)
expect_close("rough: un at rest = u - W/g", un[-1], rest - WEIGHT / G, rtol=1e-6)
expect_close("rough: at rest", v[-1], 0.0, atol=1e-9)

# rough, K = 1/2: crushed flat. The asperities carry k (eps a - u), so the weight is W/2 once u << eps a
eps = 0.5 * WEIGHT / (K * RADIUS)
t, ln_u, un, v = settle("crushed", eps, K)
flat = np.exp(ln_u) < 1e-3 * eps * RADIUS
expect("crushed: outputs with u < eps a/1000", flat.sum() >= 10, f"{flat.sum()}")
rate = np.polyfit(t[-10:], ln_u[-10:], 1)[0]
expect_close("crushed: rate of closure with the apparent weight W - k eps a", rate, -8 / 9 * 0.5, rtol=1e-3)
finish()
