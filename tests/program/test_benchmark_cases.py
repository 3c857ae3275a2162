# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The benchmark of examples/benchmark: made anew it is the same to the byte, what shares no code with Topple confirms its
answers, and docs/benchmark_cases.md prints what is in its files.

The story: somebody has a program of their own, reads coordinates and answers, and holds the one against the other without ours.
Then no answer may be wrong, the scorer must say by how much theirs are, and the page what the numbers mean."""

import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

from harness import LONG, PROGRAM, ROOT, main

FOLDER = ROOT / "examples" / "benchmark"
sys.path[:0] = [str(FOLDER), str(FOLDER / "engines")]
sys.dont_write_bytecode = True

import confirm  # noqa: E402
import draw  # noqa: E402
import exact  # noqa: E402
import make  # noqa: E402
import pieces  # noqa: E402
import rest_oracle  # noqa: E402
import score  # noqa: E402

PAGE = (ROOT / "docs" / "benchmark_cases.md").read_text(encoding="utf-8")
MANIFEST, ANSWERS = score.load()
BRIEF = ("slabs_03", "slabs_08", "teeth_11", "worn_corners_06", "notches_02", "notches_03", "far_origins_07", "slivers_03", "loads_07",
         "islands_01", "unfitting_profiles_02", "falls_06", "shaken_05", "many_blocks_04", "solids_04", "solids_07")


QUICK = (*(name for k, name in enumerate(MANIFEST) if k % 3 == 0 and MANIFEST[name]["group"] not in ("many blocks", "shaken")),
         "shaken_05", "many_blocks_04")


def tables(path):
    """A file of answers without what is said of it above."""
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def asked(group):
    """What a simulation is asked in a group: (case, quantity)."""
    return [(name, quantity) for name, own in MANIFEST.items() if own["group"] == group
            for quantity in ANSWERS[name] if score.is_of_motion(quantity)]


def page_rows(engines, groups):
    """Rows of a table of the page: cases of a group, and the cell of each engine."""
    found = [{(name, quantity): by for name, quantity, by in score.scores(tables(path), MANIFEST, ANSWERS)} for path in engines]
    yield f"| group | asked | {' | '.join(path.stem.replace('_', ', ') for path in engines)} |"
    yield "| --- | --- |" + " --- |" * len(engines)
    for group in groups:
        if asked(group):
            yield f"| {group} | {len(asked(group))} | {' | '.join(cell(own, asked(group)) for own in found)} |"


def engines_of(group):
    """Files of answers in which a group has any."""
    return [path for path in sorted((FOLDER / "scores").glob("*.csv"))
            if any(MANIFEST[row["case"]]["group"] == group for row in tables(path))]


def cell(found, names):
    """What the page says of an engine's answers to a group: how many lie within a tenth of a degree and within one, the
    largest that is outside, and how many there are not."""
    rows = [found[name] for name in names if name in found]
    if not rows:
        return "none"
    size = [math.inf if by is None else abs(by) for by in rows]
    worst = rows[size.index(max(size))]
    said = "never, or not" if worst is None else f"{worst:+.2f}" if abs(worst) >= 0.005 else "0"
    none = f" ({len(names) - len(rows)} none)" if len(rows) < len(names) else ""
    return f"{sum(s <= 0.1 for s in size)}, {sum(s <= 1 for s in size)}, {said}{none}"


class Benchmark(unittest.TestCase):
    def test_made_anew_it_is_the_same(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            make.make(PROGRAM, folder, () if LONG else QUICK)
            tables = {name: (folder / name).read_text().splitlines()[1:-1] for name in ("manifest.json", "answers.json")}
            made = {path.name: path.read_bytes() for path in (folder / make.PLACE).iterdir()}
        for name, rows in tables.items():
            kept = [row.rstrip(",") for row in (FOLDER / name).read_text().splitlines()[1:-1]]
            self.assertEqual(len(kept), len(MANIFEST))
            for row in rows:
                if name == "answers.json" and row.startswith(' "many_blocks'):
                    self.check_many_anew(row)
                else:
                    self.assertIn(row.rstrip(","), kept, f"{name}: make it anew by examples/benchmark/make.py, and say why it differs")
        kept = {path.name: path.read_bytes() for path in (FOLDER / make.PLACE).iterdir()}
        self.assertEqual(made, {name: text for name, text in kept.items() if name in made or LONG})
        self.assertEqual(len(tables["answers.json"]), len(MANIFEST) if LONG else len(QUICK))

    def check_many_anew(self, row):
        """The limit is the same to the byte; how near to the first motion proofs come from both sides changes with their searches,
        of which any is true."""
        ((name, made),) = json.loads("{" + row.rstrip(",") + "}").items()
        self.assertEqual(made["limit_deg"], ANSWERS[name]["limit_deg"])
        self.assertLessEqual(made["stand_deg"]["low"], ANSWERS[name]["stand_deg"]["high"])
        self.assertLessEqual(ANSWERS[name]["stand_deg"]["low"], made["stand_deg"]["high"])

    def test_answers_are_confirmed(self):
        for name in MANIFEST if LONG else BRIEF:
            with self.subTest(name):
                self.assertEqual(confirm.check(MANIFEST[name], ANSWERS[name]), [])

    def test_a_wrong_answer_is_found(self):
        """Brackets moved by twice their width, either way: all of a slab, the onset and the limit where they differ."""
        for name, asked in (("slabs_03", ANSWERS["slabs_03"].keys() - {"moves_deg"}), ("teeth_11", ("stand_deg", "limit_deg"))):
            for quantity in asked:
                bracket = ANSWERS[name][quantity]
                for way in (-1, 1):
                    step = 2 * way * (bracket["high"] - bracket["low"])
                    moved = {key: bracket[key] + step for key in ("low", "high")}
                    wrong = confirm.check_single(MANIFEST[name], {**ANSWERS[name], quantity: moved})
                    self.assertEqual(wrong, [quantity], (name, way))

        for quantity, bracket in ANSWERS["shaken_05"].items():
            for step in (-4e-6, 4e-6):
                moved = {key: value + step for key, value in bracket.items()}
                self.assertEqual(confirm.check(MANIFEST["shaken_05"], {**ANSWERS["shaken_05"], quantity: moved}), [quantity])

    def test_closed_forms(self):
        """A rectangle on a plane slides at its friction or topples at width over height; three teeth by docs/limit.md."""
        for name in [f"slabs_{k:02}" for k in range(1, 9)]:
            ring = confirm.points(MANIFEST[name]["block"])
            topples = math.degrees(math.atan(ring[2][0] / ring[2][1]))
            for quantity, angle in (("topple_deg", topples), ("limit_deg", min(topples, float(MANIFEST[name]["friction_deg"])))):
                self.assertAlmostEqual(ANSWERS[name][quantity]["low"], angle, delta=2.1e-9)
        a, b, c, mu = 0.03, 0.12, 0.005, math.tan(math.radians(30))
        over = 9 * (2 * b + c) * (a * a + c * c) * (a * mu + c) + 2 * a * a * c * (9 * b + 4 * c) * (1 + mu * mu)
        under = 9 * (2 * b + c) * (a * a + c * c) * (a - c * mu) + 6 * a * c * (3 * b * b - c * c) * (1 + mu * mu)
        self.assertAlmostEqual(ANSWERS["teeth_03"]["limit_deg"]["low"], math.degrees(math.atan(over / under)), delta=2.1e-9)

    def test_topple_lets_it_go_so(self):
        """The simulation of Topple, which the times do not come from: between two of its moments by Hermite's cubic."""
        for name in ("falls_05", "falls_06", "falls_07", "falls_08", "falls_09", "falls_10") if LONG else ("falls_07",):
            own, time = MANIFEST[name], ANSWERS[name]["moved_s"]["low"] + 1e-9
            scene = "\n".join(["topple: 1", "length_unit: m", f"block: {{outline: {FOLDER / own['block']}, unit_weight_kn_m3: 25}}",
                               f"base: {{profile: {FOLDER / own['base']}}}", f"friction_angle_deg: {own['friction_deg']}",
                               "tilt: {towards: left, angle_deg: 0}",
                               f"tilt_test: {{engine: dynamics, protocol: release, duration_s: {time + 0.001}}}"])
            with tempfile.TemporaryDirectory() as folder:
                path = pathlib.Path(folder) / "fall.yaml"
                path.write_text(scene + "\n")
                run = subprocess.run([PROGRAM, "tilt", "--json", "--moments=301", path], capture_output=True, text=True, check=True)
            moments = json.loads(run.stdout)["cases"][0]["moments"]
            before = max((m for m in moments if m["time_s"] <= time), key=lambda m: m["time_s"])
            after = min((m for m in moments if m["time_s"] > time), key=lambda m: m["time_s"])
            step = after["time_s"] - before["time_s"]
            s = (time - before["time_s"]) / step
            at = [(1 + 2 * s) * (1 - s)**2 * before[f"moved_{a}_m"] + s * (1 - s)**2 * step * before[f"speed_{a}_m_s"]
                  + s * s * (3 - 2 * s) * after[f"moved_{a}_m"] - s * s * (1 - s) * step * after[f"speed_{a}_m_s"] for a in "xy"]
            self.assertAlmostEqual(math.hypot(*at), float(own["moved_m"]), delta=1e-9, msg=name)

    def test_it_comes_to_rest_so(self):
        """By a search in small steps, without events: every other pose, and how it moved there."""
        for name in [name for name, own in MANIFEST.items() if "place" in own][:None if LONG else 2]:
            block, base = ([tuple(map(float, p)) for p in confirm.points(MANIFEST[name][what])] for what in ("block", "base"))
            how, outline = rest_oracle.rest(block, base)
            self.assertEqual(how, "rests", name)
            for k, axis in enumerate("xy"):
                moved = rest_oracle.centroid(outline)[k] - rest_oracle.centroid(block)[k]
                self.assertAlmostEqual(ANSWERS[name][f"moved_{axis}_m"]["low"], moved, delta=10 * rest_oracle.NEAR)
            a, b = (math.atan2(ring[1][1] - ring[0][1], ring[1][0] - ring[0][0]) for ring in (outline, block))
            turned = math.remainder(math.degrees(a - b), 360)
            self.assertAlmostEqual(ANSWERS[name]["turned_deg"]["low"], turned, delta=math.degrees(10 * rest_oracle.NEAR))

    def test_halves_of_statics_are_in_order(self):
        parted = 0
        for name, own in ANSWERS.items():
            if "stand_deg" not in own or "base" not in MANIFEST[name] or own["stand_deg"].get("never"):
                continue
            self.assertLessEqual(own["stand_deg"]["low"], own["limit_deg"].get("high", 90), name)
            if "moves_deg" in own:
                self.assertEqual(own["moves_deg"]["low"], own["stand_deg"]["low"])
            parted += own["stand_deg"]["high"] < own["limit_deg"].get("low", 90)
        self.assertIn(f"in {parted} of them the two differ", PAGE)

    def test_the_scorer(self):
        rows = [{"case": name, "quantity": quantity, "value": "never" if "low" not in bracket else str(bracket["low"])}
                for name, own in ANSWERS.items() for quantity, bracket in own.items()]
        self.assertEqual({by for _, _, by in score.scores(rows, MANIFEST, ANSWERS)}, {0.0})
        slab, peg = ANSWERS["slabs_02"]["limit_deg"], ANSWERS["notches_09"]["limit_deg"]
        self.assertAlmostEqual(score.outside(slab, "18.6"), 18.6 - 18.434948824, delta=1e-12)
        self.assertAlmostEqual(score.outside(slab, "18"), 18 - 18.434948822, delta=1e-12)
        self.assertEqual([score.outside(slab, "never"), score.outside(peg, "70"), score.outside(peg, "never")], [None, None, 0])
        found = [("slabs_01", "limit_deg", -0.05), ("slabs_02", "limit_deg", 3.0), ("slabs_03", "limit_deg", 0.0)]
        self.assertEqual(score.tally(found, MANIFEST), {("slabs", "limit_deg"): [1, 0, 1, 0, 1, 3.0]})

    def test_convex_pieces_are_the_block(self):
        for name, own in list(MANIFEST.items())[::1 if LONG else 4]:
            if "block" not in own:
                continue
            ring = confirm.points(own["block"])
            for corners in (3, 8):
                parts = pieces.convex(ring, corners)
                self.assertEqual(sum(exact.moments(part)[0] for part in parts), exact.moments(ring)[0], name)
                self.assertTrue(all(len(part) <= corners and pieces.is_convex(part) for part in parts), name)

    def test_the_page_prints_the_files(self):
        self.assertIn(f"{len(MANIFEST)} cases", PAGE)
        groups = dict.fromkeys(own["group"] for own in MANIFEST.values())
        for group in groups:
            self.assertIn(f"| {group} | ", PAGE)
        for path in (FOLDER / "scores").glob("*.csv"):
            self.assertIn(path.read_text(encoding="utf-8").splitlines()[0].removeprefix("# "), PAGE)
        plane = [group for group in groups if group != "solids"]
        for row in [*page_rows(engines_of("slabs"), plane), *page_rows(engines_of("solids"), ["solids"])]:
            self.assertIn(row, PAGE.splitlines())
        for quantity in {key for own in ANSWERS.values() for key in own}:
            self.assertIn(f"`{quantity}`", PAGE)

    def test_the_figure_draws_the_files(self):
        with tempfile.TemporaryDirectory() as folder:
            figure = pathlib.Path(folder) / "figure.svg"
            draw.main(figure)
            self.assertEqual(figure.read_text(), (ROOT / "docs/figures/benchmark_cases.svg").read_text())
        answers = {"low": 20.0, "high": 20.1}
        self.assertEqual([draw.place("moves_deg", answers, value) for value in ("20.05", "20.2", "20.9", "19", "22", "never", "")],
                         [0, 0, 1, 1, 3, 3, 4])
        self.assertEqual([draw.place("moves_deg", {"never": True}, value) for value in ("never", "30")], [0, 2])

    def test_every_bracket_is_narrow(self):
        for name, own in ANSWERS.items():
            for quantity, bracket in own.items():
                wide = 10**4 if "blocks" in MANIFEST[name] else 10**6 if "shaking" in MANIFEST[name] else 10**7 if "place" in MANIFEST[name] else 10**9
                if "low" in bracket and quantity != "moves_deg" and (name.startswith("many"), quantity) != (True, "stand_deg"):
                    width = Fraction(str(bracket["high"])) - Fraction(str(bracket["low"]))
                    self.assertLessEqual(width, Fraction(2, wide), (name, quantity))


if __name__ == "__main__":
    main()
