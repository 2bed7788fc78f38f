"""The complete script of the manual's Howto_suspension runs as printed, shortened, and the adviser finds nothing wrong with it."""
from pathlib import Path

import deck

page = (deck.ROOT / "doc" / "src" / "Howto_suspension.rst").read_text(encoding="ascii")
block = page[page.index("   variable        eta index"):page.index("The shear flow is along")]
script = "\n".join(line[3:] for line in block.splitlines())
deck.expect("the page has a script that runs", "\nrun  " in script)
script = script.replace("examples/packing", str(deck.ROOT / "examples" / "packing"))
script = script.replace("\nrun  ", "\nrun 200 # ", 1) + "\nsuspension_scene\n"
Path("in.howto").write_text(script, encoding="ascii")
text = deck.run(Path.cwd() / "in.howto", N=600).text    # nine diameters
deck.expect("ran", len(deck.Run(text, 0).thermo()["Step"]) > 0)
advice = text[text.index("Suspension scene:"):]
warnings = [line for line in advice.splitlines() if line.startswith("  warning:")]
deck.expect("no warning of the adviser", not warnings, "; ".join(warnings))
deck.expect("no warning of LAMMPS", "WARNING" not in text)
deck.finish()
