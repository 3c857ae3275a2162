# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Somebody who never saw the command line takes the tour, by buttons alone, and finds why block E moves at 28.7° and how
a base that goes on would hold it. What the tour says on the way is what the native program says; and the panels can be
read: narrow, light, dark, printed, without a complaint of the browser."""

import re

from panel_case import PanelCase
from harness import main, solve, table
from test_report_browser import contrast

# What has no room, but for what scrolls in a box of its own
TOO_WIDE = """[...document.querySelectorAll('#panels *')].filter(e => !e.closest('.wide, .tabs, .unseen, svg, .uplot') &&
  e.getBoundingClientRect().right > document.documentElement.clientWidth + 1).map(e => e.outerHTML.slice(0, 90))"""
COLOURS = """[...document.querySelectorAll('#panels p, #panels td, #panels th, #panels dd, #panels dt, #panels h2, #panels h3,' +
  ' #panels button:not(:disabled), #panels label, #panels a, #panels math')].filter(e => e.getClientRects().length > 0).map(e => {
  let own = e, back = 'rgba(0, 0, 0, 0)';
  while (own && /, 0\\)$/.test(back)) { back = getComputedStyle(own).backgroundColor; own = own.parentElement; }
  return getComputedStyle(e).color + '|' + (/, 0\\)$/.test(back) ? 'rgb(255, 255, 255)' : back); })"""
TABS = ("pivots", "forces", "curves", "map", "derive", "verify", "report")


def degrees(text):
    return [float(each) for each in re.findall(r"(-?\d+(?:\.\d+)?)°", text)]


class Tour(PanelCase):
    def begin(self, step):
        self.load()
        self.button("Guided tour: seven steps")
        self.click(f".tour ol li:nth-child({step}) button")

    def found(self, pattern):
        """What the tour has found, once it says so."""
        self.awaits(f"/{pattern}/.test(document.querySelector('.tour .found').textContent)")
        return self.said(".tour .found")

    def test_block_e(self):
        """From the button of the tour, by Next alone, to the puzzle and its answer."""
        self.load()
        self.button("Guided tour: seven steps")
        self.assertEqual(self.value("document.activeElement.textContent"), "1. A slab")
        for title in ("2. Teeth", "3. Table 3", "4. Block E's puzzle"):
            self.button("Next", ".tour")
            self.assertEqual(self.said(".tour h2"), title)
        case = solve("examples/block_e_valley.yaml")["cases"][0]
        said = degrees(self.found("begins to move at"))
        for shown, key in zip(said, (case["toppling"], case["toe"], case["limit"])):
            value = key.get("critical_angle_deg", key.get("limit_angle_deg"))["value"]
            self.assertAlmostEqual(shown, value, delta=0.0005)
        self.assertAlmostEqual(said[2], 28.735, delta=0.0005)
        self.awaits("document.querySelectorAll('#panel-forces .cone').length === 2")
        self.button("by 28.8°", ".tour")
        self.awaits("/^Slides and topples/.test(document.querySelector('#panel-verdict .verdict').textContent)")
        self.button("Tilt it by 28.7°", ".tour")
        self.awaits("/^Stands/.test(document.querySelector('#panel-verdict .verdict').textContent)")
        self.button("Next", ".tour")
        self.found("ends at the toe block E is held up to 28.735°")
        self.button("Let the base go on by 30 mm", ".tour")
        self.found("extends past the toe block E is held up to 35.201°, then it topples")
        longer = solve("examples/block_e_valley.yaml", "--set", "base.beyond.left=30")["cases"][0]
        self.assertAlmostEqual(longer["limit"]["critical_angle_deg"]["value"], 35.201, delta=0.0005)
        self.assertIn("left: 30", self.text())

    def test_table_3(self):
        """Each row is the printed one, solved: by moments it agrees, and the rows marked let go earlier."""
        self.begin(3)
        self.awaits("document.querySelectorAll('.tour tbody tr').length === 14")
        marked = self.value("[...document.querySelectorAll('.tour tbody tr')].map(r => r.classList.contains('governs'))")
        for row, printed, mark in zip(self.rows(".tour"), table("table3.csv"), marked):
            self.assertEqual(row[0], printed["model"])
            self.assertEqual(row[1], f"{printed['axis'].lower()}, {printed['towards']}")
            self.assertEqual(float(row[2].rstrip("°")), float(printed["alpha_ana"]))
            case = next(each for each in solve(f"examples/{printed['scene']}")["cases"] if each["towards"] == printed["towards"])
            moments, limit = (case[key]["critical_angle_deg"]["value"] for key in ("toppling", "limit"))
            self.assertAlmostEqual(degrees(row[3])[0], moments, delta=0.0005)
            self.assertAlmostEqual(degrees(row[4])[0], limit, delta=0.0005)
            self.assertAlmostEqual(moments, float(printed["alpha_ana"]), delta=0.05001)
            self.assertEqual(mark, limit < moments - 0.01)

    def test_every_step_finds_something(self):
        """All steps, and all that each offers to try, without a complaint of the browser."""
        self.load()
        self.button("Guided tour: seven steps")
        for step in range(1, 8):
            self.click(f".tour ol li:nth-child({step}) button")
            self.assertEqual(self.value("document.querySelector('.tour [aria-current=step]').textContent"), str(step))
            if step != 3:
                self.found("°")
            for label in self.texts(".tour .choices button"):
                self.button(label, ".tour")
                self.found("°")
        self.button("End the tour")
        self.assertEqual(self.value("document.activeElement.textContent"), "Guided tour: seven steps")

    def test_history(self):
        """Between certain to stand and certain to move the verdict says that it may, and the map is of friction."""
        self.begin(6)
        self.found("loading history has no influence")
        self.button("of 60°, tilted by 28°", ".tour")
        case = solve("examples/block_a_peak.yaml", "--set", "friction_angle_deg=60")["cases"][0]
        said = degrees(self.found("it may move"))
        self.assertAlmostEqual(said[0], case["onset"]["critical_angle_deg"]["value"], delta=0.0005)
        self.assertAlmostEqual(said[1], case["limit"]["critical_angle_deg"]["value"], delta=0.0005)
        self.assertEqual(self.value("document.querySelector('#panel-map select').value"), "friction_angle_deg")

    def test_narrow_window(self):
        """On a telephone nothing of the panels leaves the page but what scrolls in its own box."""
        self.load(width=400)
        for name in TABS:
            self.tab(name)
            self.assertEqual(self.value(TOO_WIDE), [], name)

    def test_contrast(self):
        """4.5 to 1 at least (WCAG 2, AA), light and dark; and the two differ."""
        seen = {}
        for scheme in ("light", "dark"):
            self.browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
            self.begin(2)
            self.found("°")
            pairs = set()
            for name in TABS:
                self.tab(name)
                pairs |= set(self.value(COLOURS))
            for pair in pairs:
                self.assertGreaterEqual(contrast(*pair.split("|")), 4.5, (scheme, pair))
            seen[scheme] = pairs
        self.browser.call("Emulation.setEmulatedMedia", features=[])
        self.assertNotEqual(seen["light"], seen["dark"])

    def test_print(self):
        """Printed, the panels show results and none of what is pressed."""
        self.load()
        self.browser.call("Emulation.setEmulatedMedia", media="print")
        hidden = self.value("['.tour', '.tabs'].every(s => getComputedStyle(document.querySelector(s)).display === 'none')")
        shown = self.value("document.querySelector('#panel-verdict .verdict').getClientRects().length > 0")
        self.browser.call("Emulation.setEmulatedMedia", media="")
        self.assertTrue(hidden and shown)


if __name__ == "__main__":
    main()
