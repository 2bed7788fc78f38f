# ranks: 1
"""A suspension at rest, shaken by a strain of 1e-4: storage and loss of each film against linear algebra
(decks/oracle/film_network.py), from films that flow to films that are elastic.
"""
import numpy as np

from deck import expect_close, finish, read_dump, run
from oracle.film_network import Network


def measured(t, name, omega, amplitude):
    """Complex amplitude over that of the strain, from the last cycles; strain = amplitude sin(omega t)."""
    late = t["Time"] > t["Time"][-1] - 6 * np.pi / omega
    phase = omega * t["Time"][late]
    base = np.stack([np.ones_like(phase), np.sin(phase), np.cos(phase), np.sin(2 * phase), np.cos(2 * phase)], 1)
    fit = np.linalg.lstsq(base, t[name][late], rcond=None)[0]
    return (fit[1] + 1j * fit[2]) / amplitude


edge = run("in.packing").values["lx"]
network = Network(read_dump("state.txt"), (edge, edge, edge, 0.0))
amplitude = 1e-4
for omega in 2.0, 10.0, 100.0:
    step = min(1e-3, 2 * np.pi / omega / 200)
    t = run("in.oscillation", omega=omega, amplitude=amplitude, step=step, steps=round(10 * 2 * np.pi / omega / step)).thermo()
    expect_close(f"omega {omega}: strain", t["f_shear[1]"], amplitude * np.sin(omega * t["Time"]), atol=1e-14)
    expected = 1j * omega * network.stress(omega)
    for name, value in zip(("c_stress[3][4]", "c_stress[4][4]", "v_s"), (*expected, expected.sum())):
        got = measured(t, name, omega, amplitude)
        expect_close(f"omega {omega}: {name}, storage {value.real:.4f} loss {value.imag:.4f}", abs(got / value - 1), 0, atol=4e-4)
finish()
