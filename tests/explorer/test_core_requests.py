# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The core's queue, time limit and restart by core_requests.mjs in node; and the page's bytes, bundled twice."""

import hashlib
import pathlib
import shutil
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "program"))

from harness import main  # noqa: E402

PAGE = ROOT / "build-explorer" / "explorer.html"
NODE = shutil.which("node")


@unittest.skipIf(NODE is None, "there is no node: install Debian's package nodejs")
@unittest.skipUnless(PAGE.is_file(), f"there is no {PAGE}: ./run --explorer builds it")
class Built(unittest.TestCase):
    def test_requests(self):
        """Each story of core_requests.mjs comes out right."""
        script = pathlib.Path(__file__).with_name("core_requests.mjs")
        done = subprocess.run([NODE, script], capture_output=True, encoding="utf-8", timeout=120)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_same_bytes(self):
        """Bundled again from the same sources, the page is the same file."""
        subprocess.run([ROOT / "src" / "applications" / "explorer" / "bundle"], check=True, timeout=300)
        first = hashlib.sha256(PAGE.read_bytes()).hexdigest()
        subprocess.run([ROOT / "src" / "applications" / "explorer" / "bundle"], check=True, timeout=300)
        self.assertEqual(hashlib.sha256(PAGE.read_bytes()).hexdigest(), first)

    def test_size(self):
        """The whole page has less than 8 MB."""
        self.assertLess(PAGE.stat().st_size, 8e6)


if __name__ == "__main__":
    main()
