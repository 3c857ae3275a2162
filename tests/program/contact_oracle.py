# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Where a rounded block touches its base, from the rounded outline itself.

Outline and profile are rationals. A tangent point is a rational where both edges have rational
lengths, else it is taken to 10^-90, far below what anything here is compared to; points nearer than
10^-70 are the same. The rock reaches down without end below the profile: its ends are upright
faces. Shares no code with Topple."""

from decimal import Decimal, localcontext
from fractions import Fraction
import math

import exact
from limit_oracle import corner, cross2, minus, unit

NEAR = Fraction(1, 10**70)
DEEP = 1000


def root(square):
    """The square root of a rational."""
    square = Fraction(square)
    p, q = math.isqrt(square.numerator), math.isqrt(square.denominator)
    if p * p == square.numerator and q * q == square.denominator:
        return Fraction(p, q)
    with localcontext() as context:
        context.prec = 100
        return Fraction((Decimal(square.numerator) / Decimal(square.denominator)).sqrt())


def dot2(a, b):
    return a[0] * b[0] + a[1] * b[1]


def at(a, d, s):
    return a[0] + s * d[0], a[1] + s * d[1]


def tangent_length(outline, k, radius):
    """r / tan(theta / 2) with theta from the cosine and sine of the angle between the edges."""
    v = outline[k]
    u, w = minus(outline[(k + 1) % len(outline)], v), minus(outline[k - 1], v)
    size = root(dot2(u, u)) * root(dot2(w, w))
    return Fraction(radius) * (size + dot2(u, w)) / cross2(u, w)


class Rounded:
    """The outline, counter-clockwise, with rounded corners {vertex: radius}."""

    def __init__(self, outline, corners):
        self.outline = outline
        self.corners = {k: r for k, r in corners.items() if r > 0}
        self.lengths = {k: tangent_length(outline, k, r) for k, r in self.corners.items()}
        count = len(outline)
        self.pieces = []  # (vertex, direction, first and last share of the edge that is left)
        for k, v in enumerate(outline):
            d = minus(outline[(k + 1) % count], v)
            size = root(dot2(d, d))
            first = self.lengths.get(k, 0) / size
            last = 1 - self.lengths.get((k + 1) % count, 0) / size
            self.pieces.append((v, d, Fraction(first), Fraction(last)))

    def fits(self):
        return all(last - first > -NEAR for _, _, first, last in self.pieces)

    def arc(self, k):
        """Centre, radius and tangent points of a corner."""
        v, d, first, _ = self.pieces[k]
        after = at(v, d, first)
        w, e, _, last = self.pieces[k - 1]
        before = at(w, e, last)
        size = root(dot2(d, d))
        r = Fraction(self.corners[k])
        return (after[0] - r * d[1] / size, after[1] + r * d[0] / size), r, before, after

    def centroid(self, model):
        """Of the sharp outline, or less the tips: kites less sectors of pi - theta."""
        area, sx, sy = exact.ring_moments(self.outline)[:3]
        if model == "exact":
            for k in self.corners:
                v = self.outline[k]
                centre, r, before, after = self.arc(k)
                kite = exact.ring_moments([before, v, after, centre])
                # tan(theta / 2) = r / l, and the sector's half angle is what is left of a quarter turn
                half = Fraction(exact.atan(exact.decimal(self.lengths[k] / r)))
                part = r * r * half
                far = root(dot2(minus(v, centre), minus(v, centre)))
                sine = self.lengths[k] / far  # of the half angle
                out = Fraction(2, 3) * r * sine / half / far
                place = at(centre, minus(v, centre), out)
                area -= kite[0] - part
                sx -= kite[1] - part * place[0]
                sy -= kite[2] - part * place[1]
        return sx / area, sy / area


class Contact:
    """Facets (from, to, t), touching points (at, t), points that restrain nothing, and the facets
    of positive length counted by pairs of edges."""

    def __init__(self, block, profile):
        low = min(y for _, y in profile + block.outline) - DEEP
        self.rock = [(profile[0][0], low), *profile, (profile[-1][0], low)]
        self.facets, self.points, self.corners = [], set(), set()
        for piece in block.pieces:
            self.along_edge(piece)
        for k, v in enumerate(block.outline):
            if k not in block.corners:
                self.at_vertex(block.outline, k, v)
        ends = {(same(p), unit(t)) for f in self.facets for p, t in ((f[0], f[2]), (f[1], f[2]))}
        self.points = {(p, t) for p, t in self.points if (same(p), t) not in ends}
        places = {p for p, _ in ends} | {same(p) for p, _ in self.points}
        self.corners = {p for p in self.corners if same(p) not in places}

    def along_edge(self, piece):
        v, d, first, last = piece
        square = dot2(d, d)
        for b0, b1 in zip(self.rock, self.rock[1:]):
            e = minus(b1, b0)
            if cross2(d, e) != 0 or dot2(d, e) <= 0 or cross2(d, minus(b0, v)) != 0:
                continue
            low = max(first, dot2(d, minus(b0, v)) / square)
            high = min(last, dot2(d, minus(b1, v)) / square)
            if high - low > NEAR:
                self.facets.append((at(v, d, low), at(v, d, high), d))
            elif high - low > -NEAR and (last - first < NEAR or 0 < low < 1):
                self.points.add((at(v, d, low), unit(d)))  # a tangent point, or all that is left of the edge
        for q in self.rock:
            r = minus(q, v)
            s = dot2(d, r) / square
            if cross2(d, r) == 0 and 0 < s < 1 and first - NEAR < s < last + NEAR:
                self.points.add((q, unit(d)))

    def at_vertex(self, outline, k, v):
        before, after = minus(v, outline[k - 1]), minus(outline[(k + 1) % len(outline)], v)
        for j, q in enumerate(self.rock):
            if q != v:
                continue
            up, down = corner(self.rock, j, False), corner(outline, k, True)
            if up is not None and up > 0:
                self.points |= {(v, unit(minus(q, self.rock[j - 1]))), (v, unit(minus(self.rock[j + 1], q)))}
            elif down < 0:
                self.points |= {(v, unit(before)), (v, unit(after))}
            elif up == 0:
                self.points.add((v, unit(minus(self.rock[j + 1], q))))
            elif down == 0:
                self.points.add((v, unit(after)))
            else:
                self.corners.add(v)
            return
        for b0, b1 in zip(self.rock, self.rock[1:]):
            d, r = minus(b1, b0), minus(v, b0)
            if cross2(d, r) == 0 and 0 < dot2(d, r) < dot2(d, d):
                self.points.add((v, unit(d)))

    def cone_points(self):
        """(place, t) of everything that restrains."""
        found = {(same(p), unit(t)) for f in self.facets for p, t in ((f[0], f[2]), (f[1], f[2]))}
        return sorted(found | {(same(p), t) for p, t in self.points})

    def places(self):
        return sorted({p for p, _ in self.cone_points()} | {same(p) for p in self.corners})

    def restraints(self):
        """(first end, last end, t)."""
        return self.facets + [(p, p, t) for p, t in self.points]

    def admissible(self, p, towards):
        """Does turning about p press no facet in (Reuleaux)?"""
        for q0, q1, t in self.restraints():
            side = dot2(minus(q0, p), t) if towards == "left" else dot2(minus(p, q1), t)
            if side < -NEAR:
                return False
        return True

    def length(self):
        return sum(root(dot2(minus(b, a), minus(b, a))) for a, b, _ in self.facets)

    def sliding(self, centroid, friction_deg, towards):
        """Patton's phi + i of the governing facet, in degrees; None where one stands in the way or
        nothing touches that could govern; 'never' from 90 degrees on."""
        sign = 1 if towards == "left" else -1

        def steepest(facets):
            best, blocked = None, False
            for _, _, t in facets:
                run, rise = t[0], -sign * t[1]
                if run <= 0:
                    blocked |= rise > 0
                elif best is None or rise * best[0] > best[1] * run:
                    best = (run, rise)
            return best, blocked

        reach = [f for f in self.restraints()
                 if (min(f[0][0], f[1][0]) < centroid[0] - NEAR if sign > 0
                     else max(f[0][0], f[1][0]) > centroid[0] + NEAR)]
        best, blocked = steepest(reach)
        angle = lambda b: float(friction_deg) + math.degrees(math.atan2(b[1], b[0]))
        level = best is not None and (best[1] < 0 and angle(best) < 1e-9 or friction_deg == 0 and best[1] == 0)
        if not blocked and (best is None or level):
            best, blocked = steepest(self.restraints())
        if blocked:
            return "never"
        if best is None:
            return None
        return "never" if angle(best) > 90 - 1e-9 else angle(best)


def same(p):
    """A place to 10^-80, so that equal places found by two ways compare equal."""
    return tuple(c if c.denominator < 10**40 else Fraction(round(c * 10**80), 10**80) for c in map(Fraction, p))


def distance_to_segment(p, a, b):
    d = minus(b, a)
    s = min(1.0, max(0.0, dot2(minus(p, a), d) / dot2(d, d)))
    return math.dist(p, at(a, d, s))
