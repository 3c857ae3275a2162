# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Programs of our own in the place of gnuplot and ffmpeg."""

import os
import pathlib
import tempfile
import unittest

from harness import PROGRAM

CHARTS = (("fos",), ("--x", "block.slab.width=20:150", "map", "examples/slab_left.yaml"))


class StandIns(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="topple gnuplot ")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def command(self, name, chart=CHARTS[0]):
        # options first, as POSIXLY_CORRECT wants them of this program too
        return [PROGRAM, "chart", "--output", self.folder / name, *chart]

    def stand_in(self, name, script, program="gnuplot"):
        """A folder with a gnuplot of our own, or an ffmpeg."""
        tools = self.folder / name
        tools.mkdir()
        (tools / program).write_text(f"#!/bin/sh\n{script}\n")
        (tools / program).chmod(0o755)
        return {**os.environ, "PATH": f"{tools}:/usr/bin:/bin"}
