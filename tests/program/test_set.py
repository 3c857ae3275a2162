# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""`--set`: the answer is that of the file in which the number stands, letter by letter, in every form of
report, and says what was set."""

import json
import pathlib
import re
import tempfile
import unittest

from harness import ROOT, main, run

E = ROOT / "examples" / "block_e_valley.yaml"


def without_times(text):
    text = re.sub(r'"seconds": [0-9.]+', "", re.sub(r"[0-9.]+ ms", "", text))
    return re.sub(r'"called_for_by": "[^"]*"', "", text)


class Set(unittest.TestCase):
    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.holder.name)
        self.addCleanup(self.holder.cleanup)

    def typed(self, *changes):
        """The example with other text in its file."""
        text = E.read_text(encoding="utf-8")
        for old, new in changes:
            self.assertEqual(text.count(old), 1, old)
            text = text.replace(old, new)
        path = self.folder / "typed.yaml"
        path.write_text(text, encoding="utf-8")
        return path

    def test_as_if_typed(self):
        path = self.typed(("a: 30, b: 120", "a: 31, b: 2*a+1/3"), ("friction_angle_deg: 30", "friction_angle_deg: 28.5"))
        words = ("--set", "b=2*a+1/3", "--set", "a=31", "--set", "friction_angle_deg=28.5")
        for form in ("--json", "--csv", "--table", "--elements"):
            _, truth, _ = run("solve", form, path)
            status, out, err = run("solve", form, *words, E)
            self.assertEqual((status, err), (0, ""))
            self.assertNotEqual(out, truth)
            out = re.sub(r'  "set": \[.*?\}\],\n', "", out, flags=re.DOTALL)
            out = re.sub(r"^Set .*\n|^- .*, set: .*\n", "", out, flags=re.MULTILINE)
            out = out.replace("b_mm,a_mm,friction_angle_deg,", "").replace("62.333333333333336,31,28.5,", "")
            self.assertEqual(without_times(out).rstrip(), without_times(truth).rstrip(), form)
        found = "--find", "c", "--for", "critical_angle=20"
        _, truth, _ = run("solve", "--json", *found, path)
        _, out, _ = run("solve", "--json", *found, *words, E)
        self.assertEqual(json.loads(out)["find"], json.loads(truth)["find"])

    def test_several_scenes(self):
        """Each has it, or is told that it has no such number, and costs its own row alone."""
        slab = ROOT / "examples" / "slab_left.yaml"
        status, out, err = run("solve", "--csv", "--set", "a=40", E, slab)
        self.assertEqual((status, len(out.splitlines())), (3, 2))
        self.assertIn("slab_left.yaml", err)
        self.assertIn("there is no 'a' here", err)
        status, out, _ = run("solve", "--csv", "--set", "friction_angle_deg=33", E, slab)
        self.assertEqual((status, [row[:3] for row in out.splitlines()[1:]]), (0, ["33,"] * (len(out.splitlines()) - 1)))

    def test_text_from_outside(self):
        """A key and a formula are texts of the user's: in CSV no formula of a spreadsheet, in Markdown no markup."""
        path = self.typed(("a: 30", "a: 30, _b_: 1"))
        for words in (("--table",), ("--csv",), ()):
            status, out, _ = run("solve", *words, "--set", "_b_=1 * 2", path)
            self.assertEqual(status, 0)
            self.assertNotIn("_b_" if "--table" in words else "\x1b", out.replace("\\_b\\_", ""))

    def test_formulas(self):
        """`derive --set` by a number leaves a symbol and moves the angles beside its formulas; by a formula in other
        parameters it takes the symbol out, as the file with that formula does, and not only in a parameter."""
        for words, changes in (
                (("--set", "a=31"), (("a: 30", "a: 31"),)),
                (("--set", "b=4*a"), (("b: 120", "b: 4*a"),)),
                (("--set", "block.teeth.height=4*a+c"), (("height: b", "height: 4*a+c"),))):
            path = self.typed(*changes)
            for form in ((), ("--latex",), ("--json",), ("--for-all", "count"), ("--limit",)):
                _, truth, _ = run("derive", *form, path)
                status, out, err = run("derive", *form, *words, E)
                self.assertEqual((status, err), (0, ""))
                self.assertEqual(out, truth)
        _, plain, _ = run("derive", E)
        self.assertIn("in a, b, c", plain)
        self.assertIn("in a, c", run("derive", "--set", "b=4*a", E)[1])

    def test_map_and_accuracy(self):
        """A map goes through what is set; an accuracy is that of the scene with it."""
        path = self.typed(("b: 120", "b: 100"), ("friction_angle_deg: 30", "friction_angle_deg: 20"))
        words = ("--set", "b=100", "--set", "friction_angle_deg=20")
        axis = ("--x", "a=25:30")
        _, truth, _ = run("chart", "map", path, *axis)
        status, out, err = run("chart", "map", E, *axis, *words)
        self.assertEqual((status, err), (0, ""))
        self.assertEqual(out, truth)
        self.assertNotEqual(out, run("chart", "map", E, *axis)[1])
        _, truth, _ = run("accuracy", "--json", path)
        status, out, err = run("accuracy", "--json", *words, E)
        self.assertEqual((status, err), (0, ""))
        told = [[r["bound"]["value"] if isinstance(r["bound"], dict) else r["bound"] for r in json.loads(t)["runs"]]
                for t in (out, truth)]
        self.assertEqual(told[0], told[1])

    def test_set_where_there_is_no_scene(self):
        for words, why in ((("chart", "fos", "--set", "a=3"), "an option for another kind of chart"),
                           (("accuracy", "--sweep", "--set", "a=3"), "--set and --unit apply to a scene"),
                           (("derive", "--set", "a", E), "--set takes KEY=VALUE")):
            status, out, err = run(*words)
            self.assertEqual((status, out), (2, ""))
            self.assertIn(why, err)
        status, out, err = run("derive", "--set", "b=4*q", E)
        self.assertEqual((status, out), (3, ""))
        self.assertIn("b=4*q: unknown name 'q'", err)

    def test_refused(self):
        for word, why in (("friction_angle_deg=95", "friction_angle_deg=95: friction_angle_deg must lie in [0°, 90°)"),
                          ("friction_angel_deg=9", "did you mean 'friction_angle_deg'?"),
                          ("a=q", "a=q: unknown name 'q'"), ("tilt=3", "this is a list or a map")):
            status, out, err = run("solve", "--set", word, E)
            self.assertEqual((status, out), (3, ""))
            self.assertIn(why, err)
        for word in ("a", "=3", "a="):
            status, out, err = run("solve", "--set", word, E)
            self.assertEqual((status, out), (2, ""))
            self.assertIn("--set takes KEY=VALUE", err)


if __name__ == "__main__":
    main()
