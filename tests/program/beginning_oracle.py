# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Whether a motion of many blocks that is told obeys Newton's and Coulomb's laws, in rationals: written from the mechanics, from the
outlines of a scene and from what each contact is said to do, sharing no code with Topple. Tangents are rational to 40 digits; what
must not be negative may be so by 1e-20."""

from fractions import Fraction

import exact
from onset_oracle import gyration, maximise

ROUND = Fraction(1, 10**20)


def tangent(degrees):
    sine, cosine = exact.sin_cos(degrees)
    return Fraction(sine) / Fraction(cosine)


def centroid(points):
    area = x = y = Fraction(0)
    for (x0, y0), (x1, y1) in zip(points, points[1:] + points[:1]):
        c = Fraction(x0 * y1 - x1 * y0)
        area += c / 2
        x += c * (x0 + x1) / 6
        y += c * (y0 + y1) / 6
    return area, x / area, y / area


def eliminate(rows):
    """Sparse rows {column: entry, -1: right-hand side} as {column: what it is by those that are left free}; None: there is no solution."""
    solved = {}
    for row in rows:
        row = dict(row)
        while True:
            known = next((c for c in row if c in solved), None)
            if known is None:
                break
            factor = row.pop(known)
            for c, entry in solved[known].items():
                row[c] = row.get(c, 0) - factor * entry
                if row[c] == 0:
                    del row[c]
        own = [c for c in row if c >= 0]
        if not own:
            if abs(row.get(-1, 0)) > ROUND:
                return None
            continue
        share = row.pop(own[0])
        row = {c: entry / share for c, entry in row.items()}
        for other in solved.values():
            if own[0] in other:
                factor = other.pop(own[0])
                for c, entry in row.items():
                    other[c] = other.get(c, 0) - factor * entry
                    if other[c] == 0:
                        del other[c]
        solved[own[0]] = row
    return solved


def by_free(row, solved):
    """A sum of columns as {free column: entry, -1: number}."""
    own = {-1: Fraction(0)}
    for k, entry in row.items():
        if k not in solved:
            own[k] = own.get(k, 0) + entry
            continue
        for c, more in solved[k].items():
            own[c] = own.get(c, 0) + (entry * more if c == -1 else -entry * more)
    return own


def is_possible(sums):
    """Can free columns keep all these from being negative, but for what was rounded?"""
    free = sorted({k for own in sums for k, entry in own.items() if k >= 0 and entry != 0})
    if not free:
        return all(own[-1] >= -ROUND for own in sums)
    rows = [([-own.get(k, 0) for k in free], own[-1] + ROUND, False) for own in sums]
    return maximise([Fraction(0)] * len(free), rows, range(len(free))) is not None


class Beginning:
    """A pile of blocks, of which a case of JSON tells a motion: `holds` says why it is none, or ''."""

    def __init__(self, pile, friction, contacts, case):
        self.start = case["start"]
        self.outlines = {name: [(Fraction(str(x)), Fraction(str(y))) for x, y in points] for name, points, _ in pile.blocks}
        self.free = [name for name, _, ground in pile.blocks if not ground]
        self.frictions = {frozenset((a, b)): phi for a, b, phi in pile.joints}
        self.friction, self.contacts = friction, contacts
        self.side = -1 if case["towards"] == "left" else 1
        self.mass = {name: centroid(self.outlines[name]) for name in self.free}

    def end(self, contact, which):
        return tuple(Fraction(contact[f"{which}_{axis}_m"]["value"]).limit_denominator(10**7) for axis in "xy")

    def direction(self, contact):
        """Of the contact, with the first block on its left."""
        start, end = self.end(contact, "from"), self.end(contact, "to")
        if start != end:
            return end[0] - start[0], end[1] - start[1]
        ring = self.outlines[contact["first"]]
        for (x0, y0), (x1, y1) in zip(ring, ring[1:] + ring[:1]):
            if (x1 - x0) * (start[1] - y0) == (y1 - y0) * (start[0] - x0):
                if min(x0, x1) <= start[0] <= max(x0, x1) and min(y0, y1) <= start[1] <= max(y0, y1):
                    if not self.is_shared(contact, x1 - x0, y1 - y0, start):
                        return x1 - x0, y1 - y0
        raise AssertionError(contact)

    def is_shared(self, corner, dx, dy, point):
        """Do the two blocks of a corner share a piece of the edge through it? In a notch it touches the other flank."""
        for contact in self.contacts:
            if {contact["first"], contact["second"]} == {corner["first"], corner["second"]} and not contact["corner"]:
                start, end = self.end(contact, "from"), self.end(contact, "to")
                if all(dx * (p[1] - point[1]) == dy * (p[0] - point[0]) for p in (start, end)):
                    return True
        return False

    def row(self, contact, point, way):
        """{3 block + part: entry} of a unit along `way` at a point, on the first block and back on the second."""
        own = {}
        for name, sign in ((contact["first"], 1), (contact["second"], -1)):
            if name in self.mass:
                k = 3 * self.free.index(name)
                _, x, y = self.mass[name]
                own[k], own[k + 1] = sign * way[0], sign * way[1]
                own[k + 2] = sign * ((point[0] - x) * way[1] - (point[1] - y) * way[0])
        return {k: entry for k, entry in own.items() if entry != 0}

    def holds(self):
        tilt = self.side * tangent(self.start["tilt_angle_deg"])
        width = 3 * len(self.free)
        rows, forces, checks = [], [], []  # sums that are 0; forces, columns from `width` on; sums not below 0
        newton = [{-1: Fraction(0)} for _ in range(width)]
        for k, name in enumerate(self.free):
            area, x, y = self.mass[name]
            turning = area * gyration(self.outlines[name], (x, y))
            newton[3 * k].update({3 * k: area, -1: area * tilt})
            newton[3 * k + 1].update({3 * k + 1: area, -1: -area})
            newton[3 * k + 2].update({3 * k + 2: turning})

        def force(push):
            column = width + len(forces)
            forces.append(push)
            for k, entry in push.items():
                newton[k][column] = newton[k].get(column, 0) - entry
            return column

        for contact, touch in zip(self.contacts, self.start["touches"]):
            dx, dy = self.direction(contact)
            mu = tangent(self.frictions.get(frozenset((contact["first"], contact["second"])), self.friction)) \
                / Fraction(self.start["divisor"])
            ends = [("from", touch["first_end"])] + ([] if contact["corner"] else [("to", touch["second_end"])])
            states = {state for _, state in ends if state != "opens"}
            if len(states) > 1:
                return f"{contact} does two things"
            along = self.row(contact, self.end(contact, "from"), (dx, dy))
            normals = []
            for which, state in ends:
                point = self.end(contact, which)
                normal = self.row(contact, point, (-dy, dx))
                if state == "opens":
                    checks.append(normal)
                    continue
                rows.append(normal)
                push = dict(normal)
                if state != "sticks":
                    for k, entry in along.items():
                        push[k] = push.get(k, 0) - (mu if state == "slips forward" else -mu) * entry
                normals.append(force(push))
                checks.append({normals[-1]: 1})
            if states == {"sticks"}:
                rows.append(along)
                shear = force(along)
                checks += [{**{k: mu for k in normals}, shear: sign} for sign in (1, -1)]
            elif states:
                sign = 1 if states == {"slips forward"} else -1
                checks.append({k: sign * entry for k, entry in along.items()})
        solved = eliminate(rows + newton)
        if solved is None:
            return "no accelerations and forces"
        if all(abs(by_free({k: 1}, solved)[-1]) <= ROUND for k in range(width)):
            return "nothing moves"
        return "" if is_possible([by_free(row, solved) for row in checks]) else "a law is broken"
