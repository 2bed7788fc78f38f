"""The styles compiled into LAMMPS without a plugin; and a new effect with a coefficient of its own takes six places of the
sources, and works everywhere. Both in one build.

The effect of this test, `dummy`, adds a constant normal force to each pair in range. Six insertions make it known to
pair_coeff, mixing, fix adapt, restart files, data files, the table of a run and the vectors of the loop. A seventh would be
a place that CONTRIBUTING.md does not name.
"""
import os
import shutil
import subprocess
import sys
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
PLACES = [    # file, text before which is inserted, what
    ("lubcontact_effects.h", "  NUM_COMBINATIONS = 512\n",
     "  DUMMY = 512,        // constant force\n  NUM_COMBINATIONS = 1024\n"),
    ("lubcontact_effects.h", "  static constexpr bool squeeze = MASK & SQUEEZE;\n",
     "  static constexpr bool dummy = MASK & DUMMY;\n"),
    ("lubcontact_registry.h", "constexpr unsigned all_effects()\n",
     """    {DUMMY, "dummy", "dummy", NUM_CHANNELS, NUM_ORIGINS,
     [](const TypeCoeffs &c) { return c.dummy > 0.0; },
     [](const TypeCoeffs &c) { return c.dummy > 0.0; },
     [](TypeCoeffs &c) { c.dummy = 0.0; }}};\n\n"""),
    ("lubcontact_coeffs.h", "  FrictionLaw law = FrictionLaw::NONE;\n};\n", "  double dummy = 0.0;    // force\n"),
    ("lubcontact_coeffs.h", "inline constexpr std::size_t NUM_COLUMNS",
     """    {&TypeCoeffs::dummy, "dummy", "dummy", "F", true, Mixing::MEAN, 512}};\n"""),
    ("lubcontact_pair.h", "  if constexpr (E::friction) load.cone",
     "  if constexpr (E::dummy) load.normal += c.column[law_column(&TypeCoeffs::dummy)];\n")]

DECK = """
atom_style sphere
atom_modify map array
comm_modify vel yes
region box block 0 20 0 20 0 20
create_box 2 box
create_atoms 1 single 5 5 5
create_atoms 2 single 7.2 5 5
set group all diameter 2 density 1
pair_style lubcontact 1e-9 cut 0.5
pair_coeff 1 1 1e4 5e3 dummy 3
pair_coeff 2 2 1e4 5e3 dummy 5
neighbor 0.3 bin
fix move all nve/sphere
variable fx equal fx[1]
run 0 post no
print "mixed ${fx}"
variable now equal 7
fix adapt all adapt 1 pair lubcontact dummy * * v_now
run 0 post no
print "adapted ${fx}"
unfix adapt
write_data out.data pair ij
write_restart out.restart
run 1
print "stepped ${fx}"
clear
read_restart out.restart
variable fx equal fx[1]
pair_coeff 1 2 1e4 5e3 dummy 9
run 0 post no
print "after_restart ${fx}"
"""


def edit(folder):
    for name, before, text in PLACES:
        path = folder / name
        source = path.read_text()
        at = source.index(before)
        assert source.count(before) == 1, f"{name}: {before}"
        head = source[:at]
        if text.rstrip().endswith("};"):    # a new last row
            end = head.rindex("};")
            head = head[:end] + ",\n"
        if text.startswith("  DUMMY"):
            source = head + text + source[at + len(before):]
        else:
            source = head + text + source[at:]
        path.write_text(source)


def main():
    assert len(PLACES) <= 6
    work = TOP / "build" / "places"
    shutil.rmtree(work / "src", ignore_errors=True)
    for name in "src", "cmake", "potentials":
        shutil.copytree(TOP / name, work / name, dirs_exist_ok=True)
    edit(work / "src" / "SUSPENSION")
    built = subprocess.run([str(TOP / "tools" / "compiled_in.sh"), str(work)], stdout=subprocess.PIPE, text=True, check=False)
    print(built.stdout)
    if built.returncode:
        sys.exit("compiled_in.sh failed")
    lmp = built.stdout.split("executable: ")[1].strip()
    (work / "in.dummy").write_text(DECK)
    environment = dict(os.environ, LAMMPS_PLUGIN_PATH=str(work / "none"))
    ran = subprocess.run([os.environ["MPIRUN"], "1", lmp, "-in", "in.dummy", "-log", "none"], cwd=work, env=environment,
                         capture_output=True, text=True, check=False)
    text = ran.stdout + ran.stderr
    values = dict(line.split() for line in text.splitlines() if line.split()[:1] and len(line.split()) == 2)
    expected = {"mixed": -4.0, "adapted": -7.0, "stepped": -7.0, "after_restart": -9.0}    # repels atom 1 along -x
    failed = ran.returncode
    for name, force in expected.items():
        got = float(values.get(name, "nan"))
        good = abs(got - force) < 1e-9    # and a film of next to no viscosity
        failed = failed or not good
        print(f"{name}: expected {force} got {got} {'ok' if good else 'WRONG'}")
    for what, there in (("table of the run", "  dummy          yes" in text), ("history of a pair, of the films", "10 history values per pair" in text),
                        ("data file", " dummy 7" in (work / "out.data").read_text())):
        failed = failed or not there
        print(f"{what}: {'ok' if there else 'MISSING'}")
    if failed:
        print(text[-3000:])
    sys.exit(1 if failed else 0)


main()
