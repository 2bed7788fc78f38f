# ranks: 1
"""The example examples/discs_2d, shortened: its study runs, the pressure is held, friction and area fraction are near those
of the table that it comes with.
"""
import csv
import subprocess
import sys
from pathlib import Path

import deck

folder = deck.ROOT / "examples" / "discs_2d"
Path("short.csv").unlink(missing_ok=True)
done = subprocess.run([sys.executable, str(folder / "study.py"), "--particles", "200", "--strain", "4", "--friction", "0.4",
                       "--jobs", "1", "--table", "short.csv", "--J", "0.1", "--I", "0.3"],
                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
print(done.stdout)
deck.expect("study runs", done.returncode == 0)


def read(name):
    with open(name, encoding="ascii") as file:
        return {row["regime"]: row for row in csv.DictReader(file)
                if row["friction"] == "0.4" and row["number"] == {"viscous": "0.1", "inertial": "0.3"}[row["regime"]]}


short, full = read("short.csv"), read(folder / "discs_2d.csv")
for regime in "viscous", "inertial":
    # 200 discs over some strain units: of the order of 5 % in mu
    deck.expect_close(f"{regime}: pressure", float(short[regime]["p"]), 1.0, atol=0.03)
    deck.expect_close(f"{regime}: phi", float(short[regime]["phi"]), float(full[regime]["phi"]), atol=0.02)
    deck.expect_close(f"{regime}: mu", float(short[regime]["mu"]), float(full[regime]["mu"]), rtol=0.15)

# the table of the example: contacts of both regimes are the same, so that one law holds for both
sys.path[:0] = [str(folder), str(folder.parent / "scene")]
import cases
import plot

for friction in "0", "0.4":
    found = plot.collapse(cases.read(folder / "discs_2d.csv"), friction)
    deck.expect(f"one law phi(J + alpha I^2), friction {friction}", found and abs(found[2]["fvec"]).max() < 0.003,
                f"{abs(found[2]['fvec']).max():.4f}")
deck.expect("figure is drawn", Path("short.png").stat().st_size > 1e4)
deck.finish()
