# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Figures as DXF: outlines where the block lies, in the scene's unit, decimals of a section in the world as they were given, of
one on a slope turned by its dip; what is read back is the block that was solved; other readers take the file."""

import itertools
import json
import math
import pathlib
import tempfile
import unittest
from decimal import Decimal

from harness import ROOT, example_scenes, main, reads, run

LAYERS = {"BLOCK", "HOLE", "PART", "BASE", "CONTACT", "WATER", "BOLTS", "FORCES", "MECHANISM", "TEXT"}
WORLD = """topple: 1
title: "Section \\u00c4\\n  0\\nLINE"
length_unit: m
block:
  outline: [[4500100.123, 5600020.5], [4500103.587, 5600022.51], [4500101.587, 5600025.964], [4500098.123, 5600023.964]]
  unit_weight_kn_m3: 26
frame: world
friction_angle_deg: 36
loads:
  water: {height: 1, uplift: true}
  anchors: [{at: [4500100.125, 5600024.5], dip_deg: 15, towards: right, force_kn: 50, length: 6, capacity_kn: 100}]
"""


def groups(text):
    """Pairs of a code and its value."""
    lines = text.split("\n")
    return [(int(code), value) for code, value in zip(lines[0::2], lines[1::2])]


def area_of(polyline):
    """By triangles from its first point; over a chord the segment of a circle of four times the angle of its bulge."""
    area, first = 0, [Decimal(number) for number in polyline[0][:2]]
    points = [(float(Decimal(x) - first[0]), float(Decimal(y) - first[1]), float(bulge)) for x, y, bulge in polyline]
    for (x, y, bulge), (to_x, to_y, _) in zip(points, points[1:] + points[:1]):
        area += (x * to_y - y * to_x) / 2
        if bulge != 0:
            angle = 4 * math.atan(bulge)
            radius = math.hypot(to_x - x, to_y - y) / 2 / math.sin(angle / 2)
            area += radius**2 / 2 * (angle - math.sin(angle))
    return abs(area)


class File:
    """The entities of a DXF, a list each of its groups; the polylines by layer, vertices with their bulges, as they are spelled."""

    def __init__(self, path):
        self.entities, self.polylines, self.closed = [], {}, {}
        self.bytes = pathlib.Path(path).read_bytes()
        text = self.bytes.decode("ascii")
        assert text.endswith("EOF\n")
        pairs = groups(text)
        begin = pairs.index((2, "ENTITIES"))
        self.head = dict(itertools.pairwise(value for _, value in pairs[:begin]))
        self.layers = {value for (code, value), (_, kind) in zip(pairs[1:begin], pairs) if code == 2 and kind == "LAYER"}
        for code, value in pairs[begin + 1:]:
            if code == 0:
                self.entities.append([])
            if self.entities:
                self.entities[-1].append((code, value))
        for entity in map(dict, self.entities):
            if entity[0] == "POLYLINE":
                self.polylines.setdefault(entity[8], []).append([])
                self.closed.setdefault(entity[8], []).append(int(entity[70]) == 1)
            if entity[0] == "VERTEX":
                self.polylines[entity[8]][-1].append((entity[10], entity[20], entity.get(42, "0")))

    def points(self, layer, number=0):
        return [(Decimal(x), Decimal(y)) for x, y, _ in self.polylines[layer][number]]

    def of(self, kind, layer):
        return [dict(own) for own in self.entities if own[0][1] == kind and dict(own)[8] == layer]


class FigureDxf(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def draw(self, scene, *words, name="drawn.dxf"):
        path = self.folder / name
        status, _, err = run("solve", "--quiet", "--figure", path, *words, scene, folder=ROOT)
        self.assertIn(status, (0, 1, 4), (scene, err))
        return File(path)

    def write(self, text, name="scene.yaml"):
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path

    def test_world(self):
        """A section in national coordinates comes back decimal for decimal, with its base; the unit is told; what acts on it has
        layers of its own; a title with line ends adds no group."""
        own = self.draw(self.write(WORLD))
        given = [("4500100.123", "5600020.5"), ("4500103.587", "5600022.51"), ("4500101.587", "5600025.964"),
                 ("4500098.123", "5600023.964")]
        self.assertEqual([(x, y) for x, y, _ in own.polylines["BLOCK"][0]], given)
        self.assertEqual([(x, y) for x, y, _ in own.polylines["BASE"][0]], given[:2])
        self.assertEqual((own.closed["BLOCK"], own.closed["BASE"]), ([True], [False]))
        self.assertEqual((own.head["$ACADVER"], own.head["$INSUNITS"].strip()), ("AC1009", "6"))
        self.assertEqual(own.layers, LAYERS)
        self.assertLessEqual({dict(entity).get(8) for entity in own.entities} - {None}, LAYERS)
        for kind, layer in (("LINE", "CONTACT"), ("POLYLINE", "WATER"), ("LINE", "BOLTS"), ("LINE", "FORCES"), ("TEXT", "TEXT")):
            self.assertTrue(own.of(kind, layer), (kind, layer))
        bolt = own.of("LINE", "BOLTS")[0]
        self.assertEqual((bolt[10], bolt[20]), ("4500100.125", "5600024.5"))
        way = [float(bolt[a]) - float(bolt[b]) for a, b in ((11, 10), (21, 20))]
        self.assertAlmostEqual(way[0], 6 * math.cos(math.radians(15)), delta=1e-8)  # some ulp of the coordinates
        self.assertAlmostEqual(way[1], -6 * math.sin(math.radians(15)), delta=1e-8)
        words = [text[1] for text in own.of("TEXT", "TEXT")]
        self.assertIn("\\U+00C4", words[0])
        self.assertTrue(any("FoS" in line for line in words), words)
        self.assertEqual(own.bytes, self.draw(self.write(WORLD)).bytes)

    def test_weight_points_down(self):
        """The arrow of the weight begins at the centroid and hangs straight down, on a slope and in the world."""
        slab = ("topple: 1\nlength_unit: m\nblock: {slab: {width: 3, height: 2}, unit_weight_kn_m3: 26}\n"
                "slope: {dip_deg: 25, towards: left}\nfriction_angle_deg: 36\n")
        for text in (WORLD, slab):
            arrow = {key: float(value) for key, value in self.draw(self.write(text)).of("LINE", "FORCES")[0].items() if key in
                     (10, 20, 11, 21)}
            self.assertAlmostEqual(arrow[10], arrow[11], delta=1e-8)
            self.assertLess(arrow[21], arrow[20] - 0.1)

    def test_slope(self):
        """On a slope the outline is turned by its dip about the origin of the scene, either way."""
        for towards, sign in (("left", 1), ("right", -1)):
            text = (f"topple: 1\nlength_unit: cm\nblock: {{outline: [[10, 5], [310, 5], [280, 205], [10, 205]]}}\n"
                    f"slope: {{dip_deg: 25.5, towards: {towards}}}\nfriction_angle_deg: 36\n")
            own = self.draw(self.write(text))
            angle = sign * math.radians(25.5)
            for (x, y), (a, b) in zip(own.points("BLOCK"), [(10, 5), (310, 5), (280, 205), (10, 205)]):
                self.assertAlmostEqual(float(x), a * math.cos(angle) - b * math.sin(angle), delta=1e-12)
                self.assertAlmostEqual(float(y), a * math.sin(angle) + b * math.cos(angle), delta=1e-12)
            self.assertEqual(own.head["$INSUNITS"].strip(), "5")

    def test_earthquake_up_dip(self):
        """Under an earthquake up-dip the block lies where it lies all the same."""
        text = WORLD.replace("loads:\n", "loads:\n  seismic: {horizontal: 0.2, direction: up_dip}\n")
        own, still = self.draw(self.write(text)), self.draw(self.write(WORLD))
        self.assertEqual(own.polylines["BLOCK"], still.polylines["BLOCK"])
        slope = ("topple: 1\nlength_unit: m\nblock: {outline: [[1, 0], [4, 0], [4, 2], [1, 2]], unit_weight_kn_m3: 26}\n"
                 "slope: {dip_deg: 25, towards: right}\nfriction_angle_deg: 36\n")
        own, still = self.draw(self.write(slope + "loads: {seismic: {horizontal: 0.2, direction: up_dip}}\n")), self.draw(self.write(slope))
        for one, other in zip(own.points("BLOCK"), still.points("BLOCK")):
            self.assertAlmostEqual(float(one[0]), float(other[0]), delta=1e-14)
            self.assertAlmostEqual(float(one[1]), float(other[1]), delta=1e-14)

    def test_areas(self):
        """Of every example the area within the block's polyline, bulges counted and holes taken off, is that which was solved; the
        chords of an ellipse have some 1e-5 of it less."""
        for scene in example_scenes():
            status, out, _ = run("solve", "--json", scene)
            if status not in (0, 1, 4) or "model: paper" in scene.read_text(encoding="utf-8"):
                continue  # that model keeps the area of the sharp block
            found = json.loads(out)["cases"][0]["block"]
            own = self.draw(scene)
            metres = {"4": 1e-3, "5": 1e-2, "6": 1}[own.head["$INSUNITS"].strip()]
            area = sum(map(area_of, own.polylines["BLOCK"])) - sum(map(area_of, own.polylines.get("HOLE", [])))
            ellipse = "ellipse:" in scene.read_text(encoding="utf-8")
            share = area * metres**2 / found["area_m2"]["value"] - 1
            self.assertLess(abs(share), 5e-5 if ellipse else 1e-9, scene)
            self.assertEqual(own.closed["BLOCK"], [True])

    @unittest.skipUnless(reads("dxf"), "Topple was built without dxflib")
    def test_solved_again(self):
        """Block and base read back stand as they did: the same factors, for a section in the world and for an arched block."""
        arched = ("topple: 1\nlength_unit: mm\nblock: {outline: [[0, 0], [300, 0], [300, 400], [0, 400]], "
                  "arcs: [{from: [300, 400], bulge: 0.3}]}\nfriction_angle_deg: 36\ntilt: {towards: left, angle_deg: 12}\n")
        for text, more in ((WORLD.split("loads:")[0], "frame: world\n"), (arched, "tilt: {towards: left, angle_deg: 12}\n")):
            found = json.loads(run("solve", "--json", self.write(text))[1])["cases"][0]
            self.draw(self.write(text), name="again.dxf")
            again = self.write(f"topple: 1\ndrawing: {{file: again.dxf}}\nfriction_angle_deg: 36\n{more}", "again.yaml")
            status, out, err = run("solve", "--json", again)
            self.assertEqual(status, 0, err)
            case = json.loads(out)["cases"][0]
            for key in ("toppling", "sliding"):
                self.assertAlmostEqual(case[key]["fos"]["value"], found[key]["fos"]["value"], delta=1e-7)

    def test_other_reader(self):
        """ezdxf, where it is installed, finds nothing to mend and the same outline."""
        try:
            import ezdxf
        except ImportError:
            self.skipTest("ezdxf is not installed")
        own = self.draw(self.write(WORLD))
        document = ezdxf.readfile(self.folder / "drawn.dxf")
        self.assertFalse(document.audit().errors)
        block = [line for line in document.modelspace().query("POLYLINE") if line.dxf.layer == "BLOCK"][0]
        self.assertEqual([(vertex.dxf.location.x, vertex.dxf.location.y) for vertex in block.vertices],
                         [(float(x), float(y)) for x, y in own.points("BLOCK")])

    def test_refused(self):
        """A file that the scene is read from is not written over, and a drawing of nothing leaves none."""
        scene = self.write(WORLD.replace("36", "x"))
        self.assertEqual(run("solve", "--figure", self.folder / "none.dxf", scene)[0], 3)
        self.assertFalse((self.folder / "none.dxf").exists())


if __name__ == "__main__":
    main()
