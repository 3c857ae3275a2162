# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The static limit under cohesion, bonds and anchors by every twist, at 130 digits.

A twist v that no edge e of the contact's cones resists (v . e >= 0) lets the block go where
v . F > K(v), K the sum of what each bounded force can hold against it. F - K is convex and piecewise
linear over the cone of such twists, so only those count that two planes v . e = 0 or v . h = 0 of
edges and bounded forces have in common. Each vanishes where a cos + b sin + c = 0, whose zeros
(cos, sin) take a square root alone; sines order the tilts between -90 and 90 degrees. Coordinates and
loads are rationals, tan(phi) and lengths are decimals: what lies below 10^-100 of its terms counts as
zero, and no data of these tests are nearer than 10^-60. Towards the left."""

from decimal import Decimal

import exact

exact.set_digits(130)
ZERO = Decimal(10) ** -100


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def wrench(at, force):
    return (force[0], force[1], at[0] * force[1] - at[1] * force[0])


def normed(v):
    size = max(abs(x) for x in v)
    return tuple(x / size for x in v) if size > 0 else None


class Contact:
    """Facets as pairs of rational points from left to right, their strength divided by a number."""

    def __init__(self, facets, friction_deg, cohesion=0, bond=0, divisor=Decimal(1)):
        if friction_deg == 45:
            tan = Decimal(1)
        else:
            sine, cosine = exact.sin_cos(friction_deg)
            tan = sine / cosine
        tan /= divisor
        self.ends, edges, self.held = [], [], []
        for a, b in facets:
            a, b = (tuple(exact.decimal(x) for x in p) for p in (a, b))
            t = (b[0] - a[0], b[1] - a[1])
            n = (-t[1], t[0])
            self.ends += [a, b]
            for p in (a, b):
                edges += [normed(wrench(p, (n[0] + s * t[0], n[1] + s * t[1]))) for s in (tan, -tan)]
            # t is as long as the facet, so that a stress is the factor on it
            if cohesion:
                self.held += [(wrench(a, (s * t[0], s * t[1])), exact.decimal(cohesion) / divisor)
                              for s in (1, -1)]
            if bond:
                middle = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
                self.held.append((wrench(middle, (-n[0], -n[1])), exact.decimal(bond) / divisor))
        columns = edges + [normed(h) for h, _ in self.held]
        self.twists = []
        for k, c in enumerate(columns):
            for d in columns[:k]:
                v = cross(c, d)
                if max(abs(x) for x in v) < ZERO:
                    continue
                v = normed(v)
                for side in (1, -1):
                    own = tuple(side * x for x in v)
                    if all(dot(own, e) >= -ZERO for e in edges):
                        self.twists.append(own)

    def excesses(self, cosine, sine, one):
        """(v, a, b, c) for each twist, of loads cosine cos + sine sin + one."""
        for v in self.twists:
            held = sum(most * max(Decimal(0), -dot(v, h)) for h, most in self.held)
            yield v, dot(v, cosine), dot(v, sine), dot(v, one) - held

    def limit(self, loads):
        """The least tilt above level where an excess begins to rise above zero, in degrees, and the
        names of the mechanisms there; (None, None) where none does. None where level is not held."""
        first, names = None, None
        for v, a, b, c in self.excesses(*loads):
            if a + c > ZERO:
                return None
            sine = rising_sine(a, b, c)
            if sine is None or sine < -ZERO:
                continue
            if first is None or sine < first - ZERO:
                first, names = sine, set()
            if sine < first + ZERO:
                names.add(self.name(v))
        if first is None:
            return None, None
        return exact.degrees(exact.atan(first / (1 - first * first).sqrt())), names

    def name(self, v):
        if abs(v[2]) < ZERO:
            return "slides"
        centre = (-v[1] / v[2], v[0] / v[2])
        near = Decimal(10) ** -80  # the centre's own division loses some places
        at_end = any(max(abs(x - y) for x, y in zip(centre, p)) < near for p in self.ends)
        return "topples" if at_end else "slides and topples"


def rising_sine(a, b, c):
    """The sine of the tilt between -90 and 90 degrees at which a cos + b sin + c rises through zero:
    R cos(tilt - psi) + c does so before psi."""
    size2 = a * a + b * b
    rest = size2 - c * c
    if rest <= 0:
        return None
    root = rest.sqrt()
    # (cos, sin) = (-c (a, b) + root (b, -a)) / R^2 has the slope -a sin + b cos = root > 0
    cosine, sine = (-c * a + root * b) / size2, (-c * b - root * a) / size2
    return sine if cosine > 0 else None
