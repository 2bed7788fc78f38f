# ranks: 1 4
"""A restarted run continues the straight run bit for bit, in the middle of whatever the rheometer does."""
import numpy as np

import deck

GRID = {1: "1 1 1", 2: "1 2 1", 4: "2 2 1"}[deck.RANKS]
CASES = {
    "rate and pressure": {"drive": "rate 1", "hold": "pressure 20"},
    "viscous number and pressure, variables": {"drive": "iv v_swing", "hold": "pressure v_swing"},
    "stress and volume": {"drive": "stress 30", "hold": "volume"},
    "stress and pressure": {"drive": "stress 30", "hold": "pressure 20"},
    "between two adjustments": {"drive": "stress 30", "hold": "pressure 20 every 7"},
    "oscillation": {"drive": "oscillate 0.5 2 30", "hold": "pressure 20 every 7"},
    "flip in the step of the restart": {"tilt": 0.4 + 0.5 * 5e-4},
    "flip just before": {"tilt": 0.4 + 1.5 * 5e-4},
    "planar": {"flow": "planar", "drive": "rate 0.2", "hold": "pressure 20"},
    "uniaxial": {"flow": "uniaxial", "drive": "rate -0.2", "hold": "volume"},
}


def same(what, straight, restarted):
    a, b = deck.read_dump("straight.dump"), deck.read_dump("restarted.dump")
    for column in a:
        deck.expect(f"{what}: {column}", np.array_equal(a[column], b[column]),
                    f"largest difference {np.max(np.abs(a[column] - b[column])):.1e}")
    # stress and state of the step of the restart are measured again, with the velocities at the end of the step
    for name, values in restarted.thermo().items():
        deck.expect(f"{what}: thermo {name}", np.array_equal(values[1:], straight.thermo()[name][-len(values) + 1:]))


deck.make_state()
for what in ("stress and pressure", "oscillation"):
    straight = deck.run("in.straight", grid=GRID, **CASES[what])
    same(f"two runs, {what}", straight,
         deck.run("in.straight", grid=GRID, pause="yes", out="restarted.dump", **CASES[what]))
for what, variables in CASES.items():
    straight = deck.run("in.straight", grid=GRID, **variables)
    same(what, straight, deck.run("in.restarted", grid=GRID, **variables))
    t = straight.thermo()
    if "flip" in what:
        step = t["Step"][:-1][np.diff(t["Xy"]) < 0][0]
        deck.expect(f"{what}: it does", step == 190, step)
# other targets after the restart begin at once, as after fix_modify
for then in ("oscillate 0.5 2 30", "rate -1", "stress 30", "pressure 20"):
    straight = deck.run("in.straight", grid=GRID, hold="volume every 7", pause="yes", turn="yes", then=then)
    other = {"hold": "pressure 20 every 7"} if "pressure" in then else {"drive": then, "hold": "volume every 7"}
    same(f"then {then}", straight, deck.run("in.restarted", grid=GRID, **other))
tables = [deck.run("in.unreachable", **{"from": start}).thermo() for start in ("start", "restart")]
deck.expect("judged in the same step", tables[1]["f_rheometer[10]"][1] == 1 and tables[1]["f_rheometer[10]"][-1] == 3
            and np.array_equal(tables[0]["f_rheometer[10]"][-300:], tables[1]["f_rheometer[10]"][-300:]))

text = deck.run("in.restarted", grid=GRID, flow="planar", fails=True).text
deck.expect("another flow than in the file is refused", "restart file that was written with a different flow" in text)
deck.finish()
