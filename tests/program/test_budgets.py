# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Inputs that once ran for minutes or filled the memory: an answer, or a message that says what was too
dear and what would help. The limits here are generous: they tell an end from a hang, and memory that is
bounded from memory that is not."""

import os
import pathlib
import random
import resource
import subprocess
import tempfile
import unittest

from harness import main

TOPPLE = os.environ["TOPPLE"]
SECONDS = 120  # a slow machine under a sanitizer; the budget is 5 s on a quiet one
BYTES = 1 << 30


def limited():
    """The address space of the program; a sanitizer's own is larger than any machine."""
    if "sanitize" not in TOPPLE:
        resource.setrlimit(resource.RLIMIT_AS, (2 * BYTES, 2 * BYTES))


def run(scene, *arguments):
    """Exit status, standard output and errors."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "scene.yaml")
        path.write_text(scene, encoding="utf-8")
        done = subprocess.run([TOPPLE, *arguments, str(path)], capture_output=True, text=True,
                              timeout=SECONDS, preexec_fn=limited, check=False)
    return done.returncode, done.stdout, done.stderr


def rough_slab(count, number):
    """`count` vertices below and above, each coordinate written by `number`."""
    lower = [(k + random.random() / 2, random.random()) for k in range(count // 2)]
    upper = [(count / 2 - k - random.random() / 2, 300 + random.random()) for k in range(count // 2)]
    outline = ", ".join(f"[{number(x)}, {number(y)}]" for x, y in lower + upper)
    return f"""topple: 1
length_unit: m
block:
  outline: [{outline}]
base: {{mated: true}}
friction_angle_deg: 30
tilt: {{towards: left, angle_deg: 5}}
"""


def coprime(value):
    """A fraction whose denominator of 15 digits has hardly a factor in common with another."""
    denominator = random.randrange(10**14, 10**15) | 1
    return f"{round(value * denominator)}/{denominator}"


class Coordinates(unittest.TestCase):
    """Exact coordinates share a denominator, whose digits grow with each vertex that brings its own."""

    def setUp(self):
        random.seed(12)

    def test_hundreds_of_coprime_denominators_are_solved(self):
        status, _, _ = run(rough_slab(300, coprime), "solve")
        self.assertEqual(status, 0)

    def test_thousands_are_refused_where_they_pass_the_budget(self):
        status, out, err = run(rough_slab(3000, coprime), "solve")
        self.assertEqual((status, out), (3, ""))
        self.assertIn("common multiple", err)
        self.assertIn("round the fractions", err)

    def test_their_account_by_elements_is_refused_sooner(self):
        status, out, err = run(rough_slab(1000, coprime), "solve", "--elements")
        self.assertEqual((status, out), (3, ""))
        self.assertIn("leave out --elements", err)

    def test_as_many_decimals_are_solved(self):
        status, _, _ = run(rough_slab(3000, lambda value: f"{value:.15f}"), "solve", "--elements")
        self.assertEqual(status, 0)


if __name__ == "__main__":
    main()
