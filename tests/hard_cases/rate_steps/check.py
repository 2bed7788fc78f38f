# ranks: 1
"""The rate steps by factors of a thousand and is reversed at once: Stokes flow has no memory. Stress by linear algebra
(decks/oracle/film_network.py), and smooth spheres that find back to where they were.
"""
from pathlib import Path

import numpy as np

from deck import expect, expect_close, finish, read_dump, run
from oracle.film_network import Network

START = """fix shear all deform/rheometer {} start 0
thermo_style custom step time lx ly lz xy f_shear[1] f_shear[2] f_shear[3] f_shear[4] f_shear[5] f_shear[9] f_shear[10] &
             c_stress[3][4] c_stress[4][4] v_sxy v_syy ke
thermo_modify norm no format float %.17g
"""


def stages(start, *later, **variables):
    """Tables of the stages (targets, time) and the particles at the end of each."""
    lines = [START.format(start[0])]
    for n, (targets, time) in enumerate((start, *later)):
        lines += [f"fix_modify shear {targets}"] if n else []
        lines += [f"thermo $(ceil({time}/dt/40))", f"run $(ceil({time}/dt))",
                  f"write_dump all custom stage{n}.txt id x y z vx vy vz radius mass modify format float %.17g sort id"]
    Path("stages.lmp").write_text("\n".join(lines) + "\n")
    done = run("in.steps", **variables)
    tables = [t for t in done.tables() if "f_shear[1]" in t]
    return tables, [read_dump(f"stage{n}.txt") for n in range(len(tables))], done.text


def rates():
    """Smooth particles: after each step of the rate the stress is that of Stokes flow in the present configuration."""
    later = ("rate 1e-3", 2.0), ("rate -1e-3", 2.0), ("rate -1", 0.02), ("rate -1e-3", 1.0)
    tables, particles, _ = stages(("rate 1 volume", 0.1), *later, N=60, g=4e5, coeffs="")
    for n, (t, rate) in enumerate(zip(tables, (1, 1e-3, -1e-3, -1, -1e-3))):
        expect_close(f"rate {rate}: is imposed", t["f_shear[2]"][1:], rate)
        # under rate 1 smooth films are thinner than their geometry: compare with the next configuration, where they relaxed
        end = n + 1 if abs(rate) == 1 else n
        box = tuple(tables[end][name][-1] for name in ("Lx", "Ly", "Lz", "Xy"))
        expected = Network(particles[end], box).stress().real
        got = [t[name][-1] / rate for name in ("c_stress[3][4]", "c_stress[4][4]")]
        expect_close(f"rate {rate}: squeeze and shear stress over the rate", got, expected, rtol=1e-2 if abs(rate) == 1 else 4e-4)


def overdamped():
    """The same without inertia, with drag towards the flow."""
    case = dict(N=60, g=1e4, coeffs="", move="overdamped/sphere pair cell", step="1e-4", separation=0.03)
    tables, particles, _ = stages(("rate 1e-3 volume", 0.5), ("rate 1", 0.01), ("rate -1e-3", 0.5), **case)
    for n, rate in (0, 1e-3), (2, -1e-3):
        t = tables[n]
        box = tuple(t[name][-1] for name in ("Lx", "Ly", "Lz", "Xy"))
        got = [t[name][-1] / rate for name in ("c_stress[3][4]", "c_stress[4][4]")]
        expected = Network(particles[n], box, drag=np.inf).stress().real
        expect_close(f"overdamped, rate {rate}: squeeze and shear stress over the rate", got, expected, rtol=4e-4)


def stresses():
    """Imposed stress, up and down by 1000, and reversed: the rate follows at once, does not overshoot, and the stress is held."""
    targets = (0.3, 300.0, 0.3, -0.3)
    tables, _, text = stages(("stress 0.3 volume", 10.0), ("stress 300", 0.15), ("stress 0.3", 10.0),
                             ("stress -0.3", 10.0), N=60, phi=0.45, g=1e5, density=0.5,
                             coeffs="roughness 0.03 friction coulomb 0.5", separation=0.04)
    for t, target in zip(tables, targets):
        late = slice(len(t["Step"]) // 2, None)
        total = (t["f_shear[5]"] + t["f_shear[2]"])[late]
        if target == 300:    # the structure adapts over a strain of one: still on the way
            expect("stress 300: comes near without overshoot", 150 < total[-1] < 300, f"{total[-1]:.1f}")
        else:
            expect_close(f"stress {target}: held, with that of the fluid", total.mean(), target, rtol=0.05)
        expect(f"stress {target}: rate below that of the fluid alone", np.all((t["f_shear[2]"] / target)[late] < 0.5)
               and np.mean((t["f_shear[2]"] / target)[late]) > 0, f"{t['f_shear[2]'][-1]:.4f}")
        expect("  state", np.all(t["f_shear[10]"][1:] == 1))
    expect("stress steps: not jammed, not out of reach", "cannot reach" not in text and "jammed" not in text)


def moved(edge, a, b, strain):
    """Root mean square of the displacements relative to the flow."""
    d = np.array([b[c] - a[c] for c in "xyz"])
    d[1:] -= edge * np.round(d[1:] / edge)
    d[0] -= strain * (a["y"] + b["y"]) / 2
    d[0] -= edge * np.round(d[0] / edge)
    d -= d.mean(axis=1)[:, None]
    return np.sqrt(np.mean(d**2))


def reversal():
    """Smooth spheres return, but for elasticity and inertia, both here proportional to Ca; rough ones do not."""
    back = {}
    for g, density, coeffs in (2e4, 5e-3, ""), (1e5, 1e-3, ""), (1e5, 1e-3, "roughness 0.02 friction coulomb 0.5"):
        tables, d, _ = stages(("rate 0 volume", 1e-6), ("rate 1", 0.1), ("rate -1", 0.1), g=g, density=density, coeffs=coeffs)
        edge = tables[0]["Lx"][0]
        away, back[g, coeffs] = moved(edge, d[0], d[1], 0.1), moved(edge, d[0], d[2], 0.0)
        print(f"g = {g:.0e} {coeffs}: moved away {away:.5f}, and back to within {back[g, coeffs]:.5f}")
        expect_close("  the strain is undone", tables[-1]["Xy"][-1], 0.0, atol=1e-12)
    expect_close("reversal of smooth spheres: ratio of what is left, Ca/5", back[2e4, ""] / back[1e5, ""], 5.0, rtol=0.2)
    expect("reversal of rough spheres: more than half is left", back[g, coeffs] > 0.5 * away)


rates()
overdamped()
stresses()
reversal()
finish()
