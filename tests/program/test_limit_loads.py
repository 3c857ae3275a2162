# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The static limit under loads: random cohesion, bonds, anchors and earthquakes against all pairs of
forces (limit_forces.py), and closed forms that each docstring works. Slabs are b wide and h high, of
W = 26 b h kN a metre."""

import math
import random

from harness import ROUNDS, main
from limit_forces import Base, wrench
from limit_loads_case import GAMMA, LimitLoadsCase


def centroid(outline):
    """Area and centroid by the fan of triangles from the first vertex."""
    area, gx, gy = 0.0, 0.0, 0.0
    x0, y0 = outline[0]
    for (x1, y1), (x2, y2) in zip(outline[1:], outline[2:]):
        own = ((x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)) / 2
        area += own
        gx += own * (x0 + x1 + x2) / 3
        gy += own * (y0 + y1 + y2) / 3
    return area, (gx / area, gy / area)


def mirrored(points):
    return [(-x, y) for x, y in points[::-1]]


class LimitUnderLoads(LimitLoadsCase):
    def test_random(self):
        """The first tilt from level at which the base fails; where level ground does not do, the end of
        what tilts do."""
        random.seed(81)
        for _ in range(120 * ROUNDS):
            under, outline, strength, (k, v), anchors, loads = self.random_scene()
            towards, friction = random.choice(["left", "right"]), random.randint(1, 70)
            case = self.solve(outline, friction, loads, towards)
            if towards == "right":
                under, outline = mirrored(under), mirrored(outline)
            base = Base(list(zip(under, under[1:])), friction, *strength)
            area, g = centroid(outline)
            weight = GAMMA * area
            fixed = (0.0, 0.0, 0.0)
            for (x, y), direction, force in anchors:
                fx, fy = (force * f(math.radians(direction)) for f in (math.cos, math.sin))
                if towards == "right":
                    x, fx = -x, -fx
                fixed = tuple(a + b for a, b in zip(fixed, wrench((x, y), (fx, fy))))
            forces = (wrench(g, (-k * weight, (v - 1) * weight)),
                      wrench(g, ((v - 1) * weight, k * weight)), fixed)
            with self.subTest(scene=self.text):
                self.compare(case["limit"], base, forces)

    def test_cohesion_on_a_plane(self):
        """A low slab slides where W sin a = W cos a tan(phi) + c b, that is
        sin(a - phi) = c b cos(phi) / W."""
        random.seed(82)
        for _ in range(20):
            b, h = random.uniform(3, 5), random.uniform(0.2, 0.5)
            friction, c = random.uniform(5, 30), random.uniform(0.1, 2)
            limit = self.limit([(0.0, 0.0), (b, 0.0), (b, h), (0.0, h)], friction,
                               f"cohesion_kpa: {c!r}")
            phi = math.radians(friction)
            expected = math.degrees(phi + math.asin(c * b * math.cos(phi) / (GAMMA * b * h)))
            self.assertEqual(limit["mechanism"], "slides")
            self.assertAlmostEqual(limit["critical_angle_deg"]["value"], expected, delta=1e-10)

    def test_bond_of_a_slender_slab(self):
        """A slender slab topples where W (h sin a - b cos a) / 2 = s b^2 / 2: friction is high enough."""
        random.seed(83)
        for _ in range(20):
            b, h, s = random.uniform(1, 2), random.uniform(5, 8), random.uniform(0.1, 5)
            for towards, toe in (("left", 0.0), ("right", b)):
                limit = self.limit([(0.0, 0.0), (b, 0.0), (b, h), (0.0, h)], 60, f"bond_kpa: {s!r}",
                                   towards)
                expected = math.degrees(math.atan2(b, h) + math.asin(s * b * b
                                                                     / (GAMMA * b * h
                                                                        * math.hypot(b, h))))
                self.assertEqual(limit["mechanism"], "topples")
                self.assertEqual(limit["centre_x_m"]["value"], toe)
                self.assertAlmostEqual(limit["critical_angle_deg"]["value"], expected, delta=1e-10)

    def test_a_bond_adds_no_friction(self):
        """A slab on an inclined sole that a bond keeps from toppling slides all the same, where cohesion gives
        way: sin(d - phi) = c l cos(phi) / W, d being the dip of the sole. Contact forces said `interlocked`, at a
        factor of 0.7 against sliding: the bond pulled what pressed elsewhere. What is first is the lesser of
        sliding and toppling in closed form, and nothing whose factor is below 1 stands."""
        random.seed(88)
        slid = 0
        for _ in range(60 * ROUNDS):
            b, h, slope = random.uniform(1, 4), random.uniform(1.5, 8), random.choice((0.0, random.uniform(-0.3, 0.3)))
            friction, tilt = random.uniform(10, 50), random.randint(1, 60)
            c, s = random.choice((0, random.uniform(0, 10))), random.choice((0, random.uniform(0.1, 40), 500))
            outline = [(0.0, 0.0), (b, b * slope), (b, b * slope + h), (0.0, h)]
            mirror = random.random() < 0.5
            case = self.solve(mirrored(outline) if mirror else outline, friction,
                              f"cohesion_kpa: {c!r}, bond_kpa: {s!r}", "right" if mirror else "left",
                              f", angle_deg: {tilt}")
            weight, phi, lean = GAMMA * b * h, math.radians(friction), math.degrees(math.atan(slope))
            length, x, y = b * math.hypot(1, slope), b / 2, (b * slope + h) / 2
            sine = c * length * math.cos(phi) / weight
            slides = math.degrees(phi + math.asin(sine)) - lean if sine < 1 else 180
            sine = s * length**2 / 2 / (weight * math.hypot(x, y))
            topples = math.degrees(math.atan2(x, y) + math.asin(sine)) if sine < 1 else 180
            with self.subTest(scene=self.text):
                first = case["first"]
                if min(slides, topples) > 90:
                    self.assertEqual(first["mechanism"], "interlocked")
                    continue
                self.assertEqual(first["mechanism"], "slides" if slides < topples else "topples")
                self.assertAlmostEqual(first["critical_angle_deg"]["value"], min(slides, topples), delta=1e-9)
                self.assertEqual(case["mechanism"] == "stands", tilt < min(slides, topples))
                limit = case["limit"]["critical_angle_deg"]
                sooner = limit is None or limit["value"] > slides + 1e-9
                self.assertEqual(case["limit"]["slides_sooner"], sooner)
                slid += sooner
        self.assertGreater(slid, 5 * ROUNDS)

    def test_a_bond_without_friction(self):
        """Without friction a bond has none to add: sliding and the limit tie, at sin d = c l / W, and the report
        is whole, in both directions and mirrored."""
        outline = [(0.0, 0.0), (14.0, 3.5), (14.0, 9.5), (0.0, 6.0)]
        dip, own = math.degrees(math.atan(0.25)), math.degrees(math.asin(40 * math.hypot(14, 3.5) / (26 * 14 * 6)))
        for points, side in ((outline, 1), (mirrored(outline), -1)):
            for towards, sign in (("left", 1), ("right", -1)):
                case = self.solve(points, 0, "cohesion_kpa: 40, bond_kpa: 300", towards, ", angle_deg: 30")
                first = case["first"]["critical_angle_deg"]["value"]
                self.assertAlmostEqual(first, own - side * sign * dip, delta=1e-10)
                self.assertFalse(case["limit"]["slides_sooner"])

    def test_earthquake_is_a_tilt(self):
        """k_h towards down-dip turns gravity by atan(k_h): the limit falls by just that."""
        random.seed(84)
        for _ in range(20):
            under, outline, *_ = self.random_scene()
            friction, k = random.randint(20, 60), round(random.uniform(0, 0.5), 3)
            towards = random.choice(["left", "right"])
            plain = self.limit(outline, friction, "", towards)
            shaken = self.limit(outline, friction, f"seismic: {{horizontal: {k!r}}}", towards)
            self.assertEqual(plain["mechanism"], shaken["mechanism"])
            if plain["critical_angle_deg"] is None:
                continue
            one, other = plain["critical_angle_deg"], shaken["critical_angle_deg"]
            self.assertLessEqual(abs(one["value"] - math.degrees(math.atan(k)) - other["value"]),
                                 one["error"] + other["error"] + 1e-13)

    def test_far_from_the_origin(self):
        """A million block sizes away nothing changes, with cohesion, bond and an anchor."""
        outline = [(0.0, 0.0), (1.0, 0.25), (2.0, 0.0), (2.0, 3.0), (0.0, 3.0)]
        limits = []
        for dx, dy in ((0, 0), (2e6, -3e6), (-2e9, 2e9)):
            moved = [(x + dx, y + dy) for x, y in outline]
            limits.append(self.limit(moved, 30, "cohesion_kpa: 3, bond_kpa: 2, anchors: [{at: "
                                     f"[{dx!r}, {dy + 3!r}], direction_deg: -30, force_kn: 5}}]"))
        for other in limits[1:]:
            self.assertEqual(other["mechanism"], limits[0]["mechanism"])
            one, own = limits[0]["critical_angle_deg"], other["critical_angle_deg"]
            self.assertLessEqual(abs(one["value"] - own["value"]), one["error"] + own["error"])


if __name__ == "__main__":
    main()
