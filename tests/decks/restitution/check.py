# ranks: 1 2 4
"""Two dry grains part with the share e of their velocity, whatever they weigh; what they lose is heat of the contact."""
import numpy as np
from scipy.optimize import brentq

import deck


def bounce(**variables):
    """Share of the relative velocity that is left, and the table."""
    t = deck.run("in.bounce", **variables).thermo()
    return -t["v_v"][-1] / t["v_v"][0], t


# second order in the step: 63 steps a period leave errors below 0.002, 252 below 0.0002
for case in ({"dim": 3}, {"dim": 2, "heavy": 5.0, "size": 0.4, "angle": 30}, {"heavy": 0.02, "size": 3.0, "angle": 100},
             {"roughness": 0.02, "size": 0.5}, {"films": ["squeeze", "no", "shear", "no", "roll", "no", "twist", "no"], "dim": 2},
             {"units": "metal", "ftm2v": 1.0 / 1.0364269e-4}) if deck.RANKS == 1 else ({"dim": 2, "heavy": 3.0},):
    case = {name: " ".join(value) if isinstance(value, list) else value for name, value in case.items()}
    for e in (0.1, 0.5, 0.9):
        got, t = bounce(e=e, **case)
        deck.expect_close(f"{case}: e", got, e, atol=2e-3)
        got, _ = bounce(e=e, part=0.25, **case)
        deck.expect_close("    in shorter steps", got, e, atol=2e-4)
        deck.expect("    never attracts", np.all(t["v_fn"] >= -1e-12 * t["v_fn"].max()))
        # heat of the normal contact and of nothing else; while a force acts the kinetic energy of the step has an error of second order
        heat = np.cumsum(t["c_p[1][1]"] * t["Dt"])
        lost = t["KinEng"][0] - t["KinEng"] - t["PotEng"]
        deck.expect("    no film", np.all(t["c_p[3][1]"] == 0) and np.all(t["c_stress[3][1]"] == 0))
        deck.expect_close("    heat", heat, lost, atol=0.04 * lost[-1])
        # without films a pair is not known in the step in which it parts
        deck.expect_close("    after the contact", heat[-1], lost[-1], rtol=0.02 if "films" in case else 1e-9)

got, t = bounce(e=1.0)
deck.expect_close("e = 1 is elastic", got, 1.0, atol=2e-3)

# who is asked in a step sees the forces of the run, and changes nothing
got, t = bounce(e=0.3, look="yes")
plain, u = bounce(e=0.3)
deck.expect("asking for pairs changes nothing", np.array_equal(t["v_v"], u["v_v"]))
deck.expect_close("force of compute pair/local", t["v_pushed"], t["v_fn"], atol=1e-12)
for way in ({"way": "hybrid"}, {"newton": "off"}):
    other, u = bounce(e=0.3, **way)
    deck.expect(f"{way} gives the same", np.array_equal(t["v_v"], u["v_v"]) and other == got)

# the dashpot is in the restart file
straight = deck.run("in.bounce", e=0.3).thermo()
again = deck.run("in.again", dt=f"{straight['Dt'][0]:.17g}").thermo()
deck.expect("they touch at the restart", straight["PotEng"][20] > 0)
deck.expect_close("restart in a contact", again["v_v"], straight["v_v"][20:], atol=1e-15)

# beside a film of next to no viscosity nothing changes; a real one takes more
thin, _ = bounce(e=0.5, roughness=0.02, wet=1e-9)
deck.expect_close("a film of no viscosity", thin, 0.5, atol=3e-3)
wet, t = bounce(e=0.5, roughness=0.02, wet=0.05)
alone, _ = bounce(e=1.0, roughness=0.02, wet=0.05)
deck.expect("beside a film the dashpot adds to it", wet < alone - 0.1 and wet < 0.5, f"{wet:.3g} {alone:.3g}")
deck.expect("    heat of both", np.sum(t["c_p[1][1]"]) > 0 and np.sum(t["c_p[3][1]"]) > 0)

# a row of grains of mass 1 and stiffness K = 1000: in its fastest motion neighbors move against each other, which is stable for
# dt^2 (K + 2 Z/dt) <= 1, Z being the resistance of the step; the reduced mass is 1/2
K, m = 1000.0, 0.5
for e in (0.02, 0.3, 0.9):
    beta = brentq(lambda b, e=e: 2 * b * (np.arccos(b) / np.sqrt(1 - b * b) if b < 1 else np.arccosh(b) / np.sqrt(b * b - 1)) + np.log(e), 1e-9, 50)

    def excess(dt):
        zeta = 2 * beta * np.sqrt(m * K)
        c = zeta * dt / m
        Z = min(zeta / (np.sqrt(1 + c * c / 16) + c / 4), m / dt)
        return dt * dt * (K + 2 * Z / dt) - 1

    limit = brentq(excess, 1e-6, 0.1)
    for factor, calm in ((0.97, True), (1.03, False)):
        run = deck.run("in.chain", e=e, dt=f"{factor * limit:.17g}")
        kinetic = run.thermo()["KinEng"]
        deck.expect(f"row of grains, e = {e}, {factor} of the limit {limit:.4g}: {'calm' if calm else 'not calm'}",
                    kinetic.max() < 2 * kinetic[0] if calm else kinetic.max() > 100 * kinetic[0], f"{kinetic.max() / kinetic[0]:.2g}")
        deck.expect("    and the log knows", ("exceeds" in run.text) != calm)

# many grains
deck.make_state(dim=2, phi=0.75)
dry = {"dim": 2, "steps": 400, "coeffs": "friction coulomb 0.5 restitution 0.5", "keywords": "squeeze no shear no roll no twist no"}
gas = deck.run("in.gas", out="gas.dump", **dry).thermo()
a = deck.read_dump("gas.dump")
for name, other in (("newton off", {"newton": "off"}), ("one rank", {"ranks": 1}), ("squeeze yes, viscosity 0", {"keywords": "shear no roll no twist no"})):
    deck.run("in.gas", out="other.dump", **{**dry, **other})
    b = deck.read_dump("other.dump")
    for column in ("yu", "vx", "vy", "omegaz", "fx", "tqz"):
        deck.expect_close(f"{name}: {column}", b[column], a[column], atol=1e-8 * np.sqrt(np.mean(a[column] ** 2)))


def balance(part):
    steps = int(400 / part)
    t = deck.run("in.gas", timestep=5e-4 * part, **{**dry, "steps": steps}).thermo()
    put, heat = t["c_p"], sum(t[f"c_p[{m}][1]"] for m in (1, 2, 3, 9))
    stored = sum(t[f"c_p[{m}][2]"] for m in (1, 2, 3, 9))
    work = np.cumsum(0.5 * (put[1:] + put[:-1])) * 5e-4 * part
    lost = np.cumsum(heat[1:]) * 5e-4 * part
    share = np.sum(t["c_p[1][1]"]) * 5e-4 * part / np.max(np.abs(work))
    return np.max(np.abs(work - lost - stored[1:] + stored[0])) / np.max(np.abs(work)), share


coarse, share = balance(1.0)
fine, _ = balance(0.25)
deck.expect("the balance of energy closes", fine < max(0.3 * coarse, 1e-4), f"{coarse:.1e} {fine:.1e}, share of the dashpot {share:.2g}")
deck.expect("the dashpot takes part", share > 0.02, f"{share:.2g}")
deck.finish()
