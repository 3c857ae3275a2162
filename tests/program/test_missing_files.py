# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Whatever file a command, a scene, a study or a claim names: where it is not there, or is a folder, the
system failed, which is exit status 5, and one line of message names the file. Bad input, 3, is what a file says."""

import os
import pathlib
import tempfile
import unittest

from harness import PROGRAM, main, run

HAS_GDAL = (pathlib.Path(os.environ.get("TOPPLE_BUILD", pathlib.Path(PROGRAM).parent)) / "libtopple-gis.so").exists()
HEAD = "topple: 1\nlength_unit: m\n"
SLAB = HEAD + "block: {slab: {width: 1, height: 3}, unit_weight_kn_m3: 26}\nfriction_angle_deg: 30\ntilt: {towards: left}\n"
STUDY = "topple_study: 1\nscene: slab.yaml\n"
#: What names a file that is not there: the file that says so, the text of it, the command, the name.
NAMED = [
    ("scene.yaml", HEAD + "block: {outline: none.csv}\n", "solve", "none.csv"),
    ("scene.yaml", SLAB + "base: {profile: none.csv}\n", "solve", "none.csv"),
    ("scene.yaml", SLAB + "base: {profile: {measured: none.csv}}\n", "profile", "none.csv"),
    ("scene.yaml", HEAD + "drawing: {file: none.dxf}\n", "solve", "none.dxf"),
    ("scene.yaml", HEAD + "drawing: {file: none.svg}\n", "solve", "none.svg"),
    ("scene.yaml", HEAD + "drawing: {file: none.geojson}\n", "solve", "none.geojson"),
    ("scene.yaml", HEAD + "section: {from: [0, 0], to: [1, 0]}\nblock: {outline: {mesh: none.obj}}\n", "solve", "none.obj"),
    ("scene.yaml", SLAB + "tilt_test: {engine: dynamics}\nshaking: {horizontal: {record: {file: none.at2}}}\n", "tilt",
     "none.at2"),
    ("study.yaml", "topple_study: 1\nscene: none.yaml\nvary: {friction_angle_deg: {list: [30, 31]}}\n", "study", "none.yaml"),
    ("study.yaml", STUDY + "vary: {friction_angle_deg: {column: 'none.csv:phi'}}\n", "study", "none.csv"),
    ("claims.yaml", "topple_claims: 1\ngeometries: {e: {scene: none.yaml}}\nclaims:\n"
     "- {id: x, where: here, geometry: e, quantity: a, printed: a}\n", "verify", "none.yaml"),
]


class MissingFiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.write("slab.yaml", SLAB)

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return name

    def failed(self, why, *command):
        status, out, err = run(*command, folder=self.folder)
        self.assertEqual((status, out), (5, ""), f"{command}: {err}")
        self.assertEqual(err.count("\n"), 1, err)
        self.assertIn(why, err)

    def test_named_by_the_command(self):
        """Of every command that reads one: scene, study, claims, profile, drawing, rows."""
        missing = "{}: cannot be opened: No such file or directory".format
        for command in ("solve", "sweep --x=friction_angle_deg=1:2:1", "derive", "accuracy", "tilt", "study", "verify",
                        "chart map --x=block.slab.width=1:2 --y=friction_angle_deg=1:2", "profile"):
            with self.subTest(command):
                self.failed(missing("none.yaml"), *command.split(), "none.yaml")
        self.failed(missing("none.csv"), "profile", "--unit=mm", "none.csv")
        self.failed(missing("none.dxf"), "solve", "--unit=mm", "none.dxf")
        self.write("study.yaml", STUDY + "vary: {friction_angle_deg: {list: [30, 31]}}\n")
        self.failed(missing("none.csv"), "study", "--merge", "study.yaml", "none.csv")

    def test_named_in_a_file(self):
        for by, text, command, name in NAMED:
            with self.subTest(text):
                self.failed(f"{name}: cannot be opened: No such file or directory", command, self.write(by, text))

    def test_a_folder_is_no_file(self):
        (self.folder / "folder.csv").mkdir()
        self.failed("folder.csv: cannot be read: Is a directory", "solve",
                    self.write("scene.yaml", HEAD + "block: {outline: folder.csv}\n"))
        self.failed(".: cannot be read: Is a directory", "solve", ".")

    @unittest.skipUnless(HAS_GDAL, "Topple was built without GDAL")
    def test_shapefile(self):
        self.failed("none.shp: cannot be opened: No such file or directory", "solve",
                    self.write("scene.yaml", HEAD + "drawing: {file: none.shp}\n"))


if __name__ == "__main__":
    main()
