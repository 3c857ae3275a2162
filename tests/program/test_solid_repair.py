#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A mesh that is not closed, mended.

A sound mesh is damaged in ways that are known: triangles given twice, turned, taken out, flat ones put in, points that an edge does not
know, crumbs beside it. Repaired it is the sound one to the last digit wherever nothing had to be invented; and what closes a gap is, by trying
all triangulations of its loop, the least area that there is, with the volume that fractions give it."""

import json
import math
import random
import unittest
from fractions import Fraction

from harness import main, run
from mesh_case import box, octahedron, triangles
from test_solid_scenes import SceneCase
from test_solids import exact_obj


def minus(a, b):
    return [p - q for p, q in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def volume6(points, faces):
    return sum(dot(points[a], cross(points[b], points[c])) for a, b, c in faces)


def area(points, face):
    a, b, c = (points[k] for k in face)
    n = cross(minus(b, a), minus(c, a))
    return math.sqrt(dot(n, n)) / 2


def fillings(loop):
    """All triangulations of a polygon."""
    if len(loop) < 3:
        yield []
        return
    first, last = loop[0], loop[-1]
    for k in range(1, len(loop) - 1):
        for left in fillings(loop[:k + 1]):
            for right in fillings(loop[k:]):
                yield left + right + [(first, loop[k], last)]


def edges(faces):
    return {frozenset(e) for a, b, c in faces for e in ((a, b), (b, c), (c, a))}


class Repairs(SceneCase):
    def mended(self, points, faces, *words):
        status, out, err = run("solid", "--json", "--unit=m", "--repair", *words, self.put("rock.obj", exact_obj(points, faces)))
        self.assertEqual(status, 0, err)
        return json.loads(out)

    def same(self, got, sound):
        """The solid that it was: all but its surface's numbers and notes."""
        for key in ("volume_m3", "centroid_m", "inertia_m5"):
            for own, other in zip(*([x[key]] if isinstance(x[key], dict) else x[key] for x in (got, sound))):
                self.assertLessEqual(abs(own["value"] - other["value"]), own["error"] + other["error"])
        self.assertEqual([[b["touching"], b["least"]["tilt_deg"]["value"]] if b["stands"] else None for b in got["bands"]],
                         [[b["touching"], b["least"]["tilt_deg"]["value"]] if b["stands"] else None for b in sound["bands"]])

    def test_nothing_is_invented(self):
        """Duplicates, turned triangles, all inside out, flat triangles, points on edges: the same solid, with each counted."""
        draw = random.Random(3)
        points, faces = octahedron((3, 2, 1), level=2)
        sound = self.mended(points, faces)
        self.assertEqual((sound["triangles"], "gaps" in sound["repair"]), (128, False))
        for key in ("merged_points", "duplicate_triangles", "flat_triangles", "turned_triangles", "dropped_pieces"):
            self.assertEqual(sound["repair"][key], 0)
        self.assertEqual(sound["notes"], [])
        twice = faces + [f[1:] + f[:1] for f in draw.sample(faces, 9)] + [f[::-1] for f in draw.sample(faces, 1)]
        got = self.mended(points, twice)
        self.same(got, sound)
        self.assertEqual((got["repair"]["duplicate_triangles"], got["repair"]["first_duplicate"], got["triangles"]), (10, 129, 128))
        turned = draw.sample(range(128), 30)
        got = self.mended(points, [f[::-1] if k in turned else f for k, f in enumerate(faces)])
        self.same(got, sound)
        self.assertEqual((got["repair"]["turned_triangles"], got["repair"]["first_turned"]), (30, min(turned) + 1))
        self.same(self.mended(points, [f[::-1] for f in faces]), sound)

        # a point in the middle of an edge, known to one side alone: with the flat triangle between, and without it
        a, b, c = faces[7]
        middle = [(p + q) / 2 for p, q in zip(points[a], points[b])]
        parted = faces[:7] + faces[8:] + [(a, len(points), c), (len(points), b, c)]
        for more, flat in (([(a, b, len(points))], 1), ([], 0)):
            got = self.mended(points + [middle], parted + more)
            self.same(got, sound)
            self.assertEqual((got["repair"]["flat_triangles"], got["triangles"]), (flat, 130))
            self.assertEqual(got["repair"]["closed_area_share"]["value"], 0)
            self.assertEqual(got["repair"].get("gaps", []) == [], bool(flat))
        # five of them on one edge
        on = [[p + (q - p) * Fraction(k, 8) for p, q in zip(points[a], points[b])] for k in range(1, 6)]
        chain = [a] + list(range(len(points), len(points) + 5)) + [b]
        got = self.mended(points + on, faces[:7] + faces[8:] + [(p, q, c) for p, q in zip(chain, chain[1:])])
        self.same(got, sound)
        self.assertEqual(got["repair"]["closed_area_share"]["value"], 0)

    def test_gaps_by_trying_all(self):
        """Of up to seven corners: the least area of all triangulations that use no edge twice, and the volume of that one; the same mirrored,
        turned inside out, moved by 10^12 and in feet."""
        draw = random.Random(8)
        for turn in range(6):
            points, faces = octahedron((3, 2, Fraction(5, 2)), level=2)
            points = [[x * Fraction(draw.randint(90, 110), 100) for x in p] for p in points]
            hub = draw.choice([k for k in range(len(points)) if sum(k in f for f in faces) == 6])
            ring = {f[f.index(hub) - 2]: f[f.index(hub) - 1] for f in faces if hub in f}
            loop = [next(iter(ring))]
            while len(loop) < len(ring):
                loop.append(ring[loop[-1]])
            rest = [f for f in faces if hub not in f]
            taken = edges(rest)
            best = min((f for f in fillings(loop) if not any(e in taken and abs(loop.index(min(e)) - loop.index(max(e))) not in (1, len(loop) - 1)
                                                             for e in edges(f))), key=lambda f: sum(area(points, t) for t in f))
            truth = volume6(points, rest + best) / 6
            if turn % 3 == 1:
                rest, points = [f[::-1] for f in rest], [[-p[0], p[1], p[2]] for p in points]
            if turn % 3 == 2:
                rest, points = [f[::-1] for f in rest], [[x + 10 ** 12 for x in p] for p in points]
            got = self.mended(points, rest)
            self.assertLessEqual(abs(Fraction(got["volume_m3"]["value"]) - truth), Fraction(got["volume_m3"]["error"]))
            gap, = got["repair"]["gaps"]
            self.assertEqual((gap["corners"], gap["triangles"]), (len(loop), len(loop) - 2))
            whole = sum(area([[float(x) for x in minus(p, points[0])] for p in points], t) for t in rest + best)
            own = sum(area([[float(x) for x in minus(p, points[0])] for p in points], t) for t in best)
            self.assertAlmostEqual(gap["area_m2"]["value"], own, 9)
            self.assertAlmostEqual(got["repair"]["closed_area_share"]["value"], own / whole, 9)
            self.assertGreater(got["repair"]["closed_volume_share"]["value"], 0)
            note, = (n["text"] for n in got["notes"] if "is an assumption" in n["text"])
            self.assertIn("which is an assumption: 1. ", note)
            feet = json.loads(run("solid", "--json", "--unit=ft", "--repair", f"{self.folder}/rock.obj")[1])
            self.assertAlmostEqual(feet["repair"]["gaps"][0]["area_m2"]["value"], own * 0.3048 ** 2, 9)

    def test_wide_gaps_lie_in_their_plane(self):
        """A star of 700 points without its bottom and its top: both are closed, with the polygon's area, and the volume is the prism's."""
        count = 700
        ring = [[round(math.cos(2 * math.pi * k / count) * (5 + (k % 2)), 6), round(math.sin(2 * math.pi * k / count) * (5 + (k % 2)), 6)]
                for k in range(count)]
        ring = [[Fraction(str(x)) for x in p] for p in ring]
        points = [[*p, Fraction(z)] for z in (0, 2) for p in ring]
        sides = [f for k in range(count) for f in ((k, (k + 1) % count, count + k), ((k + 1) % count, count + (k + 1) % count, count + k))]
        got = self.mended(points, sides)
        plane = sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(ring, ring[1:] + ring[:1])) / 2
        self.assertLessEqual(abs(Fraction(got["volume_m3"]["value"]) - 2 * plane), Fraction(got["volume_m3"]["error"]))
        self.assertEqual([g["triangles"] for g in got["repair"]["gaps"]], [count - 2, count - 2])
        for gap in got["repair"]["gaps"]:
            self.assertAlmostEqual(gap["area_m2"]["value"], float(plane), 9)

    def test_merged_and_dropped(self):
        """Each triangle with corners of its own, off by up to 0.001: they meet where points within 0.003 are one, and by no less; crumbs of
        0.1 % of the area go where that is said."""
        draw = random.Random(1)
        points, faces = octahedron((3, 3, 3), level=1)
        apart = [[x + Fraction(draw.randint(-1000, 1000), 10 ** 6) for x in points[k]] for f in faces for k in f]
        soup = [(3 * k, 3 * k + 1, 3 * k + 2) for k in range(len(faces))]
        got = self.mended(apart, soup, "--merge-within=0.005")
        self.assertEqual((got["vertices"], got["triangles"], got["repair"]["merged_points"]), (18, 32, 96 - 18))
        self.assertLess(got["repair"]["farthest_merged"], 0.001 * 2 * math.sqrt(3) + 1e-12)
        self.assertTrue(any("within 0.005" in n["text"] and n["kind"] == "caution" for n in got["notes"]))
        status, out, err = run("solid", "--unit=m", "--repair", "--merge-within=1e-9", f"{self.folder}/rock.obj")
        self.assertEqual((status, out), (3, ""))
        self.assertIn("pieces that share no edge", err)
        crumb, crumb_faces = octahedron((Fraction(1, 20), Fraction(1, 20), Fraction(1, 20)), (9, 0, 0))
        both = points + crumb, faces + [tuple(k + len(points) for k in f) for f in crumb_faces]
        sound = self.mended(points, faces)
        got = self.mended(*both, "--drop-below=0.01")
        self.same(got, sound)
        self.assertEqual((got["repair"]["dropped_pieces"], got["repair"]["dropped_triangles"]), (1, 8))
        small, all_areas = (sum(area([[float(x) for x in p] for p in both[0]], f) for f in part) for part in (both[1][len(faces):], both[1]))
        self.assertAlmostEqual(got["repair"]["dropped_area_share"], small / all_areas, 12)
        status, out, err = run("solid", "--unit=m", "--repair", "--drop-below=1e-6", f"{self.folder}/rock.obj")
        self.assertEqual((status, out), (3, ""))

    def test_what_stays_refused(self):
        """Surfaces that cross; one side alone; a fin; options that go with no repair. Without it messages say what it would do."""
        points, faces = box((0, 0, 0), (1, 1, 1))
        faces = triangles(faces)
        spike = points + [(Fraction(1, 2), Fraction(1, 2), 3)]
        crossing = faces[:-1] + [(faces[-1][0], faces[-1][1], 8), (faces[-1][1], faces[-1][2], 8), (faces[-1][2], faces[-1][0], 8)]
        strip = [(k, (k + 1) % 5, (k + 2) % 5) for k in range(5)]  # Moebius'
        five = [[math.floor(9 * math.cos(k)), math.floor(9 * math.sin(2 * k)), k * k] for k in range(5)]
        fin = points + [(2, 2, 2)]
        for mesh, words in (((spike, crossing), "the surface meets itself"), ((five, strip), "its repair left them so"),
                            ((fin, faces + [(faces[0][0], faces[0][1], 8)]), "its repair left them so")):
            status, out, err = run("solid", "--unit=m", "--repair", self.put("rock.obj", exact_obj(*mesh)))
            self.assertEqual((status, out), (3, ""))
            self.assertIn(words, err)
        for mesh, words in (((points, faces[1:]), "have them closed by --repair"), ((points, faces[1:] + [faces[0][::-1]]), "have them turned by --repair"),
                            ((points, faces + faces[:1]), "given twice --repair"), ((points, [f[::-1] for f in faces]), "have them turned by --repair")):
            status, out, err = run("solid", "--unit=m", self.put("rock.obj", exact_obj(*mesh)))
            self.assertEqual((status, out), (3, ""))
            self.assertIn(words, err)
        for words in ("--merge-within=1", "--drop-below=0.1"):
            self.assertEqual(run("solid", "--unit=m", words, f"{self.folder}/rock.obj")[0], 2)
        self.assertEqual(run("solid", "--repair", "--drop-below=1", f"{self.folder}/rock.obj")[0], 2)
        status, _, err = run("solid", "--repair", "--merge-within=9", f"{self.folder}/rock.obj")
        self.assertEqual(status, 3)
        self.assertIn("nothing is left of the mesh", err)

    def test_cut_by_a_plane(self):
        """Mended, then cut: of a box without two of its faces, of one with them twice, and of the sound one what lies above is the same, of scenes too."""
        points, faces = box((-1, -1, 0), (1, 1, 3))
        faces = triangles(faces)
        self.put("rock.obj", exact_obj(points, faces))
        sound = self.told(self.put("cut.yaml", "topple: 1\nlength_unit: m\nsolid: {file: rock.obj, unit: m, below: 0.5}\n"))
        self.assertEqual(sound["volume_m3"]["value"], 10)
        for damaged in (faces[1:], faces + faces[:2], faces[3:] + faces[:3] + [faces[4]]):
            self.put("rock.obj", exact_obj(points, damaged))
            got = self.told(self.put("cut.yaml", "topple: 1\nlength_unit: m\nsolid: {file: rock.obj, unit: m, below: 0.5, repair: true}\n"))
            for one, other in zip([got["volume_m3"], *got["centroid_m"], *got["inertia_m5"]], [sound["volume_m3"], *sound["centroid_m"], *sound["inertia_m5"]]):
                self.assertAlmostEqual(one["value"], other["value"], 12)
            self.assertEqual(got["bands"][0]["support"], sound["bands"][0]["support"])
            self.assertIn("repair", got)
            status, out, err = run("solid", "--json", "--unit=m", "--repair", "--below=0.5", f"{self.folder}/rock.obj")
            self.assertEqual((status, json.loads(out)["volume_m3"]), (0, got["volume_m3"]), err)

    def test_in_a_scene(self):
        """Solved, swept, drawn and on a sheet, with the caution on each; lengths are the scene's."""
        points, faces = box((-1, -1, 0), (1, 1, 3))
        faces = triangles(faces)
        self.put("rock.obj", exact_obj(points, faces[2:]))
        path = self.scene("repair: true", "tilt: {angle_deg: 5, azimuth_deg: 90}\n")
        got = self.told(path)
        self.assertEqual((got["volume_m3"]["value"], got["bands"][0]["stance"]["verdict"]), (12, "stands"))
        self.assertEqual(got["repair"]["gaps"][0]["area_m2"]["value"], 4)
        for words in (("--report", f"{self.folder}/sheet.html"), ("--figure", f"{self.folder}/rock.svg"), ("--figure", f"{self.folder}/rock.glb")):
            status, out, err = run("solve", *words, path)
            self.assertEqual(status, 0, err)
        with open(f"{self.folder}/sheet.html", encoding="utf-8") as sheet:
            self.assertIn("is an assumption", sheet.read())
        status, out, err = run("solve", "--report", f"{self.folder}/sheet.html", "--language", "es", path)
        self.assertEqual(status, 0, err)
        with open(f"{self.folder}/sheet.html", encoding="utf-8") as sheet:
            text = sheet.read()
        self.assertIn("lo que es una suposición: 1", text)
        self.assertIn("En el hueco mayor, 4 m² con 4 puntos alrededor de", text)
        self.assertNotIn("repair:", text.replace("repair: true", ""))
        status, out, err = run("sweep", "--x", "tilt.angle_deg=0,10", path)
        self.assertEqual(status, 0, err)
        self.put("rock.obj", exact_obj([[x + Fraction(k, 10 ** 4) for x in points[v]] for k, f in enumerate(faces) for v in f],
                                       [(3 * k, 3 * k + 1, 3 * k + 2) for k in range(len(faces))]))
        got = self.told(self.put("scene.yaml", "topple: 1\nlength_unit: mm\nsolid: {file: rock.obj, unit: m, bands: [1], repair: {merge_within: 5}}\n"))
        self.assertEqual((got["vertices"], got["triangles"]), (8, 12))
        both = self.put("scene.yaml", "topple: 1\nlength_unit: mm\nsolid: {file: rock.obj, unit: m, bands: [1], repair: {merge_within: 5, drop_below: 0.001}}\n"
                        "friction_angle_deg: 40\ntilt: {angle_deg: 5, azimuth_deg: 90}\n")
        status, out, err = run("sweep", "--x", "solid.repair.merge_within=5,0.001", both)  # of the second no two points are near
        rows = out.splitlines()
        self.assertEqual((len(rows), rows[1].split(",")[1], rows[2].split(",")[1]), (3, "done", "the input is wrong"), err)
        status, out, err = run("sweep", "--x", "solid.repair.drop_below=0.001,0.002", both)
        self.assertEqual((status, [row.split(",")[1] for row in out.splitlines()[1:]]), (0, ["done", "done"]), err)
        self.wrong(self.scene("repair: {drop_below: 1}"), "a share of the area")
        self.wrong(self.scene("repair: {merge_within: -1}"), "merge_within")
        self.wrong(self.scene("repair: {close: 1}"), "close")
        self.wrong(self.scene("repair: 3"), "repair")


if __name__ == "__main__":
    main()
