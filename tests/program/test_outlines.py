# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""`solve --json --outlines`: what a program draws is what was solved.

The area that a path encloses, by its own points (curves by Bezier's formula), is the area that the solution tells; facets of
contact are as long as it says; each point of a scene lies where `placed` says, also of a block that was set down. Paths are
printed to nine digits, which bounds what may differ."""

import json
import math
import pathlib
import re
import tempfile
import unittest

from harness import ROOT, example_scenes, main, run

PRINTED = 5e-9  # nine digits of a coordinate, as a share of the largest
CURVES = 5e-6   # what a cubic curve leaves of its arc, as a share of the radius (src/presentation/shape/chain.c)
STEPS = 64      # chords of a curve: 64 of an eighth of a turn leave 2e-5 of the segment's area
EXAMPLES = example_scenes()


def points(path):
    """The pieces of a path as lists of points, curves as chords."""
    pieces = []
    for letter, words in re.findall(r"([MLCZ])([^MLCZ]*)", path):
        numbers = [float(word) for word in words.split()]
        if letter == "M":
            pieces.append([tuple(numbers)])
        elif letter == "L":
            pieces[-1].append(tuple(numbers))
        elif letter == "C":
            p, q, r, s = pieces[-1][-1], *zip(numbers[::2], numbers[1::2])
            for k in range(1, STEPS + 1):
                t = k / STEPS
                pieces[-1].append(tuple((1 - t) ** 3 * a + 3 * t * (1 - t) ** 2 * b + 3 * t * t * (1 - t) * c + t ** 3 * d
                                        for a, b, c, d in zip(p, q, r, s)))
    return pieces


def area(path):
    """Enclosed by the first piece, less its other pieces, which are holes."""
    areas = [abs(math.fsum(x0 * y1 - x1 * y0 for (x0, y0), (x1, y1) in zip(piece, piece[1:] + piece[:1]))) / 2
             for piece in points(path)]
    return areas[0] - math.fsum(areas[1:])


class Outlines(unittest.TestCase):
    def solved(self, scene, folder=ROOT):
        status, out, err = run("solve", "--json", "--outlines", scene, folder=folder)
        self.assertIn(status, (0, 4), err)
        return json.loads(out)

    def written(self, text):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = pathlib.Path(folder.name) / "scene.yaml"
        path.write_text("topple: 1\nlength_unit: m\n" + text, encoding="utf-8")
        return path

    def test_the_block_drawn_has_the_area_that_is_told(self):
        for scene in EXAMPLES:
            with self.subTest(scene=scene.name):
                document = self.solved(scene)
                lies, case = document["outlines"], document["cases"][0]
                x0, y0, x1, y1 = lies["box_m"]
                size = max(x1 - x0, y1 - y0)
                curved = CURVES + 1e-5 if "C" in lies["block"] else 0
                self.assertAlmostEqual(area(lies["block"]), case["block"]["area_m2"]["value"],
                                       delta=8 * size ** 2 * (PRINTED + curved))

    def test_the_contact_drawn_is_as_long_as_is_told(self):
        for scene in EXAMPLES:
            with self.subTest(scene=scene.name):
                document = self.solved(scene)
                lies, contact = document["outlines"], document["cases"][0]["contact"]
                pieces = points(lies["contact"])
                length = math.fsum(math.dist(a, b) for piece in pieces for a, b in zip(piece, piece[1:]))
                size = max(map(abs, lies["box_m"]))
                self.assertAlmostEqual(length, contact["length_m"]["value"], delta=size * PRINTED * (2 + 2 * contact["facets"]))
                to = lies["placed"]["results"]
                told = [(contact[end]["x_m"]["value"], contact[end]["y_m"]["value"]) for end in ("left_end", "right_end")]
                ends = [(to["cosine"] * x - to["sine"] * y + to["x_m"], to["sine"] * x + to["cosine"] * y + to["y_m"]) for x, y in told]
                for end in ends if contact["points"] == 0 and pieces else []:
                    self.assertLess(min(math.dist(end, at) for piece in pieces for at in piece), 1e-8 * size)

    def test_points_of_a_scene_lie_where_it_says(self):
        """A block that leans, set down on a joint far from the origin, and one whose coordinates are the world's."""
        block = [(1000000, 50), (1000003, 50.5), (1000002.5, 56), (999999.5, 55)]
        scenes = {
            "rests": "base: {profile: [[999990, 48], [1000001, 49], [1000010, 49.5]], place: rest}\n",
            "world": "frame: world\nbase: {between: [[1000000, 50], [1000003, 50.5]]}\n",
            "plain": "",
        }
        for name, more in scenes.items():
            with self.subTest(scene=name):
                lies = self.solved(self.written(f"block: {{outline: {[list(p) for p in block]}}}\n" + more))["outlines"]
                told = lies["placed"]["block"]
                drawn = points(lies["block"])[0]
                self.assertAlmostEqual(math.hypot(told["cosine"], told["sine"]), 1, delta=1e-12)
                for x, y in block:
                    at = (told["cosine"] * x - told["sine"] * y + told["x_m"], told["sine"] * x + told["cosine"] * y + told["y_m"])
                    self.assertLess(min(math.dist(at, other) for other in drawn), 1e-7)

    def test_a_mirrored_scene_is_drawn_mirrored(self):
        block = [(0, 0), (3, 0), (4, 5), (1, 4)]
        one = self.solved(self.written(f"block: {{outline: {[list(p) for p in block]}}}\n"))["outlines"]
        other = self.solved(self.written(f"block: {{outline: {[[-x, y] for x, y in reversed(block)]}}}\n"))["outlines"]
        of_one = sorted((round(-x - one["origin_x_m"], 7), round(y + one["origin_y_m"], 7)) for x, y in points(one["block"])[0])
        of_other = sorted((round(x + other["origin_x_m"], 7), round(y + other["origin_y_m"], 7))
                          for x, y in points(other["block"])[0])
        self.assertEqual(of_one, of_other)

    def test_a_million_vertices_are_thinned(self):
        """What no screen shows is left out, and the area stays within that."""
        with tempfile.TemporaryDirectory() as folder:
            count = 100000
            ring = [(math.cos(2 * math.pi * k / count), math.sin(2 * math.pi * k / count)) for k in range(count)]
            rows = "".join(f"{x:.12f},{y + 1:.12f}\n" for x, y in ring)
            (pathlib.Path(folder) / "ring.csv").write_text("x,y\n" + rows, encoding="utf-8")
            path = pathlib.Path(folder) / "scene.yaml"
            path.write_text("topple: 1\nlength_unit: m\nblock: {outline: ring.csv}\nbase: {profile: [[-2, 0], [2, 0]]}\n"
                            "contact: {within: 1e-6}\n", encoding="utf-8")
            status, out, err = run("solve", "--json", "--outlines", path)
            self.assertEqual(status, 0, err)
            document = json.loads(out)
            self.assertLess(len(document["outlines"]["block"]), 2_000_000)
            self.assertAlmostEqual(area(document["outlines"]["block"]), math.pi, delta=1e-3)

    def test_many_blocks(self):
        """Each encloses its area, in the order of the blocks; in other lengths, far from the origin, the same lies there."""
        names = ("toppling_slope", "wet_columns", "jointed_slope")
        for name in names:
            document = self.solved(ROOT / "examples" / "blocks" / f"{name}.yaml")
            lies = document["outlines"]
            size = max(lies["box_m"][2] - lies["box_m"][0], lies["box_m"][3] - lies["box_m"][1])
            self.assertEqual(len(lies["blocks"]), len(document["blocks"]))
            for block, path in zip(document["blocks"], lies["blocks"]):
                with self.subTest(scene=name, block=block["name"]):
                    self.assertAlmostEqual(area(path), block["area_m2"]["value"], delta=1e-7 * max(size ** 2, block["area_m2"]["value"]))
        loads = self.solved(ROOT / "examples" / "blocks" / "wet_columns.yaml")["outlines"]
        self.assertEqual(([each["first_kpa"] for each in loads["surcharges"]], len(loads["anchors"]), len(points(loads["water"][0])[0])), ([20], 2, 5))
        wall = "block: {unit_weight_kn_m3: 20}\nfriction_angle_deg: 30\ntilt: {towards: left}\nblocks:\n" \
            "  - {name: a, ground: true, outline: [[1000000, 0], [1000004, 0], [1000004, 1], [1000000, 1]]}\n" \
            "  - {name: b, slab: {width: 2, height: 3}, at: [1000001, 1]}\n"
        lies = self.solved(self.written(wall))["outlines"]
        self.assertEqual([(x + lies["origin_x_m"], y + lies["origin_y_m"]) for x, y in points(lies["blocks"][1])[0]],
                         [(1000001, 1), (1000003, 1), (1000003, 4), (1000001, 4)])

    def test_what_it_goes_with(self):
        for words in (["--outlines"], ["--json", "--outlines", "--find", "a", "--for", "critical_angle=20"]):
            status, out, err = run("solve", *words, ROOT / "examples" / "block_e_valley.yaml")
            self.assertEqual((status, out), (2, ""))
            self.assertIn("--outlines goes with --json", err)


if __name__ == "__main__":
    main()
