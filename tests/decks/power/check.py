# ranks: 1 2
"""The balance of energy closes: what shear puts in is stored, kinetic, or turned into heat, by origin; the same on two ranks."""
import numpy as np

import deck

ORIGINS = ("contact/normal", "contact/tangential", "squeeze", "shear", "roll", "twist", "repulsion", "drag", "kinetic")


def balance(dt, **case):
    """Defect of the balance at its worst over what was put in, and heat by origin over it."""
    t = deck.run("in.power", **case).thermo()
    defect, share = deck.power_balance(t, dt, "c_p")
    print(f"{case}: defect {defect:.3g}, heat " + " ".join(f"{value:.3g}" for value in share))
    return defect, share[:9], np.array([t[f"c_p[{m}][1]"] for m in range(1, 10)]).T


ALL = {"contact": "friction clm shift 0.5 0.5 adhesion 0.005 repulsion 2 0.02"}
CASES = ({}, {"newton": "off"}, {"dim": 2}, {"density": 5}, {"keywords": "squeeze no", **ALL}, {"contact": "friction coulomb 0.5 restitution 0.3"},
         {"keywords": "shear no roll no twist no"}, {"more": "fix drag all drag/background 1 cell", "density": 5},
         {"flow": "deform/rheometer rate 1 pressure 20"})
WITHOUT_INERTIA = {"fraction": 0.25, "overdamped": "yes"}
if deck.RANKS > 1:    # sums over ranks, with all origins: those of one rank
    for case in (CASES[1], CASES[4], CASES[-1], WITHOUT_INERTIA):
        deck.make_state()
        one, several = (deck.run("in.power", steps=100, ranks=ranks, **case).thermo() for ranks in (1, deck.RANKS))
        for name in (name for name in one if name.startswith("c_p")):
            deck.expect_close(f"{case}: {name}", several[name], one[name], atol=1e-7 * np.max(np.abs(one[name])))
    deck.finish()
for case in CASES:
    dim = case.get("dim", 3)
    deck.make_state(dim=dim, phi=0.5 if dim == 3 else 0.75, density=case.get("density", 0.05))
    defect, share, heat = balance(5e-4, **case)
    print("    heat: " + ", ".join(f"{name} {part:.3g}" for name, part in zip(ORIGINS, share)))
    deck.expect("    no origin makes energy", np.all(np.sum(heat, axis=0) >= 0))
    fine, _, _ = balance(1.25e-4, fraction=0.25, steps=4000, **case)
    deck.expect("    the balance closes, to second order or nearly", fine < min(0.3 * defect, 1e-4), f"{defect:.1e} {fine:.1e}")

# without inertia, below the limit of the step that the drag sets
deck.make_state()
defect, share, heat = balance(1.25e-4, steps=2000, **WITHOUT_INERTIA)
deck.expect("    the balance closes", defect < 1e-4, f"{defect:.1e}")
deck.expect("    no origin makes energy, drag takes part", np.all(np.sum(heat, axis=0) >= 0) and share[7] > 0.01, f"{share[7]:.3g}")

# a drag that has something to do: all particles start off the flow
deck.make_state()
drag = {"more": "fix drag all drag/background 0.3 cell", "off": 1.0}
coarse, _, _ = balance(1e-4, fraction=0.2, steps=500, **drag)
fine, share, _ = balance(2.5e-5, fraction=0.05, steps=2000, **drag)
deck.expect("    the balance closes, to second order or nearly", fine < 0.3 * coarse and fine < 1e-4, f"{coarse:.1e} {fine:.1e}")

# forces that end abruptly take the energy of their springs with them
deck.make_state()
defect, share, _ = balance(5e-4, range="cut 0.5", **ALL)
print("    heat: " + ", ".join(f"{name} {part:.3g}" for name, part in zip(ORIGINS, share)))
deck.expect("    the balance but for pairs that leave the range", defect < 1e-3, f"{defect:.1e}")
deck.expect("    adhesive contacts break", share[0] > 1e-5)
deck.finish()
