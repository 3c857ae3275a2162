# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Do forces hold boxes that stand upon and beside each other? In fractions, from corners to verdict: contacts where boxes share a piece of a side, two
edges of a cone at each end of it, three equations a box, and the simplex method by Bland's rule, which comes to an end however degenerate."""

from fractions import Fraction as Q


def contacts(boxes):
    """(first, second, normal into the first, ends) of boxes (left, low, right, high)."""
    for i, (left, low, right, high) in enumerate(boxes):
        for j, (l, b, r, t) in enumerate(boxes):
            if low == t and max(left, l) < min(right, r):
                yield i, j, (0, 1), [(max(left, l), low), (min(right, r), low)]
            if left == r and max(low, b) < min(high, t):
                yield i, j, (1, 0), [(left, max(low, b)), (left, min(high, t))]


def equations(boxes, fixed, tangent):
    """Rows of A and of b in A f = b."""
    free = [k for k in range(len(boxes)) if k not in fixed]
    columns = []
    for i, j, (nx, ny), ends in contacts(boxes):
        for x, y in ends:
            for slope in (tangent, -tangent):
                fx, fy = nx + slope * ny, ny - slope * nx
                own = [Q(0)] * (3 * len(free))
                for k, sign in ((i, 1), (j, -1)):
                    if k in free:
                        at = 3 * free.index(k)
                        own[at:at + 3] = [sign * fx, sign * fy, sign * (x * fy - y * fx)]
                columns.append(own)
    target = []
    for k in free:
        left, low, right, high = boxes[k]
        weight = (right - left) * (high - low)
        target += [Q(0), weight, weight * (left + right) / 2]
    return [list(row) for row in zip(*columns)], target


def solvable(rows, target):
    """Is A f = b, f >= 0: by what b lacks as artificial forces, that are to come to nothing."""
    table = [[-x for x in row] + [-b] if b < 0 else row + [b] for row, b in zip(rows, target)]
    count = len(rows[0])
    basis = [count + k for k in range(len(table))]
    while True:
        lacking = [row for row, own in zip(table, basis) if own >= count]
        if not any(row[-1] for row in lacking):
            return True
        enters = next((c for c in range(count) if c not in basis and sum(row[c] for row in lacking) > 0), None)
        if enters is None:
            return False
        _, _, at = min((row[-1] / row[enters], own, k) for k, (row, own) in enumerate(zip(table, basis)) if row[enters] > 0)
        table[at] = [x / table[at][enters] for x in table[at]]
        for k, row in enumerate(table):
            if k != at and row[enters]:
                table[k] = [x - row[enters] * y for x, y in zip(row, table[at])]
        basis[at] = enters


def held(boxes, fixed, tangent):
    return solvable(*equations(boxes, fixed, Q(tangent)))
