"""Every refused argument of suspension_scene: the message says what, the value found and the cure, and underlines the word."""
import deck

SHEAR = "fix shear all deform/rheometer rate 1.0 volume\n"
GRAVITY = SHEAR + "fix pull all gravity 1.0 vector 0 -1 0\n"
CASES = [    # lines, message, underlined word or None
    ("suspension_scene rates 1", "Unknown suspension_scene keyword: rates; those that exist: measure, viscosity, rate", "rates"),
    ("suspension_scene rate", "missing argument", None),
    ("suspension_scene rate 0", "rate must be > 0, but is 0", "0"),
    ("suspension_scene temperature -1", "temperature must be >= 0, but is -1", "-1"),
    ("suspension_scene pressure high", "instead of 'high'", None),
    ("suspension_scene measure", "missing argument", None),
    ("suspension_scene measure 25", "takes a multiple of 10 steps, but not 25", "25"),
    ("suspension_scene measure 0", "takes a multiple of 10 steps, but not 0", "0"),
    ("suspension_scene measure 10 changes 1", "keyword: changes; the only one is change", "changes"),
    ("suspension_scene measure 10 change", "missing argument", None),
    ("suspension_scene measure 10 change 0", "change must be > 0, but is 0", "0"),
    ("suspension_scene measure 10", "needs a flow: fix deform/rheometer, or fix deform of xy with remap v", None),
    ("fix shear all deform 1 xy erate 1.0\nsuspension_scene measure 10", "cannot copy fix shear of style deform", None),
    (GRAVITY + "suspension_scene measure 10", "cannot copy fix pull of style gravity; the advice without the word measure", None),
    (SHEAR + "neigh_modify exclude type 1 1\nsuspension_scene measure 10", "cannot copy neigh_modify exclude", None),
    (SHEAR + "pair_style zero 3.0\npair_coeff * *\nsuspension_scene measure 10", "alone, but the pair style is zero", None),
    # an error of the copy: its step is far too long
    (SHEAR + "timestep 0.5\nsuspension_scene measure 100", "Suspension_scene measure, in its copy: ", None),
    ("delete_atoms group all\nsuspension_scene", "needs particles: use it after they are created", None),
]

TEMPLATE = (deck.CASE / "in.scene_refused").read_text()


def run(lines, fails):
    """The deck with the lines written into it: LAMMPS cannot underline a word that came from a variable."""
    deck.Path("in.now").write_text(TEMPLATE + lines + "\n")
    return deck.run(str(deck.Path.cwd() / "in.now"), fails=fails).text


deck.make_state()
for lines, message, word in CASES:
    deck.expect_error(lines.splitlines()[-1], run(lines, fails=True), message, word)
text = run(GRAVITY + "suspension_scene", fails=False)
deck.expect("the advice works with any fix", "Which effects this scene calls for" in text)
deck.finish()
