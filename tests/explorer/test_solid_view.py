# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Solids on the page: their meshes as triangles, turns of them, and the picture that follows hand, keys and tilt."""

import math
import re
import struct
import time
import unittest

import picture
from node_case import NODE, node
from page_case import ROOT, main
from panel_case import PanelCase

SOLID = ROOT / "src" / "applications" / "explorer" / "solid"
CORNERS = [[0, 0, 0], [1, 0, 0], [0, 2, 0], [0, 0, 3]]
FACES = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
OBJ = "".join("v {} {} {}\n".format(*point) for point in CORNERS) + "".join("f {}/1 {} {}\n".format(*(at + 1 for at in face)) for face in FACES)
PLY = ("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 4\n"
       "property list uchar int vertex_indices\nend_header\n" + "".join("{} {} {}\n".format(*point) for point in CORNERS)
       + "".join("3 {} {} {}\n".format(*face) for face in FACES))
STL = "solid one\n" + "".join("facet normal 0 0 0\nouter loop\n" + "".join("vertex {} {} {}\n".format(*CORNERS[at]) for at in face)
                              + "endloop\nendfacet\n" for face in FACES) + "endsolid\n"
BYTES = b"\0" * 80 + struct.pack("<I", 4) + b"".join(struct.pack("<12fH", 0, 0, 0, *(c for at in face for c in CORNERS[at]), 0) for face in FACES)


@unittest.skipIf(NODE is None, "there is no node: install Debian's package nodejs")
class Parts(unittest.TestCase):
    def test_meshes(self):
        """One tetrahedron in four formats: the same twelve corners, and a volume of one."""
        expected = [float(c) for face in FACES for at in face for c in CORNERS[at]]
        body = """return [...given.texts, Uint8Array.from(given.bytes)].map((content) => { const t = it.trianglesOf(content); return [[...t], it.volumeOf(t)]; });"""
        for numbers, volume in node(SOLID / "mesh.js", body, {"texts": [OBJ, PLY, STL], "bytes": list(BYTES)}):
            self.assertEqual(numbers, expected)
            self.assertAlmostEqual(volume, 1, places=12)
        quad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3 -2 -1\n"
        self.assertEqual(node(SOLID / "mesh.js", "return given.map((content) => it.trianglesOf(content)?.length ?? null);", [quad, "no mesh", "v 0 0 0\nf 1 2 3\n"]), [18, None, None])

    def test_turns(self):
        """Up comes upright; what lies towards the azimuth goes down by the tilt, what lies across stays; nothing is stretched."""
        ups = [[0, 0, 1], [0, 0, -2], [0, 1, 0], [0.3, -0.4, 0.5]]
        for up, found in zip(ups, node(SOLID / "turning.js", "return given.map((up) => it.turned(it.upright(up), up));", ups)):
            for one, other in zip(found, (0, 0, math.hypot(*up))):
                self.assertAlmostEqual(one, other, places=12)
        cases = [[5, 120], [30, 0], [17, 271]]
        body = """return given.map(([degrees, azimuth]) => { const a = azimuth * Math.PI / 180; const turn = it.tilted(degrees, azimuth);
          return [it.turned(turn, [Math.sin(a), Math.cos(a), 0]), it.turned(turn, [Math.cos(a), -Math.sin(a), 0])]; });"""
        for (degrees, azimuth), (down, across) in zip(cases, node(SOLID / "turning.js", body, cases)):
            way = math.radians(azimuth)
            self.assertAlmostEqual(down[2], -math.sin(math.radians(degrees)), places=12)
            self.assertAlmostEqual(math.hypot(*down), 1, places=12)
            for one, other in zip(across, (math.cos(way), -math.sin(way), 0)):
                self.assertAlmostEqual(one, other, places=12)


class Solid(PanelCase):
    def load(self, fragment="", width=1280, height=900):
        super().load(fragment, width, height)

    def setUp(self):
        super().setUp()
        if self.value("document.createElement('canvas').getContext('webgl') === null"):
            self.skipTest("this browser draws nothing by WebGL here: its page shows the report of a solid")
        self.example("balanced_rock")
        self.awaits("!document.getElementById('solid-stage').hidden")
        time.sleep(0.3)

    def rock(self):
        """Dots whose red, green and blue stand to each other as the block's, of whatever light."""
        _, _, found = picture.dots(self.picture())
        return sum(count for (r, g, b), count in found.items() if r > 60 and 0.75 < g / r < 0.92 and 0.45 < b / r < 0.68)

    def edge(self):
        return self.value("document.querySelector('.solid-lines .edge').getAttribute('d')")

    def test_drawn_and_judged(self):
        self.assertGreater(self.rock(), 30_000)
        self.assertEqual(self.said("#verdict-said"), "Stands at 5°")
        self.assertIn("1.641", self.said("#factor-said"))
        self.assertIn("tilted by 5° towards 120°", self.said(".solid-lines text"))

    def test_wedge_and_contacts(self):
        """A wedge, which no file has, between its planes, with the line that it would slide along; points that a rock lies on."""
        for name, said, factor, words, kind, count in (
                ("wedge", "Stands", "1.346 against sliding", "plunges by 31.197° towards 157.732°", "way", 1),
                ("rock_on_contacts", "May move at 5°", "15.89", "tilted by 5°", "touching", 4)):
            with self.subTest(name):
                self.example(name)
                self.assertEqual(self.said("#verdict-said"), said)
                self.assertIn(factor, self.said("#factor-said"))
                self.assertIn(words, self.said(".solid-lines text"))
                self.assertEqual(self.value(f"document.querySelectorAll('.solid-lines:not(.below-mesh) .{kind}').length"), count)
                self.assertGreater(self.rock(), 5_000)

    def test_turned_by_hand_and_keys(self):
        before = self.edge()
        x, y = self.value("(() => { const r = document.querySelector('.solid-stage canvas').getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2]; })()")
        self.pull((x, y), (x + 120, y + 20))
        turned = self.edge()
        self.assertNotEqual(turned, before)
        self.value("document.querySelector('.solid-stage canvas').focus()")
        self.press("ArrowLeft")
        self.assertNotEqual(self.edge(), turned)
        self.press("0", text="0")
        self.assertEqual(self.edge(), before)
        self.assertGreater(self.rock(), 30_000)

    def test_follows_the_tilt_and_leaves(self):
        """The weight points down whatever the tilt; a scene of a block has its own drawing again."""
        edge = self.edge()
        self.value("(() => { const f = document.querySelector('#numbers input[type=text]'); f.value = '9'; f.dispatchEvent(new Event('input')); })()")
        self.answered()
        self.assertNotEqual(self.edge(), edge)
        self.assertIn("tilted by 9°", self.said(".solid-lines text"))
        x = re.findall(r"[-\d.]+", self.value("document.querySelector('.solid-lines .weight').getAttribute('d')"))
        self.assertAlmostEqual(float(x[0]), float(x[2]), places=1)
        self.example("slab_left")
        self.assertTrue(self.value("document.getElementById('solid-stage').hidden && document.querySelector('.shape.block').getBoundingClientRect().width > 50"))


if __name__ == "__main__":
    main()
