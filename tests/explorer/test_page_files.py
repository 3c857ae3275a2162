# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What goes into the explorer and out of it: every example, files of all kinds, saved scenes, links that carry one,
and all of it without a network."""

import json
import pathlib
import re
import tempfile
import time
import unittest

from drawn_case import DrawnCase
from page_case import ADDRESS, ROOT, main, run

EXAMPLES = ROOT / "examples"
BLOCK = "document.querySelector('.shape.block').getAttribute('d')"


class Files(DrawnCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        super().setUp()

    def test_every_example(self):
        """The menu has each scene of examples/, and the page has an answer and a drawing for each."""
        names = self.value("[...document.querySelectorAll('#examples optgroup[label=Examples] option')].map(o => o.value).filter(v => v)")
        self.assertEqual(names, sorted(path.name for path in EXAMPLES.glob("*.yaml")))
        for name in names:
            with self.subTest(name):
                self.example(name.removesuffix(".yaml"))
                self.assertGreater(len(self.value(BLOCK)), 12)
                self.assertTrue(self.value("document.getElementById('message').hidden"))

    def test_scene_with_its_csv(self):
        """A scene alone misses its file and says so; opened after it, the file is taken; both at once are too."""
        self.choose(EXAMPLES / "boulder.yaml")
        self.refused()
        self.assertIn("boulder.csv", self.message())
        self.choose(EXAMPLES / "boulder.csv")
        self.answered()
        drawn = self.value(BLOCK)
        self.load()
        self.choose(EXAMPLES / "boulder.yaml", EXAMPLES / "boulder.csv")
        self.awaits("document.getElementById('scene-name').textContent === 'boulder.yaml'")
        self.answered()
        self.assertEqual(self.value(BLOCK), drawn)

    def test_drawings_become_scenes(self):
        """A DXF, an SVG and a CSV by themselves: a scene is begun that names them, which the command line reads too."""
        for name in ("section_arcs.dxf", "boulder_traced.svg", "boulder.csv", "block_e_valley.wkt"):
            with self.subTest(name):
                self.choose(EXAMPLES / name)
                self.awaits(f"document.getElementById('scene-name').textContent === '{name.rsplit('.', 1)[0]}.yaml'")
                self.answered()
                self.assertIn(name, self.text())
                (self.folder / name).write_bytes((EXAMPLES / name).read_bytes())
                self.assertEqual(self.value(BLOCK), self.solved(self.folder)["outlines"]["block"])

    def test_what_is_no_scene_is_refused_in_words(self):
        path = self.folder / "letter.odt"
        path.write_bytes(b"\xff\xfe\x00 no scene")
        before = self.text()
        self.choose(path)
        self.awaits("!document.getElementById('message').hidden")
        self.assertIn("letter.odt is not a scene", self.message())
        self.assertEqual(self.text(), before)

    def test_saved_bytes_are_the_text(self):
        self.browser.call("Page.setDownloadBehavior", behavior="allow", downloadPath=str(self.folder))
        self.click("#save")
        path = self.folder / "block_e_valley.yaml"
        for _ in range(100):
            if path.exists() and path.stat().st_size > 0:
                break
            time.sleep(0.05)
        self.assertEqual(path.read_bytes(), (EXAMPLES / "block_e_valley.yaml").read_bytes())

    def test_link_carries_the_scene_and_its_files(self):
        """The address of a page that opened a boulder from a CSV, opened anew, shows that boulder."""
        self.example("boulder")
        self.drag("tilt.angle_deg", -5, -30)  # as it stands in the menu its link would be its name
        self.answered()
        drawn, text = self.value(BLOCK), self.text()
        self.click("#link")
        fragment = self.awaits("location.hash.length > 10 && location.hash")
        self.assertRegex(fragment, r"^#z=[\w-]+$")
        self.load(fragment)
        self.assertEqual(self.value("document.getElementById('scene-name').textContent"), "boulder.yaml")
        self.assertEqual((self.value(BLOCK), self.text()), (drawn, text))

    def test_link_opened_in_the_open_page(self):
        self.click("#link")
        fragment = self.awaits("location.hash.length > 10 && location.hash")
        self.example("slab")
        self.value("history.replaceState(null, '', ' ')")
        self.value(f"location.hash = '{fragment}'")
        self.awaits("document.getElementById('scene-name').textContent === 'block_e_valley.yaml'")
        self.answered()

    def test_without_a_network(self):
        """Loaded, the page needs none: examples are opened, dragged and solved with every network off."""
        self.browser.call("Network.emulateNetworkConditions", offline=not ADDRESS.startswith("http"), latency=0,
                          downloadThroughput=-1, uploadThroughput=-1)
        self.example("block_f")
        self.drag("tilt.angle_deg", -10, -30)
        self.answered()
        self.browser.call("Network.emulateNetworkConditions", offline=False, latency=0, downloadThroughput=-1,
                          uploadThroughput=-1)

    def test_prints(self):
        """On paper: the drawing and the results, in pages that a printer has."""
        import base64
        printed = base64.b64decode(self.browser.call("Page.printToPDF")["data"])
        self.assertTrue(printed.startswith(b"%PDF"))
        self.assertGreater(len(printed), 10_000)

    def test_short_link_of_an_example(self):
        """An example that nobody changed has a link by its name; changed, the link carries all of it."""
        self.example("slab_left")
        self.click("#link")
        self.awaits("location.hash === '#example=slab_left.yaml'")
        self.load("#example=slab_left.yaml")
        self.assertEqual(self.value("document.getElementById('examples').value"), "slab_left.yaml")
        self.drag("tilt.angle_deg", -5, -30)
        self.answered()
        self.assertEqual(self.value("location.hash"), "")
        self.click("#link")
        self.awaits("location.hash.startsWith('#z=')")

    def test_within_another_page(self):
        """#embed shows the drawing with its verdict alone, or the tabs that are named beside it, of the scene of a link; what
        the reader keeps stays as it was; the line that is offered does that."""
        self.load("#embed&example=slab_left.yaml")
        self.assertEqual(self.value("document.getElementById('examples').value"), "slab_left.yaml")
        for hidden in ("header", ".side"):
            self.assertEqual(self.value(f"getComputedStyle(document.querySelector('{hidden}')).display"), "none")
        self.assertGreater(self.value("document.getElementById('drawing').getBoundingClientRect().width"), 1200)
        self.assertIsNone(self.value("localStorage.getItem('topple.scene')"))
        self.load("#embed=forces,map")
        self.assertEqual(self.value("[...document.querySelectorAll('[role=tab]')].filter(t => !t.hidden).map(t => t.id)"), ["tab-forces", "tab-map"])
        self.assertEqual(self.value("getComputedStyle(document.querySelector('header')).display"), "none")
        self.load()
        self.example("slab")
        self.click("#tab-curves")
        self.click("#embed")
        self.awaits("!document.getElementById('message').hidden")
        line = self.message()
        if line.startswith("<iframe"):  # where no clipboard is given to a page
            self.load("#" + re.search(r'src="[^#]*#([^"]*)"', line).group(1).replace("&amp;", "&"))
            self.assertEqual(self.value("document.querySelector('[aria-selected=true]').id"), "tab-curves")
            self.assertIn("slab", self.value("document.getElementById('scene-title').title"))

    def test_many_blocks(self):
        """They are drawn as the core lays them, with the factor that the native program finds; the dip follows its slider; other
        panels say what they are of; and one block is drawn again as before."""
        self.example("wet_columns")
        status, out, err = run("solve", "--json", "examples/blocks/wet_columns.yaml", folder=ROOT)
        self.assertEqual(status, 0, err)
        case = json.loads(out)["cases"][0]
        self.assertLess(case["fos_driving"]["value"], case["fos"]["value"])  # and so it governs
        self.assertAlmostEqual(float(self.value("document.querySelector('#factor-said strong').textContent")), case["fos_driving"]["value"], delta=0.0006)
        self.assertEqual(self.value("['block.slides', 'block:not(.slides)', 'ground', 'mechanism', 'surface'].map(c => document.querySelectorAll('.shape.' + c).length)"),
                         [3, 3, 1, 3, 1])
        self.awaits("document.querySelector('#panel-verdict pre')?.textContent.includes('strength reduction')")
        self.assertEqual(self.value("document.getElementById('play').textContent"), "Show how it begins to move")
        self.click("#play")
        self.assertEqual(self.value("[...document.querySelectorAll('.shape.block')].filter(b => b.getAnimations().length).length"), 3)
        self.click("#play")
        self.assertEqual(self.value("document.getAnimations().length"), 0)
        self.click("#tab-pivots")
        self.frame()
        self.assertIn("of scenes of one block", self.value("document.querySelector('#panel-pivots').textContent"))
        self.value("(() => { const s = document.querySelector('#numbers input[type=range]'); s.value = '10';"
                   " s.dispatchEvent(new Event('input')); s.dispatchEvent(new Event('change')); })()")
        self.answered()
        self.assertIn("dip_deg: 10", self.text())
        self.assertAlmostEqual(self.drawn_turn(), 10, places=3)
        self.example("block_e_valley")
        self.assertEqual(self.value("document.querySelectorAll('.shape.ground, .shape.mechanism').length"), 0)
        self.assertGreater(self.value("document.querySelectorAll('.handle').length"), 4)

    def test_blocks_are_dragged(self):
        """A whole block beside the others, which it meets exactly; the height of a column, whose handle comes with the pointer; the
        same by keys; and the drawing of a block that touches no other says so."""
        self.example("toppling_slope")
        line = lambda: next(line for line in self.text().split("\n") if "column 16," in line)  # noqa: E731
        self.drag("blocks.16", 1.3, 0.9)  # as near as makes it level again
        self.assertIn("at: [150, 15]", line())
        self.drag("blocks.16", 96, -72)
        self.refused()
        self.assertIn("'column 16' touches no other", self.message())
        self.click("#undo")
        self.answered()
        self.mouse("mouseMoved", *self.knob("blocks.9"))
        self.awaits("document.querySelector('[data-handle=\"blocks.9.slab.height\"]') !== null")
        self.drag("blocks.9.slab.height", -10, -17)
        self.answered()
        self.assertRegex(self.text(), r"column 9, slab: {width: 10, height: (3[89]|4[0-4])")
        self.value("document.querySelector('[data-handle=\"blocks.16\"]').focus()")
        self.press("ArrowRight")
        self.answered()
        self.assertIn("at: [150.1, 15]", line())
        self.awaits("document.querySelector('[data-handle=\"blocks.16.slab.height\"]') !== null")


if __name__ == "__main__":
    main()
