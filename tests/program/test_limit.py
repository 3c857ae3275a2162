# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The static limit of random contacts against brute force over all bases in exact whole numbers
(limit_oracle.py), with tan(phi) enclosed from below and above: the limit grows with it. Seeds are
fixed; TOPPLE_ROUNDS multiplies the number of rounds. Each test says which mechanisms its scenes must
come to, and how often at least: scenes that all end alike would compare little."""

import math
import os
import pathlib
import random
import tempfile
import unittest
from decimal import Decimal
from fractions import Fraction

import exact
from harness import main, solve
from limit_oracle import Limit, contacts, tangents

ROUNDS = int(os.environ.get("TOPPLE_ROUNDS", "1"))
TIE = Decimal(10) ** -40  # degrees: what tan(phi) to 1e-42 leaves of ends that are one
MOST_POINTS = 12


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


class RandomContacts(unittest.TestCase):
    def setUp(self):
        self.scene = Scene()
        self.seen = {}

    def tearDown(self):
        self.scene.folder.cleanup()

    def expected(self, outline, profile, angle, towards):
        """The oracle's answers with tan(phi) from below and above."""
        if towards == "right":
            outline, profile = mirrored(outline), mirrored(profile)
        points = contacts(outline, profile)
        if len(points) > MOST_POINTS:
            return None
        centroid = exact.centroid(exact.block_moments(outline))
        return [Limit(points, centroid, tangent) for tangent in tangents(angle)]

    def compare(self, limit, ends, towards):
        name = limit["mechanism"]
        self.assertNotEqual(name, "undecided")
        kinds = {end.kind for end in ends}
        self.assertEqual(len(kinds), 1)
        kind = kinds.pop()
        self.seen[name] = self.seen.get(name, 0) + 1
        if kind != "angle":
            self.assertEqual(name, "interlocked" if kind == "interlocked" else "holds nowhere")
            self.assertIsNone(limit["critical_angle_deg"])
            return
        found = limit["critical_angle_deg"]
        value, error = Decimal(found["value"]), Decimal(found["error"])
        self.assertGreaterEqual(value + error, angle_of(ends[0].most) - TIE)
        self.assertLessEqual(value - error, angle_of(ends[-1].most) + TIE)
        self.assertLessEqual(error, Decimal("1e-8"))
        self.compare_mechanism(limit, ends, towards)

    def compare_mechanism(self, limit, ends, towards):
        """The mechanism is one of the oracle's at the limit; a tie is told where it has two."""
        allowed = [m for end in ends for m in end.mechanisms.values()]
        tie = limit["tied_with"] is not None
        self.assertIn(tie, [len(end.mechanisms) > 1 for end in ends])
        if tie:
            self.seen["tie"] = self.seen.get("tie", 0) + 1
            self.assertIn(limit["tied_with"], [name for name, _ in allowed])
        for name, centre in allowed:
            if name == limit["mechanism"] and self.is_centre(limit, centre, towards):
                return
        self.fail(f"{limit} is none of {allowed}")

    def is_centre(self, limit, centre, towards):
        if centre is None:
            return limit["centre_x_m"] is None
        for key, own in (("centre_x_m", centre[0] if towards == "left" else -centre[0]),
                         ("centre_y_m", centre[1])):
            found = limit[key]
            if abs(Decimal(found["value"]) - exact.decimal(own)) > Decimal(found["error"]):
                return False
        return True

    def balance(self, case, outline, ends, towards):
        """The reactions at the limit: they balance the weight and its moment, each in the cone of a
        contact point."""
        limit = case["limit"]
        if limit["critical_angle_deg"] is None:
            return
        angle = math.radians(limit["critical_angle_deg"]["value"])
        gx, gy = (float(g) for g in exact.centroid(exact.block_moments(outline)))
        sums, slack = [0.0, 0.0, 0.0], [1e-13, 1e-13, 1e-13]
        side = 1 if towards == "left" else -1
        for r in limit["reactions"]:
            (x, dx), (y, dy), (fx, ex), (fy, ey) = ((r[k]["value"], r[k]["error"]) for k in
                                                    ("x_m", "y_m", "share_x", "share_y"))
            x, fx, g = side * x, side * fx, side * gx
            for k, (value, error) in enumerate(((fx, ex), (fy, ey),
                                                ((x - g) * fy - (y - gy) * fx,
                                                 (dx + dy) + abs(x - g) * ey + abs(y - gy) * ex))):
                sums[k] += value
                slack[k] += error + 1e-13 * (abs(x) + abs(y) + abs(gx) + abs(gy) + 1)
            tan = max(p / q for p, q in tangents(self.angle))
            self.assertTrue(any(
                abs(float(px) - x) + abs(float(py) - y) < 1e-9 * (abs(x) + abs(y) + 1)
                and abs(fx * tx + fy * ty) <= tan * (tx * fy - ty * fx) + 1e-9 * (1 + tan)
                * math.hypot(tx, ty) for (px, py), (tx, ty) in ends[0].points), (r, ends[0].points))
        self.assertLessEqual(abs(sums[0] - math.sin(angle)), slack[0])
        self.assertLessEqual(abs(sums[1] - math.cos(angle)), slack[1])
        self.assertLessEqual(abs(sums[2]), slack[2])

    def verdict(self, case, ends, tilt):
        """What statics rules out must not be said to stand; whether a motion can begin below that
        test_onset.py tells."""
        tan = exact.sin_cos(tilt)
        tan = Fraction(tan[0] / tan[1])
        margin = Fraction(1, 10**9)  # nearer to an end of the range is not judged here
        near = [end.holds(tan + off) for end in ends for off in (-margin, margin)]
        holds, fails = all(near), not any(near)
        if fails:
            self.assertNotIn(case["mechanism"], ("stands", "interlocked"))
        if holds:
            self.assertIn(case["mechanism"], ("stands", "interlocked", "may move"))

    def run_random(self, make, rounds, seed, draw_friction=friction, tilts=range(1, 61)):
        random.seed(seed)
        for _ in range(rounds * ROUNDS):
            block, base, outline, profile = make()
            self.angle = draw_friction()
            tilt = random.choice(tilts)
            ends = {towards: self.expected(outline, profile, self.angle, towards)
                    for towards in ("left", "right")}
            if ends["left"] is None:
                continue
            with self.subTest(scene=block, base=base, angle=self.angle):
                cases = None
                cases = self.scene.solve(block, base, self.angle, tilt=f", angle_deg: {tilt}")
            if cases is None:
                continue
            for towards, own in ends.items():
                with self.subTest(scene=self.scene.text, towards=towards):
                    self.compare(cases[towards]["limit"], own, towards)
                    self.balance(cases[towards], outline, own, towards)
                    self.verdict(cases[towards], own, tilt)

    def assert_seen(self, **least):
        """What the scenes came to, each so often at least, and nothing else."""
        seen = {name.replace(" ", "_"): count for name, count in self.seen.items()}
        self.assertEqual(set(seen), set(least))
        for name, count in least.items():
            self.assertGreaterEqual(seen[name], count, (name, seen))

    def test_teeth(self):
        self.run_random(mated_teeth, 60, 71)
        self.assert_seen(slides=10, topples=20, slides_and_topples=20, interlocked=20, holds_nowhere=2)

    def test_polygons(self):
        self.run_random(mated_polygon, 60, 72)
        self.assert_seen(slides=20, topples=5, slides_and_topples=8, interlocked=40)

    def test_worn_profiles(self):
        self.run_random(worn_profile, 60, 73)
        self.assert_seen(slides=6, topples=15, slides_and_topples=20, interlocked=15, holds_nowhere=15)

    def test_dropped(self):
        """Mostly on one point, where no friction keeps it from turning about that."""
        self.run_random(dropped, 60, 74)
        self.assert_seen(topples=40, holds_nowhere=25)

    def test_ties(self):
        """Not at a tilt of just the tie, where the factor is 1 by both and no bits decide it."""
        self.run_random(tied, 20, 75, lambda: 45, [k for k in range(1, 61) if k != 45])
        self.assert_seen(topples=1, tie=20, slides=1)


if __name__ == "__main__":
    main()
