# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Passing a scene on: the code that a camera reads, the gallery, two scenes side by side, and the printed page."""

import base64
import json
import random
import re
import unittest

from node_case import NODE, node
from page_case import ROOT, main
from panel_case import PanelCase

EXPLORER = ROOT / "src" / "applications" / "explorer"
READER = EXPLORER / "node_modules" / "jsqr" / "dist" / "jsQR.js"
# What a camera sees: each dot 4 by 4 dots, black on white
READ = f"""const {{ default: read }} = await import({json.dumps(READER.as_uri())});
  const seen = (dots) => {{ const size = 4 * dots.length, bytes = new Uint8ClampedArray(4 * size * size).fill(255);
    for (let y = 0; y < size; y++) for (let x = 0; x < size; x++) if (dots[y >> 2][x >> 2]) bytes.fill(0, 4 * (y * size + x), 4 * (y * size + x) + 3);
    return read(bytes, size, size)?.data ?? null; }};"""


@unittest.skipIf(NODE is None, "there is no node: install Debian's package nodejs")
@unittest.skipUnless(READER.is_file(), f"there is no {READER}: ./run --explorer installs it")
class Parts(unittest.TestCase):
    def test_codes_are_read_again(self):
        """By a reader of other authors: links from a few to almost as many characters as a code holds; a longer one has none."""
        draw = random.Random(5)
        letters = "ABCDEFGHabcdefgh0123456789-_"
        links = ["https://example.org/explorer.html#z=" + "".join(draw.choice(letters) for _ in range(size)) for size in (3, 80, 400, 1500, 2800)]
        body = READ + "return given.map((link) => { const dots = it.dotsOf(link); return dots === null ? null : seen(dots); });"
        self.assertEqual(node(EXPLORER / "send" / "code.js", body, [*links, "x" * 4000]), [*links, None])


class Sent(PanelCase):
    def load(self, fragment="", width=1280, height=900):
        super().load(fragment, width, height)

    def dialog(self, name):
        self.click("#" + name)
        self.awaits(f"document.getElementById('{name}-dialog').open")

    @unittest.skipUnless(READER.is_file(), f"there is no {READER}: ./run --explorer installs it")
    def test_code_leads_to_the_scene(self):
        """The code on the page, read, is the link beside it, which opens the scene that was changed."""
        self.drag("tilt.angle_deg", -10, -30)
        self.answered()
        text = self.text()
        self.dialog("send")
        self.awaits("document.querySelector('svg.code') !== null")
        link = self.value("document.querySelector('.send-link input').value")
        path, size = self.value("[document.querySelector('svg.code path').getAttribute('d'), document.querySelector('svg.code').viewBox.baseVal.width]")
        dots = [[False] * int(size) for _ in range(int(size))]
        for x, y in re.findall(r"M(\d+) (\d+)h", path):
            dots[int(y)][int(x)] = True
        self.assertEqual(node(READER, READ + "return seen(given);", dots), link)
        self.load("#" + link.split("#")[1])
        self.assertEqual(self.text(), text)

    def test_gallery(self):
        """Each card that is seen gets its picture and verdict; one that is pressed opens its scene."""
        self.dialog("gallery")
        total = self.value("document.querySelectorAll('.card').length")
        self.assertGreater(total, 45)
        for _ in range(40):
            self.value("[...document.querySelectorAll('.card:not([data-drawn])')][0]?.scrollIntoView()")
            if self.value("document.querySelectorAll('.card[data-drawn]').length") == total:
                break
            self.browser.call("Runtime.evaluate", awaitPromise=True, expression="new Promise(done => setTimeout(done, 400))")
        self.awaits(f"document.querySelectorAll('.card[data-drawn]').length === {total}", 60)
        empty = self.value("[...document.querySelectorAll('.card')].filter(c => !c.dataset.kind).map(c => c.textContent)")
        self.assertEqual(empty, [])
        self.assertGreater(self.value("document.querySelectorAll('.card svg.thumb path.block').length"), 35)
        self.assertEqual(self.value("[...document.querySelectorAll('.card')].filter(c => !c.querySelector('svg.thumb path')).map(c => c.textContent)"), [])
        self.value("[...document.querySelectorAll('.card')].find(c => c.textContent.includes('Columns on a wet slope')).click()")
        self.answered()
        self.assertEqual(self.said("#scene-title"), "Columns on a wet slope")
        self.assertFalse(self.value("document.getElementById('gallery-dialog').open"))

    def test_two_scenes_side_by_side(self):
        self.tab("compare")
        self.button("Keep this scene to compare with")
        self.drag("tilt.angle_deg", -15, -40)
        self.answered()
        self.awaits("document.querySelector('#panel-compare table tr.governs') !== null")
        rows = {row[0]: row[1:] for row in self.rows("#panel-compare")}
        self.assertEqual(rows["Tilt"][0], "20°")
        self.assertNotEqual(rows["Tilt"][0], rows["Tilt"][1])
        self.assertEqual(rows["Area (m²)"][0], rows["Area (m²)"][1])
        self.assertIn("− tilt: {towards: left, angle_deg: 20}", self.said("#panel-compare pre"))
        self.assertEqual(self.value("document.querySelectorAll('#panel-compare figure svg.thumb').length"), 2)
        self.button("Change places")
        self.answered()
        self.awaits("document.querySelector('#panel-compare tbody tr td:nth-child(3)').textContent === '20°'")
        self.assertEqual(self.said("#verdict-said"), "Stands at 20°")

    def test_printed(self):
        """On paper stand the title, the verdict, the drawing and the results that are open, and no tools; in the dark as well."""
        for scheme in ("light", "dark"):
            self.browser.call("Emulation.setEmulatedMedia", media="print", features=[{"name": "prefers-color-scheme", "value": scheme}])
            self.addCleanup(self.browser.call, "Emulation.setEmulatedMedia", media="", features=[])
            shown = self.value("['.toolbar', '.below', '.handles', '.tabs', '.badge', '#drawing svg', '#panel-results']"
                               ".map(s => document.querySelector(s).getClientRects().length > 0 && getComputedStyle(document.querySelector(s)).display !== 'none')")
            self.assertEqual(shown, [False, False, False, False, True, True, True])
            top = self.value("['#badge', '#drawing', '#panel-results'].map(s => document.querySelector(s).getBoundingClientRect().top)")
            self.assertEqual(top, sorted(top))
        pages = base64.b64decode(self.browser.call("Page.printToPDF", printBackground=True)["data"])
        self.assertTrue(pages.startswith(b"%PDF"))
        self.assertLessEqual(len(re.findall(rb"/Type\s*/Page\b", pages)), 2)


if __name__ == "__main__":
    main()
