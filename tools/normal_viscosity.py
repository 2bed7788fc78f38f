"""Normal viscosities eta_ii of a sheared suspension against its volume fraction: laws from the literature, and tables.

The stress of the particles is sigma_ii = -eta0 |rate| eta_ii(phi), i = 1, 2, 3 along the flow, its gradient and the
vorticity. A law is a Law: eta of an array of volume fractions, positive and growing from phi_low to phi_m.

[Zarraga]    I.E. Zarraga, D.A. Hill, D.T. Leighton, J. Rheol. 44, 185 (2000)
[Morris]     J.F. Morris, F. Boulay, J. Rheol. 43, 1213 (1999)
[Boyer]      F. Boyer, E. Guazzelli, O. Pouliquen, Phys. Rev. Lett. 107, 188301 (2011)
[Chevremont] W. Chevremont, thesis, Grenoble (2020), chapter 4, equations 5 to 11. Its eq. 10 lacks the exponents of eq. 8; as
             printed it is eta_22. What is meant, and what is here, is eta_33 = lambda_33 (eq. 8) times eta_22 (eq. 9).
"""
import csv
from collections import namedtuple
from pathlib import Path

import numpy as np

PHI_RCP = 0.64          # random close packing, where eta_33 = eta_22 [Chevremont, eq. 7]

# eta: of an array of volume fractions; phi_low: where it becomes positive; nodes: where its slope jumps
Law = namedtuple("Law", "name eta phi_m phi_low nodes source", defaults=(0.0, (), ""))


def power(coefficient, exponent, phi_m):
    """Coefficient times (phi/(phi_m - phi))^exponent [Chevremont, eq. 5]."""
    return lambda phi: coefficient * (phi / (phi_m - phi)) ** exponent


def chevremont_22(phi_m):
    def eta(phi):
        q = phi / phi_m
        return q**9 / (1 - q) ** 2 + 150 * q**10
    return eta


def chevremont_22_exponential(phi_m):
    def eta(phi):
        with np.errstate(divide="ignore"):
            q = phi / phi_m
            far = 1 / q - 1
        return np.exp(-2.3 * far) / (1 - q) ** 2 + 30 * np.exp(-6 * far)
    return eta


def lambda_33(phi):
    """eta_33/eta_22 [Chevremont, eq. 8]."""
    r = phi / PHI_RCP
    return r**7.5 / (1e-3 + r**6)


def lambda_33_line(phi):
    """eta_33/eta_22 [Chevremont, eq. 7], negative below 0.164."""
    return 2.1 * (phi - PHI_RCP) + 1


def along_vorticity(ratio, eta_22):
    """Rule for eta_33 from eta_33/eta_22 and the rule for eta_22."""
    return lambda phi_m: lambda phi: ratio(phi) * eta_22(phi_m)(phi)


# name -> (rule: eta of phi_m, its phi_m, phi_low, source); phi_m of Chevremont's laws is that at friction 0.5
LAWS = {
    "zarraga_11": (lambda m: power(1.55, 3, m), 0.62, 0.0, "Zarraga 2000"),
    "zarraga_22": (lambda m: power(1.36, 3, m), 0.62, 0.0, "Zarraga 2000"),
    "zarraga_33": (lambda m: power(0.62, 3, m), 0.62, 0.0, "Zarraga 2000"),
    "morris_11": (lambda m: power(0.75, 2, m), 0.68, 0.0, "Morris and Boulay 1999"),
    "morris_22": (lambda m: power(0.75 * 0.8, 2, m), 0.68, 0.0, "Morris and Boulay 1999"),
    "morris_33": (lambda m: power(0.75 * 0.5, 2, m), 0.68, 0.0, "Morris and Boulay 1999"),
    "boyer_22": (lambda m: power(1.0, 2, m), 0.585, 0.0, "Boyer 2011"),
    "boyer_33": (lambda m: power(0.6, 2, m), 0.585, 0.0, "Boyer 2011, coefficient of Chevremont 2020"),
    "chevremont_22": (chevremont_22, 0.58, 0.0, "Chevremont 2020, eq. 9"),
    "chevremont_22_exponential": (chevremont_22_exponential, 0.58, 0.0, "Chevremont 2020, eq. 11"),
    "chevremont_33": (along_vorticity(lambda_33, chevremont_22), 0.58, 0.0, "Chevremont 2020, eqs. 8, 9"),
    "chevremont_33_exponential": (along_vorticity(lambda_33, chevremont_22_exponential), 0.58, 0.0,
                                  "Chevremont 2020, eqs. 8, 11"),
    "chevremont_33_line": (along_vorticity(lambda_33_line, chevremont_22), 0.58, PHI_RCP - 1 / 2.1,
                           "Chevremont 2020, eqs. 7, 9"),
}


def named(name, phi_m=None):
    """Law of the literature; phi_m: another one than its own."""
    if name not in LAWS:
        raise ValueError(f"no law {name}: a csv file with columns phi and eta, or " + " ".join(LAWS))
    rule, own, low, source = LAWS[name]
    phi_m = own if phi_m is None else phi_m
    if not low < phi_m < 1:
        raise ValueError(f"{name}: phi_m must be above {low:.3g} and below 1, but is {phi_m:g}")
    return Law(name, rule(phi_m), phi_m, low, (), source)


def table(name, phi, eta):
    """Law through points: eta^(-1/2) is linear in 1/phi between them and beyond, as is eq. 5 with exponent 2."""
    order = np.argsort(phi)
    phi, eta = np.asarray(phi, dtype=float)[order], np.asarray(eta, dtype=float)[order]
    if len(phi) < 2 or not 0 < phi[0] or not np.all(np.diff(phi) > 0) or not eta[0] > 0 or not np.all(np.diff(eta) > 0):
        raise ValueError(f"{name}: needs two or more volume fractions with positive eta that grow together; "
                         "leave out rows where eta is within its error of 0")
    x, y = 1 / phi[::-1], eta[::-1] ** -0.5    # both from the dense end on
    slopes = np.diff(y) / np.diff(x)
    jam = x[0] - y[0] / slopes[0]    # 1/phi_m

    def interpolated(at):
        with np.errstate(divide="ignore"):
            at = 1 / np.asarray(at, dtype=float)
        left = np.clip(np.searchsorted(x, at, side="right") - 1, 0, len(slopes) - 1)
        return (y[left] + slopes[left] * (at - x[left])) ** -2.0
    return Law(name, interpolated, 1 / jam, 0.0, tuple(phi), f"{len(phi)} points from {phi[0]:.3g} to {phi[-1]:.3g}")


def read_table(words):
    """Law of a csv file, FILE or FILE:column of phi:column of eta."""
    file, _, columns = words.partition(":")
    columns = columns.split(":") if columns else ["phi", "eta"]
    with open(file, newline="", encoding="utf-8") as text:
        lines = [line for line in text if not line.startswith("#")]
    rows = list(csv.DictReader(lines, delimiter=";" if lines and ";" in lines[0] else ","))
    known = list(rows[0]) if rows else []
    missing = [column for column in columns if column not in known]
    if len(columns) != 2 or missing:
        raise ValueError(f"{file}: no column {' '.join(missing)}; write {file}:PHI:ETA with two of " + " ".join(known))
    points = [[float(row[column]) for column in columns] for row in rows if all(row[column] for column in columns)]
    return table(Path(file).stem, *np.array(points).reshape(-1, 2).T)


def find_law(words, phi_m=None):
    """Law of a name or of a csv file."""
    if words in LAWS or not Path(words.partition(":")[0]).is_file():
        return named(words, phi_m)
    if phi_m is not None:
        raise ValueError(f"{words}: a table has its own phi_m")
    return read_table(words)
