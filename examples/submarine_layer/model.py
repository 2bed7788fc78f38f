"""One-dimensional model of a layer of grains on a slope under a fluid, impermeable below, drained at its surface.

Balance of the weight at the height y, with the excess pressure p of the fluid and slow motion: the grains carry the pressure
P = W (1 - y/H) cos - p and the shear stress W (1 - y/H) sin. Their friction is that of steady flow at the viscous number
I = eta rate/P and the work of dilation, mu(I) + tan psi; they dilate at the rate e = rate tan psi with
tan psi = K (phi - phi_eq(I)). What dilates has to fill with fluid: e + (1/E) dp/dt = d/dy (k/eta dp/dy), with the modulus E of
the packing. mu(I) and phi_eq(I) are those of Boyer, Guazzelli and Pouliquen (2011), moved so that they meet a steady flow.
"""
import numpy as np
from scipy.linalg import solve_banded

LAYERS = 40
PHI_M = 0.585
NUMBERS = np.logspace(-9, 2, 2000)


def phi_boyer(i):
    return PHI_M / (1 + np.sqrt(i))


def mu_boyer(i):
    return 0.32 + 0.38 / (1 + 0.005 / np.maximum(i, 1e-30)) + i + 2.5 * PHI_M * np.sqrt(i)


def permeability(phi, radius):
    """The law beetstra of fix pore/pressure."""
    return 2 * radius**2 / (9 * phi * (10 * phi / (1 - phi) ** 3 + (1 - phi) * (1 + 1.5 * np.sqrt(phi))))


class Layer:
    """weight: buoyant, per area; slope in radians; steady: I and phi of the steady flow on this slope."""

    def __init__(self, phi, height, weight, slope, viscosity, radius, steady, dilatancy=3.0, modulus=np.inf, factor=1.0):
        self.phi, self.solid = np.full(LAYERS, float(phi)), phi * height / LAYERS
        above = 1 - (np.arange(LAYERS) + 0.5) / LAYERS
        self.load, self.shear = weight * np.cos(slope) * above, weight * np.sin(slope) * above
        self.viscosity, self.radius, self.dilatancy, self.modulus, self.factor = viscosity, radius, dilatancy, modulus, factor
        self.phi_shift = steady[1] - phi_boyer(steady[0])
        self.mu_shift = np.tan(slope) - mu_boyer(steady[0])
        self.resistance = mu_boyer(NUMBERS) + self.mu_shift - dilatancy * (phi_boyer(NUMBERS) + self.phi_shift)
        self.p = np.zeros(LAYERS)

    def flow(self, p):
        """Rate of shear and of dilation at the pressure p: mu(I) + K (phi - phi_eq(I)) = shear stress / P."""
        grains = np.maximum(self.load - p, 1e-6 * self.load)
        wanted = self.shear / grains - self.dilatancy * self.phi
        i = np.where(wanted < self.resistance[0], 0.0, np.interp(wanted, self.resistance, NUMBERS))
        rate = i * grains / self.viscosity
        return rate, self.dilatancy * rate * (self.phi - phi_boyer(i) - self.phi_shift)

    def step(self, dt):
        """p at the end of the step by Newton, at the volume fractions of its start."""
        thickness, k = self.solid / self.phi, self.factor * permeability(self.phi, self.radius) / self.viscosity
        between = 1 / (0.5 * (thickness / k)[1:] + 0.5 * (thickness / k)[:-1])
        top = k[-1] / (0.5 * thickness[-1])
        low, high = np.append(0, between), np.append(between, top)
        p, small = self.p.copy(), 1e-6 * self.load
        for _ in range(100):
            _, e = self.flow(p)
            slope = np.maximum((self.flow(p + small)[1] - e) / small, 0) + 1 / (self.modulus * dt)
            flux = np.append(between * np.diff(p), -top * p[-1])
            residual = flux - np.append(0, flux[:-1]) - (e + (p - self.p) / (self.modulus * dt)) * thickness
            bands = np.zeros((3, LAYERS))
            bands[0, 1:], bands[1], bands[2, :-1] = between, -(low + high) - slope * thickness, between
            new = np.minimum(p + solve_banded((1, 1), bands, -residual), 0.5 * (p + self.load))
            done = np.max(np.abs(new - p)) < 1e-9 * self.load[0]
            p = new
            if done:
                break
        rate, e = self.flow(p)
        self.phi = self.phi / (1 + e * dt + (p - self.p) / self.modulus)
        self.p = p
        return rate

    def run(self, until, dt=0.05):
        """Rows of time, mean phi, velocity of the surface, p at the bottom."""
        rows, mid = [], 0.5
        for n in range(round(until / dt)):
            rate = self.step(dt)
            thickness = self.solid / self.phi
            drop = self.p[0] - self.p[1]    # parabola through the lower two, level at the floor
            rows.append(((n + 1) * dt, LAYERS * self.solid / thickness.sum(), np.sum(rate * thickness), self.p[0] + drop * mid**2 / 2))
        return np.array(rows).T
