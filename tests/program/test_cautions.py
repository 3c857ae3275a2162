# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Numbers that are likely in another unit or of another sign, and loads beside a face by their last digit.

The story: a friction angle of 0.61 and a tilt of 0.35 were radians, a k_h of 9.81 was m/s2, a cohesion of 20000 was Pa, and an
anchor that was meant to hold pulled the block out; all were solved without a word. A pressure on a face that a drawing has at
1.0000005 was refused, as if it acted on nothing."""

import csv
import json
import pathlib
import re
import tempfile
import unittest

from harness import ROOT, main, run

SCENE = ("topple: 1\nlength_unit: m\nblock: {{outline: [[0, 0], [1, 0], [1, 2], [0, 2]], unit_weight_kn_m3: 26}}\n"
         "base: {{mated: true}}\n{}\n")


class Case(unittest.TestCase):
    def solve(self, text):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "s.yaml").write_text(text)
            return run("solve", "--json", "s.yaml", folder=folder)

    def solution(self, text):
        status, out, err = self.solve(text)
        self.assertEqual((status, err), (0, ""), text)
        return json.loads(out)


class Cautions(Case):
    def said(self, more):
        return [(note["kind"], note["text"]) for note in self.solution(SCENE.format(more))["notes"]]

    def cautioned(self, more, *words):
        notes = [text for kind, text in self.said(more) if kind == "caution"]
        self.assertEqual(len(notes), len(words), (more, notes))
        for text, word in zip(notes, words):
            self.assertIn(word, text)

    def test_angles(self):
        """35 degrees are 0.6109 rad, 20 are 0.3491; zero friction is meant, and so are 2 degrees and a tilt of 1."""
        self.cautioned("friction_angle_deg: 0.6109", "if it is in radians, write 35")
        self.cautioned("tilt: {towards: left, angle_deg: 0.3491}", "if it is in radians, write 20")
        self.cautioned("friction_angle_deg: 35\nfriction: {facets: [{facet: 1, angle_deg: 0.5}]}", "write 28.65")
        for more in ("friction_angle_deg: 0", "friction_angle_deg: 2", "tilt: {towards: left, angle_deg: 1}",
                     "tilt: {towards: left, angle_deg: 0}"):
            self.cautioned(more)

    def test_every_angle(self):
        """A quotient of 30/120 as the dip of a slope, 0.25 degrees, was solved without a word, and so were radians at every key but
        two. Each angle of a scene has the caution: 60 degrees are 1.0472 rad, 80 are 1.3963, 105 are 1.8326. The same scene in
        degrees has none of these."""
        block = "topple: 1\nlength_unit: m\nblock: {slab: {width: 2, height: 1}, unit_weight_kn_m3: 26}\n"
        slope = block + "friction_angle_deg: 35\nslope: {dip_deg: 20, towards: left%s}\n%s"
        patton = block + "friction: {law: patton, basic_angle_deg: %s, roughness_angle_deg: %s}\ntilt: {towards: left, angle_deg: 10}\n"
        barton = block + "friction: {law: barton, residual_angle_deg: %s, jcs_mpa: 100, tilt_test: {angle_deg: %s, normal_stress_kpa: 5}}\ntilt: {towards: left, angle_deg: 10}\n"
        many = "topple: 1\nlength_unit: m\nfriction_angle_deg: 38\nblock: {unit_weight_kn_m3: 25}\n"
        columns = many + "slope: {dip_deg: %s, towards: left}\ncolumns: {width: 10, equal_area: {face_dip_deg: %s, height: 60, upper_dip_deg: %s, base_dip_deg: %s}}\n"
        jointed = (many + "jointed_slope:\n  face: {dip_deg: %s, height: 4}\n  behind: 3\n  upper: {dip_deg: %s}\n  base: {dip_deg: %s, steps: k, tread_dip_deg: %s}\n"
                   "  joints:\n    - {name: k, dip_deg: 70, towards: right, spacing: 4}\n    - {name: c, dip_deg: %s, towards: left, spacing: 6}\n")
        wedge = ("topple: 1\nlength_unit: m\nsolid:\n  unit_weight_kn_m3: 26\n  wedge:\n    height: %s\n"
                 "    a: {dip_deg: %s, dip_direction_deg: %s, friction_angle_deg: %s, cohesion_kpa: 20}\n"
                 "    b: {dip_deg: %s, dip_direction_deg: 235, friction_angle_deg: %s, cohesion_kpa: %s}\n"
                 "    face: {dip_deg: %s, dip_direction_deg: %s}\n    upper: {dip_deg: %s, dip_direction_deg: %s}\n")
        cases = (
            (slope.replace("20", "%s", 1), ("30/120", "", ""), ("20", "", ""), ["a dip of 0.25°"]),
            (slope.replace("20", "%s", 1), ("1.3963", "", ""), ("80", "", ""), ["a dip of 1.3963° is implausible; if it is in radians, write 80"]),
            (slope, (", dip_direction_deg: 1.8326", ""), (", dip_direction_deg: 105", ""), ["an azimuth of 1.8326° is implausible; if it is in radians, write 105"]),
            (slope, (", strike_deg: 1.8326", ""), (", strike_deg: 1.8", ""), ["an azimuth of 1.8326°"]),
            (slope, ("", "loads: {anchors: [{at: [1, 1], dip_deg: 0.26, force_kn: 1}]}"), ("", "loads: {anchors: [{at: [1, 1], dip_deg: 15, force_kn: 1}]}"),
             ["a dip of 0.26°"]),
            (slope, ("", "loads: {anchors: [{at: [1, 1], direction_deg: -1.0472, force_kn: 1}]}"),
             ("", "loads: {anchors: [{at: [1, 1], direction_deg: -60, force_kn: 1}]}"), ["a direction of -1.0472°"]),
            (slope, ("", "tilt_test: {until_deg: 1.0472}"), ("", "tilt_test: {until_deg: 60}"), ["a tilt of 1.0472°"]),
            (patton, ("0.5236", "5"), ("30", "5"), ["a friction angle of 0.5236°"]),
            (patton, ("30", "0.0873"), ("30", "5"), ["a roughness angle of 0.0873°"]),
            (barton, ("0.5236", "60"), ("30", "60"), ["a friction angle of 0.5236°"]),
            (columns, ("30", "56.6", "0.0698", "35.8"), ("30", "56.6", "4", "35.8"), ["a dip of 0.0698°"]),
            (columns, ("0.52", "1.3", "0.07", "0.62"), ("30", "56.6", "4", "35.8"), ["a dip of 0.52°", "a dip of 1.3°", "a dip of 0.07°", "a dip of 0.62°"]),
            (jointed, ("60", "0.07", "30", "10", "20"), ("60", "4", "30", "10", "20"), ["a dip of 0.07°"]),
            (jointed, ("60", "4", "0.52", "10", "20"), ("60", "4", "30", "10", "20"), ["a dip of 0.52°"]),
            (jointed, ("60", "4", "30", "0.17", "20"), ("60", "4", "30", "10", "20"), ["a dip of 0.17°"]),
            (jointed, ("60", "4", "30", "10", "0.35"), ("60", "4", "30", "10", "20"), ["a dip of 0.35°"]),
            (wedge, ("30", "45", "105", "0.349", "70", "0.5236", "20", "65", "185", "12", "195"), ("30", "45", "105", "20", "70", "30", "20", "65", "185", "12", "195"),
             ["a friction angle of 0.349°", "a friction angle of 0.5236°"]),
            (wedge, ("30", "45", "105", "20", "70", "30", "20", "65", "185", "0.21", "3.4034"), ("30", "45", "105", "20", "70", "30", "20", "65", "185", "12", "195"),
             ["a dip of 0.21°", "an azimuth of 3.4034°"]),
            (wedge, ("30000", "45", "105", "20", "70", "30", "20000", "65", "185", "12", "195"), ("30", "45", "105", "20", "70", "30", "20", "65", "185", "12", "195"),
             ["the wedge's height is 30 km", "cohesion of 20000 kPa"]),
        )

        def cautions(text):
            status, out, err = self.solve(text)
            self.assertIn(status, (0, 1, 4), err + text)
            return [note["text"] for note in json.loads(out)["notes"] if note["kind"] == "caution"]

        for text, wrong, right, words in cases:
            said, others = cautions(text % wrong), cautions(text % right)
            for word in words:
                self.assertEqual(len([note for note in said if word in note]), 1, (text % wrong, word, said))
            self.assertEqual([note for note in others if "implausible" in note or "sound rock" in note], [], text % right)

    # Angles of which a small one is as likely as any: a scatter and a tolerance.
    SMALL = {"jointed_slope.joints[].scatter.dip_deg", "tilt_test.tolerance_deg"}
    FRICTION = "friction_angle_deg: 35\n"
    ONE = "topple: 1\nlength_unit: m\nblock: {slab: {width: 2, height: 1}, unit_weight_kn_m3: 26}\n"
    MANY = ("topple: 1\nlength_unit: m\nblock: {unit_weight_kn_m3: 26}\nfriction_angle_deg: 38\nblocks:\n"
            "  - {name: g, ground: true, outline: [[-9, -1], [9, -1], [9, 0], [-9, 0]]}\n  - {name: a, slab: {width: 2, height: 1}}\n"
            "tilt: {towards: left, angle_deg: 5}\n")
    COLUMNS = ("topple: 1\nlength_unit: m\nblock: {unit_weight_kn_m3: 26}\nfriction_angle_deg: 38\nslope: {dip_deg: 30, towards: left}\n"
               "columns: {width: 10, ")
    EQUAL = COLUMNS + "equal_area: {face_dip_deg: %s, height: 60, upper_dip_deg: %s, base_dip_deg: %s}}\n"
    JOINTED = ("topple: 1\nlength_unit: m\nblock: {unit_weight_kn_m3: 26}\nfriction_angle_deg: 38\ntilt: {towards: left}\njointed_slope:\n"
               "  face: {dip_deg: %s, height: 4}\n  behind: 3\n  upper: {dip_deg: %s}\n  base: {dip_deg: %s, steps: k, tread_dip_deg: %s%s}\n"
               "  joints:\n    - {name: k, dip_deg: %s, towards: right, spacing: 4%s}\n    - {name: c, dip_deg: 20, towards: left, spacing: 6}\n")
    SOLID = "topple: 1\nlength_unit: m\nsolid: {file: box.obj, unit: m, unit_weight_kn_m3: 26, azimuths: 4, %s}\n"
    PLANE = SOLID % "bands: [0.001]" + FRICTION
    WEDGE = ("topple: 1\nlength_unit: m\nsolid:\n  unit_weight_kn_m3: 26\n  wedge:\n    height: 30\n"
             "    a: {dip_deg: %s, dip_direction_deg: %s, friction_angle_deg: %s, cohesion_kpa: 20}\n"
             "    b: {dip_deg: %s, dip_direction_deg: %s, friction_angle_deg: %s, cohesion_kpa: 20}\n"
             "    face: {dip_deg: %s, dip_direction_deg: %s}\n    upper: {dip_deg: %s, dip_direction_deg: %s}\n%s")
    PLANES = [45, 105, 20, 70, 235, 30, 65, 185, 12, 195, ""]
    CRACK = "    crack: {dip_deg: %s, dip_direction_deg: %s, distance: 4}\n"
    SLOPE = ONE + FRICTION + "slope: {dip_deg: 20, towards: left%s}\n"
    DRAWN = ("topple: 1\nlength_unit: m\nblock: {outline: [[0, 0], [2, 1], [1, 3], [-1, 2]], unit_weight_kn_m3: 25}\n"
             "base: {mated: true, between: [[0, 0], [2, 1]]}\nfriction_angle_deg: 35\nframe: {%s}\n")
    MESH = ("topple: 1\nlength_unit: m\nsection: {at: [1, 0.5], azimuth_deg: %s}\nblock: {outline: {mesh: box.obj, unit: m}, unit_weight_kn_m3: 26}\n"
            "base: {mated: true}\nfriction_angle_deg: 35\ntilt: {towards: left, angle_deg: 5}\n")
    LAW = "tilt: {towards: left, angle_deg: 10}\nfriction: {law: %s}\n"

    @classmethod
    def jointed(cls, k, value):
        given = [60, 4, 30, 10, "", 70, ""]
        given[k] = value
        return cls.JOINTED % tuple(given)

    @classmethod
    def wedge(cls, k, value):
        given = list(cls.PLANES)
        given[k] = value
        return cls.WEDGE % tuple(given)

    def scenes_by_key(self):
        """By the key of each angle, a scene with a value at it."""
        degrees = lambda text: lambda value: text % value
        planes = [(f"solid.wedge.{side}.{key}", k) for k, (side, key) in enumerate(
            (side, key) for side, keys in (("a", 3), ("b", 3), ("face", 2), ("upper", 2))
            for key in ("dip_deg", "dip_direction_deg", "friction_angle_deg")[:keys])]
        told = {key: (lambda value, k=k: self.wedge(k, value)) for key, k in planes}
        told |= {f"solid.wedge.crack.{key}": (lambda value, k=k: self.wedge(10, self.CRACK % ((value, 165) if k == 0 else (70, value))))
                 for k, key in enumerate(("dip_deg", "dip_direction_deg"))}
        told |= {f"jointed_slope.{key}": (lambda value, k=k, more=more: self.jointed(k, f"{more}{value}")) for k, key, more in (
            (0, "face.dip_deg", ""), (1, "upper.dip_deg", ""), (2, "base.dip_deg", ""), (3, "base.tread_dip_deg", ""),
            (4, "base.friction_angle_deg", ", friction_angle_deg: "), (5, "joints[].dip_deg", ""),
            (6, "joints[].friction_angle_deg", ", friction_angle_deg: "))}
        told |= {f"columns.equal_area.{key}": (lambda value, k=k: self.EQUAL % tuple(value if j == k else own for j, own in enumerate((56.6, 4, 35.8))))
                 for k, key in enumerate(("face_dip_deg", "upper_dip_deg", "base_dip_deg"))}
        told |= {
            "columns.side_friction_angle_deg": degrees(self.COLUMNS + "heights: [12, 13, 14], side_friction_angle_deg: %s}\n"),
            "support.direction_deg": degrees(self.MANY + "support: {block: a, at: [0, 0.5], fos: 1, direction_deg: %s}\n"),
            "joints[].friction_angle_deg": degrees(self.MANY + "joints: [{between: [g, a], friction_angle_deg: %s}]\n"),
            "loads.forces[].direction_deg": degrees(self.MANY + "loads: {forces: [{block: a, at: [0, 0.5], direction_deg: %s, force_kn: 1}]}\n"),
            "loads.forces[].dip_deg": degrees(self.MANY + "loads: {forces: [{block: a, at: [2, 0.5], dip_deg: %s, towards: left, force_kn: 1}]}\n"),
            "section.azimuth_deg": degrees(self.MESH),
            "solid.contacts[].friction_angle_deg": degrees(self.SOLID % "contacts: [{at: [0, 0, 0], normal: [0, 0, 1], friction_angle_deg: %s}, "
                                                           "{at: [2, 0, 0], normal: [0, 0, 1]}, {at: [1, 1, 0], normal: [0, 0, 1]}]" + self.FRICTION),
            "solid.base.dip_deg": degrees(self.SOLID % "bands: [0.001], base: {dip_deg: %s, dip_direction_deg: 135}" + self.FRICTION),
            "solid.base.dip_direction_deg": degrees(self.SOLID % "bands: [0.001], base: {dip_deg: 5, dip_direction_deg: %s}" + self.FRICTION),
            "tilt.azimuth_deg": degrees(self.PLANE + "tilt: {angle_deg: 5, azimuth_deg: %s}\n"),
            "loads.seismic.azimuth_deg": degrees(self.PLANE + "tilt: {angle_deg: 5, azimuth_deg: 90}\nloads: {seismic: {horizontal: 0.1, azimuth_deg: %s}}\n"),
            "loads.anchors[].azimuth_deg": lambda value: self.wedge(10, f"loads: {{anchors: [{{force_kn: 10, azimuth_deg: {value}, dip_deg: 10}}]}}\n"),
            "friction_angle_deg": degrees(self.ONE + "friction_angle_deg: %s\ntilt: {towards: left, angle_deg: 5}\n"),
            "cases[].friction_angle_deg": degrees(self.ONE + self.FRICTION + "tilt: {towards: left, angle_deg: 5}\n"
                                                  "cases: [{name: a, friction_angle_deg: %s}, {name: b}]\n"),
            "friction.basic_angle_deg": degrees(self.ONE + self.LAW % "patton, basic_angle_deg: %s, roughness_angle_deg: 5"),
            "friction.roughness_angle_deg": degrees(self.ONE + self.LAW % "patton, basic_angle_deg: 30, roughness_angle_deg: %s"),
            "friction.residual_angle_deg": degrees(self.ONE + self.LAW % "barton, residual_angle_deg: %s, jcs_mpa: 100, jrc: 5"),
            "friction.tilt_test.angle_deg": degrees(
                self.ONE + self.LAW % "barton, residual_angle_deg: 30, jcs_mpa: 100, tilt_test: {angle_deg: %s, normal_stress_kpa: 5}"),
            "friction.facets[].angle_deg": degrees(self.ONE + self.FRICTION + "tilt: {towards: left, angle_deg: 5}\nfriction: {facets: [{facet: 1, angle_deg: %s}]}\n"),
            "tilt.angle_deg": degrees(self.ONE + self.FRICTION + "tilt: {towards: left, angle_deg: %s}\n"),
            "tilt_test.until_deg": degrees(self.SLOPE % "" + "tilt_test: {until_deg: %s}\n"),
            "slope.dip_deg": degrees(self.ONE + self.FRICTION + "slope: {dip_deg: %s, towards: left}\n"),
            "slope.dip_direction_deg": degrees(self.SLOPE % ", dip_direction_deg: %s"), "slope.strike_deg": degrees(self.SLOPE % ", strike_deg: %s"),
            "frame.dip_direction_deg": degrees(self.DRAWN % "dip_direction_deg: %s"), "frame.strike_deg": degrees(self.DRAWN % "strike_deg: %s"),
            "loads.anchors[].direction_deg": degrees(self.SLOPE % "" + "loads: {anchors: [{at: [1, 1], direction_deg: %s, force_kn: 1}]}\n"),
            "loads.anchors[].dip_deg": degrees(self.SLOPE % "" + "loads: {anchors: [{at: [1, 1], dip_deg: %s, force_kn: 1}]}\n"),
        }
        return told

    def test_each_key(self):
        """Each angle that the table of keys has, in radians: a caution where a scene with it is solved, or the scene is refused, as four
        planes in radians make no wedge. A new key needs its scene here."""
        with (ROOT / "src" / "core" / "terms" / "keys.csv").open(encoding="utf-8") as file:
            keys = {row[1] for row in csv.reader(file) if row and row[0] == "scene" and row[2] in ("degrees", "deg")}
        told = self.scenes_by_key()
        self.assertEqual({*told} | self.SMALL, keys)
        refused = set()
        for key, text in told.items():
            with tempfile.TemporaryDirectory() as folder, self.subTest(key=key):
                (pathlib.Path(folder) / "box.obj").write_bytes((ROOT / "tests" / "data" / "swept" / "box.obj").read_bytes())
                value = "1.8326" if re.search("direction|azimuth|strike", key) else "0.5236"
                (pathlib.Path(folder) / "s.yaml").write_text(text(value), encoding="utf-8")
                status, out, err = run("solve", "--json", "s.yaml", folder=folder)
                if status == 3:
                    self.assertIn("s.yaml:", err)
                    refused.add(key)
                    continue
                self.assertIn(status, (0, 1, 4), err)
                notes = [note["text"] for note in json.loads(out)["notes"] if "implausible; if it is in radians" in note["text"]]
                self.assertEqual(len(notes), 1, text(value))
                self.assertIn(f" {value}°", notes[0])
        self.assertLessEqual(refused, {key for key in told if key.startswith(("solid.wedge", "columns.equal", "jointed_slope.face"))
                                       or key in ("jointed_slope.joints[].dip_deg", "friction.tilt_test.angle_deg")})

    def test_fields_of_a_table(self):
        """A dip, a friction and lengths of rows: radians, and millimetres for metres; 20 degrees are 0.3491 rad."""
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "t.yaml").write_text(self.ONE + "friction_angle_deg: 35\nslope: {dip_deg: 20, towards: left}\n", encoding="utf-8")
            (pathlib.Path(folder) / "t.csv").write_text("name,width,height,dip,friction\nA,1,2,0.3491,35\nB,1,2,20,0.6109\nC,1000,2000,20,35\n"
                                                        "D,1,2,20,35\n", encoding="utf-8")
            status, out, err = run("solve", "--json", "--batch", "t.csv", "--template", "t.yaml", folder=folder)
        remarks = {row["name"]: row.get("remark") or "" for row in json.loads(out)["rows"]}
        for name, word in (("A", "a dip of 0.3491° is implausible; if it is in radians, write 20"),
                           ("B", "a friction angle of 0.6109° is implausible; if it is in radians, write 35"),
                           ("C", "measures 2 km, which is implausible")):
            self.assertIn(word, remarks[name], err)
        self.assertEqual(remarks["D"], "")

    def test_earthquakes(self):
        load = "loads: {{seismic: {{horizontal: {}, vertical: {}}}}}"
        self.cautioned(load.format(9.81, 0), "horizontal: 9.81 is an earthquake of more than gravity")
        self.cautioned(load.format(0.1, -15), "vertical: -15 is")
        self.cautioned(load.format(-0.1, 0), "which helps it")
        self.cautioned(load.format(1, -1))

    def test_strength(self):
        self.cautioned("friction_angle_deg: 30\nloads: {cohesion_kpa: 20000}", "if it is in Pa, write 20")
        self.cautioned("friction_angle_deg: 30\nloads: {bond_kpa: 1500}", "a bond of 1500 kPa")
        self.cautioned("friction_angle_deg: 30\nloads: {cohesion_kpa: 1000}")

    def test_many_blocks(self):
        """Scenes of many blocks had none of these but that of a unit weight: radians, m/s2 and Pa were solved without a word. Each is told once
        where it stands, of joints between two blocks, of columns and of the sets that cut a slope too; the size is that of the largest block."""
        def cautioned(text, *words):
            status, out, err = self.solve(text)
            self.assertIn(status, (0, 1), err + text)
            notes = [note["text"] for note in json.loads(out)["notes"] if note["kind"] == "caution"]
            self.assertEqual(len(notes), len(words), (text, notes))
            for note, word in zip(notes, words):
                self.assertIn(word, note)

        listed = ("topple: 1\nlength_unit: {}\nfriction_angle_deg: {}\nblock: {{unit_weight_kn_m3: 25}}\nblocks:\n"
                  "  - {{name: g, ground: true, outline: [[-900, -1], [900, -1], [900, 0], [-900, 0]]}}\n"
                  "  - {{name: a, slab: {{width: 2, height: 1}}}}\n  - {{name: b, slab: {{width: 1, height: 0.005}}, at: [0, 1]}}\n{}\n")
        cautioned(listed.format("m", 30, ""))
        cautioned(listed.format("m", 0.6109, ""), "if it is in radians, write 35")
        cautioned(listed.format("mm", 30, ""), "the largest block measures 2 mm")
        cautioned(listed.format("km", 30, ""), "the largest block measures 2 km")
        cautioned(listed.format("m", 30, "loads: {seismic: {horizontal: 9.81}}"), "horizontal: 9.81 is an earthquake of more than gravity")
        cautioned(listed.format("m", 30, "loads: {cohesion_kpa: 20000, bond_kpa: 1500}"), "if it is in Pa, write 20", "a bond of 1500 kPa")
        cautioned(listed.format("m", 30, "joints: [{between: [g, a], friction_angle_deg: 0.5, cohesion_kpa: 3000, tension_kpa: 2000}]"),
                  "write 28.65", "cohesion of 3000 kPa", "tensile strength of 2000 kPa")
        cautioned(listed.format("m", 30, "tilt: {towards: left, angle_deg: 0.2}"), "a tilt of 0.2")
        rest = "topple: 1\nlength_unit: m\nfriction_angle_deg: 30\nblock: {unit_weight_kn_m3: 25}\n"
        cautioned(rest + "slope: {dip_deg: 20, towards: left}\ncolumns: {width: 2, heights: [2, 3, 4], side_friction_angle_deg: 0.5}\n", "write 28.65")
        cautioned(rest + "jointed_slope:\n  face: {dip_deg: 65, height: 6}\n  base: {dip_deg: 20, friction_angle_deg: 0.4}\n"
                  "  joints: [{dip_deg: 70, towards: right, spacing: 3, friction_angle_deg: 0.5, cohesion_kpa: 5000}]\n",
                  "write 28.65", "cohesion of 5000 kPa", "write 22.92")

    def test_anchors(self):
        """Any direction between along the base and along it the other way pulls off it, however it is written."""
        load = "loads: {{anchors: [{{at: [0.5, 1], direction_deg: {}, force_kn: 1}}]}}"
        for degrees in (1, 90, 179.9, 450, -200, "1e-9"):
            self.cautioned(load.format(degrees), "pulls the block off its base")
        for degrees in (0, 180, -90, -1, 359, 200, -180, 360):
            self.cautioned(load.format(degrees))


class OnFace(Case):
    LOADS = ("pressures: [{{from: [{0}, 0.5], to: [{0}, 1.5], kpa: 5}}]",
             "surcharges: [{{from: [0.2, {1}], to: [0.8, 2], kpa: 5}}]",
             "anchors: [{{at: [{2}, 1], direction_deg: -20, force_kn: 3}}]")

    def pivots(self, solution):
        return [[pivot["critical_angle_deg"]["value"] for pivot in case["pivots"]] for case in solution["cases"]]

    def scene(self, load, *at):
        return SCENE.format("loads: {" + load.format(*at) + "}")

    def test_within_a_millionth(self):
        """The block is 2 m high: up to 2 µm beside its face a load is put on it, and a note says so; the numbers are those of
        the load on the face."""
        for load, what in zip(self.LOADS, ("pressure", "surcharge", "anchor")):
            exact = self.solution(self.scene(load, 1, 2, 0))
            self.assertEqual(exact["notes"], [])
            for at in ((1.0000005, 2.0000001, -0.0000019), (0.9999981, 1.999998, -1e-30)):
                near = self.solution(self.scene(load, *at))
                self.assertEqual(self.pivots(near), self.pivots(exact))
                self.assertEqual([note["kind"] for note in near["notes"]], ["note"], load)
                self.assertIn(f"this {what} acts", near["notes"][0]["text"])

    def test_farther_off(self):
        for load in self.LOADS:
            status, out, err = self.solve(self.scene(load, 1.0000021, 2.0000021, -0.0000021))
            self.assertEqual((status, out), (3, ""), load)
            self.assertIn("s.yaml:5:", err)

    def test_beside_a_corner(self):
        """A pressure that ends beyond the corner ends in it."""
        load = "pressures: [{{from: [1, {0}], to: [1, {1}], kpa: 5}}]"
        exact, near = self.solution(self.scene(load, 0, 2)), self.solution(self.scene(load, -1e-7, 2.0000001))
        self.assertEqual(self.pivots(near), self.pivots(exact))

    def test_a_face_that_leans(self):
        """The nearest point of a face from (1, 0) to (1.1, 2), given by six decimals, is on it exactly."""
        text = SCENE.replace("[1, 2]", "[1.1, 2]").format(
            "loads: {pressures: [{from: [1.033333, 0.666667], to: [1.066667, 1.333333], kpa: 5}]}")
        self.assertEqual([note["kind"] for note in self.solution(text)["notes"]], ["note"])


if __name__ == "__main__":
    main()
