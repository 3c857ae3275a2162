# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What shaking overturns a block: ranges of a factor, islands, of which nothing is told but what was run. A search by halves said
that a boulder is overturned by 1.086 times its record at the least; it is by 1.075 as well."""

import json
import pathlib
import tempfile
import unittest

from harness import ROOT, main, run
from rocking_case import PULSE, SLAB, overturns

BOULDER = ROOT / "examples" / "shaken_boulder.yaml"


class Overturning(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.scene = pathlib.Path(holder.name) / "scene.yaml"

    def told(self, scene, *words):
        status, out, err = run("tilt", "--json", "--moments", "2", "--overturning", *words, scene)
        self.assertEqual(status, 0, err)
        return json.loads(out)["cases"][0]

    def test_islands_of_a_full_sine(self):
        """A whole sine overturns a slab after one impact, or by stronger shaking before any, and spares it between: Housner's
        equation of rocking, integrated here, finds it overturned within each range and spared beside it; nothing else is
        told of the 35 factors."""
        self.scene.write_text(SLAB + PULSE.format(form="full_sine", f=1.5))
        own = self.told(self.scene, "--factors", "1:4:35")
        self.assertEqual(own["overturning_tried"], [{"from": 1, "to": 4, "count": 35}])
        ranges = own["overturning_ranges"]
        self.assertEqual(len(ranges), 2)
        for one in ranges:
            for key, share, outcome in (("spared_below", 1 - 5e-4, False), ("least", 1 + 5e-4, True),
                                        ("most", 1 - 5e-4, True), ("spared_above", 1 + 5e-4, False)):
                if one[key] is not None:
                    self.assertEqual(overturns(0.5 * one[key] * share, 1.5, 1), outcome, (key, one))
        for k in range(0, 35, 2):
            factor = 4 ** (k / 34)
            within = any(one["least"] <= factor <= one["most"] for one in ranges)
            self.assertEqual(overturns(0.5 * factor, 1.5, 1), within, factor)
        self.assertIsNone(ranges[-1]["spared_above"])
        first = ranges[0]
        self.assertEqual(own["overturning_factor"], {"spared_by": first["spared_below"], "overturned_by": first["least"]})

    def test_halves_missed_an_island(self):
        """Halving 1 and 1.189, the first of quarter octaves that overturns it, ends at 1.0857: there is an island below, and each
        end of each range is what a run of its own says. The default looks closely at the octave below the least it finds."""
        rebounds = ("--set", "tilt_test.restitution=0.3")
        halves = [1, 2 ** 0.25]

        def overturned(factor):
            scaled = f"shaking.horizontal.record.scale={1.5 * factor!r}"
            status, out, err = run("tilt", "--json", "--moments", "2", *rebounds, "--set", scaled, BOULDER)
            self.assertEqual(status, 0, err)
            return json.loads(out)["cases"][0]["end"] in ("overturned", "left its base")

        while halves[1] - halves[0] > 1e-3 * halves[1]:
            middle = sum(halves) / 2
            halves[overturned(middle)] = middle
        self.assertAlmostEqual(halves[1], 1.0857, delta=1e-4)
        own = self.told(BOULDER, *rebounds)
        self.assertLess(own["overturning_factor"]["overturned_by"], 1.075)
        coarse, fine = own["overturning_tried"]
        self.assertEqual(coarse, {"from": 1 / 16, "to": 16, "count": 65})
        self.assertLessEqual(fine["from"], 0.505 * own["overturning_factor"]["overturned_by"])
        self.assertLess((fine["to"] / fine["from"]) ** (1 / (fine["count"] - 1)), 1.0055)
        self.assertGreaterEqual(len(own["overturning_ranges"]), 3)
        for one in own["overturning_ranges"]:
            for key in ("spared_below", "least", "most", "spared_above"):
                if one[key] is not None and one[key] < 2:
                    self.assertEqual(overturned(one[key]), key in ("least", "most"), one)
            for below, above in (("spared_below", "least"), ("most", "spared_above")):
                if one[below] and one[above]:
                    self.assertLess(one[above] / one[below], 1.0011)

    def test_words_claim_what_was_tried(self):
        self.scene.write_text(SLAB + PULSE.format(form="full_sine", f=1.5))
        for factors, words in (("0.1:0.5:5", ("5 from 0.1 to 0.5, 50 % apart", "None of them overturns it")),
                               ("3.8:4:2", ("3.8 to 4, all those tried",)),
                               ("1:4:35", ("The least of them is", "not overturned by", "the greatest tried", "less may overturn",
                                           "--factors tries more"))):
            status, out, err = run("tilt", "--overturning", "--factors", factors, self.scene)
            self.assertEqual(status, 0, err)
            for word in words:
                self.assertIn(word, " ".join(out.split()))
            self.assertLessEqual(max(map(len, out.splitlines())), 80, out)
        none = self.told(self.scene, "--factors", "0.1:0.5:5")
        self.assertNotIn("overturning_factor", none)
        self.assertEqual(none["overturning_ranges"], [])

    def test_refused(self):
        for factors in ("1:2", "2:1:5", "0:1:5", "1:2:1", "1:2:100001", "1:inf:5", "a:2:3", "1:2:3x"):
            status, _, err = run("tilt", "--overturning", "--factors", factors, BOULDER)
            self.assertEqual(status, 2, factors)
            self.assertIn("--factors takes FROM:TO:COUNT", err)
        status, _, err = run("tilt", "--factors", "1:2:3", BOULDER)
        self.assertEqual(status, 2)
        self.assertIn("--overturning, which is missing", err)


if __name__ == "__main__":
    main()
