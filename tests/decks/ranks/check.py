# ranks: 4
"""1 = 4 ranks to rounding growth, in 3d and 2d, particles crossing ranks and boundaries included."""
import numpy as np

import deck

LAWS = "friction clm ramp 0.5 10 adhesion 0.002 repulsion 20 0.02"
for dim, phi, coeffs in ((3, 0.5, "friction coulomb 0.5"), (2, 0.75, "friction coulomb 0.5"), (3, 0.5, LAWS)):
    deck.make_state(dim=dim, phi=phi)
    one = deck.run("in.ranks", ranks=1, out="one.dump", dim=dim, coeffs=coeffs)
    many = deck.run("in.ranks", out="many.dump", dim=dim, coeffs=coeffs)
    a, b = deck.read_dump("one.dump"), deck.read_dump("many.dump")
    # positions differ by rounding (1e-16) times its growth along unstable directions in 0.15 of strain
    for column in ("yu", "vx", "vy", "omegaz", "fx", "tqz"):
        scale = np.sqrt(np.mean(a[column] ** 2))
        deck.expect_close(f"{dim}d {coeffs} {column}", b[column], a[column], atol=1e-8 * scale)
    for name, values in one.thermo().items():
        deck.expect_close(f"{dim}d {coeffs} thermo {name}", many.thermo()[name], values, rtol=1e-8, atol=1e-10)
    if dim == 2:
        deck.expect("no force out of the plane", np.all(b["fz"] == 0) and np.all(b["tqx"] == 0))
deck.finish()
