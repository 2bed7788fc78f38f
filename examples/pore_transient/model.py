"""One-dimensional model of a sheared layer of grains: impermeable below, drained above, the load P on it.

Its volume fraction moves towards that of the steady flow, e = b rate (phi - phi_eq(J)), with J = eta rate/(P - p); the
fluid that this takes flows through the pores, e = d/dy (k/eta dp/dy). Laws phi_eq(J) and mu(J) of Boyer et al. (2011).
The grains are rigid. Shared between layers: the rate of shear or, as the balance of momentum wants, the shear stress.
"""
import numpy as np
from scipy.linalg import solve_banded

LAYERS = 40
PHI_M = 0.585


def phi_equal(j):
    return PHI_M / (1 + np.sqrt(j))


def friction(j):
    return 0.32 + 0.38 / (1 + 0.005 / np.maximum(j, 1e-30)) + j + 2.5 * PHI_M * np.sqrt(j)


NUMBERS = np.logspace(-10, 4, 1000)
FRICTIONS = friction(NUMBERS)


def number(mu):
    """The inverse of friction(), 0 below 0.32."""
    return np.where(mu <= 0.32, 0.0, np.interp(mu, FRICTIONS, NUMBERS))


def kozeny(phi, radius=1.0):
    return (2 * radius) ** 2 * (1 - phi) ** 3 / (180 * phi**2)


def pressure(e_of, k, thickness, p):
    """p in the layers, of d/dy (k dp/dy) = e(p), by Newton; e_of gives e and de/dp >= 0."""
    for _ in range(60):
        between = 1 / (0.5 * (thickness / k)[1:] + 0.5 * (thickness / k)[:-1])
        top = k[-1] / (0.5 * thickness[-1])
        low, high = np.append(0, between), np.append(between, top)
        e, slope = e_of(p)
        flux = np.append(between * np.diff(p), -top * p[-1])
        residual = flux - np.append(0, flux[:-1]) - e * thickness
        bands = np.zeros((3, len(p)))
        bands[0, 1:], bands[1], bands[2, :-1] = between, -(low + high) - slope * thickness, between
        change = solve_banded((1, 1), bands, -residual)
        p = np.minimum(p + change, 0.5 * (p + 1))    # below the load, P = 1
        if np.max(np.abs(change)) < 1e-9:
            break
    return p


def layer(phi0, iv, height, factor, strain, shared="stress", b=3.0, step=2e-3):
    """Histories of strain, p at the bottom, shear stress at the bottom, mean phi, all over P (P = eta = 1)."""
    phi = np.full(LAYERS, phi0)
    p, rate = np.zeros(LAYERS), np.full(LAYERS, iv)
    rows, gamma = [], 0.0
    while gamma < strain:
        thickness = height / LAYERS * phi0 / phi

        def e_of(p, phi=phi):
            load = np.maximum(1 - p, 1e-12)
            root = np.sqrt(rate / load)
            return b * rate * (phi - PHI_M / (1 + root)), b * rate * PHI_M / (1 + root) ** 2 * root / (2 * load)

        for _ in range(30 if not rows else 1):
            if shared == "stress":
                rate = share(1 - p, thickness, iv, rate)
            p = pressure(e_of, factor * kozeny(phi), thickness, p)
        e, _ = e_of(p)
        dt = step / iv
        gamma += step
        phi = phi / (1 + e * dt)
        load = 1 - p
        rows.append((gamma, p[0], friction(rate[0] / load[0]) * load[0], np.sum(thickness * phi) / np.sum(thickness)))
    return np.array(rows).T


def share(load, thickness, iv, rate):
    """Rates with the same shear stress in all layers and the mean iv; a fifth of the way to them."""
    low, high = 0.0, 1e3 * np.max(load)
    for _ in range(45):
        middle = 0.5 * (low + high)
        new = number(middle / load) * load
        low, high = (low, middle) if np.sum(new * thickness) > iv * np.sum(thickness) else (middle, high)
    return rate + 0.2 * (new - rate)
