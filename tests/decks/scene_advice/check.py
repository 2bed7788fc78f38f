"""The advice of suspension_scene for known scenes: numbers by hand, and which effects they call for."""
import re

import numpy as np

import deck

EFFECTS = ("squeeze film", "shear film", "rolling film", "twisting film", "friction", "critical load", "adhesion", "repulsion",
           "drag", "particle inertia", "roughness", "elastic compliance", "Brownian motion", "far hydrodynamics", "fluid inertia")
ANSWERS = "needed|not needed|accuracy limited|beyond this package|cannot tell"


class Advice:
    def __init__(self, name="in.scene_advice", **variables):
        run = deck.run(name, **variables)
        self.text, self.values = run.text, run.values
        self.text = self.text[self.text.index("Suspension scene: what is there"):]
        self.answers = {e: re.search(rf"^  {e} +({ANSWERS}) ", self.text, re.MULTILINE).group(1) for e in EFFECTS}
        self.lines = self.text[self.text.index("Deck lines to use"):]

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
deck.expect("dense: deck lines", "  pair_style lubcontact 1 cut 0.5 twist no\n  pair_coeff * * 1000000 1000000 asperity 1000000 roughness 0.01 "
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
deck.expect("after a run: the pressure is measured", "estimated" not in scene.text)

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

# dry grains
scene = Advice(viscosity=0.0, flow="fix flow all deform/rheometer rate 1.0 pressure 100 viscosity 0")
scene.expect("dry", squeeze_film="not needed", shear_film="not needed", rolling_film="not needed", twisting_film="not needed",
             friction="needed", particle_inertia="needed", roughness="not needed", drag="not needed")
deck.expect("dry: deck lines", "pair_style lubcontact 0 cut 0.5 squeeze no shear no roll no twist no\n" in scene.lines, scene.lines)

# dilute
scene = Advice(scale=1.4)
scene.expect("dilute", drag="needed", far_hydrodynamics="beyond this package", friction="not needed")
deck.expect_close("dilute: phi", float(re.search(r"phi (\S+), N", scene.text).group(1)), phi / 1.4**3, rtol=6e-3)
deck.expect("dilute: deck lines", "fix drag all drag/background pair cell\n" in scene.lines and "roughness 0.01 friction none\n" in scene.lines,
            scene.lines)

# between: the viscosity is too low, by what examples/shear_rate has measured at 0.40 and 0.30
scene = Advice(scale=1.08)
scene.expect("semi-dilute", drag="needed", far_hydrodynamics="accuracy limited")
low = float(re.search(r"viscosity about (\S+) % low: phi", scene.text).group(1))
deck.expect_close("semi-dilute: viscosity too low by", low, np.interp(phi / 1.08**3, [0.30, 0.40], [40, 20]), atol=0.3)

# inertial, and so much that the films are idle
Advice(density=5.0).expect("inertial", particle_inertia="needed", squeeze_film="needed")
Advice(density=5000.0, dt=1e-3).expect("collisional", particle_inertia="needed", squeeze_film="not needed", shear_film="not needed")

# soft, with a long time step
scene = Advice(g=1e3, dt=1e-2)
scene.expect("soft", elastic_compliance="needed")
scene.warns("soft", "asperities are crushed flat", "the time step exceeds", "box is small")
deck.expect("soft: a shorter step", re.search(r"^  timestep \S+$", scene.lines, re.MULTILINE) is not None)

# quasi-static: squeeze films carry nothing
Advice(flow="fix flow all deform/rheometer rate 1e-3 pressure 1.0").expect("slow", squeeze_film="not needed", shear_film="needed")

# fix deform knows some rates at once, others after a run; another pair style, with all in words
for deform, before in (("erate 2.0", "print none"), (f"vel {2 * length}", "print none"), ("variable v_tilt v_speed", "run 1")):
    scene = Advice(flow=f"fix flow all deform 1 xy {deform} units box remap v", before=before)
    deck.expect_close(f"fix deform {deform}: St", scene.number("St"), 0.1 * a**2, rtol=6e-3)
scene = Advice(flow="fix flow all deform 1 xy variable v_tilt v_speed remap v")
deck.expect("fix deform variable: no rate yet", np.isnan(scene.number("St")))
scene = Advice(style="zero", flow="print none", words="viscosity 2 rate 3 pressure 60 stiffness 1e7 roughness 0.01 friction 0.3")
deck.expect_close("words: St", scene.number("St"), 0.075 * a**2, rtol=6e-3)
deck.expect_close("words: Iv", scene.number("Iv ="), 0.1, rtol=6e-3)
deck.expect("words: deck lines", "  pair_style lubcontact 2 cut 0.5 twist no\n" in scene.lines, scene.lines)

scene = Advice(style="zero", flow="print none", words="viscosity 2 rate 3 pressure 60 stiffness 1e7 roughness 0.01 friction 0.3 "
               "critical 100 adhesion 200 repulsion 300 0.02")
found = re.search(r"roughness 0.01 friction clm step 0.3 100 adhesion (\S+) repulsion 300 0.02$", scene.lines, re.MULTILINE)
deck.expect_close("words: laws in the deck lines", float(found.group(1)), 200 / (1e7 * a), rtol=1e-6)

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
    scene = Advice("in.plates", load=load)
    shown = [float(x) for x in re.search(r"viscosity 1, rate (\S+), pressure (\S+)", scene.text).groups()]
    expected = [0.5, 5.0 if load != "gap" else scene.values["measured"]]
    deck.expect_close(f"plates, {load}: rate and pressure", shown, expected, rtol=6e-3)
    deck.expect_close(f"plates, {load}: volume fraction", float(re.search(r"box +phi ([^ ,]+),", scene.text).group(1)),
                      scene.values["phi"], rtol=6e-3)
    deck.expect("  walls", ", walls\n" in scene.text)
deck.expect("nothing known", set(Advice(style="zero", flow="print none").answers.values()) == {"cannot tell"})
deck.finish()
