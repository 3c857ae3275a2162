# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The contact of rounded blocks against rationals.

The story: a corner that rounding had cut off held blocks up on rock that it did not touch. Random
undersides, profiles that follow them in parts, and rounded corners are solved as they are and
mirrored; contact, pivots, sliding and limit are those of contact_oracle.py and of all pairs of forces
(limit_oracle.py)."""

import math
import random
from fractions import Fraction

import limit_oracle
from contact_oracle import Contact, Rounded, at, distance_to_segment
from contact_scenes import SCENES, SEED, ContactTest, mirror, points_text
from harness import main

# edges of rational length, and others
RATIONAL = [(4, 3), (4, -3), (3, 4), (3, -4), (12, 5), (12, -5), (5, -12), (8, 15), (15, -8), (4, 0), (6, 0)]
OTHERS = [(2, 1), (2, -1), (3, 1), (3, -2), (1, 2), (1, -3), (4, -1), (5, 3), (0, 3), (0, -3), (3, 0)]


class Scene:
    """A block on a base; `base` is a profile, or how far a mated base extends."""

    def __init__(self, outline, corners, base, model, friction):
        self.outline, self.corners, self.base = outline, corners, base
        self.model, self.friction = model, friction

    def text(self):
        rounded = ", ".join(f"{{at: [{self.outline[k][0]}, {self.outline[k][1]}], radius: {r}}}"
                            for k, r in self.corners.items())
        base = (f"profile: {points_text(self.base)}" if isinstance(self.base[0], tuple) else
                f"mated: whole, beyond: {{left: {self.base[0]}, right: {self.base[1]}}}")
        return (f"topple: 1\nlength_unit: m\nblock:\n  outline: {points_text(self.outline)}\n"
                f"  rounded: {{model: {self.model}, corners: [{rounded}]}}\n  unit_weight_kn_m3: 26\n"
                f"base: {{{base}}}\nfriction_angle_deg: {self.friction}\ntilt: {{towards: both}}\n")

    def mirrored(self):
        last = len(self.outline) - 1
        base = mirror(self.base) if isinstance(self.base[0], tuple) else self.base[::-1]
        return Scene(mirror(self.outline), {last - k: r for k, r in self.corners.items()}, base,
                     self.model, self.friction)

    def profile(self, under):
        """The base as points."""
        if isinstance(self.base[0], tuple):
            return self.base
        left = [(under[0][0] - self.base[0], under[0][1])] if self.base[0] else []
        right = [(under[-1][0] + self.base[1], under[-1][1])] if self.base[1] else []
        return left + under + right


class Drawing:
    """Random scenes from a seed."""

    def __init__(self, seed):
        self.r = random.Random(seed)

    def underside(self):
        r = self.r
        steps = RATIONAL if r.random() < 0.6 else OTHERS
        at_, points = (Fraction(r.randint(-5, 5)), Fraction(0)), []
        points.append(at_)
        count = r.randint(1, 5)
        for k in range(count):
            dx, dy = r.choice(steps)
            if dx == 0 and (k in (0, count - 1) or points[-1][0] == points[-2][0]):
                dx = 2  # upright edges lie between others
            at_ = (at_[0] + dx, at_[1] + dy)
            points.append(at_)
        return points

    def block(self, under):
        r = self.r
        top = max(y for _, y in under) + r.randint(3, 40)
        x0, x1 = under[0][0], under[-1][0]
        lean = Fraction(r.randint(0, 2)) * (x1 - x0) / 8
        return under + [(x1 - lean, Fraction(top)), (x0 + lean, Fraction(top) + r.randint(0, 3))]

    def corners(self, outline):
        """Convex vertices and radii that fit, some of them exactly to the end of an edge."""
        r, found = self.r, {}
        for k in r.sample(range(len(outline)), r.randint(0, len(outline))):
            if limit_oracle.corner(outline, k, True) <= 0:
                continue
            radius = Fraction(r.choice((1, 1, 1, 2, 3, 4, 6)), r.choice((1, 2, 4, 5)))
            if r.random() < 0.2:  # to the end of the shorter edge, if that is a rational radius
                one = Rounded(outline, {k: 1})
                shortest = min(abs(1 / one.pieces[k][2]), abs(1 / (1 - one.pieces[k - 1][3])))
                if shortest.denominator < 1000:
                    radius = shortest * r.choice((1, Fraction(1, 2)))
            if Rounded(outline, {**found, k: radius}).fits():
                found[k] = radius
        return found

    def base(self, under, rounded):
        """A profile on or below the underside: at its vertices, at points of its edges, at tangent
        points; and past the block."""
        r = self.r
        if r.random() < 0.25:
            return [Fraction(r.choice((0, 0, 1, 4))) for _ in range(2)]
        points = []
        touch = r.choice((0.4, 0.7, 0.95))
        for k, v in enumerate(under):
            points.append((v, r.random() < touch))
            if k + 1 == len(under):
                break
            _, d, first, last = rounded.pieces[k]
            shares = {Fraction(r.randint(1, 7), 8) for _ in range(r.randint(0, 3))}
            shares |= {s for s in (first, last) if 0 < s < 1 and s.denominator < 1000 and r.random() < 0.4}
            points += [(at(v, d, s), r.random() < touch) for s in sorted(shares)]
        upright = {v[0] for v, w in zip(under, under[1:]) if v[0] == w[0]}
        profile = [p if on or p[0] in upright else (p[0], p[1] - Fraction(r.randint(1, 6), 2)) for p, on in points]
        while r.random() < 0.3 and len(profile) > 2 and profile[1][0] < profile[-1][0]:
            profile.pop(0)
        while r.random() < 0.3 and len(profile) > 2 and profile[0][0] < profile[-2][0]:
            profile.pop()
        while len(profile) > 2 and profile[0][0] == profile[1][0] and profile[0][1] > profile[1][1]:
            profile.pop(0)  # an edge along the rock's end face
        while len(profile) > 2 and profile[-1][0] == profile[-2][0] and profile[-1][1] > profile[-2][1]:
            profile.pop()
        for side in (0, -1):
            x, y = profile[side]
            if x != under[side][0] or r.random() < 0.4:
                continue
            out = (x + (1 if side else -1) * r.randint(1, 3), y + r.randint(-4, 6))
            profile.insert(len(profile) if side else 0, out)
        return profile

    def scene(self):
        under = self.underside()
        outline = self.block(under)
        corners = self.corners(outline)
        rounded = Rounded(outline, corners)
        scene = Scene(outline, corners, self.base(under, rounded), self.r.choice(("paper", "exact")),
                      self.r.choice((0, 5, 10, 20, 30, 45, 45, 60)))
        return scene, rounded, scene.profile(under)


class Random(ContactTest):
    def arcs_are_clear(self, rounded, contact):
        """The theorem of base/facets_cut.c by looking: no arc comes near the rock but at its ends."""
        rock = [tuple(map(float, p)) for p in contact.rock]
        for k in rounded.corners:
            centre, r, before, after = rounded.arc(k)
            c, p, q = (tuple(map(float, v)) for v in (centre, before, after))
            start, stop = (math.atan2(v[1] - c[1], v[0] - c[0]) for v in (p, q))
            turn = (stop - start) % (2 * math.pi)
            for j in range(1, 40):
                a = start + turn * j / 40
                spot = (c[0] + float(r) * math.cos(a), c[1] + float(r) * math.sin(a))
                vertex = tuple(map(float, rounded.outline[k]))
                gap = min(distance_to_segment(spot, *ends) for ends in zip(rock, rock[1:]))
                edges = [(vertex, p), (vertex, q)]
                inside = min(distance_to_segment(spot, *e) if e[0] != e[1] else math.inf for e in edges)
                self.assertGreaterEqual(gap, inside - 1e-9)

    def test_random(self):
        """Every scene as it is and mirrored: the contact, the pivots, sliding and the limit of all its
        directions."""
        drawing = Drawing(SEED)
        judged = apart = rounded_contact = 0
        for number in range(SCENES):
            scene, rounded, profile = drawing.scene()
            contact = Contact(rounded, profile)
            with self.subTest(seed=SEED, scene=number, text=scene.text()):
                refused = self.refused(scene.text())
                if refused is not None:
                    if "reaches across" in refused or "crosses itself" in refused:
                        continue
                    self.assertEqual(contact.places(), [], refused)
                    apart += 1
                    continue
                self.arcs_are_clear(rounded, contact)
                rounded_contact += any(rounded.corners) and Contact(Rounded(scene.outline, {}), profile
                                                                   ).places() != contact.places()
                centroid = rounded.centroid(scene.model)
                own, other = self.cases(scene.text()), self.cases(scene.mirrored().text())
                for towards, back in (("left", "right"), ("right", "left")):
                    case = own[towards]
                    self.compare_contact(case, contact)
                    self.compare_pivots(case, contact, centroid, towards)
                    self.compare_sliding(case, contact, centroid, scene.friction, towards)
                    judged += self.compare_limit(case, contact.cone_points(), centroid, scene.friction, towards)
                    for part in ("sliding", "limit"):
                        a, b = (c[part]["critical_angle_deg"] if part in c else None for c in (case, other[back]))
                        self.assertEqual(a is None, b is None, part)
                        if a is not None:
                            self.near(a, b["value"])
                    self.assertEqual(case["mechanism"], other[back]["mechanism"])
                    self.assertEqual(case["limit"]["base_matters"], other[back]["limit"]["base_matters"])
        self.assertGreater(judged, SCENES // 2)
        self.assertGreater(rounded_contact, SCENES // 6)


if __name__ == "__main__":
    main()
