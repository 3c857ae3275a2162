#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Scenes of a solid: its tilt, its earthquake, its factor, and what may be set, swept and drawn in them.

The oracle follows the resultant from the centroid to the base: the solid stands where that point lies in the polygon of what
touches, and slides where the resultant leaves the cone of friction. Azimuths that are open it tries by the hundred."""

import csv
import io
import json
import math
import pathlib
import random
import re
import struct
import unittest
from fractions import Fraction

from harness import main, run
from mesh_case import box, triangles
from test_solids import FRUSTUM, PRISM, SIX, Case, exact_obj

ROCK = "examples/solids/balanced_rock.yaml"
STEPS = 360


def unit(azimuth):
    return math.sin(math.radians(azimuth)), math.cos(math.radians(azimuth))


class Stance:
    """A convex polygon seen from the foot of the centroid, counter-clockwise, and the height of this over it."""

    def __init__(self, corners, height, friction):
        self.corners, self.height, self.mu = corners, height, math.tan(math.radians(friction))

    def resultant(self, tilt, towards, horizontal, vertical, quake):
        """In the base: what pulls along it east and north, and what presses on it."""
        d, (te, tn), (qe, qn) = math.radians(tilt), unit(towards), unit(quake)
        along, across = qe * te + qn * tn, qe * tn - qn * te
        down = (1 - vertical) * math.sin(d) + horizontal * along * math.cos(d)
        on = (1 - vertical) * math.cos(d) - horizontal * along * math.sin(d)
        side = horizontal * across
        return down * te + side * tn, down * tn - side * te, on

    def moves(self, pull_east, pull_north, on):
        """(topples, slides)"""
        if on <= 0:
            return True, True
        at = self.height * pull_east / on, self.height * pull_north / on
        edges = zip(self.corners, self.corners[1:] + self.corners[:1])
        topples = any((q[0] - p[0]) * (at[1] - p[1]) - (q[1] - p[1]) * (at[0] - p[0]) < 0 for p, q in edges)
        return topples, math.hypot(pull_east, pull_north) > on * self.mu

    def factor(self, pull_east, pull_north, on):
        """The least by which the pull may grow, by halving."""
        low, high = 0.0, 1.0
        while not any(self.moves(high * pull_east, high * pull_north, on)):
            high *= 2
            if high > 1e9:
                return math.inf
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (low, middle) if any(self.moves(middle * pull_east, middle * pull_north, on)) else (middle, high)
        return low

    def safety(self, tilt, pull_east, pull_north, on):
        """On driving loads, what presses on the base by the weight alone stays; by strength where it does not topple anyway."""
        rests = math.cos(math.radians(tilt))

        def at(f):
            return f * pull_east, f * pull_north, rests - f * (rests - on)
        low, high = 0.0, 1.0
        while not any(self.moves(*at(high))):
            high *= 2
            if high > 1e9:
                return math.inf
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (low, middle) if any(self.moves(*at(middle))) else (middle, high)
        pull = math.hypot(pull_east, pull_north)
        return low if self.moves(pull_east, pull_north, on)[0] or pull == 0 else min(low, on * self.mu / pull)

    def acceleration(self, tilt, towards, quake):
        low, high = 0.0, 1e4
        if not any(self.moves(*self.resultant(tilt, towards, high, 0, quake))):
            return math.inf
        for _ in range(80):
            middle = (low + high) / 2
            low, high = (low, middle) if any(self.moves(*self.resultant(tilt, towards, middle, 0, quake))) else (middle, high)
        return low


class SceneCase(Case):
    def scene(self, solid, rest="", head="length_unit: m\n"):
        return self.put("scene.yaml", f"topple: 1\n{head}solid: {{file: rock.obj, unit: m, bands: [0], {solid}}}\n{rest}")

    def told(self, path, *words):
        status, out, err = run("solve", "--json", path, *words)
        self.assertEqual(status, 0, err)
        return json.loads(out)

    def wrong(self, path, *told):
        status, out, err = run("solve", path)
        self.assertEqual((status, out), (3, ""), err)
        for words in told:
            self.assertIn(words, err)


class Stances(SceneCase):
    def oracle(self, got, friction):
        band = got["bands"][0]
        return Stance([(c["east_m"], c["north_m"]) for c in band["support"]], band["height_m"]["value"], friction)

    def test_earthquakes_and_tilts(self):
        """Any tilt and any earthquake, their azimuths given or open, against the point that the resultant meets."""
        draw = random.Random(7)
        self.put("rock.obj", exact_obj(*PRISM))
        stood = fell = 0
        for k in range(24):
            tilt, towards, quake = draw.randint(0, 30), draw.randint(0, 359), draw.randint(0, 359)
            horizontal, vertical, friction = draw.randint(0, 30) / 100, draw.randint(-10, 20) / 100, draw.randint(15, 60)
            open_tilt, open_quake = k % 3 == 2, k % 3 > 0
            rest = (f"friction_angle_deg: {friction}\ntilt: {{angle_deg: {tilt}{'' if open_tilt else f', azimuth_deg: {towards}'}}}\n"
                    f"loads: {{seismic: {{horizontal: {horizontal}, vertical: {vertical}{'' if open_quake else f', azimuth_deg: {quake}'}}}}}\n")
            got = self.told(self.scene("azimuths: 5", rest))
            own, stance = self.oracle(got, friction), got["bands"][0]["stance"]
            ways = [(t, q) for t in (range(0, STEPS) if open_tilt else [towards])
                    for q in ([t] if open_tilt else range(0, STEPS) if open_quake else [quake])]
            pulls = [own.resultant(tilt, t, horizontal, vertical, q) for t, q in ways]
            still = [own.resultant(tilt, t, 0, 0, q) for t, q in ways]
            factor = min(own.safety(tilt, *p) for p in pulls + still)
            tolerance = 0.01 * factor if open_quake else 1e-9 * factor  # of trying azimuths by whole degrees
            safety = got["safety"]
            self.assertLessEqual(safety.get("least", 0), factor + 1e-9)
            self.assertGreaterEqual(safety.get("most", math.inf), factor - tolerance)
            if "fos" in stance:
                self.assertLessEqual(stance["fos"]["value"], factor + 1e-9)
                self.assertGreaterEqual(stance["fos"]["value"], factor - tolerance)
            else:
                self.assertEqual(safety["motion"], "collapses")
            moves = any(any(own.moves(*p)) for p in pulls)
            self.assertEqual(stance["verdict"] == "stands", not moves)
            stood, fell = stood + (not moves), fell + moves
            if open_tilt or any(own.moves(*own.resultant(tilt, towards, 0, 0, 0))):
                self.assertNotIn("acceleration_g", stance)
                continue
            if vertical == 0:
                continue
            got = self.told(self.scene("azimuths: 5", rest), "--set", "loads.seismic.vertical=0")
            least = min(own.acceleration(tilt, towards, q) for q in range(0, STEPS, 3))
            stance = got["bands"][0]["stance"]
            self.assertLessEqual(stance["acceleration_g"]["value"], least + 1e-9)
            self.assertGreaterEqual(stance["acceleration_g"]["value"], 0.99 * least)
            found = own.acceleration(tilt, towards, stance["acceleration_azimuth_deg"]["value"])
            self.assertAlmostEqual(found, stance["acceleration_g"]["value"], 9)
            for rose in got["bands"][0]["rose"]:
                truth = own.acceleration(tilt, towards, rose["azimuth_deg"])
                self.assertAlmostEqual(rose.get("acceleration_g", {"value": math.inf})["value"], truth, 8)
        self.assertGreater(min(stood, fell), 3)

    def test_sliding_by_hand(self):
        """A flat box, 30 wide and 1 high: g tan(phi - d) down the dip, and tan(phi) over tan(d)."""
        self.put("rock.obj", exact_obj(*box((0, 0, 0), (30, 30, 1))))
        got = self.told(self.scene("unit_weight_kn_m3: 26", "friction_angle_deg: 30\ntilt: {angle_deg: 10, azimuth_deg: 90}\n"))
        stance = got["bands"][0]["stance"]
        self.assertAlmostEqual(stance["acceleration_g"]["value"], math.tan(math.radians(20)), 13)
        self.assertAlmostEqual(stance["acceleration_azimuth_deg"]["value"], 90, 10)
        self.assertAlmostEqual(stance["fos"]["value"], math.tan(math.radians(30)) / math.tan(math.radians(10)), 12)
        self.assertEqual(stance["fos_mechanism"], "slides")

    def test_base_that_dips(self):
        """A mesh turned onto its dip, 3-4-5, has the answers of the one that lies level and is tilted as much."""
        dip = math.degrees(math.atan2(3, 4))
        self.put("rock.obj", exact_obj(FRUSTUM, SIX))
        level = self.told(self.scene("azimuths: 8", f"friction_angle_deg: 50\ntilt: {{angle_deg: {dip!r}, azimuth_deg: 90}}\n"))
        turned = [((4 * x + 3 * z) / Fraction(5), y, (4 * z - 3 * x) / Fraction(5)) for x, y, z in FRUSTUM]
        self.put("rock.obj", exact_obj(turned, SIX))
        path = self.scene(f"azimuths: 8, base: {{dip_deg: {dip!r}, dip_direction_deg: 90}}", "friction_angle_deg: 50\n").replace("[0]", "[0]")
        with open(path, encoding="utf-8") as text:
            lines = text.read().replace("bands: [0]", "bands: [1e-9]")
        slanted = self.told(self.put("scene.yaml", lines))
        for key in ("fos", "critical_deg", "acceleration_g"):
            self.assertAlmostEqual(level["bands"][0]["stance"][key]["value"], slanted["bands"][0]["stance"][key]["value"], 8)
        self.assertEqual(slanted["tilt_angle_deg"], dip)


def root(number):
    """Exact where it is a whole number, else to 60 digits."""
    whole = math.isqrt(number)
    return Fraction(whole) if whole * whole == number else Fraction(math.isqrt(number * 10 ** 120), 10 ** 60)


def laid(points, up):
    """Points of a mesh with z upwards, in the axes of one that the least turn of `up` makes it of: p_x east + p_y north + p_z u. Upside
    down the turn is that about x. Written with 40 digits where they are no decimals."""
    x, y, z = up
    if (x, y) == (0, 0):
        return [(a, b, c) if z > 0 else (a, -b, -c) for a, b, c in points]
    length = root(x * x + y * y + z * z)
    x, y, z = x / length, y / length, z / length
    rise = (x * x + y * y) / (1 - z)  # 1 + z
    axes = (1 - x * x / rise, -x * y / rise, -x), (-x * y / rise, 1 - y * y / rise, -y), (x, y, z)
    turned = [tuple(sum(p[n] * axes[n][k] for n in range(3)) for k in range(3)) for p in points]
    return [tuple(c if (c * 10 ** 12).denominator == 1 else Fraction(round(c * 10 ** 40), 10 ** 40) for c in p) for p in turned]


class Slopes(SceneCase):
    """A base that dips, below a mesh of which any direction is up: azimuths are those of the frame that the least turn brings upright, so
    that the mesh brought upright, by fractions here, has the same answers with z upwards."""

    LOADS = "friction_angle_deg: 40\nloads: {seismic: {horizontal: 0.03, azimuth_deg: 200}}\n"

    def lies(self, points, up, dip, direction, bands="[2]", faces=PRISM[1]):
        self.put("rock.obj", exact_obj(points, faces))
        with open(self.scene(f"azimuths: 24, up: {up}, base: {{dip_deg: {dip}, dip_direction_deg: {direction}}}", self.LOADS),
                  encoding="utf-8") as text:
            return self.told(self.put("scene.yaml", text.read().replace("bands: [0]", f"bands: {bands}")))

    def same(self, one, other, path=""):
        """Numbers by their own bounds: both have the truth within them. Points of the support are doubles of a rock of size 10."""
        self.assertEqual(type(one), type(other), path)
        if isinstance(one, dict) and "error" in one:
            apart = abs(one["value"] - other["value"])
            if "azimuth" in path:
                apart = min(apart, 360 - apart)
            self.assertLessEqual(apart, 1.01 * (one["error"] + other["error"]) + 1e-15, path)  # bounds are printed in doubles, too
            self.assertLess(other["error"], 1e-9, path)
        elif isinstance(one, dict):
            self.assertEqual(one.keys(), other.keys(), path)
            for key in one.keys() - {"edge_from", "edge_to"}:  # these are in the axes of the mesh
                self.same(one[key], other[key], f"{path}.{key}")
        elif isinstance(one, list):
            self.assertEqual(len(one), len(other), path)
            for k, (p, q) in enumerate(zip(one, other)):
                self.same(p, q, f"{path}.{k}")
        elif isinstance(one, float):
            self.assertAlmostEqual(one, other, 13, path)
        else:
            self.assertEqual(one, other, path)

    def support(self, got):
        """From the corner that is farthest to the north: which comes first depends on the axes of the mesh."""
        band = got["bands"][0]
        corners = band["support"]
        first = max(range(len(corners)), key=lambda k: round(corners[k]["north_m"], 9) + 1e-6 * round(corners[k]["east_m"], 9))
        band["support"] = corners[first:] + corners[:first]
        return band

    def test_any_up(self):
        """Rational turns, of which all decisions are the same, and roots; almost and wholly upside down; and three points of a level."""
        plain = self.support(self.lies(PRISM[0], [0, 0, 1], 20, 130))
        self.assertEqual((len(plain["support"]), plain["stance"]["verdict"]), (3, "stands"))
        for up in ([0, 1, 0], [-1, 0, 0], [0, 0, -1], [12, 16, 15], [20, 12, -9], [1, 1, 1], [-3, 1, -2], [1, 2, -10 ** 9]):
            with self.subTest(up=up):
                self.same(plain, self.support(self.lies(laid(PRISM[0], up), up, 20, 130)))
        level = [[float(c) for c in p] for p in laid([(5, 1, 0), (-2, 3, 0), (1, -4, 0)], [4, 0, 3])]
        self.same(plain, self.support(self.lies(laid(PRISM[0], [4, 0, 3]), {"points": level}, 20, 130)))

    def test_exactly(self):
        """On a base that stands on end its side touches without a band, of four corners that a hair would part: a rational turn keeps that.
        A base without a dip is across `up`, of any length: the corner of a cube on its three neighbours."""
        plain = self.support(self.lies(PRISM[0], [0, 0, 1], 90, 90, "[0]"))
        self.assertEqual(plain["touching"], 4)
        for up in ([0, 1, 0], [0, 0, -7], [12, 16, 15], [20, 12, -9]):
            with self.subTest(up=up):
                self.same(plain, self.support(self.lies(laid(PRISM[0], up), up, 90, 90, "[0]")))
        corner = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
        got = self.lies(corner[0], [-1, -1, -1], 0, 77, "[0]", corner[1])
        self.assertEqual((got["bands"][0]["touching"], got["bands"][0]["stands"]), (3, True))

    def test_mirrored(self):
        """In a mirror across x every azimuth is its opposite, the earthquake's too, and factors stay."""
        points, up = laid(PRISM[0], [20, 12, -9]), [20, 12, -9]
        one = self.lies(points, up, 20, 130)["bands"][0]
        self.LOADS = self.LOADS.replace("200", "160")
        other = self.lies([(-x, y, z) for x, y, z in points], [-20, 12, -9], 20, 230, faces=[f[::-1] for f in PRISM[1]])["bands"][0]
        other["rose"] = [dict(way, azimuth_deg=(360 - way["azimuth_deg"]) % 360) for way in other["rose"][:1] + other["rose"][:0:-1]]
        for key in ("rose", "critical_deg", "height_m", "touching"):
            self.same(one[key], other[key], key)
        for key in ("fos", "critical_deg", "acceleration_g", "verdict"):
            self.same(one["stance"][key], other["stance"][key], key)

    def test_drawn(self):
        """The model of glTF has the rock on its base, east, up and south of the foot of its centroid: the same for every direction of up."""
        models = []
        for up in ([0, 0, 1], [20, 12, -9]):
            self.lies(laid(PRISM[0], up), up, 20, 130)
            status, out, err = run("solve", "--figure", f"{self.folder}/a.glb", f"{self.folder}/scene.yaml")
            self.assertEqual((status, err), (0, ""))
            models.append(pathlib.Path(f"{self.folder}/a.glb").read_bytes())
        length = struct.unpack_from("<I", models[0], 12)[0]
        (view,) = [v for v in json.loads(models[0][20:20 + length])["bufferViews"][:1]]
        rocks = []
        for model in models:
            own = struct.unpack_from("<I", model, 12)[0]
            rocks.append(struct.unpack_from(f"<{view['byteLength'] // 4}f", model, 28 + own + view.get("byteOffset", 0)))
        for one, other in zip(*rocks):
            self.assertAlmostEqual(one, other, 5)


class Lengths(SceneCase):
    def test_scale_and_three_points(self):
        """By a known length, and lying on three points in either order: as the same in its unit and upright."""
        self.put("rock.obj", exact_obj(*PRISM))
        plain = self.told(self.scene("up: [0, 0, 1]"))
        for order in ("[0, 0, 0], [3, 0, 0], [0, 4, 0]", "[0, 4, 0], [3, 0, 0], [0, 0, 0]"):
            path = self.scene(f"scale: {{from: [0, 0, 0], to: [3, 4, 0], length: 2500}}, up: {{points: [{order}]}}",
                              head="length_unit: mm\n").replace("unit: m, ", "")
            with open(path, encoding="utf-8") as text:
                scaled = self.told(self.put("scene.yaml", text.read().replace("unit: m, ", "")))
            self.assertEqual(plain["bands"][0]["least"]["tilt_deg"]["value"], scaled["bands"][0]["least"]["tilt_deg"]["value"])
            self.assertAlmostEqual(scaled["volume_m3"]["value"], plain["volume_m3"]["value"] / 8, 13)

    def test_persistence(self):
        """A box of 1, 2 and 3: over its edges the centroid rises to half the diagonals of its faces."""
        self.put("rock.obj", exact_obj(*box((0, 0, 0), (1, 2, 3))))
        poses = self.told(self.scene("azimuths: 1"))["poses"]
        low, high = math.sqrt(5) / 2, math.sqrt(10) / 2
        rises = sorted(p["persistence_m"]["value"] for p in poses if "persistence_m" in p)
        for rise, truth in zip(rises, sorted([low - 0.5, low - 1, low - 1, high - 1.5, high - 1.5])):
            self.assertAlmostEqual(rise, truth, 13)
        self.assertEqual(len(rises), 5)

    def test_one_pose_or_seventeen(self):
        """Each side of a prism of 17 has the foot of the centroid at its end, 10^-30 within or beyond, as in the solid with one
        stable face of Conway and Guy (1969); pyramids on both ends put the centroid there."""
        for hair, count in ((Fraction(1, 10 ** 30), 17), (-Fraction(1, 10 ** 30), 1)):
            with self.subTest(poses=count):
                c, s, r = Fraction(117, 125), Fraction(44, 125), (Fraction(0), Fraction(1))
                right = [r]
                for _ in range(8):
                    shrunk = c * (1 + hair)
                    r = shrunk * (c * r[0] + s * r[1]), shrunk * (c * r[1] - s * r[0])
                    right.append(r)
                ring = [(-x, y) for x, y in right[:0:-1]] + right  # clockwise from the bottom left
                ring = ring[::-1]
                doubled = [p[0] * q[1] - p[1] * q[0] for p, q in zip(ring, ring[1:] + ring[:1])]
                middle = sum((p[1] + q[1]) * d for p, q, d in zip(ring, ring[1:] + ring[:1], doubled)) / (3 * sum(doubled))
                apex = Fraction(round(-(6 * Fraction(2, 500) + 3) * middle * 10 ** 70), 10 ** 70)  # 2/5 long between pyramids of 100
                n = len(ring)
                half = Fraction(1, 5)
                points = [(*p, -half) for p in ring] + [(*p, half) for p in ring] + [(0, apex, -100 - half), (0, apex, 100 + half)]
                faces = [(k, (k + 1) % n, (k + 1) % n + n, k + n) for k in range(n)]
                faces += [((k + 1) % n, k, 2 * n) for k in range(n)] + [(k + n, (k + 1) % n + n, 2 * n + 1) for k in range(n)]
                self.assertEqual(n, 17)
                self.assertEqual(len(self.solve(exact_obj(points, triangles(faces)), "--band=0")["poses"]), count)


class Varied(SceneCase):
    def test_swept_as_set(self):
        """A sweep of the tilt says what solve says with each number set, and a row what JSON says."""
        status, out, err = run("sweep", ROCK, "--x=tilt.angle_deg=0,4,14", "--y=solid.bands.1=0.005,0.001")
        self.assertEqual(status, 0, err)
        rows = list(csv.DictReader(io.StringIO(out)))
        self.assertEqual(len(rows), 6)
        for row in rows:
            status, out, err = run("solve", "--csv", ROCK, "--set", f"tilt.angle_deg={row['tilt.angle_deg']}", "--set",
                                   f"solid.bands.1={row['solid.bands.1_m']}")
            self.assertEqual(status, 0, err)
            (own,) = csv.DictReader(io.StringIO(out))
            for key in own.keys() - {"scene"}:
                self.assertEqual(own[key], row[key], key)
        self.assertEqual({row["verdict"] for row in rows}, {"stands", "topples"})
        self.assertEqual([row["fos"] != "" for row in rows], [True] * 3 + [False] * 3)

    def test_study(self):
        """Rows of a study are those of solve with its numbers; the share that moves adds up."""
        rows = self.put("unused", "") + ".csv"
        status, out, err = run("study", "examples/solids/balanced_rock_study.yaml", "--csv", rows, "--json")
        self.assertEqual(status, 0, err)
        told = json.loads(out)
        with open(rows, encoding="utf-8") as text:
            lines = list(csv.DictReader(line for line in text if not line.startswith("#")))
        own = told["tilts"][0]["outcomes"]
        self.assertEqual(sum(line["outcome"] == "stands" for line in lines), next(o["samples"] for o in own if o["outcome"] == "stands"))
        for line in lines[:4]:
            words = [w for key in ("friction_angle_deg", "tilt.azimuth_deg") for w in ("--set", f"{key}={line[key]}")]
            band = next(key for key in line if key.startswith("solid.bands.1"))
            status, out, err = run("solve", "--csv", ROCK, *words, "--set", f"solid.bands.1={line[band]}")
            self.assertEqual(status, 0, err)
            (solved,) = csv.DictReader(io.StringIO(out))
            self.assertEqual(solved["verdict"], line["outcome"])
            self.assertAlmostEqual(float(solved["fos"]), float(line["fos"]), 8)

    def test_required(self):
        for required, status in ((1.2, 0), (5, 1)):
            ended, out, err = run("solve", ROCK, "--fail-below", str(required))
            self.assertEqual(ended, status, err)


    def test_answer(self):
        """The report begins with the answer, of the band that governs, in the numbers that the tables below it have; the figure is headed
        by the same words."""
        ended, out, err = run("solve", ROCK)
        self.assertEqual(ended, 0, err)
        answer = " ".join(out.split("\n\n")[1].split())
        own = json.loads(run("solve", "--json", ROCK)[1])
        band = min(own["bands"], key=lambda b: b["band"])
        stance = band["stance"]
        self.assertEqual(band["band"], own["governing_band"])
        self.assertIn(f"Tilted by 5° towards 120° and under its earthquake it {stance['verdict']}: factor of safety "
                      f"{math.floor(1e3 * stance['fos']['value']) / 1e3:.3f} against toppling.", answer)
        self.assertIn(f"acceleration that moves it is {stance['acceleration_g']['value']:.4g} g", answer)
        self.assertIn(f"topples at {band['least']['tilt_deg']['value']:.5g}°, towards {band['least']['azimuth_deg']['value']:.0f}°", answer)
        self.assertTrue(answer.endswith(f"So by the least band, {band['band']} m, which governs."), answer)
        self.assertLessEqual(max(len(line) for line in out.split("\n\n")[1].splitlines()), 80)


class Figures(SceneCase):
    def test_drawn(self):
        """The same bytes each time, in three formats; what is said stands in the text; a mesh that has changed is refused."""
        for name in ("rock.svg", "rock.pdf", "rock.png"):
            paths = [f"{self.folder}/{k}{name}" for k in (1, 2)]
            for path in paths:
                status, out, err = run("solve", "--figure", path, ROCK)
                self.assertEqual((status, err), (0, ""))
                self.assertIn("factor of safety", out.replace("The factor is", "factor of safety"))
            one, other = (pathlib.Path(path).read_bytes() for path in paths)
            self.assertGreater(len(one), 5000)
            if not name.endswith("pdf"):
                self.assertEqual(one, other)
        status, out, err = run("solid", "--unit=m", "--figure", f"{self.folder}/a.svg", "examples/solids/balanced_rock.obj")
        self.assertEqual((status, err), (0, ""))
        for path, told in ((f"{self.folder}/a.dxf", ".svg, .pdf, .png or .glb"), (ROCK, ".svg, .pdf, .png"), ("/nowhere/a.svg", "nowhere")):
            status, out, err = run("solve", "--figure", path, ROCK)
            self.assertNotEqual(status, 0)
            self.assertIn(told, err)

    def test_shape(self):
        """A box is drawn as wide as it is tall where it is: from above its corners lie where they are, and the support with them."""
        self.put("rock.obj", exact_obj(*box((0, 0, 0), (2, 1, 4))))
        status, out, err = run("solve", "--figure", f"{self.folder}/b.svg", self.scene("azimuths: 8"))
        self.assertEqual((status, err), (0, ""))
        text = pathlib.Path(f"{self.folder}/b.svg").read_text(encoding="utf-8")
        self.assertEqual(text.count("<image"), 2)


class Refused(SceneCase):
    def test_messages(self):
        self.put("rock.obj", exact_obj(*PRISM))
        for solid, rest, told in (("colour: red", "", "scene.yaml:3:46: unknown key 'colour'"),
                                  ("up: [0, 0, 0]", "", "not 0"), ("up: [1, 2]", "", "[x, y, z]"),
                                  ("up: {points: [[0, 0, 0], [1, 1, 1], [2, 2, 2]]}", "", "one line"),
                                  ("scale: {from: [0, 0, 0], to: [0, 0, 1], length: 1}", "", "not both"),
                                  ("object: roof", "", "no object"), ("azimuths: 99999", "", "36000"),
                                  ("base: {dip_deg: 5}", "", "dip_direction_deg"),
                                  ("base: {dip_deg: 5, dip_direction_deg: 4}", "tilt: {angle_deg: 5}", "scene.yaml:4:7"),
                                  ("", "base: {mated: true}", "scene.yaml:4:7: 'base' is of a scene of a block"),
                                  ("", "tilt: {towards: left}", "azimuth_deg"),
                                  ("", "loads: {bond_kpa: 3}", "a solid takes 'seismic'"),
                                  ("", "loads: {seismic: {horizontal: 1, direction: both}}", "azimuth_deg"),
                                  ("", "tilt: {angle_deg: 3}\nloads: {seismic: {horizontal: 1, azimuth_deg: 3}}", "tilt.azimuth_deg")):
            with self.subTest(told=told):
                self.wrong(self.scene(solid, rest + "\n"), told)
        self.wrong(self.put("scene.yaml", "topple: 1\nlength_unit: m\nsolid: {file: rock.obj}\n"), "'bands' is missing")
        self.put("rock.obj", exact_obj(PRISM[0], triangles(PRISM[1])[1:]))
        self.wrong(self.scene(""), "rock.obj", "open")

    def test_other_commands(self):
        for words in (("tilt", ROCK), ("derive", ROCK), ("solve", ROCK, "--elements"),
                      ("solve", ROCK, "--find", "friction_angle_deg", "--for", "fos=1")):
            status, out, err = run(*words)
            self.assertNotEqual(status, 0, words)
            self.assertEqual(out, "")
            self.assertTrue(re.search("solid|loads", err), err)


if __name__ == "__main__":
    main()
