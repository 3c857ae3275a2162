# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""`topple tilt --converge`: how the critical angle goes with the settings of its test, against closed forms: a slab on springs
under its whole base, the number of halvings, Housner's equation; what depends on a setting is told as not converged."""

import json
import math
import pathlib
import tempfile
import unittest

from harness import ROOT, main, rounds, run

SLAB = "topple: 1\nlength_unit: m\nblock: {{slab: {{width: {w}, height: {h}}}, unit_weight_kn_m3: 25}}\n" \
       "friction_angle_deg: 60\ntilt: {{towards: left}}\n"
E_SPRINGS = "engine: dynamics, method: springs, protocol: steps, normal_stiffness_gpa_m: 1000, shear_stiffness_gpa_m: 100"


def on_springs(w, h, k):
    """The tilt at which a slab topples whose base stands on springs of k Pa/m that do not pull, kN/m3 as above. At the closed
    length l the weight's resultant stands over l/3 from the toe, and the turn is 2 N/(k l^2) per metre of thickness; both tell
    the tilt, which is largest where the slab begins to move."""
    def tilt(l):
        alpha = math.atan2(w, h)
        for _ in range(60):
            alpha = math.atan((w - 2 * l / 3) / h) - 2 * 25e3 * w * h * math.cos(alpha) / (k * l * l)
        return alpha

    low, high = 1e-6 * w, w
    for _ in range(200):
        a, b = low + (high - low) / 3, high - (high - low) / 3
        low, high = (a, high) if tilt(a) < tilt(b) else (low, b)
    return math.degrees(tilt(low))


class Converge(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def told(self, text, *options, status=0):
        (self.folder / "scene.yaml").write_text(text)
        ended, out, err = run("tilt", "--converge", "--json", *options, self.folder / "scene.yaml")
        self.assertEqual(ended, status, err)
        own = json.loads(out)
        return own, own["cases"][0], {finding["setting"]: finding for finding in own["cases"][0]["settings"]}, err

    def test_stiffness_of_a_slab(self):
        """By the path: each stiffness gives the angle of the closed form, but for the square of the turn; what is left to the
        limit of stiff contacts falls by 100^(1/3) with each hundredfold stiffness."""
        for w, h in ((1, 3), (1, 5)):
            with self.subTest(w=w, h=h):
                _, case, settings, _ = self.told(SLAB.format(w=w, h=h) + "tilt_test: {engine: path, normal_stiffness_gpa_m: 100,"
                                                 " shear_stiffness_gpa_m: 10}\n")
                truth = math.degrees(math.atan2(w, h))
                stiffness = settings["normal_stiffness_pa_m"]
                *levels, limit = stiffness["levels"]
                self.assertEqual([level["value"] for level in levels], [1e11, 1e13, 1e15, 1e17])
                self.assertEqual((limit["value"], limit["own"]), (None, True))
                self.assertLessEqual(limit["bracket"]["least"], truth + 1e-6)
                self.assertGreaterEqual(limit["bracket"]["most"], truth - 1e-6)
                left = []
                for level in levels:
                    own = (level["bracket"]["least"] + level["bracket"]["most"]) / 2
                    left.append(truth - own)
                    square = math.degrees(math.radians(left[-1]) ** 2)  # of the turn, which is less than that angle
                    self.assertAlmostEqual(own, on_springs(w, h, level["value"]), delta=10 * square + 2e-6)
                for more, less in zip(left, left[1:]):
                    self.assertAlmostEqual(more / less, 100 ** (1 / 3), delta=0.05)  # to leading order
                self.assertEqual(stiffness["verdict"], "holds")
                self.assertTrue(case["converged"])

    def test_brackets_cost_halvings(self):
        """Without an expectation rigid contacts take a run level, one at the last tilt, and log2(90 / width) between them."""
        _, _, settings, _ = self.told(SLAB.format(w=1, h=3) + "tilt_test: {engine: dynamics, protocol: steps}\n")
        widths = settings["tolerance_deg"]["levels"]
        self.assertEqual([level["value"] for level in widths], [0.16, 0.04, 0.01, 0.0025])
        for level in widths:
            self.assertEqual(level["runs"], 2 + math.ceil(math.log2(90 / level["value"])))
            self.assertLessEqual(level["bracket"]["most"] - level["bracket"]["least"], level["value"])
            self.assertLessEqual(level["bracket"]["least"], math.degrees(math.atan2(1, 3)))
            self.assertGreaterEqual(level["bracket"]["most"], math.degrees(math.atan2(1, 3)))
        self.assertEqual([level["own"] for level in widths], [False, False, True, False])

    def test_springs_of_block_e(self):
        """Every setting of springs that the issue names is varied; all agree at the onset of motion."""
        head = (ROOT / "examples" / "block_e_valley.yaml").read_text()
        told, case, settings, _ = self.told(head + f"tilt_test: {{{E_SPRINGS}, tolerance_deg: 0.05}}\n")
        self.assertEqual(set(settings), {"normal_stiffness_pa_m", "stiffness_ratio", "time_step_s", "damping", "rounding_m",
                                         "tolerance_deg"})
        self.assertAlmostEqual(told["asked"], 0.05, delta=1e-12)
        self.assertEqual((told["quantity"], case["converged"]), ("critical angle", True))
        self.assertLess(case["onset_deg"] - 0.05, case["over_settings"]["least"])
        self.assertLess(case["over_settings"]["most"], case["onset_deg"] + 0.05)
        steps = [level["value"] for level in settings["time_step_s"]["levels"]]
        self.assertTrue(all(abs(a / b - 2) < 1e-9 for a, b in zip(steps, steps[1:])), steps)
        for finding in settings.values():
            self.assertLessEqual(finding["spread"], 0.05)

    def test_what_depends_is_told(self):
        """Soft springs take more off than was asked, at the finest stiffness too: not converged, with exit status 4. A hundred
        times as much is asked for: it holds."""
        def soft(tolerance_deg):
            return SLAB.format(w=1, h=3) + "tilt_test: {engine: path, normal_stiffness_gpa_m: 1, shear_stiffness_gpa_m: 1, " \
                f"tolerance_deg: {tolerance_deg}}}\n"

        _, case, settings, err = self.told(soft(0.001), status=4)
        self.assertFalse(case["converged"])
        stiffness = settings["normal_stiffness_pa_m"]
        self.assertEqual((stiffness["verdict"], stiffness["needed"]), ("not converged", None))
        self.assertGreater(stiffness["spread"], 0.001)
        self.assertIn("not converged over its settings", err)
        _, case, settings, _ = self.told(soft(0.1))
        self.assertEqual(settings["normal_stiffness_pa_m"]["verdict"], "holds")

    def test_what_is_refined(self):
        """Springs ten times too soft for what is asked: finer ones agree, are taken, and the other settings varied about that."""
        text = SLAB.format(w=1, h=3) + "tilt_test: {engine: dynamics, method: springs, protocol: steps, " \
            "normal_stiffness_gpa_m: 0.1, shear_stiffness_gpa_m: 0.1, tolerance_deg: 0.05}\n"
        _, case, settings, _ = self.told(text, status=4)  # for its ratio, which is none of accuracy
        stiffness = settings["normal_stiffness_pa_m"]
        self.assertEqual(stiffness["verdict"], "refined")
        self.assertAlmostEqual(stiffness["needed"] / 1e9, 1, delta=1e-9)
        truth = math.degrees(math.atan2(1, 3))
        self.assertGreater(truth - case["as_set"]["most"], 0.05)
        (base,) = [level for level in settings["damping"]["levels"] if level["own"]]
        self.assertEqual(base["bracket"], stiffness["levels"][2]["bracket"])
        self.assertAlmostEqual(base["bracket"]["most"], truth, delta=0.05)

    def test_overturning(self):
        """The least half sine that overturns a slab, over the settings of rigid contacts, against Housner's equation of rocking,
        theta'' = p^2 (-sin(alpha - theta) + a/g cos(alpha - theta)), by Runge and Kutta. In the short form
        runs end after 5 s, when it is told whether it overturns: how rocking dies out would take most of the time."""
        p2, alpha = 3 * 9.80665 / (4 * math.hypot(0.5, 2)), math.atan2(0.5, 2)

        def overturns(peak):
            def rate(t, theta):
                return p2 * (-math.sin(alpha - theta) + (peak * math.sin(2 * math.pi * t) if t < 0.5 else 0)
                             * math.cos(alpha - theta))

            t, theta, speed, h = math.asin(math.tan(alpha) / peak) / (2 * math.pi), 0, 0, 0.001
            while 0 <= theta < math.pi / 2 and t < 8:
                k1, l1 = speed, rate(t, theta)
                k2, l2 = speed + h / 2 * l1, rate(t + h / 2, theta + h / 2 * k1)
                k3, l3 = speed + h / 2 * l2, rate(t + h / 2, theta + h / 2 * k2)
                k4, l4 = speed + h * l3, rate(t + h, theta + h * k3)
                theta, speed, t = (theta + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4), speed + h / 6 * (l1 + 2 * l2 + 2 * l3 + l4),
                                   t + h)
            return theta >= math.pi / 2

        low, high = 0.3, 1.2
        while high - low > 1e-5:
            middle = (low + high) / 2
            low, high = (low, middle) if overturns(middle) else (middle, high)
        told, case, settings, _ = self.told(
            SLAB.format(w=1, h=4) + "base: {profile: [[-20, 0], [20, 0]]}\n" + rounds("tilt_test: {duration_s: 5}\n", "") +
            "shaking: {horizontal: {half_sine: {peak_g: 0.5, frequency_hz: 1}}}\n")
        self.assertEqual((told["quantity"], told["protocol"]), ("overturning factor", "release"))
        self.assertEqual(set(settings), {"step_tolerance", "least_bounce"})
        for finding in settings.values():
            self.assertEqual(finding["verdict"], "holds")
            for level in finding["levels"]:
                self.assertLess(0.5 * level["bracket"]["least"], low + 5e-4)
                self.assertGreater(0.5 * level["bracket"]["most"], high - 5e-4)

    def test_figure(self):
        """A figure is written whole, and its table has every level; a file that is none of it, and what belongs to one test,
        are refused."""
        scene = ROOT / "examples" / "tilt_block_a_peak.yaml"
        for ending in ("svg", "csv"):
            status, out, err = run("tilt", "--converge", "--figure", self.folder / f"own.{ending}", scene)
            self.assertEqual(status, 0, err)
            self.assertIn("Converged to the 0.01°", out)
            self.assertLessEqual(max(map(len, out.splitlines())), 80)
        table = (self.folder / "own.csv").read_text().splitlines()
        self.assertEqual(len(table), 1 + 5 + 3 + 4)
        self.assertIn("critical_angle_deg", table[0])
        self.assertIn("normal stiffness", (self.folder / "own.svg").read_text())
        for words in (("--figure", "own.txt"), ("--csv",), ("--overturning",), ("--animation", "own.svg")):
            with self.subTest(words):
                self.assertEqual(run("tilt", "--converge", *words, scene)[0], 2)

    def test_refused(self):
        for text, words in (("", "calls for no simulation"),
                            ("tilt_test: {engine: dynamics, protocol: release}\n", "has no critical angle")):
            (self.folder / "scene.yaml").write_text(SLAB.format(w=1, h=3).replace("left}", "left, angle_deg: 5}") + text)
            status, out, err = run("tilt", "--converge", self.folder / "scene.yaml")
            self.assertEqual((status, out), (3, ""))
            self.assertIn(words, err)

    def test_rows_of_accuracy(self):
        """`topple accuracy` has the same levels for a scene that calls for a test, and none for another."""
        scene = ROOT / "examples" / "tilt_block_e_valley.yaml"
        own = json.loads(run("tilt", "--converge", "--json", scene)[1])
        also = json.loads(run("accuracy", "--json", scene)[1])["simulated"]
        for one, other in zip(own["cases"][0]["settings"], also["cases"][0]["settings"], strict=True):
            self.assertEqual([level["bracket"] for level in one["levels"]], [level["bracket"] for level in other["levels"]])
        self.assertNotIn("simulated", json.loads(run("accuracy", "--json", ROOT / "examples" / "slab_left.yaml")[1]))
        self.assertIn("Dependence of its simulated test on the settings", run("accuracy", scene)[1])


if __name__ == "__main__":
    main()
