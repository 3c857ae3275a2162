# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Resting poses by brute force, in doubles: the block is lowered and turned in small steps, and each step in which
the two polygons overlap is halved until it is short. No event is computed; only `is a point in a polygon deep` is."""

import math

STEP = 2e-3  # radians of one step of a turn
DEEP = 1e-10  # a point is inside by more than this, in lengths of the scene: or it touches
NEAR = 1e-5  # what has touched is within this: errors of turns before, over shallow angles


def centroid(ring):
    area = x = y = 0.0
    for (x0, y0), (x1, y1) in zip(ring, ring[1:] + ring[:1]):
        cross = x0 * y1 - x1 * y0
        area += cross
        x += (x0 + x1) * cross
        y += (y0 + y1) * cross
    return x / (3 * area), y / (3 * area)


def height(profile, x):
    """Of the profile over x: None beside it."""
    tops = [y0 + (y1 - y0) * (x - x0) / (x1 - x0)
            for (x0, y0), (x1, y1) in zip(profile, profile[1:]) if x0 <= x <= x1 and x1 > x0]
    return max(tops) if tops else None


def distance(point, ring):
    """From the ring's boundary."""
    least = math.inf
    for (x0, y0), (x1, y1) in zip(ring, ring[1:] + ring[:1]):
        dx, dy = x1 - x0, y1 - y0
        share = max(0.0, min(1.0, ((point[0] - x0) * dx + (point[1] - y0) * dy) / (dx * dx + dy * dy)))
        least = min(least, math.hypot(point[0] - x0 - share * dx, point[1] - y0 - share * dy))
    return least


def inside(point, ring):
    odd = False
    for (x0, y0), (x1, y1) in zip(ring, ring[1:] + ring[:1]):
        if (y0 > point[1]) != (y1 > point[1]) and point[0] < x0 + (x1 - x0) * (point[1] - y0) / (y1 - y0):
            odd = not odd
    return odd


def deepest(block, rock):
    """How deep a vertex of either lies in the other; below zero: how far the closest is away."""
    most = -math.inf
    for points, ring in ((block, rock), (rock, block)):
        for point in points:
            depth = distance(point, ring)
            most = max(most, depth if inside(point, ring) else -depth)
    return most


def turned(ring, about, angle):
    c, s = math.cos(angle), math.sin(angle)
    return [(about[0] + c * (x - about[0]) - s * (y - about[1]), about[1] + s * (x - about[0]) + c * (y - about[1]))
            for x, y in ring]


def contacts(block, profile, rock, near):
    """Points within `near` of touching, from left to right."""
    points = [p for p in block if distance(p, rock) < near] + [p for p in profile if distance(p, block) < near]
    return sorted(points)


def drop(block, profile):
    falls = [y - height(profile, x) for x, y in block if height(profile, x) is not None]
    for x, y in profile:
        for (x0, y0), (x1, y1) in zip(block, block[1:] + block[:1]):
            if x0 <= x <= x1 and x1 > x0:
                falls.append(y0 + (y1 - y0) * (x - x0) / (x1 - x0) - y)
    return None if not falls else [(x, y - min(falls)) for x, y in block]


def turn(block, rock, about, way):
    """Until it touches anew: None where its centroid passes under the point first."""
    g = centroid(block)
    most = math.pi - abs(math.atan2(g[0] - about[0], g[1] - about[1]))
    angle, start = 0.0, max(deepest(block, rock), 0.0) + DEEP
    while deepest(turned(block, about, way * (angle + STEP)), rock) < start:
        angle += STEP
        if angle > most:
            return None
    low, high = angle, angle + STEP
    for _ in range(60):
        middle = (low + high) / 2
        if deepest(turned(block, about, way * middle), rock) < start:
            low = middle
        else:
            high = middle
    return way * low if low <= most else None


def rest(block, profile, most_turns=60):
    """What becomes of it, and its outline then: 'rests', 'beside', 'rolls off' or 'unclear'."""
    bottom = min(y for _, y in profile + block) - 10 * (max(y for _, y in block) - min(y for _, y in block)) - 10
    rock = [(profile[0][0], bottom), (profile[-1][0], bottom)] + profile[::-1]
    block = drop(block, profile)
    if block is None:
        return "beside", None
    for _ in range(most_turns):
        g = centroid(block)
        touching = contacts(block, profile, rock, NEAR)
        if not touching:
            return "unclear", block
        free = []
        for point in touching:
            if abs(g[0] - point[0]) < 1e-4:
                return "unclear", block
            way = -1 if g[0] > point[0] else 1
            if deepest(turned(block, point, way * STEP), rock) < NEAR:
                free.append((abs(g[0] - point[0]), point, way))
        if not free:
            return "rests", block
        _, about, way = max(free)
        if any(abs(about[0] - x) < NEAR and about[1] < y - NEAR for x, y in (profile[0], profile[-1])):
            return "rolls off", block
        angle = turn(block, rock, about, way)
        if angle is None:
            return "rolls off", block
        if abs(angle) < 2 * STEP:
            return "unclear", block
        block = turned(block, about, angle)
    return "unclear", block
