# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""`topple trace`: the outline of a block in a picture.

The story: a geologist has a photograph with a ranging rod and a plumb line in it. In pictures that the tests paint the
outline is known: what is traced must lie in the band that the scene states, by noise and blur, to scale and upright; a
study must be able to use the band."""

import hashlib
import json
import math
import os
import pathlib
import re
import runpy
import tempfile
import unittest

from harness import PROGRAM, ROOT, main, rounds, run
from trace_case import area, away, centroid, ellipse, paint, perimeter, read_png, turned

BUILD = pathlib.Path(os.environ.get("TOPPLE_BUILD", pathlib.Path(PROGRAM).parent))
SHAPES = {
    "boulder": ellipse(160, 130, 95, 62, 0.2),
    "slab": turned([(70, 60), (250, 60), (250, 190), (70, 190)], math.radians(12), (160, 125)),
    "notched": [(70, 60), (180, 45), (190, 110), (255, 120), (240, 205), (85, 195)],
    "grown": [(160 + r * math.cos(t), 122 + 0.8 * r * math.sin(t)) for t, r in
              ((2 * math.pi * k / 400, 88 + 9 * math.sin(10 * math.pi * k / 400) + 5 * math.cos(26 * math.pi * k / 400))
               for k in range(400))],
}
BAR = "--scale=20,230,120,230,2.5"  # a fortieth of a metre a pixel
PER_PIXEL = 0.025


@unittest.skipUnless((BUILD / "libtopple-trace.so").exists(), "topple trace was not built")
class Trace(unittest.TestCase):
    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.holder.name)

    def tearDown(self):
        self.holder.cleanup()

    def trace(self, *words, around="25,20,295,222", scale=BAR):
        """What it found, and the block of the scene that it wrote."""
        status, out, err = run("trace", "p.png", f"--around={around}", scale, "-o", "scene.yaml", "--json", *words,
                               folder=self.folder)
        self.assertEqual((status, err), (0, ""))
        return json.loads(out), self.solve()

    def solve(self, *words):
        status, out, err = run("solve", "--json", *words, "scene.yaml", folder=self.folder)
        self.assertEqual((status, err), (0, ""))
        return json.loads(out)["cases"][0]

    def points(self, found, upright=0):
        """The outline of the scene in pixels of the picture, about its centroid."""
        text = (self.folder / "scene.yaml").read_text()
        rows = [line.strip(" -[]") for line in text.splitlines() if line.startswith("  - [")]
        own = [(float(x.split()[0]), -float(y.split()[0])) for x, y in (row.split(", ") for row in rows)]
        scale = found["m_per_px"]
        own = [(x / scale, y / scale) for x, y in own]
        x, y = centroid(own)
        return turned([(p - x, q - y) for p, q in own], -upright, (0, 0))

    def in_band(self, found, points, case):
        """The area within two deviations all around; nine in ten vertices within three, one pixel for corners, and the
        tolerance, none farther off than the wedge between a block and its horizon that is too narrow to be seen in noise."""
        per_pixel = found["m_per_px"]
        deviation, tolerance = found["deviation_px"], found["tolerance_m"] / per_pixel
        wrong = abs(found["area_m2"] / per_pixel ** 2 - abs(area(points))) / perimeter(points)
        self.assertLess(wrong, 2 * deviation)
        x, y = centroid(points)
        off = sorted(away((p + x, q + y), points) for p, q in self.points(found))
        self.assertLess(off[len(off) * 9 // 10], 3 * deviation + tolerance + 1)
        self.assertLess(off[-1], 8)
        self.assertAlmostEqual(case["block"]["area_m2"]["value"], found["area_m2"], delta=found["area_m2"] * 0.002)

    def test_shapes_with_noise_and_blur(self):
        """Each shape in the worst of the pictures and in one other; under `./check --long` in all of them."""
        for k, (name, points) in enumerate(SHAPES.items()):
            better = ((0, 0), (8, 0.8))
            for noise, blur in (*rounds(better[k % 2:k % 2 + 1], better), (16, 1.8)):
                with self.subTest(name, noise=noise, blur=blur):
                    paint(self.folder / "p.png", points, noise=noise, blur=blur)
                    found, case = self.trace()
                    self.in_band(found, points, case)
                    self.assertAlmostEqual(found["m_per_px"], PER_PIXEL, 12)
                    self.assertLess(found["deviation_px"], 1 + 1.5 * blur)
                    self.assertGreater(found["edge_px"], 0.7 * blur)
                    self.assertEqual((found["touching_share"], found["length_unit"]), (0, "m"))

    def test_in_grey(self):
        paint(self.folder / "p.png", SHAPES["slab"], rock=(60, 60, 60), grey=True)
        found, case = self.trace()
        self.in_band(found, SHAPES["slab"], case)

    def test_a_rough_polygon(self):
        """Around the notch, of any sense; the same outline as from a rectangle, within the band."""
        points = SHAPES["notched"]
        paint(self.folder / "p.png", points)
        ring = [(58, 48), (190, 32), (205, 98), (268, 108), (252, 218), (72, 208)]
        for own in (ring, ring[::-1]):
            found, case = self.trace(around=",".join(f"{x},{y}" for x, y in own))
            self.in_band(found, points, case)

    def test_upright_by_a_plumb_line(self):
        """The camera was held askew by 9 degrees: by the line the slab stands as it stood, its base level, whichever end of
        the line is given first; without it, it leans."""
        upright = [(90, 60), (230, 60), (230, 180), (90, 180)]
        askew = math.radians(9)
        paint(self.folder / "p.png", turned(upright, askew, (160, 120)), noise=5)
        top, bottom = turned([(300, 50), (300, 150)], askew, (160, 120))
        for ends in ((top, bottom), (bottom, top)):
            found, case = self.trace("--plumb=" + ",".join(f"{c:.4f}" for p in ends for c in p))
            self.assertAlmostEqual(found["plumb_deg"], -9, 3)
            level = [(-70, -60), (70, -60), (70, 60), (-70, 60)]
            self.assertLess(max(away(p, level) for p in self.points(found)), 3.5)
            self.assertLess(abs(case["frame"]["dip_deg"]["value"]) if "frame" in case else 0, 1)
        leaning, _ = self.trace()
        self.assertEqual(leaning["plumb_deg"], 0)

    def test_units_and_the_same_bytes_again(self):
        paint(self.folder / "p.png", SHAPES["boulder"])
        found, case = self.trace("--unit=ft", scale="--scale=20,230,120,230,8")
        first = (self.folder / "scene.yaml").read_bytes()
        self.assertIn(b"length_unit: ft", first)
        self.assertAlmostEqual(case["block"]["area_m2"]["value"], found["area_m2"], delta=found["area_m2"] * 2e-4)
        self.trace("--unit=ft", scale="--scale=20,230,120,230,8")
        self.assertEqual((self.folder / "scene.yaml").read_bytes(), first)
        status, out, err = run("trace", "p.png", "--around=25,20,295,222", "--scale=20,230,120,230,8", "-uft",
                               folder=self.folder)
        self.assertEqual((status, out.encode(), err), (0, first, ""))

    def test_what_no_picture_shows(self):
        """The scene is whole where the options say the rest: its weight is the area times what they say, its friction
        theirs. What is not said is in no scene, neither as a supposition, and both are told."""
        paint(self.folder / "p.png", SHAPES["slab"])
        words = ("trace", "p.png", "--around=25,20,295,222", BAR, "-o", "scene.yaml")
        status, out, err = run(*words, folder=self.folder)
        self.assertEqual((status, err), (0, ""))
        for missing in ("Missing  a friction angle (--friction)", "Missing  a unit weight (--unit-weight)"):
            self.assertIn(missing, out)
        case, text = self.solve(), (self.folder / "scene.yaml").read_text()
        self.assertNotIn("sliding", case)
        self.assertIsNone(case["block"].get("weight_n"))
        self.assertIn("# friction_angle_deg: 30    # missing: ", text)
        self.assertIn("# unit_weight_kn_m3: 26   # missing: ", text)
        title = 'A "slab": \x1b[1m<b>'
        status, out, err = run(*words, "--friction=41.5", "--unit-weight", "78/3", "--thickness=0.5", "--title", title,
                               "--between=" + ",".join(str(c) for p in SHAPES["slab"][2:] for c in p), folder=self.folder)
        self.assertEqual((status, err), (0, ""))
        self.assertNotIn("Missing", out)
        case = self.solve()
        self.assertNotIn("missing", (self.folder / "scene.yaml").read_text())
        self.assertAlmostEqual(case["block"]["weight_n"]["value"], 26e3 * 0.5 * case["block"]["area_m2"]["value"], 5)
        status, out, err = run("solve", "scene.yaml", folder=self.folder)
        self.assertTrue(out.startswith('A "slab": \\x1B[1m<b>\n'), out[:60])
        self.assertEqual(case["sliding"]["friction_angle_deg"], {"value": 41.5, "error": 0})

    def test_where_the_contact_ends(self):
        """An ellipse whose underside would be contact up to where it is steeper than 45°: between two points of the picture
        it touches there alone, within the tolerance, whichever is named first, however the outline moves in and out; the
        figure shows the part in green. Without them the report says what is taken."""
        paint(self.folder / "p.png", SHAPES["boulder"])
        words = ("trace", "p.png", "--around=25,20,295,222", BAR, "-o", "scene.yaml", "--figure=f.png")
        status, out, err = run(*words, folder=self.folder)
        self.assertEqual((status, err), (0, ""))
        self.assertIn("Missing  where the contact ends (--between)", out)
        wide = self.solve()["contact"]["length_m"]["value"]
        under = [p for p in SHAPES["boulder"] if p[1] > 130]
        ends = [min(under, key=lambda p: abs(p[0] - x)) for x in (140, 200)]
        found = []
        for first, second in (ends, ends[::-1]):
            status, out, err = run(*words, f"--between={first[0]},{first[1]},{second[0]},{second[1]}", folder=self.folder)
            self.assertEqual((status, err), (0, ""))
            self.assertNotIn("where the contact ends", out)
            self.assertLessEqual(json.loads(run(*words, "--json", f"--between={first[0]},{first[1]},{second[0]},{second[1]}",
                                                folder=self.folder)[1])["between_px"], 12)
            away_px = float(re.search(r"Contact  ends in vertices of the outline ([\d.]+) pixels", out)[1])
            self.assertLess(away_px, 12)
            for offset in (-0.05, 0, 0.05):
                contact = self.solve(f"--set=outline_offset={offset}")["contact"]["length_m"]["value"]
                self.assertAlmostEqual(contact, math.dist(*ends) * PER_PIXEL, delta=2.5 * away_px * PER_PIXEL)
                self.assertLess(contact, 0.7 * wide)
            text = (self.folder / "scene.yaml").read_text()
            found.append([line for line in text.splitlines() if not line.startswith("# --scale")])
        self.assertEqual(found[0], found[1])
        _, _, rows = read_png(self.folder / "f.png")
        self.assertGreater(sum(g > 140 and r < 40 and b < 140 for row in rows for r, g, b in row), 500)

    def test_an_outline_that_was_clicked(self):
        """The corners of a slab clicked in either sense, or out of a file, are its outline to the last digit, to scale: 0.01 m
        a pixel. Its band is that of a place within a pixel, and says what it is not."""
        paint(self.folder / "p.png", SHAPES["slab"])
        corners = [(80, 60), (230, 60), (230, 180), (80, 180)]
        (self.folder / "c.csv").write_text("x_px,y_px\n" + "".join(f"{x},{y}\n" for x, y in corners))
        scenes = []
        for words in (corners, corners[::-1], None):
            outline = "c.csv" if words is None else ",".join(f"{c}" for point in words for c in point)
            status, out, err = run("trace", "p.png", f"--outline={outline}", "--scale=20,230,120,230,1", "--plumb=10,10,10,200",
                                   "--between=80,180,230,180", "-o", "scene.yaml", folder=self.folder)
            self.assertEqual((status, err), (0, ""))
            self.assertIn("0.29 pixels: a place within a pixel", out)
            self.assertIn("It is the precision in the picture alone", out)
            self.assertNotIn("misses", out)
            case = self.solve()
            self.assertAlmostEqual(case["block"]["area_m2"]["value"], 1.5 * 1.2, delta=1e-9)
            scenes.append(sorted(line for line in (self.folder / "scene.yaml").read_text().splitlines() if "  - [" in line))
        self.assertEqual(scenes[0], scenes[1])
        self.assertEqual(scenes[0], scenes[2])
        found = json.loads(run("trace", "p.png", "--outline=c.csv", BAR, "-o", "scene.yaml", "--json", folder=self.folder)[1])
        self.assertEqual((found["outline_given"], found["points"]), (True, 4))
        self.assertAlmostEqual(found["deviation_px"], 12 ** -0.5, delta=1e-8)

    def test_clicks_that_are_no_outline(self):
        paint(self.folder / "p.png", SHAPES["slab"])
        (self.folder / "mm.csv").write_text("x_mm,y_mm\n80,60\n230,60\n230,180\n")
        (self.folder / "two.csv").write_text("x,y\n80,60\n230,60\n")
        for outline, status, word in (("80,60,230,180,230,60,80,150", 3, "crosses"), ("80,60,900,60,80,180", 3, "outside of the picture"),
                                      ("mm.csv", 3, "in pixels"), ("two.csv", 3, "from 3 to 200"), ("80,60", 2, "from 3 to 200"),
                                      ("80,60,90,70,100,80", 3, "no area"), ("80,60,x", 2, "from 3 to 200")):
            got, out, err = run("trace", "p.png", f"--outline={outline}", BAR, "-o", "s.yaml", folder=self.folder)
            self.assertEqual((got, out), (status, ""), err)
            self.assertIn(word, err)
        got, _, err = run("trace", "p.png", "--outline=80,60,230,60,80,180", "--around=1,1,90,90", BAR, folder=self.folder)
        self.assertEqual(got, 2)
        self.assertIn("give one of them", err)
        got, _, err = run("trace", "p.png", "--outline=two.csv", BAR, "-o", "two.csv", folder=self.folder)
        self.assertNotEqual(got, 0)
        self.assertTrue((self.folder / "two.csv").read_text().startswith("x,y"))

    def test_the_foot_that_is_missed(self):
        """An end of the contact that is given 30 pixels below the outline, many times its band, draws a caution with by how
        much, in the report and in the scene; one on the outline draws none."""
        paint(self.folder / "p.png", SHAPES["boulder"])
        low = max(y for _, y in SHAPES["boulder"])
        x = max((y, x) for x, y in SHAPES["boulder"])[1]
        words = ("trace", "p.png", "--around=25,20,295,222", BAR, "-o", "s.yaml")
        end = min((p for p in SHAPES["boulder"] if p[1] > 130), key=lambda p: abs(p[0] - x - 30))
        _, out, _ = run(*words, f"--between={x},{low + 30},{end[0]},{end[1]}", folder=self.folder)
        self.assertAlmostEqual(float(re.search(r"misses an end of the contact that was given by ([\d.]+) pixels", out)[1]), 30,
                               delta=3)
        self.assertIn("# Caution: the outline misses", (self.folder / "s.yaml").read_text())
        _, out, _ = run(*words, f"--between={x},{low},{end[0]},{end[1]}", folder=self.folder)
        self.assertNotIn("misses", out)

    def test_the_band_in_a_study(self):
        """outline_offset moves the outline by its own amount: the area by the perimeter times it. A study draws it."""
        paint(self.folder / "p.png", SHAPES["boulder"])
        found, case = self.trace()
        length = perimeter(SHAPES["boulder"]) * PER_PIXEL
        for offset in (-2 * found["deviation_m"], 2 * found["deviation_m"]):
            moved = self.solve(f"--set=outline_offset={offset:.6f}")
            more = moved["block"]["area_m2"]["value"] - case["block"]["area_m2"]["value"]
            self.assertAlmostEqual(more / (length * offset), 1, delta=0.03)
        text = (self.folder / "scene.yaml").read_text()
        vary = next(line for line in text.splitlines() if line.startswith("#   vary:"))
        self.assertAlmostEqual(float(vary.split("deviation: ")[1].rstrip("}")), found["deviation_m"], delta=0.01)
        (self.folder / "study.yaml").write_text(f"topple_study: 1\nscene: scene.yaml\nsamples: 50\n{vary[4:]}\n")
        status, out, err = run("study", "--json", "study.yaml", folder=self.folder)
        self.assertEqual((status, err), (0, ""))

    def test_figure(self):
        """The picture with the outline on it: on the true outline the band is drawn, inside it the rock is seen."""
        paint(self.folder / "p.png", SHAPES["boulder"])
        found, _ = self.trace("--figure", "f.png")
        width, height, rows = read_png(self.folder / "f.png")
        left, right = min(x for x, _ in SHAPES["boulder"]), max(x for x, _ in SHAPES["boulder"])
        self.assertGreater(width, 500)
        self.assertGreater(height, 400)
        yellow = [(x, y) for y, row in enumerate(rows) for x, (r, g, b) in enumerate(row)
                  if r > 180 and g > 130 and b < 110 and r - b > 90]
        self.assertGreater(len(yellow), 500)
        scale = (max(x for x, _ in yellow) - min(x for x, _ in yellow)) / (right - left + 4 * found["deviation_px"])
        x0 = min(x for x, _ in yellow) - (left - 2 * found["deviation_px"]) * scale
        middle = rows[round((min(y for _, y in yellow) + max(y for _, y in yellow)) / 2)][round(160 * scale + x0)]
        self.assertLess(max(abs(a - b) for a, b in zip(middle, (150, 138, 124))), 45)

    def test_the_example(self):
        """The command of docs/trace.md on the painted boulder: 160 pixels are 2 m, and it was held askew by 4 degrees."""
        folder = ROOT / "examples" / "pictures"
        painter = runpy.run_path(str(folder / "painted_boulder.py"))
        page = (ROOT / "docs" / "trace.md").read_text(encoding="utf-8")
        words = re.search(r"topple trace (examples/pictures/painted_boulder.png .*)", page)[1].split()
        words = [str(self.folder / word) if word.endswith((".yaml", "figure.png")) else word for word in words]
        status, out, err = run("trace", *words, "--json")
        self.assertEqual((status, err), (0, ""))
        found, points = json.loads(out), painter["outline"]()
        self.assertLess(abs(found["area_m2"] - area(points) / 6400), found["deviation_m"] * perimeter(points) / 80)
        self.assertAlmostEqual(found["plumb_deg"], -4, delta=0.3)
        self.assertAlmostEqual(found["m_per_px"], 1 / 80, delta=1e-5)
        before = (folder / "painted_boulder.png").read_bytes()
        (self.folder / "painted_boulder.py").write_text((folder / "painted_boulder.py").read_text())
        runpy.run_path(str(self.folder / "painted_boulder.py"), run_name="__main__")
        self.assertEqual((self.folder / "painted_boulder.png").read_bytes(), before)

    def test_the_scene_tells_how_it_was_traced(self):
        """Its head has the hash of the picture and the words: by these the same scene is traced again, to the last byte."""
        name = "p ' $(x)\n.png"
        paint(self.folder / name, SHAPES["notched"])
        words = ["--around=58,48,190,32,205,98,268,108,252,218,72,208", BAR, "--plumb=10.25,10,12,200", "--between=86,194,239,204",
                 "--tolerance=0.05", "--unit=ft"]
        status, out, err = run("trace", name, *words, "-o", "one.yaml", folder=self.folder)
        self.assertEqual((status, err), (0, ""))
        lines = (self.folder / "one.yaml").read_text().splitlines()
        self.assertEqual(lines[:2], ["# Traced by topple trace in p ' $(x) .png, SHA-256",
                                     "# " + hashlib.sha256((self.folder / name).read_bytes()).hexdigest()])
        own = " ".join(lines[2:4]).replace("# ", "").split()
        self.assertEqual(sorted(own), sorted(words))
        self.assertEqual(run("trace", name, *own, "-o", "two.yaml", folder=self.folder)[0], 0)
        self.assertEqual((self.folder / "one.yaml").read_bytes(), (self.folder / "two.yaml").read_bytes())

    def test_report(self):
        """From the picture to the page in one command: the same page as of the scene that was written."""
        paint(self.folder / "p.png", SHAPES["slab"])
        os.environ["SOURCE_DATE_EPOCH"] = "1700000000"
        self.addCleanup(os.environ.pop, "SOURCE_DATE_EPOCH")
        status, out, err = run("trace", "p.png", "--around=25,20,295,222", BAR, "--friction=30", "-o", "s.yaml",
                               "--report=one.html", folder=self.folder)
        self.assertEqual((status, err), (0, ""))
        self.assertEqual(run("solve", "s.yaml", "--report=two.html", folder=self.folder)[0], 0)
        self.assertEqual((self.folder / "one.html").read_bytes(), (self.folder / "two.html").read_bytes())
        status, out, err = run("trace", "p.png", "--around=25,20,295,222", BAR, "--report=three.html", folder=self.folder)
        self.assertEqual((status, out), (2, ""))
        self.assertIn("name one by --output", err)

    def test_cautions(self):
        paint(self.folder / "p.png", SHAPES["boulder"])
        status, out, err = run("trace", "p.png", "--around=25,20,247,222", "--scale=20,230,30,230,1", "-o", "s.yaml",
                               folder=self.folder)
        self.assertEqual((status, err), (0, ""))
        self.assertIn("of the outline lies on the rough polygon: draw it wider", out)
        self.assertIn("no plumb line is given", out)
        self.assertIn("the scale is short, 10 pixels", out)


if __name__ == "__main__":
    main()
