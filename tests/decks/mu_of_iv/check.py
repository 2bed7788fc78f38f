# ranks: 1
"""The example examples/mu_of_iv, shortened: its study runs, resumes, and finds phi(Iv) and mu(Iv) near the laws."""
import csv
import subprocess
import sys
from pathlib import Path

import deck

study = deck.ROOT / "examples" / "mu_of_iv" / "study.py"
Path("short.csv").unlink(missing_ok=True)
command = [sys.executable, str(study), "--particles", "200", "--strain", "3", "--friction", "0.5", "--jobs", "1",
           "--table", "short.csv", "--Iv"]
for iv in (["1"], ["0.1", "1"]):    # the second time only what is missing
    done = subprocess.run(command + iv, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    print(done.stdout)
    deck.expect("study runs", done.returncode == 0)
with open("short.csv", encoding="ascii") as file:
    rows = {row["Iv"]: row for row in csv.DictReader(file)}
deck.expect("one row a case", sorted(rows) == ["0.1", "1"])
# 200 particles over two strain units: a few per cent; at Iv = 1 long-range hydrodynamics is missing, see the example
deck.expect_close("phi at 0.1", float(rows["0.1"]["phi"]), 0.445, atol=0.015)
deck.expect_close("mu at 0.1", float(rows["0.1"]["mu"]), 1.2, atol=0.15)
deck.expect_close("phi at 1", float(rows["1"]["phi"]), 0.355, atol=0.025)
deck.expect("figure is drawn", Path("short.png").stat().st_size > 1e4)
deck.finish()
