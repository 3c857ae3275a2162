# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Scenes that are dragged on the page, and how they are drawn."""

import math
import re

from page_case import PageCase

POLYGON = """# kept: a comment above
topple: 1
title: A polygon
length_unit: mm
block:
  outline: [[0, 0], [100, 0],   # kept: a comment between
    [110, 60], [60, 140], [-10, 90]]
  unit_weight_kn_m3: 26
base:
  mated: true
  beyond: {left: 0, right: 0}
friction_angle_deg: 30
tilt: {towards: left, angle_deg: 12}
"""


def polygon(count):
    """Convex, on a flat of 1 m."""
    turn = [math.radians(-34 + 248 * i / (count - 3)) for i in range(count - 2)]
    points = [[0, 0], [1000, 0]] + [[round(500 + 600 * math.cos(a), 1), round(700 + 600 * math.sin(a), 1)] for a in turn]
    return re.sub(r"outline: .*?\]\]", f"outline: {points}", POLYGON, flags=re.S)


class DrawnCase(PageCase):
    def drawn_turn(self):
        """The angle of the base on the screen, counter-clockwise, read off the matrix of what is drawn."""
        a, b = self.value("(() => { const m = document.querySelector('g.frame').getCTM(); return [m.a, m.b]; })()")
        return math.degrees(math.atan2(-b, a))
