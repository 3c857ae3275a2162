# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A drawing in place of a scene, in every command that takes one (docs/drawing.md).

The story: whoever has a drawing and three numbers writes no file. What a command prints of them is, byte for byte but
for the time that it took, what it prints of a scene that says the same; and a unit that belongs nowhere is refused."""

import json
import pathlib
import tempfile
import unittest

from harness import main, run
from mesh_case import box, obj

DRAWING = "POLYGON ((0 0, 300 0, 300 1200, 0 1250, 0 0))\n"
SCENE = """topple: 1
drawing: {file: section.wkt, unit: mm}
block: {unit_weight_kn_m3: 26}
base: {mated: true}
friction_angle_deg: 30
tilt: {towards: left, angle_deg: 5}
tilt_test: {engine: path}
"""
SET = ("block.unit_weight_kn_m3=2*13", "friction_angle_deg=30", "tilt.towards=left", "tilt.angle_deg=5",
       "tilt_test.engine=path")
COMMANDS = (("solve", "--json"), ("derive", "--json"), ("sweep", "--x", "friction_angle_deg=10:40:10"), ("tilt", "--csv"),
            ("chart", "map", "--x", "friction_angle_deg=10:40"), ("profile", "--json"), ("accuracy", "--json"))
OTHERS = ("seconds", "effects", "set", "notes", "scene")  # what it cost, and which of the two it was


def without(value, names):
    """JSON without some keys, at every depth."""
    if isinstance(value, dict):
        return {key: without(v, names) for key, v in value.items() if key not in names}
    return [without(v, names) for v in value] if isinstance(value, list) else value


class InPlaceOfAScene(unittest.TestCase):
    def setUp(self):
        own = tempfile.TemporaryDirectory()
        self.addCleanup(own.cleanup)
        self.folder = pathlib.Path(own.name)
        (self.folder / "section.wkt").write_text(DRAWING)
        (self.folder / "scene.yaml").write_text(SCENE)

    def run_here(self, *words):
        return run(*words, folder=self.folder)

    def plain(self, out, words):
        """What does not change from run to run, and names no setting (a sweep repeats those in columns of their own)."""
        if "--json" in words:
            return without(json.loads(out), OTHERS)
        if words[0] == "sweep":
            return [line.split(",left,", 1)[1] for line in out.splitlines()[1:]]
        return out

    def test_the_same_of_both(self):
        settings = [word for own in SET for word in ("--set", own)]
        for words in COMMANDS:
            with self.subTest(" ".join(words)):
                _, truth, err = self.run_here(*words, "scene.yaml")
                self.assertEqual(err, "")
                status, out, err = self.run_here(*words, "section.wkt", "--unit", "mm", *settings)
                self.assertEqual((status, err), (0, ""))
                self.assertEqual(self.plain(out, words), self.plain(truth, words))
                self.assertNotEqual(out.strip(), "")

    def test_the_unit_counts(self):
        """In inches all lengths are 25.4 times those in millimetres."""
        areas = []
        for unit in ("mm", "in"):
            _, out, _ = self.run_here("derive", "--unit", unit, "section.wkt")
            areas.append(out)
            _, out, _ = self.run_here("profile", "--json", "--unit", unit, "section.wkt")
            self.assertEqual(json.loads(out)["length_unit"], unit)
            _, out, _ = self.run_here("solve", "--json", "--unit", unit, "section.wkt")
            areas.append(json.loads(out)["cases"][0]["block"]["area_m2"]["value"])
        self.assertEqual(areas[0], areas[2], "derive tells of scene lengths")
        self.assertAlmostEqual(areas[3] / areas[1], 25.4**2, delta=1e-11)

    def test_a_study(self):
        own = ("samples: 50\nvary: {friction_angle_deg: {normal: {mean: 12, deviation: 4}, truncated: [1, 40]}}\n")
        (self.folder / "one.yaml").write_text("topple_study: 1\nscene: scene.yaml\n" + own)
        (self.folder / "two.yaml").write_text("topple_study: 1\nscene: section.wkt\nunit: mm\n"
                                              f"set: [{', '.join(SET)}]\n" + own)
        told = []
        for study in ("one.yaml", "two.yaml"):
            status, out, err = self.run_here("study", "--json", study, "--rows", study + ".csv")
            self.assertEqual((status, err), (0, ""))
            rows = (self.folder / (study + ".csv")).read_text().splitlines()
            told.append([line for line in rows if line[:1].isdigit()])
        self.assertEqual(len(told[0]), 50)
        self.assertEqual({line.split(",")[2] for line in told[0]}, {"stands", "slides"})
        self.assertEqual(told[0], told[1])

    def test_a_mesh(self):
        """Likewise a mesh, with the section that is laid through it."""
        points, faces = box((0, 0, 0), (2, 3, 1))
        (self.folder / "rock.obj").write_text(obj(points, faces, "rock1"))
        (self.folder / "mesh.yaml").write_text("topple: 1\nlength_unit: ft\nsection: {at: [0, 1], azimuth_deg: 90}\nblock: {outline: "
                                               "{mesh: rock.obj, object: rock1, unit: ft}, unit_weight_kn_m3: 26}\nfriction_angle_deg: 30\n")
        own = ("section.at.1=0", "section.at.2=1", "section.azimuth_deg=90", "block.outline.object=rock1",
               "block.unit_weight_kn_m3=26", "friction_angle_deg=30")
        settings = [word for text in own for word in ("--set", text)]
        for words in (("solve", "--json"), ("derive", "--json"), ("sweep", "--x", "friction_angle_deg=10:40:10")):
            _, truth, _ = self.run_here(*words, "mesh.yaml")
            status, out, err = self.run_here(*words, "rock.obj", "--unit", "ft", *settings)
            self.assertEqual((status, err), (0, ""))
            if words[0] == "sweep":
                self.assertEqual([row.split(",done,")[1] for row in out.splitlines()[1:]],
                                 [row.split(",done,")[1] for row in truth.splitlines()[1:]])
            else:
                self.assertEqual(self.plain(out, words), self.plain(truth, words))
        for words, why in (((), "a mesh does not say what the unit of its lengths is"), (("--unit", "m"), "'section' is missing"),
                           (("--unit", "m", "--set", "section.at.2=1"), "entries of a list come in their order"),
                           (("--unit", "m", "--set", "section.at.1=1", "--set", "section.at.x=1"), "sets no number")):
            status, out, err = self.run_here("solve", "rock.obj", *words)
            self.assertEqual((status, out), (3, ""), err)
            self.assertIn(why, err)

    def test_refused(self):
        for words, why in ((("solve", "--unit", "mm", "scene.yaml"), "a scene states it length_unit"),
                           (("profile", "--unit", "mm", "scene.yaml"), "a scene states it length_unit"),
                           (("derive", "section.wkt"), "--unit mm"),
                           (("sweep", "--unit", "yd", "--x", "friction_angle_deg=1,2", "section.wkt"),
                            "unit must be one of mm, cm, m, km, in, ft"),
                           (("solve", "--unit", "mm", "--set", "tilt.towards=up", "section.wkt"), "left, right or both"),
                           (("solve", "--unit", "mm", "--set", "tilt.towards=left", "--set", "tilt.towards=right",
                             "section.wkt"), "'tilt.towards' is set twice"),
                           (("solve", "--unit", "mm", "--set", "drawing.unit=in", "section.wkt"), "is set twice"),
                           (("solve", "--unit", "mm", "--set", "friction_angle_deg=steep", "section.wkt"),
                            "unknown name 'steep'")):
            status, out, err = self.run_here(*words)
            self.assertEqual((status, out), (3, ""), words)
            self.assertIn(why, err)
            self.assertEqual(err.count("\n"), 1, err)

    def test_refused_where_there_is_no_scene(self):
        (self.folder / "points.csv").write_text("x,y\n0,0\n1,0.1\n2,0\n3,0.1\n")
        for words, why in ((("accuracy", "--sweep", "--unit", "mm"), "--sweep generates its own blocks"),
                           (("chart", "fos", "--unit", "mm"), "an option for another kind of chart"),
                           (("profile", "--set", "a=3", "points.csv"), "is a file of points")):
            status, out, err = self.run_here(*words)
            self.assertEqual((status, out), (2, ""), words)
            self.assertIn(why, err)

    def test_refused_by_a_study(self):
        for keys, why in (("set: friction_angle_deg=30", "'set' is a list of KEY=VALUE"), ("set: []", "'set' is a list"),
                          ("set: [[a]]", "'set' is a list"), ("set: [tilt.towards]", "sets no number"),
                          ("unit: [mm]", "'unit' is mm"), ("unit: yd", "unit must be one of")):
            (self.folder / "study.yaml").write_text("topple_study: 1\nscene: section.wkt\n" + keys + "\nsamples: 9\n"
                                                    "vary: {friction_angle_deg: {normal: {mean: 9, deviation: 1}}}\n")
            status, out, err = self.run_here("study", "study.yaml")
            self.assertEqual((status, out), (3, ""), keys)
            self.assertIn(why, err)
            self.assertIn("study.yaml:", err)


if __name__ == "__main__":
    main()
