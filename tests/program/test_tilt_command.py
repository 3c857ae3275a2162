# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""`topple tilt` as a user runs it: critical angles of slabs by closed forms, by each engine; the story of block E that section
4.5 of the paper tells; accelerograms in all their spellings; and every nonsense refused at its place."""

import csv
import io
import json
import math
import pathlib
import re
import tempfile
import unittest
import xml.etree.ElementTree

from harness import ROOT, main, run

HEAD = "topple: 1\nlength_unit: m\nblock: {{slab: {{width: {w}, height: {h}}}, unit_weight_kn_m3: 25}}\n" \
       "friction_angle_deg: {phi}\ntilt: {{towards: left}}\n"
SPRINGS = "method: springs, normal_stiffness_gpa_m: 1000, shear_stiffness_gpa_m: 100"
PULSE = "shaking: {horizontal: {half_sine: {peak_g: 0.4, frequency_hz: 2}}}\n"
AT2 = "PEER NGA STRONG MOTION DATABASE RECORD\nA made-up event\nACCELERATION TIME {word} IN UNITS OF G{dot}\n{sampling}\n"
VALUES = [0, 0.1, -0.25, 0.05, 0.125, 0]


class Tilt(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def write(self, text, name="scene.yaml"):
        (self.folder / name).write_text(text)
        return self.folder / name

    def told(self, text, *options, statuses=(0,)):
        status, out, err = run("tilt", "--json", *options, self.write(text))
        self.assertIn(status, statuses, err)
        return json.loads(out)

    def critical(self, text):
        own = self.told(text)["cases"][0]
        angle = own["critical_angle_deg"]
        self.assertTrue(angle["converged"])
        return angle["stands_at"], angle["lets_go_at"], own

    def refused(self, text, *words, place=None):
        path = self.write(text)
        status, out, err = run("tilt", path)
        self.assertEqual((status, out), (3, ""), err)
        for word in words:
            self.assertIn(word, err)
        if place is not None:
            self.assertIn(f"{place}: ", err)
        return err

    def test_slabs(self):
        """atan(w / h) where it topples, phi where it slides, by the path and by rigid contacts. The bracket holds the closed
        form: a run stood below it, a run began to move above it."""
        for w, h, phi in ((1, 3, 40), (2, 5, 30), (4, 2, 25), (1, 1, 35)):
            topples = math.degrees(math.atan2(w, h))
            truth = min(topples, phi)
            for test in ("{engine: path}", "{engine: path, protocol: steps}",
                         "{engine: dynamics, protocol: steps, tolerance_deg: 0.001, duration_s: 0.001}"):
                with self.subTest(w=w, h=h, phi=phi, test=test):
                    path = self.write(HEAD.format(w=w, h=h, phi=phi) + f"tilt_test: {test}\n")
                    status, out, err = run("tilt", "--json", path)
                    own = json.loads(out)["cases"][0]  # a bracket is there, however the fall ends
                    angle = own["critical_angle_deg"]
                    self.assertTrue(angle["converged"], err)
                    self.assertLessEqual(angle["stands_at"], truth + 1e-6)
                    self.assertGreaterEqual(angle["lets_go_at"], truth - 1e-6)
                    self.assertLessEqual(angle["lets_go_at"] - angle["stands_at"], 0.01)
                    self.assertEqual(own["mechanism"], "topples" if topples < phi else "slides")
                    self.assertEqual(own["statics"]["place"], "within")

    def test_story_of_block_e(self):
        """The upper sub-element, facet 3, loses contact first; then the peak bears at its upper end; the intermediate contact
        slips before the toe does; at the limit it slides and topples, and no sooner (section 4.5)."""
        status, out, err = run("tilt", "--json", ROOT / "examples" / "tilt_block_e_valley.yaml")
        self.assertEqual(status, 0, err)
        own = json.loads(out)["cases"][0]
        limit = json.loads(run("solve", "--json", ROOT / "examples" / "block_e_valley.yaml")[1])["cases"][0]["limit"]
        self.assertAlmostEqual(own["critical_angle_deg"]["lets_go_at"], limit["critical_angle_deg"]["value"], delta=1e-4)
        self.assertEqual(own["mechanism"], "slides and topples")
        at = {}
        for event in own["events"]:
            at.setdefault((event["what"], event["facet"]), event["angle_deg"])
        self.assertLess(at["opens", 3], at["opens", 2])
        self.assertLess(at["opens", 2], at["slips", 2])
        self.assertLess(at["slips", 2], at["slips", 1])
        self.assertLess(at["slips", 1], own["critical_angle_deg"]["lets_go_at"])
        angles = [event["angle_deg"] for event in own["events"]]
        self.assertEqual(angles, sorted(angles))

    def test_locked_stress(self):
        """Between onset and limit history decides: stress locked in holds a block that falls without it, up to a tilt that
        depends on the ratio of the stiffnesses (22.767 and 23.342 degrees: docs/tilt_path.md); the result says on what."""
        scene = ROOT / "examples" / "tilt_locked_stress.yaml"
        for shear, truth in ((10, 22.767), (1000, 23.342)):
            status, out, err = run("tilt", "--json", "--set", f"tilt_test.shear_stiffness_gpa_m={shear}", scene)
            self.assertEqual(status, 0, err)
            told = json.loads(out)
            self.assertEqual((told["settings"]["from_deg"], told["settings"]["tractions"]), (21, 2))
            angle = told["cases"][0]["critical_angle_deg"]
            self.assertAlmostEqual(angle["stands_at"], truth, delta=5e-3)
            self.assertLess(told["cases"][0]["statics"]["onset_deg"], 21)
            self.assertLess(angle["lets_go_at"], told["cases"][0]["statics"]["limit_deg"])
        self.assertIn("the stress locked in on its contact", run("tilt", scene)[1])
        none = ("--set", "tilt_test.tractions.1.shear_kpa=0", "--set", "tilt_test.tractions.2.shear_kpa=0")
        status, out, err = run("tilt", *none, scene)
        self.assertEqual(status, 0, err)
        self.assertIn("No forces hold it where it is set down", out)
        mirrored = [part for key in ("1", "2") for part in
                    ("--set", f"tilt_test.tractions.{key}.shear_kpa={'20456' if key == '1' else '-6612'}")]
        self.assertIn("No forces hold it", run("tilt", *mirrored, scene)[1])  # the same stress the other way round

    def test_softening(self):
        """What springs give takes (W h / k)^(1/3) of a toe: ten times softer, 10^(1/3) as much, within a tenth. A scene that
        gives no stiffness is not asked."""
        def told(*settings):
            return json.loads(run("tilt", "--json", *settings, ROOT / "examples" / "tilt_block_e_valley.yaml")[1])["cases"][0]
        self.assertNotIn("softening_deg", told())
        text = (ROOT / "examples" / "tilt_block_e_valley.yaml").read_text()
        softening = []
        for stiffness in (1000, 100):
            own = self.told(text + f"  normal_stiffness_gpa_m: {stiffness}\n  shear_stiffness_gpa_m: {stiffness / 100}\n")
            softening.append(own["cases"][0]["softening_deg"])
        self.assertAlmostEqual(softening[0], 0.115, delta=1e-3)  # docs/tilt_path.md
        self.assertAlmostEqual(softening[1] / softening[0], 10 ** (1 / 3), delta=0.1 * 10 ** (1 / 3))

    def test_gives_way(self):
        """With k_s = k_n one facet of block F slips for good at phi - i, the paper's 20.5 degrees, where the block gives way; it
        comes to rest on the other within the reach of its springs."""
        text = (ROOT / "examples" / "tilt_block_f.yaml").read_text()
        own = self.told(text + "  normal_stiffness_gpa_m: 1000\n  shear_stiffness_gpa_m: 1000\n")["cases"][0]
        self.assertEqual(own["jumps"], 1)
        self.assertAlmostEqual(own["first_jump_deg"], 30 - math.degrees(math.atan2(5, 30)), delta=0.01)
        self.assertGreater(own["critical_angle_deg"]["stands_at"], 23)

    def test_stable_step(self):
        """A step above the longest stable one is refused with one that would do: that one is taken."""
        head = HEAD.format(w=1, h=3, phi=40).replace("{towards: left}", "{towards: left, angle_deg: 5}")
        scene = head + "tilt_test: {engine: dynamics, protocol: release, "
        err = self.refused(scene + f"{SPRINGS}, time_step_s: 1}}\n", "are not stable")
        would = re.search(r"has (\S+) s; (\S+) s would do", err.replace("\n", " "))
        for step, stable in ((would[2], True), (str(1.1 * float(would[1])), False), (str(0.9 * float(would[1])), True)):
            text = scene + f"{SPRINGS}, duration_s: 0.01, time_step_s: {step}}}\n"
            if stable:
                self.assertAlmostEqual(self.told(text, statuses=(0, 4))["settings"]["time_step_s"], float(step), delta=1e-12)
            else:
                self.refused(text, "are not stable")

    def test_until(self):
        """A table that stops below the limit says that the block stands, and tells no angle that was not tried."""
        own = self.told(HEAD.format(w=1, h=1, phi=30) + "tilt_test: {engine: path, until_deg: 29}\n")["cases"][0]
        self.assertEqual(own["critical_angle_deg"], {"stands_at": 29, "lets_go_at": None, "converged": True})
        self.assertEqual(own["end"], "stands")

    def test_records(self):
        """One record as PEER's two headers have it, with numbers over any lines, and as CSV in three units: the same peaks."""
        head = HEAD.format(w=2, h=1, phi=50) + "tilt_test: {engine: dynamics, duration_s: 0.01}\n"
        numbers = "\n".join("  ".join(f"{value:.7E}" for value in VALUES[k:k + 4]) for k in (0, 4)) + "\n"
        for name, text in (
                ("new.AT2", AT2.format(word="SERIES", dot="", sampling="NPTS=     6, DT=   .0200 SEC") + numbers),
                ("old.at2", AT2.format(word="HISTORY", dot=".", sampling="    6   0.0200    NPTS, DT") + numbers),
                ("g.csv", "time_s,acceleration_g\n" + "".join(f"{0.02 * k:.2f},{v}\n" for k, v in enumerate(VALUES))),
                ("si.csv", "t (s); a (m/s2)\n# a comment\n" + "".join(f"{0.02 * k:.2f}; {v * 9.80665:.9f}\n"
                                                                        for k, v in enumerate(VALUES))),
                ("gal.csv", "time_s,ns_gal,ud_gal\n" + "".join(f"{5 + 0.02 * k:.2f},0,{v * 980.665:.9f}\n"
                                                                for k, v in enumerate(VALUES)))):
            column = ", column: 3" if name == "gal.csv" else ""
            with self.subTest(name):
                self.write(text, name)
                told = self.told(head + f"shaking: {{horizontal: {{record: {{file: {name}, scale: 2{column}}}}}}}\n",
                                 statuses=(0, 4))["shaking"]["horizontal"]
                self.assertAlmostEqual(told["peak_g"], 0.5, delta=1e-8)
                self.assertAlmostEqual(told["duration_s"], 0.1, delta=1e-12)
                velocity = 2 * 9.80665 * 0.02 * sum((a + b) / 2 for a, b in zip(VALUES, VALUES[1:]))
                self.assertAlmostEqual(told["last_velocity_m_s"], velocity, delta=1e-8)

    def test_records_refused(self):
        head = HEAD.format(w=2, h=1, phi=50)
        scene = head + "shaking: {horizontal: {record: {file: own.%s}}}\n"
        for ending, text, words, line in (
                ("csv", "0,0\n0.1,1\n", "a header with units must come first", "own.csv:1:1"),
                ("csv", "time_s,acceleration\n0,0\n", "must end in the unit", "own.csv:1:8"),
                ("csv", "time,acceleration_g\n0,0\n", "must be the time in seconds", "own.csv:1:1"),
                ("csv", "time_s,a_g\n0,0\n0.1,x\n", "holds numbers alone", "own.csv:3:5"),
                ("csv", "time_s,a_g\n0,0\n0.1,nan\n", "not a finite number", "own.csv:3:5"),
                ("csv", "time_s,a_g\n0,0\n0.1,1\n0.5,1\n", "a gap in the accelerogram", "own.csv:4"),
                ("csv", "time_s,a_g\n0,0\n0.1,1\n0.24,1\n", "an uneven step", "own.csv:4"),
                ("csv", "time_s,a_g\n0,0\n0.1,1\n0.05,1\n", "time does not go on", "own.csv:4"),
                ("csv", "time_s,a_g\n0,0\n0.1\n", "a number is missing", "own.csv:3"),
                ("csv", "time_s,a_g\n0,1\n", "two samples at least", "own.csv"),
                ("csv", "", "the file is empty", "own.csv:1:1"),
                ("csv", "time_s,a_g\n0,0\n1,0\n", "zero throughout", "scene.yaml"),
                ("at2", "a\nb\nc\nd\n0 1 2\n", "no line with NPTS and DT", "own.at2"),
                ("at2", AT2.format(word="SERIES", dot="", sampling="NPTS= 6, DT= .02").replace("ACCELERATION", "VELOCITY"),
                 "other units are not guessed", "own.at2:4"),
                ("at2", AT2.format(word="SERIES", dot="", sampling="NPTS= 6, DT= .02") + "1 2 3\n",
                 "ends after 3 numbers, of 6", "own.at2"),
                ("at2", AT2.format(word="SERIES", dot="", sampling="NPTS= 2, DT= .02") + "1 2 3\n",
                 "more numbers than NPTS", "own.at2:5:5"),
                ("at2", AT2.format(word="SERIES", dot="", sampling="NPTS= 6, DT= 0") + "1\n", "above zero", "own.at2:4")):
            with self.subTest(text):
                self.write(text, f"own.{ending}")
                self.assertIn(line, self.refused(scene % ending, words))

    def test_nonsense(self):
        head = HEAD.format(w=1, h=3, phi=40)
        for text, words, place in (
                ("tilt_test: {engine: fem}", "engine must be path", "6:21"),
                ("tilt_test: {method: events}", "a method belongs to 'engine: dynamics'", "6:21"),
                ("tilt_test: {engine: dynamics, method: springs}", "no stiffness is assumed", "6:12"),
                ("tilt_test: {engine: dynamics, method: springs, normal_stiffness_gpa_m: 1}", "need both", "6:12"),
                (f"tilt_test: {{engine: dynamics, {SPRINGS}, time_step_s: 1}}", "are not stable", "6:"),
                ("tilt_test: {normal_stiffness_gpa_m: 0, shear_stiffness_gpa_m: 1}", "above zero, not 0", "6:37"),
                ("tilt_test: {normal_stiffness_gpa_m: 1, shear_stiffness_gpa_m: -1}", "above zero, not -1", "6:63"),
                ("tilt_test: {restitution: 0}", "'restitution' belongs to 'engine: dynamics' by 'method: events'", "6:26"),
                ("tilt_test: {engine: dynamics, restitution: 2}", "must lie in [0, 1]", "6:44"),
                ("tilt_test: {speed_deg_min: 20}", "a table that moves in time", "6:28"),
                ("tilt_test: {protocol: release}", "a release needs 'engine: dynamics'", "6:23"),
                ("tilt_test: {engine: dynamics, protocol: release}", "'tilt: {angle_deg: …}'", "6:41"),
                ("tilt_test: {start: set_down}", "a ramp starts level", "6:20"),
                ("tilt_test: {tractions: []}", "tractions are a list", "6:24"),
                ("tilt_test: {tractions: [{facet: 1, normal_kpa: [1, 2]}]}", "stress locked in on a facet is", "6:25"),
                ("tilt_test: {tractions: [{facet: 0, normal_kpa: [1, 2], shear_kpa: 1}]}", "counted from 1", "6:"),
                ("tilt_test: {tractions: [{facet: 1, normal_kpa: 1, shear_kpa: 1}]}", "normal_kpa", "6:"),
                ("tilt_test: {tractions: [{facet: 9, normal_kpa: [1, 2], shear_kpa: 1}]}", "none of the block rests on it", "6:25"),
                ("tilt_test: {tractions: [{facet: 1, normal_kpa: [1, 2], shear_kpa: 1}, {facet: 1, normal_kpa: [1, 2], "
                 "shear_kpa: 1}]}", "given twice", "6:71"),
                ("tilt_test: {engine: dynamics, tractions: [{facet: 1, normal_kpa: [1, 2], shear_kpa: 1}]}",
                 "belongs to 'engine: path'", "6:43"),
                ("tilt_test: {protocol: steps, start: level}", "one ramp to all angles", "6:37"),
                ("tilt_test: {speed: 20}", "'speed' lacks its unit: write 'speed_deg_min'", "6:13"),
                ("tilt_test: {engine: path}\n" + PULSE, "does not model shaking", "6:21"),
                ("tilt_test: {engine: dynamics, protocol: ramp}\n" + PULSE, "held at its tilt while its base shakes", "6:41"),
                ("shaking: {}", "needs 'horizontal' or 'vertical'", "6:10"),
                ("shaking: {horizontal: {}}", "is one of half_sine, full_sine and record", "6:"),
                ("shaking: {horizontal: {half_sine: {peak_g: 1}}}", "'frequency_hz' is missing", "6:"),
                ("shaking: {horizontal: {half_sine: {peak_g: 1, frequency_hz: 0}}}", "above zero", "6:61"),
                ("", "the scene calls for no simulation", "scene.yaml")):
            with self.subTest(text):
                self.assertIn(place, self.refused(head + text + "\n", words))
        bare = head.replace("friction_angle_deg: 40\n", "")
        self.refused(bare + "tilt_test: {engine: path}\n", "'friction_angle_deg' is missing")
        self.refused(head.replace("friction_angle_deg: 40", "loads: {cohesion_kpa: 1}\nfriction_angle_deg: 40")
                     + "tilt_test: {engine: path}\n", "cohesion")

    def test_boulder(self):
        """The example: spared as it is; overturned by a little more, as the bracket's two ends show when they are run."""
        boulder = ROOT / "examples" / "shaken_boulder.yaml"
        status, out, err = run("tilt", "--json", "--overturning", boulder)
        self.assertEqual(status, 0, err)
        own = json.loads(out)["cases"][0]
        self.assertEqual(own["end"], "rests again")
        factor = own["overturning_factor"]
        self.assertLess(factor["overturned_by"] / factor["spared_by"], 1.0011)
        self.assertGreater(factor["spared_by"], 1)
        for key, ends in (("spared_by", {"rests again", "stands", "still moves"}), ("overturned_by", {"overturned"})):
            scaled = f"shaking.horizontal.record.scale={1.5 * factor[key]!r}"
            told = json.loads(run("tilt", "--json", "--set", scaled, boulder)[1])["cases"][0]
            self.assertIn(told["end"], ends, key)
        weak = json.loads(run("tilt", "--json", "--set", "shaking.horizontal.record.scale=1", boulder)[1])["cases"][0]
        self.assertLess(0.35, math.tan(math.radians(weak["statics"]["limit_deg"])))
        self.assertEqual((weak["end"], weak["run_out_m"]), ("stands", 0))  # less than what lifts it moves nothing

    def test_overturning_spectrum(self):
        """The least half sine that overturns a slab, by rigid contacts against the equation of rocking of Housner's block,
        theta'' = p^2 (-sin(alpha - theta) + a/g cos(alpha - theta)), p^2 = 3 g / (4 R), integrated here by Runge and Kutta:
        such pulses overturn it before it ever comes back."""
        half_width, half_height = 0.5, 2
        p2 = 3 * 9.80665 / (4 * math.hypot(half_width, half_height))
        alpha = math.atan2(half_width, half_height)

        def overturns(peak, frequency):
            def rate(t, theta):
                shaking = peak * math.sin(2 * math.pi * frequency * t) if t < 0.5 / frequency else 0
                return p2 * (-math.sin(alpha - theta) + shaking * math.cos(alpha - theta))

            t, theta, speed, h = math.asin(math.tan(alpha) / peak) / (2 * math.pi * frequency), 0, 0, 0.001
            while 0 <= theta < math.pi / 2 and t < 8:
                k1, l1 = speed, rate(t, theta)
                k2, l2 = speed + h / 2 * l1, rate(t + h / 2, theta + h / 2 * k1)
                k3, l3 = speed + h / 2 * l2, rate(t + h / 2, theta + h / 2 * k2)
                k4, l4 = speed + h * l3, rate(t + h, theta + h * k3)
                theta += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
                speed += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4)
                t += h
            return theta >= math.pi / 2

        for frequency in (0.5, 1, 2):
            with self.subTest(frequency):
                low, high = 0.26, 4
                while high - low > 1e-4:
                    middle = (low + high) / 2
                    low, high = (low, middle) if overturns(middle, frequency) else (middle, high)
                told = self.told(HEAD.format(w=1, h=4, phi=60) + "base: {profile: [[-20, 0], [20, 0]]}\n"
                                 f"shaking: {{horizontal: {{half_sine: {{peak_g: 1, frequency_hz: {frequency}}}}}}}\n",
                                 "--overturning")["cases"][0]["overturning_factor"]
                self.assertLess(told["spared_by"], high * 1.0005)
                self.assertGreater(told["overturned_by"], low * 0.9995)
                self.assertLess(told["overturned_by"] - told["spared_by"], 1.1e-3 * high)

    def test_outputs(self):
        """The moments as CSV are those of the JSON; drawings are XML; the page has 80 columns; `solve` says what it leaves
        out."""
        boulder = ROOT / "examples" / "shaken_boulder.yaml"
        frames, moving = self.folder / "frames.svg", self.folder / "moving.svg"
        status, out, err = run("tilt", "--csv", "--moments", "50", "--figure", frames, "--animation", moving, boulder)
        self.assertEqual(status, 0, err)
        rows = list(csv.DictReader(io.StringIO(out)))
        told = json.loads(run("tilt", "--json", "--moments", "50", boulder)[1])["cases"][0]["moments"]
        self.assertEqual([float(row["turned_deg"]) for row in rows], [moment["turned_deg"] for moment in told])
        for path in (frames, moving):
            self.assertTrue(xml.etree.ElementTree.parse(path).getroot().tag.endswith("svg"))
        for scene in ("shaken_boulder", "tilt_block_e_valley", "tilt_block_f"):
            page = run("tilt", f"examples/{scene}.yaml")[1]
            self.assertLessEqual(max(map(len, page.splitlines())), 80, page)
        self.assertIn("the shaking of the base is not included in these results", run("solve", boulder)[1].replace("\n         ", " "))
        self.assertEqual(run("tilt", "--figure", self.folder / "x.png", boulder)[0], 3)


if __name__ == "__main__":
    main()
