# ranks: 1
"""The example examples/binary_mixture, shortened: rough pairs alone rub, smooth particles make it denser; its study."""
import csv
import subprocess
import sys
from pathlib import Path

import deck

study = deck.ROOT / "examples" / "binary_mixture" / "study.py"
Path("short.csv").unlink(missing_ok=True)
command = [sys.executable, str(study), "--particles", "150", "--strain", "2", "--Iv", "0.1", "--table", "short.csv", "--x"]
for x in (["0"], ["0", "0.5", "1"]):    # the second time only what is missing
    done = subprocess.run(command + x, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    print(done.stdout)
    deck.expect("study runs", done.returncode == 0)
with open("short.csv", encoding="ascii") as file:
    rows = {row["x"]: {name: float(value) for name, value in row.items()} for row in csv.DictReader(file)}
deck.expect("one row a case", sorted(rows) == ["0", "0.5", "1"])
deck.expect_close("chi_f", [rows[x]["chi_f"] for x in ("0", "0.5", "1")], [0, 0.25, 1], atol=0.04)
# the whole range is 0.07; 150 particles over one strain unit or two are good to 0.01
phi = [rows[x]["phi"] for x in ("0", "0.5", "1")]
deck.expect("the smoother, the denser", phi[0] > phi[1] > phi[2] and phi[0] > phi[2] + 0.03, str(phi))
deck.expect("figure is drawn", Path("figure.png").stat().st_size > 1e4)
deck.finish()
