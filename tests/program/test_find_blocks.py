# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""`--find --for fos=X` over many blocks never ends where a smaller factor is proven.

The search for a friction angle that gives 16 columns the factor 1.2 once ended at 38.36°, where a motion is proven to begin with 0.83
times what is there: the number was found by what forces can hold. Each number found is solved here by itself. Its factor of safety is the
value, or the output says that it is an upper bound, in words and in JSON, and none that is smaller is proven."""

import json
import pathlib
import random
import tempfile
import unittest

from harness import ROOT, main, rounds, run


def columns(draw, count):
    return (f"topple: 1\nlength_unit: m\nfriction_angle_deg: {draw.randint(20, 40)}\nblock: {{unit_weight_kn_m3: 25}}\n"
            f"slope: {{dip_deg: {draw.randint(15, 35)}, towards: left}}\n"
            f"columns: {{width: {draw.choice([1.5, 2, 3])}, step: {draw.choice([0, 0.5])}, heights: {[draw.choice([2, 3, 4]) for _ in range(count)]}}}\n")


def stack(draw, count):
    lines = ["topple: 1", "length_unit: m", "block: {unit_weight_kn_m3: 25}", f"friction_angle_deg: {draw.randint(20, 45)}", "blocks:",
             "  - {name: ground, ground: true, outline: [[-9, -1], [12, -1], [12, 0], [-9, 0]]}"]
    for k in range(count):
        lines.append(f"  - {{name: b{k}, slab: {{width: 4, height: 1}}, at: [{draw.choice([0, 0.25])}, {k}]}}")
    lines.append(f"tilt: {{towards: left, angle_deg: {draw.randint(5, 20)}}}")
    return "\n".join(lines) + "\n"


class FindBlocks(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def same(self, one, other):
        """To digits, as the number is rounded where it is printed."""
        self.assertEqual(one.keys(), other.keys())
        for key, own in one.items():
            if isinstance(own, str) or own is None:
                self.assertEqual(own, other[key])
            else:
                self.assertAlmostEqual(*((v["value"] if isinstance(v, dict) else v) for v in (own, other[key])), delta=1e-6)

    def check(self, scene, value, *words):
        """How many numbers were found, and at how many of them the factor is an upper bound alone."""
        asked = ("solve", "--find", "friction_angle_deg", "--for", f"fos={value}", *words, scene)
        status, out, err = run(*asked, "--json")
        self.assertIn(status, (0, 1, 4), err)
        if not out:
            return 0, 0
        found = json.loads(out)["find"]
        text = run(*asked)[1]
        bounds = 0
        for solution, own in zip(found["solutions"], found.get("blocks", ()), strict=True):
            number = solution["value"]
            status, out, err = run("solve", "--json", "--set", f"friction_angle_deg={number!r}", scene)
            self.assertIn(status, (0, 1, 4), err)
            safety = json.loads(out)["governing_fos"]
            self.same(own["governing_fos"], safety)
            if safety["fos"] is not None:
                self.assertTrue((1 - 1.1e-5) * value <= safety["fos"]["value"] <= 1.01 * value, safety)
                self.assertNotIn("is_upper_bound", own)
            else:
                self.assertIs(own["is_upper_bound"], True)
                self.assertGreaterEqual(safety["at_most"], value * (1 - 1.1e-5))
                bounds += 1
        self.assertEqual(text.count("this is an upper bound"), bounds, text)
        for stretch in found["at_least"]:  # certain at its ends
            for number in (stretch["low"], stretch["high"]):
                safety = json.loads(run("solve", "--json", "--set", f"friction_angle_deg={number!r}", scene)[1])["governing_fos"]
                proven = safety["fos"]["value"] + safety["fos"]["error"] if safety["fos"] else safety.get("at_least", 0)
                self.assertGreaterEqual(proven, value * (1 - 1e-9))
        return len(found["solutions"]), bounds

    def test_random(self):
        draw = random.Random(6)
        found = 0
        for number in range(rounds(3, 60)):
            text = draw.choice([columns, stack])(draw, draw.choice(rounds([1, 2], [1, 2, 3, 7])))
            scene = self.folder / "scene.yaml"
            scene.write_text(text, encoding="utf-8")
            with self.subTest(number=number, text=text):
                found += self.check(scene, draw.choice([1.05, 1.2, 1.5]), "--from", "15", "--to", "60")[0]
        self.assertGreater(found, 1)

    def test_more_columns(self):
        """Three, or seven: more than are searched with their motions: the range of the upper bounds, and one over which these are above the value."""
        scene = self.folder / "seven.yaml"
        scene.write_text(columns(random.Random(1), rounds(3, 7)), encoding="utf-8")
        for words in (("--from", "30", "--to", "60"), *rounds((), (("--from", "15", "--to", "60"), ("--from", "50", "--to", "60")))):
            self.assertEqual(self.check(scene, 1.2, *words)[0], 1)


if __name__ == "__main__":
    main()
