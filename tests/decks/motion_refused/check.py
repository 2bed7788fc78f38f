"""Every refused argument of fix drag/background and fix overdamped/sphere, and every scene in which they cannot act."""
import deck

D, O = "fix d all drag/background", "fix o all overdamped/sphere"
CASES = [    # lines in place of the fix, message, underlined word or None, variables
    (D, "missing argument", None),
    (D + " thick", "instead of 'thick'", None),
    (D + " -2", "viscosity must be >= 0, but is -2", "-2"),
    (D + " v_none", "Variable none for fix drag/background viscosity does not exist", None),
    (D + " v_per_atom", "Variable per_atom for fix drag/background viscosity is not equal-style", None),
    (D + " v_minus", "viscosity must be >= 0, but is -1 at step 0", None),
    (D + " pair", "there is no pair style lubcontact; give the viscosity instead of pair", None, {"pair": "zero 2.5", "coeff": ""}),
    (D + " pair", "the viscosity of pair style lubcontact is a variable", None, {"pair": "lubcontact v_eta cut 0.5"}),
    (D + " 1 flow 2", "Unknown fix drag/background keyword: flow", "flow"),
    (D + " 1 shear", "missing argument", None),
    (D + " 1 shear 1 shear 2", "shear is given twice", "shear"),
    (D + " 1 shear 1 cell", "already has flow shear; remove cell", "cell"),
    (D + " 1 couette 0 1 -2 1", "the upper wall must be above the lower one at y = 0, but is at -2", "-2"),
    (D + " 1 poiseuille 3 3 1", "the upper wall must be above the lower one at y = 3, but is at 3", "3"),
    (D + " 1 poiseuille 3 v_eta 1", "the upper wall must be above the lower one at y = 3, but is at 1 at step 0", None),
    (D + " 1 velocity 1 2", "missing argument", None),
    (D + " 1 velocity v_none 0 0", "Variable none for fix drag/background velocity does not exist", None),
    (D + " 1 velocity v_word 0 0", "is neither equal- nor atom-style", None),
    (D + " 1 spin 0 0 1", "spin cannot act without velocity", "spin"),
    (D + " 1 cell", "the cell does not deform", None),
    ("fix c all deform 1 x erate 0.1\n" + D + " 1 cell", "add to fix deform: remap v", None),
    ("fix c one deform 1 x erate 0.1 remap v\n" + D + " 1 cell", "use group all for fix c", None),
    (D + " 1 plates p", "p is not the ID of a fix rheometer/plates", None),
    (D + " 1 shape round", "shape must be sphere or disc, but is round", "round"),
    (D + " 1 shape disc", "shape disc needs a 2d simulation", "disc", {"dim": 3}),
    (D + " 1 hindrance some", "instead of 'some'", None),
    (D + " 1 hindrance -1", "hindrance must be >= 0, but is -1", "-1"),
    (D + " 1 hindrance phi 1.5", "hindrance phi must be >= 0 and < 1, but is 1.5", "1.5"),
    (D + " 1 hindrance phi v_eta", "the volume fraction must be >= 0 and < 1, but is 1 at step 0", None),
    (D + " 1 isolated 0", "isolated must be > 0, but is 0", "0"),
    (D + " 1 isolated", "which is not defined", None, {"pair": "zero 2.5", "coeff": ""}),
    (D + " 1 others 0.1", "others cannot act without isolated; for a weaker drag on all particles use hindrance", "others"),
    (D + " 1 isolated 3 others", "missing argument", None),
    (D + " 1 isolated others -1", "others must be >= 0, but is -1", "-1"),
    (D + " 1 isolated others weak", "instead of 'weak'", None),
    (D + " 1 isolated others v_none", "Variable none for fix drag/background others does not exist", None),
    (D + " 1 isolated others v_minus", "others must be >= 0, but is -1 at step 0", None),
    (D + " 1 isolated others 1 isolated", "isolated is given twice", "isolated"),
    (O + " 1 isolated 3 others 0.1", "cannot move particles without drag: remove isolated", "isolated"),
    (D + " 1", "use: atom_style sphere", None, {"atoms": "atomic", "pair": "zero 2.5", "coeff": ""}),
    (D + " 1\nrun_style respa 2 2", "use: run_style verlet", None),
    (D + " 1\nfix e two drag/background 1", "Fixes d and e both act on the same particles", None),
    (D + " 1\nfix push two addforce 1 0 0", "define fix d after fix push", None),
    (D + " 1\n" + O + " 1", "which already applies the drag", None),
    (O, "missing argument", None),
    (O + " 1 isolated 3", "cannot move particles without drag: remove isolated", "isolated"),
    (O + " 0", "without drag: viscosity, hindrance and radius must be > 0", None),
    ("fix move all nve/sphere\n" + O + " 1", "Fix move nve/sphere and fix overdamped/sphere both move 2 particles: remove fix move", None),
    (O + " 1 hindrance 0", "cannot move atom", None),
]
TEMPLATE = (deck.CASE / "in.refused").read_text()
DEFAULTS = {"dim": 2, "atoms": "sphere", "pair": "lubcontact 1.0 cut 0.5", "coeff": "1e4 5e3"}


def run(fix, fails, **variables):
    """The deck with the values written into it: LAMMPS cannot underline a word that came from a variable."""
    text = TEMPLATE.replace("${fix}", fix)
    for name, value in {**DEFAULTS, **variables}.items():
        text = text.replace(f"${{{name}}}", str(value))
    deck.Path("in.now").write_text(text)
    return deck.run(str(deck.Path.cwd() / "in.now"), fails=fails).text


for fix, message, word, *more in CASES:
    deck.expect_error(fix.replace("\n", "; "), run(fix, True, **(more[0] if more else {})), message, word)

# what may come after the drag: fixes of other particles, and those that set forces whatever they were
run("fix a one drag/background 1\nfix b two drag/background 2\nfix c one setforce 0 0 0\nfix f all enforce2d", False)
deck.finish()
