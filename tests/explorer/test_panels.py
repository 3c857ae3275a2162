# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What stands beside the drawing says what the native program says: each number of verdict, factors, pivots and forces is
its number rounded, curves and reports are its bytes, maps its verdicts, formulas and claims its own; in the browser, by
the menu of examples, the mouse and the keyboard."""

import csv
import decimal
import json
import pathlib
import re
import tempfile
import time

from page_case import PAGE
from panel_case import PanelCase
from harness import main, run, solve, ROOT

EXAMPLES = ("block_e_valley", "block_a_peak", "slab", "two_density_block", "block_under_water", "boulder",
            "tilt_locked_stress", "l_shaped_block", "partial_contact", "resting_block", "block_on_joint")
UNITS = {"mm": "0.001", "cm": "0.01", "m": "1", "km": "1000", "in": "0.0254", "ft": "0.3048"}
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


def scene(name):
    return f"examples/{name}.yaml"


def unit_of(name):
    text = pathlib.Path(ROOT, scene(name)).read_text(encoding="utf-8")
    return decimal.Decimal(UNITS[re.search(r"^length_unit: (\w+)", text, re.M).group(1)])


class Panels(PanelCase):
    def folder(self):
        return self.enterContext(tempfile.TemporaryDirectory())

    def holds(self, text, number, unit=1):
        """The digits printed are the rounding of the truth, which lies within the bound of the native program."""
        found = NUMBER.search(text)
        self.assertIsNotNone(found, text)
        printed = decimal.Decimal(found.group())
        value, error = (decimal.Decimal(repr(number[key])) / unit for key in ("value", "error"))
        places = -printed.as_tuple().exponent
        half = decimal.Decimal(5).scaleb(-places - 1)
        # of an exact number, as of a length without its last zeros, fewer places are printed than are certain
        self.assertLessEqual(abs(printed - value), half + error, text)

    def test_verdicts(self):
        """Verdict, governing factor, both ends of the window, margin and what another base would do."""
        for name in EXAMPLES:
            self.shown(name)
            for case in solve(scene(name))["cases"]:
                at = f"#panel-verdict [data-towards={case['towards']}] "
                verdict = self.said(at + ".verdict")
                self.assertTrue(verdict.lower().startswith(case["mechanism"]), (name, verdict))
                fos = self.said(at + "[data-number=governing_fos]")
                if case["governing_fos"]["fos"] is None:
                    self.assertIn(case["governing_fos"]["fos_is"], self.said(at + ".fos"))
                else:
                    self.holds(fos, case["governing_fos"]["fos"])
                self.holds(self.said(at + "[data-number=onset]"), case["onset"]["critical_angle_deg"])
                self.holds(self.said(at + "[data-number=limit]"), case["limit"]["critical_angle_deg"])
                margin = self.said(at + "[data-number=margin]")
                self.assertEqual(margin is None, case["first"]["margin_deg"] is None)
                if margin is not None:
                    self.holds(margin, case["first"]["margin_deg"])
                self.assertEqual(self.said(at + "[data-number=history]") is not None, case["onset"]["below_limit"])
                otherwise = self.said(at + "[data-number=otherwise]")
                self.assertEqual(otherwise is not None, case["limit"]["base_matters"])
                if otherwise is not None:
                    self.holds(otherwise, case["limit"]["otherwise"]["critical_angle_deg"])

    def test_factors_and_pivots(self):
        for name in EXAMPLES:
            self.shown(name)
            self.tab("pivots")
            for case in solve(scene(name))["cases"]:
                rows = self.rows(f"#panel-factors [data-towards={case['towards']}]")
                self.assertEqual(len(rows), len(case.get("factors", [])))
                for row, factor in zip(rows, case.get("factors", [])):
                    if factor["fos"] is None:
                        self.assertEqual(row[0], factor.get("fos_is", "none"))
                    else:
                        self.holds(row[0], factor["fos"])
                    self.assertEqual("(excluded" in row[2], not factor["counts"])
                rows = self.rows(f"#panel-pivots [data-towards={case['towards']}]")
                self.assertEqual(len(rows), len(case["pivots"]), name)
                for row, pivot in zip(rows, case["pivots"]):
                    self.assertEqual(row[0], f"{pivot['index'] + 1} {pivot['kind']}")
                    self.holds(row[1], pivot["x_m"], unit_of(name))
                    self.holds(row[2], pivot["y_m"], unit_of(name))
                    if pivot["critical_angle_deg"] is not None:
                        self.holds(row[3], pivot["critical_angle_deg"])
                    if pivot["fos"] is not None:
                        self.holds(row[4], pivot["fos"])
                    governs = (case["toppling"] or {}).get("pivot") == pivot["index"]
                    self.assertEqual(row[6], "governs" if governs else "free" if pivot["admissible"] else "blocked")

    def test_forces(self):
        """The reactions are the program's, they balance the weight at the limit, and each lies in its cone."""
        for name in EXAMPLES:
            self.shown(name)
            self.tab("forces")
            self.awaits(f"document.querySelector('#panel-forces').dataset.scene === '{name}.yaml'")
            for case in solve(scene(name))["cases"]:
                rows = self.rows(f"#panel-forces [data-towards={case['towards']}] [aria-label^='Reactions at the limit']")
                reactions = case["limit"]["reactions"]
                self.assertEqual(len(rows), len(reactions))
                for row, reaction in zip(rows, reactions):
                    for cell, key, unit in zip(row, ("x_m", "y_m", "share_x", "share_y"), (unit_of(name),) * 2 + (1, 1)):
                        self.holds(cell, reaction[key], unit)
                    if row[5] != "—":
                        self.assertLessEqual(abs(float(row[5].rstrip("°"))), case["limit"]["friction_angle_deg"]["value"] + 0.005)

    def test_curves(self):
        """The table behind a curve is what `sweep` prints, but for the last digits of bounds, and refined to 241 points."""
        self.shown("slab_left")
        self.tab("curves")
        self.awaits("(document.querySelector('#panel-curves .told').textContent.match(/^\\d+/) ?? [''])[0] === '241'")
        self.assertTrue(self.value("document.querySelector('#panel-curves .chart canvas').width > 200"))
        self.shown("block_e_valley")
        self.value("{ const menu = document.querySelectorAll('#panel-curves select')[1]; menu.value = 'friction_angle_deg';"
                        " menu.dispatchEvent(new Event('change')) } 0")
        self.awaits("/friction/.test(document.querySelector('#panel-curves .u-legend')?.textContent ?? '') &&"
                       " document.querySelector('#panel-curves .told').textContent.startsWith('241')")
        self.read_by_keys()
        saved = self.saved(self.folder(), lambda: self.click("#panel-curves .told a"), "curve.csv")
        status, out, err = run("sweep", scene("block_e_valley"), "--x", "friction_angle_deg=5:60:(60-(5))/240")
        self.assertEqual((status, err), (0, ""))
        own, native = (list(csv.DictReader(text.splitlines())) for text in (saved.decode(), out))
        self.assertEqual(len(own), len(native))
        for row, expected in zip(own, native):
            for key, value in expected.items():
                if key.endswith("_error") and value:
                    self.assertAlmostEqual(float(row[key]), float(value), delta=1e-6 * float(value))
                else:
                    self.assertEqual(row[key], value)

    def read_by_keys(self):
        """The legend, which is read out, tells what is at one number after another."""
        self.value("document.querySelector('#panel-curves .uplot').focus()")
        told = "document.querySelector('#panel-curves .u-legend .u-value').textContent"
        for keys, expected in ((("Home",), "5"), (("ArrowRight",) * 4, "5.9167"), (("ArrowLeft",), "5.6875"), (("End",), "60")):
            for key in keys:
                self.press(key)
            self.awaits(f"{told} === '{expected}'")
        self.assertEqual(self.value("document.querySelector('#panel-curves .u-legend').getAttribute('aria-live')"), "polite")

    def test_map(self):
        """Of 200 by 200 points, told from few that are solved, 441 are asked of the native program one by one; lines are
        there; how long it takes is printed; the scene is a point that can be dragged, and by the arrow keys."""
        self.shown("block_e_valley")
        self.tab("map")
        done = "document.querySelector('#panel-map .told').textContent.includes('roots')"
        self.awaits(done)
        milliseconds = float(self.value("document.querySelector('#panel-map .told').dataset.milliseconds"))
        print(f"map of 200 x 200 over a and the tilt: {milliseconds / 1000:.2f} s")
        if "://" not in PAGE:
            self.assertLess(milliseconds, 10_000)
        colours = self.value(
            "{ const c = document.querySelector('#panel-map canvas'), d = c.getContext('2d').getImageData(0, 0, 201, 201).data;"
            " const f = []; for (let r = 0; r <= 200; r += 10) for (let k = 0; k <= 200; k += 10) {"
            " const at = 4 * ((200 - r) * 201 + k); f.push([...d.slice(at, at + 3)].join()); } f }")
        ticks = [float(each) for each in self.texts("#panel-map .axes text")[:12]]
        low, high = ticks[0], ticks[5]
        status, out, err = run("sweep", scene("block_e_valley"), "--json", "--x", f"a={low}:{high}:({high}-{low})/20",
                               "--y", "tilt.angle_deg=0:60:3")
        self.assertIn(status, (0, 4), err)
        verdicts = [point["cases"][0]["verdict"] for point in json.loads(out)["points"]]
        pairs = set(zip(verdicts, colours))
        self.assertEqual(len(pairs), len(set(verdicts)), pairs)
        self.assertEqual(len(pairs), len(set(colours)), pairs)
        self.assertGreaterEqual(len(pairs), 2)
        self.assertGreater(self.value("document.querySelectorAll('#panel-map .borders path').length"), 2)

    def test_map_point(self):
        self.shown("block_e_valley")
        self.tab("map")
        self.awaits("document.querySelector('#panel-map canvas').width === 201")
        x, y = self.middle("#panel-map .scene-point .touch")
        self.browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y - 100)
        self.assertRegex(self.said("#panel-map .pointed"), r"^a [\d.]+, tilt [\d.]+: [a-z ]+$")
        self.pull((x, y), (x, y - 60))
        self.awaits("Number(document.querySelector('#numbers input[type=text]').value) > 24")
        before = float(self.value("document.querySelector('#numbers input[type=text]').value"))
        self.value("document.querySelector('#panel-map .scene-point').focus()")
        self.key("ArrowDown")
        self.awaits(f"Number(document.querySelector('#numbers input[type=text]').value) < {before}")
        self.click("#undo")
        self.click("#undo")
        self.awaits("document.querySelector('#numbers input[type=text]').value === '20'")

    def test_a_map_holds_nothing_up(self):
        """While the borders of a map over two lengths are being found, which takes seconds, another tilt is answered."""
        self.shown("block_e_valley")
        self.tab("map")
        self.value("{ const menus = document.querySelectorAll('#panel-map select'); menus[1].value = 'friction_angle_deg';"
                   " menus[1].dispatchEvent(new Event('change')); } 0")
        self.awaits("document.querySelector('#panel-map .told').textContent.includes('being found')", 60)
        began = time.monotonic()
        self.value("{ const f = document.querySelector('#numbers input[type=text]'); f.value = '29';"
                   " f.dispatchEvent(new Event('input')); } 0")
        self.awaits("/^Slides and topples at 29°/.test(document.querySelector('#panel-verdict .verdict').textContent)")
        took = time.monotonic() - began
        found = self.value("document.querySelector('#panel-map .told').textContent.includes('being found')")
        print(f"answered in {took:.2f} s while a map was made")
        self.assertTrue(found)
        self.assertLess(took, 1.5)

    def test_formulas(self):
        """The governing formula of the program, typeset; a slider moves the scene, the formula's number and the verdict."""
        self.shown("block_e_valley")
        self.tab("derive")
        self.awaits("Boolean(document.querySelector('#panel-derive .value output')?.textContent)")
        status, out, _ = run("derive", "--json", scene("block_e_valley"))
        self.assertEqual(status, 0)
        governing = next(pivot for pivot in json.loads(out)["pivots"] if pivot["governs"])
        shown = self.texts("#panel-derive .equation math")[1]
        letters = re.sub(r"[*^ ]", "", governing["tan_critical_angle"]["numerator"] + governing["tan_critical_angle"]["denominator"])
        self.assertEqual(re.sub(r"\s", "", shown), "tanαcrit=" + letters)
        self.assertTrue(self.value("[...document.querySelectorAll('#panel-derive mfrac')].every(f =>"
                                        " f.children[0].getBoundingClientRect().bottom <= f.children[1].getBoundingClientRect().top + 3)"))
        self.value("{ const s = document.querySelector('#panel-derive .slider input'); s.value = '24';"
                        " s.dispatchEvent(new Event('input')); s.dispatchEvent(new Event('change')); } 0")
        case = solve(scene("block_e_valley"), "--set", "a=24")["cases"][0]
        angle = case["toppling"]["critical_angle_deg"]["value"]
        self.awaits(f"Math.abs(parseFloat(document.querySelector('#panel-derive .value output').textContent) - {angle}) < 6e-5")
        self.answered()
        self.holds(self.said("#panel-verdict [data-number=governing_fos]"), case["governing_fos"]["fos"])
        self.click("#panel-derive .choices label:nth-child(2) input")
        self.awaits("/Static limit/.test(document.querySelector('#panel-derive').textContent)")
        limit = case["limit"]["critical_angle_deg"]["value"]
        self.awaits(f"[...document.querySelectorAll('#panel-derive .value output')].some(o => Math.abs(parseFloat(o.textContent) - {limit}) < 6e-5)")

    def claim(self, quantity, printed):
        self.value(f"{{ const p = document.querySelector('#panel-verify'); p.querySelector('select').value = '{quantity}';"
                        f" p.querySelector('input.formula').value = {json.dumps(printed)}; p.querySelector('form').requestSubmit(); }} 0")
        self.awaits("!/^…?$/.test(document.querySelector('#panel-verify .claim').textContent)")
        return self.said("#panel-verify .claim")

    def test_verify(self):
        """A misprint is refuted and mended, the mended formula is proven, a number agrees, and nonsense is told."""
        self.shown("block_e_valley")
        self.tab("verify")
        wrong = self.claim("critical_angle", "tan^-1((27ab + 14ac)/(9b^2 + 18bc + 6c^2))")
        self.assertTrue(wrong.startswith("refuted"), wrong)
        self.assertIn("the number 14 at column 16 is 13", wrong)
        self.assertTrue(self.claim("critical_angle", "tan^-1((27ab + 13ac)/(9b^2 + 18bc + 6c^2))").startswith("proven"))
        self.assertTrue(self.claim("critical_angle", "35.2").startswith("agrees"))
        self.assertTrue(self.claim("critical_angle", "35.3").startswith("disagrees"))
        told = self.claim("critical_angle", 'a/2b"\n- : {')
        self.assertNotRegex(told, "proven|agrees|refuted")
        self.assertGreater(len(told), 10)

    def test_accuracy(self):
        """Ways, prices and certain digits are the native program's; the times are of this machine."""
        self.shown("block_e_valley")
        self.tab("accuracy")
        self.button("Measure on this machine", "#panel-accuracy")
        self.awaits("/Measured in/.test(document.querySelector('#panel-accuracy .told').textContent)", 120)
        rows = self.rows("#panel-accuracy [aria-label=Measurements]")
        status, out, _ = run("accuracy", "--json", scene("block_e_valley"))
        self.assertEqual(status, 0)
        runs = [each for each in json.loads(out)["runs"] if each.get("bound_log10") is not None]
        self.assertEqual([row[:3] for row in rows], [[each["method"], each["level"], str(each["bits"])] for each in runs])
        for row, each in zip(rows, runs):
            self.assertAlmostEqual(int(row[4]), -each["bound_log10"], delta=1.001)
            self.assertGreater(float(row[3].lstrip("< ")), 0)

    def test_light_and_dark(self):
        """Curves and maps take the colours that are chosen: their ink is light on dark, and the map's colours are others."""
        self.shown("block_e_valley")
        self.tab("map")
        pixel = "document.querySelector('#panel-map canvas').toDataURL()"
        self.awaits("document.querySelector('#panel-map .told').textContent.includes('roots')")
        light = self.value(pixel)
        self.value("{ const s = document.getElementById('theme'); s.value = 'dark'; s.dispatchEvent(new Event('change')); } 0")
        self.awaits(f"{pixel} !== {json.dumps(light)}")

    def test_reports(self):
        """The report as text but for its time, and the figure byte for byte."""
        self.shown("block_e_valley")
        self.tab("report")
        self.awaits("document.querySelector('#panel-report pre')?.textContent.includes('Certain to every digit')")
        _, out, _ = run("solve", scene("block_e_valley"))
        self.assertEqual(self.said("#panel-report pre").splitlines()[:-1], out.splitlines()[:-1])
        saved = self.saved(self.folder(), lambda: self.button("Solution, JSON"), "block_e_valley.json")
        told, native = (each["cases"][0]["limit"] for each in (json.loads(saved), solve(scene("block_e_valley"))))
        self.assertEqual(told.keys(), native.keys())
        for key in ("critical_angle_deg", "centre_x_m", "fos"):  # elsewhere the bounds may differ, but not the truth
            self.assertLessEqual(abs(told[key]["value"] - native[key]["value"]), told[key]["error"] + native[key]["error"])

    def test_figures_and_sheets_are_the_command_line_s(self):
        """By their buttons: the figure's bytes; the sheet line by line, but for times and the folder of the scene."""
        self.shown("block_e_valley")
        self.tab("report")
        native = pathlib.Path(self.folder())
        for option, label, ending in (("--figure", "Figure, SVG", "svg"), ("--figure", "Figure, PDF", "pdf"),
                                      ("--report", "Calculation sheet, Markdown", "md")):
            with self.subTest(label):
                saved = self.saved(self.folder(), lambda: self.button(label), f"block_e_valley.{ending}")
                own = native / f"own.{ending}"
                status, _, err = run("solve", "--quiet", option, own, "block_e_valley.yaml", folder=ROOT / "examples")
                self.assertEqual((status, err), (0, ""))
                if ending != "md":
                    self.assertEqual(saved, own.read_bytes())
                    continue
                timed = re.compile(r"\|[^|\n]*\|\n")
                self.assertEqual(timed.sub("|\n", saved.decode()), timed.sub("|\n", own.read_text(encoding="utf-8")))

    def test_words_are_explained(self):
        """By the keyboard: a word that has the focus tells what it means, in the program's own words; Escape hides it."""
        self.shown("block_e_valley")
        self.value("document.querySelector('#panel-verdict .verdict .term').focus()")
        self.awaits("!document.getElementById('explanation').hidden")
        _, out, _ = run("explain", "stands")
        told = re.sub(r"\s+", " ", self.said("#explanation"))
        self.assertIn(re.sub(r"\s+", " ", out.splitlines()[1].strip()), told)
        self.key("Escape")
        self.awaits("document.getElementById('explanation').hidden")

    def test_a_scene_without_an_answer(self):
        """The last answer stays, greyed, and says so; with the next scene it goes."""
        self.shown("block_e_valley")
        self.value("{ const field = document.querySelector('#numbers input[type=text]'); field.value = '20'; } 0")
        self.tab("text")
        self.value("document.querySelector('#editor .cm-content').focus()")
        self.browser.call("Input.insertText", text="nonsense: 1\n")
        self.awaits("!document.querySelector('#panel-verdict .stale').hidden")
        self.assertIn("last one", self.said("#panel-verdict .stale"))
        self.shown("slab")
        self.assertTrue(self.value("document.querySelector('#panel-verdict .stale').hidden"))

    def test_tabs_by_the_keyboard(self):
        self.click("#tab-pivots")
        self.value("document.getElementById('tab-pivots').focus()")
        self.key("ArrowRight")
        self.assertEqual(self.value("document.activeElement.id"), "tab-forces")
        self.assertFalse(self.value("document.getElementById('panel-forces').hidden"))
        self.key("End")
        self.assertEqual(self.value("document.activeElement.id"), "tab-about")
        self.key("Home")
        self.assertEqual(self.value("[...document.querySelectorAll('[role=tab]')].filter(t => t.tabIndex === 0).length"), 1)


if __name__ == "__main__":
    main()
