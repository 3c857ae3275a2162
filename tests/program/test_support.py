# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Support as an engineer gives it: bolts by their dip, with length, capacity, spacing and rows; pressures of linings and walls; the
force for a wanted factor and the direction in which it is least. Held to closed forms of a rectangle on a plane, to the same
support said in other words, to its mirror image, another origin and other units."""

import json
import math
import pathlib
import tempfile
import unittest

from harness import ROOT, main, run, solve

#: 1.2 x 4 m at 26 kN/m3 on a plane that dips by 25 degrees, with 2 m of water in the crack behind it.
WIDTH, HEIGHT, WEIGHT, DIP, FRICTION = 1.2, 4, 1.2 * 4 * 26, math.radians(25), math.tan(math.radians(35))
WATER = 9.81 * 2**2 / 2 * math.cos(DIP)
PLACE = "slope: {dip_deg: 25, towards: left}\n"
BOLT = "at: [0, 8/3], dip_deg: 15"


def scene(loads, place=PLACE, unit="m", slab=(WIDTH, HEIGHT), water="water: {height: 2}"):
    block = slab if isinstance(slab, str) else f"slab: {{width: {slab[0]}, height: {slab[1]}}}"
    return (f"topple: 1\nlength_unit: {unit}\nblock: {{{block}, unit_weight_kn_m3: 26}}\nfriction_angle_deg: 35\n{place}"
            f"loads: {{{', '.join(filter(None, (water, loads)))}}}\n")


def anchors(*bolts):
    return "anchors: [" + ", ".join(f"{{{bolt}}}" for bolt in bolts) + "]"


class Support(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, text):
        path = self.folder / "scene.yaml"
        path.write_text(text)
        return path

    def case(self, text, *words):
        return solve(self.write(text), *words)["cases"][0]

    def factors(self, text):
        """Toppling by moments, sliding, and governing."""
        case = self.case(text)
        sliding = case["sliding"]["fos"]
        toppling = case["toppling"]["fos"]
        return [number and number["value"] for number in (toppling, sliding, case["governing_fos"]["fos"])]

    def same(self, one, other):
        for a, b in zip(self.factors(one), self.factors(other)):
            self.assertTrue(a == b or abs(a - b) < 1e-9 * abs(b), (one, other, a, b))

    def found(self, text, wanted, *words, key="loads.anchors.1.force_kn"):
        status, out, error = run("solve", "--json", "--find", key, "--for", wanted, *words, self.write(text))
        self.assertEqual(status, 0, error)
        return json.loads(out)["find"]

    def refused(self, loads, **other):
        status, out, error = run("solve", self.write(scene(loads, **other)))
        self.assertEqual((status, out), (3, ""), error)
        self.assertRegex(error, r"scene\.yaml:\d+:\d+: ")
        return " ".join(error.split())

    def test_by_hand(self):
        """The block of issue 33: 80 kN, 15 degrees below the horizontal at two thirds of the height, active and passive, and with
        the uplift of the water. Moments about the lower edge, forces along the plane."""
        along, normal = 80 * math.cos(math.radians(40)), 80 * math.sin(math.radians(40))
        for uplift in (0, 1):
            water = f"water: {{height: 2, uplift: {'true' if uplift else 'false'}}}"
            lift = uplift * 9.81 * 2 * WIDTH / 2 * math.cos(DIP)
            press = WEIGHT * math.cos(DIP) + normal - lift
            drive = WEIGHT * math.sin(DIP) + WATER
            overturning = WEIGHT * math.sin(DIP) * HEIGHT / 2 + WATER * 2 / 3 + lift * WIDTH * 2 / 3
            held = WEIGHT * math.cos(DIP) * WIDTH / 2
            toppling = (held + along * 8 / 3) / overturning
            own = self.factors(scene(anchors(BOLT + ", force_kn: 80, passive: true"), water=water))
            self.assertAlmostEqual(own[0], toppling, delta=1e-9)
            self.assertAlmostEqual(own[1], (press * FRICTION + along) / drive, delta=1e-9)
            self.assertAlmostEqual(own[0], (1.971, 1.837)[uplift], delta=5e-4)
            self.assertAlmostEqual(own[1], (2.503, 2.397)[uplift], delta=5e-4)
            active = self.factors(scene(anchors(BOLT + ", force_kn: 80"), water=water))
            self.assertAlmostEqual(active[1], press * FRICTION / (drive - along), delta=1e-8)
        self.assertAlmostEqual(self.factors(scene(anchors(BOLT + ", force_kn: 80")))[1], 12.467, delta=5e-4)

    def test_force_for_a_factor(self):
        for passive, force in (("false", 31.886), ("true", 41.452)):
            text = scene(anchors(f"{BOLT}, force_kn: 80, passive: {passive}"))
            (own,) = self.found(text, "fos=1.3")["solutions"]
            self.assertAlmostEqual(own["value"], force, delta=5e-4)
        # of two rows at a spacing of 2 m the number found is that of one bolt, and as much per metre
        text = scene(anchors(f"{BOLT}, force_kn: 80, spacing: 2, rows: 2, row_step: [0, -0.5]"))
        told = self.found(text, "fos=1.3")
        arm = 8 / 3 + 8 / 3 - 0.5
        moment = WEIGHT * math.sin(DIP) * 2 + WATER * 2 / 3 - WEIGHT * math.cos(DIP) * 0.6 / 1.3
        self.assertAlmostEqual(told["solutions"][0]["value"], 2 * moment / arm / math.cos(math.radians(40)), delta=1e-9)
        self.assertAlmostEqual(told["per_metre_kn"][0]["value"], told["solutions"][0]["value"], delta=1e-9)

    def test_same_in_other_words(self):
        """Along a slope, as it lies, and on a table: a dip is a direction. Rows are bolts one by one, a spacing scales a force, a
        passive capacity is a force. (In the world's frame the dip is atan 7/24, and the bolt goes up-dip unless its side is said, in a
        mirror and shaken both ways too.)"""
        say = BOLT + ", force_kn: 80"
        self.same(scene(anchors(say)), scene(anchors("at: [0, 8/3], direction_deg: -40, force_kn: 80")))
        table = "tilt: {angle_deg: 25, towards: left}\n"
        self.same(scene(anchors(say), table), scene(anchors("at: [0, 8/3], direction_deg: -15, force_kn: 80"), table))
        c, s = 24 / 25, 7 / 25
        ring = [(c * x - s * y, s * x + c * y) for x, y in ((0, 0), (1.2, 0), (1.2, 4), (0, 4))]
        world = "outline: [" + ", ".join(f"[{x:.9f}, {y:.9f}]" for x, y in ring) + "]"
        x, y = -s * 2.5, c * 2.5
        bolt = f"at: [{x:.9f}, {y:.9f}], dip_deg: 15, force_kn: 80"
        lies = scene(anchors(bolt), "frame: world\n", slab=world)
        self.same(lies, scene(anchors(bolt + ", towards: right"), "frame: world\n", slab=world))
        mirror = "outline: [" + ", ".join(f"[{-x:.9f}, {y:.9f}]" for x, y in ring) + "]"
        self.same(lies, scene(anchors(bolt.replace("[-", "[")), "frame: world\n", slab=mirror))
        shaken = ["seismic: {horizontal: 0.3}, " + anchors(bolt + side) for side in ("", ", towards: right")]
        self.same(*(scene(loads, "frame: world\n", slab=world, water="") for loads in shaken))
        slope = f"slope: {{dip_deg: {math.degrees(math.atan2(7, 24))!r}, towards: left}}\n"
        self.same(lies, scene(anchors("at: [0, 2.5], dip_deg: 15, force_kn: 80"), slope))
        for passive in ("true", "false"):
            tail = f", passive: {passive}"
            rows = anchors(f"{say}{tail}, rows: 3, row_step: [0.1, -0.6]")
            single = anchors(*(f"at: [{0.1 * k}, 8/3 - {0.6 * k}], dip_deg: 15, force_kn: 80{tail}" for k in range(3)))
            self.same(scene(rows), scene(single))
            self.same(scene(anchors(f"{BOLT}, force_kn: 120, spacing: 1.5{tail}")), scene(anchors(say + tail)))
        self.same(scene(anchors(f"{BOLT}, capacity_kn: 80, passive: true")), scene(anchors(say + ", passive: true")))
        thick = f"slab: {{width: {WIDTH}, height: {HEIGHT}}}, thickness: 3"
        self.same(scene(anchors(f"{BOLT}, force_kn: 80, spacing: 1"), slab=thick), scene(anchors(f"{BOLT}, force_kn: 240"), slab=thick))

    def test_mirror_shift_units(self):
        bolt = "dip_deg: 15, force_kn: 80, spacing: {s}, length: {l}, rows: 2, passive: true"
        own = scene(anchors("at: [0, 8/3], row_step: [0, -0.5], " + bolt.format(s=1.5, l=3)))
        right = PLACE.replace("left", "right")
        mirror = scene(anchors("at: [1.2, 8/3], row_step: [0, -0.5], " + bolt.format(s=1.5, l=3)), right)
        self.same(own, mirror)
        ring = "outline: [[7, 9], [8.2, 9], [8.2, 13], [7, 13]]"
        self.same(own, scene(anchors("at: [7, 9 + 8/3], row_step: [0, -0.5], " + bolt.format(s=1.5, l=3)), slab=ring))
        small = scene(anchors("at: [0, 8000/3], row_step: [0, -500], " + bolt.format(s=1500, l=3000)), unit="mm", slab=(1200, 4000),
                      water="water: {height: 2000}")
        self.same(own, small)
        first, second = (solve(self.write(text))["supports"][0] for text in (own, small))
        for name, number in first.items():
            if isinstance(number, dict):
                self.assertAlmostEqual(number["value"], second[name]["value"], delta=1e-12, msg=name)

    def test_follows_the_dip(self):
        """Where the dip of the slope is set to another, a bolt stays at its angle below the horizontal."""
        path = self.write(scene(anchors(BOLT + ", force_kn: 80, passive: true")))
        set_to = solve(path, "--set", "slope.dip_deg=20")["cases"][0]["sliding"]["fos"]["value"]
        own = self.factors(scene(anchors("at: [0, 8/3], direction_deg: -35, force_kn: 80, passive: true"),
                                 PLACE.replace("25", "20")))[1]
        self.assertAlmostEqual(set_to, own, delta=1e-12)

    def test_report_and_json(self):
        """Lengths by hand: the way through the block is 1.2 / cos 40 degrees."""
        text = scene(anchors(BOLT + ", force_kn: 80, capacity_kn: 100, spacing: 2, length: 3, rows: 2, row_step: [0, -1]"),
                     slab=f"slab: {{width: {WIDTH}, height: {HEIGHT}}}, thickness: 5")
        own = solve(self.write(text))["supports"][0]
        for name, value in (("force_kn", 80), ("force_kn_m", 80), ("total_kn", 400), ("utilisation", 0.8), ("spacing_m", 2),
                            ("bond_length_m", 3 - 1.2 / math.cos(math.radians(40)))):
            self.assertLessEqual(abs(own[name]["value"] - value), own[name]["error"] + 1e-15, name)
        self.assertEqual((own["rows"], own["passive"]), (2, False))
        report = run("solve", self.write(text))[1]
        for words in ("bolts of 80 kN in 2 rows at a spacing of 2 m", "utilisation 0.800", "80 kN per metre, 400 kN on the block"):
            self.assertIn(words, report)
        self.assertNotIn("supports", solve(self.write(scene("anchors: [{at: [0, 1], direction_deg: -40, force_kn: 1}]"))))

    def test_pressure_of_a_support(self):
        """10 to 20 kPa on the whole face at the toe: 60 kN per metre, at 5/9 of the height above the base."""
        moment = WEIGHT * math.sin(DIP) * 2 + WATER * 2 / 3
        held = WEIGHT * math.cos(DIP) * 0.6
        drive = WEIGHT * math.sin(DIP) + WATER
        say = "support_pressures: [{from: [0, 4], to: [0, 0], kpa: [20, 10]%s}]"
        own = self.factors(scene(say % ""))
        self.assertAlmostEqual(own[0], (held + 60 * 4 * 5 / 9) / moment, delta=1e-9)
        self.assertAlmostEqual(own[1], (WEIGHT * math.cos(DIP) * FRICTION + 60) / drive, delta=1e-9)
        half = self.factors(scene("support_pressures: [{from: [0, 4], to: [0, 0], kpa: [10, 5], passive: false}]"))
        self.assertAlmostEqual(half[0], held / (moment - 30 * 4 * 5 / 9), delta=1e-9)
        told = solve(self.write(scene(say % "")))["supports"][0]
        self.assertAlmostEqual(told["force_kn_m"]["value"], 60, delta=1e-12)
        self.assertIn("would pull", self.refused("support_pressures: [{from: [0, 0], to: [0, 4], kpa: 10}]"))
        self.assertIn("does not act on an edge", self.refused("support_pressures: [{from: [1, 1], to: [1, 0], kpa: 10}]"))

    def test_least_force(self):
        """Sliding on a plane takes the least active force at phi to the plane, F = (drive - press tan phi / n) / (cos + sin tan phi /
        n) at tan = tan(phi) / n for a factor n; a passive one F = (n drive - press tan phi) / (cos + sin tan phi) at tan = tan(phi).
        Toppling takes it normal to its arm."""
        low = (3, 1)  # too low to topple
        weight = 3 * 26
        slide, hold = weight * math.sin(DIP) + 9.81 / 2 * math.cos(DIP), weight * math.cos(DIP)
        for passive, share in (("false", 1.5), ("true", 1)):
            text = scene(anchors(f"at: [0, 0.5], dip_deg: 15, force_kn: 10, passive: {passive}"), slab=low, water="water: {height: 1}")
            told = self.found(text, "sliding_fos=1.5", "--least-force")
            angle = math.atan(FRICTION / share)
            self.assertAlmostEqual(told["direction_deg"], math.degrees(angle) - 25, delta=2e-3)
            force = ((slide - hold * FRICTION / 1.5) / (math.cos(angle) + math.sin(angle) * FRICTION / 1.5) if share > 1 else
                     (1.5 * slide - hold * FRICTION) / (math.cos(angle) + math.sin(angle) * FRICTION))
            (own,) = told["solutions"]
            self.assertAlmostEqual(own["value"], force, delta=1e-6 * force)
            # proven at the direction given: there, the force makes the factor, and a little less does not
            turned = lambda kn: self.case(scene(
                anchors(f"at: [0, 0.5], dip_deg: {told['direction_deg']!r}, force_kn: {kn!r}, passive: {passive}"), slab=low,
                water="water: {height: 1}"))["sliding"]["fos"]
            above, below = turned(own["value"] + own["error"]), turned(own["value"] - own["error"] - 1e-9)
            self.assertGreaterEqual(above["value"] + above["error"], 1.5)
            self.assertLess(below["value"], 1.5)
        # at (0.9, 2) the arm from the lower edge is normal to a pull that dips by atan(0.9/2) below the plane
        told = self.found(scene(anchors("at: [0.9, 2], direction_deg: 0, force_kn: 80, passive: true")), "fos=1.3", "--least-force")
        moment = 1.3 * (WEIGHT * math.sin(DIP) * 2 + WATER * 2 / 3) - WEIGHT * math.cos(DIP) * 0.6
        self.assertAlmostEqual(told["direction_deg"], -math.degrees(math.atan2(0.9, 2)), delta=2e-3)
        self.assertAlmostEqual(told["solutions"][0]["value"], moment / math.hypot(0.9, 2), delta=1e-5)

    def test_between_two_forces(self):
        """An active bolt along the plane at two thirds of the height holds the block from a force on, until its pull topples it
        up-dip: there what drives is the bolt less the weight along the plane and the water, and 1.3 of it balances the weight across
        about the upper edge. The design
        is the least force, rounded up; the factor is judged anew at all ends, and of half and twice the force."""
        text = scene(anchors("at: [0, 8/3], dip_deg: -25, force_kn: 80"))
        told = self.found(text, "governing_fos=1.3", "--to", "300")
        low = (WEIGHT * math.sin(DIP) * 2 + WATER * 2 / 3 - WEIGHT * math.cos(DIP) * 0.6 / 1.3) * 3 / 8
        high = (WEIGHT * math.sin(DIP) * 2 + WATER * 2 / 3 + WEIGHT * math.cos(DIP) * 0.6 / 1.3) * 3 / 8
        (own,) = told["at_least"]
        self.assertAlmostEqual(own["low"], low, delta=1e-9)
        self.assertAlmostEqual(own["high"], high, delta=1e-9)
        self.assertEqual((own["begins"], own["ends"]), (True, True))
        for force, side in ((own["low"], 1), (own["low"] - 1e-9, -1), (own["high"], 1), (own["high"] + 1e-9, -1), (low / 2, -1),
                            (told["design"], 1), (high * 2, -1)):
            status, out, error = run("solve", "--json", "--set", f"loads.anchors.1.force_kn={force!r}", self.write(text))
            factor = json.loads(out)["cases"][0]["governing_fos"]["fos"]
            value, bound = (factor["value"], factor["error"]) if factor else (0, 0)
            self.assertGreaterEqual(side * (value - 1.3), -bound, (force, error))
        self.assertTrue(low < told["design"] < low + 0.01 and round(told["design"], 2) == told["design"])
        self.assertGreater(told["design_result"]["value"], 1.3)
        report = run("solve", "--find", "loads.anchors.1.force_kn", "--for", "governing_fos=1.3", "--to", "300", self.write(text))[1]
        self.assertIn(f"governing_fos ≥ 1.3 from {low:.10f} to {high:.10f}; below 1.3 before and after", report)
        self.assertIn("design value: 24.43 kN, the least rounded up, which gives governing_fos 1.3002; above 63.5788 kN is too much",
                      report)

    def test_page(self):
        """docs/loads.md prints what comes of its first command."""
        page = (ROOT / "docs/loads.md").read_text(encoding="utf-8").partition("## Support")[2]
        report = run("solve", "--find", "loads.anchors.1.force_kn", "--for", "governing_fos=1.3", "examples/slope/anchored_block.yaml")[1]
        self.assertIn(f"```text\n{report}```", page)

    def test_no_design(self):
        """No force is needed where the factor is there without; one that suffices against toppling alone is no design; and a
        lining has one in kPa, here against sliding, by hand."""
        text = scene(anchors("at: [0, 8/3], dip_deg: 15, force_kn: 30, passive: true"))
        told = self.found(text, "fos=0.5")
        self.assertEqual([(own["low"], own["begins"]) for own in told["at_least"]], [(0, False)])
        self.assertNotIn("design", told)
        self.assertIn("no design value: fos is above 0.5 already with the least that was tried, 0 kN",
                      run("solve", "--find", "loads.anchors.1.force_kn", "--for", "fos=0.5", self.write(text))[1])
        self.assertNotIn("design", self.found(text, "sliding_fos=1.2"))  # where it still topples
        low = scene("support_pressures: [{from: [0, 1], to: [0, 0], kpa: 10}]", slab=(3, 1), water="water: {height: 1}")
        told = self.found(low, "sliding_fos=1.8", key="loads.support_pressures.1.kpa")
        weight = 3 * 26
        kpa = 1.8 * (weight * math.sin(DIP) + 9.81 / 2 * math.cos(DIP)) - weight * math.cos(DIP) * FRICTION
        self.assertAlmostEqual(told["at_least"][0]["low"], kpa, delta=1e-9)
        self.assertTrue(kpa < told["design"] < kpa + 0.01)

    def test_bad_input(self):
        for bolt, message in (
                ("at: [0, 1], dip_deg: 15, force_kn: 1, length: 1", "its way through it to the rock is 1.55572 m; give a greater"),
                ("at: [0, 1], dip_deg: 15, towards: left, force_kn: 1, length: 9", "leaves the block where no rock is"),
                ("at: [0, 3.9], dip_deg: -80, force_kn: 1, length: 9", "leaves the block where no rock is"),
                ("at: [0, 1], dip_deg: 15, force_kn: 1, spacing: 0", "spacing must be above zero"),
                ("at: [0, 1], dip_deg: 15, force_kn: 9, capacity_kn: 8", "a force of 9 kN is more than the capacity of this bolt, 8 kN"),
                ("at: [0, 1], dip_deg: 15, capacity_kn: 8", "give its 'force_kn', or say 'passive: true'"),
                ("at: [0, 1], dip_deg: 15", "'force_kn' is missing here"),
                ("at: [0, 5], dip_deg: 15, force_kn: 1", "lies outside its outline"),
                ("at: [0, 1], dip_deg: 15, force_kn: 1, rows: 3, row_step: [0, -0.6]", "row 3 of these bolts"),
                ("at: [0, 1], dip_deg: 15, force_kn: 1, rows: 3", "'row_step: [dx, dy]'"),
                ("at: [0, 1], dip_deg: 15, force_kn: 1, rows: 1.5", "rows must be a whole number from 1 to 1000"),
                ("at: [0, 1], dip_deg: 91, force_kn: 1", "dip_deg must lie in [-90°, 90°]"),
                ("at: [0, 1], dip_deg: 15, direction_deg: -40, force_kn: 1", "give one of them"),
                ("at: [0, 1], force_kn: 1", "a bolt has its 'dip_deg'"),
                ("at: [0, 1], direction_deg: -40, towards: left, force_kn: 1", "'towards' goes with 'dip_deg'"),
                ("at: [0, 1], dip_deg: 15, towards: up, force_kn: 1", "towards must be left or right")):
            self.assertIn(message, self.refused(anchors(bolt)), bolt)
        self.assertIn("say where this bolt goes to", self.refused(anchors(BOLT + ", force_kn: 1"), place="tilt: {angle_deg: 5}\n"))
        level, lying = "outline: [[0, 0], [2, 0], [2, 3], [0, 3]]", "outline: [[0, 0], [2, 1], [1, 3], [-1, 2]]"
        for slab, bolt, message in ((level, "at: [0, 1], dip_deg: 15", "say where this bolt goes to"),
                                    (lying, "at: [0, 2], dip_deg: -80", "taken to go up-dip, leaves the block where no rock is behind it")):
            self.assertIn(message, self.refused(anchors(bolt + ", force_kn: 1"), place="frame: world\n", slab=slab, water=""))
        for words, message in ((("--least-force",), "--least-force goes with --find"),):
            self.assertIn(message, run("solve", *words, self.write(scene(anchors(BOLT + ", force_kn: 80"))))[2])
        for passive, key, message in ((", passive: true", "force_kn", "name that key instead, or give it a 'force_kn' too"),
                                      ("", "force_kn", "give any to begin with, 'force_kn: 1'")):
            path = self.write(scene(anchors(BOLT + ", capacity_kn: 200" + passive)))
            status, _, err = run("solve", "--find", f"loads.anchors.1.{key}", "--for", "governing_fos=1.05", path)
            self.assertEqual(status, 3)
            self.assertIn(message, err)
        path = self.write(scene(anchors(BOLT + ", force_kn: 80")))
        self.assertIn("find loads.anchors.N.force_kn", " ".join(run("solve", "--find", "friction_angle_deg", "--for", "governing_fos=2",
                                                                    "--least-force", path)[2].split()))


main()
