"""Two equal smooth spheres without inertia in a shear flow (rate y, 0, 0), with all of their hydrodynamics.

Relative motion x' = E x - W x - [A n n + B (1 - n n)] E x of the centres (lengths in the radius, times in 1/rate); A and B by
the fits of F.R. da Cunha, E.J. Hinch, J. Fluid Mech. 309, 211 (1996) to the values of G.K. Batchelor, J.T. Green,
J. Fluid Mech. 56, 375 (1972). The fits jump by 0.3 % (A) and 2 % (B) at r = 2.01, by 1 % and 8 % at r = 2.5;
moving these borders changes smallest gaps by 15 %. Not compared with the printed tables, but they have the known values at
contact, 1 - A = 4.077 (r - 2) and B = 0.406, the far field 5/r^3 and 16/(3 r^5), and the published smallest gap.
"""
import math

import numpy as np
from scipy.integrate import solve_ivp

CLOSEST = 4.0e-5    # da Cunha & Hinch: smallest gap over the radius of spheres that come from far away, as y0 -> 0


def along(r):
    """A(r)"""
    if r < 2.01:
        return (16.3096 - 7.1548 * r) / r
    if r < 2.5:
        return np.polyval([232.2304, -46.3151, -92.4471, 14.8204, 17.7176, -4.3833], 1 / r)
    return np.polyval([430, 12.5, -102, 125, -35, 0, 25, -8, 0, 5, 0, 0, 0], 1 / r)


def across(r):
    """B(r)"""
    if r < 2.01:
        L = -math.log(max(r - 2, 1e-12))    # trial steps may overlap
        return 2 * (0.4056 * L**2 + 1.49681 * L - 1.9108) / (r * (L**2 + 6.04250 * L + 6.32549))
    if r < 2.5:
        return np.polyval([154.8074, -36.4909, -65.2926, 11.4615, 12.3641, -3.1918], 1 / r)
    return np.polyval([-36, -25, -36, 0, 10, 0, 0, 16, 0, 0, 0, 0, 0], 1 / r) / 3


def rates(_, state):
    """x' of (x, y), or of (x, y, z)"""
    x, y = state[:2]
    r = math.hypot(*state)
    A, B = along(r), across(r)
    strain = (A - B) * x * y / r**2
    return [y - strain * x - 0.5 * B * y, -strain * y - 0.5 * B * x] + [-strain * z for z in state[2:]]


def encounter(x0, y0, x_end):
    """From (x0, y0) past the other sphere: the smallest gap and y where x = x_end, over the radius."""
    def abreast(_, state):
        return state[0]

    def end(_, state):
        return state[0] - x_end

    end.terminal = True
    done = solve_ivp(rates, (0.0, 1e4), [x0, y0], method="DOP853", rtol=1e-10, atol=1e-13, events=[abreast, end])
    gap = done.y_events[0][0, 1] - 2.0 if len(done.y_events[0]) else math.nan    # by symmetry the smallest
    return gap, done.y_events[1][0, 1]


def path(start, x_end, rough=0.0, fine=False):
    """From start past the other sphere to x_end, hard and rough: surfaces closer than rough slide along each other without
    friction until the flow pulls them apart. Positions, one column each, fine for a figure, and the smallest gap.
    """
    def meet(_, state):
        return math.hypot(*state) - 2 - rough

    def sliding(_, state):
        n, v = np.array(state) / math.hypot(*state), np.array(rates(0.0, state))
        return v - min(0.0, v @ n) * n

    def parts(_, state):
        return np.dot(rates(0.0, state), state)

    def end(_, state):
        return state[0] - x_end

    meet.terminal, meet.direction, end.terminal, end.direction, parts.terminal, parts.direction = True, -1.0, True, 1.0, True, 1.0
    points, touching, passed = [np.array(start, dtype=float)], False, False
    while not passed:
        done = solve_ivp(sliding if touching else rates, (0.0, 1e4), points[-1], method="DOP853", rtol=1e-10, atol=1e-13,
                         max_step=0.1 if touching else 0.3 if fine else 5.0, events=[parts] if touching else [end, meet] if rough else [end])
        assert done.status == 1, done.message
        points += list(done.y.T[1:])
        passed = not touching and len(done.t_events[0]) > 0
        touching = not touching
    found = np.array(points).T
    return found, np.min(np.linalg.norm(found, axis=0)) - 2


def leave_contact(gap, x_end):
    """Rough spheres that cannot come closer than gap leave each other where they are abreast: y where x = x_end."""
    return encounter(1e-12, 2.0 + gap, x_end)[1]
