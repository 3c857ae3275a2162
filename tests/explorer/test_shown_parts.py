# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Nothing that the page shows is false, without a page, by node: the opening film leaves the scene as it is, a film ends at the
collapse, water is level, reactions balance what they are said to balance, and a verdict is that of the scene that is open."""

import json
import math
import pathlib
import random
import tempfile
import unittest

from node_case import NODE, node
from page_case import ROOT
from harness import PROGRAM, main, rounds, run

EXPLORER = ROOT / "src" / "applications" / "explorer"
DRAWING = EXPLORER / "drawing"
YAML = EXPLORER / "node_modules" / "yaml"
NEEDS_YAML = unittest.skipUnless(YAML.is_dir(), f"there is no {YAML}: ./run --explorer installs it")

PATH_TEST = """topple: 1
length_unit: m
block: {slab: {width: 1, height: 2}, unit_weight_kn_m3: 26}
base: {mated: true}
friction_angle_deg: 60
tilt: {towards: left, angle_deg: 20}
tilt_test: {engine: path}
"""

WITH_CASES = """topple: 1
title: A slab in load cases
length_unit: m
block: {outline: [[0, 0], [6, 0], [6, 3], [0, 3]], unit_weight_kn_m3: 26}
friction_angle_deg: 38
slope: {dip_deg: 30, towards: left}
loads: {cohesion_kpa: 20}
cases:
  - {name: static, required_fos: 1.5}
  - {name: wet, required_fos: 1.8, loads: {water: {height: 1.5, uplift: true}}}
  - {name: earthquake, required_fos: 1.1, loads: {seismic: {horizontal: 0.08}}}
"""

MANY_WITH_CASES = """topple: 1
title: Two blocks in load cases
length_unit: m
friction_angle_deg: 31
block: {unit_weight_kn_m3: 25}
blocks:
  - {name: ground, ground: true, outline: [[-9, -1], [9, -1], [9, 0], [-9, 0]]}
  - {name: low, slab: {width: 2, height: 1}}
  - {name: column, slab: {width: 1, height: 5}, at: [2, 0]}
tilt: {towards: left, angle_deg: 10}
cases:
  - {name: static, required_fos: 1.1}
  - {name: earthquake, loads: {seismic: {horizontal: 0.1}}, required_fos: 1.2}
"""


@unittest.skipIf(NODE is None, "there is no node: install Debian's package nodejs")
class Shown(unittest.TestCase):
    def folder(self):
        return pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def test_the_opening_film_changes_nothing(self):
        """The film runs to its end, or to an input of each kind in the middle of a swing: it ends at the tilt of the scene. No method
        of the scene's store but those of its events is called, and neither address nor storage is touched, but that somebody was here
        is noted after an input. Before, the input left the tilt at which the film had come."""
        body = """const listeners = {}; const written = []; let frames = []; let now = 0;
          const add = (name, heard) => (listeners[name] = [...(listeners[name] ?? []), heard]);
          const remove = (name, heard) => (listeners[name] = (listeners[name] ?? []).filter((each) => each !== heard));
          const untouched = (what) => new Proxy({}, {get: (_, key) => { throw new Error(what + "." + String(key)); }, set: (_, key) => { throw new Error(what + "." + String(key)); }});
          Object.assign(globalThis, {addEventListener: add, removeEventListener: remove, matchMedia: () => ({matches: false}), history: untouched("history"),
            location: untouched("location"), requestAnimationFrame: (step) => frames.push(step), cancelAnimationFrame: () => (frames = []),
            localStorage: {getItem: () => null, setItem: (key) => written.push(key)}, document: {body: {classList: {add() {}, remove() {}}}}});
          Object.defineProperty(globalThis, "performance", {value: {now: () => now}, configurable: true});
          const store = new Proxy({}, {get: (_, key) => { if (key === "addEventListener") return add; if (key === "removeEventListener") return remove; throw new Error("store." + String(key)); }});
          const out = [];
          for (const input of given.inputs) {
            written.length = 0; frames = []; now = 0; for (const name of Object.keys(listeners)) delete listeners[name];
            const swings = []; const drawing = {case: given.kase, swingBy: (degrees) => swings.push(degrees)};
            it.firstGesture(drawing, store, () => {});
            for (let k = 0; k < 2000 && frames.length > 0; k++) {
              const steps = frames; frames = []; now += 16; steps.forEach((step) => step(now));
              if (input !== null && k === 100) { (listeners[input] ?? []).forEach((heard) => heard({})); }
            }
            out.push({input, last: swings.at(-1), least: Math.min(...swings), most: Math.max(...swings), count: swings.length, written: [...written],
              left: Object.values(listeners).flat().length, waiting: frames.length});
          }
          return out;"""
        kase = {"mechanism": "stands", "tilt_angle_deg": {"value": 20, "error": 0},
                "onset": {"kind": "angle", "critical_angle_deg": {"value": 28.735, "error": 1e-9}}}
        inputs = [None, "pointerdown", "keydown", "wheel", "change", "input", "hashchange", "text"]
        for film in node(EXPLORER / "page" / "first_gesture.js", body, {"kase": kase, "inputs": inputs}):
            with self.subTest(film["input"]):
                self.assertEqual(film["last"], 0)
                self.assertEqual((film["left"], film["waiting"]), (0, 0))
                self.assertGreater(film["count"], 50)
                self.assertGreater(film["most"], 3)
                self.assertLess(20 + film["most"], 28.735)
                self.assertGreaterEqual(20 + film["least"], 0)
                self.assertEqual(film["written"], [] if film["input"] in (None, "text") else ["topple.touched"])

    def test_the_opening_film_stays_where_the_block_stands(self):
        """Of random tilts and onsets every moment of the film is above level and below the onset; where there is no room for it, or the
        block does not stand, there is no film."""
        draw = random.Random(1)
        given = [{"mechanism": draw.choice(["stands", "stands", "stands", "may move", "topples"]), "tilt_angle_deg": {"value": draw.uniform(0, 60), "error": 0},
                  "onset": {"kind": draw.choice(["angle", "angle", "never", "nowhere", "undecided"]),
                            "critical_angle_deg": {"value": draw.uniform(0, 80), "error": draw.choice([0, 1e-9, 0.5])}}} for _ in range(rounds(300, 20000))]
        body = """return given.map((kase) => { const swing = it.swingOf(kase); if (swing === null) return null;
          return Array.from({length: 141}, (_, k) => it.swingAt(swing, 100 * k)); });"""
        films = node(EXPLORER / "page" / "first_gesture.js", body, given)
        for kase, film in zip(given, films):
            if film is None:
                continue
            self.assertEqual(kase["mechanism"], "stands")
            self.assertEqual((film[0], film[140]), (0, None))
            onset = {"angle": kase["onset"]["critical_angle_deg"], "never": {"value": 180, "error": 0}}[kase["onset"]["kind"]]
            for degrees in film[:140]:
                self.assertGreaterEqual(kase["tilt_angle_deg"]["value"] + degrees, -1e-9)
                self.assertLess(kase["tilt_angle_deg"]["value"] + degrees, onset["value"] - onset["error"])
        self.assertGreater(sum(film is not None for film in films), len(films) / 10)

    FILM = """return given.kases.map((kase) => { const film = new it.Film(kase, given.shaken, given.size);
      const shown = Array.from({length: 201}, (_, k) => (k / 200) * film.length(2));
      const times = shown.map((each) => film.timeAt(each, 2));
      return {course: film.course, end: film.end, length: film.length(2), times, back: times.map((time) => film.shownAt(time, 2)), shown,
        poses: times.map((time) => film.poseAt(time)), last: film.eventAt(film.end)?.what ?? null,
        way: it.wayOf(film, {block: {centroid_x_m: {value: 0.5}, centroid_y_m: {value: 1}}},
          {box_m: [0, 0, 1, 2], placed: {results: {cosine: 1, sine: 0, x_m: 0, y_m: 0}}})}; });"""

    def film(self, kases, shaken=False, size=math.hypot(1, 2)):
        return node(DRAWING / "film.js", self.FILM, {"kases": kases, "shaken": shaken, "size": size})

    def check_film(self, film, moved, turned):
        """All that is shown is near the block's place, the slider runs from one end to the other, and its time comes back."""
        for number in [film["length"], *film["times"], *film["back"], *film["way"], *(value for pose in film["poses"] for value in pose.values())]:
            self.assertTrue(isinstance(number, (int, float)) and math.isfinite(number), film["course"])
        self.assertGreater(film["length"], 0)
        self.assertEqual(film["times"], sorted(film["times"]))
        self.assertAlmostEqual(film["times"][-1], film["end"], delta=1e-9 * max(1, abs(film["end"])))
        for pose in film["poses"]:
            self.assertLessEqual(math.hypot(pose["x"], pose["y"]), moved)
            self.assertLessEqual(abs(pose["turned"]), turned)
        self.assertLess(max(map(abs, film["way"])), 100)

    def test_a_path_ends_at_its_collapse(self):
        """A path of equilibria knows no time; its film runs over the tilt and ends at the collapse, which statics has. Before, all of it
        was at 0 s, so that the slider was dead, and the block lay at −10^10 dots."""
        folder = self.folder()
        (folder / "scene.yaml").write_text(PATH_TEST)
        status, out, err = run("tilt", "--json", "--moments=1200", "scene.yaml", folder=folder)
        self.assertEqual(status, 0, err)
        case = json.loads(out)["cases"][0]
        film, = self.film([case])
        self.check_film(film, 0.1 * math.hypot(1, 2), 5)
        self.assertEqual((film["course"], film["last"]), ("tilt", "begins to move"))
        self.assertAlmostEqual(film["end"], math.degrees(math.atan(0.5)), delta=1e-3)  # a slab 1 × 2 topples at atan ½
        self.assertAlmostEqual(film["poses"][-1]["tilt"], film["end"], places=9)
        for shown, back in zip(film["shown"], film["back"]):
            self.assertAlmostEqual(shown, back, places=6)

    def test_no_block_is_drawn_where_none_can_be(self):
        """Moments as a simulation that fails might print them: numbers that are none, the block far away or turned millions of times, time
        that goes back. Whatever comes, the film shows only what was sane before."""
        draw = random.Random(2)
        kases = []
        for _ in range(rounds(100, 2000)):
            count, is_path = draw.randrange(2, 40), draw.random() < 0.5
            moments = [{"time_s": 0 if is_path else 0.1 * k, "angle_deg": float(k), "moved_x_m": -1e-6 * k, "moved_y_m": 0, "turned_deg": 1e-5 * k, "reactions": []}
                       for k in range(count)]
            events = [{"what": "slips", "facet": 1, "time_s": each["time_s"], "angle_deg": each["angle_deg"]} for each in moments if draw.random() < 0.2]
            key, wrong = draw.choice([("moved_x_m", -1e10), ("moved_y_m", 1e300), ("turned_deg", 8e8), ("moved_x_m", None), ("angle_deg", None), ("turned_deg", None)])
            for k in range(draw.randrange(1, count), count):
                moments[k][key] = wrong
            kases.append({"moments": moments, "events": events, "facets": []})
        # JSON knows no NaN: None is what a page reads, and is no number either
        for kase, film in zip(kases, self.film(kases)):
            with self.subTest(kase["moments"][-1]):
                self.check_film(film, 1e-3, 1)

    def test_water_is_level(self):
        """Corners of the water, turned by the tilt, which ends in a surface of one height; it lies above the base, and meets the face where
        loads.md has it: a height h along the face has the head h cos α over the foot, one that stays level the head h."""
        draw = random.Random(3)
        given = [[draw.uniform(0.01, 5), draw.random() < 0.5, math.radians(draw.choice([0, draw.uniform(0, 89), draw.uniform(-30, 0), 30])), draw.uniform(0.05, 4)]
                 for _ in range(rounds(500, 20000))]
        body = """return given.map(([height, level, tilt, width]) => it.waterCorners(it.wettedHeight(height, level, tilt), width, tilt));"""
        for (height, level, tilt, width), corners in zip(given, node(DRAWING / "water.js", body, given)):
            # the base rises towards +x, by the tilt
            turned = [(x * math.cos(tilt) - y * math.sin(tilt), x * math.sin(tilt) + y * math.cos(tilt)) for x, y in corners]
            surface = [turned[-1][1], turned[-2][1]]
            size = height + width
            self.assertAlmostEqual(surface[0], surface[1], delta=1e-9 * size / math.cos(tilt))
            self.assertTrue(all(y <= surface[0] + 1e-9 * size / math.cos(tilt) for _, y in turned))
            self.assertTrue(all(-1e-12 <= x <= width * (1 + 1e-12) and y >= -1e-12 for x, y in corners))
            if math.cos(tilt) > 0.05:
                self.assertAlmostEqual(surface[0], height if level else height * math.cos(tilt), delta=1e-9 * size / math.cos(tilt))

    def test_the_slope_of_the_water_of_a_scene(self):
        """The path on the page, of a scene of the program towards either side at 30°: its surface is level on the screen."""
        folder = self.folder()
        for towards, sign in (("left", 1), ("right", -1)):
            for level in ("true", "false"):
                text = ("topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 2}, unit_weight_kn_m3: 26}\nbase: {mated: true}\nfriction_angle_deg: 30\n"
                        f"loads: {{water: {{height: 1, stays_level: {level}}}}}\ntilt: {{towards: {towards}, angle_deg: 30}}\n")
                (folder / "scene.yaml").write_text(text)
                status, out, err = run("solve", "--json", "--outlines", "scene.yaml", folder=folder)
                self.assertEqual(status, 0, err)
                answer = json.loads(out)
                body = """const {resultPoint} = await import(given.point);
                  const context = {kase: given.answer.cases[0], result: (x, y) => resultPoint(given.answer.outlines, x, y)};
                  return it.waterPath(context, given.answer.outlines, given.turn);"""
                turn = sign * math.radians(30)
                path = node(DRAWING / "water.js", body, {"point": (DRAWING / "result_point.js").as_uri(), "answer": answer, "turn": turn})
                points = [tuple(map(float, point.split())) for point in path.strip("MZ").split("L")]
                heights = [x * math.sin(turn) + y * math.cos(turn) for x, y in points]
                self.assertAlmostEqual(heights[-1], heights[-2], places=9)
                head = 1 if level == "true" else math.cos(math.radians(30))
                self.assertAlmostEqual(heights[-1] - heights[0], head, places=9)

    def test_reactions_balance_what_they_are_said_to(self):
        """Of every example with reactions at the limit: their sum is the weight and their moment about the centroid is nothing exactly where
        the page says that they balance the weight; elsewhere it names what else acts."""
        said = {True: 0, False: 0}
        scenes = sorted([*(ROOT / "examples").glob("*.yaml"), *(ROOT / "examples" / "slope").glob("*.yaml")])
        for scene in scenes:
            status, out, err = run("solve", "--json", "--outlines", scene)
            if status not in (0, 1) or '"reactions": [' not in out:
                continue
            cases = [case for case in json.loads(out)["cases"] if (case.get("limit") or {}).get("reactions")]
            along = json.loads(out)["outlines"]["placed"]["results"]  # shares are along the mean plane, points are the scene's
            for case, balanced in zip(cases, node(EXPLORER / "panels" / "balance.js", "return given.map((each) => it.balancedBy(each));", cases)):
                with self.subTest(scene.name, towards=case["towards"]):
                    force_x = sum(one["share_x"]["value"] for one in case["limit"]["reactions"])
                    force_y = sum(one["share_y"]["value"] for one in case["limit"]["reactions"])
                    arms = [(one["x_m"]["value"] - case["block"]["centroid_x_m"]["value"], one["y_m"]["value"] - case["block"]["centroid_y_m"]["value"], one)
                            for one in case["limit"]["reactions"]]
                    moment = sum((along["cosine"] * x - along["sine"] * y) * one["share_y"]["value"] - (along["sine"] * x + along["cosine"] * y) * one["share_x"]["value"]
                                 for x, y, one in arms)
                    size = math.sqrt(case["block"]["area_m2"]["value"])
                    is_weight = abs(math.hypot(force_x, force_y) - 1) < 1e-9 and abs(moment) < 1e-9 * size
                    self.assertIsNotNone(balanced)
                    self.assertEqual(balanced["weight"], is_weight)
                    self.assertEqual(balanced["others"] == [], is_weight)
                    said[is_weight] += 1
        self.assertGreater(said[True], 5)
        self.assertGreater(said[False], 3)

    def test_loads_that_are_named(self):
        """Water, an anchor and an earthquake are named; loads that the answer does not list leave the sentence out."""
        bounded = {"value": 0, "error": 0}
        still = {"share_x": bounded, "share_y": bounded, "moment_m": bounded}

        def case(applied, loads, strength=still):
            return {"limit": {"balance": {"applied": {"share_x": {"value": applied, "error": 1e-15}, "share_y": bounded, "moment_m": bounded}, "strength": strength}},
                    "loads": [{"name": name} for name in loads]}

        given = [case(1, []), case(1, ["weight, normal", "weight, parallel"]), case(1.2, ["weight, normal", "water", "uplift", "anchor", "anchor"]), case(1.01, ["seismic"]),
                 case(1.2, []), case(1, [], {**still, "share_y": {"value": -0.08, "error": 0}}), {"limit": {}}]
        found = node(EXPLORER / "panels" / "balance.js", "return given.map((each) => it.balancedBy(each));", given)
        self.assertEqual(found, [{"weight": True, "others": []}, {"weight": True, "others": []}, {"weight": False, "others": ["water", "uplift", "anchor"]},
                                 {"weight": False, "others": ["seismic"]}, None, {"weight": False, "others": ["cohesion or bond"]}, None])

    def test_a_dead_worker_is_replaced(self):
        """Workers that never begin, that end before or after they began, or are deaf: each request is answered by another worker, or fails
        with words; none waits without end. Long runs that were confirmed are left alone."""
        body = """const made = [];
          // each worker does as its place in the list says, the last one works
          const starter = (kinds) => (heard) => { const kind = kinds[Math.min(made.length, kinds.length - 1)]; made.push(kind);
            if (kind === "throws") throw new Error("no worker");
            let ended = false; const tell = (message, ms = 1) => setTimeout(() => ended || heard(message), ms);
            if (kind === "broken") tell({kind: "broken", why: "no memory"}); else if (kind !== "silent") tell({kind: "ready"});
            return {end: () => (ended = true), post: ({id}) => {
              if (kind === "deaf") return;
              tell({kind: "begun", id}); if (kind === "dies") { tell({kind: "broken", why: "died"}, 5); return; }
              if (kind !== "mute") tell({kind: "done", id, answer: {out: "answer"}}, kind === "slow" ? 120 : 2); }}; };
          const out = [];
          for (const {kinds, count} of given) {
            made.length = 0;
            const core = new it.Requests(starter(kinds), {begin: 60, confirm: 40});
            const answers = [];
            for (let k = 0; k < count; k++) answers.push(await core.run(["solve"], {}, {timeoutMs: 200}).then(({out}) => out, (error) => error.name));
            core.close();
            out.push([answers, [...made]]);
          }
          return out;"""
        stories = [("works", ["works"], ["answer", "answer"], 1), ("silent", ["silent", "works"], ["CoreStopped", "answer"], 2),
                   ("throws", ["throws", "works"], ["answer"], 2), ("broken", ["broken", "works"], ["CoreStopped", "answer"], 2),
                   ("deaf", ["deaf", "works"], ["answer"], 2), ("deaf twice", ["deaf", "deaf", "works"], ["CoreStopped", "answer"], 3),
                   ("dies", ["dies", "works"], ["CoreStopped", "answer"], 2), ("slow", ["slow"], ["answer", "answer"], 1),
                   ("mute", ["mute", "works"], ["CoreStopped", "answer"], 2)]
        given = [{"kinds": kinds, "count": len(answers)} for _, kinds, answers, _ in stories]
        for (name, _, answers, workers), (found, made) in zip(stories, node(EXPLORER / "core" / "requests.js", body, given)):
            with self.subTest(name):
                self.assertEqual((found, len(made)), (answers, workers))

    STORE = """const {spawnSync} = await import("node:child_process"); const {writeFileSync} = await import("node:fs");
      const program = (words, files) => { for (const [name, text] of Object.entries(files)) writeFileSync(given.folder + "/" + name, text);
        const {stdout, stderr, status} = spawnSync(given.program, words, {cwd: given.folder, encoding: "utf8"}); return {out: stdout, err: stderr, status, files: {}}; };
      const wait = (ms) => new Promise((done) => setTimeout(done, ms));
      const settled = (store) => new Promise((done) => { for (const name of ["solution", "problem"]) store.addEventListener(name, () => done(name), {once: true}); });
      """

    @NEEDS_YAML
    def test_no_verdict_of_the_scene_before(self):
        """A core that answers when it is let: once another scene is open there is no last answer, also where the new one is refused, takes
        long or its core is dead; a title that is typed makes the last answer one of another subject; a number that is typed keeps it, late
        after a while."""
        body = self.STORE + """const asked = [];
          const core = {run: (words, files) => new Promise((resolve, reject) => asked.push({answer: () => resolve(program(words, files)), fail: () => reject(new Error("dead"))}))};
          const store = new it.SceneStore(core); const seen = {};
          const note = (name) => (seen[name] = {last: store.lastSolution !== null, of: store.isOfSubject, solution: store.solution !== null, problem: store.problem !== null, late: store.late});
          const done = async (how) => { await wait(0); const end = settled(store); asked.pop()[how](); await end; };
          store.open({name: "a.yaml", text: given.text}); note("opened"); await done("answer"); note("solved");
          store.setText(given.text.replace("20", "21")); note("typed"); await wait(350); note("late"); await done("answer"); note("solved again");
          store.setText(given.text.replace("title: A", "title: B")); note("another title"); await done("answer"); note("title solved");
          store.setText(given.text.replace("title: A", "title: \\"B")); note("broken title"); await done("answer"); note("refused");
          store.open({name: "b.yaml", text: given.text}); note("another"); await wait(350); note("another late"); await done("fail"); note("another failed");
          store.open({name: "c.yaml", text: "topple: 1\\noops: 2\\n"}); note("third"); await done("answer"); note("third refused");
          store.undo(); note("undone"); await done("answer"); note("undone solved");
          return seen;"""
        text = PATH_TEST.replace("topple: 1\n", "topple: 1\ntitle: A slab\n").replace("tilt_test: {engine: path}\n", "")
        seen = node(EXPLORER / "scene" / "store.js", body, {"program": PROGRAM, "folder": str(self.folder()), "text": text})

        def state(last, of, solution=False, problem=False, late=False):
            return {"last": last, "of": of, "solution": solution, "problem": problem, "late": late}

        self.assertEqual(seen, {
            "opened": state(False, False), "solved": state(True, True, solution=True), "typed": state(True, True), "late": state(True, True, late=True),
            "solved again": state(True, True, solution=True), "another title": state(True, False), "title solved": state(True, True, solution=True),
            "broken title": state(True, True), "refused": state(True, True, problem=True),
            "another": state(False, False), "another late": state(False, False, late=True), "another failed": state(False, False, problem=True),
            "third": state(False, False), "third refused": state(False, False, problem=True), "undone": state(False, False), "undone solved": state(True, True, solution=True)})

    @NEEDS_YAML
    def test_scenes_with_load_cases(self):
        """Opened, the case that governs is solved, as the command line has it with --case; one that is chosen is solved instead, and its
        words go with other commands. Of many blocks the severest row of the table is shown first. Before, both scenes were refused."""
        body = self.STORE + """const commands = [];
          const store = new it.SceneStore({run: async (words, files) => (commands.push(words), program(words, files))}); const out = [];
          for (const {name, text, chosen} of given.scenes) {
            let end = settled(store); store.open({name, text, files: {}}); const first = await end;
            const before = {told: first, problem: store.problem, cases: store.solution?.loadCases.cases, shown: store.solution?.loadCases.shown, kase: store.solution?.cases[0], words: store.caseWords};
            end = settled(store); store.chooseCase(chosen); const last = store.lastSolution; await end;
            out.push({before, last, after: {shown: store.solution.loadCases.shown, kase: store.solution.cases[0], words: store.caseWords, outlines: store.solution.outlines !== undefined}});
          }
          return out;"""
        folder = self.folder()
        scenes = [{"name": "one.yaml", "text": WITH_CASES, "chosen": "earthquake"}, {"name": "many.yaml", "text": MANY_WITH_CASES, "chosen": "static"}]
        one, many = node(EXPLORER / "scene" / "store.js", body, {"program": PROGRAM, "folder": str(folder), "scenes": scenes})

        def alone(name, case):
            status, out, err = run("solve", "--json", "--outlines", "--case", case, name, folder=folder)
            self.assertIn(status, (0, 1), err)
            return without_times(json.loads(out)["cases"][0])

        def without_times(case):
            return {key: value for key, value in case.items() if key != "effects"}

        for found, name, first, second in ((one, "one.yaml", "wet", "earthquake"), (many, "many.yaml", "earthquake", "static")):
            with self.subTest(name):
                self.assertEqual((found["before"]["told"], found["before"]["problem"]), ("solution", None))
                self.assertEqual((found["before"]["shown"], found["after"]["shown"]), (first, second))
                self.assertEqual((without_times(found["before"]["kase"]), without_times(found["after"]["kase"])), (alone(name, first), alone(name, second)))
                self.assertEqual((found["before"]["words"], found["after"]["words"]), (["--case=" + first], ["--case=" + second]))
                self.assertIsNone(found["last"])  # nothing of the case before stays while the chosen one is solved
                self.assertTrue(found["after"]["outlines"])
        self.assertEqual({each["name"]: each["met"] for each in one["before"]["cases"]}, {"static": "met", "wet": "not met", "earthquake": "met"})
        self.assertEqual({each["name"]: each["met"] for each in many["before"]["cases"]}, {"static": "met", "earthquake": "not met"})
        self.assertAlmostEqual(many["before"]["cases"][1]["fos"]["value"], 0.9948, places=3)  # the lesser of its two factors


if __name__ == "__main__":
    main()
