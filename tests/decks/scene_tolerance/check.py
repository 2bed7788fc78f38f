"""The promise of suspension_scene tolerance: its deck lines give the viscosity that it promises."""
import re
import sys
from pathlib import Path

import deck

sys.path.insert(0, str(deck.ROOT / "benchmarks" / "accuracy_cost"))
import suspension_laws    # noqa: E402  pylint: disable=wrong-import-position
from suspension import SETTLED    # noqa: E402  pylint: disable=wrong-import-position

TOLERANCE = 0.2
# the converged viscosity of the scene, from all runs of the benchmark
rows, _ = suspension_laws.read()
reference, doubt = suspension_laws.converged(rows)
deck.expect("the reference is known five times better", doubt < 0.2 * TOLERANCE, f"{reference:.2f} +- {100 * doubt:.1f} %")


def advice(**variables):
    text = deck.run("in.tolerance", **variables).text
    return text[text.index("Settings for a viscosity"):]


def number(text, what):
    return float(re.search(what + r" +(\S+)", text).group(1))


# the lines do not depend on what the deck had before: stiffness and density are theirs
text = advice(tolerance=TOLERANCE)
particles = int(number(text, "few particles, N"))
lines = text[text.index("Deck lines to use\n"):].splitlines()[1:]
lines = [line for line in lines if line.startswith("  ")]
other = advice(tolerance=TOLERANCE, stiffness="3e6", stokes="0.2")
deck.expect("the same from another stiffness and density", re.findall(r"run \d+", other) == re.findall(r"run \d+", text) or
            abs(number(other, "CPU seconds") - number(text, "CPU seconds")) < 0.1, other)
Path("proposed.lmp").write_text("\n".join(lines) + "\n", encoding="ascii")
print("\n".join(lines))

for seed in (4711, 11):
    deck.run("in.tolerance", N=particles, proposed="proposed.lmp", seed=seed)
    data = deck.read_stress()
    settled = data["v_gamma"] > SETTLED
    eta = data["v_sxy"][settled].mean()
    deck.expect_close(f"seed {seed}: viscosity within the tolerance", eta, reference, rtol=TOLERANCE)
    # what was run is what was promised: strain, and time step below the limit
    deck.expect_close("strain averaged", data["v_gamma"][-1], 2 + number(text, "scatter, strain averaged"), rtol=0.03)

# less costs more, too little cannot be had, and what lies beyond the model is said
costs = [float(re.search(r"cost: (\S+)", advice(tolerance=t)).group(1)) for t in (0.3, 0.1)]
deck.expect("a smaller tolerance costs more", costs[1] > 2 * costs[0], str(costs))
deck.expect("too small a tolerance is refused", "cannot promise" in advice(tolerance=1e-4))
deck.expect("the model is not an experiment", "not known to be within 15 % of an experiment" in advice(tolerance=0.1))
deck.expect("no fluid", "cannot tell" in advice(words="viscosity 0"))
deck.expect("other friction", "measured with friction 0.5" in advice(words="friction 0.1"))
deck.finish()
