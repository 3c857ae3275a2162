# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The static limit under loads: random cohesion, bonds, anchors and earthquakes against all pairs of
forces (limit_forces.py), and closed forms that each docstring works. Slabs are b wide and h high, of
W = 26 b h kN a metre."""

import json
import math
import os
import pathlib
import random
import tempfile
import unittest

from harness import main, run, solve
from limit_forces import Base, wrench

ROUNDS = int(os.environ.get("TOPPLE_ROUNDS", "1"))
GAMMA = 26.0


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


class LimitUnderLoads(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name) / "scene.yaml"

    def tearDown(self):
        self.folder.cleanup()

    def write(self, outline, friction, loads, towards="left", tilt=""):
        points = ", ".join(f"[{x!r}, {y!r}]" for x, y in outline)
        self.text = (f"topple: 1\nlength_unit: m\nblock:\n  outline: [{points}]\n"
                     f"  unit_weight_kn_m3: 26\nbase: {{mated: true, beyond: {{left: 0, right: 0}}}}\n"
                     f"loads: {{{loads}}}\nfriction_angle_deg: {friction!r}\n"
                     f"tilt: {{towards: {towards}{tilt}}}\n")
        self.path.write_text(self.text)

    def solve(self, *arguments, **options):
        self.write(*arguments, **options)
        return solve(self.path)["cases"][0]

    def random_scene(self):
        """A rough block, its loads as text, and as F_cos, F_sin, F_1 towards either side."""
        count = random.randint(1, 4)
        under = [(float(k), round(random.uniform(-0.3, 0.3), 2)) for k in range(count + 1)]
        height = round(random.uniform(0.5, 6), 2)
        left, right = (round(random.uniform(0, 0.5), 2) for _ in range(2))
        outline = under + [(count - right, height), (left, height)]
        strength = [random.choice([0, round(random.uniform(0, 30), 1)]) for _ in range(2)]
        shaking = [random.choice([0, round(random.uniform(-0.3, 0.3), 2)]) for _ in range(2)]
        anchors = [((outline[-1][0], height), random.randint(-180, 180), random.randint(1, 60))
                   for _ in range(random.choice([0, 0, 1, 2]))]
        loads = [f"cohesion_kpa: {strength[0]!r}, bond_kpa: {strength[1]!r}",
                 f"seismic: {{horizontal: {shaking[0]!r}, vertical: {shaking[1]!r}}}"]
        loads += ["anchors: [%s]" % ", ".join(
            f"{{at: [{x!r}, {y!r}], direction_deg: {d}, force_kn: {f}}}"
            for (x, y), d, f in anchors)] * (anchors != [])
        return under, outline, strength, shaking, anchors, ", ".join(loads)

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

    def compare(self, limit, base, forces):
        found = base.intervals(*forces)
        value = limit["critical_angle_deg"]
        level = [i for i in found if i[0] <= 0 <= i[1]]
        above, below = [i for i in found if i[0] > 0], [i for i in found if i[1] < 0]
        if not found:
            self.assertEqual(limit["mechanism"], "holds nowhere")
            return
        _, end = (level or above or below[-1:])[0]
        if end > 89.999:
            self.assertEqual(limit["mechanism"], "interlocked")
            return
        self.assertIsNotNone(value, (limit["mechanism"], found))
        self.assertLessEqual(abs(value["value"] - end), value["error"] + 1e-8)
        names = {name for name, _ in base.mechanisms(end, forces, 1e-8)}
        self.assertIn(limit["mechanism"], names)

    def limit(self, *arguments, **options):
        return self.solve(*arguments, **options)["limit"]

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

    def lifted(self, share):
        """A slab of width 1 that a shaking of k = sin 10.5, v = 1 + cos 10.5 lifts off its base by W,
        straight so at a tilt of 10.5 degrees, against a bond of `share` W: the outline and loads."""
        turn, h = math.radians(10.5), 0.001
        return [(0.0, 0.0), (1.0, 0.0), (1.0, h), (0.0, h)], (
            f"cohesion_kpa: 5, bond_kpa: {share * GAMMA * h!r}, seismic: {{horizontal: "
            f"{math.sin(turn)!r}, vertical: {1 + math.cos(turn)!r}}}")

    def expected_of_lifted(self, share):
        """It turns about an end where W (cos d / 2 + h |sin d| / 2) = share W / 2, d = a - 10.5 degrees:
        that is cos(|d| - e) = share cos e, tan e = h; last held at |d| = e + acos(share cos e)."""
        e = math.atan(0.001)
        return 10.5 - math.degrees(e + math.acos(share * math.cos(e)))

    def test_lets_go_and_holds_again_within_a_degree(self):
        """Lifted straight off its base near 10.5 degrees only, a slab holds at 10 and 11 degrees, and at
        all whole ones: the limit is where it lets go between, not `interlocked`."""
        for window in (2, 0.6, 0.1, 0.01, 0.001):
            share = math.cos(math.radians(window / 2))
            outline, loads = self.lifted(share)
            limit = self.limit(outline, 30, loads)
            self.assertEqual(limit["mechanism"], "topples")
            value = limit["critical_angle_deg"]
            self.assertAlmostEqual(value["value"], self.expected_of_lifted(share),
                                   delta=value["error"] + 1e-8)

    def test_the_first_tilt_or_undecided(self):
        """The slab lets go in two windows ever narrower: the program names the first one's tilt or
        answers `undecided`, never that the block holds at every tilt. With a bond that suffices at
        the worst tilt it says that, and only then."""
        decided = 0
        for place in range(4, 14):
            share = math.hypot(1, 0.001) * (1 - 10.0 ** -place)
            outline, loads = self.lifted(share)
            self.write(outline, 30, loads)
            status, out, _ = run("solve", "--json", self.path)
            limit = json.loads(out)["cases"][0]["limit"]
            with self.subTest(share=share):
                if limit["mechanism"] == "undecided":
                    self.assertEqual(status, 4)
                    continue
                decided += 1
                self.assertEqual(limit["mechanism"], "topples")
                value = limit["critical_angle_deg"]
                # a share off by u = 2^-53 moves acos(share cos e) by u over the root of twice the gap
                slack = math.degrees(8 * 2.0 ** -53 / math.sqrt(2 * 10.0 ** -place)) + 1e-13
                self.assertAlmostEqual(value["value"], self.expected_of_lifted(share),
                                       delta=value["error"] + slack)
        self.assertGreaterEqual(decided, 5)
        for place in range(2, 12):
            share = math.hypot(1, 0.001) * (1 + 10.0 ** -place)
            outline, loads = self.lifted(share)
            limit = self.limit(outline, 30, loads)
            self.assertEqual(limit["mechanism"], "interlocked")

    def test_pulled_off_or_pressed_on(self):
        """An anchor along the normal through the middle of a slab, pulling with more than its weight:
        the slab holds nowhere. Pressing with T it holds at every tilt: W sin a <= (W cos a + T) tan(phi)
        up to 90 degrees if W <= T tan(phi), and W h / 2 <= T b / 2."""
        random.seed(85)
        for _ in range(20):
            b, h, friction = random.uniform(1, 4), random.uniform(0.2, 1), random.randint(20, 60)
            weight, slab = GAMMA * b * h, [(0.0, 0.0), (b, 0.0), (b, h), (0.0, h)]
            more = weight * random.uniform(1.0001, 3)
            anchors = "anchors: [{at: [%r, %r], direction_deg: %d, force_kn: %r}]"
            pulled = self.limit(slab, friction, anchors % (b / 2, h, 90, more))
            self.assertEqual(pulled["mechanism"], "holds nowhere")
            enough = weight * max(1 / math.tan(math.radians(friction)), h / b)
            for factor, mechanism in ((1.0001, "interlocked"), (0.9999, None)):
                pressed = self.limit(slab, friction, anchors % (b / 2, h, -90, factor * enough))
                if mechanism is None:
                    self.assertIsNotNone(pressed["critical_angle_deg"])
                else:
                    self.assertEqual(pressed["mechanism"], mechanism)

    def test_level_water(self):
        """Water that stays level at h above the heel presses with g h^2 / (2 cos a), at h / (3 cos a):
        at tilts 0.01 degrees apart every twist of every pair of forces is held up to the limit, and
        just beyond it one is not."""
        random.seed(86)
        limits = 0
        for _ in range(30 * ROUNDS):
            b, h = round(random.uniform(1, 3), 2), round(random.uniform(2, 6), 2)
            water, friction = round(random.uniform(0.1, 0.8) * h, 2), random.randint(15, 60)
            strength = [random.choice([0, round(random.uniform(1, 20), 1)]) for _ in range(2)]
            limit = self.limit([(0.0, 0.0), (b, 0.0), (b, h), (0.0, h)], friction,
                               f"water: {{height: {water!r}, stays_level: true}}, cohesion_kpa: "
                               f"{strength[0]!r}, bond_kpa: {strength[1]!r}")
            base = Base([((0.0, 0.0), (b, 0.0))], friction, *strength)

            def beaten(degrees):
                """The largest excess of the loads over what is held against a twist."""
                a, weight = math.radians(degrees), GAMMA * b * h
                own = wrench((b / 2, h / 2), (-weight * math.sin(a), -weight * math.cos(a)))
                push = wrench((b, water / 3 / math.cos(a)), (-9.81 * water**2 / 2 / math.cos(a), 0.0))
                loads = tuple(x + y for x, y in zip(own, push))
                return max(excess[2] for excess in base.excesses((0.0,) * 3, (0.0,) * 3, loads))

            with self.subTest(scene=self.text):
                if limit["critical_angle_deg"] is None or limit["critical_angle_deg"]["value"] < 0:
                    self.assertGreater(beaten(0), 0)
                    continue
                limits += 1
                end = limit["critical_angle_deg"]["value"]
                self.assertLessEqual(max(beaten(k / 100) for k in range(int(100 * end) + 1)), 1e-9)
                self.assertGreater(beaten(end + 1e-6), 0)
        self.assertGreater(limits, 15 * ROUNDS)


if __name__ == "__main__":
    main()
