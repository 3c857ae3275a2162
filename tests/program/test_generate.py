# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Base profiles made by rule: what is asked of them is in the coordinates that come out, to the spread of one sample.

Who explored irregular bases made them in scripts of his own, with coordinates that differed from one machine to the
next. Everything here is worked out anew from the CSV that the program writes: RMS height, Z2, exponent, cut-offs; the
same seed gives the same bytes, which a scene reads as the profile that was made; what cannot be made is refused."""

import cmath
import hashlib
import json
import math
from fractions import Fraction

from generate_case import TEETH, WIDE, GenerateCase, scene
from harness import ROOT, main, run, solve

ROUGH = "self_affine: {length: %s, step: %s, hurst: %s, %s, seed: %d%s}"
ROUGH_SUM = "9f2741e406b78795d0a70d8cf6b1065edb29c557e23ecdd7802460f03306bb91"
TEETH_SUM = "823112bedd181e71b0131778ab2a4974da42f24e94e24ebc9b99393f0e8dff1b"


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


class Generate(GenerateCase):
    def rough(self, length, step, hurst, target, seed, more=""):
        middle = Fraction(length) / 2
        low, high = middle - 3, middle + 3
        block = f"block: {{outline: [[{low}, 999], [{high}, 999], [{high}, 1001], [{low}, 1001]]}}"
        return self.profile(ROUGH % (length, step, hurst, target, seed, more), block=block)

    def test_structure_function_leans_to_the_middle(self):
        """Waves of two steps to the length alone: the structure function expected of them, worked out here from the amplitudes
        that the page states, has an exponent off 2 H; so have profiles, by the CSV and as `topple profile` tells it, and the
        table of the page."""
        lags, steps, seeds = range(1, 11), 400, 12
        period = next(2**k for k in range(20) if 2**k >= 1.25 * steps)
        logs = [math.log(d) for d in lags]
        page = (ROOT / "docs" / "generate.md").read_text()
        rows = {line.split("|")[1].strip(): [cell.strip() for cell in line.split("|")[2:-1]] for line in page.splitlines()
                if line.startswith("| `hurst` | 0.3") or line.startswith("| by the structure function") or
                line.startswith("| mean of 40")}
        for hurst, told, mean in zip(*rows.values()):
            waves = [(k, k ** -(2 * float(hurst) + 1)) for k in range(math.ceil(period / steps), period // 2 + 1)]
            expected = slope(logs, [math.log(math.fsum(a * (1 - math.cos(2 * math.pi * k * d / period)) for k, a in waves))
                                    for d in lags]) / 2
            self.assertEqual(f"{expected:.3f}", told)
            self.assertAlmostEqual(float(mean), expected, delta=0.01)
            if hurst not in ("0.3", "0.9"):
                continue
            self.assertGreater(abs(expected - float(hurst)), 0.07)
            sums, reported = [0] * len(lags), []
            for seed in range(1, seeds + 1):
                _, points = self.rough(str(steps), "1", hurst, "rms_height: 3", seed)
                y = [float(v) for _, v in points]
                for j, d in enumerate(lags):
                    sums[j] += math.fsum((b - a) ** 2 for a, b in zip(y, y[d:])) / (len(y) - d)
                out = run("profile", "--json", self.path / "scene.yaml")[1]
                reported.append(next(own["exponent"]["value"] for own in json.loads(out)["hurst"] if own["by"] == "structure function"))
            self.assertAlmostEqual(slope(logs, [math.log(s) for s in sums]) / 2, expected, delta=0.02)
            self.assertAlmostEqual(math.fsum(reported) / seeds, expected, delta=0.02)
        self.assertIn("biased to the middle by cut-off waves", run("profile", self.path / "scene.yaml")[1])

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

    def test_bad_input(self):
        """Where, what, and what is right instead."""
        for made, expected in (
                (ROUGH % ("40", "0.3", "0.8", "jrc: 8", 1, ""),
                 ":4:50: the length must be a whole number of steps, from 8 to 499999; it is 400/3"),
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
                 "'cut' removes all of the roughness: the highest point stands 5 above"),
                (TEETH % (4, "") + ", worn: {cut: 1, rounded: 1}",
                 "one of cut, rounded and abraded"),
                (TEETH % (4, "") + ", noise: {deviation: 0, seed: 1}",
                 "deviation must be above zero"),
                (TEETH % (4, "") + ", measured: [[0, 0], [1, 1]]",
                 "begins with one of teeth, self_affine, jrc_profile and measured"),
                ("noise: {deviation: 1, seed: 1}",
                 "begins with one of teeth, self_affine, jrc_profile and measured"),
                (ROUGH % ("40", "0.5", "0.5", "rms_height: 1e308", 1, ""),
                 ":4:17: the profile's y is outside the range"),
                ("self_afine: {}", "did you mean 'self_affine'?")):
            status, out, err = run("solve", self.write(scene(made)), "--write-profile", self.path / "none.csv")
            self.assertEqual((status, out), (3, ""), made)
            self.assertIn(expected, err, made)
            self.assertFalse((self.path / "none.csv").exists())
        status, _, err = run("solve", ROOT / "examples" / "slab.yaml", "--write-profile", self.path / "none.csv")
        self.assertIn("the base has no separate profile", err)


if __name__ == "__main__":
    main()
