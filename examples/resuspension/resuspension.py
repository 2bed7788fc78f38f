"""Profiles of a run of in.resuspension: volume fraction, load, stress by origin, local rate.

Lengths in mean radii from the mean height of the floor's centers, stresses in viscosity*rate, compression positive. The volume of
a grain is spread over its height. The load at a height is the weight of the grains whose centers are above, less the drag of the
fluid on them and their change of momentum, over the area: what the stress below has to carry.
"""
import csv
import sys
from collections import namedtuple
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "tools"))
import ave_chunk    # noqa: E402  pylint: disable=wrong-import-position
import ave_time    # noqa: E402  pylint: disable=wrong-import-position
import steady    # noqa: E402  pylint: disable=wrong-import-position

FLOOR = 1.0             # tops of the floor, where the layer begins
PHI_REST = 0.58         # of the layer at rest
NEAR, FAR = 3.0, 5.0    # above the floor, and below the surface: no bulk
PHI_TOP = 0.1           # at the surface, where the profile passes it
ORIGINS = ("contact_n", "contact_t", "film_n", "film_t", "inertia")
FIRST = {"xx": 1, "yy": 2, "zz": 3, "xy": 4}    # columns of compute stress/partition/atom, +9 for each origin

# of each bin: its middle, volume fraction, load, stresses by component and origin, mean velocity along the flow, drag over the area
Profile = namedtuple("Profile", "z phi load stress speed drag")


def read_scene(name):
    words = Path(name).read_text(encoding="ascii").split()
    return {key: word if key == "direction" else float(word) for key, word in zip(words[::2], words[1::2])}


class Run:
    """A run with the name out: scene, sums over each bin and output, forces, means."""

    def __init__(self, out):
        self.scene = read_scene(f"{out}.scene")
        self.data = ave_chunk.read_ave_chunk(f"{out}.profile")
        self.forces = ave_time.read_ave_time(f"{out}.forces")
        self.ends = ave_time.read_ave_time(f"{out}.ends")
        self.up = {"vorticity": "zz", "gradient": "yy"}[self.scene["direction"]]
        self.area = self.scene["width"] ** 2
        self.z = self.scene["bottom"] + self.data["Coord1"][0] * (self.scene["top"] - self.scene["bottom"])
        self.thick = self.z[1] - self.z[0]
        self.outputs = len(self.data["TimeStep"])
        self.times = self.data["TimeStep"] * self.scene["dt"]
        self.phi = np.array([self.spread(row) for row in self.data["v_volume"]]) / (self.area * self.thick)

    def spread(self, volumes):
        """Volumes at the centers of grains, spread over their heights as unit spheres are."""
        edges = (np.arange(np.ceil(1 / self.thick + 0.5) + 1) - 0.5) * self.thick
        below = 0.5 + 0.25 * np.clip(edges, -1, 1) * (3 - np.clip(edges, -1, 1) ** 2)
        half = np.diff(below)[1:]
        kernel = np.concatenate([half[::-1], [2 * below[1] - 1], half])
        return np.convolve(volumes, kernel, "same")

    def stress(self, component, origins=ORIGINS, rows=slice(None)):
        """Compression in each bin, mean over rows; the inertial part is known of the normal stresses alone."""
        names = [f"c_each[{9 * ORIGINS.index(name) + FIRST[component]}]" for name in origins]
        return -sum(self.data[name][rows].mean(axis=0) for name in names if name in self.data) / (self.area * self.thick)

    def profile(self, start=0):
        """Means over the outputs from start on, or over a slice of them."""
        rows = start if isinstance(start, slice) else slice(start, None)
        volume, pull = (self.data[name][rows].mean(axis=0) for name in ("v_volume", "v_pull"))
        force = volume / self.scene["shields"] - pull
        load = (np.cumsum(force[::-1])[::-1] - 0.5 * force) / self.area
        stress = {(component, name): self.stress(component, [name], rows) for component in ("xx", "yy", "zz", "xy") for name in ORIGINS
                  if (component, name) != ("xy", "inertia")}
        count = self.data["v_one"][rows].mean(axis=0)
        with np.errstate(invalid="ignore", divide="ignore"):
            speed = self.data["v_speed"][rows].mean(axis=0) / count
        return Profile(self.z, self.phi[rows].mean(axis=0), load, stress, speed, pull / self.area)

    def imbalance(self, start=0, layer=6.0, strain=1.0):
        """Stress less load of layers between floor and surface: rms over the load, and over its error from parts of the run."""
        per = max(1, round(strain / (self.times[1] - self.times[0]))) if self.outputs > 1 else 1
        parts = [slice(n, n + per) for n in range(start, self.outputs - per + 1, per)]
        if len(parts) < 3:
            return np.nan, np.nan
        thick, bulk = round(layer / self.thick), self.bulk(start)
        first = np.flatnonzero(bulk)[0]
        excess, load = [], []
        for rows in parts:
            p = self.profile(rows)
            stress = sum(p.stress[self.up, origin] for origin in ORIGINS)
            kept = slice(first, first + bulk.sum() // thick * thick)
            excess.append((stress - p.load)[kept].reshape(-1, thick).mean(axis=1))
            load.append(p.load[kept].reshape(-1, thick).mean(axis=1))
        mean, error = np.mean(excess, axis=0), np.std(excess, axis=0, ddof=1) / np.sqrt(len(parts))
        return np.sqrt(np.mean((mean / np.mean(load, axis=0)) ** 2)), np.sqrt(np.mean((mean / error) ** 2))

    def bulk(self, start=0):
        """Bins that are neither near the floor nor near the surface."""
        phi = self.phi[start:].mean(axis=0)
        return is_bulk(self.z, phi)

    def heights(self):
        """Of each output: of the surface, and of the center of all solid volume, both over the floor."""
        top = [surface(self.z, phi) for phi in self.phi]
        volume = self.data["v_volume"]
        return np.array(top) - FLOOR, volume @ self.z / volume.sum(axis=1) - FLOOR

    def start(self):
        """First output of the steady part, by the height of the center. The deck lets the layer rise before it writes."""
        try:
            return steady.steady_start(self.heights()[1])
        except steady.TooShort:
            return 0
        except steady.NotSteady as problem:
            print(f"no steady part found ({problem}): taking the last half")
            return self.outputs // 2

    def rest(self):
        """Height of the layer at rest."""
        return self.scene["column"] / PHI_REST

    def acrivos(self):
        return 4.5 * self.scene["shields"] / self.rest()


def surface(z, phi, level=PHI_TOP):
    """Height above which the volume fraction stays below the level."""
    last = np.flatnonzero(phi >= level)[-1]
    return z[last] + (z[last + 1] - z[last]) * (phi[last] - level) / (phi[last] - phi[last + 1])


def is_bulk(z, phi):
    return (z > FLOOR + NEAR) & (z < surface(z, phi) - FAR)


def local_rate(profile, span=3.0):
    """Slope of the mean velocity over height, fitted over the span on both sides; nan where grains are rare."""
    z, speed = profile.z, profile.speed
    known = np.isfinite(speed) & (profile.phi > 0.05)
    rate = np.full_like(z, np.nan)
    for n in np.flatnonzero(known):
        near = known & (np.abs(z - z[n]) <= span)
        if near.sum() > 3:
            rate[n] = np.polyfit(z[near], speed[near], 1, w=np.sqrt(profile.phi[near]))[0]
    return rate


# tables

def mean_error(values):
    """Mean and error; of a short signal the error is half the difference between its halves."""
    try:
        found = steady.mean_error(values)
        return found.mean, found.error
    except steady.TooShort:
        half = len(values) // 2
        return np.mean(values), 0.5 * abs(np.mean(values[:half]) - np.mean(values[half:]))


def result(run, start):
    """Row of a table of runs, as text."""
    heights, centers = (values[start:] for values in run.heights())
    height, center, hold, drag, isolated = (mean_error(values) for values in (
        heights, centers, -run.forces["v_hold"][start:] / run.scene["weight"], run.forces["v_drag"][start:] / run.scene["weight"],
        run.forces["v_isolated"][start:]))
    low = (run.z > FLOOR + 2) & (run.z < FLOOR + 8)
    phi_low = mean_error(run.phi[start:, low].mean(axis=1))
    row = {"direction": run.scene["direction"]}
    row.update({name: f"{run.scene[name]:.4g}" for name in ("shields", "inertia", "N", "phi", "seed", "column")})
    row.update({"from": f"{run.times[start]:.3g}", "until": f"{run.times[-1]:.3g}", "acrivos": f"{run.acrivos():.4g}"})
    for name, (value, error) in (("height", height), ("growth", (height[0] / run.rest() - 1, height[1] / run.rest())),
                                 ("center", center), ("phi_low", phi_low), ("hold", hold), ("drag", drag), ("isolated", isolated)):
        row[name], row[f"{name}_error"] = f"{value:.4g}", f"{error:.2g}"
    row["imbalance"], row["imbalance_errors"] = (f"{value:.2g}" for value in run.imbalance(start))
    return row


def rows_of(name, run, start):
    """Rows of a table of profiles, as text: mean over the steady part, layers of a diameter."""
    p = run.profile(start)
    rate = local_rate(p) if run.scene["direction"] == "gradient" else np.ones_like(p.z)
    step = round(2 / run.thick)
    last = np.flatnonzero(p.phi > 1e-4)[-1] // step * step + step
    first = np.flatnonzero(p.z > 0)[0]
    for n in range(first, last, step):
        at = slice(n, n + step)
        parts = [p.stress[run.up, origin][at].mean() for origin in ORIGINS]
        values = [p.z[at].mean(), p.phi[at].mean(), p.load[at].mean(), np.where(p.z > FLOOR, p.drag, 0)[at].sum(), rate[at].mean(), *parts]
        yield [name, run.scene["direction"], f"{run.scene['shields']:g}"] + [f"{value:.5g}" for value in values]


COLUMNS = ["run", "direction", "shields", "z", "phi", "load", "drag", "rate", *ORIGINS]


def write_csv(name, header, rows):
    with open(name, "w", newline="", encoding="ascii") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)
    print(f"wrote {name}")


def read_profiles(name):
    """Columns of each run of a table of profiles."""
    found = {}
    with open(name, newline="", encoding="ascii") as file:
        for row in csv.DictReader(file):
            found.setdefault(row["run"], []).append(row)
    return {run: {column: np.array([float(row[column]) for row in rows]) if column not in ("run", "direction") else rows[0][column]
                  for column in COLUMNS} for run, rows in found.items()}


def homogeneous(component, friction="0.5"):
    """Volume fractions and normal viscosities in homogeneous shear, measured with the same films (tests/validation)."""
    points = {}
    with open(HERE.parents[1] / "tests" / "validation" / "range" / "results.csv", newline="", encoding="ascii") as file:
        for row in csv.DictReader(file):
            if (row["rule"], row["reach"]) == ("cut", "0.5"):
                points.setdefault(float(row["phi"]), []).append(-float(row[f"s{component}"]))
    with open(HERE.parents[1] / "tests" / "validation" / "mu_of_iv" / "results.csv", newline="", encoding="ascii") as file:
        dilute = [row for row in csv.DictReader(file) if (row["Iv"], row["friction"]) == ("1", friction)]
    points[np.mean([float(row["phi"]) for row in dilute])] = [-float(row[f"s{component}"]) for row in dilute]
    return np.array(sorted((phi, np.mean(values)) for phi, values in points.items())).T
