# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The core in WebAssembly draws what the native program draws: figure and sheet of every example, by node.

Figures as SVG and PDF are the same bytes. Of PNG every dot is the same to one step of 255, for Pixman rounds where it has
SSE2, as natively, otherwise in its plain C. Sheets are the same bytes but for the rows of the triangles that a block is
made of and their places in the drawing: CGAL gives them in the order of its memory, and a long list is cut."""

import operator
import os
import pathlib
import re
import struct
import sys
import tempfile
import unittest
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "program"))

os.environ["SOURCE_DATE_EPOCH"] = "1700000000"  # sheets without today's date and without times

from harness import main, run  # noqa: E402
from test_core_agrees import CORE, NODE, Core  # noqa: E402

EXAMPLES = ROOT / "examples"
STEPS_MAX = 1  # of 255, between two dots
UNLIKE_SHARE = 1e-4  # of all dots
SVG = re.compile(r"data:image/svg\+xml;base64,([A-Za-z0-9+/=]+)")


def dots(png):
    """Width, height and all bytes of an RGB picture, by the filters of PNG (its specification, section 9)."""
    at, packed, width, height = 8, b"", 0, 0
    while at < len(png):
        size, kind = struct.unpack(">I4s", png[at : at + 8])
        content = png[at + 8 : at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, colours = struct.unpack(">IIBB", content[:10])
            assert (depth, colours) == (8, 2), "not RGB"
        if kind == b"IDAT":
            packed += content
        at += size + 12
    raw, length = zlib.decompress(packed), 3 * width
    above, rows = bytearray(length), []
    for y in range(height):
        row = bytearray(raw[y * (length + 1) + 1 : (y + 1) * (length + 1)])
        how = raw[y * (length + 1)]
        for x in range(length) if how else ():
            left, corner = (row[x - 3], above[x - 3]) if x >= 3 else (0, 0)
            guess = left + above[x] - corner
            nearest = min((left, above[x], corner), key=lambda value: abs(guess - value))
            row[x] = (row[x] + (0, left, above[x], (left + above[x]) // 2, nearest)[how]) & 255
        rows.append(row)
        above = row
    return width, height, b"".join(rows)


def untriangled(sheet):
    """The lines of a sheet as Markdown without its drawings and its rows of triangles."""
    return [SVG.sub("", line) for line in sheet.splitlines() if not re.match(r"\| \d+ \| triangle \|", line)]


@unittest.skipIf(NODE is None, "there is no node: install Debian's package nodejs")
@unittest.skipUnless(CORE.is_file(), f"there is no {CORE}: ./run --explorer builds it")
class Draws(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.core = Core()
        cls.addClassCleanup(cls.core.close)
        cls.scenes = sorted(str(scene.relative_to(EXAMPLES)) for scene in EXAMPLES.rglob("*.yaml"))

    def written(self, option, ending, scene):
        """What the native program writes of a scene, and what the core does; None where neither writes."""
        with tempfile.TemporaryDirectory() as folder:
            native = pathlib.Path(folder) / f"x.{ending}"
            status, _, err = run("solve", "--quiet", option, str(native), scene, folder=EXAMPLES)
            own = native.read_bytes() if native.exists() else None
        answer = self.core.run(EXAMPLES, "solve", "--quiet", option, f"x.{ending}", scene, collect=[f"x.{ending}"])
        its = answer["files"].get(f"x.{ending}")
        self.assertEqual((answer["status"], own is None), (status, its is None), (scene, err, answer["err"]))
        return own, None if its is None else its.encode("latin1")

    def pairs(self, option, ending):
        for scene in self.scenes:
            own, its = self.written(option, ending, scene)
            if own is not None:
                yield scene, own, its

    def test_figures_in_lines(self):
        """SVG and PDF: the same bytes, so the same letters of the same fonts at the same places."""
        for ending in ("svg", "pdf"):
            count = 0
            for scene, own, its in self.pairs("--figure", ending):
                self.assertTrue(own == its, f"{scene} as {ending}")
                count += 1
            self.assertGreater(count, 40)
            print(f"{count} figures as {ending}: the same bytes")

    def test_figures_in_dots(self):
        """PNG: the same bytes, or dots that differ by a rounding."""
        same = unlike = 0
        for scene, own, its in self.pairs("--figure", "png"):
            if own == its:
                same += 1
                continue
            one, other = dots(own), dots(its)
            self.assertEqual(one[:2], other[:2], scene)
            apart = [abs(a - b) for a, b in zip(one[2], other[2]) if a != b]
            self.assertLessEqual(max(apart), STEPS_MAX, scene)
            self.assertLess(len(apart), UNLIKE_SHARE * len(one[2]), scene)
            unlike += 1
        self.assertGreater(same, 40)
        print(f"{same} figures as png: the same bytes; {unlike} differ by {STEPS_MAX} of 255 in some dots")

    def test_sheets(self):
        """Markdown and HTML: the same bytes; of a block of triangles all but their rows is the same."""
        same = moved = 0
        for scene, own, its in self.pairs("--report", "md"):
            if own != its:
                moved += 1
                self.assertEqual(untriangled(own.decode()), untriangled(its.decode()), scene)
                self.assertIn("| triangle |", own.decode(), scene)
                continue
            same += 1
            self.assertTrue(operator.eq(*self.written("--report", "html", scene)), scene)
        self.assertGreater(same, 40)
        print(f"{same} sheets: the same bytes; {moved} have triangles in other rows")

    def test_sheets_as_pdf(self):
        """The same bytes wherever the sheet as Markdown is."""
        for scene in ("block_e_valley.yaml", "block_f.yaml", "slab_left.yaml"):
            own, its = self.written("--report", "pdf", scene)
            self.assertTrue(own is not None and own == its, scene)

    def test_nothing_stays(self):
        """A hundred figures as PNG take the memory of the first, for each run begins anew."""
        sizes = []
        for _ in range(100):
            answer = self.core.run(EXAMPLES, "solve", "--quiet", "--figure", "x.png", "block_e_valley.yaml")
            self.assertEqual(answer["status"], 0, answer["err"])
            sizes.append(answer["memory"])
        self.assertEqual(sizes[-1], sizes[0])

    def test_refused(self):
        """A figure over the scene itself, or of another kind, is refused in the same words."""
        for name in ("block_f.yaml", "x.bmp"):
            status, _, err = run("solve", "--quiet", "--figure", name, "block_f.yaml", folder=EXAMPLES)
            answer = self.core.run(EXAMPLES, "solve", "--quiet", "--figure", name, "block_f.yaml")
            self.assertEqual((answer["status"], answer["err"]), (status, err))
            self.assertNotEqual(status, 0)


if __name__ == "__main__":
    main()
