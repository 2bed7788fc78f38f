#!/usr/bin/python3
"""Writes gap_reference.h: the gap of a pair under a smooth motion, from an ODE solver.

    dy/dt = (un - u + alpha max(0, eps - u))/(1 - shift u),   y = ln u,   un = c0 + c1 cos(w t + p)

lengths in a, time in tau = (3/2) pi eta a/g. The solver is restarted at every transition of the
contact, u = eps, so that the kink never lies inside a step. Each case is solved twice, by an
explicit Runge-Kutta of order 8 and by Radau; the difference of the two is written down.
"""
import math
import os

import numpy as np
import scipy
from scipy.integrate import solve_ivp

SAMPLES = 16
RTOL = {"DOP853": 3e-14, "Radau": 1e-12}
ATOL = {"DOP853": 1e-14, "Radau": 1e-13}

# name, alpha, eps, shift, u at start, c0, c1, w, p, end
CASES = [
    ("smooth pair, compressed", 1, 0, 0, 0.1, -0.05, 0.15, math.pi / 40, 0, 40),
    ("smooth pair, compressed deep and pulled", 1, 0, 0, 0.2, 0.03, 0.2, math.pi / 75, 0, 300),
    ("smooth pair, soft oscillation", 1, 0, 0, 0.5, 0.3, 0.6, 2, 0, 20),
    ("rough pair, pressed and released", 1, 0.02, 0, 0.12, 0.02, 0.1, math.pi / 200, 0, 400),
    ("rough pair, bouncing", 1, 0.05, 0, 0.2, 0.05, 0.15, math.pi / 30, 0, 300),
    ("stiff asperities, alpha 25", 25, 0.05, 0, 0.15, 0, 0.15, math.pi / 50, 0.3, 200),
    ("soft asperities, alpha 0.04", 0.04, 0.05, 0, 0.15, 0, 0.15, math.pi / 50, 0.3, 200),
    ("smooth pair, shifted range", 1, 0, 4, 0.2, 0.12, 0.1, math.pi / 60, 0, 240),
    ("rough pair, shifted range", 2, 0.05, 4, 0.22, 0.1, 0.13, math.pi / 60, 0, 240),
]


def solve(case, method):
    """y at the SAMPLES equally spaced times, and the number of transitions."""
    name, alpha, eps, shift, u0, c0, c1, w, p, end = case
    options = {"method": method, "rtol": RTOL[method], "atol": ATOL[method]}

    def rate(contact):
        A, add = (1 + alpha, alpha * eps) if contact else (1, 0)

        def f(t, y):
            u = np.exp(y)
            return (c0 + c1 * math.cos(w * t + p) + add - A * u) / (1 - shift * u)

        return f

    def crossing(contact):
        def event(t, y):
            return y[0] - math.log(eps)

        event.terminal = True
        event.direction = 1 if contact else -1
        return event

    t, y = 0.0, math.log(u0)
    contact = u0 < eps
    transitions = 0
    values = []
    for k in range(1, SAMPLES + 1):
        goal = end * k / SAMPLES
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


def main():
    lines = [
        "// Written by make_gap_reference.py, not by hand: ln u of a pair under the smooth motion",
        "// un = c0 + c1 cos(w t + p), lengths in a, time in tau, at times end k/16, k = 1..16.",
        f"// Solver: SciPy {scipy.__version__} DOP853, rtol {RTOL['DOP853']:g}, restarted at each"
        " transition of the contact;",
    ]
    body, worst = [], 0.0
    for case in CASES:
        y, transitions = solve(case, "DOP853")
        check, same = solve(case, "Radau")
        assert same == transitions
        difference = float(np.max(np.abs(y - check)))
        worst = max(worst, difference)
        name, *numbers = case
        body.append(f"    // {transitions} transitions, lowest ln u {y.min():.4g}, Radau differs by"
                    f" {difference:.0e}")
        body.append(f'    {{"{name}",')
        body.append("     " + ", ".join(repr(float(x)) for x in numbers) + f", {transitions},")
        rows = [", ".join(f"{x:.15g}" for x in y[m:m + 4]) for m in range(0, SAMPLES, 4)]
        body.append("     {" + ",\n      ".join(rows) + "}},")
    lines += [
        f"// Radau at rtol {RTOL['Radau']:g} differs by {worst:.0e} at most.",
        "",
        "#ifndef GAP_REFERENCE_H",
        "#define GAP_REFERENCE_H",
        "",
        "struct GapCase {",
        "  const char *name;",
        "  double alpha, eps, shift, u0;    // law and start",
        "  double c0, c1, w, p, end;        // motion",
        "  int transitions;                 // into and out of contact",
        f"  double y[{SAMPLES}];                    // ln u",
        "};",
        "",
        "// clang-format off",
        "static constexpr GapCase GAP_CASES[] = {",
        *body,
        "};",
        "// clang-format on",
        "",
        "#endif",
        "",
    ]
    here = os.path.dirname(os.path.abspath(__file__))
    with open(os.path.join(here, "gap_reference.h"), "w", encoding="utf-8") as out:
        out.write("\n".join(lines))


if __name__ == "__main__":
    main()
