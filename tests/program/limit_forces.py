# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The static limit under loads that do not turn with the tilt, by every pair of forces in floats.

The base can exert the cone of its edges, and on each facet a shear of either sense up to its
cohesion and a pull up to its bond. It holds the loads F(a) if no twist v that no edge resists has
v . F(a) > K(v), K what cohesion and bonds hold against v; twists normal to a pair of forces
suffice. Each excess v . F - K = A cos a + B sin a + C vanishes in closed form: between neighbouring
zeros of all of them nothing changes, so that one look in the middle of each gap gives the tilts that
hold, as intervals. Towards the left."""

import math


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def wrench(at, force):
    return (force[0], force[1], at[0] * force[1] - at[1] * force[0])


def normed(v):
    size = math.sqrt(dot(v, v))
    return tuple(x / size for x in v) if size > 1e-9 else None


class Base:
    """Facets as pairs of points from left to right, lengths in units of about one; one friction, or a list of one
    for each facet."""

    def __init__(self, facets, friction_deg, cohesion=0.0, bond=0.0):
        self.ends, edges, self.held = [], [], []
        each = friction_deg if isinstance(friction_deg, list) else [friction_deg] * len(facets)
        for (a, b), friction in zip(facets, each):
            tan = math.tan(math.radians(friction))
            length = math.dist(a, b)
            t = ((b[0] - a[0]) / length, (b[1] - a[1]) / length)
            n = (-t[1], t[0])
            self.ends += [a, b]
            for p in (a, b):
                for side in (tan, -tan):
                    edges.append(normed(wrench(p, (n[0] + side * t[0], n[1] + side * t[1]))))
            middle = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
            if cohesion > 0:
                self.held += [(wrench(a, t), cohesion * length),
                              (wrench(a, (-t[0], -t[1])), cohesion * length)]
            if bond > 0:
                self.held.append((wrench(middle, (-n[0], -n[1])), bond * length))
        columns = edges + [normed(h) for h, _ in self.held]
        self.twists = []
        for k, c in enumerate(columns):
            for d in columns[:k]:
                v = normed(cross(c, d))
                for side in (1, -1) if v is not None else ():
                    own = tuple(side * x for x in v)
                    if all(dot(own, e) >= -1e-11 for e in edges):
                        self.twists.append(own)

    def excesses(self, cosine, sine, one):
        """(A, B, C) for each twist, of loads F = cosine cos a + sine sin a + one."""
        for v in self.twists:
            held = sum(most * max(0.0, -dot(v, h)) for h, most in self.held)
            yield dot(v, cosine), dot(v, sine), dot(v, one) - held

    def intervals(self, cosine, sine, one):
        """Tilts in degrees, within (-90, 90), that the base holds."""
        functions = list(self.excesses(cosine, sine, one))
        cuts = [-90.0, 90.0]
        for a, b, c in functions:
            size = math.hypot(a, b)
            if size <= abs(c):
                continue
            middle, half = math.atan2(b, a), math.acos(-c / size)
            for angle in (middle - half, middle + half):
                degrees = math.degrees(math.remainder(angle, 2 * math.pi))
                if -90 < degrees < 90:
                    cuts.append(degrees)
        cuts.sort()
        found = []
        for low, high in zip(cuts, cuts[1:]):
            tilt = math.radians((low + high) / 2)
            if high - low < 1e-10 or any(a * math.cos(tilt) + b * math.sin(tilt) + c > 0
                                         for a, b, c in functions):
                continue
            if found and low - found[-1][1] < 1e-9:
                found[-1] = (found[-1][0], high)
            else:
                found.append((low, high))
        return found

    def mechanisms(self, degrees, loads, slack=1e-9):
        """Those of all twists whose excess vanishes at the tilt, as (name, centre)."""
        tilt, found = math.radians(degrees), []
        for v, (a, b, c) in zip(self.twists, self.excesses(*loads)):
            if abs(a * math.cos(tilt) + b * math.sin(tilt) + c) > slack * (1 + abs(c)):
                continue
            if abs(v[2]) < 1e-9:
                found.append(("slides", None))
                continue
            centre = (-v[1] / v[2], v[0] / v[2])
            at_contact = any(math.dist(centre, p) < 1e-6 for p in self.ends)
            found.append(("topples" if at_contact else "slides and topples", centre))
        return found
