# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The files of a study: rows that were changed are not gone on with, merged, or made HDF5 of; what nobody named is not written
through a link, nor over a file of another kind; and no message shows what stands in a file that is no table."""

import hashlib
import os
import pathlib
import re
import resource
import shutil
import signal
import struct
import subprocess

from harness import PROGRAM, main, run
from study_case import StudyCase

BUILT = pathlib.Path(PROGRAM).parent
TEXT = "samples: 300\nsampling: {chunk: 60}\nvary: {friction_angle_deg: {normal: {mean: 30, deviation: 3}}}\n"


def tampered(rows):
    """Rows that are still rows: a digit changed in place, two exchanged with their numbers, one cut short by a digit, a line
    end of another system."""
    lines = rows.splitlines(keepends=True)

    def with_line(k, line):
        return b"".join([*lines[:k], line, *lines[k + 1:]])

    digit = lines[7].index(b".") + 1
    other = b"7" if lines[7][digit:digit + 1] != b"7" else b"8"
    yield with_line(7, lines[7][:digit] + other + lines[7][digit + 1:])
    first, second = (lines[k].split(b",", 1) for k in (20, 21))
    yield b"".join([*lines[:20], first[0] + b"," + second[1], second[0] + b"," + first[1], *lines[22:]])
    yield with_line(9, lines[9].replace(lines[9].split(b",")[1], lines[9].split(b",")[1] + b"0"))
    yield b"".join([*lines[:30], *lines[31:], lines[30]])
    yield rows.replace(b"\n", b"\r\n")


class Files(StudyCase):
    def setUp(self):
        super().setUp()
        self.write(TEXT)

    def all_files(self):
        return {path: (path.is_symlink(), path.read_bytes()) for path in self.folder.iterdir() if path.exists()}

    def refused(self, says, *words, status=3):
        before = self.all_files()
        self.assertRegex(self.study("study.yaml", *words, status=status), says)
        self.assertEqual(self.all_files(), before)

    def test_progress_tells_the_hash(self):
        """Of the header and of each chunk of 60 rows, with its number before it, the SHA-256; as four numbers, added."""
        self.study("study.yaml", "--rows", "rows.csv")
        told = (self.folder / "rows.csv.progress").read_text()
        lines = (self.folder / "rows.csv").read_bytes().splitlines(keepends=True)
        pieces = [lines[0], *(b"".join(lines[k:k + 60]) for k in range(1, 301, 60))]
        hashes = [struct.unpack("<4Q", hashlib.sha256(struct.pack("<Q", k) + piece).digest()) for k, piece in enumerate(pieces)]
        added = struct.pack("<4Q", *(sum(numbers) % 2**64 for numbers in zip(*hashes)))
        self.assertIn(f"sha256: {added.hex()}\n", told)
        for wrong in ("sha256: 12\n", "sha256: " + 64 * "g" + "\n", "sha256: [1]\n"):
            at = told.index("sha256: ")
            (self.folder / "rows.csv.progress").write_text(told[:at] + wrong)
            self.refused("this is not a progress file of a study", "--rows", "rows.csv")
        (self.folder / "rows.csv.progress").write_text(told[:at])  # as before there were hashes
        self.refused("by another version of this program; restart", "--rows", "rows.csv")

    def test_counts_changed(self):
        """What is counted of the rows stands beside them, and is held to them: numbers that do not add up, or are of more or
        fewer rows."""
        self.study("study.yaml", "--rows", "rows.csv")
        path = self.folder / "rows.csv.progress"
        told = path.read_text()
        (counts,) = re.findall(r"(?m)^counts: \[(.*)\]$", told)
        numbers = counts.split(",")
        for wrong in (["299", *numbers[1:]], numbers[:-1], [*numbers[:-1], "1"], ["-1", *numbers[1:]], [*numbers, "0"]):
            path.write_text(told.replace(counts, ",".join(wrong)))
            self.refused("this is not a progress file of a study", "--rows", "rows.csv")
        path.write_text(told.replace("chunks: 5", "chunks: 4"))
        self.refused("the progress beside these rows is not theirs", "--rows", "rows.csv")
        path.write_text(told.replace("chunks: 5", "chunks: 6"))
        self.refused("the progress beside these rows is not theirs", "--rows", "rows.csv")
        path.write_text(told)
        self.study("study.yaml", "--rows", "rows.csv")

    def test_rows_changed(self):
        """Of a whole study, of one that was ended, of a shard: told, with the file and what to do, and nothing is written; the
        file put back as it was is gone on with."""
        whole = self.study("study.yaml", "--rows", "whole.csv")
        rows = (self.folder / "whole.csv").read_bytes()
        header_and_half = b"".join(rows.splitlines(keepends=True)[:121])
        progress = (self.folder / "whole.csv.progress").read_text()

        def little_room():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (len(header_and_half) + 100, len(header_and_half) + 100))

        subprocess.run([PROGRAM, "study", "study.yaml", "--rows", "half.csv"], cwd=self.folder, capture_output=True,
                       preexec_fn=little_room, check=False)
        half = (self.folder / "half.csv.progress").read_text()
        self.assertIn("chunks: 2\n", half)
        for name, own, told in (("whole.csv", rows, progress), ("half.csv", header_and_half, half)):
            path = self.folder / name
            (self.folder / (name + ".progress")).write_text(told)
            for wrong in tampered(own):
                path.write_bytes(wrong + b"299,half a ro")
                self.refused(rf"^topple: {name}: lines 1 to \d+ are not those that the study wrote.*restart|"
                             rf"^topple: {name}.*changed since", "--rows", name)
            path.write_bytes(own + b"120,half a ro")
            self.assertEqual(self.study("study.yaml", "--rows", name), whole)
            self.assertEqual(path.read_bytes(), rows)
        wrong = next(tampered(rows))
        (self.folder / "whole.csv").write_bytes(wrong)
        self.refused(r"^topple: whole.csv: lines 1 to 301 ", "--rows", "whole.csv")
        self.assertEqual(self.study("study.yaml", "--rows", "whole.csv", "--restart"), whole)
        self.assertEqual((self.folder / "whole.csv").read_bytes(), rows)

    def test_shards_changed(self):
        for k in (1, 2):
            self.study("study.yaml", "--rows", f"{k}.csv", "--shard", f"{k}/2")
        rows = (self.folder / "2.csv").read_bytes()
        for wrong in tampered(rows):
            (self.folder / "2.csv").write_bytes(wrong)
            self.refused("2.csv.*(not those that the study wrote|changed since)|out of order", "--merge", "1.csv", "2.csv")

    def test_hdf5_changed(self):
        if not (BUILT / "libtopple-hdf5.so").exists():
            self.skipTest("HDF5 is not built")
        self.study("study.yaml", "--rows", "rows.h5")
        rows = (self.folder / "rows.h5.csv").read_bytes()
        (self.folder / "rows.h5.csv").write_bytes(next(tampered(rows)))
        self.refused("rows.h5.csv: lines 1 to 301 ", "--rows", "rows.h5")
        (self.folder / "rows.h5.csv").write_bytes(rows)
        self.study("study.yaml", "--rows", "rows.h5")
        (self.folder / "mine.h5").write_bytes(b"\x89HDF\r\n\x1a\nprecious")
        self.refused("mine.h5: this file is there, and is not the rows of a study", "--rows", "mine.h5", "--restart")
        (self.folder / "led.h5").symlink_to("nowhere")
        self.refused("led.h5: cannot be written: it is a link that leads nowhere", "--rows", "led.h5", status=5)
        (self.folder / "led.h5").unlink()
        (self.folder / "precious").write_text("precious\n")
        (self.folder / "led.h5.csv").symlink_to("precious")
        for words in ([], ["--restart"]):
            self.refused("led.h5.csv: this is a link", "--rows", "led.h5", *words)

    def test_ranks_changed(self):
        if not (BUILT / "libtopple-ranks.so").exists() or shutil.which("mpirun") is None:
            self.skipTest("MPI is not built")
        env = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_rmaps_base_oversubscribe": "1"}

        def by_ranks(*words):
            return subprocess.run(["mpirun", "-n", "2", PROGRAM, "study", "study.yaml", *words], cwd=self.folder, env=env,
                                  capture_output=True, encoding="utf-8", check=False)

        self.study("study.yaml", "--rows", "rows.csv")
        rows = (self.folder / "rows.csv").read_bytes()
        progress = (self.folder / "rows.csv.progress").read_bytes()
        for wrong in tampered(rows):
            (self.folder / "rows.csv").write_bytes(wrong)
            done = by_ranks("--rows", "rows.csv")
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertRegex(done.stderr, "topple: rows.csv.*(lines 1 to 301 are not those|changed since)")
            self.assertEqual((self.folder / "rows.csv").read_bytes(), wrong)
            self.assertEqual((self.folder / "rows.csv.progress").read_bytes(), progress)
        (self.folder / "rows.csv").write_bytes(rows)
        self.assertEqual(by_ranks("--rows", "rows.csv").returncode, 0)
        self.assertEqual((self.folder / "rows.csv").read_bytes(), rows)

    def test_links(self):
        """A link that leads nowhere makes no file; the progress, which nobody named, goes through no link, dangling or not;
        rows go where a link leads, as with `cp`, if rows are there."""
        precious = self.folder / "precious"
        precious.write_text("precious\n")
        (self.folder / "rows.csv").symlink_to("nowhere")
        for words in ([], ["--restart"]):
            self.refused("rows.csv: cannot be written: it is a link that leads nowhere", "--rows", "rows.csv", *words, status=5)
            self.assertFalse((self.folder / "nowhere").exists())
        (self.folder / "rows.csv").unlink()
        for target in ("precious", "nowhere"):
            (self.folder / "rows.csv.progress").symlink_to(target)
            for words in ([], ["--restart"], ["--shard", "1/2"]):
                self.refused(r"rows.csv.progress: this is a link, and what it leads to would be lost", "--rows", "rows.csv", *words)
                self.assertFalse((self.folder / "rows.csv").exists() or (self.folder / "nowhere").exists())
            (self.folder / "rows.csv.progress").unlink()
        self.study("study.yaml", "--rows", "real.csv")
        real = (self.folder / "real.csv").read_bytes()
        (self.folder / "rows.csv").symlink_to("real.csv")
        self.study("study.yaml", "--rows", "rows.csv", "--restart")
        self.assertTrue((self.folder / "rows.csv").is_symlink())
        self.assertEqual((self.folder / "real.csv").read_bytes(), real)

    def test_restart_reads_first(self):
        """What is not rows, or not their progress, is not written over, even where all is to begin anew; rows of any study are."""
        for name, mine in (("rows.csv", "precious\n"), ("rows.csv", "sampled,1\n"), ("rows.csv", "sample,my precious lab data\n1,2\n"),
                           ("rows.csv", "sample,"), ("rows.csv.progress", "mine: 1\n"),
                           ("rows.csv.progress", "precious\n"), ("rows.csv.progress", "")):
            (self.folder / name).write_text(mine)
            self.refused(f"{name}.*(the only files that are written over|would be lost)", "--rows", "rows.csv", "--restart")
            (self.folder / name).unlink()
        self.write(TEXT.replace("300", "200"), "other.yaml")
        self.study("other.yaml", "--rows", "rows.csv")
        whole = self.study("study.yaml", "--rows", "rows.csv", "--restart")
        self.assertEqual(self.study("study.yaml"), whole)
        (self.folder / "rows.csv").write_text("")
        self.assertEqual(self.study("study.yaml", "--rows", "rows.csv", "--restart"), whole)

    def test_figures(self):
        """A figure, or the numbers of one, is written over nothing that the study reads or writes, by whatever name."""
        (self.folder / "t.csv").write_text("phi\n28\n30\n32\n31\n")
        self.write("samples: 60\nvary: {friction_angle_deg: {empirical: 't.csv:phi'}}\n")
        self.study("study.yaml", "--rows", "rows.csv")
        (self.folder / "same.csv").hardlink_to(self.folder / "rows.csv")
        for option in ("--figure", "--scatter"):
            self.refused("this is a file that is read here", "--rows", "rows.csv", option, "t.csv")
            for name in ("./rows.csv", "same.csv"):
                before = self.all_files()
                status, _out, err = run("study", "study.yaml", "--rows", "rows.csv", option, name, folder=self.folder)
                self.assertIn(status, (2, 3))
                self.assertRegex(err, "this is a file that is read here|take different files")
                self.assertEqual(self.all_files(), before)
        for k in (1, 2):
            self.study("study.yaml", "--rows", f"{k}.csv", "--shard", f"{k}/2")
        self.refused("this is a file that is read here", "--merge", "1.csv", "2.csv", "--figure", "2.csv")

    def test_nothing_is_shown(self):
        """Of a file that a study names as a table and that has no such column: not a word of it, however near."""
        (self.folder / "secret").write_text("root:x:0:0:password=hunter2:/root:/bin/bash\nhunter3,1\n")
        (self.folder / "names.csv").write_text("hunter2,phi_degrees\n1,hunter4\n")
        for kind in ("column", "empirical"):
            for of in ("secret:root", "secret:hunter2", "secret:password", "names.csv:phi_deg", "names.csv:hunter22",
                       "names.csv:phi_degrees", "slab.yaml:topple", "secret:x"):
                self.write(f"samples: 10\nvary: {{friction_angle_deg: {{{kind}: '{of}'}}}}\n", "leak.yaml")
                said = self.study("leak.yaml", status=3)
                wanted = of.split(":")[1]
                for word in ("root", "hunter", "password", "phi_degrees", "bash", "length_unit"):
                    self.assertFalse(word in said.replace(of, "").replace(f"'{wanted}'", ""), (of, said))


if __name__ == "__main__":
    main()
