# ranks: 1 2
"""suspension_scene measure of decks that have not everything on, or a drag: what a hand-written deck with everything on does."""
import re
from pathlib import Path

import numpy as np

import deck

DECK = "../scene_measure/in.scene_measure"
PRESSED = "deform/rheometer rate 1.0 pressure 30.0"
STEADY = "deform 1 xy erate 1.0 remap v"
DRAG = "fix drag some drag/background pair cell hindrance mean"
FILES = ("dump", "samples", "mean", "data", "restart")


def run(out, first=False, **variables):
    """A run without the command: rows of its samples in the second half of the 100 steps that are measured."""
    deck.run(DECK, measure="never" if first else "no", out=out, **variables)
    rows = np.loadtxt(f"samples.{out}")
    start = 0 if first else 175
    return rows[(rows[:, 0] > start + 50) & (rows[:, 0] <= start + 100)][:, 1:] * [1, -1, 1, 1, 1, 1, 1, 1, 1, 1]


def change(one, other):
    """Of stress and pressure, or phi if the volume changes, in percent, with the error of the mean of the differences of the blocks."""
    columns = [0, 8 if np.ptp(other[:, 8]) > 0 else 1]
    d = (one - other)[:, columns] / abs(other[:, columns].mean(axis=0)) * 100
    return list(zip(d.mean(axis=0), d.std(axis=0, ddof=1) / np.sqrt(len(d))))


def row(text, name):
    """Parts of stress and power, and the changes of stress and pressure with their errors, in percent."""
    line = re.search(rf"^  {name} +(.*)$", text, re.MULTILINE).group(1)
    parts = re.findall(r"(?<!\S)(-|[-0-9.]+ %)(?= )", line)[:2]
    changes = [(float(a), float(b)) for a, b in re.findall(r"([-+][0-9.]+) \+- ([0-9.]+) %", line)]
    return [None if part == "-" else float(part[:-2]) for part in parts], changes


def expect_everything(name, text, everything, as_deck=None):
    shown = re.search(r"everything on(.*): stress xy (\S+) .*pressure yy (\S+) ", text)
    means = [float(shown.group(2)), float(shown.group(3))]
    deck.expect_close(f"{name}: stress and pressure with everything on", means, everything[:, :2].mean(axis=0), rtol=1e-5)
    deck.expect("  says whether this is the deck", (shown.group(1) == "") == (as_deck is not None), shown.group(1))
    if as_deck is not None:
        deck.expect_close(f"{name}: changes as the deck is, and their errors", row(text, "as the deck is")[1],
                          change(as_deck, everything), atol=0.051)


def said(**variables):
    text = deck.run(DECK, **variables).text
    return text[text.index("steps of a copy"):].split("Currently loaded plugins")[0]


def changes_nothing(name, **variables):
    """What the command says in the middle of a run that it does not touch."""
    text = said(measure="yes", out="yes", **variables)
    plain = run("no", **variables)
    for file in FILES:
        deck.expect(f"{name}: {file} is the same", Path(f"{file}.yes").read_bytes() == Path(f"{file}.no").read_bytes())
    return text, plain


def advice(text):
    return text[text.index("Input lines to use"):]


def lacks(text, effect):
    return re.search(rf"^  {effect}: not measured; (.*)$", text, re.MULTILINE)


deck.make_state()

# a film off: the reference has it, its slots of the history begin at 0, and the others go on. By hand: friction with the coefficient 0
# keeps the same slots at 0 until then
films = {"flow": PRESSED, "keywords": "shear no", "coeffs": ""}
text, plain = changes_nothing("film off", words="friction 0.5", **films)
switch = 'if "1 == 1" then "pair_style lubcontact 1.0 cut 0.5" "pair_coeff * * 1e4 5e3 roughness 0.01 friction coulomb 0.5"'
everything = run("by_hand", flow=PRESSED, keywords="shear no", coeffs="friction coulomb 0", change=switch)
expect_everything("film off", text, everything, plain)
deck.expect("  what matters is on in the advice", "cut 0.5 twist no\n" in advice(text), advice(text))
for effect, cure in (("critical load", "critical F"), ("adhesion", "adhesion F"), ("repulsion", "repulsion F lambda"),
                     ("drag", "add fix drag/background"), ("pores", "add fix pore/pressure"), ("far field", "add fix hydro mean")):
    deck.expect(f"  {effect} is missing", lacks(text, effect) and cure in lacks(text, effect).group(1))
deck.expect("  friction is not", not lacks(text, "friction"))

# laws by keyword: a running LAMMPS can switch on what needs no new slots of the history
laws = {"flow": STEADY, "coeffs": ""}
words = "friction 0.5 critical 40 repulsion 20 0.05"
text, plain = changes_nothing("laws", words=words, **laws)
coeff = "pair_coeff * * 1e4 5e3 roughness 0.01 friction clm step 0.5 40 repulsion 20 0.05"
everything = run("laws", change=coeff, **laws)
expect_everything("laws", text, everything, plain)
coeff = coeff.replace("1e4 5e3", "10000 5000 asperity 10000")
deck.expect("  they are in the advice", coeff in advice(text), advice(text))
without = run("without", change="pair_coeff * * 1e4 5e3 roughness 0.01 friction coulomb 0.5 repulsion 20 0.05", **laws)
deck.expect_close("  part of the repulsion", row(text, "repulsion")[0][0], 100 * everything[:, 7].mean() / everything[:, 0].mean(), atol=0.051)
deck.expect_close("  changes without the critical load", row(text, "critical load")[1], change(without, everything), atol=0.051)

# before the first run everything begins alike: all films and adhesion, whose pull-off force is k delta R
if deck.RANKS == 1:
    with open("state.data", encoding="ascii") as file:
        data = file.read()
    lines = data[data.index("Atoms"):data.index("Velocities")].split("\n")[2:-1]
    mean_radius = np.mean([float(line.split()[2]) / 2 for line in lines if line])
    touching = "friction coulomb 0.5 roughness 0.03"
    first = {"flow": STEADY, "keywords": "squeeze no twist no", "coeffs": touching}
    text = said(measure="first", words="adhesion 200 change 1e-9", **first)
    delta = 200 / (1e4 * mean_radius)
    everything = run("all", first=True, flow=STEADY, coeffs=f"{touching} adhesion {delta}")
    expect_everything("before the first run", text, everything, run("first", first=True, **first))
    found = re.search(r"adhesion (\S+)$", advice(text), re.MULTILINE)
    deck.expect_close("  adhesion in the advice", float(found.group(1)), delta, rtol=1e-12)

# drag: one more effect, with its part of the power
drag = {"flow": PRESSED, "drag": f'if "1 == 1" then "group some id 1:120" "{DRAG}"'}
text, plain = changes_nothing("drag", **drag)
expect_everything("drag", text, plain)
parts, changes = row(text, "drag")
deck.expect_close("drag: part of the power", parts[1], 100 * plain[:, 5].mean() / plain[:, 6].mean(), atol=0.051)
deck.expect("  none of the stress", parts[0] is None)
deck.expect_close("drag: changes without it", changes, change(run("without", change="unfix drag", **drag), plain), atol=0.051)
deck.expect("  it is in the advice", f"  {DRAG}\n" in advice(text), advice(text))

# the fluid of the pores: the same; its pressure goes on in the copy
for what, pores in (("pores", "fix pore all pore/pressure pair cell"), ("pores of a layer", "fix pore all pore/pressure v_eta cell mean layer 3 factor 5"),
                    ("pores, undrained", "fix pore all pore/pressure pair cell storage 0.01 mean undrained")):
    case = {"flow": PRESSED, "drag": pores}
    text, plain = changes_nothing(what, **case)
    expect_everything(what, text, plain)
    parts, changes = row(text, "pores")
    deck.expect_close(f"{what}: part of the power", parts[1], 100 * plain[:, 5].mean() / plain[:, 6].mean(), atol=0.051)
    deck.expect("  there is some", parts[1] > 1 and parts[0] is None, f"{parts}")
    deck.expect_close(f"{what}: changes without them", changes, change(run("without", change="unfix pore", **case), plain), atol=0.051)
    matter = "undrained" not in what    # whose mean pressure the particles do not feel
    deck.expect("  they change something", (abs(changes[0][0]) > 0.5) == matter, f"{changes}")
    deck.expect("  they are in the advice", (f"  {pores}\n" if matter else "  # and no fix pore\n") in advice(text), advice(text))

# the far field: its level mean goes on in the copy, a grid solves anew; without it films are those that do without
case = {"flow": PRESSED, "drag": "fix far all hydro mean viscosity v_eta isolated 8"}
text, plain = changes_nothing("mean", **case)
expect_everything("mean", text, plain)
parts, changes = row(text, "far field")
deck.expect_close("mean: part of the power", parts[1], 100 * plain[:, 5].mean() / plain[:, 6].mean(), atol=0.051)
deck.expect_close("mean: part of the stress", parts[0], 100 * plain[:, 9].mean() / plain[:, 0].mean(), atol=0.051)
deck.expect_close("mean: changes without it", changes, change(run("without", change="unfix far", **case), plain), atol=0.051)
deck.expect("  it is in the advice", f"  {case['drag']}\n" in advice(text), advice(text))
if deck.RANKS == 1:
    case = {"flow": PRESSED, "drag": "fix far all hydro grid", "range": "residual 0.5"}
    text, plain = changes_nothing("grid", words="change 1e-9", **case)
    shown = re.search(r"everything on.*: stress xy (\S+) ", text)
    deck.expect_close("grid: stress, but for the solutions", float(shown.group(1)), plain[:, 0].mean(), rtol=0.02)
    deck.expect("  the far field takes part", min(row(text, "far field")[0]) > 1, row(text, "far field"))
    deck.expect("  residual films are in the advice", "residual 0.5" in advice(text) and "hydro grid" in advice(text), advice(text))

    text = said(flow=STEADY, drag='if "1 == 1" then "fix far all hydro grid" "unfix move" "fix move all overdamped/sphere hydro" "timestep 1e-4"',
                range="residual 0.5", measure="yes")
    deck.expect("  and stays where it moves the particles", "far field: cannot be left out where it moves the particles" in text
                and "squeeze: cannot be left out of residual films" in text and "overdamped/sphere hydro\n" in advice(text), text)

# and where it moves the particles it stays
massless = {"flow": STEADY, "massless": "yes", "keywords": "twist no"}
text, plain = changes_nothing("overdamped", **massless)
shown = re.search(r"everything on: stress xy (\S+) ", text)
found = float(shown.group(1)) * (1 + row(text, "as the deck is")[1][0][0] / 100)
deck.expect_close("overdamped: stress as the deck is", found, plain[:, 0].mean(), rtol=6e-4)
parts, changes = row(text, "drag")
deck.expect_close("overdamped: part of the power", parts[1], 100 * plain[:, 5].mean() / plain[:, 6].mean(), atol=0.3)
deck.expect("  drag stays", not changes and "drag: cannot be left out where it moves the particles" in text)
deck.expect("  also in the advice", "  fix move all overdamped/sphere pair cell\n" in advice(text), advice(text))
deck.finish()
