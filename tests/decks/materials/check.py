# ranks: 1 2
"""Materials by name: coefficients by hand, in every system of units, mixed, under hybrid, after a restart; refusals."""
import os
import re
from pathlib import Path

import numpy as np

import deck

os.environ["LAMMPS_POTENTIALS"] = f"{deck.ROOT / 'potentials'}:{deck.CASE}"
UNITS = {    # SI values of the units of mass, length and time (LAMMPS manual, units)
    "si": (1.0, 1.0, 1.0), "cgs": (1e-3, 1e-2, 1.0), "micro": (1e-15, 1e-6, 1e-6), "nano": (1e-21, 1e-9, 1e-9),
    "lj": (3e-12, 2e-5, 4e-3)}
# test.lubcontact: E, nu, roughness, friction (-1: none), and the radii of in.materials
SOLID = {1: (7e10, 0.25, 2e-7, 0.4, 1e-5), 2: (3e9, 0.4, 4e-7, 0.1, 2e-5), 3: (1e9, 0.5, 0.0, -1, 1.5e-5)}


def pair(i, j, soften=1.0, radius=None, load=None, kind="harmonic"):
    """g, kt (N/m), roughness over a, friction of two types, from the formulas of the manual."""
    (e1, n1, h1, mu1, r1), (e2, n2, h2, mu2, r2) = SOLID[i], SOLID[j]
    if radius:
        r1, r2 = radius[i - 1], radius[j - 1]
    e1, e2 = e1 / soften, e2 / soften
    star = 1 / ((1 - n1**2) / e1 + (1 - n2**2) / e2)
    shear = 1 / ((2 - n1) / (e1 / (2 * (1 + n1))) + (2 - n2) / (e2 / (2 * (1 + n2))))
    g = 1 / (1 / (2 * e1 * r1) + 1 / (2 * e2 * r2))
    if load:    # overlap of Hertz' law at this force
        g = load / (load / (4 / 3 * star * np.sqrt(r1 * r2 / (r1 + r2)))) ** (2 / 3)
    a = 2 * r1 * r2 / (r1 + r2) if kind == "harmonic" else (r1 + r2) / 2
    height, friction = (h1 + h2) / 2, np.sqrt(mu1 * mu2) if mu1 >= 0 and mu2 >= 0 else -1
    if {i, j} == {2, 3}:    # a line of its own in the file
        height, friction = 3e-7, 0.3
    return [g, g * 4 * shear / star, height / a, friction]


def coefficients(name):
    section = Path(name).read_text().split("PairIJ Coeffs")[1].split("Atoms")[0]
    rows = re.findall(r"^(\d) (\d) (\S+) (\S+) asperity \S+ roughness (\S+)(?: friction coulomb (\S+))?", section,
                      re.MULTILINE)
    return {(int(r[0]), int(r[1])): [float(x) if x else -1.0 for x in r[2:]] for r in rows}


def expect_pairs(what, name, pairs=((1, 1), (1, 2), (1, 3), (2, 2), (2, 3), (3, 3)), stiffness=1.0, **options):
    found = coefficients(name)
    deck.expect(f"{what}: pairs", set(found) == set(pairs), sorted(found))
    for i, j in pairs:
        expected = pair(i, j, **options)
        expected[:2] = [k / stiffness for k in expected[:2]]
        deck.expect_close(f"{what}: {i} {j}", found[i, j], expected, rtol=2e-12)


ONE_RANK = deck.RANKS == 1    # what is the same on any number of ranks is tested on one
FILE = "* * test.lubcontact"
for units, (mass, length, time) in UNITS.items():
    if not ONE_RANK and units != "cgs":
        continue
    extra = f" scale {mass} {length} {time}" if units == "lj" else ""
    text = deck.run("in.materials", units=units, length=length, density=1900 * length**3 / mass,
                    coeff=f"{FILE} Glass Plastic Smooth{extra}").text
    expect_pairs(units, "out.data", stiffness=mass / time**2)
    expect_pairs(f"{units}, restarted", "again.data", stiffness=mass / time**2)
    deck.expect(f"{units}: densities that differ", text.count("materials do not set masses") == 2)
    deck.expect(f"{units}: the one that is not known is not judged", "differs from that of Smooth" not in text)
text = deck.run("in.materials", density=2200, coeff=f"{FILE} Glass Glass Smooth").text
deck.expect("densities that nearly agree", "materials do not set masses" not in text)
deck.expect("date of the file", "test.lubcontact with DATE: 2026-11-22" in text)
deck.expect("table", "type 1         Glass: modulus 7e+10, measured 7e+10, poisson 0.25, radius 1e-05, mean" in text)
deck.expect("table of pairs", "types 1 1      g 700000 kt 600000 roughness 0.02 friction coulomb 0.4" in text)

NAMES = f"{FILE} Glass Plastic Smooth"
deck.run("in.materials", coeff=f"{NAMES} soften 1e4")
expect_pairs("soften", "out.data", soften=1e4)
deck.run("in.materials", coeff=f"{NAMES} radius 3e-5", style="lubcontact 1.0 cut 0.5 radius mean")
expect_pairs("radius", "out.data", radius=[3e-5] * 3)
deck.run("in.materials", coeff=f"{NAMES} radius 3e-5 1e-5 2e-5 load 2e-3 soften 10",
         style="lubcontact 1.0 cut 0.5 radius mean")
expect_pairs("load, radii", "out.data", radius=[3e-5, 1e-5, 2e-5], load=2e-3, soften=10, kind="mean")
for solid in SOLID:
    SOLID[solid] = (5e6, *SOLID[solid][1:])
text = deck.run("in.materials", coeff=f"{NAMES} modulus 5e6").text
expect_pairs("modulus", "out.data")
deck.expect("measured modulus is shown", "Glass: modulus 5e+06, measured 7e+10" in text)

# what the command says of the surfaces replaces the file, for all pairs
deck.run("in.materials", coeff=f"{FILE} Bare Bare Plastic modulus 1e6 friction coulomb 0.7 roughness 0.01 asperity 3.0")
for key, values in coefficients("out.data").items():
    deck.expect(f"words of the command: {key}", values[2:] == [0.01, 0.7], values)
deck.expect("words of the command: asperity", Path("out.data").read_text().count(" asperity 3 ") == 6)

# NULL: other styles have these types
SOLID[1], SOLID[3] = (7e10, *SOLID[1][1:]), (1e9, *SOLID[3][1:])
g, kt, eps, _ = pair(1, 3)
alone = deck.run("in.hybrid", way="alone", g=g, kt=kt, eps=eps).values["force"]
text = deck.run("in.hybrid")
deck.expect("hybrid: spheres repel", alone < 0.0, alone)
deck.expect_close("hybrid: force of the same numbers", text.values["force"], alone, rtol=1e-12)
deck.expect("hybrid: no type 2", "  type 2  " not in text.text)

# the file that comes with the package: what is complete is used as it is
text = deck.run("in.materials", coeff="* * common.lubcontact Glass Steel Delrin soften 1e3").text
deck.expect_close("common: glass", coefficients("out.data")[1, 1], [71e6 * 1e-5, 71e6 * 1e-5 * 2 * .77 / 1.77, .0134, .4],
                  rtol=1e-12)
deck.run("in.materials", coeff="* * common.lubcontact Silica PMMA Polystyrene friction none roughness 0.01")
deck.run("in.materials", coeff="* * common.lubcontact CornStarch NULL CornStarch friction none roughness 0.01",
         fails=True)    # NULL without hybrid: LAMMPS misses these pairs

if not ONE_RANK:
    deck.finish()

# each number that comes with the package says how it came there
for name in deck.ROOT.glob("potentials/*.lubcontact"):
    covered = False
    for number, line in enumerate(name.read_text().splitlines(), 1):
        words, _, comment = line.partition("#")
        if words.startswith("material"):
            covered = False
        elif words.strip():
            covered = covered or "[text] all of it" in comment
            if not covered and not re.search(r"\[(text|memory|assumed)\]", comment):
                deck.expect(f"{name.name}, line {number}: source", False, line)

# refusals
TEMPLATE = (deck.CASE / "in.materials").read_text()


def refused(coeff, message, word, units="si", style="lubcontact 1.0 cut 0.5"):
    text = TEMPLATE.replace("${units}", units).replace("${coeff}", coeff).replace("${style}", style)
    Path("in.now").write_text(text)
    shown = deck.run(str(Path.cwd() / "in.now"), fails=True).text
    deck.expect_error(coeff, shown, message, None if "parsed" in str(word) else word)
    return shown


def write_file(name, text, units="UNITS: si"):
    Path(name).write_text(f"# DATE: now {units}\n{text}")


GLASS = "material Glass\nmodulus 1e9\npoisson 0.3\n"
write_file("bad.lubcontact", "material Glass\nmodulus 7O\npoisson 0.3\n")
write_file("missing.lubcontact", "material Glass\npoisson 0.3\n")
write_file("twice.lubcontact", GLASS + GLASS)
write_file("nounits.lubcontact", GLASS, "")
write_file("cgs.lubcontact", GLASS, "UNITS: cgs")
write_file("empty.lubcontact", "")
write_file("clm.lubcontact", GLASS + "roughness 1e-7\nfriction clm shift 0.5 1e-9\nmaterial B\nmodulus 1\npoisson 0\n"
           "roughness 0\nfriction clm step 0.5 1e-9\n")
ALL = "Glass Plastic Smooth"
for coeff, message, word in (
        (f"* * none.lubcontact {ALL}", "Cannot open none.lubcontact: neither a number", "none.lubcontact"),
        (f"* * 1e4x {ALL}", "stiffness g of pair style lubcontact", "1e4x"),
        (f"1 1 test.lubcontact {ALL}", "Materials need pair_coeff * *, but found 1", "1"),
        ("* * test.lubcontact Glass Plastik Smooth",
         "no material Plastik in test.lubcontact, which has: Glass Plastic Smooth Bare", "Plastik"),
        ("* * test.lubcontact Glass Plastic", "for each of the 3 atom types, but has 2", "Plastic"),
        ("* * test.lubcontact Glass soften 1e4", "for each of the 3 atom types, but has 1", "Glass"),
        ("* * test.lubcontact NULL NULL NULL", "NULL stands for all 3 atom types", "NULL"),
        ("* * test.lubcontact Glass Glass NULL Glass", "for each of the 3 atom types, but has 4", "Glass"),
        ("* * test.lubcontact Glass Bare Smooth", "has no roughness for Glass with Bare: add roughness", "Bare"),
        ("* * test.lubcontact Glass Bare Smooth roughness 0", "has no friction for Glass with Bare", "Bare"),
        (f"{NAMES} soften 1e-4", "soften divides the moduli and must be >= 1, but is 1e-4", "1e-4"),
        (f"{NAMES} modulus 0", "modulus must be > 0, but is 0", "0"),
        (f"{NAMES} load", "missing argument: F; write: load F", None),
        (f"{NAMES} scale 1 2", "missing argument: T; write: scale M L T", None),
        (f"{NAMES} radius 1 2", "one number or one for each of the 3 atom types, but has 2", "2"),
        (f"{NAMES} scale 1 1 1", "scale is for units lj only, not for units si", "scale"),
        (f"{NAMES} roughness 0.01 soften 2", "soften must come before roughness", "soften"),
        ("* * bad.lubcontact Glass Glass Glass",
         "bad.lubcontact, line 3: modulus must be a number, but is 7O", "bad.lubcontact"),
        ("* * missing.lubcontact Glass Glass Glass",
         "missing.lubcontact, line 3: material Glass above has no modulus", "missing.lubcontact"),
        ("* * twice.lubcontact Glass Glass Glass",
         "twice.lubcontact, line 5: material Glass is already in line 2", "twice.lubcontact"),
        ("* * nounits.lubcontact Glass Glass Glass", "must have UNITS: si in its first line, but has none",
         "nounits.lubcontact"),
        ("* * cgs.lubcontact Glass Glass Glass", "UNITS: si in its first line, but has cgs", "cgs.lubcontact"),
        ("* * empty.lubcontact Glass Glass Glass", "line 1: there is no material", "empty.lubcontact"),
        ("* * clm.lubcontact NULL Glass B radius 1 friction none roughness 0 hardness 3",
         "Unknown pair_coeff lubcontact keyword: hardness", "hardness")):
    refused(coeff, message, word)
refused(f"{FILE} Glass Plastic Glass roughness 0", "friction cannot act: surfaces of roughness 0", None)
refused(NAMES, "under units lj add scale M L T", "test.lubcontact", units="lj")
refused(NAMES, "or lj with scale, not for units real", None, units="real")

# an error in the words made from a file: the made command is shown
shown = refused(NAMES, "roughness must be below the range 0.001", None, style="lubcontact 1.0 cut 0.001")
deck.expect("made command is shown", "test.lubcontact makes of" in shown and "pair_coeff 1 1 700000" in shown, shown)
# under hybrid the words stand one place later
write_hybrid = (deck.CASE / "in.hybrid").read_text().replace("${name}", "Gras")
Path("in.now").write_text(write_hybrid)
shown = deck.run(str(Path.cwd() / "in.now"), fails=True).text
deck.expect_error("hybrid", shown, "no material Gras in test.lubcontact", None)
lines = shown.splitlines()
carets = next(n for n, line in enumerate(lines) if line.strip(" ^") == "" and "^" in line)
deck.expect("  underlined: Gras", lines[carets - 1][lines[carets].index("^"):][:4] == "Gras", lines[carets - 1])
deck.finish()
