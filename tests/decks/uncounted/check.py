"""Stress and power by origin, and the stress that the rheometer holds, say what they leave out, and stop at constraint forces."""
import os
from pathlib import Path

import deck

deck.make_state()
STRESS, ATOM, POWER = (f"compute {name[0]}{len(name)} all {name}" for name in ("stress/partition", "stress/partition/atom", "power/partition"))
ALL = f'if "1 == 1" then "{STRESS}" "{ATOM}" "{POWER}"'
SHEAR = "fix flow all deform/rheometer rate 1 volume start 1"
VIRIAL = 'if "1 == 1" then "fix push all addforce 0 0 0" "fix_modify push virial yes" '
ROWS, HELD = "not in its rows, but in the pressure of LAMMPS: ", "include only the pair style and inertia, not "


def log(fails=False, **variables):
    return deck.run("in.uncounted", fails=fails, **variables).text


for compute in (STRESS, ATOM, POWER):
    deck.expect(f"{compute}: other pair style", log(pair="overlay", computes=compute).count(ROWS + "pair style lj/cut") == 1)
text = log(pair="overlay", computes=ALL, lines=VIRIAL)
deck.expect("pair style and fix, one warning", text.count(ROWS + "pair style lj/cut, fix push addforce") == 1 and text.count(ROWS) == 1)
text = log(computes=ALL, lines=VIRIAL + f'"{SHEAR}"')
deck.expect("fix with a virial", text.count(ROWS + "fix push addforce") == 1)
deck.expect("  in what the rheometer holds, too", text.count(HELD + "fix push addforce") == 1)
deck.expect("other pair styles count in the rheometer", HELD not in log(pair="overlay", computes=SHEAR))
for quiet in ({"pair": "zero"}, {"lines": "fix push all addforce 0 0 0"}, {}):
    deck.expect(f"nothing is left out: {quiet}", "LAMMPS: " not in log(computes=ALL, **quiet))
deck.expect_error("scaled forces", log(fails=True, pair="scaled"), "Pair style lubcontact cannot be scaled")

claims = Path(os.environ["LAMMPS_PLUGIN_PATH"]) / "tests" / "plugin" / "claims" / "claimsplugin.so"
rigid = f'if "1 == 1" then "plugin load {claims}" "fix body all rigid/claim" '
for command, message in ((STRESS, "Compute stress/partition cannot count the constraint forces in the rigid bodies of fix body"),
                         (ATOM, "Compute stress/partition/atom cannot count the constraint forces in the rigid bodies of fix body"),
                         (POWER, "Compute power/partition cannot count the constraint forces in the rigid bodies of fix body"),
                         (SHEAR, "Fix deform/rheometer cannot move the rigid bodies of fix body"),
                         ("fix d all drag/background 1", "Fix drag/background cannot drag the rigid bodies of fix body")):
    deck.expect_error(command, log(fails=True, computes="print none", lines=rigid + f'"{command}"'), message)
log(computes="compute m all microstructure", lines=rigid)    # it sums up no stress
deck.finish()
