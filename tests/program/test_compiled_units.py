# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Units of compilation (src/units.py): every file lies in one of them; what clashes lies apart; an edit moves no other."""

import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

from harness import ROOT, main

MAKER = ROOT / "src" / "units.py"


class Units(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def group(self, texts, count, counted=()):
        """Writes the files; the names that each unit includes, in its order."""
        for name, text in texts.items():
            (self.folder / name).write_text(text, encoding="utf-8")
        units = [self.folder / f"unit_{k}.c" for k in range(count)]
        self.done = subprocess.run([sys.executable, MAKER, *units, "--", *counted, "--", *(self.folder / name for name in texts)],
                                   capture_output=True, text=True)
        return [[pathlib.Path(line.split('"')[1]).name for line in unit.read_text(encoding="utf-8").splitlines()]
                for unit in units if unit.exists()]

    def test_the_same_name_in_files_apart(self):
        """A function, a table, types, a structure, a constant and a test that two files name, each in a pair of its own."""
        pairs = ["static void add(int a) {\n}\n", "static const char *const add[] = {\n  0};\n", "typedef struct {\n  int a;\n} add;\n",
                 "struct add {\n  int a;\n};\n", "enum { MANY = 3, add = 4 };\n", "typedef int (*add)(int);\n", "START_TEST(add) {\n}\n",
                 "typedef double add __attribute__((vector_size(16)));\n"]
        for text in pairs:
            units = self.group({"a.c": text, "b.c": text, "c.c": "int other;\n"}, 2)
            self.assertEqual(sorted(sum(units, [])), ["a.c", "b.c", "c.c"], text)
            self.assertNotIn(["a.c", "b.c"], [[name for name in unit if name != "c.c"] for unit in units], text)

    def test_a_macro_reaches_no_other_file(self):
        units = self.group({"a.c": "#define size 3\n", "b.c": "int f(int size) {\n  return size;\n}\n"}, 2)
        self.assertEqual(sorted(units), [["a.c"], ["b.c"]])

    def test_calls_that_are_counted(self):
        """The linker sees a call only where the function is of another unit."""
        texts = {"a.c": "void tp_load(tp_wrench *own,\n             int a) {\n}\n", "b.c": "void f(void) {\n  tp_load(0, 1);\n}\n"}
        self.assertEqual(sorted(self.group(texts, 2, ["tp_load"])), [["a.c"], ["b.c"]])
        self.assertIn(["a.c", "b.c"], self.group(texts, 1))

    def test_what_comments_and_texts_say_is_nothing(self):
        units = self.group({"a.c": "#define size 3\n", "b.c": 'const char *f(void) {\n  return "size"; /* size */\n}\n'}, 1)
        self.assertEqual(units, [["a.c", "b.c"]])

    def test_what_comes_before_headers_comes_first(self):
        units = self.group({"a.c": "#include <math.h>\n", "z.c": "#define _GNU_SOURCE\n#include <stdio.h>\n"}, 1)
        self.assertEqual(units, [["z.c", "a.c"]])

    def test_too_few_units_are_told(self):
        self.group({"a.c": "static int add;\n", "b.c": "static int add;\n"}, 1)
        self.assertNotEqual(self.done.returncode, 0)
        self.assertIn("b.c: its names clash with a file of every unit", self.done.stderr)

    def test_an_edit_moves_no_other_file(self):
        """Of thirty files of random length one takes a name that another of its unit has: it alone changes its unit."""
        chance = random.Random(5)
        texts = {f"f{k}.c": f"static int v{k};\n" * chance.randint(1, 40) for k in range(30)}
        before = self.group(texts, 4)
        unit = next(unit for unit in before if len(unit) > 1)
        texts[unit[0]] += f"static int v{unit[1][1:-2]};\n"
        after = self.group(texts, 4)
        where = [{name: k for k, unit in enumerate(units) for name in unit} for units in (before, after)]
        self.assertEqual([name for name in texts if where[0][name] != where[1][name]], [unit[1]])


if __name__ == "__main__":
    main()
