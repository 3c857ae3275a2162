# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What the tests of charts share: a slab, charts read back as rows, and numbers held to their errors."""

import csv
import io
import math
import pathlib
import tempfile
import unittest
from decimal import Decimal

import exact
from harness import run

DEGREE = math.pi / 180
SLAB = ("topple: 1\ntitle: {title}\nlength_unit: m\nblock: {{slab: {{width: {width}, height: {height}}}}}\n"
        "friction_angle_deg: {friction}\ntilt: {{towards: left}}\n")


def chart(*arguments):
    """The rows of the CSV that a chart prints."""
    status, out, err = run("chart", *arguments)
    if status != 0 or err:
        raise AssertionError(f"topple chart {arguments}: exit {status}: {err}")
    return list(csv.DictReader(io.StringIO(out)))


def select(rows, **keys):
    return [row for row in rows if all(row[k] == v for k, v in keys.items())]


def toe_of(ring):
    """What a toe that holds says of a block that turns about the first point of its outline: delta, the angle of the
    centroid from it, and kappa = k^2 / (k^2 + r^2), from exact moments."""
    a, sx, sy, xx, yy, _ = exact.ring_moments(ring)
    x, y = sx / a, sy / a
    square = (xx + yy) / a - x * x - y * y
    x, y = x - ring[0][0], y - ring[0][1]
    return math.atan2(x, y), float(square / (square + x * x + y * y))


def lean(delta, kappa, tilt):
    """How far from the base's normal the force on such a toe leans, degrees: it slips where that exceeds the friction
    angle and the inclination of the toe's facet, positive where the block climbs it."""
    return (delta + math.atan(kappa * math.tan(tilt * DEGREE - delta))) / DEGREE


class Chart(unittest.TestCase):
    def setUp(self):
        self.held = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.held.name)
        self.scene = self.folder / "scene.yaml"

    def tearDown(self):
        self.held.cleanup()

    def slab(self, width="1", height="2", friction="30", title="A slab"):
        self.scene.write_text(SLAB.format(width=width, height=height, friction=friction, title=title),
                              encoding="utf-8")
        return self.scene

    def within(self, row, truth, name):
        """A printed value lies within its printed error of the truth."""
        off = abs(Decimal(row[name]) - Decimal(truth))
        self.assertLessEqual(off, Decimal(row["y_error"]) + abs(Decimal(truth)) * Decimal("2e-16"), row)
        self.assertLess(Decimal(row["y_error"]), Decimal("1e-9"))
