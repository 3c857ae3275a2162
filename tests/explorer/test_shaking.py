# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Shaking, played: its record below the film, and which multiples of it overturn the block, each a press away."""

import math
import unittest

from node_case import NODE, node
from page_case import ROOT, main
from panel_case import PanelCase

EXPLORER = ROOT / "src" / "applications" / "explorer"
SHAKING = EXPLORER / "scene" / "shaking.js"
# Housner's block under a whole sine, whose overturning ranges are two with a stand between (docs/tilt.md)
SLAB = """topple: 1
length_unit: m
block:
  slab: {width: 1, height: 4}
  unit_weight_kn_m3: 25
base: {mated: true, beyond: {left: 1, right: 1}}
friction_angle_deg: 60
tilt: {towards: left}
tilt_test: {engine: dynamics, method: events, protocol: release}
shaking: {horizontal: {full_sine: {peak_g: 1.2, frequency_hz: 2}}}
"""


@unittest.skipIf(NODE is None, "there is no node: install Debian's package nodejs")
class Parts(unittest.TestCase):
    def test_accelerations(self):
        text = (EXPLORER.parents[2] / "examples" / "synthetic_record.at2").read_text(encoding="utf-8")
        found = node(SHAKING, "return [it.recordOf(given), it.recordOf('0, 0\\n0.5, 0.25\\n1, -1\\n'), it.recordOf('no record')];", text)
        values = [float(word) for line in text.split("\n")[4:] for word in line.split()]
        self.assertEqual(found[0]["g"], values)
        self.assertTrue(all(math.isclose(t, 0.01 * k, abs_tol=1e-12) for k, t in enumerate(found[0]["t"])))
        self.assertEqual(found[1:], [{"t": [0, 0.5, 1], "g": [0, 0.25, -1]}, None])


class Shaken(PanelCase):
    def load(self, fragment="", width=1280, height=900):
        super().load(fragment, width, height)

    def played(self):
        self.awaits("!document.getElementById('play').disabled")
        self.assertEqual(self.said("#play"), "Shake it")
        self.click("#play")
        self.awaits("!document.getElementById('film').hidden")

    def test_record_below_the_film(self):
        """As many points as the record has; a press in its middle leads to that time."""
        self.example("shaken_boulder")
        self.played()
        self.assertEqual(self.value("document.querySelector('.record .horizontal').getAttribute('d').split('L').length"), 1200)
        self.assertIn("0.5250 g", self.said(".shaking"))
        x, y, width = self.value("(() => { const r = document.querySelector('.record').getBoundingClientRect(); return [r.x, r.y + r.height / 2, r.width]; })()")
        self.mouse("mousePressed", x + width / 2, y)
        self.mouse("mouseReleased", x + width / 2, y)
        self.frame()
        shown = float(self.said(".film-line .film-said").split(" ")[0])
        end = 2 * shown
        self.assertGreater(end, 10)
        at = self.value("Number(document.querySelector('.record .now').getAttribute('x1'))")
        self.assertAlmostEqual(at, 500, delta=2)

    def test_an_island_is_a_press_away(self):
        """The ranges of `topple tilt --overturning`; in one that overturns the block it falls, in one beside it stands again."""
        self.type_scene(SLAB)
        self.answered()
        self.played()
        self.button("What overturns it?")
        self.awaits("document.querySelectorAll('.range-bar .falls').length > 0", 90)
        ranges = self.value("[...document.querySelectorAll('.range-bar button')].map(b => [b.className, b.title])")
        self.assertEqual(ranges[0][0], "spared")
        for kind, overturns in (("falls", True), ("spared", False)):
            self.click(f".range-bar .{kind}")
            self.answered()
            self.awaits("!document.getElementById('film').hidden")
            events = self.texts(".event")
            with self.subTest(kind, events=events[-3:]):
                self.assertEqual(any("overturned" in event or "leaves its base" in event for event in events), overturns)
            self.assertEqual(len(self.value("[...document.querySelectorAll('.range-bar button')].map(b => b.className)")), len(ranges))


if __name__ == "__main__":
    main()
