# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The benchmark's questions at one tilt, in rational numbers that share nothing with Topple: contacts of polygons, forces that
hold them by a linear program, and motions that can begin by trial of contact modes.

A body is its outline, counter-clockwise; rock is an outline that is fixed. A contact point is (body, other, (x, y), (t_x, t_y)):
t runs along the edge of `body`, which lies to its left, so that (-t_y, t_x) points into it. All is exact: bodies touch where
their coordinates say so."""

from fractions import Fraction


def minus(a, b):
    return a[0] - b[0], a[1] - b[1]


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def moments(ring):
    """Area, centroid and squared radius of gyration, by triangles from the first vertex."""
    x0, y0 = ring[0]
    own = [minus(p, (x0, y0)) for p in ring]
    area = sx = sy = polar = Fraction(0)
    for (ax, ay), (bx, by) in zip(own[1:], own[2:]):
        part = (ax * by - ay * bx) / 2
        area += part
        sx += part * (ax + bx) / 3
        sy += part * (ay + by) / 3
        polar += part * (ax * ax + ax * bx + bx * bx + ay * ay + ay * by + by * by) / 6
    gx, gy = sx / area, sy / area
    return area, (x0 + gx, y0 + gy), polar / area - gx * gx - gy * gy


def edges(points, is_ring):
    return list(zip(points, points[1:] + points[:1])) if is_ring else list(zip(points, points[1:]))


def share(p, a, b):
    """Where p lies on the segment from a to b, as a part of it; None beside it."""
    d, r = minus(b, a), minus(p, a)
    if cross(d, r) != 0:
        return None
    part = dot(r, d) / dot(d, d)
    return part if 0 <= part <= 1 else None


def touching(ring, other, other_is_ring=True):
    """Contact points ((x, y), t) of a body on another one, or on a profile from right to left: ends of shared stretches, and
    vertices of one within an edge of the other."""
    found, facets = set(), set()
    own, theirs = edges(ring, True), edges(other, other_is_ring)
    for a, b in own:
        d = minus(b, a)
        for c, e in theirs:
            if cross(d, minus(e, c)) == 0 and dot(d, minus(e, c)) < 0 and cross(d, minus(c, a)) == 0:
                ends = {p for p in (a, b) if share(p, c, e) is not None} | {p for p in (c, e) if share(p, a, b) is not None}
                if len(ends) == 2:
                    found |= {(p, d) for p in ends}
                    facets |= ends
    for p in ring:
        found |= {(p, minus(c, e)) for c, e in theirs if p not in facets and share(p, c, e) not in (None, 0, 1)}
    for q in other:
        found |= {(q, minus(b, a)) for a, b in own if q not in facets and share(q, a, b) not in (None, 0, 1)}
    found |= notched(other, ring, True) | {(p, (-x, -y)) for p, (x, y) in notched(ring, other, other_is_ring)}
    return sorted({(p, lowest(t)) for p, t in found})


def lowest(t):
    """The same direction, its larger part 1."""
    size = max(abs(t[0]), abs(t[1]))
    return t[0] / size, t[1] / size


def notched(corners, notch, is_ring):
    """A corner of one in a notch of the other bears on both sides of the notch: (point, direction of that side)."""
    found = set()
    for k, p in enumerate(notch):
        if p in corners and (is_ring or 0 < k < len(notch) - 1):
            before, after = minus(p, notch[k - 1]), minus(notch[(k + 1) % len(notch)], p)
            if cross(before, after) < 0:
                found |= {(p, before), (p, after)}
    return found


class Program:
    """max c x where A x = b, x >= 0, in whole numbers by Edmonds' pivots and Bland's rule: `solve` gives the value, None where
    nothing is feasible, or "unbounded"."""

    def __init__(self, columns, right):
        count = len(right)
        rows = [[column[i] for column in columns] + [right[i]] for i in range(count)]
        self.table = []
        for i, row in enumerate(rows):
            row = [-v for v in row] if row[-1] < 0 else row
            scale = 1
            for v in row:
                scale = scale * Fraction(v).denominator // gcd(scale, Fraction(v).denominator)
            self.table.append([int(v * scale) for v in row[:-1]] + [int(i == j) for j in range(count)] + [int(row[-1] * scale)])
        self.width, self.basis, self.last = len(columns), [len(columns) + i for i in range(count)], 1

    def pivot(self, row, column):
        """One step without fractions: every row over the last pivot divides evenly."""
        own, value = self.table[row], self.table[row][column]
        for i, other in enumerate(self.table):
            if i != row:
                factor = other[column]
                self.table[i] = ([(value * v - factor * w) // self.last for v, w in zip(other, own)] if factor
                                 else [value * v // self.last for v in other])
        self.last = value
        self.basis[row] = column

    def climb(self, goal, allowed):
        """Whole-number costs, appended as a row of reduced ones."""
        self.table.append([v * self.last for v in goal])
        for i, column in enumerate(self.basis):
            factor = self.table[-1][column]
            if factor:
                self.table[-1] = [v - factor * w // self.last for v, w in zip(self.table[-1], self.table[i])]
        while True:
            cost = self.table[-1]
            enter = next((k for k in range(allowed) if cost[k] > 0), None)
            if enter is None:
                return -Fraction(self.table.pop()[-1], self.last)
            leave = None
            for i, row in enumerate(self.table[:-1]):
                if row[enter] > 0:
                    if leave is None:
                        leave = i
                        continue
                    one, other = row[-1] * self.table[leave][enter], self.table[leave][-1] * row[enter]
                    if one < other or (one == other and self.basis[i] < self.basis[leave]):
                        leave = i
            if leave is None:
                self.table.pop()
                return "unbounded"
            self.pivot(leave, enter)

    def solve(self, cost=None):
        count = len(self.basis)
        if self.climb([0] * self.width + [-1] * count + [0], self.width) != 0:
            return None
        if cost is None:
            return Fraction(0)
        for i in range(count):  # an artificial variable that is left is zero: out with it, or its row says nothing
            if self.basis[i] >= self.width:
                enter = next((k for k in range(self.width) if self.table[i][k]), None)
                if enter is not None:
                    if self.table[i][enter] < 0:
                        self.table[i] = [-v for v in self.table[i]]
                    self.pivot(i, enter)
        scale = 1
        for v in cost:
            scale = scale * Fraction(v).denominator // gcd(scale, Fraction(v).denominator)
        value = self.climb([int(v * scale) for v in cost] + [0] * (count + 1), self.width)
        return value if isinstance(value, str) else value / scale


def gcd(a, b):
    while b:
        a, b = b, a % b
    return a


def cone(contact, friction, about):
    """Both edges of the cone of forces on the body at a contact point, as wrenches (f_x, f_y, moment)."""
    (x, y), (tx, ty) = contact
    size = max(abs(tx), abs(ty))
    tx, ty, x, y = tx / size, ty / size, x - about[0], y - about[1]
    for side in (1, -1):
        fx, fy = -ty + side * friction * tx, tx + side * friction * ty
        yield fx, fy, x * fy - y * fx


def holds(bodies, contacts, applied):
    """Do forces at the contacts balance what acts on the bodies? `contacts` are (body, other, (point, t), friction), other None
    for rock; `applied` (f_x, f_y, moment about the origin) of each body."""
    columns = []
    for body, other, contact, friction in contacts:
        for wrench in cone(contact, friction, (0, 0)):
            column = [Fraction(0)] * (3 * bodies)
            for k, v in enumerate(wrench):
                column[3 * body + k] = v
                if other is not None:
                    column[3 * other + k] = -v
            columns.append(column)
    return Program(columns, [-v for own in applied for v in own]).solve() is not None


class Beginning:
    """Motions of one body from rest, mass 1, under `applied` (f_x, f_y, moment about the centroid). Its acceleration a is that of
    `applied` and of the forces; at each contact point it parts, sticks or slips by Coulomb's law. As forces do no work on
    such a motion, a M a <= applied . a, and one begins only where applied . a can be above zero: its largest value over all
    modes, branch by branch."""

    def __init__(self, contacts, friction, centroid, gyration, applied):
        self.friction, self.applied = friction, applied
        self.inverse = (Fraction(1), Fraction(1), 1 / gyration)
        self.contacts = []
        for (x, y), (tx, ty) in contacts:
            size = max(abs(tx), abs(ty))
            tx, ty, x, y = tx / size, ty / size, x - centroid[0], y - centroid[1]
            normal, slip = (-ty, tx, x * tx + y * ty), (tx, ty, x * ty - y * tx)
            self.contacts.append((normal, slip))
        self.tried = 0

    def begins(self):
        return self.branch([])

    def branch(self, states):
        value = self.best(states)
        if value is None or (value != "unbounded" and value <= 0):
            return False
        if len(states) == len(self.contacts):
            return True
        return any(self.branch([*states, state]) for state in ("parts", "sticks", "up", "down"))

    def best(self, states):
        """The largest applied . a where the first contacts are in these states and the others press somehow."""
        self.tried += 1
        forces, rows = [], []  # rows: (acceleration's coefficients, is it zero, or at least zero)
        for k, (normal, slip) in enumerate(self.contacts):
            state = states[k] if k < len(states) else None
            sides = {"parts": (), "up": (-1,), "down": (1,)}.get(state, (1, -1))
            forces += [tuple(n + side * self.friction * s for n, s in zip(normal, slip)) for side in sides]
            rows.append((normal, state not in ("parts", None)))
            if state == "sticks":
                rows.append((slip, True))
            elif state in ("up", "down"):
                rows.append((slip if state == "up" else tuple(-s for s in slip), False))
        def answer(row, wrench):
            return sum(r * m * v for r, m, v in zip(row, self.inverse, wrench))
        slacks = [i for i, (_, zero) in enumerate(rows) if not zero]
        columns = [[answer(row, f) for row, _ in rows] for f in forces]
        columns += [[Fraction(-(i == k)) for i in range(len(rows))] for k in slacks]
        right = [-answer(row, self.applied) for row, _ in rows]
        cost = [answer(self.applied, f) for f in forces] + [Fraction(0)] * len(slacks)
        value = Program(columns, right).solve(cost)
        return value if value is None or isinstance(value, str) else value + answer(self.applied, self.applied)
