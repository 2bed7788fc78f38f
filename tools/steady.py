"""Steady part of a signal, means with honest errors, weighted averages and oscillatory rheology.

usage: tools/python.sh tools/steady.py FILE [--columns NAME ...] [--over NAME] [--from X] [--json]
  FILE      written by LAMMPS' fix ave/time, scalar mode
  --columns the columns to average; default: all but those that only grow, such as the strain
  --over    the column in whose units --from and the table are; default: TimeStep
  --from    start of the steady part; default: found, the same for all columns
The exit status is 1 if a column has no steady part or is too short for an error bar.

All signals are arrays of one value per sample, equally spaced. Every error is the half width of the
interval that covers the truth in 68.3 % of the cases, with Student's factor for the few degrees of
freedom of a short signal; interval() widens it to another level. The manual page is Tools_steady.

[Wolff]  U. Wolff, Comput. Phys. Commun. 156, 143 (2004)
[White]  K.P. White, Simulation 69, 323 (1997)
[Dong]   J. Dong, Numerical study of dense particle flows under planar shear, thesis, Lund (2020)
"""
import argparse
import json
import sys
from collections import namedtuple
from statistics import NormalDist

import numpy as np

from ave_time import read_ave_time    # for those who use this module, too

ONE_SIGMA = 0.6827      # level of the errors
MIN_SAMPLES = 20        # fewer have no correlation length
MIN_INDEPENDENT = 5     # below, the correlation length is a guess: at 5 relaxation times it comes out half too small
MIN_PER_CYCLE = 8       # samples; seven unknowns: mean and three harmonics
MIN_CYCLES = 40         # fewer are taken as independent

# correlation: samples per independent one; independent = samples/correlation; dof: degrees of freedom of the error
Estimate = namedtuple("Estimate", "mean error correlation independent samples dof")
Combined = namedtuple("Combined", "mean error chi2 dof probability")


class TooShort(ValueError):
    """The signal is too short to tell its error."""


class NotSteady(ValueError):
    """The signal has no steady part."""


def student(level, dof):
    """Half width, in standard errors, of the interval that covers with probability level.

    Expansion for large dof, M. Abramowitz, I.A. Stegun, Handbook of mathematical functions, 26.7.5;
    within 2 % for dof >= 2 and level <= 0.95.
    """
    x = NormalDist().inv_cdf(0.5 + 0.5 * level)
    return (x + (x**3 + x) / (4 * dof) + (5 * x**5 + 16 * x**3 + 3 * x) / (96 * dof**2)
            + (3 * x**7 + 19 * x**5 + 17 * x**3 - 15 * x) / (384 * dof**3)
            + (79 * x**9 + 776 * x**7 + 1482 * x**5 - 1920 * x**3 - 945 * x) / (92160 * dof**4))


def interval(estimate, level=0.95):
    """Half width of the interval of another level around estimate.mean; same units."""
    return estimate.error * student(level, estimate.dof) / student(ONE_SIGMA, estimate.dof)


def as_signal(values):
    values = np.asarray(values, dtype=float)
    if values.ndim != 1 or not np.all(np.isfinite(values)):
        raise ValueError("a signal must be a one-dimensional array of finite numbers")
    return values


def is_constant(values):
    return np.ptp(values) <= 1e-12 * np.max(np.abs(values))


def correlation(values):
    """Integrated correlation: samples per independent one, and the window (samples) that was summed.

    1 + 2 sum of the autocorrelation up to the automatic window of [Wolff, sec. 3.3] with S = 2, divided by
    1 - (2 window + 1)/samples for what the subtraction of the mean took away [Wolff, eq. 49, to first order].
    """
    n = len(values)
    spectrum = np.fft.rfft(values - np.mean(values), 2 * n)
    covariance = np.fft.irfft(np.abs(spectrum) ** 2)[:n] / np.arange(n, 0, -1)
    rho = covariance / covariance[0]
    half = 0.5
    for window in range(1, n // 2):
        half += rho[window]
        relaxation = 2 / np.log((2 * half + 1) / (2 * half - 1)) if half > 0.5 else 1e-9
        if np.exp(-window / relaxation) < relaxation / np.sqrt(window * n):
            break
    length = 2 * half if half > 0 else 1.0
    return length / max(1 - (2 * window + 1) / n, 0.1), window


def mean_error(values, correlated=True):
    """Estimate of the mean of a steady signal; correlated=False: of independent values.

    The error is sqrt(variance * correlation/samples) times Student's factor, with
    samples/(2 window + 1) - 1 degrees of freedom: the sum over the window scatters like the variance of so
    many independent values. TooShort: fewer than MIN_SAMPLES samples or MIN_INDEPENDENT independent ones.
    """
    values = as_signal(values)
    n = len(values)
    if n < (MIN_SAMPLES if correlated else 2):
        raise TooShort(f"only {n} samples")
    mean = float(np.mean(values))
    if is_constant(values):
        return Estimate(mean, 0.0, 1.0, float(n), n, n - 1.0)
    length, window = correlation(values) if correlated else (1.0, 0)
    independent = n / length
    if correlated and independent < MIN_INDEPENDENT:
        raise TooShort(f"only {independent:.1f} independent samples")
    dof = max(n / (2 * window + 1) - 1, 1.0)
    variance = np.var(values, ddof=0 if correlated else 1)    # correlation() corrects for the mean itself
    error = student(ONE_SIGMA, dof) * np.sqrt(variance * length / n)
    return Estimate(mean, float(error), float(length), float(independent), n, float(dof))


def has_trend(values, level=0.95):
    """Is the slope of a straight line through the signal significant, given its correlated scatter?"""
    n = len(values)
    if is_constant(values):
        return False
    time = np.arange(n) - 0.5 * (n - 1)
    slope = np.dot(time, values) / np.dot(time, time)
    scatter = values - np.mean(values) - slope * time
    if is_constant(scatter + np.mean(values)):
        return True
    length, window = correlation(scatter)
    error = np.sqrt(np.var(scatter) * length / np.dot(time, time))
    return bool(abs(slope) > student(level, max(n / (2 * window + 1) - 1, 2.0)) * error)


def end_of_transient(values):
    """Sample up to which leaving out lowers the standard error of the rest: rule MSER-5 [White]."""
    if is_constant(values):
        return 0
    first = len(values) % 5
    batches = np.mean(values[first:].reshape(-1, 5), axis=1)[::-1] - np.mean(values)
    count = np.arange(1, len(batches) + 1)
    variance = np.cumsum(batches**2) / count - (np.cumsum(batches) / count) ** 2
    shortest = len(batches) // 4
    kept = shortest + 1 + int(np.argmin((variance / count)[shortest:]))
    return first + 5 * (len(batches) - kept) if kept < len(batches) else 0


def steady_start(*signals, false_alarms=0.05):
    """Index of the first sample of the steady part, the latest of several signals of equal length.

    Twice the end of the transient by MSER-5: that rule stops where an exponential has sunk to the
    scatter; as much again lets it sink to insignificance. That may be more than half of the signal, also
    by chance where the correlation is long: then the last half is taken, unless the whole signal or its
    last three quarters drift. NotSteady: these do, or a trend is left (false_alarms: how often chance does
    that to steady signals, all together). TooShort: fewer than 50 samples.
    """
    signals = [as_signal(values) for values in signals]
    n = len(signals[0])
    if any(len(values) != n for values in signals):
        raise ValueError("signals must be of equal length")
    if n < 50:
        raise TooShort(f"only {n} samples; 50 are needed to find a steady part")

    def drift_from(*starts):
        return any(has_trend(values[first:], 1 - false_alarms / len(signals)) for values in signals for first in starts)

    start = 2 * max(end_of_transient(values) for values in signals)
    if start > n // 2:
        if drift_from(0, n // 4):
            raise NotSteady("the transient fills more than a quarter of the signal; run longer")
        start = n // 2
    if drift_from(start):
        raise NotSteady("the signal still drifts at its end; run longer")
    return start


def ratio(numerator, denominator, period=None):
    """Estimate of mean(numerator)/mean(denominator), of signals of equal length.

    The error is that of the jackknife's pseudo-values of about 100 blocks, which may be correlated;
    with period (in samples, of an oscillation) blocks are whole cycles. samples counts blocks.
    """
    numerator, denominator = as_signal(numerator), as_signal(denominator)
    n = len(numerator)
    length = max(n // 100, 1) if period is None else period
    blocks = int(n / length + 1e-9)
    if blocks < 2:
        raise TooShort("a ratio needs two cycles" if period else "a ratio needs two samples")
    edges = np.round(n - length * np.arange(blocks, -1, -1)).astype(int)    # the beginning may be left out
    above = np.add.reduceat(numerator, edges[:-1])
    below = np.add.reduceat(denominator, edges[:-1])
    without = (np.sum(above) - above) / (np.sum(below) - below)
    pseudo = blocks * np.sum(above) / np.sum(below) - (blocks - 1) * without
    return mean_error(pseudo, correlated=period is None or blocks >= MIN_CYCLES)


def weighted_mean(values, rate, period=None):
    """Estimate of sum(|rate| values)/sum(|rate|), an average over strain instead of time.

    [Dong, eq. 4.10] with a sign: he averages |values|. With values = sign(rate) stress/pressure it is
    his viscous friction (4.15) over all cycles; with the strain in place of rate his (4.16).
    """
    weight = np.abs(as_signal(rate))
    return ratio(weight * values, weight, period)


def friction(rate, stress, pressure, period=None):
    """Estimate of <|rate| stress sign(rate)>/<|rate| pressure>: dissipated power over |rate| pressure."""
    return ratio(as_signal(rate) * stress, np.abs(rate) * pressure, period)


def harmonics(time, signal, omega, order=3):
    """Complex amplitudes A_0 ... A_order of signal = sum of Re(A_k exp(i k omega time)), by least squares."""
    angles = omega * np.asarray(time)[:, None] * np.arange(1, order + 1)
    columns = np.hstack([np.ones((len(time), 1)), np.cos(angles), np.sin(angles)])
    fit = np.linalg.lstsq(columns, signal, rcond=None)[0]
    return np.concatenate([[fit[0]], fit[1:order + 1] - 1j * fit[order + 1:]])


def response(time, rate, signal, omega):
    """First and third harmonic of signal relative to that of rate, one complex number per whole cycle."""
    time, rate, signal = as_signal(time), as_signal(rate), as_signal(signal)
    spacing = (time[-1] - time[0]) / (len(time) - 1)
    period = 2 * np.pi / omega
    cycles = int(spacing * len(time) / period + 1e-6)
    if cycles < 2 or period / spacing < MIN_PER_CYCLE:
        raise TooShort(f"{cycles} cycles of {period / spacing:.1f} samples; 2 of {MIN_PER_CYCLE} are needed")
    first = time[-1] + 0.5 * spacing - cycles * period
    cycle = np.floor((time - first) / period)
    results = []
    for number in range(cycles):
        inside = cycle == number
        drive = harmonics(time[inside], rate[inside], omega)[1]
        answer = harmonics(time[inside], signal[inside], omega)
        turn = np.conj(drive) / abs(drive)    # to the phase of the rate
        results.append([abs(drive), answer[1] * turn, answer[3] * turn**3])
    return np.array(results).T


def complex_estimates(ratios, thirds):
    """Dict of the estimates of real - i imag, from one complex number per cycle."""
    correlated = len(ratios) >= MIN_CYCLES
    total, third = np.mean(ratios), np.mean(thirds)
    along = np.conj(total) / abs(total)
    angle = np.arctan2(-total.imag, total.real)
    phases = mean_error(angle - (ratios * along).imag / abs(total), correlated)
    along_third = np.conj(third) / abs(third) if third else 1.0
    return {"real": mean_error(ratios.real, correlated), "imag": mean_error(-ratios.imag, correlated),
            "modulus": mean_error((ratios * along).real, correlated), "phase": phases,
            "third": mean_error((thirds * along_third).real / abs(total), correlated)}


def complex_viscosity(time, rate, stress, omega):
    """Estimates of the complex viscosity of rate = g0 + g1 cos(omega time + any phase), stress in response.

    Dict: real = eta' and imag = eta'' of stress = eta' g1 cos + eta'' g1 sin [Dong, eqs. 4.12-4.14],
    modulus, phase = atan2(eta'', eta') (0: viscous, pi/2: elastic), and third, the intensity of the third
    harmonic of the stress over the first. Errors from the scatter of whole cycles, counted back from the
    end; fewer than 40 are taken as independent. TooShort: under 2 cycles or 8 samples in a cycle.
    """
    drive, first, third = response(time, rate, stress, omega)
    return complex_estimates(first / drive, third / drive)


def complex_friction(time, rate, stress, pressure, omega):
    """Estimates of the complex friction, a dict as of complex_viscosity.

    real = mu' = int (stress/pressure) rate dt / int |rate| dt and imag = mu'' with the strain in place of
    the rate [Dong, eqs. 4.15-4.16]; of the rate only its oscillating part counts. For a harmonic rate
    these are pi/4 times the first harmonic of stress/pressure.
    """
    pressure = as_signal(pressure)
    if np.any(pressure <= 0):
        raise ValueError("complex friction needs a positive pressure at all times")
    _, first, third = response(time, rate, stress / pressure, omega)
    return complex_estimates(0.25 * np.pi * first, 0.25 * np.pi * third)


def combine(estimates, weights=None):
    """Mean of independent runs, from their estimates: Combined(mean, error, chi2, dof, probability).

    Weights default to samples, right for runs of one system: their own errors scatter too much to be
    weights. For runs of different precision give 1/error**2. chi2 compares the means with their errors;
    probability is that of a larger chi2 by chance; below 0.05 the error grows by sqrt(chi2/dof).
    """
    if len(estimates) < 2:
        raise TooShort("combine needs two runs")
    means, errors, samples, freedom = np.array([(e.mean, e.error, e.samples, e.dof) for e in estimates]).T
    weights = np.array(samples if weights is None else weights, dtype=float)
    weights /= np.sum(weights)
    parts = (weights * errors / student(ONE_SIGMA, freedom)) ** 2
    if not np.all(parts > 0):
        raise ValueError("combine needs errors above zero")
    # degrees of freedom of the sum: F.E. Satterthwaite, Biometrics Bull. 2, 110 (1946)
    error = np.sqrt(np.sum(parts)) * student(ONE_SIGMA, np.sum(parts) ** 2 / np.sum(parts**2 / freedom))
    best = np.average(means, weights=1 / errors**2)
    chi2 = float(np.sum(((means - best) / errors) ** 2))
    dof = len(means) - 1
    # E.B. Wilson, M.M. Hilferty, Proc. Natl. Acad. Sci. 17, 684 (1931)
    normal = ((chi2 / dof) ** (1 / 3) - 1 + 2 / (9 * dof)) / np.sqrt(2 / (9 * dof))
    probability = 1 - NormalDist().cdf(normal)
    if probability < 0.05:
        error *= np.sqrt(chi2 / dof)
    return Combined(float(np.dot(weights, means)), float(error), chi2, dof, probability)


def summary(data, columns, over, start=None):
    """Rows of the table: dicts of name, mean, error, correlation and from (in units of over), samples, remark."""
    place = data[over]
    false_alarms = 0.05 / max(len(columns), 1)
    begin, remarks = 0 if start is None else int(np.searchsorted(place, start)), {}
    for name in columns if start is None else []:
        try:
            begin = max(begin, steady_start(data[name], false_alarms=false_alarms))
        except (NotSteady, TooShort) as problem:
            remarks[name] = str(problem)
    rows = []
    for name in columns:
        row = {"name": name, "mean": None, "error": None, "correlation": None, "from": None, "samples": 0,
               "remark": remarks.get(name, "")}
        values = data[name][begin:]
        try:
            if not row["remark"]:
                found = mean_error(values)
                spacing = (place[-1] - place[begin]) / (len(values) - 1)
                row.update({"mean": found.mean, "error": found.error, "correlation": found.correlation * spacing,
                            "from": float(place[begin]), "samples": found.samples})
                row["remark"] = "drifts" if has_trend(values, 1 - false_alarms) else ""
        except TooShort as problem:
            row["remark"] = str(problem)
        rows.append(row)
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file")
    parser.add_argument("--columns", nargs="+")
    parser.add_argument("--over", default="TimeStep")
    parser.add_argument("--from", dest="start", type=float)
    parser.add_argument("--json", action="store_true")
    args = parser.parse_args()
    try:
        data = read_ave_time(args.file)
    except (OSError, ValueError) as problem:
        parser.error(str(problem))
    for name in [args.over] + (args.columns or []):
        if name not in data:
            parser.error(f"no column {name} in {args.file}, which has: " + " ".join(data))
    columns = args.columns or [name for name in data if name != args.over and not np.all(np.diff(data[name]) > 0)]
    rows = summary(data, columns, args.over, args.start)
    if args.json:
        print(json.dumps(rows, indent=2))
    else:
        print(f"{'name':20s} {'mean':>12s} {'error':>10s} {'correlation':>11s} {'from':>10s} {'samples':>7s}")
        for row in rows:
            line = f"{row['name']:20s} "
            if row["mean"] is not None:
                line += "{mean:12.6g} {error:10.2g} {correlation:11.3g} {from:10.4g} {samples:7d} ".format(**row)
            print((line + row["remark"]).rstrip())
    sys.exit(1 if any(row["remark"] for row in rows) else 0)


if __name__ == "__main__":
    main()
