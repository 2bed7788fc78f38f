# ranks: 2
"""The example examples/sedimentation, shortened: a suspension that hinders, a cloud that hastens, and its figure."""
import re

import numpy as np

import deck


def settle(**variables):
    run = deck.run_example("sedimentation", **variables)
    words = open("scene.txt", encoding="ascii").read().split()
    return run.tables()[-1], np.loadtxt("settling.txt"), dict(zip(words[::2], map(float, words[1::2])))


t, steady, scene = settle(N=80, phi=0.2, until=2, outputs=20, frames=1)
deck.expect_close("80 spheres at 0.2: velocity", steady[-10:, 2].mean(), 0.25, rtol=0.25)
deck.expect_close("from rest to steady motion", scene["start"], steady[0, 2], rtol=0.03)
deck.expect("velocities scatter little", np.all(steady[:, 3] < 0.05), str(steady[:, 3].max()))
t, steady, scene = settle(N=60, phi=0.1, cloud=2, until=1.5, path=0.05, outputs=12, frames=3)
deck.expect("a cloud is faster than a sphere", np.all(steady[:, 2] > 2.5), str(steady[:, 2]))
text = deck.draw_example("sedimentation", "figure.png")
found, forces, alone = map(float, re.search(r"velocity (\S+), point forces (\S+), without images (\S+)", text).groups())
deck.expect_close("cloud: velocity of point forces in a periodic cell", found, forces, rtol=0.15)
deck.expect("which slows it down", forces < 0.8 * alone)
deck.expect_close("the last velocity is that of the run", float(re.search(r"at the end (\S+),", text).group(1)), t["v_settling"][-1], rtol=0.01)
deck.finish()
