"""Every refused argument of fix rheometer/plates: the message says what, the value found and the cure, and underlines the word."""
import deck

STYLE = "fix p between rheometer/plates"
P = STYLE + " lower upper"
CASES = [    # lines in place of the fix, message, underlined word or None
    (STYLE, "missing argument", None),
    (STYLE + " lower", "missing argument", None),
    (STYLE + " low upper", "Group low of the lower plate of fix rheometer/plates does not exist", "low"),
    (STYLE + " lower up", "Group up of the upper plate of fix rheometer/plates does not exist", "up"),
    (STYLE + " lower lower", "needs two plates, but both are group lower", "lower"),
    (P + " ratio 1", "Unknown fix rheometer/plates keyword: ratio", "ratio"),
    (P + " rate", "missing argument", None),
    (P + " rate fast", "instead of 'fast'", None),
    (P + " rate v_none", "Variable none for fix rheometer/plates rate does not exist", None),
    (P + " rate v_word", "Variable word for fix rheometer/plates rate is not equal-style", None),
    (P + " load v_word", "Variable word for fix rheometer/plates load is not equal-style", None),
    (P + " pressure v_none", "Variable none for fix rheometer/plates pressure does not exist", None),
    (P + " pressure v_minus", "pressure must be > 0, but is -1 at step 0", None),
    (P + " rate 1 stress 2", "rate and stress both set the motion along x; choose one", "stress"),
    (P + " pressure 1 gap", "pressure both set the motion along y; choose one", None),
    (P + " rate 1 rate 2", "rate is given twice", "rate"),
    (P + " oscillate 1 2", "missing argument", None),
    (P + " oscillate 1 2 0", "oscillate needs a frequency > 0, but it is 0", "0"),
    (P + " oscillate 1 v_word 3", "Variable word for fix rheometer/plates oscillate is not equal-style", None),
    (P + " pressure 0", "pressure must be > 0, but is 0", "0"),
    (P + " pressure -2.5", "pressure must be > 0, but is -2.5", "-2.5"),
    (P + " iv 0.1", "iv cannot act without pressure or load", "iv"),
    (P + " iv -0.1 pressure 1", "iv must be >= 0, but is -0.1", "-0.1"),
    (P + " iv 0.1 pressure 1 viscosity 0", "viscosity must be > 0 with iv", None),
    (P + " viscosity -1 pressure 1", "viscosity must be >= 0, but is -1", "-1"),
    (P + " viscosity v_none pressure 1", "Variable none for fix rheometer/plates viscosity does not exist", None),
    (P + " rate 1 viscosity 3", "viscosity cannot act without iv, pressure, load or stress", "viscosity"),
    (P + " gain 0 pressure 1", "gain must be > 0, but is 0", "0"),
    (P + " gain 3 load 1", "gain cannot act without pressure", "gain"),
    (P + " mass 3 pressure 1", "mass cannot act without stress or load", "mass"),
    (P + " mass 0 load 1", "mass must be > 0, but is 0", "0"),
    (P + " damper 3 pressure 1", "damper cannot act without load", "damper"),
    (P + " damper -3 load 1", "damper must be >= 0, but is -3", "-3"),
    (P + " drag 3 rate 1", "drag cannot act without stress", "drag"),
    (P + " drag -3 stress 1", "drag must be >= 0, but is -3", "-3"),
    ("fix p all rheometer/plates lower upper", "group all contains 2 particles of the plates; use the group of the particles between them",
     None),
    (STYLE + " upper lower", "must be above that of the lower plate", None),
    ("group none empty\n" + STYLE + " lower none", "group none of the upper plate is empty", None),
    ("group two id 1 2\n" + STYLE + " lower two", "1 particles are in both plates", None),
    (P + "\nfix m all nve/sphere", "Fix m nve/sphere moves 2 particles of the plates, which are moved by fix "
     "rheometer/plates; use group between for fix m", None),
    (P + "\nfix q between rheometer/plates lower upper", "moves 2 particles of the plates", None),
    ("create_atoms 1 single 2 1 2\ngroup lower id 1 4\nset group all diameter 2\n" + P,
     "add: neigh_modify exclude group lower lower", None),
    (P + "\nrun_style respa 2 2 pair 1", "does not work with run_style respa", None),
    (P + "\npair_style zero 2\npair_coeff * *\nrun_style respa 2 2 pair 1", "Fix rheometer/plates does not work with run_style respa", None),
    (P + "\nchange_box all boundary p p p", "would meet across the periodic boundary along y", None),
    (P + "\ngroup upper delete", "Group upper of the upper plate of fix rheometer/plates does not exist", None),
    (P + "\ngroup upper delete\ngroup new id 3\nrun 2", "Group upper of the upper plate of fix rheometer/plates does not exist", None),
    (P + "\nregion r block 0 1 0 1 0 1\ngroup lower clear\ngroup lower dynamic all region r", "Group lower of fix rheometer/plates must not be dynamic", None),
    ("variable v atom step>1\ngroup g dynamic all var v every 1\nfix m g nve/sphere\n" + P + "\nrun 4",
     "Fix m nve/sphere moves a particle new in its group of the plates", None),
    ("variable v atom step>1\ngroup g dynamic all var v every 1\n" + P.replace("between", "g") + "\nrun 4",
     "of the plates has joined group g of the suspended particles", None),
    (P + "\nfix_modify p damper 3", "damper cannot act without load", "damper"),
    (P + "\nfix_modify p pressure -1", "pressure must be > 0, but is -1", "-1"),
    (P + "\nfix_modify p ratio 1", "does not support fix_modify ratio", None),
    (P + " iv 0.1 pressure 1\nfix_modify p gap", "gap cannot act without another drive than iv", "gap"),
    (P + " pressure 1\ndelete_atoms group between", "group between of the suspended particles is empty", None),
    (P + " load 1e3\ntimestep 1e-1\ndelete_atoms group between\nrun 2000", "the plates touch each other at step", None),
    (P + " pressure 1\npair_style zero 2\npair_coeff * *\ntimestep 1e-2\npair_style lubcontact v_eta cut 0.5\npair_coeff * * 1 1",
     "in the pair style: the viscosity of pair style lubcontact is a variable; add: viscosity eta", None),
]

TEMPLATE = (deck.CASE / "in.refused").read_text()


def run(boundary="p m p", atoms="sphere", fix=P, fails=True):
    """The deck with the values written into it: LAMMPS cannot underline a word that came from a variable."""
    text = TEMPLATE.replace("${boundary}", boundary).replace("${atoms}", atoms).replace("${fix}", fix)
    deck.Path("in.now").write_text(text)
    return deck.run(str(deck.Path.cwd() / "in.now"), fails=fails).text


for fix, message, word in CASES:
    deck.expect_error(fix.replace("\n", "; "), run(fix=fix), message, word)
deck.expect_error("periodic along y", run(boundary="p p p"), "would meet across the periodic boundary along y; use: boundary p m p")
deck.expect_error("not periodic along x", run(boundary="f m p"), "plates must be periodic along x and z; use: boundary p m p")
deck.expect_error("not periodic along z", run(boundary="p m f"), "plates must be periodic along x and z; use: boundary p m p")
deck.expect_error("points", run(atoms="atomic"), "use: atom_style sphere")
text = run(fix=P + " load 1e-3 mass 1e-4\ntimestep 1e-3", fails=False)
deck.expect("a light plate warns", "where a plate of mass 0.0001 is unstable" in text)
text = run(fix=P + " rate 1 pressure 5 gain 2\nfix_modify p load 3 mass 2 virial no", fails=False)
deck.expect("good arguments do not warn", "rheometer/plates" not in text.split("Setting up Verlet")[-1])
deck.finish()
