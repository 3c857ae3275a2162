# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Meshes of solids with cavities (docs/mesh.md).

The story: a vuggy block was scanned inside and out, and its mesh is one surface within another. Where the plane passes a
cavity the block has a hole there, of the area and place that closed forms and fractions give, whichever way the faces of
the inner surface turn; where it passes beside it there is none; and a stone that rattles in a cavity is no part of the
block without a word."""

import csv
import io
import math
from fractions import Fraction

from harness import main, run
from mesh_case import MeshCase, box, obj, octahedron, sections


def together(*solids, flipped=()):
    """One mesh of several surfaces, some of them with their faces turned round."""
    points, faces = [], []
    for number, (own, of) in enumerate(solids):
        faces += [tuple(k + len(points) for k in (f[::-1] if number in flipped else f)) for f in of]
        points += own
    return points, faces


class Cavities(MeshCase):
    def near(self, number, exact, slack=0):
        self.assertLessEqual(abs(Fraction(number["value"]) - exact), Fraction(number["error"]) + Fraction(slack))

    def notes(self, solution):
        return " / ".join(note["text"] for note in solution["notes"])

    def test_a_cube_in_a_cube(self):
        """16 m2 less 1, and the centroid moved away from the cavity by its moment; four points of each, exact."""
        for flipped in ((), (1,)):
            mesh = together(box((0, 0, 0), (4, 4, 4)), box(("2.5", 1, 1), ("3.5", 2, 2)), flipped=flipped)
            self.write("a.obj", obj(*mesh))
            solution = self.solve(self.scene("a.obj", "{from: [0, 1.5], to: [1, 1.5]}"))
            block = solution["cases"][0]["block"]
            self.near(block["area_m2"], Fraction(15))
            self.near(block["centroid_x_m"], Fraction(16 * 2 - 3, 15))
            self.near(block["centroid_y_m"], (16 * 2 - Fraction(3, 2)) / 15)
            self.assertIn("1 outline lies within the outline: cavities, which the block has for holes", self.notes(solution))

    def test_beside_the_cavity(self):
        mesh = together(box((0, 0, 0), (4, 4, 4)), box((1, 1, 1), (2, 2, 2)))
        self.write("a.obj", obj(*mesh))
        solution = self.solve(self.scene("a.obj", "{from: [0, 3], to: [1, 3]}"))
        self.near(solution["cases"][0]["block"]["area_m2"], Fraction(16))
        self.assertNotIn("cavit", self.notes(solution))

    def test_facetted_spheres(self):
        """A boulder of 512 facets with two cavities: areas and first moments of three polygons by fractions."""
        outer = octahedron(half=(2, 2, 2), centre=(0, 0, 3), level=3)
        inner = [octahedron(half=(Fraction(1, 2),) * 3, centre=(Fraction(3, 4), 0, 3), level=2),
                 octahedron(half=(Fraction(3, 8),) * 3, centre=(-1, Fraction(1, 8), Fraction(7, 2)), level=1)]
        self.write("a.obj", obj(*together(outer, *inner, flipped=(2,))))
        block = self.block(self.scene("a.obj", "{from: [0, 0.1], to: [1, 0.1]}"))
        own = [sections(*solid, (0, Fraction(1, 10)), (1, 0)) for solid in (outer, *inner)]
        area = own[0][0] - own[1][0] - own[2][0]
        self.assertGreater(own[2][0], Fraction(1, 10))
        slack = Fraction(1, 10**7)  # points are multiples of 1e-9 m
        self.near(block["area_m2"], area, slack)
        for key, which in (("centroid_x_m", 1), ("centroid_y_m", 2)):
            moment = own[0][0] * own[0][which] - own[1][0] * own[1][which] - own[2][0] * own[2][which]
            self.near(block[key], moment / area, slack)

    def test_a_sweep_through_the_cavity(self):
        """Read again for each plane, with a hole where there is one: towards the left the tangent is x over y."""
        self.write("a.obj", obj(*together(box((0, 0, 0), (4, 4, 4)), box(("2.5", 1, 1), ("3.5", 2, 2)))))
        self.write("scene.yaml", self.scene("a.obj", "{at: [0, 0.5], azimuth_deg: 90}", rest="tilt: {towards: left}\n"))
        status, out, err = run("sweep", "--x", "section.at.2=0.5,1.5,2.5,1.25", "scene.yaml", folder=self.folder)
        self.assertEqual((status, err), (0, ""))
        told = [float(row["moments_deg"]) for row in csv.DictReader(io.StringIO(out))]
        with_cavity = math.degrees(math.atan2(16 * 2 - 3, 16 * 2 - 1.5))
        for value, truth in zip(told, (45, with_cavity, 45, with_cavity), strict=True):
            self.assertAlmostEqual(value, truth, delta=1e-9)

    def test_the_largest_keeps_its_cavities(self):
        mesh = together(box((0, 0, 0), (4, 4, 4)), box((1, 1, 1), (2, 2, 2)), box((9, 0, 0), (10, 4, 1)))
        self.write("a.obj", obj(*mesh))
        section = "{from: [0, 1.5], to: [1, 1.5]}"
        self.refuse(self.scene("a.obj", section), "scene.yaml:4:18", "the plane cuts 3 outlines where one is expected")
        solution = self.solve(self.scene("a.obj", section, ", take: largest"))
        self.near(solution["cases"][0]["block"]["area_m2"], Fraction(15))
        self.assertIn("of 2 outlines that the plane cuts the largest is taken", self.notes(solution))

    def test_beside_holes_of_the_scene(self):
        self.write("a.obj", obj(*together(box((0, 0, 0), (4, 4, 4)), box((1, 1, 1), (2, 2, 2)))))
        scene = self.scene("a.obj", "{from: [0, 1.5], to: [1, 1.5]}").replace(
            "unit_weight", "holes: [[[3, 3], [3.5, 3], [3.5, 3.5], [3, 3.5]]], unit_weight")
        self.near(self.block(scene)["area_m2"], Fraction(16) - 1 - Fraction(1, 4))

    def test_ground_with_a_cavity(self):
        """A profile is the upper side, and what lies below it does not matter."""
        self.write("a.obj", obj(*together(box((-5, 0, -4), (9, 4, 0)), box((1, 1, -3), (2, 2, -1)))))
        self.write("scene.yaml", "topple: 1\nlength_unit: m\nsection: {from: [0, 1.5], to: [1, 1.5]}\n"
                   "block: {outline: [[0, 0], [1, 0], [1, 2], [0, 2]]}\nbase: {profile: {mesh: a.obj}}\n")
        status, _, err = run("solve", "scene.yaml", folder=self.folder)
        self.assertEqual((status, err), (0, ""))

    def test_refused(self):
        section = "{from: [0, 1.5], to: [1, 1.5]}"
        loose = together(box((0, 0, 0), (4, 4, 4)), box((1, 1, 1), (3, 3, 3)), box(("1.2", "1.2", 1.25), (2, 2, 2)))
        self.write("a.obj", obj(*loose))
        self.refuse(self.scene("a.obj", section), "scene.yaml:4:18", "lies within a cavity of the solid, a loose piece")
        self.write("a.obj", obj(*together(box((1, 0, 1), (3, 4, 3)), box(("1.2", 1, "1.2"), (2, 2, 2)))))
        scene = ("topple: 1\nlength_unit: m\nsection: " + section + "\nblock: {outline: [[0, 0], [4, 0], [4, 4], [0, 4]], "
                 "holes: [{mesh: a.obj}]}\n")
        self.refuse(scene, "scene.yaml:4:60", "only the outline of the block may have holes")
        crossing = together(box((0, 0, 0), (4, 4, 4)), box((1, 1, -1), (2, 2, 2)))
        self.write("a.obj", obj(*crossing))
        self.write("scene.yaml", self.scene("a.obj", section))
        self.assertEqual(run("solve", "scene.yaml", folder=self.folder)[0], 3)


if __name__ == "__main__":
    main()
