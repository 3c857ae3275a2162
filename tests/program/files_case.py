# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What the tests of files share: a folder with a scene, commands that write into it, and what a whole file is."""

import os
import pathlib
import tempfile
import unittest

from harness import LONG

SCENE = """topple: 1
length_unit: m
block: {outline: outline.csv, unit_weight_kn_m3: 26, thickness: 1}
base: {profile: sub/profile.csv}
friction_angle_deg: 30
tilt: {towards: left, angle_deg: 5}
"""
MAP = ("--x", "block.thickness=0.5:3")
WHOLE = {".svg": (b"<?xml", b"</svg>"), ".pdf": (b"%PDF-", b"%%EOF"),
         ".png": (b"\x89PNG", b"IEND\xaeB`\x82"), ".csv": (b"panel,", b"")}


def is_whole(data, ending=".svg"):
    begin, end = WHOLE[ending]
    return data.startswith(begin) and data.rstrip().endswith(end) and data.count(begin) == 1


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="topple files ")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "sub").mkdir()
        self.scene = self.folder / "scene.yaml"
        self.scene.write_text(SCENE)
        (self.folder / "outline.csv").write_text("0,0\n2,0\n2,5\n0,5\n")
        (self.folder / "sub" / "profile.csv").write_text("-9,0\n9,0\n")

    def commands(self, output, scene=None, slow=LONG):
        """Every command that writes a file of this name; `slow`: also those that take a second."""
        scene = scene or self.scene
        commands = [("chart", "map", scene, *MAP, "--output", output), ("profile", scene, "--output", output)]
        if slow:
            commands.append(("accuracy", scene, "--output", output))
        if not str(output).endswith(".csv"):
            commands.append(("solve", scene, "--figure", output))
        return commands

    def contents(self):
        """Every file and link below the folder, with what stands in it."""
        return {str(p.relative_to(self.folder)): os.readlink(p) if p.is_symlink() else p.read_bytes()
                for p in sorted(self.folder.rglob("*")) if p.is_symlink() or p.is_file()}

    def assert_whole(self, path):
        self.assertTrue(is_whole(path.read_bytes(), path.suffix), path)
