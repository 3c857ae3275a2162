# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What is proven holds on the whole domain: roots, magnitudes, inverse functions and divisors, by
evaluation in Python's rationals on both sides of every zero."""

import json
import math
import pathlib
import random
import tempfile
import unittest
from fractions import Fraction

from harness import main, run

SLAB = ("topple: 1\nlength_unit: m\nparameters: {a: %s, b: %s}\nblock: {slab: {width: 5 + 0*a, height: 7 + 0*b}}\n"
        "base: {mated: true}\ntilt: {towards: left}\n")


class Polynomial:
    """In a and b with small whole coefficients: as text, and as a function."""

    def __init__(self, terms):
        self.terms = terms  # (coefficient, power of a, power of b)

    def text(self):
        return "(" + " ".join(f"{'-' if c < 0 else '+'} {abs(c)}*a^{i}*b^{j}" for c, i, j in self.terms) + ")"

    def __call__(self, a, b):
        return sum(c * a ** i * b ** j for c, i, j in self.terms)

    @staticmethod
    def random():
        """Lines, products of lines and sums of squares: with zeros on one side, on both, and nowhere."""
        kind = random.randrange(6)
        c = lambda: random.choice((-3, -2, -1, 1, 2, 3))
        if kind == 0:
            return Polynomial([(1, 1, 0), (-random.randint(1, 4), 0, 0)])
        if kind == 1:
            return Polynomial([(c(), 1, 0), (c(), 0, 1)])
        if kind == 2:
            return Polynomial([(1, 2, 0), (-1, 1, 1), (1, 0, 2)])
        if kind == 3:
            return Polynomial([(1, 2, 0), (random.randint(-4, 0), 1, 0), (random.randint(1, 5), 0, 0)])
        if kind == 4:
            return Polynomial([(random.randint(1, 3), 1, 1), (random.randint(1, 3), 0, 1)])
        return Polynomial([(c(), random.randint(0, 2), random.randint(0, 2)) for _ in range(3)])


def magnitude(p):
    """|p| in one of the spellings that have it: as text and function."""
    text = p.text()
    return random.choice((f"sqrt({text}^2)", f"abs({text})", f"({text}^2)^(1/2)", f"sqrt({text}^6)^(1)/{text}^2",
                          f"sqrt(4*{text}^4/({text}^2))/2", f"abs(-abs({text}))", f"({text}^4)^(1/2)/abs({text})"))


# Both sides of zeros of lines with small coefficients, the zeros themselves, and far away.
GRID = sorted({Fraction(n, d) for n in range(1, 10) for d in (1, 2, 3)} | {Fraction(1, 100), Fraction(50)})


class Domain(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def verify(self, claims, scene=(1, 2), head=""):
        """Verdicts on [(quantity, printed, more)…]."""
        (self.path / "scene.yaml").write_text(SLAB % scene)
        text = "topple_claims: 1\ngeometries: {e: {scene: scene.yaml}}\n" + head + "claims:\n" + "".join(
            f"- {{id: x{k}, where: here, geometry: e, quantity: '{q}', printed: '{p}'{more}}}\n"
            for k, (q, p, more) in enumerate(claims))
        (self.path / "claims.yaml").write_text(text)
        status, out, err = run("verify", "--json", "claims.yaml", folder=self.path)
        self.assertIn(status, (0, 1), err)
        return json.loads(out)["claims"]

    def test_random_magnitudes(self):
        """|p| in many spellings against p, -p and |p|, in a domain of all positive values and in
        bounded ones: what is proven is true at every point of the grid within the domain, true ones
        of p without a zero are proven, and so is |p| = |p| in any two spellings without divisors."""
        random.seed(7)
        domains = (("", lambda a, b: True), (", domain: {a: [1/2, 3]}", lambda a, b: Fraction(1, 2) < a < 3),
                   (", domain: {b: [a, inf]}", lambda a, b: b > a),
                   (", domain: {b: [1, 4], a: [0, b]}", lambda a, b: 1 < b < 4 and a < b))
        claims, truths = [], []
        for _ in range(360):
            p, q, (more, holds) = Polynomial.random(), Polynomial.random(), random.choice(domains)
            left, right = magnitude(p), random.choice((p.text(), f"-{p.text()}", f"abs({p.text()})"))
            other = random.choice(("0", q.text(), f"abs({q.text()})"))
            points = [(a, b) for a in GRID for b in GRID if holds(a, b)]
            signs = {(v > 0) - (v < 0) for v in (p(a, b) for a, b in points)}
            wrong = {"-": 1, "(": -1, "a": None}[right[0]]
            true = wrong not in signs and not (0 in signs and "/" in left.replace("(1/2)", ""))
            claims.append((f"{left}*(1 + a^2) + {other}", f"{right}*(1 + a^2) + {other}", more))
            truths.append((true, wrong, signs, p))
        seen = {}
        for claim, (true, wrong, signs, p) in zip(self.verify(claims), truths):
            self.assertFalse(wrong in signs and claim["verdict"] == "proven", claim)
            if claim["verdict"] == "refuted":  # at values between those of the grid, it may be
                at = {n: Fraction(v) for n, v in (part.split(" = ") for part in claim["at"].split(", "))}
                self.assertEqual(wrong, 1 if p(**at) > 0 else -1, claim)
            key = (true, claim["verdict"])
            seen[key] = seen.get(key, 0) + 1
        self.assertGreater(seen.get((True, "proven"), 0), 100, seen)
        self.assertGreater(sum(n for (true, verdict), n in seen.items() if verdict != "proven"), 60, seen)

    def test_every_scene_value(self):
        """The verdict on a root does not depend on which side of its zero the scene happens to be."""
        for a in ("1/2", "1", "3/2", "7"):
            found = [c["verdict"] for c in self.verify(
                [("a*b", "a*b + sqrt((a-1)^2) - (a-1)", ""), ("a*b", "a*b + abs(a-1) - (a-1)", ""),
                 ("a*b", "a*b + abs(1-a) + (a-1)", ""), ("abs(a-1)", "sqrt((1-a)^2)", ""),
                 ("a*b", "a*b + abs(abs(a-1)-2) - 2 + abs(a-1)", ""),
                 ("abs(a-2)*sqrt((b-1)^2)", "abs((a-2)*(b-1))", ""),
                 ("a*b", "a*b*(a-1)/(a-1)", ""), ("sqrt(a^2)", "a", ""), ("sqrt((a-b)^4)", "(a-b)^2", ""),
                 ("sqrt((a^2-a+1)^2)", "a^2-a+1", ""), ("sqrt((a^2-a*b+b^2)^2)", "a^2-a*b+b^2", ""),
                 ("a*b", "a*b*(a+1)/(a+1)", "")], (a, 2))]
            for k in (0, 1, 2, 4, 6):
                self.assertNotEqual(found[k], "proven", (a, k))
            for k in (3, 5, 7, 8, 9, 10, 11):
                self.assertEqual(found[k], "proven", (a, k))
            self.assertEqual(found[6], "undecided" if a == "1" else "agrees")

    def test_a_condition_says_where(self):
        """A formula that holds about the claim's values alone says where it holds and where not; a
        stated domain makes it proven, or refuted."""
        near, inside, outside = self.verify(
            [("sqrt((a-2)^2)", "2-a", ""), ("sqrt((a-2)^2)", "2-a", ", domain: {a: [0, 2]}"),
             ("sqrt((a-2)^2)", "2-a", ", domain: {a: [0, 5]}")])
        self.assertEqual([near["verdict"], inside["verdict"], outside["verdict"]],
                         ["agrees", "proven", "refuted"])
        self.assertIn("it holds where a - 2 <= 0", near["condition"])
        self.assertIn("it fails at a = ", near["condition"])
        ordered = self.verify([("sqrt((a-b)^2)", "b-a", ", domain: {b: [a, inf]}")])[0]
        self.assertEqual(ordered["verdict"], "proven")
        zero, other = self.verify([("a*b", "a*b*(a-1)/(a-1)", ""), ("a*b", "a*b*(a-2)/(a-2)", "")])
        self.assertEqual((zero["verdict"], other["verdict"]), ("undecided", "agrees"))
        self.assertIn("no value at the values of the claim", zero["condition"])
        self.assertEqual(other["condition"], "an identity except where a - 2 = 0")

    # Angles x and y in (0, 90) degrees: text, and the same in Python; a rational multiple at the end.
    ANGLES = (("x", lambda x, y: x), ("x + 180", lambda x, y: x + 180), ("x + y", lambda x, y: x + y),
              ("2*x", lambda x, y: 2 * x), ("x - y", lambda x, y: x - y), ("-x", lambda x, y: -x),
              ("90 - x", lambda x, y: 90 - x), ("3*x", lambda x, y: 3 * x), ("x/2", lambda x, y: x / 2),
              ("x/2 + y/2", lambda x, y: (x + y) / 2), ("180 - x", lambda x, y: 180 - x))

    def test_inverse_functions(self):
        """atan(tan z) = z is proven where z stays within 90 degrees, and nowhere else."""
        angles = "angles: {x: 20, y: 30}\n"
        claims = [(text, f"atan(tan({text}))", "") for text, _ in self.ANGLES]
        claims += [("x", "atan(tan(x + 180))", ""), ("x + 180", "x", ""), ("2*x", "atan(2*tan(x)/(1 - tan(x)^2))", ""),
                   ("x", "atan(sin(x)/cos(x))", ""), ("x", "2*atan((1 - cos(x))/sin(x))", ""),
                   ("x/2", "atan((1 - cos(x))/sin(x))", ""), ("x", "90 - atan(cot(x))", ""),
                   ("x + y", "atan((tan(x) + tan(y))/(1 - tan(x)*tan(y)))", ", domain: {x: [0, 45], y: [0, 45]}"),
                   ("x + y", "atan((tan(x) + tan(y))/(1 - tan(x)*tan(y)))", ""),
                   ("sqrt((cos(x) - sin(x))^2)", "cos(x) - sin(x)", ""),
                   ("sqrt((cos(x) - sin(x))^2)", "cos(x) - sin(x)", ", domain: {x: [0, 45]}"),
                   ("sqrt((1 - sin(x))^2)", "1 - sin(x)", ""), ("abs(sin(x))", "sin(x)", ""),
                   ("abs(sin(2*x))", "2*sin(x)*cos(x)", ""), ("abs(cos(2*x))", "cos(2*x)", "")]
        found = self.verify(claims, head=angles)
        for claim, (text, function) in zip(found, self.ANGLES):
            inside = all(-90 < function(x, y) < 90 for x in range(1, 90, 4) for y in range(1, 90, 4))
            self.assertFalse(claim["verdict"] == "proven" and not inside, claim)
            if inside:
                self.assertEqual(claim["verdict"], "proven", claim)
        rest = [c["verdict"] for c in found[len(self.ANGLES):]]
        wanted = ["proven", "refuted", None, "proven", "agrees", "proven", "agrees", "proven", None, None,
                  "agrees", "agrees", "proven", "proven", None]
        for claim, verdict, want in zip(found[len(self.ANGLES):], rest, wanted):
            if want is None:
                self.assertNotEqual(verdict, "proven", claim)
            else:
                self.assertEqual(verdict, want, claim)

    def test_negative_and_zero_values(self):
        """A symbol takes the sign of its value; one that is zero may have any."""
        verdict = lambda q, p, scene: self.verify([(q, p, "")], scene)[0]["verdict"]
        self.assertEqual(verdict("sqrt(a^2)", "a", (1, 2)), "proven")
        self.assertEqual(verdict("sqrt(a^2)", "-a", (-1, 2)), "proven")
        self.assertEqual(verdict("sqrt(a^2*b^2)", "-a*b", (-1, 2)), "proven")
        self.assertNotEqual(verdict("sqrt(a^2)", "a", (0, 2)), "proven")
        self.assertEqual(verdict("sqrt(a^2)", "abs(a)", (0, 2)), "proven")

    def test_numbers_at_their_own_values(self):
        """The sign of a root in a number is that at the claim's values, not the scene's: sqrt((a-2)^2)
        is 1 at a = 3, exactly half a unit from 0.5 and 1.5 to no digit."""
        claims = [("sqrt((a-2)^2)/2", "0.5", ", at: {a: 3}"), ("sqrt((a-2)^2)/2 + 1", "1", ", at: {a: 3}"),
                  ("sqrt((a-2)^2)/2 + 1", "2", ", at: {a: 3}"), ("sqrt((a-2)^2)/2 + 1", "< 1.5", ", at: {a: 3}"),
                  ("abs(a-2)/2 + 1", "<= 1.5", ", at: {a: 3}")]
        self.assertEqual([c["verdict"] for c in self.verify(claims)],
                         ["agrees", "agrees", "agrees", "disagrees", "agrees"])

    def test_wrong_domains(self):
        for more, message in ((", domain: {a: 1}", "a domain is two ends"), (", domain: [a]", "'domain' is a map of names"),
                              (", domain: {a: [2, 3]}", "the claim's value of 'a' lies outside this domain"),
                              (", domain: {area: [2, 3]}", "'area' is not a symbol that takes a value"),
                              (", domain: {a: [0, q]}", "unknown name 'q'"),
                              (", domain: {a: [0, sqrt(2)]}", "the end of a domain is a number"),
                              (", domain: {alpha: [0, inf]}", "the domain of an angle is two numbers")):
            (self.path / "scene.yaml").write_text(SLAB % (1, 2))
            (self.path / "claims.yaml").write_text(
                "topple_claims: 1\ngeometries: {e: {scene: scene.yaml}}\nclaims:\n"
                f"- {{id: x, where: here, geometry: e, quantity: area, printed: a*b{more}}}\n")
            status, out, err = run("verify", "claims.yaml", folder=self.path)
            self.assertEqual((status, out), (3, ""), more)
            self.assertIn(message, err)


if __name__ == "__main__":
    main()
