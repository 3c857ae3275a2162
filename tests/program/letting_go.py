# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A rigid body let go on contact points with Coulomb friction, by a fixed-point iteration on the contact forces (De Saxcé and Feng 1998). It
enumerates no modes and solves no programs; where it converges to an acceleration, that motion can begin. Nothing of Topple takes part."""

import math


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def solved(m, right):
    """m x = right, three by three, by Cramer's rule."""
    det = dot(m[0], cross(m[1], m[2]))
    columns = list(zip(*m))
    return [dot(columns_k[0], cross(columns_k[1], columns_k[2])) / det
            for columns_k in ([list(right) if i == k else list(columns[i]) for i in range(3)] for k in range(3))]


def into_cone(force, n, mu):
    """The nearest force of the cone."""
    along = dot(force, n)
    across = [f - along * k for f, k in zip(force, n)]
    size = math.sqrt(dot(across, across))
    if size <= mu * along:
        return force
    if mu * size <= -along:
        return [0.0, 0.0, 0.0]
    share = (along + mu * size) / (1 + mu * mu)
    return [share * (k + mu * t / size) for k, t in zip(n, across)]


class Body:
    """Of mass one, its centroid at the origin; contacts are (point, unit normal, mu)."""

    def __init__(self, inertia, contacts):
        self.contacts = contacts
        self.count = 3 * len(contacts)
        inverse = [solved(inertia, [1.0 if i == k else 0.0 for i in range(3)]) for k in range(3)]
        units = [[1.0 if i == k else 0.0 for i in range(3)] for k in range(3)]
        self.delassus = [[0.0] * self.count for _ in range(self.count)]
        for i, (q, _, _) in enumerate(contacts):
            for k, unit in enumerate(units):
                moment = cross(q, unit)
                turn = [dot(row, moment) for row in inverse]
                for j, (r, _, _) in enumerate(contacts):
                    moved = [u + t for u, t in zip(unit, cross(turn, r))]
                    for axis in range(3):
                        self.delassus[3 * j + axis][3 * i + k] = moved[axis]

    def let_go(self, load, forces=None, rounds=4000, close=1e-12):
        """The largest acceleration of a contact point, from the given forces on; None where it does not converge."""
        f = list(forces or [0.0] * self.count)
        row = self.delassus
        steps = [1 / sum(row[3 * i + k][3 * i + k] for k in range(3)) for i in range(len(self.contacts))]
        for _ in range(rounds):
            change = 0.0
            for i, (_, n, mu) in enumerate(self.contacts):
                u = [load[k] + dot(row[3 * i + k], f) for k in range(3)]
                along = dot(u, n)
                slip = math.sqrt(max(0.0, dot(u, u) - along * along))
                own = into_cone([f[3 * i + k] - steps[i] * (u[k] + mu * slip * n[k]) for k in range(3)], n, mu)
                change = max(change, *(abs(own[k] - f[3 * i + k]) for k in range(3)))
                f[3 * i:3 * i + 3] = own
            if change < close:
                moved = [load[k % 3] + dot(row[k], f) for k in range(self.count)]
                return max(map(abs, moved))
        return None
