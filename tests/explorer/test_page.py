# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The explorer's drawing and its text are one scene: what is dragged is written, what is typed is drawn, and both are
what the command line makes of that text."""

import math
import pathlib
import re
import shutil
import tempfile
import time
import unittest

from drawn_case import DrawnCase, POLYGON, polygon
from page_case import ROOT, main

REPORTS = 240  # of the hand, in a drag whose frames are counted


class Drawn(DrawnCase):
    def test_first_answer_within_a_second_of_the_page(self):
        """The page opens with block E, solved and drawn as the command line has it."""
        took = self.value("performance.getEntriesByName('first answer')[0].startTime") / 1000
        print(f"\nfirst answer {took:.2f} s after the page began to load")
        self.assertIn("Block E", self.value("document.getElementById('scene-title').textContent"))
        self.assertEqual(self.value("document.querySelector('.shape.block').getAttribute('d')"),
                         self.solved()["outlines"]["block"])
        self.assertLess(took, 5)

    def test_tilt_handle_writes_the_tilt_and_turns_the_drawing(self):
        self.assertAlmostEqual(self.drawn_turn(), 20, places=4)  # SVG's matrices are floats
        self.drag("tilt.angle_deg", -20, -50)
        self.answered()
        tilt = float(re.search(r"angle_deg: ([\d.]+)}", self.text()).group(1))
        self.assertGreater(tilt, 25)
        self.assertAlmostEqual(self.drawn_turn(), tilt, places=4)
        self.assertAlmostEqual(tilt * 10, round(tilt * 10), places=9)

    def test_parameter_is_what_a_size_by_name_changes(self):
        """Block E's teeth are as wide as its parameter a: dragged, a is another number and its formula stays."""
        self.drag("width of the teeth", 40, -15)
        self.answered()
        text = self.text()
        self.assertIn("width: a,", text)
        self.assertGreater(float(re.search(r"\{a: ([\d.]+),", text).group(1)), 31)
        self.assertIn("# Alejano et al.", text)

    def test_base_that_goes_on_holds_block_e(self):
        """Dragging the base's left end out past a tooth's peak: the limit rises from 28.73 to 35.20 degrees."""
        self.assertAlmostEqual(self.solved()["cases"][0]["limit"]["critical_angle_deg"]["value"], 28.7346, places=3)
        self.drag("base beyond the block to the left", -150, 55)
        self.answered()
        self.assertGreaterEqual(float(re.search(r"left: ([\d.]+)", self.text()).group(1)), 25)
        self.assertAlmostEqual(self.solved()["cases"][0]["limit"]["critical_angle_deg"]["value"], 35.2008, places=3)

    def test_vertex_follows_the_hand_in_decimals(self):
        """A vertex lies where it was let go, within half a step; only its own two numbers changed."""
        self.type_scene(POLYGON)
        self.answered()
        before = self.text()
        x, y = self.drag("block.outline.3", 37, -29)
        self.answered()
        after = self.text()
        moved = re.search(r"\[110, 60\], \[([-\d.]+), ([-\d.]+)\], \[-10", after)
        self.assertEqual(after.replace(moved.group(0), "[110, 60], [60, 140], [-10"), before)
        for number in moved.groups():
            self.assertLessEqual(len(number.partition(".")[2]), 1)
        left, top = self.knob("block.outline.3")
        self.assertLess(math.hypot(left - x, top - y), 3)
        self.assertEqual(self.value("document.querySelector('.shape.block').getAttribute('d')"),
                         self.solved()["outlines"]["block"])

    def test_far_from_the_origin(self):
        """Coordinates of a national grid, seven digits before the point: the vertex still follows the hand, and its
        neighbours keep every digit."""
        far = "[[4500000.125, 5400000.5], [4500100.125, 5400000.5], [4500110, 5400060], [4500060, 5400140], [4499990, 5400090]]"
        self.type_scene(re.sub(r"outline: .*?\]\]", "outline: " + far, POLYGON, flags=re.S))
        self.answered()
        x, y = self.drag("block.outline.3", 31, -17)
        self.answered()
        left, top = self.knob("block.outline.3")
        self.assertLess(math.hypot(left - x, top - y), 3)
        self.assertIn("[[4500000.125, 5400000.5], [4500100.125, 5400000.5], [4500110, 5400060], [45000", self.text())

    def test_shift_keeps_to_one_axis(self):
        """The hand goes up first, then to the right by more: the vertex is where it was in y."""
        self.type_scene(POLYGON.replace("angle_deg: 12", "angle_deg: 0"))
        self.answered()
        x, y = self.knob("block.outline.2")
        self.mouse("mousePressed", x, y, modifiers=8)
        for dx, dy in ((0, -5), (0, -12), (12, -14), (40, -14)):
            self.mouse("mouseMoved", x + dx, y + dy, modifiers=8)
            self.frame()
        self.mouse("mouseReleased", x + 40, y - 14, modifiers=8)
        self.assertRegex(self.text(), r"\n    \[1[2-9]\d(\.\d)?, 60\], \[60, 140\]")

    def test_a_drag_is_one_step_of_undo(self):
        self.type_scene(POLYGON)
        self.answered()
        before = self.text()
        self.drag("block.outline.2", 25, 10)
        self.drag("block.outline.3", -15, 20)
        after = self.text()
        self.click("#undo")
        between = self.text()
        self.click("#undo")
        self.assertEqual(self.text(), before)
        self.assertEqual(len({before, between, after}), 3)
        self.click("#redo")
        self.click("#redo")
        self.assertEqual(self.text(), after)
        self.assertTrue(self.value("document.getElementById('redo').disabled"))
        self.answered()

    def test_typing_moves_the_drawing(self):
        self.type_scene(POLYGON.replace("angle_deg: 12", "angle_deg: 33"))
        self.answered()
        self.assertAlmostEqual(self.drawn_turn(), 33, places=4)

    def test_error_is_at_its_line_and_the_drawing_stays(self):
        """An unknown name: the line is marked, the message says what the command line says, the last drawing is grey;
        mended, all is well again."""
        self.type_scene(POLYGON)
        self.answered()
        drawn = self.value("document.querySelector('.shape.block').getAttribute('d')")
        self.type_scene(POLYGON.replace("[60, 140]", "[oops, 140]"))
        self.refused()
        self.assertEqual(self.message(), "Line 7 unknown name 'oops'; define it under 'parameters', before its first use")
        self.assertEqual(self.value("document.querySelector('.cm-lintRange-error').textContent"), "oops")
        self.assertEqual(self.value("document.querySelector('.shape.block').getAttribute('d')"), drawn)
        self.assertTrue(self.value("document.querySelector('svg.drawing').classList.contains('stale')"))
        self.click("#message button")
        self.assertTrue(self.value("document.activeElement.classList.contains('cm-content')"))
        self.type_scene(POLYGON)
        self.answered()
        self.assertTrue(self.value("document.getElementById('message').hidden"))
        self.assertFalse(self.value("document.querySelector('svg.drawing').classList.contains('stale')"))
        self.assertIsNone(self.value("document.querySelector('.cm-lintRange-error')"))

    def test_what_cannot_be_dragged_says_why(self):
        self.example("boulder")
        self.assertIn("boulder.csv", self.value("document.getElementById('fixed').textContent"))
        self.example("block_with_hole")
        self.assertIn("formula 0.7 - r/2", self.value(
            """document.querySelector('[data-handle="block.holes.0.1"]').getAttribute('aria-label')"""))
        before = self.text()
        self.drag("block.holes.0.1", 30, 30)
        self.assertEqual(self.text(), before)

    def test_points_of_a_file_go_into_the_scene(self):
        """The boulder's 66 points stand in a CSV file. Written into the scene they are the same block, to the digit,
        and can be dragged."""
        self.example("boulder")
        drawn = self.value("document.querySelector('.shape.block').getAttribute('d')")
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        shutil.copy(ROOT / "examples" / "boulder.csv", folder)
        factors = self.solved(folder)["cases"]
        self.click("#fixed button")
        self.answered()
        self.assertEqual(self.value("document.querySelector('.shape.block').getAttribute('d')"), drawn)
        now = self.solved()["cases"]
        for one, other in zip(factors, now):
            self.assertEqual(one["pivots"], other["pivots"])
        self.drag("block.outline.40", -8, -8)
        self.answered()
        self.assertNotEqual(self.value("document.querySelector('.shape.block').getAttribute('d')"), drawn)

    def test_block_is_dragged_along_its_joint(self):
        """Block E, shifted by 5 mm: the handle at its centroid shifts it further, and it follows the hand."""
        self.example("block_e_shifted")
        x, y = self.drag("shift along the joint", -20, 8)
        self.answered()
        self.assertLess(float(re.search(r"shift: ([-\d.]+)", self.text()).group(1)), 3)
        left, _ = self.knob("shift along the joint")
        self.assertLess(abs(left - x), 8)

    def test_a_law_of_friction_has_no_slider(self):
        self.type_scene(self.text().replace("friction_angle_deg: 30", "friction: {law: patton, basic_angle_deg: 30, roughness_angle_deg: 5}"))
        self.answered()
        self.assertEqual(self.value("[...document.querySelectorAll('#numbers input')].map(i => i.disabled)"),
                         [False, False, True, True])

    def test_sliders(self):
        """The tilt by its number, the friction by its slider: both stand in the text."""
        self.value("(() => { const [, tilt, friction] = document.querySelectorAll('#numbers input'); tilt.value = '24.125';"
                   " tilt.dispatchEvent(new Event('input')); friction.value = '41.5'; friction.dispatchEvent(new Event('input')); })()")
        self.answered()
        text = self.text()
        self.assertIn("angle_deg: 24.125}", text)
        self.assertIn("friction_angle_deg: 41.5\n", text)

    def test_a_vertex_named_twice_moves_everywhere(self):
        """The vault's foot is a vertex, where an arc begins, and where the contact ends: dragged, all three are moved."""
        self.example("vault")
        self.drag("block.outline.1", 20, 0)
        self.answered()
        text = self.text()
        point = re.search(r"outline: \[\[-1, 0\], (\[[^]]+\])", text).group(1)
        self.assertNotEqual(point, "[1, 0]")
        self.assertEqual(text.count(point), 3)

    def test_handles_that_share_a_place(self):
        """Corners of a block that stand on points of the profile: both can be taken, the profile's stands off."""
        self.example("partial_contact")
        for key in ("block.outline.0", "base.profile.1"):
            x, y = self.knob(key)
            self.assertEqual(self.value(f"document.elementFromPoint({x}, {y}).closest('.handle').dataset.handle"), key)

    def test_base_without_words_gets_both_ends(self):
        """A scene that says nothing of how far the base extends: the core wants both sides where one is told."""
        self.example("block_e_wkt")
        self.drag("base beyond the block to the right", 30, 0)
        self.answered()
        self.assertRegex(self.text(), r"beyond: {left: 0, right: [\d.]+}")

    def test_loads_have_handles(self):
        """Water, anchor and its direction, dragged, stand in the scene under their keys."""
        self.example("block_under_water")
        self.drag("height of the water", 5, 40)
        self.drag("loads.anchors.0.at", 30, 20)  # into the block
        self.drag("loads.anchors.0.direction_deg", -10, 40)
        self.answered()
        text = self.text()
        self.assertLess(float(re.search(r"water: {height: ([\d.]+)", text).group(1)), 3)
        self.assertNotEqual(re.search(r"direction_deg: (-?\d+)", text).group(1), "0")
        self.assertNotIn("at: [0, 4]", text)

    def test_keyboard_moves_a_handle(self):
        """A handle that has the focus moves by a step a key, by ten with shift, and says where it is."""
        self.type_scene(POLYGON)
        self.answered()
        self.value("""document.querySelector('[data-handle="tilt.angle_deg"]').focus()""")
        self.press("ArrowUp")
        self.press("ArrowUp", "shift")
        self.answered()
        self.assertIn("angle_deg: 13.1}", self.text())
        self.assertIn("13.1", self.value("document.getElementById('told').textContent"))
        self.assertEqual(self.value("document.activeElement.dataset.handle"), "tilt.angle_deg")
        self.value("""document.querySelector('[data-handle="block.outline.3"]').focus()""")
        self.press("ArrowRight")
        self.press("ArrowDown")
        moved = re.search(r"\[([-\d.]+), ([-\d.]+)\], \[-10", self.text())
        step = float(moved.group(1)) - 60
        self.assertIn(round(math.log10(step), 6), (-2, -1, 0))
        self.assertAlmostEqual(140 - float(moved.group(2)), step, places=9)

    def test_every_handle_is_reached_by_tab(self):
        self.type_scene(POLYGON)
        self.answered()
        self.value("document.getElementById('drawing').focus()")
        seen = set()
        for _ in range(12):
            self.press("Tab")
            seen.add(self.value("document.activeElement.dataset.handle ?? ''"))
        self.assertEqual(seen - {""}, set(self.value("[...document.querySelectorAll('.handle')].map(h => h.dataset.handle)")))

    def test_finger_drags(self):
        self.browser.call("Emulation.setTouchEmulationEnabled", enabled=True)
        self.load()
        x, y = self.knob("tilt.angle_deg")
        self.browser.call("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": x, "y": y}])
        for i in range(1, 9):
            self.browser.call("Input.dispatchTouchEvent", type="touchMove", touchPoints=[{"x": x - 3 * i, "y": y - 7 * i}])
        self.browser.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
        self.answered()
        self.browser.call("Emulation.setTouchEmulationEnabled", enabled=False)
        self.assertNotIn("angle_deg: 20}", self.text())

    def test_zoom_and_pan(self):
        """The wheel brings it closer where the pointer is, a drag of the ground moves it, and 0 fits it again."""
        scale = "document.querySelector('g.frame').getCTM().a"
        first = self.value(scale)
        box = self.value("(() => { const r = document.getElementById('drawing').getBoundingClientRect(); return [r.x, r.y]; })()")
        self.browser.call("Input.dispatchMouseEvent", type="mouseWheel", x=box[0] + 300, y=box[1] + 200, deltaX=0, deltaY=-240)
        self.frame()
        closer = self.value(scale)
        self.assertGreater(closer, 1.2 * first)
        shift = "document.querySelector('g.frame').getCTM().e"
        before = self.value(shift)
        self.mouse("mousePressed", box[0] + 15, box[1] + 15)
        self.mouse("mouseMoved", box[0] + 55, box[1] + 15)
        self.mouse("mouseReleased", box[0] + 55, box[1] + 15)
        self.frame()
        self.assertAlmostEqual(self.value(shift), before + 40, delta=0.01)
        self.value("document.getElementById('drawing').focus()")
        self.press("0")
        self.frame()
        self.assertAlmostEqual(self.value(scale), first, places=4)

    def test_drags_at_sixty_frames_a_second(self):
        """Blocks of 6 to 5000 vertices, some two seconds each; the frames of the page are counted while one vertex is
        dragged, and the time that its thread works for each report of the hand, which leaves room in a sixtieth; of 5000 in
        a thirtieth."""
        self.browser.call("Performance.enable", timeDomain="threadTicks")
        for count in (6, 30, 100, 300, 1000, 5000):
            self.type_scene(polygon(count))
            self.answered()
            self.click("#tab-results")
            self.frame()
            self.value("""(() => { window.gaps = []; window.counting = true; let last = 0;
              const step = (now) => { if (last) gaps.push(now - last); last = now; if (counting) requestAnimationFrame(step); };
              requestAnimationFrame(step); })()""")
            before = self.worked()
            key = self.value("[...document.querySelectorAll('.handle')].map(h => h.dataset.handle).filter(k => k.startsWith('block.')).at(-1)")
            self.drag(key, 60, -40, steps=REPORTS, pace=0.005)
            work = 1000 * (self.worked() - before) / REPORTS
            gaps = sorted(self.value("(window.counting = false, gaps)"))
            late = sum(gap > 25 for gap in gaps) / len(gaps)
            print(f"\n{count} vertices: {1000 * len(gaps) / sum(gaps):.0f} frames a second, median "
                  f"{gaps[len(gaps) // 2]:.1f} ms, greatest {gaps[-1]:.0f} ms, {100 * late:.1f} % late; {work:.1f} ms of work each")
            # the machine of a test may be loaded: half of the frames in time is asked for, the rest printed
            if count <= 100:
                self.assertLess(gaps[len(gaps) // 2], 25)
            self.assertLess(work, 1000 / (60 if count <= 1000 else 30))
            self.answered()
        self.browser.call("Performance.disable")

    def worked(self):
        """Seconds of its thread."""
        metrics = self.browser.call("Performance.getMetrics")["metrics"]
        return next(each["value"] for each in metrics if each["name"] == "TaskDuration")


if __name__ == "__main__":
    main()
