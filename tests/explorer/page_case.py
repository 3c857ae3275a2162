# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The explorer in Chromium without a window, or in Firefox where TOPPLE_BROWSER is 'firefox': opened, dragged, typed into
and looked at. The page is build-explorer/explorer.html, or the file or address in TOPPLE_EXPLORER."""

import base64
import json
import os
import pathlib
import re
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "program"))

import browser  # noqa: E402
import firefox  # noqa: E402
import firefox_calls  # noqa: E402
from harness import main, run  # noqa: E402,F401

PAGE = os.environ.get("TOPPLE_EXPLORER", str(ROOT / "build-explorer" / "explorer.html"))
IN_FIREFOX = os.environ.get("TOPPLE_BROWSER") == "firefox"
PROGRAM, PACKAGE = (firefox.PROGRAM, "firefox-esr") if IN_FIREFOX else (browser.PROGRAM, "chromium")
BUILT = "://" in PAGE or pathlib.Path(PAGE).is_file()
ADDRESS = PAGE if "://" in PAGE else pathlib.Path(PAGE).resolve().as_uri()
KNOWN = "try { localStorage.clear(); sessionStorage.clear(); localStorage.setItem('topple.touched', '1'); } catch (refused) {}"
NEW = "try { localStorage.clear(); sessionStorage.clear(); } catch (refused) {}"
SOFTWARE = re.compile("software WebGL|GL Driver Message|Failed to create WebGL")  # said where there is no graphics card
MODIFIERS = {"control": 2, "shift": 8}
WORDS = "[...document.querySelectorAll('.cm-line')].map(l => l.textContent).join('\\n')"


class Address:
    """What `Browser.open` loads: an address as it stands."""

    def __init__(self, text):
        self.text = text

    def as_uri(self):
        return self.text


@unittest.skipIf(PROGRAM is None, f"there is no browser: install Debian's package {PACKAGE}")
@unittest.skipUnless(BUILT, f"there is no {PAGE}: ./run --explorer builds it")
class PageCase(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = firefox_calls.FirefoxCalls() if IN_FIREFOX else browser.Browser()
        cls.addClassCleanup(cls.browser.close)

    def setUp(self):
        self.load()

    def tearDown(self):
        """No test leaves a complaint in the console, or has asked for anything outside of the page."""
        told = [event["params"] for event in self.browser.events
                if event["method"] in ("Log.entryAdded", "Runtime.consoleAPICalled", "Runtime.exceptionThrown")]
        self.assertEqual([each for each in told if not SOFTWARE.search(each.get("entry", {}).get("text", ""))], [])
        asked = [event["params"]["request"]["url"] for event in self.browser.events
                 if event["method"] == "Network.requestWillBeSent"]
        own = ADDRESS.rsplit("/", 1)[0] if "://127." in ADDRESS else ADDRESS
        self.assertEqual([url for url in asked if not url.startswith(("data:", "blob:", own))], [])

    def load(self, fragment="", width=1280, height=900, kept=KNOWN):
        """@param kept what a script does to the browser's storage before the page is there: by default nothing is kept but
        that somebody was here, for whom nothing moves by itself"""
        self.browser.call("Page.navigate", url="about:blank")  # or a new fragment would load nothing
        script = self.browser.call("Page.addScriptToEvaluateOnNewDocument", source=kept)["identifier"]
        self.browser.open(Address(ADDRESS + fragment), width)
        self.browser.call("Page.removeScriptToEvaluateOnNewDocument", identifier=script)
        self.browser.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        self.answered(60)

    def reload(self):
        """As the reader does it; what the page keeps is there again."""
        self.browser.reload()
        self.answered(60)

    def value(self, expression):
        return self.browser.value(expression)

    def awaits(self, expression, seconds=20):
        """Until an expression of the page is true."""
        end = time.monotonic() + seconds
        while not (found := self.value(expression)):
            if time.monotonic() > end:
                self.fail(f"never true: {expression}; the page says {self.message()!r}")
            time.sleep(0.02)
        return found

    def frame(self):
        """Until what was changed is drawn."""
        self.browser.call("Runtime.evaluate", awaitPromise=True,
                          expression="new Promise(d => requestAnimationFrame(() => requestAnimationFrame(d)))")

    def answered(self, seconds=20):
        self.awaits("document.body?.dataset.answer === 'there'", seconds)
        self.frame()

    def refused(self):
        self.awaits("document.body?.dataset.answer === 'none'")
        self.frame()

    def message(self):
        return self.value("document.getElementById('message').textContent")

    def text(self):
        """The scene as the editor has it, once it has caught up with a drag; the tab that was open is open again."""
        time.sleep(0.25)
        before = self.value("document.querySelector('#panels [aria-selected=true]').id")
        self.click("#tab-text")
        self.frame()
        words = self.value(WORDS)
        self.click("#" + before)
        return words

    def example(self, name):
        self.value(f"(() => {{ const s = document.getElementById('examples'); s.value = '{name}.yaml';"
                   " s.dispatchEvent(new Event('change')); })()")
        self.answered()

    def solved(self, folder=None):
        """The native program's answer for the text on the page, in a folder with the files that it names."""
        folder = pathlib.Path(folder or self.enterContext(tempfile.TemporaryDirectory()))
        (folder / "scene.yaml").write_text(self.text(), encoding="utf-8")
        status, out, err = run("solve", "--json", "--outlines", "scene.yaml", folder=folder)
        self.assertEqual(status, 0, err)
        return json.loads(out)

    def press(self, key, *modifiers, code=None, text=None):
        flags = sum(MODIFIERS[name] for name in modifiers)
        number = {"Tab": 9, "Enter": 13, "ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39, "ArrowDown": 40}
        words = {"key": key, "code": code or key, "modifiers": flags,
                 "windowsVirtualKeyCode": number.get(key, ord(key.upper()[0]))}
        self.browser.call("Input.dispatchKeyEvent", type="keyDown", **words, **({"text": text} if text else {}))
        self.browser.call("Input.dispatchKeyEvent", type="keyUp", **words)

    def click(self, selector):
        self.value(f"document.querySelector({json.dumps(selector)}).click()")

    def type_scene(self, text):
        """Select all that the editor has, and type over it."""
        self.click("#tab-text")
        self.frame()
        self.value("document.querySelector('.cm-content').focus()")
        self.browser.call("Input.dispatchKeyEvent", type="keyDown", key="a", code="KeyA", modifiers=2,
                          windowsVirtualKeyCode=65, commands=["selectAll"])
        self.browser.call("Input.insertText", text=text)

    def knob(self, key):
        """Where a handle is on the screen."""
        return self.value(f"(() => {{ const r = document.querySelector('[data-handle={json.dumps(key)}] .knob')"
                          ".getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2]; })()")

    def mouse(self, kind, x, y, **words):
        self.browser.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", buttons=1, clickCount=1, **words)

    def double_click(self, x, y):
        if IN_FIREFOX:
            self.browser.double_click(x, y)
            return
        for clicks in (1, 2):
            for kind in ("mousePressed", "mouseReleased"):
                self.browser.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", buttons=1, clickCount=clicks)

    def drag(self, key, dx, dy, steps=12, pace=0.0):
        """@return where it was let go."""
        x, y = self.knob(key)
        self.mouse("mousePressed", x, y)
        for i in range(1, steps + 1):
            self.mouse("mouseMoved", x + dx * i / steps, y + dy * i / steps)
            time.sleep(pace)
        self.mouse("mouseReleased", x + dx, y + dy)
        self.frame()
        return x + dx, y + dy

    def choose(self, *paths):
        """Files, as if chosen in the dialogue of the button."""
        document = self.browser.call("DOM.getDocument")["root"]["nodeId"]
        node = self.browser.call("DOM.querySelector", nodeId=document, selector="#file")["nodeId"]
        self.browser.call("DOM.setFileInputFiles", files=[str(path) for path in paths], nodeId=node)

    def picture(self):
        return base64.b64decode(self.browser.call("Page.captureScreenshot", format="png")["data"])
