# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The package is typed: mypy --strict finds nothing in it, nor in a program that uses it, and finds mistakes in one that has
some. Skipped where there is no mypy."""

import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from harness import ROOT, main
from python_case import BUILD, topple

PROGRAM = """
import numpy
import topple


def factor(friction_angle_deg: float) -> float | None:
    outline = numpy.array([(0, 0), (50, 0), (50, 100), (0, 100)], dtype=float)
    scene = topple.Scene("mm", outline=outline, friction_angle_deg=friction_angle_deg, tilt_angle_deg="12.5")
    case = scene.solve().case(topple.Direction.LEFT)
    if case.mechanism is topple.Mechanism.STANDS and case.first_angle_deg is not None:
        print(case.first_angle_deg.value + case.first_angle_deg.error)
    found = topple.find(scene, "friction_angle_deg", "limit_angle", 20)
    print(found.report(), [solution for solution in found.solutions])
    result = topple.study("study.yaml", stop=lambda: False, progress=lambda done, of: print(done, of))
    print(result.samples, result.columns["fos"].mean(), topple.sweep(scene, "friction_angle_deg=20:30:1").to_dataframe())
    try:
        topple.Scene.read("scene.yaml")
    except topple.BadInput as error:
        print(error.file, error.line, error.fault is topple.Fault.UNIT)
    except topple.ToppleError as error:
        print(error.text)
    return None if case.governing_fos is None else float(case.governing_fos)
"""
MISTAKES = {
    'topple.Scene("mm", outlin=[])': "call-arg",
    'topple.Scene("mm").solve(digits="9")': "arg-type",
    "topple.Scene.read(3)": "arg-type",
    "topple.Mechanism.TOPLES": "attr-defined",
    "topple.Scene('mm').solve().case('left').first_angle_deg + 1": "operator",
}


CACHE = tempfile.TemporaryDirectory()  # what mypy knows of the package and of NumPy: ten seconds' work, once


def checked(text):
    """What mypy says of a program beside the package."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "program.py"
        path.write_text(text, encoding="utf-8")
        done = subprocess.run(["mypy", "--config-file", ROOT / "pyproject.toml", "--cache-dir", CACHE.name, path], capture_output=True,
                              encoding="utf-8", env={"MYPYPATH": str(BUILD / "python"), "PATH": "/usr/bin:/bin"}, check=False)
    return done.stdout


@unittest.skipUnless(shutil.which("mypy", path="/usr/bin:/bin"), "mypy is not installed")
class Typed(unittest.TestCase):
    def test_strict(self):
        self.assertEqual(checked(PROGRAM), "Success: no issues found in 1 source file\n")

    def test_mistakes(self):
        """One a line, each found."""
        text = checked("import topple\n" + "\n".join(MISTAKES) + "\n")
        found = {int(line.split(":")[1]): line for line in text.splitlines() if ": error:" in line}
        for number, (mistake, kind) in enumerate(MISTAKES.items(), 2):
            self.assertIn(f"[{kind}]", found.get(number, ""), f"{mistake}: {text}")

    def test_all(self):
        """What `__all__` lists is there, and every public name is listed."""
        for name in topple.__all__:
            self.assertTrue(hasattr(topple, name), name)
        modules = {path.stem for path in (ROOT / "python" / "topple").glob("*.py")} | {"records", "words"}
        public = {name for name in vars(topple) if not name.startswith("_") and name not in modules}
        self.assertEqual(public - set(topple.__all__), set())


if __name__ == "__main__":
    main()
