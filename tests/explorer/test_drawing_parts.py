# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Parts of the explorer's drawing that need no page, by node: which of many vertices get handles, how long its scale is,
and the film of a tilt test against the numbers that `topple tilt` prints. And what is said while its libraries are built."""

import json
import math
import pathlib
import random
import re
import sys
import tempfile
import time
import unittest

from node_case import NODE, node
from page_case import ROOT, run
from harness import main

EXPLORER = ROOT / "src" / "applications" / "explorer"
DRAWING = EXPLORER / "drawing"
YAML = EXPLORER / "node_modules" / "yaml"


@unittest.skipIf(NODE is None, "there is no node: install Debian's package nodejs")
class Parts(unittest.TestCase):
    def test_handles_near_hand_and_contact(self):
        """Of a thousand vertices 150 have handles: the 75 nearest to the hand, which brute force finds as well, and those
        nearest to the contact; one that is dragged keeps its own, and what lies outside of the window has none."""
        draw = random.Random(7)
        points = [[draw.uniform(0, 900), draw.uniform(0, 500)] for _ in range(1000)] + [[-5000, 0], [300, 900]]
        hand, contact, kept = [700, 100], [[100, 480], [400, 480]], "v3"
        body = """const view = {width: 800, height: 500, matrix: [1, 0, 0, 1, 0, 0], toScreen: (x, y) => ({x, y})};
          const of = (p) => ({x: p[0], y: p[1]});
          const {chosen, hidden} = it.nearestOf(given.points.map((p, i) => ({key: "v" + i, at: of(p)})), view,
            {hand: given.hand && of(given.hand), contact: given.contact.map(of), kept: new Set([given.kept])});
          return [chosen.map((one) => Number(one.key.slice(1))), hidden];"""
        chosen, hidden = node(DRAWING / "nearest.js", body, {"points": points, "hand": hand, "contact": contact, "kept": kept})
        self.assertEqual(len(chosen), 150)
        self.assertEqual(chosen, sorted(chosen))
        inside = [i for i, (x, y) in enumerate(points) if (-20 < x < 820 and -20 < y < 520) or i == 3]
        self.assertEqual(hidden, len(inside) - 150)
        near = sorted(inside, key=lambda i: math.dist(points[i], hand))
        self.assertLessEqual(set(near[:74]) | {3}, set(chosen))
        rest = set(chosen) - set(near[:75]) - {3}
        farthest = max(self.from_contact(points[i], contact) for i in rest)
        left_out = [i for i in inside if i not in chosen]
        self.assertLessEqual(farthest, min(self.from_contact(points[i], contact) for i in left_out))
        few, none = node(DRAWING / "nearest.js", body, {"points": points[:100], "hand": None, "contact": [], "kept": ""})
        self.assertEqual((few, none), ([i for i in range(100) if points[i][0] < 820], 0))

    @staticmethod
    def from_contact(point, contact):
        share = min(1, max(0, (point[0] - contact[0][0]) / (contact[1][0] - contact[0][0])))
        return math.dist(point, (contact[0][0] + share * (contact[1][0] - contact[0][0]), contact[0][1]))

    def test_scale_of_a_round_length(self):
        """1, 2 or 5 times a power of ten, and the next longer one would not fit."""
        draw = random.Random(8)
        given = [10 ** draw.uniform(-9, 9) for _ in range(500)] + [1, 140, 0.14, 70, 28]
        for dots, found in zip(given, node(DRAWING / "scale_bar.js", "return given.map((one) => it.roundLength(one));", given)):
            length = found["length"]
            first = length / 10 ** math.floor(math.log10(length) + 1e-9)
            self.assertIn(round(first, 9), (1, 2, 5))
            self.assertLessEqual(length * dots, 140 * (1 + 1e-12))
            self.assertGreater(length * (2 if round(first) != 2 else 2.5) * dots, 140 * (1 - 1e-12))

    def test_film_of_a_tilt_test(self):
        """At the moments that the program prints the film has its numbers; between them it lies between; the time runs from
        0 to the end and back; a slab topples, and its film says so event by event."""
        folder = ROOT / "build"
        path = folder / "explorer_film.yaml"
        path.write_text("topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 2}, unit_weight_kn_m3: 26}\n"
                        "base: {mated: true, beyond: {left: 3, right: 1}}\nfriction_angle_deg: 60\ntilt: {towards: left, angle_deg: 5}\n"
                        "tilt_test: {engine: dynamics}\n")
        self.addCleanup(path.unlink, missing_ok=True)
        status, out, err = run("tilt", "--json", "--moments=300", path.name, folder=folder)
        self.assertEqual(status, 0, err)
        case = json.loads(out)["cases"][0]
        body = """const film = new it.Film(given);
          const times = [0, 0.3, 1, 2.49, 2.5, 2.6, film.length(2)];
          return {end: film.end, begins: film.begins, poses: film.moments.map((m) => film.poseAt(m.time_s)),
            between: film.moments.slice(1).map((m, i) => film.poseAt((m.time_s + film.moments[i].time_s) / 2)),
            back: times.map((t) => film.shownAt(film.timeAt(t, 2), 2) - t), last: film.timeAt(1e9, 2), past: film.poseAt(1e9),
            first: film.contactsAt(0), later: film.contactsAt(film.begins), event: film.eventAt(film.begins).what, none: film.eventAt(0)};"""
        film = node(DRAWING / "film.js", body, case)
        moments = case["moments"]
        keys = {"tilt": "angle_deg", "x": "moved_x_m", "y": "moved_y_m", "turned": "turned_deg"}
        for moment, pose in zip(moments, film["poses"]):
            for own, key in keys.items():
                self.assertAlmostEqual(pose[own], moment[key], delta=1e-9 * max(1, abs(moment[key])))
        for before, after, pose in zip(moments, moments[1:], film["between"]):
            for own, key in keys.items():
                low, high = sorted((before[key], after[key]))
                self.assertTrue(low - 1e-9 <= pose[own] <= high + 1e-9)
        self.assertEqual([round(each, 9) for each in film["back"]], [0] * 7)
        self.assertEqual(film["last"], film["end"])
        self.assertEqual(film["past"]["turned"], moments[-1]["turned_deg"])
        self.assertEqual({each["state"] for each in film["first"]}, {"closed"})
        self.assertIn("open", {each["state"] for each in film["later"]})
        self.assertAlmostEqual(film["begins"], case["events"][0]["time_s"], places=9)
        self.assertEqual((film["event"], film["none"]), ("begins to move", None))

    def test_templates_are_solved(self):
        """Each scene to begin one's own with has an answer, and stands at the tilt that it begins with."""
        folder = ROOT / "build"
        for template in node(EXPLORER / "examples" / "templates.js", "return it.TEMPLATES;", None):
            with self.subTest(template["name"]):
                path = folder / ("explorer_" + template["name"])
                path.write_text(template["text"], encoding="utf-8")
                self.addCleanup(path.unlink, missing_ok=True)
                status, out, err = run("solve", "--json", path.name, folder=folder)
                self.assertEqual(status, 0, err)
                self.assertEqual(json.loads(out)["cases"][0]["mechanism"], "stands")

    @unittest.skipUnless(YAML.is_dir(), f"there is no {YAML}: ./run --explorer installs it")
    def test_additions_are_solved(self):
        """What the menu adds is read by the program and counts: each load is among its effects; a second anchor is one more;
        corners in place of a slab's or of teeth's numbers make the same block."""
        scenes = {"slab": (ROOT / "examples/slab_left.yaml").read_text(encoding="utf-8"),
                  "teeth": (ROOT / "examples/block_e_valley.yaml").read_text(encoding="utf-8"),
                  "lines": "topple: 1\nlength_unit: m\nblock:\n  slab:\n    width: 1\n    height: 2   # its height\n\n  unit_weight_kn_m3: 26\n"
                           "friction_angle_deg: 30\ntilt:\n  towards: left\n  angle_deg: 5\n"}
        rings = {"slab": [[0, 0], [50, 0], [50, 100], [0, 100]], "teeth": [[0, 0], [30, 5], [60, 0], [90, 5], [90, 125], [0, 125]],
                 "lines": [[0, 0], [1, 0], [1, 2], [0, 2]]}
        body = """const {SceneText} = await import(given.text); const out = {};
          for (const [name, text] of Object.entries(given.scenes)) {
            const ring = given.rings[name].map(([x, y]) => ({x, y}));
            const height = Math.max(...ring.map(({y}) => y));
            const sizes = {height, centroid: {x: ring[2].x / 2, y: height / 2}, weightKn: 52, ring};
            for (const [kind, addition] of Object.entries(it.ADDITIONS)) {
              const once = addition.text(new SceneText(text), sizes);
              out[name + " " + kind] = kind === "anchor" ? addition.text(new SceneText(once), sizes) : once;
            } }
          return out;"""
        given = {"text": (EXPLORER / "scene" / "scene_text.js").as_uri(), "scenes": scenes, "rings": rings}
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        areas = {}
        for name, text in scenes.items():
            areas[name] = self.solved(folder, text)["block"]["area_m2"]["value"]
        for name, text in node(EXPLORER / "scene" / "additions.js", body, given).items():
            with self.subTest(name):
                scene, kind = name.split()
                case = self.solved(folder, text)
                self.assertAlmostEqual(case["block"]["area_m2"]["value"], areas[scene], places=12)
                if kind == "outline":
                    self.assertIn("outline: [[0, 0], ", text)
                    self.assertNotRegex(text, "slab:|teeth:")
                else:
                    told = json.dumps([case.get("loads"), case["effects"]])
                    self.assertIn({"water": "water", "anchor": "anchor", "earthquake": "seismic", "cohesion": "cohesion"}[kind], told)
                    self.assertEqual(text.count("force_kn"), 2 if kind == "anchor" else 0)

    @unittest.skipUnless(YAML.is_dir(), f"there is no {YAML}: ./run --explorer installs it")
    def test_blocks_of_many_that_are_dragged(self):
        """A vertex that two blocks share takes both along; a block is shifted by its `at`, which it gets where it has none, and is put
        level with corners of others that are near: the program then finds the contact again."""
        text = "topple: 1\nlength_unit: m\nfriction_angle_deg: 30\ntilt: {towards: left}\nblocks:\n" \
            "  - {name: g, ground: true, outline: [[-9, -1], [9, -1], [9, 0], [2, 0], [-9, 0]]}\n" \
            "  - {name: a, outline: [[0, 0], [2, 0], [2, 3], [0, 3]]}\n  - {name: b, slab: {width: 1, height: 2}, at: [3.3, 0.25]}\n"
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        drawn = text.replace("[3.3, 0.25]", "[3, 0]")
        (folder / "scene.yaml").write_text(drawn, encoding="utf-8")
        answer = json.loads(run("solve", "--json", "--outlines", "scene.yaml", folder=folder)[1])
        body = """const [{SceneText}, {Context}, {View}] = await Promise.all(given.modules.map((each) => import(each)));
          const view = new View(); view.fit(given.answer.outlines.box_m);
          const dragged = (text, key, x, y) => {
            const scene = new SceneText(text);
            const context = new Context(scene, given.answer.cases[0], given.answer.outlines, {x: given.answer.outlines.origin_x_m, y: given.answer.outlines.origin_y_m});
            const handle = it.listedCandidates(context, view, {hand: null, kept: new Set([key])}).find((one) => one.key === key).made();
            const hand = {x: handle.at.x + x, y: handle.at.y + y};
            return scene.withNumbers(handle.drag(hand, -1)); };
          return [dragged(given.text, "blocks.1.outline.1", 0.23, -0.31), dragged(given.text, "blocks.1", 0, 0.5), dragged(given.text, "blocks.2", -1.28, -0.24)];"""
        modules = [(EXPLORER / part).as_uri() for part in ("scene/scene_text.js", "drawing/handle.js", "drawing/view.js")]
        corner, whole, level = node(DRAWING / "listed_blocks.js", body, {"modules": modules, "answer": answer, "text": text})
        self.assertEqual(corner, text.replace("[9, 0], [2, 0]", "[9, 0], [2.2, -0.3]").replace("[0, 0], [2, 0]", "[0, 0], [2.2, -0.3]"))
        self.assertEqual(whole, text.replace("[0, 3]]", "[0, 3]], at: [0, 0.5]"))
        self.assertEqual(level, text.replace("[3.3, 0.25]", "[2, 0]"))
        (folder / "scene.yaml").write_text(level, encoding="utf-8")
        pairs = [(c["first"], c["second"]) for c in json.loads(run("solve", "--json", "scene.yaml", folder=folder)[1])["contacts"]]
        self.assertIn({"a", "b"}, [set(pair) for pair in pairs])

    @unittest.skipUnless(YAML.is_dir(), f"there is no {YAML}: ./run --explorer installs it")
    def test_columns_that_are_made_of_numbers(self):
        """Their handles stand where the program has the tops of these columns; dragged there, a top is there."""
        head = "topple: 1\nlength_unit: ft\nfriction_angle_deg: 40\nslope: {dip_deg: 20, towards: left}\n"
        texts = [head + "columns: {width: 3, step: 1, rise: 3, fall: 2, below_crest: 1, above_crest: 1}\n", head + "columns: {width: 3, heights: [4, 8]}\n"]
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        body = """const [{SceneText}, {Context}] = await Promise.all(given.modules.map((each) => import(each)));
          return given.scenes.map(({text, answer}) => {
            const scene = new SceneText(text);
            const context = new Context(scene, answer.cases[0], answer.outlines, {x: answer.outlines.origin_x_m, y: answer.outlines.origin_y_m});
            return it.columnHandles(context).map((handle) => [handle.key, handle.at, scene.withNumbers(handle.drag({x: handle.at.x, y: handle.at.y + 0.3048}, -3))]); });"""

        def drawn(text):
            (folder / "scene.yaml").write_text(text, encoding="utf-8")
            outlines = json.loads(run("solve", "--json", "--outlines", "scene.yaml", folder=folder)[1])
            return {"text": text, "answer": outlines}

        def corners(scene):
            return {tuple(round(float(each), 6) for each in point.split()) for path in scene["answer"]["outlines"]["blocks"][1:] for point in re.findall(r"[ML]([^MLZ]*)", path)}

        modules = [(EXPLORER / part).as_uri() for part in ("scene/scene_text.js", "drawing/handle.js")]
        scenes = [drawn(text) for text in texts]
        found = node(DRAWING / "column_handles.js", body, {"modules": modules, "scenes": scenes})
        self.assertEqual([[key for key, _, _ in each] for each in found],
                         [["columns.width", "columns.rise", "columns.fall"], ["columns.width", *(f"columns.heights.{k}" for k in range(2))]])
        for scene, handles in zip(scenes, found):
            for key, at, text in handles[1:]:
                with self.subTest(key):
                    self.assertIn((round(at["x"] - 0.4572, 6), round(at["y"], 6)), corners(scene))
                    self.assertIn((round(at["x"] - 0.4572, 6), round(at["y"] + 0.3048, 6)), corners(drawn(text)))

    @unittest.skipUnless(YAML.is_dir(), f"there is no {YAML}: ./run --explorer installs it")
    def test_a_wedge_lies_where_the_program_has_it(self):
        """Its four corners have the centroid that the program tells; of other joints than it solved, or with a crack, it is not drawn."""
        path = ROOT / "examples" / "solids" / "wedge.yaml"
        text = path.read_text(encoding="utf-8")
        answer = json.loads(run("solve", "--json", path)[1])
        body = """const {SceneText} = await import(given.module);
          return given.texts.map((text) => { const mesh = it.meshOf(given.answer, new SceneText(text), {}); return mesh && {...mesh, near: [...mesh.near]}; });"""
        given = {"module": (EXPLORER / "scene" / "scene_text.js").as_uri(), "answer": answer, "texts": [text, text.replace("dip_deg: 70", "dip_deg: 71"), text.replace("height: 130", "height: x")]}
        mesh, other, none = node(EXPLORER / "solid" / "solid_mesh.js", body, given)
        self.assertEqual((other, none), (None, None))
        self.assertAlmostEqual(mesh["unit"], 0.3048, places=12)
        corners = {tuple(round(mesh["unit"] * each, 9) for each in mesh["near"][k:k + 3]) for k in range(0, 36, 3)}
        self.assertEqual(len(corners), 4)
        for axis in range(3):
            self.assertAlmostEqual(sum(corner[axis] for corner in corners), 0, places=6)

    def solved(self, folder, text):
        (folder / "scene.yaml").write_text(text, encoding="utf-8")
        status, out, err = run("solve", "--json", "scene.yaml", folder=folder)
        self.assertEqual(status, 0, err)
        return json.loads(out)["cases"][0]

    def test_clock_that_ticks(self):
        """A measurement shorter than a tick of the clock stands at the shortest that was measured, and never at nothing."""
        times = [0.0, 3e-5, 1e-4]
        given = [[{"seconds": each} for each in times], [{"seconds": 0.0}]]
        self.assertEqual(node(EXPLORER / "panels" / "shortest_time.js", "return given.map((runs) => it.shortestTime(runs));", given), [3e-5, 1e-6])


class Progress(unittest.TestCase):
    def test_a_word_now_and_then(self):
        """While a build prints nothing for long, it is still said how far it is; all that it printed comes back."""
        sys.path.insert(0, str(EXPLORER))
        sys.dont_write_bytecode = True
        from wasm import progress

        def build():
            yield "[1/3] cc a\n"
            time.sleep(0.2)
            yield "a warning\n"
            yield "[3/3] cc b\n"

        told = []
        self.assertEqual(progress.followed("Libraries", build(), told.append, every=0.05), "[1/3] cc a\na warning\n[3/3] cc b\n")
        self.assertGreaterEqual(len(told), 2)
        self.assertEqual(told[0], "Libraries: step 1 of 3, 0 s")
        self.assertEqual(progress.words("Libraries", 0, None, 61.2), "Libraries: begun, 61 s")


if __name__ == "__main__":
    main()
