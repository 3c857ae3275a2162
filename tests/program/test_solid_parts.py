#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Holes and parts of another unit weight inside a solid.

The oracle adds fractions: moments of each mesh by itself, times how much more than the rock it weighs."""

import json
import random
import unittest
from fractions import Fraction

from harness import main, rounds, run
from mesh_case import box, octahedron, triangles
from solid_oracle import Oracle
from test_solid_scenes import SceneCase
from test_solids import exact_obj, written

TWO = (box((0, 0, 0), (2, 2, 2)))
GAMMA = 26
#: A box of two layers, whose sides are parted where they meet.
LAYERS = ([(x, y, z) for z in (0, 1, 3) for x, y in ((0, 0), (4, 0), (4, 4), (0, 4))],
          [(0, 3, 2, 1), (8, 9, 10, 11)] + [(4 * k + c, 4 * k + (c + 1) % 4, 4 * k + 4 + (c + 1) % 4, 4 * k + 4 + c) for k in (0, 1) for c in range(4)])
LOWER = LAYERS[0], [LAYERS[1][0], (4, 5, 6, 7)] + LAYERS[1][2:6]
UPPER = LAYERS[0], [(4, 7, 6, 5), LAYERS[1][1]] + LAYERS[1][6:]


def moved(mesh, way):
    return [tuple(x + w for x, w in zip(p, way)) for p in mesh[0]], mesh[1]


class PartCase(SceneCase):
    def inside(self, rock, holes=(), parts=(), more="", head=""):
        """A scene of meshes; parts are (mesh, unit weight)."""
        self.put("rock.obj", exact_obj(*rock))
        listed = {"holes": [], "parts": []}
        for kind, k, mesh, more_of in ([("holes", k, mesh, "") for k, mesh in enumerate(holes)]
                                       + [("parts", k, mesh, f", unit_weight_kn_m3: {weight}") for k, (mesh, weight) in enumerate(parts)]):
            self.put(f"{kind}{k}.obj", exact_obj(*mesh))
            listed[kind].append(f"{{file: {kind}{k}.obj{more_of}}}")
        text = "".join(f"  {kind}: [{', '.join(own)}]\n" for kind, own in listed.items() if own)
        return self.put("scene.yaml", f"topple: 1\nlength_unit: m\n{head}solid:\n  file: rock.obj\n  unit: m\n  bands: [0]\n  azimuths: 4\n"
                                      f"  unit_weight_kn_m3: {GAMMA}\n{text}{more}")


class Moments(PartCase):
    def compare(self, rock, holes=(), parts=()):
        got = self.told(self.inside(rock, holes, parts))
        own = [(Sums(p, f), Fraction(share)) for (p, f), share in (
            [((rock[0], triangles(rock[1])), 1)] + [((m[0], triangles(m[1])), -1) for m in holes]
            + [((m[0], triangles(m[1])), Fraction(w) / GAMMA - 1) for m, w in parts])]
        weighed = sum(s * o.volume for o, s in own)
        volume = own[0][0].volume - sum(o.volume for o, s in own if s == -1)
        centroid = [sum(s * o.volume * o.centroid[k] for o, s in own) / weighed for k in range(3)]
        self.holds(got["volume_m3"], volume)
        self.holds(got["weight_n"], 1000 * GAMMA * weighed)
        for k in range(3):
            self.holds(got["centroid_m"][k], centroid[k])
        for k, (i, j) in enumerate(((0, 0), (1, 1), (2, 2), (1, 2), (2, 0), (0, 1))):
            about = sum(s * (o.inertia[k] + o.volume * o.centroid[i] * o.centroid[j]) for o, s in own) - weighed * centroid[i] * centroid[j]
            self.holds(got["inertia_m5"][k], about * volume / weighed)
        for told, (o, _) in zip(got["parts"], own[1:]):
            self.holds(told["volume_m3"], o.volume)
        return got

    def test_cubes(self):
        """A cube with a heavy cube and a hole in it; layers that fill a box, and touch its surface and one another over the same faces."""
        got = self.compare(TWO, [box((Fraction(1, 4),) * 3, (1, 1, 1))], [(box((1, 1, 1), (1.5, 1.5, 1.75)), 30)])
        self.assertEqual([(p["is_hole"], p.get("unit_weight_kn_m3")) for p in got["parts"]], [(True, None), (False, 30)])
        self.compare(LAYERS, [], [(LOWER, 20), (UPPER, 28)])

    def test_by_chance(self):
        draw = random.Random(5)
        for _ in range(rounds(3, 100)):
            rock = octahedron((4, 5, 6), (draw.randint(-9, 9), 1, 2), level=1)
            low = [min(p[a] for p in rock[0]) for a in range(3)]
            high = [max(p[a] for p in rock[0]) for a in range(3)]
            middle = [(x + y) / 2 for x, y in zip(low, high)]
            at = [[m + side * Fraction(draw.randint(10, 15), 10) for m in middle] for side in (-1, 1)]
            hole, part = (octahedron([Fraction(draw.randint(1, 9), 10) for _ in range(3)], own, level=draw.randint(0, 1)) for own in at)
            self.compare(rock, [hole], [(part, draw.choice((2, 20, 31, Fraction(59, 2))))])

    def test_same_density(self):
        """A part of the rock's own unit weight changes nothing; mirrored, and 10^15 away, it does the same."""
        plain, part = self.told(self.inside(TWO)), box((1, 1, 1), (1.5, 1.75, 1.25))
        same = self.told(self.inside(TWO, [], [(part, GAMMA)]))
        for key in ("volume_m3", "weight_n"):
            self.assertEqual(same[key]["value"], plain[key]["value"])
        (one, other) = (state["bands"][0]["least"] for state in (same, plain))
        self.assertEqual((one["edge_from"], one["edge_to"]), (other["edge_from"], other["edge_to"]))
        for key in ("tilt_deg", "azimuth_deg"):  # at another level each
            self.assertLessEqual(abs(one[key]["value"] - other[key]["value"]), one[key]["error"] + other[key]["error"])
        near = self.told(self.inside(TWO, [], [(part, 40)]))
        way = (10 ** 15, -3 * 10 ** 15, 7 * 10 ** 14)
        far = self.told(self.inside(moved(TWO, way), [], [(moved(part, way), 40)]))
        self.assertEqual(far["bands"][0]["least"]["tilt_deg"], near["bands"][0]["least"]["tilt_deg"])
        self.assertEqual(far["inertia_m5"], near["inertia_m5"])
        turned = [([(-x, y, z) for x, y, z in p], [f[::-1] for f in faces]) for p, faces in (TWO, part)]
        mirrored = self.told(self.inside(turned[0], [], [(turned[1], 40)]))
        self.assertAlmostEqual(mirrored["bands"][0]["least"]["tilt_deg"]["value"], near["bands"][0]["least"]["tilt_deg"]["value"], 12)
        self.assertAlmostEqual(mirrored["centroid_m"][0]["value"], -near["centroid_m"][0]["value"], 12)

    def test_edge_of_standing(self):
        """A frustum on its small end, of 112 m³, with a part of 3.2 m³ at x = 2: the foot of the centroid lies on the edge x = 1 where that
        weighs 35 times the rock more; and 10^-30 to either side it stands or does not."""
        points = [(x * w, y * w, z) for w, z in ((1, 0), (4, 4)) for y in (-1, 1) for x in (-1, 1)]
        rock, part = (points, TWO[1]), box((1, -1, 3), (3, 1, Fraction(19, 5)))
        for weight, stands in ((f"{36 * GAMMA}", False), (f"{36 * GAMMA - 1}.{'9' * 30}", True)):
            status, out, err = run("solve", "--json", self.inside(rock, [], [(part, weight)]))
            self.assertIn(status, (0, 4), err)  # at a tilt of 0 that is as close to the critical one
            got = json.loads(out)
            self.assertEqual((got["bands"][0]["stands"], got["level"]), (stands, "exact"))

    def test_swept(self):
        """The unit weight of a part is set, swept and told as others are."""
        path = self.inside(TWO, [], [(box((1, 1, 1), (1.5, 1.5, 1.5)), 30)])
        got = self.told(path, "--set", "solid.parts.1.unit_weight_kn_m3=20")
        self.assertEqual(got["parts"][0]["unit_weight_kn_m3"], 20)
        status, out, err = run("solve", path)
        self.assertEqual(status, 0, err)
        self.assertIn("parts0.obj, 30 kN/m³", out)
        status, out, err = run("solve", "--figure", f"{self.folder}/a.svg", path)
        self.assertEqual(status, 0, err)


class Sums(Oracle):
    """Moments alone."""

    def _facets(self):
        return {}


class Refused(PartCase):
    def test_where_they_lie(self):
        """Outside, across, around the rock, on one another, on the rock's surface: by triangle, with the file that it is of."""
        cube, hole = box((0.5, 0.5, 0.5), (1, 1, 1)), box((1, 1, 1), (1.5, 1.5, 1.5))
        for holes, parts, told in (
                ([], [(box((3, 3, 3), (4, 4, 4)), 30)], "parts0.obj:9: face 1 of this part lies outside of the rock"),
                ([], [(box((-1, -1, -1), (4, 4, 4)), 30)], "face 1 of this part lies outside of the rock"),
                ([], [(box((1, 1, 1), (4, 1.5, 1.5)), 30)], "parts0.obj:9: face 1 of this mesh and face 4 of"),
                ([], [(cube, 30), (box((0.75, 0.75, 0.75), (1.5, 1.5, 1.5)), 20)], "of this mesh and face"),
                ([], [(cube, 30), (cube, 20)], "face 1 of this part lies on the same side as the part"),
                ([], [(cube, 30), (box((0.6, 0.6, 0.6), (0.75, 0.75, 0.75)), 20)], "face 1 of this part lies inside the part"),
                ([cube], [(box((0.25, 0.25, 0.25), (1.5, 1.5, 1.5)), 20)], "face 1 of this hole lies inside the part"),
                ([(TWO[0], TWO[1])], [], "face 1 of this hole touches the surface of"),
                ([cube, hole], [], "touches the hole of"),
                ([(cube[0], triangles(cube[1])[1:])], [], "holes0.obj:9: the surface is open"),
                ([(cube[0], [f[::-1] for f in cube[1]])], [], "inside out")):
            with self.subTest(told=told):
                self.wrong(self.inside(TWO, holes, parts), told)
        self.wrong(self.inside(LAYERS, [], [(UPPER, 20), (UPPER, 30)]), "lies on the same side as the part")
        tower = box((0, 0, 2), (2, 2, 4))
        self.wrong(self.inside(TWO, [], [((tower[0], tower[1]), 30)]), "lies outside of the rock")

    def test_keys(self):
        path = self.inside(TWO, [TWO], [(TWO, 30)])
        with open(path, encoding="utf-8") as text:
            scene = text.read()
        for old, new, told in ((f"  unit_weight_kn_m3: {GAMMA}\n", "", "scene.yaml:9:10: parts of another density need the solid's"),
                               (", unit_weight_kn_m3: 30", "", "'unit_weight_kn_m3' is missing"),
                               ("unit_weight_kn_m3: 30", "unit_weight_kn_m3: 0", "a void is a hole"),
                               ("{file: parts0.obj", "{object: a", "'file' is missing"),
                               ("{file: holes0.obj}", "{file: holes0.obj, colour: red}", "unknown key 'colour'"),
                               ("[{file: holes0.obj}]", "holes0.obj", "a list of meshes")):
            with self.subTest(told=told):
                self.wrong(self.put("scene.yaml", scene.replace(old, new)), told)


if __name__ == "__main__":
    main()
