# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Charts of a tilt test: reactions balance the weight at every point drawn, and bend at the events that the test tells; the
phase portrait of a rocking slab is Housner's. Numbers are worked out here from the drawing's table and the scene alone."""

import csv
import json
import math
import pathlib
import tempfile
import unittest
import xml.etree.ElementTree

from harness import ROOT, main, run

GRAVITY = 9.80665
SLAB = "topple: 1\nlength_unit: m\nblock: {{slab: {{width: {w}, height: {h}}}, unit_weight_kn_m3: 25}}\n" \
       "base: {{profile: [[-20, 0], [20, 0]]}}\nfriction_angle_deg: 60\ntilt: {{towards: left, angle_deg: 0}}\n"


class TiltCharts(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def write(self, text):
        (self.folder / "scene.yaml").write_text(text)
        return self.folder / "scene.yaml"

    def rows(self, option, scene, *options):
        """The chart's table, and the test it is of as JSON."""
        path = self.folder / "chart.csv"
        status, out, err = run("tilt", "--json", option, path, *options, scene)
        self.assertEqual(status, 0, err)
        with open(path, encoding="utf-8") as table:
            return list(csv.DictReader(table)), json.loads(out)["cases"]

    def test_reactions_of_block_e(self):
        """Reactions along the facets' own directions, which follow from the teeth, add up to the weight of 5.689 N, tilted, at
        each of the tilts: those of the moments, and of the events exactly. The balance holds to 1e-13 of the weight."""
        rows, cases = self.rows("--reactions", ROOT / "examples" / "tilt_block_e_valley.yaml")
        weight = 25.8e3 * 0.02 * 90 * 122.5e-6
        forces = {}
        for row in rows:
            if row["event"] == "":
                forces.setdefault(float(row["angle_deg"]), {})[row["force"], int(row["facet"])] = float(row["force_n"])
        self.assertGreater(len(forces), 130)
        rise = {1: 5, 2: -5, 3: 5}
        for tilt, own in forces.items():
            x = y = 0
            for facet, height in rise.items():
                along = (30 / math.hypot(30, height), height / math.hypot(30, height))
                normal, shear = own["normal", facet], own["shear", facet]
                self.assertGreaterEqual(normal, 0)
                self.assertLessEqual(abs(shear), math.tan(math.radians(30)) * normal + 1e-9 * weight)
                x += shear * along[0] - normal * along[1]
                y += shear * along[1] + normal * along[0]
            self.assertAlmostEqual(x, weight * math.sin(math.radians(tilt)), delta=1e-11 * weight)
            self.assertAlmostEqual(y, weight * math.cos(math.radians(tilt)), delta=1e-11 * weight)
        last = cases[0]["critical_angle_deg"]["stands_at"]  # the curves end before, where displacements are no longer small
        self.assertLess(max(forces), last)
        self.assertGreater(max(forces), last - 0.05)
        marks = {(row["event"], int(row["facet"]), float(row["angle_deg"])) for row in rows if row["event"] != ""}
        told = {(event["what"], event["facet"], event["angle_deg"]) for event in cases[0]["events"] if event["facet"] > 0}
        self.assertEqual(marks, told)
        for row in rows:
            if row["event"] != "":  # each stands on its curve
                self.assertEqual(float(row["force_n"]), forces[float(row["angle_deg"])][row["force"], int(row["facet"])])
            self.assertEqual((row["x_error"], row["y_error"]), ("0", "0"))

    def test_slab_and_numbering(self):
        """A slab on a base that goes on: its one facet is the second of the base and the first of the contact, and says so;
        it bears W cos and W sin of the tilt, up to the tilt at which the slab begins to move, by each engine."""
        text = SLAB.format(w=1, h=3).replace("[[-20, 0], [20, 0]]", "[[-20, 0], [-5, 0], [9, 0], [10, 3]]")
        weight, alpha = 75e3, math.degrees(math.atan2(1, 3))
        for engine in ("engine: path", "engine: dynamics, protocol: ramp"):
            with self.subTest(engine):
                scene = self.write(text + f"tilt_test: {{{engine}, until_deg: 30}}\n")
                rows, cases = self.rows("--reactions", scene)
                self.assertGreater(len(rows), 400)
                for row in rows:
                    tilt = math.radians(float(row["angle_deg"]))
                    self.assertLessEqual(float(row["angle_deg"]), alpha + 1e-6)
                    truth = weight * (math.sin(tilt) if row["force"] == "shear" else math.cos(tilt))
                    self.assertEqual(row["facet"], "2")
                    self.assertAlmostEqual(float(row["force_n"]), truth, delta=1e-9 * weight)
                self.assertEqual(cases[0]["facets"], [{"facet": 2, "contact": 1, "x0_m": -5, "y0_m": 0, "x1_m": 9, "y1_m": 0}])
                self.assertIn("facet 2, (-5, 0) to (9, 0): facet 1 of the contact", run("tilt", scene)[1])

    def test_no_energy_of_a_path(self):
        """A path sums no energy: none is told, in place of a zero that would say that it balanced."""
        scene = self.write(SLAB.format(w=1, h=3) + "tilt_test: {engine: path, until_deg: 10}\n")
        own = json.loads(run("tilt", "--json", scene)[1])["cases"][0]
        self.assertIsNone(own["energy_balance_j"])
        self.assertEqual({moment["energy_balance_j"] for moment in own["moments"]}, {None})
        for line in run("tilt", "--csv", scene)[1].splitlines()[1:]:
            self.assertTrue(line.endswith(","), line)

    def test_phase_portrait_of_a_rocking_slab(self):
        """After its pulse a slab of 1 m by 4 m rocks freely: w^2 / 2 + p^2 cos(alpha - |theta|) stays as it is, p^2 = 3 g / 4 R,
        and each impact takes w to (1 - 3/2 sin^2 alpha) w (Housner 1963). Every point drawn lies on such an arc."""
        scene = self.write(SLAB.format(w=1, h=4)
                           + "shaking: {horizontal: {half_sine: {peak_g: 0.5, frequency_hz: 1}}}\n"
                             "tilt_test: {duration_s: 12}\n")
        rows, cases = self.rows("--phase", scene, "--moments", "600")
        alpha, p2 = math.atan2(1, 4), 3 * GRAVITY / (4 * math.hypot(0.5, 2))
        kept = 1 - 1.5 * math.sin(alpha) ** 2
        own = [row for row in rows if row["motion"] == "turning" and float(row["time_s"]) > 0.5]
        self.assertEqual([float(row["time_s"]) for row in own],
                         [moment["time_s"] for moment in cases[0]["moments"] if moment["time_s"] > 0.5])
        energy, impacts, last = None, 0, None
        for row in own:
            theta, speed = math.radians(float(row["place"])), math.radians(float(row["speed"]))
            now = speed ** 2 / 2 + p2 * math.cos(alpha - abs(theta))
            if last is not None and row["time_s"] == last[0]:
                impacts += 1
                self.assertAlmostEqual(theta, 0, delta=1e-9)
                self.assertAlmostEqual(speed, kept * last[1], delta=1e-7)
                energy = now
            energy = now if energy is None else energy
            self.assertAlmostEqual(now, energy, delta=1e-7 * p2)
            last = row["time_s"], speed
        self.assertGreater(impacts, 5)
        self.assertGreater(len(own), 500)

    def test_figures(self):
        """Both are drawn, in both directions of tilt with a panel for each, in every format; a title from outside is data."""
        scene = self.write('title: "a }{/Symbol <b> %s \\\\ `id`"\n'
                           + SLAB.format(w=1, h=3).replace("towards: left", "towards: both").replace("angle_deg: 0", "angle_deg: 20")
                           + "tilt_test: {engine: dynamics, protocol: release, duration_s: 3}\n")
        for ending, begins in (("svg", b"<?xml"), ("pdf", b"%PDF"), ("png", b"\x89PNG")):
            reactions, phase = self.folder / f"r.{ending}", self.folder / f"p.{ending}"
            status, _, err = run("tilt", "--reactions", reactions, "--phase", phase, scene)
            self.assertEqual(status, 0, err)
            for path in (reactions, phase):
                self.assertTrue(path.read_bytes().startswith(begins), path)
        drawn = "".join(xml.etree.ElementTree.parse(self.folder / "r.svg").getroot().itertext())
        for words in ("Tilted towards the left", "Tilted towards the right", "Normal force (N)", "Shear force (N)", "Time (s)"):
            self.assertIn(words, drawn)
        drawn = "".join(xml.etree.ElementTree.parse(self.folder / "p.svg").getroot().itertext())
        self.assertIn("Angular velocity (°/s)", drawn)

    def test_refused(self):
        """A name that says no format is refused before anything is computed; a path has no phase portrait."""
        scene = self.write(SLAB.format(w=1, h=3) + "tilt_test: {engine: path}\n")
        status, out, err = run("tilt", "--reactions", "x.gif", scene)
        self.assertEqual((status, out), (2, ""))
        self.assertIn("--reactions 'x.gif' must end in .svg, .pdf, .png or .csv", err)
        status, out, err = run("tilt", "--phase", self.folder / "p.csv", scene)
        self.assertEqual(status, 3)
        self.assertIn("a path simulates no motion", err)
        self.assertFalse((self.folder / "p.csv").exists())


if __name__ == "__main__":
    main()
