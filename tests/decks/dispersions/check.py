# ranks: 1 2
"""Far field and residual films of random dispersions in one moment, against linear algebra that knows nothing of the package."""
import numpy as np

import deck
from oracle import free_spheres, residual_film
from oracle.spheres import equilibrium, write_spheres

RATE, DENSITY = 1e-5, 0.08
GRID = "1 1 1" if deck.RANKS == 1 else "1 2 1"


def free_pair():
    """Of the oracle itself: with far field and film a pair in a flow moves as G.K. Batchelor and J.T. Green say (J. Fluid
    Mech. 56, 375 (1972)), whose functions 1 - A and B are these at three gaps."""
    for gap, along, across in ((0.01, 0.038054089, 0.24607976), (0.1, 0.26756401, 0.15555066), (0.944424, 0.8016484, 0.024485635)):
        a, b = residual_film.free_pair(gap)
        deck.expect_close(f"a free pair at {gap}: 1 - A, B", (a, b), (along, across), atol=2e-6)


def dispersion(number, phi, seed):
    edge, x = equilibrium(np.random.default_rng(seed), number, phi, sweeps=100)
    return edge * np.eye(3), x


def viscosity(number, phi, seed, ranges):
    cell, x = dispersion(number, phi, seed)
    v, w = np.outer(x[:, 1], [RATE, 0, 0]), np.outer(np.ones(number), [0, 0, -RATE / 2])
    write_spheres("spheres.data", cell, x, np.ones(number), v, w, DENSITY, triclinic=True)
    one = free_spheres.Dispersion(cell, x, [0, *ranges], 1e-9)
    for reach, eta, film in zip(ranges, one.viscosities()[1:], one.films()[1:]):
        t = deck.run("in.moment", range=f"residual {reach}", rate=RATE, grid=GRID).thermo()
        name = f"{number} spheres at {phi}, films to {reach}"
        deck.expect_close(f"{name}: viscosity", t["v_shear"][-1], eta[0, 0], rtol=2.5e-4)
        deck.expect_close(f"{name}: what the films carry", t["v_films"][-1], film[0, 0], rtol=1e-3)
        deck.expect("no contacts", np.all(t["v_contacts"] == 0))


def settling(number, phi, seed, reach):
    """Velocities and spins of all under equal weights."""
    cell, x = dispersion(number, phi, seed)
    write_spheres("spheres.data", cell, x, np.ones(number), 0 * x, 0 * x, DENSITY, triclinic=True)
    weight = -6 * np.pi * RATE
    t = deck.run("in.moment", range=f"residual {reach}", flow="no", weight=weight, steps=400, grid=GRID).thermo()
    d = deck.read_dump("moment.dump")
    found = np.array([d[name] for name in ("vx", "vy", "vz", "omegax", "omegay", "omegaz")]).T / RATE
    one = free_spheres.Dispersion(cell, x, [reach], 1e-9)
    known = (one.mobilities()[0][:, :, :, 1].sum(axis=2) * weight / RATE)
    deck.expect_close(f"{number} spheres at {phi} settle: mean", found[:, 1].mean(), known[:, 1].mean(), rtol=4e-4)
    deck.expect_close(f"{number} spheres at {phi} settle: velocities, spins", found, known, atol=4e-4)
    deck.expect_close("the fluid carries them", t["f_far[11]"][-1], -number * weight, rtol=1e-4)


if __name__ == "__main__":
    viscosity(40, 0.45, 3, [0.5])
    if deck.RANKS == 1:
        settling(27, 0.2, 5, 1)
        free_pair()
        viscosity(27, 0.2, 4, [1])
    deck.finish()
