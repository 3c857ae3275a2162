# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Sections that stand in a vertical plane in space, as models and surveys have them: DXF, WKT and GeoJSON give the numbers of the
same section drawn in x and y, whatever way the plane runs; what is in no vertical plane is told by how far, and where."""

import json
import math
import pathlib
import random
import re
import tempfile
import unittest

from harness import main, reads, run

#: A block with a notch on a toothed base that goes on past it on both sides: x along the section, y up.
BLOCK = [(1, 0), (2, 0.8), (3.5, 0), (5, 0), (5, 4), (1, 4)]
BASE = [(-1, 0), (1, 0), (2, 0.8), (3.5, 0), (7, 0)]
REST = "block: {unit_weight_kn_m3: 26}\nfriction_angle_deg: 35\ntilt: {towards: left, angle_deg: 12}\n"


def turned(points, along, origin=(0, 0)):
    """In space: x' along the direction on the map, y' up."""
    return [(origin[0] + along[0] * x, origin[1] + along[1] * x, y) for x, y in points]


def dxf(objects):
    """3-D polylines, each a layer, whether it is closed, and its points."""
    text = "0\nSECTION\n2\nENTITIES\n"
    for layer, closed, points in objects:
        text += f"0\nPOLYLINE\n8\n{layer}\n66\n1\n70\n{9 if closed else 8}\n"
        for point in points:
            text += f"0\nVERTEX\n8\n{layer}\n70\n32\n" + "".join(f"{code}\n{value!r}\n" for code, value in zip((10, 20, 30), point))
        text += f"0\nSEQEND\n8\n{layer}\n"
    return text + "0\nENDSEC\n0\nEOF\n"


def wkt(points, kind):
    own = [*points, points[0]] if kind == "POLYGON" else points
    inner = ", ".join(" ".join(map(repr, point)) for point in own)
    return f"{kind} Z ({'(' + inner + ')' if kind == 'POLYGON' else inner})"


class Standing(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def solve(self, drawing, name, rest=REST):
        (self.folder / name).write_text(drawing, encoding="utf-8")
        (self.folder / "scene.yaml").write_text(f"topple: 1\ndrawing: {{file: {name}, unit: m}}\n{rest}", encoding="utf-8")
        status, out, err = run("solve", "--json", "scene.yaml", folder=self.folder)
        return (json.loads(out) if out else None), status, err

    def cases(self, drawing, name):
        found, status, err = self.solve(drawing, name)
        self.assertEqual(status, 0, err)
        note = [note["text"] for note in found["notes"] if "stands in a vertical plane" in note["text"]]
        return [{key: value for key, value in case.items() if key != "effects"} for case in found["cases"]], "".join(note)

    def flat(self):
        return self.cases(dxf([("BLOCK", True, [(x, y, 0) for x, y in BLOCK]), ("BASE", False, [(x, y, 0) for x, y in BASE])]),
                          "flat.dxf")[0]

    def assert_like(self, one, other):
        self.assertEqual(len(one), len(other))
        for own, same in zip(one, other):
            for words in (("toppling", "fos"), ("toppling", "critical_angle_deg"), ("sliding", "fos"), ("limit", "critical_angle_deg"),
                          ("onset", "critical_angle_deg"), ("block", "area_m2")):
                number, expected = own[words[0]][words[1]], same[words[0]][words[1]]
                self.assertEqual(number is None, expected is None, words)
                if number is not None:
                    self.assertAlmostEqual(number["value"], expected["value"], delta=1e-7, msg=words)
            self.assertEqual(own["mechanism"], same["mechanism"])

    @unittest.skipUnless(reads("dxf"), "Topple was built without dxflib")
    def test_any_way(self):
        """Directions with whole numbers at random: block and base meet exactly, whatever digits their plane has, and the azimuth is
        that of the direction, from 0 to 180 degrees."""
        flat = self.flat()
        random.seed(12)
        for round_ in range(12):
            along = (random.randint(-9, 9), random.randint(-9, 9))
            if along == (0, 0):
                continue
            length = math.hypot(*along)
            mirrored = along < (0, 0) if along[0] != 0 else along[1] < 0  # then x runs the other way
            block, base = ([(x / length, y) for x, y in points] for points in (BLOCK, BASE))
            if mirrored:
                block, base = ([(-x, y) for x, y in points][::-1] for points in (block, base))
            objects = [("BASE", False, turned(base, along, (100, 200))), ("BLOCK", True, turned(block, along, (100, 200)))]
            if round_ % 2:
                objects.reverse()
            # binary fractions of the points are off the plane by some 1e-16, which is projected
            found, note = self.cases(dxf(objects).replace("TEXT", ""), "stands.dxf")
            self.assert_like(found, flat)
            azimuth = math.degrees(math.atan2(*along)) % 180
            self.assertIn(f"azimuth {azimuth:.2f}°", note)

    def test_exact(self):
        """Along (3, 4), whose length is 5, every number is that of the section in x and y, digit by digit."""
        along = (3, 4)
        for name in ("stands.wkt", "stands.geojson"):
            block, base = (turned([(x / 5, y) for x, y in points], along) for points in (BLOCK, BASE))
            block, base = ([(round(x, 9), round(y, 9), z) for x, y, z in points] for points in (block, base))
            if name.endswith("wkt"):
                text = wkt(block, "POLYGON") + "\n" + wkt(base, "LINESTRING") + "\n"
                flat = wkt([(x, y, 0) for x, y in BLOCK], "POLYGON") + "\n" + wkt([(x, y, 0) for x, y in BASE], "LINESTRING") + "\n"
            else:
                if not reads("geojson"):
                    continue
                text, flat = (json.dumps({"type": "FeatureCollection", "features": [
                    {"type": "Feature", "geometry": {"type": "Polygon", "coordinates": [[*own, own[0]]]}, "properties": {"layer": "block"}},
                    {"type": "Feature", "geometry": {"type": "LineString", "coordinates": other}, "properties": {"layer": "base"}}]})
                    for own, other in ((block, base), (BLOCK, BASE)))
            found, note = self.cases(text, name)
            self.assertIn("azimuth 36.87°", note)
            expected, plain = self.cases(flat, "flat_" + name)
            self.assertEqual(plain, "")
            self.assert_like(found, expected)
            for key in ("toppling", "sliding", "limit", "governing_fos"):
                self.assertEqual(found[0][key].get("fos"), expected[0][key].get("fos"), key)

    @unittest.skipUnless(reads("dxf"), "Topple was built without dxflib")
    def test_beside_the_plane(self):
        """A vertex 0.1 mm beside a plane of 6 m is projected, and the note says so; one by 0.3 m is refused at its line, with its
        distance; so is a section in an inclined plane."""
        flat = self.flat()
        block, base = turned(BLOCK, (1, 0)), turned(BASE, (1, 0))
        near = [*block[:4], (5, 0.0001, 4), block[5]]
        found, note = self.cases(dxf([("BLOCK", True, near), ("BASE", False, base)]), "near.dxf")
        self.assert_like(found, flat)
        self.assertIn("points up to 0.0001 beside it are projected", note)
        text = dxf([("BLOCK", True, [*block[:4], (5, 0.3, 4), block[5]]), ("BASE", False, base)])
        found, status, err = self.solve(text, "far.dxf")
        self.assertEqual(status, 3)
        line = text[:text.index("0.3\n")].count("\n") - 1  # of its x
        self.assertRegex(err, rf"far\.dxf:{line}:1: z changes .* this point lies 0\.3 beside its vertical plane, through \(-1, 0\) and \(7, ")
        inclined = [(x, y / 2, y) for x, y in BLOCK]
        found, status, err = self.solve(dxf([("BLOCK", True, inclined), ("BASE", False, base)]), "inclined.dxf")
        self.assertEqual(status, 3)
        self.assertIn("beside its vertical plane", err)
        pole = [(2, 3, z) for z in (0, 1, 2)]
        found, status, err = self.solve(dxf([("BLOCK", True, pole), ("BASE", False, base)]), "pole.dxf")
        self.assertEqual(status, 3)

    @unittest.skipUnless(reads("dxf"), "Topple was built without dxflib")
    def test_flat_ones(self):
        """A section in x and y beside lines in space that have no role is as it was; one of which a part lies flat is refused."""
        flat = self.flat()
        objects = [("BLOCK", True, [(x, y, 0) for x, y in BLOCK]), ("BASE", False, [(x, y, 0) for x, y in BASE])]
        contour = ("TERRAIN", False, [(0, 0, 5), (3, 4, 7), (9, 1, 2)])
        found, note = self.cases(dxf([contour, *objects]), "terrain.dxf")
        self.assertEqual((found, note), (flat, ""))
        circle = "0\nCIRCLE\n8\nHOLE\n10\n3.0\n20\n2.0\n40\n0.5\n"
        text = dxf([("BLOCK", True, turned(BLOCK, (1, 0))), ("BASE", False, turned(BASE, (1, 0)))]).replace("0\nENDSEC", circle + "0\nENDSEC")
        found, status, err = self.solve(text, "hole.dxf")
        self.assertEqual(status, 3)
        self.assertRegex(err, r"hole\.dxf:\d+:\d+: this CIRCLE lies in x and y, and others stand in the vertical plane through")


if __name__ == "__main__":
    main()
