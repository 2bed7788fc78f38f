# ranks: 1
"""tools/flow_curve.py with LAMMPS: two viscous numbers to a tolerance, resumed, and a deck that cannot be run."""
import csv
import subprocess
import sys
from pathlib import Path

import deck

for old in ("curve.csv", "curve.png"):
    Path(old).unlink(missing_ok=True)


def call(*words):
    done = subprocess.run([sys.executable, str(deck.ROOT / "tools" / "flow_curve.py"), *words, "--table", "curve.csv"],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    print(done.stdout)
    return done


words = ["pressure_shear", "Iv", "1", "0.1", "--set", "N=60", "phi=0.4", "--tolerance", "0.1", "--max-strain", "25"]
deck.expect("it runs", call(*words).returncode == 0)
with open("curve.csv", encoding="ascii") as file:
    rows = {row["value"]: {k: float(v) for k, v in row.items() if k not in ("deck", "settings", "variable", "outcome")}
            for row in csv.DictReader(file)}
slow, fast = rows["0.1"], rows["1"]
for value, row in rows.items():
    deck.expect(f"Iv {value}: tolerance reached", row["viscosity_error"] <= 0.1 * row["viscosity"], row["viscosity_error"])
    # over few units of strain the mean pressure misses by (change of ln V)/strain, see deck.pressure_shear
    deck.expect_close(f"Iv {value}: pressure", -row["syy"], 1.0, atol=0.04)
    deck.expect_close(f"Iv {value}: rate", row["rate"], float(value), rtol=1e-6)
# mu(Iv) of Boyer 1.244, 3.21 and Chevremont 1.078, 3.4; sixty particles scatter by 10 %
deck.expect("friction at Iv = 0.1", 0.95 < slow["stress"] < 1.45, slow["stress"])
deck.expect("friction at Iv = 1", 2.6 < fast["stress"] < 4.2, fast["stress"])
deck.expect("it dilates with the rate", fast["phi"] < slow["phi"] - 0.05, f"{fast['phi']} {slow['phi']}")
deck.expect("the figure is drawn", Path("curve.png").stat().st_size > 1e4)

again = call(*words)
deck.expect("nothing is repeated", again.returncode == 0 and again.stdout.count("in the table (tolerance)") == 2)
refused = call("pressure_shear", "Iv", "0.5", "--set", "N=60", "phi=0.4", "friction=-1")
deck.expect("what LAMMPS says is shown", refused.returncode == 1 and "Iv 0.5: FAILED: LAMMPS stopped: ERROR" in refused.stdout)
deck.finish()
