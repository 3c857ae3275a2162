# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The program's face: exit statuses, what goes to stdout and stderr, and the contract of its JSON."""

import pathlib
import subprocess
import tempfile
import unittest

from harness import PROGRAM, ROOT, main, run, solve

E_VALLEY = "examples/block_e_valley.yaml"


class CommandLine(unittest.TestCase):
    def test_usage(self):
        """Wrong usage is status 2, with a hint on stderr and nothing on stdout."""
        for arguments in ([], ["sovle", E_VALLEY], ["solve"], ["solve", "--jsn", E_VALLEY],
                          ["solve", E_VALLEY, E_VALLEY]):
            status, out, err = run(*arguments)
            self.assertEqual(status, 2, arguments)
            self.assertEqual(out, "")
            self.assertIn("help", err)

    def test_help_and_version(self):
        for arguments in (["--help"], ["solve", "--help"], ["--version"]):
            status, out, err = run(*arguments)
            self.assertEqual((status, err), (0, ""))
            self.assertIn("topple", out)

    def test_scene_alone(self):
        """`topple SCENE` is short for `topple solve SCENE`; only times differ between runs."""
        def untimed(text):
            return [line for line in text.splitlines() if " ms" not in line]
        self.assertEqual(untimed(run(E_VALLEY)[1]), untimed(run("solve", E_VALLEY)[1]))

    def test_full_disk(self):
        """A report that cannot be written is status 5 and says so."""
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = subprocess.run([PROGRAM, "solve", E_VALLEY], cwd=ROOT, stdout=full,
                                  stderr=subprocess.PIPE, encoding="utf-8", check=False)
        self.assertEqual(done.returncode, 5)
        self.assertIn("cannot write the report", done.stderr)

    def test_same_input_same_bytes(self):
        """Two runs print the same JSON but for the seconds."""
        def untimed(text):
            return [line for line in text.splitlines() if '"seconds"' not in line]
        one, other = (run("solve", "--json", "--elements", "examples/boulder.yaml")[1]
                      for _ in range(2))
        self.assertEqual(untimed(one), untimed(other))

    def test_json_contract(self):
        """The keys that other programs rely on, with their types."""
        solution = solve(E_VALLEY, "--elements")
        self.assertEqual(solution["topple"], "0.1.0")
        (case,) = solution["cases"]
        self.assertEqual(case["towards"], "left")
        for key in ("area_m2", "centroid_x_m", "centroid_y_m", "weight_n"):
            self.assertEqual(set(case["block"][key]), {"value", "error"})
        self.assertEqual(case["block"]["triangles"], 4)
        for pivot in case["pivots"]:
            self.assertLessEqual({"kind", "x_m", "y_m", "critical_angle_deg", "fos", "admissible"},
                                 set(pivot))
        self.assertLessEqual({"pivot", "critical_angle_deg", "fos"}, set(case["toppling"]))
        self.assertLessEqual({"critical_angle_deg", "fos"}, set(case["sliding"]))
        self.assertEqual(case["mechanism"], "stands")
        names = [effect["name"] for effect in case["effects"]]
        self.assertEqual(names, ["outline", "contact", "elements", "moments", "toppling", "sliding",
                                 "limit", "onset"])
        self.assertLessEqual({"fos", "mechanism", "definition"}, set(case["governing_fos"]))
        self.assertLessEqual({"critical_angle_deg", "mechanism", "windows"}, set(case["onset"]))
        self.assertIsInstance(case["motions"], list)
        for effect in case["effects"]:
            self.assertEqual(set(effect), {"name", "called_for_by", "seconds", "level"})

    def test_effects_are_called_for(self):
        """Without friction no sliding runs, without a tilt angle no elements; fos is null then."""
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder) / "scene.yaml"
            scene.write_text("topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 2}}\n")
            cases = solve(scene)["cases"]
        self.assertEqual([c["towards"] for c in cases], ["left", "right"])
        for case in cases:
            self.assertEqual([e["name"] for e in case["effects"]],
                             ["outline", "contact", "moments", "toppling"])
            self.assertIsNone(case["toppling"]["fos"])
            self.assertIsNone(case["block"]["weight_n"])
            self.assertNotIn("sliding", case)
            self.assertFalse(case["contact"]["beyond_stated"])

    def test_large_block(self):
        """Beyond 10 000 vertices the elements form runs only when asked for: the triangulation costs
        more than all the rest. A saw of 12 000 flat teeth, whose both forms agree about its toe."""
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder) / "scene.yaml"
            scene.write_text("topple: 1\nlength_unit: m\nblock: {teeth: {count: 12000, width: 1, height: "
                             "20000, depth: 0.1, left_end: valley}}\ntilt: {towards: left, angle_deg: 9}\n")
            plain, asked = solve(scene)["cases"][0], solve(scene, "--elements")["cases"][0]
        self.assertIsNone(plain["toppling"]["fos_elements"])
        self.assertNotIn("elements", [e["name"] for e in plain["effects"]])
        one, other = asked["toppling"]["fos"], asked["toppling"]["fos_elements"]
        self.assertLessEqual(abs(one["value"] - other["value"]), one["error"] + other["error"])

    def test_title_is_escaped(self):
        """A title with quotes, backslashes and control characters survives the JSON."""
        title = 'a "b" \\ c\td — β'
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder) / "scene.yaml"
            scene.write_text("topple: 1\ntitle: \"a \\\"b\\\" \\\\ c\\td — β\"\nlength_unit: m\n"
                             "block: {slab: {width: 1, height: 2}}\n", encoding="utf-8")
            self.assertEqual(solve(scene)["title"], title)


class HardDecisions(unittest.TestCase):
    """Decisions at a knife edge are made exactly, or by as much precision as they take."""

    def solve_slab(self, width, height, more, towards="left"):
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder) / "scene.yaml"
            scene.write_text(f"topple: 1\nlength_unit: m\nblock: {{slab: {{width: {width}, height: "
                             f"{height}}}}}\n{more}\n")
            cases = solve(scene)["cases"]
        return next(c for c in cases if c["towards"] == towards)

    def test_tilt_at_the_critical_angle(self):
        """A square slab tilts over at exactly 45 degrees: at 45 the margin is exactly zero and it no
        longer stands; 1e-30 degrees below it stands, 1e-30 above it does not."""
        for tilt, mechanism, sign in (("45", "topples", 0), ("45 - 1e-30", "stands", 1),
                                      ("45 + 1e-30", "topples", -1)):
            case = self.solve_slab(3, 3, f"tilt: {{angle_deg: {tilt}}}")
            margin = case["first"]["margin_deg"]
            self.assertEqual(case["mechanism"], mechanism)
            self.assertEqual((margin["value"] > 0) - (margin["value"] < 0), sign)
            self.assertLessEqual(margin["error"], abs(margin["value"]) * 1e-9)

    def test_tie_of_sliding_and_toppling(self):
        """Friction 45 degrees on a slab as wide as high: both move at exactly 45 degrees."""
        case = self.solve_slab(1, 1, "friction_angle_deg: 45")
        self.assertEqual(case["mechanism"], "slides and topples")
        case = self.solve_slab("1 + 1e-40", 1, "friction_angle_deg: 45")
        self.assertEqual(case["mechanism"], "slides")
        case = self.solve_slab("1 - 1e-40", 1, "friction_angle_deg: 45")
        self.assertEqual(case["mechanism"], "topples")

    def test_tie_without_round_angles(self):
        """phi_b = 45 and a facet that rises by 1 in 2 down-dip: sliding at 45 + atan(1/2) = atan(3),
        which no decimal shows. The triangle (0, 1/2), (1, 0), (x, 3) has its centroid at
        ((1 + x)/3, 7/6), so about (0, 1/2) it topples at atan((1 + x)/2): a tie for x = 5, settled by
        exact arithmetic and broken by 1e-40."""
        scene = ("topple: 1\nlength_unit: m\nblock: {outline: [[0, 1/2], [1, 0], [%s, 3]]}\n"
                 "base: {profile: [[0, 1/2], [1, 0]]}\nfriction_angle_deg: 45\ntilt: {towards: left}\n")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "scene.yaml"
            for x, first in (("5", "slides and topples"), ("5 + 1e-40", "slides"),
                             ("5 - 1e-40", "topples")):
                path.write_text(scene % x)
                (case,) = solve(path)["cases"]
                self.assertEqual(case["first"]["mechanism"], first)

    def test_centroid_above_the_pivot(self):
        """A right triangle standing on a foot that ends exactly below its centroid: critical angle
        exactly 0, and the margin at level ground exactly 0."""
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder) / "scene.yaml"
            scene.write_text("topple: 1\nlength_unit: m\nblock: {outline: [[0, 0], [3, 0], [0, 3]]}\n"
                             "base: {profile: [[1, 0], [9, 0]]}\ntilt: {towards: left, angle_deg: 0}\n")
            (case,) = solve(scene)["cases"]
        self.assertEqual(case["toppling"]["critical_angle_deg"], {"value": 0, "error": 0})
        self.assertEqual(case["first"]["margin_deg"], {"value": 0, "error": 0})
        self.assertEqual(case["mechanism"], "topples")

    def test_wedged_on_a_steep_ridge(self):
        """Teeth steeper than friction astride a ridge: the facet that leans down-dip alone would slide
        on level ground, so the other keeps its load; it leans against the block at 71.6 degrees. With
        phi_b = 20 forces hold it at any tilt; with phi_b = 10 it turns up over the ridge at 61.4
        degrees already, where Patton's formula says 81.6."""
        text = ("topple: 1\nlength_unit: m\nblock: {teeth: {count: 2, width: 10, height: 100, depth: "
                "30, left_end: valley}}\nfriction_angle_deg: %s\n")
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder) / "scene.yaml"
            for friction, mechanism in (("20", "interlocked"), ("10", "slides and topples")):
                scene.write_text(text % friction)
                for case in solve(scene)["cases"]:
                    self.assertEqual(case["mechanism"], mechanism)
                    self.assertIsNone(case["toppling"])

    def test_no_factor_past_the_pivot(self):
        """On level ground nothing overturns about the toe, so its factor is unbounded; about the other
        end the weight lies past the pivot, and the resultant form has no value: both are null."""
        case = self.solve_slab(1, 2, "tilt: {angle_deg: 0}")
        self.assertEqual([p["fos"] for p in case["pivots"]], [None, None])
        self.assertEqual([p["fos_elements"] for p in case["pivots"]][0], None)

    def test_falls_backwards(self):
        """A centroid past the up-dip end of the contact: it topples up-dip until the tilt brings it
        back over the foot."""
        text = ("topple: 1\nlength_unit: m\nblock: {outline: [[0, 0], [4, 0], [4, 2], [0, 2]]}\n"
                "base: {profile: [[-1, 0], [1, 0]]}\ntilt: {towards: left, angle_deg: %s}\n")
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder) / "scene.yaml"
            for angle, falls in ((0, True), (44, True), (46, False)):
                scene.write_text(text % angle)
                (case,) = solve(scene)["cases"]
                self.assertEqual(case["falls_backwards"], falls)
                self.assertEqual(case["mechanism"], "topples" if falls else "stands")


if __name__ == "__main__":
    main()
