# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The explorer in English, Spanish and German: no English is left on it, its numbers have the reader's sign before decimals, and
which of them is chosen by the browser's language or from the menu. Its tables of phrases: test_phrases.py."""

import pathlib
import re
import sys
import tempfile
import unittest

from node_case import NODE, node
from page_case import KNOWN, ROOT, main, run
from panel_case import PanelCase

EXPLORER = ROOT / "src" / "applications" / "explorer"
sys.path.insert(0, str(EXPLORER))

from bundling import phrases  # noqa: E402

# Words that no Spanish and no German has; "at" and "is" are parts of none
ENGLISH = re.compile(r"\b(?:the|and|of|at|is|it|towards|to|with|from)\b")
# What the page says by itself and titles of examples: not what else the scene or the program says
OWN_TEXT = """[...document.querySelectorAll('body *')].filter(e => !e.closest('pre, option, #panel-about td, .cm-editor, script, .note, .bubble, td:nth-child(3)'))
  .flatMap(e => [...[...e.childNodes].filter(n => n.nodeType === 3).map(n => n.data), e.getAttribute('aria-label') ?? '']).filter(t => t.trim())"""


@unittest.skipIf(NODE is None, "there is no node: install Debian's package nodejs")
class Refusals(unittest.TestCase):
    def refused(self):
        """Scenes that the program refuses, and what it says of each behind its place."""
        lone = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()), "boulder.yaml")
        lone.write_bytes((ROOT / "examples" / "boulder.yaml").read_bytes())
        said = {}
        for path in [*sorted((ROOT / "tests" / "bad").glob("*.yaml")), lone]:
            _, _, err = run("solve", "--json", path.name, folder=path.parent)
            said[path.name] = re.sub(r"^[^:]+:\d+:\d+: ", "", re.sub(r"^topple: ", "", err.split("\n")[0]))
        solids, rock = ROOT / "examples" / "solids", lone.parent
        (rock / "balanced_rock.obj").write_bytes((solids / "balanced_rock.obj").read_bytes())
        whole = (solids / "rock_in_the_ground.yaml").read_text(encoding="utf-8")
        below = "  below: 0.1 "
        for name, old, new in (("whole_below", below, "  below: 9 "), ("bands_and_below", below, "  bands: [0.1]\n" + below), ("no_band", below, "  bands: []\n  # "),
                               ("to_the_left", "azimuth_deg: 120", "towards: left"), ("no_up", below, "  up: [0, 0, 0]\n" + below), ("no_object", below, "  object: rocks\n" + below)):
            self.assertIn(old, whole)
            (rock / "solid.yaml").write_text(whole.replace(old, new), encoding="utf-8")
            status, _, err = run("solve", "--json", "solid.yaml", folder=rock)
            self.assertEqual(status, 3, err)
            said[name] = re.sub(r"^topple: [^:]+:\d+:\d+: ", "", err.split("\n")[0])
        self.assertGreater(len(said), 100)
        return said

    def test_what_is_quoted_stays(self):
        """A key of the scene, which is to be typed as it stands, is no word: 'slope' was proposed as 'Böschung'."""
        rows = phrases.table(phrases.REFUSALS)
        body = """const known = it.recognisers(given[0]); return given[1].map((message) => it.recognised(message, known));"""
        for code in ("es", "de"):
            own = node(EXPLORER / "words" / "refusals.js", body, [[["slope", "WORD"]] + [[row["en"], row[code]] for row in rows],
                                                                ["unknown key 'oops' in the scene; did you mean 'slope'?", "slope"]])
            self.assertIn("'slope'", own[0])
            self.assertEqual(own[1], "WORD")

    def test_every_bad_scene_is_refused_in_its_language(self):
        """No message stays English, but for what is quoted; and no row is left that the program does not say."""
        said = self.refused()
        rows = phrases.table(phrases.REFUSALS)
        body = "return given[1].map((message) => it.recognised(message, it.recognisers(given[0])));"
        for code in ("es", "de"):
            found = node(EXPLORER / "words" / "refusals.js", body, [[[row["en"], row[code]] for row in rows], list(said.values())])
            for (name, english), own in zip(said.items(), found):
                with self.subTest(name, code=code, said=own):
                    self.assertNotEqual(own, english)
                    self.assertIsNone(ENGLISH.search(re.sub(r"'[^']*'|YAML: .*|x = |^towards ", "", own)))
        sources = [path.read_text(encoding="utf-8") for path in sorted((ROOT / "src").glob("*/**/*.[ch]"))]
        literals = re.sub(r"%[.\d]*[lzh]*[a-z]", "%s", re.sub(r'"\s*\n\s*"', "", "\n".join(sources)))
        everything = "\n".join(said.values())
        unsaid = [row["en"] for row in rows if row["en"] not in literals
                  and not re.search(".+?".join(map(re.escape, row["en"].split("%s"))), everything)]
        self.assertEqual(unsaid, [])


@unittest.skipIf(NODE is None, "there is no node: install Debian's package nodejs")
class Choices(unittest.TestCase):
    def test_language_of_the_browser_and_of_the_menu(self):
        given = [["", ["de-AT", "en"]], ["", ["fr-FR", "es-MX"]], ["", ["fr"]], ["es", ["de"]], ["xx", ["de"]], ["", []]]
        found = node(EXPLORER / "words" / "language.js", "return given.map(([a, b]) => it.chosenLanguage(a, b, ['en', 'es', 'de']));", given)
        self.assertEqual(found, ["de", "es", "en", "es", "de", "en"])

    def test_sign_before_decimals_is_that_of_the_region(self):
        given = [["es", ["es-MX"]], ["es", ["es-ES"]], ["de", ["de-CH"]], ["de", ["en-US"]], ["en", ["en-GB"]], ["en", ["en-ZA"]]]
        found = node(EXPLORER / "words" / "language.js",
                     "return given.map(([a, b]) => it.decimalSign(a, b, {en: '.', es: ',', de: ','}));", given)
        self.assertEqual(found[:3], [".", ",", "."])
        self.assertEqual(found[3:5], [",", "."])

    def test_words_in_another_order(self):
        found = node(EXPLORER / "words" / "language.js", "return given.map(([phrase, ...rest]) => it.filled(phrase, rest).join(''));",
                     [["%s of %s", "a", "b"], ["%2$s de %1$s", "a", "b"], ["100 % of it", "a"], ["%s", "%s"]])
        self.assertEqual(found, ["a of b", "b de a", "100 % of it", "%s"])


class Languages(PanelCase):
    def spoken(self, language):
        kept = KNOWN.replace("localStorage.setItem('topple.touched', '1');",
                             f"localStorage.setItem('topple.touched', '1'); localStorage.setItem('topple.language', '{language}');")
        self.value("document.title")
        PanelCase.__mro__[1].load(self, kept=kept)

    def english(self):
        return [text.strip() for text in self.value(OWN_TEXT) if ENGLISH.search(text)]

    def test_no_english_is_left(self):
        """On every tab, in the tour, and while the test is played."""
        for language in ("es", "de"):
            self.spoken(language)
            self.assertEqual(self.value("document.documentElement.lang"), language)
            for tab in self.value("[...document.querySelectorAll('[role=tab]')].map(t => t.id.slice(4))"):
                self.tab(tab)
                if tab == "map":
                    self.awaits("document.querySelector('#panel-map .told')?.dataset.milliseconds")
                with self.subTest(language, tab=tab):
                    self.assertEqual(self.english(), [])
            self.click("#tour-begin button")
            for step in range(7):
                self.answered()
                with self.subTest(language, step=step):
                    self.assertEqual(self.english(), [])
                self.value("[...document.querySelectorAll('.tour .steps > button')][1].click()")
            self.click("#tour-begin button:not([hidden])")
            self.example("slab_left")
            self.awaits("!document.getElementById('play').disabled")
            self.click("#play")
            self.awaits("!document.getElementById('film').hidden")
            with self.subTest(language, what="the test"):
                self.assertEqual(self.english(), [])

    def test_numbers_have_the_comma_and_fields_take_it(self):
        """Shown with a comma, typed with one, and written into the scene with a point."""
        self.spoken("de")
        self.assertEqual(self.said("#factor-said strong"), "1,938")
        field = "#numbers input[aria-label='Neigung, °']"
        self.value(f"document.querySelector(\"{field}\").focus(), document.querySelector(\"{field}\").select()")
        self.browser.call("Input.insertText", text="21,5")
        self.answered()
        self.assertIn("angle_deg: 21.5}", self.text())
        self.assertEqual(self.value(f"document.querySelector(\"{field}\").value"), "21,5")
        self.assertIn("21,5°", self.said("#verdict-said"))

    def test_menu_keeps_the_scene(self):
        """Chosen by keys: the page begins anew in that language with the scene as it was, also on the next visit."""
        self.example("slab_left")
        self.drag("tilt.angle_deg", -20, -40)
        self.answered()
        before = self.text()
        self.click(".settings summary")
        self.value("document.getElementById('language').focus()")
        self.press("d", text="d")
        self.awaits("document.documentElement?.lang === 'de' && document.body?.dataset.answer === 'there'", 60)
        self.assertEqual(self.text(), before)
        self.reload()
        self.assertEqual(self.said("#tab-results"), "Urteil")

    def test_language_of_the_browser(self):
        agent = self.value("navigator.userAgent")
        self.browser.call("Emulation.setUserAgentOverride", userAgent=agent, acceptLanguage="es-MX,es")
        self.addCleanup(self.browser.call, "Emulation.setUserAgentOverride", userAgent=agent, acceptLanguage="en-US")
        self.load()
        self.assertEqual(self.said("#tab-results"), "Dictamen")
        self.assertEqual(self.said("#factor-said strong"), "1.938")  # as Mexico writes it

    def test_sheet_is_in_the_language_of_the_page(self):
        self.spoken("de")
        self.tab("report")
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        sheet = self.saved(folder, lambda: self.button("Berechnungsblatt, Markdown"), "block_e_valley.md")
        self.assertTrue("Der Block steht." in sheet.decode())
        self.awaits("document.querySelector('#panel-report iframe.sheet-of-scene')?.title === 'Bericht'")
        self.assertFalse(self.value("document.querySelector('#panel-report pre') !== null"))


if __name__ == "__main__":
    main()
