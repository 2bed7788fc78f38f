"""Jamming from flow curves of known phi_m and exponent, with noise of known size."""
import contextlib
import csv
import io
import tempfile
import unittest
from pathlib import Path

import numpy as np

import jamming

IV = np.logspace(-4, -1, 7)


def law(iv, phi_m=0.58, n=0.5, b=0.8):
    """Written down without the tool."""
    return phi_m / (1 + b * iv**n)


class Fits(unittest.TestCase):
    def test_points_without_noise(self):
        for n in (0.35, 0.5):
            with self.subTest(n):
                found = jamming.fit(IV, law(IV, n=n), np.full(7, 1e-4))
                np.testing.assert_allclose((found.phi_m, found.n, found.b), (0.58, n, 0.8), rtol=1e-6)

    def test_difference_instead_of_inverse(self):
        found = jamming.fit(IV, 0.6 * (1 - 0.7 * IV**0.4), difference=True)
        np.testing.assert_allclose((found.phi_m, found.n, found.b), (0.6, 0.4, 0.7), rtol=1e-6)

    def test_errors_cover_the_truth(self):
        """The scatter of fits of 300 noisy curves is the error that each reports, also with an error of x."""
        random = np.random.default_rng(7)
        for of_phi, of_x in ((1e-3, 0.0), (2e-4, 0.05)):
            pulls, sizes = [], []
            for _ in range(300):
                x = IV * (1 + of_x * random.standard_normal(7))
                phi = law(IV) + of_phi * random.standard_normal(7)
                found = jamming.fit(x, phi, np.full(7, of_phi), of_x * x)
                pulls.append(((found.phi_m - 0.58) / found.phi_m_error, (found.n - 0.5) / found.n_error))
                sizes.append(found.chi2 / found.dof)
            self.assertTrue(np.all(np.abs(np.mean(pulls, axis=0)) < 0.25), np.mean(pulls, axis=0))
            self.assertTrue(np.all((0.75 < np.std(pulls, axis=0)) & (np.std(pulls, axis=0) < 1.1)), np.std(pulls, axis=0))
            self.assertAlmostEqual(np.mean(sizes), 1, delta=0.15)

    def test_errors_grow_where_points_scatter_more_than_they_say(self):
        random = np.random.default_rng(3)
        phi = law(IV) + 1e-3 * random.standard_normal(7)
        honest, blind = (jamming.fit(IV, phi, np.full(7, error)) for error in (1e-3, 1e-4))
        self.assertGreater(blind.chi2 / blind.dof, 10)
        self.assertAlmostEqual(blind.phi_m_error / honest.phi_m_error, 1, delta=0.5)

    def test_exponent_follows_the_phi_m_that_is_assumed(self):
        phi = law(IV) + 2e-4 * np.array([1, -1, 1, 1, -1, -1, 1])
        free = jamming.fit(IV, phi)
        kept = jamming.fit(IV, phi, phi_m=free.phi_m + 5e-4)
        self.assertAlmostEqual((kept.n - free.n) / 5e-4 / free.per_phi_m, 1, delta=0.05)
        self.assertLess(free.per_phi_m, 0)
        self.assertTrue(np.isnan(kept.phi_m_error))

    def test_viscosity_diverges_with_the_inverse(self):
        phi = np.array([0.45, 0.5, 0.53, 0.55, 0.565])
        eta = 2.5 * (0.58 / phi - 1) ** -2.0
        found = jamming.fit(1 / eta, phi)
        np.testing.assert_allclose((found.phi_m, 1 / found.n), (0.58, 2.0), rtol=1e-6)

    def test_what_cannot_be_fitted(self):
        with self.assertRaisesRegex(jamming.Unusable, "2 points cannot tell phi_m, n, b"):
            jamming.fit(IV[:2], law(IV[:2]))
        with self.assertRaisesRegex(jamming.Unusable, "positive"):
            jamming.fit([0.0, 0.1, 0.2], [0.5, 0.4, 0.3])
        with self.assertRaisesRegex(jamming.Unusable, "every point needs an error"):
            jamming.fit(IV, law(IV), np.array([1e-3] * 6 + [0.0]))
        jamming.fit(IV[:2], law(IV[:2]), n=0.5)


class Command(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.table = Path(folder.name) / "curve.csv"
        with open(self.table, "w", newline="", encoding="ascii") as file:
            writer = csv.writer(file)
            writer.writerow(["Iv", "friction", "phi", "phi_error", "viscosity", "viscosity_error"])
            for friction, phi_m in (("0", 0.63), ("0.5", 0.57)):
                for iv in IV:
                    phi = law(iv, phi_m)
                    writer.writerow([iv, friction, phi, 1e-4, 3 / iv, 0.03 / iv])
            writer.writerow([1.0, "0.5", 0.2, 1e-4, "", ""])    # off the law, beyond its range

    def call(self, *words):
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            jamming.main([str(self.table), *words])
        return out.getvalue()

    def test_rows_that_were_asked_for(self):
        self.assertIn("phi_m  0.57 +-", self.call("--where", "friction=0.5", "--up-to", "0.1"))
        self.assertIn("phi_m  0.63 +-", self.call("--where", "friction=0"))
        self.assertIn("n      0.5 (kept)", self.call("--where", "friction=0", "--exponent", "0.5"))

    def test_viscosity(self):
        text = self.call("--where", "friction=0.5", "--viscosity", "viscosity")
        self.assertIn("phi_m  0.57 +-", text)
        self.assertIn("exponent 1/n = 2 +-", text)

    def test_cures(self):
        for words, message in ((["--where", "frction=0"], "NAME one of Iv, friction"), (["--x", "iv"], "there is no column iv, but Iv"),
                               (["--where", "friction=1"], "no such rows"), (["--up-to", "1e-4", "--where", "friction=0"], "1 points cannot tell")):
            with self.subTest(message), self.assertRaises(SystemExit) as end:
                self.call(*words)
            self.assertIn(message, str(end.exception.code))


if __name__ == "__main__":
    unittest.main()
