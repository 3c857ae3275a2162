# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Calculation sheets in a real browser: Chromium asks for nothing outside of the file, complains of nothing, draws the
equations, keeps to a narrow window, has enough contrast in light and in dark, and prints on A4 without cutting a table."""

import base64
import pathlib
import re
import tempfile
import unittest

import browser
from harness import main, run

EXAMPLES = ("block_e_valley", "two_density_block", "block_under_water", "boulder_on_rough_ground")
A4_COLUMN = 673  # of 210 mm less two margins of 16 mm, in dots of 1/96 inch

# What has no room, but for what scrolls in a box of its own
TOO_WIDE = """[...document.querySelectorAll('main *')].filter(e => !e.closest('.wide,.equation,pre') &&
  e.getBoundingClientRect().right > document.documentElement.clientWidth + 1).map(e => e.outerHTML.slice(0, 90))"""
CUT = """[...document.querySelectorAll('table,math,img,pre')].filter(e =>
  e.getBoundingClientRect().right > document.documentElement.clientWidth + 1).map(e => e.outerHTML.slice(0, 90))"""
BOXES = """[...document.querySelectorAll('math')].map(e => { const b = e.getBoundingClientRect();
  const f = [...e.querySelectorAll('mfrac')].map(x => { const n = x.children[0].getBoundingClientRect(),
    d = x.children[1].getBoundingClientRect(); return n.bottom <= d.top + 3 && n.width > 3 && d.width > 3; });
  return [b.width, b.height, f.every(x => x)]; })"""
COLOURS = """[...document.querySelectorAll('p,th,td,h1,h2,h3,figcaption,caption,pre,math')].map(e => {
  let own = e, back = 'rgba(0, 0, 0, 0)';
  while (own && /, 0\\)$/.test(back)) { back = getComputedStyle(own).backgroundColor; own = own.parentElement; }
  return getComputedStyle(e).color + '|' + back; })"""


def luminance(colour):
    """Relative luminance of WCAG 2."""
    parts = [int(part) / 255 for part in re.findall(r"\d+", colour)[:3]]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one, other):
    high, low = sorted((luminance(one), luminance(other)), reverse=True)
    return (high + 0.05) / (low + 0.05)


@unittest.skipIf(browser.PROGRAM is None, "there is no Chromium: install Debian's package chromium")
class Browsed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.path = pathlib.Path(folder.name)
        cls.browser = browser.Browser()
        cls.addClassCleanup(cls.browser.close)
        cls.pages = []
        for name in EXAMPLES:
            cls.pages.append(cls.path / f"{name}.html")
            status, _, err = run("solve", f"examples/{name}.yaml", "--report", cls.pages[-1])
            if status != 0:
                raise AssertionError(err)
        for command, name in (("study", "studies/slab_study"), ("tilt", "tilt_block_f")):
            cls.pages.append(cls.path / f"{command}.html")
            status, _, err = run(command, f"examples/{name}.yaml", "--report", cls.pages[-1])
            if status != 0:
                raise AssertionError(err)

    def each(self, width):
        for path in self.pages:
            self.browser.open(path, width)
            yield path

    def test_asks_for_nothing_and_complains_of_nothing(self):
        for path in self.each(1280):
            asked = [e["params"]["request"]["url"] for e in self.browser.events
                     if e["method"] == "Network.requestWillBeSent"]
            self.assertEqual([url for url in asked if not url.startswith("data:")], [path.as_uri()])
            told = [e["params"] for e in self.browser.events
                    if e["method"] in ("Log.entryAdded", "Runtime.consoleAPICalled", "Runtime.exceptionThrown")]
            self.assertEqual(told, [])
            self.assertTrue(self.browser.value("[...document.images].every(i => i.complete && i.naturalWidth > 100)"))

    def test_a_complaint_would_be_heard(self):
        """The test above would see a request, and what the policy of the page forbids: of a page into which both were
        put, it does."""
        text = self.pages[0].read_text(encoding="utf-8").replace(
            "</main>", '<img src="http://127.0.0.1:9/x.png" alt=""><script>1</script></main>')
        spoilt = self.path / "spoilt.html"
        spoilt.write_text(text, encoding="utf-8")
        self.browser.open(spoilt, 1280)
        told = " ".join(e["params"]["entry"]["text"] for e in self.browser.events if e["method"] == "Log.entryAdded")
        self.assertIn("Content Security Policy", told)

    def test_equations_are_drawn(self):
        """Each has a box of its own, and in each fraction one row stands above the other."""
        count = 0
        for _ in self.each(1280):
            for width, height, stacked in self.browser.value(BOXES):
                self.assertGreater(width, 40)
                self.assertGreater(height, 12)
                self.assertTrue(stacked)
                count += 1
        self.assertGreater(count, 20)

    def test_narrow_window(self):
        """On a telephone nothing leaves the page but what scrolls in its own box."""
        for _ in self.each(400):
            self.assertEqual(self.browser.value(TOO_WIDE), [])
            self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), 400)

    def test_contrast(self):
        """7 to 1 at least (WCAG 2, AAA), light and dark; and the two differ."""
        seen = set()
        for scheme in ("light", "dark"):
            self.browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
            for _ in self.each(1280):
                for pair in set(self.browser.value(COLOURS)):
                    self.assertGreaterEqual(contrast(*pair.split("|")), 7, (scheme, pair))
                    seen.add(pair)
        self.browser.call("Emulation.setEmulatedMedia", features=[])
        self.assertGreater(len(seen), 3)

    def test_prints_on_a4(self):
        """In the width of an A4 page no table, equation or figure is cut, and the PDF has pages of that size."""
        self.browser.call("Emulation.setEmulatedMedia", media="print")
        for _ in self.each(A4_COLUMN):
            self.assertEqual(self.browser.value(CUT), [])
        self.browser.call("Emulation.setEmulatedMedia", media="")
        for _ in self.each(1280):
            printed = base64.b64decode(self.browser.call("Page.printToPDF", preferCSSPageSize=True)["data"])
            sizes = re.findall(rb"/MediaBox \[0 0 ([\d.]+) ([\d.]+)\]", printed)
            self.assertGreater(len(sizes), 1)
            for width, height in sizes:
                self.assertAlmostEqual(float(width), 595.28, delta=1)
                self.assertAlmostEqual(float(height), 841.89, delta=1)


if __name__ == "__main__":
    main()
