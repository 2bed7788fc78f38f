# ranks: 1 4
"""suspension_scene measure changes nothing, to the last bit, and its copies do what the run itself does. Decks with everything on."""
import re
from pathlib import Path

import numpy as np

import deck

PRESSED = "deform/rheometer rate 1.0 pressure 30.0"
LAMMPS = "deform 1 xy erate 1.0 remap v"
FILES = ("dump", "samples", "mean", "data", "restart")


def blocks(out):
    """Shear stress, pressure and parts in the five blocks of the second half of 100 steps from 175 on."""
    rows = np.loadtxt(f"samples.{out}")
    return rows[(rows[:, 0] > 225) & (rows[:, 0] <= 275)][:, 1:]


def change(without, with_all):
    """In percent, with the error of the mean of the differences of the blocks."""
    d = (without - with_all) / abs(with_all.mean()) * 100
    return d.mean(), d.std(ddof=1) / np.sqrt(len(d))


def numbers(text, effect):
    """Part of the stress, if it has one, and the changes of stress and pressure with their errors, in percent."""
    line = re.search(rf"^  {effect} +(.*)$", text, re.MULTILINE).group(1)
    changes = re.findall(r"([-+][0-9.]+) \+- ([0-9.]+) %", line)
    part = re.match(r"([-0-9.]+) %", line)
    return (float(part.group(1)) if part else None), [(float(a), float(b)) for a, b in changes]


cases = [("pressed", {"flow": PRESSED}), ("fix deform, newton off", {"flow": LAMMPS, "newton": "off"})]
if deck.RANKS == 2:
    cases += [("lists by size", {"flow": LAMMPS, "multi": "yes", "collect": "neigh_modify collection/interval 3 2.0 2.2 9.0", "types": 2}),
              ("lists by type", {"flow": LAMMPS, "multi": "yes", "collect": "neigh_modify collection/type 3 2 1,4 3", "types": 4}),
              ("lists of each type", {"flow": LAMMPS, "multi": "yes", "types": 3})]
if deck.RANKS == 1:
    cases.append(("discs, viscosity by variable",
                  {"flow": "deform/rheometer rate 1 volume viscosity v_eta", "viscosity": "v_eta", "dim": 2}))
for name, case in cases:
    deck.make_state(dim=case.get("dim", 3), phi=0.75 if "dim" in case else 0.5, types=case.get("types", 1))
    yes = deck.run("in.scene_measure", measure="yes", out="yes", **case)
    no = deck.run("in.scene_measure", measure="no", out="no", **case)
    for file in FILES:
        same = Path(f"{file}.yes").read_bytes() == Path(f"{file}.no").read_bytes()
        deck.expect(f"{name}: {file} is the same", same)
    for a, b in zip(yes.tables(), no.tables()):
        deck.expect(f"{name}: thermo is the same", all(np.array_equal(a[key], b[key]) for key in b))
    deck.expect("  both runs", len(yes.tables()) == len(no.tables()) == 2)
    lists = re.findall(r"^Currently loaded plugins.*\n((?: +[0-9]+: .*\n)*)", yes.text, re.MULTILINE)
    deck.expect("  plugins are still there", len(lists) == 2 and lists[0] == lists[1], lists[-1])

    # the copy as it is runs as the run itself goes on
    text, plain = yes.text[yes.text.index("steps of a copy"):], blocks("no")
    shown = re.search(r"everything on, as the deck is: stress xy (\S+) .*pressure yy (\S+) ", text)
    sxy, pressure = plain[:, 0].mean(), -plain[:, 1].mean()
    deck.expect_close(f"{name}: stress of the copy", float(shown.group(1)), sxy, rtol=1e-5)
    deck.expect_close(f"{name}: pressure of the copy", float(shown.group(2)), pressure, rtol=1e-5)
    for effect, column in (("friction", 2), ("shear", 3), ("squeeze", 4)):
        deck.expect_close(f"{name}: part of {effect}", numbers(text, effect)[0], 100 * plain[:, column].mean() / sxy, atol=0.051)
    deck.expect(f"{name}: twisting may go", "twist no" in re.search(r"Input lines to use: changes.*\n(.*)", text).group(1))

    # so does that without friction, which a running LAMMPS can leave out, too
    if name != "pressed":
        continue
    deck.run("in.scene_measure", measure="no", out="less", change="pair_coeff * * 1e4 5e3 roughness 0.01", **case)
    less = blocks("less")
    for what, column, found in zip(("stress", "phi"), (0, 8), numbers(text, "friction")[1]):
        expected = change(less[:, column], plain[:, column])
        deck.expect_close(f"change of {what} without friction, and its error", found, expected, atol=0.051)

# a stress that is held does not change: what a film does shows in the rate
if deck.RANKS == 1:
    deck.make_state()
    text = deck.run("in.scene_measure", measure="yes", flow="deform/rheometer stress 60 pressure 30", out="yes").text
    deck.expect("the rate is not held", "stress over rate" in text and "of stress/rate" in text)
    deck.expect("  nor the volume", "of phi" in text)
    text = text[text.index("steps of a copy"):]
    found = numbers(text, "squeeze")[1][0]
    deck.expect("  squeeze film: matters", found[0] + 2 * found[1] < 0, found)
    deck.expect("  and stays", "squeeze no" not in text)

# before the first run no pair has a history: each effect can be left out by its keyword
if deck.RANKS == 1:
    deck.make_state()
    text = deck.run("in.scene_measure", measure="first").text
    deck.expect("says that the history is missing", "the pairs had no history yet" in text)
    runs = {}
    for effect in ("none", "squeeze", "shear", "roll", "twist"):
        keywords = "" if effect == "none" else f"{effect} no"
        deck.run("in.scene_measure", measure="never", out="first", keywords=keywords)
        rows = np.loadtxt("samples.first")
        runs[effect] = rows[(rows[:, 0] > 50) & (rows[:, 0] <= 100)][:, [1, 9]]    # stress, 1/volume
        if effect != "none":
            expected = [change(runs[effect][:, c], runs["none"][:, c]) for c in (0, 1)]
            deck.expect_close(f"changes without {effect}, and their errors", numbers(text, effect)[1], expected, atol=0.051)
deck.finish()
