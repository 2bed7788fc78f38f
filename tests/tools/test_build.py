"""What the options of our CMakeLists.txt build: the plugin without tests, the kernel's tests without LAMMPS."""
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LAMMPS = ["-D", "LAMMPS_SOURCE_DIR=" + os.environ["LAMMPS_SOURCES"]]


class Build(unittest.TestCase):
    def configure(self, *options):
        """build.ninja for these options."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        done = subprocess.run(["cmake", "-G", "Ninja", "-S", ROOT, "-B", folder.name, *options], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        return (Path(folder.name) / "build.ninja").read_text(encoding="utf-8")

    def test_plugin_without_tests(self):
        rules = self.configure(*LAMMPS, "-D", "SUSPENSION_TESTS=OFF", "-D", "CMAKE_DISABLE_FIND_PACKAGE_GTest=ON",
                               "-D", "CMAKE_DISABLE_FIND_PACKAGE_benchmark=ON")
        self.assertIn("suspensionplugin.so", rules)
        self.assertNotIn("tests/", rules)
        self.assertNotIn("kernel_benchmark", rules)
        objects = [line.split()[1].rsplit("/", 1)[1] for line in rules.splitlines()
                   if line.startswith("build src/CMakeFiles/suspension_styles.dir/SUSPENSION/")]
        longest = [n for n, name in enumerate(objects) if name.startswith(("lubcontact_loop_share", "lubcontact_loop_residual"))]
        self.assertEqual(longest, list(range(len(longest))), "the longest files are not the first: " + " ".join(objects))

    def test_plugin_without_adviser(self):
        off = ("-D", "SUSPENSION_TESTS=OFF", "-D", "SUSPENSION_ADVISER=OFF")
        self.assertIn("/SUSPENSION-ADVISER/suspension_scene.cpp", self.configure(*LAMMPS, *off[:2]))
        self.assertNotIn("/SUSPENSION-ADVISER/suspension_scene.cpp", self.configure(*LAMMPS, *off))

    def test_kernel_tests_without_lammps(self):
        rules = self.configure()
        self.assertIn("build kernel_tests:", rules)
        self.assertNotIn("suspensionplugin.so", rules)

    def test_warnings_are_errors_on_demand(self):
        self.assertNotIn("-Werror", self.configure(*LAMMPS))
        strict = self.configure(*LAMMPS, "-D", "SUSPENSION_WERROR=ON")
        ours = [line for line in strict.splitlines() if line.startswith("  FLAGS = ") and "-Wextra" in line]
        self.assertGreater(len(ours), 50)
        self.assertEqual([line for line in ours if "-Werror" not in line], [])


if __name__ == "__main__":
    unittest.main()
