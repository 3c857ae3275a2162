# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Derived formulas in C and LaTeX, and what a derivation may cost and may not be asked for."""

import ctypes
import json
import math
import subprocess
from fractions import Fraction

import exact
from derive_case import DeriveCase, TEETH, quotient
from harness import LONG, PROGRAM, compiled, main, run

# A sanitizer's own address space is larger than any machine.
LIMITED = 'exec "$@"' if "sanitize" in str(PROGRAM) else 'ulimit -v 1500000; exec "$@"'


class DeriveWritten(DeriveCase):
    def test_c(self):
        """The C of a derivation compiles without warnings and gives the numbers."""
        self.scene.write_text(TEETH % (3, "peak"))
        status, out, _ = run("derive", "--c", "--elements", self.scene)
        self.assertEqual(status, 0)
        c = compiled(out, self.scene)
        c.tan_critical_angle_1.restype = c.fos_elements_1.restype = ctypes.c_double
        a, b, depth = (ctypes.c_double(v) for v in (30, 120, 5))
        tangent = Fraction(27 * 30 * 120 + 14 * 30 * 5, 9 * 120**2 - 3 * 25)
        self.assertAlmostEqual(c.tan_critical_angle_1(a, b, depth), float(tangent), delta=1e-15)
        angle = ctypes.c_double(math.atan(float(tangent)))
        self.assertAlmostEqual(c.fos_elements_1(angle, a, b, depth), 1, delta=1e-14)

    def test_c_numbers(self):
        """Constants beyond 2^63 and beyond what a double holds, negative and high powers: the C gives
        the program's own critical angle."""
        outlines = ("[[0, 0], [a, 0], [a, 12345678901234567891*b], [0, 12345678901234567890123/7*b]]",
                    "[[0, 0], [a, 0], [a, a^-3*b^-2], [0, 3*a^-1]]", "[[0, 0], [a, 0], [a + 1, b^20], [1, b^20 + a^13]]",
                    "[[0, 0], [1e-200*a, 0], [1e-200*a, 3e-200*b], [0, 3e-200*b + 1e-201]]",
                    "[[0, 0], [a/(1e250 + b), 0], [1/(1e249 + a), 3/(1e250 + b)], [0, 2/(1e250 + 7*a)]]",
                    "[[0, 0], [1e120*a, 0], [1e120*a, 7e120*b + 1e-100], [0, 1e120]]")
        for k, outline in enumerate(outlines):
            self.scene.write_text("topple: 1\nlength_unit: m\nparameters: {a: 1.25, b: 1.5}\nblock: {outline: "
                                  f"{outline}}}\nbase: {{mated: true}}\ntilt: {{towards: left}}\n")
            status, out, err = run("derive", "--c", self.scene)
            self.assertEqual((status, err), (0, ""))
            c = compiled(out, self.scene.with_name(f"derived_{k}"))
            c.tan_critical_angle_1.restype = ctypes.c_double
            found = math.degrees(math.atan(c.tan_critical_angle_1(ctypes.c_double(1.25), ctypes.c_double(1.5))))
            truth = json.loads(run("derive", "--json", self.scene)[1])["pivots"][0]["critical_angle_deg"]["value"]
            self.assertAlmostEqual(found, truth, delta=1e-11 * abs(truth), msg=outline)

    def test_budget(self):
        """Quotients, powers and nests that would take minutes or gigabytes are derived or refused
        within a budget that is counted, so that the answer is the same twice; the address space that
        the program may use says that it does not try. A third of them twice and with an option, but
        in the long rounds."""
        square = lambda ys: ", ".join([f"[{k}, {y}]" for k, y in enumerate(ys)]
                                      + [f"[{len(ys) - 1}, 100]", "[0, 100]"])
        many = ", ".join(f"p{k}: {k + 1}" for k in range(60))
        chain = ", ".join(["p0: 1"] + [f"p{k}: 1/(p{k - 1}*p{k - 1} + a*b + {k})" for k in range(1, 40)])
        scenes = [(many, square([f"1/(p{k} + 1)" for k in range(n)])) for n in (3, 8, 12, 20, 60)]
        scenes += [(many, square([f"1/(p{k} + p{k + 1} + 1)" for k in range(n)])) for n in (5, 12)]
        scenes += [(many, square([f"p0/({k + 1}*p0^{10 * k + 1} + {2 * k + 3}*p0 + {k + 1})" for k in range(12)])),
                   (many, square([f"(p0 + p1)/({k + 1}*p0 + {2 * k + 3}*p1 + p2 + {k})" for k in range(9)])),
                   ("a: 1, b: 1, " + chain, "[0, 0], [1, 0], [1, 9 + p39], [0, 9 + p38]"),
                   ("a: 1, b: 1", "[0, 0], [1, 0], [1, (a + b)^5000], [0, 1]"),
                   ("a: 1, b: 1", "[0, 0], [1, 0], [1, 1 + 1/((a^1000)^90 + b)], [0, 1 + 1/((b^1000)^90 + a)]"),
                   ("a: 1", "[0, 0], [1, 0], [1, " + "1/(1 + " * 150 + "a" + ")" * 150 + "], [0, 1]"),
                   (many, "[0, 0], [" + "+".join(f"p{k}" for k in range(60)) + ", 0], [1, "
                    + "*".join(f"p{k}" for k in range(60)) + "], [0, 5]")]
        for k, (parameters, outline) in enumerate(scenes):
            self.scene.write_text(f"topple: 1\nlength_unit: m\nparameters: {{{parameters}}}\nblock: {{outline: "
                                  f"[{outline}]}}\nfriction_angle_deg: 30\ntilt: {{towards: left}}\n")
            thorough = LONG or k % 3 == 1
            for options in ((), (("--limit",), ("--rounded",))[k % 2])[:2 if thorough else 1]:
                answers = [subprocess.run(["sh", "-c", LIMITED, "sh", PROGRAM, "derive", *options,
                                           str(self.scene)], capture_output=True, encoding="utf-8", timeout=120)
                           for _ in range(2 if thorough and not options else 1)]
                status, out, err = answers[0].returncode, answers[0].stdout, answers[0].stderr
                again = answers[-1]
                self.assertEqual((status, out, err), (again.returncode, again.stdout, again.stderr))
                self.assertIn(status, (0, 3), (outline[:80], err))
                self.assertNotIn("memory", err, outline[:80])
                self.assertEqual((out == "", err.count("\n")), (status == 3, 1 if status == 3 else 0))

    def test_latex(self):
        self.scene.write_text(TEETH % (3, "valley"))
        out = run("derive", "--latex", self.scene)[1]
        self.assertIn(r"\frac{27 a b + 13 a c}{9 b^{2} + 18 b c + 6 c^{2}}", out)

    def test_many_teeth(self):
        """200 teeth: the same tangent as by exact numbers."""
        pivot = self.derive(TEETH % (200, "valley"))["pivots"][0]
        values = {"a": Fraction(30), "b": Fraction(120), "c": Fraction(5)}
        gx, gy = exact.centroid(exact.block_moments(exact.teeth(200, 30, 120, 5, "valley")))
        self.assertEqual(quotient(pivot["tan_critical_angle"], values), gx / gy)

    def refuse(self, parameters, width, expected):
        self.scene.write_text(f"topple: 1\nlength_unit: m\nparameters: {{{parameters}}}\nblock: "
                              f"{{slab: {{width: {width}, height: 1}}}}\n")
        status, out, err = run("derive", self.scene)
        self.assertEqual((status, out), (3, ""))
        self.assertIn(expected, err)

    def test_bad_input(self):
        """What numbers allow but symbols do not: zero denominators, high powers, endless products,
        thousands of parameters."""
        self.refuse("a: 1, b: 2", "1/(a - 1)", "division by zero")
        self.refuse("a: 1, b: 1", "(a/b)^2000", "an exponent may be at most 1000 here")
        self.refuse("a: 2, b: 3", "2^a", "an exponent must be a whole number")
        self.refuse("a: 2, b: 3, c: 5", "(a + b + c)^40", "more than 64 terms in one number")
        many = ", ".join(f"p{k}: {k + 1}" for k in range(10_000))
        self.refuse(many, "p1", "more than 1000 keys in one place")


if __name__ == "__main__":
    main()
