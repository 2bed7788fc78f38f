# ranks: 1
"""The example examples/yield_stress, shortened: adhesion gives a stress that does not sink with the rate, and stops creep."""
import subprocess
import sys
from pathlib import Path

import numpy as np

import deck

ORIGIN = deck.ROOT / "examples" / "yield_stress"
# contacts have to meet before they stick: adhesion builds up over a strain of about two
stress = {}
for adhesion in ("0", "4e-3"):
    deck.run_example("yield_stress", N=100, adhesion=adhesion, rate=1e-3, strain=1.6)
    data = deck.read_stress()
    stress[adhesion] = data["v_sxy"][data["v_gamma"] > 1.2].mean()
deck.expect("more than twice as stiff with adhesion", stress["4e-3"] > 2 * stress["0"], str(stress))

rates = {}
for applied in (0.08, 1.0):    # the yield stress is 0.02 to 0.03 pull-off forces of 4
    deck.run_example("yield_stress", N=100, adhesion="4e-3", rate=1e-3, strain=0.8, stress=applied, steps=12000)
    data = deck.read_stress()
    rates[applied] = data["v_gamma_dot"][-10:].mean()
deck.expect("creep stops under a small stress", abs(rates[0.08]) < 1e-5, f"{rates[0.08]:.2e}")
deck.expect("flows under a large one", rates[1.0] > 1e-3, f"{rates[1.0]:.2e}")

for name in ("short.csv", "creep.csv"):
    Path(name).unlink(missing_ok=True)
done = subprocess.run([sys.executable, str(ORIGIN / "study.py"), "--particles", "80", "--strain", "0.3", "--rates", "0.01",
                       "0.003", "--adhesion", "0", "1e-3", "--stress", "0.5", "--steps", "2000", "--table", "short.csv",
                       "--creep", "creep.csv"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
print(done.stdout)
deck.expect("study runs", done.returncode == 0)
deck.expect("figure is drawn", Path("figure.png").stat().st_size > 1e4)
deck.expect("no number is lost", np.all(np.isfinite(list(stress.values()) + list(rates.values()))))
deck.finish()
