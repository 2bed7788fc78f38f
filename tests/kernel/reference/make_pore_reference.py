#!/usr/bin/python3
"""Writes pore_reference.h: pore pressure and forces of a few spheres on small grids.

Independent of the headers: Cartesian coordinates and every periodic image in turn, a general mesh of hexahedra whose corners
are points (isoparametric, 3 x 3 x 3 points of Gauss), full matrices of weights, of the divergence and of Darcy's law, direct
solution. Only what the discretization defines is the same: the spline and its reflection at plates, the weights that reproduce
one and the position, gradients at the centers, and the closure.
"""
import itertools
import math
import os

import numpy as np
import scipy
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import spsolve

PHI_MIN, PHI_MAX, ETA, DT = 0.1, 0.95, 0.7, 0.9

# name, lower, upper ("p": periodic, "i": impermeable, "d": drained), elements, cell (xprd yprd zprd xy xz yz), particles, kozeny
CASES = [
    ("periodic, upright", "p", "p", (3, 4, 3), (3.9, 5.1, 4.2, 0.0, 0.0, 0.0), 60, False),
    ("periodic, tilted", "p", "p", (4, 3, 3), (5.1, 4.0, 3.9, 1.4, -0.8, 0.6), 60, True),
    ("lower drained, upper impermeable", "d", "i", (3, 4, 4), (4.2, 5.3, 5.0, 0.0, 0.0, 0.0), 70, False),
    ("lower impermeable, upper drained", "i", "d", (3, 3, 3), (4.2, 4.3, 4.0, 0.0, 0.9, 0.0), 55, False),
    ("both drained, clear above", "d", "d", (3, 5, 3), (4.2, 7.0, 4.0, 0.0, 0.0, 0.0), 40, True),
    ("both impermeable", "i", "i", (4, 3, 3), (5.2, 4.1, 4.0, 0.0, -1.1, 0.0), 60, False),
]


def bspline(t):
    t = abs(t)
    return 0.75 - t * t if t <= 0.5 else 0.5 * (1.5 - t) ** 2 if t < 1.5 else 0.0


def cap(y, a):
    """Part of a sphere above a plane, by its volume."""
    h = min(max(a + y, 0.0), 2 * a)
    return math.pi * h * h * (3 * a - h) / 3 / (4 / 3 * math.pi * a ** 3)


def closure(kozeny, phi, a):
    phi = min(max(phi, PHI_MIN), PHI_MAX)
    K = 10 * phi / (1 - phi) ** 3
    if not kozeny:
        K += (1 - phi) * (1 + 1.5 * math.sqrt(phi))
    return 2 * a * a / (9 * phi * K)


def shape(r):
    """Trilinear functions and their gradients on the unit cube, corners in the order of the headers."""
    corners = [(c & 1, c >> 1 & 1, c >> 2) for c in range(8)]
    one = [[r[a] if bits[a] else 1 - r[a] for a in range(3)] for bits in corners]
    slope = [[1.0 if bits[a] else -1.0 for a in range(3)] for bits in corners]
    N = np.array([o[0] * o[1] * o[2] for o in one])
    dN = np.array([[s[0] * o[1] * o[2], o[0] * s[1] * o[2], o[0] * o[1] * s[2]] for o, s in zip(one, slope)])
    return N, dN


def solve(case, seed):
    name, lower, upper, (nx, ny, nz), (xprd, yprd, zprd, xy, xz, yz), count, kozeny = case
    rng = np.random.default_rng(seed)
    plates = lower != "p"
    edges = np.array([[xprd, 0, 0], [xy, yprd, 0], [xz, yz, zprd]])
    origin = np.array([0.4, -1.1, 0.25])
    n = np.array([nx, ny, nz])

    # particles, rounded so that the table has them exactly; the upper part of "clear above" is empty
    top = 0.45 if "clear" in name else 1.0
    s = rng.random((count, 3)) * [1, top, 1]
    x = np.round(origin + s @ edges, 3)
    a = np.round(0.4 + 0.2 * rng.random(count), 3)
    v = np.round(rng.normal(size=(count, 3)), 3)
    force = np.round(rng.normal(size=(count, 3)), 3)
    mass = np.round(0.4 + rng.random(count), 3)
    volume = 4 / 3 * math.pi * a ** 3
    inside = np.ones(count)
    if plates:
        inside = np.array([cap(xi[1] - origin[1], ai) * cap(origin[1] + yprd - xi[1], ai) for xi, ai in zip(x, a)])

    # elements: all images of a particle, mirror images in y between plates
    elements = list(itertools.product(range(ny), range(nz), range(nx)))    # x fastest
    centers = np.array([origin + (np.array([i, j, k]) + 0.5) / n @ edges for j, k, i in elements])
    V = xprd * yprd * zprd / len(elements)
    images = []    # per element: particle, spline, position of the image
    shifts = [np.array(t) for t in itertools.product(*([range(-2, 3)] * 3)) if not plates or t[1] == 0]
    inverse = np.linalg.inv(edges)
    for center in centers:
        found = []
        for i in range(count):
            for shift in shifts:
                place = x[i] + shift @ edges
                mirrors = [place]
                if plates:
                    for plane in (origin[1], origin[1] + yprd):
                        mirror = place.copy()
                        mirror[1] = 2 * plane - place[1]
                        mirrors.append(mirror)
                w = 0.0
                for mirror in mirrors:
                    t = ((mirror - center) @ inverse) * n
                    w += bspline(t[0]) * bspline(t[1]) * bspline(t[2])
                if w > 0:
                    found.append((i, w, place))
        images.append(found)

    phi = np.zeros(len(elements))
    radius = np.zeros(len(elements))
    total = sum((volume * inside)), sum(a * a * inside)
    W = np.zeros((len(elements), count))
    reach = np.zeros((len(elements), count))
    residual = 0.0
    for e, found in enumerate(images):
        filled = sum(volume[i] * inside[i] * w for i, w, _ in found)
        squares = sum(a[i] ** 2 * inside[i] * w for i, w, _ in found)
        phi[e] = filled / V
        fill = max(PHI_MIN * V - filled, 0.0)
        radius[e] = 0.75 / math.pi * (filled + fill) / (squares + fill * total[1] / total[0])
        if filled <= PHI_MIN * V:
            for i, w, _ in found:
                W[e, i] += volume[i] * inside[i] * w / (PHI_MIN * V)
                reach[e, i] += abs(volume[i] * inside[i] * w / (PHI_MIN * V))
            continue
        weight = np.array([volume[i] * inside[i] * w / filled for i, w, _ in found])
        place = np.array([at for _, _, at in found])
        mean = weight @ place
        M = (place - mean).T @ (weight[:, None] * (place - mean))
        # in spacings, where the headers cut eigenvalues: none here is near the cut
        to_lattice = np.diag(n) @ inverse.T
        assert np.linalg.eigvalsh(to_lattice @ M @ to_lattice.T)[0] > 0.02
        g = np.linalg.solve(M, centers[e] - mean)
        full = weight * (1 + (place - mean) @ g)
        residual = max(residual, abs(full.sum() - 1), np.abs(full @ place - centers[e]).max())
        for (i, _, _), one in zip(found, full):
            W[e, i] += one
            reach[e, i] += abs(one)
    assert residual < 1e-12

    # mesh of points
    layers = ny + 1 if plates else ny
    nodes = layers * nz * nx

    def node(i, j, k):
        return ((j % layers) * nz + k % nz) * nx + i % nx

    gauss, gauss_weight = np.polynomial.legendre.leggauss(3)
    gauss, gauss_weight = 0.5 + 0.5 * gauss, 0.5 * gauss_weight
    mobility = np.array([closure(kozeny, f, r) for f, r in zip(phi, radius)]) / ETA
    rows, cols, values, unit = [], [], [], []
    D = np.zeros((nodes, 3 * count))
    G = np.zeros((3 * len(elements), nodes))    # gradients at the centers
    for e, (j, k, i) in enumerate(elements):
        bits = [(c & 1, c >> 1 & 1, c >> 2) for c in range(8)]
        corner = [node(i + b[0], j + b[1], k + b[2]) for b in bits]
        points = np.array([origin + (np.array([i, j, k]) + b) / n @ edges for b in bits])
        local = np.zeros((8, 8))
        for p, q, r in itertools.product(range(3), repeat=3):
            _, dN = shape((gauss[p], gauss[q], gauss[r]))
            J = points.T @ dN
            gradient = dN @ np.linalg.inv(J)
            local += gauss_weight[p] * gauss_weight[q] * gauss_weight[r] * abs(np.linalg.det(J)) * gradient @ gradient.T
        for c in range(8):
            for d in range(8):
                rows.append(corner[c])
                cols.append(corner[d])
                values.append(mobility[e] * local[c, d])
                unit.append(local[c, d])
        _, dN = shape((0.5, 0.5, 0.5))
        gradient = dN @ np.linalg.inv(points.T @ dN)
        for c in range(8):
            for axis in range(3):
                G[3 * e + axis, corner[c]] += gradient[c, axis]
    K = coo_matrix((values, (rows, cols)), shape=(nodes, nodes)).tocsr()
    K1 = coo_matrix((unit, (rows, cols)), shape=(nodes, nodes)).tocsr()
    for axis in range(3):
        D[:, axis::3] = -V * G[axis::3].T @ W
    wall = np.zeros(nodes)
    v_lower, v_upper = (0.2, -0.3) if plates and "d" in lower + upper else (0.0, 0.0)
    if plates:
        share = xprd * zprd / (nx * nz)
        wall[:nx * nz] -= v_lower * share
        wall[-nx * nz:] += v_upper * share

    # a pressure, then the step from it; mean gradient along x and z
    slope = np.array([0.3, 0.0, -0.2])
    p = np.round(rng.normal(size=nodes), 3)
    fixed = np.zeros(nodes, dtype=bool)
    if lower == "d":
        fixed[:nx * nz] = True
        p[:nx * nz] = 0.5
    if upper == "d":
        fixed[-nx * nz:] = True
        p[-nx * nz:] = -0.25
    drive = V * (G.reshape(len(elements), 3, nodes) * (mobility[:, None, None] * slope[None, :, None])).sum(axis=(0, 1))

    def forces(q):
        g = (G @ q).reshape(-1, 3) + slope
        return -V * W.T @ g

    bound = (reach * (V * reach.sum(axis=0) / mass)[None, :]).sum(axis=1)
    c = (mobility + DT * bound).max()
    ahead = v + DT / mass[:, None] * (force + forces(p))
    r = -(D @ ahead.ravel() + wall) - K @ p - drive
    free = ~fixed
    change = np.zeros(nodes)
    if fixed.any():
        change[free] = spsolve(c * K1[free][:, free].tocsc(), r[free])
    else:
        ends = np.ones(nodes)
        if plates:
            ends[:nx * nz] = ends[-nx * nz:] = 0.5
        full = c * K1.toarray() + np.outer(ends, ends)
        change = np.linalg.solve(full, r - ends * r.sum() / ends.sum())
    p_next = p + change
    f_next = forces(p_next)

    # and Darcy's law for the velocities given
    still = np.zeros(nodes)
    still[fixed] = p[fixed]
    rhs = -(D @ v.ravel() + wall) - K @ still - drive
    darcy = still.copy()
    if fixed.any():
        darcy[free] = spsolve(K[free][:, free].tocsc(), rhs[free])
    else:
        darcy = np.linalg.solve(K.toarray() + np.outer(ends, ends), rhs - ends * rhs.sum() / ends.sum())
    return {
        "x": x, "a": a, "v": v, "force": force, "mass": mass, "p": p, "phi": phi, "mobility": mobility, "bound": bound,
        "p_next": p_next, "f_next": f_next, "darcy": darcy, "origin": origin, "slope": slope, "walls": (v_lower, v_upper),
    }


def numbers(values, digits="%.17g"):
    flat = [digits % value for value in np.asarray(values, dtype=float).ravel()]
    lines = [", ".join(flat[m:m + 6]) for m in range(0, len(flat), 6)]
    return "{" + ",\n      ".join(lines) + "}"


def main():
    wall = {"p": "Wall::PERIODIC", "i": "Wall::IMPERMEABLE", "d": "Wall::DRAINED"}
    body = []
    for number, case in enumerate(CASES):
        name, lower, upper, n, cell, count, kozeny = case
        found = solve(case, 100 + number)
        table = np.hstack([found["x"], found["a"][:, None], found["mass"][:, None], found["v"], found["force"]])
        body.append(f'    {{"{name}", {wall[lower]}, {wall[upper]}, {n[0]}, {n[1]}, {n[2]},')
        cell_text = ", ".join(repr(float(value)) for value in cell)
        origin = ", ".join(repr(float(value)) for value in found["origin"])
        body.append(f"     {{{{{origin}}}, {cell_text}}}, {'true' if kozeny else 'false'}, "
                    f"{{{found['walls'][0]!r}, {found['walls'][1]!r}}},")
        body.append("     " + numbers(table, "%.3f") + ",")
        for key, digits in (("p", "%.3f"), ("phi", "%.13g"), ("mobility", "%.13g"), ("bound", "%.13g"), ("p_next", "%.13g"),
                            ("f_next", "%.13g"), ("darcy", "%.13g")):
            body.append("     " + numbers(found[key], digits) + ("," if key != "darcy" else "},"))
    lines = [
        "// Written by make_pore_reference.py, not by hand.",
        "",
        "#ifndef PORE_REFERENCE_H",
        "#define PORE_REFERENCE_H",
        "",
        "// clang-format off",
        "// Spheres on a grid, and what a step makes of them: full matrices of a general mesh of hexahedra, Cartesian",
        f"// coordinates, all images in turn; NumPy {np.__version__}, SciPy {scipy.__version__}.",
        "struct PoreCase {",
        "  const char *name;",
        "  Wall lower, upper;",
        "  int nx, ny, nz;",
        "  Cell cell;",
        "  bool kozeny;",
        "  WallVelocity walls;",
        "  std::vector<double> particles;    // x, y, z, radius, mass, velocity, force",
        "  Field p;                          // before",
        "  std::vector<double> phi, mobility, bound;",
        "  Field p_next;                     // after a step with c K1",
        "  std::vector<double> forces;       // then",
        "  Field darcy;                      // K p = -D v of the velocities given",
        "};",
        "",
        f"static constexpr double PORE_VISCOSITY = {ETA!r}, PORE_DT = {DT!r};",
        "static const Vec3 PORE_SLOPE{0.3, 0.0, -0.2};    // mean gradient",
        "",
        "static const std::vector<PoreCase> PORE_CASES = {",
        *body,
        "};",
        "// clang-format on",
        "",
        "#endif",
        "",
    ]
    here = os.path.dirname(os.path.abspath(__file__))
    with open(os.path.join(here, "pore_reference.h"), "w", encoding="utf-8") as out:
        out.write("\n".join(lines))


if __name__ == "__main__":
    main()
