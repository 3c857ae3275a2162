# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A study by the ranks of mpirun: the rows and the summary of one process, to the byte; so after a rank was killed; and one
complaint where one of them fails. Without mpirun, no MPI is loaded."""

import os
import pathlib
import shutil
import subprocess
import sys
import time

from harness import PROGRAM, main
from study_case import StudyCase

BUILD = pathlib.Path(os.environ.get("TOPPLE_BUILD", pathlib.Path(PROGRAM).parent))
# What mpirun asks of those who are root, or have fewer cores than ranks.
ALLOWED = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1"}
STUDY = """samples: 230
sampling: {chunk: 20}
vary:
  friction_angle_deg: {normal: {mean: 30, deviation: 2}}
  block.slab.height: {list: [1, 2, -1]}
tilts_deg: [28, 30]
"""
RELIABILITY = """samples: 100
sampling: {chunk: 10}
vary: {friction_angle_deg: {normal: {mean: 30, deviation: 2}}}
reliability: {quantity: limit_deg}
"""


class Ranks(StudyCase):
    def setUp(self):
        super().setUp()
        self.write(STUDY)
        self.temporary = self.folder / "temporary"
        self.temporary.mkdir()

    def begin(self, ranks, *words, program=PROGRAM):
        return subprocess.Popen(["mpirun", "-n", str(ranks), program, *words], cwd=self.folder, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, encoding="utf-8",
                                env={**os.environ, **ALLOWED, "TMPDIR": str(self.temporary)})

    def mpirun(self, ranks, *words, status=0, program=PROGRAM):
        with self.begin(ranks, *words, program=program) as process:
            out, err = process.communicate(timeout=300)
        self.assertEqual(process.returncode, status, err)
        return err if status else out

    def by_ranks(self, ranks, *words, **more):
        return self.mpirun(ranks, "study", "study.yaml", "--threads", "1", "--json", *words, **more)

    def read(self, name):
        return (self.folder / name).read_bytes()

    def complaint(self, err):
        """What Topple says of all that mpirun does."""
        (line,) = [line for line in err.splitlines() if line.startswith("topple: ")]
        return line

    def check(self, ranks, whole):
        """Rows and summary as of one process, and no file is left."""
        self.assertEqual(self.by_ranks(ranks, "--csv", "ranks.csv"), whole)
        self.assertEqual(self.read("ranks.csv"), self.read("one.csv"))
        left = {path.name for path in self.folder.iterdir()}
        self.assertEqual({name for name in left if name.startswith("ranks")}, {"ranks.csv", "ranks.csv.progress"})
        self.assertEqual([path for path in self.temporary.iterdir() if path.name.startswith("topple")], [])

    def test_the_bytes_of_one_process(self):
        """1, 2 and 3 ranks, with rows and without; samples that are none, and reliability, which the first rank does."""
        for study in (RELIABILITY, STUDY):
            self.write(study)
            whole = self.study("study.yaml", "--json", "--csv", "one.csv", "--restart")
            text = self.study("study.yaml")
            for ranks in (1, 2, 3):
                self.check(ranks, whole)
                self.assertEqual(self.by_ranks(ranks), whole)
                self.check(ranks, whole)  # the rows are there
                (self.folder / "ranks.csv").unlink()
                (self.folder / "ranks.csv.progress").unlink()
        self.assertEqual(self.mpirun(2, "study", "study.yaml", "--threads", "2"), text)

    def test_more_ranks_than_chunks(self):
        """And a study that ends where it is certain: one process stops there, ranks find where it would have."""
        for more in ("sampling: {chunk: 150}\n", "until: {half_width: 0.1}\n"):
            self.write("samples: 230\nvary: {friction_angle_deg: {normal: {mean: 25, deviation: 2}}}\n" + more)
            whole = self.study("study.yaml", "--json", "--csv", "one.csv", "--restart")
            self.assertEqual(self.by_ranks(3, "--csv", "ranks.csv", "--restart"), whole)
            self.check(3, whole)

    def test_after_a_rank_was_killed(self):
        """Rows of each part are there, then one rank dies; the same command goes on. So it does where the merging was cut
        off, and from rows that one process began."""
        self.write("samples: 20000\nsampling: {chunk: 50}\nvary: {friction_angle_deg: {normal: {mean: 25, deviation: 2}}}\n")
        with self.begin(2, "study", "study.yaml", "--threads", "1", "--csv", "ranks.csv") as process:
            progress = self.folder / "ranks.csv.part2"
            until = time.monotonic() + 60
            while not progress.exists() or progress.stat().st_size < 5000:
                self.assertIsNone(process.poll())
                self.assertLess(time.monotonic(), until)
                time.sleep(0.01)
            (child, *_) = map(int, pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split())
            os.kill(child, 9)
            process.communicate(timeout=60)
        self.assertNotEqual(process.returncode, 0)
        before = progress.stat().st_mtime_ns, progress.read_bytes()
        whole = self.study("study.yaml", "--json", "--csv", "one.csv")
        lines = self.read("one.csv").splitlines(keepends=True)
        self.assertIn(before[1].splitlines(keepends=True)[1], lines[10001:])
        self.assertIn(b"".join(before[1].splitlines(keepends=True)[1:51]), self.read("one.csv"))
        self.check(2, whole)
        for part in (1, 2):
            self.study("study.yaml", "--shard", f"{part}/2", "--csv", f"ranks.csv.part{part}")
        self.check(2, whole)

    def test_one_rank_fails(self):
        """It complains, alone; nothing is printed, and the exit status is its own. Then the study goes on."""
        whole = self.study("study.yaml", "--json", "--csv", "one.csv")
        (self.folder / "ranks.csv.part2").write_text("of another one\n")
        err = self.by_ranks(2, "--csv", "ranks.csv", status=3)
        self.assertIn("ranks.csv.part2: this file is there", self.complaint(err))
        self.assertEqual(self.read("ranks.csv.part2"), b"of another one\n")
        (self.folder / "ranks.csv.part2").unlink()
        self.check(2, whole)
        (self.folder / "full.csv").symlink_to("/dev/full")
        self.assertIn("cannot be written", self.complaint(self.by_ranks(2, "--csv", "full.csv", status=5)))

    def test_all_fail(self):
        """Of what each one finds, the first tells: a study that is none, a file that is no rows, parts of other ranks."""
        self.assertIn("none.yaml", self.complaint(self.mpirun(3, "study", "none.yaml", status=5)))
        err = self.by_ranks(3, "--csv", "slab.yaml", status=3)
        self.assertIn("a file that the study reads", self.complaint(err))
        self.study("study.yaml", "--shard", "1/2", "--csv", "ranks.csv.part1")
        self.assertIn("shard 1 of 2; restart", self.complaint(self.by_ranks(3, "--csv", "ranks.csv", status=3)))

    def test_shards_are_left_alone(self):
        """Under mpirun a script may as well share a study out by itself."""
        self.mpirun(2, "-c", f'"{PROGRAM}" study study.yaml --shard $((OMPI_COMM_WORLD_RANK + 1))/2 '
                    "--csv part$OMPI_COMM_WORLD_RANK.csv", program="sh")
        self.study("study.yaml", "--csv", "one.csv")
        self.study("study.yaml", "--merge", "part0.csv", "part1.csv", "--csv", "rows.csv")
        self.assertEqual(self.read("rows.csv"), self.read("one.csv"))

    def test_without_the_library_of_ranks(self):
        """A program that has none says so, once, and does not run the study twice."""
        shutil.copy(PROGRAM, self.folder / "topple")
        err = self.by_ranks(2, program=self.folder / "topple", status=5)
        self.assertIn("libtopple-ranks.so", self.complaint(err))
        self.assertIn("--shard", self.complaint(err))

    def test_one_process_loads_no_mpi(self):
        done = subprocess.run([PROGRAM, "study", "study.yaml"], cwd=self.folder, env={**os.environ, "LD_DEBUG": "files"},
                              capture_output=True, encoding="utf-8", check=True)
        self.assertIn("libgmp", done.stderr)
        self.assertNotIn("libmpi", done.stderr)


if __name__ == "__main__":
    if not (BUILD / "libtopple-ranks.so").exists() or shutil.which("mpirun") is None:
        print("skipped: Topple was built without MPI, or there is no mpirun (apt-get install libopenmpi-dev openmpi-bin)")
        sys.exit(77)
    main()
