# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Base profiles made by rule: what is asked of them is in the coordinates that come out, to the spread of one sample.

Who explored irregular bases made them in scripts of his own, with coordinates that differed from one machine to the
next. Everything here is worked out anew from the CSV that the program writes: RMS height, Z2, exponent, wear."""

import cmath
import hashlib
import json
import math
import pathlib
import random
import tempfile
import unittest
from fractions import Fraction

from harness import ROOT, main, run, solve

SLAB = "block: {slab: {width: 3, height: 5}}"
TEETH = "teeth: {count: %d, wavelength: 60, amplitude: 5, left_end: valley%s}"
ROUGH = "self_affine: {length: %s, step: %s, hurst: %s, %s, seed: %d%s}"
FAR = "block: {outline: [[0, 1000], [1, 1000], [1, 1001]]}"  # set down on any of them


def scene(profile, block=FAR, base="place: rest", more=""):
    return f"topple: 1\nlength_unit: mm\n{block}\nbase: {{profile: {{{profile}}}, {base}}}\n{more}"


def transform(values):
    """The discrete Fourier transform of a power of two of numbers."""
    if len(values) == 1:
        return list(values)
    even, odd = transform(values[::2]), transform(values[1::2])
    turned = [cmath.exp(-2j * math.pi * k / len(values)) * z for k, z in enumerate(odd)]
    return [a + b for a, b in zip(even, turned)] + [a - b for a, b in zip(even, turned)]


def slope(x, y):
    mean_x, mean_y = math.fsum(x) / len(x), math.fsum(y) / len(y)
    return (math.fsum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / math.fsum((a - mean_x) ** 2 for a in x))


def height(points, x):
    """Of a profile without upright steps."""
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        if x0 <= x <= x1:
            return y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    raise ValueError(x)


class Generate(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def write(self, text, name="scene.yaml"):
        (self.path / name).write_text(text)
        return self.path / name

    def profile(self, made, **more):
        """Its CSV, and its points."""
        status, _, err = run("solve", self.write(scene(made, **more)), "--write-profile", self.path / "out.csv")
        self.assertEqual((status, err), (0, ""), made)
        text = (self.path / "out.csv").read_text()
        lines = text.splitlines()
        self.assertEqual(lines[0], "x,y")
        return text, [tuple(map(Fraction, line.split(","))) for line in lines[1:]]

    def rough(self, length, step, hurst, target, seed, more=""):
        middle = Fraction(length) / 2
        low, high = middle - 3, middle + 3
        block = f"block: {{outline: [[{low}, 999], [{high}, 999], [{high}, 1001], [{low}, 1001]]}}"
        return self.profile(ROUGH % (length, step, hurst, target, seed, more), block=block)

    def test_targets(self):
        """RMS height about the mean line, Z2, and the Z2 of a JRC, to the rounding of the heights:
        a millionth of the RMS."""
        for seed, (target, value) in enumerate((("rms_height", 2), ("rms_height", 0.037), ("z2", 0.25), ("jrc", 0),
                                                ("jrc", 12.5), ("jrc", 20))):
            _, points = self.rough("128", "0.5", "0.7", f"{target}: {value}", seed)
            self.assertEqual([x for x, _ in points], [Fraction(k, 2) for k in range(257)])
            y = [float(y) for _, y in points]
            rms = math.sqrt(math.fsum(v * v for v in y) / len(y))
            z2 = math.sqrt(math.fsum((b - a) ** 2 for a, b in zip(y, y[1:])) / 256) / 0.5
            self.assertAlmostEqual(math.fsum(y) / len(y), 0, delta=1e-6 * rms)
            self.assertAlmostEqual(slope([k for k in range(257)], y) * 257, 0, delta=1e-5 * rms)
            if target == "rms_height":
                self.assertAlmostEqual(rms / value, 1, delta=1e-6)
            elif target == "z2":
                self.assertAlmostEqual(z2 / value, 1, delta=1e-5)
            else:
                self.assertAlmostEqual(32.2 + 32.47 * math.log10(z2), value, delta=1e-3)

    def test_exponent(self):
        """The periodogram of what was made, with a Hann window, falls as frequency^-(2 H + 1). The
        logarithm of an ordinate has the spread pi / sqrt 6, and by the window some two of three are
        independent: over these ordinates the slope has a standard deviation of 0.1, H half of that,
        and the mean over the seeds 0.02: three times that is allowed."""
        seeds, used = 6, range(8, 400)
        for hurst in ("0.3", "0.5", "0.8"):
            found = []
            for seed in range(seeds):
                _, points = self.rough("1023", "1", hurst, "rms_height: 5", seed)
                powers = transform([float(v) * (1 - math.cos(2 * math.pi * (k + 0.5) / 1024))
                                    for k, (_, v) in enumerate(points)])
                fall = -slope([math.log(k) for k in used], [2 * math.log(abs(powers[k])) for k in used])
                found.append((fall - 1) / 2)
            self.assertAlmostEqual(math.fsum(found) / seeds, float(hurst), delta=0.06, msg=str(found))

    def test_cut_offs(self):
        """Nothing but leakage beyond the cut-offs: waves from 16 to 64 long hold all but a hundredth of the power."""
        _, points = self.rough("1023", "1", "0.5", "rms_height: 1", 9, ", shortest: 16, longest: 64")
        y = [float(v) * (1 - math.cos(2 * math.pi * (k + 0.5) / 1024)) for k, (_, v) in enumerate(points)]
        powers = [abs(z) ** 2 for z in transform(y)[:512]]
        self.assertGreater(math.fsum(powers[14:67]) / math.fsum(powers), 0.99)

    def test_same_everywhere(self):
        """The same seed gives these very bytes, on every machine; another seed others."""
        text, _ = self.rough("100", "0.25", "0.8", "jrc: 8", 7)
        self.assertEqual(hashlib.sha256(text.encode()).hexdigest(), ROUGH_SUM)
        self.assertEqual(text, self.rough("100", "0.25", "0.8", "jrc: 8", 7)[0])
        self.assertNotEqual(text, self.rough("100", "0.25", "0.8", "jrc: 8", 8)[0])
        scattered = ", seed: 3, skew: 0.2, scatter: {wavelength: 0.3, amplitude: 0.4, skew: 0.1}"
        text, _ = self.profile(TEETH % (40, scattered) + ", noise: {deviation: 0.01, seed: 4}, worn: {rounded: 0.05}",
                               block=WIDE)
        self.assertEqual(hashlib.sha256(text.encode()).hexdigest(), TEETH_SUM)

    def test_measured_again(self):
        """`topple profile` finds in it the Z2 of the JRC that was asked for, and that JRC."""
        path = self.write(scene(ROUGH % ("100", "0.5", "0.8", "jrc: 11.5", 1, ""), block=WIDE))
        status, out, err = run("profile", "--json", path)
        self.assertEqual((status, err), (0, ""))
        told = json.loads(out)
        self.assertAlmostEqual(told["z2"]["value"], 10 ** ((11.5 - 32.2) / 32.47), delta=1e-5)
        jrc = [row["jrc"]["value"] for row in told["jrc"]["correlations"] if "Tse" in row["source"]]
        self.assertEqual(len(jrc), 1)
        self.assertAlmostEqual(jrc[0], 11.5, delta=1e-3)

    def test_note_on_jrc(self):
        """A profile of a wanted JRC is none of Barton's, and says so, with the step that the
        regression is meant for."""
        done = solve(self.write(scene(ROUGH % ("100", "0.5", "0.8", "jrc: 8", 1, ""), block=WIDE)))
        notes = [note["text"] for note in done["notes"]]
        said = ("none of Barton's profiles", "Tse and Cruden (1979)", "0.508 mm", "0.5 mm apart")
        self.assertTrue(any(all(words in note for words in said) for note in notes), notes)

    def test_teeth_as_mated(self):
        """Regular teeth are the base of the paper's blocks: everything that is told of the block is
        that of a mated base."""
        block = ("block: {teeth: {count: 3, width: 30, height: 120, depth: 5, left_end: valley}, "
                 "unit_weight_kn_m3: 25.8}\nfriction_angle_deg: 30\ntilt: {angle_deg: 20}\n")
        own = solve(self.write(scene(TEETH % (7, ", start: [-60, 0]"), block=block, base="place: as_given")))
        mated = solve(self.write(f"topple: 1\nlength_unit: mm\n{block}"
                                 "base: {mated: true, beyond: {left: 60, right: 60}}\n"))
        for mine, other in zip(own["cases"], mated["cases"], strict=True):
            for key in ("pivots", "toppling", "sliding", "limit", "onset", "governing_fos", "mechanism"):
                self.assertEqual(mine[key], other[key], key)

    def test_teeth_in_formulas(self):
        """(A1.1) and its like come out of the generated base as of the mated one; a symbol in its rule is refused."""
        text = ("topple: 1\nlength_unit: mm\nparameters: {a: 30, b: 120, c: 5}\n"
                "block: {teeth: {count: 3, width: a, height: b, depth: c, left_end: valley}}\nbase: {%s}\n")
        formulas = [run("derive", self.write(text % base))[1]
                    for base in ("profile: {" + TEETH % (3, "") + "}", "mated: true")]
        self.assertIn("tan(alpha_crit) = (27*a*b + 13*a*c)/(9*b^2 + 18*b*c + 6*c^2)", formulas[0])
        self.assertEqual(*formulas)
        symbol = text % ("profile: {" + (TEETH % (3, "")).replace("60", "2*a") + "}")
        status, _, err = run("derive", self.write(symbol))
        self.assertEqual(status, 3)
        self.assertIn(":5:48: derive takes a profile made by rule by its numbers, and 'a' stands for any", err)
        self.assertEqual(run("solve", self.path / "scene.yaml")[0], 0)

    def test_scattered_teeth(self):
        """Every tooth within its ranges, as far as both ends of them in 400 teeth; valleys at one height."""
        scattered = ", seed: 11, skew: 0.25, scatter: {wavelength: 0.2, amplitude: 0.5, skew: 0.25}"
        _, points = self.profile(TEETH % (800, scattered), block=WIDE)
        self.assertEqual({y for _, y in points[::2]}, {0})
        widths, skews = [], []
        for (x0, _), (x1, _), (x2, _) in zip(points[::2], points[1::2], points[2::2]):
            widths.append(float(x2 - x0) / 60)
            skews.append(float((x1 - x0) - (x2 - x1)) / float(x2 - x0))
        heights = [float(y) / 5 for _, y in points[1::2]]
        for values, middle, scatter in ((widths, 1, 0.2), (skews, 0.25, 0.25), (heights, 1, 0.5)):
            self.assertEqual(len(values), 400)
            self.assertLess(max(abs(v - middle) for v in values), scatter * 1.0001)
            for end in (-1, 1):
                self.assertGreater(max(end * (v - middle) for v in values), 0.97 * scatter)  # 1 in 10^2.6 misses
            self.assertAlmostEqual(math.fsum(values) / 400, middle, delta=4 * scatter / math.sqrt(1200))
        only, _ = self.profile(TEETH % (800, ", seed: 11, scatter: {amplitude: 0.5}"), block=WIDE)
        self.assertIn("\n30,", only)

    def test_noise(self):
        """Points move along y alone, by six deviations at most, with their standard deviation and mean."""
        line = [(Fraction(k, 3), Fraction(k % 7, 7)) for k in range(3000)]
        self.write("\n".join(f"{x},{y}" for x, y in line), "line.csv")
        _, points = self.profile("measured: line.csv, noise: {deviation: 0.05, seed: 2}", block=WIDE)
        self.assertEqual([x for x, _ in points], [x for x, _ in line])
        moved = [float(b - a) for (_, a), (_, b) in zip(line, points)]
        self.assertLess(max(map(abs, moved)), 6 * 0.05)
        self.assertAlmostEqual(math.fsum(moved) / 3000, 0, delta=4 * 0.05 / math.sqrt(3000))
        deviation = math.sqrt(math.fsum(m * m for m in moved) / 3000)
        self.assertAlmostEqual(deviation, 0.05, delta=4 * 0.05 / math.sqrt(6000))

    def test_wear(self):
        """Cut: the lower of the profile and the level, everywhere. Abraded: above the mean in
        proportion. Rounded: never above what was there, lower than it by at most the depth, and at a
        tip by the depth, or by all that half of its edges allow."""
        draw = random.Random(5)
        for _ in range(4):
            line = [(Fraction(k), Fraction(draw.randint(0, 4000), 1000)) for k in range(60)]
            self.write("\n".join(f"{x},{float(y)}" for x, y in line), "line.csv")
            top = max(y for _, y in line)
            worn = {how: self.profile(f"measured: line.csv, worn: {{{how}: 0.7}}", block=NARROW)[1]
                    for how in ("cut", "abraded", "rounded")}
            mean = sum(y for _, y in line) / len(line)
            depth = Fraction(7, 10)
            for k in range(1, 590):
                x = Fraction(k, 10) + Fraction(1, 37)
                before = height(line, x)
                self.assertAlmostEqual(height(worn["cut"], x), min(before, top - depth), delta=1e-5)
                after = height(worn["rounded"], x)
                self.assertLess(after, before + Fraction(1, 10 ** 6))
                self.assertGreater(after, before - depth - Fraction(1, 10 ** 6))
            for (x, y), (_, after) in zip(line, worn["abraded"], strict=True):
                left = y if y <= mean else mean + (y - mean) * (1 - depth / (top - mean))
                self.assertAlmostEqual(after, left, delta=1e-6)
            for (x, y), a, b in zip(line[1:-1], line, line[2:]):
                blunt = min(depth, (2 * y - a[1] - b[1]) / 8)
                self.assertAlmostEqual(height(worn["rounded"], x), y - max(blunt, 0), delta=1e-5)

    def test_written_and_read(self):
        """A scene that reads the CSV is the scene that made it."""
        made = ROOT / "examples" / "boulder_on_rough_ground.yaml"
        own = run("solve", "--json", made, "--write-profile", self.path / "ground.csv")
        lines = [line for line in made.read_text().splitlines() if "self_affine" not in line]
        text = "\n".join(lines).replace("  profile:", "  profile: ground.csv")
        case, other = solve(made)["cases"][0], solve(self.write(text))["cases"][0]
        self.assertEqual(own[0], 0)
        for key in ("rest", "pivots", "limit", "mechanism"):
            self.assertEqual(case[key], other[key], key)
        status, _, err = run("solve", self.path / "scene.yaml", "--write-profile", self.path / "ground.csv")
        self.assertEqual(status, 3)
        self.assertIn("would be lost", err)

    def test_found(self):
        """A number within the rule is found as others are: the slope of one facet at which a wedge
        on it topples at 35 degrees, solved anew at what was found."""
        text = ("topple: 1\nlength_unit: mm\nparameters: {h: %s}\n"
                "block: {outline: [[0, h], [40, 0], [40, 80], [0, 80]]}\n"
                "tilt: {towards: left}\n"
                "base: {profile: {teeth: {count: 1, wavelength: 80, amplitude: h, left_end: peak}}}\n")
        status, out, err = run("solve", "--json", self.write(text % 5), "--find", "h", "--for", "critical_angle=35",
                               "--from", 1, "--to", 60)
        self.assertEqual((status, err), (0, ""))
        found = json.loads(out)["find"]["solutions"]
        self.assertGreater(len(found), 0)
        case = solve(self.write(text % found[0]["value"]))["cases"][0]
        self.assertAlmostEqual(case["toppling"]["critical_angle_deg"]["value"], 35, delta=1e-7)

    def test_bad_input(self):
        """Where, what, and what is right instead."""
        for made, expected in (
                (ROUGH % ("40", "0.3", "0.8", "jrc: 8", 1, ""),
                 ":4:50: the length must be a whole number of steps, from 8 to 4194303; it is 400/3"),
                (ROUGH % ("40", "0.5", "1", "jrc: 8", 1, ""),
                 "hurst must lie strictly between 0 and 1; it is 1"),
                (ROUGH % ("40", "0.5", "0.5", "jrc: 21", 1, ""),
                 "jrc must lie between 0 and 20; it is 21"),
                (ROUGH % ("40", "0.5", "0.5", "jrc: 8, z2: 1", 1, ""),
                 "one of rms_height, z2 and jrc"),
                (ROUGH % ("40", "0.5", "0.5", "z2: 0", 1, ""),
                 "z2 must lie between 0.000001 and 1000; it is 0"),
                (ROUGH % ("40", "0.5", "0.5", "jrc: 8", -1, ""), "seed must not be negative"),
                (ROUGH % ("40", "0.5", "0.5", "jrc: 8", 2 ** 63, ""),
                 "a seed is a whole number from 0 to 9223372036854775807"),
                ((ROUGH % ("40", "0.5", "0.5", "jrc: 8", 1, "")).replace(", seed: 1", ""),
                 "'seed' is missing here"),
                (ROUGH % ("40", "0.5", "0.5", "jrc: 8", 1, ", shortest: 0.9"),
                 "wavelengths go from 'shortest'"),
                (ROUGH % ("40", "0.5", "0.5", "jrc: 8", 1, ", longest: 41"), "at most the length"),
                (ROUGH % ("40", "0.5", "0.5", "jrc: 8", 1, ", shortest: 20, longest: 20.1"),
                 "no wave of the profile's period"),
                (TEETH % (4, ", scatter: {skew: 0.5}"), "'seed' is missing here"),
                (TEETH % (4, ", skew: 0.5, scatter: {skew: 0.5}"), "together at most 0.9"),
                (TEETH % (4, ", scatter: {amplitude: 1.1}"), "amplitude must lie between 0 and 1"),
                (TEETH % (0, ""), "a whole number of teeth, at least 1"),
                (TEETH % (4, "") + ", worn: {cut: 5}",
                 "'cut' takes off all of the roughness: the highest point stands 5 above"),
                (TEETH % (4, "") + ", worn: {cut: 1, rounded: 1}",
                 "one of cut, rounded and abraded"),
                (TEETH % (4, "") + ", noise: {deviation: 0, seed: 1}",
                 "deviation must be above zero"),
                (TEETH % (4, "") + ", measured: [[0, 0], [1, 1]]",
                 "begins with one of teeth, self_affine and measured"),
                ("noise: {deviation: 1, seed: 1}",
                 "begins with one of teeth, self_affine and measured"),
                (ROUGH % ("40", "0.5", "0.5", "rms_height: 1e308", 1, ""),
                 ":4:17: the profile's y is outside the range"),
                ("measured: nowhere.csv", "nowhere.csv: cannot be opened"),
                ("self_afine: {}", "did you mean 'self_affine'?")):
            status, out, err = run("solve", self.write(scene(made)), "--write-profile", self.path / "none.csv")
            self.assertEqual((status, out), (3, ""), made)
            self.assertIn(expected, err, made)
            self.assertFalse((self.path / "none.csv").exists())
        status, _, err = run("solve", ROOT / "examples" / "slab.yaml", "--write-profile", self.path / "none.csv")
        self.assertIn("the base has no profile of its own", err)


NARROW = "block: {outline: [[20, 90], [40, 90], [40, 92], [20, 92]]}"
WIDE = "block: {outline: [[40, 999], [60, 999], [60, 1001], [40, 1001]]}"
ROUGH_SUM = "9f2741e406b78795d0a70d8cf6b1065edb29c557e23ecdd7802460f03306bb91"
TEETH_SUM = "823112bedd181e71b0131778ab2a4974da42f24e94e24ebc9b99393f0e8dff1b"

if __name__ == "__main__":
    main()
