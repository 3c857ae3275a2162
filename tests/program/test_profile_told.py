# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What `topple profile` tells (docs/profile.md): the paper's Table 2, the page, the figure; what it is told of a scene;
and what it refuses."""

import csv
import json
import math
import subprocess
import unittest

from harness import PROGRAM, ROOT, main, run, solve, table
from profile_case import JOINT, ProfileCase


class Table2(ProfileCase):
    """Every column: V, W, S and i by the scene, the normal stress at the tilt where the block began to move, JRC by the
    equations."""

    PRINTED = {  # V cm3, W N, S cm2, stress kPa, i, JRC by (10), (12), (14)
        "A": (86.85, 2.25, 9.0, 2.29, 18.4, 3.9, 41.9, 16.7), "B": (115.50, 2.99, 8.4, 3.43, 19.6, 4.3, 44.6, 17.7),
        "C": (258.40, 6.68, 16.0, 3.88, 19.3, 4.3, 34.6, 19.4), "D": (392.80, 10.16, 16.0, 6.12, 19.3, 4.5, 34.6, 19.4),
        "E": (220.50, 5.70, 18.0, 2.83, 9.5, 2.0, 22.2, 6.9), "F": (144.60, 3.74, 12.0, 2.92, 9.5, 2.1, 32.2, 6.9),
        "G": (150.60, 3.89, 12.0, 2.97, 9.5, 2.1, 32.2, 6.9)}
    # Misprinted: 17.4 by the table's own c / a (docs/paper.md).
    MENDED = {("C", 7): 17.4, ("D", 7): 17.4}
    LET_GO = {"A": 23.5, "B": 15.0, "C": 21.7, "D": 15.3, "E": 26.7, "F": 20.5, "G": 23.8}
    CUT_OFF = {("C", 1), ("G", 1), ("B", 4)}  # and not rounded

    def scene(self, row, tilt):
        left = "peak" if row["N"] in "24" and row["model"] in "DG" else "valley"
        return self.write(
            f"topple: 1\nlength_unit: mm\nblock:\n  teeth: {{count: {row['N']}, width: {row['a']}, height: {row['b']}, "
            f"depth: {row['c']}, left_end: {left}}}\n  thickness: 20\n  unit_weight_kn_m3: 25.872\n"
            f"base: {{mated: true}}\nfriction_angle_deg: 30\ntilt: {{towards: left, angle_deg: {tilt}}}\n", "scene.yaml")

    def test_every_column(self):
        rows = table("table1.csv")
        self.assertEqual(len(rows), 7)
        for row in rows:
            name = row["model"]
            path = self.scene(row, self.LET_GO[name])
            solved, found = solve(path)["cases"][0], self.profile(path, "--jcs", "120")
            by = {own["equation"]: own["jrc"]["value"] for own in found["jrc"]["correlations"]}
            stress = found["jrc"]["eq_10"]["normal_stress_kpa"]
            own = (1e6 * 0.02 * solved["block"]["area_m2"]["value"], solved["block"]["weight_n"]["value"],
                   0.2 * found["length"]["value"], stress, found["effective_angle_deg"]["value"],
                   found["jrc"]["eq_10"]["jrc"]["value"], by["A/(2.05 L^0.917)"], by["32.2 + 32.47 log10 Z2"])
            self.assertEqual(found["jrc"]["eq_10"]["jcs_mpa"], 120)
            for k, (printed, computed) in enumerate(zip(self.PRINTED[name], own)):
                digits = 2 if k in (0, 1, 3) else 1
                wanted = self.MENDED.get((name, k), printed)
                room = 10.0 ** -digits * (1 if (name, k) in self.CUT_OFF or k == 3 else 0.5) + 1e-9
                self.near(computed, wanted, room)

    def test_stress(self):
        """On level ground where the scene has no tilt; as given where it is given; and below JCS."""
        row = table("table1.csv")[0]
        level = self.scene(row, 0)
        weight = solve(level)["cases"][0]["block"]["weight_n"]["value"]
        found = self.profile(level, "--jcs", "120")
        self.near(found["jrc"]["eq_10"]["normal_stress_kpa"], weight / (0.045 * 0.02) / 1e3, 1e-12)
        given = self.profile(level, "--jcs", "120", "--stress", "500")
        self.near(given["jrc"]["eq_10"]["jrc"]["value"], math.degrees(math.atan(1 / 3)) / math.log10(240), 1e-12)
        self.refused(level, "below JCS", "--jcs", "0.1", "--stress", "500")
        self.assertNotIn("eq_10", self.profile(level)["jrc"])


class Refused(ProfileCase):
    def test_points(self):
        path = self.write("x,y\n0,0\n1,0.5\n2,0\n1.5,1\n3,0\n")
        self.refused(path, "profile.csv:5:1: the profile folds back: point 4 lies left of point 3")
        path = self.write("0,0\n1,0.5\n1,2\n3,0\n")
        self.refused(path, "profile.csv:3:1: the profile steps upright")
        self.refused("1,1\n", "at least two points")
        self.refused("x,y\n", "no points")
        self.refused("0,0\n1,one\n", "profile.csv:2:3")
        self.refused("0,0\n1e300,1\n1.0000000000000000001e300,0\n", "profile.csv:3:1: point 3 lies")

    def test_options(self):
        path = self.write([(k, k % 3) for k in range(30)])
        self.refused(path, "too coarse", "--step", "20")
        self.refused(path, "too fine", "--step", "1e-9")
        self.refused(path, "length_unit must be one of", "--unit", "parsec")
        self.refused(path, "a normal stress beside JCS", "--jcs", "100")
        self.refused(path, "JCS beside the normal stress", "--stress", "100")
        self.refused(ROOT / "examples" / "block_e_valley.yaml", "JCS beside", "--stress", "100")
        self.refused(ROOT / "examples" / "slab.yaml", "a scene states it length_unit", "--unit", "mm")
        for wrong in (("--step", "0"), ("--step", "-1"), ("--step", "x"), ("--scale", "0"), ("--detrend", "both"),
                      ("--resample", "fourier"), ("--window", "bartlett"), ("--jcs", "nan"), ("--all",), ("--json", "--csv"),
                      ("-o", "x.txt"), (path,)):
            self.assertEqual(run("profile", path, *wrong)[0], 2, wrong)
        self.assertEqual(run("profile")[0], 2)
        self.assertEqual(run("profile", self.folder / "nothing.csv")[0], 5)

    def test_series_that_are_not_there(self):
        found = self.profile("0,0\n1,1\n3,0\n4,1\n5,1\n")
        self.assertEqual(found["series"], "uneven")
        self.assertNotIn("spectrum", found)
        self.assertIn("--step", run("profile", self.folder / "profile.csv")[1])
        self.assertEqual(self.profile([(k, k % 2) for k in range(15)])["series"], "short")
        self.assertEqual(self.profile([(k, k % 2) for k in range(16)])["series"], "given")
        finer = self.profile([(k, k % 2) for k in range(30)], "--step", "0.1")
        self.assertIn("finer than any distance", finer["notes"][0]["text"])
        self.assertEqual(finer["notes"][0]["kind"], "caution")


class Told(ProfileCase):
    def test_page(self):
        status, out, err = run("profile", "--step", "0.5", "--mirror", "--detrend", "line", JOINT)
        self.assertEqual((status, err), (0, ""))
        for word in ("201 points every 0.5, straight between the 401", "mirrored", "least squares is subtracted",
                     "meant for it", "self-affine H"):
            self.assertIn(word, out)
        self.assertLessEqual(max(map(len, out.splitlines()[1:])), 80)  # below the path

    def test_scene(self):
        """A base profile, and a base that is mated: the piece that touches."""
        found = self.profile(ROOT / "examples" / "block_e_valley.yaml")
        self.assertEqual((found["from"], found["sampling"]["points"]), ("mated base", 4))
        scene = self.write("topple: 1\nlength_unit: m\nblock: {outline: [[1, 0], [2, 0], [2, 2], [1, 2]]}\n"
                           "base: {profile: [[0, 1], [1, 0], [2, 0], [3, 1]]}\n", "scene.yaml")
        found = self.profile(scene)
        self.assertEqual((found["from"], found["length_unit"], found["sampling"]["points"]), ("base profile", "m", 4))
        self.near(found["z2"]["value"], math.sqrt(2 / 3), 1e-15)

    def test_figure(self):
        for ending in ("svg", "pdf", "png", "csv"):
            path = self.folder / f"figure.{ending}"
            status, out, err = run("profile", JOINT, "-o", path)
            self.assertEqual((status, out, err), (0, "", ""))
            self.assertGreater(path.stat().st_size, 1000)
        rows = list(csv.DictReader((self.folder / "figure.csv").open(encoding="utf-8")))
        names = {row["quantity"] for row in rows}
        self.assertEqual(names, {"height", "slope rose", "structure function", "spectral density"})
        shares = [float(row["share"]) for row in rows if row["quantity"] == "slope rose"]
        self.near(sum(shares), 1, 1e-4)
        own = self.write(JOINT.read_text(encoding="utf-8"), "own.csv")
        status, _, err = run("profile", own, "-o", own)
        self.assertEqual(status, 3, err)

    def test_same_bytes(self):
        one, other = (subprocess.run([PROGRAM, "profile", "--json", "--all", JOINT], capture_output=True, check=True).stdout
                      for _ in range(2))
        self.assertEqual(one, other)
        json.loads(one)


if __name__ == "__main__":
    main()
