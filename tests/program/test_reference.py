# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The reference of every public call (docs/reference): Doxygen makes it of the headers without a
warning, and nothing that they declare is missing in it. What the compiler sees of the headers is
compared with what the reference says."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

from harness import ROOT, main

sys.path.insert(0, str(ROOT / "docs/reference"))
import filter as comments  # pylint: disable=wrong-import-position

HEADERS = sorted((ROOT / "include" / "topple").glob("topple*.h"))
PAGES = [ROOT / "docs/library.md", ROOT / "docs/scene_in_memory.md"]


def said_of(item):
    """What the reference says of it."""
    parts = [item.find("briefdescription"), item.find("detaileddescription")]
    return " ".join("".join("".join(part.itertext()) for part in parts).split())


def build(source, output):
    """Doxygen's exit status and what it printed."""
    settings = (ROOT / "docs/reference/Doxyfile.in").read_text(encoding="utf-8")
    for name, value in (("SOURCE", source), ("OUTPUT", output), ("VERSION", "0")):
        settings = settings.replace(f"@{name}@", str(value))
    (output / "Doxyfile").write_text(settings, encoding="utf-8")
    done = subprocess.run(["doxygen", "Doxyfile"], cwd=output, check=False, capture_output=True,
                          encoding="utf-8")
    return done.returncode, done.stdout + done.stderr


@unittest.skipUnless(shutil.which("doxygen"), "doxygen is not installed")
class Reference(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="topple reference ")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.outcome = build(ROOT, cls.folder)
        parsed = [xml.etree.ElementTree.parse(path) for path in cls.folder.glob("xml/*.xml")]
        cls.compounds = [c for p in parsed for c in p.getroot().iter("compounddef")]
        cls.members = [m for compound in cls.compounds for m in compound.iter("memberdef")]

    def test_no_warning(self):
        self.assertEqual(self.outcome, (0, ""))

    def test_every_function(self):
        """Those that the compiler sees, each with its parameters and with words on it."""
        seen = subprocess.run(["cc", "-E", "-P", ROOT / "include/topple/topple.h"], check=True,
                              capture_output=True, encoding="utf-8").stdout
        seen = re.sub(r"(static inline [^{]*)\{[^}]*\}", r"\1;", seen)
        declared = {name: [re.search(r"\w+(?=\W*$)", p)[0] for p in parameters.split(",")]
                    for name, parameters in re.findall(r"\b(tp_\w+)\s*\(([^()]*)\)\s*"
                                                       r"(?:__attribute__\(\(\w+\)\))?;", seen)}
        self.assertGreater(len(declared), 100)
        told = {}
        for member in self.members:
            if member.get("kind") == "function":
                names = [(p.findtext("declname") or "void") for p in member.iter("param")]
                told[member.findtext("name")] = names
                self.assertGreater(len(said_of(member)), 10, member.findtext("name"))
        self.assertEqual(told, declared)

    def test_every_struct_field_and_value(self):
        """A value of an enumeration by words of its own, or by those of its enumeration."""
        fields = values = 0
        for compound in self.compounds:
            name = compound.findtext("compoundname")
            if compound.get("kind") in ("struct", "file") and not name.endswith(".md"):
                self.assertTrue(said_of(compound), name)
        for member in self.members:
            name, words = member.findtext("name"), said_of(member)
            if member.get("kind") in ("variable", "typedef", "define"):
                fields += member.get("kind") == "variable"
                self.assertTrue(words, name)
            for value in member.findall("enumvalue"):
                values += 1
                self.assertTrue(words or said_of(value), f"{name}: {value.findtext('name')}")
        self.assertGreater(fields, 300)
        self.assertGreater(values, 100)

    def test_every_status_is_told(self):
        """The comment of tp_status names all but TP_OK, which the compiler takes from the list."""
        (status,) = [m for m in self.members if m.findtext("name") == "tp_status"]
        for value in status.findall("enumvalue"):
            if value.findtext("name") != "TP_OK":
                self.assertIn(value.findtext("name"), said_of(status))

    def test_what_is_not_documented_is_found(self):
        """The check itself: of a call without a word and one with, it tells of the first."""
        with tempfile.TemporaryDirectory(prefix="with blanks ") as name:
            source, output = pathlib.Path(name, "tree"), pathlib.Path(name, "output")
            for folder in (output, source / "include/topple", source / "docs/reference"):
                folder.mkdir(parents=True)
            few = [path for path in HEADERS if path.stem in ("topple_find", "topple_blocks", "topple_scene")]  # all take as long as the reference
            for path in (*few, *PAGES, ROOT / "docs/reference/filter.py"):
                shutil.copy(path, source / path.relative_to(ROOT))
            header = source / "include/topple/topple_find.h"
            text = header.read_text(encoding="utf-8")
            end = text.rindex("#ifdef __cplusplus")
            text = f"{text[:end]}int tp_silent(int of);\n\n/* Words. */\nint tp_told(int of);\n\n{text[end:]}"
            header.write_text(text, encoding="utf-8")
            status, printed = build(source, output)
            self.assertNotEqual(status, 0, printed)
            self.assertIn("tp_silent", printed)
            self.assertNotIn("tp_told", printed)


class Comments(unittest.TestCase):
    """What stands for what, where a header is made ready for Doxygen."""

    def converted(self, text):
        head = "/* SPDX 1 */\n/* SPDX 2 */\n\n/* The file. */\n\n"
        out = comments.converted(head + text)
        self.assertEqual(out.count("\n"), (head + text).count("\n"), "lines stay")
        self.assertTrue(out.startswith("/* SPDX 1 */\n/* SPDX 2 */\n/** @file\n * The file. */\n"))
        return out.split("/** @file\n * The file. */\n\n", 1)[1]

    def test_groups_end_at_an_empty_line(self):
        self.assertEqual(self.converted("/* Both. */\nint a(int b);\nint c(void);\n\nint d(b);\n"),
                         "/** Both. */\nint a(int b);\n/** Both. */ int c(void);\n\nint d(b);\n")
        self.assertEqual(self.converted("/* One. */\nint a(void);\n/* Two. */\nint b(void);\n"),
                         "/** One. */\nint a(void);\n/** Two. */\nint b(void);\n")

    def test_inline_functions(self):
        text = "/* Both. */\nstatic inline int a(void) {\n  return 1;\n}\nint b(void);\n"
        self.assertEqual(self.converted(text), text.replace("/* ", "/** ")
                         .replace("int b", "/** Both. */ int b"))

    def test_fields(self):
        self.assertEqual(
            self.converted("/* Of it. */\nstruct s {\n  char *a, *b[2]; /* two\n        lines */\n"
                           "  int c; /* c */\n};\n"),
            "/** Of it. */\nstruct s {\n"
            "  char *a; /**< two lines */ char *b[2]; /**< two lines */\n"
            "\n  int c; /**< c */\n};\n")

    def test_what_doxygen_would_read(self):
        self.assertEqual(self.converted("/* A \\x1B, |a| < b, `x < y`. */\nint a(void);\n"),
                         "/** A \\\\x1B, |a| \\< b, `x < y`. */\nint a(void);\n")

    def test_pages(self):
        self.assertEqual(comments.unlinked("[a b](c.md) and [d](https://e)"),
                         "a b and [d](https://e)")


if __name__ == "__main__":
    main()
