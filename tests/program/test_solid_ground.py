#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A rock on a mesh of the ground.

The oracle tries every corner against every face and every edge against every edge, in fractions. A flat ground gives what the plane
base gives, a groove its closed form, and what was extruded what the tool in the plane says."""

import json
import math
import random
import unittest
from fractions import Fraction

from harness import ROOT, main, rounds, run
from mesh_case import box, octahedron, triangles
from solid_oracle import cross, dot, minus
from test_solid_contacts import slip
from test_solid_scenes import SceneCase
from test_solids import exact_obj


def primitive(v):
    bottom = math.lcm(*(Fraction(x).denominator for x in v))
    whole = [int(x * bottom) for x in v]
    common = math.gcd(*whole)
    return tuple(x // common for x in whole)


def grid(heights, step=1, origin=(0, 0)):
    """Two triangles for each cell, counter-clockwise seen from above."""
    rows, columns = len(heights), len(heights[0])
    points = [(Fraction(origin[0]) + step * i, Fraction(origin[1]) + step * j, Fraction(heights[j][i])) for j in range(rows) for i in range(columns)]
    faces = []
    for j in range(rows - 1):
        for i in range(columns - 1):
            a = j * columns + i
            faces += [(a, a + 1, a + columns + 1), (a, a + columns + 1, a + columns)]
    return points, faces


def divided(points, faces):
    """Every triangle in four."""
    points, index = list(map(tuple, points)), {}
    index = {p: k for k, p in enumerate(points)}
    out = []
    for a, b, c in triangles(faces):
        middles = []
        for p, q in ((a, b), (b, c), (c, a)):
            middle = tuple(Fraction(x + y) / 2 for x, y in zip(points[p], points[q]))
            if middle not in index:
                index[middle] = len(points)
                points.append(middle)
            middles.append(index[middle])
        ab, bc, ca = middles
        out += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return points, out


def prism(outline, width, caps):
    """A polygon (x, z), clockwise seen from -y, between y = -width and y = width, with triangles of it as caps."""
    count = len(outline)
    points = [(x, -width, z) for x, z in outline] + [(x, width, z) for x, z in outline]
    sides = [(k, k + count, (k + 1) % count + count, (k + 1) % count) for k in range(count)]
    return points, sides + [tuple(c) for c in caps] + [tuple(k + count for k in reversed(c)) for c in caps]


def sheet(profile, width):
    """An open ground over a profile (x, z) from left to right."""
    count = len(profile)
    points = [(x, -width, z) for x, z in profile] + [(x, width, z) for x, z in profile]
    return points, [(k, k + 1, k + 1 + count, k + count) for k in range(count - 1)]


class Surface:
    """Corners and edges as they are, by comparing planes."""

    def __init__(self, points, faces):
        self.points = [tuple(map(Fraction, p)) for p in points]
        self.faces = triangles(faces)
        self.sides, self.around = {}, {}
        for f in self.faces:
            for a, b in ((f[0], f[1]), (f[1], f[2]), (f[2], f[0])):
                self.sides.setdefault(frozenset((a, b)), []).append(f)
            for v in f:
                self.around.setdefault(v, []).append(f)
        self.edges = [e for e, own in self.sides.items() if len(own) == 1 or primitive(self.normal(own[0])) != primitive(self.normal(own[1]))]
        self.corners = [v for v in self.around if self.is_corner(v)]

    def normal(self, f):
        a, b, c = (self.points[k] for k in f)
        return cross(minus(b, a), minus(c, a))

    def is_corner(self, v):
        ways = [primitive(minus(self.points[next(iter(e - {v}))], self.points[v])) for e in self.edges if v in e]
        return bool(ways) and not (len(ways) == 2 and ways[0] == tuple(-x for x in ways[1]))

    def ends(self, v):
        """The corners that straight edges lead to."""
        out = []
        for e in self.edges:
            if v not in e:
                continue
            last, at = v, next(iter(e - {v}))
            while at not in self.corners:
                last, at = at, next(next(iter(g - {at})) for g in self.edges if at in g and last not in g)
            out.append(self.points[at])
        return out

    def opposite(self, edge):
        return [self.points[next(iter(set(f) - edge))] for f in self.sides[edge]]


def over(surface, face, point, band):
    """The height of a point over a face in shares of the normal, where it is within the band and over it; else None."""
    n, corners = surface.normal(face), [surface.points[k] for k in face]
    height = dot(n, minus(point, corners[0]))
    if height * height > band * band * dot(n, n):
        return None
    for p, q in zip(corners, corners[1:] + corners[:1]):
        if dot(cross(minus(q, p), minus(point, p)), n) < 0:
            return None
    return height / dot(n, n)


def brute(rock, ground, band):
    """(point on the ground, primitive normal) of all contacts."""
    found = set()
    for v in rock.corners:
        for face in ground.faces:
            n, share = ground.normal(face), over(ground, face, rock.points[v], band)
            if share is None:
                continue
            behind = [min(0, dot(n, minus(end, ground.points[face[0]]))) for end in rock.ends(v)]
            if any(dot(rock.normal(f), n) < 0 for f in rock.around[v]) and all(h * h <= band * band * dot(n, n) for h in behind):
                found.add((tuple(p - share * x for p, x in zip(rock.points[v], n)), primitive(n)))
    for w in ground.corners:
        about = {u for f in ground.around[w] for u in f}
        for face in rock.faces:
            n = rock.normal(face)
            if over(rock, face, ground.points[w], band) is None or any(dot(n, minus(ground.points[u], ground.points[w])) < 0 for u in about):
                continue
            found.add((ground.points[w], primitive([-x for x in n])))
    for e in rock.edges:
        p, pp = (rock.points[k] for k in e)
        for g in ground.edges:
            q, qq = (ground.points[k] for k in g)
            u, v, w = minus(pp, p), minus(qq, q), minus(q, p)
            c = cross(u, v)
            square = dot(c, c)
            if square == 0 or dot(w, c) ** 2 > band * band * square:
                continue
            s, t = dot(cross(w, v), c) / square, dot(cross(w, u), c) / square
            if not (0 <= s <= 1 and 0 <= t <= 1):
                continue
            ways = [way for way in (1, -1) if all(way * dot(c, minus(o, p)) >= 0 for o in rock.opposite(e))
                    and all(way * dot(c, minus(o, q)) <= 0 for o in ground.opposite(g))]
            if len(ways) == 1:
                found.add((tuple(a + t * b for a, b in zip(q, v)), primitive([ways[0] * x for x in c])))
    return found


def hulls(found):
    """Without those that lie between two or within three others of one plane and normal, by trying all."""
    def between(p, others):
        for a in others:
            for b in others:
                if a != b and cross(minus(a, p), minus(b, p)) == (0, 0, 0) and dot(minus(a, p), minus(b, p)) < 0:
                    return True
        return False

    def within(p, others, n):
        """No line through p in the plane has all others on one side."""
        for a in others:
            across = cross(n, minus(a, p))
            sides = [dot(across, minus(b, p)) for b in others]
            if all(s <= 0 for s in sides) or all(s >= 0 for s in sides):
                return False
        return True

    kept = set()
    for p, n in found:
        others = [q for q, m in found if m == n and q != p and dot(m, minus(q, p)) == 0]
        if not others or not (between(p, others) or (len(others) > 2 and within(p, others, n))):
            kept.add((p, n))
    return kept


class GroundCase(SceneCase):
    def on(self, bands, rest, more="", base="file: ground.obj"):
        return self.put("scene.yaml", self.text(bands, rest, more, base))

    @staticmethod
    def text(bands, rest, more="", base="file: ground.obj"):
        return (f"topple: 1\nlength_unit: m\nsolid:\n  file: rock.obj\n  unit: m\n  azimuths: 8\n  bands: {bands}\n"
                f"  base: {{{base}}}\n{more}{rest}")

    def meshes(self, rock, ground):
        self.put("rock.obj", exact_obj(*rock))
        self.put("ground.obj", exact_obj(*ground))

    def same(self, one, other):
        """Tilts, factors and accelerations."""
        for key in ("critical_deg", "fos", "acceleration_g"):
            self.assertEqual(key in one, key in other)
            if key in one:
                self.assertLessEqual(abs(one[key]["value"] - other[key]["value"]), one[key]["error"] + other[key]["error"] + 1e-9)


class References(GroundCase):
    def test_flat_ground_is_the_plane(self):
        """The rock of the examples on two triangles: what touches, tilts towards all azimuths, the least and its factor are those of
        the plane base, for every band."""
        self.put("rock.obj", (ROOT / "examples" / "solids" / "balanced_rock.obj").read_text(encoding="ascii"))
        self.put("ground.obj", exact_obj([(-2, -2, 0), (2, -2, 0), (2, 2, 0), (-2, 2, 0)], [(0, 1, 2), (0, 2, 3)]))
        bands, rest = [0.005, 0.01, 0.02], "friction_angle_deg: 12\n"
        for band in bands:
            plane = self.told(self.put("plane.yaml", "topple: 1\nlength_unit: m\nsolid: {file: rock.obj, unit: m, azimuths: 8, "
                                                     f"bands: {band}}}\n{rest}"))["bands"][0]
            got = self.told(self.on([band], rest))
            own, contacts = got["ground"]["bands"][0], got["contacts"]
            self.assertEqual((own["found"], own["contacts"], own["normals_deg"]), (plane["touching"], len(plane["support"]), 0))
            self.assertEqual(got["ground"]["entered_m"], 0)
            for way, azimuth in zip(contacts["ways"], plane["rose"]):
                self.assertLessEqual(abs(way["critical_deg"]["value"] - azimuth["critical_deg"]["value"]),
                                     way["critical_deg"]["error"] + azimuth["critical_deg"]["error"])
            self.assertLessEqual(abs(own["critical_deg"]["value"] - plane["critical_deg"]["value"]), own["critical_deg"]["error"] + 1e-9)
        together = self.told(self.on([0.02, 0.005, 0.01], rest))["ground"]
        self.assertEqual((together["governing_band"], [b["contacts"] for b in together["bands"]]), (0.005, [10, 6, 9]))
        tilts = [b["critical_deg"]["value"] for b in together["bands"]]
        self.assertGreaterEqual(tilts[0] + 1e-6, tilts[2])
        self.assertGreaterEqual(tilts[2] + 1e-6, tilts[1])

    def test_groove(self):
        """A prism in a groove of the half-angle eta: tan = mu / sqrt(sin^2 eta - mu^2 cos^2 eta) along it; interlocked from tan eta,
        that included: it was undecided where both are 45 degrees. A motion begins at mu / sin eta: what is proven ends before."""
        for run_, rise, phi in ((1, 1, 20), (7, 4, 25), (4, 3, 60), (1, 1, 45)):
            rock = prism([(0, 0), (Fraction(run_), Fraction(rise)), (-Fraction(run_), Fraction(rise))], 3, [(0, 1, 2)])
            self.meshes(rock, sheet([(-2 * run_, 2 * rise), (0, 0), (2 * run_, 2 * rise)], 9))
            got = self.told(self.on("0", f"friction_angle_deg: {phi}\ntilt: {{angle_deg: 5, azimuth_deg: 0}}\n"))
            eta, mu = math.atan2(run_, rise), math.tan(math.radians(phi))
            proven = got["contacts"]["verdict"] == "stands"
            self.assertTrue(proven or got["contacts"]["verdict"] == "may move")
            onset = mu / math.sin(eta) / math.tan(math.radians(5))
            for factor in got["safety"]["states"][0]["factors"]:
                self.assertLessEqual(factor.get("least", 0), onset)
                self.assertGreaterEqual(factor.get("least", 0), 1 if proven else 0)
            self.assertAlmostEqual(got["ground"]["bands"][0]["normals_deg"], 180 - 2 * math.degrees(eta), 9)
            if phi == 45 or mu >= math.tan(eta):
                self.assertNotIn("critical_deg", got["contacts"])
                self.assertEqual(got["contacts"]["ways"][0]["mechanism"], "interlocked")
                continue
            own = got["contacts"]["critical_deg"]
            truth = math.degrees(math.atan2(mu, math.sqrt(math.sin(eta) ** 2 - (mu * math.cos(eta)) ** 2)))
            self.assertLessEqual(abs(own["value"] - truth), own["error"] + 1e-12)

    def test_extruded_block_in_the_plane(self):
        """Block E of Alejano et al., extruded, on its extruded teeth: the limit of the tool in the plane, both ways."""
        for under in ([(0, 0), (30, 5), (60, 0), (90, 5)], [(0, 5), (30, 0), (60, 5), (90, 0)]):
            outline = under + [(90, 125), (0, 125)]
            caps = [(0, 1, 5), (1, 2, 5), (2, 4, 5), (2, 3, 4)]
            for base in ([(-30, under[1][1])] + under + [(120, under[2][1])], under):
                self.meshes(prism(outline, 40, caps), sheet(base, 200))
                for phi in (15, 30):
                    self.compare(outline, base, phi)

    def compare(self, outline, base, phi):
        flat = self.told(self.put("flat.yaml", f"topple: 1\nlength_unit: m\nblock: {{outline: {[list(p) for p in outline]}}}\n"
                                               f"base: {{profile: {[list(p) for p in base]}}}\nfriction_angle_deg: {phi}\ntilt: {{towards: both}}\n"))
        for case in flat["cases"]:
            azimuth = 270 if case["towards"] == "left" else 90
            got = self.told(self.on("0", f"friction_angle_deg: {phi}\ntilt: {{angle_deg: 1, azimuth_deg: {azimuth}}}\n"))
            one, other = case["limit"]["critical_angle_deg"], got["contacts"]["critical_deg"]
            self.assertLessEqual(abs(one["value"] - other["value"]), one["error"] + other["error"] + 1e-9)

    def test_ledge(self):
        """A box half over the end of its ground: the corners of the ground's end carry it, as the plane's support cut there."""
        self.meshes(box((-1, -1, 0), (1, 1, 2)), ([(-5, -5, 0), (Fraction(1, 2), -5, 0), (Fraction(1, 2), 5, 0), (-5, 5, 0)], [(0, 1, 2), (0, 2, 3)]))
        got = self.told(self.on("0", "friction_angle_deg: 40\ntilt: {angle_deg: 1, azimuth_deg: 90}\n"))
        self.assertEqual(sorted(tuple(c["at"]) for c in got["contacts"]["contacts"]), [(-1, -1, 0), (-1, 1, 0), (0.5, -1, 0), (0.5, 1, 0)])
        self.assertAlmostEqual(got["contacts"]["critical_deg"]["value"], math.degrees(math.atan(0.5)), 9)
        self.assertEqual(got["contacts"]["verdict"], "stands")


class Chance(GroundCase):
    def drawn(self, draw):
        """A bumpy ball over bumpy ground, as near as it gets without being refused."""
        ball, faces = octahedron((1, 1, Fraction(1, 4)), (0, 0, 0), 1)
        ball = [tuple(Fraction(round(64 * x) + draw.randint(-4, 4), 64) for x in p) for p in ball]
        ground = grid([[Fraction(draw.randint(-12, 12), 64) for _ in range(6)] for _ in range(6)], Fraction(3, 4), (Fraction(-15, 8) + Fraction(draw.randint(-9, 9), 64), -2))
        return (ball, faces), ground

    def compare(self, rock, ground, band):
        self.meshes(rock, ground)
        path = self.on(float(band), "friction_angle_deg: 30\n")
        status, out, err = run("solve", "--json", path)
        if status == 3:
            return 0, err
        self.assertEqual(status, 0, err)
        got = json.loads(out)
        found = brute(Surface(*rock), Surface(*ground), band)
        kept = hulls(found)
        self.assertEqual(got["ground"]["bands"][0]["contacts"], len(kept))
        left = list(kept)
        for c in got["contacts"]["contacts"]:
            near = [k for k in left if math.dist(list(map(float, k[0])), c["at"]) < 1e-12
                    and math.dist([x / math.hypot(*k[1]) for x in k[1]], c["normal"]) < 1e-12]
            self.assertEqual(len(near), 1)
            left.remove(near[0])
        return len(kept), ""

    def test_all_pairs(self):
        """Contacts, to the last: lowered until it enters deeper than the band."""
        draw, most, kinds = random.Random(11), 0, 0
        for _ in range(rounds(3, 30)):
            (ball, faces), ground = self.drawn(draw)
            for k in range(20, 0, -1):
                lifted = [(x, y, z + Fraction(k, 32)) for x, y, z in ball]
                count, err = self.compare((lifted, faces), ground, Fraction(1, 16))
                most, kinds = max(most, count), kinds + (count > 0)
                if "enters" in err:
                    break
                self.assertIn(bool(err), (count == 0,))
        self.assertGreater(most, 2)
        self.assertGreater(kinds, 5)


class Smooth(GroundCase):
    def test_mean_of_the_normals(self):
        """A prism in a groove is wedged in it, and slides at phi on a plane across the mean of both sides. It begins to slide along the groove at
        27.2 degrees; up to which factor it does not is not decided. What is required is not met where it is not with the mean."""
        self.meshes(prism([(0, 0), (1, 1), (-1, 1)], 3, [(0, 1, 2)]), sheet([(-2, 2), (0, 0), (2, 2)], 9))
        rest = "friction_angle_deg: 20\ntilt: {angle_deg: 15, azimuth_deg: 0}\n"
        got = self.told(self.on("0", rest))
        own, plane = got["ground"]["bands"][0], math.tan(math.radians(20)) / math.tan(math.radians(15))
        self.assertAlmostEqual(own["smooth_critical_deg"]["value"], 20, 6)
        self.assertAlmostEqual(own["smooth_fos"]["value"], plane, 6)
        self.assertEqual((own["verdict"], own["smooth_verdict"]), ("stands", "stands"))
        self.assertNotIn("fos", own)
        self.assertGreater(got["contacts"]["fos_driving"]["value"], 1.4)
        for required, met in ((1.3, "open"), (1.4, "not met")):
            status, out, err = run("solve", "--json", self.on("0", rest + f"required_fos: {required}\n"))
            self.assertEqual((status, json.loads(out)["meets_required"]), (4 if met == "open" else 1, met), err)
            self.assertAlmostEqual(json.loads(out)["safety"]["most"], plane, 6)


class Invariance(GroundCase):
    """The same bumpy ball on the same bumpy ground, told otherwise."""

    def setUp(self):
        super().setUp()
        draw = random.Random(5)
        (ball, faces), self.ground = Chance.drawn(self, draw)
        lowest = Fraction(3, 8)
        self.rock = [(x, y, z + lowest) for x, y, z in ball], faces
        self.rest = "friction_angle_deg: 30\ntilt: {angle_deg: 2, azimuth_deg: 50}\n"
        self.plain = self.got(self.rock, self.ground)
        self.assertGreater(self.plain["ground"]["bands"][0]["contacts"], 1)

    def got(self, rock, ground, rest=None, **more):
        self.meshes(rock, ground)
        return self.told(self.on("0.125", rest or self.rest, **more))

    def test_far_away(self):
        def far(mesh):
            return [tuple(x + 10 ** 15 for x in p) for p in mesh[0]], mesh[1]
        got = self.got(far(self.rock), far(self.ground))
        self.assertEqual(got["ground"]["bands"], self.plain["ground"]["bands"])

    def test_mirrored(self):
        def mirrored(mesh):
            return [(-x, y, z) for x, y, z in mesh[0]], [f[::-1] for f in mesh[1]]
        got = self.got(mirrored(self.rock), mirrored(self.ground), self.rest.replace("50", "310"))
        one, other = got["ground"]["bands"][0], self.plain["ground"]["bands"][0]
        self.assertEqual((one["contacts"], one["widest_m"], one["verdict"]), (other["contacts"], other["widest_m"], other["verdict"]))
        self.same(one, other)

    def test_other_unit(self):
        """The ground in millimetres."""
        ground = [tuple(1000 * x for x in p) for p in self.ground[0]], self.ground[1]
        got = self.got(self.rock, ground, base="file: ground.obj, unit: mm")
        self.assertEqual(got["ground"]["bands"], self.plain["ground"]["bands"])

    def test_known_length(self):
        """The ground in steps of 0.4 m, told by a length along an axis; of the root of 2 times that, told aslant; the rock in such steps, too,
        by one length for both or by two; the scene in feet, where a foot is a whole number of the ground's steps."""
        def scaled(mesh, by):
            return [tuple(by * x for x in p) for p in mesh[0]], mesh[1]
        steps = Fraction(5, 2)
        one = self.plain["ground"]["bands"][0]
        got = self.got(self.rock, scaled(self.ground, steps), base="file: ground.obj, scale: {from: [0, 1, 0], to: [5, 1, 0], length: 2}")
        self.assertEqual(got["ground"]["bands"], self.plain["ground"]["bands"])
        self.assertAlmostEqual(got["ground"]["metres_per_unit"], 0.4, 15)
        aslant = "scale: {from: [0, 0, 0], to: [5, 5, 0], length: 2.82842712474619009760337744841939615714}"
        for rock, unit, base in ((self.rock, "unit: m", f"file: ground.obj, {aslant}"), (scaled(self.rock, steps), aslant, "file: ground.obj"),
                                 (scaled(self.rock, steps), aslant, f"file: ground.obj, {aslant}")):
            self.meshes(rock, scaled(self.ground, steps))
            other = self.told(self.put("scene.yaml", self.text("0.125", self.rest, base=base).replace("unit: m\n  az", unit + "\n  az")))["ground"]["bands"][0]
            self.assertEqual((one["contacts"], one["verdict"]), (other["contacts"], other["verdict"]))
            self.assertAlmostEqual(one["widest_m"], other["widest_m"], 12)
            self.same(one, other)
        self.meshes(self.rock, scaled(self.ground, 12))
        feet = self.text("0.125", self.rest, base="file: ground.obj, unit: in").replace("m\nsolid", "ft\nsolid").replace("unit: m\n", "unit: ft\n")
        other = self.told(self.put("scene.yaml", feet))["ground"]["bands"][0]
        self.assertEqual((one["contacts"], one["verdict"]), (other["contacts"], other["verdict"]))
        self.same(one, other)
        self.assertAlmostEqual(other["widest_m"], 0.3048 * one["widest_m"], 12)

    def test_subdivided(self):
        """Corners in faces and on edges are none."""
        for rock, ground in ((divided(*self.rock), self.ground), (self.rock, divided(*self.ground)), (divided(*self.rock), divided(*divided(*self.ground)))):
            one, other = self.got(rock, ground)["ground"]["bands"][0], self.plain["ground"]["bands"][0]
            self.assertEqual((one["contacts"], one["widest_m"], one["verdict"]), (other["contacts"], other["widest_m"], other["verdict"]))
            self.same(one, other)

    def test_wider_bands_hold_no_less(self):
        self.meshes(self.rock, self.ground)
        bands = self.told(self.on("[0.125, 0.2, 0.3, 0.5]", self.rest))["ground"]["bands"]
        for one, other in zip(bands, bands[1:]):
            self.assertLessEqual(one["found"], other["found"])
            if "fos" in one and "fos" in other:
                self.assertLessEqual(one["fos"]["value"], other["fos"]["value"] + 1e-6)
        self.assertGreater(bands[-1]["found"], bands[0]["found"])


class Depth(GroundCase):
    REST = "friction_angle_deg: 30\n"
    FLAT = [(-5, -5, 0), (5, -5, 0), (5, 5, 0), (-5, 5, 0)], [(0, 1, 2), (0, 2, 3)]

    def test_box_that_sinks(self):
        """By 0.1 into coarse ground and fine; within the band of 0.1 it is taken, and told."""
        fine = grid([[0] * 41 for _ in range(41)], Fraction(1, 4), (-5, -5))
        for ground in (self.FLAT, fine):
            self.meshes(box((-1, -1, Fraction(-1, 10)), (1, 1, 2)), ground)
            self.wrong(self.on("0.05", self.REST), "enters the ground by 0.1 m", "triangle", "deeper than the band of 0.05 m")
            self.assertAlmostEqual(self.told(self.on("0.1", self.REST))["ground"]["entered_m"], 0.1, 12)

    def test_hill_within(self):
        """A steep cone of the ground stands 0.5 high in the midst of the rock's sole, where this has no corner."""
        ground = grid([[Fraction(max(0, 5 - abs(i - 40) - abs(j - 40)), 10) for i in range(81)] for j in range(81)], Fraction(1, 8), (-5, -5))
        self.meshes(box((-2, -2, 0), (2, 2, 2)), ground)
        self.wrong(self.on("0.3", self.REST), "enters the ground by 0.5 m")

    def test_edge_across_a_ridge(self):
        """No corner of one is in the other: the rock's edge cuts the ridge by 0.25."""
        rock = prism([(0, 0), (1, 1), (-1, 1)], 3, [(0, 1, 2)])
        ridge = [(-4, -1, -1), (-4, 0, Fraction(1, 4)), (-4, 1, -1), (4, -1, -1), (4, 0, Fraction(1, 4)), (4, 1, -1)], [(0, 3, 4, 1), (1, 4, 5, 2)]
        self.meshes(rock, ridge)
        self.wrong(self.on("0.2", self.REST), "enters the ground by 0.25 m")
        self.assertAlmostEqual(self.told(self.on("0.25", self.REST))["ground"]["entered_m"], 0.25, 12)

    def test_all_of_it_below(self):
        self.meshes(box((-1, -1, -1), (1, 1, 1)), grid([[0] * 41 for _ in range(41)], Fraction(1, 4), (-5, -5)))
        self.wrong(self.on("0.05", self.REST), "enters the ground by 1 m")

    def test_gap(self):
        self.meshes(box((-1, -1, Fraction(1, 8)), (1, 1, 2)), self.FLAT)
        self.wrong(self.on("0.1", self.REST), "0.125 m apart at the least", "farther than the band of 0.1 m", "move one")
        self.told(self.on("0.125", self.REST))


class Refusals(GroundCase):
    def setUp(self):
        super().setUp()
        self.meshes(box((-1, -1, 0), (1, 1, 2)), Depth.FLAT)

    def test_words(self):
        friction = "friction_angle_deg: 30\n"
        for scene, told in (
                (self.text("0", friction, base="file: ground.obj, dip_deg: 3"), ["'dip_deg'", "leave it out"]),
                (self.text("0", friction, base="unit: mm"), ["'unit'", "'file'"]),
                (self.text("0", friction, base="file: ground.obj, unit: furlong"), ["unit must be one of"]),
                (self.text("0", friction, base="file: ground.obj, unit: m, scale: {from: [0, 0, 0], to: [1, 0, 0], length: 2}"), ["'unit'", "'scale'", "not both"]),
                (self.text("0", friction, base="file: ground.obj, scale: {from: [0, 0, 0], to: [0, 0, 0], length: 2}"), ["one point"]),
                (self.text("0", friction, base="dip_deg: 3, dip_direction_deg: 4, scale: {from: [0, 0, 0], to: [1, 0, 0], length: 2}"), ["'scale'", "'file'"]),
                (self.text("0", ""), ["needs friction"]),
                (self.text("0", friction + "tilt: {angle_deg: 3}\n"), ["'azimuth_deg'"]),
                (self.text("0", friction + "loads: {seismic: {horizontal: 0.1}}\n"), ["'azimuth_deg'"]),
                (self.text("0", friction, more="  below: 0.1\n"), ["'below'"]),
                (self.text("0", friction, more="  thin: 0.1\n"), ["'thin'", "touches it with its own surface", "beforehand"]),
                (self.text("0", friction, more="  contacts: [{at: [0, 0, 0]}]\n"), ["'contacts'", "'bands'"])):
            self.wrong(self.put("scene.yaml", scene), *told)
        status, out, err = run("solve", self.on("0", friction, base="file: none.obj"))
        self.assertEqual((status, out), (5, ""), err)
        self.assertIn("none.obj", err)

    def test_ground_that_is_none(self):
        friction = "friction_angle_deg: 30\n"
        points, faces = Depth.FLAT
        for mesh, told in (((points, [f[::-1] for f in faces]), ["upside down"]),
                           ((points, [faces[0], faces[1][::-1]]), ["against each other", "not repaired"]),
                           ((points + [(0, 0, 0)], [(0, 1, 2), (0, 2, 3), (0, 4, 2)]), ["no area"])):
            self.put("ground.obj", exact_obj(*mesh))
            self.wrong(self.on("0", friction), *told, "ground.obj")

    def test_too_many(self):
        """A thousand contacts and more, none within the hull of others: peaks under a flat sole, each of another height."""
        heights = [[Fraction(0) if i % 2 or j % 2 else 1 - Fraction(i * 81 + j, 10 ** 6) for i in range(81)] for j in range(81)]
        self.put("ground.obj", exact_obj(*grid(heights, Fraction(1, 40), (-1, -1))))
        self.put("rock.obj", exact_obj(*box((-2, -2, 1), (2, 2, 3))))
        self.wrong(self.on("0.01", "friction_angle_deg: 30\n"), "contacts within the band", "1000")


if __name__ == "__main__":
    main()
