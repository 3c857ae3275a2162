# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Rounded corners and back-analysis: Table 4, polygons of many chords, recovered radii, limits."""

import json
import math
import pathlib
import random
import tempfile
import unittest
from decimal import Decimal
from fractions import Fraction

import exact
from harness import main, run, solve, table

SCENE = ("topple: 1\nlength_unit: mm\nblock:\n  teeth: {{count: {n}, width: {a}, height: {b}, depth: {c}, "
         "left_end: {end}}}\n  rounded: {{model: {model}, corners: [{{at: left_end, radius: {r}}}]}}\n"
         "  unit_weight_kn_m3: 25.8\ntilt: {{towards: left}}\n")
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


class Rounded(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.scene = pathlib.Path(self.folder.name) / "scene.yaml"

    def tearDown(self):
        self.folder.cleanup()

    def write(self, n, a, b, c, end, r, model="paper"):
        self.scene.write_text(SCENE.format(n=n, a=a, b=b, c=c, end=end, r=r, model=model))

    def find(self, target, *more, scene=None):
        status, out, err = run("solve", "--json", "--find", "block.rounded.corners.1.radius", "--for",
                               target, *more, scene or self.scene)
        self.assertEqual((status, err), (0, ""))
        return json.loads(out)["find"]

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
        for _ in range(60):
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
        """1000 random blocks: the radius that gives the critical angle of a known radius is that one,
        to 1e-10 of it."""
        random.seed(52)
        for k in range(1000):
            n, end = random.randint(1, 5), random.choice(["valley", "peak"])
            a, b, c = random.randint(15, 30), random.randint(60, 200), random.randint(1, 9)
            r = random.randint(10, 300) / 100
            self.write(n, a, b, c, end, r, random.choice(["paper", "exact"]))
            angle = solve(self.scene)["cases"][0]["toppling"]["critical_angle_deg"]
            found = self.find(f"critical_angle={angle['value']!r}", "--from", r / 2, "--to", 2 * r)
            near = min(abs(s["value"] - r) for s in found["solutions"])
            self.assertLess(near, 1e-10 * max(r, 1), (k, found))

    def test_limit(self):
        """Radius to 0: the sharp block, at first order by the moved axis; exact and paper differ at third
        order, the area of the tip times its distance from the axis."""
        self.write(3, 30, 120, 5, "peak", 0)
        sharp = solve(self.scene)["cases"][0]
        self.assertNotIn("rounded", sharp["pivots"][0])
        angles = {}
        for model in ("paper", "exact"):
            for r in (0.2, 0.1):
                self.write(3, 30, 120, 5, "peak", r, model)
                angles[model, r] = solve(self.scene)["cases"][0]["toppling"]["critical_angle_deg"]["value"]
        zero = sharp["toppling"]["critical_angle_deg"]["value"]
        first = (zero - angles["paper", 0.2]) / (zero - angles["paper", 0.1])
        third = ((angles["exact", 0.2] - angles["paper", 0.2])
                 / (angles["exact", 0.1] - angles["paper", 0.1]))
        self.assertAlmostEqual(first, 2, delta=0.01)
        self.assertAlmostEqual(third, 8, delta=0.05)

    def test_symmetric(self):
        """A block that is its own mirror image, both ends rounded: its centroid stands exactly over a
        joint, which balls can only enclose; both directions have the same answer."""
        self.scene.write_text(
            "topple: 1\nlength_unit: mm\nblock:\n  teeth: {count: 4, width: 20, height: 158, depth: 7, left_end: "
            "valley}\n  rounded: {corners: [{at: left_end, radius: 5}, {at: right_end, radius: 5}]}\n"
            "friction_angle_deg: 30\ntilt: {towards: both, angle_deg: 10}\n")
        left, right = (case["toppling"]["critical_angle_deg"] for case in solve(self.scene)["cases"])
        self.assertLessEqual(abs(left["value"] - right["value"]), left["error"] + right["error"])

    def test_rolling(self):
        """A slab of width w and height h on a toe of radius r: at its critical angle the centre of
        curvature is r above the base and from the side, the centroid h / 2 above. A low slab on a toe
        of nearly half its width rolls back, a taller one topples."""
        for height, radius, beyond in ((30, 19, "rolls back"), (100, 19, "topples")):
            self.scene.write_text(
                f"topple: 1\nlength_unit: mm\nblock:\n  slab: {{width: 40, height: {height}}}\n  rounded: {{model:"
                f" paper, corners: [{{at: left_end, radius: {radius}}}]}}\ntilt: {{towards: left}}\n")
            toppling = solve(self.scene)["cases"][0]["toppling"]
            alpha = math.atan2(20 - radius, height / 2)
            self.assertAlmostEqual(toppling["critical_angle_deg"]["value"], math.degrees(alpha), delta=1e-12)
            centre, weight = (radius, radius), (20, height / 2)
            above = ((centre[0] - weight[0]) * math.sin(alpha) + (centre[1] - weight[1]) * math.cos(alpha)) > 0
            self.assertEqual(toppling["beyond"], "rolls back" if above else "topples")
            self.assertEqual(toppling["beyond"], beyond)

    def test_rest(self):
        """Beyond its critical angle a low slab rolls on its toe to a new rest. Where it is found by rolling
        the block in small steps in doubles: turned about the contact, which moves r a radian along the
        base, until the centroid stands over the contact; towards both sides alike. At a steeper tilt it
        topples."""
        width, height, radius = 40.0, 30.0, 19.0
        scene = ("topple: 1\nlength_unit: mm\nblock:\n  slab: {width: 40, height: 30}\n  rounded: {model: paper, "
                 "corners: [{at: %s, radius: 19}]}\ntilt: {towards: %s, angle_deg: %r}\n")
        for tilt, rests in ((5.0, True), (11.5, True), (14.0, False)):
            for end, towards in (("left_end", "left"), ("right_end", "right")):
                self.scene.write_text(scene % (end, towards, tilt))
                toppling = solve(self.scene)["cases"][0]["toppling"]
                self.assertEqual(toppling["beyond"], "rolls back" if rests else "topples")
                self.assertEqual("rest_turn_deg" in toppling, rests)
            a = math.radians(tilt)
            cx, cy, gx, gy = radius, radius, width / 2, height / 2

            def arm(t):
                """Horizontal distance of the centroid up-dip of the contact after a turn by t."""
                x = cx - radius * t + (gx - cx) * math.cos(t) - (gy - cy) * math.sin(t)
                y = cy + (gx - cx) * math.sin(t) + (gy - cy) * math.cos(t)
                return (x - (cx - radius * t)) * math.cos(a) - y * math.sin(a)

            turns = [k * math.pi / 2 / 4000 for k in range(4001)]
            place = next((k for k in range(4000) if arm(turns[k]) < 0 <= arm(turns[k + 1])), None)
            self.assertEqual(place is not None, rests)
            if rests:
                low, high = turns[place], turns[place + 1]
                for _ in range(60):
                    middle = (low + high) / 2
                    low, high = (middle, high) if arm(middle) < 0 else (low, middle)
                self.assertAlmostEqual(toppling["rest_turn_deg"]["value"], math.degrees(low), delta=1e-9)

    def test_roundings_that_meet(self):
        """Two roundings leave one point of the edge between them, level or inclined: a toe that rolls towards
        either side, water between the ends that the edge has without them, as just before they meet."""
        square = [(0, 0), (4, 3), (1, 7), (-3, 4)]
        water = "loads: {water: {height: 1, unit_weight_kn_m3: 10, uplift: true}}\n"

        def case(turn, towards, less, loads, base):
            ring, rock = ([(turn * x, y) for x, y in points] for points in (square, base))
            corners = [f"{{at: [{x}, {y}], radius: {radius} - {less}}}" for (x, y), radius in zip(ring, (2, 3))]
            self.scene.write_text(
                "topple: 1\nlength_unit: m\nblock:\n  outline: "
                f"{[list(p) for p in ring]}\n  unit_weight_kn_m3: 26\n  thickness: 1\n  rounded: {{model: exact, "
                f"corners: [{', '.join(corners)}]}}\nbase: {{profile: {[list(p) for p in rock][::turn]}}}\n"
                f"{loads}friction_angle_deg: 40\ntilt: {{towards: {towards}, angle_deg: 5}}\n")
            return solve(self.scene)["cases"][0]

        for base in ([(0, 0), (4, 3)], [(-4, -3), (4, 3)], [(0, 0), (8, 6)], [(0, 0), (4, 3), (8, 3)]):
            for loads in ("", water):
                for towards, mirrored in (("left", "right"), ("right", "left")):
                    at, other = case(1, towards, 0, loads, base), case(-1, mirrored, 0, loads, base)
                    near = case(1, towards, "1e-9", loads, base)
                    self.assertEqual((len(at["pivots"]), len(near["pivots"])), (1, 2))
                    self.assertEqual(at["pivots"][0]["kind"], other["pivots"][0]["kind"])
                    for told in (other, near):
                        self.assertEqual(at["toppling"].get("beyond"), told["toppling"].get("beyond"))
                        self.assertEqual(at["limit"]["base_beyond_toe"], told["limit"]["base_beyond_toe"])
                        self.assertAlmostEqual(at["toppling"]["critical_angle_deg"]["value"],
                                               told["toppling"]["critical_angle_deg"]["value"], delta=1e-6)
                        for own, its in zip(at.get("loads", []), told.get("loads", []), strict=True):
                            self.assertAlmostEqual(own["moment_nm"]["value"], its["moment_nm"]["value"],
                                                   delta=1e-6 * abs(own["moment_nm"]["value"]))

    def test_only_when_called_for(self):
        """No rounding in the scene, none in the account of effects; a radius of 0 changes no number."""
        self.write(3, 30, 120, 5, "peak", 0)
        zero = solve(self.scene)
        text = self.scene.read_text()
        self.scene.write_text("\n".join(l for l in text.splitlines() if "rounded" not in l) + "\n")
        none = solve(self.scene)
        self.assertNotIn("rounding", [e["name"] for e in none["cases"][0]["effects"]])
        for part in ("block", "pivots", "toppling", "mechanism"):
            self.assertEqual(zero["cases"][0][part], none["cases"][0][part])

    def refuse(self, rounded, message, options=(), outline="[[0, 0], [10, 0], [10, 10], [5, 2], [0, 10]]"):
        self.scene.write_text(f"topple: 1\nlength_unit: mm\nblock:\n  outline: {outline}\n  rounded: {rounded}\n"
                              "tilt: {towards: left}\n")
        status, out, err = run("solve", *options, self.scene)
        self.assertEqual((status, out), (3, ""), err)
        self.assertIn(message, err)
        self.assertIn("scene.yaml:", err)

    def test_bad_corners(self):
        one = "{corners: [{at: %s, radius: %s}]}"
        self.refuse(one % ("[5, 2]", 1), "the corner at (5, 2) is reflex; only convex corners are rounded")
        self.refuse(one % ("[5, 3]", 1), "the outline has no such vertex to round")
        self.refuse(one % ("[0, 0]", -1), "the radius of a corner must not be negative")
        self.refuse(one % ("[0, 0]", 11), "the radius at (0, 0) is too large: rounding it would take up more "
                                          "than the edge from vertex 5 (0, 10) to vertex 1 (0, 0)")
        self.refuse("{corners: [{at: [0, 0], radius: 6}, {at: [10, 0], radius: 6}]}",
                    "rounding it and the next corner would take up more than the edge from vertex 1 (0, 0)")
        self.refuse("{corners: [{at: [0, 0], radius: 1}, {at: left_end, radius: 1}]}", "rounded twice")
        self.refuse("{corners: [{at: middle, radius: 1}]}", "'at' must be left_end or right_end")
        self.refuse("{corners: [{at: left_end}]}", "'radius' is missing here")
        self.refuse("{model: round, corners: []}", "model must be exact")
        self.refuse("{radius: 3}", "unknown key")
        self.refuse("{model: exact}", "rounded needs a list")
        self.refuse(one % ("[0, 0]", 1), "leave out --elements", ("--elements",))
        status, _, err = run("derive", self.scene)
        self.assertEqual(status, 3)
        self.assertIn("derive with --rounded", err)

    def test_ellipse(self):
        """An ellipse on a flat: area, centroid and second moments against polygons inscribed with n
        chords, whose gap falls as 1 / n^2; a hemisphere-like cut of a circle in closed form: with the
        flat at the diameter less nothing the centroid is 4 r / (3 pi) over it, approached from below."""
        scene = "topple: 1\nlength_unit: m\nblock: {ellipse: {width: %r, height: %r, flat: %r}}\ntilt: {towards: left}\n"
        for width, height, flat in ((8, 3, 1.8), (2, 2, 0.1), (3, 7, 2.9)):
            self.scene.write_text(scene % (width, height, flat))
            case = solve(self.scene)["cases"][0]
            gaps = []
            beta = math.asin(flat / width)
            for n in (400, 800):
                turns = [-math.pi / 2 + beta + (2 * math.pi - 2 * beta) * k / n for k in range(n + 1)]
                ring = [(width / 2 * math.cos(t), height / 2 * (math.sin(t) + math.cos(beta))) for t in turns]
                m = exact.ring_moments([(Fraction(x), Fraction(y)) for x, y in ring])
                gy = m[2] / m[0]
                gaps.append([abs(case["block"]["area_m2"]["value"] - float(m[0])),
                             abs(case["block"]["centroid_y_m"]["value"] - float(gy)),
                             abs(case["block"]["second_moment_xx_m4"]["value"] - float(m[3])),
                             abs(case["block"]["second_moment_yy_m4"]["value"] - float(m[4] - gy * m[2]))])
            for coarse, fine in zip(*gaps):
                self.assertLess(fine, 1e-2)
                self.assertAlmostEqual(coarse / fine, 4, delta=0.2)
            angle = math.degrees(math.atan2(flat / 2, case["block"]["centroid_y_m"]["value"]))
            self.assertAlmostEqual(case["toppling"]["critical_angle_deg"]["value"], angle, delta=1e-12)
        self.scene.write_text(scene % (2, 2, 1.999999999999))
        centroid = solve(self.scene)["cases"][0]["block"]["centroid_y_m"]["value"]
        self.assertAlmostEqual(centroid, 4 / (3 * math.pi), delta=2e-6)
        for wrong, message in (("{width: 2, height: 2, flat: 2}", "the flat must be narrower"),
                               ("{width: 2, height: 0, flat: 1}", "height must be above zero"),
                               ("{width: 2, height: 2}", "'flat' is missing here")):
            self.scene.write_text(f"topple: 1\nlength_unit: m\nblock: {{ellipse: {wrong}}}\n")
            status, out, err = run("solve", self.scene)
            self.assertEqual((status, out), (3, ""))
            self.assertIn(message, err)

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
