# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The factor that governs is below 1 exactly where a motion can begin at the tilt, passes 1 without a leap, and names
what begins.

The stories are scenes that stood, for certain, under a factor below 1, and scenes whose factor leapt where they begin to
topple. By strength the truth is the verdict of the same scene with so much less, or more, of it: windows of motion,
which share nothing with the search for the factor. Whatever is found for governing_fos is solved again."""

import json
import math
import re

from governing_case import GoverningCase, slab
from harness import ROOT, main, run

SCENES = ROOT / "tests/data/governing"
DEGREE = math.pi / 180


def text_of(name):
    return (SCENES / f"{name}.yaml").read_text(encoding="utf-8")


def at_tilt(text, tilt):
    changed, count = re.subn(r"(tilt: .*angle_deg: )[0-9.]+", rf"\g<1>{tilt:.9f}", text)
    assert count == 1
    return changed


def with_strength(text, share):
    """All friction angles and the cohesion of a scene, tan(phi) and cohesion times a share."""
    def changed(match):
        angle = math.atan(share * math.tan(float(match[2]) * DEGREE)) / DEGREE
        return f"{match[1]}{angle:.12f}"

    text = re.sub(r"(friction_angle_deg: )([0-9.]+)", changed, text)
    text = re.sub(r"(facet: [0-9]+, angle_deg: )([0-9.]+)", changed, text)
    return re.sub(r"(cohesion_kpa: )([0-9.]+)", lambda m: f"{m[1]}{share * float(m[2]):.12f}", text)


class Law(GoverningCase):
    def case(self, text):
        (case,) = self.solve(text)
        return case

    def check_strength(self, text, case):
        """On both sides of the strength that the factor tells of, the verdict differs."""
        factor = self.by(case, "strength reduction")
        fos = factor["fos"]["value"]
        share = fos if factor["raised"] else 1 / fos
        stands = [self.case(with_strength(text, share * (1 + side)))["mechanism"] == "stands" for side in (-1e-6, 1e-6)]
        self.assertEqual(sum(stands), 1, (share, stands))

    def test_certain_to_stand(self):
        """Contact forces prevent the turn, or the slide, that the factor below 1 is about."""
        for name in ("behind_a_step", "behind_a_step_leaning", "facets_of_two_frictions", "pressed_behind_a_step"):
            with self.subTest(name):
                text = text_of(name)
                case = self.case(text)
                self.assertEqual(case["mechanism"], "stands")
                self.assertGreater(case["governing_fos"]["fos"]["value"], 1)
                moments = [f for f in case["factors"] if f["definition"] == "moments"]
                self.assertEqual((moments[0]["counts"], moments[0]["standing"]), (False, "prevented"))
                self.assertLess(moments[0]["fos"]["value"], 1)
                self.check_strength(text, case)
        report = run("solve", self.scene(text_of("behind_a_step")))[1]
        self.assertIn("(excluded: another motion begins first)", report)

    def test_static_state(self):
        """Under its earthquake the block stands between two windows of motions; without it, it can move. An earthquake that holds a
        block is no support: the state without it governs, and a caution says so."""
        text = text_of("between_two_windows")
        self.assertEqual(self.case(text)["mechanism"], "may move")
        status, out, _ = run("solve", "--fail-below", "1", self.scene(text))
        self.assertEqual(status, 1)
        self.assertRegex(out, r"the state without the\s+earthquake\s+governs")
        alone = self.case(re.sub(r" *seismic: .*\n", "", text))
        self.assertEqual(alone["governing_fos"], self.case(text)["governing_fos"])

    def test_half_on_clay(self):
        """On facets of two frictions no one of them has the whole load. It slides from 21.8 degrees on, whatever the
        shares, and its factor is 1 there and nowhere before."""
        text = text_of("half_on_clay")
        case = self.case(text)
        self.assertEqual(self.by(case, "shear strength")["standing"], "uneven")
        self.check_strength(text, case)
        onset = case["onset"]["critical_angle_deg"]["value"]
        before = None
        for tilt in (10, 15, 17.9, 18.1, 20, 21, onset - 1e-6):
            fos = self.case(at_tilt(text, tilt))["governing_fos"]["fos"]["value"]
            self.assertGreater(fos, 1)
            self.assertTrue(before is None or fos < before)
            before = fos
        self.assertLess(before - 1, 1e-6)

    def test_no_leap_at_toppling(self):
        """Moments tell how far beyond its toppling a block is, not the friction that would jam it."""
        for name, below, above in (("set_down_on_two_points", 24.26, 24.27), ("on_two_flanks", 18.3, 18.4)):
            for tilt in (below, above):
                case = self.case(at_tilt(text_of(name), tilt))
                angle = case["toppling"]["critical_angle_deg"]["value"]
                governing = case["governing_fos"]
                self.assertEqual((governing["mechanism"], governing["definition"]), ("topples", "moments"))
                truth = math.tan(angle * DEGREE) / math.tan(tilt * DEGREE)
                self.assertAlmostEqual(governing["fos"]["value"], truth, delta=1e-9)
                self.assertEqual(case["mechanism"] == "stands", truth > 1)
            strength = self.by(case, "strength reduction")
            self.assertEqual((strength["fos"], strength["fos_is"]), (None, "none: not certain to stand at any strength"))

    def test_find(self):
        """What is found for the governing factor gives that factor; what is found for another one says so."""
        scene = self.scene(text_of("anchored"), "anchored.yaml")
        key = "loads.anchors.1.force_kn"
        done, out, err = run("solve", "--find", key, "--for", "governing_fos=1.3", "--to", "200", "--json", scene)
        self.assertEqual(done, 0, err)
        found = json.loads(out)["find"]
        force = found["solutions"][0]
        self.assertEqual(found["governing"][0]["mechanism"], "slides")
        again = self.case(text_of("anchored").replace("force_kn: 10", f"force_kn: {force['value']!r}"))
        self.assertAlmostEqual(again["governing_fos"]["fos"]["value"], 1.3, delta=1e-9)
        done, out, err = run("solve", "--find", key, "--for", "fos=1.3", "--to", "200", scene)
        self.assertEqual(done, 0, err)
        self.assertIn("Caution: fos is not the governing factor there: FoS 1.149 against sliding", out)

    def test_shares_of_a_study(self):
        """Of samples as many are below 1 as can move."""
        folder = self.scene(slab(1, 2, 30, 22), "slab.yaml").parent
        study = folder / "study.yaml"
        study.write_text("topple_study: 1\nscene: slab.yaml\nsamples: 400\n"
                         "vary:\n  friction_angle_deg: {normal: {mean: 26, deviation: 6}}\n", encoding="utf-8")
        done, out, err = run("study", "--json", study)
        self.assertEqual(done, 0, err)
        result = json.loads(out)
        below = sum(f["below_1"] for f in result["governing_factors"])
        self.assertGreater(below, 0)
        stands = next(o["samples"] for o in result["tilts"][0]["outcomes"] if o["outcome"] == "stands")
        self.assertEqual(below + stands, 400)


if __name__ == "__main__":
    main()
