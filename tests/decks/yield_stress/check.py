# ranks: 1
"""The example examples/yield_stress, shortened: adhesion gives a stress that does not sink with the rate, and stops creep."""
import subprocess
import sys
from pathlib import Path

import numpy as np

import deck

ORIGIN = deck.ROOT / "examples" / "yield_stress"
# contacts have to meet before they stick: adhesion builds up over a strain of one or two; the pull-off force is 4, the
# yield stress of large cells about 0.02 of it, of this small one more
RATE = 3e-3
flowing, after = {}, {}
for adhesion, applied in (("0", 0), ("4e-3", 0.08), ("4e-3", 4.0)):
    deck.run_example("yield_stress", N=100, adhesion=adhesion, rate=RATE, strain=1.5, stress=applied, steps=12000)
    data = deck.read_stress()
    before = data["v_gamma"] < 1.5
    flowing[adhesion] = data["v_sxy"][before & (data["v_gamma"] > 1.0)].mean()
    after[applied] = data["v_gamma_dot"][-8:].mean()
deck.expect("at least 1.5 times the stress with adhesion", flowing["4e-3"] > 1.5 * flowing["0"], str(flowing))
deck.expect("creep stops under a small stress", abs(after[0.08]) < 1e-2 * RATE, f"{after[0.08]:.2e}")
deck.expect("flows under a large one", after[4.0] > 0.3 * RATE, f"{after[4.0]:.2e}")

for name in ("short.csv", "creep.csv"):
    Path(name).unlink(missing_ok=True)
done = subprocess.run([sys.executable, str(ORIGIN / "study.py"), "--particles", "80", "--strain", "0.3", "--rates", "0.01",
                       "0.003", "--adhesion", "0", "1e-3", "--stress", "0.5", "--steps", "2000", "--before", "0.3",
                       "--table", "short.csv", "--creep", "creep.csv"],
                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
print(done.stdout)
deck.expect("study runs", done.returncode == 0)
deck.expect("figure is drawn", Path("figure.png").stat().st_size > 1e4)
deck.expect("no number is lost", np.all(np.isfinite(list(flowing.values()) + list(after.values()))))
deck.finish()
