# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""`topple accuracy`: what every price gives is inside its bound, and the bounds are worth their bits.

The angles are compared with Python's decimals; no test looks at a time but to see that there is one."""

import csv
import json
import math
import pathlib
import tempfile
import unittest
from decimal import Decimal
from fractions import Fraction

import exact
from harness import LONG, ROOT, main, rounds, run, solve

BITS = [53, 64, 128, 256, 512, 1024, 2048, 4096]
WORN = "examples/block_a_worn.yaml"
SCENES = {  # methods that each scene calls for
    WORN: ["boundary sums", "triangles", "rounding, paper's model", "rounding, exact model", "limit analysis",
           "onset of motion"],
    "examples/block_seismic.yaml": ["boundary sums", "triangles", "limit analysis", "onset of motion"],
}
if LONG:  # a second each
    SCENES |= {
        "examples/boulder.yaml": ["boundary sums", "triangles", "limit analysis", "onset of motion"],
        "examples/two_density_block.yaml": ["boundary sums", "triangles"],
        "examples/boulder_ellipse.yaml": ["boundary sums"],
        "examples/vault.yaml": ["boundary sums"],
    }


def measure(*arguments):
    status, out, err = run("accuracy", "--json", *arguments)
    if status != 0 or err:
        raise AssertionError(f"topple accuracy: exit {status}: {err}")
    return json.loads(out)


class Accuracy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.of = {scene: measure(scene) for scene in SCENES}

    def runs(self):
        """Every run, with what names it in a complaint."""
        return [(scene, r, {key: r[key] for key in ("method", "level", "bits")} | {"scene": scene})
                for scene, measured in self.of.items() for r in measured["runs"]]

    def test_methods(self):
        """Only what the scene calls for is measured."""
        for scene, methods in SCENES.items():
            with self.subTest(scene=scene):
                seen = list(dict.fromkeys(r["method"] for r in self.of[scene]["runs"]))
                self.assertEqual([m for m in seen if m in methods], methods)
                self.assertEqual([v["method"] for v in self.of[scene]["values"]], seen)

    def test_true_error_within_bound(self):
        """The promise: the truth lies inside the bound at every price. Also where doubles underflow."""
        for _, r, name in self.runs():
            with self.subTest(**name):
                self.assertGreater(r["seconds"], 0)
                if r["bound"] is None:  # the limit in doubles is unproven, and right all the same here
                    self.assertEqual((r["method"], r["level"]), ("limit analysis", "double"))
                    self.assertLess(r["true_error"], 1e-9)
                else:
                    self.assertLessEqual(r["true_error"], r["bound"])
                    if r["true_error_log10"] is not None:
                        self.assertLessEqual(r["true_error_log10"], r["bound_log10"] + 1e-6)

    def test_bounds_follow_the_bits(self):
        """Balls lose a few bits of their precision, not more: the bound is below 2^(30 - bits) degrees, and
        above 2^(-bits) of the angle, for no angle here is exact."""
        for _, r, name in self.runs():
            if r["level"] == "ball" and r["bound_log10"] is not None:
                with self.subTest(**name):
                    self.assertLess(r["bound_log10"], (30 - r["bits"]) * math.log10(2))
                    self.assertGreater(r["bound_log10"], (-8 - r["bits"]) * math.log10(2))
        for scene, methods in SCENES.items():
            if "boundary sums" in methods:
                bits = [r["bits"] for r in self.of[scene]["runs"] if r["method"] == "boundary sums" and r["level"] == "ball"]
                self.assertEqual(bits, BITS)

    def test_logarithms_are_those_of_the_bounds(self):
        for _, r, name in self.runs():
            with self.subTest(**name):
                if r["bound"] and r["bound"] > 1e-300:
                    self.assertAlmostEqual(math.log10(r["bound"]), r["bound_log10"], delta=1e-5)
                if r["true_error"] > 1e-300:
                    self.assertAlmostEqual(math.log10(r["true_error"]), r["true_error_log10"], delta=1e-5)

    def test_values(self):
        """What the ways come to is what `solve` says; the sharp block A is that of Python's rationals."""
        values = {v["method"]: v["angle_deg"] for v in self.of[WORN]["values"]}
        own = solve(WORN, "--digits", 14)["cases"][0]
        moments = exact.block_moments(exact.teeth(3, Fraction(15), Fraction(94), Fraction(5), "peak"))
        sharp = exact.critical_angle(moments, (0, 5))
        for number, truth in ((values["boundary sums"], sharp), (values["triangles"], sharp),
                              (values["rounding, paper's model"], own["toppling"]["critical_angle_deg"]["value"]),
                              (values["limit analysis"], own["limit"]["critical_angle_deg"]["value"]),
                              (values["onset of motion"], own["onset"]["critical_angle_deg"]["value"])):
            self.assertLess(abs(Decimal(number["value"]) - Decimal(truth)), Decimal("1e-13"))

    def test_onset(self):
        """Where friction on the flank behind the toe could hold block A, its limit is 30.25° and its onset still the
        angle of its moments, by Python's rationals; every price of sums and balls is measured. Under cohesion the
        limit comes in, and with Barton's friction there is no single onset: no rows."""
        text = (ROOT / "examples/block_a_peak.yaml").read_text(encoding="utf-8")
        moments = exact.block_moments(exact.teeth(3, Fraction(15), Fraction(94), Fraction(5), "peak"))
        steep = text.replace("friction_angle_deg: 30", "friction_angle_deg: 60")
        barton = text.replace("friction_angle_deg: 30",
                              "friction: {law: barton, residual_angle_deg: 25, jcs_mpa: 50, jrc: 8}")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "scene.yaml"
            path.write_text(steep, encoding="utf-8")
            measured = measure(path)
            for other in (steep + "loads: {cohesion_kpa: 1}\n", barton)[:rounds(1, 2)]:
                path.write_text(other, encoding="utf-8")
                self.assertNotIn("onset of motion", {r["method"] for r in measure(path)["runs"]})
        values = {v["method"]: v["angle_deg"]["value"] for v in measured["values"]}
        self.assertAlmostEqual(values["limit analysis"], 30.251, delta=1e-3)
        truth = exact.critical_angle(moments, (0, 5))
        self.assertLess(abs(Decimal(values["onset of motion"]) - truth), Decimal("1e-14"))
        own = [r for r in measured["runs"] if r["method"] == "onset of motion"]
        self.assertEqual([r["bits"] for r in own if r["level"] == "ball"], BITS)
        self.assertLessEqual({"double", "compensated", "exact"}, {r["level"] for r in own})

    def test_page(self):
        status, out, err = run("accuracy", WORN)
        self.assertEqual((status, err), (0, ""))
        self.assertIn("limit analysis           double          64", out)
        self.assertRegex(out, r"onset of motion          ball          4096 +[0-9.]+ [µm]s  [0-9.]+e-12[0-9]{2}  [0-9.]+e-12[0-9]{2}\n")
        self.assertRegex(out, r"\n  onset of motion          23\.503265325340")
        self.assertRegex(out, r"boundary sums            ball          4096 +[0-9.]+ µs  [0-9.]+e-12[0-9]{2}  [0-9.]+e-12[0-9]{2}\n")
        self.assertIn("rounding, paper's model  23.503265325340", out)
        self.assertTrue(all(len(line) <= 81 for line in out.splitlines()))


class Sweep(unittest.TestCase):
    def test_sizes(self):
        """Sums and triangles at every size, the same angle from both; the limit and the onset up to 10^5 vertices."""
        most = rounds(100, 1000)
        measured = measure(f"--sweep=10:{most}")
        for size in [size for size in (10, 100, 1000) if size <= most]:
            values = {v["method"]: v["angle_deg"]["value"] for v in measured["values"] if v["vertices"] == size}
            self.assertEqual(set(values), {"boundary sums", "triangles", "limit analysis", "onset of motion"})
            self.assertEqual(values["boundary sums"], values["triangles"])
        for r in measured["runs"]:
            if r["bound"] is not None:
                self.assertLessEqual(r["true_error"], r["bound"])

    def test_a_rough_block_by_rationals(self):
        """The rough block of ten vertices, rebuilt here from its recipe: the angle by Python's rationals."""
        state, along, height, outline = 2026, 0, 0, []

        def draw(below):
            nonlocal state
            state = (state * 6364136223846793005 + 1442695040888963407) % 2**64
            return (state >> 33) % below

        for k in range(8):
            outline.append((Fraction(along), Fraction(height if k < 7 else 0)))
            step, rise = draw(81), draw(101)
            along, height = along + 60 + step, height + rise - 50 - int(height / 64)
        top = Fraction(4096 + along // 5 * 2)
        outline += [(outline[-1][0], top), (Fraction(0), top)]
        truth = exact.critical_angle(exact.block_moments(outline), outline[0])
        value = next(v for v in measure("--sweep=10:10")["values"] if v["method"] == "boundary sums")["angle_deg"]
        self.assertLessEqual(abs(Decimal(value["value"]) - truth), Decimal(value["error"]) + Decimal("1e-50"))


class Output(unittest.TestCase):
    def test_files(self):
        """A figure and a table of a scene and of a sweep; each row of a table has digits that are right."""
        with tempfile.TemporaryDirectory() as folder:
            for name, arguments in (("scene", ["examples/boulder_ellipse.yaml"]), ("sweep", ["--sweep=10:100"])):
                drawn = ((".svg", b"<?xml"), (".pdf", b"%PDF")) if LONG or name == "sweep" else ()
                for ending, start in (*drawn, (".csv", b"panel,method,")):
                    path = pathlib.Path(folder) / (name + ending)
                    status, out, err = run("accuracy", *arguments, "-o", path)
                    self.assertEqual((status, out, err), (0, "", ""))
                    self.assertTrue(path.read_bytes().startswith(start), path.read_bytes()[:40])
                rows = list(csv.DictReader(path.read_text(encoding="utf-8").splitlines()))
                self.assertGreater(len(rows), 9)
                if name == "scene":
                    for row in rows:
                        proven, right = float(row["certain_digits"]), row["true_digits"]
                        self.assertTrue(right == "all" or float(right) > proven - 0.1 or row["level"] == "double")

    def test_usage(self):
        """Wrong usage is exit 2, a scene without an angle exit 3, a file that is not there or cannot be written exit 5."""
        for wrong in ([], [WORN, WORN], ["--sweep=10"], ["--sweep=a:b"], ["--sweep=-10:100"], ["--sweep", WORN],
                      [WORN, "-o", "x.txt"], [WORN, "--json", "-o", "x.svg"]):
            self.assertEqual(run("accuracy", *wrong)[0], 2, wrong)
        for sizes in ("5:100", "100:10", "10:100000000"):
            status, out, err = run("accuracy", "--sweep=" + sizes)
            self.assertEqual((status, out), (3, ""))
            self.assertIn("from 10 vertices at the least to 10000000 at the most", err)
        self.assertEqual(run("accuracy", "--sweep=10:10", "-o", "/nowhere/x.svg")[0], 5)
        self.assertEqual(run("accuracy", "nothing.yaml")[0], 5)

    def test_no_angle(self):
        """A block in a slot as deep as itself cannot turn."""
        scene = "topple: 1\nlength_unit: m\nblock: {outline: [[0, 0], [1, 0], [1, 1], [0, 1]]}\n" \
                "base: {profile: [[-1, 2], [0, 2], [0, 0], [1, 0], [1, 2], [2, 2]]}\n"
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "held.yaml"
            path.write_text(scene, encoding="utf-8")
            status, out, err = run("accuracy", path)
        self.assertEqual((status, out), (3, ""))
        self.assertIn("no pivot is admissible", err)


if __name__ == "__main__":
    main()
