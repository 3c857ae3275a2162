# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The overturning spectrum of a slab by rigid contacts, against Housner's equation of rocking integrated here: the least pulse
at each frequency, and the islands in which a stronger one spares it. Of a record its speed takes the place of a frequency."""

import csv
import json
import math
import pathlib
import tempfile
import unittest

from harness import ROOT, main, run
from rocking_case import GRAVITY, PULSE, SLAB, overturns


class Spectrum(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def write(self, text):
        (self.folder / "scene.yaml").write_text(text)
        return self.folder / "scene.yaml"

    def rows(self, scene, frequencies):
        path = self.folder / "spectrum.csv"
        status, _, err = run("tilt", "--json", "--spectrum", path, "--frequencies", frequencies, scene)
        self.assertEqual(status, 0, err)
        with open(path, encoding="utf-8") as table:
            return list(csv.DictReader(table))

    def test_half_sines(self):
        """At each frequency Housner's slab is spared at the lower end of the bracket and overturned at the upper one, 2e-4 of it
        apart from either; PGV is PGA over pi f."""
        rows = self.rows(self.write(SLAB + PULSE.format(form="half_sine", f=1)), "0.25:4:5")
        own = [row for row in rows if row["panel_of"] == "frequency" and row["edge"] == "least found that overturns"]
        self.assertEqual([float(row["x"]) for row in own], [0.25, 0.5, 1, 2, 4])
        for row in own:
            frequency, peak, half = float(row["x"]), float(row["pga_g"]), float(row["y_error"])
            self.assertLessEqual(half, 0.5e-3 * peak)
            self.assertFalse(overturns((peak - half) * (1 - 2e-4), frequency, 0.5), row)
            self.assertTrue(overturns((peak + half) * (1 + 2e-4), frequency, 0.5), row)
            self.assertAlmostEqual(float(row["pgv_m_s"]), peak * GRAVITY / (math.pi * frequency), delta=1e-12)
            self.assertEqual(row["runs_decided"], "all")
        both = [row for row in rows if row["panel_of"] == "pgv" and row["edge"] == own[0]["edge"]]
        self.assertEqual([row["pga_g"] for row in both], [row["pga_g"] for row in own])
        for row, other in zip(both, own):
            self.assertAlmostEqual(float(row["x"]), float(other["pgv_m_s"]), delta=1e-13)

    def test_islands_of_full_sines(self):
        """A whole period of a sine overturns a slab after one impact or before any, and between these it is spared (Zhang and
        Makris 2001): just inside of each edge of such an island Housner's slab is spared, just outside it is overturned."""
        rows = self.rows(self.write(SLAB + PULSE.format(form="full_sine", f=1)), "1.2:2.4:4")
        edges = [row for row in rows if row["panel_of"] == "frequency" and row["edge"] in ("stands again from", "stands up to")]
        self.assertEqual(len(edges), 8)
        for row in edges:
            frequency, peak, half = float(row["x"]), float(row["pga_g"]), float(row["y_error"])
            below = overturns((peak - half) * (1 - 5e-4), frequency, 1)
            above = overturns((peak + half) * (1 + 5e-4), frequency, 1)
            self.assertEqual((below, above), (True, False) if row["edge"] == "stands again from" else (False, True), row)

    def test_record(self):
        """At the speed of its record: the two ends of the bracket, and of an island, as the test itself runs them."""
        boulder = ROOT / "examples" / "shaken_boulder.yaml"
        rows = [row for row in self.rows(boulder, "1:1.5:2") if row["panel_of"] == "frequency" and float(row["x"]) == 1]
        peak = json.loads(run("tilt", "--json", boulder)[1])["shaking"]["horizontal"]["peak_g"]
        edges = {"least found that overturns": (False, True), "stands again from": (True, False), "stands up to": (False, True)}
        self.assertEqual({row["edge"] for row in rows}, set(edges))
        for row in rows:
            for sign, overturned in zip((-1, 1), edges[row["edge"]]):
                # scale 1.5 is the scene's; a last digit's worth inside the two runs that it lies between
                scale = 1.5 * (float(row["pga_g"]) + sign * float(row["y_error"]) * (1 + 1e-12)) / peak
                told = json.loads(run("tilt", "--json", "--set", f"shaking.horizontal.record.scale={scale!r}", boulder)[1])
                self.assertEqual(told["cases"][0]["end"] == "overturned", overturned, row)

    def test_figure(self):
        path = self.folder / "spectrum.svg"
        scene = self.write(SLAB + PULSE.format(form="full_sine", f=1))
        self.assertEqual(run("tilt", "--json", "--spectrum", path, "--frequencies", "1.6:2:2", scene)[0], 0)
        text = path.read_text()
        for words in ("Frequency of the pulse (Hz)", "PGV (m/s)", "PGA (g)", "stands again", "static limit"):
            self.assertTrue(words in text, words)

    def test_refused(self):
        scene = self.write(SLAB + "tilt_test: {engine: path}\n")
        status, _, err = run("tilt", "--spectrum", self.folder / "a.csv", scene)
        self.assertEqual(status, 3)
        self.assertIn("needs a base that shakes", err)
        for text in ("1:2", "2:1:5", "0:1:5", "1:2:1", "1:2:201", "a:2:3", "1:2:3x"):
            status, _, err = run("tilt", "--spectrum", self.folder / "a.csv", "--frequencies", text, scene)
            self.assertEqual(status, 2, text)
            self.assertIn("--frequencies takes FROM:TO:COUNT", err)
        wide = self.write(SLAB.replace("width: 1, height: 4", "width: 9, height: 1").replace("friction_angle_deg: 70",
                                                                                             "friction_angle_deg: 5")
                          + PULSE.format(form="half_sine", f=4) + "tilt_test: {duration_s: 0.1}\n")
        status, _, err = run("tilt", "--spectrum", self.folder / "a.csv", "--frequencies", "4:5:2", wide)
        self.assertEqual(status, 3)
        self.assertIn("no shaking of up to 64 g overturns", err)
        self.assertFalse((self.folder / "a.csv").exists())


if __name__ == "__main__":
    main()
