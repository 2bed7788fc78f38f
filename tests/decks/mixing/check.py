"""Mixed coefficients: springs in series, mean roughness and screening length, geometric friction, critical load, adhesion and
repulsion; the same after a restart and from a data file."""
from pathlib import Path

import deck

deck.run("in.mixing")


def coefficients(name):
    """The words after pair_coeff I J, numbers as numbers."""
    section = Path(name).read_text().split("PairIJ Coeffs")[1].split("Atoms")[0]
    rows = [line.split() for line in section.splitlines()[2:] if line.strip()]

    def value(word):
        return float(word) if word[0].isdigit() else word

    return {(row[0], row[1]): [value(word) for word in row[2:]] for row in rows}


def words(g, kt, k, eps, *laws):
    return [g, kt, "asperity", k, "roughness", eps, *laws]


NONE = ("friction", "none")
GIVEN = words(1000, 400, 1000, 0.01, "friction", "clm", "ramp", 0.3, 7, "repulsion", 0, 0.02)
expected = {
    ("1", "1"): words(1000, 300, 1000, 0.01, "friction", "coulomb", 0.4),
    ("1", "2"): words(1500, 375, 1200, 0.02, "friction", "coulomb", 0.6),    # 2ab/(a+b), sqrt(0.4*0.9)
    ("1", "3"): words(111, 22, 111, 0.05, *NONE),    # given
    ("2", "2"): words(3000, 500, 1500, 0.03, "friction", "coulomb", 0.9),
    ("2", "3"): words(2400, 4000 / 9, 12000 / 7, 0.015, *NONE),    # no friction, because 3 has none
    ("3", "3"): words(2000, 400, 2000, 0, *NONE),
    ("3", "4"): words(4000 / 3, 400, 4000 / 3, 0.01, *NONE, "restitution", 0.9 ** 0.5),    # 3 neither sticks nor repels
    ("3", "5"): words(4000 / 3, 400, 4000 / 3, 0.02, *NONE, "restitution", 0.4 ** 0.5),
    ("4", "4"): words(1000, 400, 1000, 0.02, "friction", "clm", "step", 0.2, 4, "adhesion", 0.01, "repulsion", 2, 0.01, "restitution", 0.9),
    ("4", "5"): words(1000, 400, 1000, 0.03, "friction", "clm", "step", 0.4, 6, "adhesion", 0.02, "repulsion", 4, 0.02, "restitution", 0.6),
    ("5", "5"): words(1000, 400, 1000, 0.04, "friction", "clm", "step", 0.8, 9, "adhesion", 0.04, "repulsion", 8, 0.03, "restitution", 0.4),
    ("1", "4"): GIVEN, ("1", "5"): GIVEN, ("2", "4"): GIVEN, ("2", "5"): GIVEN,
}
found = coefficients("mixed.data")
deck.expect("every pair is written", set(found) == set(expected))
for pair, row in expected.items():
    names, numbers = ([x for x in row if isinstance(x, str)], [x for x in row if not isinstance(x, str)])
    got = found[pair]
    deck.expect(f"pair {pair}: words", [x for x in got if isinstance(x, str)] == names, " ".join(map(str, got)))
    deck.expect_close(f"pair {pair}: numbers", [x for x in got if not isinstance(x, str)], numbers, rtol=1e-12)
deck.expect("the same after a restart", coefficients("again.data") == found)
deck.expect("the same from the data file", coefficients("third.data") == found)
deck.finish()
