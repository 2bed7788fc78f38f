"""Every refused argument of compute microstructure: the message, and the word it underlines."""
import deck

CASES = [    # arguments, message, underlined word or None
    ("contact", "mode must be contacts, fabric, forces, angle or sphere, but is contact", "contact"),
    ("contacts all", "Unknown compute microstructure contacts argument: all", "all"),
    ("fabric 3", "Unknown compute microstructure fabric argument: 3", "3"),
    ("forces", "missing argument", None),
    ("forces 10", "missing argument", None),
    ("forces 0 5", "number of bins must be >= 1, but is 0", "0"),
    ("forces 10 -2", "largest force over the mean must be > 0, but is -2", "-2"),
    ("forces 10 5 6", "Unknown compute microstructure forces argument: 6", "6"),
    ("angle", "missing argument", None),
    ("angle -5", "number of bins must be >= 1, but is -5", "-5"),
    ("angle 12 plain xy", "Unknown compute microstructure angle keyword: plain", "plain"),
    ("angle 12 plane", "missing argument", None),
    ("angle 12 plane yx", "plane must be xy, xz or yz, but is yx", "yx"),
    ("angle 12 stress xw", "stress must be a component such as xy, but is xw", "xw"),
    ("angle 12 stress x", "stress must be a component such as xy, but is x", "x"),
    ("angle 12 band 0", "band must be in (0, 1], but is 0", "0"),
    ("angle 12 band 1.5", "band must be in (0, 1], but is 1.5", "1.5"),
    ("sphere 12", "missing argument", None),
    ("sphere 12 0", "number of bins must be >= 1, but is 0", "0"),
    ("sphere 6 12 band 0.3", "needs mode angle and a 3d system", "band"),
]
FLAT = [
    ("sphere 6 12", "needs three dimensions; use: angle 12 in 2d", "sphere"),
    ("angle 12 band 0.3", "needs mode angle and a 3d system", "band"),
    ("angle 12 plane xz", "plane must be xy in 2d, but is xz", "xz"),
]
TEMPLATE = (deck.CASE / "in.refused").read_text()


def refused(arguments, dim=3, style="lubcontact 1.0 cut 0.5", coeff="1e4 5e3"):
    """What LAMMPS prints; the arguments are written into the deck: it cannot underline a word of a variable."""
    text = TEMPLATE
    for name, value in {"arguments": arguments, "dim": dim, "style": style, "coeff": coeff}.items():
        text = text.replace(f"${{{name}}}", str(value))
    deck.Path("in.now").write_text(text)
    return deck.run(str(deck.Path.cwd() / "in.now"), fails=True).text


for n, cases in ((3, CASES), (2, FLAT)):
    for words, message, word in cases:
        deck.expect_error(f"{n}d: {words}", refused(words, n), message, word)
deck.expect_error("other pair style", refused("angle 12", style="zero 3.0", coeff=""),
                  "pair_style lubcontact, which is not defined")
deck.finish()
