# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Derived formulas: equal to the paper's Fig. 8 letter by letter, and at their parameters equal to
exact numbers, as rationals: nothing here has a tolerance but where C evaluates in doubles."""

import ctypes
import json
import math
import random
import re
from decimal import Decimal
from fractions import Fraction

import exact
from derive_case import DeriveCase, TEETH, quotient
from harness import compiled, main, rounds, run, solve

# (N, left end): numerator and denominator as in Fig. 8, (A1.4) … (A1.24)
FIG_8 = {
    (2, "valley"): ("6*a*b + 3*a*c", "3*b^2 + 6*b*c + 2*c^2"),
    (2, "peak"): ("6*a*b + 3*a*c", "3*b^2 - c^2"),
    (3, "valley"): ("27*a*b + 13*a*c", "9*b^2 + 18*b*c + 6*c^2"),
    (3, "peak"): ("27*a*b + 14*a*c", "9*b^2 - 3*c^2"),
    (4, "valley"): ("12*a*b + 6*a*c", "3*b^2 + 6*b*c + 2*c^2"),
    (4, "peak"): ("12*a*b + 6*a*c", "3*b^2 - c^2"),
}


def evaluate(text, values):
    """An expression of a scene in rationals: its numbers are fractions."""
    python = re.sub(r"\d+", lambda n: f"Fraction({n.group()})", text)
    return eval(python, {"__builtins__": {}, "Fraction": Fraction}, values)


class Derive(DeriveCase):
    def test_fig_8(self):
        """N = 2, 3, 4 towards both kinds of end: the formulas of Fig. 8, in the same terms."""
        for (count, end), (top, bottom) in FIG_8.items():
            pivot = self.derive(TEETH % (count, end))["pivots"][0]
            self.assertTrue(pivot["governs"])
            self.assertEqual(pivot["tan_critical_angle"], {"numerator": top, "denominator": bottom})

    def test_elements_form(self):
        """(A1.3) and (A1.15): the triangles below a peak stabilise, FoS = p cot(alpha) + q."""
        for count, top, bottom in ((3, "27*a*b + 14*a*c", "9*b^2"), (4, "4*a*b + 2*a*c", "b^2")):
            form = self.derive(TEETH % (count, "peak"), "--elements")["pivots"][0]["fos_elements"]
            self.assertEqual(form["cot"], {"numerator": top, "denominator": bottom})
            self.assertEqual(form["constant"], {"numerator": "c^2", "denominator": "3*b^2"})

    def test_general_parameters(self):
        """The same block by dx, y, A and lambda (section 5.1 of the paper): four teeth, dx = 2 lambda,
        about a valley, at random values against exact moments."""
        text = ("topple: 1\nlength_unit: mm\nparameters: {y: 100, A: 5, l: 40}\nblock:\n  teeth: "
                "{block_width: 2*l, mean_height: y, amplitude: A, wavelength: l, left_end: valley}\n")
        tangent = self.derive(text)["pivots"][0]["tan_critical_angle"]
        for _ in range(20):
            y, amplitude, length = (Fraction(random.randint(1, 99)) for _ in range(3))
            count, a, b, c = 4, length / 2, y - amplitude / 2, amplitude
            m = exact.block_moments(exact.teeth(count, a, b, c, "valley"))
            gx, gy = exact.centroid(m)
            found = quotient(tangent, {"y": y, "A": amplitude, "l": length})
            self.assertEqual(found, gx / gy)

    def test_parameters_by_expressions(self):
        """A parameter given by others stands for its expression; one given by a number is a symbol,
        whatever its name."""
        derived = self.derive("topple: 1\nlength_unit: m\nparameters: {w: 2, k: 3, h: k*w, twice_h: "
                              "2*h}\nblock: {slab: {width: w, height: twice_h}}\n")
        self.assertEqual(derived["symbols"], ["w", "k"])
        self.assertEqual(derived["area"], {"numerator": "2*w^2*k", "denominator": "1"})
        self.assertEqual(derived["pivots"][0]["tan_critical_angle"],
                         {"numerator": "1", "denominator": "2*k"})

    def test_random_polygons(self):
        """Random polygons in three parameters: area and every tangent, evaluated at the values,
        equal the exact rational of the numbers; the angle lies within the bounds of solve."""
        random.seed(31)
        done = 0
        while done < rounds(200, 1000):
            values, texts = self.random_polygon(random.randint(3, 9))
            ring = [tuple(evaluate(t, values) for t in pair) for pair in texts]
            body = ", ".join(f"[{x}, {y}]" for x, y in texts)
            numbers = ", ".join(f"{n}: {v}" for n, v in values.items())
            self.scene.write_text(f"topple: 1\nlength_unit: m\nparameters: {{{numbers}}}\nblock: "
                                  f"{{outline: [{body}]}}\nbase: {{mated: whole}}\ntilt: {{towards: left}}\n")
            status, out, err = run("derive", "--json", self.scene)
            if status == 3:  # the random expressions made it cross itself
                self.assertRegex(err, "crosses|touches|repeats")
                continue
            self.assertEqual((status, err), (0, ""))
            derived = json.loads(out)
            m = exact.block_moments(ring)
            gx, gy = exact.centroid(m)
            self.assertEqual(quotient(derived["area"], values), m[0])
            self.assertEqual(quotient(derived["x_moment"], values), m[1])
            for pivot in derived["pivots"]:
                px, py = quotient(pivot["x"], values), quotient(pivot["y"], values)
                self.assertIn((px, py), ring)
                if gy != py:
                    self.assertEqual(quotient(pivot["tan_critical_angle"], values),
                                     (gx - px) / (gy - py))
            if done % 50 == 0:
                numeric = solve(self.scene)["cases"][0]["pivots"]
                for one, other in zip(derived["pivots"], numeric):
                    a, b = one["critical_angle_deg"], other["critical_angle_deg"]
                    self.assertLessEqual(abs(Decimal(a["value"]) - Decimal(b["value"])),
                                         Decimal(a["error"]) + Decimal(b["error"]))
            done += 1

    def test_rounded(self):
        """--rounded, the C of it compiled: at the length r that it says lets block E go at alpha, the
        critical angle about the moved axis, by exact moments, is alpha; r_c = r tan(theta/2), theta
        the corner's angle. Towards the peak it is (A2.4) and (A2.6), towards the valley (A2.10)."""
        for end, slope in (("peak", -1), ("valley", 1)):
            self.scene.write_text(TEETH % (3, end))
            status, out, err = run("derive", "--c", "--rounded", self.scene)
            self.assertEqual((status, err), (0, ""))
            c = compiled(out, self.scene.with_name(f"derived_{end}"))
            for name in ("rounding_length", "corner_radius", "tan_critical_angle_rounded"):
                getattr(c, f"{name}_left").restype = ctypes.c_double
            sizes = [ctypes.c_double(v) for v in (30, 120, 5)]
            i, alpha = math.atan(5 / 30), math.radians(33 if end == "peak" else 31)
            length = c.rounding_length_left(ctypes.c_double(alpha), ctypes.c_double(i), *sizes)
            ring = exact.teeth(3, 30, 120, 5, end)
            gx, gy = exact.centroid(exact.block_moments(ring))
            x = float(gx - ring[0][0]) - length * math.cos(i)
            y = float(gy - ring[0][1]) - slope * length * math.sin(i)
            self.assertGreater(length, 0)
            self.assertAlmostEqual(math.atan2(x, y), alpha, delta=1e-13)
            tangent = c.tan_critical_angle_rounded_left(ctypes.c_double(length), ctypes.c_double(i), *sizes)
            self.assertAlmostEqual(tangent, math.tan(alpha), delta=1e-13)
            radius = c.corner_radius_left(ctypes.c_double(alpha), ctypes.c_double(i), *sizes)
            theta = math.pi / 2 - slope * i
            self.assertAlmostEqual(radius, length * math.tan(theta / 2), delta=1e-12)
        latex = run("derive", "--latex", "--rounded", self.scene)[1]
        self.assertIn(r"18 b r \cos i", latex)
        slab = run("derive", "--json", "--rounded", "examples/paper/slab.yaml")[1]
        rounded = json.loads(slab)["rounded"][0]  # Eq. (5)
        self.assertEqual(rounded["tan_critical_angle"], {"numerator": "dx - 2*r", "denominator": "y"})
        self.scene.write_text(TEETH.replace("{a: 30,", "{r: 1, a: 30,") % (3, "peak"))
        status, out, err = run("derive", "--rounded", self.scene)
        self.assertEqual((status, out), (3, ""))
        self.assertIn("need the name 'r' for themselves; rename this parameter", err)

    def test_every_number_of_teeth(self):
        """--for-all count: at every N from 1 to 60, far beyond the members that fix and check it, the
        formula of N's parity equals the exact tangent of that block, for both ends and directions."""
        random.seed(32)
        for end in ("valley", "peak"):
            formulas = self.family(TEETH % (3, end))["formulas"]
            for count in range(1, 61):
                a, b = Fraction(random.randint(1, 500), 7), Fraction(random.randint(1, 500), 7)
                c = Fraction(random.randint(1, 100), 13)
                ring = exact.teeth(count, a, b, c, end)
                gx, gy = exact.centroid(exact.block_moments(ring))
                values = {"a": a, "b": b, "c": c, "N": Fraction(count)}
                for own in formulas:
                    if (own["count"] == "even") != (count % 2 == 0):
                        continue
                    left = own["towards"] == "left"
                    px, py = ring[0] if left else ring[count]
                    self.assertEqual(own["kind"], "valley" if py == 0 else "peak")
                    arm = gx - px if left else px - gx
                    if gy != py:
                        self.assertEqual(quotient(own["tan_critical_angle"], values), arm / (gy - py))

    def test_general_equations(self):
        """Eq. (15) is exact for an even number of teeth; Eq. (16) is so with A^2 / (12 y^2) in the
        place of the printed A^2 / (4 y^2); for an odd number there is a term in the wavelength."""
        text = ("topple: 1\nlength_unit: mm\nparameters: {dx: 90, y: 122.5, A: 5, l: 60}\nblock:\n  "
                "teeth: {block_width: dx, mean_height: y, amplitude: A, wavelength: l, left_end: %s}\n")
        peak, valley = (self.family(text % end)["formulas"] for end in ("peak", "valley"))
        even_peak, even_valley = peak[2], valley[2]
        self.assertEqual(even_peak["kind"] + even_valley["kind"], "peakvalley")
        self.assertEqual(even_peak["tan_critical_angle"],
                         {"numerator": "12*dx*y", "denominator": "12*y^2 - 12*y*A - A^2"})
        self.assertEqual(even_valley["tan_critical_angle"],
                         {"numerator": "12*dx*y", "denominator": "12*y^2 + 12*y*A - A^2"})
        self.assertEqual(peak[0]["tan_critical_angle"],
                         {"numerator": "24*dx^2*y + A*l^2",
                          "denominator": "24*dx*y^2 - 24*dx*y*A - 2*dx*A^2"})

    def test_family_of_no_teeth(self):
        """Only teeth have a count; the option takes nothing else."""
        status, out, err = run("derive", "--for-all", "count", "examples/boulder.yaml")
        self.assertEqual((status, out), (3, ""))
        self.assertIn("only a toothed block", err)
        self.assertEqual(run("derive", "--for-all", "teeth", "examples/block_c.yaml")[0], 2)


if __name__ == "__main__":
    main()
