# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The rows of a study as HDF5, read by h5py: value by value those of the CSV, with units, the texts of all files that the
study rests on, and the version; the same bytes by ranks, shards and after kills; whole or not at all where the disk is
full, and a word on what to install where there is no HDF5."""

import ctypes.util
import math
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import time
import unittest

from harness import PROGRAM, main, rounds
from study_case import StudyCase

try:
    import h5py
except ImportError:
    h5py = None

BUILD = pathlib.Path(os.environ.get("TOPPLE_BUILD", pathlib.Path(PROGRAM).parent))
LIBRARY = BUILD / "libtopple-hdf5.so"
STUDY = """title: Slabs of Höhe h
samples: 9000
sampling: {chunk: 300}
vary:
  friction_angle_deg: {normal: {mean: 30, deviation: 2}}
  block.slab.height: {uniform: {low: -0.1, high: 4}}
  block.slab.width: {empirical: 'widths.csv:w'}
tilts_deg: [20, 30]
"""


class Hdf5(StudyCase):
    def setUp(self):
        super().setUp()
        if not LIBRARY.exists():
            self.skipTest("Topple was built without HDF5")
        (self.folder / "widths.csv").write_text("w\n1.5\n2\n2.5\n")
        self.write(STUDY)

    def read(self, name):
        return (self.folder / name).read_bytes()

    @unittest.skipIf(h5py is None, "python3-h5py is not installed")
    def test_what_it_holds(self):
        """More rows than a block has: what HDF5's own library reads is what the CSV says, in type, value and unit."""
        summary = self.study("study.yaml", "--rows", "rows.h5")
        self.assertEqual(self.study("study.yaml", "--rows", "rows.csv"), summary)
        rows = self.rows()
        self.assertEqual(self.read("rows.h5.csv"), self.read("rows.csv"))
        with h5py.File(self.folder / "rows.h5") as file:
            self.assertEqual(set(file), {*rows[0], "files"})
            for name in rows[0]:
                column = file[name]
                self.assertEqual((column.shape, column.compression), ((9000,), "gzip"), name)
                self.assertLess(column.chunks[0], 9000)
                for got, row in zip(column[:], rows):
                    said = row[name]
                    if column.dtype.kind == "f":
                        self.assertTrue(math.isnan(got) if said == "" else got == float(said), (name, got, said))
                    else:
                        self.assertEqual(int(said) if name == "sample" else said, got if name == "sample" else got.decode())
            units = {name: file[name].attrs["unit"] for name in rows[0] if "unit" in file[name].attrs}
            self.assertEqual(units, {"friction_angle_deg": "deg", "block.slab.height_m": "m", "block.slab.width_m": "m",
                                     "moments_deg": "deg", "pivot_x_m": "m", "pivot_y_m": "m", "onset_deg": "deg",
                                     "limit_deg": "deg"})
            said = dict(file.attrs)
            version = subprocess.run([PROGRAM, "--version"], capture_output=True, encoding="utf-8", check=True).stdout.split()[-1]
            self.assertEqual(said, {"topple": version, "planned": 9000, "samples": 9000, "study_file": "study.yaml",
                                    "study": self.read("study.yaml").decode(), "scene_file": "slab.yaml",
                                    "scene": self.read("slab.yaml").decode()})
            self.assertEqual(dict(file["files"].attrs), {"widths.csv": self.read("widths.csv").decode()})

    def test_the_same_bytes(self):
        """Twice, by shards merged, by ranks; with the rows that are there, and after they were begun anew."""
        self.study("study.yaml", "--rows", "rows.h5")
        whole = self.read("rows.h5")
        self.study("study.yaml", "--rows", "rows.h5")
        self.assertEqual(self.read("rows.h5"), whole)
        (self.folder / "rows.h5").write_bytes(b"old")
        self.assertIn("is not the rows of a study", self.study("study.yaml", "--rows", "rows.h5", "--restart", status=3))
        (self.folder / "rows.h5").write_bytes(whole)
        self.study("study.yaml", "--rows", "rows.h5", "--restart", "--threads", "2")
        self.assertEqual(self.read("rows.h5"), whole)
        for k in (1, 2):
            self.study("study.yaml", "--shard", f"{k}/2", "--rows", f"{k}.csv")
        self.study("study.yaml", "--merge", "1.csv", "2.csv", "--rows", "merged.HDF5")
        self.assertEqual(self.read("merged.HDF5"), whole)
        if (BUILD / "libtopple-ranks.so").exists() and shutil.which("mpirun"):
            allowed = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                       "OMPI_MCA_rmaps_base_oversubscribe": "1"}
            # of three one has no rows; of the long study each has several shares, which begin within chunks of it
            for samples in rounds((9000,), (9000, 250000)):
                self.write(STUDY.replace("9000", str(samples)))
                self.study("study.yaml", "--rows", "rows.h5", "--restart")
                subprocess.run(["mpirun", "-n", "3", PROGRAM, "study", "study.yaml", "--rows", "ranks.h5", "--restart"],
                               cwd=self.folder, env={**os.environ, **allowed}, capture_output=True, check=True)
                self.assertEqual(self.read("ranks.h5"), self.read("rows.h5"))
            self.assertEqual({path.name for path in self.folder.glob("ranks*")},
                             {"ranks.h5", "ranks.h5.csv", "ranks.h5.csv.progress"})

    def test_interrupted(self):
        """Killed and interrupted there is no such file, and the same command makes it."""
        self.study("study.yaml", "--rows", "rows.h5")
        for number in (signal.SIGKILL, signal.SIGINT):
            with subprocess.Popen([PROGRAM, "study", "study.yaml", "--rows", "killed.h5"], cwd=self.folder,
                                  stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, encoding="utf-8",
                                  preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL)) as process:
                progress = self.folder / "killed.h5.csv.progress"
                while not progress.exists() or "chunks: 0\n" in progress.read_text():
                    time.sleep(0.001)
                process.send_signal(number)
                err = process.stderr.read()
            self.assertEqual(process.returncode, -number)
            self.assertEqual("the rows so far are in 'killed.h5.csv'" in err, number == signal.SIGINT)
            self.assertFalse((self.folder / "killed.h5").exists())
            self.study("study.yaml", "--rows", "killed.h5")
            self.assertEqual(self.read("killed.h5"), self.read("rows.h5"))
            for name in ("killed.h5", "killed.h5.csv", "killed.h5.csv.progress"):
                (self.folder / name).unlink()

    def test_disk_full(self):
        """Room for the CSV, not for the HDF5 beside it on a small disk: status 5 and why; nothing half made; then whole."""
        self.study("study.yaml", "--rows", "rows.h5")
        whole = self.read("rows.h5")

        def little_room():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (len(whole) // 2, len(whole) // 2))

        for before in (whole, None):
            if before is None:
                (self.folder / "rows.h5").unlink()
            done = subprocess.run([PROGRAM, "study", "study.yaml", "--rows", "rows.h5"], cwd=self.folder,
                                  capture_output=True, encoding="utf-8", preexec_fn=little_room, check=False)
            self.assertEqual((done.returncode, done.stdout), (5, ""))
            self.assertEqual(done.stderr, "topple: rows.h5: cannot be written: File too large; the rows stay in 'rows.h5.csv', "
                                          "and the same command makes this file of them\n")
            self.assertEqual(self.read("rows.h5") if before else None, before)
            self.assertEqual(list(self.folder.glob("*.part")), [])
        self.study("study.yaml", "--rows", "rows.h5")
        self.assertEqual(self.read("rows.h5"), whole)

    def test_refused(self):
        """Before a sample is solved: files of others, and what HDF5 cannot be written to."""
        def refused(says, *words, status=3):
            before = {path: path.read_bytes() for path in self.folder.iterdir() if path.is_file()}
            self.assertIn(says, self.study("study.yaml", *words, status=status))
            self.assertEqual({path: path.read_bytes() for path in self.folder.iterdir() if path.is_file()}, before)

        (self.folder / "mine.h5").write_text("precious\n")
        (self.folder / "link.h5").symlink_to("slab.yaml")
        (self.folder / "folder.h5").mkdir()
        refused("this file is there", "--rows", "mine.h5")
        refused("a file that the study reads", "--rows", "link.h5", "--restart")
        refused("a separate file", "--rows", "folder.h5", "--restart")
        refused("a shard writes CSV", "--rows", "rows.h5", "--shard", "1/2", status=2)
        self.study("study.yaml", "--rows", "rows.h5")
        self.write(STUDY.replace("mean: 30", "mean: 31"))
        refused("changed since", "--rows", "rows.h5")

    def test_without_the_library(self):
        """A program alone says what to install, before it begins."""
        alone = self.folder / "alone"
        alone.mkdir()
        shutil.copy(PROGRAM, alone)
        if ctypes.util.find_library("topple-hdf5"):
            self.skipTest("another Topple is installed here")
        done = subprocess.run([alone / "topple", "study", "study.yaml", "--rows", "rows.h5"], cwd=self.folder,
                              capture_output=True, encoding="utf-8", check=False)
        self.assertEqual((done.returncode, done.stdout), (5, ""))
        self.assertIn("'./run --with hdf5'", done.stderr)
        self.assertEqual(list(self.folder.glob("rows*")), [])
        maps = subprocess.run(["ldd", PROGRAM], capture_output=True, encoding="utf-8", check=True).stdout
        self.assertNotIn("hdf5", maps)


if __name__ == "__main__":
    main()
