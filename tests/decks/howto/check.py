"""The scripts of the manual and of README run as printed, shortened, and nothing warns of them."""
from pathlib import Path

import numpy as np

import deck

SCENE = str(deck.ROOT / "examples" / "scene")


def indented(name, first, end, spaces):
    """Lines of a page from the one that begins with `first` to `end`, without their indentation."""
    page = (deck.ROOT / name).read_text(encoding="ascii")
    block = page[page.index(" " * spaces + first):]
    return "\n".join(line[spaces:] for line in block[:block.index(end)].splitlines()) + "\n"


def scripts(name):
    """Complete scripts of a page: its blocks that begin with a line of a script and contain a run."""
    blocks, lines = [], (deck.ROOT / name).read_text(encoding="ascii").splitlines()
    for n, line in enumerate(lines):
        if line == ".. code-block:: LAMMPS":
            block = []
            for inner in lines[n + 2:]:
                if inner and not inner.startswith("   "):
                    break
                block.append(inner[3:])
            blocks.append("\n".join(block) + "\n")
    return [block for block in blocks if "\nrun  " in block]


def run(name, script, **variables):
    for folder in "examples/packing", "examples/scene":
        script = script.replace(folder, str(deck.ROOT / folder))
    Path(f"in.{name}").write_text(script, encoding="ascii")
    text = deck.run(Path.cwd() / f"in.{name}", **variables).text
    deck.expect(f"{name}: ran", len(deck.Run(text, 0).thermo()["Step"]) > 0)
    deck.expect(f"{name}: no warning of LAMMPS", "WARNING" not in text)
    return text


def shortened(script, steps):
    deck.expect("the page has a script that runs", "\nrun  " in script)
    return script.replace("\nrun  ", f"\nrun {steps} # ", 1)


# Howto_suspension; the adviser finds nothing wrong with it
script = indented("doc/src/Howto_suspension.rst", "variable        eta index", "The shear flow is along", 3)
text = run("howto", shortened(script, 200) + "suspension_scene\n", N=600)    # nine diameters
advice = text[text.index("Suspension scene:"):]
warnings = [line for line in advice.splitlines() if line.startswith("  warning:")]
deck.expect("no warning of the adviser", not warnings, "; ".join(warnings))

# Howto_rheometer, and its script that goes on
page = "doc/src/Howto_rheometer.rst"
first = run("rheometer", shortened(indented(page, "units           lj", ".. code-block:: bash", 3), 300) + "write_restart state.restart\n", N=400,
            scene=SCENE)
second = run("restarted", shortened(indented(page, "read_restart", "*Neighbor* is", 3), 300), scene=SCENE)
deck.expect_close("the strain goes on", deck.Run(second, 0).thermo()["f_shear[1]"][0], deck.Run(first, 0).thermo()["f_shear[1]"][-1], rtol=1e-4)
without = Path("in.restarted").read_text(encoding="ascii").replace("neighbor        0.3 bin", "neighbor        3.0 bin")
Path("in.slow").write_text(without, encoding="ascii")
deck.expect("a skin of another unit warns", "the lists are long and slow" in deck.run(Path.cwd() / "in.slow").text)

# README: what a deck needs more than a dry granular one
lines = indented("README.md", "comm_modify  vel yes", "With a LAMMPS of your own", 4)
Path("in.start").write_text("units lj\natom_style sphere\ncomm_modify vel yes\n"
                            f"include {deck.ROOT / 'examples/packing/packing.lmp'}\nwrite_data state.data\n", encoding="ascii")
deck.run(Path.cwd() / "in.start", N=400, phi=0.45, separation=0.01)
dry = "units lj\natom_style sphere\nread_data state.data\nfix move all nve/sphere\n"
text = run("readme", dry + lines + "thermo_style custom step c_s[1][4]\nrun 300\n")
deck.expect("README: it flows", "shear rate     0.1, " in text)

# Howto_coming_from: its scripts flow, and the springs are those of the table, 2 Kn and Kt
yade, lf_dem, lammps = scripts("doc/src/Howto_coming_from.rst")
for name, script, rate, shown in ("yade", yade, 10, "c_s[3][4]"), ("lf_dem", lf_dem, 1, "v_eta_r"), ("lammps", lammps, 1, "v_eta_r"):
    text = run(f"coming_from_{name}", shortened(script, 1000), N=250)
    deck.expect(f"{name}: it flows", f"shear rate     {rate}, " in text)
    deck.expect(f"{name}: stress", deck.Run(text, 0).thermo()[shown][-1] > 1)
    if name == "lf_dem":
        deck.expect("  critical load 6 pi/0.1, stiffness 2 kn", "g 753982 " in text and "friction clm shift 1 188.49" in text)
pair = """units lj
atom_style sphere
comm_modify vel yes
region box block -5 5 -5 5 -5 5
create_box 1 box
create_atoms 1 single 0 0 0
create_atoms 1 single 1.995 0 0
set group all diameter 2 density 1
pair_style lubcontact 1.0 cut 0.5
pair_coeff * * $(2*1e5) $(2/7*1e5) roughness 0.01 friction coulomb 0.5
fix move all nve/sphere
compute f all pair/local force
compute force all reduce sum c_f inputs local
thermo_style custom step c_force
thermo_modify norm no
run 0
"""
text = run("coming_from_pair", pair)
deck.expect_close("g = 2 Kn has the spring Kn at rest", deck.Run(text, 0).thermo()["c_force"][0], 1e5 * (0.01 + 0.005), rtol=1e-7)

# Howto_gravity: Stokes' velocity over the hindrance, with reduced gravity and with a lift of its own; a bed rests on its floor
sphere, bed = scripts("doc/src/Howto_gravity.rst")
for phi in 0.0, 0.3:
    table = deck.Run(run("sphere", sphere, phi=phi), 0).thermo()
    deck.expect_close(f"a sphere at {phi}", table["v_v"][-1], table["v_stokes"][-1] * (1 - phi)**4.65, rtol=1e-7)
    deck.expect_close("  Stokes' velocity", table["v_stokes"][-1], 2 / 9 * 0.06 * 75, rtol=1e-7)
weight = next(line for line in sphere.splitlines() if line.startswith("fix             weight"))
lift = ("fix weight all gravity ${g} vector 0 0 -1\nvariable lift atom 4/3*PI*radius^3*v_rho_f*v_g\n"
        "fix buoyancy all addforce 0 0 v_lift")
for density in 0.1, 0.05, 0.02:    # the last one floats
    table = deck.Run(run("lift", sphere.replace(weight, lift), rho_p=density), 0).thermo()
    deck.expect_close(f"a lift of its own, density {density}", table["v_v"][-1], 2 / 9 * (density - 0.04) * 75, rtol=1e-7)
text = run("bed", shortened(bed, 300000) + "suspension_scene brief\n", N=100, rho=1.0, dt=7e-4)
table = deck.Run(text, 0).thermo()
deck.expect_close("the floor carries the weight", table["c_load"][-1], -table["v_weight"][-1], rtol=2e-3)
deck.expect_close("the bed rests", table["v_v"][-1], 0, atol=1e-3)
deck.expect("it was a suspension", table["v_v"].max() > 0.1, f"{table['v_v'].max():.3f}")
deck.expect("the adviser knows that it settles", "No input lines: the system is not sheared" in text)

# Howto_hydrodynamics: a shear on both levels, and particles that settle
shear, settling = scripts("doc/src/Howto_hydrodynamics.rst")
films, far = indented("doc/src/Howto_hydrodynamics.rst", "pair_style      lubcontact 1.0 residual 1\n   fix", "Particles that settle", 3).splitlines()[:2]
level = "fix             far all hydro mean"
deck.expect("the lines of the level are in the script", level in shear and "pair_style      lubcontact 1.0 cut 0.5" in shear)
for name, script in (("mean", shear), ("grid", shear.replace(level, far).replace("pair_style      lubcontact 1.0 cut 0.5", films))):
    table = deck.Run(run(f"hydro_{name}", shortened(script, 200), N=100), 0).thermo()
    deck.expect(f"hydro {name}: the far field has a part of the stress", 0.4 < table["v_far"][-1] < 3, f"{table['v_far'][-1]:.3g}")
table = deck.Run(run("settling", shortened(settling, 100), N=60), 0).thermo()
deck.expect_close("it settles slower than alone", table["v_settling"][-1], 0.55, atol=0.1)

# Howto_pore_pressure: a layer that begins to shear sucks; and the periodic piece of it
script, = scripts("doc/src/Howto_pore_pressure.rst")
table = deck.Run(run("layer", script.replace("run             3000", "run             1500"), N=150, rest=40), 0).thermo()
deck.expect("the fluid is sucked in", np.all(table["f_pores[3]"][1:] < -1), f"{table['f_pores[3]']}")
deck.expect("and the grains resist", table["f_cell[9]"][-1] > 8, f"{table['f_cell[9]'][-1]:.3g}")
piece = indented("doc/src/Howto_pore_pressure.rst", "fix             pores all pore/pressure pair cell mean", "Fix deform/rheometer then", 3)
text = run("piece", dry.replace("fix move", "change_box all triclinic\nfix move") + lines.split("fix  ")[0] + piece +
           "thermo_style custom step f_pores[3] f_shear[4]\nrun 300\n")
deck.expect("the fluid has a part of the pressure", np.ptp(deck.Run(text, 0).thermo()["f_pores[3]"]) > 0)
deck.finish()
