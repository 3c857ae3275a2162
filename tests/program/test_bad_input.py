# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Bad input: each scene of tests/bad names in its last line the message that it must get.

Every one must end with exit status 3, say where (file:line:column), print nothing to stdout, and
do so whether a report, JSON or the elements are asked for."""

import os
import pathlib
import tempfile
import unittest

from harness import ROOT, main, run

BAD = ROOT / "tests" / "bad"
SLAB = "topple: 1\nlength_unit: mm\nblock: {slab: {width: %s, height: 2}}\n"


class BadInput(unittest.TestCase):
    def refuse(self, path, expected, folder=BAD, ends=3):
        status, out, err = run("solve", path, folder=folder)
        self.assertEqual(status, ends, f"{path}: {err}")
        self.assertEqual(out, "", path)
        self.assertIn(expected, err, path)
        self.assertEqual(err.count("\n"), 1, "one line of message")
        return err

    def refuse_text(self, text, expected):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "scene.yaml").write_bytes(text)
            return self.refuse("scene.yaml", expected, folder)

    def test_huge_file_of_zeros(self):
        """A 1 GiB file of zeros, as scene and as CSV, is refused at once and not read to its end."""
        with tempfile.TemporaryDirectory() as folder:
            zeros = pathlib.Path(folder) / "zeros.yaml"
            with open(zeros, "wb") as file:
                file.truncate(1 << 30)
            self.refuse("zeros.yaml", "zeros.yaml:1:1: not YAML", folder)
            scene = pathlib.Path(folder) / "scene.yaml"
            scene.write_text("topple: 1\nlength_unit: mm\nblock: {outline: zeros.yaml}\n")
            self.refuse("scene.yaml", "zeros.yaml:1:1: a line longer than 65536 bytes", folder)

    def test_deep_nesting(self):
        """Expressions nested 100 000 deep are refused where they pass 200 levels, in every way that
        an expression can nest; the stack never sees the rest."""
        deep = 100_000
        for width in ("(" * deep + "1" + ")" * deep, "-" * deep + "1", "2^" * deep + "1"):
            self.refuse_text((SLAB % width).encode(), "nested deeper than 200 levels")

    def test_long_but_flat(self):
        """100 000 terms in a row are no nesting: the sum is exact and accepted."""
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder) / "scene.yaml"
            scene.write_text(SLAB % ("1" + "+1" * 99_999))
            status, _, err = run("solve", scene)
            self.assertEqual((status, err), (0, ""))

    def test_holes_that_touch_but_do_not_cut(self):
        """The counterpart of hole_cuts.yaml and its like: holes that hang on the outline or on each
        other in one point, and ten in a row from the outline on, leave the block in one piece."""
        chain = [[[k, 2], [k + 1, 1], [k + 1, 2]] for k in range(10)]
        chains = {"": chain, "touches both sides": chain + [[[10, 2], [10.5, 1], [11, 2]]]}
        for cut, holes in chains.items():
            text = f"""topple: 1\nlength_unit: m
block: {{outline: [[0, 0], [11, 0], [11, 4], [0, 4]], holes: {holes}}}\n"""
            with self.subTest(cut), tempfile.TemporaryDirectory() as folder:
                scene = pathlib.Path(folder) / "scene.yaml"
                scene.write_text(text)
                status, out, err = run("solve", scene)
                self.assertEqual(status, 3 if cut else 0, err)
                self.assertIn("2 pieces" if cut else "area 39 m²", err if cut else out)

    def test_files_that_cannot_be_read(self):
        """Missing, a folder, without permission: the system failed. Empty, only comments: bad input."""
        self.refuse("nowhere.yaml", "nowhere.yaml: cannot be opened: No such file", ends=5)
        self.refuse(".", ".: cannot be read: Is a directory", ends=5)
        self.refuse_text(b"", "scene.yaml:1:1: the file is empty; a scene begins with 'topple: 1'")
        self.refuse_text(b"# nothing\n\n", "scene.yaml:1:1: the file is empty")
        with tempfile.TemporaryDirectory() as folder:
            locked = pathlib.Path(folder) / "locked.yaml"
            locked.write_text("topple: 1\n")
            locked.chmod(0)
            if os.geteuid() != 0:  # root reads everything
                self.refuse("locked.yaml", "cannot be opened: Permission denied", folder, 5)

    def test_bytes_that_are_no_text(self):
        """Binary junk, invalid UTF-8, a zero byte in a quoted string."""
        for junk in (b"\x7fELF\x02\x01\x01\x00", b"topple: \xff\xfe\xfa", b'"a\\0b": 1\n',
                     b"topple: 1\ntitle: \"a\\0b\"\n"):
            self.refuse_text(junk, "scene.yaml:")

    def test_long_number(self):
        """A number of a million digits is refused before it reaches the exact arithmetic."""
        self.refuse_text((SLAB % ("1." + "7" * 1_000_000)).encode(), "has more than 1000 digits")

    def test_denominators(self):
        """Thousands of coprime denominators would need a common one of megabits: refused."""
        vertices = ", ".join(f"[{k}/{10**300 + 2 * k + 1}, {k * k}]" for k in range(1, 12001))
        text = f"topple: 1\nlength_unit: mm\nblock: {{outline: [{vertices}]}}\n"
        self.refuse_text(text.encode(), "have a common multiple of")


def add_scene_tests():
    """One test a scene of tests/bad, named after it."""
    for path in sorted(BAD.glob("*.yaml")):
        last = path.read_text(encoding="utf-8").rstrip("\n").rsplit("\n", 1)[-1]
        assert last.startswith("# expect: "), path
        expected = last.removeprefix("# expect: ")
        if ".csv" not in expected.split(" ")[0]:
            expected = f"{path.name}:{expected}"

        def check(self, name=path.name, expected=expected):
            self.refuse(name, expected)

        setattr(BadInput, f"test_scene_{path.stem}", check)


add_scene_tests()

if __name__ == "__main__":
    main()
