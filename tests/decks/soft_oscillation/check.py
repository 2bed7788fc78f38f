# ranks: 1
"""A soft sphere that falls fast on a fixed one is caught by the film: it swings on its bulk spring while the gap closes
and opens by a hundred decades with the direction of the force. Path and gap against SciPy, and order of convergence in
the step, smooth and with asperities too weak for the weight (k eps a = W/2). The deck is the one of falling_sphere.

Stokes number a rho sqrt(2 u0 gravity)/eta = 30, W/g = a/20, time unit eta/(a rho gravity).
"""
import numpy as np

from deck import PAIR, expect_close, finish, run
from oracle.normal_pair import Pair, film

STOKES, U0, SAG, PERIODS = 30, 0.1, 0.05, 4
DENSITY = STOKES**2 / (2 * U0)
MASS, WEIGHT, C = 4 / 3 * np.pi * DENSITY, 4 / 3 * np.pi, film(1.0, 1.0)
G = WEIGHT / SAG
FREQUENCY = np.sqrt(G / MASS)
DURATION = PERIODS * 2 * np.pi / FREQUENCY
COURANT = [0.2, 0.1, 0.05]    # step over sqrt(m/(2 g))


def swing(eps, courant, gap="exponential"):
    rows = run(PAIR / "in.fall", density=DENSITY, g=G, k=G, eps=eps, u0=U0, gap=gap, courant=courant,
               duration=DURATION, rows=200).thermo()
    return rows["Time"], np.array([rows["v_un"], np.log(rows["c_u"]), rows["v_v"]])


for what, eps in ("smooth", 0.0), ("crushed", 0.5 * WEIGHT / G):
    decks = []
    for courant in COURANT:
        times, table = swing(eps, courant)
        decks.append(table)
    exact = Pair(MASS, WEIGHT, G, G, eps, C).solve(U0, 0.0, times).y[[0, 2, 1]]
    un, ln_u = [[np.max(np.abs(table[row] - exact[row])) for table in decks] for row in (0, 1)]
    print(f"{what}: ln u from {exact[1].max():.1f} to {exact[1].min():.1f}; largest errors with steps {COURANT}:")
    print("  un  " + " ".join(f"{e:.2e}" for e in un) + "   ln u  " + " ".join(f"{e:.2e}" for e in ln_u))
    euler = swing(eps, COURANT[1], "euler")[1]
    print(f"  gap euler, step {COURANT[1]}: un {np.max(np.abs(euler[0] - exact[0])):.2e}"
          f"  ln u {np.max(np.abs(euler[1] - exact[1])):.2e}")

    # velocity Verlet runs ahead by (w dt)^2/24 of the phase, amplitude about the depth of the fall
    ahead = (FREQUENCY * DURATION) * (COURANT[-1] / np.sqrt(2))**2 / 24
    expect_close(f"{what}: un against SciPy", decks[-1][0], exact[0], atol=2 * ahead * U0)
    expect_close(f"{what}: ln u against SciPy", decks[-1][1], exact[1], rtol=2 * ahead, atol=2 * ahead * np.ptp(exact[1]))
    for name, errors in ("un", un), ("ln u", ln_u):
        expect_close(f"{what}: second order, ratios of the errors of {name}", np.divide(errors[:-1], errors[1:]), 4.0,
                     rtol=0.1)
    # without the second order the two finer runs leave the fourth
    best = (4 * decks[2] - decks[1]) / 3
    expect_close(f"{what}: un extrapolated", best[0], exact[0], atol=0.05 * un[-1])
    expect_close(f"{what}: ln u extrapolated", best[1], exact[1], atol=0.05 * ln_u[-1])
    if eps == 0.0:
        # Newton's law integrated, see falling_sphere
        expect_close("smooth: ln u = ln u0 - (8/9) t - m v/c", best[1],
                     np.log(U0) - 8 / 9 * times - MASS * best[2] / C, atol=0.05 * ln_u[-1])
finish()
