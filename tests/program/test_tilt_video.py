# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""An animation as WebM or GIF: what ffmpeg is given, caught by one of our own in its place. Its frames hold the block where
the test's JSON says it is; its arguments hold nothing of the scene; without it the message names the package."""

import json
import math
import os
import pathlib
import shutil
import struct
import subprocess
import tempfile
import unittest
import zlib

from harness import PROGRAM, main

TITLE = "a '`touch trap`' {/Symbol b} $(id) %s"
SCENE = f"topple: 1\ntitle: \"{TITLE}\"\n" + """length_unit: m
block: {slab: {width: 2, height: 1}, unit_weight_kn_m3: 25}
base: {profile: [[-20, 0], [20, 0]]}
friction_angle_deg: 20
tilt: {towards: left, angle_deg: 30}
tilt_test: {engine: dynamics, protocol: release, duration_s: 0.8}
"""
BLOCK = (0x7a, 0xa6, 0xc2)
CATCH = "printf '%s\\n' \"$@\" > '{0}/arguments'; cat > '{0}/frames'; printf moving"


def images(data):
    """The PNGs one behind the other: width, height, rows of (r, g, b)."""
    at, found = 0, []
    while at < len(data):
        assert data[at:at + 8] == b"\x89PNG\r\n\x1a\n"
        at += 8
        packed = b""
        while True:
            length, kind = struct.unpack(">I4s", data[at:at + 8])
            body = data[at + 8:at + 8 + length]
            at += 12 + length
            if kind == b"IHDR":
                width, height, depth, colour = struct.unpack(">IIBB", body[:10])
                assert depth == 8 and colour in (2, 6)
                size = 3 if colour == 2 else 4
            packed += body if kind == b"IDAT" else b""
            if kind == b"IEND":
                break
        found.append((width, height, size, packed))
    return found


def unpacked(width, height, size, packed):
    """Rows of bytes, the filters of PNG undone."""
    raw, above, rows = zlib.decompress(packed), bytearray(width * size), []
    for y in range(height):
        kind, row = raw[y * (width * size + 1)], bytearray(raw[y * (width * size + 1) + 1:(y + 1) * (width * size + 1)])
        for x in range(len(row)):
            left, up, corner = (row[x - size], above[x], above[x - size]) if x >= size else (0, above[x], 0)
            if kind == 4:
                nearest = left + up - corner
                guess = min((abs(nearest - left), 0, left), (abs(nearest - up), 1, up), (abs(nearest - corner), 2, corner))[2]
            else:
                guess = (0, left, up, (left + up) // 2)[kind]
            row[x] = (row[x] + guess) & 255
        rows.append(row)
        above = row
    return rows


def block_of(image):
    """Dots of the block's colour: how many, their centroid (y upwards), their second moment about it."""
    width, height, size, _ = image
    dots = [(x, height - y) for y, row in enumerate(unpacked(*image)) for x in range(width)
            if tuple(row[x * size:x * size + 3]) == BLOCK]
    x, y = (sum(d[k] for d in dots) / len(dots) for k in (0, 1))
    xx, xy, yy = (sum((d[i] - (x, y)[i]) * (d[j] - (x, y)[j]) for d in dots) for i, j in ((0, 0), (0, 1), (1, 1)))
    return len(dots), x, y, math.degrees(math.atan2(2 * xy, xx - yy) / 2)


class Video(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)
        (self.folder / "scene.yaml").write_text(SCENE)
        self.tools = self.folder / "tools"
        self.tools.mkdir()

    def stand_in(self, script):
        (self.tools / "ffmpeg").write_text(f"#!/bin/sh\n{script}\n")
        (self.tools / "ffmpeg").chmod(0o755)
        return f"{self.tools}:{os.environ['PATH']}"

    def animate(self, name, path):
        done = subprocess.run([PROGRAM, "tilt", "--json", "--animation", self.folder / name, self.folder / "scene.yaml"],
                              cwd=self.folder, env={**os.environ, "PATH": path}, capture_output=True, encoding="utf-8",
                              check=False)
        return done

    def test_frames(self):
        """A slab that slides on a table at 30 degrees: 25 frames a second for two seconds and a ninth more, the slab inclined as
        the table, and as far down it at the end as the test says."""
        done = self.animate("a.webm", self.stand_in(CATCH.format(self.folder)))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((self.folder / "a.webm").read_text(), "moving")
        frames = images((self.folder / "frames").read_bytes())
        self.assertEqual(len(frames), math.ceil(2 / 0.9 * 25))
        self.assertEqual({frame[:2] for frame in frames}, {frames[0][:2]})
        self.assertEqual([side % 2 for side in frames[0][:2]], [0, 0])
        dots, x, y, incline = block_of(frames[0])
        last_dots, last_x, last_y, _ = block_of(frames[-1])
        scale = math.sqrt(dots / 2)  # 2 m2
        self.assertAlmostEqual(last_dots / dots, 1, delta=0.02)
        self.assertAlmostEqual(incline, 30, delta=0.3)
        own = json.loads(done.stdout)["cases"][0]
        run_out = own["run_out_m"]  # its acceleration is g (sin 30 - tan 20 cos 30)
        self.assertAlmostEqual(run_out, 9.80665 * (0.5 - math.tan(math.radians(20)) * math.cos(math.pi / 6)) / 2 * 0.8 ** 2,
                               delta=1e-9)
        self.assertAlmostEqual(last_x - x, -run_out * math.cos(math.pi / 6) * scale, delta=1.5)
        self.assertAlmostEqual(last_y - y, -run_out * math.sin(math.pi / 6) * scale, delta=1.5)

    def test_nothing_of_the_scene_in_a_command(self):
        """ffmpeg is given the same words whatever the scene is, and nothing in its title is carried out."""
        for name, kind in (("a.webm", "webm"), ("b.GIF", "gif")):
            done = self.animate(name, self.stand_in(CATCH.format(self.folder)))
            self.assertEqual(done.returncode, 0, done.stderr)
            arguments = (self.folder / "arguments").read_text()
            self.assertNotIn("touch", arguments)
            self.assertNotIn(str(self.folder), arguments)
            self.assertEqual(arguments.split()[-3:], ["-f", kind, "pipe:1"])
        self.assertFalse((self.folder / "trap").exists())

    def test_without_ffmpeg(self):
        """Status 5, what to install, and no file; as SVG it needs none."""
        shutil.copy(shutil.which("gnuplot"), self.tools / "gnuplot")
        done = self.animate("a.gif", str(self.tools))
        self.assertEqual(done.returncode, 5)
        self.assertIn("'apt-get install ffmpeg'", done.stderr)
        self.assertFalse((self.folder / "a.gif").exists())
        self.assertEqual(self.animate("a.svg", str(self.tools)).returncode, 0)

    def test_failures(self):
        """What ffmpeg complains of is told, and a file that was there stays."""
        (self.folder / "a.gif").write_text("as before")
        for script, said in (("cat >/dev/null; echo half; echo it broke >&2; exit 3", "ffmpeg failed: it broke"),
                             ("exit 0", "ffmpeg failed: it drew nothing and printed no message")):
            done = self.animate("a.gif", self.stand_in(script))
            self.assertEqual(done.returncode, 5)
            self.assertIn(said, done.stderr)
            self.assertEqual((self.folder / "a.gif").read_text(), "as before")

    @unittest.skipUnless(shutil.which("ffmpeg") and shutil.which("ffprobe"), "ffmpeg is not installed")
    def test_films(self):
        """ffmpeg itself reads back as many frames of each format, and the same scene gives the same bytes."""
        for name, codec, rate in (("a.webm", "vp9", 25), ("a.gif", "gif", 12.5)):
            data = []
            for _ in range(2):
                done = self.animate(name, os.environ["PATH"])
                self.assertEqual(done.returncode, 0, done.stderr)
                data.append((self.folder / name).read_bytes())
            self.assertEqual(data[0], data[1])
            told = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=codec_name,nb_read_frames",
                                   "-of", "csv=p=0", self.folder / name], capture_output=True, encoding="utf-8", check=True)
            self.assertEqual(told.stdout.strip(), f"{codec},{math.ceil(2 / 0.9 * rate)}")


if __name__ == "__main__":
    main()
