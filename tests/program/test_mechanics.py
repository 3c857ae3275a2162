# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Every number that docs/mechanics.md prints: found by another route than the program's, found by the program, and
printed on the page. `Page.prints` fails where the page says something else."""

import math
import pathlib
import tempfile
import unittest
from fractions import Fraction

import exact
from harness import ROOT, main, run, solve

PAGE = " ".join((ROOT / "docs/mechanics.md").read_text(encoding="utf-8").split())
TEETH_E = (3, 30, 120, 5)
DEGREE = math.pi / 180


def tan(degrees):
    return math.tan(degrees * DEGREE)


def bisect(function, low, high):
    """A zero of a function that rises from below zero to above."""
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if function(middle) < 0 else (low, middle)
    return (low + high) / 2


def case(scene, folder=ROOT):
    return solve(scene, folder=folder)["cases"][0]


def found(scene, key, target):
    """The one solution of `topple solve --find`."""
    solutions = solve(scene, "--find", key, "--for", target)["find"]["solutions"]
    if len(solutions) != 1:
        raise AssertionError(f"{scene}: {solutions}")
    return solutions[0]


class Page(unittest.TestCase):
    def prints(self, text, *numbers):
        """The page has the text, with its {} filled by the numbers to as many places as {:.3f} say."""
        self.assertIn(text.format(*numbers), PAGE)

    def agree(self, number, truth, error=1e-9):
        """A number of the program and one found otherwise, in doubles."""
        value = number["value"] if isinstance(number, dict) else number
        self.assertLessEqual(abs(value - truth), error * max(1, abs(truth)))


class Moments(Page):
    def setUp(self):
        self.case = case("examples/block_e_valley.yaml")
        self.moments = exact.block_moments(exact.teeth(*TEETH_E, "valley"))

    def test_area_and_centroid(self):
        """By fans of triangles."""
        x, y = map(float, exact.centroid(self.moments))
        self.agree(self.case["block"]["area_m2"], float(self.moments[0]) / 1e6)
        self.agree(self.case["block"]["centroid_x_m"], x / 1000)
        self.agree(self.case["block"]["centroid_y_m"], y / 1000)
        self.prints("A = {} mm² and its centroid at ({:.3f}, {:.3f}) mm", self.moments[0], x, y)

    def test_toppling_about_the_valley(self):
        _, a, b, c = TEETH_E
        tangent = Fraction(27 * a * b + 13 * a * c, 9 * b * b + 18 * b * c + 6 * c * c)
        x, y = exact.centroid(self.moments)
        self.assertEqual(tangent, x / y)
        angle, factor = math.atan(tangent) / DEGREE, float(tangent) / tan(20)
        self.agree(self.case["toppling"]["critical_angle_deg"], angle)
        self.agree(self.case["toppling"]["fos"], factor)
        self.prints("tan α_crit = (27ab + 13ac)/(9b² + 18bc + 6c²), {:.3f}°; at a tilt of 20° the factor is {:.3f}.",
                    angle, factor)

    def test_elements_about_the_peak(self):
        """Slabs and triangles, each component of their weights with the side that its sign says."""
        _, a, b, c = TEETH_E
        px, py = a, c
        sides = [0.0, 0.0]
        for k in range(3):
            thirds = a / 3 if k % 2 == 0 else 2 * a / 3  # the triangle's lower corner is at its left end, or right
            for area, x, y in ((a * b, k * a + a / 2, c + b / 2), (a * c / 2, k * a + thirds, 2 * c / 3)):
                for moment in ((x - px) * math.cos(20 * DEGREE), (py - y) * math.sin(20 * DEGREE)):
                    sides[moment < 0] += area * abs(moment)
        x, y = map(float, exact.centroid(self.moments))
        factors = (x - px) / (y - py) / tan(20), sides[0] / sides[1]
        peak = self.case["pivots"][1]
        self.agree(peak["fos"], factors[0])
        self.agree(peak["fos_elements"], factors[1])
        self.prints("at 20°: {:.3f} and {:.3f}.", *factors)

    def test_roughness_angle(self):
        angle = math.atan2(5, 30) / DEGREE
        self.agree(self.case["sliding"]["facet_angle_deg"], angle)
        self.prints("Eq. (7); {:.3f}° for block E", angle)


class Rounding(Page):
    def test_worn_corner(self):
        """The axis moves up-dip along the facet by l until the arms balance at 23.5°; the radius is l tan(theta/2)."""
        x, y = map(float, exact.centroid(exact.block_moments(exact.teeth(3, 15, 94, 5, "peak"))))
        i, tilt = math.atan2(5, 15), 23.5 * DEGREE
        length = (x * math.cos(tilt) - (y - 5) * math.sin(tilt)) / math.cos(i - tilt)  # the facet falls up-dip
        radius = length * math.tan((math.pi / 2 + i) / 2)
        scene = (ROOT / "examples/block_a_worn.yaml").read_text(encoding="utf-8")
        self.assertIn("model: paper", scene)
        self.agree(found("examples/block_a_worn.yaml", "block.rounded.corners.1.radius", "critical_angle=23.5"), radius)
        self.prints("is rounded by {:.3f} mm (model `paper`; Table 4 prints 3.36)", radius)


class Loads(Page):
    def test_earthquake(self):
        b, h, k = 2, 4, Fraction(3, 20)
        angle = math.atan((b - k * h) / (h + k * b)) / DEGREE
        self.agree(case("examples/block_seismic.yaml")["toppling"]["critical_angle_deg"], angle)
        self.prints("tan α = (b − k h)/(h + k b) = 1.4/4.3, {:.3f}°", angle)
        yields = (b - h * tan(15)) / (h + b * tan(15))
        self.agree(found("examples/block_seismic.yaml", "loads.seismic.horizontal", "fos=1"), yields)
        self.prints("k = (b − h tan 15°)/(h + b tan 15°) = {:.4f}", yields)

    def test_level_water(self):
        """The slab's moments by hand: weight 1040 kN, water 9.81 h^2/2 at h/3, both as the face stands at the tilt."""
        def moment(tilt):
            cosine = math.cos(tilt * DEGREE)
            return 1040 * (2.5 * math.sin(tilt * DEGREE) - 4 * cosine) + 9.81 * 3**3 / 6 / cosine**2
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder) / "water.yaml"
            scene.write_text("topple: 1\nlength_unit: m\nblock: {slab: {width: 8, height: 5}, unit_weight_kn_m3: 26}\n"
                             "base: {mated: true, beyond: {left: 1, right: 1}}\n"
                             "loads: {water: {height: 3, stays_level: true}}\ntilt: {towards: left}\n")
            own = case(scene)
        topples, overtops = bisect(moment, 20, 70), math.acos(3 / 5) / DEGREE
        self.agree(own["toppling"]["critical_angle_deg"], topples)
        self.agree(own["water_overtops_deg"], overtops)
        self.prints("overtopped at {:.3f}°, toppling at {:.3f}°", overtops, topples)


class Limit(Page):
    def test_block_e_towards_its_valley(self):
        """By the lines of two forces: at the toe and at the first peak, where friction acts up-dip, meeting the
        weight's."""
        _, a, _, c = TEETH_E
        i, phi = math.atan2(c, a), 30 * DEGREE
        steep, flat = math.tan(phi + i), math.tan(phi - i)
        cy = (a - c * steep) / (flat - steep)
        cx = cy * flat
        x, y = map(float, exact.centroid(exact.block_moments(exact.teeth(*TEETH_E, "valley"))))
        angle = math.atan2(x - cx, y - cy) / DEGREE
        own = case("examples/block_e_valley.yaml")["limit"]
        self.agree(own["critical_angle_deg"], angle)
        self.agree(own["centre_x_m"], cx / 1000)
        self.agree(own["centre_y_m"], cy / 1000)
        self.prints("φ = 30°: {:.3f}°, turning about (−{:.3f}, −{:.3f}) mm", angle, -cx, -cy)
        goes_on = own["otherwise"]["critical_angle_deg"]["value"]
        self.agree(goes_on, math.atan2(x, y) / DEGREE)  # moments about the toe
        self.prints("on a base that goes on for another tooth holds up to {:.3f}°", goes_on)

    def test_block_a_that_friction_could_hold(self):
        """Two facets that grip: forces at the ends of the first facet, one along each edge that friction gives."""
        x, y = exact.centroid(exact.block_moments(exact.teeth(3, 15, 94, 5, "peak")))
        moments = math.atan2(x, y - 5) / DEGREE
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder) / "a.yaml"
            text = (ROOT / "examples/block_a_peak.yaml").read_text(encoding="utf-8")
            scene.write_text(text.replace("friction_angle_deg: 30", "friction_angle_deg: 60"))
            own = case(scene)
        limit = self.least_over_all_twists(exact.teeth(3, 15, 94, 5, "peak")[:4], (float(x), float(y)), 60)
        self.agree(own["toppling"]["critical_angle_deg"], moments)
        self.agree(own["limit"]["critical_angle_deg"], limit)
        self.prints("with φ = 60°: moments {:.3f}°, static limit {:.3f}°", moments, limit)

    def least_over_all_twists(self, under, centroid, friction):
        """The least tilt at which an admissible twist, normal to two cone edges, gains from the weight."""
        columns = []
        for (x0, y0), (x1, y1) in zip(under, under[1:]):
            tx, ty = float(x1 - x0), float(y1 - y0)
            for px, py in ((float(x0), float(y0)), (float(x1), float(y1))):
                for sign in (1, -1):
                    fx, fy = -ty + sign * tan(friction) * tx, tx + sign * tan(friction) * ty
                    columns.append((fx, fy, px * fy - py * fx))
        gx, gy = centroid
        best = math.inf
        for k, p in enumerate(columns):
            for q in columns[:k]:
                v = (p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0])
                level, gain = -v[1] - gx * v[2], -v[0] + gy * v[2]  # v . F_c and v . F_s
                if gain < 0:
                    v, level, gain = [-c for c in v], -level, -gain
                least = min(sum(a * b for a, b in zip(v, c)) for c in columns)
                if gain > 0 and least > -1e-9 * max(map(abs, v)):
                    best = min(best, math.atan2(-level, gain) / DEGREE)
        return best


class FromRest(Page):
    def test_the_toe_slips(self):
        """Newton's law for the slab turning about its toe: the toe's force lies on the edge of the cone."""
        mass, width, height = 1.0, 1.0, 3.0
        inertia = mass * (width**2 + height**2) / 12
        arm = math.hypot(width, height) / 2
        lean = math.atan2(width, height)

        def excess(tilt):
            """Shear over pressure at the toe, less tan 30°."""
            a = tilt * DEGREE
            turn = mass * arm * math.sin(a - lean) / (inertia + mass * arm**2)
            across = -arm * math.cos(lean) * turn, arm * math.sin(lean) * turn  # acceleration of G
            shear, pressure = mass * (across[0] + math.sin(a)), mass * (across[1] + math.cos(a))
            return shear / pressure - tan(30)
        slips = bisect(excess, 20, 85)
        self.agree(slips, math.atan(tan(30 - lean / DEGREE) / 0.25) / DEGREE + lean / DEGREE)
        self.prints("with φ = 30° topples alone up to {:.3f}°", slips)


class Teeth(Page):
    def test_equations_15_and_16(self):
        """Every N, peaks and valleys, against moments by triangles."""
        self.prints("tan α_crit = (Δx/y) / (1 ∓ A/y − A²/(12 y²))")
        self.prints("an odd number of teeth adds ± A λ²/(2 Δx) to this numerator")
        a, b, c = Fraction(7, 2), Fraction(23), Fraction(5, 3)
        for count in range(1, 10):
            for end, sign in (("peak", 1), ("valley", -1)):
                x, y = exact.centroid(exact.block_moments(exact.teeth(count, a, b, c, end)))
                width, mean, wave = count * a, b + c / 2, 2 * a
                top = 12 * width * mean + (sign * c * wave**2 / (2 * width) if count % 2 else 0)
                below = 12 * mean**2 - sign * 12 * mean * c - c * c
                self.assertEqual(x / (y - (c if end == "peak" else 0)), top / below, (count, end))
                if count % 2 == 0:
                    self.assertEqual(top / below, width / mean / (1 - sign * c / mean - c * c / (12 * mean**2)))

    def test_mean_square_slope(self):
        """Of teeth it is tan^2 i: proven by the program about its own sums."""
        with tempfile.TemporaryDirectory() as folder:
            claims = pathlib.Path(folder) / "claims.yaml"
            claims.write_text("topple_claims: 1\ntitle: Slopes\n"
                              f"geometries:\n  e: {{scene: {ROOT}/examples/block_e_valley.yaml}}\n"
                              "claims:\n- {id: Z, where: here, geometry: e, quantity: mean_square_slope, "
                              "printed: c^2/a^2}\n")
            status, out, err = run("verify", claims)
            self.assertEqual((status, err), (0, ""))
            self.assertRegex(out, r"(?i)proven")


class Capacities(Page):
    def test_intervals_of_tilts(self):
        """The shares of section 6: not negative, 1 in sum, and the arc lies in its triangle."""
        self.prints("F(α) = B₀ F(a) + B₁ A + B₂ F(b)")
        for low, high in ((0.0, 0.4), (-1.1, 0.9), (0.2, 3.2)):
            middle, half = (low + high) / 2, (high - low) / 2
            for k in range(11):
                angle = low + k * (high - low) / 10
                up, down = math.sin((angle - low) / 2), math.sin((high - angle) / 2)
                shares = [down**2, 2 * down * up * math.cos(half), up**2]
                shares = [share / math.sin(half) ** 2 for share in shares]
                self.assertGreater(min(shares), -1e-15)
                self.agree(sum(shares), 1)
                for turn in (math.cos, math.sin):
                    parts = (turn(low), turn(middle) / math.cos(half), turn(high))
                    self.agree(sum(s * p for s, p in zip(shares, parts)), turn(angle))

    def test_numbers_of_the_code(self):
        """What the page says of budgets and rungs stands in the code."""
        for says, file, code in (
                ("take 6 · 10⁷ columns at 64 bits and 1000 more for each column, one of them a quarter of that",
                 "src/core/number/work.c", ("fixed = 6e7;", "by_column = 1000;", "share = 0.25")),
                ("160; exact sums and 320, 1280, 5120 bits", "src/core/number/ladder.c",
                 ("{TP_LEVEL_DOUBLE, 64}", "{TP_LEVEL_COMPENSATED, 128}", "{TP_LEVEL_BALL, TP_BALL_BITS}",
                  "{TP_LEVEL_EXACT, 320}", "{TP_LEVEL_EXACT, TP_SETTLING_BITS}", "{TP_LEVEL_EXACT, 5120}")),
                ("160; exact sums and 320, 1280, 5120 bits", "src/core/number/ladder.h",
                 ("TP_BALL_BITS = 160, TP_SETTLING_BITS = 1280",)),
                ("numbers that 1280 bits do not separate (160 for the limit", "src/statics/static_limit/limit_asked.c",
                 ("enclosed ? TP_BALL_BITS : TP_SETTLING_BITS",)),
                ("halved; 256 are tried, at most", "src/statics/certificate/interval.c", ("MOST_SAMPLES = 256",)),
                ("factors from 10⁻⁶ to 10⁶", "src/statics/strength_reduction/reduction.c", ("least_factor = 1e-6, most_factor = 1e6",)),
                ("no more than 70°", "src/statics/evaluation/friction.c", ("MOST_DEGREES = 70",)),
                ("between 2^(−b/2) and 2^(−b/4) degrees", "src/statics/certificate/bracket.c",
                 ("exponent = -bits / 2; exponent <= -bits / 4",))):
            self.assertIn(says, PAGE)
            text = (ROOT / file).read_text(encoding="utf-8")
            for part in code:
                self.assertIn(part, text, file)


if __name__ == "__main__":
    main()
