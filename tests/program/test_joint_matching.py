# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""`joint: {matching: …}`: the least shift at which a block matches its base as little as is asked for: on regular teeth by
a formula, where the matching leaps too; on irregular undersides by stating the shift that was found, and those before it."""

import random
from fractions import Fraction

from harness import main, run, solve
from joint_case import A, C, SEED, JointCase, text, underside


class Matching(JointCase):
    def test_matching_of_teeth(self):
        """All gaps stay within a closure e up to a shift of a e/(2c), where the matching leaps from 1 to 1/2 + e/(4c);
        then it falls by 1/(2a). The shift found is the least but for 1/1024 of the closure."""
        closure = Fraction(3, 10)
        leap = A * closure / (2 * C)
        for sought, side in ((Fraction(3, 4), 1), (Fraction(3, 10), 1), (Fraction(9, 20), -1), (Fraction(11, 100), -1)):
            truth = leap if sought > Fraction(1, 2) else A * (1 - 2 * sought + closure / C)
            joint = f"{{matching: {sought}, closure: {closure}, towards: {'right' if side > 0 else 'left'}}}"
            with self.subTest(sought=sought):
                found = self.teeth(joint=joint)["joint"]
                shift, before = (Fraction(found[key]["value"]) * side * 1000 for key in ("shift_m", "shift_before_m"))
                self.assertLessEqual(found["matching"]["value"], float(sought) + 1e-15)
                self.assertGreater(found["matching_before"]["value"], float(sought))
                self.assertLessEqual(abs(shift - truth), closure / 1000)
                self.assertLess(before, shift)
                self.same(found["matching_sought"], sought, 1)
                if sought > Fraction(1, 2):
                    self.assertEqual(found["matching_before"]["value"], 1)
                    self.assertAlmostEqual(found["matching"]["value"], float(1 / Fraction(2) + closure / (4 * C)), delta=1e-4)
        self.assertEqual(self.teeth(joint="{matching: 1, closure: 1}")["joint"]["shift_m"]["value"], 0)

    def test_matching_of_others(self):
        """What is found for an irregular underside is what the same shift gives when it is stated, and so is what matches
        just before it; none of the shifts on the way there, a closure or a sixteenth apart, matches as little."""
        draw = random.Random(SEED + 2)
        done = 0
        while done < 4:
            under = underside(draw)
            block = f"outline: {text(under + [(under[-1][0], Fraction(3)), (under[0][0], Fraction(3))])}"
            base, closure = "{beyond: {left: 2, right: 2}}", Fraction(1, 20)
            self.write(block, base, joint=f"{{matching: 0.4, closure: {closure}}}")
            ended, _, err = run("solve", self.path)
            if ended != 0:
                self.assertIn("still matches", err)
                continue
            done += 1
            found = solve(self.path)["cases"][0]["joint"]
            with self.subTest(under=under):
                for own, key in ((found["shift_m"], "matching"), (found["shift_before_m"], "matching_before")):
                    shift = Fraction(round(Fraction(own["value"]) * 1000 * 2 ** 14 / closure), 2 ** 14) * closure
                    stated = self.case(block, base, joint=f"{{shift: {shift}, closure: {closure}}}")["joint"]
                    self.assertAlmostEqual(stated["matching"]["value"], found[key]["value"], delta=1e-14)
                self.assertLessEqual(found["matching"]["value"], 0.4)
                self.assertGreater(found["matching_before"]["value"], 0.4)
                way = closure
                while float(way) < found["shift_before_m"]["value"] * 1000:
                    stated = self.case(block, base, joint=f"{{shift: {way}, closure: {closure}}}")["joint"]
                    self.assertGreater(stated["matching"]["value"], 0.4)
                    way += max(closure, way / 16)


if __name__ == "__main__":
    main()
