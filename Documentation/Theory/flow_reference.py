"""The flow of page I in numpy, on the nodes of a lattice mesh: the paper's flow alone, without smoothing in between."""

import numpy as np

LOW = 0.5 - 0.5 / np.sqrt(3.0)
FLOOR = 0.05  # of rho in the denominator of (I2)


def cell_corners(x):
    n = len(x)
    return [[[x[a:n - 1 + a, b:n - 1 + b, c:n - 1 + c] for c in (0, 1)] for b in (0, 1)] for a in (0, 1)]


def cell_volumes(x):
    """Exact volumes of the trilinear cells: 2 x 2 x 2 Gauss points of det J."""
    c = cell_corners(x)
    total = 0.0
    for xi in (LOW, 1 - LOW):
        for eta in (LOW, 1 - LOW):
            for zeta in (LOW, 1 - LOW):
                def blend(edge, u, v):
                    return ((1 - u) * (1 - v) * edge(0, 0) + u * (1 - v) * edge(1, 0)
                            + (1 - u) * v * edge(0, 1) + u * v * edge(1, 1))
                a = blend(lambda p, q: c[1][p][q] - c[0][p][q], eta, zeta)
                b = blend(lambda p, q: c[p][1][q] - c[p][0][q], xi, zeta)
                d = blend(lambda p, q: c[p][q][1] - c[p][q][0], xi, eta)
                total = total + np.einsum("...i,...i", a, np.cross(b, d))
    return total / 8


def volume_variance(x):
    volume = cell_volumes(x)
    return np.mean((volume / volume.mean() - 1) ** 2)


def least_flux(rho):
    """(I5), (I6): v on the faces by axis, d2 v = 1 - rho, by cosine transforms."""
    m = len(rho)
    a = np.arange(m)
    C = np.sqrt(2 / m) * np.cos(np.pi * a[:, None] * (a[None, :] + 0.5) / m)
    C[0] = np.sqrt(1 / m)
    eigen = 2 - 2 * np.cos(np.pi * a / m)
    spectrum = np.einsum("ai,bj,ck,ijk->abc", C, C, C, 1 - rho, optimize=True)
    total = eigen[:, None, None] + eigen[None, :, None] + eigen[None, None, :]
    total[0, 0, 0] = np.inf
    theta = np.einsum("ai,bj,ck,abc->ijk", C, C, C, spectrum / total, optimize=True)
    flux = []
    for axis in range(3):
        pad = [(0, 0)] * 3
        pad[axis] = (1, 1)
        flux.append(np.pad(-np.diff(theta, axis=axis), pad))
    return flux


def interpolate(field, point):
    """Linear along every axis; points [... x 3] in index coordinates, clamped to the field."""
    size = np.array(field.shape[:3])
    p = np.clip(point, 0, size - 1)
    base = np.minimum(p.astype(int), np.maximum(size - 2, 0))
    w = p - base
    step = np.minimum(1, size - 1)
    result = 0.0
    for corner in np.ndindex(2, 2, 2):
        index = base + np.array(corner) * step
        weight = np.prod(np.where(corner, w, 1 - w), axis=-1)
        value = field[index[..., 0], index[..., 1], index[..., 2]]
        result = result + (weight[..., None] if value.ndim > weight.ndim else weight) * value
    return result


def flow_pass(x, held=False, steps=8):
    """f o g_1^-1 at the nodes: every lattice node is carried backwards from t = 1 to 0."""
    volume = cell_volumes(x)
    rho = volume / volume.mean()
    flux = least_flux(rho)
    density = np.maximum(rho, FLOOR)
    n = len(x)

    def velocity(p, t):
        v = np.empty_like(p)
        for axis in range(3):
            shifted = p - 0.5
            shifted[..., axis] += 0.5
            v[..., axis] = interpolate(flux[axis], shifted)
        return -v / ((1 - t) * interpolate(density, p - 0.5) + t)[..., None]

    nodes = np.stack(np.meshgrid(*[np.arange(n, dtype=float)] * 3, indexing="ij"), -1)
    p, dt = nodes.copy(), 1.0 / steps
    for step in range(steps):
        t = 1 - step * dt
        k1 = velocity(p, t)
        k2 = velocity(p - 0.5 * dt * k1, t - 0.5 * dt)
        k3 = velocity(p - 0.5 * dt * k2, t - 0.5 * dt)
        k4 = velocity(p - dt * k3, t - dt)
        p = np.clip(p - dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4), 0, n - 1)
    if held:
        inner = np.zeros((n,) * 3, bool)
        inner[1:-1, 1:-1, 1:-1] = True
        p = np.where(inner[..., None], p, nodes)
    return interpolate(x, p)
