"""What the examples share: laws from the literature, runs of a deck, and the stacked parts of the stress."""
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
TOOLS = HERE.parents[1] / "tools"
sys.path.insert(0, str(TOOLS))
import steady    # noqa: E402  pylint: disable=wrong-import-position

# columns of stress.txt (scene/stress.lmp) -> name and color of the part
PARTS = {"fluid": ("fluid", "0.8"), "v_contact_n": ("contact, normal", "#1f4e79"),
         "v_contact_t": ("contact, tangential", "#6fa8dc"), "v_film_n": ("lubrication, normal", "#b45f06"),
         "v_film_t": ("lubrication, tangential", "#f6b26b"), "v_stresslet": ("far field", "#38761d")}

# W. Chevremont, B. Chareyre, H. Bodiguel, Phys. Rev. Fluids 4, 064302 (2019), eqs. 13 to 16 of the thesis


def phi_m_chevremont(friction):
    """Volume fraction at jamming, eq. 13."""
    return 0.6301 - 0.0794 * (1 - np.exp(-friction / 0.4032))


def phi_chevremont(iv, friction):
    """Volume fraction at a viscous number, eq. 15."""
    return phi_m_chevremont(friction) / (1 + np.sqrt(iv))


def split_chevremont(iv, friction=0.5):
    """Shear stress over pressure at a viscous number, eq. 14; for friction >= 0.36: part of contacts, part of films and fluid."""
    return 0.36 + 0.34 / (1 + 0.0133 / iv), iv * (1 - phi_chevremont(iv, friction)) ** -2.5


def mu_chevremont(iv, friction):
    return sum(split_chevremont(iv, friction))


def eta_chevremont(phi, friction=0.5):
    """Relative viscosity, eq. 16 = mu/Iv at phi(Iv)."""
    iv = (phi_m_chevremont(friction) / phi - 1) ** 2
    return mu_chevremont(iv, friction) / iv


# F. Boyer, E. Guazzelli, O. Pouliquen, Phys. Rev. Lett. 107, 188301 (2011); measured with polystyrene and PMMA spheres

PHI_M_BOYER = 0.585


def phi_boyer(iv):
    return PHI_M_BOYER / (1 + np.sqrt(iv))


def split_boyer(iv):
    """As the form of their law suggests it; they measured the sum."""
    return 0.32 + 0.38 / (1 + 0.005 / iv), iv + 2.5 * PHI_M_BOYER * np.sqrt(iv)


def mu_boyer(iv):
    return sum(split_boyer(iv))


def eta_boyer(phi):
    iv = (PHI_M_BOYER / phi - 1) ** 2
    return mu_boyer(iv) / iv


# S. Gallier, E. Lemaire, F. Peters, L. Lobry, J. Fluid Mech. 757, 514 (2014); resolved simulations, friction 0.5, phi <= 0.45. As the
# fit that Chevremont's thesis gives (eqs. A3, A4), with the minus sign that its second term needs: the viscosity of the hydrodynamic
# part must grow with phi

def phi_gallier(iv):
    return 0.64 / (1 + iv**0.4)


def split_gallier(iv):
    return split_boyer(iv)[0], iv * (1 - phi_gallier(iv) / 0.68) ** (-2.4 * 0.68)


def eta_gallier(phi):
    iv = (0.64 / phi - 1) ** 2.5
    return sum(split_gallier(iv)) / iv


def split_lecampion(iv):
    """B. Lecampion, D.I. Garagash, J. Fluid Mech. 759, 197 (2014); no data behind it. As Chevremont's thesis gives it (eqs. A5, A6),
    with 5/2 phi_m where it prints 5 phi_m: only so is the dilute limit that of Einstein.
    """
    from_jamming = 1 - phi_boyer(iv) / PHI_M_BOYER
    return 0.3 + PHI_M_BOYER / 0.158 * from_jamming, (iv + (2.5 * PHI_M_BOYER + 2) * np.sqrt(iv)) * from_jamming**2


SPLITS = {"Chevremont 2019": split_chevremont, "Boyer 2011": split_boyer, "Gallier 2014": split_gallier,
          "Lecampion 2014": split_lecampion}


def phi_to_start(iv, chi_f):
    """Volume fraction of a packing to start from under a pressure, within 0.02 of what the scene takes with friction
    0.5 at a fraction chi_f of the contacts (examples/mu_of_iv)."""
    smooth, rough = phi_m_chevremont(0) / (1 + 0.75 * np.sqrt(iv)), phi_m_chevremont(0.5) / (1 + 0.9 * np.sqrt(iv))
    return min(smooth + chi_f * (rough - smooth), 0.59)


def simulate(deck, variables, ranks=1, log="none", read=None):
    """Runs a deck of an example in a scratch folder; columns of its stress.txt, and of normal.txt and contacts.txt if
    any, as a dict; or what read(folder) gives."""
    environment = dict(os.environ)
    lmp = environment.pop("LAMMPS_EXECUTABLE", None)    # the tests say which; for the tools it would be one of the user
    command = [environment["MPIRUN"], str(ranks), lmp] if lmp and "MPIRUN" in environment else \
        [str(TOOLS / "lmp.sh"), "-n", str(ranks)]
    command += ["-in", str(deck), "-log", log, "-screen", "none"]
    with tempfile.TemporaryDirectory() as folder:
        for name, value in {"scene": HERE, "packing": HERE.parent / "packing" / "packing.lmp", **variables}.items():
            command += ["-var", name, str(value)]
        subprocess.run(command, cwd=folder, check=True, env=environment)
        return (read or read_run)(folder)


def read_run(folder="."):
    """Columns of stress.txt and, if there are any, of normal.txt and contacts.txt, which has a line more: that of the start."""
    data = steady.read_ave_time(Path(folder) / "stress.txt")
    for file in ("normal.txt", "contacts.txt"):
        if (Path(folder) / file).exists():
            more = steady.read_ave_time(Path(folder) / file)
            kept = np.searchsorted(more["TimeStep"], data["TimeStep"])
            data.update({name: column[kept] for name, column in more.items() if name not in data})
    return data


def estimate(values):
    """Mean and error; the error is nan where the signal is too short to tell it."""
    try:
        found = steady.mean_error(values)
        return found.mean, found.error
    except steady.TooShort:
        return float(np.mean(values)), float("nan")


def ratio(above, below):
    """Ratio of two means and its error, as estimate() does it."""
    try:
        found = steady.ratio(above, below)
        return found.mean, found.error
    except steady.TooShort:
        return float(np.mean(above) / np.mean(below)), float("nan")


def steady_from(x, *signals):
    """Where along x the steady part begins; half way, with a message, if there is none."""
    try:
        return x[steady.steady_start(*signals)]
    except (steady.NotSteady, steady.TooShort) as problem:
        print(f"no steady part found ({problem}): taking the last half")
        return x[len(x) // 2]


def steady_means(data, means, by=("v_sxy",), strain="v_gamma"):
    """Row of a table: where the signals by become steady, and mean and error of the columns in means, a dict of their names."""
    start = steady_from(data[strain], *(data[name] for name in by))
    row = {"from": f"{start:.2f}"}
    for name, column in means.items():
        found = estimate(data[column][data[strain] >= start])
        row["mean_" + name], row[f"mean_{name}_error"] = (f"{value:.5g}" for value in found)
    return row


def stack_parts(ax, x, data, sign=1.0):
    """Parts of the shear stress (times sign) against x, stacked on that of the fluid."""
    parts = {name: data[name] for name in PARTS if name in data and np.any(data[name])}
    parts = {"fluid": data["v_sxy"] - sum(parts.values()) - data["v_inertia"], **parts}
    bottom = np.zeros_like(x)
    for name, part in parts.items():
        label, color = PARTS[name]
        ax.fill_between(x, bottom, bottom + sign * part, color=color, label=label, lw=0)
        bottom = bottom + sign * part


def legend(ax, **options):
    """Legend in the order of the stack."""
    handles, labels = ax.get_legend_handles_labels()
    ax.legend(handles[::-1], labels[::-1], frameon=False, fontsize=8, **options)


def image(name="particles.ppm"):
    """Picture drawn by LAMMPS without its margins, or None; also saved as PNG."""
    import matplotlib.pyplot as plt    # pylint: disable=import-outside-toplevel
    if not Path(name).exists():
        return None
    picture = plt.imread(name)
    plt.imsave(Path(name).with_suffix(".png"), picture)
    return picture[20:-20, 60:-60]
