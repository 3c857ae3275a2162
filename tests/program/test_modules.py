# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What ./run leaves out, as only some commands have a use for it: a command that misses its module says which option of
./run builds it, and README lists each."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from harness import PROGRAM, ROOT, main

RUN = (ROOT / "run").read_text(encoding="utf-8")
MODULES = re.search(r"^modules=\((.*)\)$", RUN, re.M).group(1).split()


class Missing(unittest.TestCase):
    """The program alone in a folder, without the libraries that lie beside it where they were built."""

    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)
        shutil.copy(PROGRAM, self.folder)
        (self.folder / "study.yaml").write_text(
            f"topple_study: 1\nscene: {ROOT / 'examples' / 'slab_left.yaml'}\nsamples: 2\n"
            "vary: {friction_angle_deg: {uniform: {low: 20, high: 30}}}\n")

    def misses(self, module, *words, **environment):
        done = subprocess.run([self.folder / "topple", *map(str, words)], cwd=self.folder, capture_output=True,
                              encoding="utf-8", env={**os.environ, **environment}, timeout=60)
        if done.returncode == 0:
            self.skipTest("another Topple is installed here")
        self.assertEqual((done.returncode, done.stdout), (5, ""), done.stderr)
        self.assertIn(f"./run --with {module}'", done.stderr)
        self.assertIn(module, MODULES)

    def test_trace(self):
        self.misses("trace", "trace", ROOT / "examples" / "pictures" / "painted_boulder.png", "--around=70,70,420,300",
                    "--scale=30.7,306.7,190.3,317.9,2")

    def test_hdf5(self):
        self.misses("hdf5", "study", "study.yaml", "--rows", "rows.h5")

    def test_xlsx(self):
        (self.folder / "survey.csv").write_text("name,width (m),height (m),dip,friction\na,1,2,20,30\n")
        self.misses("xlsx", "solve", "--batch", "survey.xlsx")
        self.misses("xlsx", "solve", "--batch", "survey.csv", "--output", "table.xlsx")

    def test_gis(self):
        (self.folder / "section.shp").write_bytes(b"")
        done = subprocess.run([self.folder / "topple", "solve", "section.shp", "--unit", "m"], cwd=self.folder, capture_output=True,
                              encoding="utf-8", timeout=60)
        self.assertIn(done.returncode, (3, 5), done.stderr)  # built without it, or its library is not there
        self.assertIn("'./run --with gis'", done.stderr)

    def test_python(self):
        """The package as it lies in a clone, or built for another Python."""
        package = self.folder / "python" / "topple"
        package.mkdir(parents=True)
        for source in (ROOT / "python" / "topple").glob("*.py"):
            shutil.copy(source, package)
        done = subprocess.run([sys.executable, "-c", "import topple"], cwd=self.folder, capture_output=True, encoding="utf-8",
                              env={**os.environ, "PYTHONPATH": str(package.parent)}, timeout=60)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"(?m)^ImportError: .*'\./run --with python --setup' in Topple's folder.*PYTHONPATH=build/python")

    def test_mpi(self):
        self.misses("mpi", "study", "study.yaml", OMPI_COMM_WORLD_SIZE="2", OMPI_COMM_WORLD_RANK="0")

    def test_charts(self):
        self.misses("charts", "chart", "ranges", "--output", "chart.svg", PATH=str(self.folder / "empty"))


class Run(unittest.TestCase):
    def refuses(self, *words):
        done = subprocess.run([ROOT / "run", *words], capture_output=True, encoding="utf-8", timeout=60)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        return done.stderr

    def test_unknown_modules(self):
        """Before anything is installed or built; all that there are are named."""
        for words in (["--with"], ["--with", "opencv"], ["--with=trace,opencv", "solve"]):
            said = self.refuses(*words).splitlines()[0]
            for module in MODULES:
                self.assertIn(module, said)

    def test_each_is_explained(self):
        """In the head of ./run with its packages, and in README."""
        readme = (ROOT / "README.md").read_text(encoding="utf-8")
        for module in MODULES:
            self.assertRegex(RUN, rf"(?m)^# +{module} ")
            self.assertRegex(RUN, rf"(?m)^  \[{module}\]=")
            self.assertIn(f"./run --with {module}", readme)


if __name__ == "__main__":
    main()
