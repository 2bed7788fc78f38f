# ranks: 2
"""The example examples/microstructure, shortened: contacts lie in the direction of compression and carry the stress."""
import numpy as np

import deck

deck.run_example("microstructure", N=300, transient=0.6, strain=0.4, sampling=0.04)
data = np.loadtxt("circle.txt", skiprows=4)[:, 1:]
angle, contacts, vn = data[:, 0], data[:, 2], data[:, 7]
compression = angle > np.pi / 2
deck.expect("most contacts are in compression", contacts[compression].sum() > 0.6 * contacts.sum(),
            f"{contacts[compression].sum() / contacts.sum():.3f}")
approach, part = vn[compression].sum(), vn[~compression].sum()
deck.expect("pairs approach in compression and part in extension", approach < 0 < part, f"{approach:.3f} {part:.3f}")
sums = data[:, 9:13].sum(axis=0) * 2 * np.pi / len(angle)
deck.expect_close("stresses add up", sums, np.loadtxt("yx.txt", skiprows=4)[:4, 1], rtol=1e-7)
z = np.loadtxt("contacts.txt")[-1, 2]
deck.expect("Z between 2 and 4", 2 < z < 4, f"{z:.2f}")
deck.expect("contact fabric xy is negative", np.loadtxt("contacts.txt")[-1, 20] < 0)
deck.draw_example("microstructure", "figure.png", "distributions.png")
deck.finish()
