# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The library as Python has it: numbers go in exactly, of every kind and every layout of array; what is wrong raises the
exception of its status; threads, memory, figures."""

import errno
import gc
import math
import os
import pathlib
import pickle
import subprocess
import sys
import tempfile
import threading
import unittest
import xml.dom.minidom
from decimal import Decimal
from fractions import Fraction

from harness import ROOT, main, run
from python_case import BLOCK, BUILD, SQUARE, ffi, lib, numpy, said, topple


class Numbers(unittest.TestCase):
    def area(self, outline):
        """Its area in units of the scene, as exactly as 60 digits tell."""
        return Fraction(topple.Scene("m", outline=outline).solve(digits=60, limit=False).block.area_m2.digits)

    def test_exactly(self):
        """A rectangle of a width times 1: its area is the number that the width was taken for."""
        for number, meant in ((0.1, Fraction(0.1)), ("0.1", Fraction(1, 10)), (Decimal("0.1"), Fraction(1, 10)),
                              (Fraction(1, 3), Fraction(1, 3)), ("2.5/7", Fraction(5, 14)), (2**53 + 1, Fraction(2**53 + 1)),
                              (numpy.float32(0.1), Fraction(float(numpy.float32(0.1)))), (numpy.int64(7), Fraction(7)),
                              (numpy.longdouble(1) / 3, Fraction(*(numpy.longdouble(1) / 3).as_integer_ratio()))):
            area = self.area([(0, 0), (number, 0), (number, 1.0), (0, Decimal(1))])
            self.assertLess(abs(area - meant), abs(meant) * Fraction(1, 10**58), number)

    def test_arrays(self):
        """The same points however they lie in memory."""
        points = numpy.array(BLOCK, dtype=float)
        meant = said(topple.Scene("mm", outline=BLOCK, friction_angle_deg=30))
        wide = numpy.zeros((6, 4))
        wide[:, ::2] = points
        for own in (points, points.astype(numpy.float32), points.astype(numpy.int16), points.astype(numpy.uint8),
                    points.astype(numpy.longdouble), points.astype(object), points.astype(">f8"), wide[:, ::2],
                    numpy.asfortranarray(points), points[::-1].copy()[::-1], points.tolist(), points.astype(str),
                    numpy.vstack([points, points[:1]])):
            self.assertEqual(said(topple.Scene("mm", outline=own, friction_angle_deg=30)), meant)
        large = numpy.array([(0, 0), (2**60 + 1, 0), (2**60 + 1, 1), (0, 1)])
        self.assertEqual(self.area(large), 2**60 + 1)

    def test_is_copied(self):
        points = numpy.array(SQUARE, dtype=float)
        scene = topple.Scene("mm", outline=points)
        meant = said(scene)
        points[:] = 0
        self.assertEqual(said(scene), meant)

    def test_what_is_no_number(self):
        for wrong in (None, True, 1j, b"1", [1], topple.Bounded(1.0, 0.1)):
            self.assertRaises(TypeError, topple.Scene("mm").set_thickness, wrong)
        for wrong in (math.nan, math.inf, "1/0", "one", "0x10", Decimal("nan"), 1e-320, "1e400", "1\0", ""):
            self.assertRaises(topple.BadInput, topple.Scene("mm").set_thickness, wrong)
        for wrong in ([(0, 0, 0)], numpy.zeros(4), numpy.zeros((2, 3)), [(0, "x")], [(math.nan, 0)] * 4):
            self.assertRaises(topple.BadInput, topple.Scene("mm").set_outline, wrong)


class Errors(unittest.TestCase):
    def test_statuses(self):
        """A class for each status that is no success, each of them a ToppleError and of its kind in Python."""
        from topple.errors import ERRORS
        self.assertEqual(sorted(ERRORS), list(range(1, len(ERRORS) + 1)))
        self.assertEqual(sum(name.startswith("TP_") and name in dir(lib) for name in
                             ("TP_BAD_INPUT", "TP_NO_ANSWER", "TP_UNDECIDED", "TP_OUT_OF_MEMORY", "TP_SYSTEM_FAILED",
                              "TP_DEPENDENCY_FAILED")), len(ERRORS))
        for kind in ERRORS.values():
            self.assertTrue(issubclass(kind, topple.ToppleError))
        self.assertTrue(issubclass(topple.BadInput, ValueError))
        self.assertTrue(issubclass(topple.SystemFailed, OSError))

    def test_files(self):
        """A file that is not there, or may not be read or written, is what Python calls so, whichever call names it and
        whichever file names it in turn; the message stays."""
        with tempfile.TemporaryDirectory() as folder:
            missing = pathlib.Path(folder) / "no: thing.yaml"
            scene = pathlib.Path(folder) / "scene.yaml"
            outline = pathlib.Path(folder) / "outline.csv"
            scene.write_text("topple: 1\nlength_unit: m\nblock: {outline: outline.csv}\n", encoding="utf-8")
            drawing = topple.Scene("mm", outline=SQUARE, friction_angle_deg=30).solve().write_figure
            for call, name in ((lambda: topple.Scene.read(missing), missing), (lambda: topple.Scene.read(scene), outline),
                               (lambda: topple.study(missing), missing), (lambda: topple.verify(missing), missing),
                               (lambda: topple.profile_of_file(missing, "m"), missing),
                               (lambda: topple.Scene.read_with(missing.with_suffix(".dxf"), unit="m"), missing.with_suffix(".dxf")),
                               (lambda: topple.Scene.read_with(missing.with_suffix(".stl"), "section.at.1=0", "section.at.2=0", "section.azimuth_deg=0",
                                                               unit="m"), missing.with_suffix(".stl")),
                               (lambda: drawing(missing / "figure.svg"), missing / "figure.svg")):
                with self.subTest(name=name), self.assertRaises(FileNotFoundError) as caught:
                    call()
                error = pickle.loads(pickle.dumps(caught.exception))
                self.assertIsInstance(error, topple.SystemFailed)
                self.assertEqual((error.errno, error.filename, error.strerror), (errno.ENOENT, str(name), os.strerror(errno.ENOENT)))
                self.assertIn(": cannot be ", str(error))
            outline.write_text("0,0\n1,0\n1,2\n", encoding="utf-8")
            outline.chmod(0)
            if not os.access(outline, os.R_OK):  # who may do all may read it
                with self.assertRaises(PermissionError) as caught:
                    topple.Scene.read(scene)
                self.assertEqual((caught.exception.errno, caught.exception.filename), (errno.EACCES, str(outline)))
        refused = topple.errors.failure(lib.TP_SYSTEM_FAILED, ffi.new("tp_message *", {"text": b"a.csv: cannot be read: Permission denied", "file": b"a.csv",
                                                                                    "system_error": errno.EACCES}))
        self.assertIsInstance(refused, topple.PermissionDenied)
        self.assertIsInstance(refused, PermissionError)
        self.assertIsNone(topple.SystemFailed("gnuplot, which draws charts, is not installed").errno)

    def test_kinds_of_wrong_input(self):
        """Every wrong scene says which kind of input is wrong; none of them is the caller's mistake."""
        faults = {}
        for path in sorted((ROOT / "tests/bad").glob("*.yaml")):
            try:
                topple.Scene.read(path).solve()
            except topple.BadInput as error:
                faults.setdefault(error.fault.value, []).append(path.name)
                self.assertEqual(pickle.loads(pickle.dumps(error)).fault, error.fault)
            except topple.ToppleError:
                pass
        self.assertEqual(set(faults), {"format", "key", "unit", "range", "geometry"}, faults)

    def test_messages(self):
        """What, where and what to do; the scene stays as it was."""
        scene = topple.Scene("mm", outline=SQUARE, friction_angle_deg=30)
        meant = said(scene)
        with self.assertRaisesRegex(topple.BadInput, r"^tp_scene_set_friction_angle_deg: angle_deg must lie in \[0°, 90°\)"):
            scene.set_friction_angle_deg(90)
        with self.assertRaisesRegex(topple.BadInput, "y of point 3 of outline must be a finite number"):
            scene.set_outline([(0, 0), (1, 0), (1, math.nan)])
        self.assertEqual(said(scene), meant)
        with self.assertRaisesRegex(ValueError, "'left'.*'right'.*'both'"):
            scene.set_tilt_towards("up")
        with self.assertRaisesRegex(OSError, "^/nowhere.yaml: cannot be opened: No such file"):
            topple.Scene.read("/nowhere.yaml")
        with self.assertRaises(topple.SystemFailed):
            scene.solve().write_figure("/nowhere/figure.svg")
        with self.assertRaisesRegex(topple.BadInput, "^here:2"):
            topple.Scene.from_text("topple: 1\nnonsense: 2\n", "here")
        with self.assertRaisesRegex(topple.BadInput, "parameters"):
            topple.derive(scene)
        self.assertRaises(topple.BadInput, topple.Scene.read(ROOT / "examples" / "slab.yaml").set_title, "x")
        self.assertRaises(topple.BadInput, scene.solve, digits=0)

    def test_cautions(self):
        """Issued as warnings, from the line that solves; notes are not."""
        scene = topple.Scene("mm", slab=("1e12", 1))
        with self.assertWarns(topple.Caution) as caught:
            solution = scene.solve()
        self.assertEqual(caught.filename, __file__)
        self.assertIn(topple.NoteKind.CAUTION, {note.kind for note in solution.notes})
        self.assertIn(solution.notes[0].text.splitlines()[0], str(caught.warning))


class Threads(unittest.TestCase):
    def test_one_scene_in_eight(self):
        scene = topple.Scene("mm", outline=BLOCK, friction_angle_deg=30, tilt_angle_deg=10)
        meant, found = said(scene), []
        threads = [threading.Thread(target=lambda: found.extend(said(scene) for _ in range(20))) for _ in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, [meant] * 160)

    def test_others_run_meanwhile(self):
        """While a long solve runs, Python goes on, and the scene cannot be changed."""
        x = numpy.arange(1500)
        under = numpy.column_stack([x, 0.01 * (x * 7919 % 101)])
        scene = topple.Scene("mm", outline=numpy.vstack([under, [(1499, 300), (0, 300)]]), friction_angle_deg=30)
        thread = threading.Thread(target=scene.solve)
        thread.start()
        refused = 0
        while thread.is_alive():
            try:
                scene.set_title("another")
            except RuntimeError:
                refused += 1
        thread.join()
        self.assertGreater(refused, 10)
        scene.set_title("another")

    @unittest.skipUnless(pathlib.Path("/proc/self/statm").exists(), "needs /proc")
    def test_memory_is_flat(self):
        """Scenes, solutions and failures are given back; the owner stays as long as a part of it is held."""
        angles = set()

        def work(times):
            for _ in range(times):
                scene = topple.Scene("mm", outline=BLOCK, friction_angle_deg="30", tilt_angle_deg=10)
                held = scene.solve().cases[0].limit
                with self.assertRaises(topple.BadInput):
                    scene.set_thickness(-1)
                del scene
                angles.add(held.critical_angle_deg.value)

        def pages():
            gc.collect()
            return int(pathlib.Path("/proc/self/statm").read_text().split()[1])

        work(300)
        before = pages()
        work(2000)
        self.assertLess(pages() - before, 300)  # 1.2 MB; a solution alone has 20 kB
        self.assertEqual(len(angles), 1)


class Reports(unittest.TestCase):
    def test_sheets(self):
        """The sheets of the program, of a solution, a study and a tilt test, but for where the elements are called for."""
        told = {"date": "2023-11-14 22:13 UTC", "times": False}
        scene, study, tilt = (str(ROOT / "examples" / name) for name in (
            "block_e_valley.yaml", "studies/slab_study.yaml", "tilt_block_f.yaml"))
        tilted = topple.Scene.read(tilt)
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            topple.Scene.read(scene).solve(elements=True).write_report(folder / "solve.md", **told)
            topple.study(study).write_report(folder / "study.md", study, **told)
            topple.tilt_test(tilted).write_report(folder / "tilt.md", tilted, **told)
            for command, path in (("solve", scene), ("study", study), ("tilt", tilt)):
                subprocess.run([BUILD / "topple", command, path, "--report", folder / "own.md"], check=True,
                               stdout=subprocess.DEVNULL, env={**os.environ, "SOURCE_DATE_EPOCH": "1700000000"})
                self.assertEqual((folder / "own.md").read_text(encoding="utf-8"),
                                 (folder / f"{command}.md").read_text(encoding="utf-8"), command)
            self.assertRaises(topple.BadInput, topple.Scene.read(scene).solve().write_report, folder / "own.txt")


class Figures(unittest.TestCase):
    def test_svg(self):
        """The drawing of the program; a scene that was changed is not drawn."""
        path = ROOT / "examples" / "block_e_valley.yaml"
        solution = topple.Scene.read(path).solve()
        svg = solution._repr_svg_()
        self.assertEqual(xml.dom.minidom.parseString(svg).documentElement.tagName, "svg")
        with tempfile.TemporaryDirectory() as folder:
            run("solve", "--figure", f"{folder}/own.svg", path)
            drawn = pathlib.Path(folder, "own.svg").read_text(encoding="utf-8")
            self.assertEqual(svg, drawn)
            solution.write_figure(pathlib.Path(folder, "own.png"))
            self.assertEqual(pathlib.Path(folder, "own.png").read_bytes()[1:4], b"PNG")
            self.assertRaises(topple.BadInput, solution.write_figure, pathlib.Path(folder, "own.txt"))
        scene = topple.Scene("mm", outline=SQUARE, friction_angle_deg=30)
        solved = scene.solve()
        scene.set_friction_angle_deg(20)
        with self.assertRaisesRegex(topple.BadInput, "solve it again"):
            solved.svg()

    def test_without_the_library(self):
        """Without libtopple-figure all else works, and a figure says what is missing."""
        program = "import sys, topple; sys.modules['topple._figure'] = None\n" \
                  "s = topple.Scene('mm', slab=(5, 10)).solve()\n" \
                  "try: s.svg()\nexcept topple.DependencyFailed as error: print(error)"
        done = subprocess.run([sys.executable, "-c", program], check=True, capture_output=True, encoding="utf-8",
                              env={"PYTHONPATH": str(BUILD / "python")})
        self.assertIn("libtopple-figure", done.stdout)


if __name__ == "__main__":
    main()
