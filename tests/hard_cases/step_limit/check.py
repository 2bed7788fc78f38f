# ranks: 1
"""The stability limit that the log prints holds: at 0.9 of it the energy of spheres on their springs stays within what
velocity Verlet allows, 1/(1 - 0.9^2) of it, for sizes up to 1:20, light and heavy partners, films at a gap, and both effective
radii; and it is not a limit for nothing: 1.5 times the step blows up. The same for fix overdamped/sphere, whose spheres at 0.9
of the limit load their springs in a shear flow as they do at 0.3 of it.
"""
import re
from pathlib import Path

import numpy as np

import deck

DEFAULTS = {"size": 20, "weight": 1, "gap": 0.02, "rule": "harmonic", "kt": 500, "motion": "nve"}
CASES = [{"size": size, "rule": rule} for size in (2, 20) for rule in ("harmonic", "mean")]
CASES += [{"size": 1}, {"size": 1, "gap": 0.45, "kt": 1000}, {"size": 5, "weight": 0.05}, {"size": 3, "kt": 10}]


def run(cases):
    """All of them in one run of LAMMPS."""
    lines = []
    for case in cases:
        lines.append("clear")
        for name, value in {**DEFAULTS, "step": 1e-6, "steps": 0, **case}.items():
            lines.append(f"variable {name} delete\nvariable {name} index {value}")
        lines.append(f"include {deck.CASE}/in.limit")
    Path("in.all").write_text("\n".join(lines) + "\n")
    return deck.run(Path("in.all").resolve())


limits = [float(value) for value in re.findall(r"of the stability limit (\S+)\n", run(CASES).text)]
steps = [{**case, "step": 0.9 * limit, "steps": 2000} for case, limit in zip(CASES, limits, strict=True)]
steps.append({**CASES[-1], "step": 1.5 * limits[-1], "steps": 2000})
growth = [np.max(np.nan_to_num(t["v_energy"], nan=np.inf)) / t["v_energy"][0] for t in run(steps).tables()]
for case, limit, most in zip(CASES, limits, growth[:-1], strict=True):
    what = " ".join(f"{name} {value}" for name, value in case.items())
    deck.expect(f"{what}: limit {limit:.4g}, energy at 0.9 of it is bounded", most < 1.02 / (1 - 0.81), f"{most:.3g}")
deck.expect("at 1.5 times the limit it is not", growth[-1] > 100, f"{growth[-1]:.3g}")

cases = [{"size": size, "rule": rule, "motion": "overdamped"} for size, rule in ((2, "harmonic"), (20, "harmonic"), (20, "mean"))]
limits = [float(value) for value in re.findall(r"overdamped/sphere: .* of the stability limit (\S+)\n", run(cases).text)]
tables = run([{**case, "step": share * limit, "steps": round(900 / share)}
              for case, limit in zip(cases, limits, strict=True) for share in (0.9, 0.3)]).tables()
for n, (case, limit) in enumerate(zip(cases, limits, strict=True)):
    coarse, fine = tables[2 * n]["v_energy"], tables[2 * n + 1]["v_energy"]
    what = " ".join(f"{name} {value}" for name, value in case.items())
    deck.expect_close(f"{what}: limit {limit:.4g}, energy of the springs", coarse[200::100], fine[600::300], rtol=0.1)
    deck.expect("  which they still hold", fine[-1] > 0 and coarse[-1] > 0)
deck.finish()
