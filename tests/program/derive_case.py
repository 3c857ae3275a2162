# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What the tests of derivations share: formulas evaluated in rationals, and scenes derived."""

import json
import math
import pathlib
import random
import tempfile
import unittest
from fractions import Fraction

from harness import run

TEETH = ("topple: 1\nlength_unit: mm\nparameters: {a: 30, b: 120, c: 5}\nblock:\n"
         "  teeth: {count: %d, width: a, height: b, depth: c, left_end: %s}\ntilt: {towards: left}\n")


def value(formula, values):
    """A derived polynomial at rational values, by Python's own arithmetic."""
    return Fraction(eval(formula.replace("^", "**"), {"__builtins__": {}}, values))


def quotient(fraction, values):
    return value(fraction["numerator"], values) / value(fraction["denominator"], values)


class DeriveCase(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.scene = pathlib.Path(self.folder.name) / "scene.yaml"

    def tearDown(self):
        self.folder.cleanup()

    def derive(self, text, *options):
        self.scene.write_text(text)
        status, out, err = run("derive", "--json", *options, self.scene)
        self.assertEqual((status, err), (0, ""))
        return json.loads(out)

    def random_polygon(self, count):
        """A star-shaped polygon whose coordinates are expressions in p, q and r, with their values."""
        values = {n: Fraction(random.randint(50, 150), 100) for n in "pqr"}
        names = list(values)
        while True:
            angles = sorted(random.uniform(0, 2 * math.pi) for _ in range(count))
            gaps = [b - a for a, b in zip(angles, angles[1:] + [angles[0] + 2 * math.pi])]
            if max(gaps) < 3 and min(gaps) > 0.02:
                break
        texts = []
        for angle in angles:
            radius = random.randint(600, 1000)
            pair = []
            for part in (math.cos(angle), math.sin(angle)):
                number = Fraction(round(radius * part), 100)
                name, other = random.choice(names), random.choice(names)
                form = random.choice([f"{number}*{name}", f"({number})*{name}/{other}",
                                      f"{number} + {name} - {other}", f"{number}"])
                pair.append(form)
            texts.append(pair)
        return values, texts

    def family(self, text):
        self.scene.write_text(text)
        status, out, err = run("derive", "--for-all", "count", "--json", self.scene)
        self.assertEqual((status, err), (0, ""))
        return json.loads(out)
