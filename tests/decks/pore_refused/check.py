"""Every refused argument and surrounding of fix pore/pressure: the message says what, the value found and the cure."""
import struct

import deck

STYLE = "fix p between pore/pressure"
F = STYLE + " 1"
OPEN = " plates c lower drained upper drained"
CLOSED = " plates c lower impermeable upper impermeable"
ABOVE = " plates c lower drained upper impermeable"
C = "\nfix c between rheometer/plates lower upper "
CASES = [    # lines in place of the fix, message, underlined word or None, boundary
    (STYLE, "missing argument: eta|pair", None),
    (STYLE + " thick", "instead of 'thick'", None),
    (STYLE + " 0", "viscosity must be > 0, but is 0", "0"),
    (STYLE + " -2", "viscosity must be > 0, but is -2", "-2"),
    (STYLE + " v_none", "Variable none for fix pore/pressure viscosity does not exist", None),
    (STYLE + " v_word", "Variable word for fix pore/pressure viscosity is not equal-style", None),
    (STYLE + " v_minus", "viscosity must be > 0, but is -1 at step 0", None),
    (STYLE + " v_later", "viscosity must be > 0, but is 0 at step 1", None),
    (F + " ratio 1", "Unknown fix pore/pressure keyword: ratio", "ratio"),
    (F + " mean", "missing argument: drained|undrained|layer", None),
    (F + " mean wet", "mean must be one of drained undrained layer, but is wet", "wet"),
    (F + " mean layer", "missing argument: H", None),
    (F + " mean layer 0", "mean layer must be > 0, but is 0", "0"),
    (F + " mean layer deep", "instead of 'deep'", None),
    (F + OPEN + " mean drained", "it cannot act between plates, whose kinds decide; remove mean, or for the mean alone "
     "use solver mean", "mean"),
    (F + " solver mean", "solver mean has nothing to do in a cell that is drained: add mean layer H, or mean undrained", "solver"),
    (F + OPEN + " solver mean grid 3 3 3", "solver mean has no pressure in space: grid cannot act; remove it", "grid"),
    (F + OPEN + " solver mean spacing 3", "spacing cannot act; remove it", "spacing"),
    (F + OPEN + " solver mean tolerance 0.1", "tolerance cannot act; remove it", "tolerance"),
    (F + OPEN + " pressure 2 solver mean", "pressure cannot act; remove it", "pressure"),
    (F + " mean layer 5 solver mean gradient 0 1 0", "gradient cannot act; remove it", "gradient"),
    (F + OPEN + " solver mean storage 1", "storage cannot act; remove it, or use a cell with mean undrained", "storage"),
    (F + " mean layer 5 solver mean storage 1", "storage cannot act; remove it, or use a cell with mean undrained", "storage"),
    (F + OPEN + " solver mean coupling explicit", "which has no explicit form: use coupling implicit", "coupling"),
    (F + CLOSED + " solver mean" + C + "rate 1 load 1", "use drained for one of them, gap in fix c (", None),
    (F + " mean undrained", "mean undrained needs a fluid that can be compressed; add: storage S", "mean"),
    (F + " cell mean layer 5", "mean layer follows the dilation of a fix deform/rheometer, but there is none: add one, or use mean "
     "drained or undrained", None),
    (F + " cell mean layer 5\nfix d between deform 1 x erate 0.1 remap v", "mean layer follows the dilation of a fix deform/rheometer", None),
    (F + " factor 1 factor 2", "factor is given twice", "factor"),
    (F + " solver", "missing argument: grid|cg|mean", None),
    (F + " solver network", "solver must be one of grid cg mean, but is network", "network"),
    (F + " spacing", "missing argument: h", None),
    (F + " spacing 0", "spacing must be > 0, but is 0", "0"),
    (F + " spacing wide", "instead of 'wide'", None),
    (F + " grid 3 3", "missing argument: nz", None),
    (F + " grid 3 0 3", "grid must be > 0, but is 0", "0"),
    (F + " grid 3 3 3 spacing 3", "has a grid already: spacing cannot act", "spacing"),
    (F + " permeability darcy", "permeability must be one of beetstra kozeny constant, but is darcy", "darcy"),
    (F + " permeability constant", "missing argument: k", None),
    (F + " permeability constant -1", "permeability must be > 0, but is -1", "-1"),
    (F + " factor 0", "factor must be > 0, but is 0", "0"),
    (F + " phi_min 0", "phi_min must be > 0, but is 0", "0"),
    (F + " phi_min 0.5", "phi_min must be < 0.5, but is 0.5", "0.5"),
    (F + " plates c lower drained", "missing argument: upper drained|impermeable", None),
    (F + " plates c upper drained lower drained", "plates: expected lower, but found upper", "upper"),
    (F + " plates c lower drained lower drained", "plates: expected upper, but found lower", "lower"),
    (F + " plates c lower wet upper drained", "plates must be one of impermeable drained, but is wet", "wet"),
    (F + OPEN + " cell", "has plates already: cell cannot act", "cell"),
    (F + " pressure 3", "pressure is that at drained plates, but there are none", "pressure"),
    (F + CLOSED + " pressure 3", "pressure is that at drained plates, but there are none", "pressure"),
    (F + OPEN + " pressure v_none" + C, "Variable none for fix pore/pressure pressure does not exist", None),
    (F + " storage 0", "storage must be > 0, but is 0", "0"),
    (F + " gradient 0 0", "missing argument: gz", None),
    (F + " gradient 0 v_word 0", "Variable word for fix pore/pressure gradient is not equal-style", None),
    (F + " coupling loose", "coupling must be one of implicit explicit off, but is loose", "loose"),
    (F + " tolerance 0", "tolerance must be > 0, but is 0", "0"),
    (STYLE + " pair\npair_style zero 2\npair_coeff * *", "give the viscosity instead of pair", None),
    (STYLE + " pair\npair_style lubcontact v_eta cut 0.5\npair_coeff * * 1 1", "give the viscosity instead of pair", None),
    (F + " cell\nrun_style respa 2 2 pair 1", "does not work with run_style respa", None),
    (F + "\nfix q between pore/pressure 1", "More than one fix pore/pressure: the pressure of the pores is only one", None),
    (F + "\nfix d between drag/background 1 velocity 0 0 0", "remove fix d drag/background, or use coupling off", None),
    ("unfix move\nfix d between overdamped/sphere 1 velocity 0 0 0\n" + F, "remove fix d overdamped/sphere, or use coupling off", None),
    (F + "\nfix g between gravity 1 vector 0 -1 0", "Fix g gravity may add forces after fix pore/pressure, which needs all other "
     "forces: move it before fix pore/pressure", None),
    (C.strip() + "\n" + F + OPEN, "Fix c rheometer/plates must come after fix pore/pressure", None),
    (F + OPEN, "plates: c is not the ID of a fix rheometer/plates", None),
    (F + " plates move lower drained upper drained", "plates: move is not the ID of a fix rheometer/plates", None),
    (F, "add plates fix-ID lower drained upper drained", None),
    ("group none empty\nfix p none pore/pressure 1" + OPEN + C, "has no particles in its group", None),
    (F + OPEN + " grid 3 6 3" + C, "the elements of the grid are 1.333 along y, smaller than the mean diameter 2 of the particles", None),
    (F + OPEN + " spacing 1" + C, "use a coarser grid", None),
    (F + CLOSED + C + "rate 1 load 1", "use drained for one of them, gap in fix c, or storage S", None),
    (F + CLOSED + C + "rate 1 pressure 1", "use drained for one of them, gap in fix c, or storage S", None),
    (F + ABOVE + C + "rate 1 pressure 1", "use load instead of pressure there, or upper drained", None),
]
GOOD = (F + ABOVE + " solver mean" + C + "rate 1 pressure 1", C.strip() + "\n" + F + OPEN + " solver mean" + "\nfix g between gravity 1 vector 0 -1 0",
        F + CLOSED + " solver mean" + C + "rate 1 gap", F + OPEN + " solver mean\nfix d between drag/background 1 velocity 0 0 0" + C,
        F + CLOSED + C + "rate 1 gap", F + CLOSED + " storage 1" + C + "rate 1 load 1", F + ABOVE + C + "rate 1 load 1",
        F + " plates c lower impermeable upper drained pressure 2" + C + "rate 1 pressure 1", F + CLOSED + " coupling off" + C + "rate 1 load 1",
        "fix g between gravity 1 vector 0 -1 0\n" + F + OPEN + " gradient v_eta 0 0" + C,
        F + OPEN + " coupling off" + "\nfix d between drag/background 1 velocity 0 0 0" + C + "\nfix a all ave/time 1 1 1 f_p[*]")
TEMPLATE = (deck.CASE / "in.refused").read_text()


def run(fix, boundary="p m p", atoms="sphere", dim=3, fails=True):
    """The deck with the values written into it: LAMMPS cannot underline a word that came from a variable."""
    text = TEMPLATE
    for name, value in (("boundary", boundary), ("atoms", atoms), ("dim", dim), ("thick", "0 12" if dim == 3 else "-1 1"), ("fix", fix)):
        text = text.replace("${" + name + "}", str(value))
    if dim == 2:
        text = text.replace(" 0.1\n", " 0\n") + "\n"
    deck.Path("in.now").write_text(text)
    return deck.run(str(deck.Path.cwd() / "in.now"), fails=fails).text


for fix, message, word in CASES:
    boundary = "p m p" if "plates" in fix or fix == F else "p p p"
    deck.expect_error(fix.replace("\n", "; "), run(fix, boundary), message, word)
for boundary in ("f p p", "p p f"):
    deck.expect_error(f"boundary {boundary}", run(F, boundary), "needs a periodic cell, or along y the plates")
deck.expect_error("points", run(F, "p p p", atoms="atomic"), "use: atom_style sphere")
deck.expect_error("discs", run(F, "p p p", dim=2), "has no law of permeability for discs; use: permeability constant k")
for fix in GOOD:
    text = run(fix, fails=False)
    deck.expect(f"good: {fix}".replace("\n", "; "), "WARNING: Fix pore" not in text)

# a layer, before or after the fix that moves the cell
STRETCH, LAYER = "fix d between deform/rheometer flow uniaxial rate 0.1 pressure 1", F + " cell mean layer 5"
for fixes in ((STRETCH, LAYER), (LAYER, STRETCH)):
    text = run("\n".join(fixes), "p p p", fails=False)
    deck.expect("good: " + "; ".join(fixes), "WARNING: Fix pore" not in text)

# a restart file with a damaged byte
run(F + " grid 3 3 3\nrun 2\nwrite_restart good.restart", "p p p", fails=False)
content = deck.Path("good.restart").read_bytes()
at = content.index(struct.pack("4d", 27, 3, 3, 3))
again = "atom_modify map array\nread_restart {} \ncomm_modify vel yes\nfix move between nve\ntimestep 1e-4\n" + F + " grid 3 3 3\nrun 1\n"
for what, byte in (("good", None), ("head", at + 9), ("pressure", at + 8 * 20 + 3)):
    damaged = bytearray(content)
    if byte:
        damaged[byte] ^= 4
    deck.Path(f"{what}.now.restart").write_bytes(damaged)
    deck.Path("in.now").write_text(again.format(f"{what}.now.restart"))
    text = deck.run(str(deck.Path.cwd() / "in.now"), fails=what != "good").text
    if byte:
        deck.expect_error(f"damaged {what}", text, "The part of fix pore/pressure in the restart file is damaged: use another one")
deck.finish()
