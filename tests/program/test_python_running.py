# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Long calls in Python: ctrl-C ends them at once and what was known is kept; they say how far they are. Scenes and results go
to other processes; their words have an order, so that tables of pandas sort and group by them."""

import copy
import multiprocessing
import os
import pathlib
import pickle
import shutil
import signal
import subprocess
import tempfile
import threading
import time
import unittest
import warnings

from harness import PROGRAM, ROOT, main
from python_case import SQUARE, numpy, said, topple

STUDY = """
topple_study: 1
scene: block_e_valley.yaml
samples: 3000000
sampling: {method: monte_carlo, seed: 1, chunk: 50}
vary:
  friction_angle_deg: {uniform: {low: 25, high: 45}}
"""
BUILD = pathlib.Path(os.environ.get("TOPPLE_BUILD", pathlib.Path(PROGRAM).parent))
NAME = str(ROOT / "examples" / "study")
SHAKEN = ROOT / "examples" / "shaken_boulder.yaml"


def interrupt(after, marks):
    """Ctrl-C in some seconds."""
    def press():
        time.sleep(after)
        marks.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    threading.Thread(target=press, daemon=True).start()


def first_angle(scene):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", topple.Caution)
        return scene.solve().cases[0].first_angle_deg


class Stopped(unittest.TestCase):
    def test_interrupted(self):
        """Ctrl-C raises a KeyboardInterrupt that has the samples so far. It takes a moment, not the minutes of the study; a machine
        under load may take longer than the tenth of a second that is the aim, so a study that does not listen is what fails."""
        marks = []
        interrupt(0.5, marks)
        with self.assertRaises(KeyboardInterrupt) as caught:
            topple.study_text(STUDY, NAME)
        self.assertLess(time.monotonic() - marks[0], 5)
        result = caught.exception.result
        self.assertIs(result.end, topple.StudyEnd.INTERRUPTED)
        self.assertGreater(result.samples, 0)
        self.assertLess(result.samples, result.planned)
        self.assertEqual(len(result.columns["friction_angle_deg"]), result.kept)

    def test_stop_and_progress(self):
        """`stop` ends the study with a result; `progress` counts up to what is planned. What either raises is raised."""
        counts = []
        result = topple.study_text(STUDY, NAME, stop=lambda: len(counts) > 2, progress=lambda done, of: counts.append((done, of)))
        self.assertIs(result.end, topple.StudyEnd.INTERRUPTED)
        self.assertEqual(counts, sorted(counts))
        self.assertEqual({of for _, of in counts}, {3000000})
        self.assertGreaterEqual(result.samples, counts[-1][0])
        with self.assertRaisesRegex(ZeroDivisionError, "by zero"):
            topple.study_text(STUDY, NAME, progress=lambda done, of: 1 / 0)

    def test_rows_as_hdf5(self):
        """By the name of the rows: what h5py reads of them are the columns of the result, and the program makes the same file.
        A shard has CSV alone."""
        try:
            import h5py
        except ImportError:
            self.skipTest("python3-h5py is not installed")
        if not (BUILD / "libtopple-hdf5.so").exists():
            self.skipTest("Topple was built without HDF5")
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            shutil.copy(ROOT / "examples" / "block_e_valley.yaml", folder)
            study = folder / "study.yaml"
            study.write_text(STUDY.replace("3000000", "400"))
            result = topple.study(study, rows=folder / "rows.h5")
            with h5py.File(folder / "rows.h5") as file:
                self.assertEqual(file.attrs["samples"], 400)
                for column in ("friction_angle_deg", "limit_deg", "fos"):
                    numpy.testing.assert_array_equal(file[column][:], result.columns[column])
            subprocess.run([PROGRAM, "study", study.name, "--rows", "other.h5"], cwd=folder, check=True, capture_output=True)
            with h5py.File(folder / "rows.h5") as one, h5py.File(folder / "other.h5") as other:
                for column in one:
                    if column != "files":
                        numpy.testing.assert_array_equal(one[column][:], other[column][:], column)
            with self.assertRaises(topple.BadInput):
                topple.study(study, rows=folder / "part.h5", shard=(1, 2))

    def test_the_same_samples(self):
        """What was interrupted has the first samples of the whole."""
        text = STUDY.replace("3000000", "200")
        whole = topple.study_text(text, NAME).columns["onset_deg"]
        done = [0]
        part = topple.study_text(STUDY, NAME, progress=lambda samples, of: done.append(samples),
                                 stop=lambda: done[-1] > 0).columns["onset_deg"]
        count = min(len(whole), len(part))
        self.assertGreater(count, 0)
        numpy.testing.assert_array_equal(whole[:count], part[:count])

    def test_simulations(self):
        """A scan of overturning, a test and a sweep end, too."""
        scene = topple.Scene.read(SHAKEN)
        marks = []
        interrupt(0.3, marks)
        with self.assertRaises(KeyboardInterrupt):
            topple.chart_overturning(scene, count=200, tolerance=1e-6)
        block = topple.Scene.read(ROOT / "examples" / "block_e_valley.yaml")
        part = topple.sweep(block, "friction_angle_deg=20:60:0.001", stop=lambda: True)
        self.assertLess(len(part), 40001)

    def test_left(self):
        """A map cannot be asked to stop: it is left to end by itself, and the scene is in use until then."""
        scene = topple.Scene.read(ROOT / "examples" / "slab_left.yaml")
        marks = []
        interrupt(0.2, marks)
        with self.assertRaises(KeyboardInterrupt):
            for _ in range(1000):
                topple.chart_map(scene, ("block.slab.width", 10, 150), ("friction_angle_deg", 10, 50))


class Copies(unittest.TestCase):
    def scenes(self):
        """Made in every way that there is, and changed after that."""
        built = topple.Scene("mm", outline=numpy.array(SQUARE, dtype=float), friction_angle_deg="33.3", tilt_angle_deg=12,
                             unit_weight_kn_m3=26)
        built.set_number("loads.cohesion_kpa", "1/3")
        built.set_thickness(2)
        read = topple.Scene.read(ROOT / "examples" / "block_e_valley.yaml")
        return {"built": built, "read": read, "varied": read.varied({"a": "100/3"}), "set": read.with_settings("b=4*a+1/7"),
                "varied, changed": built.varied({"friction_angle_deg": 20}),
                "drawing": topple.Scene.read_with(ROOT / "examples" / "block_e_valley.wkt", "friction_angle_deg=30", unit="mm"),
                "text": topple.Scene.from_text((ROOT / "examples" / "slab.yaml").read_text(encoding="utf-8"), "slab")}

    def test_same_scene(self):
        """A copy says the same, and is one by itself: a change of it leaves the other."""
        for name, scene in self.scenes().items():
            with self.subTest(name):
                for other in (copy.copy(scene), copy.deepcopy(scene), pickle.loads(pickle.dumps(scene))):
                    self.assertEqual(said(other), said(scene))
        built = self.scenes()["built"]
        other = copy.copy(built)
        other.set_thickness(5)
        self.assertEqual(built.number("block.thickness"), 2)
        self.assertEqual(pickle.loads(pickle.dumps(other)).number("block.thickness"), 5)

    def test_other_process(self):
        """A pool solves scenes, and results come back."""
        scenes = list(self.scenes().values())
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            for scene, angle in zip(scenes, pool.map(first_angle, scenes)):
                self.assertEqual(angle, first_angle(scene))

    def test_cleanup(self):
        """Memory that a thread leaves is given back, and results stay."""
        from topple._library import lib

        solution = topple.Scene("mm", slab=(50, 100), friction_angle_deg=30).solve(digits=50)
        before = solution.to_json()
        lib.tp_cleanup()
        self.assertEqual(solution.to_json(), before)


class Tables(unittest.TestCase):
    def test_order_of_words(self):
        """Words have the order of C, and none with words of another set."""
        self.assertEqual(sorted(reversed(topple.Mechanism)), list(topple.Mechanism))
        with self.assertRaises(TypeError):
            topple.Mechanism.TOPPLES < topple.Direction.LEFT

    def test_pandas(self):
        """Rows of a study and of a sweep, and verdicts, as tables that sort and group by outcomes."""
        try:
            import pandas
        except ImportError:
            self.skipTest("pandas is not installed")
        table = topple.study_text(STUDY.replace("3000000", "300"), NAME).to_dataframe()
        self.assertEqual(len(table), 300)
        outcome = next(name for name in table if isinstance(table[name].iloc[0], topple.StudyOutcome))
        groups = table.groupby(outcome)["friction_angle_deg"].count()
        self.assertEqual(groups.sum(), 300)
        self.assertEqual(list(groups.index), sorted(groups.index))
        self.assertTrue(table.sort_values(outcome)[outcome].is_monotonic_increasing)
        blocks = topple.verdicts([numpy.array(SQUARE, dtype=float)] * 3, 30, numpy.array([10.0, 20.0, 40.0])).to_dataframe()
        self.assertEqual(list(blocks["mechanism"]), sorted(blocks["mechanism"], key=list(blocks["mechanism"]).index))
        own = topple.sweep(topple.Scene.read(ROOT / "examples" / "block_e_valley.yaml"), "friction_angle_deg=20:40:10").to_dataframe()
        self.assertEqual(list(own["friction_angle_deg"]), [20, 30, 40])
        self.assertIsInstance(own, pandas.DataFrame)

    def test_xarray(self):
        """A sweep over two numbers is a grid."""
        try:
            import xarray  # noqa: F401
        except ImportError:
            self.skipTest("xarray is not installed")
        scene = topple.Scene.read(ROOT / "examples" / "block_e_valley.yaml")
        grid = topple.sweep(scene, "friction_angle_deg=20:40:10", "c=2.5,5").to_xarray()
        self.assertEqual(dict(grid.sizes), {"friction_angle_deg": 3, "c_mm": 2, "towards": 1})
        self.assertEqual(float(grid["limit_deg"].sel(friction_angle_deg=30, c_mm=5, towards="left")),
                         float(scene.solve().cases[0].limit.critical_angle_deg))


if __name__ == "__main__":
    main()
