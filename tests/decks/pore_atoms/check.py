# ranks: 1 4
"""Stress of the pores particle by particle: sums to row 7 of the cell, and is what an own program makes of the profile."""
import numpy as np

import deck


def spline(x):
    """Quadratic B-spline of the width 3."""
    x = np.abs(x)
    return np.where(x < 0.5, 0.75 - x ** 2, np.where(x < 1.5, 0.5 * (1.5 - x) ** 2, 0.0))


def above(y, radius):
    """Part of a sphere above the plane y = 0."""
    s = np.clip(y / radius, -1, 1)
    return (2 + 3 * s - s ** 3) / 4


def weights(d, bottom, gap, lx, lz, ny, phi_min=0.1):
    """W[e, i] of ny layers of elements, each as wide as the cell: sums over all images and mirror images."""
    volume = 4 / 3 * np.pi * d["radius"] ** 3 * above(d["y"] - bottom, d["radius"]) * above(bottom + gap - d["y"], d["radius"])
    xi, eta, zeta = d["x"] / lx % 1, (d["y"] - bottom) / gap * ny, d["z"] / lz % 1
    W = np.zeros((ny, len(volume)))
    for e in range(ny):
        of_y = spline(eta - e - 0.5) + spline(-eta - e - 0.5) + spline(2 * ny - eta - e - 0.5)
        w, offset = [], []
        for m in (-1, 0, 1):
            for n in (-1, 0, 1):
                w.append(volume * of_y * spline(xi + m - 0.5) * spline(zeta + n - 0.5))
                offset.append([xi + m - 0.5, eta - e - 0.5, zeta + n - 0.5])
        w, offset = np.array(w), np.moveaxis(np.array(offset), 1, 2)
        total = np.sum(w)
        assert total > phi_min * lx * lz * gap / ny
        mean = np.einsum("ai,aid->d", w, offset) / total
        second = np.einsum("ai,aid,aif->df", w, offset - mean, offset - mean) / total
        assert np.min(np.linalg.eigvalsh(second)) > 0.01
        W[e] = np.sum(w * (1 + (offset - mean) @ np.linalg.solve(second, -mean)), axis=0) / total
    return W


def last_profile():
    lines = [line.split() for line in deck.Path("layers.txt").read_text().splitlines() if not line.startswith("#")]
    return np.array(lines[-int(lines[-1][0]):], dtype=float)[:, 1:]


def read(what, **variables):
    t, d = deck.run("in.layers", **variables).thermo(), deck.read_dump("each.dump")
    for name in t:
        t[name] = t[name][-1]
    size = np.sum(np.abs(d["c_each[55]"]))
    deck.expect(f"{what}: there is a pressure", size > 1, f"{size:.3g}")
    for n in (1, 2, 3):
        deck.expect_close(f"{what}: sum over the particles is volume times row 7, {n}", np.sum(d[f"c_each[{54 + n}]"]),
                          t["Volume"] * t[f"c_cell[7][{n}]"], atol=1e-12 * size)
        deck.expect(f"{what}: the same in all directions, {n}", np.array_equal(d[f"c_each[{54 + n}]"], d["c_each[55]"]))
    deck.expect(f"{what}: only there", all(np.all(d[f"c_each[{n}]"] == 0) for n in range(58, 64)))
    inside = d["id"] <= 60
    deck.expect(f"{what}: the same in a group", np.array_equal(d["c_some[55]"][inside], d["c_each[55]"][inside]))
    deck.expect(f"{what}: and none outside it", np.all(d["c_some[55]"][~inside] == 0))
    return t, d


deck.run(deck.ROOT / "tests" / "decks" / "plates" / "state.lmp", ranks=1)
WALLS = {"closed below": "lower impermeable upper drained pressure 3", "closed above": "lower drained upper impermeable"}
for what, walls in WALLS.items():
    motion = "rate 1 pressure 5" if "upper drained" in walls else "stress 10 load 5"
    t, d = read(what, motion=motion, before=f"fix pore between pore/pressure 1 plates cell {walls} grid 1 4 1")
    profile = last_profile()
    ny = len(profile)
    height = profile[1, 0] - profile[0, 0]
    bottom, gap = profile[0, 0] - 0.5 * height, ny * height
    W = weights(d, bottom, gap, t["Lx"], t["Lz"], ny)
    deck.expect_close(f"{what}: all weights of an element", np.sum(W, axis=1), 1, rtol=1e-12)
    of_layer = t["Lx"] * t["Lz"] * height * profile[:, 1]
    size = np.max(np.abs(d["c_each[55]"]))
    deck.expect_close(f"{what}: of each particle", d["c_each[55]"], -of_layer @ W, atol=1e-9 * size)
    deck.expect_close(f"{what}: first moment", np.sum(d["c_each[55]"] * d["y"]), -np.sum(of_layer * profile[:, 0]),
                      atol=1e-9 * size * np.ptp(d["y"]))
deck.make_state()
for what, pore, flow in (("cell", "", "deform/rheometer rate 1 volume"), ("layer", "mean layer 4", "deform/rheometer rate 1 pressure 20")):
    read(what, where="cell", flow=flow, before=f"fix pore all pore/pressure pair grid 3 3 3 {pore}")
deck.run("in.layers", where="cell", before="fix pore all pore/pressure pair grid 3 3 3 coupling off mean layer 4")
d = deck.read_dump("each.dump")
deck.expect("coupling off: a pressure that is not felt is no stress", np.all(d["c_each[55]"] == 0))
deck.finish()
