# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""One factor of safety of many blocks (docs/blocks_in_contact.md): below 1 exactly where a motion can begin, and never above a number at which
one is proven. The block that may move had "1.3137 (governs)" and, in other forms, a factor that was met; eight columns were headed by the
direction that is safe. Compared with the windows of motion of `block:`, which another solver finds: on driving loads
tan α_s / tan α with α_s the lower end of a window, by strength the divisor at which a motion begins."""

import json
import math
import random

from governing_case import GoverningCase
from harness import main, rounds, run
from pile_case import Pile, text_of

NEAR = 2e-5


def tilted(angle, side="left"):
    return f"tilt: {{towards: {side}, angle_deg: {angle}}}"


def bounds(own):
    """Of a factor as JSON has it."""
    if own.get("fos") is not None:
        return own["fos"]["value"] - own["fos"]["error"], own["fos"]["value"] + own["fos"]["error"]
    if own["fos_is"] == "unbounded":
        return math.inf, math.inf
    if own["fos_is"] == "none":
        return 0, 0
    return own.get("at_least", 0), own.get("at_most", math.inf)


def degrees(end, else_):
    return else_ if end is None else end["value"]


def window_factor(one, tilt):
    """On driving loads, of weight alone: (can a motion begin, factor)."""
    windows = [(degrees(w["from_deg"], -90), degrees(w["to_deg"], 90)) for w in one["onset"]["windows"]]
    inside = [low for low, high in windows if low <= tilt <= high]
    ends = inside or [low for low, _ in windows if low > tilt]
    if not ends:
        return False, math.inf
    low = max(inside) if inside else min(ends)
    return bool(inside), max(0, math.tan(math.radians(low))) / math.tan(math.radians(tilt)) if low < 90 else math.inf


class FactorLawBlocks(GoverningCase):
    def solved(self, text):
        status, out, err = run("solve", "--json", self.scene(text))
        self.assertIn(status, (0, 1, 4), err + text)
        return status, json.loads(out)

    def scenes(self, draw):
        """A block on a profile of one to three facets, as `block:` and as `blocks:`."""
        profile, x = [(0, draw.randint(-10, 10) / 5)], 0
        for _ in range(draw.randint(1, 3)):
            x += draw.randint(3, 10)
            profile.append((x / 5, draw.randint(-12, 12) / 5))
        top = max(y for _, y in profile) + draw.randint(4, 20) / 5
        left, right = draw.randint(-6, 6) / 5, x / 5 + draw.randint(-6, 6) / 5
        return None if left >= right else ([*profile, (right, top), (left, top)], profile)

    def test_one_block_in_both_forms(self):
        draw, count, decided, moving = random.Random(59), 0, 0, 0
        for _ in range(rounds(40, 1500)):
            shape = self.scenes(draw)
            if shape is None:
                continue
            outline, profile = shape
            friction, tilt, side = draw.choice((20, 40, 50, 60, 70)), draw.choice((3, 8, 15, 25)), draw.choice(("left", "right"))
            required = draw.choice((1.1, 1.5))
            rest = f"{tilted(tilt, side)}\nrequired_fos: {required}\n"
            status, out, _ = run("solve", "--json", self.scene(
                f"topple: 1\nlength_unit: m\nblock: {{outline: {text_of(outline)}, unit_weight_kn_m3: 25}}\n"
                f"base: {{profile: {text_of(profile)}}}\nfriction_angle_deg: {friction}\n{rest}"))
            if status not in (0, 1, 4):
                continue
            one = json.loads(out)["cases"][0]
            if one["onset"]["windows"] is None:
                continue
            ground = [(profile[0][0], -20), (profile[-1][0], -20), *reversed(profile)]
            pile = Pile().add("g", ground, True).add("b", outline)
            where = (outline, profile, friction, tilt, side)
            status, system = self.solved(pile.scene(friction, rest))
            own = system["cases"][0]
            moves, factor = window_factor(one, tilt)
            strength = one["onset"]["fos"] and one["onset"]["fos"]["value"]
            low, high = bounds(own["governing_fos"])
            self.assertEqual(own["verdict"] in ("may move", "collapses"), moves, where)
            self.assertEqual(high <= 1, moves, where)
            driving, divisor = own["fos_by_driving"], own["fos_by_strength"]
            if driving["counts"]:
                self.assertLessEqual(driving.get("at_least", math.inf), factor * (1 + NEAR) + NEAR, where)
                self.assertGreaterEqual(driving.get("at_most", math.inf), min(factor, 900) * (1 - NEAR) - NEAR, where)
            if strength is not None and divisor["counts"]:
                self.assertLessEqual(divisor.get("at_least", math.inf), strength * (1 + NEAR), where)
                self.assertGreaterEqual(divisor.get("at_most", math.inf), strength * (1 - NEAR), where)
            truth = min(factor, strength if strength is not None and divisor["counts"] else math.inf)
            self.assertLessEqual(low, truth * (1 + NEAR) + NEAR, where)
            self.assertGreaterEqual(high, min(truth, 900) * (1 - NEAR) - NEAR, where)
            count += 1
            decided += own["governing_fos"].get("fos_is") != "undecided"
            moving += moves
            meets = "met" if not moves and low >= required else "not met" if moves or high < required else "open"
            self.assertEqual(own["meets_required"], meets, where)
            self.assertEqual(status, {"met": 0, "not met": 1, "open": 4}[meets], where)
            other = self.solved(pile.moved(lambda x, y: (-x, y)).scene(
                friction, rest.replace(side, {"left": "right", "right": "left"}[side])))[1]["cases"][0]
            self.assertEqual((other["verdict"], other["meets_required"]), (own["verdict"], own["meets_required"]), where)
            mirrored = bounds(other["governing_fos"])
            self.assertLessEqual(mirrored[0], high * (1 + NEAR), where)
            self.assertLessEqual(low, mirrored[1] * (1 + NEAR), where)
        self.assertGreaterEqual(decided, 0.9 * count)
        self.assertGreaterEqual(moving, 0.1 * count)


if __name__ == "__main__":
    main()
