# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What tests of solids know by a second route: moments, facets of the hull, poses and tilts in fractions, by trying all."""

import itertools
import math
from fractions import Fraction


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def ball(parts, cut):
    """A ball of radius 1 about the origin of so many meridians, cut flat at z = cut, to coordinates of 10^-9."""
    rings, low = parts // 2, math.acos(cut)
    points = [(0, 0, 1)]
    for j in range(1, rings + 1):
        polar = low * j / rings
        points += [(math.sin(polar) * math.cos(2 * math.pi * k / parts), math.sin(polar) * math.sin(2 * math.pi * k / parts),
                    cut if j == rings else math.cos(polar)) for k in range(parts)]
    points = [tuple(Fraction(round(x * 10 ** 9), 10 ** 9) for x in p) for p in points] + [(Fraction(0), Fraction(0), Fraction(cut).limit_denominator(10 ** 9))]
    faces = []
    for k in range(parts):
        after = (k + 1) % parts
        faces.append((0, 1 + k, 1 + after))
        for j in range(rings - 1):
            a, b = 1 + j * parts, 1 + (j + 1) * parts
            faces += [(a + k, b + k, b + after), (a + k, b + after, a + after)]
        last = 1 + (rings - 1) * parts
        faces.append((last + after, last + k, len(points) - 1))
    return points, faces


class Oracle:
    def __init__(self, points, faces):
        self.points, self.faces = points, faces
        if faces:
            self._moments()
        self.facets = self._facets()

    def _moments(self):
        volume6, first, second = Fraction(0), [Fraction(0)] * 3, [Fraction(0)] * 6
        pairs = ((0, 0), (1, 1), (2, 2), (1, 2), (2, 0), (0, 1))
        for face in self.faces:
            own = [self.points[k] for k in face]
            d = dot(own[0], cross(own[1], own[2]))
            volume6 += d
            total = [sum(p[k] for p in own) for k in range(3)]
            first = [f + d * t for f, t in zip(first, total)]
            second = [s + d * (sum(p[i] * p[j] for p in own) + total[i] * total[j]) for s, (i, j) in zip(second, pairs)]
        self.volume = volume6 / 6
        self.centroid = tuple(f / (4 * volume6) for f in first)
        self.inertia = [s / 120 - self.volume * self.centroid[i] * self.centroid[j] for s, (i, j) in zip(second, pairs)]

    def _facets(self):
        """Sets of points in one plane that has none beyond, with the normal out."""
        found = {}
        for three in itertools.combinations(range(len(self.points)), 3):
            a, b, c = (self.points[k] for k in three)
            normal = cross(minus(b, a), minus(c, a))
            sides = [dot(normal, minus(p, a)) for p in self.points]
            if normal == (0, 0, 0) or (max(sides) > 0 and min(sides) < 0):
                continue
            out = normal if max(sides) <= 0 else tuple(-x for x in normal)
            found[frozenset(k for k, side in enumerate(sides) if side == 0)] = out
        return found

    def edges(self, facet):
        """Counter-clockwise seen from outside, between corners."""
        normal = self.facets[facet]
        found = []
        for i, j in itertools.permutations(facet, 2):
            way = minus(self.points[j], self.points[i])
            if all(dot(cross(way, minus(self.points[k], self.points[i])), normal) > 0
                   or (cross(way, minus(self.points[k], self.points[i])) == (0, 0, 0)
                       and 0 <= dot(way, minus(self.points[k], self.points[i])) <= dot(way, way)) for k in facet):
                found.append((i, j))
        return found

    def ring(self, facet):
        after = dict(self.edges(facet))
        at = min(after)
        ring = [at]
        while after[ring[-1]] != at:
            ring.append(after[ring[-1]])
        return ring

    def arm2(self, facet, edge):
        """The distance of the foot from an edge, squared, with its sign."""
        i, j = edge
        normal, way = self.facets[facet], minus(self.points[j], self.points[i])
        s = dot(cross(way, minus(self.centroid, self.points[i])), normal)
        return Fraction(s) * abs(s) / (dot(way, way) * dot(normal, normal))

    def _angle(self, facet):
        """The share of all directions that passes through a facet."""
        total, ring = 0.0, self.ring(facet)
        for k in range(1, len(ring) - 1):
            a, b, c = (tuple(float(x) for x in minus(self.points[i], self.centroid)) for i in (ring[0], ring[k], ring[k + 1]))
            la, lb, lc = (math.sqrt(dot(v, v)) for v in (a, b, c))
            total += 2 * math.atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb)
        return total / (4 * math.pi)

    def poses(self):
        """(normal, share, least tan²) of each."""
        goes = {}
        for facet in self.facets:
            arms = {edge: self.arm2(facet, edge) for edge in self.edges(facet)}
            edge = min(arms, key=arms.get)
            goes[facet] = facet if arms[edge] > 0 else next(
                other for other in self.facets if other != facet and set(edge) <= other)
        shares = dict.fromkeys(self.facets, 0.0)
        for facet in self.facets:
            at = facet
            while goes[at] != at:
                at = goes[at]
            shares[at] += self._angle(facet)
        found = []
        for facet, normal in self.facets.items():
            if goes[facet] != facet:
                continue
            height = dot(normal, minus(self.points[min(facet)], self.centroid))
            tan2 = min(self.arm2(facet, edge) for edge in self.edges(facet)) * dot(normal, normal) / Fraction(height) ** 2
            size = math.sqrt(dot(normal, normal))
            found.append((tuple(x / size for x in map(float, normal)), shares[facet], tan2))
        return found

    def persistences(self):
        """Of each pose but the lowest, the least rise on a way to a pose as low or lower: the lowest passes between all pairs of
        facets, by trying every facet between (Floyd and Warshall)."""
        facets = list(self.facets)
        heights = [float(dot(self.facets[f], minus(self.points[min(f)], self.centroid))) / math.sqrt(dot(self.facets[f], self.facets[f]))
                   for f in facets]
        sides = {edge: k for k, f in enumerate(facets) for edge in self.edges(f)}
        arms = {edge: self.arm2(facets[k], edge) for edge, k in sides.items()}
        lowest = [[math.inf] * len(facets) for _ in facets]
        for (i, j), k in sides.items():
            other, own, beyond = sides[j, i], arms[i, j], arms[j, i]
            within = own > 0 and beyond > 0
            lowest[k][other] = max(heights[k], heights[other], math.sqrt(heights[k] ** 2 + float(own)) if within else 0)
        for via in range(len(facets)):
            for a in range(len(facets)):
                for b in range(len(facets)):
                    lowest[a][b] = min(lowest[a][b], max(lowest[a][via], lowest[via][b]))
        poses = [k for k, f in enumerate(facets) if min(self.arm2(f, edge) for edge in self.edges(f)) > 0]
        order = sorted(poses, key=lambda k: Fraction(dot(self.facets[facets[k]], minus(self.points[min(facets[k])], self.centroid))) ** 2
                       / dot(self.facets[facets[k]], self.facets[facets[k]]))  # exact: a pose may be lower by less than a double tells
        return sorted(min(lowest[k][g] for g in order[:n]) - heights[k] for n, k in enumerate(order) if n > 0)

    def lies(self, band):
        """As it lies: does it stand, its least tan², and its tilt towards an azimuth in degrees."""
        low = min(p[2] for p in self.points)
        flat = sorted({p[:2] for p in self.points if p[2] <= low + band})
        foot, height = self.centroid[:2], self.centroid[2] - low
        edges = [(p, q) for p, q in itertools.permutations(flat, 2)
                 if all((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]) > 0 or r in (p, q)
                        or ((q[0] - p[0]) * (r[1] - p[1]) == (q[1] - p[1]) * (r[0] - p[0])
                            and min(p, q) <= r <= max(p, q)) for r in flat)]
        arms = [((q[0] - p[0]) * (foot[1] - p[1]) - (q[1] - p[1]) * (foot[0] - p[0]), q[0] - p[0], q[1] - p[1]) for p, q in edges]
        if len({p for p, _ in edges}) < 3 or min(a for a, _, _ in arms) <= 0:
            return False, None, None

        def towards(azimuth):
            east, north = math.sin(math.radians(azimuth)), math.cos(math.radians(azimuth))
            reaches = [float(a) / (float(dy) * east - float(dx) * north) for a, dx, dy in arms if float(dy) * east - float(dx) * north > 1e-12]
            return math.degrees(math.atan(min(reaches) / float(height)))
        return True, min(Fraction(a) ** 2 / (dx * dx + dy * dy) for a, dx, dy in arms) / Fraction(height) ** 2, towards


def wrapped(points):
    """Facets as of Oracle, by wrapping: from a facet over each of its edges to the next (Chand and Kapur 1970). Exact for whole
    numbers; each edge takes one pass over all points, so that hundreds of points are soon done."""
    def plane(a, normal):
        return frozenset(k for k, p in enumerate(points) if dot(normal, minus(p, a)) == 0)

    def over(i, j, normal):
        """The normal of the plane through an edge, from i to j, of the facet beyond it."""
        a, best = points[j], None
        way = minus(points[i], a)
        for p in points:
            if dot(normal, minus(p, a)) == 0:
                continue
            if best is None or dot(cross(way, minus(best, a)), minus(p, a)) > 0:
                best = p
        return cross(way, minus(best, a))

    def ring(facet, normal):
        """Corners, counter-clockwise: from each to the one that has none of the others to its right, of those the farthest."""
        first = min(facet, key=lambda k: points[k])
        corners = [first]
        while True:
            at, best = points[corners[-1]], None
            for k in facet - {corners[-1]}:
                way = minus(points[k], at)
                side = -1 if best is None else dot(cross(minus(points[best], at), way), normal)
                if side < 0 or (side == 0 and dot(way, way) > dot(minus(points[best], at), minus(points[best], at))):
                    best = k
            if best == first:
                return corners
            corners.append(best)

    low = min(range(len(points)), key=lambda k: points[k])
    a = points[low]
    ahead = None  # seen from above, all are left of the way from the first point to this one
    for p in points:
        if p[:2] == a[:2]:
            continue
        if ahead is None or (ahead[0] - a[0]) * (p[1] - a[1]) - (ahead[1] - a[1]) * (p[0] - a[0]) < 0:
            ahead = p
    upright = (ahead[1] - a[1], a[0] - ahead[0], 0)
    on = sorted(plane(a, upright), key=lambda k: points[k])
    line = [k for k in on if cross(minus(points[on[-1]], a), minus(points[k], a)) != (0, 0, 0)]
    first = upright if line else over(on[0], on[-1], upright)
    found, waiting = {}, [(a, first)]
    while waiting:
        at, normal = waiting.pop()
        facet = plane(at, normal)
        if facet in found:
            continue
        assert all(dot(normal, minus(p, at)) <= 0 for p in points)
        found[facet] = normal
        corners = ring(facet, normal)
        waiting += [(points[i], over(i, j, normal)) for i, j in zip(corners, corners[1:] + corners[:1])]
    return found


class Wrapped(Oracle):
    """The same of many points, by wrapping."""

    def _facets(self):
        return wrapped(self.points)
