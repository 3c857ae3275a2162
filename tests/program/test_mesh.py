# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Outlines cut out of meshes.

The story: a surveyor hands in a scan, an engineer asks what stands on one upright section of it. The same solid must give
the same block from every format; its area must be that of the section by fractions that join no chains; a plane through
vertices, edges and corners must cut as cleanly as one between them; slices must add up to the volume."""

import csv
import io
import math
from fractions import Fraction

from harness import main, run
from mesh_case import MeshCase, binary_stl, box, obj, octahedron, ply, sections, stl, triangles, volume

BOULDER = octahedron(half=(1.5, 1, 0.75), centre=(Fraction(1, 4), Fraction(-1, 8), 3), level=3)


class Mesh(MeshCase):
    def near(self, number, exact, slack):
        """Within its own bound, and what rounding of the points allows."""
        self.assertLessEqual(abs(Fraction(number["value"]) - exact), Fraction(number["error"]) + Fraction(slack))

    def test_every_format_gives_the_same_block(self):
        files = {"a.stl": stl(*BOULDER), "b.STL": binary_stl(*BOULDER), "c.obj": obj(*BOULDER), "d.ply": ply(*BOULDER)}
        for k, (form, real, index) in enumerate((f, r, i) for f in ("binary_little_endian", "binary_big_endian")
                                                for r in ("float", "double") for i in ("int", "ushort")):
            files[f"e{k}.ply"] = ply(*BOULDER, form=form, real=real, index=index)
        told = []
        for name, content in files.items():
            self.write(name, content)
            told.append(self.solve(self.scene(name, "{at: [0.25, 0], azimuth_deg: 37}")))
            for case in told[-1]["cases"]:
                del case["effects"]
            told[-1]["notes"] = [note["text"] for note in told[-1]["notes"]]
        self.assertEqual(len(told), 12)
        for other in told[1:]:
            self.assertEqual(other, told[0])

    def test_a_unit_that_is_not_said(self):
        """No such file says its unit: taken for the scene's, which is a caution, unless the scene says it; a mesh in place of a scene
        has it from --unit."""
        solid = box((0, 0, 0), (2, 3, 1))
        solid = (solid[0], triangles(solid[1]))
        for name, content in (("a.stl", stl(*solid)), ("b.stl", binary_stl(*solid)), ("c.obj", obj(*solid)), ("d.ply", ply(*solid))):
            self.write(name, content)
            for more, area, cautions in (("", 2, 1), (", unit: m", 2, 0), (", unit: mm", Fraction(2, 10**6), 0)):
                scale = 1000 if "mm" in more else 1
                plane = f"{{from: [0, {Fraction(1, scale)}], to: [1, {Fraction(1, scale)}]}}"
                solution = self.solve(self.scene(name, plane, more))
                self.near(solution["cases"][0]["block"]["area_m2"], Fraction(area), 0)
                told = [note["text"] for note in solution["notes"] if note["kind"] == "caution" and "unit of its lengths" in note["text"]]
                self.assertEqual(len(told), cautions, (name, more))
            status, out, err = run("solve", "--json", self.folder / name, "--unit", "m", "--set", "section.at.1=0", "--set", "section.at.2=1",
                                   "--set", "section.azimuth_deg=90")
            self.assertEqual((status, err), (0, ""))
            self.assertNotIn("unit of its lengths", out)

    def test_lines_of_windows_names_with_blanks_and_long_numbers(self):
        points, faces = box((0, 0, 0), (2, 3, 1))
        self.write("a.obj", obj(points, faces, "the block").replace("\n", "\r\n").replace("2.0", "2.000000000000000000"))
        block = self.block(self.scene("a.obj", "{from: [0, 1], to: [1, 1]}", ", object: the block"))
        self.near(block["area_m2"], Fraction(2), 0)

    def test_a_box_keeps_its_corners(self):
        """Four points, exact, though a plane crosses ten edges of its triangles."""
        points, faces = box((0, 0, 0), ("1.3", "2", "0.7"))
        self.write("a.stl", stl(points, triangles(faces)))
        solution = self.solve(self.scene("a.stl", "{from: [0, 1], to: [5, 1]}"))
        self.assertEqual(solution["notes"][0]["text"],
                         "the section of this mesh has 4 points, 1.3 wide and 0.7 m high, all of them exact")
        self.near(solution["cases"][0]["block"]["area_m2"], Fraction("0.91"), 0)

    def test_tetrahedron_by_its_closed_form(self):
        """Across the axis at a share t of its height from the tip the section is t squared of that of its foot."""
        points = [tuple(map(Fraction, p)) for p in ((0, 0, 0), (0, 0, 3), (0, 2, 0), (6, 0, 0))]
        self.write("a.obj", obj(points, [(0, 1, 2), (0, 3, 1), (1, 3, 2), (0, 2, 3)]))
        for x in ("0.5", "2", "3.75", "5.5"):
            block = self.block(self.scene("a.obj", f"{{from: [{x}, 0], to: [{x}, 1]}}"))
            self.near(block["area_m2"], 3 * ((6 - Fraction(x)) / 6) ** 2, 0 if x == "3" else 4e-8)

    def test_area_and_centroid_in_fractions(self):
        """Planes through vertices and edges of the mesh among them: their sum of vectors is exact."""
        self.write("a.obj", obj(*BOULDER))
        x, y = Fraction(1, 4), Fraction(-1, 8)
        cases = [((x, y), (1, 0)), ((x, y), (0, 1)), ((x, y), (0, -1)), ((x, y), (-1, 0)),
                 ((x, y + Fraction(1, 3)), (Fraction(3, 5), Fraction(4, 5))), ((x, y), (Fraction(-5, 13), Fraction(12, 13))),
                 (BOULDER[0][20][:2], (Fraction(8, 17), Fraction(-15, 17)))]
        for origin, direction in cases:
            with self.subTest(origin=origin, direction=direction):
                to = [o + d for o, d in zip(origin, direction)]
                line = "{{from: [{}, {}], to: [{}, {}]}}".format(*origin, *to)
                block = self.block(self.scene("a.obj", line))
                area, s, z = sections(*BOULDER, origin, direction)
                self.near(block["area_m2"], area, 1e-8)  # 5e-10 at each point of a perimeter of 8 m
                self.near(block["centroid_x_m"], s, 1e-8)
                self.near(block["centroid_y_m"], z, 1e-8)

    def test_azimuth_is_a_bearing(self):
        """Clockwise from y; the section seen from its right side has s to the right. An ellipsoid's is an ellipse."""
        half = (1.5, 1, 0.75)
        self.write("a.obj", obj(*octahedron(half=half, level=5)))
        for azimuth in (0, 30, 90, 123.25, 180, 270, -45, 360):
            turn = math.radians(azimuth)
            width = 1 / math.hypot(math.sin(turn) / half[0], math.cos(turn) / half[1])
            block = self.block(self.scene("a.obj", f"{{at: [0, 0], azimuth_deg: {azimuth}}}"))
            true = math.pi * width * half[2]
            self.assertLess(abs(block["area_m2"]["value"] / true - 1), 0.002)  # chords of 3 degrees: 0.0018 at most
            self.assertLess(block["area_m2"]["value"], true * 1.001)
        shifted = octahedron(half=half, centre=(4, 0, 2), level=2)
        self.write("b.obj", obj(*shifted))
        block = self.block(self.scene("b.obj", "{at: [0, 0], azimuth_deg: 90}"))
        self.assertAlmostEqual(block["centroid_x_m"]["value"], 4, 6)
        block = self.block(self.scene("b.obj", "{at: [0, 0], azimuth_deg: -90}"))
        self.assertAlmostEqual(block["centroid_x_m"]["value"], -4, 6)

    def test_slices_add_up_to_the_volume(self):
        """Between two neighbouring vertices the area is a quadratic of the offset, so Simpson's rule is exact."""
        points, faces = octahedron(half=(1.5, 1, 0.75), centre=(0, 5, 3), level=1)
        self.write("a.obj", obj(points, faces))
        self.write("scene.yaml", self.scene("a.obj", "{at: [0, 5], azimuth_deg: 90}"))
        levels = sorted({p[1] for p in points})
        total = Fraction(0)
        area = {}
        for low, high in zip(levels, levels[1:]):
            for y in (low + (high - low) / 4, (low + high) / 2, high - (high - low) / 4):
                own = self.block((self.folder / "scene.yaml").read_text(), "--set", f"section.at.2={y}")["area_m2"]
                area[y] = Fraction(own["value"])
            a, b, c = (area[y] for y in (low + (high - low) / 4, (low + high) / 2, high - (high - low) / 4))
            total += (high - low) * (2 * a - b + 2 * c) / 3  # exact for cubics, and its points lie within
        self.assertLess(abs(total - volume(points, faces)), 1e-7)

    def test_unit_of_the_mesh_and_height_along_y(self):
        points, faces = octahedron(half=(1500, 1000, 750), centre=(0, 0, 1000), level=2)
        turned = [(p[0], p[2], -p[1]) for p in points]
        self.write("a.obj", obj(points, faces))
        self.write("b.obj", obj(turned, faces))
        wanted = self.block(self.scene("a.obj", "{from: [0, 0.125], to: [1, 0.125]}", ", unit: mm"))
        own = self.block(self.scene("b.obj", "{from: [0, 0.125], to: [1, 0.125], up: y}", ", unit: mm"))
        self.assertEqual(own, wanted)
        area, _, _ = sections(points, faces, (0, 125), (1, 0))
        self.near(wanted["area_m2"], area / 10 ** 6, 1e-8)

    def test_objects_of_one_file(self):
        """Block and ground out of one file; ground is a surface with an edge, or a solid whose upper side counts."""
        top, faces = box((0, 0, 2), (2, 2, 5))
        ground, ground_faces = box((-3, -3, 0), (6, 6, 2))
        surface = [(-3, -3, 2), (6, -3, 2), (6, 6, 2), (-3, 6, 2)]
        both = obj(top, faces, "boulder") + obj(ground, [[k + 8 for k in f] for f in ground_faces], "solid ground")
        both += obj(surface, [(16, 17, 18, 19)], "surface")
        self.write("a.obj", both)
        told = []
        for name in ("solid ground", "surface"):
            scene = self.scene("a.obj", "{from: [0, 1], to: [1, 1]}", ", object: boulder",
                               rest=f"base: {{profile: {{mesh: a.obj, object: {name}}}}}\nfriction_angle_deg: 30\n")
            told.append(self.solve(scene)["cases"])
            for case in told[-1]:
                del case["effects"]
        self.assertEqual(told[0], told[1])
        self.assertAlmostEqual(told[0][0]["toppling"]["critical_angle_deg"]["value"], math.degrees(math.atan2(2, 3)), 12)

    def test_flipped_and_degenerate_faces_are_told(self):
        points, faces = box((0, 0, 0), (2, 3, 1))
        own = triangles(faces)
        self.write("a.obj", obj(points, [own[0][::-1]] + own[1:] + [(0, 0, 1)]))
        solution = self.solve(self.scene("a.obj", "{from: [0, 1], to: [1, 1]}"))
        notes = [note["text"] for note in solution["notes"]]
        self.assertIn("faces without three different corners are left out, 1 in all, the first of them face 13", notes)
        self.assertIn("in 2 of the edges that the plane cuts a face runs against its neighbour; the section is the same as if it "
                      "did not", notes)
        self.near(solution["cases"][0]["block"]["area_m2"], Fraction(2), 0)

    def test_a_hole_is_closed_where_that_is_asked_for(self):
        points, faces = octahedron(level=2)
        plane = "{from: [0, 0.01], to: [1, 0.01]}"
        gone = next(k for k, f in enumerate(faces) if min(points[p][1] for p in f) < 0.01 < max(points[p][1] for p in f)
                    and sum(points[p][2] for p in f) > 2)
        self.write("a.obj", obj(points, faces[:gone] + faces[gone + 1:]))
        solution = self.solve(self.scene("a.obj", plane, ", gap: 0.5"))
        notes = " ".join(note["text"] for note in solution["notes"])
        self.assertIn("; 1 gap was closed, the widest of ", notes)
        area, _, _ = sections(points, faces, (0, Fraction(1, 100)), (1, 0))
        self.near(solution["cases"][0]["block"]["area_m2"], area, 1e-8)  # the face was flat: its chord is its section

    def test_the_largest_of_several(self):
        points, faces = box((0, 0, 0), (2, 3, 1))
        scrap, more = box(("2.5", "0.5", "0.5"), ("2.75", 2, "0.75"))
        self.write("a.obj", obj(points + scrap, list(faces) + [[k + 8 for k in f] for f in more]))
        solution = self.solve(self.scene("a.obj", "{from: [0, 1], to: [1, 1]}", ", take: largest"))
        self.near(solution["cases"][0]["block"]["area_m2"], Fraction(2), 0)
        self.assertIn("caution", [note["kind"] for note in solution["notes"] if "largest is taken" in note["text"]])

    def test_a_sweep_turns_the_plane(self):
        """A mesh is read once and cut again at each azimuth, as by a scene that says it."""
        self.write("a.obj", obj(*BOULDER))
        self.write("scene.yaml", self.scene("a.obj", "{at: [0.25, -0.125], azimuth_deg: 0}"))
        status, out, err = run("sweep", "scene.yaml", "--x=section.azimuth_deg=0:90:30", folder=self.folder)
        self.assertEqual((status, err), (0, ""))
        rows = [row for row in csv.DictReader(io.StringIO(out)) if row["towards"] == "left"]
        self.assertEqual(len(rows), 4)
        scene = (self.folder / "scene.yaml").read_text()
        for row, azimuth in zip(rows, (0, 30, 60, 90)):
            case = self.solve(scene.replace("azimuth_deg: 0", f"azimuth_deg: {azimuth}"))["cases"][0]
            self.assertEqual(float(row["moments_deg"]), case["toppling"]["critical_angle_deg"]["value"])
        self.assertEqual(len({row["moments_deg"] for row in rows}), 4)


if __name__ == "__main__":
    main()
