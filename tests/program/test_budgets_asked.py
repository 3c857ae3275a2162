# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""No input below 100 KB may cost more than some 10 s and 1 GB: what a few bytes ask for is counted, and refused by
the number that asks for it where it is too much. Every run here has 20 s of CPU time and 1.5 GB of address space,
so that it ends with neither a signal nor a system error, however busy the machine is."""

import csv
import io
import itertools
import os
import pathlib
import random
import re
import resource
import subprocess
import tempfile
import unittest

from harness import PROGRAM, ROOT, main, rounds

SANITIZED = "sanitize" in PROGRAM
CPU_S = 400 if SANITIZED else 20
BYTES = 3 << 29
PEER = "PEER\nX\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 40, DT= {step} SEC\n" + 4 * (5 * "0.5 -0.3 " + "\n")
HAS = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True).stdout

BLOCK = """topple: 1
length_unit: mm
block: {outline: [[10,20],[30,20],[30,60],[10,60]], unit_weight_kn_m3: 26}
friction_angle_deg: 35
tilt: {towards: left, angle_deg: 20}
"""
SLAB = """topple: 1
length_unit: m
block: {slab: {width: 1, height: 2}, unit_weight_kn_m3: 26}
base: {mated: true, beyond: {left: 0, right: 0}}
friction_angle_deg: 35
tilt: {towards: left, angle_deg: 20}
"""


def limited():
    resource.setrlimit(resource.RLIMIT_CPU, (CPU_S, CPU_S))
    if not SANITIZED:
        resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))


class Asked(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)

    def write(self, name, text):
        self.assertLess(len(text), 100_000)
        (self.folder / name).write_text(text, encoding="utf-8")

    def run_limited(self, *arguments):
        done = subprocess.run([PROGRAM, *arguments], cwd=self.folder, preexec_fn=limited, capture_output=True,
                              text=True, check=False)
        return done.returncode, done.stdout, done.stderr

    def ends(self, *arguments):
        """With an answer, a refusal or in doubt; never by a limit."""
        status, out, err = self.run_limited(*arguments)
        self.assertIn(status, (0, 1, 3, 4), f"{arguments}: {err}")
        if status != 0:
            self.assertTrue(out or err)
        return status, out, err

    def refused(self, arguments, place, *words):
        status, out, err = self.ends(*arguments)
        self.assertEqual((status, out), (3, ""), err)
        self.assertIn(place, err)
        for word in words:
            self.assertIn(word, err)


# ---- drawings ------------------------------------------------------------------------------------


def groups(*pairs):
    return "".join(f"{code}\n{value}\n" for code, value in pairs)


def dxf(blocks, *entities):
    rectangle = groups((0, "LWPOLYLINE"), (8, "BLOCK"), (90, 4), (70, 1), (10, 0), (20, 0), (10, 1), (20, 0),
                       (10, 1), (20, 2), (10, 0), (20, 2))
    return (groups((0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1015"), (9, "$INSUNITS"), (70, 6),
                   (0, "ENDSEC"), (0, "SECTION"), (2, "BLOCKS")) + blocks +
            groups((0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES")) + rectangle + "".join(entities) +
            groups((0, "ENDSEC"), (0, "EOF")))


def block(name, *entities):
    return groups((0, "BLOCK"), (8, 0), (2, name), (10, 0), (20, 0)) + "".join(entities) + groups((0, "ENDBLK"))


def circle(layer):
    return groups((0, "CIRCLE"), (8, layer), (10, 0), (20, 0), (40, 1))


def line(layer):
    return groups((0, "LINE"), (8, layer), (10, 0), (20, 0), (11, 1), (21, 1))


def insert(name, layer, columns, rows, scale=1):
    return groups((0, "INSERT"), (8, layer), (2, name), (10, 0), (20, 0), (41, scale), (42, 3), (70, columns),
                  (71, rows), (44, 1), (45, 1), (50, 17.3))


@unittest.skipIf("without dxflib" in HAS, "built without dxflib")
class Drawings(Asked):
    def dxf_is_read(self):
        self.write("plain.dxf", dxf(""))
        if "built without" in self.run_limited("solve", "plain.dxf")[2]:
            self.skipTest("built without dxflib")

    def test_arrays_on_a_layer_that_is_not_used_cost_nothing(self):
        """A million lines, a hundred thousand ellipses, and blocks of blocks of 10^16: what they would be is told,
        and the block is the same as without them."""
        self.dxf_is_read()
        self.write("plain.dxf", dxf(""))
        plain = self.ends("solve", "--json", "plain.dxf")[1]
        within = [block(f"B{k}", insert(f"B{k + 1}", "X", 100, 100)) for k in range(4)] + [block("B4", line("X"))]
        for name, blocks, put in (
                ("rows", block("A", line("X")), insert("A", "X", 1000, 990)),
                ("arcs", block("A", *10 * [circle("X")]), insert("A", "X", 100, 100, 2)),
                ("deep", "".join(within), insert("B0", "X", 1, 1)),
                ("layer 0", block("A", line("0")), insert("A", "X", 1000, 990))):
            with self.subTest(name):
                self.write("array.dxf", dxf(blocks, put))
                status, out, err = self.ends("solve", "--json", "array.dxf")
                self.assertEqual(status, 0, err)
                keys = ("area_m2", "centroid_x_m", "centroid_y_m")
                for key in keys:
                    told = re.search(rf'"{key}": (.*)', out).group(1)
                    self.assertEqual(told, re.search(rf'"{key}": (.*)', plain).group(1))
                self.assertIn("left out", self.ends("solve", "array.dxf")[1])

    def test_arrays_of_what_is_used_are_refused(self):
        self.dxf_is_read()
        self.write("base.dxf", dxf(block("A", circle("BASE")), insert("A", "BASE", 1000, 990, 2)))
        self.refused(("solve", "base.dxf"), "base.dxf:30:1", "more than 500000 points", "export the layers")
        self.write("base.dxf", dxf(block("A", line("0")), insert("A", "BASE", 1000, 990)))
        self.refused(("solve", "base.dxf"), "base.dxf:30:1", "more than 500000 points")

    def test_few_inserted_objects_are_listed_as_before(self):
        self.dxf_is_read()
        self.write("few.dxf", dxf(block("A", circle("X")), insert("A", "X", 3, 2, 2)))
        out = self.ends("solve", "--verbose", "few.dxf")[1]
        self.assertEqual(out.count("CIRCLE"), 6, out)

    def test_a_spline_of_degree_10(self):
        """700 control points, with knots of 17 digits whose denominators share nothing."""
        self.dxf_is_read()
        draw = random.Random(1)
        points = [(draw.random() * 100, draw.random() * 100) for _ in range(700)]
        knots = sorted(draw.random() for _ in range(711))
        spline = groups((0, "SPLINE"), (8, "Y"), (70, 8), (71, 10), (72, 711), (73, 700), (74, 0),
                        *((40, k) for k in knots),
                        *itertools.chain.from_iterable(((10, x), (20, y), (30, 0)) for x, y in points))
        self.write("spline.dxf", dxf("", spline))
        self.assertEqual(self.ends("solve", "spline.dxf")[0], 0)

    def test_curves_of_an_outline_have_a_budget_in_all(self):
        path = "M0 0" + 3000 * "c1 2 3 -2 1 0"
        self.write("curves.svg", '<svg xmlns="http://www.w3.org/2000/svg">'
                                 f'<path id="BLOCK" d="{path}z"/></svg>')
        self.write("fine.yaml", "topple: 1\ndrawing: {file: curves.svg, unit: m, tolerance: 1e-18}\n")
        self.ends("solve", "fine.yaml")

    def test_transforms_are_multiplied_out_up_to_4096_bits(self):
        def svg(count):
            return ('<svg xmlns="http://www.w3.org/2000/svg">\n<g transform="' + "rotate(7.123)" * count +
                    '"><rect id="BLOCK" x="0" y="0" width="1" height="2"/></g></svg>\n')
        self.write("turned.svg", svg(20))
        status, out, err = self.run_limited("solve", "--unit", "m", "turned.svg")
        if "built without" in err:
            self.skipTest("built without expat")
        self.assertEqual(status, 0, err)
        self.write("turned.svg", svg(4000))
        self.refused(("solve", "--unit", "m", "turned.svg"), "turned.svg:2:1", "more than 4096 bits")


# ---- profiles and rests --------------------------------------------------------------------------


class Profiles(Asked):
    def base(self, text):
        self.write("scene.yaml", BLOCK + f"base: {text}\n")

    def test_points_of_a_rule(self):
        affine = "{profile: {self_affine: {length: 40, step: 40/%d, hurst: 0.8, rms_height: 0.4, seed: 6}}, place: %s}"
        self.base(affine % (4194303, "rest"))
        self.refused(("solve", "scene.yaml"), "scene.yaml:6:50", "from 8 to 499999", "4194303")
        teeth = "{profile: {teeth: {count: %d, wavelength: 0.0001, amplitude: 1, left_end: valley}}, place: rest}"
        self.base(teeth % 1000000)
        self.refused(("solve", "scene.yaml"), "scene.yaml:6:33", "at most 500 000 teeth")

    def test_a_block_that_touches_in_100_000_points(self):
        self.base("{profile: {teeth: {count: 500000, wavelength: 0.0002, amplitude: 1, left_end: valley}}, place: rest}")
        self.ends("solve", "scene.yaml")

    def test_all_poses_on_20_000_points(self):
        self.base("{profile: {self_affine: {length: 40, step: 40/20000, hurst: 0.8, rms_height: 0.4, seed: 6}}, place: all}")
        self.ends("solve", "scene.yaml")


# ---- simulations ---------------------------------------------------------------------------------


class Simulations(Asked):
    springs = "tilt_test: {{engine: dynamics, method: springs, normal_stiffness_gpa_m: {}, shear_stiffness_gpa_m: {}{}}}\n"

    def refuse(self, text, place, *words):
        self.write("scene.yaml", SLAB + text)
        self.refused(("tilt", "scene.yaml"), place, *words)

    def test_springs(self):
        self.refuse(self.springs.format("1e9", "1e9", ""), "scene.yaml:7:72", "steps", "at most 1e+08", "softer springs")
        self.refuse(self.springs.format("1e12", "1e-12", ""), "scene.yaml:7:72", "steps", "softer springs")
        self.refuse(self.springs.format("1e-12", "1e12", ""), "scene.yaml:7:102", "steps", "softer springs")
        self.refuse(self.springs.format("1", "1", ", time_step_s: 1e-300"), "scene.yaml:7:114", "1e-300 s",
                    "a longer 'time_step_s'")
        self.refuse(self.springs.format("1", "1", ", speed_deg_min: 1e-9"), "scene.yaml:7:116", "speed_deg_min")
        self.refuse(self.springs.format("1", "1", ", duration_s: 1e9"), "scene.yaml:7:113", "duration_s")

    def test_shaking(self):
        pulse = "shaking: {{horizontal: {{half_sine: {{peak_g: 1, frequency_hz: {}}}}}}}\n"
        self.refuse(pulse.format("1e-300"), "scene.yaml:7:61", "at most 4e+06", "a higher frequency")
        self.refuse(pulse.format("1e-9"), "scene.yaml:7:61", "at most 4e+06")
        self.write("scene.yaml", SLAB + pulse.format("1e300"))
        self.ends("tilt", "scene.yaml")
        self.write("scene.yaml", SLAB + pulse.format("1"))
        status, _, err = self.ends("tilt", "--spectrum=s.csv", "--frequencies=1e-300:1e300:5", "scene.yaml")
        self.assertEqual(status, 3)
        self.assertIn("at a frequency of 1e-300 in the spectrum: ", err)
        self.assertIn("at most 4e+06", err)
        self.assertFalse((self.folder / "s.csv").exists())

    def test_records(self):
        text = "shaking: {horizontal: {record: {file: own.at2}}}\n"
        self.write("own.at2", PEER.format(step="1e300"))
        self.refuse(text, "scene.yaml:7:", "a record of smaller steps")
        for step in ("-1", "- 1", "-.01", "-1e-3"):
            if step == "- 1":
                continue
            self.write("own.at2", PEER.format(step=step))
            self.refuse(text, f"own.at2:4:{len('NPTS= 40, DT= ') + len(step)}", "must be above zero")
        for count in ("-40", "0", "1.5", "1e9"):
            self.write("own.at2", PEER.format(step="0.01").replace("= 40", f"= {count}"))
            self.refuse(text, f"own.at2:4:{len('NPTS= ') + len(count)}", "NPTS must be a whole number")


class Contacts(Asked):
    def told(self, block, base, rest):
        self.write("scene.yaml", "topple: 1\nlength_unit: mm\n"
                   f"block: {{{block}, unit_weight_kn_m3: 26}}\nbase: {base}\nfriction_angle_deg: 20\n"
                   f"tilt: {{towards: left, angle_deg: 2}}\n{rest}\n")
        return self.ends("tilt" if rest else "solve", "scene.yaml")

    def test_pairs_that_may_touch(self):
        """Found at random: each of these ran out of time or memory, and the last ended by a signal."""
        mated = "{mated: true, beyond: {left: 0, right: 0}}"
        pulse = "shaking: {horizontal: {half_sine: {peak_g: 10, frequency_hz: 10}}}"
        self.told("teeth: {count: 10, width: 0.2, height: 40, depth: 40, left_end: valley}",
                  "{profile: {self_affine: {length: 40, step: 40/400000, hurst: 0.8, rms_height: 1e-9, seed: 1}}, "
                  "place: rest}", pulse)
        self.told("teeth: {count: 20000, width: 1e-30, height: 1e-30, depth: 1, left_end: valley}", mated, pulse)
        self.told("teeth: {count: 20000, width: 1e-300, height: 40, depth: 1e30, left_end: valley}",
                  "{profile: {teeth: {count: 1000, wavelength: 1e-30, amplitude: 1e3, left_end: peak}, "
                  "worn: {rounded: 1}}, place: rest}", "")
        self.told("ellipse: {width: 40, height: 1e6, flat: 2}", mated,
                  "tilt_test: {engine: dynamics, method: events, protocol: release, duration_s: 1}")

    def test_lengths_far_apart(self):
        """Teeth of a nanometre under an amplitude of 1e30 mm: doubles tell of no pair when it touches, and millions of
        them were looked at in exact numbers, for 15 s and more, before the work was told to be too much."""
        block = "teeth: {count: 1000, width: 2, height: 1, depth: 40, left_end: valley}"
        for rule in ("teeth: {count: 1000, wavelength: 1e-9, amplitude: 1e30, left_end: peak}, noise: {deviation: 1e-9, seed: 1}",
                     "teeth: {count: 1000, wavelength: 2, amplitude: 1e30, left_end: peak}"):
            for place in ("rest", "all"):
                with self.subTest(rule=rule, place=place):
                    began = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
                    status, out, err = self.told(block, f"{{profile: {{{rule}}}, place: {place}}}", "")
                    self.assertLess(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - began, 200 if SANITIZED else 5)
                    self.assertEqual((status, out), (3, ""))
                    self.assertIn("scene.yaml:4:", err)
                    self.assertIn("lengths too far apart", err)

    def test_a_row_that_reaches_beyond_its_ground(self):
        """1000 slabs side by side on the ground, and some more beyond its end, which fall however strong joints are, as the last one
        does by itself: thrust k tan(5 deg) of the k last ones is below what k times their weight asks for, k / 1. A search for forces
        that there are not took minutes, and left the factor open."""
        for hanging in (1, 10, 500):
            slabs = "".join(f"  - {{name: b{k}, slab: {{width: 1, height: 1}}, at: [{k}, 0]}}\n" for k in range(1000 + hanging))
            self.write("row.yaml", "topple: 1\nlength_unit: m\nfriction_angle_deg: 30\ntilt: {towards: left, angle_deg: 5}\nblocks:\n"
                       "  - {name: ground, ground: true, outline: [[-1000,-1],[1000,-1],[1000,0],[-1000,0]]}\n" + slabs)
            status, out, err = self.run_limited("solve", "--csv", "row.yaml")
            self.assertIn(status, (0, 4), err)
            row = next(csv.DictReader(io.StringIO(out)))
            self.assertEqual((row["verdict"], row["fos_is"]), ("collapses", "none"), row)


# ---- files that are written ----------------------------------------------------------------------


class Written(Asked):
    def test_two_options_never_write_one_file(self):
        scene = ROOT / "examples" / "block_e_valley.yaml"
        study = ROOT / "examples" / "study_slab.yaml"
        (self.folder / "there.svg").write_text("kept")
        (self.folder / "hard.svg").hardlink_to(self.folder / "there.svg")
        (self.folder / "soft.svg").symlink_to("there.svg")
        (self.folder / "dangling.svg").symlink_to("new.svg")
        (self.folder / "again").symlink_to(".")
        pairs = (("new.svg", "new.svg"), ("new.svg", "./new.svg"), ("again/new.svg", "new.svg"),
                 ("new.svg", str(self.folder / "new.svg")), ("dangling.svg", "new.svg"), ("there.svg", "hard.svg"),
                 ("there.svg", "soft.svg"))
        for one, other in pairs:
            for command in (("tilt", scene, "--figure", "--animation"), ("solve", scene, "--figure", "--write-profile"),
                            ("study", study, "--figure", "--scatter")):
                with self.subTest(command=command[0], one=one, other=other):
                    status, out, err = self.run_limited(command[0], f"{command[2]}={one}", f"{command[3]}={other}",
                                                        str(command[1]))
                    self.assertEqual((status, out), (2, ""), err)
                    self.assertIn("take different files", err)
        self.assertEqual((self.folder / "there.svg").read_text(), "kept")
        self.assertFalse((self.folder / "new.svg").exists())


# ---- the page ------------------------------------------------------------------------------------


class Page(unittest.TestCase):
    def test_it_has_every_budget_with_its_bound(self):
        header = re.findall(r"(TP_BUDGET_\w+) = (\d+)", (ROOT / "src/core/common/budget.h").read_text(encoding="utf-8"))
        page = re.findall(r"\| `(TP_BUDGET_\w+)` \| (\d+) \|", (ROOT / "docs/budgets.md").read_text(encoding="utf-8"))
        self.assertEqual(header, page)


# ---- at random -----------------------------------------------------------------------------------

EXTREME = ("0", "1", "-1", "1e-300", "1e-30", "1e-9", "1e-3", "0.5", "2", "7", "40", "1e3", "1e6", "1e9", "1e30", "1e300")
MILD = ("0.2", "0.5", "1", "2", "10", "40")


class AtRandom(Asked):
    """Scenes of a few lines, every count, length, stiffness, step and frequency of which is drawn from all
    magnitudes."""

    def number(self):
        return self.draw.choice(EXTREME if self.draw.random() < 0.4 else MILD)

    def count(self):
        return self.draw.choice(("1", "2", "3", "10", "100", "1000", "20000", "1000000", "10000000"))

    def profile(self):
        n = self.number
        rules = (f"self_affine: {{length: 40, step: 40/{self.count()}, hurst: 0.8, rms_height: {n()}, seed: 1}}",
                 f"self_affine: {{length: {n()}, step: {n()}, hurst: 0.5, z2: {n()}, seed: 1}}",
                 f"teeth: {{count: {self.count()}, wavelength: {n()}, amplitude: {n()}, left_end: peak}}",
                 f"teeth: {{count: {self.count()}, wavelength: 40/{self.count()}, amplitude: {n()}, left_end: valley}}")
        worn = self.draw.choice(("", f", worn: {{rounded: {n()}}}", f", noise: {{deviation: {n()}, seed: 1}}"))
        place = self.draw.choice(("rest", "all", "rest"))
        return f"{{profile: {{{self.draw.choice(rules)}{worn}}}, place: {place}}}"

    def block(self):
        n = self.number
        return self.draw.choice((f"slab: {{width: {n()}, height: {n()}}}", f"slab: {{width: {n()}, height: {n()}}}",
                                 f"teeth: {{count: {self.count()}, width: {n()}, height: {n()}, depth: {n()}, "
                                 "left_end: valley}",
                                 f"ellipse: {{width: {n()}, height: {n()}, flat: {n()}}}"))

    def simulation(self):
        n = self.number
        return self.draw.choice(
            ("tilt_test: {engine: path}",
             f"tilt_test: {{engine: path, normal_stiffness_gpa_m: {n()}, shear_stiffness_gpa_m: {n()}, tolerance_deg: {n()}}}",
             f"tilt_test: {{engine: dynamics, method: springs, normal_stiffness_gpa_m: {n()}, shear_stiffness_gpa_m: {n()}, "
             f"damping: 0.8, rounding: {n()}, speed_deg_min: {n()}}}",
             f"tilt_test: {{engine: dynamics, method: springs, normal_stiffness_gpa_m: {n()}, shear_stiffness_gpa_m: {n()}, "
             f"time_step_s: {n()}}}",
             f"tilt_test: {{engine: dynamics, method: events, speed_deg_min: {n()}, until_deg: {n()}}}",
             f"tilt_test: {{engine: dynamics, method: events, protocol: release, duration_s: {n()}}}",
             f"shaking: {{horizontal: {{half_sine: {{peak_g: {n()}, frequency_hz: {n()}}}}}}}",
             f"shaking: {{horizontal: {{full_sine: {{peak_g: {n()}, frequency_hz: {n()}}}}}, "
             f"vertical: {{half_sine: {{peak_g: {n()}, frequency_hz: {n()}}}}}}}"))

    def scene(self):
        base = "{mated: true, beyond: {left: 0, right: 0}}" if self.draw.random() < 0.5 else self.profile()
        text = (f"topple: 1\nlength_unit: {self.draw.choice(('m', 'mm'))}\n"
                f"block: {{{self.block()}, unit_weight_kn_m3: {self.draw.choice(('26', self.number()))}}}\n"
                f"base: {base}\nfriction_angle_deg: {self.draw.choice(('35', '20', self.number()))}\n"
                f"tilt: {{towards: left, angle_deg: {self.draw.choice(('20', '5', self.number()))}}}\n")
        if self.draw.random() < 0.6:
            text += self.simulation() + "\n"
        return text

    def test_scenes_of_extreme_numbers_end(self):
        for seed in range(rounds(24, 2000)):
            self.draw = random.Random(seed)
            text = self.scene()
            command = "tilt" if "tilt_test" in text or "shaking" in text else "solve"
            with self.subTest(seed=seed, scene=text):
                self.write("scene.yaml", text)
                self.ends(command, "scene.yaml")


if __name__ == "__main__":
    main()
