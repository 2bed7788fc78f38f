"""Suspension balance: steady profiles of a sheared suspension that settles, its height, normal viscosities from a profile.

usage: tools/python.sh tools/balance.py laws
       tools/python.sh tools/balance.py profile LAW ... --shields SH ... --column M [--phi-m X] [--table NAME.csv]
       tools/python.sh tools/balance.py height LAW ... --acrivos A ... [--phi0 0.58] [--phi-m X] [--table NAME.csv]
       tools/python.sh tools/balance.py viscosity FILE --shields SH [--columns Z PHI] [--radius 1] [--laws LAW ...]
                                        [--table NAME.csv]
  LAW        name of a law of the literature, or a csv file with columns phi and eta, or FILE:PHI:ETA for other columns
  --shields  Shields number viscosity*rate/(density difference*gravity*radius)
  --column   solid volume over the area of the floor, in radii
  --acrivos  9/2 Shields number*radius/height at rest; --phi0: volume fraction at rest
  --phi-m    volume fraction at jamming, in place of that of the law
  viscosity  FILE is written by LAMMPS' fix ave/chunk, bins along z, or a csv file; --columns: its height and volume
             fraction, in units of --radius; default Coord1 v_phi, of a csv file z phi
Beside each table is a figure, NAME.png. Lengths are in radii. The manual page is Tools_balance.

The weight of the particles is carried by the normal stress of those below [Morris; Chevremont, eqs. 3 to 6]:
  phi/Sh = -d eta_ii/dz,  eta_ii(z) = (1/Sh) integral of phi from z to the surface,  eta_ii(0) = column/Sh.
So profiles against z/Sh are one curve, cut where eta_ii = column/Sh.

[Morris]     J.F. Morris, F. Boulay, J. Rheol. 43, 1213 (1999)
[Acrivos]    A. Acrivos, R. Mauri, X. Fan, Int. J. Multiphase Flow 19, 797 (1993)
[Chevremont] W. Chevremont, thesis, Grenoble (2020), chapter 4
"""
import argparse
import csv
import sys
from collections import namedtuple
from pathlib import Path

import numpy as np

import ave_chunk
import normal_viscosity
from normal_viscosity import Law

STEPS = 400             # of phi and of ln eta, each
DILUTE = 1e-4           # of phi at the floor, below which the rest of the height is that of a power law
NODES, WEIGHTS = np.polynomial.legendre.leggauss(5)

# from the floor up: z, phi, eta; height of the surface, of the center of all solid volume
Profile = namedtuple("Profile", "z phi eta height center")


def phi_at(law, eta):
    """Volume fraction with a normal viscosity, by bisection."""
    eta = np.asarray(eta, dtype=float)
    low, high = np.full_like(eta, law.phi_low), np.full_like(eta, law.phi_m)
    for _ in range(100):
        middle = 0.5 * (low + high)
        with np.errstate(divide="ignore", over="ignore", invalid="ignore"):
            below = law.eta(middle) < eta
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    return 0.5 * (low + high)


def integrals(law, phi):
    """Of d eta/phi and eta d eta/phi over each step of phi, by parts, so that no slope of eta is needed."""
    eta = law.eta(phi)
    half, middle = 0.5 * np.diff(phi), 0.5 * (phi[1:] + phi[:-1])
    p = middle[:, None] + half[:, None] * NODES
    e = law.eta(p)
    first = np.diff(eta / phi) + half * ((e / p**2) @ WEIGHTS)
    second = np.diff(0.5 * eta**2 / phi) + half * ((0.5 * (e / p) ** 2) @ WEIGHTS)
    return first, second


def levels(law, eta_floor):
    """Volume fractions from the dilute end to the floor, fine where phi or eta changes."""
    phi_floor = float(phi_at(law, eta_floor))
    lowest = max(law.phi_low, DILUTE * phi_floor)
    phi = np.linspace(lowest, phi_floor, STEPS)
    eta_low = max(float(law.eta(phi[1])), 1e-12 * eta_floor)
    phi = np.concatenate([phi, phi_at(law, np.geomspace(eta_low, eta_floor, STEPS)), np.array(law.nodes)])
    if law.phi_low == 0.0:
        phi = np.concatenate([phi, np.geomspace(lowest, phi_floor, STEPS)])
    phi = np.unique(np.clip(phi, lowest, phi_floor))
    return phi[phi > 0]


def check(**positive):
    for name, value in positive.items():
        if not 0 < value < np.inf:
            raise ValueError(f"{name} must be > 0, but is {value:g}")


def profile(law, shields, column):
    """Steady Profile; lengths in radii. The height is infinite where eta falls no faster than phi."""
    check(shields=shields, column=column)
    phi = levels(law, column / shields)
    eta = law.eta(phi)
    if not np.all(np.isfinite(eta)) or not np.all(np.diff(eta) >= 0):
        raise ValueError(f"{law.name}: eta must grow with phi from {phi[0]:.3g} to {phi[-1]:.3g}")
    first, second = integrals(law, phi)
    above = shields * np.concatenate([[0.0], np.cumsum(first)])    # height over the dilute end
    rest, moment = 0.0, 0.0
    if law.phi_low == 0.0 and eta[0] > 0:    # a power law below the dilute end
        exponent = np.log(eta[1] / eta[0]) / np.log(phi[1] / phi[0])
        rest = shields * eta[0] / phi[0] * exponent / (exponent - 1) if exponent > 1.01 else np.inf
        moment = 0.5 * eta[0] ** 2 / phi[0] * 2 * exponent / (2 * exponent - 1)
    z = above[-1] - above
    center = shields**2 * (np.sum(second) + moment) / column
    return Profile(z[::-1], phi[::-1], eta[::-1], above[-1] + rest, center)


def height(law, acrivos, phi0):
    """Height of the sheared layer over that at rest, at an Acrivos number [Acrivos]: nothing else matters."""
    check(acrivos=acrivos, phi0=phi0)
    return profile(law, 2 * acrivos / 9, phi0).height


def viscosity(z, phi, shields):
    """eta_ii at the centers z of equally thick layers with volume fractions phi, which reach the surface."""
    check(shields=shields)
    z, phi = np.asarray(z, dtype=float), np.asarray(phi, dtype=float)
    if len(z) < 2 or not np.allclose(np.diff(z), z[1] - z[0], rtol=1e-6) or not z[1] > z[0]:
        raise ValueError("heights must be equally spaced and grow")
    return (np.cumsum(phi[::-1])[::-1] - 0.5 * phi) * (z[1] - z[0]) / shields


# the command

def write(name, names, rows):
    with open(name, "w", newline="", encoding="ascii") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(names)
        writer.writerows([[word if isinstance(word, str) else f"{word:.6g}" for word in row] for row in rows])
    print(f"wrote {name}")


def figure(name, draw, **labels):
    import matplotlib    # pylint: disable=import-outside-toplevel
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt    # pylint: disable=import-outside-toplevel
    fig, ax = plt.subplots(figsize=(5.6, 4.4))
    draw(ax)
    ax.set(**labels)
    ax.legend(frameon=False, fontsize=8)
    fig.tight_layout()
    fig.savefig(name, dpi=130)
    plt.close(fig)
    print(f"wrote {name}")


def outside(law, phi):
    """Words on volume fractions beyond the points of a table."""
    if law.nodes and (phi.max() > law.nodes[-1] or phi.min() < law.nodes[0]):
        print(f"{law.name}: extrapolated beyond its points, {law.nodes[0]:.3g} to {law.nodes[-1]:.3g}, "
              f"up to the floor at {phi.max():.3f} and to the surface")


def command_laws(_):
    for name in normal_viscosity.LAWS:
        law = normal_viscosity.named(name)
        print(f"{name:27s} phi_m {law.phi_m:.3f}  {law.source}")


def command_profile(args):
    found = [(law, sh, profile(law, sh, args.column)) for law in args.laws for sh in args.shields]
    print(f"{'law':27s} {'Shields':>8s} {'Acrivos':>8s} {'phi floor':>9s} {'height':>8s} {'center':>8s}")
    for law, sh, p in found:
        outside(law, p.phi)
        acrivos = 4.5 * sh * args.phi0 / args.column
        print(f"{law.name:27s} {sh:8g} {acrivos:8.3g} {p.phi[0]:9.4f} {p.height:8.3f} {p.center:8.3f}")
    write(args.table, ["law", "shields", "z", "phi", "eta"],
          [[law.name, sh, *row] for law, sh, p in found for row in zip(p.z, p.phi, p.eta)])

    def draw(ax):
        for law, sh, p in found:
            ax.plot(p.phi, p.z, label=f"{law.name}, Sh {sh:g}")
    figure(args.table.with_suffix(".png"), draw, xlabel="volume fraction", ylabel="height / radius",
           ylim=(0, None), xlim=(0, None))


def command_height(args):
    rows = [[law.name, acrivos, height(law, acrivos, args.phi0) - 1] for law in args.laws for acrivos in args.acrivos]
    print(f"{'law':27s} {'Acrivos':>8s} {'(h - h0)/h0':>12s}")
    for name, acrivos, grown in rows:
        print(f"{name:27s} {acrivos:8g} {grown:12.4f}")
    write(args.table, ["law", "acrivos", "growth"], rows)
    fine = np.geomspace(min(args.acrivos), max(args.acrivos), 60)

    def draw(ax):
        for law in args.laws:
            ax.plot(fine, [height(law, acrivos, args.phi0) - 1 for acrivos in fine], label=law.name)
        ax.set(xscale="log", yscale="log")
    figure(args.table.with_suffix(".png"), draw, xlabel="Acrivos number $A$", ylabel="$(h - h_0)/h_0$")


def read_profile(args):
    """Heights in radii and volume fractions."""
    with open(args.file, encoding="utf-8") as text:
        first = text.readline()
    if "," in first and not first.startswith("#"):
        names = args.columns or ["z", "phi"]
        with open(args.file, newline="", encoding="utf-8") as text:
            rows = list(csv.DictReader(text))
        data = {name: np.array([float(row[name]) for row in rows]) for name in names if name in rows[0]}
    else:
        names = args.columns or ["Coord1", "v_phi"]
        data = {name: column.mean(axis=0) for name, column in ave_chunk.read_ave_chunk(args.file).items()}
    missing = [name for name in names if name not in data]
    if missing:
        raise ValueError(f"{args.file} has no column {' '.join(missing)}; give two with --columns")
    return data[names[0]] / args.radius, data[names[1]]


def command_viscosity(args):
    z, phi = read_profile(args)
    eta = viscosity(z, phi, args.shields[0])
    rows = [row for row in zip(z, phi, eta) if row[1] > 0]
    print(f"{'z':>8s} {'phi':>8s} {'eta':>10s}")
    for row in rows:
        print(f"{row[0]:8.3f} {row[1]:8.4f} {row[2]:10.4g}")
    write(args.table, ["z", "phi", "eta"], rows)
    _, phi, eta = np.array(rows).T

    def draw(ax):
        ax.plot(phi, eta, "o", ms=3, color="k", label=Path(args.file).name)
        for law in args.laws:
            fine = np.linspace(max(law.phi_low, phi.min()), min(0.999 * law.phi_m, 1.02 * phi.max()), 200)[1:]
            ax.plot(fine, law.eta(fine), lw=1, label=law.name)
        ax.set(yscale="log")
    figure(args.table.with_suffix(".png"), draw, xlabel="volume fraction", ylabel=r"normal viscosity $\eta_{ii}$")


def parse(words):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("laws")
    of = {name: commands.add_parser(name) for name in ("profile", "height", "viscosity")}
    for name in ("profile", "height"):
        of[name].add_argument("laws", nargs="+", metavar="LAW")
        of[name].add_argument("--phi0", type=float, default=0.58)
    of["viscosity"].add_argument("file")
    of["viscosity"].add_argument("--laws", nargs="+", default=[])
    of["viscosity"].add_argument("--columns", nargs=2)
    of["viscosity"].add_argument("--radius", type=float, default=1.0)
    of["viscosity"].add_argument("--shields", type=float, nargs=1, required=True)
    of["profile"].add_argument("--shields", type=float, nargs="+", required=True)
    of["profile"].add_argument("--column", type=float, required=True)
    of["height"].add_argument("--acrivos", type=float, nargs="+", required=True)
    for name, one in of.items():
        one.add_argument("--phi-m", type=float)
        one.add_argument("--table", type=Path, default=Path(f"balance_{name}.csv"))
    return parser.parse_args(words)


def main(words=None):
    args = parse(words)
    try:
        if args.command != "laws":
            args.laws = [normal_viscosity.find_law(word, args.phi_m) for word in args.laws]
            args.table = args.table.with_suffix(".csv")
        {"laws": command_laws, "profile": command_profile, "height": command_height,
         "viscosity": command_viscosity}[args.command](args)
    except (ValueError, OSError) as problem:
        sys.exit(f"balance.py: {problem}")


if __name__ == "__main__":
    main()
