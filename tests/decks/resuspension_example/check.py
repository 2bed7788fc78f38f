# ranks: 1
"""The example examples/resuspension, shortened: weight, floor, drag and momentum balance, as a whole and height by height."""
import os
import re
import sys
from pathlib import Path

import numpy as np

import deck

sys.path.insert(0, str(deck.ROOT / "examples" / "resuspension"))
import resuspension

Path("runs").mkdir(exist_ok=True)
for old in (*Path("runs").iterdir(), *Path().glob("*.csv")):
    old.unlink()
SHIELDS, N = 2.0, 150
SHORT = {"N": N, "column": 6, "inertia": 0.2, "settle": 1, "rise": 2, "strain": 4, "packing": deck.ROOT / "examples" / "packing" / "packing.lmp"}


def shear(direction, drag_on_others):
    run = deck.run(os.path.relpath(deck.ROOT / "examples" / "resuspension" / "in.resuspension", deck.CASE), direction=direction,
                   shields=SHIELDS, out=f"runs/{direction}", **SHORT)
    deck.expect(f"{direction}: the time step is below the limit", "exceeds" not in run.text)
    layer = resuspension.Run(f"runs/{direction}")
    weight = 4 / 3 * np.pi * N * (1 + 3 * 0.05**2) / SHIELDS
    deck.expect_close(f"{direction}: weight of the spheres less buoyancy", layer.scene["weight"], weight, rtol=0.03)
    hold, drag, others = (layer.forces[name] for name in ("v_hold", "v_drag", "v_drag_others"))
    rise = np.diff(layer.ends["v_momentum"]) / np.diff(layer.ends["v_now"])
    deck.expect(f"{direction}: the inertia is seen", np.std(rise) > 3e-3 * weight, f"{np.std(rise) / weight:.4f}")
    deck.expect_close(f"{direction}: momentum of each output over the weight", (rise + hold - drag) / layer.scene["weight"], -1, atol=1e-3)
    deck.expect_close(f"{direction}: the floor carries the weight", (hold.mean() - drag.mean()) / layer.scene["weight"], -1, atol=0.02)
    deck.expect(f"{direction}: drag on grains that are not isolated", np.all(others == 0) != drag_on_others, f"{others.mean():.3f}")
    deck.expect(f"{direction}: some are isolated", 0.2 < layer.forces["v_isolated"].mean() < 10, f"{layer.forces['v_isolated'].mean():.2f}")

    p = layer.profile()
    stress = sum(p.stress[layer.up, origin] for origin in resuspension.ORIGINS)
    moment, carried = np.sum(np.gradient(-p.load * layer.area) * p.z), np.sum(stress) * layer.thick * layer.area
    deck.expect_close(f"{direction}: stress of all grains, from the forces on them", carried, moment, rtol=0.02)
    block = round(5 / layer.thick)
    first = np.flatnonzero(p.z > 3.5)[0]    # lower down a half of the stress is that of the floor
    for n in (first, first + block):
        load, here = p.load[n:n + block].mean(), stress[n:n + block].mean()
        deck.expect_close(f"{direction}: stress at {p.z[n] - 0.25:.1f} to {p.z[n + block] - 0.25:.1f}, weight above", here, load, rtol=0.1)
    pull = p.drag[p.z > 1.5].sum() * layer.area    # above the floor
    deck.expect_close(f"{direction}: drag by height and in all, over the weight", pull / weight, drag.mean() / weight, atol=0.01)
    film, contact = (np.sum(sum(p.stress[layer.up, f"{origin}_{way}"] for way in "nt")) for origin in ("film", "contact"))
    deck.expect(f"{direction}: contacts carry, films pull", contact > 0 > film > -0.3 * contact, f"{film / contact:.3f}")
    height = layer.heights()[0].mean() / layer.rest()
    deck.expect(f"{direction}: the layer rises", 1.35 < height < 1.9, f"{height:.3f}")
    return layer


shear("vorticity", False)
rate = resuspension.local_rate(shear("gradient", True).profile())
deck.expect("gradient: the layer slips against the fluid", 0.4 < np.nanmean(rate) < 1.0, f"{np.nanmean(rate):.3f}")

text = deck.draw_example("resuspension", "figure.png")
deck.expect("heights beside the models", len(re.findall(r"^vorticity +2 +0\.\d+ +\d\.\d+( +\d\.\d+){4}$", text, re.MULTILINE)) == 1)
rows = resuspension.read_profiles("profiles.csv")
deck.expect("profiles of both", sorted(rows) == ["gradient", "vorticity"] and all(len(columns["z"]) > 7 for columns in rows.values()))
deck.finish()
