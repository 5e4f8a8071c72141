"""The equations of pages D, E and F in dense numpy: small meshes only, written from the pages and not from the C++.

Surfaces are (vertices nV x 3, triangles nF x 3), outward; maps are unit vectors nV x 3.
"""

import numpy as np


def triangle_areas(x, t):
    return 0.5 * np.linalg.norm(np.cross(x[t[:, 1]] - x[t[:, 0]], x[t[:, 2]] - x[t[:, 0]]), axis=1)


def normalised(x):
    return x / np.linalg.norm(x, axis=-1, keepdims=True)


def cotan_laplacian(x, t):
    """(D1), dense."""
    D = np.zeros((len(x), len(x)))
    for k in range(3):
        p, q, r = t[:, k], t[:, (k + 1) % 3], t[:, (k + 2) % 3]
        u, v = x[p] - x[r], x[q] - x[r]
        half_cot = 0.5 * (u * v).sum(1) / np.linalg.norm(np.cross(u, v), axis=1)
        np.add.at(D, (p, q), -half_cot)
        np.add.at(D, (q, p), -half_cot)
    D[np.diag_indices(len(x))] = -D.sum(1)
    return D


def boundary_terms(x, removed, sign=-1.0):
    """(D2); sign = +1 is the paper's misprint."""
    A, B, C = x[removed]
    theta = (B - A) @ (C - A) / ((B - A) @ (B - A))
    height = np.linalg.norm(C - A - theta * (B - A))
    terms = np.zeros((len(x), 2))
    terms[removed, 0] = np.array([-1.0, 1.0, 0.0]) / np.linalg.norm(B - A)
    terms[removed, 1] = np.array([1.0 - theta, theta, sign]) / height
    return terms


def conformal_map(x, t, removed, sign=-1.0):
    """(D3), (D4). Returns the map and the relative residuals of D x = a and D y = b. The mean of the right-hand sides,
    for which there is no solution, is left out: it is zero unless `sign` is the misprint."""
    D = cotan_laplacian(x, t)
    terms = boundary_terms(x, t[removed], sign)
    pinned = D.copy()
    pinned[t[removed, 0], t[removed, 0]] += 1.0
    plane = np.linalg.solve(pinned, terms - terms.mean(0))
    residual = np.linalg.norm(D @ plane - terms, axis=0) / np.linalg.norm(terms, axis=0)
    plane -= np.median(plane, axis=0)
    plane /= np.median(np.linalg.norm(plane, axis=1))
    r2 = (plane**2).sum(1)
    s = np.column_stack([2 * plane, r2 - 1]) / (1 + r2)[:, None]
    if (determinants(s, t) > 0).mean() < 0.5:
        s[:, 0] *= -1
    return s, residual


def corner_angles(x, t):
    """Angles of all triangles, nF x 3 [degrees]."""
    angle = []
    for k in range(3):
        u, v = x[t[:, (k + 1) % 3]] - x[t[:, k]], x[t[:, (k + 2) % 3]] - x[t[:, k]]
        angle.append(np.arctan2(np.linalg.norm(np.cross(u, v), axis=1), (u * v).sum(1)))
    return np.degrees(np.stack(angle, 1))


def triangle_towards(x, t, direction, margin=0.03):
    """The most regular triangle within about 14 degrees of a direction seen from the centroid."""
    area = triangle_areas(x, t)
    middle = x[t].mean(1)
    aligned = normalised(middle - area @ middle / area.sum()) @ direction
    sides = sum(((x[t[:, k]] - x[t[:, k - 1]]) ** 2).sum(1) for k in range(3))
    return np.where(aligned >= aligned.max() - margin, area / sides, -1).argmax()


def moebius_centred(x, t, s):
    """(D5), (D6)."""
    mass = np.bincount(t.ravel(), np.repeat(triangle_areas(x, t) / 3, 3), len(x))
    mass /= mass.sum()
    for _ in range(50):
        centroid = mass @ s
        if np.linalg.norm(centroid) < 1e-13:
            break
        spread = np.eye(3) - np.einsum("v,vi,vj->ij", mass, s, s)
        c = -0.5 * np.linalg.solve(spread, centroid)
        c *= min(1.0, 0.5 / np.linalg.norm(c))
        cs = s @ c
        s = normalised(((1 - c @ c) * s + 2 * (1 + cs)[:, None] * c))
    return s


def body_frame(x, t, s):
    """Rotation by least squares: directions on the sphere match those in the body."""
    area = triangle_areas(x, t)
    centre = x[t].mean(1)
    body = normalised(centre - area @ centre / area.sum())
    u, _, vt = np.linalg.svd(np.einsum("f,fi,fj->ij", area, body, normalised(s[t].sum(1))))
    return s @ (u @ np.diag([1, 1, np.linalg.det(u @ vt)]) @ vt).T


def determinants(s, t):
    return np.einsum("fi,fi->f", s[t[:, 0]], np.cross(s[t[:, 1]], s[t[:, 2]]))


def solid_angles(s, t):
    a, b, c = s[t[:, 0]], s[t[:, 1]], s[t[:, 2]]
    D = 1 + (a * b).sum(1) + (b * c).sum(1) + (c * a).sum(1)
    return 2 * np.arctan2(determinants(s, t), D)


def area_ratios(x, t, s):
    area = triangle_areas(x, t)
    return solid_angles(s, t) / (4 * np.pi * area / area.sum())


def area_rms(x, t, s):
    area = triangle_areas(x, t)
    return np.sqrt((area / area.sum()) @ (area_ratios(x, t, s) - 1) ** 2)


def vertex_shares(t, values, count):
    return np.bincount(t.ravel(), np.repeat(values / 3, 3), count)


def moser_pass(t, s, density, steps=4):
    """(E1), (E2): one pass of the flow for a density at the vertices. Stops before a step that would flip a triangle."""
    share = vertex_shares(t, solid_angles(s, t), len(s))
    density = density * share.sum() / (density @ share)
    L = cotan_laplacian(s, t)
    L[0, 0] += 1.0
    potential = np.linalg.solve(L, (density - 1) * share)
    gradient = vertex_gradients(t, s, potential)

    def velocity(p, time):
        triangle, weight = locate(t, s, p)
        corner = t[triangle]
        mu = np.einsum("pk,pk->p", weight, density[corner])
        g = np.einsum("pk,pki->pi", weight, gradient[corner])
        g -= (g * p).sum(1)[:, None] * p
        return -g / ((1 - time) * mu + time)[:, None]

    p, dt = s.copy(), 1.0 / steps
    for step in range(steps):
        time = step * dt
        k1 = velocity(p, time)
        k2 = velocity(normalised(p + 0.5 * dt * k1), time + 0.5 * dt)
        k3 = velocity(normalised(p + 0.5 * dt * k2), time + 0.5 * dt)
        k4 = velocity(normalised(p + dt * k3), time + dt)
        moved = normalised(p + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4))
        if (determinants(moved, t) <= 0).any():
            break
        p = moved
    return p


def vertex_gradients(t, s, f):
    """Gradient of the piecewise linear f, averaged at the vertices by area, tangent to the sphere."""
    a, b, c = s[t[:, 0]], s[t[:, 1]], s[t[:, 2]]
    normal = np.cross(b - a, c - a)
    twice = np.linalg.norm(normal, axis=1)
    edge = f[t[:, 0], None] * (c - b) + f[t[:, 1], None] * (a - c) + f[t[:, 2], None] * (b - a)
    weighted = np.cross(normal, edge) / twice[:, None]
    g, weight = np.zeros_like(s), np.zeros(len(s))
    for k in range(3):
        np.add.at(g, t[:, k], weighted)
        np.add.at(weight, t[:, k], twice)
    g /= weight[:, None]
    return g - (g * s).sum(1)[:, None] * s


def locate(t, s, p):
    """The triangle that holds each direction, by a scan, and the weights (G2)."""
    a, b, c = s[t[:, 0]], s[t[:, 1]], s[t[:, 2]]
    weights = np.stack([p @ np.cross(b, c).T, p @ np.cross(c, a).T, p @ np.cross(a, b).T], 2)
    weights /= determinants(s, t)[None, :, None] ** (2 / 3)  # comparable between triangles of different size
    smallest = np.where(p @ (a + b + c).T > 0, weights.min(2), -np.inf)
    triangle = smallest.argmax(1)
    weight = np.maximum(weights[np.arange(len(p)), triangle], 0)
    return triangle, weight / weight.sum(1, keepdims=True)


def barrier_map(x, t, s, eps=1e-3, steps=60):
    """(E4), its shape term by the limit for short edges, by damped Gauss-Newton in tangent coordinates with eps = 0.1,
    0.01, ... down to `eps`."""
    target = 4 * np.pi * triangle_areas(x, t) / triangle_areas(x, t).sum()
    L = cotan_laplacian(x, t)
    W = np.clip(-L, 0.02, 10.0) * (L != 0)
    np.fill_diagonal(W, 0.0)
    L = np.diag(W.sum(1)) - W
    count = len(x)

    def energy(p, e):
        if (determinants(p, t) <= 0).any():
            return np.inf
        r = solid_angles(p, t) / target
        return 0.5 * target @ (r + 1 / r - 2) + 0.5 * e * (p * (L @ p)).sum()

    e, damping = max(0.1, eps), 0.0
    for _ in range(steps):
        helper = np.where(np.abs(s[:, :1]) < 0.6, [[1.0, 0, 0]], [[0, 1.0, 0]])
        b1 = normalised(np.cross(s, helper))
        basis = np.stack([b1, np.cross(s, b1)], 2)  # nV x 3 x 2
        r = solid_angles(s, t) / target
        N = determinants(s, t)
        pa, pb, pc = s[t[:, 0]], s[t[:, 1]], s[t[:, 2]]
        D = 1 + (pa * pb).sum(1) + (pb * pc).sum(1) + (pc * pa).sum(1)
        tangent = []  # dOmega in the tangent coordinates of the three corners
        for k in range(3):
            u, v = s[t[:, (k + 1) % 3]], s[t[:, (k + 2) % 3]]
            d = 2 * (D[:, None] * np.cross(u, v) - N[:, None] * (u + v)) / (N**2 + D**2)[:, None]
            tangent.append(np.einsum("fi,fij->fj", d, basis[t[:, k]]))
        jacobian = np.concatenate(tangent, 1)  # nF x 6
        unknown = (2 * t[:, :, None] + [0, 1]).reshape(len(t), 6)
        rows = basis.transpose(0, 2, 1).reshape(2 * count, 3)
        blocks = (rows @ rows.T) * np.repeat(np.repeat(L, 2, 0), 2, 1)
        gradient = e * np.einsum("via,vi->va", basis, L @ s).ravel()
        np.add.at(gradient, unknown, 0.5 * (1 - 1 / r**2)[:, None] * jacobian)
        hessian = (e + damping) * blocks
        weight = 0.5 * (1 + r) / r**2 / target
        local = weight[:, None, None] * jacobian[:, :, None] * jacobian[:, None, :]
        np.add.at(hessian, (unknown[:, :, None], unknown[:, None, :]), local)
        hessian[np.diag_indices(2 * count)] += 1e-9 * np.trace(hessian) / (2 * count)
        step = -np.linalg.solve(hessian, gradient)
        length, before = 1.0, energy(s, e)
        while length > 1e-6:
            moved = normalised(s + length * np.einsum("via,va->vi", basis, step.reshape(count, 2)))
            if energy(moved, e) <= before + 1e-4 * length * gradient @ step:
                break
            length *= 0.5
        s = moved if length > 1e-6 else s
        full = length > 0.9
        if e <= eps and (full and np.sqrt(step @ step / count) < 1e-5 or length <= 1e-6):
            break
        damping = 0.3 * damping if full else max(damping, e) * 3
        if e > eps and full:
            e = max(0.1 * e, eps)
    return s


def icosphere(levels):
    g = (1 + 5**0.5) / 2
    x = np.array([[-1, g, 0], [1, g, 0], [-1, -g, 0], [1, -g, 0], [0, -1, g], [0, 1, g], [0, -1, -g], [0, 1, -g],
                  [g, 0, -1], [g, 0, 1], [-g, 0, -1], [-g, 0, 1]])
    t = np.array([[0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4], [11, 10, 2],
                  [10, 7, 6], [7, 1, 8], [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8], [3, 8, 9], [4, 9, 5],
                  [2, 4, 11], [6, 2, 10], [8, 6, 7], [9, 8, 1]])
    x = normalised(x)
    for _ in range(levels):
        edges = np.sort(np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]]), axis=1)
        unique, inverse = np.unique(edges, axis=0, return_inverse=True)
        m = len(x) + inverse.reshape(3, -1).T
        x = np.concatenate([x, normalised(x[unique].sum(1))])
        t = np.concatenate([np.column_stack([t[:, 0], m[:, 0], m[:, 2]]), np.column_stack([t[:, 1], m[:, 1], m[:, 0]]),
                            np.column_stack([t[:, 2], m[:, 2], m[:, 1]]), m])
    return x, t


def cube_to_sphere(p):
    """(F2), (F3): points of the surface of [-1,1]^3 to the sphere, areas in proportion."""
    result = np.empty_like(p)
    axis = np.abs(p).argmax(1)
    row = np.arange(len(p))
    u, v = p[row, (axis + 1) % 3], p[row, (axis + 2) % 3]
    swap = np.abs(v) > np.abs(u)
    x, y = np.where(swap, v, u), np.where(swap, u, v)
    alpha = np.pi / 12 * np.divide(y, x, out=np.zeros_like(x), where=x != 0)
    S = 2**0.25 * x / np.sqrt(2**0.5 - np.cos(alpha))
    X, Y = S * (2**0.5 * np.cos(alpha) - 1), S * 2**0.5 * np.sin(alpha)
    X, Y = np.where(swap, Y, X), np.where(swap, X, Y)
    q = X**2 + Y**2
    result[row, (axis + 1) % 3] = X * np.sqrt(1 - q / 4)
    result[row, (axis + 2) % 3] = Y * np.sqrt(1 - q / 4)
    result[row, axis] = np.sign(p[row, axis]) * (1 - q / 2)
    return result
