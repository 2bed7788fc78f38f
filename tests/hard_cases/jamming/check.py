# ranks: 1
"""Shear at and above jamming: at imposed volume the stress is that of the overlaps; below the yield stress it comes to rest."""
import numpy as np

from deck import ROOT, expect, expect_close, finish, read_dump, run
from oracle.film_network import Network


def table(done):
    return [t for t in done.tables() if "f_shear[1]" in t]


def elastic(d, box, g, eps):
    """Stress xx yy zz of elastic spheres in series with asperities of the same stiffness, flat at an overlap of eps a."""
    stress = np.zeros(3)
    for _, _, r, n, un, a, _, _ in Network(d, box, reach=eps).pairs():
        stress -= r * n * (g / 2 * (eps * a - un) if un > -eps * a else -g * un)
    return stress / np.prod(box[:3])


def volume():
    """Films add a few percent. Only normal stress: the shear film between flattened asperities has no limit of friction."""
    for squeezed, g, eps in (0.66, 1e4, 0.005), (0.72, 1e4, 0.005), (0.72, 1e5, 0.005):
        t = table(run("in.jammed", N=60, squeezed=squeezed, g=g, steps=4000, coeffs=f"roughness {eps}"))[-1]
        box = tuple(t[name][-1] for name in ("Lx", "Ly", "Lz", "Xy"))
        expected = elastic(read_dump("end.txt"), box, g, eps)
        got = [t[f"c_stress[1][{k}]"][-1] + t[f"c_stress[3][{k}]"][-1] for k in (1, 2, 3)]
        what = f"volume fraction {squeezed}, g {g:.0e}, deepest overlap {-t['c_deepest'][-1]:.2f}"
        expect_close(f"{what}: stress of the overlaps", got, expected, rtol=0.03)
        expect(f"{what}: finite all the time", all(np.all(np.isfinite(column)) for column in t.values()))
        expect(f"{what}: overlaps do not grow", t["c_deepest"].min() > 1.3 * t["c_deepest"][0], t["c_deepest"][0])


def below_yield():
    """Friction 0.05 at volume fraction 0.58: it stays, and the cell expands as slowly as the servo lets it."""
    case = dict(N=60, phi=0.56, squeezed=0.58, coeffs="roughness 0.02 friction coulomb 0.5", steps=10000)
    for stress in 0.5, 0.0:
        done = run("in.jammed", flow=f"stress {stress} pressure 10", **case)
        first, t = table(done)
        strain = t["f_shear[1]"]
        expect_close(f"stress {stress}, pressure 10: at rest", strain, strain[0], atol=1e-3)
        expect_close("  all the time", first["f_shear[1]"], 0.0, atol=1e-2)
        expect_close("  the particles carry the stress", t["f_shear[5]"].mean(), stress, atol=0.03)
        expect("  the pressure sinks towards its target", 10 < t["f_shear[4]"][-1] < t["f_shear[4]"][0] < first["f_shear[4]"][0])
        expect("  no warning", "WARNING" not in done.text)
    flowing = table(run("in.jammed", flow="stress 12 pressure 10", **case))[-1]
    expect("above yield it flows", flowing["f_shear[1]"][-1] > 0.05, f"strain {flowing['f_shear[1]'][-1]:.3f}")


def below_yield_between_plates():
    """The plate comes to rest and static friction carries the stress; above yield it goes on."""
    run(ROOT / "tests" / "decks" / "plates" / "state.lmp", ranks=1, phi=0.55)
    t = run("in.plates", motion="stress 2 load 100 damper 300 drag 10").thermo()
    # what remains after a time of 2 is the film that relaxes, how far depends on the packing: 2e-4 to 2e-3 of three seeds.
    # A suspension that flowed, at 100 times the viscosity of the fluid, would be sheared by 0.06
    strain, late = t["f_cell[1]"], t["Time"] > 2
    rate = np.abs(np.diff(strain) / np.diff(t["Time"]))
    expect_close("plates, stress 2 under load 100: at rest", strain[late], strain[-1], atol=2.5e-3)
    expect("plates: creep dies out", rate[-1] < 5e-4 and rate[-1] < 0.8 * rate[late[1:]][0], rate[-1])
    expect_close("plates: shear stress on both", [t["f_cell[9]"][-1], t["f_cell[10]"][-1]], 2.0, rtol=2e-3)
    expect_close("plates: pressure on both", [t["f_cell[7]"][-1], t["f_cell[8]"][-1]], 100.0, rtol=2e-3)
    t = run("in.plates", motion="stress 80 load 100 damper 300 drag 10", steps=3000).thermo()
    expect("plates, stress 80: flow", t["f_cell[1]"][-1] > 0.5, t["f_cell[1]"][-1])


def out_of_reach():
    """Dry grains that never meet resist no stress: said once."""
    done = run("in.dry")
    t = done.thermo()
    expect("nothing resists: one warning", done.text.count("this system cannot reach it") == 1)
    late = t["f_shear[9]"] > 10.5
    expect("nothing resists: state 3 after ten units of strain", np.all(t["f_shear[10]"][late] == 3) and late.any()
           and np.all(t["f_shear[10]"][t["f_shear[9]"] < 9.5][1:] == 1))
    rest = run("in.dry", part="rest").thermo()
    expect("nothing resists: judged in the same step after a restart",
           np.array_equal(rest["f_shear[10]"][1:], t["f_shear[10]"][-len(rest["Step"]) + 1:]) and np.ptp(rest["f_shear[10]"]) > 0,
           rest["f_shear[9]"][0])


volume()
below_yield()
below_yield_between_plates()
out_of_reach()
finish()
