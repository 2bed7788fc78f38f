# ranks: 1
"""The example examples/dilute_to_dense, shortened: its table and figure; what the far field adds at one volume fraction."""
import csv
import subprocess
import sys
from pathlib import Path

import deck

Path("study.csv").unlink(missing_ok=True)
words = ["--phi", "0.3", "--particles", "60", "--strain", "2", "--table", "study.csv"]
done = subprocess.run([sys.executable, str(deck.ROOT / "examples" / "dilute_to_dense" / "study.py"), *words],
                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
print(done.stdout)
deck.expect("study.py runs", done.returncode == 0)
with open("study.csv", encoding="ascii") as file:
    rows = {row["level"]: {k: float(v) for k, v in row.items() if k not in ("level", "rule")} for row in csv.DictReader(file)}
deck.expect_close("films alone have no stresslets", rows["none"]["stresslet"], 0.0, atol=0.0)
deck.expect_close("mean: 5/2 of the volume fraction", rows["mean"]["stresslet"], 2.5 * 0.3, rtol=1e-3)
for level in ("mean", "grid"):
    parts = sum(rows[level][name] for name in ("contact_n", "contact_t", "film_n", "film_t", "stresslet"))
    deck.expect_close(f"{level}: the parts are the whole", 1 + parts, rows[level]["eta_r"], rtol=0.03)    # but for inertia
# 500 particles: 2.0 with films alone, 3.3 in the laws; sixty scatter by 10 %
deck.expect("films alone are too thin", rows["none"]["eta_r"] < 2.4, rows["none"]["eta_r"])
for level in ("mean", "grid"):
    deck.expect(f"{level}: near the laws", 2.6 < rows[level]["eta_r"] < 3.9, rows[level]["eta_r"])
text = deck.draw_example("dilute_to_dense", "figure.png")
deck.expect("all levels are in it", text.count("phi 0.3") == 3)
deck.finish()
