# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What is not a number is said in words: no angle of 180 degrees for "never", no factor below zero without a word,
no null without its reason, nothing "uncertain" below a headline that calls every digit certain.

Random slabs and steps under random loads, strong ones and nothings among them, at tilts from up-dip to upright.
TOPPLE_ROUNDS multiplies the number of scenes."""

import json
import math
import pathlib
import random
import re
import tempfile
import unittest

from harness import ROUNDS, main, rounds, run

# null where the scene does not ask for it, or where another key of the same object says what is the case
SAID_ELSEWHERE = {"tied_with", "centre_x_m", "centre_y_m", "margin_deg", "fos_elements", "fos_strength", "toppling",
                  "from_deg", "to_deg"}  # of a window of tilts that has no end on that side


def scene():
    choice = random.choice
    w, h = choice([0.5, 1, 2, 3, 8]), choice([1, 2, 4, 5, 6])
    step = choice([0, 1, -1, 0.5])
    outline = [[0, 0], [w, 0], [w, h], [0, h]] if step == 0 else [
        [0, 0], [w, 0], [w, step], [2 * w, step], [2 * w, h + 1], [0, h + 1]]
    top = h if step == 0 else min(h + 1, h + 1 - step)
    at = choice(outline)
    loads = [
        f"water: {{height: {top * choice([0, 1, 0.5, 0.1])}, stays_level: {choice(['true', 'false'])}, uplift: {choice(['true', 'false'])}}}",
        f"seismic: {{horizontal: {choice([0, 0.1, 2])}, vertical: {choice([0, 0.1, -1])}}}",
        f"cohesion_kpa: {choice([0, 1, 47])}",
        f"bond_kpa: {choice([0, 1e-20, 10])}",
        f"anchors: [{{at: {at}, direction_deg: {choice([0, 45, 90, 180, 270, -30])}, "
        f"force_kn: {choice([0, 100, 2000, 26 * w * h])}, passive: {choice(['true', 'false'])}}}]"]
    loads = random.sample(loads, random.randint(0, 3))
    friction = choice([f"friction_angle_deg: {choice([0, 30, 45, 89])}\n"] * 3 + [
        "", "friction: {law: barton, residual_angle_deg: 24, jrc: 8, jcs_mpa: 50}\n"])
    return (f"topple: 1\nlength_unit: m\nblock: {{outline: {outline}, unit_weight_kn_m3: 26}}\nbase: {{mated: true}}\n"
            + friction + (f"loads: {{{', '.join(loads)}}}\n" if loads else "")
            + f"tilt: {{towards: {choice(['left', 'right'])}, angle_deg: {choice([0, 10, 45, 60, 89.9])}}}\n")


class Words(unittest.TestCase):
    def check(self, tree, key=""):
        if isinstance(tree, list):
            for part in tree:
                self.check(part, key)
        elif isinstance(tree, dict) and "error" in tree:
            self.assertTrue(math.isfinite(tree["value"]) and math.isfinite(tree["error"]), key)
            if key.endswith("_deg"):
                self.assertLess(abs(tree["value"]), 180, key)
        elif isinstance(tree, dict):
            for own, part in tree.items():
                said = tree.get(own.removesuffix("_deg") + "_is") or (own != "mechanism" and tree.get("mechanism"))
                if part is None and own not in SAID_ELSEWHERE:
                    self.assertTrue(said or tree.get("fos_is"), own)
                if own.startswith("fos") and isinstance(part, dict) and part["value"] + part["error"] < 0:
                    self.assertIn("none", tree[own + "_is"])
                self.check(part, own)

    def test_random_scenes(self):
        random.seed(57)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "scene.yaml"
            for _ in range(rounds(80, 250) * ROUNDS):
                text = scene()
                path.write_text(text)
                with self.subTest(scene=text):
                    status, out, err = run("solve", "--json", path)
                    self.assertIn(status, (0, 4), err)
                    if out:
                        self.check(json.loads(out))
                    page = run("solve", path)[1]
                    self.assertIsNone(re.search(r"180\.000|uncertain|\bnan\b|\binf\b|FoS -|out of range", page))

    def test_slides_at_every_tilt(self):
        """An anchor of ten times the weight along the base: no tilt is the first at which it slides."""
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "scene.yaml"
            path.write_text("topple: 1\nlength_unit: m\nblock: {slab: {width: 2, height: 4}, unit_weight_kn_m3: 26}\n"
                            "base: {mated: true}\nloads: {anchors: [{at: [0, 0], direction_deg: 180, force_kn: 2000}]}\n"
                            "friction_angle_deg: 30\ntilt: {towards: left, angle_deg: 10}\n")
            sliding = json.loads(run("solve", "--json", path)[1])["cases"][0]["sliding"]
            self.assertEqual((sliding["critical_angle_deg"], sliding["critical_angle_is"]), (None, "always"))
            weight, a, phi = 208, math.radians(10), math.radians(30)
            factor = weight * math.cos(a) * math.tan(phi) / (weight * math.sin(a) + 2000)
            self.assertAlmostEqual(sliding["fos"]["value"], factor, delta=1e-12)
            page = run("solve", path)[1]
            self.assertIn("Sliding under the loads: at every tilt.", page)
            # with the inertia of 9 g at half its height it turns about its heel as it slips: the row names how it begins to move
            self.assertIn("\n    slides and topples about (2, ", page)
            self.assertRegex(page, r"\n> 0\.058 +sliding and toppling +shear strength over force along the facet\n")

    def test_a_weight_past_its_pivot(self):
        """Of a pivot up-dip of the centroid tan(angle) / tan(tilt) is below zero: a quotient, but no factor of
        safety, which neither a page nor JSON gives as one where turning is blocked as well."""
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "scene.yaml"
            path.write_text("topple: 1\nlength_unit: m\nblock: {slab: {width: 2, height: 4}}\n"
                            "tilt: {towards: left, angle_deg: 10}\n")
            pivot = json.loads(run("solve", "--json", path)[1])["cases"][0]["pivots"][1]
            self.assertEqual((pivot["fos"], pivot["admissible"]), (None, False))
            self.assertEqual(pivot["fos_is"], "none: resisting action is negative")
            row = [line for line in run("solve", path)[1].splitlines() if "-26.565" in line][0]
            self.assertIn(" none ", row)


if __name__ == "__main__":
    main()
