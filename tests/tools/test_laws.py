"""Laws of the literature in examples/scene: their limits, and the numbers that follow from their printed forms."""
import sys
import unittest
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "examples" / "scene"))
import rheology    # noqa: E402  pylint: disable=wrong-import-position

DILUTE = 1e6    # viscous number
LIMIT = {"Chevremont 2019": 2.5, "Boyer 2011": 2.5, "Gallier 2014": 2.4, "Lecampion 2014": 2.5}    # [eta] of each


def phi_of(name, iv):
    return {"Chevremont 2019": lambda x: rheology.phi_chevremont(x, 0.5), "Gallier 2014": rheology.phi_gallier}.get(name, rheology.phi_boyer)(iv)


class Splits(unittest.TestCase):
    def test_dilute_limit_is_that_of_einstein(self):
        for name, split in rheology.SPLITS.items():
            with self.subTest(name):
                phi = phi_of(name, DILUTE)
                self.assertAlmostEqual((split(DILUTE)[1] / DILUTE - 1) / phi, LIMIT[name], delta=0.02)

    def test_contacts_at_jamming(self):
        for name, contact in (("Chevremont 2019", 0.36), ("Boyer 2011", 0.32), ("Gallier 2014", 0.32), ("Lecampion 2014", 0.3)):
            with self.subTest(name):
                of_contacts, of_films = rheology.SPLITS[name](1e-12)
                self.assertAlmostEqual(of_contacts, contact, delta=1e-5)
                self.assertLess(of_films, 1e-5)

    def test_sums_are_the_laws(self):
        # from the printed forms, by hand: 0.36 + 0.34/1.133 + 0.1 (1 - 0.5737/1.31623)^(-5/2); 0.32 + 0.38/1.05 + 0.1 + 1.4625 sqrt(0.1)
        self.assertAlmostEqual(sum(rheology.split_chevremont(0.1)), 1.0784, delta=1e-4)
        self.assertAlmostEqual(sum(rheology.split_boyer(0.1)), 1.2444, delta=1e-4)
        # 0.64/1.39811 = 0.45776 of 0.68: 0.1*0.32682^-1.632 = 0.6203; 0.3 + 3.70253*0.24025 and (0.1 + 3.4625*0.316228) 0.24025^2
        self.assertAlmostEqual(rheology.split_gallier(0.1)[1], 0.6203, delta=3e-4)
        for found, expected in zip(rheology.split_lecampion(0.1), (1.1895, 0.0690)):
            self.assertAlmostEqual(found, expected, delta=2e-4)

    def test_rivals_have_similar_sums(self):
        iv = np.logspace(-3, 0, 20)
        sums = np.array([sum(split(iv)) for split in rheology.SPLITS.values()])
        self.assertLess((sums.max(axis=0) / sums.min(axis=0)).max(), 1.6)

    def test_viscosity_is_eq_16(self):
        phi, jam = np.array([0.2, 0.3, 0.4, 0.5, 0.54]), 0.6301 - 0.0794 * (1 - np.exp(-0.5 / 0.4032))
        square = (jam / phi - 1) ** 2
        np.testing.assert_allclose(rheology.eta_chevremont(phi), 0.36 / square + 0.34 / (square + 0.0133) + (1 - phi) ** -2.5, rtol=1e-12)
        np.testing.assert_allclose(rheology.eta_gallier(0.4), 6.74, rtol=1e-3)    # tests/validation/far_field


if __name__ == "__main__":
    unittest.main()
