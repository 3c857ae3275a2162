#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Solids: moments, poses and tilts of a mesh.

The oracle knows no quickhull and no signed filters: facets of the hull are the planes through three points that have no
point beyond, the foot of the centroid and every choice are fractions, and a tilt is known by its rational tan²."""

import json
import math
import random
import struct
import unittest
from fractions import Fraction

from harness import main, rounds, run
from mesh_case import box, obj, octahedron, triangles
from solid_oracle import Oracle, ball, minus


def written(points):
    """Coordinates as decimals with all their digits."""
    def decimal(x):
        x = Fraction(x)
        places = 0
        while (x * 10 ** places).denominator != 1:
            places += 1
        digits = str(abs(int(x * 10 ** places))).rjust(places + 1, "0")
        return ("-" if x < 0 else "") + (f"{digits[:-places]}.{digits[-places:]}" if places else digits)
    return ["v " + " ".join(decimal(x) for x in p) + "\n" for p in points]


def exact_obj(points, faces):
    return "".join(written(points)) + "".join("f " + " ".join(str(k + 1) for k in f) + "\n" for f in faces)


def stl(points, faces):
    """Binary."""
    records = b"".join(struct.pack("<12fH", 0, 0, 0, *(float(x) for k in f for x in points[k]), 0) for f in triangles(faces))
    return bytes(80) + struct.pack("<I", len(triangles(faces))) + records


def ply(points, faces):
    """Binary, of doubles, with the greater end first."""
    head = (f"ply\nformat binary_big_endian 1.0\nelement vertex {len(points)}\nproperty double x\nproperty double y\n"
            f"property double z\nelement face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
    return (head.encode() + b"".join(struct.pack(">3d", *map(float, p)) for p in points)
            + b"".join(struct.pack(f">B{len(f)}i", len(f), *f) for f in faces))


FRUSTUM = [(-1, -1, 0), (1, -1, 0), (-1, 1, 0), (1, 1, 0)] + [(Fraction(x, 2), Fraction(y, 2), 2) for y in (-1, 1) for x in (-1, 1)]
SIX = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)]
PRISM = ([(0, 0, 0), (3, 0, 0), (0, 4, 0), (0, 0, 6), (3, 0, 6), (0, 4, 6)], [(0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)])


class Case(unittest.TestCase):
    def setUp(self):
        import tempfile
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def put(self, name, content):
        path = f"{self.folder}/{name}"
        with open(path, "wb") as out:
            out.write(content.encode() if isinstance(content, str) else content)
        return path

    def solve(self, content, *words, name="rock.obj"):
        status, out, err = run("solid", "--json", "--unit=m", self.put(name, content), *words)
        self.assertEqual(status, 0, err)
        return json.loads(out)

    def refused(self, content, *told, name="rock.obj"):
        status, out, err = run("solid", "--unit=m", self.put(name, content))
        self.assertEqual((status, out), (3, ""), err)
        for words in told:
            self.assertIn(words, err)

    def holds(self, number, truth):
        """A fraction lies within the bound."""
        self.assertLessEqual(abs(Fraction(number["value"]) - truth), Fraction(number["error"]))
        self.assertLess(number["error"], 1e-9 * max(1, abs(number["value"])))

    def is_angle(self, number, tan2):
        """tan² of a rational, by the C library's arctangent to some roundings."""
        truth = math.degrees(math.atan(math.sqrt(tan2)))
        self.assertLessEqual(abs(number["value"] - truth), number["error"] + 1e-15 * 100)


class References(Case):
    def test_known_solids(self):
        for points, faces, volume, height, shares, tan2 in (
                (*box((0, 0, 0), (1, 2, 3)), 6, Fraction(3, 2), (0.322511, 0.121364, 0.056126), Fraction(1, 9)),
                (FRUSTUM, SIX, Fraction(14, 3), Fraction(11, 14), (), Fraction(196, 121)),
                (*PRISM, 36, 3, (), Fraction(16, 225))):
            with self.subTest(volume=volume):
                got = self.solve(exact_obj(points, faces), "--unit-weight=26", "--friction=20", "--band=0")
                self.holds(got["volume_m3"], volume)
                self.holds(got["weight_n"], 26000 * volume)
                self.holds(got["centroid_m"][2], height)
                (band,) = got["bands"]
                self.is_angle(band["least"]["tilt_deg"], tan2)
                self.assertEqual(band["mechanism"], "slides" if tan2 > Fraction(1, 7) else "topples")
                for share in shares:
                    self.assertEqual(sum(round(p["share"]["value"], 6) == share for p in got["poses"]), 2)

    def test_capped_sphere(self):
        """A ball of radius 1, cut flat at -0.95: the error of a mesh falls with the square of its length."""
        tilts = []
        for parts in (24, 48):
            (band,) = self.solve(exact_obj(*ball(parts, -0.95)), "--band=0")["bands"]
            tilts.append(band["least"]["tilt_deg"]["value"])
        self.assertAlmostEqual((4 * tilts[1] - tilts[0]) / 3, 18.162979, 3)

    def test_formats(self):
        """One solid in three formats, whose numbers binary floats hold."""
        points, faces = FRUSTUM, SIX
        told = [self.solve(make(points, faces), name=f"rock.{ending}") for make, ending in ((exact_obj, "obj"), (stl, "stl"), (ply, "ply"))]
        for other in told[1:]:
            for key in ("volume_m3", "centroid_m", "inertia_m5"):
                self.assertEqual(other[key], told[0][key])

    def test_section_in_the_plane(self):
        """A section that was extruded topples to both sides as the plane tool says, and as it is refused by none."""
        outline = [(0, 0), (5, 0), (6, 4), (3, 7), (-1, 3)]
        n = len(outline)
        points = [(x, y, z) for y in (0, 2) for x, z in outline]
        faces = [tuple(range(n)), tuple(range(2 * n - 1, n - 1, -1))] + [(k, k + n, (k + 1) % n + n, (k + 1) % n) for k in range(n)]
        got = self.solve(exact_obj(points, faces), "--band=0", "--azimuths=4")
        scene = self.put("s.yaml", f"topple: 1\nlength_unit: m\nblock: {{outline: {[list(p) for p in outline]}}}\n")
        status, out, err = run("solve", "--json", scene)
        self.assertEqual(status, 0, err)
        for case in json.loads(out)["cases"]:
            rose = got["bands"][0]["rose"][1 if case["towards"] == "right" else 3]
            self.assertAlmostEqual(rose["toppling_deg"]["value"], case["toppling"]["critical_angle_deg"]["value"], 11)
        mesh = self.put("rock.obj", exact_obj(points, faces))
        status, cut, err = run("solid", "--unit=m", "--band=0", "--section=90", mesh)
        self.assertEqual(status, 0, err)
        self.assertIn("to the left, the section topples at 42.483°, the rock at 42.483°.\n", cut)
        status, again, err = run("solve", "--json", self.put("cut.yaml", cut))
        self.assertEqual(status, 0, err)
        for one, other in zip(json.loads(out)["cases"], json.loads(again)["cases"]):
            self.assertAlmostEqual(one["toppling"]["critical_angle_deg"]["value"], other["toppling"]["critical_angle_deg"]["value"], 7)
        for words, told in ((["--up=1,1,0"], "z or y upwards"), (["--section=400"], "-360 and 360"), (["--json"], "no other output")):
            status, none, err = run("solid", "--unit=m", "--band=0", "--section=45", mesh, *words)
            self.assertEqual((status in (2, 3), none), (True, ""), err)
            self.assertIn(told, err)


class AgainstFractions(Case):
    def check(self, points, faces, scale=1):
        oracle = Oracle([tuple(Fraction(x, scale) for x in p) for p in points], triangles(faces))
        got = self.solve(exact_obj(oracle.points, faces), "--azimuths=7", "--band=0,0.25")
        self.holds(got["volume_m3"], oracle.volume)
        for number, truth in zip(got["centroid_m"], oracle.centroid):
            self.holds(number, truth)
        for number, truth in zip(got["inertia_m5"], oracle.inertia):
            self.holds(number, truth)
        poses = oracle.poses()
        self.assertEqual(got["facets"], len(oracle.facets))
        self.assertEqual(len(got["poses"]), len(poses))
        for pose in got["poses"]:
            normal, share, tan2 = max(poses, key=lambda p: sum(a * b for a, b in zip(p[0], pose["down"])))
            self.assertAlmostEqual(sum(a * b for a, b in zip(normal, pose["down"])), 1, 12)
            self.assertAlmostEqual(pose["share"]["value"], share, 11)
            self.is_angle(pose["least"]["tilt_deg"], tan2)
        rises = sorted(pose["persistence_m"]["value"] for pose in got["poses"] if "persistence_m" in pose)
        self.assertEqual(len(rises), len(poses) - 1)
        for rise, truth in zip(rises, oracle.persistences()):
            self.assertAlmostEqual(rise, truth, 11)
        for band in got["bands"]:
            stands, tan2, towards = oracle.lies(Fraction(band["band"]))
            self.assertEqual(band["stands"], stands)
            if not stands:
                continue
            self.is_angle(band["least"]["tilt_deg"], tan2)
            for own in band["rose"]:
                self.assertAlmostEqual(own["toppling_deg"]["value"], towards(own["azimuth_deg"]), 11)
        return got

    def test_convex(self):
        draw = random.Random(36)
        for _ in range(rounds(14, 7000)):
            points = [tuple(draw.randint(-40, 40) for _ in range(3)) for _ in range(8)]
            hull = Oracle(points, [])
            used = sorted({k for facet in hull.facets for k in facet})
            faces = [tuple(used.index(k) for k in hull.ring(facet)) for facet in hull.facets]
            self.check([points[k] for k in used], faces, 8)

    def test_tetrahedra(self):
        """In either order of their points: CGAL makes the hull of four points as they come, half of them inside out."""
        draw = random.Random(74)
        for _ in range(8):
            points = [tuple(draw.randint(-40, 40) for _ in range(3)) for _ in range(4)]
            hull = Oracle(points, [])
            self.check(points, [tuple(hull.ring(facet)) for facet in hull.facets], 8)

    def test_star_shaped(self):
        """Mostly far from convex: each point of a small ball is moved along its own ray, to between 6 and 20 times its distance, so that all
        of the surface is seen from the middle of the ball."""
        draw = random.Random(63)
        points, faces = octahedron(level=1)
        for _ in range(rounds(5, 3000)):
            self.check([tuple(x * draw.randint(6, 20) for x in p) for p in points], faces, 8)

    def test_cuboid_that_stands(self):
        self.check(*box((0, 0, 0), (1, 2, 3)))


class Invariance(Case):
    @staticmethod
    def without_place(told):
        """What does not depend on where it lies."""
        for key in ("file", "centroid_m", "notes"):
            told.pop(key, None)
        for item in told["poses"] + told["bands"]:
            for end in ("edge_from", "edge_to"):
                item.get("least", {}).pop(end, None)
        return told

    def test_far_away(self):
        """Moved by 10^15 lengths: the same to the last digit."""
        near, far = (self.without_place(self.solve(exact_obj([tuple(x + d for x, d in zip(p, move)) for p in FRUSTUM], SIX)))
                     for move in ((0, 0, 0), (10 ** 15, -10 ** 15, 10 ** 15)))
        self.assertEqual(near, far)

    def test_turned(self):
        """By a rational rotation about x, with up turned along: the least turn brings it back."""
        def turn(p):
            return p[0], (3 * p[1] - 4 * p[2]) / Fraction(5), (4 * p[1] + 3 * p[2]) / Fraction(5)
        straight = self.solve(exact_obj(*PRISM))
        turned = self.solve(exact_obj([turn(p) for p in PRISM[0]], PRISM[1]), "--up=0,-4,3")
        for one, other in zip(straight["bands"], turned["bands"]):
            self.assertAlmostEqual(one["least"]["azimuth_deg"]["value"], other["least"]["azimuth_deg"]["value"], 11)
            for a, b in zip(one["rose"], other["rose"]):
                self.assertAlmostEqual(a["toppling_deg"]["value"], b["toppling_deg"]["value"], 11)

    def test_mirrored(self):
        straight = self.solve(exact_obj(*PRISM))
        mirrored = self.solve(exact_obj([(-x, y, z) for x, y, z in PRISM[0]], [f[::-1] for f in PRISM[1]]))
        one, other = straight["bands"][0]["rose"], mirrored["bands"][0]["rose"]
        for k, own in enumerate(one):
            self.assertAlmostEqual(own["toppling_deg"]["value"], other[-k % len(other)]["toppling_deg"]["value"], 11)
        self.assertEqual([round(p["share"]["value"], 12) for p in straight["poses"]], [round(p["share"]["value"], 12) for p in mirrored["poses"]])

    def test_subdivided(self):
        """Every triangle in four: corners on straight edges and in flat facets change nothing."""
        points, faces = list(map(tuple, FRUSTUM)), []
        index = {p: k for k, p in enumerate(points)}
        for a, b, c in triangles(SIX):
            middles = []
            for p, q in ((a, b), (b, c), (c, a)):
                middle = tuple(Fraction(x + y) / 2 for x, y in zip(points[p], points[q]))
                middles.append(index.setdefault(middle, len(points)))
                if middles[-1] == len(points):
                    points.append(middle)
            ab, bc, ca = middles
            faces += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        whole, divided = self.solve(exact_obj(FRUSTUM, SIX)), self.solve(exact_obj(points, faces))
        self.assertEqual(whole["facets"], divided["facets"])
        self.assertEqual([p["corners"] for p in divided["poses"]], [4] * 6)
        self.assertAlmostEqual(whole["volume_m3"]["value"], divided["volume_m3"]["value"], 13)
        for one, other in zip(whole["bands"], divided["bands"]):
            self.assertEqual(len(other["support"]), 4)
            for a, b in zip(one["rose"], other["rose"]):
                self.assertAlmostEqual(a["toppling_deg"]["value"], b["toppling_deg"]["value"], 11)

    def test_edge_of_standing(self):
        """A leaning box whose foot is on the edge, and 10^-30 within: doubles cannot tell, and both are decided."""
        def leaning(lean):
            return [(x + (lean if z else 0), y, z) for z in (0, 2) for y in (0, 1) for x in (0, 1)]
        for lean, stands in ((Fraction(1), False), (1 - Fraction(1, 10 ** 30), True), (1 + Fraction(1, 10 ** 30), False)):
            (band,) = self.solve(exact_obj(leaning(lean), SIX), "--band=0")["bands"]
            self.assertEqual(band["stands"], stands)
            if stands:
                self.is_angle(band["least"]["tilt_deg"], Fraction(1, 2 * 10 ** 30) ** 2)


class Refused(Case):
    CUBE = box((0, 0, 0), (1, 1, 1))

    def test_surfaces(self):
        points, faces = self.CUBE
        threes = triangles(faces)
        second = [tuple(x + 5 for x in p) for p in points]
        through = [tuple(x + Fraction(1, 2) for x in p) for p in points]
        beyond = [tuple(k + 8 for k in f) for f in threes]
        self.refused(exact_obj(points, threes[:-1]), "open", "triangle", "3 such edges")
        self.refused(exact_obj(points, [f[::-1] for f in threes]), "inside out", "triangle 1")
        self.refused(exact_obj(points, [threes[0][::-1], *threes[1:]]), "triangle 1 and triangle", "oriented against each other")
        self.refused(exact_obj(points + second, threes + beyond), "2 pieces", "triangle 1 begins", "triangle 13")
        self.refused(exact_obj(points + through, threes + beyond), "2 pieces")
        self.refused(exact_obj(points, threes + [threes[0]]), "three triangles or more", "triangle 13")
        self.refused(exact_obj(points[:3], [(0, 1, 2), (0, 2, 1)]), "flat")
        self.refused(exact_obj([*points, (2, 2, 2)], [*threes, (0, 7, 8)]), "triangle 13 has no area")
        self.refused("v 0 0 0\n", "no face")
        self.refused("", "no face")

    def test_crossing(self):
        """The top of a tall box is turned half round its axis: its sides pass through each other below."""
        points, faces = box((0, 0, 0), (1, 1, 4))
        pulled = [p if p[2] == 0 or p[:2] != (1, 1) else (Fraction(1, 8), Fraction(1, 8), -1) for p in points]
        self.refused(exact_obj(pulled, triangles(faces)), "meets itself", "triangle")

    def test_header_that_claims(self):
        """10^9 triangles in 134 bytes: refused by the length of the file, before memory is asked for."""
        self.refused(bytes(80) + struct.pack("<I", 10 ** 9) + bytes(50), "50000000084 bytes", "this one has 134", name="rock.stl")

    def test_words(self):
        path = self.put("rock.obj", obj(*self.CUBE))
        for words, told in ((["--band=-1"], "0 or more"), (["--up=0,0"], "three numbers"), (["--up=0,0,0"], "not 0"),
                            (["--friction=90"], "below 90"), (["--azimuths=0"], "1 to 36000"), (["--unit=ell"], "mm, cm"),
                            (["--object=roof"], "no object 'roof'"), (["--json", "--csv"], "one of")):
            status, out, err = run("solid", path, *words)
            self.assertIn(status, (2, 3), words)
            self.assertEqual(out, "")
            self.assertIn(told, err)


class Told(Case):
    def test_page_and_rows(self):
        path = self.put("rock.obj", obj(*box((0, 0, 0), (1, 2, 3))))
        status, out, err = run("solid", path, "--friction=15", "--unit-weight=26")
        self.assertEqual(status, 0, err)
        for words in ("156000 N", "6 poses", "friction angle 15°", "15°  slides", "unit of its lengths", "18.434949°"):
            self.assertIn(words, out)
        status, out, err = run("solid", path, "--csv", "--band=0,0.5", "--azimuths=8")
        self.assertEqual(status, 0, err)
        rows = [line.split(",") for line in out.splitlines()]
        self.assertEqual(len(rows), 1 + 16)
        self.assertAlmostEqual(float(rows[3][2]), math.degrees(math.atan(1 / 3)), 12)
        self.assertEqual(minus((3, 2, 1), (1, 1, 1)), (2, 1, 0))


if __name__ == "__main__":
    main()
