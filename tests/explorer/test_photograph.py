# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A block traced over a photograph: the page writes, byte by byte, what `topple trace` does for the same clicks."""

import hashlib
import math
import pathlib
import random
import re
import tempfile
import unittest

from node_case import NODE, node
from page_case import ROOT, main, run
from panel_case import PanelCase

TRACE = ROOT / "src" / "applications" / "explorer" / "photograph" / "trace_scene.js"
PICTURE = ROOT / "examples" / "pictures" / "painted_boulder.png"
SCALE, PLUMB = [(30.7, 306.7), (190.3, 317.9)], [(448, 54), (438, 204)]
IS_THERE = run("trace", str(PICTURE), "--outline=10,10,60,10,60,60", "--scale=1,1,9,1,1")[0] == 0


def flat(points):
    return ",".join(f"{x!r},{y!r}" for x, y in points)


def dicts(points):
    return [{"x": x, "y": y} for x, y in points]


@unittest.skipIf(NODE is None, "there is no node: install Debian's package nodejs")
@unittest.skipUnless(IS_THERE, "this build has no trace: ./run --with trace")
class Scenes(unittest.TestCase):
    def test_bytes_of_the_program(self):
        """For outlines of 3 to 40 clicks in either sense, with and without plumb line, ends of the contact and what is known of the rock."""
        draw = random.Random(11)
        digest = hashlib.sha256(PICTURE.read_bytes()).hexdigest()
        compared = 0
        for _ in range(24):
            count, turned = draw.randint(3, 40), draw.random() < 0.5
            ring = [(round(240 + 130 * math.cos(a), draw.choice([0, 1, 3])), round(170 + 90 * math.sin(a), 1))
                    for a in sorted(draw.uniform(0, 2 * math.pi) for _ in range(count))]
            low = sorted(ring, key=lambda point: -point[1])[:2]
            ring = ring[::-1] if turned else ring
            plumb = PLUMB if draw.random() < 0.7 else []
            between = [low[0], (low[1][0] + draw.random(), low[1][1])] if draw.random() < 0.6 else []
            length, unit = draw.choice([2, 0.73, 1234.5]), draw.choice(["m", "ft", "mm"])
            friction, weight = draw.choice(["", "35"]), draw.choice(["", "26.5"])
            options = [f"--outline={flat(ring)}", f"--scale={flat(SCALE)},{length!r}", f"--unit={unit}"]
            options += [f"--plumb={flat(plumb)}"] * bool(plumb) + [f"--between={flat(between)}"] * bool(between)
            options += ["--friction=35"] * bool(friction) + ["--unit-weight=26.5"] * bool(weight)
            status, printed, _ = run("trace", str(PICTURE), *options)
            if status != 0:
                continue  # no block: the page shows the program's complaint about the scene
            compared += 1
            made = node(TRACE, "return it.traceScene(given);", {
                "image": PICTURE.name, "hash": digest, "outline": dicts(ring), "scale": dicts(SCALE), "length": length, "unit": unit,
                "plumb": dicts(plumb), "between": dicts(between), "friction": friction, "unitWeight": weight})
            self.assertEqual(made, printed)
        self.assertGreater(compared, 12)

    def test_refusals(self):
        one = {"image": "a.png", "hash": None, "scale": dicts(SCALE), "length": 1, "unit": "m", "plumb": [], "friction": "", "unitWeight": "", "between": []}
        said = node(TRACE, "return given.map((each) => { try { return it.traceScene(each); } catch (error) { return error.message; } });", [
            {**one, "outline": dicts([(0, 0), (1, 1)])}, {**one, "outline": dicts([(0, 0), (1, 1), (2, 2)])},
            {**one, "outline": dicts([(0, 0), (9, 0), (9, 9)]), "between": dicts([(0, 0), (1, 0)])}])
        for words, expected in zip(said, ("3 to 200", "3 to 200", "nearest to one point")):
            self.assertIn(expected, words)


class Traced(PanelCase):
    CLICKS = [(105, 300), (380, 310), (395, 180), (300, 95), (180, 95), (92, 200)]

    def load(self, fragment="", width=1280, height=900):
        super().load(fragment, width, height)

    def setUp(self):
        super().setUp()
        self.browser.call("Emulation.setFocusEmulationEnabled", enabled=True)
        self.choose(PICTURE)
        self.awaits("document.body.classList.contains('tracing') && document.querySelector('.photo image').getBoundingClientRect().width > 100")

    def on_screen(self, x, y):
        return self.value(f"(() => {{ const m = document.querySelector('.photo g').getScreenCTM(); return [m.a * {x} + m.e, m.d * {y} + m.f]; }})()")

    def click_at(self, x, y):
        at = self.on_screen(x, y)
        self.browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=at[0], y=at[1])
        self.mouse("mousePressed", *at)
        self.mouse("mouseReleased", *at)

    def typed(self, label, text):
        self.value(f"(() => {{ const f = document.querySelector('#photo [aria-label=\"{label}\"]'); f.focus(); f.select(); }})()")
        self.browser.call("Input.insertText", text=text)

    def traced(self):
        for point in [*SCALE, *PLUMB, *self.CLICKS]:
            self.click_at(*point)
        self.click_at(*self.CLICKS[0])  # closes it
        for point in self.CLICKS[:2]:
            x, y = self.on_screen(*point)
            self.click_at(point[0] + 4, point[1] + 8)  # beside the vertex, which is a point itself
        self.typed("Distance of the two points of the scale", "2,0")
        self.typed("Friction angle, °", "35")
        self.typed("Unit weight, kN/m³", "26")

    @unittest.skipUnless(IS_THERE, "this build has no trace: ./run --with trace")
    def test_scene_is_that_of_the_command_line(self):
        """By the mouse; the options that stand in the scene's head make the same bytes again."""
        self.traced()
        self.button("Make the scene")
        self.answered()
        self.assertEqual(self.value("document.querySelectorAll('#message:not([hidden])').length"), 0)
        text = self.text()
        head = re.search(r"# (--outline=\S+)\n# (--scale=\S+) (--unit=\S+) (--plumb=\S+) (--between=\S+)\n", text)
        self.assertIsNotNone(head, text[:600])
        with tempfile.TemporaryDirectory() as folder:
            status, printed, err = run("trace", str(PICTURE), *head.groups(), "--friction=35", "--unit-weight=26", folder=pathlib.Path(folder))
        self.assertEqual(status, 0, err)
        self.assertEqual(text.rstrip("\n"), printed.rstrip("\n"))
        outline = [float(number) for number in head.group(1).partition("=")[2].split(",")]
        for wanted, found in zip([c for point in self.CLICKS for c in point], outline):
            self.assertAlmostEqual(wanted, found, delta=0.6)

    def test_photograph_lies_behind_the_block(self):
        """Its corners of the outline are where the block's are drawn."""
        self.traced()
        self.button("Make the scene")
        self.answered()
        self.awaits("document.querySelector('.photo-behind').getAttribute('display') === null")
        pairs = self.value("""(() => { const m = document.querySelector('.photo-behind').getScreenCTM();
          const block = document.querySelector('.shape.block'), frame = block.getScreenCTM();
          const points = block.getAttribute('d').match(/-?[\\d.e-]+ -?[\\d.e-]+/g).map(p => p.split(' ').map(Number))
            .map(([x, y]) => [frame.a * x + frame.c * y + frame.e, frame.b * x + frame.d * y + frame.f]);
          return %s.map(([x, y]) => { const at = [m.a * x + m.c * y + m.e, m.b * x + m.d * y + m.f];
            return Math.min(...points.map(p => Math.hypot(p[0] - at[0], p[1] - at[1]))); }); })()""" % [list(point) for point in self.CLICKS])
        self.assertLess(max(pairs), 3)
        upright = self.value("(() => { const m = document.querySelector('.photo-behind').getScreenCTM(); const [x, y] = [%r, %r];"
                             " return (m.a * x + m.c * y) / (m.b * x + m.d * y); })()" % (PLUMB[1][0] - PLUMB[0][0], PLUMB[1][1] - PLUMB[0][1]))
        self.assertLess(abs(upright), 5e-3)  # the plumb line hangs down as the block lies, by clicks on whole dots
        self.example("slab_left")
        self.assertEqual(self.value("document.querySelector('.photo-behind').getAttribute('display')"), "none")

    def test_with_keys_alone(self):
        """The cross is moved by arrows, Enter puts a point; a point is moved by arrows, and deleted."""
        self.value("document.querySelector('svg.photo').focus()")
        for key in ("ArrowLeft", "ArrowLeft", "Enter"):
            self.press(key)
        self.press("ArrowRight")
        self.press("Enter")
        self.assertEqual(self.value("document.querySelectorAll('.photo-point.scale').length"), 2)
        x = "Number(document.querySelector('.photo-point.scale').getAttribute('cx'))"
        self.value("document.querySelector('.photo-point.scale').focus()")
        before = self.value(x)
        self.press("ArrowRight")
        self.assertGreater(self.value(x), before)
        self.press("Delete")
        self.assertEqual(self.value("document.querySelectorAll('.photo-point.scale').length"), 1)

    def test_closer_and_farther_with_keys(self):
        """Closer about the cross, which stays where it is seen; taken beyond the window it takes the photograph along; 0 fits again."""
        scale = "document.querySelector('.photo g').getScreenCTM().a"
        cross = "(() => { const r = document.querySelector('.photo .cross').getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2]; })()"
        self.value("document.querySelector('svg.photo').focus()")
        self.press("ArrowRight")
        first, there = self.value(scale), self.value(cross)
        for _ in range(4):
            self.press("+", text="+")
        self.assertAlmostEqual(self.value(scale) / first, 1.25 ** 4, places=3)
        for one, other in zip(self.value(cross), there):
            self.assertAlmostEqual(one, other, delta=1)
        self.press("-", text="-")
        self.assertAlmostEqual(self.value(scale) / first, 1.25 ** 3, places=3)
        for _ in range(90):
            self.press("ArrowRight")
        left, right = self.value("(() => { const r = document.querySelector('svg.photo').getBoundingClientRect(); return [r.left, r.right]; })()")
        self.assertTrue(left < self.value(cross)[0] < right)
        self.press("0", text="0")
        self.assertAlmostEqual(self.value(scale), first, places=6)

    def test_what_lacks_is_said(self):
        self.button("Make the scene")
        self.assertIn("two points", self.message())
        self.button("Leave the photograph")
        self.assertTrue(self.value("document.getElementById('photo').hidden && !document.getElementById('trace').hidden"))
        self.click("#trace")
        self.assertFalse(self.value("document.getElementById('photo').hidden"))

    def test_file_that_is_no_picture(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "broken.png")
            path.write_bytes(b"no picture")
            self.choose(path)
            self.awaits("document.getElementById('message').textContent.includes('broken.png')")


if __name__ == "__main__":
    main()
