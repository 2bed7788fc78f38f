# ranks: 1
"""Damped, bouncing or oscillating: the regimes of a falling sphere in the plane of roughness and contact number, at three
Stokes numbers, against SciPy. All spheres fall in one run. draw.py draws the map of the manual.
"""
import numpy as np

import regimes
from deck import expect, expect_close, finish

POINTS = [(eps, K, stokes) for stokes in (100, 10, 3) for K in (50, 5, 0.2) for eps in (1e-4, 1e-3, 1e-2)]
EXPECTED = {    # [C] fig. 5: soft spheres oscillate, hard rough ones bounce, hard smooth ones are damped, the more the lower St
    100: "bouncing bouncing bouncing oscillating bouncing bouncing oscillating oscillating oscillating",
    10: "damped bouncing bouncing oscillating bouncing bouncing oscillating oscillating oscillating",
    3: "damped damped bouncing damped damped oscillating damped oscillating oscillating",
}

found = regimes.simulate(POINTS)
for stokes, words in EXPECTED.items():
    mine = [n for n, point in enumerate(POINTS) if point[2] == stokes]
    for n, word in zip(mine, words.split(), strict=True):
        eps, K, _ = POINTS[n]
        un, u = found[0][n], found[1][n]
        what = f"St {stokes:g} eps {eps:g} K {K:g}"
        expect(f"{what}: the gap is positive", np.all(u > 0) and np.all(np.isfinite(un)))
        exact_un, exact_u = regimes.path(eps, K, stokes)
        exact, got = regimes.measures(exact_un, exact_u, eps), regimes.measures(un, u, eps)
        expect(f"{what}: SciPy is {word}", regimes.name(*exact) == word, "rise {:.4f} parting {:.4f}".format(*exact))
        expect(f"{what}: the package is {word}", regimes.name(*got) == word, "rise {:.4f} parting {:.4f}".format(*got))
        # of the fall: first collision to 1e-3, later ones add the phase of velocity Verlet
        expect_close(f"{what}: rise and parting", got, exact, rtol=0.02, atol=1e-3)
finish()
