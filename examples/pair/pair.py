"""Runs of in.fall, in.shear and in.pairs, and the solutions beside them. Lengths in the radius, viscosity 1."""
import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.optimize import brentq

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "tests" / "decks"))
from deck import Run    # noqa: E402  pylint: disable=wrong-import-position
from oracle import normal_pair, sheared_pair    # noqa: E402  pylint: disable=wrong-import-position

SPACING = 0.02    # time from one output of an encounter to the next
WEIGHT = 4 / 3 * np.pi    # of the sphere that falls; times in eta/(a rho gravity)


def lammps(deck, folder, **variables):
    """Runs a deck in a folder: what it prints."""
    environment = dict(os.environ)
    lmp = environment.pop("LAMMPS_EXECUTABLE", None)    # the tests say which
    command = [environment["MPIRUN"], "1", lmp] if lmp and "MPIRUN" in environment else [str(ROOT / "tools" / "lmp.sh")]
    command += ["-in", str(HERE / deck), "-log", "none", "-nocite"]
    for name, value in variables.items():
        command += ["-var", name, str(value)]
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False,
                          env=environment)
    if done.returncode:
        sys.exit(done.stdout[-2000:])
    return Run(done.stdout, 0)


# ---- a sphere falls on a fixed one

@dataclass
class Fall:
    stokes: float      # a rho sqrt(2 u0 gravity)/eta, which is the time of the free fall, too
    eps: float         # roughness
    k: float           # stiffness of bulk and asperities
    u0: float = 0.1
    duration: float = 24.0
    rows: int = 240

    @property
    def density(self):
        return self.stokes**2 / (2 * self.u0)

    def run(self):
        """Times, un and u."""
        t = lammps("in.fall", HERE, density=self.density, g=self.k, k=self.k, eps=self.eps, u0=self.u0, courant=0.1,
                   duration=self.duration, rows=self.rows).thermo()
        return t["Time"], t["v_un"], t["c_u"]

    def solve(self, times):
        """The same by SciPy: un and u."""
        pair = normal_pair.Pair(4 / 3 * np.pi * self.density, WEIGHT, self.k, self.k, self.eps, normal_pair.film(1.0, 1.0))
        y = pair.solve(self.u0, 0.0, times, rtol=1e-7).y
        return y[0], np.exp(y[2])

    def viscous(self, times):
        """u without inertia: the film alone, and from u = eps on film and asperities. With weight W and c u'/u of the film
        -c u'/u = W - k (eps - u), whose solution is that of the logistic equation.
        """
        c = normal_pair.film(1.0, 1.0)
        u = self.u0 * np.exp(-WEIGHT / c * times)
        touch = c / WEIGHT * np.log(self.u0 / max(self.eps, 1e-300))
        late = times > touch
        p, q = self.k / c, (WEIGHT - self.k * self.eps) / c
        u[late] = q / ((q / max(self.eps, 1e-300) + p) * np.exp(q * (times[late] - touch)) - p)
        return u


# ---- two spheres pass each other in a shear flow

@dataclass
class Encounter:
    y: float                  # of the undisturbed streamline
    z: float = 0.0
    eps: float = 0.0          # roughness
    ca: float = 1e-4          # eta rate a/stiffness of bulk and asperities
    friction: float = 0.0

    def start(self, reach):
        """Just out of range, where the path is still a streamline."""
        far = 2.05 + reach
        return -np.sqrt(max(far**2 - self.y**2 - self.z**2, 0.01)), self.y, self.z

    def solve(self, reach=0.5, stokes=0.01, pair=sheared_pair.Pair, longest=1000.0):
        """By SciPy: the smallest gap, and y and z when it is over."""
        model = pair(rate=1.0, eta=1.0, density=stokes, g=1 / self.ca, kt=0.5 / self.ca, reach=reach, k=1 / self.ca, eps=self.eps,
                     mu=self.friction)
        states, least = model.solve((0, 0, 0), self.start(reach), np.array([0.0, longest]), 1e-5, once=True)
        x, y, z = (states[sheared_pair.XJ] - states[sheared_pair.XI])[:, -1]
        assert x > 0, x
        return least, y, z


class Published(sheared_pair.Pair):
    """As in Yade: the film feels 2 a/(2 a + un) of the slip velocity."""

    def felt(self, un):
        return 2 * self.a / (2 * self.a + un)


class TwoPi(Published):
    """As in its script of two spheres in shear: the torque of drag is -8 pi eta R^3 (2 pi w - vorticity/2)."""

    def drag(self, state, rates):
        turned = np.array(state)
        for w in sheared_pair.WI, sheared_pair.WJ:
            turned[w] *= 2 * np.pi
        super().drag(turned, rates)


def squeezed(offset, reach):
    """Smallest gap with the squeeze film alone, hard, without inertia. The film takes u'/(2 u) of the velocity at which the flow
    closes the gap, (2 + u) sin cos, and nothing of that at which it turns the pair, sin^2: then u (2 + u)^3 sin^4 is constant.
    """
    return brentq(lambda u: u * (2 + u)**3 - offset**4 * reach / (2 + reach), 0.0, reach, xtol=1e-16)


@dataclass
class Passage:
    x: np.ndarray
    y: np.ndarray
    z: np.ndarray
    u: np.ndarray    # gap, NaN out of range

    @property
    def least(self):
        """Smallest gap, between the outputs by a parabola; NaN if never in range."""
        if np.all(np.isnan(self.u)):
            return np.nan
        k = np.nanargmin(self.u)
        low, middle, high = self.u[k - 1:k + 2] if 0 < k < len(self.u) - 1 else (self.u[k],) * 3
        bend = high - 2 * middle + low
        return middle - (high - low)**2 / (8 * bend) if bend > 0 else middle

    @property
    def out(self):
        return self.y[-1], self.z[-1]


def encounters(pairs, reach=0.5, stokes=0.01, fraction=0.6, longest=400.0, **variables):
    """Paths of many pairs in one run, with steps of a fraction of the limit that the pair style reports."""
    mass, stiffest = 4 / 3 * np.pi * stokes, 1 / min(pair.ca for pair in pairs)
    every = int(np.ceil(SPACING / (fraction * 2 / np.sqrt(3.5 * stiffest / mass))))
    with tempfile.TemporaryDirectory() as folder:
        write_pairs(Path(folder), pairs, reach, stokes)
        lammps("in.pairs", folder, reach=reach, step=SPACING / every, every=every, rows=int(longest / SPACING), x_end=reach + 3,
               **variables)
        return read_pairs(Path(folder), len(pairs))


def write_pairs(folder, pairs, reach, stokes):
    apart = 3 * (reach + 4)
    atoms, coeffs = [], []
    for n, pair in enumerate(pairs):
        x, y, z = np.array(pair.start(reach)) / 2
        for tag, side in ((n + 1, -1), (n + 1001, 1)):
            atoms.append(f"{tag} {n + 1} 2.0 {stokes:.17g} {side * x:.17g} {side * y:.17g} {(n + 0.5) * apart + side * z:.17g}\n")
        friction = f"friction coulomb {pair.friction}" if pair.friction else "friction none"
        coeffs.append(f"pair_coeff {n + 1} {n + 1} {1 / pair.ca:.17g} {0.5 / pair.ca:.17g} roughness {pair.eps:.17g} {friction}\n")
    (folder / "pairs.data").write_text(
        f"pairs in shear\n\n{2 * len(pairs)} atoms\n{len(pairs)} atom types\n-1000 1000 xlo xhi\n-100 100 ylo yhi\n"
        f"0 {len(pairs) * apart} zlo zhi\n\nAtoms # sphere\n\n" + "".join(atoms), encoding="ascii")
    (folder / "pairs.lmp").write_text("".join(coeffs), encoding="ascii")


def read_pairs(folder, count):
    rows = [line.split() for line in (folder / "places.dump").read_text(encoding="ascii").splitlines()]
    places = np.array([row for row in rows if len(row) == 4 and row[0].isdigit()], dtype=float).reshape(-1, 2 * count, 4)
    between = places[:, count:, 1:] - places[:, :count, 1:]
    gaps = np.full(between.shape[:2], np.nan)
    frame = -1
    for line in (folder / "gaps.dump").read_text(encoding="ascii").splitlines():
        words = line.split()
        frame += words[:2] == ["ITEM:", "TIMESTEP"]
        if len(words) == 3 and words[0].isdigit():
            gaps[frame, min(int(words[0]), int(words[1])) - 1] = float(words[2])
    return [Passage(*between[:, n].T, gaps[:, n]) for n in range(count)]
