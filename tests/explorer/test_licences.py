# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What is inlined into the explorer is named in it with its licence: every package of npm that can get into the page, at
its version and with its notice, and every source package of the core."""

import csv
import json
import re
import unittest

from page_case import ROOT, main

EXPLORER = ROOT / "src" / "applications" / "explorer"
# Licences that go with the GNU General Public License, version 3 or later
COMPATIBLE = {"MIT", "ISC", "BSD-3-Clause", "BSL-1.0", "Apache-2.0 WITH LLVM-exception", "LGPL-2.1-or-later", "LGPL-3.0-or-later",
              "GPL-2.0-or-later", "GPL-3.0-or-later", "libpng-2.0", "Zlib",
              # LGPL 2.1 may become GPL by its section 3; FreeType's is chosen as GPL; a font is data beside the program
              "LGPL-2.1-only OR MPL-1.1", "FTL OR GPL-2.0-or-later", "Bitstream-Vera"}
NEED_NOTICE = {"MIT", "ISC", "BSD-3-Clause", "BSL-1.0", "libpng-2.0", "Zlib", "FTL OR GPL-2.0-or-later", "Bitstream-Vera"}
# What goes by another name than that of its source package
NAMES = {"suitesparse": "cxsparse", "mpfr4": "mpfr", "flint-arb": "arb", "glibc": "argp", "libpng1.6": "libpng"}


class Licences(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.told = json.loads((EXPLORER / "licences" / "licences.json").read_text(encoding="utf-8"))

    def test_packages_of_npm(self):
        """As the lock file has them: none is missing, none stands at another version or licence."""
        lock = json.loads((EXPLORER / "package-lock.json").read_text(encoding="utf-8"))["packages"]
        locked = {f"{place.removeprefix('node_modules/')} {each['version']}": each["license"] for place, each in lock.items()
                  if place and not each.get("dev") and not each.get("optional")}
        told = {each["name"]: each["licence"] for each in self.told["libraries"]}
        self.assertEqual({name: told.get(name) for name in locked}, locked)
        self.assertGreater(len(locked), 10)

    def test_source_packages_of_the_core(self):
        table = EXPLORER / "wasm" / "sources.csv"
        if not table.exists():
            self.skipTest("the core is not built from this tree")
        rows = csv.DictReader(line for line in table.read_text(encoding="utf-8").splitlines() if not line.startswith("#"))
        told = {each["name"].split()[0].lower(): each["licence"] for each in self.told["libraries"]}
        for row in rows:
            name = NAMES.get(row["package"], row["package"])
            self.assertIn(name, told)

    def test_licences_and_notices(self):
        """All go with the GPL; those that ask for their notice have one, with somebody's name in it."""
        for each in self.told["libraries"]:
            self.assertIn(each["licence"], COMPATIBLE, each["name"])
            if each["licence"] in NEED_NOTICE:
                self.assertRegex(self.told["notices"][each["notice"]], re.compile(r"copyright|distributed under", re.I), each["name"])
            self.assertGreater(len(each["for"]), 3)


if __name__ == "__main__":
    main()
