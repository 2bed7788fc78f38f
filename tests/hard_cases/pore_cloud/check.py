# ranks: 1 4
"""Pores of a packing with clear fluid around it, of one particle, and at a Stokes number of 1e-6."""
import numpy as np

from deck import expect, expect_close, finish, read_dump, run

PORE = {"mean": 3, "largest": 4, "heat": 7, "fx": 8, "fy": 9, "fz": 10, "iterations": 11, "residual": 12, "k_min": 13, "k_max": 14, "step": 15, "power": 16}


def read(**variables):
    t = run("in.cloud", **variables).thermo()
    t.update({name: t[f"f_pore[{n}]"] for name, n in PORE.items()})
    return t


def beetstra(phi, radius=1.0):
    drag = 10 * phi / (1 - phi) ** 3 + (1 - phi) * (1 + 1.5 * np.sqrt(phi))
    return 2 * radius ** 2 / (9 * phi * drag)


# ---- a packing with a free surface on both sides, and clear fluid: elements without particles, permeabilities in the ratio 1e4
SLAB = {"aspect": 2.5, "steps": 150}
seen = {}
for what, words, fraction in (("cg", "solver cg", 1), ("grid", "solver grid", 1), ("cg, small step", "solver cg", 0.25), ("grid, small step", "solver grid", 0.25),
                              ("grid, viscous", "solver grid", 1)):
    eta = 1e6 if "viscous" in what else 1
    t = seen[what] = read(pore=f"{eta} cell phi_min 0.001 grid 3 8 3 {words}", fraction=fraction, **{**SLAB, "steps": int(150 / fraction)})
    energy = t["PotEng"] + t["KinEng"]
    expect(f"slab, {what}: permeabilities", t["k_max"][0] / t["k_min"][0] > 1e4, f"{t['k_max'][0] / t['k_min'][0]:.2g}")
    expect("  energy never grows", np.all(np.diff(energy) < 1e-3 * energy[0]) and energy[-1] < energy[0], f"{energy[0]:.3g} {energy[-1]:.3g}")
    if "cg" in what:
        expect("  the pores take it", t["power"][1:].sum() > 0 and t["heat"].min() >= 0)
        expect("  iterations converge", np.all(t["iterations"] < 300) and np.all(t["residual"] <= 1e-8), f"{t['iterations'].max():.0f}")
for what in ("cg", "grid"):
    expect(f"slab: all numbers are numbers, {what}", all(np.all(np.isfinite(v)) for v in seen[what].values()))
apart = [(seen[f"grid{more}"]["KinEng"][-1] - seen[f"cg{more}"]["KinEng"][-1]) / seen["cg"]["KinEng"][0] for more in ("", ", small step")]
expect("slab: one solution a step is late, the less the smaller the step", 0 < apart[1] < 0.5 * apart[0] < 0.1, f"{apart[0]:.3f} {apart[1]:.3f}")

# ---- one particle: elements below phi_min everywhere. A gradient acts on the volume of the fluid that phi_min gives it
SLOPE = -3.0
t = read(N=1, kick=0, pore=f"2 cell gradient 0 {SLOPE} 0 coupling off", steps=3)
d = read_dump("cloud.dump")
volume = 4 / 3 * np.pi
expect_close("one particle: one permeability", [t["k_min"][0], t["k_max"][0]], beetstra(0.1), rtol=1e-12)
expect_close("  force of a gradient", d["f_pore[2]"], -SLOPE * volume / 0.1, rtol=1e-10)
expect_close("  and nothing across", [d["f_pore[1]"], d["f_pore[3]"]], 0, atol=1e-10)
t = read(N=1, kick=0.1, pore="2 cell", steps=200)
energy = t["v_energy"]
expect("one particle: it is slowed down", np.all(np.diff(energy) < 0) and energy[-1] < 0.9 * energy[0], f"{energy[0]:.3g} {energy[-1]:.3g}")
for solver in ("grid", "cg"):
    t = read(N=1, kick=0.1, pore=f"1e8 cell solver {solver}", steps=50)
    expect(f"one particle in a stiff fluid, {solver}: no energy from nowhere", np.all(t["v_energy"][1:] <= t["v_energy"][0]), f"{t['v_energy'][-1] / t['v_energy'][0]:.3g}")

# ---- St = rho a^2 rate/eta 1e-5 and 1e-6, at hundreds of steps of an explicit coupling: inertia does not matter any more
steady, TIME = {}, 5e-3
for density in (1e-5, 1e-6):
    steps = int(round(TIME / (0.2 * np.sqrt(4.19 * density / 1e4))))
    t = read(rate=1, density=density, separation=0.03, phi=0.45, pore="pair cell grid 3 3 3 solver cg", flow="fix flow all deform/rheometer rate 1 volume", steps=steps)
    if density == 1e-6:    # one solution a step is late where the pressure is rough
        late = read(rate=1, density=density, separation=0.03, phi=0.45, pore="pair cell grid 3 3 3", flow="fix flow all deform/rheometer rate 1 volume", steps=steps)
        expect("  one solution a step is late", 0.7 < late["largest"][-1] / t["largest"][-1] < 0.98 and 0.5 < late["heat"][-1] / t["heat"][-1] < 0.98,
               f"{late['largest'][-1] / t['largest'][-1]:.2f} {late['heat'][-1] / t['heat'][-1]:.2f}")
    steady[density] = {name: t[name][-1] for name in ("largest", "heat", "power")}
    expect(f"St {density:g}: over the step of explicit coupling", t["step"][-1] > 5, f"{t['step'][-1]:.3g}")
    expect("  the pores take what they are given", abs(t["power"][-1] / (t["heat"][-1] * t["Volume"][-1]) - 1) < 0.1,
           f"{t['power'][-1] / (t['heat'][-1] * t['Volume'][-1]):.3f}")
for name in ("largest", "heat"):
    expect_close(f"St 1e-6 and 1e-5: {name}", steady[1e-6][name], steady[1e-5][name], rtol=0.05)
finish()
