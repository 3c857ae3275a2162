# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Nothing that the page shows is false: the opening film leaves the scene as it is, films of a path end at the collapse, water
is level, reactions balance what they are said to, and the verdict of one scene never stands under the title of another."""

import json
import math
import pathlib
import re
import tempfile
import time

from drawn_case import DrawnCase
from page_case import NEW, main
from panel_case import PanelCase
from test_shown_parts import MANY_WITH_CASES, PATH_TEST, WITH_CASES

TURN = "(() => { const m = document.querySelector('g.frame').getCTM(); return Math.atan2(-m.b, m.a) * 180 / Math.PI; })()"
KEPT = "JSON.stringify([{...localStorage}, {...sessionStorage}, location.hash, history.state, history.length])"
TILT = "document.querySelectorAll('#numbers input')[1].value"

# What the page's workers can be made to do, from before the page is there: end without a word, or take as long as is asked for.
WORKERS = NEW.replace("} catch", "localStorage.setItem('topple.touched', '1'); } catch") + """
  window.workers = []; window.held = null;
  window.Worker = class extends Worker { constructor(...given) { super(...given); window.workers.push(this); }
    postMessage(message, ...rest) { if (message.kind === 'run' && window.held !== null) window.held.push(() => super.postMessage(message, ...rest)); else super.postMessage(message, ...rest); } };"""


class Film(DrawnCase):
    def opened_new(self):
        """As the page comes to who was never here, in the middle of a swing."""
        self.load(kept=NEW)
        first = 20
        self.awaits(f"Math.abs({TURN} - {first}) > 2")
        self.assertTrue(self.value("document.body.classList.contains('inviting')"))

    def unchanged(self, kept):
        self.frame()
        self.assertAlmostEqual(self.drawn_turn(), 20, places=4)
        self.assertFalse(self.value("document.body.classList.contains('inviting')"))
        self.assertEqual(self.value(TILT), "20")
        self.assertIn("Stands at 20°", self.value("document.getElementById('verdict-said').textContent"))
        self.assertTrue(self.value("document.getElementById('undo').disabled"))
        now = json.loads(self.value(KEPT))
        now[0].pop("topple.touched", None)  # that somebody was here is noted once they touch something
        self.assertEqual(now, kept)

    def test_any_input_ends_the_opening_film_where_it_began(self):
        """A click, the wheel, a key in the middle of a swing: the tilt is 20° as before, nothing can be undone, nothing was kept but that
        somebody was here, and a reload finds block E at 20°. Before, the tilt at which the film had come stayed, also over a reload."""
        for what in ("click", "wheel", "key"):
            with self.subTest(what):
                self.opened_new()
                kept = json.loads(self.value(KEPT))
                if what == "click":
                    self.mouse("mousePressed", 600, 300)
                    self.mouse("mouseReleased", 600, 300)
                elif what == "wheel":
                    self.browser.call("Input.dispatchMouseEvent", type="mouseWheel", x=500, y=300, deltaX=0, deltaY=-120)
                    self.awaits("!document.body.classList.contains('inviting')")
                else:
                    self.press("a")
                self.unchanged(kept)
                self.assertIn("angle_deg: 20}", self.text())
                self.reload()
                self.assertAlmostEqual(self.drawn_turn(), 20, places=4)

    def test_the_opening_film_writes_nothing_while_it_runs(self):
        """For a second of the film storage, address and history are as they were before, and the tilt handle swings with the base, whose
        tilt stays below the onset of 28.7°."""
        self.opened_new()
        kept, turns = self.value(KEPT), []
        end = time.monotonic() + 2
        while time.monotonic() < end:
            turns.append(self.drawn_turn())
            self.assertEqual(self.value(KEPT), kept)
            self.assertEqual(self.value(TILT), "20")
        self.assertGreater(max(turns) - min(turns), 1)
        self.assertLess(max(turns), 28.7)
        self.mouse("mousePressed", 600, 300)
        self.mouse("mouseReleased", 600, 300)

    def test_a_path_is_played_to_its_collapse(self):
        """The slider leads from level to the collapse at atan ½; the block stays at its place, and the words say the tilt and no time."""
        self.type_scene(PATH_TEST)
        self.answered()
        self.click("#play")
        self.awaits("!document.getElementById('film').hidden", 60)
        seek = "(() => { const s = document.querySelector('#film input[type=range]'); s.value = %d; s.dispatchEvent(new Event('input')); })()"
        turns = []
        for at in range(0, 2001, 100):
            self.value(seek % at)
            turns.append(self.drawn_turn())
            x, y, width, height = self.value("(() => { const r = document.querySelector('.shape.block').getBoundingClientRect(); return [r.x, r.y, r.width, r.height]; })()")
            self.assertTrue(0 < x < 1280 and 0 < y < 900 and 20 < width < 1000 and 20 < height < 900, (x, y, width, height))
        self.assertEqual(turns, sorted(turns))
        self.assertAlmostEqual(turns[0], 0, places=3)
        self.assertAlmostEqual(turns[-1], math.degrees(math.atan(0.5)), delta=2e-3)
        said = self.value("document.querySelector('.film-said').textContent")
        self.assertRegex(said, r"^tilt 26\.57°: begins to move$")
        self.assertTrue(self.value("document.querySelector('#film select').hidden"))

    def test_water_is_level_on_the_screen(self):
        """Of a slab with water behind it at tilts to either side, the upper edge of the water is level, while the tilt is dragged too."""
        for towards in ("left", "right"):
            self.type_scene("topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 2}, unit_weight_kn_m3: 26}\nbase: {mated: true, beyond: {left: 1, right: 1}}\n"
                            f"friction_angle_deg: 30\nloads: {{water: {{height: 1}}}}\ntilt: {{towards: {towards}, angle_deg: 15}}\n")
            self.answered()
            for way in (None, (-10, -40)):
                if way is not None:
                    self.drag("tilt.angle_deg", *(way if towards == "left" else (-way[0], way[1])))
                    self.answered()
                heights = self.value("""(() => { const p = document.querySelector('.shape.water'); const m = p.getCTM();
                  return p.getAttribute('d').slice(1, -1).split('L').map(t => t.split(' ').map(Number)).map(([x, y]) => m.b * x + m.d * y + m.f); })()""")
                with self.subTest(towards, way=way):
                    self.assertGreater(abs(self.drawn_turn()), 14)
                    self.assertAlmostEqual(heights[-1], heights[-2], delta=0.01)
                    self.assertLess(heights[-1], heights[0] - 20)

    def test_a_slope_is_drawn_at_its_dip(self):
        """Where x runs along a slope the drawing is turned by its dip, whose number the handle of the tilt changes; before, it was drawn
        level, and the handle tilted it further. A tilt beyond the dip is added, and a load case is drawn at the dip that it has."""
        text = WITH_CASES[:WITH_CASES.index("cases:")]
        self.type_scene(text)
        self.answered()
        self.assertAlmostEqual(self.drawn_turn(), 30, places=4)
        self.drag("tilt.angle_deg", 10, 30)
        self.answered()
        dip = float(re.search(r"dip_deg: ([\d.]+)", self.text()).group(1))
        self.assertLess(dip, 29)
        self.assertNotIn("tilt:", self.text())
        self.assertAlmostEqual(self.drawn_turn(), dip, places=4)
        self.type_scene(text + "tilt: {towards: left, angle_deg: 5}\n")
        self.answered()
        self.assertAlmostEqual(self.drawn_turn(), 35, places=4)
        self.type_scene(text + "cases:\n  - {name: steeper, set: {slope.dip_deg: 40}}\n")
        self.answered()
        self.assertAlmostEqual(self.drawn_turn(), 40, places=4)


class Verdicts(PanelCase):
    def load(self, fragment="", width=1280, height=900, kept=WORKERS):
        super().load(fragment, width, height, kept)

    def badge(self):
        return self.value("['scene-title', 'verdict-said', 'factor-said'].map((id) => document.getElementById(id).textContent)")

    def seen(self):
        """All that can be read on the page but its menus: verdicts in the badge and beside it."""
        return self.value("document.querySelector('.badge').innerText + '\\n' + document.getElementById('panels').innerText")

    def hold(self):
        """From now on no request reaches a worker."""
        self.value("window.held = []")

    def let_go(self):
        self.value("(() => { const held = window.held; window.held = null; held.forEach((post) => post()); })()")

    def open_example(self, name):
        self.value(f"(() => {{ const s = document.getElementById('examples'); s.value = '{name}.yaml'; s.dispatchEvent(new Event('change')); }})()")

    def opened(self, name, text):
        path = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()), name)
        path.write_text(text)
        self.choose(path)
        self.awaits(f"document.getElementById('scene-title').title === {name!r}")

    def nothing_of_block_e(self):
        """Neither its verdict nor its numbers, and no drawing of it."""
        self.assertEqual(self.badge()[1:], ["", ""])
        self.assertNotRegex(self.seen(), r"Stands at 20|28\.735|35\.201")
        self.assertEqual(self.value("document.querySelectorAll('.shape.block, .symbol').length"), 0)

    def test_another_scene_that_takes_long(self):
        """While the answer for another scene is awaited there is nothing of block E under its title; then it is there."""
        self.assertIn("Stands at 20°", self.badge()[1])
        self.hold()
        self.open_example("slab")
        self.frame()
        self.assertNotIn("Block E", self.badge()[0])
        self.nothing_of_block_e()
        time.sleep(0.5)
        self.nothing_of_block_e()
        self.assertIn("The scene is being solved.", self.seen())
        self.let_go()
        self.answered()
        self.assertNotEqual(self.badge()[1], "")
        self.assertNotIn("The scene is being solved", self.seen())

    def test_a_scene_that_is_pasted_over(self):
        """A text with another title, typed over the one that is there: title and verdict change together."""
        pasted = PATH_TEST.replace("topple: 1\n", "topple: 1\ntitle: Pasted over\n")
        self.hold()
        self.type_scene(pasted)
        end = time.monotonic() + 0.7
        while time.monotonic() < end:
            title, verdict, _ = self.badge()
            self.assertTrue("Block E" in title or verdict == "", (title, verdict))
        self.click("#tab-results")
        self.assertEqual(self.badge(), ["Pasted over", "", ""])
        self.assertNotRegex(self.seen(), r"28\.735|35\.201")
        self.let_go()
        self.answered()
        self.assertIn("Stands at 20°", self.badge()[1])

    def test_another_scene_that_is_refused(self):
        self.opened("refused.yaml", "topple: 1\ntitle: Refused\noops: 2\n")
        self.refused()
        self.assertEqual(self.badge()[0], "Refused")
        self.nothing_of_block_e()

    def test_a_number_that_takes_long_is_greyed(self):
        """Of the same scene the last answer stays, greyed, and says that the scene is being solved."""
        self.hold()
        self.value("(() => { const tilt = document.querySelectorAll('#numbers input')[1]; tilt.value = '21'; tilt.dispatchEvent(new Event('input')); })()")
        self.awaits("document.getElementById('badge').classList.contains('of-before')")
        self.frame()
        self.assertIn("Stands at 20°", self.badge()[1])
        self.assertIn("The scene is being solved; this is the last answer.", self.seen())
        self.assertTrue(self.value("document.querySelector('svg.drawing').classList.contains('stale')"))
        self.let_go()
        self.answered()
        self.assertIn("Stands at 21°", self.badge()[1])
        self.assertFalse(self.value("document.getElementById('badge').classList.contains('of-before')"))

    def test_a_dead_worker(self):
        """The core's workers end without a word; a scene that is then opened is answered by another worker, and until then there is nothing of
        block E under its title."""
        self.value("window.workers.splice(0).forEach((worker) => worker.terminate())")
        self.open_example("slab")
        self.frame()
        self.nothing_of_block_e()
        self.answered(60)
        self.assertNotEqual(self.badge()[1], "")
        self.assertTrue(self.value("document.getElementById('message').hidden"))

    def test_a_worker_that_fails(self):
        """An error outside of a run: the worker is replaced, and the next scene is solved."""
        self.value("window.workers.forEach((worker) => worker.onerror({preventDefault() {}, message: 'no memory'}))")
        self.open_example("slab")
        self.answered(60)
        self.assertNotEqual(self.badge()[1], "")

    def test_load_cases_of_one_block(self):
        """The case that governs is shown with what it requires; another one is chosen, and all is of that; the list has all three."""
        self.opened("cases.yaml", WITH_CASES)
        self.answered()
        self.assertEqual(self.badge()[0], "A slab in load cases")
        self.assertEqual(self.value("document.getElementById('load-cases').value"), "wet")
        self.assertRegex(self.value("document.getElementById('required-said').textContent"), r"^FoS 1\.800 required: not met$")
        rows = self.rows("#panel-verdict")
        self.assertEqual([(row[0], row[-1]) for row in rows[:3]], [("wet", "1.800, not met"), ("static", "1.5, met"), ("earthquake", "1.100, met")])
        wet = self.badge()[2]
        self.hold()
        self.value("(() => { const s = document.getElementById('load-cases'); s.value = 'static'; s.dispatchEvent(new Event('change')); })()")
        self.frame()
        self.assertEqual(self.badge()[1:], ["", ""])
        self.let_go()
        self.answered()
        self.assertNotEqual(self.badge()[2], wet)
        self.assertIn("1.866", self.badge()[2])
        self.assertRegex(self.value("document.getElementById('required-said').textContent"), r"^FoS 1\.5(00)? required: met$")
        self.tab("curves")
        self.awaits("document.querySelector('#panel-curves .told')?.textContent.includes('points in')", 60)
        self.tab("forces")
        self.assertIn("are in balance with the weight and with: ", self.said("#panel-forces"))
        self.open_example("slab")
        self.answered()
        self.assertTrue(self.value("document.getElementById('load-case').hidden"))
        self.assertTrue(self.value("document.getElementById('required-said').hidden"))

    def test_load_cases_of_many_blocks(self):
        self.opened("many.yaml", MANY_WITH_CASES)
        self.answered()
        self.assertEqual(self.value("document.getElementById('load-cases').value"), "earthquake")
        self.assertIn("Collapses", self.badge()[1])
        self.awaits("document.querySelector('#panel-verdict pre')?.textContent.includes('earthquake')", 60)
        self.value("(() => { const s = document.getElementById('load-cases'); s.value = 'static'; s.dispatchEvent(new Event('change')); })()")
        self.answered()
        self.assertIn("Stands", self.badge()[1])

    def test_what_the_reactions_balance(self):
        """The weight where it acts alone; water, uplift and the anchor by name where they act too."""
        self.tab("forces")
        self.assertIn("just balance the weight;", self.said("#panel-forces"))
        self.example("block_under_water")
        said = self.said("#panel-forces")
        self.assertNotIn("just balance the weight", said)
        for name in ("water", "uplift", "anchor"):
            self.assertRegex(said, r"in balance with the weight and with: [^;]*" + name)


if __name__ == "__main__":
    main()
