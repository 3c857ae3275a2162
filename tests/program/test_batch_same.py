# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Rows of a batch that make the same scene are solved once: 40 000 bare names over one template took a solve each, 12 s of a slab and
hours of a wall. No test measures a time: one that solved each row by itself would not end within that of a test."""

import csv
import io
import pathlib
import random
import tempfile
import unittest

from harness import main, run

TEMPLATE = """topple: 1
length_unit: m
block: {slab: {width: 1, height: 1}, unit_weight_kn_m3: 26}
friction_angle_deg: 35
slope: {dip_deg: 20, towards: right}
"""


def wall(courses=14, bricks=8):
    """A wall of bricks in bond, of which a solve takes a good part of a second."""
    blocks = [f"  - {{name: ground, ground: true, outline: [[-9, -1], [{2 * bricks + 9}, -1], [{2 * bricks + 9}, 0], [-9, 0]]}}"]
    for course in range(courses):
        ends = [0, *range(1, 2 * bricks, 2), 2 * bricks] if course % 2 else list(range(0, 2 * bricks + 1, 2))
        blocks += [f"  - {{name: b{course}_{k}, slab: {{width: {b - a}, height: 1}}, at: [{a}, {course}]}}"
                   for k, (a, b) in enumerate(zip(ends, ends[1:]))]
    return ("topple: 1\nlength_unit: m\nblock: {unit_weight_kn_m3: 25}\nfriction_angle_deg: 35\ntilt: {towards: left, angle_deg: 5}\n"
            "blocks:\n" + "\n".join(blocks) + "\n")


class Same(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")
        return name

    def rows(self, table, *words):
        status, out, err = run("solve", "--batch", "--csv", table, *words, folder=self.folder)
        self.assertIn(status, (0, 1, 3, 4), err)
        return list(csv.DictReader(io.StringIO(out))), err

    def test_bare_names(self):
        """5000 names over a wall that takes a good part of a second: one solve."""
        self.write("wall.yaml", wall())
        table = self.write("names.csv", "name\n" + "".join(f"B{k}\n" for k in range(5000)))
        rows, _ = self.rows(table, "--template", "wall.yaml")
        self.assertEqual(len(rows), 5000)
        self.assertEqual({tuple(list(row.values())[2:]) for row in rows}, {tuple(list(rows[0].values())[2:])})
        self.assertEqual(sorted((row["name"], row["line"]) for row in rows), sorted((f"B{k}", str(k + 2)) for k in range(5000)))

    def test_rows_are_their_own(self):
        """Rows drawn from few blocks, some of which cannot be solved, with other names and notes: each is what it is in a table that
        has no other, its line and its complaint apart."""
        draw = random.Random(3)
        self.write("template.yaml", TEMPLATE)
        kinds = ["20,35", "20,", "50,35", ",35", "x,35", "20,35,", "89.5,1", "20.0,35", "20,35,,,"]
        lines = [f"{draw.choice(['', 'A', f'B{k}'])},note {k},{draw.choice(kinds)}" for k in range(120)]
        head = "name,note,dip (deg),friction (deg)\n"
        told, err = self.rows(self.write("all.csv", head + "\n".join(lines) + "\n"), "--template", "template.yaml")
        told = {int(row["line"]): row for row in told}
        self.assertEqual(sorted(told), list(range(2, 122)))
        self.assertIn("likewise in lines", err)
        for line, text in enumerate(lines, 2):
            alone, _ = self.rows(self.write("one.csv", head + text + "\n"), "--template", "template.yaml")
            own = dict(alone[0])
            own["remark"] = own["remark"].replace("one.csv:2", f"all.csv:{line}").replace("row 2", f"row {line}")
            own["name"] = own["name"].replace("row 2", f"row {line}")
            self.assertEqual(told[line], {**own, "line": str(line)}, text)

    def test_threads(self):
        """The same table by any number of threads."""
        self.write("template.yaml", TEMPLATE)
        table = self.write("all.csv", "name,dip (deg)\n" + "".join(f"B{k},{20 + k % 7}\n" for k in range(400)))
        first = self.rows(table, "--template", "template.yaml", "--threads", "1")[0]
        for threads in ("2", "5"):
            self.assertEqual(self.rows(table, "--template", "template.yaml", "--threads", threads)[0], first)


if __name__ == "__main__":
    main()
