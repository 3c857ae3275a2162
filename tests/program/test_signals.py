# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The program that is interrupted, whose reader goes away, and whose streams are closed or full: no part of a
file is left, and what was there is as before."""

import itertools
import os
import random
import resource
import signal
import subprocess
import time

from files_case import Folder, is_whole
from harness import LONG, PROGRAM, ROOT, main, rounds, run


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
                for turn in range(rounds(6, 24)):
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
            for command in self.commands(figure, slow=LONG or ending == "svg"):
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
