"""The regimes of a sphere that falls on a fixed one ([C] fig. 5: W. Chevremont, thesis, Grenoble 2020, sec. 2.3.1): damped,
bouncing, oscillating, in the plane of roughness eps and contact number K = k eps a/weight at the Stokes number
St = a rho sqrt(2 u0 gravity)/eta. Bulk and asperities have the same stiffness. Lengths in a, gravity 1, viscosity 1.

Two numbers decide, both over the fall u0: how far the sphere rises from its lowest point (un), and how far the surfaces
part again beyond the asperities (u - eps) after it.
    damped        it does not rise, by less than SMALL
    bouncing      it rises and the surfaces part
    oscillating   it rises, but the film does not let go: the bulk swings behind a gap that stays closed
"""
import numpy as np
from scipy.integrate import solve_ivp

import deck
from oracle.normal_pair import Pair, film

U0, FALL = 0.1, np.sqrt(2 * 0.1)    # of free fall: sqrt(2 u0/gravity)
DURATION = 8 * FALL
SMALL = 0.01
NAMES = ("damped", "bouncing", "oscillating")


def density(stokes):
    return stokes / np.sqrt(2 * U0)


def stiffness(eps, K, stokes):
    return K * 4 / 3 * np.pi * density(stokes) / eps


def measures(un, u, eps):
    """Rise and parting over u0, of one path."""
    rise = np.max(un - np.minimum.accumulate(un))
    parting = np.max(u - np.maximum(eps, np.minimum.accumulate(u)))
    return rise / U0, parting / U0


def name(rise, parting):
    if rise < SMALL:
        return "damped"
    return "bouncing" if parting > SMALL else "oscillating"


def path(eps, K, stokes, frames=400, rtol=1e-8):
    """SciPy's path: un and u at equal times. LSODA; rates and jacobian know nothing of the package."""
    mass, k = 4 / 3 * np.pi * density(stokes), stiffness(eps, K, stokes)
    pair = Pair(mass=mass, weight=mass, g=k, k=k, rough=eps, film=film(1.0, 1.0))
    times = np.linspace(0, DURATION, frames + 1)

    def bounded(f):    # a trial step of the solver may ask for anything
        return lambda t, state: f(t, [state[0], state[1], min(state[2], 3.0)])

    done = solve_ivp(bounded(pair.rates), (0, DURATION), [U0, 0.0, np.log(U0)], method="LSODA", t_eval=times,
                     rtol=rtol, atol=[1e-10, 1e-9, 1e-8], jac=bounded(pair.jacobian))
    assert done.success, done.message
    return done.y[0], np.exp(done.y[2])


def simulate(points, courant=0.05):
    """The package's paths of all points (eps, K, stokes), in one run: un and u at equal times, from 0 on."""
    step = courant * min(np.sqrt(eps / K) for eps, K, _ in points)
    frames = 400
    every = int(np.ceil(DURATION / frames / step))
    with open("points.data", "w") as f:
        n = len(points)
        f.write(f"pairs that fall\n\n{2 * n} atoms\n{n} atom types\n0 {10 * n} xlo xhi\n-5 5 ylo yhi\n-2 5 zlo zhi\n\nAtoms\n\n")
        for m, (_, _, stokes) in enumerate(points):
            for tag, z in ((m + 1, 0), (m + 1001, 2 + U0)):
                f.write(f"{tag} {m + 1} 2 {density(stokes):.17g} {10 * m + 5} 0 {z}\n")
    with open("points.lmp", "w") as f:
        f.write("pair_coeff * * 1 1\n")
        for m, (eps, K, stokes) in enumerate(points):
            k = stiffness(eps, K, stokes)
            f.write(f"pair_coeff {m + 1} {m + 1} {k:.17g} {k:.17g} roughness {eps}\n")
    deck.run("in.regimes", step=DURATION / frames / every, every=every, frames=frames)
    un, u = np.full((2, n, frames + 1), np.nan)
    frame = -1
    with open("paths.dump") as f:
        for line in f:
            if line.startswith("ITEM: TIMESTEP"):
                frame += 1
            words = line.split()
            if len(words) == 4 and words[0].isdigit():
                m = min(int(words[0]), int(words[1])) - 1
                u[m, frame], un[m, frame] = float(words[2]), float(words[3])
    return un, u
