# ranks: 1 2
"""A common drift of all particles changes nothing that is measured or held: stress, kinetic energy, power, pressure control."""
import numpy as np

import deck

RHEOMETER = ("f_flow[2] f_flow[3] f_flow[4] f_flow[5] f_flow[8]", "deform/rheometer {} every 1 start 1")
CASES = [    # flow, what it holds, dimension
    ("rate 1 pressure 20", 3), ("rate 1 volume", 3), ("stress 30 pressure 20", 3), ("rate 1 pressure 20", 2),
    ("flow planar rate 0.5 pressure 20", 3)]


def run(drift, drive, dim):
    held, flow = RHEOMETER
    start = "1" if "planar" not in drive else "0"
    table = deck.run("in.drift", drift=drift, density=2, dim=dim, held=held, steps=200,
                     flow=flow.format(drive).replace("start 1", f"start {start}")).thermo()
    return table, np.loadtxt("held.txt")[:, 1:]


for drive, dim in CASES:
    deck.make_state(dim=dim, phi=0.5 if dim == 3 else 0.75, **({"shape": "orthogonal"} if "planar" in drive else {}))
    still, held = run("0 0 0", drive, dim)
    for drift in ("0 30 0", "-20 10 5") if dim == 3 else ("5 30 0",):
        moving, held_moving = run(drift, drive, dim)
        what = f"{drive}, {dim}d, drift {drift}"
        for name, values in still.items():
            if name == "Step":
                continue
            scale = np.max(np.abs(still["c_s[5][2]"])) if name.startswith("c_s[5]") else np.max(np.abs(values))
            scale = np.max(np.abs(still["c_sum[2]"])) if name.startswith("c_sum") else scale
            deck.expect_close(f"{what}: {name}", moving[name], values, atol=1e-7 * scale)
        scale = np.max(np.abs(held), axis=0) + 1e-3
        deck.expect_close(f"{what}: rheometer", held_moving / scale, held / scale, atol=1e-7)
    volume = still["Volume"]
    deck.expect_close(f"{drive}, {dim}d: particles add up", still["c_sum[4]"] / volume, still["c_s[5][4]"], rtol=1e-9, atol=1e-10)
deck.finish()
