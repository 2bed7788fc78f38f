"""README of the project: its table 'Measured' says what the csv files say, its pages and programs are there, and it is short."""
import csv
import re
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "examples" / "scene"), str(ROOT / "benchmarks" / "accuracy_cost")]
import rheology    # noqa: E402  pylint: disable=wrong-import-position
import suspension_laws    # noqa: E402  pylint: disable=wrong-import-position

README = (ROOT / "README.md").read_text(encoding="ascii")
LINES = 120    # more than that nobody reads


def read(name):
    """Rows of a csv file, whichever of the two delimiters it has."""
    lines = (ROOT / name).read_text(encoding="ascii").splitlines()
    return list(csv.DictReader(lines, delimiter=";" if ";" in lines[0] else ","))


def column(rows, key, /, **where):
    """Numbers of a column, of the rows with these values."""
    found = [float(row[key]) for row in rows if all(row[k] == value for k, value in where.items())]
    if not found:
        raise KeyError(f"no row with {where}")
    return found


def mean(values):
    return sum(values) / len(values)


def standard_error(values):
    return (sum((v - mean(values)) ** 2 for v in values) / (len(values) - 1) / len(values)) ** 0.5


def span(rows, *knobs):
    """Smallest and largest viscosity of some knobs."""
    values = [value for knob in knobs for value in column(rows, "eta_r", knob=knob)]
    return f"{min(values):.0f} to {max(values):.0f}"


# What a row of the table has to say, from the rows of its csv file: the first words of the claim -> text of the number.

def viscosity(rows):
    seeds = column(rows, "eta_r", knob="base") + column(rows, "eta_r", knob="seed")
    return (f"{mean(seeds):.1f} +- {standard_error(seeds):.1f}; "
            f"{rheology.eta_boyer(0.5):.1f}, {rheology.eta_chevremont(0.5):.1f}")


def contacts(rows):
    total = mean(column(rows, "eta_r", knob="base") + column(rows, "eta_r", knob="seed"))
    parts = [mean(column(rows, name, knob="base") + column(rows, name, knob="seed")) for name in ("contact_n", "contact_t")]
    return f"{100 * sum(parts) / total:.0f} %"


def sensitivity(rows):
    return "; ".join(span(rows, knob) for knob in ("range", "roll coefficient", "friction"))


def range_of_films(rows):
    return ", ".join(f"{mean(column(rows, 'eta_r', rule='cut', reach='0.5', phi=phi)) / rheology.eta_chevremont(float(phi)):.2f}"
                     for phi in ("0.4", "0.45", "0.5", "0.54", "0.55"))


def off_phi(rows, *numbers):
    """Largest distance to the law of Chevremont et al. at each viscous number, over the frictions."""
    def off(iv, mu):
        return abs(mean(column(rows, "phi", Iv=iv, friction=mu)) - rheology.phi_chevremont(float(iv), float(mu)))
    return "; ".join(f"{max(off(iv, mu) for mu in ('0', '0.3', '0.5')):.3f}" for iv in numbers)


def far_field(rows):
    def over_law(phi, **where):
        return column(rows, "eta_r", phi=phi, friction="0.5", **where)[0] / rheology.eta_chevremont(float(phi))
    return "; ".join(", ".join(f"{over_law(phi, level=level, range=reach):.2f}" for phi in ("0.1", "0.2", "0.3", "0.4", "0.45", "0.5"))
                     for level, reach in (("grid", "1"), ("none", "0.5")))


def thickening(rows):
    etas = [1 / rate for rate in column(rows, "mean_rate", drive="stress", phi="0.56")]    # at a stress of 1, viscosity 1
    return f"{min(etas):.0f} to {float(f'{max(etas):.2e}'):.0f}"


def pair_in_shear(rows):
    (order,), (error,) = (column(rows, name, scene="pair in shear", setting="smooth") for name in ("order_exponential", "at_limit_exponential"))
    return f"{order:.2f}; {error:.0e}"


def longer_steps(rows):
    def accurate(scene, method):
        return column(rows, "accurate dt", scene=scene, method=method)[0]
    return ", ".join(f"{accurate(scene, 'lubcontact, gap exponential') / accurate(scene, 'granular + lubricate, inner gap 1e-3'):.0f}"
                     for scene in ("squeeze", "pass", "suspension"))


def tolerances(rows):
    converged, _ = suspension_laws.converged(suspension_laws.read()[0])
    kept = []
    for tolerance in ("0.3", "0.2", "0.1"):
        etas = column(rows, "eta_r", tolerance=tolerance)
        good = sum(abs(eta / converged - 1) < float(tolerance) for eta in etas)
        kept.append(f"{good} of {len(etas)}, {mean(column(rows, 'cpu', tolerance=tolerance)):.0f} s")
    return "; ".join(kept)


def lists(rows):
    def speed(particles, which):
        return column(rows, "speed", particles=particles, ranks="1", lists=which)[0]
    return "; ".join(f"{speed(n, 'affine') / speed(n, 'lammps'):.1f}" for n in ("4000", "1008000"))


def speed_usual(rows):
    return f"{column(rows, 'speed_usual', name='all')[0]:.1f}"


def speed_small(rows):
    every = "{:.1f}; {:.2f}".format(*(column(rows, name, name="all")[0] for name in ("speed", "speed_over_overlay")))
    return f"{every}; {column(rows, 'pair_over_gran', name='squeeze')[0]:.2f}"


CLAIMS = {
    "Relative viscosity": viscosity,
    "Share of contacts": contacts,
    "What moves it": sensitivity,
    "Range of the films": range_of_films,
    "Volume fraction under an imposed pressure": lambda rows: off_phi(rows, "1e-3", "1e-2", "0.1", "1"),
    "The far field": far_field,
    "Critical-load friction thickens": thickening,
    "Pair in shear": pair_in_shear,
    "Largest accurate time step": longer_steps,
    "Settings of `suspension_scene tolerance`": tolerances,
    "Neighbor lists": lists,
    "Speed at the step that users take": speed_usual,
    "Speed at a small step": speed_small,
}


def table():
    """Rows of the table: claim, number, command."""
    rows = re.findall(r"^\| (.*) \| (.*) \| (.*) \|$", README[README.index("## Measured"):], re.MULTILINE)
    return [row for row in rows if row[0] not in ("claim", "---")]


class Measured(unittest.TestCase):
    def test_numbers_are_those_of_the_csv_files(self):
        for claim, number, command in table():
            with self.subTest(claim):
                law = [found for words, found in CLAIMS.items() if claim.startswith(words)]
                self.assertEqual(len(law), 1, "no function here says what this row has to say, or several do")
                (name,) = re.findall(r"\]\(([^)]*\.csv)\)", command)
                self.assertEqual(number, law[0](read(name)), f"{name} says something else")

    def test_every_claim_has_a_row(self):
        for words in CLAIMS:
            self.assertEqual(sum(claim.startswith(words) for claim, _, _ in table()), 1, words)

    def test_programs_are_there(self):
        for claim, _, command in table():
            (program,) = re.findall(r"`(?:tools/python\.sh )?([\w/]+\.(?:py|sh))[^`]*`", command)
            self.assertTrue((ROOT / program).is_file(), f"{claim}: {program}")


class Links(unittest.TestCase):
    def test_files_are_there(self):
        for target in re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", README):
            if not target.startswith("http"):
                self.assertTrue((ROOT / target).exists(), target)

    def test_every_page_of_a_style_is_in_the_table(self):
        for page in (ROOT / "doc" / "src").glob("*.rst"):
            if re.search(r"^\.\. index:: ", page.read_text(encoding="ascii"), re.MULTILINE):
                self.assertIn(f"(doc/src/{page.name})", README)


class Form(unittest.TestCase):
    def test_short(self):
        self.assertLessEqual(len(README.splitlines()), LINES)

    def test_version_of_the_citation(self):
        cmake = (ROOT / "CMakeLists.txt").read_text(encoding="ascii")
        version = re.search(r"project\(suspension VERSION (\S+)", cmake)[1]
        self.assertIn(f"\nversion: {version}\n", (ROOT / "CITATION.cff").read_text(encoding="ascii"))


if __name__ == "__main__":
    unittest.main()
