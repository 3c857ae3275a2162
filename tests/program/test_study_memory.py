# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Memory does not grow with the samples of a study beyond those that it keeps for quantiles: the most that it ever took, as the
system counts it, with rows in CSV and made into HDF5. Slabs of no height, which take no time to solve, are samples as well."""

import os
import pathlib
import subprocess

from harness import PROGRAM, main
from study_case import StudyCase

BUILD = pathlib.Path(os.environ.get("TOPPLE_BUILD", pathlib.Path(PROGRAM).parent))
KEPT = 1 << 18  # docs/study.md
COLUMNS = 1 + 4 + 1 + 1 + 2  # what varies, quantities, outcome, definition of the factor, two factors beside it


class Memory(StudyCase):
    def peak(self, samples, *words):
        """In bytes."""
        self.write(f"samples: {samples}\nsampling: {{chunk: 5000}}\nvary: {{block.slab.height: {{uniform: {{low: -4, high: -1}}}}}}\n")
        with subprocess.Popen([PROGRAM, "study", "study.yaml", "--restart", "--threads", "1", *words], cwd=self.folder,
                              stdout=subprocess.PIPE, encoding="utf-8") as process:
            out = process.stdout.read()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = status
        self.assertEqual(status, 0)
        self.assertIn(f"{samples} of {samples} samples", out)
        return 1024 * usage.ru_maxrss

    def test_flat(self):
        """1000 samples; as many as are kept; twice as many, whose numbers alone would be 19 MB more."""
        little = self.peak(1000, "--rows", "rows.csv")
        much = self.peak(KEPT, "--rows", "rows.csv")
        more = self.peak(2 * KEPT, "--rows", "rows.csv")
        self.assertLess(much - little, 3 * 8 * COLUMNS * KEPT)  # the columns, and what sorts and ranks one by one
        self.assertLess(abs(more - much), 6 << 20)  # as the allocator happens to part it

    def test_flat_in_hdf5(self):
        """Twice and ten times a block of rows, which would be 20 MB more."""
        if not (BUILD / "libtopple-hdf5.so").exists():
            self.skipTest("Topple was built without HDF5")
        few, many = (self.peak(rows, "--rows", "rows.h5") - self.peak(rows, "--rows", "rows.csv") for rows in (16384, 81920))
        self.assertLess(many - few, 6 << 20)


if __name__ == "__main__":
    main()
