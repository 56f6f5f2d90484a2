#!/usr/bin/python3
"""Reads the network of a comparison and solves one of its load cases, by numpy alone.

    examples/read_network.py FOLDER CASE FIT [nonlinear]

FOLDER is what a run with Study = compare has written; FIT is as in the names of its files. Prints the
energy and how far the displacements are from those of springfit, relative to the largest. All laws are
here: doc/network.md.
"""

import csv
import itertools
import re
import sys

import numpy as np

ROW = lambda name: list(csv.DictReader(open(name)))  # noqa: E731
COLUMNS = lambda rows, names: np.array([[float(r[n]) for n in names] for r in rows])  # noqa: E731


def square(d):
    """Of lengths; differentiable by complex steps, as all below."""
    return (d * d).sum(-1)


def elongation(law, d, rest):
    s = square(d)
    return np.sqrt(s) - rest if law == "quadratic" else (s - rest**2) / (2 * rest)


def angle(x):
    u, v = x[:, 0] - x[:, 1], x[:, 2] - x[:, 1]
    return np.arccos((u * v).sum(-1) / np.sqrt(square(u) * square(v)))


def volumes(x):
    """m x points: of a cell's Gauss points in the order of the vertices, or of a simplex."""
    n, dim = x.shape[1:]
    if n == dim + 1:
        return (np.linalg.det(x[:, 1:] - x[:, :1]) / (2 if dim == 2 else 6))[:, None]
    if n == dim:  # a triangle in space
        w = np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0])
        return np.sqrt(square(w))[:, None] / 2
    bits = np.array([v[::-1] for v in itertools.product((0, 1), repeat=dim)])
    result = []
    for point in 0.5 + (bits - 0.5) / np.sqrt(3):
        factors = np.where(bits, point, 1 - point)
        gradients = [
            (2 * bits[:, d] - 1) * np.delete(factors, d, 1).prod(1) for d in range(dim)
        ]
        jacobian = np.einsum("da,mac->mdc", gradients, x)
        result.append(np.linalg.det(jacobian) / 2**dim)
    return np.array(result).T


def energies(family, law, x, c):
    """J, of each member: x is m x nodes x dim, c the columns by name, m x numbers."""
    if family == "springs":
        q = elongation(law, x[:, 1] - x[:, 0], c["rest_length"][:, 0])
        return c["k"][:, 0] * q**2 / 2
    if family == "couplings":
        q_a = elongation(law, x[:, 1] - x[:, 0], c["rest_length_a"][:, 0])
        q_b = elongation(law, x[:, 3] - x[:, 2], c["rest_length_b"][:, 0])
        return c["stiffness"][:, 0] * q_a * q_b
    if family == "angles":
        return c["k"][:, 0] * (angle(x) - c["rest_angle"][:, 0]) ** 2 / 2
    V = volumes(x)
    V = V if "point" in family else V.sum(1, keepdims=True)
    if law == "quadratic":
        return (c["k"] * (V - c["rest_volume"]) ** 2 / 2).sum(1)
    mu, lam, rest = c["mu"], c["lambda"], c["rest_volume"]
    log_J = np.log(V / rest)
    if law == "logarithmic":
        return (rest * (-mu + lam * log_J / 2) * log_J).sum(1)
    # Plane stress: log_c, of the square of the stretch across the plane.
    lam, log_c = 2 * mu * lam / (2 * mu - lam), -lam * log_J / mu
    for _ in range(50):
        slope = lam / 2 + mu * np.exp(log_c)
        log_c = log_c - (lam * (log_J + log_c / 2) + mu * (np.exp(log_c) - 1)) / slope
    stretch = np.exp(log_c)
    return (rest * mu / 2 * (stretch - 1 - (1 + stretch) * (log_J + log_c / 2))).sum(1)


def gradients(family, law, x, c):
    """N, by complex steps: to the last digits."""
    result = np.empty_like(x)
    for a, d in np.ndindex(x.shape[1:]):
        step = x.astype(complex)
        step[:, a, d] += 1e-40j
        result[:, a, d] = energies(family, law, step, c).imag / 1e-40
    return result


def hessians(family, law, x, c):
    """N/m, by differences of the fourth order of the gradients."""
    size = x.shape[1] * x.shape[2]
    result = np.empty((len(x), size, size))
    h = 1e-3 * np.ptp(x, axis=1).max(1)
    for i, (a, d) in enumerate(np.ndindex(x.shape[1:])):
        sum_ = 0
        for times, weight in ((1, 8), (-1, -8), (2, -1), (-2, 1)):
            step = x.copy()
            step[:, a, d] += times * h
            sum_ = sum_ + weight * gradients(family, law, step, c)
        result[:, i] = (sum_ / (12 * h)[:, None, None]).reshape(len(x), -1)
    return result


def read(folder, fit):
    """Places of the nodes, n x dim in m, and the families: (name, law, nodes, columns by name)."""
    used = open(f"{folder}/used.prm").read()
    dim = int(re.search(r"set Dimension\s*= (\d)", used)[1])
    places = COLUMNS(ROW(f"{folder}/nodes.csv"), "xyz"[:dim])
    families = {}
    for row in ROW(f"{folder}/families.csv"):
        if row["fit"] == fit:
            families.setdefault((row["file"], row["family"], row["law"]), []).append(row)
    network = []
    for (file, family, law), rows in families.items():
        n, members = int(rows[0]["n_nodes_of_member"]), ROW(f"{folder}/{file}")
        if not members:
            continue
        names, columns = list(members[0])[n:], {}
        for row in rows:
            width = int(row["numbers_of_member"])
            columns[row["column"]] = COLUMNS(members, names[:width])
            names = names[width:]
        network.append((family, law, COLUMNS(members, list(members[0])[:n]).astype(int), columns))
    return places, network


def energy(network, x):
    """J, of nodes at x."""
    return sum(energies(f, law, x[n], c).sum() for f, law, n, c in network)


def forces(network, x):
    """N on each node at x."""
    result = np.zeros_like(x)
    for f, law, n, c in network:
        np.add.at(result, n, -gradients(f, law, x[n], c))
    return result


def main(folder, case, fit, kinematics="linear"):
    nodes, network = read(folder, fit)
    dim = nodes.shape[1]
    axes = "xyz"[:dim]
    suffix = "_nonlinear" if kinematics == "nonlinear" else ""
    table = ROW(f"{folder}/{case}_{fit}{suffix}.csv")
    force = COLUMNS(table, ["force_" + a for a in axes]).ravel()
    expected = COLUMNS(table, ["u_" + a for a in axes])
    free = COLUMNS(table, ["held_" + a for a in axes]).ravel() == 0

    def places(u):
        return nodes + u.reshape(-1, dim)

    def tangent(u):
        x, K = places(u), np.zeros((force.size, force.size))
        for f, law, n, c in network:
            dofs = (n[:, :, None] * dim + np.arange(dim)).reshape(len(n), -1)
            np.add.at(K, (dofs[:, :, None], dofs[:, None, :]), hessians(f, law, x[n], c))
        return K

    support = np.where(free, 0, expected.ravel())
    if kinematics == "linear":
        K, u = tangent(0 * force), support
        u[free] = np.linalg.solve(K[np.ix_(free, free)], (force - K @ support)[free])
    else:
        u = 0 * force
        for load in (0.25, 0.5, 0.75, 1):
            u[~free] = load * support[~free]
            for _ in range(30):
                pull = forces(network, places(u)).ravel()
                missing = (load * force + pull)[free]
                if np.linalg.norm(missing) < 1e-11 * np.linalg.norm(pull):
                    break
                step = np.linalg.solve(tangent(u)[np.ix_(free, free)], missing)
                u[free] += step
        print(f"energy {energy(network, places(u)):.10g} J")
    difference = np.abs(u.reshape(-1, dim) - expected).max() / np.abs(expected).max()
    print(f"difference {difference:.3g} of the largest displacement")
    return difference


if __name__ == "__main__":
    if len(sys.argv) not in (4, 5):
        sys.exit(__doc__)
    main(*sys.argv[1:])
