# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""`topple sweep`: every row is what `topple solve --csv --set` says there, byte by byte; of slabs what closed forms say; of
the mirrored, the shifted and the rescaled scene the same; and a point that is wrong is a row of its own."""

import csv
import io
import json
import math
import os
import pathlib
import random
import subprocess
import tempfile
import unittest

from harness import PROGRAM, ROOT, main, run

E = ROOT / "examples" / "block_e_valley.yaml"
SLAB = ("topple: 1\nlength_unit: {unit}\nparameters: {{w: {w}, h: {h}, p: 30}}\n"
        "block: {{outline: [[{x0}, 0], [{x1}, 0], [{x1}, h], [{x0}, h]]}}\n"
        "friction_angle_deg: p\ntilt: {{towards: {towards}}}\n")
OWN = {"status", "first", "first_deg", "first_error", "pivot", "pivot_kind", "pivot_x_m", "pivot_x_error", "pivot_y_m",
       "pivot_y_error", "message"}  # beside the columns of `solve --csv`


def rows(text):
    return list(csv.DictReader(io.StringIO(text)))


class Sweep(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def slab(self, unit="m", w="1", h="2", x0="0", towards="left"):
        path = self.folder / "slab.yaml"
        path.write_text(SLAB.format(unit=unit, w=w, h=h, x0=x0, x1="w" if x0 == "0" else f"{x0} + w", towards=towards))
        return path

    def sweep(self, *words, status=0):
        got, out, err = run("sweep", *words)
        self.assertEqual(got, status, err)
        return rows(out)

    def test_rows_are_solves(self):
        random.seed(17)
        cases = [(E, "friction_angle_deg", "c"), (E, "a", "tilt.angle_deg"),
                 (ROOT / "examples" / "block_seismic.yaml", "loads.seismic.horizontal", "friction_angle_deg"),
                 (ROOT / "examples" / "block_a_worn.yaml", "block.rounded.corners.1.radius", "friction_angle_deg")]
        for scene, x, y in cases:
            lists = [",".join(str(random.randint(1, 90) / 4) for _ in range(3)) for _ in range(2)]
            if "seismic" in x or "radius" in x:
                lists[0] = "0.5,0.05,0.125"
            text = run("sweep", scene, "--x", f"{x}={lists[0]}", "--y", f"{y}={lists[1]}")[1]
            own = rows(text)
            k = 0
            for v in lists[1].split(","):
                for u in lists[0].split(","):
                    _, out, _ = run("solve", "--csv", "--set", f"{x}={float(u):g}", "--set", f"{y}={float(v):g}", scene)
                    for row in rows(out):
                        del row["scene"]
                        self.assertEqual({key: value for key, value in own[k].items() if key not in OWN}, row)
                        self.assertEqual(own[k]["status"], "done")
                        k += 1
            self.assertEqual(k, len(own))

    def test_closed_form(self):
        """Of a slab the critical angle is atan(w/h), the limit the lesser of that and of the friction angle."""
        for row in self.sweep(self.slab(), "--x", "w=0.2:3:0.1", "--y", "p=10:60:12.5"):
            tip = math.degrees(math.atan2(float(row["w_m"]), 2))
            slip = float(row["p"])
            self.assertLessEqual(abs(float(row["moments_deg"]) - tip), float(row["moments_error"]) + 1e-13)
            self.assertLessEqual(abs(float(row["limit_deg"]) - min(tip, slip)), float(row["limit_error"]) + 1e-13)
            self.assertEqual(row["limit_mechanism"], "topples" if tip < slip else "slides")
            self.assertLessEqual(abs(float(row["pivot_x_m"])) + abs(float(row["pivot_y_m"])), 0)

    def test_symmetry(self):
        """Mirrored, shifted, and in another unit: the same angles, bit by bit where nothing is rounded."""
        axis = ("--x", "p=10:60:5")
        truth = self.sweep(self.slab(), *axis)
        angles = ("moments_deg", "sliding_deg", "limit_deg", "certain_to_stand_deg", "limit_mechanism", "first")
        for other in (self.slab(towards="right"), self.slab(x0="1e6"), self.slab("cm", "100", "200"),
                      self.slab("ft", "1/0.3048", "2/0.3048")):
            got = self.sweep(other, *axis)
            self.assertEqual(len(got), len(truth))
            for one, two in zip(got, truth):
                for key in angles:
                    if not key.endswith("_deg"):
                        self.assertEqual(one[key], two[key])
                    else:
                        error = key[:-3] + "error"
                        bound = float(one[error]) + float(two[error])
                        self.assertLessEqual(abs(float(one[key]) - float(two[key])), bound)

    def test_exact_steps(self):
        self.assertEqual([row["w_m"] for row in self.sweep(self.slab(), "--x", "w=0.1:0.6:0.1")],
                         ["0.1", "0.2", "0.3", "0.4", "0.5", "0.6"])
        document = json.loads(run("sweep", "--json", self.slab(), "--x", "w=1:2:1/3")[1])
        self.assertEqual([point["set"][0]["formula"] for point in document["points"]], ["1", "4/3", "5/3", "2"])

    def test_wrong_points(self):
        got = self.sweep(self.slab(), "--x", "p=80:100:5", "--y", "w=0,1", status=3)
        self.assertEqual([row["status"] for row in got], ["the input is wrong"] * 5 + ["done"] * 2 + ["the input is wrong"] * 3)
        self.assertEqual([row["p"] for row in got], ["80", "85", "90", "95", "100"] * 2)
        self.assertIn("must lie in [0°, 90°)", got[9]["message"])
        self.assertEqual(got[9]["moments_deg"], "")
        document = json.loads(run("sweep", "--json", self.slab(), "--x", "p=80,90")[1])
        self.assertEqual([len(point["cases"]) for point in document["points"]], [1, 0])

    def test_undecided_points(self):
        """Digits that doubles do not have."""
        got = self.sweep(self.slab(), "--x", "w=1,2", "--level", "double", "--digits", "40", status=4)
        self.assertEqual({row["status"] for row in got}, {"undecided at the precision allowed"})

    def test_threads(self):
        words = (E, "--x", "c=0:10:0.125", "--y", "friction_angle_deg=25,99,35")
        one = run("sweep", *words, "--threads", "1")
        for count in ("2", "7"):
            self.assertEqual(run("sweep", *words, "--threads", count), one)

    def test_files(self):
        """Whole or not at all; the text is that of the standard output; a scene is not written over."""
        words = (self.slab(), "--x", "w=1:2:0.25")
        for name, form in (("t.csv", ()), ("t.json", ("--json",))):
            path = self.folder / name
            self.assertEqual(run("sweep", *words, "--output", path), (0, "", ""))
            self.assertEqual(path.read_text(encoding="utf-8"), run("sweep", *words, *form)[1])
        path = self.folder / "none.csv"
        self.assertEqual(run("sweep", self.slab(), "--x", "q=1:2:1", "--output", path)[0], 3)
        self.assertFalse(path.exists())
        self.assertEqual(run("sweep", *words, "--output", self.folder / "none" / "t.csv")[0], 5)
        self.assertEqual(sorted(os.listdir(self.folder)), ["slab.yaml", "t.csv", "t.json"])

    def test_closed_pipe(self):
        """Who reads no more ends it, with a message and without a signal."""
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = subprocess.run([PROGRAM, "sweep", E, "--x", "c=1:9:0.01"], stdout=full, stderr=subprocess.PIPE,
                                  encoding="utf-8", check=False)
        self.assertEqual(done.returncode, 5)
        self.assertIn("cannot write", done.stderr)

    def test_refused(self):
        for words, status, why in (
                ((E,), 2, "the number to sweep is missing"), ((E, "--y", "a=1,2"), 2, "--y comes beside --x"),
                ((E, "--x", "a=1,2", "--x", "b=1,2"), 2, "one --x at a time"),
                ((E, "--x", "a=1,2", "--output", "t.txt"), 2, ".csv or .json"),
                ((E, "--x", "a=1,2", "--threads", "0"), 2, "--threads takes a whole number from 1 to 1024"),
                ((E, "--x", "friction_angel_deg=1,2"), 3, "did you mean 'friction_angle_deg'?"),
                ((E, "--x", "a=1:2"), 3, "a range is written FIRST:LAST:STEP"),
                ((E, "--x", "a=1,2", "--set", "b=q"), 3, "b=q: unknown name 'q'")):
            got, out, err = run("sweep", *words)
            self.assertEqual((got, out), (status, ""), words)
            self.assertIn(why, err)


if __name__ == "__main__":
    main()
