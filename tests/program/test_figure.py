# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Figures: files of the three kinds, whole and alike on every run, in which nothing covers the block;
mistakes leave no file behind."""

import cmath
import itertools
import math
import pathlib
import resource
import signal
import struct
import subprocess
import tempfile
import unittest
import zlib

from harness import PROGRAM, ROOT, example_scenes, main, run, solve
from svg import Drawing, covers, overlap

E_VALLEY = "examples/block_e_valley.yaml"
EXAMPLES = example_scenes()
# Tints of the block and of its parts, as src/presentation/figure/view.c has them.
TINTS = ((0.84, 0.925, 0.975), (0.985, 0.9, 0.68), (0.97, 0.95, 0.6))
ROCK = (0.89, 0.88, 0.86)
VERMILION = (0.835, 0.369, 0.0)

# Scenes that a figure could trip over.
SCENES = {
    "cautioned": "block: {slab: {width: 1, height: 2}, unit_weight_kn_m3: 2600}\nfriction_angle_deg: 30",
    "slender": "block: {slab: {width: 1, height: 1000}}\nfriction_angle_deg: 30",
    "flat": "block: {slab: {width: 1000, height: 1}}\nfriction_angle_deg: 30\ntilt: {angle_deg: 3}",
    "interlocked": "block: {teeth: {count: 2, width: 10, height: 100, depth: 30, left_end: valley}}\n"
                   "friction_angle_deg: 20",
    "without_friction": "block: {slab: {width: 1, height: 2}}\ntilt: {towards: right, angle_deg: 12}",
    "nowhere": "block: {outline: [[0, 0], [4, 0], [4, 2], [0, 2]]}\n"
               "base: {profile: [[-1, 0], [1, 0]]}\nfriction_angle_deg: 30",
    "one_point": "block: {outline: [[0, 0], [1, 1], [-1, 1]]}\n"
                 "base: {profile: [[-2, 0], [2, 0]]}\nfriction_angle_deg: 30",
    "below_level": "block: {outline: [[0, 0.5], [1, 0], [1.2, 3]]}\n"
                   "base: {profile: [[0, 0.5], [1, 0]]}\nfriction_angle_deg: 0",
    "far_off": "block: {outline: [[1e9, 1e9], [1e9 + 1, 1e9], [1e9 + 1, 1e9 + 2], [1e9, 1e9 + 2]]}\n"
               "friction_angle_deg: 30",
    "tiny": "block: {slab: {width: 1e-200, height: 2e-200}}\nfriction_angle_deg: 30",
    "level_water": "block: {slab: {width: 2, height: 5}, unit_weight_kn_m3: 26}\n"
                   "loads: {water: {height: 2, stays_level: true}}\nfriction_angle_deg: 60",
    "long_title": "title: " + "A word and " * 40 + "W" * 300 + "\nblock: {slab: {width: 1, height: 2}}",
}


class Figures(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def draw(self, scene, name, *options):
        """The bytes of a figure; the report stays as without it."""
        file = self.path / name
        status, out, err = run("solve", *options, "--figure", file, scene)
        self.assertEqual((status, err), (0, ""), scene)
        self.assertRegex(out, "Tilted towards the|As it lies, towards the")
        self.assertEqual([f.name for f in self.path.iterdir() if f.suffix == ".part"], [])
        return file.read_bytes()

    def scene(self, name, text):
        file = self.path / f"{name}.yaml"
        file.write_text("topple: 1\nlength_unit: m\n" + text + "\n")
        return file

    def check_clear(self, drawing, scene):
        """No text meets another, the block, or the margin of the page."""
        width, height = drawing.size
        self.assertGreater(len(drawing.texts), 10, scene)
        for text in drawing.texts:
            self.assertTrue(text[0] > 0 and text[1] > 0 and text[2] < width and text[3] < height, scene)
            for tint in TINTS:
                for area in drawing.areas.get(tint, []):
                    self.assertFalse(covers(area, text), f"{scene}: text {text} on the block")
        for one, other in itertools.combinations(drawing.texts, 2):
            self.assertFalse(overlap(one, other), f"{scene}: texts {one} and {other}")

    def test_svg(self):
        """Every example: an XML file with clear texts, a block and rock a panel."""
        for scene in EXAMPLES:
            with self.subTest(scene=scene.name):
                drawing = Drawing(self.draw(scene, "figure.svg").decode())
                self.check_clear(drawing, scene.name)
                panels = len(solve(scene)["cases"])
                for colour in (TINTS[0], ROCK):  # once more in the legend
                    self.assertEqual(len(drawing.areas[colour]), panels + 1)

    def test_clearance_is_noticed(self):
        """The check above sees a text that lies on the block, and one that lies on a text."""
        drawing = Drawing(self.draw(E_VALLEY, "figure.svg").decode())
        block = drawing.areas[TINTS[0]][0][0]
        x, y = (sum(p[k] for p in block) / len(block) for k in (0, 1))
        texts = drawing.texts
        for moved in ((x - 1, y - 1, x + 1, y + 1),
                      (block[0][0] - 2, block[0][1] - 2, block[0][0] + 2, block[0][1] + 2), texts[0]):
            drawing.texts = texts + [moved]
            with self.assertRaises(AssertionError):
                self.check_clear(drawing, E_VALLEY)

    def test_hard_scenes(self):
        for name, text in SCENES.items():
            with self.subTest(scene=name):
                drawing = Drawing(self.draw(self.scene(name, text), "figure.svg").decode())
                self.check_clear(drawing, name)

    def test_block_e(self):
        """Block E towards its valley: turned by the limit, which a short base has at 28.73 degrees, and
        a cross at the centre of rotation, below its base."""
        drawing = Drawing(self.draw(E_VALLEY, "figure.svg").decode())
        (block,), *_ = drawing.areas[TINTS[0]]
        self.assertEqual(len(block), 6)
        limit = solve(E_VALLEY)["cases"][0]["limit"]
        corners = [complex(x, -y) for x, y in block]  # from the valley in (0, 0) to (90, 5) and on
        turn = (corners[3] - corners[0]) / complex(90, 5)
        self.assertAlmostEqual(math.degrees(cmath.phase(turn)), limit["critical_angle_deg"]["value"],
                               places=3)
        self.assertAlmostEqual(limit["critical_angle_deg"]["value"], 28.73, places=2)
        centre = corners[0] + turn * complex(1000 * limit["centre_x_m"]["value"],
                                             1000 * limit["centre_y_m"]["value"])
        self.assertLess(limit["centre_y_m"]["value"], -0.05)
        crossed = [sum(complex(x, -y) for x, y in piece) / len(piece)
                   for stroke in drawing.strokes[VERMILION] for piece in stroke]
        # Cairo rounds to 1/256 point
        self.assertEqual(sum(abs(middle - centre) < 0.01 for middle in crossed), 2)

    def test_elements(self):
        """--elements draws the sides of the elements; a figure without it is smaller."""
        plain = self.draw(E_VALLEY, "figure.svg")
        self.assertGreater(len(self.draw(E_VALLEY, "elements.svg", "--elements")), len(plain))

    def test_pdf(self):
        for scene in EXAMPLES[::6]:
            data = self.draw(scene, "figure.pdf")
            self.assertTrue(data.startswith(b"%PDF-1."))
            self.assertTrue(data.rstrip().endswith(b"%%EOF"))
            self.assertEqual(data.count(b"/Type /Page "), 1)
            self.assertIn(b"/CreationDate (20000101000000Z)", data)  # not the time of day

    def test_png(self):
        """300 dots to the inch, as large as the SVG; all of its data there."""
        for scene in EXAMPLES[::6]:
            data = self.draw(scene, "figure.PNG")
            self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
            size = Drawing(self.draw(scene, "figure.svg").decode()).size
            pixels = struct.unpack(">II", data[16:24])
            for points, count in zip(size, pixels):  # the SVG rounds its size: a whole number of pixels may be one more
                self.assertIn(count - math.ceil(points * 300 / 72), (0, 1))
            position, image = 8, b""
            while position < len(data):
                length, kind = struct.unpack(">I4s", data[position:position + 8])
                body = data[position + 8:position + 8 + length]
                check, = struct.unpack(">I", data[position + 8 + length:position + 12 + length])
                self.assertEqual(check, zlib.crc32(kind + body))
                image += body if kind == b"IDAT" else b""
                position += 12 + length
            self.assertEqual(kind, b"IEND")
            self.assertEqual(len(zlib.decompress(image)), pixels[1] * (1 + 3 * pixels[0]))

    def test_same_input_same_bytes(self):
        for kind in ("svg", "pdf", "png"):
            for scene in (E_VALLEY, "examples/block_under_water.yaml", "examples/boulder.yaml"):
                one = self.draw(scene, f"one.{kind}")
                self.assertEqual(one, self.draw(scene, f"other.{kind}"), (kind, scene))

    def test_committed_figure(self):
        """docs/figures shows what the program draws."""
        committed = Drawing((ROOT / "docs/figures/block_e_valley.svg").read_text())
        drawn = Drawing(self.draw(E_VALLEY, "figure.svg").decode())
        self.assertEqual(committed.areas[TINTS[0]], drawn.areas[TINTS[0]])
        self.assertEqual(committed.areas[VERMILION], drawn.areas[VERMILION])

    def test_large_block(self):
        """100 000 vertices: a file of moderate size."""
        points = []
        for k in range(100000):
            t = 2 * math.pi * k / 100000
            r = 1 + 0.05 * math.sin(7 * t) + 0.02 * math.sin(31 * t)
            points.append(f"{r * math.cos(t):.9f}, {r * math.sin(t):.9f}")
        (self.path / "large.csv").write_text("\n".join(points) + "\n")
        scene = self.scene("large", "block: {outline: large.csv}\nfriction_angle_deg: 35")
        data = self.draw(scene, "figure.svg")
        self.assertLess(len(data), 2_000_000)
        self.check_clear(Drawing(data.decode()), "large")


class Mistakes(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def test_endings(self):
        """An ending that is no kind of figure is wrong usage, which names the kinds."""
        for name in ("figure.jpg", "figure", "figure.svg.gz", ".svg", "svg", ""):
            status, out, err = run("solve", "--figure", self.path / name if name else "",
                                   ROOT / E_VALLEY, folder=self.path)
            self.assertEqual((status, out), (2, ""), name)
            self.assertIn(".svg, .pdf, .png or .dxf", err)
            self.assertEqual(list(self.path.iterdir()), [])

    def test_with_find(self):
        status, out, err = run("solve", "--find", "parameters.c", "--for", "fos=1", "--figure",
                               self.path / "figure.svg", ROOT / E_VALLEY)
        self.assertEqual((status, out), (2, ""))
        self.assertIn("--find", err)

    def test_bad_scene(self):
        """A scene that is wrong leaves no figure."""
        scene = self.path / "scene.yaml"
        scene.write_text("topple: 1\nlength_unit: m\nblock: {slab: {width: -1, height: 2}}\n")
        self.assertEqual(run("solve", "--figure", self.path / "figure.svg", scene)[0], 3)
        self.assertEqual(list(self.path.iterdir()), [scene])

    def test_no_folder(self):
        for kind in ("svg", "pdf", "png"):
            status, out, err = run("solve", "--figure", self.path / "none" / f"figure.{kind}",
                                   ROOT / E_VALLEY)
            self.assertEqual((status, out), (5, ""))
            self.assertIn(f"none/figure.{kind}: cannot be written: No such file", err)
        self.assertEqual(list(self.path.iterdir()), [])

    def test_folder_in_the_way(self):
        folder = self.path / "figure.svg"
        folder.mkdir()
        status, out, err = run("solve", "--figure", folder, ROOT / E_VALLEY)
        self.assertEqual((status, out), (5, ""))
        self.assertIn("cannot be written", err)
        self.assertEqual(list(self.path.iterdir()), [folder])

    def test_report_that_cannot_be_written(self):
        """Exit status 5, and no figure: neither a new one nor one in the place of the old."""
        for kind in ("svg", "pdf", "png"):
            for before in (None, "old"):
                figure = self.path / f"figure.{kind}"
                if before is not None:
                    figure.write_text(before)
                with open("/dev/full", "w", encoding="utf-8") as full:
                    done = subprocess.run([PROGRAM, "solve", "--figure", figure, E_VALLEY], cwd=ROOT, stdout=full,
                                          stderr=subprocess.PIPE, encoding="utf-8", check=False)
                self.assertEqual(done.returncode, 5)
                self.assertIn("cannot write the report: No space left", done.stderr)
                self.assertEqual(list(self.path.iterdir()), [] if before is None else [figure])
                if before is not None:
                    self.assertEqual(figure.read_text(), before)
                    figure.unlink()

    def test_full_disk(self):
        """A figure that cannot be written to its end leaves the file of that name as it was."""
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))

        for kind in ("svg", "pdf", "png"):
            figure = self.path / f"figure.{kind}"
            figure.write_text("old")
            done = subprocess.run([PROGRAM, "solve", "--figure", figure, E_VALLEY], cwd=ROOT,
                                  capture_output=True, encoding="utf-8", preexec_fn=limit, check=False)
            self.assertEqual((done.returncode, done.stdout), (5, ""), kind)
            self.assertIn("cannot be written: File too large", done.stderr)
            self.assertEqual(figure.read_text(), "old")
            self.assertEqual(list(self.path.iterdir()), [figure])
            figure.unlink()


if __name__ == "__main__":
    main()
