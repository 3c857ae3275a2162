# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Every output states the factor of safety, the verdict and the exit status that `topple solve --json` states.

A batch once reported "holds" where `solve` reported "may move", because each output chose the governing number by itself. Here the
rule is written once more, in Python, on the numbers of the JSON: a motion that can begin comes first, then what is undecided, then
the smaller factor. Table, batch, sweep, study, report, sheet and exit status of every example and of random scenes are compared with
it. The laws of the factor are checked on the same scenes: it is below 1 exactly where a motion can begin, no proven factor is
below it, and the mirror image has the same."""

import csv
import io
import json
import math
import random
import re

from governing_case import GoverningCase
from harness import ROOT, example_scenes, main, rounds, run

STANDS, MOVES, OPEN = "stands", "moves", "open"


def stance(case):
    return STANDS if case["mechanism"] in ("stands", "interlocked") else OPEN if case["mechanism"] == "undecided" else MOVES


def bounds(case):
    """The least and the greatest that the factor can be."""
    governing = case["governing_fos"]
    if governing["fos"] is not None:
        value, error = governing["fos"]["value"], governing["fos"]["error"]
        return value - error, value + error
    told = governing["fos_is"]
    if told.startswith("none"):
        return 0, 0
    if told.startswith("unbounded"):
        return math.inf, math.inf
    return governing.get("at_least", 0), governing.get("at_most", math.inf)


def worst(cases):
    order = {MOVES: 0, OPEN: 1, STANDS: 2}
    return min(cases, key=lambda case: (order[stance(case)], *reversed(bounds(case))))


def status_for(cases, required):
    """The exit status of a required factor: not met comes before open."""
    status = 0
    for case in cases:
        least, most = bounds(case)
        if stance(case) == MOVES or most < required or not case["governing_fos"]["sliding_judged"]:
            return 1
        if stance(case) == OPEN or least < required:
            status = 4
    return status


def outline_text(points):
    return "[" + ", ".join(f"[{x}, {y}]" for x, y in points) + "]"


class OutputsAgree(GoverningCase):
    def json_of(self, *arguments):
        status, out, err = run(*arguments)
        self.assertIn(status, (0, 1, 4), err)
        return json.loads(out)

    def check_laws(self, case):
        """Below 1 exactly where a motion can begin; no factor that counts is below the governing one."""
        governing = case["governing_fos"]
        least, most = bounds(case)
        known = governing["fos"] is not None or not governing["fos_is"].startswith("undecided")
        if known and stance(case) != OPEN and governing["complete"]:
            self.assertEqual(stance(case) == MOVES, most < 1 or (most, least) == (1, 1))
        for factor in case["factors"]:
            if factor["counts"] and factor["fos"] is not None and governing["fos"] is not None:
                self.assertLessEqual(least, factor["fos"]["value"] + factor["fos"]["error"])

    def check_table(self, scene, cases):
        _, out, _ = run("solve", "--csv", scene)
        rows = list(csv.DictReader(io.StringIO(out)))
        self.assertEqual(len(rows), len(cases))
        for row, case in zip(rows, cases):
            self.assertEqual(row["verdict"], case["mechanism"])
            fos = case["governing_fos"]["fos"]
            if fos is not None and case["governing_fos"]["complete"]:
                self.assertEqual(float(row["fos"]), fos["value"])

    def check_report(self, scene, cases, required):
        """The headline of each direction, rounded down; the exit status with and without --fail-below."""
        status, out, _ = run("solve", scene)
        lines = re.findall(r"^  FoS (?:at most )?([\d.]+)", out, re.MULTILINE)
        numbers = [case["governing_fos"]["fos"]["value"] for case in cases if case["governing_fos"]["fos"] is not None]
        self.assertEqual(len(lines), len(numbers), out)
        for line, number in zip(lines, numbers):
            self.assertLessEqual(float(line), number + 6e-4)  # no more than the next digit
            self.assertAlmostEqual(float(line), number, delta=max(1.1e-3, 1e-3 * number))
        if required is not None and status != 3:
            self.assertEqual(status, status_for(cases, required), out)
        numbers = [most for most in (bounds(case)[1] for case in cases) if 0 < most < math.inf]
        for design in (0.999 * min(numbers), 1.001 * min(numbers)) if numbers else (1,):
            status, _, err = run("solve", "--fail-below", f"{design:.6f}", scene)
            self.assertEqual(status, status_for(cases, float(f"{design:.6f}")), err)

    def check_batch(self, scene, cases, friction):
        path = self.folder / "batch.csv"
        path.write_text(f"name,friction\nA,{friction}\n", encoding="utf-8")
        out = run("solve", "--batch", path, "--template", scene, "--json")[1]
        (row,) = json.loads(out)["rows"]
        case = worst(cases)
        least, most = bounds(case)
        if row["fos"] is not None:
            self.assertLessEqual(abs(row["fos"]["value"] - case["governing_fos"]["fos"]["value"]),
                                 row["fos"]["error"] + case["governing_fos"]["fos"]["error"])
        required = row["required_fos"]["value"] if row["required_fos"] else None
        if row["standing"] == "holds":
            self.assertEqual(stance(case), STANDS)
            self.assertGreaterEqual(least, 1 if required is None else required)
        if stance(case) == MOVES:
            self.assertEqual(row["standing"], "fails", row)
        if required is not None and most < required:
            self.assertIn(row["standing"], ("fails", "below required"), row)

    def check_sweep(self, scene, cases, friction):
        told = self.json_of("sweep", "--json", f"--x=friction_angle_deg={friction}:{friction + 1}:1", scene)["points"][0]["cases"]
        for row, case in zip(told, cases):
            self.assertEqual(row["verdict"], case["mechanism"])
            if case["governing_fos"]["fos"] is not None and case["governing_fos"]["complete"]:
                self.assertAlmostEqual(row["fos"]["value"], case["governing_fos"]["fos"]["value"], delta=1e-12)

    def check_study(self, scene, case, friction):
        """A study of one direction, whose samples have that friction."""
        study, rows = self.folder / "study.yaml", self.folder / "rows.csv"
        study.write_text(f"topple_study: 1\nscene: {scene.name}\nsamples: 3\n"
                         f"vary: {{friction_angle_deg: {{values: [{friction}]}}}}\n", encoding="utf-8")
        status, _, err = run("study", "--restart", "--rows", rows, study)
        if status == 3 and "values" in err:
            study.write_text(f"topple_study: 1\nscene: {scene.name}\nsamples: 3\nvary: {{friction_angle_deg: {{uniform: "
                             f"{{low: {friction}, high: {friction + 1e-9:.10f}}}}}}}\n", encoding="utf-8")
            status, _, err = run("study", "--restart", "--rows", rows, study)
        self.assertEqual(status, 0, err)
        lines = [line for line in rows.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
        outcome = {"interlocked": "stands"}.get(case["mechanism"], case["mechanism"])
        for row in csv.DictReader(lines):
            self.assertIn(row["outcome"], (outcome, "open"))
            if row["outcome"] != "open" and case["governing_fos"]["fos"] is not None and case["governing_fos"]["complete"]:
                self.assertAlmostEqual(float(row["fos"]), case["governing_fos"]["fos"]["value"],
                                       delta=1e-6 * max(1, case["governing_fos"]["fos"]["value"]))

    def check(self, scene, friction=None, required=None):
        solved = self.json_of("solve", "--json", scene)
        cases = solved["cases"]
        if any(case.get("tilt_angle_deg") is None for case in cases):
            return  # no tilt, no factor
        for case in cases:
            if case["governing_fos"]["sliding_judged"]:
                self.check_laws(case)
        self.check_table(scene, cases)
        self.check_report(scene, cases, required)
        if friction is None:
            return
        self.check_batch(scene, cases, friction)
        self.check_sweep(scene, cases, friction)
        if len(cases) == 1:
            self.check_study(scene, cases[0], friction)

    def test_examples(self):
        for scene in example_scenes():
            with self.subTest(scene=scene.name):
                self.check(scene)

    def draw(self, draw):
        """A block on a rough base that fits it, with or without loads; its text, and that of its mirror image."""
        count = draw.randint(1, 4)
        sole = [(k, draw.choice([0, 0, round(draw.uniform(-0.4, 0.4), 2)])) for k in range(count + 1)]
        height = round(draw.uniform(0.5, 5), 2)
        outline = sole + [(round(count - draw.uniform(0, 0.5), 2), height), (round(draw.uniform(0, 0.5), 2), height)]
        friction, tilt = draw.randint(15, 60), draw.randint(0, 45)
        required = draw.choice([None, 1.1, 1.5])
        loads = []
        if draw.random() < 0.4:
            loads.append(f"seismic: {{horizontal: {round(draw.uniform(0, 0.3), 2)}}}")
        if draw.random() < 0.3:
            loads.append(f"cohesion_kpa: {draw.randint(1, 10)}")

        def text(points, towards):
            return (f"topple: 1\nlength_unit: m\nblock: {{outline: {outline_text(points)}, unit_weight_kn_m3: 26}}\n"
                    f"base: {{mated: true, beyond: {{left: 0, right: 0}}}}\nfriction_angle_deg: {friction}\n"
                    f"tilt: {{towards: {towards}, angle_deg: {tilt}}}\n" + (f"loads: {{{', '.join(loads)}}}\n" if loads else "") +
                    (f"required_fos: {required}\n" if required else ""))

        towards = draw.choice(["left", "left", "both"])
        image = [(-x, y) for x, y in reversed(outline)]
        return text(outline, towards), text(image, {"left": "right"}.get(towards, towards)), friction, required

    def test_random(self):
        draw = random.Random(20261128)
        for number in range(rounds(25, 2000)):
            text, image, friction, required = self.draw(draw)
            with self.subTest(number=number, text=text):
                self.check(self.scene(text), friction, required)
                ones = self.json_of("solve", "--json", self.scene(text))["cases"]
                others = self.json_of("solve", "--json", self.scene(image, "image.yaml"))["cases"]
                for one, other in zip(ones, reversed(others), strict=True):
                    self.assertEqual(one["mechanism"], other["mechanism"])
                    a, b = one["governing_fos"]["fos"], other["governing_fos"]["fos"]
                    self.assertEqual(a is None, b is None)
                    if a is not None:
                        self.assertLessEqual(abs(a["value"] - b["value"]), a["error"] + b["error"])

    def test_row_of_the_table(self):
        """The block that a batch called "holds" where it can move: its left direction governs."""
        text = (ROOT / "tests/data/governing/can_move_left.yaml").read_text(encoding="utf-8")
        self.check(self.scene(text), 43.1, 1.1)
        out = run("solve", self.scene(text))
        self.assertEqual(out[0], 1)


if __name__ == "__main__":
    main()
