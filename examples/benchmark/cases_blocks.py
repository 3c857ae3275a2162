# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The cases of the benchmark of many blocks: outlines by name, counter-clockwise, with exact decimals; `ground` is rock. Blocks touch
where their edges coincide."""

import math
import random
from fractions import Fraction

from cases import decimal, ring


def box(x, y, width, height):
    x, y, width, height = (Fraction(str(v)) for v in (x, y, width, height))
    return [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]


FLOOR = ring((-20, -1), (20, -1), (20, 0), (-20, 0))


def stack(*boxes):
    return {"ground": FLOOR, **{f"block {k}": box(*own) for k, own in enumerate(boxes, 1)}}


def stepped(width, step, heights):
    """Columns on a stepped base, from the toe on the left."""
    count, width, step = len(heights), Fraction(str(width)), Fraction(str(step))
    top = [(k * width, y * step) for k in range(1, count + 1) for y in ((k - 1), min(k, count - 1))]
    floor = [(-width, Fraction(0)), *top, ((count + 1) * width, (count - 1) * step)]
    points = [p for k, p in enumerate(floor) if k == 0 or p != floor[k - 1]]
    ground = [(-width, Fraction(-5)), ((count + 1) * width, Fraction(-5)), *reversed(points)]
    return {"ground": ground, **{f"column {k + 1}": box(k * width, k * step, width, height) for k, height in enumerate(heights)}}


def wall(bricks, courses):
    """Running bond: bricks of 2 by 1, half ones at the ends of every other course."""
    boxes = []
    for course in range(courses):
        ends = [0, *range(1, 2 * bricks, 2), 2 * bricks] if course % 2 else list(range(0, 2 * bricks + 1, 2))
        boxes += [(a, course, b - a, 1) for a, b in zip(ends, ends[1:])]
    return stack(*boxes)


def arch(count, thickness, height):
    """Half a ring of mean radius 1 on two piers that are rock: corners on decimals, shared by neighbours."""
    rays = [(Fraction(math.cos(a)), Fraction(math.sin(a))) for a in (math.pi * k / count for k in range(count + 1))]
    inner, outer = Fraction(str(1 - thickness / 2)), Fraction(str(1 + thickness / 2))
    low, high = ([(decimal(r * x), decimal(r * y) + height) for x, y in rays] for r in (inner, outer))
    blocks = {f"voussoir {k + 1}": [low[k], high[k], high[k + 1], low[k + 1]] for k in range(count)}
    ground = ring((-3, -1), (3, -1), (3, 0), (outer, 0)) + [(outer, height), (inner, height), (inner, Fraction(0)), (-inner, Fraction(0)),
                                                         (-inner, height), (-outer, height), (-outer, Fraction(0)), (Fraction(-3), Fraction(0))]
    return {"ground": ground, **blocks}


def many():
    """All cases of many blocks."""
    chance = random.Random(11)
    drawn = [Fraction(chance.randint(8, 30), 10) for _ in range(7)]
    found = (
        ("A brick on a brick", stack((0, 0, 2, 1), ("0.25", 1, "1.5", 1)), 35),
        ("A brick that overhangs two others", stack((0, 0, 2, 1), ("-0.5", 1, 2, 1), ("-1", 2, 2, 1)), 40),
        ("A column behind a low block", stack((0, 0, 2, 1), (2, 0, 1, 5)), 31),
        ("A lintel on two pillars", stack((0, 0, "0.8", 3), (3, 0, "0.8", 3), ("-0.2", 3, "4.2", "0.6")), 32),
        ("Three columns on steps", stepped(1, "0.2", [Fraction(2), Fraction(4), Fraction(3)]), 33),
        ("A wall of two courses", wall(2, 2), 30),
        ("Seven columns of drawn heights on steps", stepped(1, "0.1", drawn), 34),
        ("An arch of five stones", arch(5, 0.3, 1), 38),
        ("A wall of five courses", wall(2, 5), 36),
        ("The slope of Goodman and Bray, sixteen columns",
         stepped(10, 1, [Fraction(h) for h in (*range(4, 41, 4), 34, 28, 22, 16, 10, 4)]), "38.15"))
    for number, (title, blocks, friction) in enumerate(found, 1):
        yield {"name": f"many_blocks_{number:02}", "group": "many blocks", "difficulty": number, "title": title, "blocks": blocks,
               "friction_deg": friction, "towards": "left"}
