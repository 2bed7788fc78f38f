"""Every refused argument of the rheometer: what is wrong, the value found, the cure; the wrong word is underlined."""
import deck

GOOD = {"dim": 3, "boundary": "p p p", "atoms": "sphere", "z": "0 12", "cell": "change_box all triclinic",
        "pair": "lubcontact 1 cut 0.5", "coeff": "* * 1e4 5e3", "before": "", "group": "all", "args": "rate 1 volume",
        "after": ""}
NO_PAIR = {"pair": "zero 2.5", "coeff": "* *"}
VARIABLE_ETA = {"pair": "lubcontact v_eta cut 0.5"}
CASES = [    # what is wrong, message, underlined word or None
    ({"args": ""}, "missing argument", None),
    ({"args": "flow"}, "missing argument", None),
    ({"args": "rate"}, "missing argument", None),
    ({"args": "rate 1"}, "needs one of: pressure, volume", None),
    ({"args": "volume"}, "needs one of: rate, iv, stress, oscillate", None),
    ({"args": "rate 1 pressure"}, "missing argument", None),
    ({"args": "oscillate 0 1 volume"}, "instead of 'volume'", None),
    ({"args": "oscillate 0 1"}, "missing argument", None),
    ({"args": "oscillate 0 1 v_local volume"}, "Variable local for fix deform/rheometer oscillate is not equal-style", None),
    ({"args": "oscillate 0 v_none 1 volume"}, "Variable none for fix deform/rheometer oscillate does not exist", None),
    ({"args": "rate 1 volume start"}, "missing argument", None),
    ({"args": "rate 1 volume gain"}, "missing argument", None),
    ({"args": "rate 1 volume viscosity"}, "missing argument", None),
    ({"args": "flow couette rate 1 volume"}, "flow must be shear, planar or uniaxial, but is couette", "couette"),
    ({"args": "rate 1 volume gdot 2"}, "Unknown fix deform/rheometer keyword: gdot", "gdot"),
    ({"args": "rate fast volume"}, "instead of 'fast'", None),
    ({"args": "rate 1 stress 2 volume"}, "accepts only one of rate, iv, stress, oscillate; remove stress", "stress"),
    ({"args": "rate 1 volume pressure 2"}, "accepts only one of pressure, volume; remove pressure", "pressure"),
    ({"args": "rate 1 pressure 0"}, "pressure must be > 0, but is 0", "0"),
    ({"args": "rate 1 pressure v_negative"}, "pressure must be > 0, but is 0", None),
    ({"args": "rate 1 volume viscosity -1"}, "viscosity must be >= 0, but is -1", "-1"),
    ({"args": "rate 1 volume viscosity v_negative"}, "viscosity must be >= 0, but is -", None),
    ({"args": "rate 1 pressure 1 gain 0"}, "gain must be > 0, but is 0", "0"),
    ({"args": "rate 1 volume every 0"}, "every must be > 0, but is 0", "0"),
    ({"args": "rate 1 volume every"}, "missing argument", None),
    ({"after": "fix_modify r every 2"}, "cannot be changed by fix_modify", None),
    ({"args": "rate 1 volume gain 2"}, "gain cannot act at constant volume", "gain"),
    ({"args": "iv 0.1 volume"}, "cannot impose a viscous number at constant volume", None),
    ({"args": "iv 0.1 pressure 1 viscosity 0"}, "cannot impose a viscous number without viscosity", None),
    ({"args": "rate v_none volume"}, "Variable none for fix deform/rheometer rate does not exist", None),
    ({"args": "rate v_local volume"}, "Variable local for fix deform/rheometer rate is not equal-style", None),
    ({"args": "rate 1 pressure 1", **NO_PAIR}, "needs the viscosity of the fluid; add: viscosity eta", None),
    ({"args": "rate 1 pressure 1", **VARIABLE_ETA}, "viscosity v_name", None),
    ({"cell": ""}, "add: change_box all triclinic", None),
    ({"cell": "change_box all triclinic xz final 1 boundary p p p"},
     "without tilts xz and yz, but they are 1 and 0", None),
    ({"cell": "change_box all triclinic xy final 1 boundary p p p", "args": "flow planar rate 1 volume"},
     "needs a cell without tilt for extension, but xy is 1", None),
    ({"boundary": "f p p"}, "needs a cell that is periodic in the directions of the flow", None),
    ({"boundary": "p f p"}, "periodic", None),
    ({"boundary": "p p f", "cell": "", "args": "flow planar rate 1 volume"},
     "periodic in the directions of the flow", None),
    ({"dim": 2, "z": "-0.5 0.5", "args": "flow uniaxial rate 1 volume"},
     "no uniaxial flow in 2d; use planar", "uniaxial"),
    ({"atoms": "atomic", **NO_PAIR}, "use: atom_style sphere", None),
    ({"group": "none"}, "no particles with a radius in its group", None),
    ({"after": "run_style respa 2 2"}, "does not work with run_style respa; use: run_style verlet", None),
    ({"after": "run_style respa 2 2", "args": "rate 1 volume viscosity 1", **NO_PAIR},
     "Fix deform/rheometer does not work with run_style respa", None),
    ({"after": "change_box all boundary s p p"}, "needs a cell that is periodic in the directions of the flow", None),
    ({"after": "change_box all boundary p f p"}, "needs a cell that is periodic in the directions of the flow", None),
    ({"after": "change_box all boundary p p f", "cell": "", "args": "flow planar rate 1 volume"},
     "needs a cell that is periodic in the directions of the flow", None),
    ({"after": "fix other all deform 1 z erate 1"}, "More than one fix deform", None),
    ({"after": "fix other all deform 1 y erate 1"}, "multiple fixes", None),
    ({"after": "uncompute r_virial"}, "was deleted", None),
    ({"after": "fix_modify r"}, "missing argument", None),
    ({"after": "fix_modify r rate"}, "missing argument", None),
    ({"after": "fix_modify r pressure -1"}, "pressure must be > 0, but is -1", None),
    ({"after": "fix_modify r flow planar"}, "cannot be changed by fix_modify", None),
    ({"after": "fix_modify r start 1"}, "cannot be changed by fix_modify", None),
    ({"after": "fix_modify r iv 0.1"}, "cannot impose a viscous number at constant volume", None),
    ({"after": "fix_modify r rate v_none"}, "Variable none for fix deform/rheometer rate does not exist", None),
    ({"after": "change_box all ortho"}, "with certain fixes defined", None),
    ({"cell": "change_box all triclinic x final 0 4.9 units box"}, "has come below twice the cutoff", None),
    ({"before": "compute T all temp\nfix other all npt temp 1 1 1 y 1 1 1"}, "multiple fixes", None),
]
TEMPLATE = (deck.CASE / "in.refused").read_text()


def run(variables, fails):
    """The deck with the values written into it: LAMMPS cannot underline a word that came from a variable."""
    text = TEMPLATE
    for name, value in {**GOOD, **variables}.items():
        text = text.replace(f"${{{name}}}", str(value))
    deck.Path("in.now").write_text(text)
    return deck.run(str(deck.Path.cwd() / "in.now"), fails=fails).text


run({}, fails=False)
for variables, message, word in CASES:
    deck.expect_error(str(variables), run(variables, fails=True), message, word)
deck.finish()
