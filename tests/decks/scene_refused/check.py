"""Every refused argument of suspension_scene: the message says what, the value found and the cure, and underlines the word."""
import deck

SHEAR = "fix shear all deform/rheometer rate 1.0 volume\n"
GRAVITY = SHEAR + "fix pull all gravity 1.0 vector 0 -1 0\n"
CHARGED = "clear\natom_style hybrid sphere charge\ncomm_modify vel yes\nregion box prism 0 12 0 12 0 12 0 0 0\ncreate_box 1 box\n" \
    "create_atoms 1 single 6 6 6\nset group all diameter 2 density 1\npair_style lubcontact 1.0 cut 0.5\n" \
    "pair_coeff * * 1e4 5e3 roughness 0.01\nfix move all nve/sphere\n" + SHEAR
SLIPPERY = "pair_coeff * * 1e4 5e3 roughness 0.01\n"
SMOOTH = "pair_coeff * * 1e4 5e3\n"
HYBRID = "pair_style hybrid lubcontact 1.0 cut 0.5 zero 3.0\npair_coeff * * lubcontact 1e4 5e3 roughness 0.01\n"
PLATES = "unfix move\ngroup lower id 1\ngroup upper id 2\ngroup between subtract all lower upper\n" \
    "fix move between nve/sphere\nfix cell between rheometer/plates lower upper rate 0.5 pressure 5\n"
CASES = [    # lines, message, underlined word or None
    ("suspension_scene rates 1", "Unknown suspension_scene keyword: rates; those that exist: measure, brief, viscosity, rate", "rates"),
    ("suspension_scene rate", "missing argument", None),
    ("suspension_scene rate 0", "rate must be > 0, but is 0", "0"),
    ("suspension_scene temperature -1", "temperature must be >= 0, but is -1", "-1"),
    ("suspension_scene repulsion 1 0", "length of the repulsion must be > 0, but is 0", "0"),
    ("suspension_scene pressure high", "instead of 'high'", None),
    ("suspension_scene measure", "missing argument", None),
    ("suspension_scene measure 25", "takes a number of steps that is a multiple of 10, but not 25", "25"),
    ("suspension_scene measure 0", "a multiple of 10, but not 0", "0"),
    ("suspension_scene measure 10 changes 1", "keyword: changes; those that exist: change, friction, critical, adhesion, repulsion",
     "changes"),
    ("suspension_scene measure 10 viscosity 1", "measure keyword: viscosity", "viscosity"),
    ("suspension_scene measure 10 repulsion 1", "missing argument", None),
    ("suspension_scene measure 10 repulsion 1 0", "repulsion must be > 0, but is 0", "0"),
    ("suspension_scene measure 10 friction 0", "friction must be > 0, but is 0", "0"),
    (SHEAR + SLIPPERY + "suspension_scene measure 10 critical 2", "critical cannot act without friction: give friction mu, too", "critical"),
    (SHEAR + SMOOTH + "suspension_scene measure 10 adhesion 2", "types 1 1 have none: give them a roughness > 0", "adhesion"),
    (SHEAR + "suspension_scene measure 10 adhesion 1e4", "Suspension_scene measure, in its copy: ", None),    # breaks out of range
    ("suspension_scene measure friction 0.5", "needs a number of steps before keywords, not friction", "friction"),
    ("suspension_scene brief tolerance 0.1", "brief cannot act with tolerance, which prints its settings only: remove one of them", None),
    ("suspension_scene tolerance 1", "is a relative error and must be < 1, but is 1", "1"),
    ("fix shear all deform/rheometer oscillate 0 1 3 volume\nsuspension_scene measure 10", "compares the viscosity of steady shear, but fix "
     "shear has: flow shear every 8 oscillate", None),
    ("fix shear all deform/rheometer flow planar rate 1 volume\nsuspension_scene measure 10", "has: flow planar", None),
    ("suspension_scene measure 10 change", "missing argument", None),
    ("suspension_scene measure 10 change 0", "change must be > 0, but is 0", "0"),
    ("suspension_scene measure 10", "needs a flow: fix deform/rheometer, or fix deform of xy with remap v", None),
    ("fix shear all deform 1 xy erate 1.0\nsuspension_scene measure 10", "cannot copy fix shear of style deform", None),
    (SHEAR + "variable u atom y\nfix d all drag/background 1 velocity v_u 0 0\nrun 0\nsuspension_scene measure 10",
     "cannot copy fix d: variable u is atom-style; suspension_scene without measure works", None),
    (SHEAR + "variable u equal 1.0\nfix d all drag/background v_u cell\nsuspension_scene measure 10",
     "cannot copy fix d: variable u has no value before the first run; add run 0", None),
    ("variable u equal 1.0\nfix d all pore/pressure v_u cell\n" + SHEAR + "suspension_scene measure 10",
     "cannot copy fix d: variable u has no value before the first run; add run 0", None),
    (SHEAR + "group now dynamic all every 1\nfix d now drag/background 1\nsuspension_scene measure 10",
     "cannot copy the dynamic group now of fix d; suspension_scene without measure works", None),
    (SHEAR + HYBRID + "suspension_scene measure 10", "lubcontact alone, but the pair style is hybrid; suspension_scene without measure works", None),
    (PLATES + "suspension_scene measure 10", "works in periodic cells and cannot copy the plates of fix cell; suspension_scene without measure works", None),
    (GRAVITY + "suspension_scene measure 10", "supports only sheared suspensions without other forces and cannot copy fix pull of style gravity: "
     "unfix it if it does not matter; suspension_scene without measure works; or compare two runs of your own", None),
    *((SHEAR + f"fix other all {style}\nsuspension_scene measure 10", f"cannot copy fix other of style {style.split()[0]}: unfix it", None)
      for style in ("addforce 0 1 0", "wall/lj93 ylo EDGE 1 1 1 pbc yes", "adapt 1 pair lubcontact friction * * v_one")),
    (SHEAR + "neigh_modify once yes exclude type 1 1\ngroup some id <= 100\natom_modify first some\nneigh_modify include some\n"
     "comm_modify group some\npair_modify compute no\nrun_style respa 2 2\nsuspension_scene measure 10",
     "measure cannot copy run_style respa, pair_modify compute no, neigh_modify exclude, neigh_modify include, neigh_modify once yes, "
     "comm_modify group; suspension_scene without measure works", None),
    (CHARGED + "suspension_scene measure 10", "what particles of atom_style hybrid sphere charge have beside those of atom_style sphere; "
     "suspension_scene without measure works", None),
    ("variable eta equal 1.0\npair_style lubcontact v_eta cut 0.5\npair_coeff * * 1e4 5e3 roughness 0.01\nfix shear all deform/rheometer rate 1.0 "
     "volume viscosity 1\nsuspension_scene measure 10", "does not know the viscosity of the pair style before the first run: add run 0", None),
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
if "LAMMPS (4 Feb 2025" in run("", fails=False):    # newer ones do not have these styles any more
    CASES += [(SHEAR + f"{line}\nsuspension_scene measure 10", f"cannot copy {name}; suspension_scene without measure works", None)
              for line, name in (("neighbor 0.3 multi/old", "neighbor multi/old"),
                                 ("comm_modify mode multi/old", "comm_modify mode multi/old"))]
for lines, message, word in CASES:
    deck.expect_error(lines.splitlines()[-1], run(lines, fails=True), message, word)
text = run(GRAVITY + "suspension_scene", fails=False)
deck.expect("the advice works with any fix", "Effects that this system needs" in text)
deck.finish()
