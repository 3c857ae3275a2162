# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The explorer in Chromium, used as a reader uses it: by the menu of examples, buttons, keys and the mouse."""

import json
import os
import pathlib
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "program"))

import browser  # noqa: E402

# The page as it was built; TOPPLE_EXPLORER names another one, a file or an address
PLACE = os.environ.get("TOPPLE_EXPLORER", str(ROOT / "build-explorer" / "explorer.html"))


class Address:
    def __init__(self, text):
        self.text = text

    def as_uri(self):
        return self.text if "://" in self.text else pathlib.Path(self.text).resolve().as_uri()


def missing():
    """Why the page cannot be tried, or None."""
    if browser.PROGRAM is None:
        return "there is no Chromium: install Debian's package chromium"
    if "://" not in PLACE and not pathlib.Path(PLACE).exists():
        return f"there is no {PLACE}: build the explorer first"
    return None


class Page:
    def __init__(self, width=1400, height=1600):
        self.browser = browser.Browser()
        self.width, self.height = width, height
        self.open()

    def open(self, width=None):
        self.browser.open(Address(PLACE), width or self.width)
        self.browser.call("Emulation.setDeviceMetricsOverride", width=width or self.width, height=self.height,
                          deviceScaleFactor=1, mobile=False)
        self.wait("document.querySelector('#panel-verdict .verdict') !== null", "the first answer")

    def close(self):
        self.browser.close()

    def value(self, expression):
        return self.browser.value(expression)

    def wait(self, expression, what, seconds=60):
        """Until it is true: the page answers in its own time."""
        end = time.monotonic() + seconds
        while not self.value(expression):
            if time.monotonic() > end:
                raise AssertionError(f"in vain for {seconds} s: {what}")
            time.sleep(0.03)

    def example(self, name):
        """By the menu of examples; returns when the verdict is of it."""
        self.value("document.getElementById('panel-verdict').lastElementChild.dataset.scene = ''; 0")
        self.value(f"{{ const menu = document.getElementById('examples'); menu.value = {json.dumps(name)};"
                   " menu.dispatchEvent(new Event('change')); } 0")
        self.wait(f"document.getElementById('panel-verdict').lastElementChild.dataset.scene === {json.dumps(name)}", name)

    def tab(self, name):
        self.click(f"#tab-{name}")

    def click(self, selector):
        if not self.value(f"(document.querySelector({json.dumps(selector)})?.click(), "
                          f"document.querySelector({json.dumps(selector)}) !== null)"):
            raise AssertionError(f"nothing to click at {selector}")

    def button(self, text, within="body"):
        """The button that says so."""
        found = self.value(
            f"{{ const one = [...document.querySelectorAll({json.dumps(within + ' button')})]"
            f".find(each => each.textContent === {json.dumps(text)}); one?.click(); one !== undefined }}")
        if not found:
            raise AssertionError(f"no button says {text!r}")

    def text(self, selector):
        return self.value(f"document.querySelector({json.dumps(selector)})?.textContent ?? null")

    def texts(self, selector):
        return self.value(f"[...document.querySelectorAll({json.dumps(selector)})].map(each => each.textContent)")

    def rows(self, selector):
        """The cells of each row of a table."""
        return self.value(f"[...document.querySelectorAll({json.dumps(selector + ' tbody tr')})]"
                          ".map(row => [...row.cells].map(cell => cell.textContent))")

    def box(self, selector):
        """Middle of it, in dots of the window."""
        return self.value(f"{{ const one = document.querySelector({json.dumps(selector)}); one.scrollIntoView({{block: 'center'}});"
                          " const b = one.getBoundingClientRect(); [b.x, b.y, b.width, b.height] }")

    def hover(self, x, y):
        self.browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)

    def mouse(self, kind, x, y):
        self.browser.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left",
                          buttons=0 if kind == "mouseReleased" else 1, clickCount=1)

    def drag(self, start, end, steps=8):
        self.hover(*start)
        self.mouse("mousePressed", *start)
        for step in range(1, steps + 1):
            self.mouse("mouseMoved", *(a + (b - a) * step / steps for a, b in zip(start, end)))
        self.mouse("mouseReleased", *end)

    def key(self, name, code=None):
        for kind in ("keyDown", "keyUp"):
            self.browser.call("Input.dispatchKeyEvent", type=kind, key=name, code=code or name,
                              windowsVirtualKeyCode={"Tab": 9, "Enter": 13, "Escape": 27, "End": 35, "Home": 36, "ArrowLeft": 37,
                                                     "ArrowUp": 38, "ArrowRight": 39, "ArrowDown": 40}.get(name, 0))

    def scheme(self, name):
        self.browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": name}])

    def complaints(self):
        """What the console was told since the page was opened."""
        kinds = ("Log.entryAdded", "Runtime.consoleAPICalled", "Runtime.exceptionThrown")
        return [event["params"] for event in self.browser.events if event["method"] in kinds]

    def saved(self, folder, press, name, seconds=60):
        """The bytes of a file that the page offers once it was pressed."""
        self.browser.call("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(folder))
        path = pathlib.Path(folder, name)
        press()
        end = time.monotonic() + seconds
        while not path.exists():
            if time.monotonic() > end:
                raise AssertionError(f"{name} was not saved")
            self.value("0")
            time.sleep(0.05)
        return path.read_bytes()
