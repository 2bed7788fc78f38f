"""Every refused argument and surrounding of fix hydro: the message says what, the value found and the cure."""
import struct

import deck

STYLE = "fix h all hydro"
F = STYLE + " grid every 1"
M = STYLE + " mean"
SHEAR = "\nfix d all deform 1 xy erate 0.1 remap v"
NO_FILMS = "pair_style lubcontact 1 cut 0.5 squeeze no shear no roll no twist no\npair_coeff * * 1 1\n"
CASES = [    # lines in place of the fix, message, underlined word or None, variables
    (STYLE, "missing argument: level", None),
    (STYLE + " fine", "level must be mean or grid, but is fine", "fine"),
    (M + " tol 0.1", "Unknown fix hydro mean keyword: tol", "tol"),
    (M + " isolated", "missing argument: n", None),
    (M + " isolated 0", "isolated must be > 0, but is 0", "0"),
    (M + " isolated 1.5", "instead of '1.5'", None),
    (M + " isolated 1 isolated 2", "isolated is given twice", "isolated"),
    (M + " viscosity -1", "viscosity must be > 0, but is -1", "-1"),
    (M + " viscosity v_later", "viscosity must be > 0, but is 0 at step 1", None),
    (M + "\npair_style lubcontact 0 cut 0.5\npair_coeff * * 1 1", "viscosity must be > 0, but is 0 at step 0", None),
    (M + " viscosity 1\npair_style zero 2\npair_coeff * *", "counts partners in range of pair style lubcontact, which is not defined", None),
    (M + SHEAR.replace("remap v", "remap x"), "add to fix deform: remap v", None),
    (M + SHEAR.replace("all deform", "some deform"), "use group all for fix d", None),
    (M, "use: atom_style sphere", None, {"atoms": "atomic"}),
    (M, "works in 3d only: in 2d particles have no volume of fluid around them; use fix drag/background", None,
     {"dim": 2, "boundary": "p p p", "thick": "-1 1"}),
    (M + "\nrun_style respa 2 2 pair 1", "does not work with run_style respa", None),
    (M + "\nfix i all hydro grid every 1", "More than one fix hydro", None),
    ("unfix move\ngroup a id 1\ngroup b id 2\ngroup m id 3\nfix c m rheometer/plates a b rate 0 gap\n" + M,
     "the plates of fix c would be spheres", None, {"boundary": "p m p"}),
    (M + "\nfix b some drag/background 1", "has the drag of 2 particles already: remove fix b drag/background", None),
    (M + "\nfix g all gravity 1 vector 0 -1 0", "Fix g gravity may add forces after fix hydro", None),
    (STYLE + " grid steps 1", "Unknown fix hydro grid keyword: steps", "steps"),
    (STYLE + " grid every", "missing argument: n", None),
    (STYLE + " grid every 0", "every must be > 0, but is 0", "0"),
    (STYLE + " grid every 0.5", "instead of '0.5'", None),
    (STYLE + " grid every 1 every 2", "every is given twice", "every"),
    (STYLE + " grid strain 0", "strain must be > 0, but is 0", "0"),
    (STYLE + " grid strain 0.01 every 1", "has strain already: every cannot act", "every"),
    (F + " tol 0", "tol must be > 0, but is 0", "0"),
    (F + " tol 1", "tol must be < 1, but is 1", "1"),
    (F + " width 0", "width must be > 0, but is 0", "0"),
    (F + " spacing -1", "spacing must be > 0, but is -1", "-1"),
    (F + " spacing 1.5", "spacing must be <= 1", "1.5"),
    (F + " points 5", "points must be 4, 6, 8, 10 or 12, but is 5", "5"),
    (F + " reach 2.5", "reach must be at least 3, but is 2.5", "2.5"),
    (F + " reach far", "instead of 'far'", None),
    (F + " hold 3", "missing argument: z_torque", None),
    (F + " hold 3 0", "hold must be > 0, but is 0", "0"),
    (F + " viscosity 0", "viscosity must be > 0, but is 0", "0"),
    (F + " viscosity v_none", "Variable none for fix hydro viscosity does not exist", None),
    (F + " viscosity v_word", "Variable word for fix hydro viscosity is not equal-style", None),
    (F + " viscosity v_minus", "viscosity must be > 0, but is -1 at step 0", None),
    (F + " viscosity v_later", "viscosity must be > 0, but is 0 at step 1", None),
    (F + "\npair_style zero 2\npair_coeff * *", "there is no pair style lubcontact; give the viscosity instead of pair", None),
    (F + "\npair_style lubcontact v_eta residual 0.5\npair_coeff * * 1 1", "give the viscosity instead of pair", None),
    (STYLE + " grid", "solves every 0.0025 of strain, but the cell does not deform: use fix deform/rheometer, or every n", None),
    (F + SHEAR.replace("remap v", "remap x"), "add to fix deform: remap v", None),
    (F + SHEAR.replace("all deform", "some deform"), "use group all for fix d", None),
    (F, "use: atom_style sphere", None, {"atoms": "atomic"}),
    ("pair_style lubcontact 1 cut 0.5\npair_coeff * * 1 1\n" + F, "a part of the films of pair_style lubcontact ... cut, which would act twice: use "
     "range residual, or switch the films off", None),
    (M + "\npair_style lubcontact 1 residual 1\npair_coeff * * 1 1", "Fix hydro mean has no far field that would leave films of range residual: use "
     "range cut, or fix hydro grid", None),
    ("", "range residual is what fix hydro grid leaves to the films: add this fix, or use range cut", None),
    (F, "range residual is for spheres in 3d: use range cut", None, {"dim": 2, "boundary": "p p p", "thick": "-1 1"}),
    (NO_FILMS + F, "works in 3d only", None, {"dim": 2, "boundary": "p p p", "thick": "-1 1"}),
    (F, "but y is not: use boundary p p p", None, {"boundary": "p f p"}),
    (F + "\nrun_style respa 2 2 pair 1", "does not work with run_style respa", None),
    (F + "\nset atom 2 diameter 0", "atom 2 has no radius", None),
    ("group none id 9\n" + F.replace("all", "none"), "has no particles in its group", None),
    (F + "\nfix i all hydro grid every 1", "More than one fix hydro", None),
    ("fix p all pore/pressure 1\n" + M, "has the drag of the fluid between the particles already: remove fix h hydro", None),
    ("fix p all pore/pressure 1 coupling off\n" + F, "describe the same fluid twice: remove one of them", None),
    ("fix p all pore/pressure 1\n" + F, "has the drag of the fluid between the particles already: remove fix h hydro", None),
    (F + "\nfix p all pore/pressure 1", "describe the same fluid twice: remove one of them", None),
    ("unfix move\ngroup a id 1\ngroup b id 2\ngroup m id 3\nfix c m rheometer/plates a b rate 0 gap\n" + F, "the plates of fix c would be spheres", None, {"boundary": "p m p"}),
    (F + "\nfix b some drag/background 1", "has the drag of 2 particles already: remove fix b drag/background", None),
    ("unfix move\nfix o all overdamped/sphere 1\n" + F, "fix o overdamped/sphere, which has a drag of its own: use fix o overdamped/sphere hydro", None),
    ("unfix move\nfix o all overdamped/sphere 1\n" + M, "fix o overdamped/sphere, which has a drag of its own on all: use fix nve/sphere", None),
    ("unfix move\nfix o all overdamped/sphere hydro\n" + M, "needs a fix hydro grid, which has the drag of all particles", None),
    (NO_FILMS + "unfix move\nfix o all overdamped/sphere hydro", "needs a fix hydro grid, which has the drag of all particles", None),
    ("unfix move\nfix o all overdamped/sphere hydro cell", "has its fluid elsewhere: cell cannot act; remove it", "cell"),
    ("unfix move\nfix o all overdamped/sphere hydro\n" + F.replace("all", "some"), "which is not in the group of fix h: use the same group", None),
    ("neigh_modify exclude group some some\n" + F, "use neigh_modify exclude none", None),
    (F + "\nfix g all gravity 1 vector 0 -1 0", "Fix g gravity may add forces after fix hydro, which needs all other forces: "
     "define it before fix hydro", None),
]

GOOD = (NO_FILMS + F, "unfix move\nfix o all overdamped/sphere hydro\n" + F, "pair_style lubcontact 1 residual 2 shear no gap euler\npair_coeff * * 1 1\n" + F, M, M + " viscosity v_eta isolated 2" + SHEAR, "fix p all pore/pressure 1 coupling off\n" + M, F + " hold auto", F + " hold 3 2", STYLE + " grid" + SHEAR, "fix g all gravity 1 vector 0 -1 0\n" + F + "\nfix a all ave/time 1 1 1 f_h[*]",
        "fix h some hydro grid every 1\nfix w some setforce 0 0 0", F + " viscosity v_eta", F + " viscosity pair width 0.8 spacing 0.7 points 8 reach 6")
TEMPLATE = (deck.CASE / "in.refused").read_text()
USUAL = {"atoms": "sphere", "boundary": "p p p", "dim": 3, "thick": "0 12"}


def run(fix, fails=True, **variables):
    """The deck with the values written into it: LAMMPS cannot underline a word that came from a variable."""
    text = TEMPLATE
    films = "cut 0.5" if M in fix else "residual 0.5"
    for name, value in {**USUAL, "range": films, **variables, "fix": fix}.items():
        text = text.replace("${" + name + "}", str(value))
    if variables.get("dim") == 2:
        text = text.replace(" 0.1\n", " 0\n")
    deck.Path("in.now").write_text(text)
    return deck.run(str(deck.Path.cwd() / "in.now"), fails=fails).text


for lines, message, word, *more in CASES:
    deck.expect_error(lines.replace("\n", "; "), run(lines, **(more[0] if more else {})), message, word)
for lines in GOOD:
    deck.expect(f"good: {lines}".replace("\n", "; "), "WARNING: Fix hydro" not in run(lines, fails=False))

# a restart file with a damaged byte: of the fix, of an atom
run(F + "\nrun 2\nwrite_restart good.restart", fails=False)
content = deck.Path("good.restart").read_bytes()
head = content.index(struct.pack("Q", 0x5355535000000000 + 8 * 10))
PART = 31    # doubles of an atom: their number, two loads of 11, motion of 6, hold, seal
atom = content.index(struct.pack("d", PART), head)
again = "atom_modify map array\nread_restart {} \ncomm_modify vel yes\nfix move all nve\ntimestep 1e-4\n" + F + "\nrun 1\n"
for what, byte, message in (("good", None, ""), ("head", head + 20, "The part of fix hydro in the restart file is damaged"),
                            ("atom", atom + 30, "for fix hydro is damaged: use another one")):
    damaged = bytearray(content)
    if byte:
        damaged[byte] ^= 4
    deck.Path(f"{what}.now.restart").write_bytes(damaged)
    deck.Path("in.now").write_text(again.format(f"{what}.now.restart"))
    text = deck.run(str(deck.Path.cwd() / "in.now"), fails=what != "good").text
    if byte:
        deck.expect_error(f"damaged {what}", text, message)
deck.finish()
