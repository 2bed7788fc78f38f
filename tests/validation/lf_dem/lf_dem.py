"""Which of LF_DEM's choices makes its viscosity: they are switched on one by one, from its own starting configurations.

usage: tools/python.sh lf_dem.py [--phi 0.45 0.5] [--strain 6] [--jobs 1]
Runs in.lf_dem for each case, appends to runs.csv what it lacks, writes the table of README.md.
"""
import argparse
import sys
import tempfile
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
TOP = HERE.parents[2]
sys.path.insert(0, str(TOP / "examples" / "scene"))
import cases    # noqa: E402  pylint: disable=wrong-import-position
import rheology    # noqa: E402  pylint: disable=wrong-import-position

TABLE = HERE / "runs.csv"
CASE = ["variant", "phi", "strain"]
PARTS = ["contact_n", "contact_t", "film_n", "film_t"]
FIELDS = CASE + ["eta_r", "error", *PARTS]
TRANSIENT = 1.0
# kn = 1e4 6 pi, kt = kn/2; here two springs in series carry a contact at rest
SOFT = {"stiffness": f"{2e4 * 6 * np.pi:.6g}", "kt": f"{0.5e4 * 6 * np.pi:.6g}"}
THIN = {"roughness": "0.001", "touch": "1", "stiffness": "1e7"}
VARIANTS = {
    "as the examples": {},
    "drag on all": {"drag": "1"},
    "contact at touch": {"touch": "1"},
    "contact at touch, film 1/(xi + 0.001)": THIN,
    "no twisting film": {"modes": "twist no"},
    "soft as LF_DEM": SOFT,
    "drag on all, soft as LF_DEM": {"drag": "1", **SOFT},
    "all but soft": {**THIN, "drag": "1", "modes": "twist no"},
    "all but soft, St 0.0125": {**THIN, "drag": "1", "modes": "twist no", "density": "0.0125"},
}
PUBLISHED = {"0.45": (18.0, 0.7), "0.5": (41.7, 1.6)}    # LF_DEM 00fa7cc0, strain 1 to 3, without 5/2 phi


def write_data(start, file):
    """Data file of a configuration of LF_DEM, whose gradient is z: y and z change places, a reflection in both."""
    lines = start.read_text(encoding="ascii").splitlines()
    edge = float(lines[3].split()[4])
    spheres = np.array([[float(word) for word in line.split()[:4]] for line in lines if not line.startswith("#")])
    with open(file, "w", encoding="ascii") as out:
        out.write(f"{start.name}\n\n{len(spheres)} atoms\n1 atom types\n\n" + "".join(f"0 {edge:.15g} {c}lo {c}hi\n" for c in "xyz") + "\nAtoms # sphere\n\n")
        for tag, (x, y, z, radius) in enumerate(spheres, 1):
            out.write(f"{tag} 1 {2 * radius:.15g} 1 {x:.15g} {z:.15g} {y:.15g}\n")


def measure(case):
    with tempfile.TemporaryDirectory() as folder:
        data_file = Path(folder) / "start.data"
        write_data(HERE / f"start_{case['phi']}.dat", data_file)
        data = rheology.simulate(HERE / "in.lf_dem", {"start": data_file, "strain": case["strain"], **VARIANTS[case["variant"]]})
    kept = {name: column[data["v_gamma"] >= TRANSIENT] for name, column in data.items()}
    eta, error = rheology.estimate(kept["v_sxy"])
    return {**case, **dict(zip(FIELDS[3:], (f"{x:.4g}" for x in (eta, error, *(kept["v_" + name].mean() for name in PARTS)))))}


def table(rows):
    lines = ["| variant | " + " | ".join(f"phi {phi}" for phi in PUBLISHED) + " | contacts, films at " + list(PUBLISHED)[-1] + " |", "|---" * 4 + "|"]
    found = {(row["variant"], row["phi"]): row for row in rows}
    for variant in VARIANTS:
        of = [found.get((variant, phi)) for phi in PUBLISHED]
        if not any(of):
            continue
        words = [f"{float(row['eta_r']):.1f}" + (f" +- {float(row['error']):.1f}" if row["error"] != "nan" else "") if row else "" for row in of]
        last = of[-1]
        words.append("{:.1f}, {:.1f}".format(float(last["contact_n"]) + float(last["contact_t"]), float(last["film_n"]) + float(last["film_t"])) if last else "")
        lines.append(f"| {variant} | " + " | ".join(words) + " |")
    lines.append("| LF_DEM | " + " | ".join(f"{eta} +- {error}" for eta, error in PUBLISHED.values()) + " | |")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--phi", nargs="+", default=list(PUBLISHED))
    parser.add_argument("--strain", default="6")
    parser.add_argument("--jobs", type=int, default=1)
    args = parser.parse_args()
    cases.run([dict(zip(CASE, (variant, phi, args.strain))) for variant in VARIANTS for phi in args.phi], measure, TABLE, FIELDS, args.jobs)
    cases.write_tables(HERE / "README.md", {"table": table(cases.read(TABLE))})


if __name__ == "__main__":
    main()
