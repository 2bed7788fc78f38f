"""The plugin loaded twice, unloaded and loaded again, and across clear: the same system gives the same bits each time.
Taken away from a system that uses it, the next run is refused.
"""
import os

import deck

PLUGIN = os.path.join(os.environ["LAMMPS_PLUGIN_PATH"].split(":")[0], "suspensionplugin.so")

deck.make_state()
v = deck.run("in.load", plugin=PLUGIN).values
for n in (2, 3, 4):
    deck.expect(f"round {n} is round 1", v[f"round{n}"] == v["round1"], v[f"round{n}"])
for what, message in (
        ("pair lubcontact", "pair_style lubcontact, which is not defined"),
        ("fix NEIGH_HISTORY/LUBCONTACT", "load the plugin and give pair_style and pair_coeff again"),
        ("fix deform/rheometer", "Could not find thermo fix ID flow"),
        ("compute stress/partition", "Could not find thermo compute with ID parts")):
    text = deck.run("in.unload", fails=True, what=f"plugin unload {what}").text
    deck.expect_error(f"unload {what}", text, message)
    deck.expect("  after the first run", "RESULT before" in text and "RESULT after" not in text)
deck.finish()
