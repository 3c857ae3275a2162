# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The installed package alone: the five lines at the head of docs/python.md, in an empty folder, against a copy that was
installed into another one, with nothing else of the project beside it."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from harness import ROOT, main
from python_case import BUILD, SOURCES

PAGE = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="topple python ")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        subprocess.run(["meson", "install", "-C", BUILD, "--no-rebuild", "--destdir", cls.folder / "installed"], check=True,
                       capture_output=True)
        (cls.package,) = (cls.folder / "installed").rglob("topple/py.typed")
        (cls.folder / "empty").mkdir()

    def run_alone(self, program):
        """What a program prints, with nothing of the project in reach but the installed package."""
        done = subprocess.run([sys.executable, "-c", program], cwd=self.folder / "empty", check=False, capture_output=True,
                              encoding="utf-8", env={"PATH": os.environ["PATH"],
                                                     "PYTHONPATH": str(self.package.parent.parent),
                                                     "PYTHONDONTWRITEBYTECODE": "1", "HOME": str(self.folder)})
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def test_five_lines(self):
        (program, *_) = re.findall(r"^```python\n(.*?)^```$", PAGE, re.M | re.S)
        (printed, *_) = re.findall(r"^```text\n(.*?)^```$", PAGE, re.M | re.S)
        self.assertEqual(len(program.splitlines()), 5)
        self.assertEqual(self.run_alone(program), printed)

    def test_examples(self):
        """Each compares what it prints with closed forms of its own, and would end with another
        status; each has a twin in C."""
        examples = sorted((ROOT / "examples" / "python").glob("*.py"))
        twins = (ROOT / "examples" / "c").glob("*.c")
        self.assertEqual({path.stem for path in examples}, {path.stem for path in twins})
        for example in examples:
            with self.subTest(example=example.name):
                printed = self.run_alone(example.read_text(encoding="utf-8"))
                self.assertGreater(printed.count("\n"), 3)

    def test_all_is_there(self):
        """Each file of the package; it is loaded from the install, with its own libraries, and draws."""
        own = {path.name for path in SOURCES.iterdir() if path.suffix == ".py"}
        self.assertLessEqual(own, {path.name for path in self.package.parent.iterdir()})
        program = "import topple\nprint(topple.__file__)\n" \
                  "s = topple.Scene('mm', slab=(5, 10), friction_angle_deg=30).solve()\nprint(s._repr_svg_()[-7:])"
        where, *drawn = self.run_alone(program).splitlines()
        self.assertEqual(pathlib.Path(where).parent, self.package.parent)
        self.assertIn("</svg>", drawn[0])

    def test_other_versions(self):
        """A package that was built for another libtopple than is loaded, and another library of figures: told, before a struct of
        one is read by the other."""
        draws = "import topple\ntopple.Scene('mm', slab=(5, 10), friction_angle_deg=30).solve().write_figure('f.svg')\n"
        for call, said in (("tp_version", "ImportError: this package was built for libtopple 0"),
                           ("tp_figure_version", "libtopple-figure 9.8.7, and libtopple is 0")):
            first = self.folder / f"{call}.so"
            subprocess.run(["cc", "-shared", "-fPIC", "-x", "c", "-", "-o", first], check=True, encoding="utf-8",
                           input=f'const char *{call}(void) {{ return "9.8.7"; }}\n')
            done = subprocess.run([sys.executable, "-c", draws], cwd=self.folder / "empty", check=False, capture_output=True,
                                  encoding="utf-8", env={"PATH": os.environ["PATH"], "LD_PRELOAD": f"../{call}.so",  # no blank in it
                                                         "PYTHONPATH": str(self.package.parent.parent)})
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(said, done.stderr)
            self.assertIn("install both of the same version", done.stderr)
        self.assertEqual(list((self.folder / "empty").iterdir()), [])

    def test_without_numpy(self):
        """Scenes of lists need no NumPy, and it is not loaded for them."""
        self.assertEqual(self.run_alone("import sys, topple\ntopple.Scene('mm', outline=[(0, 0), (50, 0), (0, 50)]).solve()\n"
                                        "print('numpy' in sys.modules)"), "False\n")


if __name__ == "__main__":
    main()
