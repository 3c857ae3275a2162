# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A study by the ranks of mpirun: the rows and the summary of one process, to the byte; so after a rank was killed, by any
number of ranks; an early end for all; and one complaint where one of them fails. Without mpirun, no MPI is loaded."""

import os
import pathlib
import shutil
import signal
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
SENSITIVITY = """samples: 90
sampling: {chunk: 10}
vary:
  friction_angle_deg: {normal: {mean: 30, deviation: 2}}
  block.slab.height: {uniform: {low: 3, high: 12}}
sensitivity: {samples: 1500}
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
        self.assertEqual(self.read("ranks.csv.progress"), self.read("one.csv.progress"))
        self.assertEqual([path for path in self.temporary.iterdir() if path.name.startswith("topple")], [])

    def test_the_bytes_of_one_process(self):
        """1, 2, 3 and 5 ranks, with rows and without; samples that are none, and indices and reliability, of which the first
        rank shares out the points."""
        for study in (RELIABILITY, SENSITIVITY, STUDY):
            self.write(study)
            whole = self.study("study.yaml", "--json", "--csv", "one.csv", "--restart")
            text = self.study("study.yaml")
            for ranks in (1, 2, 3, 5):
                self.check(ranks, whole)
                self.assertEqual(self.by_ranks(ranks), whole)
                self.check(ranks, whole)  # the rows are there
                (self.folder / "ranks.csv").unlink()
                (self.folder / "ranks.csv.progress").unlink()
        self.assertEqual(self.mpirun(2, "study", "study.yaml", "--threads", "2"), text)

    def test_more_ranks_than_chunks(self):
        """And a study that ends where it is certain: one process stops there, and all ranks after the same chunk."""
        for more in ("sampling: {chunk: 150}\n", "until: {half_width: 0.1}\n"):
            self.write("samples: 230\nvary: {friction_angle_deg: {normal: {mean: 25, deviation: 2}}}\n" + more)
            whole = self.study("study.yaml", "--json", "--csv", "one.csv", "--restart")
            self.assertEqual(self.by_ranks(3, "--csv", "ranks.csv", "--restart"), whole)
            self.check(3, whole)

    def test_ends_early(self):
        """Of 10^9 samples 600 are enough: no rank goes on, which would take hours."""
        self.write("samples: 1000000000\nuntil: {half_width: 0.04}\n"
                   "vary: {friction_angle_deg: {normal: {mean: 25, deviation: 2}}}\n")
        whole = self.study("study.yaml", "--json", "--csv", "one.csv")
        for ranks in (2, 3, 5):
            self.check(ranks, whole)
            (self.folder / "ranks.csv").unlink()
            (self.folder / "ranks.csv.progress").unlink()
        self.assertIn('"samples": 600', whole)

    def kill_a_rank(self, ranks, chunks):
        """Once the progress tells of so many chunks, the last rank dies by SIGKILL."""
        progress = self.folder / "ranks.csv.progress"
        with self.begin(ranks, "study", "study.yaml", "--threads", "1", "--csv", "ranks.csv") as process:
            until = time.monotonic() + 60
            while not progress.exists() or int(progress.read_text().split("chunks: ")[1].split()[0]) < chunks:
                self.assertIsNone(process.poll())
                self.assertLess(time.monotonic(), until)
                time.sleep(0.01)
            children = pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
            os.kill(int(children[-1]), signal.SIGKILL)
            process.communicate(timeout=60)
        self.assertNotEqual(process.returncode, 0)
        return int(progress.read_text().split("chunks: ")[1].split()[0])

    def test_after_a_rank_was_killed(self):
        """What was complete is there; and as many ranks, more, fewer, or one process go on with it, in turn."""
        self.write("samples: 60000\nsampling: {chunk: 50}\nvary: {friction_angle_deg: {normal: {mean: 25, deviation: 2}}}\n")
        whole = self.study("study.yaml", "--json", "--csv", "one.csv")
        told = 0
        for ranks, chunks in ((2, 1), (3, 200), (2, 500)):
            before, told = told, self.kill_a_rank(ranks, max(chunks, told + 1))
            self.assertGreater(told, before)
            self.assertLess(told, 1200)
            done = b"".join(self.read("one.csv").splitlines(keepends=True)[:1 + 50 * told])
            self.assertTrue(self.read("ranks.csv").startswith(done))
        begun = {name: self.read(name) for name in ("ranks.csv", "ranks.csv.progress")}
        for ranks in (1, 2, 5):
            for name, own in begun.items():
                (self.folder / name).write_bytes(own)
            self.check(ranks, whole)
        for name, own in begun.items():
            (self.folder / name).write_bytes(own)
        self.assertEqual(self.study("study.yaml", "--json", "--csv", "ranks.csv"), whole)
        self.assertEqual(self.read("ranks.csv"), self.read("one.csv"))

    def test_one_rank_fails(self):
        """It cannot write where it has no room, or the rows: one complaint, nothing is printed, and the exit status is its own.
        Then the study goes on, by the other rank alone too."""
        self.write(STUDY.replace("samples: 230", "samples: 6000"))
        whole = self.study("study.yaml", "--json", "--csv", "one.csv")
        limit = len(self.read("one.csv")) // 512 // 2  # of half the file, for the second rank alone
        script = (f'trap "" XFSZ; [ "$OMPI_COMM_WORLD_RANK" = 0 ] || ulimit -f {limit}; '
                  f'exec "{PROGRAM}" study study.yaml --threads 1 --json --csv ranks.csv')
        err = self.mpirun(2, "-c", script, program="sh", status=5)
        self.assertIn("ranks.csv: cannot be written: File too large", self.complaint(err))
        self.assertEqual(self.study("study.yaml", "--json", "--csv", "ranks.csv"), whole)
        self.check(2, whole)
        (self.folder / "full.csv").symlink_to("/dev/full")
        self.assertIn("cannot be written", self.complaint(self.by_ranks(2, "--csv", "full.csv", status=5)))

    def test_all_fail(self):
        """Of what each one finds, the first tells: a study that is none, a file that is no rows, rows of a shard."""
        self.assertIn("none.yaml", self.complaint(self.mpirun(3, "study", "none.yaml", status=5)))
        err = self.by_ranks(3, "--csv", "slab.yaml", status=3)
        self.assertIn("a file that the study reads", self.complaint(err))
        self.study("study.yaml", "--shard", "1/2", "--csv", "ranks.csv")
        before = self.read("ranks.csv"), self.read("ranks.csv.progress")
        self.assertIn("shard 1 of 2; restart", self.complaint(self.by_ranks(3, "--csv", "ranks.csv", status=3)))
        self.assertEqual((self.read("ranks.csv"), self.read("ranks.csv.progress")), before)

    def test_into_a_pipe(self):
        """Which one process alone writes, what the others send it in turn."""
        whole = self.study("study.yaml", "--json", "--csv", "one.csv")
        os.mkfifo(self.folder / "pipe")
        with subprocess.Popen(["cat", "pipe"], cwd=self.folder, stdout=subprocess.PIPE) as reader:
            self.assertEqual(self.by_ranks(3, "--csv", "pipe"), whole)
            self.assertEqual(reader.stdout.read(), self.read("one.csv"))

    def launched(self, ranks, names):
        """Under a launcher that tells its processes of themselves by other names than Open MPI's."""
        told = " ".join(f"{name}={value}" for name, value in names.items())
        return self.mpirun(ranks, "-c", f'exec env -u OMPI_COMM_WORLD_SIZE -u OMPI_COMM_WORLD_RANK {told} '
                           f'"{PROGRAM}" study study.yaml --threads 1 --json', program="sh")

    def test_launchers(self):
        """Slurm's step, PMI's names, PMIx's rank alone, of which MPI tells how many there are; a batch script of Slurm, which
        has a number of tasks and no step, is one process."""
        whole = self.study("study.yaml", "--json")
        rank = "$OMPI_COMM_WORLD_RANK"
        for names in ({"SLURM_STEP_NUM_TASKS": 2, "SLURM_PROCID": rank}, {"PMI_SIZE": 2, "PMI_RANK": rank}, {"PMIX_RANK": rank}):
            self.assertEqual(self.launched(2, names), whole, names)
        self.assertEqual(self.launched(1, {"PMIX_RANK": rank}), whole)
        env = {**os.environ, "SLURM_NTASKS": "4", "SLURM_PROCID": "0", "LD_DEBUG": "files"}
        done = subprocess.run([PROGRAM, "study", "study.yaml", "--json"], cwd=self.folder, env=env, capture_output=True,
                              encoding="utf-8", check=True)
        self.assertEqual(done.stdout, whole)
        self.assertNotIn("libmpi", done.stderr)

    def test_launched_without_mpi(self):
        """srun without its MPI: two processes of which each would be alone, and run all of the study. Refused, and told once."""
        env = {**os.environ, **ALLOWED, "SLURM_STEP_NUM_TASKS": "2", "SLURM_PROCID": "0"}
        done = subprocess.run([PROGRAM, "study", "study.yaml", "--csv", "rows.csv"], cwd=self.folder, env=env, capture_output=True,
                              encoding="utf-8", check=False)
        self.assertEqual((done.returncode, done.stdout), (5, ""))
        self.assertIn("began 2 processes, but the MPI that Topple was built with knows of 1", self.complaint(done.stderr))
        self.assertIn("srun --mpi=pmix", done.stderr)
        self.assertFalse((self.folder / "rows.csv").exists())

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
