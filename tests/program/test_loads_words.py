# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Which loads a scene calls for, what the report says of them, and loads that are refused."""

import json
import math

from harness import main, run
from loads_case import G, LoadsCase, slab


class LoadsWords(LoadsCase):
    def test_limits(self):
        """Loads to nothing: the dry block, at first order."""
        dry = math.degrees(math.atan2(2, 5))
        for form in ("{seismic: {horizontal: %r}}", "{water: {height: 3, unit_weight_kn_m3: %r}}",
                     "{bond_kpa: %r}", "{anchors: [{at: [0, 4], direction_deg: 0, force_kn: %r}]}"):
            gaps = [self.solve(2.0, 5.0, form % size)["toppling"]["critical_angle_deg"]["value"] - dry
                    for size in (2e-4, 1e-4, 0)]
            self.assertAlmostEqual(gaps[2], 0, delta=1e-11)
            self.assertAlmostEqual(gaps[0] / gaps[1], 2, delta=1e-3)

    def test_only_what_is_called_for(self):
        """Each load is in the account of effects if and only if the scene calls for it, with its place, and
        changes no number of the block."""
        loads = {"seismic": "{seismic: {horizontal: 0.1}}", "water": "{water: {height: 1}}",
                 "pressure": "{pressures: [{from: [2, 0], to: [2, 5], kpa: 1}]}",
                 "surcharge": "{surcharges: [{from: [0, 5], to: [2, 5], kpa: 1}]}",
                 "anchor": "{anchors: [{at: [0, 4], direction_deg: 0, force_kn: 1}]}",
                 "bond": "{bond_kpa: 1}", "cohesion": "{cohesion_kpa: 1}"}
        blocks = []
        for name, text in loads.items():
            case = self.solve(2.0, 5.0, text, tilt=5)
            effects = {e["name"]: e["called_for_by"] for e in case["effects"]}
            self.assertEqual([n for n in loads if n in effects], [name])
            self.assertIn("scene.yaml:6:", effects[name])
            if name != "cohesion":  # which has no moment
                self.assertIn(name, [load["name"] for load in case["loads"]])
            blocks.append((case["block"], case["contact"]))
        self.assertEqual(blocks.count(blocks[0]), len(blocks))

    def test_support_and_yield(self):
        """Back-analysis: the yield acceleration of a slab is (b - h tan a) / (h + b tan a); the anchor for
        FoS 1.5 is F = (overturning - stabilising / 1.5) / z."""
        self.scene.write_text(slab(2.0, 4.0, "{seismic: {horizontal: 0.15}}", tilt=15))
        status, out, err = run("solve", "--json", "--find", "loads.seismic.horizontal", "--for", "fos=1", self.scene)
        self.assertEqual((status, err), (0, ""))
        t = math.tan(math.radians(15))
        found = json.loads(out)["find"]["solutions"]
        self.assertEqual(len(found), 1)
        self.assertAlmostEqual(found[0]["value"], (2 - 4 * t) / (4 + 2 * t), delta=1e-12)
        self.scene.write_text(slab(2.0, 5.0, "{anchors: [{at: [0, 4], direction_deg: 0, force_kn: 10}]}", tilt=20))
        status, out, err = run("solve", "--json", "--find", "loads.anchors.1.force_kn", "--for", "fos=1.5",
                               "--from", 0, "--to", 60, self.scene)
        self.assertEqual((status, err), (0, ""))
        weight, a = G * 10, math.radians(20)
        force = (weight * 2.5 * math.sin(a) - weight * math.cos(a) / 1.5) / 4
        self.assertAlmostEqual(json.loads(out)["find"]["solutions"][0]["value"], force, delta=1e-10)

    def refuse(self, loads, message, *options, text=None):
        self.scene.write_text(text or slab(2.0, 5.0, loads))
        status, out, err = run("solve", *options, self.scene)
        self.assertEqual((status, out), (3, ""), err)
        self.assertIn(message, err)
        self.assertIn("scene.yaml:", err)

    def test_bad_loads(self):
        self.refuse("{anchors: [{at: [3, 4], direction_deg: 0, force_kn: 1}]}", "'at' lies outside its outline")
        self.refuse("{anchors: [{at: [1, 4], direction_deg: 0, force_kn: -1}]}", "must not be negative")
        self.refuse("{anchors: [{at: [1, 4], force_kn: 1}]}", "an anchor its 'direction_deg'")
        self.refuse("{anchors: {at: [1, 4]}}", "anchors are a list")
        self.refuse("{pressures: [{from: [2, 0], to: [2, 5], kpa: [-1, 0]}]}", "a pressure must not be negative")
        self.refuse("{pressures: [{from: [2, 5], to: [2, 0], kpa: 1}]}", "this pressure would pull")
        self.refuse("{pressures: [{from: [2, 0], to: [0, 5], kpa: 1}]}", "does not act on an edge of the block")
        self.refuse("{surcharges: [{from: [0, 6], to: [2, 6], kpa: 1}]}", "does not act on an edge of the block")
        self.refuse("{water: {height: 6}}", "the water stands above the top of the block")
        self.refuse("{water: {uplift: true}}", "water needs 'height'")
        self.refuse("{seismic: {}}", "seismic needs 'horizontal' (k_h) or 'vertical' (k_v)")
        self.refuse("{sismic: {horizontal: 1}}", "did you mean 'seismic'?")
        self.refuse("{cohesion_kpa: -1}", "cohesion_kpa must not be negative")
        self.refuse("{seismic: {horizontal: 0.1}}", "leave out --elements", "--elements")
        tip = slab(2.0, 5.0, "{cohesion_kpa: 1}").replace(
            "tilt:", "base: {profile: [[-1, -1], [0, 0], [1, -1], [2, 0], [3, -1]]}\ntilt:")
        self.refuse(None, "touches its base only in points", text=tip)
        self.refuse(None, "give its 'unit_weight_kn_m3'",
                    text=slab(2.0, 5.0, "{bond_kpa: 1}").replace("  unit_weight_kn_m3: 26\n", ""))


if __name__ == "__main__":
    main()
