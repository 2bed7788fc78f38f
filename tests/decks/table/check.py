"""The table that the pair style prints at the start: sizes, numbers, and which effects really act."""
import re

import deck

TITLE = "Pair style lubcontact: what this run simulates"


def tables(**variables):
    """The tables of a run, each a dict of what stands in front and behind; and all its text."""
    text = deck.run("in.table", **variables).text
    found = []
    for part in text.split(TITLE)[1:]:
        rows = [re.match(r"  (\S.{13}) (.*)$", line) for line in part.splitlines()[1:]]
        ends = next((n for n, row in enumerate(rows) if not row), len(rows))
        found.append({row.group(1).strip(): row.group(2) for row in rows[:ends]})
    return found, text


def number(row, name):
    return float(re.search(rf"{re.escape(name)} = (\S+?),? ", row + " ").group(1))


(table,), text = tables()
deck.expect("number and sizes", table["particles"].startswith("4, radius 1 to 3, mean 1.5, 1 pairs in range"), table["particles"])
deck.expect_close("St, of mean radius and density", number(table["shear rate"], "St = rho a^2 rate/eta"), 2.5 * 1.5**2 * 0.1 / 2.0, rtol=5e-3)
deck.expect_close("Ca, of mean radius", number(table["shear rate"], "Ca = eta rate a/g"), 2.0 * 0.1 * 1.5 / 1e4, rtol=5e-3)
deck.expect("which radius", table["shear rate"].endswith("a = mean radius"), table["shear rate"])
deck.expect("friction acts", table["friction"] == "yes", table["friction"])

# points of other styles are no particles of this one, and no reason for a warning
(table,), text = tables(scene="points")
deck.expect("points: number and sizes", table["particles"].startswith("3, radius 1 to 1, mean 1, "), table["particles"])
deck.expect("points: no warning of a repulsion that jumps", "jumps" not in text)
deck.expect("points: no infinite number", "inf" not in str(table), table)

# before particles are poured, and once there are some
found, _ = tables(scene="pour")
before, after = found[0], found[-1]
deck.expect("pour: none yet", before["particles"].startswith("none yet"), before["particles"])
deck.expect("pour: no infinite number", "inf" not in str(before), before)
deck.expect("pour: the next table has them", after["particles"].startswith("20, radius 1.25 to 1.25"), after["particles"])

# an effect that is on and does nothing says why
SMOOTH = {"style": "lubcontact 2.0 cut 0.5 squeeze no"}
for variables, row, state in (
        ({**SMOOTH, "coeff": "* * 1e4 5e3 friction coulomb 0.5"}, "friction", "yes"),
        ({"style": "lubcontact 0 cut 0.5", "coeff": "* * 1e4 5e3 friction coulomb 0.5"}, "friction", "yes"),
        ({"style": "lubcontact 0 cut 0.5"}, "squeeze film", "not now: viscosity 0"),
        ({"style": "lubcontact 0 cut 0.5"}, "twisting film", "not now: viscosity 0"),
        ({"style": "lubcontact 2 cut 0.5 rollcoeff 0"}, "rolling film", "not now: coefficient 0"),
        ({"style": "lubcontact 2 cut 0.5 roll no"}, "rolling film", "no"),
        ({"coeff": "* * 1e4 5e3 friction coulomb 0"}, "friction", "not now: coefficient 0"),
        ({"coeff": "* * 1e4 5e3"}, "friction", "no"),
        ({"coeff": "* * 1e4 5e3 repulsion 0 0.05"}, "repulsion", "not now: force 0"),
        ({"coeff": "* * 1e4 5e3 repulsion 1 0.05"}, "repulsion", "yes"),
        ({"style": "lubcontact v_eta cut 0.5", "coeff": "* * 1e4 5e3 friction coulomb 0.5"}, "friction",
         "not now: smooth surfaces do not touch through a film"),
        ({"coeff": "* * 1e4 5e3 friction coulomb 0.5", "more": "fix a all adapt 1 pair lubcontact roughness * * v_eps"},
         "friction", "not now: smooth surfaces do not touch through a film")):
    (table,), _ = tables(**variables)
    deck.expect(f"{row}: {variables}", table[row] == state, table[row])

# of two types one is smooth: their contacts are frictional, those of the smooth ones among themselves are not
rough, smooth = "1 1 1e4 5e3 roughness 0.01 friction coulomb 0.5", "2 2 1e4 5e3 friction coulomb 0.5"
(table,), _ = tables(coeff=f"{rough}", more=f"pair_coeff {smooth}")
deck.expect("rough on smooth is frictional", table["friction"] == "yes" and not table["types 1 2"].endswith("without friction"),
            table["types 1 2"])
deck.expect("smooth on smooth is not", table["types 2 2"].endswith(": smooth, without friction"), table["types 2 2"])
deck.finish()
