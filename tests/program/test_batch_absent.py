# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Batches of which anything that may be absent is: names, columns, load cases, required factors, partial factors, tilts, weights.

A batch of many blocks with two load cases of one rank ended the program, as the row had no name of its case. Every combination of what
a template and its table may leave out is made here, for one block, many blocks, a solid on a plane and on contacts, and a wedge
(a random part of them, all under `./check --long`). The program ends with a status of its own; a row that is solved has the
factor, the required result and the worst case that `solve --json` has of the scene in it."""

import itertools
import json
import math
import random
import re
import subprocess

from governing_case import GoverningCase
from harness import LONG, PROGRAM, main
from mesh_case import box
from test_solids import exact_obj

BLOCKS = {
    "one": "block: {slab: {width: 2, height: 1}%s}\n",
    "many": "block: {%s}\nblocks:\n  - {%sground: true, outline: [[-9, -1], [9, -1], [9, 0], [-9, 0]]}\n  - {%sslab: {width: 2, height: 1}}\n",
    "plane": "solid: {file: rock.obj, unit: m, azimuths: 4, bands: [0.001]%s}\n",
    "contacts": "solid: {file: rock.obj, unit: m, azimuths: 4, contacts: [{at: [0, 0, 0], normal: [0, 0, 1]}, {at: [2, 0, 0], normal: [0, 0, 1]}, "
                "{at: [2, 1, 0], normal: [0, 0, 1]}, {at: [0, 1, 0], normal: [0, 0, 1]}]%s}\n",
    "wedge": "solid: {wedge: {height: 22, a: {dip_deg: 48, dip_direction_deg: 110, friction_angle_deg: 30, cohesion_kpa: 10}, "
             "b: {dip_deg: 62, dip_direction_deg: 232, friction_angle_deg: 26, cohesion_kpa: 15}, face: {dip_deg: 68, dip_direction_deg: 180}, "
             "upper: {dip_deg: 8, dip_direction_deg: 185}}%s}\n",
}
CASES = {"none": "", "two": "cases:\n  - {name: static, required_fos: 1.5}\n  - {name: b, required_fos: 1.4}\n",
         "unlike": "cases:\n  - {name: static}\n  - {name: shaken, required_fos: 1.1, loads: {seismic: {horizontal: 0.1}}}\n"}
DESIGNS = {"none": "", "required": "required_fos: 1.3\n", "partial": "partial_factors: DA1-2\n"}
PARTS = {"kind": BLOCKS, "cases": CASES, "design": DESIGNS, "tilt": (True, False), "weight": (True, False), "friction": (True, False),
         "title": (True, False), "names": (True, False), "name": ("A", "", None), "phi": ("35", "", None), "required": (None, "1.2", ""),
         "case": (None, "static", "")}


class Absent(GoverningCase):
    def setUp(self):
        super().setUp()
        self.scene(exact_obj(*box((0, 0, 0), (2, 1, 1))), "rock.obj")

    def text(self, own):
        kind, weight = own["kind"], "unit_weight_kn_m3: 25" if own["weight"] else ""
        if kind == "many":
            block = BLOCKS[kind] % (weight, "name: ground, " if own["names"] else "", "name: low, " if own["names"] else "")
        else:
            block = BLOCKS[kind] % (f", {weight}" if weight else "")
        side = "azimuth_deg: 270" if kind in ("plane", "contacts") else "towards: left"
        tilt = f"tilt: {{{side}, angle_deg: 10}}\n" if own["tilt"] and kind != "wedge" else ""
        return ("topple: 1\nlength_unit: m\n" + ("title: of many\n" if own["title"] else "") + block + tilt +
                ("friction_angle_deg: 35\n" if own["friction"] and kind != "wedge" else "") + DESIGNS[own["design"]] + CASES[own["cases"]])

    def table(self, own):
        heads = [(head, own[key]) for head, key in (("name", "name"), ("friction", "phi"), ("required_fos", "required"), ("case", "case"))
                 if own[key] is not None]
        if not heads:
            return "thickness\n\n"
        return ",".join(head for head, _ in heads) + "\n" + ",".join(cell for _, cell in heads) + "\n"

    def ended(self, *words):
        done = subprocess.run([PROGRAM, *map(str, words)], cwd=self.folder, capture_output=True, encoding="utf-8", timeout=120, check=False)
        self.assertIn(done.returncode, (0, 1, 3, 4), (words, done.stderr[-300:]))
        self.assertNotEqual(done.returncode == 3 and "topple: " not in done.stderr, True, done.stderr)
        return done

    @staticmethod
    def factor(own):
        """Bounds of the factor that governs a scene, and whether it is met."""
        if "wedge" in own:
            safety, meets = own["wedge"], own.get("meets_required")
        elif "safety" in own:
            safety, meets = own["safety"], own.get("meets_required")
        elif "governing_fos" in own:
            said = [case["meets_required"] for case in own["cases"] if case.get("meets_required")]
            safety, meets = own["governing_fos"], next((m for m in ("not met", "open", "met") if m in said), None)
        else:
            safety = own["cases"][0]["governing_fos"]
            meets = safety.get("meets_required")
        if safety.get("fos") is not None:
            return (safety["fos"]["value"] - safety["fos"]["error"], safety["fos"]["value"] + safety["fos"]["error"]), meets
        return None, meets

    def agrees(self, row, own):
        """With the scene solved by itself: of its cases, the one of the row."""
        text = self.text(own)
        for key, phrase in (("phi", "friction_angle_deg"), ("required", "required_fos")):
            if own[key]:
                text = re.sub(rf"^{phrase}: .*\n", "", text, flags=re.M)
                if key == "required":
                    text = re.sub(r"^partial_factors: .*\n", "", text, flags=re.M)
                text = text.replace("length_unit: m\n", f"length_unit: m\n{phrase}: {own[key]}\n", 1)
        path = self.scene(text, "row.yaml")
        case = ("--case", row["load_case"]) if row.get("load_case") else ()
        done = self.ended("solve", "--json", *case, path)
        if done.returncode == 3:
            return False
        bounds, meets = self.factor(json.loads(done.stdout))
        if bounds is not None and row.get("fos") is not None:
            self.assertLessEqual(row["fos"]["value"] - row["fos"]["error"], bounds[1] * (1 + 1e-9), (text, row))
            self.assertGreaterEqual(row["fos"]["value"] + row["fos"]["error"], bounds[0] * (1 - 1e-9), (text, row))
        self.assertEqual(bounds is None, row.get("fos") is None, (text, row))
        if meets is not None and row["standing"] != "fails":
            self.assertEqual(row["standing"], {"met": "holds", "not met": "below required"}.get(meets, "undecided"), (text, row))
        return True

    def check(self, own):
        """The row by each writer; the standing of the row, or None."""
        template, table = self.scene(self.text(own), "template.yaml"), self.scene(self.table(own), "table.csv")
        words = ("solve", "--batch", table, "--template", template)
        done = self.ended(*words, "--json")
        writers = [(), ("--csv",), ("--table",), ("--output", "page.html", "--output", "page.md")]
        for more in writers if LONG else [random.Random(str(own)).choice(writers)]:
            self.assertEqual(self.ended(*words, *more).returncode, done.returncode, (own, more))
        if not done.stdout:
            return None
        (row,) = json.loads(done.stdout)["rows"] or (None,)
        if row is None or row["standing"] == "not solved":
            self.assertIn(done.returncode, (3,), (own, done.stderr))
            return None
        self.assertEqual(done.returncode, {"holds": 0, "undecided": 4}.get(row["standing"], 1), own)
        if own["cases"] == "none":
            self.assertFalse(row.get("load_case"), own)
        else:
            self.assertIn(row.get("load_case"), ("static", "b", "shaken"), own)
        return row["standing"] if self.agrees(row, own) else None

    def drawn(self, kind, count):
        """Combinations of a kind: under `--long` all of them, else some, of which each part is as likely to be there as not."""
        every = itertools.product(*(list(values) for part, values in PARTS.items() if part != "kind"))
        names = [part for part in PARTS if part != "kind"]
        if LONG:
            return [{"kind": kind} | dict(zip(names, values)) for values in every]
        draw = random.Random(kind)
        return [{"kind": kind} | {name: draw.choice([list(PARTS[name])[0], draw.choice(list(PARTS[name]))]) for name in names}
                for _ in range(count)]

    def test_combinations(self):
        seen = {}
        for kind in BLOCKS:
            for own in self.drawn(kind, 60 if kind in ("one", "many") else 4)[:None if kind in ("one", "many") else 100]:
                standing = self.check(own)
                seen.setdefault(kind, {}).setdefault(standing, []).append(own)
        for kind in ("one", "many"):
            self.assertGreater(sum(len(rows) for standing, rows in seen[kind].items() if standing), 10, kind)

    def test_solids_by_themselves(self):
        """A batch takes no solids, and says so; their scenes are solved, in every form, whatever they leave out."""
        for kind in ("plane", "contacts", "wedge"):
            for k, own in enumerate(self.drawn(kind, 16)[:400]):
                path = self.scene(self.text(own))
                first = self.ended("solve", path).returncode
                writers = [("--json",), ("--csv",), ("--quiet", "--report=sheet.html"), ("--quiet", "--report=sheet.md"), ("--quiet", "--figure=figure.svg")]
                for words in writers if LONG else [writers[k % len(writers)]]:
                    self.assertEqual(self.ended("solve", *words, path).returncode, first, (self.text(own), words))

    def test_equal_ranks(self):
        """The table of the defect, with what it leaves out: tan 35 / tan 10 in both cases, and that which requires more governs."""
        for names, title, name in itertools.product((True, False), (True, False), ("A", "", None)):
            own = {"kind": "many", "cases": "two", "design": "none", "tilt": True, "weight": True, "friction": True, "title": title,
                   "names": names, "name": name, "phi": "35", "required": None, "case": None}
            template, table = self.scene(self.text(own), "template.yaml"), self.scene(self.table(own), "table.csv")
            done = self.ended("solve", "--batch", table, "--template", template, "--json")
            (row,) = json.loads(done.stdout)["rows"]
            self.assertEqual((done.returncode, row["load_case"], row["standing"]), (0, "static", "holds"), own)
            self.assertAlmostEqual(row["fos"]["value"], math.tan(math.radians(35)) / math.tan(math.radians(10)), delta=5e-6)


if __name__ == "__main__":
    main()
