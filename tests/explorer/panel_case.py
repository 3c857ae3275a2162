# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The explorer's panels in Chromium: their tabs, buttons, tables and files, as a reader uses them."""

import json
import pathlib
import time

from page_case import KNOWN, PageCase

KEYS = {"Escape": 27, "End": 35, "Home": 36, "ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39, "ArrowDown": 40}


class PanelCase(PageCase):
    def load(self, fragment="", width=1400, height=1600, kept=KNOWN):
        super().load(fragment, width, height, kept)

    def shown(self, name):
        """An example, and the panel of the verdict is of it."""
        self.example(name)
        self.awaits(f"document.querySelector('#panel-verdict [data-scene]')?.dataset.scene === '{name}.yaml'")

    def tab(self, name):
        self.click(f"#tab-{name}")
        self.frame()

    def button(self, text, within="body"):
        """The button that says so is pressed."""
        found = self.value(
            f"{{ const one = [...document.querySelectorAll({json.dumps(within + ' button')})]"
            f".find(each => each.textContent === {json.dumps(text)}); one?.click(); one !== undefined }}")
        self.assertTrue(found, f"no button says {text!r}")

    def said(self, selector):
        return self.value(f"document.querySelector({json.dumps(selector)})?.textContent ?? null")

    def texts(self, selector):
        return self.value(f"[...document.querySelectorAll({json.dumps(selector)})].map(each => each.textContent)")

    def rows(self, selector):
        """The cells of each row of a table."""
        return self.value(f"[...document.querySelectorAll({json.dumps(selector + ' tbody tr')})]"
                          ".map(row => [...row.cells].map(cell => cell.textContent))")

    def middle(self, selector):
        """Of an element, in dots of the window, into which it is brought."""
        return self.value(f"{{ const one = document.querySelector({json.dumps(selector)}); one.scrollIntoView({{block: 'center'}});"
                          " const b = one.getBoundingClientRect(); [b.x + b.width / 2, b.y + b.height / 2] }")

    def pull(self, start, end, steps=8):
        """By the mouse, from one dot to another."""
        self.browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=start[0], y=start[1])
        self.mouse("mousePressed", *start)
        for step in range(1, steps + 1):
            self.mouse("mouseMoved", *(a + (b - a) * step / steps for a, b in zip(start, end)))
        self.mouse("mouseReleased", *end)

    def key(self, name):
        for kind in ("keyDown", "keyUp"):
            self.browser.call("Input.dispatchKeyEvent", type=kind, key=name, code=name, windowsVirtualKeyCode=KEYS[name])

    def saved(self, folder, press, name, seconds=60):
        """The bytes of a file that the page offers once it was pressed."""
        self.browser.call("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(folder))
        path = pathlib.Path(folder, name)
        press()
        end = time.monotonic() + seconds
        # one browser makes the file first, and puts its bytes there at the end
        while not path.exists() or path.stat().st_size == 0 or any(path.parent.glob("*.part")):
            self.assertLess(time.monotonic(), end, f"{name} was not saved")
            time.sleep(0.05)
        return path.read_bytes()
