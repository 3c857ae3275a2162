# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The figures of a study: every number that they draw, worked out anew from the rows of the samples, which are written to
CSV, and from the summary."""

import csv
import io
import json
import math
import pathlib
import statistics
import tempfile
import unittest
import xml.etree.ElementTree

from harness import ROOT, main, run
from study_case import ROAD_COLUMNS

ROAD = ROOT / "examples" / "studies" / "block_above_road_study.yaml"
SLAB = ROOT / "examples" / "studies" / "slab_study.yaml"
Z = statistics.NormalDist().inv_cdf(0.975)


def wilson(count, samples):
    share, room = count / samples, Z * Z / samples
    middle = (share + room / 2) / (1 + room)
    half = Z / (1 + room) * math.sqrt(share * (1 - share) / samples + room / (4 * samples))
    return middle - half, middle + half


class Figures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(holder.cleanup)
        cls.folder = pathlib.Path(holder.name)
        status, out, err = run("study", "--json", ROAD, "--csv", cls.folder / "rows.csv", "--figure", cls.folder / "figure.csv",
                               "--scatter", cls.folder / "scatter.csv")
        assert status == 0, err
        cls.summary = json.loads(out)
        cls.rows, cls.figure, cls.scatter = (
            list(csv.DictReader(io.StringIO((cls.folder / f"{name}.csv").read_text(encoding="utf-8"))))
            for name in ("rows", "figure", "scatter"))
        cls.limits = [float(row["limit_deg"]) for row in cls.rows]

    def series(self, panel, of=None):
        got = [row for row in self.figure if row["panel_of"] == panel and (of is None or row["of"] == of)]
        self.assertTrue(got, (panel, of))
        return got

    def test_fragility(self):
        """Between the share of limits and the share of onsets below a tilt, with Wilson's intervals."""
        onsets = [float(row["onset_deg"]) for row in self.rows]
        for name, angles in (("certain to move", self.limits), ("not certain to stand", onsets)):
            before = -1
            for row in self.series("fragility", name):
                count = sum(angle < float(row["x"]) for angle in angles)
                self.assertEqual(float(row["y"]), count / len(angles))
                for got, truth in zip((row["low"], row["high"]), wilson(count, len(angles))):
                    self.assertAlmostEqual(float(got), truth, delta=1e-9)
                self.assertGreaterEqual(float(row["y"]), before)
                before = float(row["y"])
            self.assertGreater(before, 0.99)

    def test_counted(self):
        """What the study counted at its tilts lies on the curve."""
        points = self.series("fragility, counted", "certain to move")
        self.assertEqual([float(row["x"]) for row in points], [18, 20, 22, 24, 26, 28, 30])
        for row in points:
            self.assertEqual(float(row["y"]), sum(limit < float(row["x"]) for limit in self.limits) / len(self.limits))
            self.assertTrue(float(row["low"]) <= float(row["y"]) <= float(row["high"]))

    def test_distribution(self):
        """Bins of one width from the least to the greatest, in shares that add up to 1, by what each sample does."""
        bins = self.series("distribution")
        self.assertAlmostEqual(sum(float(row["y"]) for row in bins), 1, delta=1e-12)
        for outcome in {row["of"] for row in bins}:
            own = self.series("distribution", outcome)
            centres = [float(row["x"]) for row in own]
            width = centres[1] - centres[0]
            self.assertAlmostEqual(centres[0] - width / 2, min(self.limits), delta=1e-9)
            self.assertAlmostEqual(centres[-1] + width / 2, max(self.limits), delta=1e-9)
            for centre, row in zip(centres, own):
                count = sum(centre - width / 2 <= limit < centre + width / 2 for limit, sample in zip(self.limits, self.rows)
                            if sample["outcome"] == outcome)
                self.assertAlmostEqual(float(row["y"]) * len(self.rows), count, delta=1 + 1e-9)  # one on an edge
            self.assertAlmostEqual(sum(float(row["y"]) for row in own) * len(self.rows),
                                   sum(sample["outcome"] == outcome for sample in self.rows), delta=1e-6)

    def test_ranks(self):
        """Spearman's, the strongest on top."""
        def ranks(values):
            order = sorted(range(len(values)), key=values.__getitem__)
            return {k: place for place, k in enumerate(order)}
        limit = ranks(self.limits)
        bars = self.series("rank correlation")
        self.assertEqual([float(row["y"]) for row in bars], [4, 3, 2, 1])
        for row in bars:
            own = ranks([float(sample[ROAD_COLUMNS.get(row["of"], row["of"])]) for sample in self.rows])
            n = len(own)
            truth = 1 - 6 * sum((own[k] - limit[k]) ** 2 for k in own) / (n * (n * n - 1))
            self.assertAlmostEqual(float(row["x"]), truth, delta=1e-3)  # ties
            self.assertTrue(float(row["low"]) < truth < float(row["high"]))
        self.assertEqual(sorted(bars, key=lambda row: -abs(float(row["x"]))), bars)

    def test_convergence(self):
        """At each power of two: the first so many samples."""
        steps = self.series("convergence")
        self.assertEqual([int(row["x"]) for row in steps], [16, 32, 64, 128, 256, 512, 1000])
        for row in steps:
            first = self.rows[:int(row["x"])]
            count = sum(sample["outcome"] in ("slides", "topples", "slides and topples", "leaves its base") for sample in first)
            self.assertEqual(float(row["y"]), count / len(first))
            self.assertAlmostEqual(float(row["low"]), max(0, wilson(count, len(first))[0]), delta=1e-9)

    def test_scatter(self):
        """Each sample in each panel, told apart by what it does."""
        for number, key in enumerate(("friction_angle_deg", "block.unit_weight_kn_m3", "loads.water.height",
                                      "loads.seismic.horizontal"), 1):
            got = [(row["of"], float(row["x"]), float(row["y"])) for row in self.scatter if row["panel"] == str(number)]
            self.assertEqual({row["panel_of"] for row in self.scatter if row["panel"] == str(number)}, {key})
            truth = [(row["outcome"], float(row[ROAD_COLUMNS.get(key, key)]), float(row["limit_deg"])) for row in self.rows]
            self.assertEqual(sorted(got), sorted(truth))

    def test_drawn(self):
        """Text of the user's stands there as it is, without markup; a file in each format."""
        for name in ("a.svg", "a.pdf", "a.png"):
            status, _, err = run("study", SLAB, "--figure", self.folder / name, "--scatter", self.folder / f"s{name}")
            self.assertEqual((status, err), (0, ""))
            self.assertGreater((self.folder / name).stat().st_size, 4000)
        text = "".join(xml.etree.ElementTree.parse(self.folder / "a.svg").getroot().itertext())
        for word in ("Probability against tilt", "Static limit (°)", "friction_angle_deg", "Samples", "certain to move",
                     "Certain to move at 28°", "Tilt (°)"):
            self.assertIn(word, text)

    def test_refused(self):
        for words, status, why in ((("--figure", "a.txt"), 2, "--figure takes a file that ends in .svg, .pdf, .png or .csv"),
                                   (("--scatter", "a"), 2, "--scatter takes a file"),
                                   (("--figure", "a.csv", "--csv", "a.csv"), 2, "take different files"),
                                   (("--figure", "/nowhere/at/all.svg"), 5, "/nowhere/at/all.svg")):
            got, _, err = run("study", SLAB, *words)
            self.assertEqual(got, status)
            self.assertIn(why, err)
        (self.folder / "scene.yaml").write_text("topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 1}}\n"
                                                "tilt: {towards: left}\nfriction_angle_deg: 30\n")
        (self.folder / "study.yaml").write_text("topple_study: 1\nscene: scene.yaml\n"
                                                "vary: {friction_angle_deg: {list: [95, 99]}}\n")
        got, out, err = run("study", self.folder / "study.yaml", "--figure", self.folder / "none.svg")
        self.assertEqual(got, 3, err)
        self.assertIn("there is nothing to draw", err)


if __name__ == "__main__":
    main()
