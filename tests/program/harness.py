# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Running the program as a user does, and the closing line of a test run."""

import csv
import ctypes
import decimal
import functools
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("TOPPLE", str(ROOT / "build" / "topple"))
LONG = os.environ.get("TOPPLE_LONG", "0") not in ("", "0")  # ./check --long


def rounds(brief, long):
    """How often a random test draws: `brief` times, `long` times under `./check --long`. The brief ones are of a
    fixed seed and take seconds."""
    return long if LONG else brief


# By what the numbers of random scenes are multiplied.
ROUNDS = int(os.environ.get("TOPPLE_ROUNDS", rounds(1, 10)))


@functools.cache
def reads(kind):
    """Was Topple built to read drawings of this kind: dxf, geojson or svg? It says so itself."""
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / f"drawing.{kind}").write_text("no drawing\n", encoding="utf-8")
        return "was built without" not in run("solve", f"drawing.{kind}", folder=folder)[2]


def is_readable(scene):
    """Does Topple, as it was built, read a file and the drawing that it names?"""
    text = scene.name + "\n" + (scene.read_text(encoding="utf-8") if scene.suffix == ".yaml" and scene.exists() else "")
    return all(map(reads, set(re.findall(r"\.(dxf|geojson|svg)\b", text))))


def example_scenes():
    """The scenes of examples/ that Topple, as it was built, reads; but those of several load cases, of which each is one."""
    examples = ROOT / "examples"
    return [path for path in sorted([*examples.glob("*.yaml"), *examples.glob("slope/*.yaml")])
            if is_readable(path) and "\ncases:" not in path.read_text(encoding="utf-8")]


def schemas():
    """The JSON Schemas of what commands print, which the build makes."""
    return sorted((pathlib.Path(PROGRAM).parent / "src" / "core").glob("*.json"))


def run(*arguments, folder=ROOT, timeout=300):
    """Run topple; exit status, stdout and stderr as text."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=folder, timeout=timeout,
                          capture_output=True, encoding="utf-8")
    return done.returncode, done.stdout, done.stderr


def solve(scene, *options, folder=ROOT):
    """The JSON of `topple solve --json`; a status other than 0 is an error of the test."""
    status, out, err = run("solve", "--json", *options, scene, folder=folder)
    if status != 0 or err:
        raise AssertionError(f"topple solve {scene}: exit {status}: {err}")
    return json.loads(out)


def compiled(source, path):
    """C in a library of its own, without a warning; `path` is its name, another for each of a process."""
    compiler = shutil.which("cc")
    if compiler is None:
        raise AssertionError("there is no C compiler")
    file, library = path.with_suffix(".c"), path.with_suffix(".so")
    file.write_text(source)
    subprocess.run([compiler, "-Wall", "-Wextra", "-Werror", "-O1", "-shared", "-fPIC", file, "-o", library, "-lm"],
                   check=True)
    return ctypes.CDLL(str(library))


def rounded_down(value, decimals=3):
    """A factor of safety as it is printed: no decimal of it is above the true one."""
    place = decimal.Decimal(1).scaleb(-decimals)
    return str(decimal.Decimal(value).quantize(place, decimal.ROUND_FLOOR))


def table(name):
    """Rows of a reviewed table in tests/data, without its comment lines."""
    lines = (ROOT / "tests" / "data" / name).read_text(encoding="utf-8").splitlines()
    return list(csv.DictReader(line for line in lines if line and not line.startswith("#")))


def main():
    """Run the tests of the calling file and close with one line that counts them."""
    suite = unittest.defaultTestLoader.loadTestsFromModule(sys.modules["__main__"])
    result = unittest.TextTestRunner(verbosity=1).run(suite)
    failed = len({test.test_case.id() if hasattr(test, "test_case") else test.id()
                  for test, _ in result.failures + result.errors})  # a test with cases that fail is one
    print(f"{result.testsRun - failed} passed, {failed} failed", flush=True)
    sys.exit(failed > 0 or result.testsRun == 0)
