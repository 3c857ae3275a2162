# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Random contacts with friction angles whose tangent is a short fraction: mated teeth and polygons, worn profiles, blocks
dropped on profiles, and blocks whose sliding and toppling tie."""

import math
import pathlib
import random
import tempfile
from fractions import Fraction

import exact
from harness import solve


def text_of(points):
    return "[" + ", ".join(f"[{x}, {y}]" for x, y in points) + "]"


def mirrored(points):
    return [(-x, y) for x, y in points[::-1]]


def angle_of(tangent):
    return exact.degrees(exact.atan(exact.decimal(tangent)))


def lower_chain(outline):
    """From the leftmost to the rightmost vertex of a counter-clockwise outline, the lowest of each."""
    first = outline.index(min(outline))
    last = outline.index(min(outline, key=lambda p: (-p[0], p[1])))
    return [outline[(first + k) % len(outline)] for k in range((last - first) % len(outline) + 1)]


def friction():
    return random.choice([0, 45, 45, Fraction("89.9"), *(random.randint(1, 850) / Fraction(10)
                                                         for _ in range(8))])


def star(count, radius):
    """A star-shaped outline on whole numbers."""
    while True:
        angles = sorted(random.uniform(0, 2 * math.pi) for _ in range(count))
        gaps = [b - a for a, b in zip(angles, angles[1:] + [angles[0] + 2 * math.pi])]
        ring = []
        for angle in angles:
            r = radius * random.uniform(0.5, 1)
            ring.append((Fraction(round(r * math.cos(angle))), Fraction(round(r * math.sin(angle)))))
        sweeps = all(p[0] * q[1] > p[1] * q[0] for p, q in zip(ring, ring[1:] + ring[:1]))
        if max(gaps) < math.pi * 0.9 and sweeps:
            return ring


def rough(count, step, depth):
    xs = sorted(random.sample(range(1, step * count), count - 1))
    return [(Fraction(x), Fraction(random.randint(0, depth))) for x in [0, *xs, step * count]]


def mated_teeth():
    """Teeth, and the base with some more teeth, or a piece of one, past either end."""
    count, a = random.randint(1, 4), random.randint(2, 40)
    b, c, end = random.randint(5, 200), random.randint(1, 40), random.choice(["valley", "peak"])
    outline = exact.teeth(count, a, b, c, end)
    more = [random.choice([0, 0, a, Fraction(a, 2)]) for _ in range(2)]
    profile = outline[:count + 1]
    for side in (0, 1):
        if more[side]:
            inner, other = (profile[0], profile[1]) if side == 0 else (profile[-1], profile[-2])
            far = (2 * inner[0] - other[0], other[1])
            profile = [far] + profile if side == 0 else profile + [far]
    block = f"teeth: {{count: {count}, width: {a}, height: {b}, depth: {c}, left_end: {end}}}"
    return block, f"mated: whole, beyond: {{left: {more[0]}, right: {more[1]}}}", outline, profile


def mated_polygon():
    """Any polygon on the counterpart of its underside, which goes on level or ends."""
    outline = star(random.randint(3, 9), random.choice([6, 30, 1000]))
    under = lower_chain(outline)
    left, right = random.choice([0, 3]), random.choice([0, 3])
    profile = [(under[0][0] - left, under[0][1])] * (left > 0) + under
    profile += [(under[-1][0] + right, under[-1][1])] * (right > 0)
    return (f"outline: {text_of(outline)}", f"mated: whole, beyond: {{left: {left}, right: {right}}}",
            outline, profile)


def worn_profile():
    """A rough block on a base of which some points are worn down; it may go on past the block, up or
    down, so that the ends may be notches."""
    under = rough(random.randint(1, 6), random.choice([4, 50]), random.choice([3, 20]))
    height = max(y for _, y in under) + random.randint(1, 120)
    lean = random.choice([-20, 0, 0, 3])
    if any((x - under[0][0]) * (height - under[0][1]) <= lean * (y - under[0][1])
           for x, y in under[1:]) or any(
               (under[-1][0] - x) * (height - under[-1][1]) <= -lean * (y - under[-1][1])
               for x, y in under[:-1]):
        lean = 0
    outline = under + [(under[-1][0] + lean, Fraction(height)), (lean, Fraction(height))]
    kept = random.randrange(len(under))
    profile = [(x, y - random.randint(1, 9)) if random.random() < 0.4 and k != kept else (x, y)
               for k, (x, y) in enumerate(under)]
    if lean <= 0 and random.random() < 0.7:
        profile.append((profile[-1][0] + 5, profile[-1][1] + random.randint(-5, 5)))
    if lean >= 0 and random.random() < 0.7:
        profile.insert(0, (profile[0][0] - 5, profile[0][1] + random.randint(-5, 5)))
    return f"outline: {text_of(outline)}", f"profile: {text_of(profile)}", outline, profile


def dropped():
    """A polygon let down on a profile until it touches: contact in a point, sometimes in several."""
    outline = star(random.randint(3, 7), random.choice([5, 8, 40]))
    least, most = min(x for x, _ in outline), max(x for x, _ in outline)
    xs = sorted(random.sample(range(int(least) - 5, int(most) + 6), random.randint(2, 6)))
    xs = [int(least) - 9, *xs, int(most) + 9]
    profile = [(Fraction(x), Fraction(random.randint(0, 4))) for x in xs]
    under = lower_chain(outline)
    gaps = [y - height_at(profile, x) for x, y in under]
    gaps += [height_at(under, x) - y for x, y in profile if least <= x <= most]
    outline = [(x, y - min(gaps)) for x, y in outline]
    return f"outline: {text_of(outline)}", f"profile: {text_of(profile)}", outline, profile


def tied():
    """A block on a level base with the centroid at 45 degrees over its left end: where the friction is
    45 degrees too, it slides and topples towards the left at one tilt, exactly."""
    width, height = random.randint(2, 40), random.randint(1, 40)
    left = random.randint(-3, width - 1)
    right = random.randint(max(-3, left - width + 1), 9)
    outline = [(Fraction(x), Fraction(y)) for x, y in
               ((0, 0), (width, 0), (width + right, height), (left, height))]
    gx, gy = exact.centroid(exact.block_moments(outline))
    if gx <= 0:
        return tied()
    outline = [(x, y * gx / gy) for x, y in outline]
    profile = [(Fraction(-random.choice([0, 9])), Fraction(0)), (Fraction(width + 5), Fraction(0))]
    return f"outline: {text_of(outline)}", f"profile: {text_of(profile)}", outline, profile


def height_at(chain, x):
    """The lowest height of a chain over x."""
    heights = []
    for (x0, y0), (x1, y1) in zip(chain, chain[1:]):
        if x0 != x1 and min(x0, x1) <= x <= max(x0, x1):
            heights.append(y0 + (y1 - y0) * (x - x0) / (x1 - x0))
    return min(heights)


class Scene:
    """A scene in a temporary folder, solved towards both sides."""

    def __init__(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name) / "scene.yaml"

    def solve(self, block, base, angle, more="", tilt="", unit="m"):
        self.text = (f"topple: 1\nlength_unit: {unit}\nblock:\n  {block}\n  unit_weight_kn_m3: 26\n"
                     f"base: {{{base}}}\nfriction_angle_deg: {angle}\n{more}"
                     f"tilt: {{towards: both{tilt}}}\n")
        self.path.write_text(self.text)
        return {case["towards"]: case for case in solve(self.path)["cases"]}
