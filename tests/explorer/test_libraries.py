# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The cache of libraries for WebAssembly outlives the checkout that made it: somebody clones anew, and builds with what is there.
And a word of the program that draws is not forgotten where the core has a file of its own in place of one."""

import os
import pathlib
import re
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "program"))
from harness import ROOT, main  # noqa: E402

sys.path.insert(0, str(ROOT / "src/applications/explorer"))
sys.dont_write_bytecode = True
from wasm import libraries  # noqa: E402

DEFINED = re.compile(r"^tp_status (tp_cli_\w+)\(", re.M)


class Cache(unittest.TestCase):
    def test_no_link_leads_into_the_checkout(self):
        own = libraries.HERE / "include"
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "source.h").write_text("int source;\n")
            for _ in range(2):  # one that was killed goes on
                libraries.linked(folder / "include", [folder / "source.h", own / "argp.h", own / "bits"])
            self.assertEqual(os.readlink(folder / "include" / "source.h"), "../source.h")
            for path in (folder / "include").rglob("*"):
                self.assertTrue(path.name == "source.h" or not path.is_symlink(), path)
            self.assertEqual((folder / "include" / "argp.h").read_bytes(), (own / "argp.h").read_bytes())
            self.assertEqual({path.name for path in (folder / "include" / "bits").iterdir()}, {path.name for path in (own / "bits").iterdir()})


class Replaced(unittest.TestCase):
    def test_the_core_draws_all_that_the_program_draws(self):
        """Sheets of solids came, and the core was linked without them no more, which the tests of a push do not build."""
        own, other = ((ROOT / "src/applications" / path).read_text() for path in ("explorer/wasm/c_library/draw.c", "cli/draw.c"))
        self.assertEqual(set(DEFINED.findall(own)), set(DEFINED.findall(other)))


if __name__ == "__main__":
    main()
