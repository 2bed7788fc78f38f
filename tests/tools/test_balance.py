"""The suspension balance against closed forms, a direct integration, and numbers computed by hand from the printed laws."""
import contextlib
import csv
import io
import tempfile
import unittest
from pathlib import Path

import numpy as np

import ave_chunk
import balance
import normal_viscosity
from normal_viscosity import Law, named

# eta at phi/phi_m .5, .6, .7, .8, .9, .95, three digits; phi_m = .58 for all but Boyer's
AT = np.array([0.5, 0.6, 0.7, 0.8, 0.9, 0.95])
VALUES = {
    "chevremont_22": (0.154, 0.970, 4.69, 19.5, 91.0, 342),
    "chevremont_22_exponential": (0.475, 1.90, 6.44, 20.8, 92.9, 376),
    "boyer_22": (1, 2.25, 5.444, 16, 81, 361),
    "chevremont_33": (0.042, 0.374, 2.33, 11.9, 66.8, 272),
}
# (h - h0)/h0 at Acrivos numbers .1, .5, 1, 2, 5 for phi0 = .58, two digits
ACRIVOS = (0.1, 0.5, 1, 2, 5)
GROWTH = {
    "chevremont_33": (0.28, 0.46, 0.54, 0.64, 0.77), "chevremont_33_exponential": (0.30, 0.52, 0.63, 0.75, 0.93),
    "chevremont_22": (0.34, 0.57, 0.68, 0.80, 0.97), "boyer_33": (0.29, 0.66, 0.94, 1.34, 2.12),
    "zarraga_33": (0.34, 0.63, 0.80, 1.03, 1.42),
}
CHUNKS = """# Chunk-averaged data for fix profile and group all
# Timestep Number-of-chunks Total-count
# Chunk Coord1 Ncount v_phi
100 3 40
  1 0.5 20 0.5
  2 1.5 15 0.3
  3 2.5 5 0.1
200 3 42
  1 0.5 21 0.52
  2 1.5 15 0.3
  3 2.5 6 0.14
"""


class Laws(unittest.TestCase):
    def test_values_of_the_printed_formulas(self):
        for name, expected in VALUES.items():
            law = named(name)
            np.testing.assert_allclose(law.eta(AT * law.phi_m), expected, rtol=0.007, atol=0.0005, err_msg=name)

    def test_coefficients_of_the_power_laws(self):
        # at phi = phi_m/2 the power is one, at 2/3 phi_m it is 2^exponent
        expected = {"zarraga": (3, 0.62, 1.55, 1.36, 0.62), "morris": (2, 0.68, 0.75, 0.6, 0.375), "boyer": (2, 0.585, None, 1, 0.6)}
        for name, (exponent, phi_m, *coefficients) in expected.items():
            for axis, coefficient in zip((11, 22, 33), coefficients):
                if coefficient is not None:
                    eta = named(f"{name}_{axis}").eta(np.array([phi_m / 2, phi_m / 1.5]))
                    np.testing.assert_allclose(eta, [coefficient, coefficient * 2**exponent], rtol=1e-12)

    def test_ratio_along_the_vorticity(self):
        # both forms of lambda_33 end at 1 at random close packing, and agree where there are data
        self.assertAlmostEqual(normal_viscosity.lambda_33_line(0.64), 1)
        self.assertAlmostEqual(float(normal_viscosity.lambda_33(0.64)), 1, delta=1.1e-3)
        phi = np.linspace(0.35, 0.61, 30)
        np.testing.assert_allclose(normal_viscosity.lambda_33(phi), normal_viscosity.lambda_33_line(phi), atol=0.05)
        # the printed eq. 10 is eta_22: what is here is not
        self.assertLess(named("chevremont_33").eta(0.3) / named("chevremont_22").eta(0.3), 0.33)

    def test_all_grow_and_diverge(self):
        for name in normal_viscosity.LAWS:
            law = named(name)
            phi = np.linspace(law.phi_low, law.phi_m, 500)[2:-1]
            self.assertTrue(np.all(np.diff(law.eta(phi)) > 0) and law.eta(phi[0]) >= 0, name)
            self.assertGreater(law.eta(0.9999 * law.phi_m), 1e5)
            self.assertAlmostEqual(float(law.eta(law.phi_low + 1e-12)), 0, delta=1e-9)

    def test_another_jamming(self):
        self.assertAlmostEqual(float(named("boyer_33", 0.6).eta(0.3)), 0.6)
        for wrong in (1.0, 0.0, 0.1):
            with self.assertRaisesRegex(ValueError, "phi_m must be"):
                named("chevremont_33_line", wrong)
        with self.assertRaisesRegex(ValueError, "no law boyer.*boyer_33"):
            named("boyer")

    def test_table(self):
        boyer = named("boyer_33")
        points = np.array([0.45, 0.35, 0.55, 0.5])    # in any order
        law = normal_viscosity.table("t", points, boyer.eta(points))
        phi = np.linspace(0.05, 0.58, 40)
        np.testing.assert_allclose(law.eta(phi), boyer.eta(phi), rtol=1e-9)    # exact for exponent 2, beyond, too
        self.assertAlmostEqual(law.phi_m, 0.585)
        thesis = named("chevremont_33")
        points = np.linspace(0.3, 0.56, 14)
        law = normal_viscosity.table("t", points, thesis.eta(points))
        phi = np.linspace(0.31, 0.55, 40)
        np.testing.assert_allclose(law.eta(phi), thesis.eta(phi), rtol=0.04)    # eta grows by 1.9 in the first step of .02
        for phi, eta in (([0.4], [1]), ([0.4, 0.5], [1, 1]), ([0.4, 0.5], [-1, 1]), ([0.4, 0.4], [1, 2]), ([0.0, 0.4], [1, 2])):
            with self.assertRaisesRegex(ValueError, "grow together"):
                normal_viscosity.table("t", phi, eta)


class Profiles(unittest.TestCase):
    def power(self, exponent, coefficient=0.6, phi_m=0.585):
        return Law("power", normal_viscosity.power(coefficient, exponent, phi_m), phi_m)

    def test_closed_form_of_exponent_2(self):
        # eta = c s^2, s = phi/(phi_m - phi) = S at the floor; d eta/phi = (2 c/phi_m)(1 + s) ds
        c, phi_m = 0.6, 0.585
        for shields, column in ((0.2, 25.0), (2.0, 25.0), (20.0, 25.0), (2.0, 0.1), (1e-3, 40.0)):
            found = balance.profile(self.power(2), shields, column)
            floor = np.sqrt(column / shields / c)
            s = found.phi / (phi_m - found.phi)
            z = shields * c / phi_m * ((1 + floor) ** 2 - (1 + s) ** 2)
            tall = shields * c / phi_m * ((1 + floor) ** 2 - 1)
            np.testing.assert_allclose(found.z, z, atol=1e-9 * tall)
            self.assertAlmostEqual(found.height / tall, 1, delta=1e-6)
            self.assertAlmostEqual(found.phi[0] / (phi_m * floor / (1 + floor)), 1, delta=1e-12)
            center = shields**2 * 2 * c**2 / phi_m * (floor**3 / 3 + floor**4 / 4) / column
            self.assertAlmostEqual(found.center / center, 1, delta=1e-6)

    def test_closed_form_of_exponent_3(self):
        # q = phi/phi_m: integral of d eta/phi = (3 c/phi_m) [1/(3 (1-q)^3) - 1/(2 (1-q)^2)]
        c, phi_m, shields, column = 0.62, 0.62, 2.0, 25.0
        found = balance.profile(self.power(3, c, phi_m), shields, column)

        def integral(q):
            return 3 * c / phi_m * (1 / (3 * (1 - q) ** 3) - 1 / (2 * (1 - q) ** 2))
        floor = (column / shields / c) ** (1 / 3)
        floor = floor / (1 + floor)
        np.testing.assert_allclose(found.z, shields * (integral(floor) - integral(found.phi / phi_m)), atol=1e-8)
        self.assertAlmostEqual(found.height, shields * (integral(floor) - integral(0)), delta=1e-7)

    def test_an_osmotic_pressure_settles_exponentially(self):
        law, shields, column = Law("gas", lambda phi: 3.0 * phi, 1.0), 0.5, 0.4
        found = balance.profile(law, shields, column)
        np.testing.assert_allclose(found.phi, column / 1.5 * np.exp(-found.z / 1.5), rtol=1e-9)
        self.assertEqual(found.height, np.inf)
        self.assertAlmostEqual(found.center, 1.5, delta=1e-9)

    def test_direct_integration_of_the_thesis(self):
        law, shields, column = named("chevremont_33"), 2.0, 25.0
        found = balance.profile(law, shields, column)

        def slope(phi):
            return -phi / shields * 2e-6 / (law.eta(phi + 1e-6) - law.eta(phi - 1e-6))
        phi, step = found.phi[0], 0.02
        for n in range(int(50 / step)):    # Runge and Kutta, up from the floor
            if n % 250 == 0:
                self.assertAlmostEqual(phi, np.interp(n * step, found.z, found.phi), delta=2e-5)
            k1 = slope(phi)
            k2 = slope(phi + 0.5 * step * k1)
            k3 = slope(phi + 0.5 * step * k2)
            phi += step / 6 * (k1 + 2 * k2 + 2 * k3 + slope(phi + step * k3))

    def test_all_laws_hold_the_column(self):
        for name in normal_viscosity.LAWS:
            for shields in (0.02, 2.0, 50.0):
                found = balance.profile(named(name), shields, 25.0)
                mass = np.sum(0.5 * (found.phi[1:] + found.phi[:-1]) * np.diff(found.z))
                self.assertAlmostEqual(mass / 25, 1, delta=2e-4, msg=f"{name} {shields}")
                moment = np.sum(0.5 * (found.phi[1:] * found.z[1:] + found.phi[:-1] * found.z[:-1]) * np.diff(found.z))
                self.assertAlmostEqual(moment / 25 / found.center, 1, delta=2e-3, msg=f"{name} {shields}")
                self.assertAlmostEqual(found.eta[0] * shields / 25, 1, delta=1e-9)

    def test_one_curve_over_z_by_shields(self):
        law, deep = named("zarraga_33"), balance.profile(named("zarraga_33"), 0.2, 25.0)
        for shields, column in ((2.0, 25.0), (20.0, 7.0)):
            found = balance.profile(law, shields, column)
            below = (found.height / shields - deep.height / 0.2) + deep.z / 0.2    # counted from the surface
            kept = below > 0
            np.testing.assert_allclose(np.interp(below[kept], found.z / shields, found.phi), deep.phi[kept], atol=1e-4)

    def test_what_a_negative_law_does(self):
        found = balance.profile(named("chevremont_33_line"), 2.0, 25.0)
        self.assertAlmostEqual(found.phi[-1], 0.64 - 1 / 2.1, delta=1e-4)    # the profile ends there

    def test_height_against_acrivos_number(self):
        for name, expected in GROWTH.items():
            found = [balance.height(named(name), acrivos, 0.58) - 1 for acrivos in ACRIVOS]
            np.testing.assert_allclose(found, expected, atol=0.006, err_msg=name)
        # the height at rest does not matter
        for rest in (10.0, 45.0):
            found = balance.profile(named("boyer_33"), 2 * 0.7 * rest / 9, 0.55 * rest).height / rest
            self.assertAlmostEqual(found, balance.height(named("boyer_33"), 0.7, 0.55), delta=1e-9)

    def test_refusals(self):
        for shields, column in ((0, 1), (1, -1), (np.nan, 1), (np.inf, 1)):
            with self.assertRaisesRegex(ValueError, "must be > 0"):
                balance.profile(named("boyer_33"), shields, column)
        falling = Law("falling", lambda phi: phi * (0.3 - phi) / (0.6 - phi) ** 4, 0.6)
        with self.assertRaisesRegex(ValueError, "falling: eta must grow"):
            balance.profile(falling, 1.0, 50.0)


class Viscosity(unittest.TestCase):
    def test_linear_profile(self):
        z = 0.1 * np.arange(100) + 0.05
        found = balance.viscosity(z, 0.04 * (10 - z), 2.0)
        np.testing.assert_allclose(found, 0.04 * (10 - z) ** 2 / 4, atol=2e-4)

    def test_gives_the_law_back(self):
        for name in ("chevremont_33", "boyer_33", "zarraga_22"):
            law, shields = named(name), 2.0
            found = balance.profile(law, shields, 25.0)
            z = 0.1 * np.arange(int(10 * found.z[-1]) + 2) + 0.05
            phi = np.interp(z, found.z, found.phi, right=0.0)
            eta = balance.viscosity(z, phi, shields)
            kept = phi > 0.1
            np.testing.assert_allclose(eta[kept], law.eta(phi[kept]), rtol=0.02, atol=5e-3)

    def test_refusals(self):
        for z in ([0, 1, 3], [2, 1, 0], [1]):
            with self.assertRaisesRegex(ValueError, "equally spaced"):
                balance.viscosity(z, np.ones(len(z)), 1.0)


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="ascii")
        return str(self.folder / name)

    def command(self, *words, fails=False):
        out = io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
            try:
                balance.main(list(words))
            except SystemExit as end:
                self.assertTrue(fails, f"{end} {out.getvalue()}")
                return str(end) + out.getvalue()
        self.assertFalse(fails, out.getvalue())
        return out.getvalue()

    def table(self, name):
        with open(self.folder / name, newline="", encoding="ascii") as file:
            return list(csv.DictReader(file))

    def test_ave_chunk(self):
        for tail in ("", "300 3 40\n  1 0.5 20 0.5\n", "300 3", "300 3 40\n  1 0.5 20 0.5\n  2 1.5 15 0.3\n  3 2."):
            data = ave_chunk.read_ave_chunk(self.write("profile.txt", CHUNKS + tail))
            self.assertEqual(list(data), ["TimeStep", "Coord1", "Ncount", "v_phi"])
            np.testing.assert_array_equal(data["TimeStep"], [100, 200])
            np.testing.assert_array_equal(data["v_phi"], [[0.5, 0.3, 0.1], [0.52, 0.3, 0.14]])
        for text, why in (("# TimeStep v_a\n1 2\n", "no file of fix ave/chunk"), (CHUNKS[:120], "no complete output"),
                          (CHUNKS + "300 1 4\n 1 0.5 3 0.1\n", "number of chunks changes")):
            with self.assertRaisesRegex(ValueError, why):
                ave_chunk.read_ave_chunk(self.write("profile.txt", text))

    def test_viscosity_of_a_run(self):
        out = str(self.folder / "eta.csv")
        self.command("viscosity", self.write("profile.txt", CHUNKS), "--shields", "4", "--radius", "0.5",
                     "--laws", "boyer_33", "--table", out)
        rows = self.table("eta.csv")
        np.testing.assert_allclose([float(row["z"]) for row in rows], [1, 3, 5])
        # phi .51, .3, .12 in layers two radii thick
        np.testing.assert_allclose([float(row["eta"]) for row in rows], [(0.255 + 0.42) / 2, (0.15 + 0.12) / 2, 0.06 / 2])
        self.assertGreater((self.folder / "eta.png").stat().st_size, 5000)
        text = self.command("viscosity", self.write("p.csv", "z,phi\n0.5,0.4\n1.5,0.2\n"), "--shields", "1", "--table", out)
        self.assertRegex(text, r"(?m)^ +0.500 +0.4000 +0.4\n")
        text = self.command("viscosity", str(self.folder / "p.csv"), "--shields", "1", "--columns", "z", "c", fails=True)
        self.assertIn("no column c", text)

    def test_profiles_and_heights(self):
        table = self.write("eta.csv", "# of a run\nphi,eta_33\n" + "".join(
            f"{phi},{0.6 * (phi / (0.585 - phi)) ** 2}\n" for phi in (0.3, 0.4, 0.5)) + "0.2,\n")
        out = str(self.folder / "out.csv")
        text = self.command("profile", table + ":phi:eta_33", "boyer_33", "--shields", "0.2", "20", "--column", "25", "--table", out)
        self.assertIn("eta: extrapolated beyond its points, 0.3 to 0.5", text)
        heights = [float(line.split()[4]) for line in text.splitlines() if "  " in line and line.split()[0] in ("eta", "boyer_33")]
        np.testing.assert_allclose(heights[:2], heights[2:], rtol=1e-4)
        self.assertEqual({(row["law"], row["shields"]) for row in self.table("out.csv")},
                         {(law, sh) for law in ("eta", "boyer_33") for sh in ("0.2", "20")})
        text = self.command("height", "boyer_33", "--acrivos", "1", "2", "--table", out)
        self.assertRegex(text, r"boyer_33 +2 +1.33")
        for words, why in ((["profile", table, "--shields", "1", "--column", "9"], "no column eta.*:PHI:ETA"),
                           (["profile", table + ":phi:eta_33", "--shields", "1", "--column", "9", "--phi-m", ".6"], "its own phi_m"),
                           (["height", "boyer", "--acrivos", "1"], "no law boyer"),
                           (["height", "boyer_33", "--acrivos", "0"], "acrivos must be > 0")):
            self.assertRegex(self.command(*words, fails=True), why)

    def test_list_of_laws(self):
        lines = self.command("laws").splitlines()
        self.assertEqual([line.split()[0] for line in lines], list(normal_viscosity.LAWS))


if __name__ == "__main__":
    unittest.main()
