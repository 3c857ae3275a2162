# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""`arc_tolerance`: chords for arcs, so that what takes straight edges alone takes a curved block. The chords end on the arcs and
leave them by no more than the tolerance; numbers come to those of the exact arcs as it shrinks, within bounds that follow from
it; a block set down by its chords lies as the polygon of these chords."""

import json
import math
import pathlib
import re
import tempfile
import unittest

from harness import main, run
from test_figure_dxf import File

HEAD = "topple: 1\nlength_unit: m\n"
#: A wall with an arched top, and a notch in its left side: one arc outwards, one inwards.
ARCHED = ("block: {{outline: [[0, 0], [3, 0], [3, 4], [0, 4], [0, 3], [0, 1]], arcs: [{{from: [3, 4], {top}}}, "
          "{{from: [0, 3], bulge: -0.2}}]{more}, unit_weight_kn_m3: 26}}\n")
STANDS = "friction_angle_deg: 35\ntilt: {towards: left, angle_deg: 10}\n"
#: An oval stone: half circles of radius 1 about (1, 1) and (3, 1).
OVAL = "block: {{outline: [[1, 0], [3, 0], [3, 2], [1, 2]], arcs: [{{from: [3, 0], bulge: 1}}, {{from: [1, 2], bulge: 1}}]{more}, unit_weight_kn_m3: 26}}\n"


class ArcChords(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def write(self, text, name="scene.yaml"):
        path = self.folder / name
        path.write_text(HEAD + text, encoding="utf-8")
        return path

    def solve(self, text, *words):
        status, out, err = run("solve", "--json", *words, self.write(text))
        self.assertEqual(status, 0, err)
        return json.loads(out)

    def cases(self, text, *words):
        """Of each direction all but what it cost."""
        return [{key: value for key, value in case.items() if key != "effects"} for case in self.solve(text, *words)["cases"]]

    def refused(self, text, saying):
        status, _, err = run("solve", self.write(text))
        self.assertEqual(status, 3, err)
        self.assertIn(saying, err)

    def test_comes_to_the_arcs(self):
        """Area, centroid and the angle of toppling differ from those of the exact arcs by no more than the tolerance makes: the area
        by tolerance times the length of the arcs, the centroid by that over the area times twice the diameter."""
        exact = self.solve(ARCHED.format(top="bulge: 0.5", more="") + STANDS)["cases"][0]
        arcs = sum(chord * (1 + b * b) / b * math.atan(b) for chord, b in ((3, 0.5), (2, 0.2)))
        area = exact["block"]["area_m2"]["value"]
        x, y = (exact["block"][key]["value"] for key in ("centroid_x_m", "centroid_y_m"))
        last = math.inf
        for tolerance in (0.1, 0.01, 1e-3, 1e-5):
            found = self.solve(ARCHED.format(top="bulge: 0.5", more=f", arc_tolerance: {tolerance}") + STANDS)
            note = [note["text"] for note in found["notes"] if "chords stand" in note["text"]]
            self.assertEqual(len(note), 1)
            self.assertIn(f"nowhere more than {tolerance:g} m".replace("1e-05", "0.00001"), note[0])
            own = found["cases"][0]
            off = abs(own["block"]["area_m2"]["value"] - area)
            self.assertLess(off, tolerance * arcs)
            self.assertLess(off, last)
            last = off
            self.assertGreaterEqual(float(re.search(r"at most (\S+) m² of area", note[0])[1]) * 1.05, off)
            shift = 2 * tolerance * arcs / (area - tolerance * arcs) * math.hypot(4, 5)
            for key, value in (("centroid_x_m", x), ("centroid_y_m", y)):
                self.assertLess(abs(own["block"][key]["value"] - value), shift)
            angle = [case["toppling"]["critical_angle_deg"]["value"] for case in (own, exact)]
            self.assertLess(abs(math.tan(math.radians(angle[0])) - x / y), shift * (1 + x / y) / (y - shift))
            self.assertLess(abs(angle[0] - angle[1]), math.degrees(shift * (1 + x / y) / (y - shift)))

    def test_chords_lie_on_the_arc(self):
        """Every vertex lies on the circle to a thousandth of the tolerance, every middle of a chord within it by no more than the
        tolerance; an arc through a point has the chords of its bulge."""
        tolerance = 0.004
        radius, centre = 3 * (1 + 0.25) / (4 * 0.5), (1.5, 4 - 3 * (1 - 0.25) / (4 * 0.5))
        rings = []
        for top in ("bulge: 0.5", "through: [1.5, 4.75]"):
            path = self.folder / "drawn.dxf"
            scene = self.write(ARCHED.format(top=top, more=f", arc_tolerance: {tolerance}") + STANDS)
            self.assertEqual(run("solve", "--quiet", "--figure", path, scene)[0], 0)
            ring = [(float(x), float(y)) for x, y in File(path).points("BLOCK")]
            rings.append(ring)
            arch = [(x, y) for x, y in ring if y >= 4]
            self.assertGreater(len(arch), 10)
            for x, y in arch:
                self.assertLess(abs(math.hypot(x - centre[0], y - centre[1]) - radius), tolerance / 900)
            for (x, y), (to_x, to_y) in zip(arch, arch[1:]):
                sagitta = radius - math.hypot((x + to_x) / 2 - centre[0], (y + to_y) / 2 - centre[1])
                self.assertTrue(0 < sagitta < tolerance, sagitta)
        self.assertEqual(rings[0], rings[1])

    def test_within_and_rest(self):
        """`within` and `place: rest` refuse arcs and name the key; with it an oval comes to rest as the polygon of its chords does,
        given as an outline: the same numbers."""
        ground = "base: {profile: [[-1, -0.001], [5, -0.001]]}\ncontact: {within: 0.01}\nfriction_angle_deg: 35\n"
        self.refused(OVAL.format(more="") + ground, "'arc_tolerance' of the block makes chords")
        found = self.solve(OVAL.format(more=", arc_tolerance: 0.02") + ground)
        self.assertLess(abs(found["cases"][0]["block"]["area_m2"]["value"] - (4 + math.pi)), 0.02 * 2 * math.pi)
        bowl = "base: {profile: [[-2, 3], [1, 0], [3, 0.5], [6, 3]], place: rest}\nfriction_angle_deg: 35\n"
        self.refused(OVAL.format(more="") + bowl, "'arc_tolerance' of the block makes chords")
        rests = self.solve(OVAL.format(more=", arc_tolerance: 0.05") + bowl)["cases"]
        path = self.folder / "chords.dxf"
        mated = self.write(OVAL.format(more=", arc_tolerance: 0.05") + "friction_angle_deg: 35\n")
        self.assertEqual(run("solve", "--quiet", "--figure", path, mated)[0], 0)
        ring = ", ".join(f"[{x}, {y}]" for x, y in File(path).points("BLOCK"))
        polygon = self.solve(f"block: {{outline: [{ring}], unit_weight_kn_m3: 26}}\n" + bowl)["cases"]
        for one, other in zip(rests, polygon):
            for key in ("block", "contact", "pivots", "toppling", "limit"):
                self.assertEqual(one[key], other[key], key)

    def test_bulges_of_a_drawing(self):
        """Bulges of a drawing are arcs like any other; water with a level presses on the chords."""
        lines = [f"0\nVERTEX\n8\nBLOCK\n10\n{x}\n20\n{y}\n42\n{b}" for x, y, b in ((0, 0, 0), (3, 0, 0), (3, 4, 0.5), (0, 4, 0))]
        text = "\n".join(["0\nSECTION\n2\nENTITIES\n0\nPOLYLINE\n8\nBLOCK\n66\n1\n70\n1", *lines, "0\nSEQEND\n0\nENDSEC\n0\nEOF\n"])
        (self.folder / "block.dxf").write_text(text, encoding="ascii")
        scene = ("drawing: {file: block.dxf, unit: m}\nblock: {unit_weight_kn_m3: 26%s}\nfriction_angle_deg: 35\n"
                 "tilt: {towards: left, angle_deg: 10}\nloads: {water: {level: 2}}\n")
        self.refused(scene % "", "'arc_tolerance' of the block makes chords")
        wet = self.solve(scene % ", arc_tolerance: 0.01")
        dry = self.solve(ARCHED.format(top="bulge: 0.5", more=", arc_tolerance: 0.01") + STANDS)
        self.assertLess(wet["cases"][0]["toppling"]["fos"]["value"], dry["cases"][0]["toppling"]["fos"]["value"])

    def test_set_and_refused(self):
        """It is set and found by its key; what is no tolerance is refused at its place; without arcs it does nothing."""
        text = ARCHED.format(top="bulge: 0.5", more=", arc_tolerance: 0.01") + STANDS
        coarse = self.cases(text, "--set", "block.arc_tolerance=0.1")
        self.assertEqual(coarse, self.cases(text.replace("0.01", "0.1")))
        self.assertNotEqual(coarse, self.cases(text))
        self.refused(text.replace("arc_tolerance: 0.01", "arc_tolerance: 0"), "arc_tolerance must be above zero")
        self.refused(text.replace("arc_tolerance: 0.01", "arc_tolerance: 1e-14"), "scene.yaml:3:")
        plain = "block: {slab: {width: 1, height: 2}%s}\n" + STANDS
        self.assertEqual(self.cases(plain % ""), self.cases(plain % ", arc_tolerance: 0.01"))


if __name__ == "__main__":
    main()
