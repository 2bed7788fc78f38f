"""What a film between two equal spheres adds to the far field of fix hydro grid, by linear algebra; radius 1, viscosity 1.

The exact resistance of two spheres (multipoles, tests/kernel/reference) minus that of force coupling, both for pairs without
external force and torque: with the far field such a pair moves as the exact one, under any forces between its spheres and in
any flow. Run as a program it writes residual_film.csv; nothing here knows the fit that the package uses.

Twice the dissipation, n from j to i, distance r, w = dr/dt, slip s = v_i - v_j - (r/2)(omega_i + omega_j) x n across n,
rho = omega_i - omega_j, strain of the flow e = n.E.n, t = (1 - nn).E.n:
    A w^2 - 2 b w e + C e^2 + As s^2 - 2 bs s.t + Cs t^2 + Rr (rho x n)^2 + Tw (rho.n)^2
"""
import sys
from pathlib import Path

import numpy as np
from scipy.interpolate import CubicSpline

TABLE = Path(__file__).with_suffix(".csv")
NAMES = ("A", "b", "C", "As", "bs", "Cs", "Rr", "Tw")
# what diverges at contact: 3 pi/(2 u), and factors of ln(1/u)
LOGARITHMS = {"As": np.pi, "Rr": 0.6 * np.pi}


def eliminated(form, free):
    """The form where these variables have taken their places by themselves."""
    kept = [n for n in range(len(form)) if n not in free]
    return form[np.ix_(kept, kept)] - form[np.ix_(kept, free)] @ np.linalg.solve(form[np.ix_(free, free)], form[np.ix_(free, kept)])


def by_symmetry(forms, r):
    """Forms of (w, e), of (slip, rotation of the pair, t) and of (rho, translation), from those of two spheres.

    Spheres 1 at 0 and 2 at r along x: along = (v1, v2, -e), across = (v1, v2, omega1, omega2, -2 t). A pair that turns with spin
    g and slips: v = -+ (r g + s)/2, both spins g. In a strain both have -+ r t/2 relative to the flow.
    """
    along, across, twist = forms
    apart = np.array([[-0.5, 0.5 * r], [0.5, -0.5 * r], [0, -1]])
    odd = np.array([[-0.5, -0.5 * r, 0.5 * r], [0.5, 0.5 * r, -0.5 * r], [0, 1, 0], [0, 1, 0], [0, 0, -2]])
    even = np.array([[0, 1], [0, 1], [-0.5, 0], [0.5, 0], [0, 0]])
    turned = np.array([-0.5, 0.5])
    return apart.T @ along @ apart, odd.T @ across @ odd, even.T @ across @ even, turned @ twist @ turned


def two_spheres():
    """The program of the multipoles."""
    sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "kernel" / "reference"))
    import make_residual_reference
    return make_residual_reference


def solved(gap):
    """The numbers of NAMES from the two resistances."""
    r = 2 + gap
    most = int(max(60, 36 / np.sqrt(gap)))
    exact = by_symmetry(two_spheres().exact(1, gap, most), r)
    far = by_symmetry(two_spheres().force_coupling(1, gap), r)
    along, shear = exact[0] - far[0], eliminated(exact[1][:2, :2], [1])[0, 0] - eliminated(far[1][:2, :2], [1])[0, 0]
    roll = (eliminated(exact[2], [1]) - eliminated(far[2], [1]))[0, 0]
    # a free pair in a flow with t = 1 slips and turns; centers, s + r g, and stresslet shall be exact
    s, g = -np.linalg.solve(exact[1][:2, :2], exact[1][:2, 2])
    stress = exact[1][2, :2] @ (s, g) + exact[1][2, 2]
    f = far[1]
    # force coupling without torque: f[1] (s', g', 1) = 0 at s' + r g' = s + r g
    slip, turn = np.linalg.solve([f[1, :2], [1, r]], [-f[1, 2], s + r * g])
    pull = shear * slip + f[0] @ (slip, turn, 1)    # bs: what the film lacks to do that
    rest = stress - f[2] @ (slip, turn, 1) + pull * slip
    return along[0, 0], -along[0, 1], along[1, 1], shear, pull, rest, roll, exact[3] - far[3]


def free_pair(gap):
    """1 - A and B of a free pair in a strain, relative motion over that of the flow: force coupling and the films of the table."""
    film, r = Films()(gap), 2 + gap
    along, odd, _, _ = by_symmetry(two_spheres().force_coupling(1, gap), r)
    odd[0, 0] += film["As"]
    odd[0, 2] -= film["bs"]
    s, g = -np.linalg.solve(odd[:2, :2], odd[:2, 2])
    w = (film["b"] - along[0, 1]) / (along[0, 0] + film["A"])
    return w / r, 1 - (s + r * g) / r


def leading(name, u):
    return 1.5 * np.pi / u if name == "A" else LOGARITHMS.get(name, 0.0) * np.log(1 / u)


class Films:
    """The numbers of NAMES at any gap up to 4 radii, from the table; nearer than its end from u, u ln u and a constant."""

    def __init__(self):
        rows = np.loadtxt(TABLE, delimiter=",", skiprows=1)
        self.end, last = rows[0, 0], rows[:6, 0]
        near = np.array([np.ones(6), last * np.log(last), last, last**2 * np.log(last)]).T
        self.inner, self.outer = {}, {}
        for n, name in enumerate(NAMES):
            rest = rows[:, n + 1] - leading(name, rows[:, 0])
            if name in ("bs", "Cs"):    # with logarithms of their own
                near_of = np.column_stack([near, np.log(last)])
            elif name == "A":
                near_of = np.column_stack([near, np.log(last)])
            else:
                near_of = near
            self.inner[name] = np.linalg.lstsq(near_of, rest[:6], rcond=None)[0]
            self.outer[name] = CubicSpline(np.log(rows[:, 0]), rest * rows[:, 0] if name == "A" else rest)

    def __call__(self, gap):
        u = np.asarray(gap, dtype=float)
        found = {}
        for name in NAMES:
            c = self.inner[name]
            inside = c[0] + c[1] * u * np.log(u) + c[2] * u + c[3] * u * u * np.log(u) + (c[4] * np.log(u) if len(c) > 4 else 0)
            outside = self.outer[name](np.log(np.maximum(u, self.end))) / (u if name == "A" else 1)
            found[name] = leading(name, u) + np.where(u < self.end, inside, outside)
        return found


def main():
    gaps = np.exp(np.linspace(np.log(0.003), np.log(4.0), 60))
    rows = [(gap, *solved(gap)) for gap in gaps]
    np.savetxt(TABLE, rows, fmt="%.9g", delimiter=",", header="gap," + ",".join(NAMES), comments="")


if __name__ == "__main__":
    main()
