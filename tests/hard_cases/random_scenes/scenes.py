"""Random small scenes: a cluster of spheres or discs, 2 to 40, with every law of the pair style drawn by its seed."""
import re

import numpy as np

BOX = 60.0    # half of it, length


def cluster(rng, n, dim):
    """Positions and radii: each sphere beside an earlier one, at a gap or a small overlap, none deeper."""
    radius = np.exp(rng.uniform(np.log(0.4), np.log(2.5), n))
    x = np.zeros((n, 3))
    m = 1
    while m < n:
        d = rng.normal(size=3)
        d[dim:] = 0
        partner = rng.integers(m)
        gap = rng.uniform(-0.02, 0.3) * min(radius[m], radius[partner])
        x[m] = x[partner] + (radius[m] + radius[partner] + gap) * d / np.linalg.norm(d)
        others = np.linalg.norm(x[:m] - x[m], axis=1) - radius[:m] - radius[m]
        m += bool(np.all(others > -0.02 * np.minimum(radius[:m], radius[m])))
    return x, radius


class Scene:
    def __init__(self, seed):
        rng = np.random.default_rng(seed)
        self.seed = seed
        self.dim = int(rng.choice([2, 3]))
        self.disc = self.dim == 2 and rng.random() < 0.5
        n = int(rng.integers(2, 8)) if rng.random() < 0.5 else int(rng.integers(8, 41))
        self.x, self.radius = cluster(rng, n, self.dim)
        self.density = np.exp(rng.uniform(np.log(0.1), np.log(10), n))
        self.mass = 4 / 3 * np.pi * self.density * self.radius**3
        self.type = rng.integers(1, 3, n)
        self.type[0] = 1
        self.laws(rng)
        g = self.stiffest
        self.dt = 0.1 * np.sqrt(np.min(self.mass) / (10 * g))
        # towards the middle and about; slow enough for overlaps of a few percent
        fast = self.radius * np.sqrt(g / self.mass) * np.exp(rng.uniform(np.log(3e-3), np.log(3e-2), n))
        inward = np.mean(self.x, axis=0) - self.x
        inward /= np.maximum(np.linalg.norm(inward, axis=1), 1e-3)[:, None]
        flat = np.array([1, 1, self.dim - 2])
        self.v = fast[:, None] * (rng.uniform(0, 1, (n, 1)) * inward + rng.uniform(-0.5, 0.5, (n, 3))) * flat
        upright = np.array([self.dim - 2, self.dim - 2, 1])
        self.omega = (fast / self.radius)[:, None] * rng.uniform(-1, 1, (n, 3)) * upright
        self.newton = str(rng.choice(["on", "off"]))

    def laws(self, rng):
        """pair_style and pair_coeff; the stiffest spring; mu by type."""
        hc = rng.uniform(0.3, 1.0)
        self.rule = str(rng.choice(["cut", "shifted"]))
        self.eta = 0.0 if rng.random() < 0.2 else np.exp(rng.uniform(np.log(1e-2), np.log(1e2)))
        modes = {mode: rng.random() < 0.8 for mode in ("squeeze", "shear", "roll", "twist")}
        self.squeeze = modes["squeeze"] and self.eta > 0
        self.shear = modes["shear"] and self.eta > 0
        self.style = f"lubcontact {self.eta:.6g} {self.rule} {hc:.6g} radius {rng.choice(['harmonic', 'mean'])}"
        self.style += "".join(f" {mode} {'yes' if on else 'no'}" for mode, on in modes.items())
        if modes["roll"] and rng.random() < 0.3:
            self.style += " rollcoeff 1.5"
        if modes["squeeze"] and rng.random() < 0.15:
            self.style += " gap euler"
        self.friction = str(rng.choice(["none", "coulomb", "clm step", "clm shift", "clm ramp"]))
        self.adhesion, repulsion = rng.random() < 0.3, rng.random() < 0.3
        self.coeffs, self.mu, self.stiffest = [], [], 0.0
        for kind in 1, 2:
            g, k, kt = 1e3 * np.exp(rng.uniform(np.log([0.3, 0.1, 0.1]), np.log([3, 10, 1])))
            eps = np.exp(rng.uniform(np.log(1e-3), np.log(3e-2)))
            smooth = not self.adhesion and rng.random() < 0.25
            mu, critical = round(rng.uniform(0, 1), 4), np.exp(rng.uniform(np.log(0.01), np.log(10)))
            words = f"{kind} {kind} {g:.6g} {kt:.6g} asperity {k:.6g} roughness {0.0 if smooth else eps:.6g}"
            words += f" friction {self.friction}"
            if self.friction != "none":
                words += f" {mu:.6g}" + (f" {critical:.6g}" if "clm" in self.friction else "")
            if self.adhesion:
                words += f" adhesion {0.3 * eps * min(1, g / k):.6g}"
            if repulsion:    # 1e-6 of it is left at the end of the range of the smallest pair
                words += f" repulsion {rng.uniform(0.1, 10):.6g} {hc * np.min(self.radius) / 14:.6g}"
            self.coeffs.append(words)
            self.mu.append(mu if self.friction != "none" else 0.0)
            self.stiffest = max(self.stiffest, g, kt)
        if self.squeeze and all("roughness 0 " in words for words in self.coeffs):    # friction that cannot act is refused
            self.coeffs = [re.sub(r" friction (none|coulomb \S+|clm \S+ \S+ \S+)", " friction none", words) for words in self.coeffs]
            self.friction, self.mu = "none", [0.0, 0.0]

    def words(self):
        return f"seed {self.seed}: N {len(self.x)} dim {self.dim} {self.style} | " + " | ".join(self.coeffs)

    def moved(self):
        """Turned, shifted, set in motion, in another order of the particles and with the other setting of newton."""
        rng = np.random.default_rng(self.seed + 10**6)
        other = Scene(self.seed)
        q, _ = np.linalg.qr(rng.normal(size=(3, 3)))
        q *= np.sign(np.linalg.det(q))
        if self.dim == 2:
            c, s = np.cos(1.0 + self.seed), np.sin(1.0 + self.seed)
            q = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
        flat = np.array([1, 1, self.dim - 2])
        other.turn, other.shift = q, rng.uniform(-5, 5, 3) * flat
        other.boost = np.max(np.linalg.norm(self.v, axis=1)) * rng.uniform(-1, 1, 3) * flat
        other.order = rng.permutation(len(self.x))    # other's particle m is self's order[m]
        for name in "x", "v", "omega":
            setattr(other, name, getattr(self, name)[other.order] @ q.T)
        other.x = other.x + other.shift
        other.v = other.v + other.boost
        for name in "radius", "density", "mass", "type":
            setattr(other, name, getattr(self, name)[other.order])
        other.newton = "off" if self.newton == "on" else "on"
        return other

    def write(self, name, steps):
        """Data file, and the lines of the deck."""
        with open(f"{name}.data", "w") as f:
            n, z = len(self.x), BOX if self.dim == 3 else 0.5
            f.write(f"scene\n\n{n} atoms\n2 atom types\n")
            f.write("".join(f"{-b} {b} {d}lo {d}hi\n" for d, b in zip("xyz", (BOX, BOX, z))) + "\nAtoms\n\n")
            for m in range(n):
                f.write(f"{m + 1} {self.type[m]} {2 * self.radius[m]:.17g} {self.density[m]:.17g} "
                        + " ".join(f"{c:.17g}" for c in self.x[m]) + "\n")
            f.write("\nVelocities\n\n")
            for m in range(n):
                f.write(f"{m + 1} " + " ".join(f"{c:.17g}" for c in (*self.v[m], *self.omega[m])) + "\n")
        columns = " ".join(f"c_p[{m}][{c}]" for c in (1, 2) for m in range(1, 10))
        disc = " disc" if self.disc else ""
        plane = "fix plane all enforce2d" if self.dim == 2 else ""
        return f"""clear
print "SCENE {name}"
units lj
dimension {self.dim}
newton {self.newton}
atom_style sphere
atom_modify map array sort 0 0.0
boundary f f {'f' if self.dim == 3 else 'p'}
comm_modify vel yes
read_data {name}.data
neighbor 0.3 bin
pair_style {self.style}
{chr(10).join('pair_coeff ' + words for words in self.coeffs)}
fix move all nve/sphere{disc}
{plane}
timestep {self.dt:.17g}
compute p all power/partition
compute which all property/local ptype1 ptype2
compute pairs all pair/local dist p1 p4 p5 p9 p10 p15
dump pairs all local 20 {name}.pairs c_which[*] c_pairs[*]
dump_modify pairs format float %.17g
thermo 1
thermo_style custom step c_p {columns}
thermo_modify norm no format float %.17g
run {steps}
write_dump all custom {name}.dump id x y z vx vy vz omegax omegay omegaz modify format float %.17g
"""
