# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Rounded corners and back-analysis: Table 4, polygons of many chords, recovered radii, limits."""

import json
import math
import random
from decimal import Decimal
from fractions import Fraction

import exact
from harness import main, rounds, run, solve, table
from rounded_case import RoundedCase

BLOCKS = {"A": (3, 15, 94, 5), "B": (3, 14, 135, 5), "C": (4, 20, 158, 7), "D": (4, 20, 242, 7),
          "E": (3, 30, 120, 5), "G": (2, 30, 123, 5)}


def moved_axis(ring, r_c, end):
    """The axis that (A2.5) gives: l = r_c / tan(theta / 2) along the first facet, in decimals."""
    (x0, y0), (x1, y1) = [(exact.decimal(x), exact.decimal(y)) for x, y in ring[:2]]
    run_, rise = x1 - x0, y1 - y0
    size = (run_ * run_ + rise * rise).sqrt()
    cosine, sine = run_ / size, rise / size
    length = Decimal(r_c) * cosine / (1 - sine)  # tan((90 - i) / 2) = (1 - sin i) / cos i, i signed
    return x0 + length * cosine, y0 + length * sine


class Rounded(RoundedCase):
    def test_table_4(self):
        """Every row of Table 4 by `solve --find`: r_c from alpha_phys, and the FoS there. Printed 3.61 mm
        for block A about its valley is 3.64; four factors are off in the last digit (docs/paper.md)."""
        wrong = {("A", "19.8", "r_c"), ("C", "21.7", "fos"), ("D", "15.3", "fos"), ("D", "15.1", "fos"),
                 ("G", "23.9", "fos")}
        rows = table("table4_radii.csv")
        self.assertGreaterEqual(len(rows), 11)
        for row in rows:
            block, end = row["block"], row["axis"]
            n, a, b, c = BLOCKS[block]
            name = block.lower() + (f"_{end}" if block in "ABE" else "")
            found = self.find(f"critical_angle={row['alpha_phys_deg']}", "--from", 0, "--to", 15,
                              scene=f"examples/paper/table_4/{name}.yaml")["solutions"]
            self.assertEqual(len(found), 1)
            self.assertLess(found[0]["error"], 1e-10)
            off = abs(Decimal(repr(found[0]["value"])) - Decimal(row["rc_mm"]))
            self.assertEqual(off > Decimal("0.005"), (block, row["alpha_phys_deg"], "r_c") in wrong, row)
            # with the tip's mass taken off: the radius found gives the measured angle
            self.write(n, a, b, c, end, 1, "exact")
            exact_mass = self.find(f"critical_angle={row['alpha_phys_deg']}", "--from", 0, "--to", 15)["solutions"]
            self.assertEqual(len(exact_mass), 1)
            self.write(n, a, b, c, end, repr(exact_mass[0]["value"]), "exact")
            angle = solve(self.scene)["cases"][0]["toppling"]["critical_angle_deg"]["value"]
            self.assertAlmostEqual(angle, float(row["alpha_phys_deg"]), delta=1e-10)
            ring = exact.teeth(n, a, b, c, end)
            fos = exact.factor_of_safety(exact.block_moments(ring), ring[0], Fraction(row["alpha_phys_deg"]))
            self.assertEqual(abs(fos - Decimal(row["fos"])) > Decimal("0.005"),
                             (block, row["alpha_phys_deg"], "fos") in wrong, row)

    def test_axis(self):
        """Model paper: the critical angle about the moved axis, by exact moments at 60 digits."""
        random.seed(51)
        for _ in range(rounds(20, 60)):
            n, end = random.randint(1, 5), random.choice(["valley", "peak"])
            a, b, c, r = (random.randint(10, 30), random.randint(80, 200), random.randint(1, 9),
                          Fraction(random.randint(1, 400), 100))
            self.write(n, a, b, c, end, r)
            own = solve(self.scene)["cases"][0]
            pivot = own["pivots"][0]
            ring = exact.teeth(n, a, b, c, end)
            gx, gy = exact.centroid(exact.block_moments(ring))
            px, py = moved_axis(ring, exact.decimal(r), end)
            x, y = exact.decimal(gx) - px, exact.decimal(gy) - py
            angle = exact.degrees(exact.atan(x / y))
            found = pivot["critical_angle_deg"]
            self.assertLessEqual(abs(Decimal(found["value"]) - angle),
                                 Decimal(found["error"]) + Decimal("1e-50"))
            self.assertTrue(pivot["rounded"])
            self.assertLessEqual(abs(Decimal(pivot["x_m"]["value"]) * 1000 - px), Decimal("1e-12"))

    def test_exact_model(self):
        """Model exact: area, centroid and second moments of a triangle and a slab with all corners
        rounded equal those of a polygon whose arcs are chords of angle h, but for the segments between
        chord and arc: a relative error of h^2 / 4 of the tips at most; second order is seen."""
        corners = "[{at: [0, 0], radius: 2}, {at: [20, 0], radius: 3}, {at: [6, 15], radius: 1}]"
        self.scene.write_text(
            "topple: 1\nlength_unit: m\nblock:\n  outline: [[0, 0], [20, 0], [6, 15]]\n  rounded: {corners: "
            f"{corners}}}\nbase: {{mated: true, between: [[0, 0], [20, 0]]}}\ntilt: {{towards: left}}\n")
        block = solve(self.scene)["cases"][0]["block"]
        gaps = []
        for pieces in (50, 100):
            ring = []
            points = [(0, 0), (20, 0), (6, 15)]
            for k, r in enumerate((2, 3, 1)):
                v, w, u = points[k], points[k - 1], points[(k + 1) % 3]
                angle = lambda p: math.atan2(p[1] - v[1], p[0] - v[0])
                theta = (angle(w) - angle(u)) % (2 * math.pi)
                middle = angle(u) + theta / 2
                cx, cy = (v[0] + r / math.sin(theta / 2) * math.cos(middle),
                          v[1] + r / math.sin(theta / 2) * math.sin(middle))
                first = angle(w) + math.pi / 2  # normal of the edge before, away from the block
                for j in range(pieces + 1):
                    turn = first + (math.pi - theta) * j / pieces
                    ring.append((cx + r * math.cos(turn), cy + r * math.sin(turn)))
            m = exact.ring_moments([(Fraction(x), Fraction(y)) for x, y in ring])
            area, gx, gy = float(m[0]), float(m[1] / m[0]), float(m[2] / m[0])
            gaps.append((abs(block["area_m2"]["value"] - area), abs(block["centroid_x_m"]["value"] - gx),
                         abs(block["centroid_y_m"]["value"] - gy)))
        for coarse, fine in zip(*gaps):
            self.assertLess(fine, 2e-3)
            self.assertAlmostEqual(coarse / fine, 4, delta=0.1)

    def test_second_moments(self):
        """A square of side 2 with all corners rounded by r: from each quarter of it, a square of side r
        at d = 1 - r from the axes goes and a quarter of a circle comes back; in closed form. The product
        moment vanishes by symmetry, which balls can only enclose."""
        r = 0.75
        d = 1 - r
        corners = ", ".join(f"{{at: [{x}, {y}], radius: {r}}}" for x, y in ((0, 0), (2, 0), (2, 2), (0, 2)))
        self.scene.write_text("topple: 1\nlength_unit: m\nblock:\n  outline: [[0, 0], [2, 0], [2, 2], [0, 2]]"
                              f"\n  rounded: {{corners: [{corners}]}}\ntilt: {{towards: left}}\n")
        block = solve(self.scene)["cases"][0]["block"]
        tip = r * ((d + r)**3 - d**3) / 3 - (d**2 * math.pi * r**2 / 4 + 2 * d * r**3 / 3 + math.pi * r**4 / 16)
        self.assertAlmostEqual(block["area_m2"]["value"], 4 - 4 * r**2 * (1 - math.pi / 4), delta=1e-14)
        for name in ("second_moment_xx_m4", "second_moment_yy_m4"):
            self.assertAlmostEqual(block[name]["value"], 4 / 3 - 4 * tip, delta=1e-14)
        product = block["second_moment_xy_m4"]
        self.assertLessEqual(abs(product["value"]), product["error"])
        self.assertLess(product["error"], 1e-9 * block["second_moment_xx_m4"]["value"])

    def test_recovered(self):
        """Random blocks: the radius that gives the critical angle of a known radius is that one,
        to 1e-10 of it."""
        random.seed(52)
        for k in range(rounds(50, 1000)):
            n, end = random.randint(1, 5), random.choice(["valley", "peak"])
            a, b, c = random.randint(15, 30), random.randint(60, 200), random.randint(1, 9)
            r = random.randint(10, 300) / 100
            self.write(n, a, b, c, end, r, random.choice(["paper", "exact"]))
            angle = solve(self.scene)["cases"][0]["toppling"]["critical_angle_deg"]
            found = self.find(f"critical_angle={angle['value']!r}", "--from", r / 2, "--to", 2 * r)
            near = min(abs(s["value"] - r) for s in found["solutions"])
            self.assertLess(near, 1e-10 * max(r, 1), (k, found))

    def test_bad_find(self):
        self.write(3, 30, 120, 5, "peak", 1)
        for key, target, message in (
                ("block.rouned", "fos=1", "there is no 'rouned' here; did you mean 'rounded'?"),
                ("block.rounded", "fos=1", "this is a list or a map; a single number can be found"),
                ("block.rounded.corners.2.radius", "fos=1", "there is no '2' here"),
                ("friction_angle", "fos=1", "there is no 'friction_angle' here"),
                ("block.teeth.left_end", "critical_angle=20", "unknown name 'peak'"),
                ("block.rounded.corners.1.radius", "fos=1.2", "fos needs a tilt")):
            status, out, err = run("solve", "--find", key, "--for", target, self.scene)
            self.assertEqual((status, out), (3, ""), err)
            self.assertIn(message, err)
        for wrong in (("--find", "x"), ("--for", "fos=1"), ("--find", "x", "--for", "fos"),
                      ("--find", "x", "--for", "area=1"), ("--from", "0"), ("--to", "9")):
            self.assertEqual(run("solve", *wrong, self.scene)[0], 2)

    def test_all_solutions(self):
        """None in the range is said so. An L whose arm grows moves its centroid out over the foot: every
        number found gives the wanted angle by exact moments."""
        self.write(3, 30, 120, 5, "peak", 1)
        status, out, _ = run("solve", "--find", "block.teeth.height", "--for", "critical_angle=89",
                             "--from", 100, "--to", 200, self.scene)
        self.assertEqual(status, 0)
        self.assertIn("none in range", out)
        self.scene.write_text(
            "topple: 1\nlength_unit: m\nparameters: {p: 2}\nblock:\n  outline: [[0, 0], [2, 0], [2, 1], [2 + p, 1],"
            " [2 + p, 2], [0, 2]]\nbase: {mated: true, between: [[0, 0], [2, 0]]}\ntilt: {towards: left}\n")
        status, out, err = run("solve", "--json", "--find", "p", "--for", "critical_angle=50", "--from", "0.01",
                               "--to", "6", self.scene)
        self.assertEqual((status, err), (0, ""))
        solutions = json.loads(out)["find"]["solutions"]
        for s in solutions:
            p = Fraction(s["value"])
            ring = [(0, 0), (2, 0), (2, 1), (2 + p, 1), (2 + p, 2), (0, 2)]
            gx, gy = exact.centroid(exact.block_moments([(Fraction(x), Fraction(y)) for x, y in ring]))
            self.assertAlmostEqual(math.degrees(math.atan2(gx, gy)), 50, delta=1e-9)
        self.assertEqual(len(solutions), 1)


if __name__ == "__main__":
    main()
