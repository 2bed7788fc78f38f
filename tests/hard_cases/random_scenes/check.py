# ranks: 1 2
"""What must hold in any scene: momentum, angular momentum and the balance of energy; heat of no mode is negative; gaps are
positive, friction is within Coulomb's cone, without film and adhesion nothing attracts; and a scene that is turned, shifted,
set in motion, renumbered, run without Newton's third law or on other ranks is the same scene.

Forty random scenes (scenes.py), all in one run of LAMMPS; what fails prints its seed and its laws.
"""
from pathlib import Path

import numpy as np
from scenes import Scene

import deck

STEPS = 800
SCENES = [Scene(seed) for seed in range(100, 140)]
ORIGINS = ("contact/normal", "contact/tangential", "squeeze", "shear", "roll", "twist", "repulsion", "drag", "kinetic")


def simulate(scenes, prefix, ranks):
    """Thermo table and final state of each."""
    names = [f"{prefix}{scene.seed}" for scene in scenes]
    text = "".join(scene.write(name, STEPS) for scene, name in zip(scenes, names))
    Path(f"in.{prefix}").write_text(text)
    run = deck.run(Path(f"in.{prefix}").resolve(), ranks=ranks)
    return run.tables(), [deck.read_dump(f"{name}.dump") for name in names]


def vectors(dump, names):
    return np.array([dump[name] for name in names.split()]).T


def momenta(scene, x, v, omega):
    inertia = (0.5 if scene.disc else 0.4) * scene.mass * scene.radius**2
    P = np.sum(scene.mass[:, None] * v, axis=0)
    L = np.sum(scene.mass[:, None] * np.cross(x, v) + inertia[:, None] * omega, axis=0)
    return P, L


def read_pairs(name):
    rows = [line.split() for line in Path(name).read_text().splitlines() if not line.startswith("ITEM") and line.count(" ") > 6]
    return np.array(rows, dtype=float).T if rows else np.zeros((9, 0))


class Worst:
    """Largest value of each check over its limit, and where."""

    def __init__(self):
        self.of = {}

    def see(self, what, value, limit, scene):
        share = value / limit if np.isfinite(value) else np.inf
        if share > self.of.get(what, (-np.inf,))[0]:
            self.of[what] = (share, value, scene)

    def judge(self):
        for what, (share, value, scene) in self.of.items():
            good = share <= 1
            deck.expect(what, good, f"worst {value:.2e}, {share:.2g} of the limit, " + (f"seed {scene.seed}" if good else scene.words()))


worst = Worst()
seen = np.zeros(4)    # contacts, those that slip, pairs that attract, all
if deck.RANKS == 1:
    tables, states = simulate(SCENES, "plain", 1)
    _, others = simulate([scene.moved() for scene in SCENES], "moved", 1)
    for scene, table, state, moved_state in zip(SCENES, tables, states, others, strict=True):
        x, v, omega = vectors(state, "x y z"), vectors(state, "vx vy vz"), vectors(state, "omegax omegay omegaz")
        speed = np.max(np.linalg.norm(scene.v, axis=1) + scene.radius * np.linalg.norm(scene.omega, axis=1))
        size = np.sum(scene.mass) * speed
        before, after = momenta(scene, scene.x, scene.v, scene.omega), momenta(scene, x, v, omega)
        worst.see("momentum", np.max(np.abs(after[0] - before[0])), 1e-12 * size, scene)
        worst.see("angular momentum", np.max(np.abs(after[1] - before[1])), 1e-11 * size, scene)

        heat = np.array([np.cumsum(table[f"c_p[{m}][1]"]) * scene.dt for m in range(1, 10)])
        energy = sum(table[f"c_p[{m}][2]"] for m in range(1, 10))
        peak = np.max(energy)
        defect = energy + np.sum(heat, axis=0) - energy[0]
        worst.see("energy is never made", np.max(defect), 1e-3 * peak, scene)
        if scene.rule == "shifted":    # with cut, pairs that leave take what their springs hold
            worst.see("the balance of energy closes", np.max(np.abs(defect)), 1e-3 * peak, scene)
        for origin, lost in zip(ORIGINS, heat):
            worst.see(f"heat of {origin} is not negative", -np.min(lost), 1e-3 * peak, scene)

        one, two, _, u, contact, film, friction, shear, repulsion = read_pairs(f"plain{scene.seed}.pairs")
        mu = np.sqrt(np.take(scene.mu, one.astype(int) - 1) * np.take(scene.mu, two.astype(int) - 1))
        load = np.maximum(0, contact)
        worst.see("gaps are positive", -np.min(u, initial=1), 1e-300, scene)
        little = 1e-9 * np.max(load, initial=0) + 1e-300
        worst.see("friction within Coulomb", np.max(friction - mu * load, initial=0), little, scene)
        if not scene.shear:
            worst.see("without film all of the shear is friction", np.max(shear, initial=0), little, scene)
        if not scene.squeeze and not scene.adhesion:
            worst.see("without film and adhesion nothing attracts", -np.min(contact + film, initial=0), 1e-300, scene)
        worst.see("repulsion repels", -np.min(repulsion, initial=0), 1e-300, scene)

        moved = scene.moved()
        back = np.argsort(moved.order)
        drift = moved.shift + STEPS * scene.dt * moved.boost
        compared = (("positions", 1e-9, "x y z", x, drift), ("velocities", 1e-6 * speed, "vx vy vz", v, moved.boost),
                    ("spins", 1e-6 * speed / np.min(scene.radius), "omegax omegay omegaz", omega, 0))
        for what, limit, found, mine, move in compared:
            there = (vectors(moved_state, found)[back] - move) @ moved.turn
            worst.see(f"turned, shifted, boosted, renumbered: {what}", np.max(np.abs(there - mine)), limit, scene)
        slips = (load > 0) & (friction > 0) & (friction > 0.999 * mu * load)
        seen += [np.sum(contact > 0), np.sum(slips), np.sum(contact + film < 0), len(u)]
    print(f"{len(SCENES)} scenes, {sum(len(s.x) for s in SCENES)} particles, {sum(s.dim == 2 for s in SCENES)} in 2d, "
          f"{sum(s.eta == 0 for s in SCENES)} dry")
    deck.expect("contacts, slipping ones, attraction, pairs seen", np.all(seen > [1000, 200, 2000, 20000]), str(seen.astype(int)))
else:
    some = SCENES[::3]
    _, one = simulate(some, "one", 1)
    _, many = simulate(some, "many", deck.RANKS)
    for scene, a, b in zip(some, one, many, strict=True):
        for names, limit in ("x y z", 1e-9), ("vx vy vz", 1e-6), ("omegax omegay omegaz", 1e-6):
            scale = max(1e-300, np.max(np.abs(vectors(a, names))))
            worst.see(f"other ranks: {names}", np.max(np.abs(vectors(a, names) - vectors(b, names))), limit * scale, scene)
worst.judge()
deck.finish()
