"""Friction by the load of two dry spheres dragged along each other, by law and load; a mixture of rough and smooth spheres."""
import numpy as np

import deck

MU, F = 0.8, 10.0
LAWS = {    # friction at the normal force N
    "clm step": lambda N, mu, F: mu * N * (N >= F),
    "clm shift": lambda N, mu, F: mu * np.maximum(0, N - F),
    "clm ramp": lambda N, mu, F: mu * N * np.minimum(1, N / F),
    "brizmer": lambda N, mu, F: mu * N / np.tanh(mu * (N / F) ** 0.35),
}


def drag(**variables):
    t = deck.run("in.drag", **variables).thermo()
    return t["Step"] * 1e-4, *(t[f"c_sum[{n}]"] for n in range(1, 6))


for law, friction in LAWS.items():
    for load in 4.0, 15.0, 40.0:
        s, un, N, fx, held, state = drag(load=load, law=law, critical=F)
        what = f"{law}, load {load:g}"
        deck.expect_close(f"{what}: normal force", N, 500 * (0.05 - un), rtol=1e-9)
        limit = friction(N, MU, F)
        # sticking: kt times the way, as the pair turns by less than 2.5 %
        deck.expect_close(f"{what}: friction", held, np.minimum(1000 * s, limit), rtol=1e-3, atol=1e-9)
        slips = 1000 * s > 1.01 * limit
        deck.expect(f"{what}: it slips in the end", slips.sum() > 100)
        deck.expect_close(f"{what}: slipping", held[slips], limit[slips], rtol=1e-9, atol=1e-12)
        deck.expect(f"{what}: states", np.all(state[slips] == 2) and np.all(state[1:][1000 * s[1:] < 0.99 * limit[1:]] == 1))
        deck.expect(f"{what}: friction is all", np.allclose(np.abs(fx), held, rtol=1e-3, atol=1e-12))

# critical load 0 is Coulomb's law
for law in LAWS:
    s, un, N, fx, held, state = drag(load=4.0, law=law, critical=0.0)
    deck.expect_close(f"{law} without critical load", held[-100:], MU * N[-100:], rtol=1e-9)

# mixture: mu_ij = sqrt(mu_i mu_j), F*_ij = sqrt(F*_i F*_j); a smooth partner takes friction away
for law, friction in LAWS.items():
    s, un, N, fx, held, state = drag(load=15.0, law=law, critical=F, i=1, j=2)
    deck.expect(f"{law}: rough on smooth is frictionless", np.all(held == 0) and np.all(fx == 0) and np.all(N > 0))
    s, un, N, fx, held, state = drag(load=40.0, law=law, critical=F, i=3, j=1)
    deck.expect_close(f"{law}: two rough kinds", held[-100:], friction(N, 0.4, 2 * F)[-100:], rtol=1e-9)
deck.finish()
