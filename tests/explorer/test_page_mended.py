# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What readers once found wrong with the page, and no other test tells: ends of lines, names of files, work that cannot be
kept, words of the scene before, what a handle hides, and what lies out of sight."""

import pathlib
import re
import tempfile
import time

from drawn_case import POLYGON
from page_case import KNOWN, ROOT, main, run
from panel_case import PanelCase

BOX = "(() => {{ const r = document.querySelector({}).getBoundingClientRect(); return [r.left, r.top, r.right, r.bottom]; }})()"


class Mended(PanelCase):
    def load(self, fragment="", width=1280, height=900, kept=KNOWN):
        super().load(fragment, width, height, kept)

    def folder(self):
        return pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def box(self, selector):
        """Of an element on the screen: left, top, right, bottom."""
        return self.value(BOX.format(repr(selector)))

    def opened(self, name, text):
        path = self.folder() / name
        path.write_bytes(text.encode())
        self.choose(path)
        self.awaits(f"document.getElementById('scene-name').textContent === {name!r}")
        self.answered()

    def test_lines_of_another_system_keep_their_ends(self):
        """A file with CR and LF is opened, one number dragged, saved: each line ends as it did, and only that number is another."""
        given = POLYGON.replace("\n", "\r\n")
        self.opened("windows.yaml", given)
        self.drag("tilt.angle_deg", -10, -30)
        self.answered()
        saved = self.saved(self.folder(), lambda: self.click("#save"), "windows.yaml").decode()
        angle = re.search(r"left, angle_deg: ([\d.]+)", saved).group(1)
        self.assertNotEqual(angle, "12")
        self.assertEqual(saved, given.replace("angle_deg: 12", f"angle_deg: {angle}"))

    def test_name_of_a_file_is_no_option(self):
        self.opened("--help.yaml", POLYGON)
        self.assertIn("at 12°", self.said("#verdict-said"))

    def test_asks_before_work_is_lost(self):
        """A file that is no text cannot be kept: the page asks before it is left, where the scene was changed; one of text alone
        it keeps, and asks nothing."""
        left = "dispatchEvent(new Event('beforeunload', {cancelable: true}))"
        self.opened("kept.yaml", POLYGON)
        self.drag("tilt.angle_deg", -10, -30)
        self.answered()
        self.assertTrue(self.value(left))
        folder = self.folder()
        (folder / "with.yaml").write_text(POLYGON)
        (folder / "points.csv").write_bytes(b"\xff\xfe")
        self.choose(folder / "with.yaml", folder / "points.csv")
        self.awaits("document.getElementById('scene-name').textContent === 'with.yaml'")
        self.answered()
        self.drag("tilt.angle_deg", -10, -30)
        self.answered()
        time.sleep(0.3)
        self.assertFalse(self.value(left))
        self.value("document.getElementById('undo').click()")  # what is not changed is no loss
        self.example("slab")

    def test_words_are_of_the_scene_that_is_there(self):
        """What was said of a handle, and of a scene that was refused, goes with that scene."""
        self.value("document.querySelector('[data-handle=\"tilt.angle_deg\"]').focus()")
        self.press("ArrowUp")
        self.answered()
        self.assertIn("20.1", self.said("#told"))
        self.example("slab")
        self.assertEqual(self.said("#told"), "")
        self.type_scene("topple: 1\noops: 2\n")
        self.refused()
        self.assertIn("oops", self.message())
        self.example("block_f")
        self.assertTrue(self.value("document.getElementById('message').hidden"))

    def test_governing_pivot_is_seen_around_its_handle(self):
        """Its ring is wider than the knob of the vertex or of the base's end that lies on it."""
        for name in ("block_e_valley", "slab_left", "boulder_traced", "block_f"):
            self.example(name)
            left, top, right, bottom = self.box(".pivot.governing path")
            x, y = (left + right) / 2, (top + bottom) / 2
            knobs = self.value("[...document.querySelectorAll('.handle .knob')].map(k => k.getBoundingClientRect()).map(r => [r.x + r.width / 2, r.y + r.height / 2, r.width / 2])")
            with self.subTest(name):
                for at_x, at_y, radius in knobs:
                    if abs(at_x - x) < 2 and abs(at_y - y) < 2:
                        self.assertGreater((right - left) / 2, radius + 3)

    def test_pivots_are_whole(self):
        """In windows of each width no column of the table is cut off or has to be scrolled to, and no scroll bar is empty."""
        for width, height in ((1440, 900), (1024, 768), (390, 844)):
            with self.subTest(width):
                self.load(width=width, height=height)
                self.tab("pivots")
                widths = self.value("(() => { const t = document.querySelector('#panel-pivots table'); const out = [];"
                                    " for (let e = t; e.id !== 'panels'; e = e.parentElement) out.push([e.scrollWidth, e.clientWidth]); return out; })()")
                for needed, given in widths:
                    self.assertLessEqual(needed, given + 1)
                self.assertLessEqual(self.box("#panel-pivots table")[2], width)
                self.assertEqual(self.value("(() => { const w = document.querySelector('#panel-pivots .wide'); return w.offsetHeight - w.clientHeight; })()"), 0)

    def test_pivots_are_whole_in_each_language(self):
        """On a telephone, where German has its longest words."""
        for language in ("de", "es"):
            with self.subTest(language):
                self.load(width=390, height=844, kept=KNOWN.replace("localStorage.setItem('topple.touched', '1');",
                          f"localStorage.setItem('topple.touched', '1'); localStorage.setItem('topple.language', '{language}');"))
                self.tab("pivots")
                needed, given = self.value("(() => { const w = document.querySelector('#panel-pivots .wide'); return [w.scrollWidth, w.clientWidth]; })()")
                self.assertLessEqual(needed, given + 1)

    def test_badge_covers_no_block_on_a_telephone(self):
        """As a scene is opened, also where what it says takes two lines and a choice of directions, and where the sheet is open."""
        self.load(width=390, height=844)
        for name in ("block_f", "block_a_valley", "boulder_traced"):
            for opened in (False, True):
                with self.subTest(name, opened=opened):
                    self.example(name)
                    if opened:
                        self.click("#grip")
                    for _ in range(4):  # until it has been fitted to its new size
                        self.frame()
                    _, top, _, _ = self.box(".shape.block")
                    _, _, _, badge = self.box("#badge")
                    self.assertGreaterEqual(top, badge - 1)
                    if opened:
                        self.click("#grip")
                        self.frame()

    def test_vertices_that_crowd_are_small(self):
        """On a telephone the ground of a slope has a vertex below each column: their knobs leave the contacts in sight, and one that has
        the focus is as large as any; of a block with four they are not small."""
        self.load(width=390, height=844)
        self.example("toppling_slope")
        knobs = "[...document.querySelectorAll('.handle.vertex')].map(h => [h.classList.contains('close'), h.querySelector('.knob').getBoundingClientRect().width])"
        sizes = self.value(knobs)
        small = [width for close, width in sizes if close]
        self.assertGreater(len(small), 8)
        self.assertLess(max(small), 11)
        self.value("document.querySelector('.handle.vertex.close').focus()")
        self.frame()
        self.assertGreater(self.value("document.querySelector('.handle.vertex.close:focus .knob').getBoundingClientRect().width"), 13)
        self.example("boulder_traced")
        self.assertLess(sum(close for close, _ in self.value(knobs)), 0.5 * len(self.value(knobs)) + 1)

    def test_sentences_of_a_report_are_as_wide_as_their_panel(self):
        """What goes on in the next line is broken where the panel ends, what stands in columns is not; the text is the program's to the letter."""
        self.load(width=390, height=844)
        for name, begins, count in (("balanced_rock", "Tilted by 5°", 1), ("toppling_slope", "MAY MOVE", 1)):
            with self.subTest(name):
                self.example(name)
                self.awaits(f"[...document.querySelectorAll('#panel-verdict .prose')].some(e => e.textContent.trim().startsWith('{begins}'))")
                proses = self.value("[...document.querySelectorAll('#panel-verdict .prose')].map(e => [e.textContent, e.getBoundingClientRect().right])")
                self.assertGreaterEqual(len(proses), count)
                for text, right in proses:
                    self.assertLessEqual(right, 390)
                    self.assertNotRegex(text.strip(), r"\S  ")
                folder = "solids" if name == "balanced_rock" else "blocks"
                whole = self.value("document.querySelector('#panel-verdict pre').textContent")
                status, out, _ = run("solve", ROOT / "examples" / folder / f"{name}.yaml")
                self.assertEqual(status, 0)
                self.assertEqual(whole.split("\n")[3:12], out.split("\n")[3:12])

    def test_controls_stay_within_their_part(self):
        """In windows of each width, none lies over another part of the page, or beyond it."""
        for width, height in ((1440, 900), (1024, 768), (700, 900), (390, 844)):
            self.load(width=width, height=height)
            right = self.box(".below")[2]
            for at, field in enumerate(self.value("[...document.querySelectorAll('#numbers :is(label, input)')].map(e => e.getBoundingClientRect().right)")):
                with self.subTest(width, at=at):
                    self.assertLessEqual(field, right)

    def test_tour_on_a_telephone_keeps_the_drawing_in_sight(self):
        """In each of its steps the block stands in the upper part of the window, and what the tour says below it."""
        self.load(width=390, height=844)
        self.click("#tour-begin button")
        for step in range(1, 8):
            self.click(f".tour ol li:nth-child({step}) button")
            self.answered()
            with self.subTest(step):
                left, top, right, bottom = self.box(".shape.block")
                _, sheet, _, _ = self.box(".side")
                self.assertGreater(min(bottom, sheet) - top, 120)
                self.assertGreaterEqual(left, -1)
                self.assertLessEqual(right, 391)
                self.assertLessEqual(bottom, sheet)
                _, said, _, _ = self.box(".tour h2")
                self.assertTrue(sheet <= said < 844)

    def test_tour_shows_what_it_speaks_of(self):
        """In a common window what it finds, and the panel of its step, or the table of the third, are on the screen with no scrolling."""
        self.load(width=1440, height=900)
        self.click("#tour-begin button")
        for step in range(1, 8):
            self.click(f".tour ol li:nth-child({step}) button")
            self.answered()
            if step == 3:
                self.awaits("document.querySelector('.tour table') !== null")
                self.assertLess(self.box(".tour table")[1], 800)
                continue
            self.awaits("document.querySelector('.tour .found').textContent.includes('°')")
            with self.subTest(step):
                panel = self.value("document.querySelector('[role=tabpanel]:not([hidden])').id")
                self.assertLess(self.box("#" + panel)[1], 800)
                self.assertLessEqual(self.box(".tour .found")[3], 900)


if __name__ == "__main__":
    main()
