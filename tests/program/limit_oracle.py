# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The static limit by brute force in whole numbers: every pair of cone edges, primal and dual.

The wrenches (f_x, f_y, moment) of a base are the cone of its columns c. The loads at the tilt with
tangent t are F_c + t F_s up to a positive factor; the block holds where -(F_c + t F_s) lies in the
cone. By Caratheodory it then lies, shadowed along F_s, in the cone of two columns: all pairs give
all ends of the range of t. Each pair's normal with no column against it bounds t from the other
side. Both searches must meet, which proves each answer on the spot. Towards the left; a tilt to the
right is that of the mirror image."""

import math
from fractions import Fraction

import exact

SCALE = 10**50


def tangents(angle_degrees):
    """Whole numbers (p, q) with p/q below and above tan(angle), equal where it is rational."""
    angle = Fraction(angle_degrees)
    if angle in (0, 45):
        return ((int(angle / 45), 1),)
    sine, cosine = exact.sin_cos(angle)
    middle = int(sine / cosine * SCALE)
    return ((middle - 10**8, SCALE), (middle + 10**8, SCALE))


def cross2(a, b):
    return a[0] * b[1] - a[1] * b[0]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def minus(p, q):
    return p[0] - q[0], p[1] - q[1]


def along(p, a, b):
    """Where p lies on the segment a b: 0 to 1, or None."""
    d, r = minus(b, a), minus(p, a)
    if cross2(d, r) != 0:
        return None
    part = (r[0] * d[0] + r[1] * d[1]) / (d[0] * d[0] + d[1] * d[1])
    return part if 0 <= part <= 1 else None


def corner(chain, k, closed):
    """Turn of a chain at vertex k: above zero to the left; None at its ends."""
    if not closed and k in (0, len(chain) - 1):
        return None
    before, own, after = chain[k - 1], chain[k], chain[(k + 1) % len(chain)]
    return cross2(minus(own, before), minus(after, own))


def contacts(outline, profile):
    """(x, y, t) for every end of every facet and every touching point; outline counter-clockwise,
    t its direction or the profile's. A straight vertex is an inner point of an edge."""
    found = set()
    block = list(zip(outline, outline[1:] + outline[:1]))
    base = list(zip(profile, profile[1:]))
    for a0, a1 in block:
        for b0, b1 in base:
            d, e = minus(a1, a0), minus(b1, b0)
            if cross2(d, e) != 0 or d[0] * e[0] + d[1] * e[1] <= 0 or cross2(d, minus(b0, a0)) != 0:
                continue
            ends = {p for p in (a0, a1) if along(p, b0, b1) is not None}
            ends |= {p for p in (b0, b1) if along(p, a0, a1) is not None}
            if len(ends) == 2:
                found |= {(p, unit(d)) for p in ends}
    for k, p in enumerate(outline):
        for j, q in enumerate(profile):
            if p == q:
                up, down = corner(profile, j, False), corner(outline, k, True)
                if (up or 0) > 0:
                    found |= {(p, unit(minus(q, profile[j - 1]))),
                              (p, unit(minus(profile[j + 1], q)))}
                elif down < 0:
                    found |= {(p, unit(minus(p, outline[k - 1]))),
                              (p, unit(minus(outline[(k + 1) % len(outline)], p)))}
                elif up == 0:
                    found.add((p, unit(minus(profile[j + 1], q))))
                elif down == 0:
                    found.add((p, unit(minus(outline[(k + 1) % len(outline)], p))))
        for b0, b1 in base:
            if p not in (b0, b1) and along(p, b0, b1) is not None:
                found.add((p, unit(minus(b1, b0))))
    for q in profile:
        for a0, a1 in block:
            if q not in (a0, a1) and along(q, a0, a1) is not None:
                found.add((q, unit(minus(a1, a0))))
    return sorted(found)


def unit(d):
    """The direction in lowest whole numbers."""
    x, y = Fraction(d[0]), Fraction(d[1])
    factor = math.lcm(x.denominator, y.denominator)
    x, y = int(x * factor), int(y * factor)
    shared = math.gcd(x, y)
    return x // shared, y // shared


class Limit:
    """Feasible range of t for contact points, the centroid and tan(phi) = p/q, one pair (p, q) or a list of
    one for each point; `shift` is k_h."""

    def __init__(self, points, centroid, tangent, shift=Fraction(0)):
        tangents_of = tangent if isinstance(tangent, list) else [tangent] * len(points)
        self.points = points
        down, across = self.load(centroid, (-shift, -1)), self.load(centroid, (-1, shift))
        both = whole(down + across)
        self.down, self.across = both[:3], both[3:]
        columns = set()
        for ((x, y), (tx, ty)), (p, q) in zip(points, tangents_of):
            for side in (1, -1):
                fx, fy = -ty * q + side * tx * p, tx * q + side * ty * p
                columns.add(whole((fx, fy, x * fy - y * fx)))
        self.columns = sorted(columns)
        low, high = self.ends()
        self.most, self.mechanisms = self.bounds(1)
        self.least, _ = self.bounds(-1)
        if low is None:
            self.kind = "nowhere"
        elif self.most is None:
            self.kind = "interlocked"
        else:
            self.kind = "angle"
            assert self.most == high, "primal and dual do not meet"
        assert low is None or self.least in (None, low), "primal and dual do not meet"

    def holds(self, t):
        """Do forces hold the block at the tilt of tangent t?"""
        return (self.kind != "nowhere" and (self.least is None or self.least <= t)
                and (self.most is None or t <= self.most))

    @staticmethod
    def load(at, force):
        return (*force, at[0] * force[1] - at[1] * force[0])

    def pairs(self):
        for k, a in enumerate(self.columns):
            for b in self.columns[:k]:
                normal = cross(a, b)
                pull = dot(normal, self.across)
                if pull != 0:
                    yield a, b, normal, pull

    def ends(self):
        """Least and largest t of all basic solutions; None, None where there is none."""
        values = []
        for a, b, normal, pull in self.pairs():
            work = dot(normal, self.down)  # t = -work / pull
            rest = [work * s - pull * d for d, s in zip(self.down, self.across)]
            if pull < 0:
                rest = [-r for r in rest]
            if dot(cross(rest, a), normal) <= 0 <= dot(cross(rest, b), normal):
                values.append(Fraction(-work, pull))
        return (min(values), max(values)) if values else (None, None)

    def bounds(self, way):
        """The bound on t upwards (way 1) or downwards (-1), None where there is none, and its
        mechanisms: twists in lowest terms."""
        best, twists = None, set()
        for _, _, normal, pull in self.pairs():
            if way * pull < 0:
                normal, pull = tuple(-n for n in normal), -pull
            t = Fraction(-dot(normal, self.down), pull)
            if best is not None and way * t > way * best:
                continue
            if any(dot(normal, c) < 0 for c in self.columns):
                continue
            if best is None or t != best:
                best, twists = t, set()
            twists.add(whole(normal))
        return best, {twist: self.mechanism(twist) for twist in twists}

    def mechanism(self, twist):
        x, y, omega = twist
        if omega == 0:
            return "slides", None
        centre = Fraction(-y, omega), Fraction(x, omega)
        at_contact = any(centre == point for point, _ in self.points)
        return ("topples" if at_contact else "slides and topples"), centre


def whole(vector):
    """The same direction in lowest whole numbers."""
    factor = 1
    for v in vector:
        factor = math.lcm(factor, Fraction(v).denominator)
    numbers = [int(v * factor) for v in vector]
    shared = math.gcd(*numbers)
    return tuple(n // shared for n in numbers)
