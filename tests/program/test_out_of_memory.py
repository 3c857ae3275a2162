# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Memory that runs out: every command, with the n-th request of the whole process failing once, be it ours,
FLINT's, Cairo's or the C library's own.

The program then ends with status 5, a message, nothing on stdout and no file; or, where a library made do
without, as if nothing had happened. By default a few n of each command, four times as many under
`./check --long`; with TOPPLE_EVERY_REQUEST set all, or 5000 of the commands that make more requests."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

from harness import PROGRAM, ROOT, main, rounds

# The loader takes a blank for the end of a name: a link to the library, in a folder without one.
LINKS = tempfile.TemporaryDirectory()
LIBRARY = pathlib.Path(LINKS.name, "failing_memory.so")
LIBRARY.symlink_to(os.environ["TOPPLE_FAILING_MEMORY"])
MOST = 5000 if os.environ.get("TOPPLE_EVERY_REQUEST") else None
EXAMPLES = ROOT / "examples"
CLAIMS = """topple_claims: 1
geometries: {{slab: {{scene: {scene}}}}}
claims:
- {{id: a, where: Eq. (3), geometry: slab, quantity: critical_angle, printed: tan^-1(dx/y)}}
- {{id: b, where: Eq. (2), geometry: slab, quantity: fos, printed: tan alpha*(dx/y)}}
"""


def run(folder, arguments, **environment):
    """Run topple under the library that fails: exit status, stdout, stderr, names of the files left."""
    for file in folder.glob("out.*"):
        file.unlink()
    done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=folder, capture_output=True, encoding="utf-8",
                          timeout=600, env=os.environ | {"LD_PRELOAD": str(LIBRARY)} | environment)
    return done.returncode, done.stdout, done.stderr, sorted(file.name for file in folder.glob("out.*"))


def without_times(text):
    """A report but for how long things took."""
    text = re.sub(r'"seconds": [^,}]*', "", text)
    return re.sub(r" *[0-9.e+-]+ ms", "", text)


class OutOfMemory(unittest.TestCase):
    def every(self, points, *arguments, complete=b""):
        """Fail so many of the requests, evenly spread, a quarter of them (two at the least) but in the long rounds; a
        file that is left ends in `complete`."""
        points = MOST or rounds(max(2, points // 4), points)
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "claims.yaml").write_text(CLAIMS.format(scene=EXAMPLES / "paper" / "slab.yaml"))
            status, out, err, files = run(folder, arguments, TOPPLE_COUNT_REQUESTS="1")
            self.assertIn(status, (0, 1), err)
            requests = max(map(int, re.findall(r"requests: (\d+)", err)))
            self.assertGreater(requests, 50)
            failed = 0
            for n in range(1, requests + 1, 1 + (requests - 1) // points):
                with self.subTest(n=n):
                    own = run(folder, arguments, TOPPLE_FAIL_AT=str(n))
                    if own[0] == status:
                        self.assertEqual(without_times(own[1]), without_times(out))
                        self.assertEqual(own[3], files)
                        for file in files:
                            self.assertTrue((folder / file).read_bytes().rstrip().endswith(complete))
                        continue
                    failed += 1
                    self.assertEqual(own[0], 5, own[2])
                    self.assertEqual(own[1], "")
                    self.assertRegex(own[2], r"(?m)^topple: .*(memory|cannot|load)")
                    self.assertEqual(own[3], [], "a file is left")
            self.assertGreater(failed, 0)

    def test_solve(self):
        self.every(40, "solve", "--json", "--elements", EXAMPLES / "block_e_valley.yaml")

    def test_solve_with_hole(self):
        self.every(20, "solve", EXAMPLES / "block_with_hole.yaml")

    def test_solve_under_loads(self):
        self.every(20, "solve", EXAMPLES / "block_under_water.yaml")

    def test_solve_many_blocks(self):
        """In the program of forces and in the proofs too: it is not called undecided."""
        self.every(20, "solve", EXAMPLES / "blocks" / "wet_columns.yaml")

    def test_solve_outline_of_file(self):
        self.every(20, "solve", EXAMPLES / "boulder.yaml")

    def test_solve_to_many_digits(self):
        self.every(20, "solve", "--digits", "40", EXAMPLES / "block_e_valley.yaml")

    def test_accuracy(self):
        """To a file, as the times differ from run to run."""
        self.every(3, "accuracy", "--output", "out.csv", EXAMPLES / "slab.yaml")

    def test_profile(self):
        self.every(10, "profile", "--json", EXAMPLES / "joint_profile.csv")
        self.every(5, "profile", "--step", "0.5", "--resample", "spline", "--jcs", "120", EXAMPLES / "block_e_valley.yaml")

    def test_table(self):
        self.every(30, "solve", "--table", EXAMPLES / "block_f.yaml", EXAMPLES / "slab.yaml")

    def test_find(self):
        self.every(15, "solve", "--find", "block.rounded.corners.1.radius", "--for", "critical_angle=23.5",
                   EXAMPLES / "block_a_worn.yaml")

    def test_figure(self):
        """Fontconfig crashes at some n: the program does not."""
        self.every(60, "solve", "--figure", "out.svg", EXAMPLES / "slab.yaml", complete=b"</svg>")

    def test_figure_in_pdf(self):
        self.every(40, "solve", "--figure", "out.pdf", EXAMPLES / "slab.yaml", complete=b"%%EOF")

    def test_derive(self):
        self.every(40, "derive", "--elements", "--rounded", EXAMPLES / "block_e_valley.yaml")

    def test_derive_limit(self):
        self.every(30, "derive", "--limit", "--unchecked", EXAMPLES / "block_e_valley.yaml")

    def test_derive_checks(self):
        self.every(1500, "derive", "--limit", EXAMPLES / "slab_left.yaml")

    def test_derive_for_all_counts(self):
        self.every(20, "derive", "--for-all", "count", EXAMPLES / "block_e_valley.yaml")

    def test_verify(self):
        self.every(30, "verify", "claims.yaml")

    def test_chart_fos(self):
        self.every(20, "chart", "fos", "--json")

    def test_chart_mechanisms(self):
        self.every(10, "chart", "mechanisms", "--output", "out.csv")

    def test_chart_ranges(self):
        self.every(4, "chart", "ranges")

    def test_chart_map(self):
        self.every(10, "chart", "map", EXAMPLES / "slab_left.yaml", "--x", "block.slab.width=10:150")

    def test_chart_drawn(self):
        self.every(8, "chart", "fos", "--output", "out.svg", complete=b"</svg>")


if __name__ == "__main__":
    main()
