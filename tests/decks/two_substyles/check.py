# ranks: 1 2
"""Two sub-styles lubcontact that share the pairs: limits of the time step, partners and viscosity are those of one style for all."""
import re

import deck

TYPES = {"types": 2}
deck.make_state(**TYPES)


def limits(text, before):
    return [float(x) for x in re.findall(before + r".*of the stability limit (\S+)$", text, re.MULTILINE)]


MOVE = 'if "1 == 1" then "unfix move" "fix o all overdamped/sphere pair" "timestep 1e-5"'
DRAG = 'if "1 == 1" then "unfix move" "fix move all nve/sphere" "fix d all drag/background 1 isolated 9" "thermo_style custom step f_d[8]"'
one, two = deck.run("in.two"), deck.run("in.two", way="two")
expected = limits(one.text, "  time step")
found = limits(two.text, "  time step")
deck.expect("both sub-styles print a limit", len(found) == 2 and len(expected) == 1)
deck.expect_close("limit of the time step", found, expected[0], rtol=1e-5)
one, two = deck.run("in.two", fix=MOVE), deck.run("in.two", way="two", fix=MOVE)
deck.expect_close("limit without inertia", limits(two.text, "Fix overdamped"), limits(one.text, "Fix overdamped"), rtol=1e-5)
one, two = deck.run("in.two", fix=DRAG), deck.run("in.two", way="two", fix=DRAG)
dragged = one.thermo()["f_d[8]"]
deck.expect("some are isolated, others are not", 0 < dragged[0] < 200, dragged)
deck.expect_close("isolated particles", two.thermo()["f_d[8]"], dragged)

text = deck.run("in.two", way="two", fix='if "1 == 1" then "timestep 0.1" "run 0" "timestep 1e-4"').text
deck.expect("one warning", text.count("the stability limit of the contact springs") == 1)

for fix, message in (
        ("fix d all drag/background pair", "Fix drag/background eta pair: the sub-styles lubcontact have different viscosities, 1 and 2"),
        ("fix f all deform/rheometer rate 1 pressure 1 start 1", "have different viscosities, 1 and 2; give it: viscosity eta")):
    deck.expect_error(fix, deck.run("in.two", fails=True, way="two", eta2="2.0", fix=fix).text, message)
for fix in ("fix d all drag/background 1", "fix f all deform/rheometer rate 1 volume start 1",
            "fix f all deform/rheometer rate 1 pressure 1 start 1 viscosity 1"):
    deck.run("in.two", way="two", eta2="2.0", fix=fix)
deck.expect_error("partners twice", deck.run("in.two", fails=True, way="overlay", fix="fix d all drag/background 1 isolated").text,
                  "isolated would count the partners of types 1 2 2 times, once for each sub-style lubcontact: assign these types to one")
deck.finish()
