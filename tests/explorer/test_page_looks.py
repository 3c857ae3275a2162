# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""How the explorer looks: something is drawn in light and in dark, text has contrast, nothing leaves a narrow window."""

import re
import unittest

import picture
from page_case import ROOT, PageCase, main

# A text, and all grounds below it from the root to itself, painted one on the other by the browser
PAIRS = """(() => {
  const canvas = document.createElement('canvas').getContext('2d', {willReadFrequently: true});
  canvas.canvas.width = canvas.canvas.height = 1;
  const painted = colours => { canvas.clearRect(0, 0, 1, 1);
    for (const colour of colours) { canvas.fillStyle = colour; canvas.fillRect(0, 0, 1, 1); }
    return [...canvas.getImageData(0, 0, 1, 1).data].slice(0, 3).join(); };
  const found = {};
  for (const e of document.querySelectorAll('body *')) {
    if (e.closest('svg, :disabled, [hidden]') || e.getClientRects().length === 0) continue;
    if (![...e.childNodes].some(n => n.nodeType === 3 && n.textContent.trim())) continue;
    const grounds = [];
    for (let up = e; up; up = up.parentElement) grounds.unshift(getComputedStyle(up).backgroundColor);
    const pair = painted([...grounds, getComputedStyle(e).color]) + '|' + painted(grounds);
    found[pair] ??= e.tagName + '.' + e.className + ': ' + e.textContent.trim().slice(0, 30);
  }
  return Object.entries(found); })()"""
TOO_WIDE = """[...document.querySelectorAll('main *, header *')].filter(e => e.getClientRects().length > 0 &&
  !e.closest('.toolbar, .drawing-tools, .tabs, .cm-scroller, svg, .wide, table, math') && e.getBoundingClientRect().right > document.documentElement.clientWidth + 1)
  .map(e => e.outerHTML.slice(0, 90))"""
AXE = ROOT / "src" / "applications" / "explorer" / "node_modules" / "axe-core" / "axe.min.js"
CONTRAST = 4.5  # WCAG 2, AA


def luminance(colour):
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in (int(part) / 255 for part in colour.split(","))]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one, other):
    high, low = sorted((luminance(one), luminance(other)), reverse=True)
    return (high + 0.05) / (low + 0.05)


class Looks(PageCase):
    def scheme(self, name):
        self.browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": name}])

    def tearDown(self):
        self.browser.call("Emulation.setEmulatedMedia", features=[])
        super().tearDown()

    def test_drawn_in_light_and_in_dark(self):
        """The block's colour fills a good part of the drawing, on a light ground or a dark one; by the system or by the
        switch."""
        for scheme, block, ground in (("light", (242, 206, 147), (255, 255, 255)), ("dark", (95, 69, 16), (20, 22, 26))):
            with self.subTest(scheme):
                self.scheme(scheme)
                self.load()
                _, _, found = picture.dots(self.picture())
                near = sum(count for colour, count in found.items() if max(abs(a - b) for a, b in zip(colour, block)) < 12)
                self.assertGreater(near, 30_000)
                self.assertGreater(found[ground], 200_000)
        self.value("(() => { const s = document.getElementById('theme'); s.value = 'light'; s.dispatchEvent(new Event('change')); })()")
        self.frame()
        self.assertGreater(picture.dots(self.picture())[2][(255, 255, 255)], 200_000)

    def test_contrast(self):
        for scheme in ("light", "dark"):
            self.scheme(scheme)
            self.load()
            pairs = self.value(PAIRS)
            self.assertGreaterEqual(len(pairs), 4)
            for pair, where in pairs:
                with self.subTest(scheme, where=where):
                    self.assertGreaterEqual(contrast(*pair.split("|")), CONTRAST, pair)

    def test_colours_of_two_kinds_differ_for_every_eye(self):
        """No two neighbours are told apart by hue alone: the block's edge has a contrast of 3 to the block, and the
        contact's line one of 3 to the block and to the rock (WCAG 2, 1.4.11)."""
        def of(shape, key):
            colour = self.value(f"getComputedStyle(document.querySelector('.shape.{shape}')).{key}")
            return ",".join(re.findall(r"\d+", colour)[:3])
        for scheme in ("light", "dark"):
            self.scheme(scheme)
            self.load()
            with self.subTest(scheme):
                self.assertGreaterEqual(contrast(of("block", "stroke"), of("block", "fill")), 3)
                self.assertGreaterEqual(contrast(of("contact", "stroke"), of("block", "fill")), 3)
                self.assertGreaterEqual(contrast(of("contact", "stroke"), of("rock", "fill")), 3)

    @unittest.skipUnless(AXE.is_file(), f"there is no {AXE}: ./run --explorer installs it")
    def test_axe_finds_nothing(self):
        """The rules of axe, on every tab, wide and narrow, of a solid and of many blocks, in the tour and with a complaint."""
        rules = AXE.read_text(encoding="utf-8")
        for width, height in ((1440, 900), (390, 844)):
            self.load(width=width, height=height)
            self.browser.call("Runtime.evaluate", expression=rules)
            for tab in self.value("[...document.querySelectorAll('[role=tab]')].map(t => t.id)"):
                self.click("#" + tab)
                self.frame()
                self.assertEqual(self.axe(), [], (width, tab))
            for name in ("send", "gallery"):
                self.click("#" + name)
                self.frame()
                self.assertEqual(self.axe(), [], (width, name))
                self.value(f"document.getElementById('{name}-dialog').close()")
            for name in ("balanced_rock", "toppling_slope"):
                self.example(name)
                self.assertEqual(self.axe(), [], (width, name))
            self.example("block_e_valley")
            self.choose(ROOT / "examples" / "pictures" / "painted_boulder.png")
            self.awaits("document.body.classList.contains('tracing')")
            self.assertEqual(self.axe(), [], (width, "a photograph"))
            self.value("[...document.querySelectorAll('#photo button')].pop().click()")
            self.click("#tour-begin button")
            self.answered()
            self.assertEqual(self.axe(), [], (width, "tour"))
            self.type_scene("topple: 1\noops: 1\n")
            self.refused()
            self.assertEqual(self.axe(), [], (width, "a complaint"))

    @unittest.skipUnless(AXE.is_file(), f"there is no {AXE}: ./run --explorer installs it")
    def test_axe_finds_nothing_elsewhere(self):
        """Nor in the film of a fall and of a shaking, in any step of the tour, beside a kept scene, with menus open, in the dark, and
        within another page."""
        rules = AXE.read_text(encoding="utf-8")

        def looked_at(scheme, fragment=""):
            self.scheme(scheme)
            self.load(fragment)
            self.browser.call("Runtime.evaluate", expression=rules)
        looked_at("dark")
        for name in ("slab_left", "shaken_boulder"):
            self.example(name)
            self.awaits("!document.getElementById('play').disabled")
            self.click("#play")
            self.awaits("!document.getElementById('film').hidden", 60)
            self.click(".film button")
            self.assertEqual(self.axe(), [], name)
            self.click("#play")
        self.value("document.querySelectorAll('.settings, .legend').forEach(d => d.open = true)")
        self.assertEqual(self.axe(), [], "menus")
        looked_at("light")
        self.click("#tab-compare")
        self.click("#panel-compare button")
        self.example("block_f")
        self.assertEqual(self.axe(), [], "two scenes")
        self.click("#tour-begin button")
        for step in range(1, 8):
            self.click(f".tour ol li:nth-child({step}) button")
            self.answered()
            self.assertEqual(self.axe(), [], step)
        looked_at("dark", "#embed=results,pivots&example=slab_left.yaml")
        self.assertEqual(self.axe(), [], "embedded")

    def axe(self):
        """What it has to complain of."""
        told = "axe.run(document).then(r => r.violations.map(v => v.id + ': ' + v.nodes.map(n => n.html.slice(0, 120)).join(' | ')))"
        return self.browser.call("Runtime.evaluate", awaitPromise=True, returnByValue=True, expression=told)["result"]["value"]

    def test_narrow_window(self):
        """On a telephone nothing leaves the page, and the drawing is as wide as it."""
        self.load(width=400)
        self.assertLessEqual(self.value("document.documentElement.scrollWidth"), 400)
        self.assertEqual(self.value(TOO_WIDE), [])
        self.assertGreater(self.value("document.getElementById('drawing').getBoundingClientRect().width"), 360)


if __name__ == "__main__":
    main()
