"""gap exponential and gap euler on the scenes of benchmarks/side_by_side: second and first order in the time step against
closed forms, and the error of either at the same step. LAMMPS' own styles are in the benchmark.

Squeezed by a force F(t) two spheres with the film c u'/u have ln(u/u0) = (1/c) integral F dt - m v/c whatever their
stiffness.
"""
import numpy as np

import deck

PAIR = deck.ROOT / "benchmarks" / "side_by_side" / "in.pair"
C, MASS = 1.5 * np.pi, 4 / 3 * np.pi * 5e-4
DURATION = 2 * np.pi


def exact(t):
    """Pressed by a force that turns round, from a gap of 0.1 to 0.003 and back."""
    return np.log(0.1) - 0.5 * np.log(33.3) * (1 - np.cos(t))


def error(scene, method, dt):
    steps = round(DURATION / dt)
    t = deck.run(PAIR, ranks=1, scene=scene, method=method, dt=DURATION / steps, steps=steps, rows=steps // 50).thermo()
    return np.max(np.abs(np.exp(np.log(t["c_u"]) - exact(t["Time"]) + MASS * t["v_vz"] / C) - 1))


errors, euler = [{dt: error("squeeze", method, dt) for dt in (6.4e-4, 3.2e-4)} for method in ("exponential", "euler")]
deck.expect_close("squeeze: exponential, error falls by", errors[6.4e-4] / errors[3.2e-4], 4.0, rtol=0.1)
deck.expect_close("squeeze: euler, error falls by", euler[6.4e-4] / euler[3.2e-4], 2.0, rtol=0.1)
deck.expect("squeeze: exponential is right to", errors[6.4e-4] < 1e-4, f"{errors[6.4e-4]:.1e}")
deck.expect("squeeze: euler is wrong by 100 times as much", euler[6.4e-4] > 100 * errors[6.4e-4], f"{euler[6.4e-4]:.1e}")

# a pair that meets in shear and is sheared back returns
back = {}
for method in ("exponential", "euler"):
    t = deck.run(PAIR, ranks=1, scene="reversal", method=method, dt=1.6e-3, steps=10000, rows=200).thermo()
    deck.expect(f"{method}: they met", t["c_u"][t["c_u"] > 0].min() < 0.05, f"{t['c_u'][t['c_u'] > 0].min():.2e}")
    back[method] = np.hypot(t["v_x"][-1] + 4, t["v_y"][-1] - 0.5)
deck.expect("exponential: returns", back["exponential"] < 0.005, f"{back['exponential']:.1e}")
deck.expect("euler: misses by more than 4 times as much", back["euler"] > 4 * back["exponential"], f"{back['euler']:.1e}")
deck.finish()
