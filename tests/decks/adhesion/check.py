# ranks: 1 2
"""Two spheres pressed together hold until the pull-off force k delta a: a dry cycle against its closed form, a wet sphere
that hangs on another or falls, and a restart while it is being pulled."""
import numpy as np

import deck

# dry: asperities k and bulk g in series, a harmonic; the contact breaks where its gap u exceeds (eps + delta) a
g, k, a, eps, delta = 1000, 400, 2 * 0.5 * 1.0 / 1.5, 0.03, 0.01
series, breaks = g * k / (g + k), (eps + delta * (1 + k / g)) * a


def cycle(**variables):
    t = deck.run("in.cycle", **variables).thermo()
    return t["c_sum[2]"], t["c_sum[3]"], t["c_sum[1]"], t["c_sum[5]"], t["c_sum[4]"]


un, force, energy, state, film = cycle(un=-0.006, v=1.0)
held = un < breaks
deck.expect("breaks inside the run", 0 < held.sum() < un.size)
deck.expect_close("pulled apart: k g/(k + g) (eps a - un) until it breaks", force, np.where(held, series * (eps * a - un), 0), atol=1e-9)
deck.expect_close("largest pull = k delta a", -force.min(), k * delta * a, rtol=2e-2)
deck.expect_close("energy = work of the springs", energy, np.where(held, 0.5 * series * (eps * a - un) ** 2, 0), atol=1e-9)
deck.expect("in contact until it breaks", np.array_equal(state > 0, held))
deck.expect("no film", np.all(film == 0))
lost = np.sum(0.5 * (force[1:] + force[:-1])[un[1:] > eps * a] * np.diff(un)[un[1:] > eps * a])

un, force, energy, state, film = cycle(un=0.09, v=-1.0, steps=900)
touch = un < eps * a
deck.expect_close("approaching: nothing before the asperities touch", force, np.where(touch, series * (eps * a - un), 0), atol=1e-9)
deck.expect("touches inside the run", 0 < touch.sum() < un.size)
# what the branches differ by: (1/2) k delta^2 a^2 of the asperities and (k/g) of that in the bulk, lost at the break
deck.expect_close("energy lost in the cycle", -lost, 0.5 * k * (delta * a) ** 2 * (1 + k / g), rtol=3e-2)

# wet: weight below and above the pull-off force k delta a = 10
t = deck.run("in.hanging", weight=6.0).thermo()
W = np.hypot(6.0, 0.3)    # of the forces down and sideways
deck.expect_close("hangs at u = eps a + W/k", t["c_sum[1]"][-1], 0.05 + W / 500, atol=1e-7)
deck.expect_close("and un = u + W/g", t["c_sum[2]"][-1], 0.05 + W / 500 + W / 1000, atol=1e-7)
deck.expect_close("the asperities carry the weight", t["c_sum[3]"][-1], -W, rtol=1e-5)
pulled = t["c_sum[3]"] <= 0
deck.expect("tension has no friction", np.all(t["c_sum[5]"][pulled] == 0) and pulled.sum() > 100)
deck.expect("pressed, there is friction", np.all(t["c_sum[5]"][~pulled][1:] > 0) and np.sum(~pulled) > 1)
deck.expect("it is pulled at the restart", np.all(t["c_sum[3]"][80:] < 0), f"{t['c_sum[3]'][80]:.3g}")
for step in 80, 480:
    again = deck.run("in.hanging", weight=6.0, part="again", file=f"half.restart.{step}", dump="again.dump")
    a_, b_ = deck.read_dump("straight.dump"), deck.read_dump("again.dump")
    deck.expect(f"restart at {step}: bit for bit", all(np.array_equal(a_[c], b_[c]) for c in a_),
                f"{max(np.max(np.abs(a_[c] - b_[c])) for c in a_):.1e}")

t = deck.run("in.hanging", weight=12.0, steps=200).thermo()
u, contact, state = t["c_sum[1]"], t["c_sum[3]"], t["c_sum[6]"]
deck.expect("beyond the pull-off force it falls", u[-1] > 0.3, f"{u[-1]:.3g}")
deck.expect("never a pull above k delta a", contact.min() > -10.0 and contact.min() < -9.0, f"{contact.min():.4g}")
gone = int(np.argmax(state == 0))
deck.expect("once broken it does not come back", gone > 0 and np.all(state[gone:] == 0) and np.all(contact[gone:] == 0))
deck.expect("broken at u = (eps + delta) a", u[gone - 1] <= 0.07 < u[gone] + 1e-12, f"{u[gone - 1]:.5g} {u[gone]:.5g}")
deck.finish()
