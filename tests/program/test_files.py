# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The program among files, signals and other processes.

`--output` wrote over the profile that the chart was computed from, replaced links by files, and left
`.part` files where it was interrupted; with its standard output closed it could write into a file.
Here every way to each of these is tried: what was there must be there as before, or the whole new
file, and nothing else."""

import itertools
import os
import pathlib
import shutil
import stat
import subprocess
import unittest

from files_case import Folder, SCENE, is_whole
from harness import PROGRAM, ROOT, main, run


class Sources(Folder):
    def test_what_is_read_is_not_written_to(self):
        """The scene and both of its lists, by name, other spelling, link, hard link, chain of links."""
        sources = [self.scene, self.folder / "outline.csv", self.folder / "sub" / "profile.csv"]
        for k, source in enumerate(sources):
            hard, soft, chain, far = (self.folder / f"{name}{k}.svg" for name in ("hard", "soft", "chain", "far"))
            os.link(source, hard)
            soft.symlink_to(source.relative_to(self.folder))
            chain.symlink_to(soft.name)
            far.symlink_to(self.folder / "sub" / ".." / "sub" / ".." / source.relative_to(self.folder))
        names = [*self.folder.glob("*.svg"), self.folder / "sub" / ".." / "hard0.svg",
                 *sources[1:], self.folder / "sub" / ".." / "outline.csv"]
        before = self.contents()
        for name in names:
            for command in self.commands(name):
                status, out, err = run(*command)
                self.assertEqual((status, out), (3, ""), command)
                self.assertIn("would be lost", err)
        self.assertEqual(self.contents(), before)

    def test_scene_named_as_a_figure(self):
        """A scene whose own name ends in .svg; and a copy of it may be written to."""
        scene = self.folder / "scene.svg"
        scene.write_text(SCENE)
        for command in self.commands(scene, scene, slow=True):
            self.assertEqual(run(*command)[0], 3, command)
        self.assertEqual(scene.read_text(), SCENE)
        copy = self.folder / "copy.svg"
        copy.write_text(SCENE)
        for command in self.commands(copy, slow=True):
            self.assertEqual(run(*command)[0], 0, command)
            self.assert_whole(copy)


class Kept(Folder):
    def test_links_stay(self):
        """The file that a link leads to is written, as cp does; the link stays."""
        target = self.folder / "sub" / "target.svg"
        for first, command in itertools.product((True, False), self.commands(self.folder / "one.svg")):
            target.write_text("as before")
            for name, to in (("two.svg", "sub/target.svg"), ("one.svg", "two.svg" if first else str(target))):
                (self.folder / name).unlink(missing_ok=True)
                (self.folder / name).symlink_to(to)
            before = self.contents()
            self.assertEqual(run(*command)[0], 0, command)
            self.assert_whole(target)
            after = self.contents()
            before.pop("sub/target.svg")
            after.pop("sub/target.svg")
            self.assertEqual(before, after)

    def test_file_of_two_names(self):
        """Both names have the figure afterwards, and are one file still."""
        one, other = self.folder / "one.svg", self.folder / "sub" / "other.svg"
        one.write_text("as before" * 100000)  # longer than what is written
        os.link(one, other)
        for command in self.commands(one):
            self.assertEqual(run(*command)[0], 0, command)
            self.assertTrue(one.samefile(other))
            self.assert_whole(one)

    def test_link_that_leads_nowhere(self):
        (self.folder / "link.svg").symlink_to("none/nothing.svg")
        before = self.contents()
        for command in self.commands(self.folder / "link.svg", slow=True):
            status, out, err = run(*command)
            self.assertEqual((status, out), (5, ""))
            self.assertIn("link that leads nowhere", err)
        self.assertEqual(self.contents(), before)

    def test_mode_and_owner(self):
        """Of a file that is there both stay; a new one has what the mask leaves."""
        figure = self.folder / "figure.svg"
        for command, mode in itertools.product(self.commands(figure), (0o600, 0o640, 0o666, 0o755)):
            figure.write_text("as before")
            figure.chmod(mode)
            if os.geteuid() == 0:
                os.chown(figure, 65534, 65533)
            before = figure.stat()
            self.assertEqual(run(*command)[0], 0)
            after = figure.stat()
            self.assert_whole(figure)
            self.assertEqual((before.st_mode, before.st_uid, before.st_gid),
                             (after.st_mode, after.st_uid, after.st_gid))
        figure.unlink()
        for command, mask in itertools.product(self.commands(figure), (0o022, 0o077)):
            subprocess.run([PROGRAM, *command], cwd=ROOT, check=True, capture_output=True,
                           preexec_fn=lambda own=mask: os.umask(own))
            self.assertEqual(stat.S_IMODE(figure.stat().st_mode), 0o666 & ~mask)
            figure.unlink()

    @unittest.skipIf(os.geteuid() != 0, "needs another user's rights")
    def test_rights_of_another_user(self):
        """As nobody: a file that may not be written stays; one that may, in a folder that takes no
        new file, or of another owner, is written."""
        def as_nobody():
            os.setgroups([])
            os.setgid(65533)
            os.setuid(65534)

        self.folder.chmod(0o755)
        program = self.folder / "program" / "topple"  # others may not enter /root, where it may have been built
        program.parent.mkdir()
        for path in (pathlib.Path(PROGRAM), *pathlib.Path(PROGRAM).parent.glob("libtopple-figure.so.*[0-9]")):
            shutil.copy(path, program.parent)
        sub, figure = self.folder / "sub", self.folder / "sub" / "figure.svg"
        for folder_mode, file_mode, written in ((0o777, 0o644, False), (0o777, 0o666, True),
                                                (0o755, 0o666, True), (0o755, 0o644, False)):
            for command in self.commands(figure):
                figure.write_text("as before" * 100000)
                sub.chmod(folder_mode)
                figure.chmod(file_mode)
                done = subprocess.run([program, *command], cwd="/", check=False, capture_output=True,
                                      preexec_fn=as_nobody)
                self.assertEqual(done.returncode, 0 if written else 5, (command, done.stderr))
                self.assertEqual((figure.stat().st_uid, stat.S_IMODE(figure.stat().st_mode)), (0, file_mode))
                if written:
                    self.assert_whole(figure)
                else:
                    self.assertEqual(figure.read_text(), "as before" * 100000)
                self.assertEqual(len(list(sub.iterdir())), 2)

    def test_parts_of_other_runs(self):
        """The name that would serve is taken by a file of another run: both stay."""
        figure = self.folder / "figure.csv"

        def take_names():
            for k in range(3):
                (self.folder / f".topple-{os.getpid()}-{k}.part").write_text("of another run")

        subprocess.run([PROGRAM, *self.commands(figure)[0]], cwd=ROOT, check=True, preexec_fn=take_names)
        self.assert_whole(figure)
        parts = list(self.folder.glob(".*.part"))
        self.assertEqual([p.read_text() for p in parts], ["of another run"] * 3)

    def test_pipes_and_devices(self):
        """What is not a regular file is written to where it is."""
        pipe, null, full = (self.folder / f"{name}.svg" for name in ("pipe", "null", "full"))
        os.mkfifo(pipe)
        null.symlink_to("/dev/null")
        full.symlink_to("/dev/full")
        for command in self.commands(pipe):
            with subprocess.Popen([PROGRAM, *command], cwd=ROOT, stdout=subprocess.PIPE) as process:
                data = pipe.read_bytes()
                process.communicate()
            self.assertEqual(process.returncode, 0)
            self.assertTrue(is_whole(data))
            self.assertTrue(stat.S_ISFIFO(pipe.stat().st_mode))
        for command in self.commands(null):
            self.assertEqual(run(*command)[0], 0)
        for command in self.commands(full):
            status, out, err = run(*command)
            self.assertEqual((status, out), (5, ""))
            self.assertIn("No space left", err)
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/null").st_mode))

    def test_standard_output_as_a_file(self):
        """A link to /dev/stdout: through a pipe, and where that is a file of its own."""
        link, out = self.folder / "link.svg", self.folder / "out.txt"
        link.symlink_to("/dev/stdout")
        for command in self.commands(link)[:2]:
            data = subprocess.run([PROGRAM, *command], cwd=ROOT, check=True, capture_output=True).stdout
            self.assertTrue(is_whole(data))
            with open(out, "wb") as file:
                subprocess.run([PROGRAM, *command], cwd=ROOT, check=True, stdout=file)
                self.assertEqual(os.fstat(file.fileno()).st_ino, out.stat().st_ino)
            self.assertTrue(is_whole(out.read_bytes()))


if __name__ == "__main__":
    main()
