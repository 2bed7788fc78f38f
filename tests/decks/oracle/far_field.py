"""Spheres in a periodic Stokes fluid by force coupling: the full matrix from a sum over all waves, viscosity 1.

Unknowns of a sphere: force, torque and stresslet on the fluid, xx yy xy xz yz of the last, which is traceless; motions:
velocity, spin, rate of strain, with the weights of the power.
"""
import numpy as np

EPS = np.zeros((3, 3, 3))
for a, b, c in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
    EPS[a, b, c], EPS[a, c, b] = 1, -1


def stresslets():
    """An orthonormal basis of symmetric traceless tensors."""
    basis = []
    for a, b in ((0, 1), (0, 2), (1, 2)):
        t = np.zeros((3, 3))
        t[a, b] = t[b, a] = np.sqrt(0.5)
        basis.append(t)
    basis.append(np.diag([1, -1, 0]) / np.sqrt(2))
    basis.append(np.diag([-1, -1, 2]) / np.sqrt(6))
    return np.array(basis)


BASIS = stresslets()
# dipole C_jk = S_jk - eps_jkm T_m/2 of each of torque and stresslet
DIPOLES = np.concatenate([-0.5 * np.moveaxis(EPS, 2, 0), BASIS])


def mobility(cell, x, radius, smallest=1e-11):
    """11 n by 11 n; columns of cell are its edges."""
    n = len(x)
    width_m, width_d = radius / np.sqrt(np.pi), radius / (6 * np.sqrt(np.pi)) ** (1 / 3)
    most = np.sqrt(-np.log(smallest)) / np.min(width_d)    # the narrower one, twice
    top = [int(most * np.linalg.norm(edge) / (2 * np.pi)) + 1 for edge in cell.T]
    m = np.stack(np.meshgrid(*(np.arange(-t, t + 1) for t in top), indexing="ij"), -1).reshape(-1, 3)
    m = m[np.any(m != 0, axis=1)]
    m = m[np.lexsort((m[:, 2], m[:, 1], m[:, 0]))][len(m) // 2:]    # one of k and -k
    k = 2 * np.pi * m @ np.linalg.inv(cell)
    k2 = np.sum(k * k, axis=1)
    k, k2 = k[k2 < most**2], k2[k2 < most**2]
    whole = np.zeros((11 * n, 11 * n))
    for part in np.array_split(np.arange(len(k)), max(1, len(k) // 1000)):
        q, q2 = k[part], k2[part]
        # u = (1 - qq/q^2) f/q^2: two directions across q, over q
        across = np.linalg.svd(q[:, None, :])[2][:, 1:] / np.sqrt(q2)[:, None, None]
        phase = np.exp(-1j * q @ x.T)
        force = np.exp(-0.5 * q2[:, None] * width_m**2) * phase                      # wave, sphere
        dipole = -1j * np.exp(-0.5 * q2[:, None] * width_d**2) * phase
        load = np.empty((len(q), 2, n, 11), dtype=complex)
        load[:, :, :, :3] = force[:, None, :, None] * across[:, :, None, :]
        load[:, :, :, 3:] = dipole[:, None, :, None] * np.einsum("wdj,pjk,wk->wdp", across, DIPOLES, q)[:, :, None, :]
        load = load.reshape(-1, 11 * n)
        for half in (np.ascontiguousarray(load.real), np.ascontiguousarray(load.imag)):
            whole += 2 * half.T @ half
    return whole / np.linalg.det(cell)


def loads(cell, x, radius, velocity, spin, strain):
    """Force, torque and stresslet of each sphere on the fluid; velocities and spins relative to a flow of that strain."""
    n = len(x)
    motion = np.zeros((n, 11))
    motion[:, :3], motion[:, 3:6] = velocity, spin
    motion[:, 6:] = -np.einsum("pjk,jk->p", BASIS, strain)
    found = np.linalg.solve(mobility(cell, x, radius), motion.ravel()).reshape(n, 11)
    return found[:, :3], found[:, 3:6], np.einsum("np,pjk->njk", found[:, 6:], BASIS)
