# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Random blocks and profiles that do not fit each other."""

import math


def random_block(draw):
    """A star with up to nine corners: some of them notches."""
    count = draw.randint(3, 9)
    angles = sorted(draw.sample(range(0, 360, 7), count))
    if max(b - a for a, b in zip(angles, angles[1:] + [angles[0] + 360])) > 170:
        return random_block(draw)
    reach = [3 * draw.uniform(0.4, 1) for _ in angles]
    return [(round(r * math.cos(math.radians(a)), 3), round(5 + r * math.sin(math.radians(a)), 3))
            for r, a in zip(reach, angles)]


def random_profile(draw):
    x, points = -draw.uniform(2, 12), []
    while x < 12:
        points.append((round(x, 3), round(draw.uniform(-0.6, 0.6), 3)))
        x += draw.choice([0.3, 1, 2.5]) * draw.uniform(0.5, 1.5)
    return points


def text(points):
    return "[" + ", ".join(f"[{x!r}, {y!r}]" for x, y in points) + "]"
