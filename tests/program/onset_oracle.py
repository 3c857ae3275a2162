# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Which motion can begin, by trial of every contact mode in whole numbers.

At each contact point the block parts, sticks, or slips one way or the other. Every combination that
some acceleration a = (a_x, a_y, theta) about the centroid has is put to a linear program in the
forces and t = tan(tilt), with M a = w(t) + forces put in; it says whether the mode is possible with
all that is strict about it strict, and between which t. Nothing is known of cones of loads, of
their bounds, or of which contacts matter. Towards the left; w(t) = (-t, -1, 0)."""

from fractions import Fraction
from itertools import combinations

PARTS, STICKS, UP, DOWN = "parts", "sticks", "slips up", "slips down"


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def sign(x):
    return (x > 0) - (x < 0)


def gyration(outline, centroid):
    """Square of the radius of gyration of a polygon about its centroid."""
    area = xx = Fraction(0)
    ring = [(Fraction(x) - centroid[0], Fraction(y) - centroid[1]) for x, y in outline]
    for (x0, y0), (x1, y1) in zip(ring, ring[1:] + ring[:1]):
        c = x0 * y1 - x1 * y0
        area += c / 2
        xx += c * (x0 * x0 + x0 * x1 + x1 * x1 + y0 * y0 + y0 * y1 + y1 * y1) / 12
    return xx / area


def maximise(cost, rows, free):
    """max cost . x subject to row . x <= bound or == bound, x >= 0 but for the `free`; rows are
    (coefficients, bound, is_equality). None: not possible; "unbounded". By Bland's rule."""
    width = len(cost)
    columns = [[1, k] for k in range(width)] + [[-1, k] for k in free]
    table, basis = [], []
    equal_or_slack = sum(not equality for _, _, equality in rows)
    total = len(columns) + equal_or_slack + len(rows)
    slack = 0
    for index, (coefficients, bound, equality) in enumerate(rows):
        row = [sgn * Fraction(coefficients[k]) for sgn, k in columns]
        row += [Fraction(0)] * (equal_or_slack + len(rows)) + [Fraction(bound)]
        if not equality:
            row[len(columns) + slack] = Fraction(1)
            slack += 1
        if row[-1] < 0:
            row = [-x for x in row]
        row[len(columns) + equal_or_slack + index] = Fraction(1)
        table.append(row)
        basis.append(len(columns) + equal_or_slack + index)
    artificial = len(columns) + equal_or_slack

    def run(goal, allowed):
        reduced = goal[:] + [Fraction(0)]
        for row, own in zip(table, basis):
            if reduced[own] != 0:
                factor = reduced[own]
                reduced = [x - factor * y for x, y in zip(reduced, row)]
        while True:
            enter = next((k for k in range(allowed) if reduced[k] > 0), None)
            if enter is None:
                return -reduced[-1]
            ratios = [(row[-1] / row[enter], basis[k], k) for k, row in enumerate(table)
                      if row[enter] > 0]
            if not ratios:
                return "unbounded"
            _, _, leave = min(ratios)
            pivot = table[leave][enter]
            table[leave] = [x / pivot for x in table[leave]]
            for k, row in enumerate(table):
                if k != leave and row[enter] != 0:
                    factor = row[enter]
                    table[k] = [x - factor * y for x, y in zip(row, table[leave])]
            factor = reduced[enter]
            reduced = [x - factor * y for x, y in zip(reduced, table[leave])]
            basis[leave] = enter

    if run([Fraction(0)] * artificial + [Fraction(-1)] * len(rows), total) != 0:
        return None
    for k in range(len(table)):  # what is left of the artificial ones is zero: out with it
        if basis[k] >= artificial:
            enter = next((j for j in range(artificial) if table[k][j] != 0), None)
            if enter is None:
                continue
            pivot = table[k][enter]
            table[k] = [x / pivot for x in table[k]]
            for j, row in enumerate(table):
                if j != k and row[enter] != 0:
                    factor = row[enter]
                    table[j] = [x - factor * y for x, y in zip(row, table[k])]
            basis[k] = enter
    goal = [sgn * Fraction(cost[k]) for sgn, k in columns] + [Fraction(0)] * (total - len(columns))
    return run(goal, artificial)


class Onset:
    """Windows of t for contact points ((x, y), (t_x, t_y)), the centroid, k^2 and tan(phi), one or a list of one
    for each point. `senses`, by point: 1, it bears as it slips up or sticks alone; -1, down or sticks; 0."""

    senses = None

    def __init__(self, points, centroid, gyration, tangent, senses=None):
        self.gyration, self.tangent, self.senses = gyration, tangent, senses
        self.contacts = []
        for (x, y), (tx, ty) in points:
            x, y = x - centroid[0], y - centroid[1]
            self.contacts.append(((x, y), (tx, ty), (-ty, tx, tx * x + ty * y),
                                  (tx, ty, ty * x - tx * y)))
        self.found = []  # (from, to, states), None for an end that there is not
        for states, twist in self.modes():
            ends = self.interval(states, twist)
            if ends is not None:
                self.found.append((*ends, states))
        self.windows = self.merge()

    def tangent_at(self, k):
        return self.tangent[k] if isinstance(self.tangent, list) else self.tangent

    def bears(self, k, state):
        return self.senses is None or self.senses[k] * {UP: 1, DOWN: -1}.get(state, 0) >= 0

    def modes(self):
        """The states of all contacts in every motion that the base admits; and the twist where every
        contact sticks, to tell both senses apart."""
        planes = [c[2] for c in self.contacts] + [c[3] for c in self.contacts]
        planes += [(1, 0, 0), (0, 1, 0), (0, 0, 1)]
        rays = set()
        for a, b in combinations(planes, 2):
            ray = cross(a, b)
            for own in (ray, tuple(-x for x in ray)):
                if any(own) and all(dot(c[2], own) >= 0 for c in self.contacts):
                    size = max(abs(x) for x in own)
                    rays.add(tuple(Fraction(x) / size for x in own))
        rays = sorted(rays)
        found = set()
        for count in (1, 2, 3):
            for chosen in combinations(rays, count):
                twist = [sum(own[k] for own in chosen) for k in range(3)]
                if any(twist):
                    states = tuple(self.state(c, twist) for c in self.contacts)
                    found.add((states, tuple(twist) if set(states) == {STICKS} else ()))
        return sorted(found)

    @staticmethod
    def state(contact, twist):
        if dot(contact[2], twist) > 0:
            return PARTS
        return {1: UP, -1: DOWN, 0: STICKS}[sign(dot(contact[3], twist))]

    def interval(self, states, twist):
        """(least, most) t of the mode, None for no end; None where it is not possible."""
        forces = []
        for k, (((x, y), (tx, ty), _, _), state) in enumerate(zip(self.contacts, states)):
            for side in {PARTS: (), STICKS: (1, -1), UP: (-1,), DOWN: (1,)}[state] if self.bears(k, state) else ():
                fx, fy = -ty + side * self.tangent_at(k) * tx, tx + side * self.tangent_at(k) * ty
                forces.append((fx, fy, (x * fy - y * fx) / self.gyration))
        count = len(forces)

        def along(row):
            """row . a as coefficients of the forces, t and s, and what is left: times -1, <= rest."""
            return [-dot(row, f) for f in forces] + [row[0]], -row[1]

        equal, strict = [], []
        for (_, _, normal, slip), state in zip(self.contacts, states):
            own, rest = along(normal)
            (strict if state == PARTS else equal).append((own, rest))
            if state in (UP, DOWN):
                own, rest = along(slip)
                strict.append((own, rest) if state == UP else ([-x for x in own], -rest))
            elif state == STICKS:
                equal.append(along(slip))
        if twist:
            strict.append(along(twist))
        rows = [(own + [0], rest, True) for own, rest in equal]
        rows += [(own + [1], rest, False) for own, rest in strict]
        rows.append(([0] * (count + 1) + [1], 1, False))
        slack = maximise([0] * (count + 1) + [1], rows, [count, count + 1])
        if slack is None or slack <= 0:
            return None
        rows = [(own, rest, True) for own, rest in equal] + [(own, rest, False)
                                                             for own, rest in strict]
        most = maximise([0] * count + [1], rows, [count])
        least = maximise([0] * count + [-1], rows, [count])
        return (None if least == "unbounded" else -least, None if most == "unbounded" else most)

    def merge(self):
        windows = []
        for low, high, _ in sorted(self.found, key=lambda f: (f[0] is not None, f[0] or 0)):
            if windows and (windows[-1][1] is None or low is None or low <= windows[-1][1]):
                if windows[-1][1] is not None:
                    windows[-1][1] = None if high is None else max(high, windows[-1][1])
            else:
                windows.append([low, high])
        return windows

    def names(self, t):
        """The mechanisms of the modes that hold t."""
        return {self.name(states) for low, high, states in self.found
                if (low is None or low <= t) and (high is None or t <= high)}

    def name(self, states):
        if all(state == PARTS for state in states):
            return "leaves its base"
        if STICKS in states:
            return "topples"
        closed = [c[2] for c, state in zip(self.contacts, states) if state != PARTS]
        turns = [cross(a, b)[2] for a, b in combinations(closed, 2) if any(cross(a, b))]
        return "slides" if turns and not any(turns) else "slides and topples"
