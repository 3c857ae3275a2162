# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What a hand can do on the page besides dragging: play the tilt test, put and delete vertices, type numbers, leave and come
back; and what the page does by itself."""

import json
import pathlib
import re
import tempfile
import time

from drawn_case import DrawnCase, POLYGON, polygon
from page_case import IN_FIREFOX, NEW, main, run

FALLING = """topple: 1
length_unit: m
block: {slab: {width: 1, height: 2}, unit_weight_kn_m3: 26}
base: {mated: true, beyond: {left: 3, right: 1}}
friction_angle_deg: 60
tilt: {towards: left, angle_deg: 5}
"""
TURN = "(() => { const m = document.querySelector('g.frame').getCTM(); return Math.atan2(-m.b, m.a) * 180 / Math.PI; })()"


class Hand(DrawnCase):
    def test_tilt_test_is_played(self):
        """A slab on 60° of friction is tilted until it topples: the table and the block are where `topple tilt` has them, at
        the event that is chosen by its name and at the end; left, the drawing is the scene's again."""
        self.type_scene(FALLING)
        self.answered()
        self.click("#play")
        self.awaits("!document.getElementById('film').hidden")
        case = self.native_test()
        names = self.value("[...document.querySelectorAll('.event')].map(b => b.textContent)")
        self.assertEqual([name.split(" at facet")[0].split(",")[0] for name in names], [event["what"] for event in case["events"]][:len(names)])
        at = next(i for i, event in enumerate(case["events"]) if event["what"] == "begins to move")
        self.value(f"document.querySelectorAll('.event')[{at}].click()")
        self.frame()
        self.assertAlmostEqual(self.drawn_turn(), case["events"][at]["angle_deg"], places=3)
        self.assertEqual(self.value("document.querySelectorAll('.event[aria-current=true]').length"), 1)
        self.value("(() => { const s = document.querySelector('.film input'); s.value = s.max; s.dispatchEvent(new Event('input')); })()")
        self.frame()
        turn = self.turned()
        last = [moment for moment in case["moments"] if moment["time_s"] <= case["events"][-1]["time_s"]][-1]
        self.assertAlmostEqual(turn, last["turned_deg"], delta=2)
        self.assertGreater(turn, 80)
        self.assertIn("rests", self.value("document.querySelector('.film-said').textContent"))
        self.click("#play")
        self.frame()
        self.assertTrue(self.value("document.getElementById('film').hidden"))
        self.assertIsNone(self.value("document.querySelector('g.moving').getAttribute('transform')"))
        self.assertAlmostEqual(self.drawn_turn(), 5, places=4)

    def turned(self):
        """By how much the block is drawn turned on its table, degrees."""
        return float(re.search(r"rotate\(([-\d.e]+)\)", self.value("document.querySelector('g.moving').getAttribute('transform')")).group(1))

    def native_test(self):
        """The native program's tilt test of the scene on the page."""
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        (folder / "scene.yaml").write_text(self.text() + "\ntilt_test: {engine: dynamics}\n", encoding="utf-8")
        status, out, err = run("tilt", "--json", "--moments=1200", "scene.yaml", folder=folder)
        self.assertEqual(status, 0, err)
        return json.loads(out)["cases"][0]

    def test_less_motion_where_it_was_asked_for(self):
        """The test then stands at the moment at which the block begins to move, and nothing plays by itself."""
        self.browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-reduced-motion", "value": "reduce"}])
        self.type_scene(FALLING)
        self.answered()
        self.click("#play")
        self.awaits("!document.getElementById('film').hidden")
        self.frame()
        first = self.drawn_turn()
        self.assertGreater(first, 26)
        time.sleep(0.3)
        self.assertEqual(self.drawn_turn(), first)
        self.browser.call("Emulation.setEmulatedMedia", features=[])

    def test_first_gesture(self):
        """Who was never here sees the drawing swing by itself; a touch ends it where it began, for good."""
        self.load(kept=NEW)
        self.awaits(f"Math.abs({TURN} - 20) > 1")
        self.assertTrue(self.value("document.body.classList.contains('inviting')"))
        self.mouse("mousePressed", 600, 300)
        self.mouse("mouseReleased", 600, 300)
        self.answered()
        self.frame()
        self.assertAlmostEqual(self.drawn_turn(), 20, places=4)
        time.sleep(0.4)
        self.assertAlmostEqual(self.drawn_turn(), 20, places=4)
        self.value("history.replaceState(null, ''); localStorage.removeItem('topple.scene')")
        self.reload()
        time.sleep(0.4)
        self.assertFalse(self.value("document.body.classList.contains('inviting')"))

    def test_complaint_moves_nothing(self):
        """While a vertex is dragged through another edge the message comes and goes, and the drawing stays where it is."""
        self.type_scene(POLYGON)
        self.answered()
        place = "(() => { const r = document.getElementById('drawing').getBoundingClientRect(); return [r.x, r.y, r.width, r.height]; })()"
        before = self.value(place)
        self.type_scene(POLYGON.replace("topple: 1", "topple: 1\noops: 3"))
        self.refused()
        self.assertEqual(self.value(place), before)
        self.assertIn("oops", self.message())

    def test_work_is_kept(self):
        """A reload finds the scene as it was left, in this tab and in a new one; a link that was copied before does not
        bring an older one back. Nothing is waited for: who reloads as the hand lets go loses nothing either."""
        self.type_scene(POLYGON)
        self.answered()
        self.click("#link")
        self.awaits("location.hash.length > 10")
        self.drag("tilt.angle_deg", -10, -30)
        self.answered()
        left = self.text()
        self.assertNotEqual(left, POLYGON.rstrip("\n"))
        self.reload()
        self.assertEqual(self.text(), left)
        kept = "JSON.parse(localStorage.getItem('topple.scene.' + localStorage.getItem('topple.scene').split(' ')[0])).text"
        self.awaits(f"localStorage.getItem('topple.scene') !== null && {kept} === {json.dumps(left)}")  # what a new tab reads
        if IN_FIREFOX:  # Chromium now and then reads what was stored before, for a moment
            self.value("history.replaceState(null, '')")  # as a new tab has it
            self.reload()
            self.assertEqual(self.text(), left)
        for way in (12, -24):  # at once, within the time in which a drag is not kept yet
            self.drag("tilt.angle_deg", way, way)
            self.reload()
            before, left = left, self.text()
            self.assertNotEqual(left, before)
        x, y = self.knob("tilt.angle_deg")
        self.mouse("mousePressed", x, y)
        self.mouse("mouseMoved", x + 10, y + 30)  # while the hand holds it
        self.reload()
        self.assertNotEqual(self.text(), left)
        self.mouse("mouseReleased", x + 10, y + 30)

    def test_each_tab_keeps_its_own(self):
        """Another tab that is changed later does not change what a reload finds here; beyond six the oldest is forgotten."""
        self.type_scene(POLYGON)
        self.answered()
        self.reload()
        mine = self.value("history.state.tab")
        self.awaits("localStorage.getItem('topple.scene') === history.state.tab")
        self.value("""(() => { for (let i = 0; i < 7; i++) localStorage.setItem('topple.scene.t' + i, JSON.stringify({name: 'other.yaml', text: 'topple: 1', files: {}}));
          localStorage.setItem('topple.scene', ['t0', 't1', 't2', 't3', history.state.tab, 't4', 't5', 't6'].join(' ')); })()""")
        self.reload()
        self.assertEqual(self.text(), POLYGON)
        self.drag("tilt.angle_deg", -10, -30)
        self.reload()
        self.assertIn("A polygon", self.text())
        self.assertEqual(self.value("localStorage.getItem('topple.scene')"), f"{mine} t0 t1 t2 t3 t4")
        self.assertEqual(self.value("Object.keys(localStorage).filter(k => k.startsWith('topple.scene.')).length"), 6)

    def test_tab_leaves_the_editor(self):
        self.click("#tab-text")
        self.frame()
        self.value("document.querySelector('.cm-content').focus()")
        before = self.text()
        self.press("Tab")
        self.assertFalse(self.value("document.activeElement.classList.contains('cm-content')"))
        self.assertEqual(self.text(), before)

    def test_keys_are_explained(self):
        """Where the cursor is in the text, it is said what its key means, in the program's own words."""
        self.type_scene(POLYGON)
        self.answered()
        x, y = self.value("(() => { const r = [...document.querySelectorAll('.cm-line')].find(l => l.textContent.startsWith('tilt:'))"
                          ".getBoundingClientRect(); return [r.x + 15, r.y + r.height / 2]; })()")
        self.mouse("mousePressed", x, y)
        self.mouse("mouseReleased", x, y)
        self.awaits("/^tilt, a key of scenes/.test(document.getElementById('key-help').textContent)")
        said = self.value("document.getElementById('key-help').textContent")
        word = run("explain", "tilt")[1].split("\ntilt, a key of scenes\n")[1].split("\n")[0].strip()
        self.assertIn(word, said)

    def test_fields_say_what_they_do_not_take(self):
        """95, -5 and abc change nothing, are called out while they stand there, and are gone when the field is left; a
        comma is a point; without a tilt the slider stands at its beginning."""
        field = "document.querySelector('#numbers input[type=text]')"
        for typed, said in (("95", "from 0 to 90"), ("-5", "from 0 to 90"), ("abc", "not a number")):
            with self.subTest(typed):
                self.value(f"{field}.focus(); {field}.select()")
                self.browser.call("Input.insertText", text=typed)
                if typed == "95":  # its first digit was a tilt of its own
                    self.answered()
                self.assertEqual(self.value("document.querySelector('#numbers .why').textContent"), said)
                self.assertEqual(self.value(f"{field}.getAttribute('aria-invalid')"), "true")
                self.value(f"{field}.blur()")
                self.assertEqual(self.value(f"{field}.value"), "20")
                self.assertEqual(self.value("document.querySelector('#numbers .why').textContent"), "")
        self.value(f"{field}.focus(); {field}.select()")
        self.browser.call("Input.insertText", text="12,5")
        self.answered()
        self.assertIn("angle_deg: 12.5}", self.text())
        self.example("slab_left")
        self.assertEqual(self.value("document.querySelector('#numbers input[type=range]').value"), "0")
        self.assertEqual(self.value("document.querySelector('#numbers input[type=range]').getAttribute('aria-valuetext')"), "none")

    def test_vertices_by_hand(self):
        """A double click on an edge puts a vertex there; Delete takes the one with the focus away; Insert adds one, as Enter does; each
        is one step of undo."""
        self.type_scene(POLYGON)
        self.answered()
        before = self.text()
        (x0, y0), (x1, y1) = self.knob("block.outline.2"), self.knob("block.outline.3")
        x, y = (x0 + x1) / 2, (y0 + y1) / 2
        self.double_click(x, y)
        self.answered()
        added = re.search(r"\[110, 60\], \[([-\d.]+), ([-\d.]+)\], \[60, 140\]", self.text())
        self.assertAlmostEqual(float(added.group(1)), 85, delta=1.5)
        self.assertAlmostEqual(float(added.group(2)), 100, delta=1.5)
        self.value("""document.querySelector('[data-handle="block.outline.3"]').focus()""")
        self.press("Delete")
        self.answered()
        self.assertEqual(self.text(), before)
        self.value("""document.querySelector('[data-handle="block.outline.0"]').focus()""")
        self.press("Insert")
        self.answered()
        self.assertIn("[[0, 0], [50, 0], [100, 0],", self.text())
        self.value("""document.querySelector('[data-handle="block.outline.0"]').focus()""")
        self.assertIn("Enter puts a vertex behind it", self.value("document.activeElement.getAttribute('aria-label')"))
        self.press("Enter")
        self.answered()
        self.assertIn("[[0, 0], [25, 0], [50, 0],", self.text())
        for _ in range(4):
            self.click("#undo")
        self.assertEqual(self.text(), before)

    def add(self, name):
        """By the menu, as a hand does it."""
        self.value("(() => { const s = document.getElementById('add'); s.dispatchEvent(new Event('focus'));"
                   f" s.value = '{name}'; s.dispatchEvent(new Event('change')); }})()")
        self.answered()

    def test_loads_by_the_menu(self):
        """A slab gets corners of its own, water and an anchor without a word of YAML; each has handles, is in the answer, and
        is one step of undo."""
        self.example("slab")
        before = self.text()
        for name, handle in (("outline", "block.outline.2"), ("water", "height of the water"), ("anchor", "loads.anchors.0.at")):
            self.add(name)
            self.assertIn(handle, self.value("[...document.querySelectorAll('.handle')].map(h => h.dataset.handle)"))
        self.drag("height of the water", 0, -30)
        self.answered()
        loads = {each["name"] for each in self.solved()["cases"][0]["loads"]}
        self.assertTrue(any("water" in name for name in loads) and any("anchor" in name for name in loads), loads)
        self.value("document.getElementById('add').dispatchEvent(new Event('focus'))")
        self.assertEqual(self.value("[...document.querySelectorAll('#add option:disabled')].map(o => o.value)"), ["water", "outline"])
        for _ in range(4):
            self.click("#undo")
        self.assertEqual(self.text(), before)

    def test_many_vertices(self):
        """Of 600 vertices those near the pointer have handles, wherever it is."""
        self.type_scene(polygon(600).replace("], [", "],\n    ["))
        self.answered()
        self.assertLess(self.value("document.querySelectorAll('.handle').length"), 160)
        box = self.value("(() => { const r = document.querySelector('.shape.block').getBoundingClientRect(); return [r.x + r.width / 2, r.y]; })()")
        self.browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=box[0], y=box[1] + 4)
        self.frame()
        self.frame()
        self.assertIn("block.outline.300", self.value("[...document.querySelectorAll('.handle')].map(h => h.dataset.handle)"))

    def test_alias_is_no_handle(self):
        """An angle by alias cannot be dragged, and a key behind a comma that ends its map is put there properly."""
        self.type_scene(POLYGON.replace("title: A polygon", "parameters: {t: &t 12}").replace("angle_deg: 12", "angle_deg: *t"))
        self.refused()  # the program has no aliases of numbers, and says so
        handle = "document.querySelector('.handle.tilt')?.getAttribute('aria-label') ?? 'alias'"
        self.assertIn("alias", self.value(handle))
        self.type_scene(POLYGON.replace("towards: left, angle_deg: 12", "towards: left,"))
        self.answered()
        self.drag("tilt.angle_deg", -20, -40)
        self.answered()
        self.assertRegex(self.text(), r"towards: left, angle_deg: [\d.]+}")


if __name__ == "__main__":
    main()
