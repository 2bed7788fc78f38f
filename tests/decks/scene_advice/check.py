"""The advice of suspension_scene for known scenes: numbers by hand, and which effects they call for."""
import re
from pathlib import Path

import numpy as np

import deck

EFFECTS = ("squeeze film", "shear film", "rolling film", "twisting film", "friction", "critical load", "adhesion", "repulsion",
           "drag", "particle inertia", "roughness", "elastic compliance", "Brownian motion", "far hydrodynamics", "fluid inertia")
ANSWERS = "needed|not needed|accuracy limited|beyond this package|cannot tell"


class Advice:
    def __init__(self, name="in.scene_advice", **variables):
        run = deck.run(name, **variables)
        self.text, self.values = run.text, run.values
        self.text = self.text[max(self.text.find("Suspension scene: what is there"), self.text.find("Effects that")
                                 if variables.get("words") == "brief" else 0):]
        self.answers = {e: re.search(rf"^  {e} +({ANSWERS}) ", self.text, re.MULTILINE).group(1) for e in EFFECTS}
        self.lines = self.text[self.text.index("nput lines"):]

    def number(self, name):
        value = re.search(rf"^  {re.escape(name)}.*? (\S+)$", self.text, re.MULTILINE).group(1)
        return float("nan") if value == "?" else float(value)

    def expect(self, scene, **answers):
        for effect, answer in answers.items():
            effect = effect.replace("_", " ")
            deck.expect(f"{scene}: {effect} is {answer}", self.answers[effect] == answer, self.answers[effect])

    def warns(self, scene, *words):
        found = re.findall(r"^  warning: (.*)$", self.text, re.MULTILINE)
        deck.expect(f"{scene}: {len(words)} warnings", len(found) == len(words), str(found))
        for word in words:
            deck.expect(f"  {word}", any(word in line for line in found))


deck.make_state()
with open("state.data", encoding="ascii") as file:
    data = file.read()
length = float(re.search(r"^\S+ (\S+) xlo xhi", data, re.MULTILINE).group(1))
rows = data[data.index("Atoms"):data.index("Velocities")].split("\n")[2:-1]
radii = np.array([float(row.split()[2]) / 2 for row in rows if row])
a = radii.mean()
phi = (4 / 3 * np.pi * radii**3).sum() / length**3

# dense and viscous, at constant volume, before the first run: the pressure is estimated
scene = Advice()
jam = 0.6301 - 0.0794 * (1 - np.exp(-0.5 / 0.4032))
iv = (jam / phi - 1)**2
for name, value in (("St", 0.05 * a**2), ("Iv =", iv), ("I =", 2 * a * np.sqrt(0.05 * iv)), ("Ca", a / 1e6), ("E/P", 1e6 * iv / a),
                    ("E eps/P", 1e4 * iv / a), ("phi/phi_m", phi / jam), ("Iv + I^2/10", iv + 0.4 * a**2 * 0.05 * iv)):
    deck.expect_close(f"dense: {name}", scene.number(name), value, rtol=6e-3)
deck.expect("the pressure is estimated", "(estimated from phi)" in scene.text)
deck.expect("no temperature, no Pe", np.isnan(scene.number("Pe")))
scene.expect("dense", squeeze_film="needed", shear_film="needed", rolling_film="needed", twisting_film="not needed",
             friction="needed", critical_load="cannot tell", drag="not needed", particle_inertia="not needed", roughness="needed",
             Brownian_motion="cannot tell", far_hydrodynamics="not needed", fluid_inertia="cannot tell")
scene.warns("dense", "box is small")
deck.expect("dense: input lines", "  pair_style lubcontact 1 cut 0.5 twist no\n  pair_coeff * * 1000000 1000000 asperity 1000000 roughness 0.01 "
            "friction coulomb 0.5\n" in scene.lines, scene.lines)
# Gershgorin with 12 neighbors of the smallest sphere
limit = 2 / np.sqrt(2 * 12 * 3.5e6 / (4 / 3 * np.pi * radii.min()**3 * 0.05))
deck.expect_close("dense: limit of the time step", float(re.search(r"limit (\S+) \(estimated", scene.text).group(1)), limit, rtol=6e-3)

# after a run the limit is the one that the pair style prints, and the pressure is measured
scene = Advice(before="run 20")
run = deck.run("in.scene_advice", before="run 20")
printed = re.search(r"of the stability limit (\S+)\n  shear rate", run.text).group(1)
deck.expect_close("after a run: limit of the time step", float(re.search(r"limit (\S+)$", scene.text, re.MULTILINE).group(1)),
                  float(printed), rtol=6e-3)
deck.expect("after a strain of 2e-4: no mean yet", "(estimated from phi); measured over a strain of 0.00016, too short for a mean" in scene.text)

# a mean pressure, not that of the last step; of less than a unit of strain it is doubtful
Path("results").write_text("".join(f"print \"RESULT {name} $(f_flow[{n}])\"\n" for name, n in (("mean", 11), ("now", 4), ("deviation", 13))))
scene = Advice(dt=4e-5, before="run 3000", after="include results")
shown = re.search(r"pressure (\S+) \(mean over a strain of (\S+); single values scatter by (\S+)\)", scene.text)
deck.expect_close("mean pressure, strain and scatter", [float(x) for x in shown.groups()],
                  [scene.values["mean"], 0.12, scene.values["deviation"]], rtol=6e-3)
deck.expect("  is not that of the last step", abs(scene.values["now"] / scene.values["mean"] - 1) > 0.02, scene.values)
deck.expect_close("  Iv of it", scene.number("Iv ="), 1 / scene.values["mean"], rtol=6e-3)
scene.warns("started", "box is small", "near the stability limit", "the pressure is a mean over a strain of 0.12 only")

# a critical load: before a run the pressure has two bounds, and lines follow what holds at both
slip, rub = (1 / (jam_of / phi - 1)**2 for jam_of in (0.6301, jam))
for law, load, friction, critical, words, why in (
        ("step", 1e6, "not needed", "not needed", "friction none", "no contact reaches its critical load"),
        ("step", 1e-3, "needed", "not needed", "friction coulomb 0.5", "P a^2/F"),
        ("step", 20, "needed", "needed", "friction clm step 0.5 20", "P a^2/F"),
        ("step", 10, "needed", "cannot tell", "friction clm step 0.5 10", "run first, or give pressure P"),
        ("step", 1000, "cannot tell", "cannot tell", "friction clm step 0.5 1000", "run first, or give pressure P"),
        ("shift", 1e-3, "needed", "needed", "friction clm shift 0.5 0.001", "act at every load"),
        ("ramp", 1e6, "needed", "needed", "friction clm ramp 0.5 1000000", "act at every load")):
    scene = Advice(coeff=f"roughness 0.01 friction clm {law} 0.5 {load}")
    scene.expect(f"clm {law} {load}", friction=friction, critical_load=critical)
    deck.expect("  why", why in scene.text)
    found = re.search(r"friction (none|coulomb.*|clm.*)$", re.search(r"^  pair_coeff.*$", scene.lines, re.MULTILINE).group(0)).group(0)
    deck.expect("  the line follows", found == words, found)
    gone = re.search(r"# left out, not needed by the table above: (.*)$", scene.lines, re.MULTILINE).group(1)
    deck.expect("  and says what is left out", ("critical load" in gone) == ("clm" not in words) and ("friction" in gone) == ("none" in words), gone)
    shown = [float(x) for x in re.search(r"pressure (\S+) to (\S+) \(estimated", scene.text).groups()]
    deck.expect_close("  bounds of the pressure", shown, [slip, rub], rtol=6e-3)
# a law without largest coefficient of friction: jamming lies between that of its least one and that of an infinite one
scene = Advice(coeff="roughness 0.01 friction brizmer 0.5 20")
scene.expect("brizmer", friction="needed", critical_load="needed")
deck.expect("  why", "act at every load" in scene.text)
deck.expect("  the line follows", "friction brizmer 0.5 20" in scene.lines, scene.lines)
shown = [float(x) for x in re.search(r"pressure (\S+) to (\S+) \(estimated", scene.text).groups()]
deck.expect_close("  bounds of the pressure", shown, [rub, 1 / ((0.6301 - 0.0794) / phi - 1)**2], rtol=6e-3)
# once the pressure is known they are one
scene = Advice(coeff="roughness 0.01 friction clm step 0.5 1000", words="pressure 15")
scene.expect("clm, pressure given", friction="not needed", critical_load="not needed")
deck.expect("  the line follows", "friction none" in scene.lines, scene.lines)
# a film that is needed is on in the lines
scene = Advice(range="cut 0.5 shear no")
deck.expect("a film that is off", "pair_style lubcontact 1 cut 0.5 twist no\n" in scene.lines and "# needed, but off so far: shear" in scene.lines,
            scene.lines)

# short
scene = Advice(words="brief")
deck.expect("brief: verdicts, warnings, lines", len(scene.answers) == len(EFFECTS) and "Input lines to use" in scene.text and
            "what is there" not in scene.text and "Dimensionless" not in scene.text)

# the same at an imposed pressure, viscous number, and with a temperature: kT = T in these units
scene = Advice(flow="fix flow all deform/rheometer iv 0.2 pressure 5.0", words="temperature 0.01 fluid_density 0.3 critical 50 repulsion 0.1 adhesion 30")
deck.expect_close("iv: rate", float(re.search(r"rate ([^ ,]+), pressure 5$", scene.text, re.MULTILINE).group(1)), 1.0, rtol=1e-6)
deck.expect_close("iv: Pe", scene.number("Pe"), 600 * np.pi * a**3, rtol=6e-3)
deck.expect_close("iv: Re", scene.number("Re"), 0.3 * a**2, rtol=6e-3)
scene.expect("iv", Brownian_motion="not needed", fluid_inertia="beyond this package", critical_load="needed", repulsion="not needed",
             adhesion="needed")
# what the deck has not is to be added: the adhesion as its length, F/(k a)
found = re.search(r"# add to pair_coeff: friction clm step 0.5 50 adhesion (\S+)$", scene.lines, re.MULTILINE)
deck.expect_close("iv: words of the laws", float(found.group(1)), 30 / (1e6 * a), rtol=1e-6)
scene = Advice(flow="fix flow all deform/rheometer iv 0.2 pressure 5.0", words="repulsion 30 0.05 friction 0.3")
deck.expect("iv: length of the repulsion", "  # add to pair_coeff: repulsion 30 0.05\n" in scene.lines, scene.lines)
deck.expect("iv: nothing to add", "# add to" not in Advice(flow="fix flow all deform/rheometer iv 0.2 pressure 5.0").lines)
scene = Advice(words="temperature 0.1")
scene.expect("warm", Brownian_motion="beyond this package")

# dry grains by a variable, which a run has evaluated
scene = Advice(viscosity="v_dry", flow="fix flow all deform/rheometer rate 1.0 pressure 100 viscosity v_dry")
scene.expect("dry by variable, before a run", squeeze_film="cannot tell")
scene = Advice(viscosity="v_dry", flow="fix flow all deform/rheometer rate 1.0 pressure 100 viscosity v_dry", before="run 0")
scene.expect("dry by variable", squeeze_film="not needed", shear_film="not needed", roughness="not needed")
text = deck.run("in.scene_advice", viscosity="v_dry", flow="fix flow all deform/rheometer rate 1.0 pressure 100 viscosity v_dry", before="run 0",
                words="measure 10").text
deck.expect("dry by variable: measured", "everything on" in text and "nan" not in text[text.index("steps of a copy"):])

# particles that fall: no advice for shear
GRAVITY = "fix pull all gravity 9.81 vector 0 -1 0"
scene = Advice(flow=GRAVITY, before="run 0", words="fluid_density 0.02 temperature 0.01")
speed = 2 / 9 * 0.05 * 9.81 * a**2
for name, value in (("Stokes' velocity", speed), ("with buoyancy", 0.6 * speed), ("time until then", speed / 9.81), ("St = rho a v", 0.05 * a * speed),
                    ("Re = rho_f a v", 0.02 * a * speed), ("Pe = m g a", 0.05 * 9.81 * 4 / 3 * np.pi * a**4 / 0.01)):
    deck.expect_close(f"falling: {name}", scene.number(name), value, rtol=6e-3)
scene.expect("falling", squeeze_film="needed", shear_film="cannot tell", friction="cannot tell", drag="needed", particle_inertia="cannot tell",
             far_hydrodynamics="accuracy limited", fluid_inertia="not needed", elastic_compliance="cannot tell")
deck.expect("falling: no lines", "No input lines: the system is not sheared" in scene.text and "pair_style" not in scene.text)
deck.expect("falling: what gravity is", "gravity 9.81 (fix pull)" in scene.text and "of the whole box" in scene.text)
scene = Advice(flow=f'if "1 == 1" then "fix flow all deform/rheometer rate 1.0 volume" "{GRAVITY}"')
scene.warns("falling and sheared", "box is small", "what gravity does (fix pull) is in none of them")
scene = Advice(flow="print none")
deck.expect("no flow: no lines", "No input lines: what may be left out was measured in shear" in scene.text)

# dry grains
scene = Advice(viscosity=0.0, flow="fix flow all deform/rheometer rate 1.0 pressure 100 viscosity 0")
scene.expect("dry", squeeze_film="not needed", shear_film="not needed", rolling_film="not needed", twisting_film="not needed",
             friction="needed", particle_inertia="needed", roughness="not needed", drag="not needed")
deck.expect("dry: input lines", "pair_style lubcontact 0 cut 0.5 squeeze no shear no roll no twist no\n" in scene.lines, scene.lines)

# dilute
scene = Advice(scale=1.4)
scene.expect("dilute", drag="needed", far_hydrodynamics="needed", friction="not needed")
deck.expect_close("dilute: phi", float(re.search(r"phi (\S+), N", scene.text).group(1)), phi / 1.4**3, rtol=6e-3)
deck.expect("dilute: input lines", "  fix far all hydro mean\n" in scene.lines and "drag/background" not in scene.lines and "roughness 0.01 friction none\n" in scene.lines,
            scene.lines)

# between: the viscosity is too low, by what tests/validation/far_field has measured
scene = Advice(scale=1.08)
scene.expect("semi-dilute", drag="needed", far_hydrodynamics="needed")
low = float(re.search(r"viscosity about (\S+) % low with films alone: phi", scene.text).group(1))
deck.expect_close("semi-dilute: viscosity too low by", low, np.interp(phi / 1.08**3, [0.3, 0.35, 0.4, 0.45], [40, 33, 22, 12]), atol=0.3)

# inertial, and so much that the films are idle
Advice(density=5.0).expect("inertial", particle_inertia="needed", squeeze_film="needed")
Advice(density=5000.0, dt=1e-3).expect("collisional", particle_inertia="needed", squeeze_film="not needed", shear_film="not needed")

# soft, with a long time step
scene = Advice(g=1e3, dt=1e-2)
scene.expect("soft", elastic_compliance="needed")
scene.warns("soft", "asperities are crushed flat", "the time step exceeds", "box is small")
deck.expect("soft: a shorter step", re.search(r"^  timestep \S+$", scene.lines, re.MULTILINE) is not None)

# slow: squeeze films carry little, and were left out in a measurement; not where particles collide, nor nearer to jamming
SLOW = {"flow": "fix flow all deform/rheometer rate 7e-3 pressure 1.0"}
scene = Advice(**SLOW)
scene.expect("slow", squeeze_film="not needed", shear_film="needed")
deck.expect("slow: no room for inertia without it", " squeeze no" in scene.lines and float(re.search(r"density (\S+) allows", scene.lines).group(1)) < 8)
for what, case in {"collisions": {**SLOW, "density": 72}, "near jamming": {"flow": "fix flow all deform/rheometer rate 1e-3 pressure 1.0"},
                   "no friction": {**SLOW, "coeff": "roughness 0.01"}}.items():
    scene = Advice(**case)
    scene.expect(f"slow, {what}", squeeze_film="needed")
    deck.expect("  and stays", "squeeze no" not in scene.lines, scene.lines)

# fix deform knows some rates at once, others after a run; another pair style, with all in words
for deform, before in (("erate 2.0", "print none"), (f"vel {2 * length}", "print none"), ("variable v_tilt v_speed", "run 1")):
    scene = Advice(flow=f"fix flow all deform 1 xy {deform} units box remap v", before=before)
    deck.expect_close(f"fix deform {deform}: St", scene.number("St"), 0.1 * a**2, rtol=6e-3)
scene = Advice(flow="fix flow all deform 1 xy variable v_tilt v_speed remap v")
deck.expect("fix deform variable: no rate yet", np.isnan(scene.number("St")))
scene = Advice(style="zero", flow="print none", words="viscosity 2 rate 3 pressure 60 stiffness 1e7 roughness 0.01 friction 0.3")
deck.expect_close("words: St", scene.number("St"), 0.075 * a**2, rtol=6e-3)
deck.expect_close("words: Iv", scene.number("Iv ="), 0.1, rtol=6e-3)
deck.expect("words: input lines", "  pair_style lubcontact 2 cut 0.5 twist no\n" in scene.lines, scene.lines)

scene = Advice(style="zero", flow="print none", words="viscosity 2 rate 3 pressure 60 stiffness 1e7 roughness 0.01 friction 0.3 "
               "critical 100 adhesion 200 repulsion 300 0.02")
found = re.search(r"roughness 0.01 friction clm step 0.3 100 adhesion (\S+) repulsion 300 0.02$", scene.lines, re.MULTILINE)
deck.expect_close("words: laws in the input lines", float(found.group(1)), 200 / (1e7 * a), rtol=1e-6)

# units in which pressure, energy and mass need factors: kcal/mol/A^3 to atm, (g/mol)(A/fs)^2 to kcal/mol, K to kcal/mol
scene = Advice(units="real", style="zero", flow="print none", density=3.0, words="viscosity 2 rate 3e-2 pressure 60 stiffness 1e7 "
               "temperature 300 fluid_density 1.5")
for name, value in (("St", 2390.057 * 3 * a**2 * 0.015), ("Iv =", 0.06 * 68568.415 / 60), ("E/P", 1e7 / a * 68568.415 / 60),
                    ("I =", 2 * a * 0.03 * np.sqrt(2390.057 * 3 * 68568.415 / 60)), ("Re", 2390.057 * 1.5 * a**2 * 0.015),
                    ("Pe", 6 * np.pi * a**3 * 0.06 / (0.0019872067 * 300))):
    deck.expect_close(f"units real: {name}", scene.number(name), value, rtol=6e-3)
deck.expect("units real: density and pressure as given", ", density 3\n" in scene.text and ", pressure 60\n" in scene.text)

# plates: rate and volume fraction of the fix, its pressure, imposed or measured
for load in ("pressure 5", "gap"):
    scene = Advice("in.plates", load=load, steps=2500)
    shown = [float(x) for x in re.search(r"viscosity 1, rate (\S+), pressure (\S+)", scene.text).groups()]
    expected = [0.5, 5.0 if load != "gap" else scene.values["measured"]]
    deck.expect_close(f"plates, {load}: rate and pressure", shown, expected, rtol=6e-3)
    deck.expect_close(f"plates, {load}: volume fraction", float(re.search(r"box +phi ([^ ,]+),", scene.text).group(1)),
                      scene.values["phi"], rtol=6e-3)
    deck.expect("  walls", ", walls\n" in scene.text)
    phi = scene.values["phi"]    # permeability of an array of spheres of radius 1, Beetstra
    k = 2 / (9 * phi * (10 * phi / (1 - phi)**3 + (1 - phi) * (1 + 1.5 * np.sqrt(phi))))
    pores = scene.number("Iv =") * scene.values["gap"]**2 / k
    deck.expect_close("  Pi of the pores", scene.number("Pi ="), pores, rtol=6e-3)
    deck.expect("  fix pore/pressure is advised", ("add fix pore/pressure" in scene.text) == (pores > 1), f"Pi {pores:.3g}")
    deck.expect("  a mean is doubtful", ("the pressure is a mean over a strain of 0.125 only" in scene.text) == (load == "gap"))
deck.expect("a viscous fluid cannot follow", "in a transient the volume waits for the fluid in the pores: add fix pore/pressure"
            in Advice("in.plates", words="viscosity 100").text)
deck.expect("no layer, no pores", "Pi =" not in Advice(style="zero", flow="print none").text)
deck.expect("nothing known", set(Advice(style="zero", flow="print none").answers.values()) == {"cannot tell"})
deck.finish()
