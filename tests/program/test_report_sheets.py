# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Calculation sheets, as `topple solve --report` writes them.

The story: an engineer signs the page and a reviewer repeats it with a pocket calculator. So every number on it is the
one of the JSON, every formula holds with the digits that stand in it, the account by elements adds up, and the page
says of which input it is."""

import hashlib
import math
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

from harness import PROGRAM, ROOT, main, run, solve
from report_case import Interval, Page, number, words

EXAMPLES = ("block_e_valley", "block_a_peak", "l_shaped_block", "two_density_block", "block_with_hole", "block_seismic",
            "block_under_water", "block_bonded", "block_a_worn", "vault", "boulder_on_rough_ground", "partial_contact",
            "resting_poses", "block_f", "boulder_ellipse", "block_on_clay")
UNITS = {"mm": 1e-3, "cm": 1e-2, "m": 1.0}
EPOCH = {**os.environ, "SOURCE_DATE_EPOCH": "1700000000"}


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.path = pathlib.Path(cls.folder.name)
        cls.pages = {}
        for name in EXAMPLES:
            scene = f"examples/{name}.yaml"
            status, _, err = run("solve", scene, "--report", cls.path / f"{name}.html")
            if status != 0:
                raise AssertionError((name, status, err))
            try:
                told = solve(scene, "--elements", "--pivots=all")
            except AssertionError:
                told = solve(scene, "--pivots=all")
            text = (cls.path / f"{name}.html").read_text(encoding="utf-8")
            unit = re.search(r"(?m)^length_unit: (\w+)", (ROOT / scene).read_text(encoding="utf-8")).group(1)
            cls.pages[name] = Page(text), told["cases"], UNITS[unit]

    def each(self):
        for name, (page, cases, unit) in self.pages.items():
            with self.subTest(name):
                yield page, cases, unit

    def same(self, printed, bounded, scale=1.0):
        """The printed digits are those of the number of JSON."""
        value, half = number(printed)
        self.assertLessEqual(abs(value - bounded["value"] / scale), half + bounded["error"] / scale + 1e-12 * abs(value), printed)

    def same_factor(self, printed, bounded):
        """And of a factor of safety, which is rounded down."""
        value, half = number(printed)
        self.assertLessEqual(value, bounded["value"] + bounded["error"] + 1e-12, printed)
        self.assertLessEqual(bounded["value"] - value, 2 * half + 2 * bounded["error"] + 1e-12, printed)

    def test_factors(self):
        """The factors of safety, which counts, and which governs."""
        seen = 0
        for page, cases, _ in self.each():
            tilted = [case for case in cases if case["factors"]]
            tables = page.tables("Factors of safety")
            self.assertEqual(len(tables), len(tilted))
            for table, case in zip(tables, tilted):
                self.assertEqual(len(table) - 1, len(case["factors"]))
                for (_, fos, _, counts), factor in zip(table[1:], case["factors"]):
                    self.assertEqual(counts.startswith("no"), not factor["counts"])
                    if factor["fos"] is not None and factor["fos"]["value"] >= 0:
                        self.same_factor(fos, factor["fos"])
                        seen += 1
                governing = [row for row in table if row[3] == "governs"]
                if case["governing_fos"]["fos"] is not None:
                    self.same_factor(governing[0][1], case["governing_fos"]["fos"])
        self.assertGreater(seen, 20)

    def test_window(self):
        """Tilt, onset, limit and margin."""
        for page, cases, _ in self.each():
            for table, case in zip(page.tables("Tilts up to which"), cases):
                facts = dict(table)
                if "tilt_angle_deg" in case:
                    self.same(facts["Tilt of the scene"].split("=")[1], case["tilt_angle_deg"])
                for words, key in (("Certain to stand up to", "onset"), ("Certain to move beyond", "limit")):
                    if "=" in facts[words]:
                        self.same(facts[words].split("=")[1], case[key]["critical_angle_deg"])
                    else:
                        self.assertIsNone(case.get(key, {}).get("critical_angle_deg"))
                if case["first"]["margin_deg"] is not None:
                    self.same(facts["Margin to the lower of them"], case["first"]["margin_deg"])

    def test_pivots(self):
        """Where they are, at which tilt it topples about each, and with which factor."""
        seen = 0
        for page, cases, unit in self.each():
            for table, case in zip(page.tables("Points about which"), cases):
                for line in table[1:]:
                    row, pivot = dict(zip(table[0], line)), case["pivots"][int(line[0]) - 1]
                    self.assertEqual(row["Kind"], pivot["kind"])
                    self.same(line[2], pivot["x_m"], unit)
                    self.same(line[3], pivot["y_m"], unit)
                    if pivot["critical_angle_deg"] is not None:
                        self.same(row["Topples at"], pivot["critical_angle_deg"])
                    for head, key in (("FoS", "fos"), ("FoS by elements", "fos_elements")):
                        if head in row and re.match(r"[\d.]", row[head]) and pivot[key] is not None:
                            self.same_factor(row[head], pivot[key])
                            seen += 1
        self.assertGreater(seen, 40)

    def test_loads_and_reactions(self):
        """Moments of loads, and the forces that hold the block at its limit."""
        seen = [0, 0]
        for page, cases, unit in self.each():
            loaded = [case for case in cases if case.get("loads")]
            for table, case in zip(page.tables("Moments about the governing pivot at the scene"), loaded):
                for (name, force, arm, moment, side, place), load in zip(table[1:], case["loads"], strict=True):
                    self.assertEqual((name, side, place), (load["name"], load["side"], load["called_for_by"]))
                    self.same(moment, load["moment_nm"], 1e3)
                    self.assertEqual(force == "–", "force_n" not in load)
                    if "force_n" in load:  # and by the pocket calculator the one is the other's product
                        self.same(force, load["force_n"], 1e3)
                        self.same(arm, load["arm_m"], unit)
                        product = Interval.printed(force) * Interval.printed(arm) * Interval(unit, unit)
                        self.assertTrue(product.meets(Interval.printed(moment)), (force, arm, moment))
                    seen[0] += 1
            held = [case for case in cases if case.get("limit", {}).get("reactions")]
            tables = page.tables("Forces of the base on the block")
            self.assertEqual(len(tables), len(held))
            for table, case in zip(tables, held):
                for row, force in zip(table[1:], case["limit"]["reactions"], strict=True):
                    for text, key, scale in zip(row[1:], ("x_m", "y_m", "share_x", "share_y"), (unit, unit, 1, 1)):
                        self.same(text, force[key], scale)
                        seen[1] += 1
        self.assertGreater(min(seen), 5)

    def test_sliding_under_loads(self):
        """N, U, T, tan φ, c A and P are stated in kN; from the JSON they make the factor, and so they do from the printed digits
        (the formula is among those recomputed below). N of a block on a level base is by hand W cos α + k W sin α."""
        seen = 0
        for page, cases, _ in self.each():
            loaded = [case for case in cases if "normal_n" in case.get("sliding", {})]
            tables = page.tables("Forces on the facet that slides")
            self.assertEqual(len(tables), len(loaded))
            for table, case in zip(tables, loaded):
                own = case["sliding"]
                for row, key in zip(table[1:], ("normal_n", "uplift_n", "driving_n", "friction_tangent", "cohesion_n", "held_n")):
                    self.same(row[1], own[key], 1 if key == "friction_tangent" else 1e3)
                if own["fos"] is not None:
                    n, u, t, tangent, c, p = (own[key]["value"] for key in ("normal_n", "uplift_n", "driving_n", "friction_tangent",
                                                                           "cohesion_n", "held_n"))
                    self.assertAlmostEqual(((n - u) * tangent + c + p) / t / own["fos"]["value"], 1, 9)
                    seen += 1
        self.assertGreater(seen, 1)
        sheet = "block: {slab: {width: 1, height: 2}, unit_weight_kn_m3: 25}\nfriction_angle_deg: 35\ntilt: {angle_deg: 12, towards: left}\n"
        (self.path / "hand.yaml").write_text("topple: 1\nlength_unit: m\n" + sheet + "loads: {seismic: {horizontal: 0.1}, cohesion_kpa: 3}\n",
                                             encoding="utf-8")
        own = solve(self.path / "hand.yaml")["cases"][0]["sliding"]
        w, a = 50e3, math.radians(12)
        for key, value in (("normal_n", w * math.cos(a) - 0.1 * w * math.sin(a)), ("driving_n", w * math.sin(a) + 0.1 * w * math.cos(a)),
                           ("uplift_n", 0), ("cohesion_n", 3e3), ("held_n", 0), ("friction_tangent", math.tan(math.radians(35)))):
            self.assertAlmostEqual(own[key]["value"], value, delta=1e-9 * w, msg=key)

    def test_account_adds_up(self):
        """By the printed digits alone: areas, weights, the centroid, each moment, and both sums."""
        seen = 0
        for page, cases, unit in self.each():
            drawn = [case for case in cases if "elements" in case and case["toppling"]]
            tables = page.tables("Moments about the governing pivot by elements")
            self.assertEqual(len(tables), len(drawn))
            for table, case in zip(tables, drawn):
                rows = [[Interval.printed(text) for text in line[2:]] for line in table[1:]]
                elements, whole = rows[:-1], rows[-1]
                account = case["elements"]["account"]
                self.assertEqual(len(elements), len(account))
                for line, element in zip(table[1:], account):
                    for text, key, scale in zip(line[2:], ("area_m2", "centroid_x_m", "centroid_y_m", "weight", "stabilising",
                                                           "overturning"), (unit * unit, unit, unit, 1, unit, unit)):
                        self.same(text, element[key], scale)
                for column in (0, 3, 4, 5):
                    total = sum((row[column] for row in elements[1:]), elements[0][column])
                    self.assertTrue(total.meets(whole[column]), (column, total.low, total.high, table[-1]))
                for column in (1, 2):
                    first = sum((row[3] * row[column] for row in elements[1:]), elements[0][3] * elements[0][column])
                    self.assertTrue((first / whole[3]).meets(whole[column]))
                pivot = case["pivots"][case["toppling"]["pivot"]]
                self.moments(elements, case, [pivot[key]["value"] / unit for key in ("x_m", "y_m")])
                seen += len(elements)
        self.assertGreater(seen, 30)

    def moments(self, elements, case, pivot):
        """Of each element W times its arm, cos α along x and sin α along y, put with the side that their signs say."""
        angle = math.radians(case["elements"]["angle_deg"]["value"])
        cosine, sine = Interval(math.cos(angle), math.cos(angle)), Interval(math.sin(angle), math.sin(angle))
        turn = 1 if case["towards"] == "left" else -1
        for _, x, y, weight, stabilising, overturning in elements:
            arm_x, arm_y = x + Interval(-pivot[0], -pivot[0]), y + Interval(-pivot[1], -pivot[1])
            one, two = weight * (arm_x if turn > 0 else -arm_x) * cosine, weight * arm_y * sine
            zero = Interval(0, 0)
            holds = (one if one.high > 0 else zero) + (-two if two.high < 0 else zero)
            turns = (two if two.high > 0 else zero) + (-one if one.high < 0 else zero)
            self.assertTrue(holds.meets(stabilising) and turns.meets(overturning))

    def test_formulas_hold(self):
        """Each formula with its numbers put in: all sides that hold numbers alone are the same number, as far as the
        digits that stand there tell, and they tell at least two digits of it."""
        compared = 0
        for page, _, _ in self.each():
            for line in page.lines():
                values = [(text, value) for text, value in line if value is not None]
                for text, value in values:
                    width, size = value.high - value.low, max(abs(value.low), abs(value.high))
                    self.assertLess(width, 0.02 * size + 0.2, text)
                for (one, first), (other, second) in zip(values, values[1:]):
                    self.assertTrue(first.meets(second), f"{one} is not {other}")
                    compared += 1
        self.assertGreater(compared, 60)

    def test_no_account(self):
        """A block with arcs, rounded corners or an ellipse has none, and its sheet says why; others say nothing of the kind."""
        said = {name: sum(text.startswith("No account of moments by elements") for text in map(words, page.all("p")))
                for name, (page, _, _) in self.pages.items()}
        self.assertEqual({name for name, count in said.items() if count}, {"vault", "block_a_worn", "boulder_ellipse"})
        for name, count in said.items():
            self.assertFalse(count and self.pages[name][0].tables("Moments about the governing pivot"), name)

    def test_onset(self):
        """Of each onset a formula, the limit that it is, or why neither: told by what the JSON has. Formulas are estimated above."""
        kinds = {"Onset: toppling about C is possible": 0, "Onset: sliding is possible": 0, "Onset: α_s is the static limit": 0,
                 "The onset has no one-line formula": 0}
        run("solve", "examples/boulder.yaml", "--report", self.path / "boulder.html")  # whose onset is below its limit
        below = Page((self.path / "boulder.html").read_text(encoding="utf-8")), solve("examples/boulder.yaml")["cases"], 1
        for page, cases, _ in [*self.each(), below]:
            told = [kind for text in map(words, page.all("p")) for kind in kinds if text.startswith(kind)]
            at_angle = [case for case in cases if case.get("onset", {}).get("critical_angle_deg")]
            self.assertEqual(len(told), len(at_angle))
            for kind, case in zip(told, at_angle):
                kinds[kind] += 1
                onset, limit = case["onset"]["critical_angle_deg"]["value"], case["limit"].get("critical_angle_deg")
                if "toppling" in kind:
                    self.assertEqual(case["onset"]["mechanism"], "topples")
                elif "sliding" in kind:
                    self.assertEqual(case["onset"]["mechanism"], "slides")
                    self.assertAlmostEqual(onset, case["sliding"]["critical_angle_deg"]["value"], 9)
                elif "limit" in kind:
                    self.assertLessEqual(abs(onset - limit["value"]), 1.1e-6)
                else:
                    self.assertTrue(limit is None or onset < limit["value"])
        self.assertEqual([count > 0 for count in kinds.values()], [True] * 4, kinds)

    def test_structure(self):
        """Language, one title, headings in order, a text for each figure, heads of tables, and nothing that runs."""
        for page, _, _ in self.each():
            self.assertEqual([e.get("lang") for e in page.all("html")], ["en"])
            levels = [int(e.tag[1]) for e in page.all("h1", "h2", "h3", "h4")]
            self.assertEqual(levels.count(1), 1)
            for one, next_one in zip([0, *levels], levels):
                self.assertLessEqual(next_one, one + 1)
            self.assertEqual(page.all("script", "iframe", "object", "link", "form"), [])
            for image in page.all("img"):
                self.assertTrue(image.get("src").startswith("data:image/svg+xml;base64,"))
                self.assertGreater(len(image.get("alt")), 20)
            for table in page.all("table"):
                self.assertTrue(all(e.get("scope") for e in table.iter("th")))
                self.assertEqual({len(row) for row in table.iter("tr")}, {len(next(table.iter("tr")))})
            for element in page.root.iter():
                self.assertEqual([name for name in element.keys() if name.startswith("on") or name in ("style", "href")], [])
            policy = [e.get("content") for e in page.all("meta") if e.get("http-equiv") == "Content-Security-Policy"]
            self.assertEqual(len(policy), 1)
            self.assertTrue(policy[0].startswith("default-src 'none'; img-src data:; style-src 'sha256-"))

    def test_says_of_which_input(self):
        """The hash of the scene file, which is shown, and cautions of the scene."""
        page, _, _ = self.pages["block_e_valley"]
        data = (ROOT / "examples/block_e_valley.yaml").read_bytes()
        facts = page.facts("Program, date and input")
        self.assertEqual(facts["its SHA-256"], hashlib.sha256(data).hexdigest())
        shown = "".join(page.all("pre")[0].itertext())
        self.assertEqual(shown.rstrip("\n"), data.decode().rstrip("\n"))
        for page, cases, _ in self.each():
            self.assertEqual(len(page.tables("Who has prepared")[0]), 4)

    def test_same_bytes(self):
        """With SOURCE_DATE_EPOCH a rerun gives the same bytes, of every kind, and the page bears that date."""
        for kind in ("html", "md", "pdf"):
            texts = []
            for k in range(2):
                path = self.path / f"{k}.{kind}"
                subprocess.run([PROGRAM, "solve", "examples/block_seismic.yaml", "--report", path], cwd=ROOT, check=True,
                               capture_output=True, env=EPOCH)
                texts.append(path.read_bytes())
            self.assertEqual(*texts)
            if kind != "pdf":
                self.assertIn(b"2023-11-14 22:13 UTC", texts[0])
            else:
                self.assertTrue(texts[0].startswith(b"%PDF-"))
        for wrong in ("x", "-1", "1e9", "99999999999999999999"):
            done = subprocess.run([PROGRAM, "solve", "examples/slab.yaml", "--report", self.path / "w.html"], cwd=ROOT,
                                  capture_output=True, env={**EPOCH, "SOURCE_DATE_EPOCH": wrong}, encoding="utf-8")
            self.assertEqual(done.returncode, 3, wrong)
            self.assertIn("SOURCE_DATE_EPOCH", done.stderr)

    def test_markdown_has_the_same(self):
        """Every cell of a table of the page stands in the Markdown, and every equation between dollars."""
        run("solve", "examples/block_e_valley.yaml", "--report", self.path / "e.md")
        text = (self.path / "e.md").read_text(encoding="utf-8")
        page = self.pages["block_e_valley"][0]
        plain = re.sub(r"\\([!-/:-@\[-`{-~])", r"\1", text)
        for table in page.all("table"):
            for cell in table.iter("td"):
                words = "".join(cell.itertext())
                if "ms" not in words and "UTC" not in words and not re.fullmatch(r"\d+\.\d{3}", words):
                    self.assertIn(words, plain)
        self.assertEqual(text.count("$$"), 2 * len(page.all("math")))

    def test_refused(self):
        """Names that are no report's, what does not go together, and files that are read; nothing is left behind."""
        scene = "examples/slab.yaml"
        for words in (["--report", "x.txt", scene], ["--report", "x", scene], ["--report", ".html", scene],
                      ["--report", "x.pdf", "--figure", "x.pdf", scene], ["--report", "x.html", "--table", scene],
                      ["--report", "x.html", "--find", "block.slab.width", "--for", "fos=1", scene]):
            status, out, err = run("solve", *words)
            self.assertEqual((status, out), (2, ""), words)
            self.assertIn("--report", err)
        status, _, err = run("solve", scene, "--report", "/nowhere/x.html")
        self.assertEqual(status, 5)
        self.assertIn("/nowhere/x.html: cannot be written", err)
        own = self.path / "scene.html"
        own.write_bytes((ROOT / scene).read_bytes())
        status, _, err = run("solve", own, "--report", own)
        self.assertEqual(status, 3)
        self.assertEqual(own.read_bytes(), (ROOT / scene).read_bytes())
        self.assertEqual([p.name for p in self.path.glob(".*")], [])


if __name__ == "__main__":
    main()
