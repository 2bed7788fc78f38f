"""fix adapt and a v_name viscosity give the trajectory of a change by hand between two runs, bit for bit."""
import numpy as np

import deck

deck.make_state()
dumps = {}
for way in ("hand", "adapt", "variable"):
    deck.run("in.adapt", way=way, out=f"{way}.dump")
    dumps[way] = deck.read_dump(f"{way}.dump")
for way in ("adapt", "variable"):
    worst = max(np.max(np.abs(dumps[way][c] - dumps["hand"][c])) for c in ("x", "vx", "fx", "tqz"))
    deck.expect(f"{way} = by hand", worst == 0.0, f"largest difference {worst:.1e}")
deck.run("in.adapt", way="none", out="none.dump")
change = np.max(np.abs(deck.read_dump("none.dump")["fx"] - dumps["hand"]["fx"]))
deck.expect("the change matters", change > 1e-3, f"{change:.2g}")

# friction, critical load and repulsion
for law in ("clm ramp", "brizmer"):
    for way in ("laws", "laws_by_hand", "no_laws"):
        deck.run("in.adapt", way=way, out=f"{way}.dump", law=law, coeffs=f"friction {law} 0.5 5 repulsion 10 0.02")
        dumps[way] = deck.read_dump(f"{way}.dump")
    worst = max(np.max(np.abs(dumps["laws"][c] - dumps["laws_by_hand"][c])) for c in ("x", "vx", "fx", "tqz"))
    deck.expect(f"{law} = by hand", worst == 0.0, f"largest difference {worst:.1e}")
    change = np.max(np.abs(dumps["no_laws"]["fx"] - dumps["laws"]["fx"]))
    deck.expect("the change matters", change > 1e-3, f"{change:.2g}")
deck.finish()
