"""A run of 10^8 steps in miniature: thousands of rebuilds of the neighbor list, restart files, many runs, many systems in
one input. What the process occupies must not grow once it has all its arrays: less than a byte for each particle and
rebuild, or 0.2 % of what a system of the same input takes.
"""
import re

import deck


def occupied(text):
    """Memory that the process has taken from the system after each run, Mbyte."""
    return [float(size) for size in re.findall(r"Current reserved memory pool size: ([0-9.]+) Mbyte", text)]


def judge(what, sizes, limit):
    print(f"{what}: {sizes}")
    grown = sizes[-1] - sizes[len(sizes) // 2]    # in the second half
    deck.expect(f"{what}: Mbyte grown in the second half, at most {limit:.3g}", grown <= limit, f"{grown:.3g}")


N, STEPS = 60, 2000
deck.make_state(N=N)
for reach in ("cut 0.5", "voronoi 0.5"):
    steps = STEPS if "cut" in reach else STEPS // 10
    sizes = occupied(deck.run("in.rebuild", range=reach, runs=6, steps=steps).text)
    judge(f"rebuilds, {reach}", sizes, 1e-6 * N * 2 * steps)
sizes = occupied(deck.run("in.clear", runs=40).text)
judge("systems", sizes, 20 * 0.002 * sizes[0])
deck.finish()
