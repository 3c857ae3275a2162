# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What the tests of verdicts share: block E, and claims about it that are verified."""

import json
import pathlib
import random
import tempfile
import unittest
from fractions import Fraction

import exact
import notation
from harness import run

SCENE = ("topple: 1\nlength_unit: mm\nparameters: {a: 30, b: 120, c: 5}\nblock:\n"
         "  teeth: {count: 3, width: a, height: b, depth: c, left_end: peak}\ntilt: {towards: left}\n")
HEAD = "topple_claims: 1\ngeometries: {e: {scene: scene.yaml}, round: {scene: scene.yaml, rounded: true}}\n"
A1_4 = "tan^-1((27ab + 14ac)/(9b^2 - 3c^2))"


# Number of sub-blocks and kind of the left end of the paper's geometries.
TEETH = {"a_peak": (3, "peak"), "a_valley": (3, "valley"), "b_peak": (3, "peak"),
         "b_valley": (3, "valley"), "c": (4, "valley"), "d": (4, "peak"), "e_peak": (3, "peak"),
         "e_valley": (3, "valley"), "f": (2, "valley"), "g": (2, "peak")}


class Block:
    """A toothed block at random rational values, its moments by Python's rationals: from the outline
    (fans of triangles) for the resultant, from its slabs and triangles for the sums of Appendix A."""

    def __init__(self, geometry):
        self.rounded = geometry.endswith("_round")
        count, self.end = TEETH[geometry.removesuffix("_round")]
        rational = lambda low, high: Fraction(random.randint(low * 97, high * 97), 97)
        self.a, self.b, self.c = rational(10, 30), rational(90, 200), rational(3, 8)
        self.alpha, self.i = notation.Angle(rational(1, 9) / 40), notation.Angle(rational(1, 9) / 60)
        self.r = rational(1, 3)
        ring = exact.teeth(count, self.a, self.b, self.c, self.end)
        gx, gy = exact.centroid(exact.block_moments(ring))
        self.sharp = ring[0]
        self.x_arm, self.y_arm = gx - self.sharp[0], gy - self.sharp[1]
        self.slope = 1 if self.end == "valley" else -1
        self.elements = []  # area, x and y of the centroid: slabs, then triangles, the farthest first
        for k in reversed(range(count)):
            self.elements.append((self.a * self.b, (k + Fraction(1, 2)) * self.a, self.c + self.b / 2))
        for k in reversed(range(count)):
            low = k if ring[k][1] == 0 else k + 1  # the joint that the triangle reaches down to
            inner = Fraction(1, 3) if low == k else Fraction(2, 3)
            self.elements.append((self.a * self.c / 2, (k + inner) * self.a, 2 * self.c / 3))
        self.weights = [rational(1, 9) for _ in self.elements]

    def values(self):
        names = {"a": self.a, "b": self.b, "c": self.c, "r": self.r, "alpha": self.alpha, "i": self.i,
                 "alpha_phys": self.alpha, "delta_P": self.i, "delta_V": self.i.complement(),
                 "delta_v": self.i.complement()}
        names.update({f"w_{k + 1}": w for k, w in enumerate(self.weights)})
        return names

    def axis(self):
        """The pivot, moved along the facet where the corner is rounded."""
        x, y = self.sharp
        if self.rounded:
            x, y = x + self.r * self.i.cos, y + self.slope * self.r * self.i.sin
        return x, y

    def sums(self, weights):
        """Stabilising and overturning moments, each component on the side where the sharp corner
        has it."""
        (px, py), stabilising, overturning = self.axis(), 0, 0
        for weight, (_, x, y) in zip(weights, self.elements):
            stabilising += weight * (x - px) * self.alpha.cos
            if y >= self.sharp[1]:
                overturning += weight * (y - py) * self.alpha.sin
            else:
                stabilising -= weight * (y - py) * self.alpha.sin
        return stabilising, overturning

    def quantity(self, name):
        (px, py), (sx, sy) = self.axis(), self.sharp
        x, y = self.x_arm + sx - px, self.y_arm + sy - py
        areas = [e[0] for e in self.elements]
        if name == "critical_angle":
            return x / y
        if name == "fos":
            return x / y * self.alpha.cos / self.alpha.sin
        if name == "fos_elements":
            stabilising, overturning = self.sums(areas)
            return stabilising / overturning
        if name in ("stabilising_moment", "overturning_moment"):
            return self.sums(self.weights)[name == "overturning_moment"]
        length = ((self.x_arm * self.alpha.cos - self.y_arm * self.alpha.sin)
                  / (self.i.cos * self.alpha.cos - self.slope * self.i.sin * self.alpha.sin))
        if name == "rounding_length":
            return length
        if name == "corner_radius":  # tan((90 - slope i) / 2)
            return length * (1 - self.slope * self.i.sin) / self.i.cos
        raise KeyError(name)


class ClaimsCase(unittest.TestCase):
    """Claims written for the test, about block E towards its peak."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name)
        (self.path / "scene.yaml").write_text(SCENE)

    def tearDown(self):
        self.folder.cleanup()

    def verify(self, claims, head=HEAD):
        (self.path / "claims.yaml").write_text(head + "claims:\n" + claims)
        return run("verify", "--json", "claims.yaml", folder=self.path)

    def claim(self, quantity, printed, more="geometry: e", head=HEAD):
        """The result of one claim."""
        status, out, err = self.verify(f"- {{id: x, where: here, quantity: '{quantity}', printed: "
                                       f"'{printed}', {more}}}\n", head)
        self.assertEqual(err, "")
        result = json.loads(out)["claims"][0]
        self.assertEqual(status, 1 if result["verdict"] in ("refuted", "disagrees") else 0)
        return result

    def refuse(self, claims, message, head=HEAD):
        status, out, err = self.verify(claims, head)
        self.assertEqual((status, out), (3, ""), err)
        self.assertIn(message, err)
        self.assertEqual(err.count("\n"), 1)
