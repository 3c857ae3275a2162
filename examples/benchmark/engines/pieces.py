# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Convex pieces of an outline, as engines of rigid bodies take them: ears are cut off exactly, and joined again where that
stays convex and has no more than so many corners."""


def turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def is_inside(p, a, b, c):
    return turn(a, b, p) >= 0 and turn(b, c, p) >= 0 and turn(c, a, p) >= 0


def ears(ring):
    """Triangles of a simple outline, counter-clockwise."""
    left = list(ring)
    while len(left) > 3:
        for k, b in enumerate(left):
            a, c = left[k - 1], left[(k + 1) % len(left)]
            if turn(a, b, c) == 0:
                break
            if turn(a, b, c) > 0 and not any(is_inside(p, a, b, c) for p in left if p not in (a, b, c)):
                yield [a, b, c]
                break
        else:
            raise ValueError("no ear is left: the outline crosses itself")
        del left[k]
    if turn(*left) != 0:
        yield left


def is_convex(ring):
    return all(turn(ring[k - 2], ring[k - 1], ring[k]) > 0 for k in range(len(ring)))


def joined(one, other, most):
    """Two pieces that share an edge as one, or None."""
    for k, a in enumerate(one):
        b = one[(k + 1) % len(one)]
        if a in other and b in other and other[(other.index(b) + 1) % len(other)] == a:
            at = other.index(a)
            both = one[k + 1:] + one[:k + 1] + (other[at + 1:] + other[:at])[:len(other) - 2]
            return both if len(both) <= most and is_convex(both) else None
    return None


def convex(ring, most=8):
    if is_convex(ring) and len(ring) <= most:
        return [list(ring)]
    parts = list(ears(ring))
    k = 0
    while k < len(parts):
        for j in range(k + 1, len(parts)):
            both = joined(parts[k], parts[j], most)
            if both:
                parts[k] = both
                del parts[j]
                break
        else:
            k += 1
    return parts
