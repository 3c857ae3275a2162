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
import random
import resource
import signal
import stat
import subprocess
import tempfile
import time
import unittest

from harness import PROGRAM, ROOT, main, run

SCENE = """topple: 1
length_unit: m
block: {outline: outline.csv, unit_weight_kn_m3: 26, thickness: 1}
base: {profile: sub/profile.csv}
friction_angle_deg: 30
tilt: {towards: left, angle_deg: 5}
"""
MAP = ("--x", "block.thickness=0.5:3")
WHOLE = {".svg": (b"<?xml", b"</svg>"), ".pdf": (b"%PDF-", b"%%EOF"),
         ".png": (b"\x89PNG", b"IEND\xaeB`\x82"), ".csv": (b"panel,", b"")}


def is_whole(data, ending=".svg"):
    begin, end = WHOLE[ending]
    return data.startswith(begin) and data.rstrip().endswith(end) and data.count(begin) == 1


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="topple files ")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "sub").mkdir()
        self.scene = self.folder / "scene.yaml"
        self.scene.write_text(SCENE)
        (self.folder / "outline.csv").write_text("0,0\n2,0\n2,5\n0,5\n")
        (self.folder / "sub" / "profile.csv").write_text("-9,0\n9,0\n")

    def commands(self, output, scene=None):
        """Every command that writes a file of this name."""
        scene = scene or self.scene
        commands = [("chart", "map", scene, *MAP, "--output", output),
                    ("accuracy", scene, "--output", output)]
        if not str(output).endswith(".csv"):
            commands.append(("solve", scene, "--figure", output))
        return commands

    def contents(self):
        """Every file and link below the folder, with what stands in it."""
        return {str(p.relative_to(self.folder)): os.readlink(p) if p.is_symlink() else p.read_bytes()
                for p in sorted(self.folder.rglob("*")) if p.is_symlink() or p.is_file()}

    def assert_whole(self, path):
        self.assertTrue(is_whole(path.read_bytes(), path.suffix), path)


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
        for command in self.commands(scene, scene):
            self.assertEqual(run(*command)[0], 3, command)
        self.assertEqual(scene.read_text(), SCENE)
        copy = self.folder / "copy.svg"
        copy.write_text(SCENE)
        for command in self.commands(copy):
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
        for command in self.commands(self.folder / "link.svg"):
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
        sub, figure = self.folder / "sub", self.folder / "sub" / "figure.svg"
        for folder_mode, file_mode, written in ((0o777, 0o644, False), (0o777, 0o666, True),
                                                (0o755, 0o666, True), (0o755, 0o644, False)):
            for command in self.commands(figure):
                figure.write_text("as before" * 100000)
                sub.chmod(folder_mode)
                figure.chmod(file_mode)
                done = subprocess.run([PROGRAM, *command], cwd="/", check=False, capture_output=True,
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
        """What is no regular file is written to where it is."""
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


class Signals(Folder):
    def test_interrupted_while_it_draws(self):
        """A gnuplot that takes its time, and a signal: the program ends by it, and nothing is left."""
        tools, figure = self.folder / "tools", self.folder / "figure.svg"
        tools.mkdir()
        gnuplot, begun = tools / "gnuplot", tools / "begun"
        gnuplot.write_text(f"#!/bin/sh\necho half\n: >'{begun}'\nexec sleep 30\n")
        gnuplot.chmod(0o755)
        figure.write_text("as before")
        for end in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            # a test that is run without a terminal may hand down that a signal is ignored
            with subprocess.Popen([PROGRAM, "chart", "fos", "-o", figure], cwd=ROOT,
                                  env={"PATH": f"{tools}:/usr/bin:/bin"},
                                  preexec_fn=lambda end=end: signal.signal(end, signal.SIG_DFL)) as process:
                while not begun.exists():
                    time.sleep(0.01)
                process.send_signal(end)
            self.assertEqual(process.returncode, -end)
            begun.unlink()
            self.assertEqual(figure.read_text(), "as before")
            self.assertEqual(sorted(p.name for p in self.folder.iterdir()),
                             ["figure.svg", "outline.csv", "scene.yaml", "sub", "tools"])

    def test_interrupted_at_any_time(self):
        """From the start to past the end: the file is as before or whole, and stands alone."""
        rng = random.Random(5)
        for ending in ("svg", "csv"):
            figure = self.folder / f"figure.{ending}"
            for command in self.commands(figure):
                began = time.monotonic()
                run(*command)
                whole = time.monotonic() - began
                for turn in range(8):
                    figure.write_text("as before")
                    end = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)[turn % 3]
                    with subprocess.Popen([PROGRAM, *command], cwd=ROOT, stdout=subprocess.DEVNULL) as process:
                        time.sleep(rng.uniform(0.5, 1.1) * whole)
                        process.send_signal(end)
                    self.assertIn(process.returncode, (0, -end), command)
                    # the process that draws a figure ends by itself, and may be about to rename it
                    for _ in range(3000):
                        if not list(self.folder.glob("**/*.part")):
                            break
                        time.sleep(0.01)
                    self.assertEqual(list(self.folder.glob("**/*.part")), [])
                    data = figure.read_bytes()
                    self.assertTrue(is_whole(data, figure.suffix) or
                                    (process.returncode != 0 and data == b"as before"), command)
                figure.unlink()

    def test_larger_than_allowed(self):
        """SIGXFSZ, as the system sends it: status 5, a complaint, and the file as before."""
        for ending in ("svg", "pdf", "png", "csv"):
            figure = self.folder / f"figure.{ending}"
            for command in self.commands(figure):
                for text in ("as before", None):
                    if text is None:
                        figure.unlink()
                    else:
                        figure.write_text(text)
                    before = self.contents()
                    done = subprocess.run(
                        [PROGRAM, *command], cwd=ROOT, check=False, capture_output=True, encoding="utf-8",
                        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100)))
                    self.assertEqual((done.returncode, done.stdout), (5, ""), command)
                    self.assertIn("File too large", done.stderr)
                    self.assertEqual(self.contents(), before)

    def test_nobody_reads_the_report(self):
        """SIGPIPE ends the program as it ends others; where it is ignored, status 5. No figure is left
        behind either way: the process that draws takes back what it had made ready."""
        figure = self.folder / "figure.svg"
        for ignored in (False, True):
            reading, writing = os.pipe()
            os.close(reading)
            done = subprocess.run([PROGRAM, "solve", self.scene, "--figure", figure], cwd=ROOT, check=False,
                                  stdout=writing, stderr=subprocess.PIPE, restore_signals=not ignored)
            os.close(writing)
            self.assertEqual(done.returncode, 5 if ignored else -signal.SIGPIPE)
            for _ in range(500):
                if not list(self.folder.glob(".topple*")):
                    break
                time.sleep(0.01)
            self.assertEqual([path for path in self.folder.iterdir() if "topple" in path.name or path == figure], [])


class Streams(Folder):
    def test_closed(self):
        """Any of the standard streams closed: no file gets what is meant for it."""
        for closed in itertools.chain.from_iterable(itertools.combinations(range(3), n) for n in (1, 2, 3)):
            for output in ("figure.svg", "figure.csv"):
                for command in [("solve", self.scene), *self.commands(self.folder / output)]:
                    before = self.contents()
                    done = subprocess.run([PROGRAM, *command], cwd=ROOT, check=False,
                                          preexec_fn=lambda own=closed: [os.close(k) for k in own],
                                          stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                          stderr=subprocess.DEVNULL)
                    reports = command[0] == "solve"  # else the file is all
                    self.assertEqual(done.returncode, 5 if reports and 1 in closed else 0, (closed, command))
                    after = self.contents()
                    if output in after and "sub" not in output and (self.folder / output).exists():
                        self.assert_whole(self.folder / output)
                        (self.folder / output).unlink()
                    after.pop(output, None)
                    self.assertEqual(after, before)

    def test_full_disk(self):
        """Help and version to a full disk are failures too, said once."""
        for arguments in (["--help"], ["--version"], ["help"], ["solve", "--help"], ["chart", "--help"],
                          ["solve", "--version"], ["solve", "--usage"], ["solve", self.scene],
                          ["derive", self.scene], ["chart", "fos"]):
            with open("/dev/full", "wb") as full:
                done = subprocess.run([PROGRAM, *arguments], cwd=ROOT, stdout=full, stderr=subprocess.PIPE,
                                      encoding="utf-8", check=False)
            self.assertEqual(done.returncode, 5, arguments)
            self.assertEqual(done.stderr.count("No space left on device"), 1, arguments)


if __name__ == "__main__":
    main()
