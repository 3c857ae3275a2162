# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Firefox, spoken to as Chromium is (tests/program/browser.py): the calls of its protocol that tests of the page make, each
done by what Firefox has for it. So one test is the test of both."""

import re
import unittest

import firefox

# Names of keys as WebDriver has them (W3C WebDriver, 17.4.2); others are letters themselves
KEYS = {"Tab": "\ue004", "Enter": "\ue007", "Escape": "\ue00c", "Delete": "\ue017", "Insert": "\ue016", "End": "\ue010", "Home": "\ue011",
        "ArrowLeft": "\ue012", "ArrowUp": "\ue013", "ArrowRight": "\ue014", "ArrowDown": "\ue015", " ": " "}
SHIFT, CONTROL = "\ue008", "\ue009"
HELD = {2: CONTROL, 8: SHIFT}
PLACED = """const b = gBrowser.selectedBrowser;
  b.style.cssText = `flex: none; min-width: 0; align-self: start; justify-self: start; width: ${arguments[0]}px; height: ${arguments[1]}px`;
  resizeTo(arguments[0] + 60, arguments[1] + 200);"""
TOLD = """return Services.console.getMessageArray().flatMap((each) => {
    try { each.QueryInterface(Ci.nsIScriptError); } catch { return []; }
    return /javascript|CSP/.test(each.category) && each.sourceName.startsWith(arguments[0]) && each.timeStamp >= arguments[1] ? [each.errorMessage] : [];
  });"""
PREFERENCE = "typeof arguments[1] === 'string' ? Services.prefs.setStringPref(...arguments) : typeof arguments[1] === 'boolean' ? Services.prefs.setBoolPref(...arguments) : Services.prefs.setIntPref(...arguments)"
WORKED = """return ChromeUtils.requestProcInfo().then((all) => {
    const process = all.children.find((each) => each.pid === gBrowser.selectedBrowser.browsingContext.currentWindowGlobal.osPid);
    return process.threads.find((each) => each.tid === process.pid).cpuTime / 1e9;
  });"""


class FirefoxCalls(firefox.Firefox):
    """As `browser.Browser`. What Firefox has no way to do skips the test that asks for it."""

    def __init__(self):
        super().__init__()
        self.begun, self.address = 0, "about:blank"

    def call(self, method, **words):
        done = getattr(self, re.sub(r"\W", "_", method), None)
        if done is None:
            raise unittest.SkipTest(f"Firefox has no {method}")
        return done(**words) or {}

    @property
    def events(self):
        """What the page has complained of since it was opened."""
        told = self.inside(TOLD, self.address.split("#")[0], self.begun)
        return [{"method": "Log.entryAdded", "params": {"entry": {"text": text}}} for text in told]

    @events.setter
    def events(self, kept):
        del kept  # whatever was complained of until now is meant
        self.begin()

    def begin(self):
        self.begun = self.inside("return Date.now()")

    def open(self, address, width):
        del width  # which is said beside it
        self.begin()
        self.address = address.as_uri()
        self.ask("WebDriver:Navigate", url=self.address)

    def reload(self):
        self.begin()
        self.ask("WebDriver:Refresh")

    def value(self, expression):
        return self.script("return (0, eval)(arguments[0])", expression)

    def preference(self, name, value):
        self.inside(PREFERENCE, name, value)

    # Pages

    def Page_navigate(self, url):
        self.ask("WebDriver:Navigate", url=url)

    def first(self, text):
        self.inside("Services.ppmm.sharedData.set('topple:first', arguments[0]); Services.ppmm.sharedData.flush()", text)

    def Page_addScriptToEvaluateOnNewDocument(self, source):
        self.first(source)
        return {"identifier": "first"}

    def Page_removeScriptToEvaluateOnNewDocument(self, identifier):
        del identifier
        self.first("")

    def Page_captureScreenshot(self, format):
        del format  # PNG, as ever
        return {"data": self.ask("WebDriver:TakeScreenshot", full=False)["value"]}

    def Page_printToPDF(self, printBackground=False):
        return {"data": self.ask("WebDriver:Print", background=printBackground)["value"]}

    def Runtime_evaluate(self, expression, **words):
        del words
        return {"result": {"value": self.value(expression)}}

    def Browser_setDownloadBehavior(self, behavior, downloadPath):
        del behavior
        self.preference("browser.download.folderList", 2)
        self.preference("browser.download.dir", downloadPath)

    Page_setDownloadBehavior = Browser_setDownloadBehavior

    # How it is shown

    def Emulation_setDeviceMetricsOverride(self, width, height, **words):
        del words
        self.inside(PLACED, width, height)

    def Emulation_setEmulatedMedia(self, media="", features=()):
        wanted = {each["name"]: each["value"] for each in features}
        self.inside("gBrowser.selectedBrowser.browsingContext.mediumOverride = arguments[0]", media)
        self.preference("layout.css.prefers-color-scheme.content-override", {"dark": 0, "light": 1}.get(wanted.get("prefers-color-scheme"), 1))
        self.preference("ui.prefersReducedMotion", 1 if wanted.get("prefers-reduced-motion") == "reduce" else 0)

    def Emulation_setFocusEmulationEnabled(self, enabled):
        """A window without a screen is in front as it is."""

    def Emulation_setTouchEmulationEnabled(self, enabled):
        self.preference("dom.w3c_touch_events.enabled", 1 if enabled else 2)
        self.preference("dom.maxtouchpoints.testing.value", 5 if enabled else -1)

    def Emulation_setUserAgentOverride(self, userAgent, acceptLanguage):
        del userAgent
        self.preference("intl.accept_languages", acceptLanguage)

    def Network_emulateNetworkConditions(self, offline, **words):
        del words
        self.inside("Services.io.offline = arguments[0]", offline)

    def Network_enable(self):
        """It is not listened to."""

    Network_disable = Performance_disable = Network_enable

    def Performance_enable(self, timeDomain):
        """Its clock is that of the page's thread as it is."""

    def Performance_getMetrics(self):
        return {"metrics": [{"name": "TaskDuration", "value": self.inside(WORKED)}]}

    # Hands

    def Input_dispatchMouseEvent(self, type, x, y, button="left", buttons=0, clickCount=1, modifiers=0, deltaX=0, deltaY=0):
        del button, buttons, clickCount
        at = {"x": round(x), "y": round(y)}
        if type == "mouseWheel":
            self.act("wheel", [{"type": "scroll", **at, "deltaX": deltaX, "deltaY": deltaY, "duration": 0}], type="wheel")
            return
        move = [{"type": "pointerMove", **at, "duration": 0}]
        steps = {"mouseMoved": move, "mousePressed": [*move, {"type": "pointerDown", "button": 0}], "mouseReleased": [*move, {"type": "pointerUp", "button": 0}]}
        held = [HELD[bit] for bit in HELD if modifiers & bit]
        self.keys([("keyDown", key) for key in held])
        self.act("mouse", steps[type], type="pointer", parameters={"pointerType": "mouse"})
        self.keys([("keyUp", key) for key in held])

    def double_click(self, x, y):
        """Its four steps at once: between two calls Firefox forgets how often was clicked."""
        click = [{"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0}]
        self.act("mouse", [{"type": "pointerMove", "x": round(x), "y": round(y), "duration": 0}, *click, *click], type="pointer",
                 parameters={"pointerType": "mouse"})

    def Input_dispatchTouchEvent(self, type, touchPoints):
        moves = [{"type": "pointerMove", "x": round(point["x"]), "y": round(point["y"]), "duration": 0} for point in touchPoints]
        more = {"touchStart": [{"type": "pointerDown", "button": 0}], "touchMove": [], "touchEnd": [{"type": "pointerUp", "button": 0}]}[type]
        self.act("finger", moves + more, type="pointer", parameters={"pointerType": "touch"})

    def keys(self, actions):
        if actions:
            self.act("keys", [{"type": kind, "value": key} for kind, key in actions], type="key")

    def Input_dispatchKeyEvent(self, type, key, modifiers=0, **words):
        del words
        held = [HELD[bit] for bit in HELD if modifiers & bit] if type == "keyDown" else []
        self.keys([("keyDown", each) for each in held] + [(type, KEYS.get(key, key))] + [("keyUp", each) for each in held])

    def Input_insertText(self, text):
        """A word letter by letter, which the editor may complete; all else at once, as Chromium does it."""
        if text.isalpha():
            self.keys([(kind, letter) for letter in text for kind in ("keyDown", "keyUp")])
            return
        self.inside("Cc['@mozilla.org/widget/clipboardhelper;1'].getService(Ci.nsIClipboardHelper).copyString(arguments[0])", text)
        self.keys([("keyDown", CONTROL), ("keyDown", "v"), ("keyUp", "v"), ("keyUp", CONTROL)])

    # Files

    def DOM_getDocument(self):
        return {"root": {"nodeId": "html"}}

    def DOM_querySelector(self, nodeId, selector):
        del nodeId
        return {"nodeId": selector}

    def DOM_setFileInputFiles(self, files, nodeId):
        found = self.ask("WebDriver:FindElement", using="css selector", value=nodeId)["value"]
        self.ask("WebDriver:ElementSendKeys", id=next(iter(found.values())), text="\n".join(files))
