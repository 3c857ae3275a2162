# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The cases of the benchmark of solids: closed surfaces of triangles with exact decimals, standing on z = 0 or on a plane parallel
to it."""

import math
import random
from fractions import Fraction

from cases import decimal, ring


def between(bottom, top, hubs=()):
    """Corners and triangles between two rings of as many points (x, y, z), counter-clockwise seen from above, and their caps,
    which are fans from the first point, or from a hub below and one above."""
    count = len(bottom)
    faces = [(0, k + 1, k) for k in range(1, count - 1)] + [(count, count + k, count + k + 1) for k in range(1, count - 1)]
    if hubs:
        faces = [face for k in range(count) for after in [(k + 1) % count]
                 for face in ((2 * count, after, k), (2 * count + 1, count + k, count + after))]
    for k in range(count):
        after = (k + 1) % count
        faces += [(k, after, count + after), (k, count + after, count + k)]
    return [*bottom, *top, *hubs], faces


def at_height(points, z):
    return [(x, y, Fraction(str(z))) for x, y in points]


def prism(points, height, shift=(0, 0)):
    x, y = (Fraction(str(v)) for v in shift)
    return between(at_height(points, 0), at_height([(a + x, b + y) for a, b in points], height))


def circle(count, radius, chance=None):
    """Points on decimals near a circle; with chance, at radii between a third and all of it."""
    radii = [radius * (chance.uniform(1 / 3, 1) if chance else 1) for _ in range(count)]
    return [(decimal(r * math.cos(2 * math.pi * k / count)), decimal(r * math.sin(2 * math.pi * k / count))) for k, r in enumerate(radii)]


def moved(solid, shift):
    points, faces = solid
    return [tuple(v + s for v, s in zip(p, shift)) for p in points], faces


def solids():
    """All solids, from easy to hard."""
    square, triangle = ring((-1, -1), (1, -1), (1, 1), (-1, 1)), ring((0, 0), (3, 0), (0, 4))
    half = ring(("-0.5", "-0.5"), ("0.5", "-0.5"), ("0.5", "0.5"), ("-0.5", "0.5"))
    corner = ring((0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3))
    chance = random.Random(5)
    star = between(at_height(circle(11, 1.0, chance), 0), at_height(circle(11, 1.2, chance), 3),
                   [(Fraction(0), Fraction(0), Fraction(0)), (Fraction(0), Fraction(0), Fraction(3))])
    narrow, wide = circle(9, 0.7), circle(9, 1.4)
    for number, (title, solid, friction) in enumerate((
            ("A cuboid 1 by 2 by 3", prism(ring((0, 0), (1, 0), (1, 2), (0, 2)), 3), 30),
            ("A frustum of a pyramid", between(at_height(square, 0), at_height(half, 2)), 40),
            ("A prism on a triangle of 3, 4 and 5", prism(triangle, 6), 35),
            ("A leaning prism", prism(square, 4, ("0.6", "0.3")), 38),
            ("A rock wider above than below", between(at_height(narrow, 0), at_height(wide, "2.5")), 36),
            ("An angle, whose support reaches over its inner corner", prism(corner, 2), 55),
            ("A star of eleven drawn radii", star, 33),
            ("The frustum 4e9 m away", moved(between(at_height(square, 0), at_height(half, 2)),
                                             (Fraction(4 * 10**9), Fraction(-7 * 10**8), Fraction(10**6))), 40)), 1):
        yield {"name": f"solids_{number:02}", "group": "solids", "difficulty": number, "title": title, "solid": solid, "friction_deg": friction}
