# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""How the explorer changes a scene's text, without a page, by node: a number is put where it stands and all around it
stays; decimals are exact; formulas have the values that Python gives them; undo leads back."""

import decimal
import fractions
import json
import pathlib
import random
import re
import tempfile
import unittest

from node_case import NODE, node
from page_case import ROOT, run
from harness import main

SCENE = ROOT / "src" / "applications" / "explorer" / "scene"
INSTALLED = (ROOT / "src" / "applications" / "explorer" / "node_modules" / "yaml").is_dir()

# Layouts of one scene: {0}, {1}, ... are the numbers that are changed, and nothing else may be
LAYOUTS = {
    "flow": """topple: 1
title: "a # that is no comment: {{x}}"   # one that is
length_unit: mm
block:
  outline: [[0, 0], [{0},{1}] , [ {2}   ,140.50]]  # vertices
tilt: {{towards: left, angle_deg: {3}}}
""",
    "block": """# a head
topple: 1
length_unit: mm
block:
    outline:
    - - 0
      - 0
    # between
    -   - {0}    # x
        - {1}
    - [{2}, 140]
tilt:
  towards: left

  angle_deg:    {3} # degrees
""",
    "wide": """topple: 1\r
length_unit: mm\r
block: {{outline: [
  [0, 0], [{0}, {1}],\r
  ['{2}', 140]\r
 ]}}\r
tilt: {{
  angle_deg: "{3}",
  towards: left}}
# end without a newline""",
}
PATHS = [["block", "outline", 1, 0], ["block", "outline", 1, 1], ["block", "outline", 2, 0], ["tilt", "angle_deg"]]


@unittest.skipIf(NODE is None, "there is no node: install Debian's package nodejs")
class Edits(unittest.TestCase):
    def test_snapped_decimals(self):
        """The text is the multiple of the step that is nearest to the double, as Python's decimals have it."""
        draw = random.Random(1)
        given = [[draw.uniform(-1, 1) * 10.0 ** draw.randrange(-4, 7), draw.randrange(-6, 3)] for _ in range(3000)]
        given += [[0.0, 0], [-0.001, -1], [0.05, -2], [99.96, -1], [-0.5, 1]]
        for (value, exponent), text in zip(given, node(SCENE / "decimal.js", "return given.map((one) => it.snap(...one));", given)):
            step = decimal.Decimal(10) ** exponent
            self.assertEqual(decimal.Decimal(text) % step, 0, (value, exponent, text))
            self.assertLessEqual(abs(fractions.Fraction(text) - fractions.Fraction(value)),
                                 fractions.Fraction(step) / 2 * (1 + fractions.Fraction(1, 10**9)), (value, exponent, text))
            self.assertNotRegex(text, r"^-0$|e|\.$|\.\d*0$")

    def test_steps_are_powers_of_ten_below_so_many_dots(self):
        given = [[length, 3] for length in (1e-9, 0.0123, 0.333, 0.3334, 1, 7e5)]
        found = node(SCENE / "decimal.js", "return given.map((one) => it.stepExponent(...one));", given)
        for (length, dots), exponent in zip(given, found):
            self.assertLessEqual(10.0 ** exponent, length * dots * (1 + 1e-12))
            self.assertGreater(10.0 ** (exponent + 1), length * dots)

    def test_formulas_have_python_s_values(self):
        """Of 800 random formulas with parameters; what is no formula has no value."""
        draw = random.Random(2)

        def formula(depth):
            if depth == 0 or draw.random() < 0.2:
                return draw.choice(("a", "b_2", str(draw.randrange(1, 30)), f"{draw.uniform(0.1, 9):.3f}", ".5", "1e2"))
            left, right = formula(depth - 1), formula(depth - 1)
            return draw.choice((f"{left} + {right}", f"{left}-{right}", f"{left}*{right}", f"({left})/({right})",
                                f"-({left})", f"({left})^2", f"-({left})^2"))

        given = [formula(draw.randrange(1, 5)) for _ in range(800)]
        names = {"a": 1.75, "b_2": 12.0}
        found = node(SCENE / "formula.js", "const names = new Map([['a', 1.75], ['b_2', 12]]); return given.map((one) => it.formulaValue(one, names));", given)
        told = 0
        for text, value in zip(given, found):
            try:
                expected = eval(text.replace("^", "**"), {}, names)
            except (ZeroDivisionError, OverflowError):
                continue
            self.assertAlmostEqual(value, expected, delta=1e-9 * max(1, abs(expected)), msg=text)
            told += 1
        self.assertGreater(told, 700)
        bad = ["", "c", "1 +", "(1", "1)", "a b", "1/0", "alert(1)", "__proto__", "constructor", "2^^3", "(" * 5000 + "1" + ")" * 5000]
        self.assertEqual(node(SCENE / "formula.js", "return given.map((one) => it.formulaValue(one, new Map()));", bad), [None] * len(bad))

    def test_difference_of_texts(self):
        draw = random.Random(3)
        given = []
        for _ in range(500):
            texts = ["".join(draw.choice("ab\n") for _ in range(draw.randrange(12))) for _ in range(2)]
            given.append(texts)
        found = node(SCENE / "../editor/difference.js", "return given.map((one) => it.difference(...one));", given)
        for (before, after), change in zip(given, found):
            if change is None:
                self.assertEqual(before, after)
            else:
                self.assertEqual(before[:change["from"]] + change["insert"] + before[change["to"]:], after)

    def test_complaints_of_the_core(self):
        """Place and words of each line that the program says when a scene is bad."""
        for text, line in (("topple: 1\nblock: {slab: {width: oops, height: 1}}\nlength_unit: m\n", 2), ("topple: [", 2)):
            path = ROOT / "build" / "explorer_complaint.yaml"
            path.write_text(text)
            self.addCleanup(path.unlink, missing_ok=True)
            _, _, err = run("solve", "--json", path.name, folder=path.parent)
            found = node(SCENE / "complaint.js", "return it.readComplaint(given);", err)
            self.assertEqual((found["file"], found["line"]), (path.name, line))
            self.assertNotIn(path.name, found["message"])
            self.assertTrue(err.strip().endswith(found["message"]))
        found = node(SCENE / "complaint.js", "return it.readComplaint(given);", "")
        self.assertIn("without a message", found["message"])
        found = node(SCENE / "complaint.js", "return it.readComplaint(given);", "topple: ./-x.yaml:3:4: no\n")
        self.assertEqual((found["file"], found["line"]), ("-x.yaml", 3))

    def test_undo_leads_back_through_gestures(self):
        """Against a list of all states: of a gesture only its last one is kept."""
        draw = random.Random(4)
        steps = []
        for i in range(400):
            steps.append(draw.choice((["push", f"s{i}", None], ["push", f"s{i}", draw.choice("gh")], ["undo"], ["redo"], ["end"])))
        found = node(SCENE / "history.js", """const history = new it.History("s", (state) => state.length);
          return given.map(([what, state, gesture]) => { if (what === "push") history.push(state, gesture);
            else if (what === "end") history.endGesture(); else history[what](); return history.present; });""", steps)
        states, at, last = ["s"], 0, None
        for (what, *words), present in zip(steps, found):
            if what == "push":
                if words[1] is not None and words[1] == last:
                    states[at:] = [words[0]]
                else:
                    states[at + 1:] = [words[0]]
                    at += 1
                last = words[1]
            else:
                moved = max(0, min(len(states) - 1, at + {"undo": -1, "redo": 1, "end": 0}[what]))
                last = last if what != "end" and moved == at else None
                at = moved
            self.assertEqual(present, states[at])

    def test_links_come_back(self):
        state = {"name": "a b.yaml", "text": "title: ü — 漢\n" * 200, "files": {"meshes/x-1.csv": "0;1\n" * 1000}}
        found = node(SCENE / "link.js", "const hash = await it.linkOfScene(given); return [hash, await it.sceneOfLink(hash)];", state)
        self.assertEqual(found[1], state)
        self.assertLess(len(found[0]), 400)
        self.assertIsNone(node(SCENE / "link.js", "return it.sceneOfLink('#elsewhere');", None))

    def test_names_in_links(self):
        """Names as people give them come back; none leads out of the folder where the program runs, but for a file in a folder
        beside that of the scene."""
        back = """const out = []; for (const name of given) {
          try { out.push((await it.sceneOfLink(await it.linkOfScene({name, text: "x: 1", files: {}}))).name); } catch (e) { out.push(e.message); } }
          return out;"""
        good = ["block (1).yaml", "böschung.yaml", "岩.yaml", "a/b/c.yaml", "-x.yaml", "what's this & that.yaml"]
        self.assertEqual(node(SCENE / "link.js", back, good), good)
        bad = ["../x.yaml", "/etc/x", "a/../b", "a//b", "", ".", "a\\b", "a\nb", "a/b/c/d/e", "x" * 300]
        self.assertEqual(set(node(SCENE / "link.js", back, bad)), {"it has no scene in it"})
        files = """return given.map((name) => { try { return Object.keys(it.checked({name: "x.yaml", text: "", files: {[name]: ""}}).files)[0]; } catch (e) { return null; } });"""
        self.assertEqual(node(SCENE / "link.js", files, ["../meshes/x.obj", "../../x.obj", "meshes/../../x.obj", "/x.obj"]), ["../meshes/x.obj", None, None, None])

    def test_lines_keep_their_ends(self):
        """What is typed into an editor of plain lines goes into a file of Windows', of Unix', or of both: read plainly the
        text is what was typed, and no line that was not touched has another end."""
        draw = random.Random(5)
        given = []
        for ends in (["\r\n"], ["\n"], ["\r\n", "\n"], ["\r\n", "\n", "\r"]):
            for _ in range(300):
                lines = ["".join(draw.choice("ab") for _ in range(draw.randrange(3))) + draw.choice(ends) for _ in range(draw.randrange(1, 8))]
                text = "".join(lines)
                plain = re.sub(r"\r\n?", "\n", text)
                at = draw.randrange(len(plain) + 1)
                given.append([text, plain[:at] + draw.choice(["x", "x\ny", ""]) + plain[min(len(plain), at + draw.randrange(3)):]])
        found = node(SCENE / "../editor/line_ends.js", "return given.map((one) => it.withTyped(...one));", given)
        for (before, typed), after in zip(given, found):
            self.assertEqual(re.sub(r"\r\n?", "\n", after), typed, (before, typed))
            if "\n" not in before.replace("\r\n", ""):
                self.assertNotRegex(after, r"(?<!\r)\n", (before, typed))
        self.assertEqual(node(SCENE / "../editor/line_ends.js", "return it.withTyped(...given);", ["a\r\nb\nc\r\n", "a\nb\ncd\n"]), "a\r\nb\ncd\r\n")

    def test_typed_numbers(self):
        """A field takes numbers in its range, with a point or a comma, and says why it takes no other."""
        cases = {"9": "9", " 12,5 ": "12.5", "1e1": "1e1", "95": "from 0 to 90", "-5": "from 0 to 90", "abc": "not a number",
                 "1.2.3": "not a number", "": "", "Infinity": "not a number"}
        found = node(SCENE / "../page/typed_number.js", "return given.map((typed) => it.typedNumber(typed, 90));", list(cases))
        for typed, answer, said in zip(cases, found, cases.values()):
            self.assertEqual((answer["text"] if answer["text"] is not None else answer["wrong"]), said, typed)

    def test_files_begin_scenes_that_are_solved(self):
        """Points that go one way are ground, others a block, also from a .txt; a drawing is tilted: each scene that is begun
        is solved by the program, with a factor of safety that is a number."""
        files = {"ground.csv": "x,y\n" + "".join(f"{k},{(k * k) % 3 / 10}\n" for k in range(12)),
                 "grid.txt": "".join(f"{5000 + 4 * k} {(k * 7) % 5 / 10}\n" for k in range(12)),
                 "block.txt": "0 0\n2 0\n2 3\n0 3\n", "it's.csv": "0;0\n1;0\n1;2\n0;2\n",
                 "drawing.svg": '<svg xmlns="http://www.w3.org/2000/svg"><path id="BLOCK" d="M0 0H10V-20H0Z"/></svg>'}
        scenes = node(SCENE / "open.js", "return Object.entries(given).map(([name, content]) => it.sceneOf(name, content));", files)
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        for (name, content), text in zip(files.items(), scenes):
            with self.subTest(name):
                (folder / name).write_text(content, encoding="utf-8")
                (folder / "scene.yaml").write_text(text, encoding="utf-8")
                status, out, err = run("solve", "--json", "scene.yaml", folder=folder)
                self.assertEqual(status, 0, err)
                self.assertEqual("profile:" in text, name in ("ground.csv", "grid.txt"))
                fos = [case["governing_fos"]["fos"] for case in json.loads(out)["cases"]]
                self.assertTrue(any(each is not None for each in fos))
        for name, content in (("notes.txt", "dear all"), ("a.png", "x")):
            self.assertIsNone(node(SCENE / "open.js", "return it.sceneOf(...given);", [name, content]))


@unittest.skipIf(NODE is None, "there is no node: install Debian's package nodejs")
@unittest.skipUnless(INSTALLED, "src/applications/explorer/node_modules is not there: ./run --explorer installs it")
class Texts(unittest.TestCase):
    def changed(self, text, numbers):
        return node(SCENE / "scene_text.js", "return new it.SceneText(given.text).withNumbers(given.numbers);", {"text": text, "numbers": numbers})

    def test_colours_of_a_text_nested_too_deeply(self):
        """The parser of the editor's colours runs out of stack on brackets in brackets; taken with care it leaves the text without
        colours, and of any other text it has the same tree."""
        parse = """const { yamlLanguage } = await import(`${given.modules}/@codemirror/lang-yaml/dist/index.js`);
                   const careful = new it.CarefulParser(yamlLanguage.parser);
                   const { parser } = yamlLanguage, deep = "topple: " + "[".repeat(50000);
                   let thrown = "";
                   try { parser.parse(deep); } catch (error) { thrown = error.name; }
                   return [thrown, careful.parse(deep).length, String(careful.parse(given.text)), String(parser.parse(given.text))];"""
        thrown, length, with_care, without = node(SCENE / "../editor/careful_parser.js", parse,
                                                  {"modules": (SCENE / "../node_modules").resolve().as_uri(),
                                                   "text": "topple: 1\nblock: {outline: [[0, 0], [1, 0], [1, 2]]} # a comment\n"})
        self.assertEqual((thrown, length), ("RangeError", len("topple: ") + 50_000))
        self.assertEqual(with_care, without)
        self.assertIn("Comment", with_care)

    def test_numbers_change_and_nothing_else(self):
        """In each layout the text is the layout with other numbers in it, byte by byte. Quotes around a number go: it is
        the number that was changed."""
        for name, layout in LAYOUTS.items():
            with self.subTest(name):
                before = layout.format("110", "60", "75", "12")
                numbers = [{"path": path, "text": text} for path, text in zip(PATHS, ("-1.25", "0.5", "1234567", "9"))]
                expected = layout.replace("'{2}'", "{2}").replace('"{3}"', "{3}").format("-1.25", "0.5", "1234567", "9")
                self.assertEqual(self.changed(before, numbers), expected)
                one = layout.replace("'{2}'", "{2}").format("110", "60", "8", "12")
                self.assertEqual(self.changed(before, numbers[2:3] and [{"path": PATHS[2], "text": "8"}]), one)

    def test_keys_that_are_not_there_are_added(self):
        cases = (
            ("topple: 1\ntilt: {towards: left}\n", "topple: 1\ntilt: {towards: left, angle_deg: 5}\n"),
            ("topple: 1\ntilt: {}  # none\nx: 1\n", "topple: 1\ntilt: {angle_deg: 5}  # none\nx: 1\n"),
            ("tilt:\n    towards: left   # down\nx: 1\n", "tilt:\n    towards: left   # down\n    angle_deg: 5\nx: 1\n"),
            ("topple: 1\nx: 1  # last", "topple: 1\nx: 1  # last\ntilt: {angle_deg: 5}"),
            ("tilt: {towards: left,}\n", "tilt: {towards: left, angle_deg: 5}\n"),
            ("tilt: {towards: left , # a, b\n  }\n", "tilt: {towards: left , # a, b\n  angle_deg: 5}\n"),
            ("tilt: {towards: left # a, b\n  }\n", "tilt: {towards: left # a, b\n  , angle_deg: 5}\n"),
            ("topple: 1\r\ntilt:\r\n  towards: left\r\nx: 1\r\n", "topple: 1\r\ntilt:\r\n  towards: left\r\n  angle_deg: 5\r\nx: 1\r\n"),
        )
        for before, after in cases:
            with self.subTest(before):
                self.assertEqual(self.changed(before, [{"path": ["tilt", "angle_deg"], "text": "5"}]), after)

    def test_aliases_and_lists_are_no_numbers(self):
        """Where no number can be put, it is said why, before a hand tries."""
        asked = "const scene = new it.SceneText(given); return scene.whyNoNumber(['tilt', 'angle_deg']);"
        for text, why in (("a: &t 5\ntilt: {angle_deg: *t}\n", "alias *t"), ("tilt: {angle_deg: [1, 2]}\n", "list"), ("tilt: 5\n", "no map"),
                          ("a: &m {angle_deg: 3}\ntilt: *m\n", "alias *m"), ("tilt: {angle_deg: &t 5}\n", None), ("x: 1\n", None), ("- 1\n", "no place")):
            found = node(SCENE / "scene_text.js", asked, text)
            self.assertTrue(found is None if why is None else why in found, (text, found))

    def test_a_tree_that_moves_along(self):
        """The tree of a text whose numbers changed is that of the new text read anew: every number stands where it says."""
        asked = """let scene = new it.SceneText(given.text);
          const wrong = [];
          const places = (node, path, found) => { if (node?.items) node.items.forEach((one, i) => one?.key ? places(one.value, [...path, one.key.value], found)
            : places(one, [...path, i], found)); else found.push([path.join("."), node.value, node.range.slice(0, 2).join()]); return found; };
          for (const numbers of given.edits) {
            scene = scene.movedTo(numbers);
            const anew = new it.SceneText(scene.text);
            if (JSON.stringify(places(scene.root, [], [])) !== JSON.stringify(places(anew.root, [], []))) wrong.push(scene.text);
          }
          return [wrong, scene.text];"""
        draw = random.Random(6)
        for name, layout in LAYOUTS.items():
            text = layout.format("110", "60", "75", "12")
            edits = [[{"path": path, "text": str(draw.randrange(10**draw.randrange(1, 7)))} for path in draw.sample(PATHS, draw.randrange(1, 4))] for _ in range(40)]
            wrong, last = node(SCENE / "scene_text.js", asked, {"text": text, "edits": edits})
            self.assertEqual(wrong, [], name)
            for each in edits:
                text = self.changed(text, each)
            self.assertEqual(last, text)

    def test_vertices_come_and_go(self):
        """In each layout of a list a vertex is put behind each other one and taken away again, which leaves the text as it
        was; any one can go, and what is then read are the others."""
        texts = [layout.format("110", "60", "75", "12") for layout in LAYOUTS.values()]
        found = node(SCENE / "scene_text.js", """const edits = await import(given.module); const outline = ["block", "outline"];
          const points = (text) => new it.SceneText(text).points(outline);
          return given.texts.map((text) => [0, 1, 2].map((at) => {
            const scene = new it.SceneText(text);
            const added = edits.withItem(scene, outline, at, "[7.5, -8]");
            return [points(text), points(added), edits.withoutItem(new it.SceneText(added), outline, at + 1), points(edits.withoutItem(scene, outline, at))];
          }));""", {"texts": texts, "module": (SCENE / "list_edits.js").as_uri()})
        for text, places in zip(texts, found):
            for at, (before, added, back, left) in enumerate(places):
                self.assertEqual(added, [*before[:at + 1], ["7.5", "-8"], *before[at + 1:]])
                self.assertEqual(back, text)
                self.assertEqual(left, [*before[:at], *before[at + 1:]])

    def test_key_at_a_place(self):
        """Of each word of an example the key that it belongs to, by the path that the program explains."""
        text = (ROOT / "examples" / "block_under_water.yaml").read_text(encoding="utf-8")
        places = {"direction_deg": "loads.anchors[].direction_deg", "[0, 4]": "loads.anchors[].at", "width": "block.slab.width", "35": "friction_angle_deg",
                  "3, uplift": "loads.water.height", "towards: left": "tilt.towards", "# docs": None}
        offsets = [text.index(word) for word in places]
        found = node(SCENE / "scene_text.js", """const {keyAt} = await import(given.module); const scene = new it.SceneText(given.text);
          return given.offsets.map((at) => keyAt(scene, at)?.path ?? null);""", {"module": (SCENE / "key_at.js").as_uri(), "text": text, "offsets": offsets})
        self.assertEqual(found, list(places.values()))
        for path in filter(None, places.values()):
            self.assertIn(f"{path}, a key of scenes", run("explain", path)[1])

    def test_random_scenes_read_back(self):
        """Edits of examples: what the program reads at the place is the number that was put there, and a second edit
        that puts the old one back gives the old text."""
        for name, path in (("block_e_valley", ["parameters", "a"]), ("slab", ["block", "slab", "width"]),
                           ("block_under_water", ["loads", "anchors", 0, "at", 1]), ("vault", ["block", "outline", 2, 1])):
            with self.subTest(name):
                text = (ROOT / "examples" / f"{name}.yaml").read_text(encoding="utf-8")
                old = node(SCENE / "scene_text.js", "return new it.SceneText(given[0]).scalar(given[1]);", [text, path])
                there = self.changed(text, [{"path": path, "text": "17.125"}])
                self.assertEqual(len(there), len(text) + len("17.125") - len(old))
                self.assertEqual(self.changed(there, [{"path": path, "text": old}]), text)

    def test_what_is_no_yaml_has_no_tree(self):
        for text, why in (("topple: {", "indent"), ("a: {\nb: 1\n}", "line"), ("a: b: c", "not valid YAML"), ("x" * 300_000, "too long")):
            self.assertIn(why, node(SCENE / "scene_text.js", "return new it.SceneText(given).unread;", text))


class Sources(unittest.TestCase):
    def test_no_source_makes_markup_of_text(self):
        """None of the calls by which text becomes markup stands in the page's sources."""
        calls = re.compile(r"\b(innerHTML|outerHTML|insertAdjacentHTML|document\.write|DOMParser|createContextualFragment|eval|new Function)\b|\.html\(")
        for path in sorted((ROOT / "src" / "applications" / "explorer").rglob("*.js")):
            if "node_modules" in path.parts:
                continue
            with self.subTest(path.name):
                self.assertIsNone(calls.search(path.read_text(encoding="utf-8")))


if __name__ == "__main__":
    main()
