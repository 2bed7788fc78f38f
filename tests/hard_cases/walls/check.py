# ranks: 1
"""The walls of LAMMPS together with pair style lubcontact: which work, and what they do to a sphere. All are dry: the film
between a sphere and a wall is in none of them (for one, make the wall of particles: case particle_walls).
"""
import numpy as np

from deck import expect, expect_close, expect_error, finish, run

MASS, K = 4 / 3 * np.pi, 1000.0


def gran(damping=0.0, friction=0.0, rest="yplane 0 NULL", style="wall/gran"):
    """A wall with normal dashpot (force/velocity) and sliding friction."""
    sliding = f"tangential linear_nohistory {1.0 if friction else 0.0} {friction}"
    return f"fix wall all {style} granular hooke {K} {damping} {sliding} damping velocity {rest}"


GRAN_Y = gran()


def bounce():
    """A spring and a dashpot: time of contact and restitution of half a period of the oscillator."""
    for damping in 0.0, 40.0:
        t = run("in.wall", walls=gran(damping), start="0 -1 0", step=1e-4, steps=8000, every=1).thermo()
        w, half = np.sqrt(K / MASS), 0.5 * damping / MASS
        ratio = np.pi / np.sqrt(w**2 - half**2)
        expect_close(f"wall/gran, damping {damping}: contact lasts", np.sum(t["v_y"] < 1) * 1e-4, ratio, atol=2e-4)
        expect_close(f"wall/gran, damping {damping}: rebound", t["v_vy"][-1], np.exp(-half * ratio), rtol=1e-3)


def stack():
    """Wall, sphere, rough contact, sphere, at rest: each carries what is above, and the stress knows the pair only."""
    g, weight = 1e3, MASS * 0.5
    t = run("in.wall", walls=gran(40.0), pair=1, places="0 0.999 0", second="0 3.01 0", weight=0.5, step=2e-3, steps=20000,
            every=1000).thermo()
    expect_close("stack: the wall carries both", 1 - t["v_y"][-1], 2 * weight / K, rtol=1e-5)
    gap = 0.02 - weight / g - weight / g    # asperities and bulk in series
    expect_close("stack: the contact carries one", t["v_top"][-1] - t["v_y"][-1] - 2, gap, atol=1e-6)
    expect_close("stack: stress", t["c_stress[1][2]"][-1], -weight * (2 + gap) / 8000, rtol=1e-4)


def rolling():
    """Friction ends where the surface rolls: 5/7 of the velocity; 2/7 of that of a wall that moves."""
    case = dict(places="0 0.99 0", weight=2.0, step=1e-3, steps=4000, every=200)
    t = run("in.wall", walls=gran(40.0, 0.5), start="1 0 0", **case).thermo()
    expect_close("sliding becomes rolling: velocity", t["v_vx"][-1], 5 / 7, rtol=1e-5)
    expect_close("sliding becomes rolling: spin", t["c_wz"][-1], -5 / 7, rtol=1e-5)
    t = run("in.wall", walls=gran(40.0, 0.5) + " shear x 1.0", sides="p f p", **case).thermo()
    expect_close("carried by a moving wall: velocity", t["v_vx"][-1], 2 / 7, rtol=1e-5)


def regions():
    """At the bottom of a drum and of a bowl."""
    drum = "region drum cylinder z 0 0 5 INF INF"
    bowl = "region drum sphere 0 0 0 5"
    for shape in drum, bowl:
        t = run("in.wall", before=shape, walls=gran(40.0, 0.5, "region drum", "wall/gran/region"), places="0.3 -3.9 0.0",
                weight=4.0, steps=20000, every=1000, after="fix slow all drag/background 0.3").thermo()
        expect_close(f"{shape}: distance from the middle", -t["v_y"][-1], 4 + 4 * MASS / K, rtol=1e-5)
        expect_close(f"{shape}: at the bottom", t["v_x"][-1], 0.0, atol=1e-3)


def overdamped():
    """Without inertia a sphere sinks into the wall by Euler's rule, exactly."""
    weight, c, dt = 2.0 * MASS, 6 * np.pi, 1e-3
    t = run("in.wall", move="overdamped/sphere 1.0", walls=gran(), weight=2.0, places="0 1 0", step=dt, steps=200,
            every=1).thermo()
    sunk = weight / K * (1 - (1 - K * dt / c)**np.arange(201))
    expect_close("overdamped on wall/gran", 1 - t["v_y"], sunk, atol=1e-9)


def reflect():
    """Mirrors the centers. Two spheres in contact that are mirrored together do not notice each other."""
    t = run("in.wall", walls="fix wall all wall/reflect ylo 0.0", pair=1, places="-0.95 1.5 0", second="0.95 1.5 0",
            start="0 -1 0", coeffs="1e-9 1e-9", step=1e-3, steps=3000).thermo()
    expect_close("wall/reflect: mirrors centers", t["v_y"], np.abs(1.5 - t["Time"]), atol=1e-12)
    expect_close("wall/reflect: and the velocity", t["v_vy"], np.where(t["Time"] < 1.5005, -1, 1))
    expect_close("wall/reflect: no film force between mirrored spheres", t["v_fy"], 0.0, atol=1e-20)


def in_shear():
    """Walls across the vorticity are compatible with the rheometer, those across the gradient are not."""
    rheometer = "fix shear all deform/rheometer rate 0.5 volume"
    side = gran(rest="zplane -2 2")
    case = dict(shape="prism", after=rheometer, step=1e-3, steps=8000)
    t = run("in.wall", walls=side, sides="p p f", places="0 3 0", start="0 0 0.5", **case).thermo()
    expect_close("smooth side walls: the flow goes on", t["v_vx"], 0.5 * (t["v_y"] + 10), atol=1e-9)
    done = run("in.wall", walls=GRAN_Y, sides="p p p", fails=True, **case)
    expect_error("wall across the gradient of a periodic cell", done.text, "Cannot use wall in periodic dimension")
    done = run("in.wall", walls=GRAN_Y, sides="p f p", fails=True, **case)
    expect_error("a cell that is not periodic", done.text, "Fix deform/rheometer")


def drag_order():
    done = run("in.wall", walls="fix drag all drag/background 1.0", after=gran(), fails=True)
    expect_error("a wall after the drag", done.text, "Fix wall wall/gran adds forces after fix drag/background")


def center(what, force, args, **case):
    """The force of a wall on the way towards it and back."""
    t = run("in.wall", walls=args, places="0 2.2 0", start="0 -2 0", step=1e-3, steps=1000, **case).thermo()
    expect_close(f"{what}: force", t["v_fy"], force(t["v_y"]), rtol=1e-7, atol=1e-7)
    expect(f"{what}: acts", np.ptp(t["v_fy"]) > 1)


def hamaker(y):
    """wall/colloid: derivative of the energy of a sphere of radius 1, surfaces at the distance y - 1, epsilon = sigma = 1."""
    def energy(d):
        return ((6 - d) / d**7 + (d + 8) / (d + 2)**7) / 7560 - \
            (2 * (d + 1) + d * (d + 2) * (np.log(d) - np.log(d + 2))) / (6 * d * (d + 2))
    h = 1e-5
    return -(energy(y - 1 + h) - energy(y - 1 - h)) / (2 * h)


def centers():
    e, c = 100.0, 1.1    # twice the stiffness, and the radius: an elastic wall for equal spheres
    springs = f"fix wall all wall/harmonic ylo 0.0 {e} 0.0 {c}"
    inside = "fix wall all wall/{} ylo 0.0 {} 5.0"    # cut off where the sphere never is
    center("wall/harmonic", lambda y: 2 * e * np.maximum(0, c - y), springs)
    t = run("in.wall", walls=springs, after="fix slow all drag/background 0.3", weight=0.5, places="0 1.1 0", steps=20000,
            every=1000).thermo()
    expect_close("wall/harmonic: rest under the weight", t["v_y"][-1], c - 0.5 * MASS / (2 * e), rtol=1e-6)
    center("wall/lj93", lambda y: 1.2 / y**10 - 3 / y**4, inside.format("lj93", "1.0 1.0"))
    center("wall/lj126", lambda y: 48 / y**13 - 24 / y**7, inside.format("lj126", "1.0 1.0"))
    center("wall/lj1043", lambda y: 2 * np.pi * (4 / y**11 - 4 / y**5 - np.sqrt(2) / (y + 0.61 / np.sqrt(2))**4),
           inside.format("lj1043", "1.0 1.0"))
    center("wall/morse", lambda y: 200 * (np.exp(-10 * (y - 1)) - np.exp(-5 * (y - 1))), inside.format("morse", "20.0 5.0 1.0"))
    center("wall/colloid", lambda y: 100 * hamaker(y), inside.format("colloid", "100.0 1.0"))
    center("indent", lambda y: e * np.maximum(0, c - y)**2, f"fix wall all indent {e} plane y {c} lo")
    center("wall/region", lambda y: 2 * e * np.maximum(0, c - y), f"fix wall all wall/region floor harmonic {e} 0.0 {c}",
           before="region floor plane 0 0 0 0 1 0")


bounce()
stack()
rolling()
regions()
overdamped()
reflect()
in_shear()
drag_order()
centers()
finish()
