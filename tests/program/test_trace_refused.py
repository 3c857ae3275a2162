# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""`topple trace` of what is no picture of a block: broken and huge files, words that fit no picture, files that must stay.

The story: pictures come from phones and messengers, cut off and renamed; a header may claim more pixels than there is
memory. Every one is refused in one line, and no file is left or changed."""

import os
import pathlib
import shutil
import struct
import tempfile
import unittest
import zlib

from harness import PROGRAM, main, run
from trace_case import ellipse, paint, write_png

BUILD = pathlib.Path(os.environ.get("TOPPLE_BUILD", pathlib.Path(PROGRAM).parent))
WORDS = ("--around=10,10,110,80", "--scale=5,85,55,85,1")


@unittest.skipUnless((BUILD / "libtopple-trace.so").exists(), "topple trace was not built")
class TraceRefused(unittest.TestCase):
    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.holder.name)
        self.picture = self.folder / "p.png"
        paint(self.picture, ellipse(60, 45, 40, 28), width=120, height=90)

    def tearDown(self):
        self.holder.cleanup()

    def refuse(self, status, words, *options, picture="p.png"):
        before = sorted(path.name for path in self.folder.iterdir())
        found, out, err = run("trace", picture, *(options or WORDS), folder=self.folder)
        self.assertEqual((found, out), (status, ""), err)
        self.assertIn(words, err)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), before)
        return err

    def header(self, width, height, bits=8, kind=2):
        data = struct.pack(">IIBBBBB", width, height, bits, kind, 0, 0, 0)
        chunk = b"IHDR" + data
        return (b"\x89PNG\r\n\x1a\n" + struct.pack(">I", len(data)) + chunk + struct.pack(">I", zlib.crc32(chunk)))

    def test_broken_png(self):
        whole = self.picture.read_bytes()
        for cut in (20, 60, len(whole) // 2, len(whole) - 30):
            self.picture.write_bytes(whole[:cut])
            self.assertTrue(self.refuse(3, "topple: p.png: a broken PNG: ").endswith("\n"))
        spoilt = bytearray(whole)
        spoilt[len(whole) // 2] ^= 255
        self.picture.write_bytes(spoilt)
        self.refuse(3, "a broken PNG: ")

    def test_huge(self):
        for width, height in ((50000, 50000), (2 ** 31 - 1, 1), (1, 40000), (20000, 20000)):
            self.picture.write_bytes(self.header(width, height))
            err = self.refuse(3, "topple: p.png: ")
            self.assertTrue("pictures of at most 100 million are read" in err or "a broken PNG" in err, err)

    def test_what_no_rock_has(self):
        for words, option in (("no scene takes what the options say: friction_angle_deg must lie in [0", "--friction=90"),
                              ("no scene takes what the options say: unit_weight_kn_m3 must be above zero", "--unit-weight=0"),
                              ("no scene takes what the options say: thickness must be above zero", "--thickness=-1")):
            self.refuse(3, words, *WORDS, option, picture="none.png")
        for option in ("--friction=30 deg", "--friction=", "--unit-weight=26,5", "--thickness=1}"):
            self.refuse(2, option.split("=")[0] + ": ", *WORDS, option)

    def test_contact_between(self):
        self.refuse(3, "both ends of the contact are nearest to one point of the outline", *WORDS, "--between=5,5,6,6")
        self.refuse(3, "lies outside of the picture", *WORDS, "--between=50,70,190,70")
        for words in ("50,70", "50,70,50,70", "a", "1,2,3,4,5"):
            self.refuse(2, "--between takes two different points", *WORDS, "--between=" + words)

    def test_no_picture(self):
        for content in (b"", b"GIF89a", b"root:x:0:0:", b"\xff\xd8"):
            self.picture.write_bytes(content)
            self.assertNotIn("root", self.refuse(3, "this is neither a PNG nor a JPEG"))
        for content in (b"\xff\xd8\xff\xe0", b"\xff\xd8\xff\xd9", b"\xff\xd8\xff\xc0\x00\x11\x08\xff\xff\xff\xff\x03" + b"\0" * 9):
            self.picture.write_bytes(content)
            self.refuse(3, "topple: p.png: ")
        self.refuse(5, "none.png: cannot be opened: No such file", picture="none.png")
        (self.folder / "folder.png").mkdir()
        self.refuse(3, "folder.png: is not a regular file", picture="folder.png")

    def test_nothing_to_see(self):
        write_png(self.picture, 120, 90, [bytes([120] * 360)] * 90)
        self.refuse(3, "nothing within the rough polygon is unlike what lies around it")
        self.refuse(3, "the rough polygon fills the picture", "--around=0,0,120,90", WORDS[1])
        self.refuse(3, "the rough polygon holds too few pixels", "--around=10,10,15,15", WORDS[1])
        self.refuse(3, "too few pixels", "--around=10,10,50,50,90,90", WORDS[1])

    def test_places(self):
        for words in (("--around=10,10,121,80", WORDS[1]), (WORDS[0], "--scale=5,-1,55,85,1"), (*WORDS, "--plumb=5,5,5,91")):
            self.refuse(3, "a point that is given lies outside of the picture, which is 120 pixels wide and 90 high", *words)

    def test_words(self):
        for words, told in (((WORDS[0],), "--scale is missing"), ((WORDS[1],), "--around is missing"),
                            (("--around=1,2,3", WORDS[1]), "--around takes from 2 to 200 points"),
                            (("--around=1,2,x,4", WORDS[1]), "--around takes"), (("--around=1,2,nan,4", WORDS[1]), "--around takes"),
                            ((WORDS[0], "--scale=5,5,5,5,1"), "--scale takes two different points"),
                            ((WORDS[0], "--scale=5,5,9,5,0"), "--scale takes"), ((WORDS[0], "--scale=5,5,9,5"), "--scale takes"),
                            ((*WORDS, "--plumb=5,5,5,5"), "--plumb takes two different points"),
                            ((*WORDS, "--unit=yd"), "--unit is one of mm, cm, m, km, in, ft"),
                            ((*WORDS, "--tolerance=0"), "--tolerance takes a length above 0"),
                            ((*WORDS, "--figure=f.svg"), "--figure takes a file whose name ends in .png"),
                            ((*WORDS, "--json"), "name a file for that by --output")):
            self.refuse(2, told, *words)
        self.assertEqual(run("trace")[0], 2)

    def test_the_picture_stays(self):
        before = self.picture.read_bytes()
        for option in ("-o", "--figure"):
            self.refuse(3, "p.png", *WORDS, option, "p.png")
            self.assertEqual(self.picture.read_bytes(), before)
        self.refuse(5, "none/s.yaml", *WORDS, "-o", "none/s.yaml")

    def test_hostile_name(self):
        """A name of a file is text in the scene that is written."""
        name = 'a"]\n# $(touch x) .png'
        shutil.copy(self.picture, self.folder / name)
        status, _, err = run("trace", name, *WORDS, "-o", "s.yaml", folder=self.folder)
        self.assertEqual((status, err), (0, ""))
        status, out, err = run("solve", "s.yaml", folder=self.folder)
        self.assertEqual((status, err), (0, ""))
        self.assertIn('Traced in a"] # $(touch x) .png', out)


if __name__ == "__main__":
    main()
