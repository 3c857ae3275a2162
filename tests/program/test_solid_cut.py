#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A rock that a plane cuts: what lies below is ground, what lies above rests on the section.

The oracle clips triangles in fractions and closes the cut by a fan of triangles, with moments about the origin of the file: it
needs no origin on the plane. What is cut so is then a solid like any other, whose poses and tilts it finds by trying all."""

import csv
import io
import json
import random
import unittest
from fractions import Fraction

from harness import main, rounds, run
from mesh_case import box, octahedron, triangles
from solid_oracle import Oracle, dot
from test_solid_parts import PartCase
from test_solid_scenes import SceneCase
from test_solids import FRUSTUM, SIX, Case, exact_obj
from test_solids import Invariance as _Invariance


without_place = _Invariance.without_place


def clipped(points, faces, level, up=(0, 0, 1)):
    """What lies no lower than up . p = level, closed."""
    index, found, kept, rim = {}, [], [], []

    def number(p):
        if p not in index:
            index[p] = len(found)
            found.append(p)
        return index[p]

    for face in triangles(faces):
        corners = [tuple(map(Fraction, points[k])) for k in face]
        heights = [dot(up, p) - level for p in corners]
        if max(heights) <= 0:
            continue
        ring = []
        for k in range(3):
            (a, s), (b, t) = (corners[k], heights[k]), (corners[(k + 1) % 3], heights[(k + 1) % 3])
            if s >= 0:
                ring.append((number(a), s == 0))
            if s * t < 0:
                ring.append((number(tuple(x + (y - x) * s / (s - t) for x, y in zip(a, b))), True))
        kept += [(ring[0][0], ring[k][0], ring[k + 1][0]) for k in range(1, len(ring) - 1)]
        rim += [(ring[k][0], ring[(k + 1) % len(ring)][0]) for k in range(len(ring)) if ring[k][1] and ring[(k + 1) % len(ring)][1]]
    apex = rim[0][0]
    return found, kept + [(apex, q, p) for p, q in rim if apex not in (p, q)]


def arch():
    """Two legs and a beam: a section of two loops."""
    outline = [(0, 0), (1, 0), (1, 2), (3, 2), (3, 0), (4, 0), (4, 3), (0, 3)]
    points = [(x, y, z) for y in (0, 1) for x, z in outline]
    sides = [(k, 8 + k, 8 + (k + 1) % 8, (k + 1) % 8) for k in range(8)]
    front = [(0, 1, 2, 7), (2, 6, 7), (2, 3, 6), (3, 4, 5, 6)]
    return points, sides + front + [tuple(8 + k for k in f[::-1]) for f in front]


def outwards(points, faces):
    return (points, faces) if Oracle(points, triangles(faces)).volume > 0 else (points, [f[::-1] for f in faces])


class CutCase(Case):
    def cut(self, points, faces, below, *words):
        """Against the oracle of what lies above."""
        level = min(p[2] for p in points) + Fraction(below)
        oracle = Oracle(*clipped(points, faces, level))
        got = self.solve(exact_obj(points, faces), "--azimuths=7", f"--below={float(below)}", *words)
        self.holds(got["volume_m3"], oracle.volume)
        for number, truth in zip(got["centroid_m"] + got["inertia_m5"], list(oracle.centroid) + oracle.inertia):
            self.holds(number, truth)
        (band,) = got["bands"]
        self.assertEqual((got["below"], band["band"]), (float(below), float(below)))
        self.holds(band["height_m"], oracle.centroid[2] - level)
        stands, tan2, towards = oracle.lies(0)
        self.assertEqual(band["stands"], stands)
        if stands:
            self.is_angle(band["least"]["tilt_deg"], tan2)
            for own in band["rose"]:
                self.assertAlmostEqual(own["toppling_deg"]["value"], towards(own["azimuth_deg"]), 11)
        poses = oracle.poses()
        self.assertEqual((got["facets"], len(got["poses"])), (len(oracle.facets), len(poses)))
        for pose in got["poses"]:
            normal, share, tan2 = max(poses, key=lambda p: sum(a * b for a, b in zip(p[0], pose["down"])))
            self.assertAlmostEqual(pose["share"]["value"], share, 10)
            self.is_angle(pose["least"]["tilt_deg"], tan2)
        return got


class Sections(CutCase):
    def test_box(self):
        """A box 1 x 2 x 3 cut at h is a box of the height 3 - h, on the same base: tan 1/(3 - h)."""
        for below in (0, Fraction(1, 2), 1, Fraction(5, 2)):
            got = self.cut(*box((0, 0, 0), (1, 2, 3)), below)
            self.holds(got["volume_m3"], 2 * (3 - Fraction(below)))
            self.is_angle(got["bands"][0]["least"]["tilt_deg"], 1 / (3 - Fraction(below)) ** 2)

    def test_frustum_and_pyramid(self):
        """A pyramid of the side 2 and the height 4 cut at 2 is one of the side 1 and the height 2, its centroid at a quarter of that."""
        pyramid = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0), (0, 0, 4)], [(3, 2, 1, 0), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
        got = self.cut(*pyramid, 2)
        self.holds(got["volume_m3"], Fraction(2, 3))
        self.is_angle(got["bands"][0]["least"]["tilt_deg"], 1)
        self.cut(FRUSTUM, SIX, 1)

    def test_plane_through_corners_edges_and_faces(self):
        """Layers whose corners lie on the plane, and a ball of which a ring does."""
        layered = [(x, y, z) for z in (0, 1, 3) for x, y in ((0, 0), (4, 0), (4, 4), (0, 4))]
        sides = [(4 * k + c, 4 * k + (c + 1) % 4, 4 * k + 4 + (c + 1) % 4, 4 * k + 4 + c) for k in (0, 1) for c in range(4)]
        self.cut(layered, [(0, 3, 2, 1), (8, 9, 10, 11)] + sides, 1)
        self.cut(*octahedron(level=0), 1)
        self.cut(*octahedron((2, 3, 4), level=1), 4)
        self.cut(*outwards(*arch()), 2)

    def test_several_loops(self):
        """Both legs of an arch carry it: the hull of the section is the whole of its plan."""
        for below in (0, Fraction(1, 2), Fraction(7, 4), Fraction(9, 4)):
            got = self.cut(*outwards(*arch()), below)
            self.assertEqual(len(got["bands"][0]["support"]), 4)

    def test_by_chance(self):
        draw = random.Random(360)
        points, faces = octahedron(level=1)
        done = 0
        while done < rounds(4, 600):
            own = [tuple(x * Fraction(draw.randint(9, 20), 8) for x in p) for p in points]
            low, high = min(p[2] for p in own), max(p[2] for p in own)
            below = Fraction(round(512 * (high - low) * Fraction(draw.randint(10, 55), 100)), 512)
            if Oracle(own, []).facets and self.pieces(own, faces, low + below) == 1:
                self.cut(own, faces, below)
                done += 1

    @staticmethod
    def pieces(points, faces, level):
        """Of what lies above, over shared corners: each has a highest corner that its neighbours do not top."""
        above = {k for k, p in enumerate(points) if p[2] > level}
        found = 0
        while above:
            found, reach = found + 1, [above.pop()]
            while reach:
                at = reach.pop()
                near = {k for f in faces if at in f for k in f} & above
                above -= near
                reach += near
        return found


class Decisions(CutCase):
    def test_edge_of_standing(self):
        """A leaning box, of which what lies above 1 has its foot on the edge of the section, and 10^-30 within and beyond."""
        for lean, stands in ((Fraction(1), False), (1 - Fraction(1, 10 ** 30), True), (1 + Fraction(1, 10 ** 30), False)):
            points = [(x + lean * z / 2, y, z) for z in (0, 3) for y in (0, 1) for x in (0, 1)]
            (band,) = self.solve(exact_obj(points, SIX), "--below=1")["bands"]
            self.assertEqual(band["stands"], stands)

    def test_through_thirds(self):
        """Points of the section that no decimal writes: a plane at 1 through edges of the height 3, far from exact in doubles; the same
        solid written with its section as a mesh of its own, in lengths of a third."""
        points = [(0, 0, 0), (7, 1, 0), (2, 8, 0), (1, 2, 3), (5, 3, 3), (2, 4, 3)]
        faces = [(0, 2, 1), (3, 4, 5), (0, 1, 4), (0, 4, 3), (1, 2, 5), (1, 5, 4), (2, 0, 3), (2, 3, 5)]
        own, closed = clipped(points, faces, 1)
        cut = self.solve(exact_obj(points, faces), "--below=1")
        straight = self.solve(exact_obj([tuple(3 * x for x in p) for p in own], closed), "--band=0")
        self.assertAlmostEqual(cut["volume_m3"]["value"] * 27, straight["volume_m3"]["value"], 11)
        one, other = cut["bands"][0], straight["bands"][0]
        self.assertEqual(len(one["support"]), len(other["support"]))
        for a, b in zip(one["rose"], other["rose"]):
            self.assertAlmostEqual(a["toppling_deg"]["value"], b["toppling_deg"]["value"], 11)

    def test_far_away_mirrored_and_in_other_units(self):
        points, faces = octahedron((2, 3, 4), level=1)
        near, far = (without_place(self.solve(exact_obj([tuple(x + d for x, d in zip(p, move)) for p in points], faces), "--below=1.3"))
                     for move in ((0, 0, 0), (10 ** 15, -10 ** 15, 10 ** 15)))
        self.assertEqual(near, far)
        mirrored = self.solve(exact_obj([(-x, y, z) for x, y, z in points], [f[::-1] for f in faces]), "--below=1.3")
        one, other = near["bands"][0]["rose"], mirrored["bands"][0]["rose"]
        for k, own in enumerate(one):
            self.assertAlmostEqual(own["toppling_deg"]["value"], other[-k % len(other)]["toppling_deg"]["value"], 11)
        shorter = self.solve(exact_obj(points, faces), "--unit=cm", "--below=1.3")
        self.assertEqual([a["toppling_deg"]["value"] for a in one], [a["toppling_deg"]["value"] for a in shorter["bands"][0]["rose"]])
        self.assertAlmostEqual(shorter["volume_m3"]["value"] * 10 ** 6, near["volume_m3"]["value"], 9)

    def test_slanted(self):
        """Up is (0, 3, 4), of the length 5: what the plane cuts is known in fractions; (0, 1, 1) has a root for its length."""
        points, faces = octahedron((2, 3, 4), level=1)
        level = min(dot((0, 3, 4), p) for p in points) + 5 * Fraction(3, 2)
        oracle = Oracle(*clipped(points, faces, level, (0, 3, 4)))
        got = self.solve(exact_obj(points, faces), "--up=0,3,4", "--below=1.5")
        self.holds(got["volume_m3"], oracle.volume)
        low, high = (Oracle(*clipped(points, faces, min(dot((0, 1, 1), p) for p in points) + root * Fraction(3, 2), (0, 1, 1))).volume
                     for root in (Fraction(141421356237309505, 10 ** 17), Fraction(141421356237309504, 10 ** 17)))
        got = self.solve(exact_obj(points, faces), "--up=0,1,1", "--below=1.5")
        value, error = (Fraction(got["volume_m3"][key]) for key in ("value", "error"))
        self.assertTrue(value - error <= high and low <= value + error)


class Parts(PartCase):
    def test_holes_and_parts_are_cut(self):
        """A cube with a heavy cube and a hole that the plane cuts, and a part that lies below it."""
        hole, part, lost = box((1, 1, 1), (2, 2, 3)), box((3, 3, 1), (4, 5, 4)), box((1, 4, Fraction(1, 4)), (2, 5, Fraction(3, 4)))
        path = self.inside(box((0, 0, 0), (6, 6, 6)), [hole], [(part, 30), (lost, 28)])
        with open(path, encoding="utf-8") as scene:
            text = scene.read()
        got = self.told(self.put("cut.yaml", text.replace("bands: [0]", "below: 2")))
        volume, weight = 6 * 6 * 4 - 1, 26 * (6 * 6 * 4 - 1) + 4 * 2 * 2
        self.holds(got["volume_m3"], volume)
        self.holds(got["weight_n"], 1000 * weight)
        self.holds(got["centroid_m"][2], Fraction(26 * (144 * 4 - Fraction(5, 2)) + 4 * 4 * 3, weight))
        self.assertEqual([p["volume_m3"]["value"] for p in got["parts"]], [1, 4, 0])


class Scenes(SceneCase):
    ROCK = "examples/solids/rock_in_the_ground.yaml"

    def test_example(self):
        """The scene has what the options have, and a factor that the rose of the same section bounds."""
        got = self.told(self.ROCK)
        status, out, err = run("solid", "--json", "--unit=m", "examples/solids/balanced_rock.obj", "--below=0.1", "--friction=32", "--unit-weight=26")
        self.assertEqual(status, 0, err)
        other = json.loads(out)
        for key in ("volume_m3", "centroid_m", "weight_n", "poses"):
            self.assertEqual(got[key], other[key])
        self.assertEqual(got["bands"][0]["least"], other["bands"][0]["least"])
        self.assertEqual((got["triangles"], got["vertices"]), (512, 258))

    def test_varied(self):
        """A sweep over the depth is what single scenes say, and a study of it runs."""
        status, out, err = run("sweep", self.ROCK, "--x=solid.below=0.05:0.2:0.05")
        self.assertEqual(status, 0, err)
        rows = list(csv.DictReader(io.StringIO(out)))
        for row in rows:
            alone = self.told(self.ROCK, "--set", f"solid.below={row['solid.below']}")
            self.assertEqual(float(row["fos"]), alone["bands"][0]["stance"]["fos"]["value"])
        self.assertEqual(len({row["fos"] for row in rows}), 4)

    def test_section(self):
        """Of an arch on both legs, across it: the section is the solid, to the digits of its head."""
        path = self.put("arch.obj", exact_obj(*outwards(*arch())))
        for below in (0.5, 2):
            status, out, err = run("solid", "--unit=m", path, f"--below={below}", "--section=90")
            self.assertEqual(status, 0, err)
            for side in out.splitlines()[2:4]:
                self.assertEqual(*(side.replace(".\n", "").split("° ")[0] for side in (side.split("topples at ")[1].split(",")[0], side.split("rock at ")[1].rstrip("."))))
            status, solved, err = run("solve", "--json", self.put("section.yaml", out))
            self.assertEqual(status, 0, err)
            self.assertAlmostEqual(json.loads(solved)["cases"][0]["block"]["area_m2"]["value"], 4 * 3 - 4 * below + (-2 * (2 - below) if below < 2 else 0), 9)

    def test_drawn(self):
        for ending, first in (("svg", b"<?xml"), ("glb", b"glTF"), ("pdf", b"%PDF")):
            status, _, err = run("solve", self.ROCK, f"--figure={self.folder}/rock.{ending}")
            self.assertEqual(status, 0, err)
            with open(f"{self.folder}/rock.{ending}", "rb") as figure:
                self.assertTrue(figure.read().startswith(first))

    def test_sheet(self):
        for language, words in (("en", "what lies below is ground"), ("es", "lo que queda debajo es terreno"), ("de", "was darunter liegt, ist Untergrund")):
            status, _, err = run("solve", self.ROCK, f"--report={self.folder}/rock.md", f"--language={language}")
            self.assertEqual(status, 0, err)
            with open(f"{self.folder}/rock.md", encoding="utf-8") as sheet:
                self.assertIn(words, sheet.read())


class Refused(SceneCase):
    def scene(self, solid, rest="", head="length_unit: m\n"):
        return self.put("scene.yaml", f"topple: 1\n{head}solid: {{file: rock.obj, unit: m, {solid}}}\n{rest}")

    def test_nothing_above(self):
        self.put("rock.obj", exact_obj(*box((0, 0, 0), (1, 2, 3))))
        for below in (3, 4):
            self.wrong(self.scene(f"below: {below}"), "scene.yaml:3:", "nothing of the rock lies above the plane that cuts it")
        self.wrong(self.scene("below: -1"), "scene.yaml:3:", "below")

    def test_two_pieces(self):
        """An arch upside down, cut above the beam that holds its legs together."""
        self.put("rock.obj", exact_obj(*outwards([(x, y, -z) for x, y, z in arch()[0]], arch()[1])))
        self.wrong(self.scene("below: 2"), "scene.yaml:3:", "2 pieces that nothing holds together")
        self.wrong(self.scene("below: 1"), "2 pieces")
        self.assertEqual(len(self.told(self.scene("below: 0.5"))["bands"]), 1)

    def test_beside_others(self):
        self.put("rock.obj", exact_obj(*box((0, 0, 0), (1, 2, 3))))
        self.wrong(self.scene("below: 1, bands: [0]"), "leave out 'bands', or 'below'")
        self.wrong(self.scene("below: 1, contacts: [{at: [0, 0, 0]}]"), "leave out 'contacts', or 'below'")
        status, out, err = run("solid", "--unit=m", f"{self.folder}/rock.obj", "--below=1", "--band=0")
        self.assertEqual((status, out), (3, ""))
        self.assertIn("give one of both", err)


if __name__ == "__main__":
    main()
