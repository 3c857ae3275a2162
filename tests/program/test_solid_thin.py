#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A mesh that is thinned.

What is left is read out of the model that --figure writes. That no point of it is farther from the mesh than the length, nor of the mesh from
it, is found by the distances of points to all triangles; that volume, centroid, inertia and poses are those of the mesh, by solving that; that a
support is never more, by its corners. The thinned surface, written as a mesh by itself, passes the gate."""

import csv
import io
import json
import math
import random
import unittest
from fractions import Fraction

from harness import main, rounds, run
from mesh_case import box, octahedron, triangles
from test_solid_repair import cross, dot, minus, volume6
from test_solid_sheets import Model
from test_solids import exact_obj


def rough(seed, level=4, least=900, most=1100):
    """A ball of radius 1 whose points are moved along their rays by chance."""
    draw = random.Random(seed)
    points, faces = octahedron(level=level)
    rays = [Fraction(draw.randint(least, most), 1000) for _ in points]
    return [tuple(x * ray for x in p) for p, ray in zip(points, rays)], faces


def distance(p, corners):
    """Of a point from a triangle (in doubles): over the plane where its foot lies within, else from a side."""
    a, b, c = corners
    normal = cross(minus(b, a), minus(c, a))
    size = dot(normal, normal)
    if size > 0 and all(dot(cross(minus(r, q), minus(p, q)), normal) >= 0 for q, r in ((a, b), (b, c), (c, a))):
        return abs(dot(minus(p, a), normal)) / math.sqrt(size)
    least = math.inf
    for q, r in ((a, b), (b, c), (c, a)):
        way = minus(r, q)
        share = min(1, max(0, dot(minus(p, q), way) / dot(way, way)))
        off = minus(p, [x + share * y for x, y in zip(q, way)])
        least = min(least, math.sqrt(dot(off, off)))
    return least


class Thinned(Model):
    ROUNDING = 1e-6  # of a model's floats

    def both(self, points, faces, length, *words, name="rock.obj"):
        """As the mesh is, and thinned."""
        path = self.put(name, exact_obj(points, faces))
        told = []
        for own in ([], [f"--thin={length}"]):
            status, out, err = run("solid", "--json", "--unit=m", *words, *own, path)
            self.assertEqual(status, 0, err)
            told.append(json.loads(out))
        return told

    def surface(self, points, faces, length, got):
        """The points that are left, by their numbers in the mesh, and the triangles."""
        status, _, err = run("solid", "--unit=m", f"--thin={length}", "--figure", f"{self.folder}/rock.glb", self.put("rock.obj", exact_obj(points, faces)))
        self.assertEqual(status, 0, err)
        model, corners, _, _ = self.read(f"{self.folder}/rock.glb")[0]["rock"]
        low = min(p[2] for p in points)
        east, north, _ = (float(c["value"]) for c in got["centroid_m"])
        placed = [(x + east, north - z, y + float(low)) for x, y, z in model]
        numbers = []
        for p in placed:
            k = min(range(len(points)), key=lambda k: sum((float(x) - y) ** 2 for x, y in zip(points[k], p)))
            self.assertLess(max(abs(float(x) - y) for x, y in zip(points[k], p)), self.ROUNDING)
            numbers.append(k)
        return [tuple(numbers[c] for c in corners[k:k + 3]) for k in range(0, len(corners), 3)]

    def same(self, got, whole):
        """What is of the mesh: to the last digit."""
        for key in ("volume_m3", "centroid_m", "inertia_m5", "facets", "poses"):
            self.assertEqual(got[key], whole[key], key)

    def test_nowhere_farther(self):
        """Points of either surface, its corners and others by chance, from the other one; and what is left passes the gate by itself."""
        draw = random.Random(8)
        for seed in range(rounds(2, 40)):
            points, faces = rough(seed, level=3)
            length = draw.choice((0.25, 0.4))
            whole, got = self.both(points, faces, length)
            self.same(got, whole)
            record = got["thinning"]
            self.assertEqual((record["scan_triangles"], record["scan_vertices"], record["length"]), (len(faces), len(points), length))
            self.assertLessEqual(record["farthest"], length)
            left = self.surface(points, faces, length, whole)
            self.assertEqual((len(left), len({k for f in left for k in f})), (got["triangles"], got["vertices"]))
            self.assertLess(len(left), len(faces))
            near = [tuple(map(float, p)) for p in points]
            for ones, others in ((faces, left), (left, faces)):
                others = [[near[k] for k in f] for f in others]
                tried = [near[k] for k in {k for f in ones for k in f}]
                for f in draw.sample(ones, 20):
                    shares = [draw.random() for _ in range(3)]
                    tried.append(tuple(sum(s * near[k][axis] for s, k in zip(shares, f)) / sum(shares) for axis in range(3)))
                for p in tried:
                    self.assertLess(min(distance(p, f) for f in others), record["farthest"] * (1 + 1e-12))
            more = Fraction(volume6(points, left) - volume6(points, faces)) / 6
            self.holds_difference(record["volume_difference_m3"], more)
            used = sorted({k for f in left for k in f})
            alone = self.solve(exact_obj([points[k] for k in used], [tuple(used.index(k) for k in f) for f in left]))
            self.assertEqual(alone["facets"], whole["facets"])
            for own, other in zip(alone["bands"], got["bands"]):
                self.assertEqual((own["touching"], len(own["support"])), (other["touching"], len(other["support"])))

    def holds_difference(self, number, truth):
        self.assertLessEqual(abs(Fraction(number["value"]) - truth), Fraction(number["error"]))
        self.assertLess(number["error"], 1e-12)

    def test_a_support_is_never_more(self):
        """Its corners are points of the mesh within the band, so that it lies within; each of the mesh's own that is a length
        deeper in the band has one as near as that."""
        points, faces = rough(5)
        for length in (0.05, 0.1):
            whole, got = self.both(points, faces, length, "--band=0,0.1,0.2,0.3")
            for one, other in zip(whole["bands"], got["bands"]):
                self.assertLessEqual(other["touching"], one["touching"])
                if other["stands"]:
                    self.assertTrue(one["stands"])
                    self.assertLessEqual(other["least"]["tilt_deg"]["value"], one["least"]["tilt_deg"]["value"] + 1e-12)
            deeper = self.solve(exact_obj(points, faces), f"--band={0.3 - length}")["bands"][0]["support"]
            mine = got["bands"][3]["support"]
            for corner in deeper:
                self.assertLessEqual(self.outside(corner, mine), length * (1 + 1e-9))

    @staticmethod
    def outside(point, corners):
        """How far a point lies outside of a convex polygon, seen from above."""
        at, three = [point["east_m"], point["north_m"], 0], [[c["east_m"], c["north_m"], 0] for c in corners]
        return min(distance(at, (three[0], three[k], three[k + 1])) for k in range(1, len(three) - 1))

    def test_how_it_lies_changes_nothing(self):
        """Moved by 2^50 lengths, in feet, as another format has it: the same triangles are left."""
        points, faces = rough(6)
        _, got = self.both(points, faces, 0.125)
        for other in (self.both([tuple(x + 2 ** 50 for x in p) for p in points], faces, 0.125)[1],
                      self.both(points, faces, 0.125, "--unit=ft")[1]):
            self.assertEqual([other[key] for key in ("triangles", "vertices", "facets")], [got[key] for key in ("triangles", "vertices", "facets")])
            self.assertAlmostEqual(other["thinning"]["farthest"], got["thinning"]["farthest"], 12)

    def test_mirrored(self):
        """The poses are those of the mesh, so that they are mirrored too, whatever triangles are left."""
        points, faces = rough(7)
        _, one = self.both(points, faces, 0.1)
        _, other = self.both([(-x, y, z) for x, y, z in points], [f[::-1] for f in faces], 0.1)
        self.assertAlmostEqual(one["volume_m3"]["value"], other["volume_m3"]["value"], 13)
        self.assertEqual([round(p["share"]["value"], 12) for p in one["poses"]], [round(p["share"]["value"], 12) for p in other["poses"]])

    def test_all_on_the_hull(self):
        """Of a convex rock nothing can go but what lies within its facets."""
        whole, got = self.both(*octahedron(level=3), 0.3)
        self.assertEqual((got["triangles"], got["thinning"]["farthest"]), (whole["triangles"], 0))
        points, faces = self.flat_cube(8)
        whole, got = self.both(points, faces, 2)
        self.same(got, whole)
        self.assertEqual((got["vertices"], got["triangles"], got["thinning"]["hull_corners"]), (8, 12, 8))
        self.assertEqual(got["thinning"]["volume_difference_m3"]["value"], 0)

    @staticmethod
    def flat_cube(parts):
        """A unit cube of so many squares a side, of two triangles each."""
        index, faces = {}, []
        for axis in range(3):
            for side in (0, parts):
                for i in range(parts):
                    for j in range(parts):
                        ring = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
                        square = []
                        for u, v in ring if side else ring[::-1]:
                            at = [0, 0, 0]
                            at[axis], at[(axis + 1) % 3], at[(axis + 2) % 3] = side, u, v
                            square.append(index.setdefault(tuple(at), len(index)))
                        faces += triangles([tuple(square)])
        return [tuple(Fraction(x, parts) for x in p) for p in index], faces

    def test_a_plane_cuts_the_mesh(self):
        """Below a plane nothing depends on the thinning: it cuts the mesh itself."""
        points, faces = rough(9)
        whole, got = self.both(points, faces, 0.1, "--below=0.3")
        self.same(got, whole)
        self.assertEqual(got["bands"], whole["bands"])
        self.assertLess(got["triangles"], whole["triangles"])

    def test_points_that_stay(self):
        """A ball so rough that its spikes would pass through each other: points stay there, and it is no failure."""
        points, faces = rough(2, least=500, most=1500)
        whole, got = self.both(points, faces, 0.6)
        self.same(got, whole)
        self.assertGreater(got["thinning"]["left_points"], 0)
        self.assertIn("points are left where they are", json.dumps(got["notes"]))

    def test_scenes(self):
        """Of a scene, in its lengths; swept by band; on a sheet in Spanish and German; a caution for a band of less than the length."""
        points, faces = rough(3)
        self.put("rock.obj", exact_obj(points, faces))
        scene = self.put("rock.yaml", "topple: 1\nlength_unit: mm\nsolid: {file: rock.obj, unit: m, thin: 100, bands: [50, 300]}\n"
                         "friction_angle_deg: 30\ntilt: {angle_deg: 1, azimuth_deg: 20}\n")
        got = self.told(scene)
        _, same = self.both(points, faces, 0.1, "--band=0.05,0.3", "--friction=30")
        self.assertEqual((got["thinning"], got["triangles"]), (same["thinning"], same["triangles"]))
        self.assertEqual([b["support"] for b in got["bands"]], [b["support"] for b in same["bands"]])
        self.assertIn("in bands of less than 0.1, ", json.dumps(got["notes"]))
        status, out, err = run("sweep", "--x", "tilt.angle_deg=0,1", scene)
        self.assertEqual(status, 0, err)
        self.assertEqual(len(list(csv.DictReader(io.StringIO(out)))), 2)
        wider = self.put("wider.yaml", "topple: 1\nlength_unit: mm\nsolid: {file: rock.obj, unit: m, thin: 100, bands: [100]}\n"
                         "friction_angle_deg: 30\ntilt: {angle_deg: 1, azimuth_deg: 20}\n")
        status, out, err = run("sweep", "--x", "solid.thin=100,300,100", wider)  # each has a surface of its own
        self.assertEqual(status, 0, err)
        rows = list(csv.DictReader(io.StringIO(out)))
        for row in rows:
            alone = self.told(wider, "--set", f"solid.thin={row['solid.thin']}")
            self.assertEqual(float(row["fos"]), alone["bands"][0]["stance"]["fos"]["value"])
        self.assertEqual(rows[0], rows[2])
        self.assertNotEqual(rows[0]["fos"], rows[1]["fos"])
        for language, words in (("es", "malla adelgazada: "), ("de", "Netz ausgedünnt: ")):
            status, out, err = run("solve", "--report", f"{self.folder}/sheet.html", "--language", language, scene)
            self.assertEqual(status, 0, err)
            with open(f"{self.folder}/sheet.html", encoding="utf-8") as sheet:
                text = sheet.read()
            self.assertIn(words, text)
            self.assertNotIn("thinned:", text)

    def test_refused(self):
        points, faces = box((0, 0, 0), (1, 1, 1))
        path = self.put("rock.obj", exact_obj(points, triangles(faces)))
        for words, told in ((["--thin=0"], "above 0"), (["--thin=-1"], "0 or more"), (["--thin=a"], "'a'"), (["--thin"], "requires an argument")):
            status, out, err = run("solid", path, *words)
            self.assertEqual((status, out), (2, ""))
            self.assertIn(told, err)
        self.put("rock.obj", exact_obj(points, triangles(faces)[1:]))
        status, out, err = run("solid", "--thin=0.1", path)
        self.assertEqual((status, out), (3, ""))
        self.assertIn("the surface is open", err)
        status, out, err = run("solid", "--json", "--thin=0.1", "--repair", path)  # mended, then thinned
        self.assertEqual(status, 0, err)
        self.assertEqual((json.loads(out)["repair"]["gaps"][0]["triangles"], json.loads(out)["triangles"]), (1, 12))
        tall, faces = box((0, 0, 0), (1, 1, 4))
        pulled = [p if p[2] == 0 or p[:2] != (1, 1) else (Fraction(1, 8), Fraction(1, 8), Fraction(-1)) for p in tall]
        self.put("rock.obj", exact_obj(pulled, triangles(faces)))
        status, out, err = run("solid", "--thin=0.1", path)
        self.assertEqual((status, out), (3, ""))
        self.assertIn("the surface meets itself", err)
        hole = exact_obj(*box((Fraction(1, 4),) * 3, (Fraction(1, 2),) * 3))
        self.put("rock.obj", exact_obj(points, triangles(faces)))
        self.put("hole.obj", hole)
        self.wrong(self.put("a.yaml", "topple: 1\nlength_unit: m\nsolid: {file: rock.obj, unit: m, thin: 0.1, bands: 0, holes: [{file: hole.obj}]}\n"),
                   "a.yaml:3:", "is not thinned")
        self.wrong(self.put("b.yaml", "topple: 1\nlength_unit: m\nsolid: {file: rock.obj, unit: m, thin: 0, bands: 0}\n"), "b.yaml:3:", "thin")


del Model  # its own tests are run where it stands

if __name__ == "__main__":
    main()
