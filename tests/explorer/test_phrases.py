# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The words of the explorer's page, read from its sources without a browser: every text that they put on the page has its Spanish
and German, and what has none is on a list that says why."""

import html
import json
import re
import sys
import unittest

from page_case import ROOT, main

EXPLORER = ROOT / "src" / "applications" / "explorer"
sys.path.insert(0, str(EXPLORER))

from bundling import examples, phrases  # noqa: E402

PAGE = EXPLORER / "page" / "index.html"
SAID = re.compile(r'\b(?:say|parts|word)\(\s*"((?:[^"\\]|\\.)*)"')
NAMED = re.compile(r'(?:\b(?:label|title|what|caption)|"aria-label"): "((?:[^"\\]|\\.)*[a-z] [^"]*|[A-Z][a-z]+…?)"')
CHILD = re.compile(r'\b(?:svgE|e)lement\(\s*"\w+", \{[^{}]*\}, "((?:[^"\\]|\\.)*[A-Za-z]{3}(?:[^"\\]|\\.)*)"')
LIST_SAID = re.compile(r"\[([^\[\]]*)\]\.map\(\((\w+)\) => say\(\2\)\)")
# Comments, which are passed over, and texts of a module, each as it stands in it
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|"((?:[^"\\\n]|\\.)*)"|`((?:[^`\\]|\\.)*)`|\'((?:[^\'\\\n]|\\.)*)\'', re.S)
WORDS = re.compile(r"[A-Za-z]{2,} [A-Za-z]{2,}|^[A-Z][a-z]{2,}")  # what looks like a text to be read
# What stands before a text that nobody reads: it is compared with another one, imported, a class or a kind of shape
UNREAD = re.compile(r'(?:[!=]== |case |\.includes\(|(?:^|\n)import [^\n]*|\bclass: |\bkind: |classList\.\w+\()\Z')
SIGNS = {"", "1", "Topple"}  # said as they are
# Texts with words that are not the page's: why, and which, by the module where that is all of them
SCENES = "scenes are English, whoever writes them"
MODULES = {"examples/templates.js": SCENES, "photograph/trace_scene.js": SCENES, "solid/mesh_picture.js": "a program of the graphics card"}
EXCEPTIONS = {
    "the languages by their own names": {"English", "Español", "Deutsch"},
    "said by no one but the browser: the names of keys, types, errors, fonts, measurements": {
        "Enter", "Delete", "Backspace", "Insert", "Mod-z", "Mod-y", "Mod-Shift-z", "Content-Type", "AbortError", "CoreStopped",
        "13px system-ui", "12px system-ui", "px system-ui", "first answer"},
    "classes of elements": {
        "shape touch ", "shape water", "shape preview", "part other", "block at-rest ", "pivot governing", "pivot admissible"},
    "units, which have no language": {"lbf ft", "kip ft"},
    "keys of the program's answers": {"holds nowhere", "scene lengths", "typed in"},
    "terms that `topple explain` is asked for, which answers in English": {"limit equilibrium", "Patton's law", "admissible pivot", ", a key of scenes"},
    "what an expression is refused by, of which only that it is refused is told": {
        "nested too deeply", "ends too early", "no number, name or bracket", "a bracket is open", "a parenthesis is open", "no number"},
    "faults of the page or its core, told in brackets for those who report them": {
        "${name} lies outside of where scenes are", "the rest of the core is not there yet", "ended with status ${status}",
        "the program did not end by exit", "a later request replaced this one", "cells are halved three times", "no formula has ", "a panel draws "},
    "markup of the line for another page": {'<iframe src="'},
    SCENES: {
        "      # the file says no unit: is it metres?", "topple: 1\\nlength_unit: m      # the file says no unit: is it metres?",
        "topple: 1\\nlength_unit: m      # the file says no unit: is it metres?\\n",
        "block:      # begun as a square stone over the profile: draw your own\\n  outline: [[",
        "\\nfriction_angle_deg: 30      # assumed; replace it by a measured value\\ntilt: {towards: both, angle_deg: 10}      # assumed, too\\n"},
}


def sources():
    return {path: path.read_text(encoding="utf-8") for path in sorted(EXPLORER.glob("*/*.js"))}


def plain(literal):
    return literal.replace('\\"', '"')


def literals():
    """What modules say by a phrase that stands in them, with the module's name."""
    for path, text in sources().items():
        for pattern in (SAID, NAMED, CHILD):
            yield from ((path.name, plain(found)) for found in pattern.findall(text))
        for listed, _ in LIST_SAID.findall(text):
            yield from ((path.name, plain(found)) for found in re.findall(r'"((?:[^"\\]|\\.)*)"', listed))
    page = PAGE.read_text(encoding="utf-8")
    yield PAGE.name, re.search(r"<title>(.*)</title>", page)[1]
    body = page[page.index("<body"):]
    for found in re.findall(r">([^<>]*[A-Za-z][^<>]*)<", body) + re.findall(r'(?:title|aria-label)="([^"]*)"', body):
        yield PAGE.name, html.unescape(found.strip())
    licences = json.loads((EXPLORER / "licences" / "licences.json").read_text(encoding="utf-8"))
    yield from (("licences.json", each["for"]) for each in licences["libraries"])


def texts():
    """(place, text) of all that looks like a text to be read, wherever it stands in a module."""
    for path, source in sources().items():
        for found in TOKEN.finditer(source):
            text = next((group for group in found.groups() if group is not None), None)
            if text is not None and WORDS.search(plain(text)) and not UNREAD.search(source[max(0, found.start() - 100):found.start()]):
                yield f"{path.parent.name}/{path.name}", source.count("\n", 0, found.start()) + 1, plain(text)


def known():
    """All phrases, and the beginnings and ends of those that are put together with a word that varies."""
    rows = {row["en"] for path in (phrases.PROGRAMS, phrases.OWN, phrases.REFUSALS) for row in phrases.table(path)}
    return rows | {re.sub(r"(left|right)$", "", row) for row in rows} | {re.sub(r"^(width|height|flat)(?= of the ellipse)", "", row) for row in rows}


class Tables(unittest.TestCase):
    def test_every_phrase_has_its_translations(self):
        """In the table of the program or in that of the page, and in one of them alone; no row is left that nobody says."""
        programs, own = ({row["en"] for row in phrases.table(path)} for path in (phrases.PROGRAMS, phrases.OWN))
        self.assertEqual(own & programs, set())
        missing = sorted({(name, said) for name, said in literals() if said not in own | programs | SIGNS
                          and not said.endswith(" the ") and not re.fullmatch(r"(α_[sw]|scene\.yaml)", said)})
        self.assertEqual(missing, [])
        everything = "\n".join([*sources().values(), *(html.unescape(path.read_text(encoding="utf-8")) for path in (
            EXPLORER / "bundling" / "examples.py", EXPLORER / "licences" / "licences.json", PAGE))])
        ends = re.compile(r" (left|right|slab|ellipse)$")  # put together with a word that varies
        words_of_results = {"none: the scene gives no tilt", "note", "caution", "assumption", "refuted", "onset of motion", "critical angle", "critical angle, integer arithmetic"}
        unused = [row for row in own if row not in everything and ends.sub(" ", row) not in everything and row not in words_of_results
                  and ends.sub("", row).removesuffix(" of the") not in everything]
        self.assertEqual(unused, [])

    def test_every_title_has_its_translations(self):
        """Of the examples, in one table, and none of an example that is gone."""
        own, titles = ([row["en"] for row in phrases.table(path)] for path in (phrases.OWN, phrases.TITLES))
        self.assertEqual(set(titles), {each["title"] for each in examples.examples()} - set(own))

    def test_no_text_without_a_phrase(self):
        """A text that stands anywhere in a module, also in an error or as a part of a longer one, is a phrase or an exception; and each
        exception is still there."""
        excepted = set().union(*EXCEPTIONS.values())
        phrased = known()
        unknown = [found for found in texts() if found[2] not in phrased | excepted and found[0] not in MODULES]
        self.assertEqual(unknown, [])
        there = {text for _, _, text in texts()}
        self.assertEqual(sorted(excepted - there), [])
        self.assertEqual([name for name in MODULES if not any(place == name for place, _, text in texts() if text not in phrased)], [])

    def test_texts_are_found(self):
        """Of a source as it might be written: two texts that are read, none of those that are not."""
        source = '// No "comment here"\nimport { a } from "no file here";\nif (x === "no text here") throw new Error("A text here");\n' \
            'element("p", { class: "no class here" }, `${x} another text`);'
        found = [next(group for group in each.groups() if group is not None) for each in TOKEN.finditer(source)
                 if any(group is not None and WORDS.search(group) for group in each.groups()) and not UNREAD.search(source[:each.start()])]
        self.assertEqual(found, ["A text here", "${x} another text"])
        self.assertEqual(CHILD.findall('element("p", {}, "library")'), ["library"])
        self.assertEqual(NAMED.findall('{ class: "tour", "aria-label": "Guided tour" }'), ["Guided tour"])

    def test_translations_take_what_the_phrase_takes(self):
        for row in phrases.table(phrases.OWN) + phrases.table(phrases.TITLES) + phrases.table(phrases.REFUSALS):
            for code in ("es", "de"):
                with self.subTest(row["en"], code=code):
                    self.assertTrue(row[code])
                    self.assertEqual(len(re.findall(r"%(?:\d\$)?s", row[code])), row["en"].count("%s"))

    def test_each_row_once(self):
        """A second row of one phrase would silently replace the first."""
        for path in (phrases.OWN, phrases.TITLES, phrases.REFUSALS):
            rows = [row["en"] for row in phrases.table(path)]
            self.assertEqual([row for row in set(rows) if rows.count(row) > 1], [])


if __name__ == "__main__":
    main()
