"""Who may include whom in src: arrows point down, physics knows no LAMMPS, style headers include their base class only."""
import re
import sys
import unittest
from fnmatch import fnmatchcase
from pathlib import Path

SRC = Path(__file__).resolve().parents[2] / "src"

# From the bottom up; a file belongs to the first pattern that fits, "objects" being lubcontact_* with a .cpp. It may include
# what is in its own layer or below, as long as no cycle comes of it.
LAYERS = (
    ("objects of the pair style", 3, "objects lubcontact_loop* radical_tessellation*"),
    ("physics", 0, "lubcontact_*.h pairstat_*.h material_*.h fluid_*.h restart_seal.h "
                   "each_processor.h pore_closure.h pore_layer.h pore_grid.h pore_deposit.h pore_spread.h pore_operator.h "
                   "pore_solve.h pore_cg.h pore_step.h pore_tetrahedron.h pore_network.h pore_network_flow.h "
                   "hydro_tensors.h hydro_wide.h hydro_lattice.h hydro_spread.h hydro_pairs.h hydro_layers.h hydro_waves.h hydro_solve.h hydro_hold.h "
                   "hydro_spline.h hydro_precondition.h "
                   "rheometer_flow.h rheometer_list.h rheometer_mean.h rheometer_plate.h rheometer_servo.h"),
    ("physics of the adviser", 1, "scene_numbers.h scene_verdict.h scene_bounds.h scene_settling.h scene_accuracy.h "
                                  "scene_history.h scene_laws.h scene_words.h"),
    ("host and input", 2, "suspension_host.* suspension_input.* uncounted_forces.* exclusive_particles.* spin_inertia.* "
                          "particle_inertia.* list_keeper.* fix_neigh_history_*"),
    ("pair style", 4, "pair_lubcontact*"),
    ("fixes", 5, "fix_* background_* deform_* plates_*"),
    ("computes and commands", 6, "compute_* suspension_history.*"),
    ("adviser", 7, "scene_* suspension_scene*"),
    ("plugin", 8, "suspensionplugin.cpp"),
)
PHYSICS = ("physics", "physics of the adviser")
FFTW = {("pore_solve.h", "fftw3.h"), ("hydro_solve.h", "fftw3.h")}

# Arrows that are still wrong: "file: header". The test fails when one of them is no longer needed.
KNOWN = {
    "layers": set(),
    "style headers": set(),
    "cycles": set(),
}

FILES = {path.name: path for path in sorted(SRC.rglob("*")) if path.suffix in (".h", ".cpp")}
TEXT = {name: path.read_text(encoding="ascii") for name, path in FILES.items()}
INCLUDES = {name: re.findall(r'^\s*#\s*include\s*"([^"]+)"', text, re.MULTILINE) for name, text in TEXT.items()}
NOTICE = ("SUSPENSION: dense non-Brownian suspensions in LAMMPS",
          "This software is distributed under the GNU General Public License, version 2.")


def layer(name):
    is_object = name.startswith("lubcontact_") and Path(name).stem + ".cpp" in FILES
    for title, height, patterns in LAYERS:
        if any(pattern == "objects" and is_object or fnmatchcase(name, pattern) for pattern in patterns.split()):
            return title, height
    raise AssertionError(f"{name} is in no layer: add it to the table in {Path(__file__).name}")


def module(name):
    """A header and what belongs to it: x.cpp, and x_more.cpp or x_more.h if they include x.h."""
    stem = Path(name).stem
    parts = stem.split("_")
    for n in range(len(parts), 0, -1):
        header = "_".join(parts[:n]) + ".h"
        if header != name and header in FILES and header in INCLUDES[name]:
            return module(header)
    return stem


def base_header(text):
    """Header of the base class of a style: FixDeform is in fix_deform.h."""
    base = re.search(r"^class \w+ : public (\w+)", text, re.MULTILINE).group(1)
    return re.sub(r"(?<!^)(?=[A-Z])", "_", base).lower() + ".h"


class Layers(unittest.TestCase):
    def judge(self, rule, found):
        known, found = KNOWN.get(rule, set()), set(found)
        self.assertEqual(sorted(found - known), [], rule + ": not allowed")
        self.assertEqual(sorted(known - found), [], rule + ": mended, take it out of KNOWN")

    def test_names_are_unique(self):
        """LAMMPS puts all packages into one include path."""
        names = [path.name for path in SRC.rglob("*.[hc]*")]
        self.assertEqual(len(names), len(set(names)))
        self.assertGreater(len(names), 80)

    def test_arrows_point_down(self):
        self.judge("layers", (f"{name}: {other}" for name, others in INCLUDES.items() for other in others
                              if other in FILES and layer(other)[1] > layer(name)[1]))

    def test_every_file_has_a_layer(self):
        for name in FILES:
            layer(name)

    def test_physics_knows_no_lammps(self):
        physics = [name for name in FILES if layer(name)[0] in PHYSICS]
        self.assertGreater(len(physics), 30)
        self.judge("physics", (f"{name}: {other}" for name in physics for other in INCLUDES[name]
                               if other not in physics))
        self.judge("physics", (f"{name}: <{other}>" for name in physics
                               for other in re.findall(r"#\s*include\s*<([^>]+)>", TEXT[name])
                               if "." in other and (name, other) not in FFTW))

    def test_suspension_works_without_its_adviser(self):
        self.judge("adviser", (f"{name}: {other}" for name, path in FILES.items() if path.parent.name == "SUSPENSION"
                               for other in INCLUDES[name]
                               if other in FILES and FILES[other].parent.name != "SUSPENSION"))

    def test_no_cycles(self):
        arrows = {}
        for name, others in INCLUDES.items():
            arrows.setdefault(module(name), set()).update(module(other) for other in others if other in FILES)
        reached = {}    # all that a module sees
        for start in arrows:
            seen, todo = set(), [start]
            while todo:
                for other in arrows.get(todo.pop(), ()):
                    if other not in seen:
                        seen.add(other)
                        todo.append(other)
            reached[start] = seen
        self.judge("cycles", (f"{a} {b}" for a in reached for b in reached[a] if a < b and a in reached.get(b, ())))

    def test_style_headers_include_their_base_class_only(self):
        styles = [name for name, text in TEXT.items() if re.search(r"^\w+Style\(", text, re.MULTILINE)]
        self.assertGreater(len(styles), 10)
        self.judge("style headers", (f"{name}: {other}" for name in styles for other in INCLUDES[name]
                                     if other != base_header(TEXT[name])))

    def test_the_pair_style_is_short_and_owns_no_public_data(self):
        header = TEXT["pair_lubcontact.h"]
        self.assertLess(header.count("\n"), 150)
        public = header[header.index(" public:"):header.index(" private:")]
        code = re.sub(r"//[^\n]*", "", public)
        data = [statement.strip() for statement in code.split(";") if statement.strip()
                and "(" not in statement and not re.match(r"(?:public:\s*)?using\b", statement.strip())]
        self.assertEqual(data, [])

    def test_files_have_the_licence_notice(self):
        for name, text in TEXT.items():
            head = "\n".join(text.splitlines()[:9])
            self.assertTrue(all(line in head for line in NOTICE), name)


if __name__ == "__main__":
    sys.exit(unittest.main())
