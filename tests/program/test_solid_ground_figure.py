#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The mesh of the ground in the figure of a rock and in its model.

Where points of the model lie is computed from both meshes by hand; how much of a ground is drawn, from areas seen from above, by the
counts of dots of either colour in the picture that the figure embeds."""

import base64
import pathlib
import re
import sys

from harness import ROOT, main, run
from mesh_case import box
from test_solid_ground import grid
from test_solid_scenes import SceneCase
from test_solid_sheets import Model
from test_solids import exact_obj

sys.path.insert(0, str(ROOT / "tests" / "explorer"))
import picture  # noqa: E402

SCENE = """topple: 1
length_unit: m
solid: {{file: rock.obj, unit: m, azimuths: 8, base: {{file: ground.obj{ground}}}, bands: [{band}]{more}}}
friction_angle_deg: 35
tilt: {{angle_deg: 5, azimuth_deg: 90}}
"""


class Case(SceneCase):
    def rest(self, rock, ground, base="", more="", band=0.001):
        self.put("rock.obj", exact_obj(*rock))
        self.put("ground.obj", exact_obj(*ground))
        return self.put("scene.yaml", SCENE.format(ground=base, more=more, band=band))


class GroundInModel(Case, Model):
    def shapes(self, *given, **also):
        return self.draw(self.rest(*given, **also))[0]

    def test_ground_lies_under_the_rock(self):
        """All of a ground, and not only what is near: its points from the foot of the rock's centroid, with y up, as sand; its triangles
        look up. The name is that of its file."""
        rock, ground = box((5, 7, 1), (7, 8, 5)), grid([[1] * 4] * 3, step=100, origin=(-90, -80))
        shapes = self.shapes(rock, ground)
        points, corners, material, mode = shapes["ground, ground.obj"]
        self.assertEqual((material, mode), ("ground", 4))
        self.assertEqual(sorted(points), sorted((float(x - 6), float(z - 1), float(7.5 - y)) for x, y, z in ground[0]))
        self.assertEqual(len(corners), 3 * len(ground[1]))
        for k in range(0, len(corners), 3):
            a, b, c = (points[i] for i in corners[k:k + 3])
            self.assertLess((b[0] - a[0]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[0] - a[0]), 0)  # counter-clockwise from above: z is south
        self.assertEqual(len(shapes["rock"][0]), 8)

    def test_far_off_in_other_units_and_turned(self):
        """Rock and ground of the model are the same to the last digit 10⁹ away, with the ground in centimetres, and with heights along y."""
        rock, ground = box((0, 0, 0), (2, 1, 2)), grid([[0, 0, -0.25]] * 2 + [[0, 0, -0.5]], step=2, origin=(-1, -1))

        def surfaces(*given, **also):
            shapes = self.shapes(*given, **also)
            return shapes["rock"], shapes["ground, ground.obj"]

        def moved(mesh, place):
            return [place(*p) for p in mesh[0]], mesh[1]
        one = surfaces(rock, ground)
        far = lambda x, y, z: (x + 10**9, y - 10**9, z + 10**9)
        self.assertEqual(surfaces(moved(rock, far), moved(ground, far)), one)
        centimetres = moved(ground, lambda x, y, z: (100 * x, 100 * y, 100 * z))
        self.assertEqual(surfaces(rock, centimetres, base=", unit: cm"), one)
        upright = lambda x, y, z: (x, z, -y)
        self.assertEqual(surfaces(moved(rock, upright), moved(ground, upright), more=", up: [0, 1, 0]"), one)

    def test_one_object(self):
        """Of a file of several the one that is named, and its name."""
        ground = grid([[0, 0], [0, 0]], step=4, origin=(-1, -1))
        text = exact_obj(*box((8, 8, 8), (9, 9, 9)))
        other = exact_obj(*ground).replace("f ", "g field\nf ", 1)
        other = re.sub(r"^f .*", lambda m: "f " + " ".join(str(int(k) + 8) for k in m[0].split()[1:]), other, flags=re.M)
        scene = self.rest(box((0, 0, 0), (2, 1, 2)), ground, base=", object: field")
        self.put("ground.obj", text.replace("f ", "g tower\nf ", 1) + other)
        shapes, _ = self.draw(scene)
        self.assertEqual(len(shapes["ground, ground.obj, field"][0]), 4)


class GroundInFigure(Case):
    def counts(self, scene):
        """How many dots of the pictures from the side and from above, on a sheet, are of rock, of ground, and of rock behind ground."""
        path = pathlib.Path(self.folder) / "sheet.html"
        status, _, err = run("solve", "--report", path, scene)
        self.assertEqual(status, 0, err)
        drawing, = re.findall(r"data:image/svg.xml;base64,([^\"]+)", path.read_text(encoding="utf-8"))
        pictures = re.findall(r'"data:image/png;base64,([^"]+)"', base64.b64decode(drawing).decode())
        self.assertEqual(len(pictures), 2)
        return sorted(map(self.count, pictures))

    def count(self, drawn):
        found = [0, 0, 0]
        for (red, _, blue), count in picture.dots(base64.b64decode(drawn))[2].items():
            if red > 100:
                found[0 if blue > 0.92 * red else 1 if blue < 0.80 * red else 2] += count
        return found

    def test_how_much_is_drawn(self):
        """From above, a rock of 2 m² that is 4 m tall: of a ground of 800 m a side what is 0.3 of its longest side about it, 4.4 by 3.4 m;
        one of 4 by 3 m as a whole, and none of it is before the rock."""
        rock = box((0, 0, 0), (2, 1, 4))
        for ground, area in ((grid([[0] * 2] * 2, step=800, origin=(-400, -400)), 4.4 * 3.4), (grid([[0] * 5] * 4, origin=(-1, -1)), 12)):
            counts = self.counts(self.rest(rock, ground))
            ratios = [sand / max(1, stone) for stone, sand, _ in counts]
            self.assertTrue(any(abs(ratio - (area - 2) / 2) < 0.02 * ratio for ratio in ratios), (counts, area))
            self.assertLess(max(both for *_, both in counts), 2000)

    def test_rock_shows_through(self):
        """Of a ground that stands before the rock: many of the dots from the side have both colours."""
        plane, faces = grid([[0] * 9] * 9, origin=(-3, -4))
        bank = [(x, y, 1 if y <= -1 else z) for x, y, z in plane], faces  # to the south, where the eye is
        self.assertGreater(max(both for *_, both in self.counts(self.rest(box((0, 0, 0), (2, 1, 2)), bank))), 10_000)


if __name__ == "__main__":
    main()
