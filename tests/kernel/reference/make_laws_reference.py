#!/usr/bin/python3
"""Writes laws_reference.h: Lambert's W, and the gap of a pair with adhesion and repulsion under a smooth motion.

    dy/dt = (un - u + alpha c (eps - u) + p exp(-k u))/(1 - shift u),   y = ln u,   un = c0 + c1 cos(w t + phase)

lengths in a, forces in g a, time in tau = (3/2) pi eta a/g. c is 1 from where u falls below eps until it exceeds eps + delta,
else 0. The solver is restarted at both, so that the jump never lies inside a step. Each case is solved twice, by an explicit
Runge-Kutta of order 8 and by Radau; the difference of the two is written down.
"""
import math
import os

import numpy as np
import scipy
from scipy.integrate import solve_ivp
from scipy.special import lambertw

SAMPLES = 16
RTOL = {"DOP853": 3e-14, "Radau": 1e-12}
ATOL = {"DOP853": 1e-14, "Radau": 1e-13}

# name, alpha, eps, delta, p, k, shift, u at start, c0, c1, w, phase, end
CASES = [
    ("smooth, repulsion", 1, 0, 0, 0.02, 50, 0, 0.2, 0.03, 0.1, math.pi / 60, 0, 240),
    ("smooth, short and strong repulsion", 1, 0, 0, 0.5, 400, 0, 0.2, 0.02, 0.1, math.pi / 75, 0, 300),
    ("rough, repulsion", 1, 0.05, 0, 0.03, 40, 0, 0.2, 0.04, 0.15, math.pi / 60, 0, 300),
    ("rough, repulsion, shifted range", 2, 0.05, 0, 0.03, 40, 4, 0.22, 0.1, 0.13, math.pi / 60, 0, 240),
    ("adhesion", 1, 0.05, 0.02, 0, 1, 0, 0.2, 0.05, 0.15, math.pi / 60, 0, 300),
    ("adhesion, stiff asperities", 25, 0.05, 0.01, 0, 1, 0, 0.15, 0.1, 0.25, math.pi / 50, 0.3, 200),
    ("adhesion, shifted range", 2, 0.05, 0.03, 0, 1, 4, 0.22, 0.1, 0.13, math.pi / 60, 0, 240),
    ("adhesion and repulsion", 3, 0.04, 0.02, 0.02, 60, 0, 0.2, 0.05, 0.15, math.pi / 60, 0, 300),
]


def solve(case, method):
    """y at the SAMPLES equally spaced times, and the number of transitions."""
    name, alpha, eps, delta, p, k, shift, u0, c0, c1, w, phase, end = case
    options = {"method": method, "rtol": RTOL[method], "atol": ATOL[method]}

    def rate(contact):
        A, add = (1 + alpha, alpha * eps) if contact else (1, 0)

        def f(t, y):
            u = np.exp(y)
            return (c0 + c1 * math.cos(w * t + phase) + add + p * np.exp(-k * u) - A * u) / (1 - shift * u)

        return f

    def crossing(contact):
        def event(t, y):
            return y[0] - math.log(eps + delta if contact else eps)

        event.terminal = True
        event.direction = 1 if contact else -1
        return event

    t, y = 0.0, math.log(u0)
    contact = u0 < eps
    transitions = 0
    values = []
    for n in range(1, SAMPLES + 1):
        goal = end * n / SAMPLES
        while t < goal:
            events = [crossing(contact)] if eps > 0 else None
            s = solve_ivp(rate(contact), (t, goal), [y], events=events, **options)
            assert s.success, s.message
            if s.status == 1:
                # y from a run that ends there: dense output is less accurate than the steps
                t_cross = float(s.t_events[0][0])
                s = solve_ivp(rate(contact), (t, t_cross), [y], **options)
                contact = not contact
                transitions += 1
                t, y = t_cross, float(s.y[0, -1])
            else:
                t, y = goal, float(s.y[0, -1])
        values.append(y)
    return np.array(values), transitions


def lambert(L):
    """W(exp L): SciPy where exp L is a number, else three more digits by Newton's rule from the asymptote."""
    if abs(L) < 700:
        return float(lambertw(math.exp(L)).real)
    y = L - math.log(L)
    for _ in range(20):
        y *= (1 + L - math.log(y)) / (1 + y)
    return y


def main():
    body, worst = [], 0.0
    for case in CASES:
        y, transitions = solve(case, "DOP853")
        check, same = solve(case, "Radau")
        assert same == transitions
        difference = float(np.max(np.abs(y - check)))
        worst = max(worst, difference)
        name, *numbers = case
        body.append(f"    // {transitions} transitions, lowest ln u {y.min():.4g}, Radau differs by {difference:.0e}")
        body.append(f'    {{"{name}",')
        body.append("     " + ", ".join(repr(float(x)) for x in numbers) + f", {transitions},")
        rows = [", ".join(f"{x:.15g}" for x in y[m:m + 4]) for m in range(0, SAMPLES, 4)]
        body.append("     {" + ",\n      ".join(rows) + "}},")
    lines = [
        "// Written by make_laws_reference.py, not by hand.",
        "",
        "#ifndef LAWS_REFERENCE_H",
        "#define LAWS_REFERENCE_H",
        "",
        "// clang-format off",
        "// Lambert's W at exp L.",
        "struct LambertCase {",
        "  double L, W;",
        "};",
        "",
        "static constexpr LambertCase LAMBERT_CASES[] = {",
        *[f"    {{{L!r}, {lambert(L):.17g}}}," for L in (-500.0, -100.0, -30.0, -5.0, -1.0, 0.0, 0.5, 1.0, 1.5, 3.0, 10.0,
                                                      100.0, 690.0, 1e4, 1e5)],
        "};",
        "",
        "// ln u of a pair under the smooth motion un = c0 + c1 cos(w t + phase), lengths in a, forces in g a,",
        "// time in tau, at times end n/16, n = 1..16.",
        f"// Solver: SciPy {scipy.__version__} DOP853, rtol {RTOL['DOP853']:g}, restarted at each transition of the contact;",
        f"// Radau at rtol {RTOL['Radau']:g} differs by {worst:.0e} at most.",
        "struct LawsCase {",
        "  const char *name;",
        "  double alpha, eps, delta, p, k, shift, u0;    // law and start",
        "  double c0, c1, w, phase, end;                 // motion",
        "  int transitions;                              // into and out of contact",
        f"  double y[{SAMPLES}];                                 // ln u",
        "};",
        "",
        "static constexpr LawsCase LAWS_CASES[] = {",
        *body,
        "};",
        "// clang-format on",
        "",
        "#endif",
        "",
    ]
    here = os.path.dirname(os.path.abspath(__file__))
    with open(os.path.join(here, "laws_reference.h"), "w", encoding="utf-8") as out:
        out.write("\n".join(lines))


if __name__ == "__main__":
    main()
