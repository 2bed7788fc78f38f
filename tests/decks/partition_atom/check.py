# ranks: 1 4
"""Stress by origin of each particle: sums to that of the cell, agrees with LAMMPS' stress/atom, known for one pair."""
from pathlib import Path

import numpy as np
from scipy.optimize import brentq

import deck

INERTIAL = slice(36, 45)    # of 6 origins with 9 components each
PAIR = np.r_[0:36, 45:54]    # the others
LAWS = "friction clm shift 0.5 5 adhesion 0.002 repulsion 20 0.02"
SIX = [0, 1, 2, 3, 4, 5]    # xx yy zz xy xz yz, in the order of LAMMPS


def blocks(name):
    """Blocks of a file of fix ave/time mode vector or fix ave/chunk, each a header and its rows."""
    lines = [line.split() for line in Path(name).read_text().splitlines() if not line.startswith("#")]
    found = []
    while lines:
        n = int(lines[0][1])
        found.append(np.array(lines[1:n + 1], dtype=float))
        lines = lines[n + 1:]
    return found


def columns(dump, name, n):
    return np.array([dump[f"c_{name}[{m}]"] for m in range(1, n + 1)]).T


for case in ({"dim": 3}, {"dim": 3, "newton": "off"}, {"dim": 2}, {"dim": 3, "way": "hybrid"}):
    dim = case["dim"]
    deck.make_state(dim=dim, phi=0.5 if dim == 3 else 0.75)
    volume = deck.run("in.sheared", coeffs=LAWS, **case).values["volume"]
    dump = deck.read_dump("each.dump")
    each, some = columns(dump, "each", 54), columns(dump, "some", 54)
    scale = np.sqrt(np.mean(np.sum(each[:, PAIR], axis=1) ** 2))
    print(f"{case}: stress times volume of a particle is of the order of {scale:.3g}")

    cells = [volume * block[:6, 1:].reshape(54) for block in blocks("cell.txt")]
    cell = cells[-1]
    size = np.repeat(np.max(np.abs(cell.reshape(6, 9)), axis=1), 9)    # of each origin
    deck.expect_close("sum over all particles = volume times the stress of the cell", np.sum(each, axis=0) / size,
                      cell / size, atol=1e-12)
    for n, name in enumerate(("contact normal", "contact tangential", "lubrication normal", "lubrication tangential",
                              "inertial", "repulsion")):
        deck.expect(f"{name} takes part", np.abs(cell[9 * n + 3]) > (1e-5 if n == 4 else 0.01) * size[0], f"{cell[9 * n + 3]:.3g}")

    layers = blocks("layers.txt")
    deck.expect("a profile at every output, the first included", len(layers) == len(cells) == 5)
    for profile, whole in zip(layers, cells):
        deck.expect("five layers with particles", profile.shape[0] == 5 and np.all(profile[:, 2] > 0))
        deck.expect_close("sum over the layers", np.sum(profile[:, 3:], axis=0) / size, whole / size, atol=1e-12)

    # LAMMPS tallies the same pairs and the same momentum by its own code, without the origins
    pairs = np.sum(each[:, PAIR].reshape(-1, 5, 9), axis=1)
    deck.expect_close("pairs = compute stress/atom", pairs[:, SIX] / scale, columns(dump, "pair", 6) / scale, atol=1e-11)
    ke = columns(dump, "ke", 6)
    deck.expect_close("inertial = compute stress/atom with temp/deform", each[:, INERTIAL][:, SIX], ke,
                      atol=1e-11 * np.max(np.abs(ke)))
    normal = each.reshape(-1, 6, 9)[:, [0, 2, 4, 5]]
    deck.expect_close("central forces and inertia: xy = yx, xz = zx, yz = zy", normal[:, :, [6, 7, 8]] / scale,
                      normal[:, :, [3, 4, 5]] / scale, atol=1e-12)

    inside = dump["id"] <= 120
    deck.expect("of a group: the same in it", np.array_equal(some[inside], each[inside]))
    deck.expect("of a group: zero outside it", np.all(some[~inside] == 0))

# Bulk g in series with asperities k and repulsion F0 exp(-u/lambda), the gap u of the surfaces being the root of
#   g (u - un) = k (eps a - u) + F0 exp(-u/lambda),  a = 2 R1 R2/(R1 + R2)
# on the line of centers n; stress times volume of either is -(1/2) r F n n for each of the two forces
g, k, un, eps, F0, length = 1000, 500, -0.001, 0.01 * 1.2, 3, 0.004
u = brentq(lambda x: g * (x - un) - k * (eps - x) - F0 * np.exp(-x / length), 0, 0.1, xtol=1e-16)
r, n = 2.5 + un, np.array([2, -1, 2]) / 3
mass = 0.5 * 4 / 3 * np.pi * np.array([1, 1.5, 1]) ** 3
velocity = np.array([[0.1, -0.2, 0.3], [-0.3, 0.1, 0.2], [0.2, 0.3, -0.1]])
velocity -= mass @ velocity / np.sum(mass)    # without the common drift


def nine(tensor):
    return np.array([tensor[a, b] for a, b in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2), (1, 0), (2, 0), (2, 1))])


expected = np.zeros((3, 54))
expected[:2, :9] = nine(-0.5 * r * k * (eps - u) * np.outer(n, n))
expected[:2, 45:] = nine(-0.5 * r * F0 * np.exp(-u / length) * np.outer(n, n))
expected[:, INERTIAL] = [nine(-m * np.outer(v, v)) for m, v in zip(mass, velocity)]
for newton in ("on", "off"):
    deck.run("in.two_layers", newton=newton)
    each = columns(deck.read_dump("pair.dump"), "each", 54)
    deck.expect_close(f"newton {newton}: pressed pair and single sphere", each, expected, atol=1e-11)
    profile = blocks("two_layers.txt")[0]
    deck.expect("two spheres below, one above", np.array_equal(profile[:, 2], [2, 1]))
    deck.expect_close("profile, lower half", profile[0, 3:], np.sum(expected[:2], axis=0), atol=1e-11)
    deck.expect_close("profile, upper half", profile[1, 3:], expected[2], atol=1e-11)

for variables, message in (
        ({"command": "compute each all stress/partition/atom now"}, "Unknown compute stress/partition/atom argument: now"),
        ({"style": "zero 2.0", "coeff": ""}, "Compute stress/partition/atom splits the forces of pair_style lubcontact, "
                                             "which is not defined"),
        ({}, "Stress by origin per atom was not tallied in step 7")):
    text = deck.run("in.refused", fails=True, **variables).text
    shown = next((line for line in text.splitlines() if line.startswith("ERROR")), "no error")
    deck.expect(f"refused: {variables}", message in shown, shown)
deck.finish()
