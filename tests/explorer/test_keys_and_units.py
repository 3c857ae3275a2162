# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Keys proposed while they are typed, from the program's own table of keys, and scenes in another unit of length: the native
program finds the same block there."""

import fractions
import json
import pathlib
import re
import sys
import tempfile
import unittest

from node_case import NODE, node
from page_case import ROOT, WORDS, main, run
from panel_case import PanelCase

EXPLORER = ROOT / "src" / "applications" / "explorer"
SCENE = EXPLORER / "scene"
sys.path.insert(0, str(EXPLORER))

from bundling import keys  # noqa: E402

METRES = {"mm": "0.001", "cm": "0.01", "m": "1", "km": "1000", "in": "0.0254", "ft": "0.3048"}
# A cursor (|) in what is typed, and the path of the map whose keys can stand there; None: none can
PLACES = [
    ("topple: 1\nfric|\ntilt: {angle_deg: 3}", ""),
    ("block:\n  ou|\n  thickness: 3\n", "block"),
    ("block:\n  |", "block"),
    ("block:\n  slab: {width: 1}\n|", ""),
    ("tilt: {towards: left, an|}", "tilt"),
    ("tilt: {|}", "tilt"),
    ("tilt: {towards: |}", None),
    ("base:\n  mated: true\n  beyond: {left: 1, \n    ri|}\n", "base.beyond"),
    ("loads:\n  anchors:\n    - {at: [0, 1], |}", "loads.anchors[]"),
    ("loads:\n  anchors:\n    - at: [1, 2]\n      dir|\n", "loads.anchors[]"),
    ("loads:\n  anchors:\n  - at: [1, 2]\n    fo|\n  - at: [3, 4]\n", "loads.anchors[]"),
    ("loads:\n  anchors:\n    - a|", "loads.anchors[]"),
    ("block: {outline: [[0, |0]]}", None),
    ("block:\n  parts:\n    - outline: [[0, 0],\n        [1, 1]]\n      un|\n", "block.parts[]"),
    ("title: a |b", None), ("# com|", None), ("topple: 1  # co|", None), ("title: 'a, {|'", None),
    ("shaking:\n  horizontal: {half_sine: {pe|}}", "shaking.horizontal.half_sine"),
]
SLAB = "topple: 1\nlength_unit: m\nblock:\n  slab: {width: 1, height: 2}\nbase: {mated: true, beyond: {left: 0, right: 0}}\n"


@unittest.skipIf(NODE is None, "there is no node: install Debian's package nodejs")
class Parts(unittest.TestCase):
    def test_where_a_key_is_typed(self):
        given = [[text.replace("|", ""), text.index("|")] for text, _ in PLACES]
        found = node(SCENE / "key_place.js", "return given.map(([text, at]) => it.keyPlace(text, at)?.path ?? null);", given)
        for (text, path), place in zip(PLACES, found):
            with self.subTest(text):
                self.assertEqual(place, path)

    def test_every_key_of_every_example_is_proposed_where_it_stands(self):
        """At each key of the examples, as if it were typed there: the table has it among those of that map."""
        texts = [path.read_text(encoding="utf-8") for path in sorted((ROOT / "examples").glob("**/*.yaml"))]
        scenes = [text for text in texts if text.lstrip("#").find("topple: 1") >= 0]
        self.assertGreater(len(scenes), 40)
        body = f"""const {{ keyPlace }} = await import({json.dumps((SCENE / 'key_place.js').as_uri())});
          const {{ parseDocument, isMap, isSeq }} = await import({json.dumps((EXPLORER / 'node_modules/yaml/dist/index.js').as_uri())});
          const wrong = []; let count = 0;
          const walk = (text, node, path) => {{
            if (isMap(node)) for (const {{ key, value }} of node.items) {{
              if (path === "parameters" || path.endsWith(".set")) continue;
              const place = keyPlace(text, key.range[0] + 1);
              const ok = place !== null && it.keysOf(given.keys, place.path).some((one) => one.key === key.value);
              count++;
              if (!ok) wrong.push(path + "." + key.value + " in " + place?.path);
              walk(text, value, path === "" ? key.value : path + "." + key.value);
            }} else if (isSeq(node)) node.items.forEach((item) => walk(text, item, path + "[]"));
          }};
          for (const text of given.scenes) walk(text, parseDocument(text, {{ schema: "failsafe", logLevel: "silent" }}).contents, "");
          return [count, wrong];"""
        count, wrong = node(SCENE / "scene_keys.js", body, {"keys": keys.keys(), "scenes": scenes})
        self.assertGreater(count, 500)
        # what a profile of a mesh has stands in the table at the outline of one
        self.assertEqual([each for each in wrong if not each.startswith("base.profile.")], [])

    def test_decimals_in_another_unit(self):
        """Against fractions: each is exact, as a decimal where it ends, else as a product."""
        numbers = ["1", "0", "-0.5", "12.75", "1e-3", "30", "1e6", ".25", "-7.0625", "0.3048"]
        given = [[text, one, other] for text in numbers for one in METRES for other in METRES]
        body = """const { UNITS, times } = it;
          const gcd = (a, b) => (b === 0n ? a : gcd(b, a % b));
          return given.map(([text, one, other]) => { const [[a, b], [c, d]] = [UNITS[one], UNITS[other]];
            const [over, under] = [a * d, b * c]; const by = gcd(over, under); return times(text, [over / by, under / by]); });"""
        for (text, one, other), made in zip(given, node(SCENE / "length_units.js", body, given)):
            exact = fractions.Fraction(text) * fractions.Fraction(METRES[one]) / fractions.Fraction(METRES[other])
            with self.subTest(text, one=one, other=other):
                factors = re.fullmatch(r"([^*]+)\*(\d+)/(\d+)", made)
                self.assertEqual(factors is None, {2, 5}.issuperset(primes(exact.denominator)))
                value = fractions.Fraction(made) if factors is None else fractions.Fraction(factors[1]) * int(factors[2]) / int(factors[3])
                self.assertEqual(value, exact)

    def test_block_is_the_same_in_every_unit(self):
        """The native program's answers, which are in metres and degrees, for each example that can be changed."""
        lengths = keys.keys()
        changed = 0
        for path in sorted((ROOT / "examples").glob("*.yaml")):
            text = path.read_text(encoding="utf-8")
            body = f"""const {{ SceneText }} = await import({json.dumps((SCENE / 'scene_text.js').as_uri())});
              const {{ inUnit }} = await import({json.dumps((SCENE / 'length_units.js').as_uri())});
              try {{ return ["ft", "cm"].map((unit) => inUnit(new SceneText(given.text), unit, it.lengthsOf(given.keys))); }}
              catch (error) {{ if (error instanceof RangeError) return error.message; throw error; }}"""
            made = node(SCENE / "scene_keys.js", body, {"text": text, "keys": lengths})
            if isinstance(made, str):
                continue
            status, before, _ = run("solve", "--json", path.name, folder=path.parent)
            if status != 0:
                continue
            changed += 1
            for unit, other in zip(("ft", "cm"), made):
                with self.subTest(path.name, unit=unit), tempfile.TemporaryDirectory() as folder:
                    for beside in path.parent.iterdir():
                        (pathlib.Path(folder) / beside.name).symlink_to(beside)
                    (pathlib.Path(folder) / "in_another_unit.yaml").write_text(other, encoding="utf-8")
                    status, after, err = run("solve", "--json", "in_another_unit.yaml", folder=folder)
                    self.assertEqual(status, 0, err)
                    # what the program makes by a rule, or cuts out of a mesh, it rounds in the scene's own unit
                    slack = 1e-4 if any(word in text for word in ("self_affine", "mesh:")) else 0
                    for one, two in zip(json.loads(before)["cases"], json.loads(after)["cases"]):
                        self.assertEqual(one["mechanism"], two["mechanism"])
                        near(self, *(each.get("limit", {}).get("critical_angle_deg") for each in (one, two)), slack)
                        near(self, one["block"]["area_m2"], two["block"]["area_m2"], slack)
                        near(self, one.get("governing_fos", {}).get("fos"), two.get("governing_fos", {}).get("fos"), slack)
        self.assertGreater(changed, 25)

    def test_what_cannot_be_changed_says_why(self):
        texts = [SLAB.replace("width: 1", "width: 1/3"), SLAB.replace("length_unit: m\n", ""),
                 SLAB.replace("slab: {width: 1, height: 2}", "outline: stone.csv"),
                 SLAB.replace("length_unit: m\n", "length_unit: m\nparameters: {a: 10}\n").replace("width: 1", "width: a") + "tilt: {angle_deg: a}\n"]
        body = f"""const {{ SceneText }} = await import({json.dumps((SCENE / 'scene_text.js').as_uri())});
          const {{ inUnit }} = await import({json.dumps((SCENE / 'length_units.js').as_uri())});
          return given.texts.map((text) => {{ try {{ return inUnit(new SceneText(text), "mm", it.lengthsOf(given.keys)); }} catch (error) {{ return error.message; }} }});"""
        found = node(SCENE / "scene_keys.js", body, {"texts": texts, "keys": keys.keys()})
        for said, word in zip(found, ("formula 1/3", "length_unit", "stone.csv", "parameter a")):
            self.assertIn(word, said)


def primes(number):
    found = set()
    for prime in (2, 5, 3, 127, number):
        while number > 1 and number % prime == 0:
            number //= prime
            found.add(prime)
    return found


def near(case, one, two, slack):
    """Equal within both bounds, and a share of the value."""
    if one is None or two is None:
        case.assertEqual(one, two)
        return
    case.assertLessEqual(abs(one["value"] - two["value"]), one["error"] + two["error"] + slack * abs(one["value"]))


class Page(PanelCase):
    def setUp(self):
        super().setUp()
        self.browser.call("Emulation.setFocusEmulationEnabled", enabled=True)  # as of the window in front

    def test_keys_are_proposed_and_taken(self):
        """Two letters, and Enter takes the key that they begin, with its colon; what it means stands beside it."""
        self.type_scene(SLAB)
        self.answered()
        self.browser.call("Input.insertText", text="fri")
        self.awaits("document.querySelector('.cm-tooltip-autocomplete li[aria-selected]') !== null")
        listed = self.texts(".cm-tooltip-autocomplete li .cm-completionLabel")
        self.assertEqual(listed[:2], ["friction_angle_deg", "friction_is"])
        self.awaits("document.querySelector('.cm-completionInfo')?.textContent.includes('friction_angle_deg')")
        time_of_grace = "new Promise(done => setTimeout(done, 120))"  # in which CodeMirror takes no Enter for it
        self.browser.call("Runtime.evaluate", awaitPromise=True, expression=time_of_grace)
        self.press("Enter", text="\r")
        self.browser.call("Input.insertText", text="30\n")
        self.answered()
        self.assertEqual(self.value(WORDS), SLAB + "friction_angle_deg: 30\n")
        self.browser.call("Input.insertText", text="fri")
        self.awaits("document.querySelector('.cm-tooltip-autocomplete li') !== null")
        self.assertNotIn("friction_angle_deg", self.texts(".cm-tooltip-autocomplete li .cm-completionLabel"))

    def chosen(self, option):
        """From the menu of units, by its keys."""
        self.value("document.activeElement.blur(), document.getElementById('units').focus()")
        found = self.value(f"(() => {{ const s = document.getElementById('units'); const o = [...s.options].find(o => o.value === {json.dumps(option)});"
                           " if (o.disabled) return false; s.value = o.value; s.dispatchEvent(new Event('change')); return true; })()")
        self.frame()
        return found

    def test_same_block_in_another_unit(self):
        """The drawing stays, numbers and scale change; it is one step back."""
        drawn = "(() => { const b = document.querySelector('.shape.block').getBoundingClientRect(); return [b.x, b.y, b.width, b.height].map(Math.round); })()"
        before, shape, said = self.text(), self.value(drawn), self.said("#factor-said")
        self.assertTrue(self.chosen("0 cm"))
        self.answered()
        self.assertIn("length_unit: cm", self.text())
        self.assertIn("{a: 3, b: 12, c: 0.5}", self.text())
        self.assertEqual(self.value(drawn), shape)
        self.assertEqual(self.said("#factor-said"), said)
        self.assertIn("cm", self.said("g.scale text"))
        self.click("#undo")
        self.answered()
        self.assertEqual(self.text(), before)

    def test_units_of_reports_and_what_is_meant(self):
        self.assertTrue(self.chosen("3 lbf"))
        self.answered()
        self.assertRegex(self.text(), r"result_units: \{force: lbf\}")
        self.tab("report")
        self.awaits("document.querySelector('#panel-report pre')?.textContent.includes('lbf')")
        self.assertTrue(self.chosen("1 m"))
        self.answered()
        self.assertIn("{a: 30, b: 120, c: 5}", self.text())
        self.assertFalse(self.chosen("1 m"))


if __name__ == "__main__":
    main()
