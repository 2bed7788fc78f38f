"""Volume fraction at jamming and exponent of the approach to it, with their errors, from a flow curve.

usage: tools/python.sh tools/jamming.py TABLE.csv [--x Iv | --viscosity COLUMN] [--y phi] [--up-to 0.1] [--exponent N] [--phi-m PHI]
                                        [--where NAME=VALUE ...] [--difference]
  TABLE.csv    one row a run, such as those of tools/flow_curve.py and examples/mu_of_iv
  --x          column with the distance to jamming, such as the viscous number; or
  --viscosity  column with a viscosity, whose inverse is that distance
  --y          column with the volume fraction; its errors are in the column y_error, those of x in x_error, if there are any
  --up-to      largest x (inverse of a viscosity) that is fitted
  --exponent   keep the exponent; --phi-m keep the volume fraction at jamming; by default both are found
  --where      only rows with these values
  --difference fit 1 - phi/phi_m instead of phi_m/phi - 1
Fits phi_m/phi - 1 = b x^n by weighted least squares. With x a viscous number the laws of Boyer et al. (2011) and Chevremont et al. (2019)
have n = 1/2; with x the inverse of a viscosity, this diverges as (phi_m - phi)^(-1/n). The manual page is Tools_jamming.
"""
import argparse
import csv
import sys
from collections import namedtuple
from pathlib import Path

import numpy as np
from scipy.optimize import curve_fit

# per_phi_m: change of the exponent with the phi_m that is assumed; chi2 and dof: of the fit; nan errors: not fitted
Fit = namedtuple("Fit", "phi_m phi_m_error n n_error b b_error per_phi_m chi2 dof")


class Unusable(ValueError):
    """The points do not determine what is asked for."""


def volume_fraction(x, phi_m, n, b, difference=False):
    """phi at a distance x from jamming."""
    return phi_m * (1 - b * x**n) if difference else phi_m / (1 + b * x**n)


def errors_of_phi(x, phi_error, x_error, curve):
    """Errors in both as errors of phi alone, by the slope of a curve."""
    step = 1e-4
    slope = (curve(x * (1 + step)) - curve(x * (1 - step))) / (2 * step * x)
    return np.hypot(phi_error, slope * x_error)


def fit(x, phi, phi_error=None, x_error=None, n=None, phi_m=None, difference=False):
    """Fit of phi_m/phi - 1 = b x^n, or of 1 - phi/phi_m = b x^n; without errors all points count the same.

    The errors are those of the points, larger by sqrt(chi2/dof) where the points scatter more than their errors say.
    """
    x, phi = np.asarray(x, dtype=float), np.asarray(phi, dtype=float)
    free = [name for name, value in (("phi_m", phi_m), ("n", n), ("b", None)) if value is None]
    if len(x) < len(free):
        raise Unusable(f"{len(x)} points cannot tell " + ", ".join(free) + ": fit more points, or keep one of them")
    if np.any(x <= 0) or np.any(phi <= 0):
        raise Unusable("distances to jamming and volume fractions must be positive")
    weighted = phi_error is not None or x_error is not None
    phi_error = np.zeros_like(x) if phi_error is None else np.asarray(phi_error, dtype=float)
    x_error = np.zeros_like(x) if x_error is None else np.asarray(x_error, dtype=float)
    kept = {name: value for name, value in (("phi_m", phi_m), ("n", n)) if value is not None}

    def curve(at, *values):
        return volume_fraction(at, **kept, **dict(zip(free, values)), difference=difference)

    first = {"phi_m": 1.02 * phi.max(), "n": 0.5, "b": 0.8}
    values = [first[name] for name in free]
    for _ in range(4 if weighted else 1):    # the slope of the curve is in the weights
        sigma = errors_of_phi(x, phi_error, x_error, lambda at: curve(at, *values)) if weighted else np.ones_like(x)    # pylint: disable=cell-var-from-loop
        if np.any(~np.isfinite(sigma)) or np.any(sigma <= 0):
            raise Unusable("every point needs an error above zero, or none of them one")
        try:
            values, covariance = curve_fit(curve, x, phi, values, sigma, absolute_sigma=True, maxfev=10000)
        except RuntimeError as problem:
            raise Unusable(f"no fit found: {problem}") from None
    chi2, dof = float(np.sum(((phi - curve(x, *values)) / sigma) ** 2)), len(x) - len(free)
    if dof > 0 and (chi2 > dof or not weighted):
        covariance = covariance * chi2 / dof
    found = {**kept, **dict(zip(free, values))}
    errors = dict(zip(free, np.sqrt(np.diag(covariance))))
    per_phi_m = np.nan
    if "phi_m" in free and "n" in free and errors["phi_m"] > 0:    # the best n for a given phi_m lies on this line
        per_phi_m = covariance[free.index("phi_m"), free.index("n")] / errors["phi_m"] ** 2
    return Fit(*(x for name in ("phi_m", "n", "b") for x in (found[name], errors.get(name, np.nan))), per_phi_m, chi2, dof)


# the command

def read(table, where):
    """Rows of the table with these values."""
    with open(table, newline="", encoding="ascii") as file:
        rows = list(csv.DictReader(file))
    for words in where:
        name, equal, value = words.partition("=")
        if not equal or rows and name not in rows[0]:
            raise Unusable(f"--where {words}: write NAME=VALUE with NAME one of " + ", ".join(rows[0] if rows else []))
        rows = [row for row in rows if row[name] == value]
    if not rows:
        raise Unusable(f"{table} has no such rows")
    return rows


def column(rows, name):
    if name not in rows[0]:
        raise Unusable(f"there is no column {name}, but " + ", ".join(rows[0]))
    return np.array([float(row[name] or "nan") for row in rows])


def points(rows, args):
    """x, phi and their errors, of the rows that are fitted; None where the table knows no error."""
    x = column(rows, args.viscosity or args.x)
    x_error = column(rows, f"{args.viscosity or args.x}_error") if f"{args.viscosity or args.x}_error" in rows[0] else None
    if args.viscosity:
        x_error = None if x_error is None else x_error / x**2
        x = 1 / x
    phi = column(rows, args.y)
    phi_error = column(rows, args.y + "_error") if args.y + "_error" in rows[0] else None
    good = np.isfinite(x) & np.isfinite(phi) & (x <= args.up_to)
    for error in (x_error, phi_error):
        if error is not None:
            good &= np.isfinite(error)
    return [None if values is None else values[good] for values in (x, phi, phi_error, x_error)]


def parse(words):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("table", type=Path)
    distance = parser.add_mutually_exclusive_group()
    distance.add_argument("--x", default="Iv")
    distance.add_argument("--viscosity")
    parser.add_argument("--y", default="phi")
    parser.add_argument("--up-to", type=float, default=np.inf)
    parser.add_argument("--exponent", type=float)
    parser.add_argument("--phi-m", type=float)
    parser.add_argument("--where", nargs="+", default=[])
    parser.add_argument("--difference", action="store_true")
    return parser.parse_args(words)


def main(words=None):
    args = parse(words)
    try:
        x, phi, phi_error, x_error = points(read(args.table, args.where), args)
        found = fit(x, phi, phi_error, x_error, args.exponent, args.phi_m, args.difference)
    except (Unusable, OSError) as problem:
        sys.exit(f"jamming.py: {problem}")
    print(f"{len(x)} points, chi2 {found.chi2:.3g} of {found.dof} degrees of freedom")
    for name in ("phi_m", "n", "b"):
        error = getattr(found, name + "_error")
        print(f"{name:6s} {getattr(found, name):.5g}" + (f" +- {error:.2g}" if np.isfinite(error) else " (kept)"))
    print(f"divergence with the exponent 1/n = {1 / found.n:.3g}" + (f" +- {found.n_error / found.n**2:.2g}" if np.isfinite(found.n_error) else ""))
    if np.isfinite(found.per_phi_m):
        print(f"a phi_m larger by 0.001 makes n larger by {0.001 * found.per_phi_m:.2g}")


if __name__ == "__main__":
    main()
