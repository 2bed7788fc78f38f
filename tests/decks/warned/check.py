"""Scenes that run, but not as meant, get a warning; advice does not rest on numbers that have changed since."""
import re

import deck

deck.make_state()


def log(**variables):
    return deck.run("in.warned", **{"words": "rate 1", **variables}).text


def limit(text):
    """Time step over its limit, the limit, and what it is, as the adviser has it."""
    found = re.search(r"^  time step +\S+, (\S+) of the stability limit (\S+)(.*)$", text[text.index("Suspension scene:"):], re.MULTILINE)
    return float(found.group(1)), float(found.group(2)), found.group(3)


REMAP, TURN = "particles that cross its boundary keep their velocity: add to fix deform: remap v", "does not rotate particles: use fix nve/sphere"
text = log(more="fix shear all deform 1 xy erate 1")
deck.expect("fix deform without remap v", REMAP in text)
text = log(more="fix shear all deform 1 xy erate 1 remap v")
deck.expect("with remap v", "WARNING" not in text)
text = log(more='if "1 == 1" then "unfix move" "fix move all nve"')
deck.expect("fix nve", TURN in text)

plain = limit(text)[1]
heavier = limit(log(more='if "1 == 1" then "unfix move" "fix move all nve"', then="set group all density 0.2"))
deck.expect_close("four times the mass since the run: twice the limit", heavier[1], 2 * plain, rtol=0.01)
stiffer = limit(log(then="pair_coeff * * 1e6 5e5 roughness 0.01"))
deck.expect("other coefficients: an estimate", "estimated for 12 neighbors" in stiffer[2] and stiffer[1] < 0.2 * plain, stiffer)
massless = log(more='if "1 == 1" then "unfix move" "fix move all overdamped/sphere pair velocity 0 0 0" "timestep 1e-5"')
deck.expect("nothing has inertia", "without limit here: no pair in range of particles with inertia" in massless)
deck.expect("  the adviser, too", "fix overdamped/sphere has its own" in massless)
deck.expect("  and proposes no density", "inertia does not show: density" not in massless)

text = log(words="rate 1 viscosity 3 roughness 0.02 tolerance 0.2")
deck.expect("words that the lines do not set", "# for the scene with viscosity 3 roughness 0.02, which the lines do not set" in text)
text = log(words="pressure 10 tolerance 0.2")
deck.expect("no rate, no settings", "cannot tell: give the shear rate: rate g" in text and "nan" not in text[text.index("Settings"):])
text = log(more="fix shear all deform/rheometer rate 1 volume", words="tolerance 0.2")
deck.expect("pressure of the start", "(estimated from phi); measured over a strain of 0.024, too short for a mean" in text)
deck.expect("settings for a tolerance come once, without the advice", "Effects that this system needs" not in text and
            text.count("Suspension scene") == 0)
text = log(more="fix shear all deform/rheometer rate 1 volume", coeffs="friction clm step 0.5 20", words="tolerance 0.2")
deck.expect("no settings for a pressure that may be two", "cannot tell: the pressure, on which the stiffness rests, is not known before" in text)
text = log(more="fix shear all deform/rheometer rate 1 volume", coeffs="friction clm step 0.5 20", words="tolerance 0.2 pressure 30")
deck.expect("  but for a given one", "Input lines to use" in text)
# a critical load that nothing reaches: the pressure is a quarter of that with friction, which is no reason to warn
text = log(more="fix shear all deform/rheometer rate 1 volume", then="run 4000 post no", coeffs="friction clm step 0.5 1000", words="brief")
deck.expect("steady without friction: no alarm", "warning: the measured pressure" not in text and "warning: the pressure" not in text)
deck.expect("  friction and its critical load are left out", "left out, not needed by the table above: twist, friction, critical load" in text)

LIMIT, RESET = "the stability limit of the contact springs", "fix step all dt/reset 5 {0} {1} 100"
deck.expect("no warning below the limit", LIMIT not in log())
deck.expect("fix dt/reset beyond the limit warns once", log(more=RESET.format(plain, 1.2 * plain)).count(LIMIT) == 1)
massless = 'if "1 == 1" then "unfix move" "fix move all overdamped/sphere pair" "timestep 1e-5" '
slow = float(re.search(r"^Fix overdamped/sphere: .* stability limit (\S+)$", log(more=massless), re.MULTILINE).group(1))
text = log(more=massless + '"' + RESET.format(slow, 1.2 * slow) + '"')
deck.expect("  without inertia, too", text.count("against the drag of fix overdamped/sphere") == 1)
deck.expect("not between two runs", LIMIT not in log(then='if "1 == 1" then "timestep 1" "timestep 1e-4"'))

# skin of the neighbor lists: LAMMPS' default is one length for all particles
LONG = "times the largest radius: the lists are long and slow; use: neighbor 0."
largest = max(float(line.split()[2]) / 2 for line in open("state.data", encoding="ascii").read().split("Atoms")[1].split("Velocities")[0]
              .splitlines()[2:] if line)
for skin, warned in (1.95 * largest, False), (2.05 * largest, True):
    text = log(more=f"neighbor {skin} bin")
    deck.expect(f"skin of {skin / largest} largest radii warns: {warned}", (LONG in text) == warned)

# other contacts or films between the same particles
GRAN = '"pair_coeff * * gran/hooke/history"'
GRANULAR = '"pair_coeff * * granular hooke 1e4 0 tangential linear_nohistory 0.0 0.5"'
OURS = '"pair_coeff * * lubcontact 1e4 5e3 roughness 0.01"'
LUBRICATE = "lubricate 1e-6 1 1 1.81 2.5 1 0"    # of spheres of one size
DRY = "lubcontact 0 cut 0.1 squeeze no shear no roll no twist no"
TWICE = "act twice; lubcontact replaces the other style: remove it"
for styles, coeffs, words in (
        ("hybrid/overlay gran/hooke/history 1e4 NULL 0 NULL 0.5 1 lubcontact 1.0 cut 0.5", (GRAN, OURS),
         "lubcontact and gran/hooke/history both act on types 1 1, so elastic contacts act twice"),
        ("hybrid/overlay lubcontact 1.0 cut 0.5 granular", (OURS, GRANULAR), "lubcontact and granular both act on types 1 1, so elastic contacts act twice"),
        (f"hybrid/overlay lubcontact 1.0 cut 0.5 {LUBRICATE}", (OURS, '"pair_coeff * * lubricate"', '"set group all diameter 1.8"'),
         "lubcontact and lubricate both act on types 1 1, so films act twice"),
        (f"hybrid/overlay {DRY} {LUBRICATE}", (OURS, '"pair_coeff * * lubricate"', '"set group all diameter 1.8"'), None),
        ("hybrid/overlay lubcontact 1.0 cut 0.5 zero 2.5", (OURS, '"pair_coeff * * zero"'), None),
        ("hybrid/overlay lubcontact 1.0 cut 0.5 lubcontact 2.0 cut 0.3",
         ('"pair_coeff * * lubcontact 1 1e4 5e3 roughness 0.01"', '"pair_coeff * * lubcontact 2 1e4 5e3"'),
         "lubcontact and lubcontact both act on types 1 1, so contacts and films act twice")):
    text = log(more=f'if "1 == 1" then "pair_style {styles}" {" ".join(coeffs)}')
    deck.expect(f"{styles} warns: {words}", words is not None and words in text if words else TWICE not in text)
deck.make_state(types=2)
styles = "hybrid/overlay gran/hooke/history 1e4 NULL 0 NULL 0.5 1 lubcontact 1.0 cut 0.5 zero 2.5"
text = log(more=f'if "1 == 1" then "pair_style {styles}" "pair_coeff 2 2 gran/hooke/history" "pair_coeff 1 1 lubcontact 1e4 5e3" '
                '"pair_coeff * * zero"')
deck.expect("a granular style for other types", TWICE not in text)
deck.finish()
