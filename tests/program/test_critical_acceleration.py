# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The critical acceleration of many blocks (docs/blocks_in_contact.md) is that of blocks which do not move at rest. A block on two facets that
may move as it was placed had one of 0.2515 g in JSON, in CSV, in sweeps and in a back-analysis, though `topple solve` printed none. Rows have
it with its companions: up to which acceleration no motion can begin, and with which one can. Compared with the windows of motion of `block:`,
which another solver finds: an acceleration k turns the weight by atan k, so that a motion begins with tan(α_s - α)."""

import csv
import io
import json
import math
import random

from governing_case import GoverningCase
from harness import ROOT, main, rounds, run
from pile_case import Pile, text_of

DATA = ROOT / "tests" / "data" / "factor_law"
NUMBERS = ("critical_acceleration_g", "moving_acceleration_g", "standing_acceleration_g")


def numbers(own):
    """What a case has of them; null, as in a sweep, is none."""
    return {key: own[key]["value"] if isinstance(own[key], dict) else own[key] for key in NUMBERS if own.get(key) is not None}


def table(out):
    """The same of rows of CSV."""
    return [{key: float(row[key]) for key in NUMBERS if row[key]} for row in csv.DictReader(io.StringIO(out))]


def shape_of(draw):
    """A block on a profile of one to three facets."""
    profile, x = [(0, draw.randint(-10, 10) / 5)], 0
    for _ in range(draw.randint(1, 3)):
        x += draw.randint(3, 10)
        profile.append((x / 5, draw.randint(-12, 12) / 5))
    top = max(y for _, y in profile) + draw.randint(4, 20) / 5
    return [*profile, (x / 5, top), (0, top)], profile


class CriticalAcceleration(GoverningCase):
    def cases(self, scene, key=None, value=None):
        """By `solve --json`, once CSV was seen to say the same, and a sweep of `key`, which has that value in the scene."""
        status, out, err = run("solve", "--json", scene)
        self.assertIn(status, (0, 1, 4), err)
        cases = json.loads(out)["cases"]
        own = [numbers(case) for case in cases]
        self.assertEqual(table(run("solve", "--csv", scene)[1]), own)
        if key is not None:
            sweep = ("sweep", scene, "--x", f"{key}={value}", "--threads", "1")
            self.assertEqual(table(run(*sweep)[1]), own)
            (point,) = json.loads(run(*sweep, "--json")[1])["points"]
            self.assertEqual([numbers(case) for case in point["cases"]], own)
        for case, have in zip(cases, own, strict=True):
            if case.get("static_verdict", case["verdict"]) in ("may move", "collapses"):
                self.assertEqual(have, {}, case)
            elif "moving_acceleration_g" in have and "critical_acceleration_g" in have:
                self.assertLessEqual(have["moving_acceleration_g"], have["critical_acceleration_g"] * (1 + 1e-6) + 1e-6, case)
        return cases

    def test_block_on_facets(self):
        """At a tilt within a window of motion it has none; below one, it begins where the window does."""
        draw, at_rest, compared = random.Random(59), 0, 0
        for _ in range(rounds(16, 600)):
            outline, profile = shape_of(draw)
            friction, tilt = draw.choice((30, 40, 50, 60)), draw.choice((3, 8, 15, 25))
            rest = f"tilt: {{towards: left, angle_deg: {tilt}}}\n"
            status, out, _ = run("solve", "--json", self.scene(
                f"topple: 1\nlength_unit: m\nblock: {{outline: {text_of(outline)}, unit_weight_kn_m3: 25}}\n"
                f"base: {{profile: {text_of(profile)}}}\nfriction_angle_deg: {friction}\n{rest}"))
            if status != 0 or json.loads(out)["cases"][0]["onset"]["windows"] is None:
                continue
            windows = [(w["from_deg"]["value"] if w["from_deg"] else -90, w["to_deg"]["value"] if w["to_deg"] else 90)
                       for w in json.loads(out)["cases"][0]["onset"]["windows"]]
            ground = [(profile[0][0], -20), (profile[-1][0], -20), *reversed(profile)]
            (case,) = self.cases(self.scene(Pile().add("g", ground, True).add("b", outline).scene(friction, rest)), "tilt.angle_deg", tilt)
            moves = any(low <= tilt <= high for low, high in windows)
            self.assertEqual(case["verdict"] in ("may move", "collapses"), moves, (outline, friction, tilt))
            at_rest += moves
            ahead = [low for low, _ in windows if low > tilt]
            if moves or not ahead or "moving_acceleration_g" not in case:
                continue
            truth = math.tan(math.radians(min(ahead) - tilt))
            self.assertAlmostEqual(case["moving_acceleration_g"], truth, delta=2e-5 * max(1, truth), msg=(outline, friction, tilt))
            self.assertLessEqual(case["standing_acceleration_g"], truth + 1e-9)
            compared += 1
        self.assertGreaterEqual(min(at_rest, compared), 3)

    def test_pinned(self):
        """The block and the columns that had one, and a slope whose companion is less than it."""
        for name in ("may_move_many.yaml", "columns_phi42.yaml"):
            (case,) = self.cases(DATA / name)
            self.assertEqual((case["verdict"], numbers(case)), ("may move", {}), name)
        left, _ = self.cases(DATA / "study_open.yaml")
        self.assertLess(left["moving_acceleration_g"], left["critical_acceleration_g"]["value"])

    def test_find(self):
        """Where forces can hold a wanted acceleration, but the block may move at rest, it is no critical one."""
        find = ("solve", "--find", "friction_angle_deg", "--for", "critical_acceleration=0.2", "--from", "38", "--to", "46")
        status, out, err = run(*find, DATA / "may_move_many.yaml")
        self.assertEqual(status, 0, err)
        self.assertIn("the blocks may move at rest", out)
        self.assertEqual(json.loads(run(*find, "--json", DATA / "may_move_many.yaml")[1])["find"]["solutions"], [])
        # A slab on a slope of 20° has it where the friction angle is 20° + atan 0.2.
        slab = Pile().add("g", [(-9, -1), (9, -1), (9, 0), (-9, 0)], True).add("b", [(0, 0), (4, 0), (4, 1), (0, 1)])
        scene = self.scene(slab.scene(35, "slope: {dip_deg: 20, towards: left}\n"))
        status, out, err = run("solve", "--find", "friction_angle_deg", "--for", "critical_acceleration=0.2", scene)
        self.assertEqual(status, 0, err)
        self.assertAlmostEqual(float(out.splitlines()[1].split()[0]), 20 + math.degrees(math.atan(0.2)), delta=1e-3)
        self.assertIn("critical_acceleration is an upper bound", out)


if __name__ == "__main__":
    main()
