# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Numbers that are likely in another unit or of another sign, and loads beside a face by their last digit.

The story: a friction angle of 0.61 and a tilt of 0.35 were radians, a k_h of 9.81 was m/s2, a cohesion of 20000 was Pa, and an
anchor that was meant to hold pulled the block out; all were solved without a word. A pressure on a face that a drawing has at
1.0000005 was refused, as if it acted on nothing."""

import json
import pathlib
import tempfile
import unittest

from harness import main, run

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
