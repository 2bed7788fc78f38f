"""The scripts of the manual and of README run as printed, shortened, and nothing warns of them."""
from pathlib import Path

import deck

SCENE = str(deck.ROOT / "examples" / "scene")


def indented(name, first, end, spaces):
    """Lines of a page from the one that begins with `first` to `end`, without their indentation."""
    page = (deck.ROOT / name).read_text(encoding="ascii")
    block = page[page.index(" " * spaces + first):]
    return "\n".join(line[spaces:] for line in block[:block.index(end)].splitlines()) + "\n"


def run(name, script, **variables):
    for folder in "examples/packing", "examples/scene":
        script = script.replace(folder, str(deck.ROOT / folder))
    Path(f"in.{name}").write_text(script, encoding="ascii")
    text = deck.run(Path.cwd() / f"in.{name}", **variables).text
    deck.expect(f"{name}: ran", len(deck.Run(text, 0).thermo()["Step"]) > 0)
    deck.expect(f"{name}: no warning of LAMMPS", "WARNING" not in text)
    return text


def shortened(script, steps):
    deck.expect("the page has a script that runs", "\nrun  " in script)
    return script.replace("\nrun  ", f"\nrun {steps} # ", 1)


# Howto_suspension; the adviser finds nothing wrong with it
script = indented("doc/src/Howto_suspension.rst", "variable        eta index", "The shear flow is along", 3)
text = run("howto", shortened(script, 200) + "suspension_scene\n", N=600)    # nine diameters
advice = text[text.index("Suspension scene:"):]
warnings = [line for line in advice.splitlines() if line.startswith("  warning:")]
deck.expect("no warning of the adviser", not warnings, "; ".join(warnings))

# Howto_rheometer, and its script that goes on
page = "doc/src/Howto_rheometer.rst"
first = run("rheometer", shortened(indented(page, "units           lj", ".. code-block:: bash", 3), 300) + "write_restart state.restart\n", N=400,
            scene=SCENE)
second = run("restarted", shortened(indented(page, "read_restart", "*Neighbor* is", 3), 300), scene=SCENE)
deck.expect_close("the strain goes on", deck.Run(second, 0).thermo()["f_shear[1]"][0], deck.Run(first, 0).thermo()["f_shear[1]"][-1], rtol=1e-4)
without = Path("in.restarted").read_text(encoding="ascii").replace("neighbor        0.3 bin", "neighbor        3.0 bin")
Path("in.slow").write_text(without, encoding="ascii")
deck.expect("a skin of another unit warns", "the lists are long and slow" in deck.run(Path.cwd() / "in.slow").text)

# README: what a deck needs more than a dry granular one
lines = indented("README.md", "comm_modify  vel yes", "With a LAMMPS of your own", 4)
Path("in.start").write_text("units lj\natom_style sphere\ncomm_modify vel yes\n"
                            f"include {deck.ROOT / 'examples/packing/packing.lmp'}\nwrite_data state.data\n", encoding="ascii")
deck.run(Path.cwd() / "in.start", N=400, phi=0.45, separation=0.01)
dry = "units lj\natom_style sphere\nread_data state.data\nfix move all nve/sphere\n"
text = run("readme", dry + lines + "thermo_style custom step c_s[1][4]\nrun 300\n")
deck.expect("README: it flows", "shear rate     0.1, " in text)
deck.finish()
