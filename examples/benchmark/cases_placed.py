# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The cases of the benchmark of blocks that do not stand level, and of blocks that do not fit their base."""

import math
import random
from fractions import Fraction

from cases import case, decimal, ring


def islands():
    """They move on a level table, are certain to stand between two tilts, and move again."""
    steep = [(0, "1.839"), ("1.131", "0.859"), (2, "0.14")], [("1.5", 6), ("-0.5", 6)]
    for title, friction, under, tops in (
            ("On a facet that rises against the tilt: it slides either way", 10, [(0, "0.8"), (2, 0)], [(2, 3), (0, 3)]),
            ("On a facet of 45 degrees: it slides, or topples", 30, [(0, 2), (2, 0)], [(2, 4), (0, 4)]),
            ("On two facets that flatten", 8, [(0, 1), (1, "0.2"), (2, 0)], [(2, 3), (0, 3)]),
            ("On two facets that steepen", 10, [(0, "1.833"), ("0.897", "1.309"), (2, "0.469")], [("1.5", "3.5"), ("-0.5", "3.5")]),
            ("A narrow island: it turns up-dip, stands, topples", 30, *steep),
            ("A narrower island", 20, *steep)):
        under, tops = ring(*under), ring(*tops)
        yield case("islands", title, under + tops, under, friction)


def drawn_profile(chance, count, width, relief):
    """Rock from -width to 2 width in so many pieces."""
    return [(decimal(Fraction(-1 + 3 * k / count) * width), decimal(relief * chance.uniform(0, 1))) for k in range(count + 1)]


def polygon(chance, corners, width, height):
    """A convex block: corners on an ellipse at drawn angles, two metres above the rock."""
    angles = sorted(2 * math.pi * (k + chance.uniform(0.15, 0.85)) / corners for k in range(corners))
    return [(decimal(width / 2 * (1 + math.cos(a))), decimal(2 + height / 2 * (1 + math.sin(a)))) for a in angles]


def unfitting():
    """Blocks that are set down on profiles that they do not fit: first they come to rest, on a level table, then it is tilted."""
    for seed, corners, pieces, relief, friction in ((3, 4, 6, 0.1, 30), (1, 5, 6, 0.2, 35), (4, 6, 8, 0.2, 32), (5, 6, 10, 0.3, 40),
                                                    (8, 7, 12, 0.4, 38), (7, 8, 16, 0.3, 45), (11, 9, 20, 0.5, 34), (9, 12, 30, 0.4, 36)):
        chance = random.Random(seed)
        block, base = polygon(chance, corners, 1.5, 1.2), drawn_profile(chance, pieces, 1.5, relief)
        yield case("unfitting profiles", f"Seed {seed}: {corners} corners on {pieces} pieces", block, base, friction, seed=seed, place="rest")


def placed():
    for make in (islands, unfitting):
        for number, own in enumerate(make(), 1):
            yield {"name": f"{own['group'].replace(' ', '_')}_{number:02}", "difficulty": number, **own}
