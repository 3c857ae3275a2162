# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Roughness of a digitised sole is no strength, and a caution says how much of it is in the factor.

A slab 4 m by 1.2 m with friction of 30° at 29° slides, on its mean plane, with tan 30° / tan 29° = 1.042. Its sole
digitised with ± 2 cm climbs over its own errors. The numbers of the caution are the governing factor the scene and
that of a second scene, with the sole drawn level."""

import json
import math
import pathlib
import random
import re
import tempfile
import unittest

from harness import main, run

SAID = re.compile(r"towards the (left|right) (?:([0-9.]+) governs|it holds up to ([0-9.]+)°|(nothing moves it)) with the sole "
                  r"as it is drawn; with ([0-9]+) of its facets, on asperities whose sides are shorter than ([0-9.]+) (m|mm), "
                  r"half of the contact, levelled into the mean plane it slides (?:with a factor of|at) ([0-9.]+)")
LEVEL = [(0, 0), (4, 0)]


def rough(draw, step, deviation=0.02):
    count = round(4 / step)
    return [(round(k * step, 3), round(draw.uniform(-deviation, deviation), 4)) for k in range(count + 1)]


class RoughSole(unittest.TestCase):
    def told(self, sole, base="{mated: true}", more="friction_angle_deg: 30\n", tilt="tilt: {towards: left, angle_deg: 29}\n", status=0):
        """All that JSON says of a slab with that sole, or the complaint."""
        outline = ", ".join(f"[{x}, {y}]" for x, y in sole + [(4, 1.2), (0, 1.2)])
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "slab.yaml"
            path.write_text("topple: 1\nlength_unit: m\nblock: {outline: [%s], unit_weight_kn_m3: 26}\nbase: %s\n%s%s"
                            % (outline, base, more, tilt))
            found, out, err = run("solve", "--json", path)
        self.assertEqual(found, status, err)
        return json.loads(out) if status == 0 else err

    def solve(self, sole, tilt="{towards: left, angle_deg: 29}", base="{mated: true}", more="friction_angle_deg: 30\n"):
        outline = ", ".join(f"[{x}, {y}]" for x, y in sole + [(4, 1.2), (0, 1.2)])
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "slab.yaml"
            path.write_text("topple: 1\nlength_unit: m\nblock: {outline: [%s], unit_weight_kn_m3: 26}\nbase: %s\n%stilt: %s\n"
                            % (outline, base, more, tilt))
            status, out, err = run("solve", "--json", path)
        self.assertEqual((status, err), (0, ""))
        found = json.loads(out)
        said = [SAID.search(note["text"]) for note in found["notes"] if "as it is drawn" in note["text"]]
        self.assertNotIn(None, said)
        return found["cases"][0], [match.groups() for match in said]

    def test_digitised_soles(self):
        """Both numbers, for soles with points 0.2 to 0.4 m apart, and the level one as the closed form has it."""
        draw = random.Random(12)
        told = 0
        for step in (0.2, 0.25, 0.4) * 4:
            case, said = self.solve(rough(draw, step))
            governs = case["governing_fos"]["fos"]
            flat = math.tan(math.radians(30)) / math.tan(math.radians(29))
            if governs["value"] < 1.005 * flat:
                self.assertEqual(said, [])
                continue
            told += 1
            side, drawn, _, _, facets, length, _, level = said[0]
            self.assertEqual((side, length, float(level)), ("left", "2", round(flat, 3)))
            self.assertEqual(int(facets), round(4 / step))
            self.assertAlmostEqual(float(drawn), governs["value"], delta=6e-4)
            self.assertTrue(1.1 < governs["value"] < 1.5)  # docs/limit.md
        self.assertGreater(told, 8)

    def test_smooth_gives_the_flat_number(self):
        """Any wavelength above the digitising step: tan 30° / tan 29° = 1.042 on a sole of one facet, level, with the area of the
        block as it was (by trapezoids here); the mirror image likewise. A wavelength below the step levels nothing."""
        draw = random.Random(7)
        flat = math.tan(math.radians(30)) / math.tan(math.radians(29))
        for step in (0.2, 0.25, 0.4) * 2:
            sole = rough(draw, step)
            area = 4.8 - sum((b[0] - a[0]) * (a[1] + b[1]) / 2 for a, b in zip(sole, sole[1:]))
            for smooth in (step + 0.001, 1, 10):
                found = self.told(sole, "{mated: true, smooth: %s}" % smooth)["cases"][0]
                self.assertAlmostEqual(found["governing_fos"]["fos"]["value"], flat, delta=1e-12)
                self.assertAlmostEqual(found["block"]["area_m2"]["value"], area, delta=1e-12)
                self.assertEqual((found["contact"]["facets"], found["smoothed"]["facets"], found["smoothed"]["stretches"]),
                                 (1, len(sole) - 1, 1))
                mean = sum((b[0] - a[0]) * (a[1] + b[1]) / 2 for a, b in zip(sole, sole[1:])) / 4
                self.assertAlmostEqual(found["smoothed"]["farthest_m"]["value"], max(abs(y - mean) for _, y in sole), delta=1e-12)
            mirror = [(4 - x, y) for x, y in reversed(sole)]
            other = self.told(mirror, "{mated: true, smooth: 1}", tilt="tilt: {towards: right, angle_deg: 29}\n")["cases"][0]
            self.assertAlmostEqual(other["governing_fos"]["fos"]["value"], flat, delta=1e-12)
            none = self.told(sole, "{mated: true, smooth: %s}" % (step / 2))["cases"][0]
            self.assertEqual(none["smoothed"]["facets"], 0)
            self.assertEqual(none["governing_fos"], self.told(sole)["cases"][0]["governing_fos"])

    def test_smooth_keeps_long_facets(self):
        """Noise between two long flanks of a wave: the noise becomes the line between its ends, and the flanks stay as drawn."""
        noise = [(1.5, 0.3), (1.7, 0.32), (1.9, 0.27), (2.1, 0.33), (2.3, 0.28), (2.5, 0.3)]
        found = self.told([(0, 0)] + noise + [(4, 0)], "{mated: true, smooth: 0.5}")["cases"][0]
        drawn = self.told([(0, 0), noise[0], noise[-1], (4, 0)])["cases"][0]
        self.assertEqual((found["smoothed"]["facets"], found["smoothed"]["stretches"]), (5, 1))
        for name in ("governing_fos", "limit", "pivots", "sliding"):
            self.assertEqual(found[name], drawn[name], name)
        self.assertAlmostEqual(found["smoothed"]["farthest_m"]["value"], 0.03, delta=1e-12)

    def test_smooth_as_it_lies(self):
        """In the frame of the world the sole becomes its mean plane: the factor is tan φ over the tangent of the dip that is told
        for the sole as it is drawn."""
        sole = rough(random.Random(3), 0.25)
        cosine, sine = 24 / 25, 7 / 25
        turn = lambda points: [(round(cosine * x - sine * y, 9), round(sine * x + cosine * y, 9)) for x, y in points]
        outline = ", ".join(f"[{x}, {y}]" for x, y in turn(sole + [(4, 1.2), (0, 1.2)]))
        found = []
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "slab.yaml"
            for base in ("{mated: true, smooth: 0.3}", "{mated: true}"):
                path.write_text("topple: 1\nlength_unit: m\nframe: {strike_deg: 300}\nfriction_angle_deg: 30\n"
                                "block: {outline: [%s], unit_weight_kn_m3: 26}\nbase: %s\n" % (outline, base))
                found.append(json.loads(run("solve", "--json", path)[1])["cases"][0])
        dip = [case["frame"]["dip_deg"]["value"] for case in found]
        self.assertAlmostEqual(dip[0], dip[1], delta=1e-12)
        self.assertEqual(found[0]["frame"]["dip_direction_deg"]["value"], 30)
        self.assertAlmostEqual(found[0]["governing_fos"]["fos"]["value"], math.tan(math.radians(30)) / math.tan(math.radians(dip[0])),
                               delta=1e-9)

    def test_apparent_friction(self):
        """What the facets would add is in the angle: the flat factor, whatever the length of the facets; basic adds, as before."""
        flat = math.tan(math.radians(30)) / math.tan(math.radians(29))
        for sole in (rough(random.Random(5), 0.25), [(0, 0), (1, 0.1), (2, 0), (3, 0.1), (4, 0)], LEVEL):
            apparent, basic, neither = (self.told(sole, more=f"friction_angle_deg: 30\n{meaning}") for meaning in
                                        ("friction_is: apparent\n", "friction_is: basic\n", ""))
            self.assertAlmostEqual(apparent["cases"][0]["governing_fos"]["fos"]["value"], flat, delta=1e-12)
            self.assertEqual(basic["cases"][0]["governing_fos"], neither["cases"][0]["governing_fos"])
            self.assertNotIn("rough joint", " ".join(note["text"] for note in basic["notes"]))

    def test_roughness_decides(self):
        """At 31° the level sole slides and the digitised one stands."""
        text = " ".join(note["text"] for note in self.told(rough(random.Random(5), 0.25), tilt="tilt: {towards: left, angle_deg: 31}\n")["notes"])
        self.assertIn("roughness decides that it stands", text)
        calm = " ".join(note["text"] for note in self.told(rough(random.Random(5), 0.25))["notes"])
        self.assertIn("'base: {smooth: …}' levels short facets", calm)
        self.assertNotIn("roughness decides", calm)

    def test_inclined_mean_line(self):
        """A sole that falls by 4 cm over 4 m is levelled along x, and a caution says what that takes away: 0.57°."""
        sole = [(k / 4, round(-0.011 * k / 4, 5)) for k in range(17)]
        notes = self.told(sole, "{mated: true, smooth: 1}")["notes"]
        self.assertTrue(any("is inclined to x by 0.63°" in note["text"] for note in notes), notes)

    def test_refused(self):
        steps = [(0, 0), (1, 0), (1, 0.1), (2, 0.1), (4, 0)]
        for sole, base, more, said in (
                (steps, "{mated: true, smooth: 1.5}", "friction_angle_deg: 30\n", "upright or runs back"),
                (LEVEL, "{mated: true, smooth: 0}", "friction_angle_deg: 30\n", "smooth must be above"),
                (LEVEL, "{profile: [[-1, 0], [5, 0]], smooth: 1}", "friction_angle_deg: 30\n", "smooth"),
                (LEVEL, "{profile: [[-1, 0], [5, 0]]}", "friction_angle_deg: 30\nfriction_is: apparent\n", "friction_is: basic"),
                (LEVEL, "{mated: true}", "friction_angle_deg: 30\nfriction_is: peak\n", "'basic'"),
                (LEVEL, "{mated: true}", "friction_is: basic\n", "give one of them")):
            error = self.told(sole, base, more, status=3)
            self.assertIn(said, error)
            self.assertRegex(error, r"slab\.yaml:\d+:\d+: ")

    def test_under_loads(self):
        """Water behind the slab: the level number is that of the level slab under the same water."""
        sole = rough(random.Random(5), 0.25)
        sole[0], sole[-1] = (0, 0), (4, 0)
        loads = "friction_angle_deg: 30\nloads: {water: {height: 0.3}}\n"
        _, said = self.solve(sole, more=loads, tilt="{towards: left, angle_deg: 20}")
        level, none = self.solve(LEVEL, more=loads, tilt="{towards: left, angle_deg: 20}")
        self.assertEqual(none, [])
        # the level slab weighs 124.8 kN, the digitised one some other tenths of a percent
        self.assertAlmostEqual(float(said[0][7]), level["sliding"]["fos"]["value"], delta=0.01)

    def test_without_a_tilt(self):
        """Angles in place of factors: the level sole slides at 30°."""
        case, said = self.solve(rough(random.Random(5), 0.25), tilt="{towards: left}")
        self.assertEqual(float(said[0][7]), 30)
        self.assertAlmostEqual(float(said[0][2]), case["limit"]["critical_angle_deg"]["value"], delta=6e-4)

    def test_long_waves_and_stated_teeth_are_none(self):
        """A level sole, one step from end to end, two teeth whose sides are half of the contact each, and a slab that
        topples before its level sole would slide: no caution. Teeth that the scene states as such: none either."""
        for sole in (LEVEL, [(0, 0), (4, 0.3)], [(0, 0), (2, 0.3), (4, 0)]):
            self.assertEqual(self.solve(sole, tilt="{towards: left, angle_deg: 10}")[1], [], sole)
        self.assertEqual(self.solve(rough(random.Random(5), 0.25), more="friction_angle_deg: 85\n")[1], [])
        status, out, _ = run("solve", "--json", "examples/block_e_valley.yaml")
        self.assertEqual(status, 0)
        self.assertNotIn("as it is drawn", out)


if __name__ == "__main__":
    main()
