#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Calculation sheets and figures of solids: on a plane, on contacts, and of a wedge.

The story: an engineer surveys a boulder, signs its sheet, and a reviewer repeats it with a pocket calculator. So every number in a
table is the one of the JSON, every formula holds with the digits that stand in it, the mesh is named by its hash, and what the
figure shows lies where the numbers say."""

import hashlib
import json
import math
import os
import pathlib
import re
import struct
import unittest

from harness import ROOT, main, run
from report_case import Page, number, words
from test_solid_contacts import cross, dot
from test_solid_scenes import SceneCase
from test_solid_wedge import Polyhedron, normal
from test_solids import exact_obj
from mesh_case import box

FOLDER = ROOT / "examples" / "solids"
NAMES = {"balanced_rock": "Factors of safety, for each band", "rock_on_contacts": "Factor of safety", "wedge": "Factor of safety"}
VERMILION, BLUE = "rgb(83.5%,36.9%,0%)", "rgb(0%,44.7%,69.8%)"


class Sheets(SceneCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.pages = {}

    def sheet(self, scene, *more, ending="html"):
        path = pathlib.Path(self.folder) / f"sheet.{ending}"
        status, out, err = run("solve", scene, "--report", path, *more)
        self.assertIn(status, (0, 1), err)
        return path

    def page(self, name):
        if name not in self.pages:
            self.pages[name] = Page(self.sheet(FOLDER / f"{name}.yaml").read_text(encoding="utf-8"))
        return self.pages[name]

    def of(self, name):
        return self.page(name), self.told(FOLDER / f"{name}.yaml")

    def same(self, printed, bounded, scale=1.0):
        value, half = number(printed)
        true, room = bounded["value"] / scale, bounded["error"] / scale
        self.assertLessEqual(value - true, half + room, printed)
        self.assertLessEqual(true - value, 2 * half + room, printed)  # a factor of safety is rounded down

    def test_every_number(self):
        """Of each table, and of page 1."""
        plane = self.of("balanced_rock")
        for row, band in zip(plane[0].tables(NAMES["balanced_rock"])[0][1:], plane[1]["bands"], strict=True):
            self.assertEqual((float(row[0]), row[4], row[5]), (band["band"], "toppling", band["stance"]["verdict"]))
            for cell, own in zip(row[1:4], (band["least"]["tilt_deg"], band["least"]["azimuth_deg"], band["stance"]["fos"])):
                self.same(cell, own)
        rose = plane[0].tables("Towards each azimuth, in the governing band: tilts from level, and the least horizontal acceleration at "
                               "its tilt")[0][1:]
        self.assertEqual(len(rose), 24)
        by_azimuth = {own["azimuth_deg"]: own for own in plane[1]["bands"][0]["rose"]}
        for row in rose:
            own = by_azimuth[float(row[0])]
            for cell, key in zip((row[1], row[2], row[4]), ("toppling_deg", "critical_deg", "acceleration_g")):
                self.same(cell, own[key])
        held, got = self.of("rock_on_contacts")
        safety, got = got["safety"], got["contacts"]
        row = held.tables(NAMES["rock_on_contacts"])[0][1]
        self.assertEqual(row[3:], ["sliding and toppling", got["verdict"]])
        for cell, key in zip(row, ("critical_deg", "critical_azimuth_deg")):
            self.same(cell, got[key])
        # Whether a motion can begin is open here, so the factor is a bound alone, rounded up.
        self.assertEqual(safety["fos_is"], "undecided")
        bound = re.fullmatch(r"undecided, at most ([\d.]+)", row[2])
        self.assertTrue(0 <= float(bound[1]) - safety["most"] < 1e-4, row[2])
        for row, own in zip(held.tables("Contacts, with one of the systems of forces that hold it, across and along each, in shares of "
                                           "its weight")[0][1:], got["contacts"], strict=True):
            self.assertAlmostEqual(float(row[8]), dot(own["force"], own["normal"]), delta=5.1e-5)
            self.assertAlmostEqual(math.hypot(float(row[8]), float(row[9])), math.sqrt(dot(own["force"], own["force"])), delta=1e-4)
        wedge = self.of("wedge")
        facts = wedge[0].facts("Areas and forces of the wedge")
        own = wedge[1]["wedge"]
        for key, bounded, scale in (("A_A (m²)", own["areas_m2"][0], 1), ("A_B (m²)", own["areas_m2"][1], 1), ("S (kN)", own["driving_n"], 1e3),
                                    ("N_A (kN)", own["normal_n"][0], 1e3), ("N_B (kN)", own["normal_n"][1], 1e3)):
            self.same(facts[key], bounded, scale)
        moments = {row[0]: row[1] for row in wedge[0].tables("Volume, centroid and second moments about it, in the axes of the mesh")[0]}
        self.same(moments["V (m³)"], wedge[1]["volume_m3"])

    def test_every_formula(self):
        """Each side that holds numbers alone is the same number, within what its digits leave open."""
        count = 0
        for name in ("balanced_rock", "wedge"):
            for line in self.page(name).lines():
                values = [value for _, value in line if value is not None]
                for value in values[1:]:
                    self.assertTrue(values[0].meets(value), line)
                    count += 1
        self.assertGreaterEqual(count, 4)

    def test_record(self):
        """The scene and its mesh by their hashes, the mesh by that alone; the same bytes again; letterhead; neither is overwritten."""
        mesh = pathlib.Path(self.put("rock.obj", exact_obj(*box((0, 0, 0), (2, 1, 4)))))
        scene = self.scene("azimuths: 8, up: [1, 1, 3]", "friction_angle_deg: 30\nrequired_fos: 1.5\ntilt: {angle_deg: 1}\n"
                                          "report: {company: Example Geotechnics, author: A. Author}\n")
        os.environ["SOURCE_DATE_EPOCH"] = "1700000000"
        self.addCleanup(os.environ.pop, "SOURCE_DATE_EPOCH")
        for ending in ("html", "pdf"):
            self.assertEqual(self.sheet(scene, ending=ending).read_bytes(), self.sheet(scene, ending=ending).read_bytes())
        text = self.sheet(scene).read_text(encoding="utf-8")
        for told in (hashlib.sha256(mesh.read_bytes()).hexdigest(), "Example Geotechnics", "It does not stand: a point or a line touches.",
                     "not met", "azimuths: 8"):
            self.assertIn(told, text)
        self.assertNotIn(mesh.read_text(encoding="utf-8").splitlines()[3], text)
        for path, told in ((scene, ".html, .md or .pdf"), (f"{self.folder}/x.txt", ".html, .md or .pdf"), ("/nowhere/x.md", "nowhere")):
            status, _, err = run("solve", scene, "--report", path)
            self.assertNotEqual(status, 0)
            self.assertIn(told, err)

    def test_certainly_moves(self):
        """A box that leans too far: no forces, the motion that begins instead; its figure, too."""
        self.put("rock.obj", exact_obj(*box((-1, -1, 0), (1, 1, 4))))
        corners = "".join(f"{{at: [{x}, {y}, 0], normal: [0, 0, 1]}}, " for x in (-1, 1) for y in (-1, 1))
        scene = self.put("scene.yaml", f"topple: 1\nlength_unit: m\nsolid: {{file: rock.obj, unit: m, azimuths: 8, contacts: [{corners}]}}\n"
                                       "friction_angle_deg: 40\ntilt: {angle_deg: 30, azimuth_deg: 90}\n")
        text = self.sheet(scene, "--figure", f"{self.folder}/moves.svg", ending="md").read_text(encoding="utf-8")
        self.assertIn("It certainly moves, for no forces hold it: it topples about the axis along", text)
        self.assertIn("Verdict: topples.", text)
        self.assertEqual(pathlib.Path(f"{self.folder}/moves.svg").read_text(encoding="utf-8").count("<image"), 2)


class Drawn(SceneCase):
    def dots(self, scene, ink, radius):
        """Where circles of this ink and radius, filled, have their middles."""
        path = pathlib.Path(self.folder) / "figure.svg"
        status, _, err = run("solve", "--figure", path, scene)
        self.assertEqual(status, 0, err)
        found = re.findall(r"fill:" + re.escape(ink) + r';[^>]*d="M ([\d.]+) ([\d.]+) C ', path.read_text(encoding="utf-8"))
        return [(float(x) - radius, float(y)) for x, y in found]

    def test_resultant_of_a_wedge(self):
        """On the net R lies where the weight and the water of the polyhedron of all half-spaces point, and I where both joints meet."""
        own = self.told(FOLDER / "wedge.yaml")["wedge"]
        sides = [(normal(side["dip_deg"], side["dip_direction_deg"]), 0) for side in own["sides"]]
        top = own["corners"][4]
        (a, _), (b, _), (face, _), (upper, _) = sides
        planes = [([-v for v in a], 0), ([-v for v in b], 0), (face, 0), (upper, dot(upper, [top["east_m"], top["north_m"], top["up_m"]]))]
        shape = Polyhedron(planes)
        water = own["water_kpa"]["value"]
        pull = [water * shape.areas[0] * a[k] + water * shape.areas[1] * b[k] - (25.13398 * shape.volume if k == 2 else 0) for k in range(3)]
        plunge, trend = math.radians(own["plunge_deg"]["value"]), math.radians(own["trend_deg"]["value"])
        line = [math.cos(plunge) * math.sin(trend), math.cos(plunge) * math.cos(trend), -math.sin(plunge)]
        net = lambda d: [v / (math.sqrt(dot(d, d)) - d[2]) for v in d[:2]]
        radius = 130
        (rx, ry), (ix, iy) = (self.dots(FOLDER / "wedge.yaml", ink, 2.8)[-1] for ink in (VERMILION, BLUE))
        self.assertAlmostEqual((rx - ix) / radius, net(pull)[0] - net(line)[0], delta=0.002)
        self.assertAlmostEqual((iy - ry) / radius, net(pull)[1] - net(line)[1], delta=0.002)

    def test_contacts(self):
        """From above the contacts that are seen lie as their coordinates say."""
        self.put("rock.obj", exact_obj(*box((0, 0, 0), (4, 2, 2))))
        spots = [(1, 2), (3, 2), (4, 1)]  # on walls, seen from above: their normals point down a little
        listed = ", ".join(f"{{at: [{x}, {y}, 1], normal: {n}}}" for (x, y), n in zip(spots, ("[0, -1, -0.1]", "[0, -1, -0.1]", "[-1, 0, -0.1]")))
        scene = self.put("scene.yaml", f"topple: 1\nlength_unit: m\nsolid: {{file: rock.obj, unit: m, azimuths: 8, contacts: [{listed}]}}\n"
                                       "friction_angle_deg: 30\n")
        one, other, third = self.dots(scene, VERMILION, 2.6)[-3:]
        scale = (other[0] - one[0]) / 2
        self.assertGreater(scale, 10)
        self.assertAlmostEqual(one[1], other[1], delta=0.02)
        self.assertAlmostEqual((third[0] - one[0]) / scale, 3, delta=0.01)
        self.assertAlmostEqual((third[1] - one[1]) / scale, 1, delta=0.01)

class Model(SceneCase):
    """A .glb, read back by the words of the specification of glTF 2.0: head, chunks, accessors."""

    def read(self, path):
        data = pathlib.Path(path).read_bytes()
        magic, version, length, size, kind = struct.unpack_from("<4sIII4s", data)
        self.assertEqual((magic, version, length, kind, size % 4), (b"glTF", 2, len(data), b"JSON", 0))
        head = json.loads(data[20:20 + size])
        size_of, name = struct.unpack_from("<I4s", data, 20 + size)
        buffer = data[28 + size:]
        self.assertEqual((name, size_of, head["buffers"][0]["byteLength"]), (b"BIN\0", len(buffer), len(buffer)))
        shapes = {}
        for node in head["nodes"][1:]:
            own = head["meshes"][node["mesh"]]["primitives"][0]
            points = self.values(head, buffer, own["attributes"]["POSITION"], "f", 3)
            accessor = head["accessors"][own["attributes"]["POSITION"]]
            for least, most, own_values in zip(accessor["min"], accessor["max"], zip(*points)):
                self.assertAlmostEqual(least, min(own_values), delta=1e-8 * abs(least))
                self.assertAlmostEqual(most, max(own_values), delta=1e-8 * abs(most))
            corners = [i for i, in self.values(head, buffer, own["indices"], "I", 1)] if "indices" in own else None
            shapes[node["name"]] = points, corners, head["materials"][own["material"]]["name"], own["mode"]
        self.assertEqual(head["nodes"][0]["children"], list(range(1, len(head["nodes"]))))
        return shapes, head["nodes"][0]["rotation"]

    @staticmethod
    def values(head, buffer, accessor, kind, width):
        own = head["accessors"][accessor]
        view = head["bufferViews"][own["bufferView"]]
        return list(struct.iter_unpack("<" + width * kind, buffer[view["byteOffset"]:view["byteOffset"] + view["byteLength"]]))

    def draw(self, scene):
        status, _, err = run("solve", "--figure", f"{self.folder}/rock.glb", scene)
        self.assertEqual(status, 0, err)
        return self.read(f"{self.folder}/rock.glb")

    def test_pose(self):
        """A box beside the origin: its corners from the foot of its centroid, outwards, with y up; the base leans as the scene says."""
        self.put("rock.obj", exact_obj(*box((5, 7, 1), (7, 8, 5))))
        shapes, (x, y, z, w) = self.draw(self.scene("azimuths: 8", "friction_angle_deg: 30\ntilt: {angle_deg: 10, azimuth_deg: 90}\n"))
        points, corners, _, mode = shapes["rock"]
        self.assertEqual(mode, 4)
        self.assertEqual(sorted(set(points)), sorted((e, u, -n) for e in (-1, 1) for u in (0, 4) for n in (-0.5, 0.5)))
        faces = [[points[i] for i in corners[k:k + 3]] for k in range(0, len(corners), 3)]
        self.assertAlmostEqual(sum(dot(a, cross(b, c)) for a, b, c in faces) / 6, 8)
        sides = shapes["support, band 0 m"][0]
        self.assertEqual(sides[1::2], sides[2::2] + sides[:1])  # each ends where the next one begins
        self.assertEqual(sorted(sides[::2]), sorted((e, 0, -n) for e in (-1, 1) for n in (-0.5, 0.5)))
        edge, _, ink, mode = shapes["edge that governs"]
        self.assertEqual((sorted(edge), ink, mode), ([(1, 0, -0.5), (1, 0, 0.5)], "red", 1))
        up = (2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x))  # what the turn makes of upwards
        self.assertAlmostEqual(up[0], math.sin(math.radians(10)))
        self.assertAlmostEqual(up[1], math.cos(math.radians(10)))
        tip = shapes["weight"][0][1]
        self.assertAlmostEqual(tip[0], 2 * math.tan(math.radians(10)), 6)

    def test_held_and_refused(self):
        """Forces end where their contacts are; a wedge and a block in a section have no model."""
        shapes, _ = self.draw(FOLDER / "rock_on_contacts.yaml")
        told = self.told(FOLDER / "rock_on_contacts.yaml")
        for k, contact in enumerate(told["contacts"]["contacts"], 1):
            at = [c - g["value"] for c, g in zip(contact["at"], told["centroid_m"])]
            end = shapes[f"force {k}"][0][1]
            self.assertAlmostEqual(end[0], at[0], 6)
            self.assertAlmostEqual(-end[2], at[1], 6)
            self.assertEqual(end, shapes[f"normal {k}"][0][0])
        self.assertEqual(shapes["axis"][2], "purple")
        for scene, told in ((FOLDER / "wedge.yaml", "a wedge has no mesh"), ("examples/slab.yaml", ".svg, .pdf, .png or .dxf")):
            status, _, err = run("solve", "--figure", f"{self.folder}/x.glb", scene)
            self.assertEqual(status, 3)
            self.assertIn(told, err)


if __name__ == "__main__":
    main()
