"""A rigid rotation gives no force, and carries the force of a stuck contact with it."""
import numpy as np

import deck

axis = np.array([1, 2, -0.5]) / np.linalg.norm([1, 2, -0.5])
K = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
quarter = np.eye(3) + K + K @ K    # Rodrigues at 90 degrees


def vectors(dump, names):
    return np.array([dump[name] for name in names]).T


# Unloaded: at rest, then turned. fix move gives the velocity at the end of a step where time integration gives the one
# at its middle: that shifts the contact point by half the spin about the normal times the tilt of n in every step.
deck.run("in.rotation", load="no")
after = deck.read_dump("after.dump")
before = deck.read_dump("before.dump")
rise = vectors(after, ("fx", "fy", "fz")) - vectors(before, ("fx", "fy", "fz")) @ quarter.T
theta = np.pi / 2 / 100000
slip = 0.5 * 2 * theta * np.pi / 2
deck.expect_close("no force from a rigid rotation", rise, 0 * rise, atol=5e3 * slip)
slip_if_not_objective = 2 * np.pi / 2
deck.expect("which is little", slip < 1e-4 * slip_if_not_objective)

deck.run("in.rotation", load="yes")
before, after = deck.read_dump("before.dump"), deck.read_dump("after.dump")
for what, names in (("force", ("fx", "fy", "fz")), ("torque", ("tqx", "tqy", "tqz"))):
    a, b = vectors(before, names) @ quarter.T, vectors(after, names)
    scale = np.max(np.abs(a))
    deck.expect(f"{what} is there", scale > 1.0, f"{scale:.3g}")
    deck.expect_close(f"{what} turns with the pair", b, a, atol=5e3 * slip + 1e-4 * scale)
total = vectors(after, ("fx", "fy", "fz")).sum(axis=0)
deck.expect_close("forces balance", total, 0 * total, atol=1e-9)
moment = (np.cross(vectors(after, "xyz"), vectors(after, ("fx", "fy", "fz"))) + vectors(after, ("tqx", "tqy", "tqz"))).sum(axis=0)
deck.expect_close("moments balance", moment, 0 * moment, atol=1e-9)
deck.finish()
