#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Convex hulls of solids with points on their edges and in their faces, as CAD files have them.

Of 120 prisms with rows of points on their upright edges, 82 had poses that were wrong at exit status 0, and 7 crashed or were
refused: the hull was taken as a library returned it. Each solid is compared here with the same solid without these points, with
closed forms, or with facets that are found by wrapping in whole numbers, which themselves are compared with all planes through
three points."""

import json
import math
import pathlib
import random
import struct
import tempfile
import unittest
from fractions import Fraction

from harness import ROOT, main, rounds, run
from mesh_case import binary_stl, triangles
from solid_oracle import Oracle, Wrapped, wrapped
from test_solids import exact_obj

DATA = ROOT / "tests" / "data" / "defects3" / "solids"


# ---- solids: whole coordinates, faces counter-clockwise seen from outside ------------------------------------------------------

def mapped(points, draw):
    """By a linear map of whole numbers that keeps the orientation: what is on one line or plane stays so."""
    while True:
        rows = [[draw.randint(-3, 3) for _ in range(3)] for _ in range(3)]
        (a, b, c), (d, e, f), (g, h, i) = rows
        if a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g) > 0:
            return [tuple(sum(m * x for m, x in zip(row, p)) for row in rows) for p in points]


def ring(sides, radius, turn):
    """A convex polygon about the origin: multiples of 60, whose halves to sixths are whole."""
    return [tuple(60 * round(radius * f(turn + 2 * math.pi * k / sides)) for f in (math.cos, math.sin)) for k in range(sides)]


class Mesh:
    def __init__(self):
        self.places, self.faces = {}, []

    def point(self, at):
        return self.places.setdefault(tuple(at), len(self.places))

    def triangle(self, *corners):
        self.faces.append(tuple(self.point(p) for p in corners))

    def quad(self, a, b, c, d):
        self.triangle(a, b, c)
        self.triangle(a, c, d)

    def done(self):
        return list(self.places), self.faces


def prism(base, height, rows, columns, has_middles):
    """Upright over a polygon, with points that part each upright edge into `rows` and each other one into `columns`, in the faces as
    well; `has_middles`: with a point in the middle of each end."""
    mesh, sides = Mesh(), len(base)
    border = [tuple(a[i] + (b[i] - a[i]) * k // columns for i in range(2))
              for a, b in zip(base, base[1:] + base[:1]) for k in range(columns)]
    for k, (a, b) in enumerate(zip(border, border[1:] + border[:1])):
        for row in range(rows):
            low, high = height * row // rows, height * (row + 1) // rows
            mesh.quad((*a, low), (*b, low), (*b, high), (*a, high))
        if has_middles or columns > 1:
            mesh.triangle((0, 0, 0), (*b, 0), (*a, 0))
            mesh.triangle((0, 0, height), (*a, height), (*b, height))
        elif 0 < k < sides - 1:
            mesh.triangle((*base[0], 0), (*b, 0), (*a, 0))
            mesh.triangle((*base[0], height), (*a, height), (*b, height))
    return mesh.done()


def tube(outer, inner, height, rows):
    mesh = Mesh()
    for a, b, c, d in zip(outer, outer[1:] + outer[:1], inner, inner[1:] + inner[:1]):
        for row in range(rows):
            low, high = height * row // rows, height * (row + 1) // rows
            mesh.quad((*a, low), (*b, low), (*b, high), (*a, high))
            mesh.quad((*d, low), (*c, low), (*c, high), (*d, high))
        mesh.quad((*b, 0), (*a, 0), (*c, 0), (*d, 0))
        mesh.quad((*a, height), (*b, height), (*d, height), (*c, height))
    return mesh.done()


def stairs(heights):
    """Cubes in a grid: a number of them on each square, nowhere more than before it in either direction."""
    mesh, size = Mesh(), len(heights)

    def tall(x, y):
        return heights[x][y] if 0 <= x < size and 0 <= y < size else 0
    for x in range(size):
        for y in range(size):
            for z in range(tall(x, y)):
                corner = {(i, j, k): (60 * (x + i), 60 * (y + j), 60 * (z + k)) for i in (0, 1) for j in (0, 1) for k in (0, 1)}
                for out, four in (((1, 0, 0), ((1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1))),
                                  ((-1, 0, 0), ((0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0))),
                                  ((0, 1, 0), ((0, 1, 0), (0, 1, 1), (1, 1, 1), (1, 1, 0))),
                                  ((0, -1, 0), ((0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1))),
                                  ((0, 0, 1), ((0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))),
                                  ((0, 0, -1), ((0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0)))):
                    if not 0 <= z + out[2] < tall(x + out[0], y + out[1]):
                        mesh.quad(*(corner[c] for c in four))
    return mesh.done()


def drawn_stairs(draw, size):
    heights = [[draw.randint(1, size) for _ in range(size)] for _ in range(size)]
    for x in range(size):
        for y in range(size):
            heights[x][y] = min([heights[x][y]] + [heights[x - 1][y]] * (x > 0) + [heights[x][y - 1]] * (y > 0))
    return heights


def singles(points, draw):
    """Turned any way and rounded to 24 bits each, as an STL has them; exact."""
    a, b, c, d = (draw.gauss(0, 1) for _ in range(4))
    n = math.sqrt(a * a + b * b + c * c + d * d)
    a, b, c, d = a / n, b / n, c / n, d / n
    turn = ((1 - 2 * (c * c + d * d), 2 * (b * c - a * d), 2 * (b * d + a * c)),
            (2 * (b * c + a * d), 1 - 2 * (b * b + d * d), 2 * (c * d - a * b)),
            (2 * (b * d - a * c), 2 * (c * d + a * b), 1 - 2 * (b * b + c * c)))
    scale = draw.choice((0.001, 0.0254, 1 / 60, 1.7))
    return [tuple(Fraction(struct.unpack("f", struct.pack("f", scale * sum(t * x for t, x in zip(row, p))))[0]) for row in turn)
            for p in points]


# ---- tests ---------------------------------------------------------------------------------------------------------------------

class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def solve(self, content, *words, name="rock.obj"):
        path = self.folder / name
        path.write_bytes(content.encode() if isinstance(content, str) else content)
        return self.solve_file(path, *words)

    def solve_file(self, path, *words):
        status, out, err = run("solid", "--json", "--unit=m", "--azimuths=3", *words, path)
        self.assertEqual((status, err), (0, ""), path)
        got = json.loads(out)
        self.assertTrue(all(0 < pose["share"]["value"] < 1 and 0 < pose["least"]["tilt_deg"]["value"] < 90 for pose in got["poses"]))
        self.assertAlmostEqual(sum(pose["share"]["value"] for pose in got["poses"]), 1, 12)
        return got

    def near(self, one, other, what):
        """Two bounds of one number meet."""
        self.assertLessEqual(abs(one["value"] - other["value"]), one["error"] + other["error"] + 1e-15 * abs(one["value"]), what)

    def same(self, one, other):
        """The same poses of two files, by their direction down."""
        self.assertEqual((one["facets"], len(one["poses"])), (other["facets"], len(other["poses"])))
        for pose in one["poses"]:
            twin = max(other["poses"], key=lambda p: sum(a * b for a, b in zip(p["down"], pose["down"])))
            for a, b in zip(twin["down"], pose["down"]):
                self.assertAlmostEqual(a, b, 12)
            for key in ("share", "facet_share", "height_m"):
                self.near(pose[key], twin[key], key)
            self.near(pose["least"]["tilt_deg"], twin["least"]["tilt_deg"], "tilt")
            self.assertEqual(pose["corners"], twin["corners"])
        lasting = [sorted((p["persistence_m"] for p in g["poses"] if "persistence_m" in p), key=lambda p: p["value"]) for g in (one, other)]
        self.assertEqual(len(lasting[0]), len(lasting[1]))
        for a, b in zip(*lasting):
            self.near(a, b, "persistence")

    def agrees(self, got, oracle, scale=1):
        """With facets found in whole numbers, each `scale` lengths."""
        poses = oracle.poses()
        self.assertEqual((got["facets"], len(got["poses"])), (len(oracle.facets), len(poses)))
        for pose in got["poses"]:
            tilt = pose["least"]["tilt_deg"]
            # the normals of facets that rounding has split are the same to these digits, their shares and tilts are not
            alike = [p for p in poses if sum(a * b for a, b in zip(p[0], pose["down"])) > 1 - 1e-12]
            self.assertTrue(alike, pose["down"])
            _, share, tan2 = min(alike, key=lambda p: abs(math.degrees(math.atan(math.sqrt(p[2]))) - tilt["value"])
                                 + abs(p[1] - pose["share"]["value"]))
            self.assertAlmostEqual(pose["share"]["value"], share, 9)
            self.assertAlmostEqual(tilt["value"], math.degrees(math.atan(math.sqrt(tan2))), delta=tilt["error"] + 1e-12)
        rises = sorted((pose["persistence_m"]["value"], pose["persistence_m"]["error"]) for pose in got["poses"] if "persistence_m" in pose)
        for (rise, error), truth in zip(rises, sorted(float(r * scale) for r in oracle.persistences())):
            self.assertAlmostEqual(rise, truth, delta=1e-9 * max(1, truth) + error)  # of solids of 1e4, differences of their heights


class Listed(Case):
    """The files that were found."""

    def test_regular_prisms(self):
        """The share of a side is the solid angle of a rectangle seen from over its middle."""
        for name, sides, height in (("prism5_plain", 5, 2.5), ("prism5_rows_wrong", 5, 2.5), ("prism3_rows_crash", 3, 2.5),
                                    ("prism3_rows_free", 3, None)):
            with self.subTest(name):
                lines = (DATA / f"{name}.obj").read_text(encoding="utf-8").splitlines()
                points = [tuple(map(float, line.split()[1:])) for line in lines if line.startswith("v ")]
                height = max(p[2] for p in points)
                radius = max(math.hypot(*p[:2]) for p in points)
                wide, away = 2 * radius * math.sin(math.pi / sides), radius * math.cos(math.pi / sides)
                side = math.atan(wide * height / (2 * away * math.sqrt(4 * away ** 2 + wide ** 2 + height ** 2))) / math.pi
                end = (1 - sides * side) / 2
                got = self.solve_file(DATA / f"{name}.obj")
                self.assertEqual(got["facets"], sides + 2)
                shares = [pose["share"]["value"] for pose in got["poses"]]
                for share, truth in zip(shares, sorted([side] * sides + [end, end], reverse=True), strict=True):
                    self.assertAlmostEqual(share, truth, 7)
                if name.startswith("prism5"):
                    self.assertEqual([round(s, 6) for s in shares], [0.164265] * 5 + [0.089337] * 2)
                if name == "prism3_rows_crash":
                    self.assertEqual([round(s, 6) for s in shares], [0.297344] * 3 + [0.053984] * 2)
        self.same(self.solve_file(DATA / "prism5_rows_wrong.obj"), self.solve_file(DATA / "prism5_plain.obj"))

    def test_tube_and_round(self):
        """Facets, shares and tilts of the very points of the files."""
        lines = [line.split() for line in (DATA / "tube.obj").read_text(encoding="utf-8").splitlines()]
        points = [tuple(map(Fraction, words[1:4])) for words in lines if words[:1] == ["v"]]
        faces = [tuple(int(w.split("/")[0]) - 1 for w in words[1:]) for words in lines if words[:1] == ["f"]]
        self.compare(DATA / "tube.obj", points, faces)
        data = (DATA / "round.stl").read_bytes()
        places, faces = {}, []
        for k in range(struct.unpack_from("<I", data, 80)[0]):
            values = [Fraction(x) for x in struct.unpack_from("<9f", data, 96 + 50 * k)]
            faces.append(tuple(places.setdefault(tuple(values[i:i + 3]), len(places)) for i in (0, 3, 6)))
        self.compare(DATA / "round.stl", list(places), faces)

    def compare(self, path, points, faces):
        unit = math.lcm(*(x.denominator for p in points for x in p))
        places = {}
        joined = [tuple(places.setdefault(tuple(int(x * unit) for x in points[k]), len(places)) for k in f) for f in faces]
        self.agrees(self.solve_file(path), Wrapped(list(places), triangles(joined)), Fraction(1, unit))

    def test_nothing_crashes(self):
        """What is refused is refused by a message, also by the repair that it offers."""
        for name in ("idler_riser.STL", "stl_trailing_bytes.stl"):
            for words in ((), ("--repair",), ("--repair", "--merge-within=0.000001"), ("--thin=0.01",), ("--below=0.01",)):
                status, out, err = run("solid", "--json", "--unit=m", *words, DATA / name)
                self.assertIn(status, (0, 3), err)
                self.assertEqual(status == 0, bool(out), err)


class WithoutThesePoints(Case):
    """The same solid with points on its edges and in its faces, and without them."""

    def test_prisms(self):
        draw = random.Random(120)
        for number in range(rounds(120, 10000)):
            sides, rows, columns = draw.randint(3, 5), draw.randint(2, 6), draw.choice((1, 1, 2, 3))
            base = ring(sides, draw.uniform(200, 999), draw.uniform(0, 7))
            height = 60 * draw.randint(100, 3000)
            plain = prism(base, height, 1, 1, False)
            rich = prism(base, height, rows, columns, draw.random() < 0.5)
            seed = draw.random()
            scale = draw.choice((1, 1024, 10 ** 5, 3 * 10 ** 4 // 3))
            plain, rich = [([tuple(Fraction(x, scale) for x in p) for p in mapped(points, random.Random(seed))], faces)
                           for points, faces in (plain, rich)]
            with self.subTest(number=number, sides=sides, rows=rows, columns=columns):
                one, other = self.solve(exact_obj(*plain)), self.solve(exact_obj(*rich))
                self.same(other, one)
                self.assertEqual(one["facets"], sides + 2)

    def test_cylinders_and_tubes(self):
        """Coordinates of single precision: upright edges stay upright."""
        draw = random.Random(121)
        for number in range(rounds(8, 1000)):
            sides, rows = draw.randint(6, 40), draw.randint(2, 5)
            outer = ring(sides, 900, draw.uniform(0, 7))
            inner = [tuple(x // 2 for x in p) for p in outer]
            height = 60 * draw.randint(100, 3000)
            make = (lambda r: tube(outer, inner, height, r)) if number % 2 else (lambda r: prism(outer, height, r, 1, r > 1))
            scale = draw.choice((1, 7, 1000))
            solids = [([tuple(struct.unpack("f", struct.pack("f", x / scale))[0] for x in p) for p in points], faces)
                      for points, faces in (make(1), make(rows))]
            with self.subTest(number=number, sides=sides, rows=rows):
                one, other = (self.solve(binary_stl(*solid), name="rock.stl") for solid in solids)
                self.same(other, one)

    def test_cut_and_thinned(self):
        """What a plane has cut off, and what is left of a mesh that is thinned: they have hulls as well."""
        draw = random.Random(122)
        for number in range(rounds(4, 300)):
            base, height = ring(draw.randint(3, 5), 900, draw.uniform(0, 7)), 60 * draw.randint(600, 3000)
            plain, rich = prism(base, height, 1, 1, False), prism(base, height, 4, 2, True)
            with self.subTest(number=number):
                one = self.solve(exact_obj(*plain))
                self.same(self.solve(exact_obj(*rich), "--thin=30"), one)
                self.same(self.solve(exact_obj(*rich), "--thin=0.001"), one)
                seed = draw.random()
                low = (Fraction(1, 3), Fraction(2, 7))[number % 2] * height  # the second cuts between rows
                plain, rich = ((mapped(points, random.Random(seed)), faces) for points, faces in (plain, rich))
                lowest, highest = min(p[2] for p in plain[0]), max(p[2] for p in plain[0])
                low = Fraction(highest - lowest, 3)
                self.same(*(self.solve(exact_obj(*solid), f"--below={float(low)!r}") for solid in (rich, plain)))


class InWholeNumbers(Case):
    """Against facets of the very points of the file, found by wrapping in whole numbers."""

    def test_wrapping(self):
        """It finds all planes through three points that have none beyond, with the points on each."""
        draw = random.Random(123)
        for _ in range(rounds(30, 1000)):
            points = list({tuple(draw.randint(0, 3) for _ in range(3)) for _ in range(14)})
            brute = Oracle(points, []).facets
            if len(brute) > 3:
                self.assertEqual(set(wrapped(points)), set(brute))

    def test_cubes_in_grids(self):
        draw = random.Random(124)
        for number in range(rounds(6, 600)):
            points, faces = stairs(drawn_stairs(draw, draw.randint(1, 4)))
            if number % 2:
                points = mapped(points, draw)
            with self.subTest(number=number):
                self.agrees(self.solve(exact_obj(points, faces)), Wrapped(points, faces))

    def rounded_part(self, draw, number):
        """Any of four kinds, turned any way and rounded to single precision."""
        base, height = ring(draw.randint(3, 9), draw.uniform(200, 999), draw.uniform(0, 7)), 60 * draw.randint(100, 3000)
        points, faces = (lambda: stairs(drawn_stairs(draw, 2)),
                         lambda: prism(base, height, draw.randint(2, 4), draw.randint(1, 2), True),
                         lambda: prism(base, height, 3, 1, False),
                         lambda: tube(base, [tuple(x // 2 for x in p) for p in base], height, 2))[number % 4]()
        return singles(points, draw), faces

    def test_sliver_between_two_edges(self):
        """The foot is as far beyond two edges of a sliver but for the 16th digit: the facet rolled over the first of them, and its share of 3e-9
        went to the wrong one of two poses whose heights differ by 1e-15."""
        draw = random.Random(125)
        for number in range(77):
            points, faces = self.rounded_part(draw, number)
        unit = math.lcm(*(x.denominator for p in points for x in p))
        (self.folder / "rock.stl").write_bytes(binary_stl(points, faces))
        oracle = Wrapped([tuple(int(x * unit) for x in p) for p in points], faces)
        self.agrees(self.solve_file(self.folder / "rock.stl"), oracle, Fraction(1, unit))

    def test_rounded_parts(self):
        """Stairs, prisms with rows, cylinders and tubes, turned any way and rounded to single precision as CAD programs write
        them: points that were in one face are off it by some last digits, and the hull has slivers."""
        draw = random.Random(125)
        refused, count = 0, rounds(16, 1600)
        for number in range(count):
            points, faces = self.rounded_part(draw, number)
            unit = math.lcm(*(x.denominator for p in points for x in p))
            with self.subTest(number=number):
                (self.folder / "rock.stl").write_bytes(binary_stl(points, faces))
                status, _, err = run("solid", "--unit=m", self.folder / "rock.stl")
                self.assertIn(status, (0, 3), err)
                refused += status == 3  # rounding can make triangles meet
                if status == 0:
                    oracle = Wrapped([tuple(int(x * unit) for x in p) for p in points], faces)
                    self.agrees(self.solve_file(self.folder / "rock.stl"), oracle, Fraction(1, unit))
        self.assertLess(refused, count / 4)


if __name__ == "__main__":
    main()
