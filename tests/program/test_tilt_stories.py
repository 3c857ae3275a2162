# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The stories of blocks E and F: docs/tilt_stories.md quotes the event logs as the program prints them and shows its figures."""

import json
import math
import pathlib
import re
import tempfile
import unittest

from harness import ROOT, main, run

PAGE = (ROOT / "docs" / "tilt_stories.md").read_text()
DYNAMICS = "tilt_test: {engine: dynamics, protocol: steps}\n"
NUMBER = re.compile(r"-?\d+\.?\d*")


def log_of(report):
    """The first direction's events, as they stand on a page."""
    block = report.split("Events", 1)[1].split("\n\n", 1)[0]
    return "\n".join("  " + line for line in block.splitlines()[1:])


class Stories(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def dynamic(self, name):
        """The example, towards the left, with its engine changed as the page says."""
        text = (ROOT / "examples" / f"tilt_block_{name}.yaml").read_text().replace("towards: both", "towards: left")
        scene = self.folder / f"{name}.yaml"
        scene.write_text(text[:text.index("tilt_test:")] + DYNAMICS)
        return scene

    def test_logs_are_on_the_page(self):
        for name in ("e_valley", "f"):
            for scene in (ROOT / "examples" / f"tilt_block_{name}.yaml", self.dynamic(name)):
                with self.subTest(scene.name):
                    status, out, err = run("tilt", scene)
                    self.assertEqual(status, 0, err)
                    self.assertGreaterEqual(len(log_of(out).splitlines()), 5)
                    self.assertIn(log_of(out), PAGE)

    def test_figures_are_those_of_the_page(self):
        """The same elements in the same order, numbers to a fiftieth of their unit, which is a hundredth of the block."""
        for name, figure in (("e_valley", "tilt_block_e.svg"), ("f", "tilt_block_f.svg")):
            with self.subTest(figure):
                drawn = self.folder / figure
                status, _, err = run("tilt", self.dynamic(name), "--figure", drawn)
                self.assertEqual(status, 0, err)
                new, shown = drawn.read_text(), (ROOT / "docs" / "figures" / figure).read_text()
                self.assertIn(f"figures/{figure}", PAGE)
                self.assertEqual(NUMBER.sub("#", new), NUMBER.sub("#", shown))
                for a, b in zip(NUMBER.findall(new), NUMBER.findall(shown)):
                    self.assertAlmostEqual(float(a), float(b), delta=0.02)
                self.assertEqual(shown.count("stroke-dasharray"), 6)

    def test_tables_tell_what_the_log_has(self):
        """Section 4.5 in the order of the events: the upper facet goes first, the middle one slips, the left one as well, and
        both blocks slide as they topple at the onset of motion, which is the limit."""
        for name, facets in (("e_valley", (3, 2, 1)), ("f", (2, 2, 1))):
            with self.subTest(name):
                status, out, err = run("tilt", "--json", ROOT / "examples" / f"tilt_block_{name}.yaml")
                own = json.loads(out)["cases"][0]
                last = {(event["what"], event["facet"]): event["angle_deg"] for event in own["events"]}
                story = [last["opens", facets[0]], last["slips", facets[1]], last["slips", facets[2]],
                         own["critical_angle_deg"]["lets_go_at"]]
                self.assertEqual(story, sorted(story))
                self.assertEqual(own["mechanism"], "slides and topples")
                self.assertAlmostEqual(story[-1], own["statics"]["onset_deg"], delta=1e-5)
                for angle in story[1:]:
                    self.assertIn(f"{angle:.2f}°", PAGE.replace("°**", "°"))

    def test_no_ratio_of_stiffnesses_gives_both_angles(self):
        """When facets of E and F first slip at two ratios, as the page has it: each of the paper's angles is one of these, of a
        ratio of its own; and 20.54 degrees is phi - i."""
        first = {}
        for name in ("e_valley", "f"):
            for shear in (10, 1000):
                scene = self.folder / f"{name}_{shear}.yaml"
                text = (ROOT / "examples" / f"tilt_block_{name}.yaml").read_text().rstrip()
                scene.write_text(f"{text}\n  normal_stiffness_gpa_m: 1000\n  shear_stiffness_gpa_m: {shear}\n")
                status, out, err = run("tilt", "--json", scene)
                self.assertEqual(status, 0, err)
                for event in reversed(json.loads(out)["cases"][0]["events"]):
                    if event["what"] == "slips":
                        first[name, shear, event["facet"]] = event["angle_deg"]
        for key, angle in ((("e_valley", 10, 2), "27.53°"), (("f", 10, 2), "19.17°"), (("e_valley", 1000, 2), "22.27°"),
                           (("f", 1000, 1), "20.54°"), (("f", 1000, 2), "13.84°")):
            self.assertEqual(f"{first[key]:.2f}°", angle, key)
            self.assertIn(angle, PAGE)
        self.assertLess(first["f", 10, 2], first["f", 10, 1])
        self.assertAlmostEqual(first["f", 1000, 1], 30 - math.degrees(math.atan2(5, 30)), delta=1e-3)

    def test_weight_passes_the_peak_at_14_degrees(self):
        """The centroid of block E by its polygon: the vertical through it meets the peak (30, 5) at that tilt, where the middle
        facet bears most and the left one least."""
        ring = [(0, 0), (30, 5), (60, 0), (90, 5), (90, 125), (0, 125)]
        cross = [a[0] * b[1] - b[0] * a[1] for a, b in zip(ring, ring[1:] + ring[:1])]
        x, y = (sum((a[k] + b[k]) * c for a, b, c in zip(ring, ring[1:] + ring[:1], cross)) / (3 * sum(cross)) for k in (0, 1))
        self.assertAlmostEqual(math.degrees(math.atan2(x - 30, y - 5)), 14, delta=0.5)
        status, out, err = run("tilt", "--json", ROOT / "examples" / "tilt_block_e_valley.yaml")
        own = json.loads(out)["cases"][0]
        normal = {facet: [(reaction["normal_n"], moment["angle_deg"]) for moment in own["moments"]
                          for reaction in moment["reactions"] if reaction["facet"] == facet] for facet in (1, 2)}
        self.assertAlmostEqual(max(normal[2])[1], 14, delta=2)
        self.assertAlmostEqual(min(normal[1])[1], 14, delta=2)


if __name__ == "__main__":
    main()
