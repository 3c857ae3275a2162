# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The static limit where loads do not turn with the tilt: a block that begins to move and holds again. Each docstring works its
closed form; slabs are b wide and h high, of W = 26 b h kN a metre."""

import json
import math
import random

from harness import ROUNDS, main, run
from limit_forces import Base, wrench
from limit_loads_case import GAMMA, LimitLoadsCase


class LimitOverTilts(LimitLoadsCase):
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
        all whole ones: the limit is where it begins to move between, not `interlocked`."""
        for window in (2, 0.6, 0.1, 0.01, 0.001):
            share = math.cos(math.radians(window / 2))
            outline, loads = self.lifted(share)
            limit = self.limit(outline, 30, loads)
            self.assertEqual(limit["mechanism"], "topples")
            value = limit["critical_angle_deg"]
            self.assertAlmostEqual(value["value"], self.expected_of_lifted(share),
                                   delta=value["error"] + 1e-8)

    def test_the_first_tilt_or_undecided(self):
        """The slab begins to move in two windows ever narrower: the program names the first one's tilt or
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
