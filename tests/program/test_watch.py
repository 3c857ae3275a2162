# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""How the program speaks while one works with it: `solve --watch` solves again when a file changes, however it is written;
colour is for terminals alone and says nothing that words do not; --quiet leaves the exit status."""

import os
import pathlib
import pty
import re
import signal
import subprocess
import tempfile
import threading
import time
import unittest

from harness import PROGRAM, ROOT, main, run

SLAB = "topple: 1\ntitle: A slab\nlength_unit: m\nblock: {slab: {width: 2, height: HEIGHT}}\nfriction_angle_deg: 40\n" \
       "tilt: {towards: left, angle_deg: 10}\n"
OUTLINE = "topple: 1\nlength_unit: m\nblock: {outline: \"the outline.csv\"}\nbase: {mated: true}\nfriction_angle_deg: 40\n" \
          "tilt: {towards: left, angle_deg: 10}\n"


class Watched:
    """A program that watches, and what it says: both of its outputs in one text, as they come."""

    def __init__(self, folder, *words):
        self.program = subprocess.Popen([PROGRAM, "solve", "--watch", *words], cwd=folder, stdout=subprocess.PIPE,
                                        stderr=subprocess.STDOUT, encoding="utf-8")
        self.text, self.seen = "", 0
        self.reader = threading.Thread(target=self.read)
        self.reader.start()

    def read(self):
        for line in self.program.stdout:
            self.text += line

    def says(self, pattern, seconds=60):
        """Waits for the pattern after what was waited for before."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            found = re.compile(pattern).search(self.text, self.seen)
            if found:
                self.seen = found.end()
                return found
            time.sleep(0.01)
        raise AssertionError(f"{pattern!r} is not in {self.text[self.seen:]!r}")

    def end(self, number=signal.SIGINT):
        self.program.send_signal(number)
        status = self.program.wait(timeout=60)
        self.reader.join()
        self.program.stdout.close()
        return status


class Watch(unittest.TestCase):
    def setUp(self):
        own = tempfile.TemporaryDirectory()
        self.addCleanup(own.cleanup)
        self.folder = pathlib.Path(own.name)
        self.scene = self.folder / "scene.yaml"

    def write(self, height):
        self.scene.write_text(SLAB.replace("HEIGHT", str(height)))

    def begin(self, *words):
        own = Watched(self.folder, "scene.yaml", *words)
        self.addCleanup(lambda: own.program.poll() is None and own.end())
        return own

    def test_written_in_place(self):
        """A slab of 2 by 4 topples at atan(1/2), by 2 at 40 degrees slides first, by 5 at atan(2/5)."""
        self.write(4)
        own = self.begin()
        own.says(r"26\.565°")
        own.says("watching the scene")
        self.write(5)
        own.says(r"21\.801°")
        self.write(2)
        own.says(r"slid")
        own.says("watching the scene")
        self.assertEqual(own.end(), -signal.SIGINT)

    def test_replaced_by_an_editor(self):
        """A new file under the old name; or the old one moved away, and a new one written a moment later."""
        self.write(4)
        own = self.begin()
        own.says("watching the scene")
        other = self.folder / ".scene.yaml.swp"
        other.write_text(SLAB.replace("HEIGHT", "5"))
        other.rename(self.scene)
        own.says(r"21\.801°")
        own.says("watching the scene")
        self.scene.rename(self.folder / "scene.yaml~")
        time.sleep(0.1)
        self.write(4)
        own.says(r"26\.565°")
        self.assertNotIn("cannot", own.text)

    def test_file_that_it_names(self):
        outline = self.folder / "the outline.csv"
        outline.write_text("0,0\n2,0\n2,4\n0,4\n")
        self.scene.write_text(OUTLINE)
        own = self.begin()
        own.says(r"26\.565°")
        own.says("watching the scene")
        outline.write_text("0,0\n2,0\n2,5\n0,5\n")
        own.says(r"21\.801°")

    def test_mistakes_are_told_and_it_goes_on(self):
        self.write(4)
        own = self.begin("--json")
        own.says("watching the scene")
        self.write("4O")
        own.says(r"topple: scene.yaml:4:\d+: ")
        own.says("watching the scene")
        self.scene.unlink()
        own.says("cannot be opened")
        self.write(5)
        own.says(r"21\.80140948")
        own.says("watching the scene")
        time.sleep(1.5)  # nothing changes: nothing is said
        self.assertEqual(own.text[own.seen:].strip(" -\n").replace("and the files that it names; ctrl-C ends", "").strip(), "")

    def test_not_there(self):
        """A scene that is not there at the beginning is a mistake, not something to wait for."""
        status, out, err = run("solve", "--watch", "none.yaml", folder=self.folder)
        self.assertEqual((status, out), (5, ""))
        self.assertIn("none.yaml", err)
        self.assertEqual(run("solve", "--watch", "--table", "a.yaml")[0], 2)

    def test_reader_that_leaves(self):
        """Nobody reads any more: it ends by itself."""
        self.write(4)
        with subprocess.Popen([PROGRAM, "solve", "--watch", "scene.yaml"], cwd=self.folder, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL) as program:
            program.stdout.read(1)
            program.stdout.close()
            self.write(5)
            self.assertNotEqual(program.wait(timeout=60), 0)


def untimed(text):
    """Without the time that it took."""
    return re.sub(r"[0-9.]+ ms", "", text)


class Colour(unittest.TestCase):
    def on_terminal(self, *words, **environment):
        """What a terminal gets of both outputs."""
        terminal, own = pty.openpty()
        program = subprocess.Popen([PROGRAM, *words], cwd=ROOT, stdout=own, stderr=own, stdin=subprocess.DEVNULL,
                                   env={**os.environ, "TERM": "xterm", "NO_COLOR": "", **environment})
        os.close(own)
        text = b""
        while True:
            try:
                more = os.read(terminal, 65536)
            except OSError:
                break
            if not more:
                break
            text += more
        program.wait()
        os.close(terminal)
        return untimed(text.decode().replace("\r\n", "\n"))

    def test_terminals_alone(self):
        scene = "examples/slab.yaml"
        plain = untimed(run("solve", scene)[1])
        self.assertNotIn("\033", plain)
        coloured = self.on_terminal("solve", scene)
        self.assertIn("\033[32m  Stands at 20°.\033[0m\n", coloured)
        self.assertEqual(re.sub(r"\033\[[0-9;]*m", "", coloured), plain)
        for words, environment in ((("--color", "never"), {}), ((), {"NO_COLOR": "1"}), ((), {"TERM": "dumb"})):
            self.assertEqual(self.on_terminal("solve", *words, scene, **environment), plain)
        self.assertEqual(untimed(run("solve", "--color", "always", scene)[1]), coloured)
        self.assertNotIn("\033", self.on_terminal("solve", "--json", scene))

    def test_what_is_not_certain_is_not_green(self):
        """Without friction a block stands by its moments alone; beyond its limit it is red; a title is no verdict."""
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "s.yaml"
            for more, colour, begins in (("tilt: {towards: left, angle_deg: 10}", "33", "  Stands"),
                                         ("friction_angle_deg: 40\ntilt: {towards: left, angle_deg: 30}", "31", "  Does not stand")):
                path.write_text("topple: 1\ntitle: \"  Stands for ever\"\nlength_unit: m\nblock: {slab: {width: 2, height: 4}}\n" + more)
                out = run("solve", "--color=always", path)[1]
                self.assertIn(f"\033[{colour}m{begins}", out)
                self.assertNotIn("\033[32m", out)

    def test_complaints(self):
        self.assertEqual(self.on_terminal("solve", "none.yaml")[:19], "\033[1;31mtopple:\033[0m ")

    def test_wrong(self):
        status, out, err = run("solve", "--color", "blue", "examples/slab.yaml")
        self.assertEqual((status, out), (2, ""))
        self.assertIn("--color takes auto, always or never, not 'blue'", err)


class Quiet(unittest.TestCase):
    def test_status_alone(self):
        """Nothing on the standard output by any command, the same exit status, complaints all the same."""
        for words in (("solve", "examples/slab.yaml"), ("solve", "--json", "examples/slab.yaml"), ("derive", "examples/slab.yaml"),
                      ("solve", "--fail-below", "9", "examples/slab.yaml"), ("solve", "none.yaml"), ("explain", "FoS"), ("examples",),
                      ("sweep", "examples/slab_left.yaml", "--x", "friction_angle_deg=20,30"), ("chart", "fos"),
                      ("profile", "examples/joint_profile.csv"), ("tilt", "examples/tilt_block_f.yaml")):
            status, out, err = run(*words)
            self.assertEqual(run(*words, "-q"), (status, "", err), words)
            self.assertTrue(out or status in (1, 3, 5), words)
            self.assertEqual(run(*words, "--quiet")[1], "")

    def test_files_are_written(self):
        with tempfile.TemporaryDirectory() as folder:
            for words in (("examples", "partial_contact"), ("solve", "--write-profile", "p.csv", "partial_contact.yaml"), ("new", "--slab", "1x2")):
                self.assertEqual(run(*words, "-q", folder=folder), (0, "", ""))
            self.assertEqual(sorted(os.listdir(folder)), ["p.csv", "partial_contact.yaml", "scene.yaml"])


if __name__ == "__main__":
    main()
