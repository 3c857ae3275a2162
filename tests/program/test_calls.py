# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Every public call, as the headers declare them, is tried with arguments that no call can do anything with, and is
among what must come out the same whatever the program has set in its thread, and in eight threads at once.

A call that was added later was in none of these tests, and nothing said so."""

import re
import sys
import unittest

from harness import ROOT, main

sys.path.insert(0, str(ROOT / "include"))
from exports import declared

CALLS = sorted(set().union(*(declared(path.read_text(encoding="utf-8")) for path in (ROOT / "include" / "topple").glob("topple*.h"))))


def called(pattern):
    """The names that the C of the tests uses, outside of comments and texts; a default is made by its `_init`."""
    names = set()
    for path in (ROOT / "tests").rglob(pattern):
        text = re.sub(r'/\*.*?\*/|"(?:\\.|[^"\\\n])*"', " ", path.read_text(encoding="utf-8"), flags=re.DOTALL)
        names.update(re.sub("_options_default$", "_options_init", name) for name in re.findall(r"\btp_\w+\b", text))
    return names


class Calls(unittest.TestCase):
    def test_list_is_whole(self):
        self.assertGreater(len(CALLS), 100)
        for name in ("tp_solve", "tp_scene_add_anchor", "tp_report_figure_if", "tp_solution_free"):
            self.assertIn(name, CALLS)

    def test_hostile_arguments(self):
        tried = called("test_*arguments.c")
        self.assertEqual([], [name for name in CALLS if name not in tried],
                         "not tried in tests/library/test_arguments.c or another test_*_arguments.c")

    def test_settings_and_threads(self):
        said = called("sayings*.c")
        self.assertEqual([], [name for name in CALLS if name not in said],
                         "not called in tests/support/sayings*.c, which test_host.c and test_threads.c run")
        for test in ("test_host.c", "test_threads.c"):
            used = re.search(r"say_everything|all_sayings", (ROOT / "tests/library" / test).read_text(encoding="utf-8"))
            self.assertIsNotNone(used, f"tests/library/{test} runs what tests/support/sayings.h offers")


if __name__ == "__main__":
    main()
