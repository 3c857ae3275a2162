# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Loads against closed forms worked by hand; each test says how. W = unit weight * width * height."""

import math
import random
from fractions import Fraction

from harness import main
from loads_case import G, LoadsCase

WATER = 9.81


class Loads(LoadsCase):
    def test_seismic(self):
        """Slab b x h: about the toe W (b/2) cos a = W (h/2) sin a + k W ((h/2) cos a + (b/2) sin a), so
        tan a = (b - k h) / (h + k b). With k_v upwards gravity is (1 - k_v) of itself. Towards both
        sides alike."""
        random.seed(61)
        for _ in range(50):
            b, h = random.uniform(1, 3), random.uniform(3, 6)
            k, v = random.uniform(0, 0.3), random.uniform(0, 0.3)  # downwards the state at rest governs
            towards = random.choice(["left", "right"])
            case = self.solve(b, h, f"{{seismic: {{horizontal: {k!r}, vertical: {v!r}}}}}", tilt=10,
                              towards=towards)
            expected = math.atan2((1 - v) * b - k * h, (1 - v) * h + k * b)
            self.assert_angle(case, math.degrees(expected))
            s, c = math.sin(math.radians(10)), math.cos(math.radians(10))
            shaking = k * (b * s + h * c) + v * (b * c - h * s)  # times W / 2, on the side of its sign
            self.assert_fos(case, (b * c + max(-shaking, 0)) / (h * s + max(shaking, 0)))

    def test_water_on_the_face(self):
        """Water up to w along the face, head w cos a: force g w^2 cos a / 2 at w / 3, uplift g w b cos a / 2
        at 2 b / 3 from the toe. All goes with cos a but the parallel weight:
        tan a = (W b / 2 - g (w^3 / 6 + w b^2 / 3)) / (W h / 2)."""
        random.seed(62)
        for _ in range(30):
            b, h = random.uniform(1, 3), random.uniform(3, 6)
            w = random.uniform(0, h)
            for uplift in (0, 1):
                towards = random.choice(["left", "right"])
                case = self.solve(b, h, f"{{water: {{height: {w!r}, uplift: {'true' if uplift else 'false'}}}}}",
                                  towards=towards)
                weight = G * b * h
                moment = WATER * (w**3 / 6 + uplift * w * b * b / 3)
                expected = math.degrees(math.atan2(weight * b / 2 - moment, weight * h / 2))
                if expected > 0:
                    self.assert_angle(case, expected)
                else:
                    self.assertLess(case["toppling"]["critical_angle_deg"]["value"], 1e-9)

    def test_level_water(self):
        """Water that stays w (vertically) over the heel: force g w^2 / (2 cos a) at w / (3 cos a), uplift
        g w b / 2. The zeros of the moment by bisection in doubles; of several, all."""
        random.seed(63)
        for _ in range(30):
            b, h = random.uniform(1, 3), random.uniform(3, 6)
            w = random.uniform(0.3, 0.7) * h
            case = self.solve(b, h, f"{{water: {{height: {w!r}, uplift: true, stays_level: true}}}}")
            weight = G * b * h

            def moment(a):
                force = WATER * w * w / (2 * math.cos(a))
                return (-weight * b / 2 * math.cos(a) + weight * h / 2 * math.sin(a)
                        + force * w / (3 * math.cos(a)) + WATER * w * b / 2 * 2 * b / 3)

            limit = math.acos(w / h)
            points = [limit * k / 4000 for k in range(4001)]
            zeros = []
            for low, high in zip(points, points[1:]):
                if (moment(low) > 0) == (moment(high) > 0):
                    continue
                for _ in range(60):
                    middle = (low + high) / 2
                    if (moment(middle) > 0) == (moment(low) > 0):
                        low = middle
                    else:
                        high = middle
                zeros.append(math.degrees(low))
            found = [z["value"] for z in case["pivots"][0]["limits_deg"]]
            self.assertEqual(len(found), len(zeros))
            for one, other in zip(found, zeros):
                self.assertAlmostEqual(one, other, delta=1e-9)

    def test_anchor(self):
        """An anchor of F at (0, z) pulling at angle t from x: its moment about the toe (0, 0) is -z F cos t
        (counter-clockwise), whatever the tilt: W ((h/2) sin a - (b/2) cos a) = F z cos t, in closed form
        sin(a - d) = 2 F z cos t / (W sqrt(b^2 + h^2)), d = atan(b / h). Active: FoS = stabilising over
        (overturning - anchor); passive: (stabilising + anchor) over overturning."""
        b, h, z, tilt = 2.0, 5.0, 4.0, 20.0
        for t in (0.0, -30.0, 30.0):
            for force in (10.0, 40.0):
                for passive in ("false", "true"):
                    case = self.solve(b, h, f"{{anchors: [{{at: [0, {z}], direction_deg: {t}, force_kn: {force}, "
                                            f"passive: {passive}}}]}}", tilt=tilt)
                    weight = G * b * h
                    held = force * z * math.cos(math.radians(t))
                    d = math.atan2(b, h)
                    expected = d + math.asin(2 * held / (weight * math.hypot(b, h)))
                    self.assert_angle(case, math.degrees(expected))
                    stabilising = weight * b / 2 * math.cos(math.radians(tilt))
                    overturning = weight * h / 2 * math.sin(math.radians(tilt))
                    if passive == "true":
                        self.assert_fos(case, (stabilising + held) / overturning)
                    else:
                        self.assert_fos(case, stabilising / (overturning - held))

    def test_anchor_through_the_pivot(self):
        """An anchor whose line goes through the toe has no moment, which sines and cosines can only enclose:
        the factor is that of the weight alone, b cos a / (h sin a), on whichever side it counts."""
        for passive in ("false", "true"):
            case = self.solve(2.0, 5.0, "{anchors: [{at: [1, 1], direction_deg: 45, force_kn: 100, passive: %s}]}"
                              % passive, tilt=20)
            self.assert_fos(case, 2 / 5 / math.tan(math.radians(20)))
            self.assert_angle(case, math.degrees(math.atan2(2, 5)))

    def test_pressure_and_surcharge(self):
        """A pressure from 0 at the top to p at the foot of the up-dip face is the triangle of water held to
        the block: force p h / 2 at h / 3. A surcharge q over the top is a weight q b at its middle."""
        b, h, p, q = 2.0, 5.0, 30.0, 25.0
        case = self.solve(b, h, f"{{pressures: [{{from: [{b}, 0], to: [{b}, {h}], kpa: [{p}, 0]}}]}}", tilt=5)
        weight, moment = G * b * h, p * h * h / 6
        d = math.atan2(b, h)
        self.assert_angle(case, math.degrees(d - math.asin(2 * moment / (weight * math.hypot(b, h)))))
        case = self.solve(b, h, f"{{surcharges: [{{from: [0, {h}], to: [{b}, {h}], kpa: {q}}}]}}", tilt=5)
        total = weight + q * b
        lever = (weight * h / 2 + q * b * h) / total
        self.assert_angle(case, math.degrees(math.atan2(b / 2, lever)))

    def test_bond(self):
        """A tensile bond s on a level contact of length b resists with s b^2 / 2."""
        b, h, s = 2.0, 6.0, 12.0
        case = self.solve(b, h, f"{{bond_kpa: {s}}}", tilt=20)
        weight, held = G * b * h, s * b * b / 2
        d = math.atan2(b, h)
        self.assert_angle(case, math.degrees(d + math.asin(2 * held / (weight * math.hypot(b, h)))))
        tilt = math.radians(20)
        self.assert_fos(case, (weight * b / 2 * math.cos(tilt) + held) / (weight * h / 2 * math.sin(tilt)))

    def test_bond_of_a_rough_base(self):
        """About every pivot of rough bases, what opens facet by facet in fractions: with s = (q - P) . t and
        t = q1 - q0 it opens where s > 0, and resists with (s1^2 - s0^2) / (2 t^2), s not below 0."""
        generator = random.Random(71)
        for count in (3, 17, 60, 200):
            points = [(Fraction(k), Fraction(generator.randrange(-150, 151), 100)) for k in range(count + 1)]
            points[0] = (points[0][0], Fraction(0))
            points[-1] = (points[-1][0], Fraction(0))
            ring = points + [(Fraction(count), Fraction(count)), (Fraction(0), Fraction(count))]
            self.compare_bonds(points, ring, generator.choice([1, 7]))

    def test_sliding(self):
        """W sin a = W cos a tan f + c b: sin(a - f) = c b cos f / W. With k_h: tan(a + atan k) = tan f."""
        b, h, f, c = 4.0, 2.0, 30.0, 5.0
        case = self.solve(b, h, f"{{cohesion_kpa: {c}}}", tilt=20, friction=f)
        weight = G * b * h
        expected = f + math.degrees(math.asin(c * b * math.cos(math.radians(f)) / weight))
        self.assertAlmostEqual(case["sliding"]["critical_angle_deg"]["value"], expected, delta=1e-10)
        tilt = math.radians(20)
        fos = (weight * math.cos(tilt) * math.tan(math.radians(f)) + c * b) / (weight * math.sin(tilt))
        self.assertAlmostEqual(case["sliding"]["fos"]["value"], fos, delta=1e-11)
        case = self.solve(b, h, "{seismic: {horizontal: 0.2}}", friction=f)
        self.assertAlmostEqual(case["sliding"]["critical_angle_deg"]["value"], f - math.degrees(math.atan(0.2)),
                               delta=1e-10)

    def test_never_and_always(self):
        """A strong anchor: it never topples. A strong pressure: it never stands."""
        case = self.solve(2.0, 5.0, "{anchors: [{at: [0, 4], direction_deg: 0, force_kn: 1000}]}")
        self.assertIsNone(case["toppling"]["critical_angle_deg"])
        self.assertEqual(case["pivots"][0]["limits_deg"], [])
        case = self.solve(2.0, 5.0, "{pressures: [{from: [2, 0], to: [2, 5], kpa: 1000}]}", tilt=5)
        self.assertIsNone(case["toppling"]["critical_angle_deg"])
        self.assertEqual(case["mechanism"], "topples")

    def test_rounded_toe_under_load(self):
        """With a rounded toe the lever arms are about the moved axis: a slab with k, model paper,
        tan a = ((b - 2 r) - k h) / (h + k (b - 2 r))."""
        rounded = "  rounded: {model: paper, corners: [{at: left_end, radius: 0.1}]}\n"
        case = self.solve(2.0, 5.0, "{seismic: {horizontal: 0.1}}", extra=rounded)
        self.assert_angle(case, math.degrees(math.atan2(1.8 - 0.5, 5 + 0.18)))


if __name__ == "__main__":
    main()
