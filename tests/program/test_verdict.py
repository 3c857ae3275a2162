# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The verdict in words: certain to stand up to one tilt, certain to move beyond another, history between.

Block A about its peak with a friction of 60 degrees: moments about the toe let it go at 26.215 degrees, forces on the
steep facets could hold it up to 30.251 (docs/mechanics.md section 6a). The report said that it stands at 28. Text,
JSON, table, CSV and figure are held to one another; the angles come from closed forms and from the mechanics page."""

import csv
import io
import json
import math
import pathlib
import re
import tempfile
import unittest

from harness import ROOT, main, run

BLOCK_A = (ROOT / "examples/block_a_peak.yaml").read_text(encoding="utf-8")

COLUMN = ("topple: 1\nlength_unit: m\nblock: {outline: [[0, 0], [4, 14], [4, 83], [0, 83]]}\n"
          "base: {profile: [[-5, -5], [0, 0], [4, 9], [9, 11]]}\nfriction_angle_deg: 74.3\ntilt: {towards: left, angle_deg: 66}\n")


class Verdict(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="topple verdict ")
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "scene.yaml"

    def block_a(self, friction, tilt):
        self.path.write_text(BLOCK_A.replace("friction_angle_deg: 30", f"friction_angle_deg: {friction}").replace(
            "tilt: {towards: left}", f"tilt: {{towards: left, angle_deg: {tilt}}}"))
        return run("solve", self.path)[1], json.loads(run("solve", "--json", self.path)[1])["cases"][0]

    def test_window(self):
        """Below, within and beyond: the same two angles, and what holds at the tilt. The lower one is the moments'
        closed form of the paper, atan2 of the lever arms about the peak."""
        area = 3 * 15 * 94 + 3 * 15 * 5 / 2
        arms = [(15 * k + 7.5, 5 + 47, 15 * 94) for k in range(3)]
        arms += [(10, 10 / 3, 37.5), (20, 10 / 3, 37.5), (40, 10 / 3, 37.5)]
        x = sum(a * w for a, _, w in arms) / area
        y = sum(b * w for _, b, w in arms) / area
        moments = math.degrees(math.atan2(x, y - 5))
        for tilt, mechanism, said in ((20, "stands", "  Stands at 20°.\n"),
                                      (28, "may move", "  May move at 28° or stand: the result depends on loading history.\n  It can begin to topple.\n"),
                                      (32, "topples", "  Does not stand at 32°: it can begin to topple.\n")):
            with self.subTest(tilt=tilt):
                page, case = self.block_a(60, tilt)
                self.assertEqual(case["mechanism"], mechanism)
                self.assertIn(said, page)
                onset = case["onset"]["critical_angle_deg"]
                self.assertLessEqual(abs(onset["value"] - moments), onset["error"] + 1e-12)
                self.assertIn(f"Certain to stand up to α_s = {moments:.3f}°" + (f", a margin of {moments - 20:.3f}°" if tilt == 20 else "") + ".\n", page)
                self.assertIn("From that tilt toppling is possible about pivot 1, the peak at (0, 5).\n", page)
                self.assertIn("Certain to move beyond α_w = 30.251°:\n  by limit analysis it slides and topples about", page)
                self.assertIn("Between these tilts the result depends on loading history: friction on\n", page)
                self.assertEqual("Motions that can begin" in page, tilt > moments)
                self.assertLessEqual(max(map(len, page.splitlines())), 80)

    def test_beyond_the_limit(self):
        """At 32 degrees the limit's mechanism is to slide and topple, but the block topples: what a person reads
        of it is what can begin, in every output. The margin is to the tilt from which that can begin."""
        page, case = self.block_a(60, 32)
        self.assertEqual((case["mechanism"], case["can_begin"], case["limit"]["mechanism"], case["first"]["mechanism"]),
                         ("topples", ["topples"], "slides and topples", "slides and topples"))
        self.assertIn("Does not stand at 32°: it can begin to topple.\n", page)
        cells = [cell.strip() for cell in run("solve", "--table", self.path)[1].splitlines()[2].split("|")]
        self.assertEqual((cells[4], cells[12]), ("topples", "slides and topples"))
        (row,) = csv.DictReader(io.StringIO(run("solve", "--csv", self.path)[1]))
        self.assertEqual((row["verdict"], row["can_begin"], row["limit_mechanism"]),
                         ("topples", "topples", "slides and topples"))
        for tilt in (20, 28, 32):
            first, onset, limit = (lambda c: (c["first"], c["onset"], c["limit"]))(self.block_a(60, tilt)[1])
            for key, angle in (("margin_deg", onset), ("margin_to_first_deg", limit)):
                gap = angle["critical_angle_deg"]["value"] - tilt
                self.assertAlmostEqual(first[key]["value"], gap, delta=1e-9)
                self.assertLess(first[key]["error"], 1e-9)

    def test_several_motions(self):
        """A tall column on a steep and very rough flank, far beyond its limit: rigid bodies have no unique motion there
        (Painleve). All are named, and the verdict is one of them."""
        self.path.write_text(COLUMN)
        page, case = run("solve", self.path)[1], json.loads(run("solve", "--json", self.path)[1])["cases"][0]
        self.assertGreater(len(case["can_begin"]), 1)
        self.assertIn(case["mechanism"], case["can_begin"])
        verbs = {"slides": "slide", "topples": "topple", "slides and topples": "slide and topple", "leaves its base": "leave its base"}
        self.assertIn("it can begin to " + ", or to ".join(verbs[m] for m in case["can_begin"]) + ".\n", page)
        cells = [cell.strip() for cell in run("solve", "--table", self.path)[1].splitlines()[2].split("|")]
        self.assertEqual(cells[4], " or ".join(case["can_begin"]))

    def test_no_window(self):
        """With 30 degrees both are one, and nothing is said of history."""
        page, case = self.block_a(30, 20)
        self.assertFalse(case["onset"]["below_limit"])
        self.assertIn("Certain to stand up to α_s = 26.215°, a margin of 6.215°,\n  and to move beyond:\n  it topples about pivot 1",
                      page)
        self.assertNotIn("history", page)

    def test_interlocked(self):
        """Pegs that no motion leaves, and a notch whose friction could hold the block at every tilt though it can
        begin to topple: `interlocked` was said of both."""
        page = run("solve", "tests/hard/limit_interlocked.yaml")[1]
        self.assertIn("Certain to stand at every tilt up to 90°: no motion can begin.\n", page)
        page = run("solve", "tests/hard/limit_parallel_cones.yaml")[1]
        self.assertNotIn("nterlocked", page)
        self.assertIn("Not certain to move at any tilt up to 90°: some forces would hold it.\n  Beyond α_s the result depends on loading history", page)
        for case in json.loads(run("solve", "--json", "tests/hard/limit_parallel_cones.yaml")[1])["cases"]:
            self.assertEqual((case["limit"]["mechanism"], case["mechanism"]), ("interlocked", "stands"))

    def test_leaning(self):
        """A column that leans up-dip falls over up to 12.529 degrees and stands from there to 33.690: the report told
        of the first alone. There is no margin to a tilt from which it is not certain to stand: it falls."""
        self.path.write_text("topple: 1\nlength_unit: m\nblock: {outline: [[0, 0], [2, 0], [6, 9], [4, 9]]}\n"
                             "base: {mated: true, between: [[0, 0], [2, 0]]}\nfriction_angle_deg: 40\n"
                             "tilt: {towards: left, angle_deg: 5}\n")
        page, case = run("solve", self.path)[1], json.loads(run("solve", "--json", self.path)[1])["cases"][0]
        self.assertIn("  Fails up-dip already at 5°: below 12.529° it topples.\n"
                      "  Motions can begin up to 12.529° (first to topple),\n    from 33.690° on (first to topple)\n"
                      "  and at no other tilt up to 90°.\n", page)
        self.assertIn("\n    topples about (2, 0):\n", page)
        self.assertEqual((case["mechanism"], case["can_begin"], case["first"]["margin_deg"]), ("topples", ["topples"], None))

    def test_no_strength_holds_it(self):
        """Past the tilt of its moments a slab topples on any strength: `none` alone left open which of the two it meant."""
        self.path.write_text("topple: 1\nlength_unit: m\nblock: {slab: {width: 3, height: 2}}\nfriction_angle_deg: 35\n"
                             "tilt: {towards: left, angle_deg: 62}\n")
        self.assertIn("  none      sliding                 strength reduction, by contact forces\n" + " " * 36 +
                      "(excluded: strength does not decide it)\n" + " " * 36 + "(not certain to stand at any strength)\n", run("solve", self.path)[1])

    def test_motions(self):
        """Of a block that turns about a toe that sticks, the weight's moment over the inertia about it; the centroid
        moves across the line from the toe."""
        page, case = self.block_a(60, 28)
        (motion,) = case["motions"]
        block = case["block"]
        a = math.radians(28)
        x, y = block["centroid_x_m"]["value"], block["centroid_y_m"]["value"] - 0.005
        gyration = (block["second_moment_xx_m4"]["value"] + block["second_moment_yy_m4"]["value"]) / block["area_m2"]["value"]
        angular = (y * math.sin(a) - x * math.cos(a)) / (gyration + x * x + y * y)
        row = page.splitlines()[page.splitlines().index("    topples about (0, 5):") + 1]
        told = re.fullmatch(r"      x (\S+) g, y (\S+) g, turning (\S+) g/m", row).groups()
        for number, truth in zip(map(float, told), (-angular * y, angular * x, angular)):
            self.assertAlmostEqual(number, truth, delta=1e-3 * abs(truth))
        self.assertEqual(motion["mechanism"], "topples")
        self.assertIn("      facet 1, left end: sticks, force (", page)

    def test_fail_below_where_history_decides(self):
        """A factor above the design factor is no promise where a motion can begin; below it is told either way."""
        self.block_a(60, 28)
        status, _, err = run("solve", "--fail-below=0.5", self.path)
        self.assertEqual(status, 1)
        self.assertIn("at this tilt it is not certain to stand", err)
        self.block_a(60, 20)
        self.assertEqual(run("solve", "--fail-below=1.3", self.path)[0], 0)

    def test_table(self):
        """A column of the tilt up to which it is certain to stand."""
        self.block_a(60, 28)
        cells = [cell.strip() for cell in run("solve", "--table", self.path)[1].splitlines()[2].split("|")]
        self.assertEqual((cells[4], cells[7], cells[11]), ("may move: topples", "26.215°", "30.251°"))
        (row,) = csv.DictReader(io.StringIO(run("solve", "--csv", self.path)[1]))
        self.assertEqual((row["verdict"], round(float(row["certain_to_stand_deg"]), 3)), ("may move", 26.215))

    def test_figure_is_drawn(self):
        for tilt in (20, 28, 32):
            self.block_a(60, tilt)
            figure = self.path.parent / "figure.svg"
            self.assertEqual(run("solve", "--figure", figure, self.path)[0], 0)
            self.assertTrue(figure.read_text(encoding="utf-8").startswith("<?xml"))


if __name__ == "__main__":
    main()
