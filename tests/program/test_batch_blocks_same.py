# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A row of a batch over many blocks states what `topple solve --json` states, cell by cell.

Once such rows had no bounds, so that rows whose factor is only bounded tied, their remark stated "at least 0.00000" where nothing is
proven, and required/FoS was empty. Here each cell is made of the JSON of `solve`, by the definitions of docs/batch.md alone."""

import csv
import io
import json
import math
import pathlib
import random
import re
import tempfile
import unittest

from harness import main, rounds, run

ORDER = ("fails", "below required", "undecided", "not solved", "holds")


def worst_verdict(case):
    """With the earthquake or without, whichever is the more severe; what forces can hold is as open as what is undecided."""
    rank = {"collapses": 0, "may move": 1, "can be held": 2, "undecided": 2, "stands": 3}
    return min((case["verdict"], case.get("static_verdict", case["verdict"])), key=rank.get)


def meets(solved):
    """In all directions."""
    said = [case.get("meets_required") for case in solved["cases"]]
    return next((word for word in ("not met", "open", "met") if word in said), None)


def standing(case, meets):
    verdict = worst_verdict(case)
    if verdict in ("collapses", "may move"):
        return "fails"
    if meets == "not met":
        return "below required"
    return "undecided" if verdict != "stands" or meets == "open" else "holds"


def share(row):
    """What rows of one standing are sorted by."""
    required = float(row["required_fos"] or 1)
    if row["fos"]:
        return (float(row["fos"]) / required,) * 2
    if row["fos_is"] != "undecided":
        return (math.inf,) * 2 if row["fos_is"] == "unbounded" else (0, 0)
    return float(row["at_most"] or math.inf) / required, float(row["at_least"] or 0) / required


def scene(draw):
    """A stack, a row, or columns on a slope, with an earthquake or without."""
    lines = ["topple: 1", "length_unit: m", "block: {unit_weight_kn_m3: 25}", f"friction_angle_deg: {draw.randint(12, 50)}"]
    kind = draw.choice(["stack", "row", "columns"])
    seismic = f"horizontal: {draw.uniform(0.02, 0.4):.2f}"
    if kind == "columns":
        lines += [f"columns: {{width: 2, step: {draw.choice([0.5, 1])}, rise: 4, fall: 1, below_crest: {draw.randint(1, 2)}, above_crest: 1}}",
                  f"slope: {{dip_deg: {draw.randint(15, 40)}, towards: left}}"]
        seismic += ", direction: " + draw.choice(["both", "down_dip", "up_dip"])
    else:
        lines += ["blocks:", "  - {name: ground, ground: true, outline: [[-9, -1], [12, -1], [12, 0], [-9, 0]]}"]
        at = [0, 0]
        for k in range(draw.randint(1, 3)):
            width, height = draw.choice([1, 1.5, 2]), draw.choice([1, 2, 3])
            lines.append(f"  - {{name: b{k}, slab: {{width: {width}, height: {height}}}, at: {at}}}")
            at = [draw.choice([0, 0.25, 0.5]), at[1] + height] if kind == "stack" else [at[0] + width, 0]
        lines.append(f"tilt: {{towards: {draw.choice(['left', 'right', 'both'])}, angle_deg: {draw.randint(0, 35)}}}")
    if draw.random() < 0.5:
        lines.append(f"loads: {{seismic: {{{seismic}}}}}")
    if draw.random() < 0.6:
        lines.append(f"required_fos: {draw.choice([1.1, 1.3, 1.5])}")
    return "\n".join(lines) + "\n"


class BatchBlocksSame(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def check_bounds(self, row, safety):
        """Both in cells, in the remark rounded outwards, and never a bound of which nothing is known."""
        for key in ("at_least", "at_most"):
            self.assertEqual(float(row[key]) if row[key] else None, safety.get(key))
        found = re.search(r"the factor of safety is(?: at least ([\d.]+))?(?: and)?(?: at most ([\d.]+))?", row["remark"])
        known = [key for key, digits in (("at_least", 1e-5), ("at_most", 0)) if safety.get(key, -1) >= digits]
        self.assertEqual([key for k, key in enumerate(("at_least", "at_most")) if found and found[k + 1]], known, row["remark"])
        if "at_least" in known:
            self.assertTrue(0 <= safety["at_least"] - float(found[1]) < 1.01e-5)
        if "at_most" in known:
            self.assertTrue(0 <= float(found[2]) - safety["at_most"] < 1.01e-5)

    def check_row(self, row, solved, text):
        safety = solved["governing_fos"]
        case = next(own for own in solved["cases"] if own["towards"] == solved["governs_towards"])
        given = re.search(r"required_fos: ([\d.]+)", text)
        fos, required = safety["fos"], given and float(given[1])
        self.assertEqual(row["towards"], case["towards"])
        self.assertEqual(float(row["dip_deg"]), case["tilt_angle_deg"]["value"])
        self.assertEqual(row["standing"], standing(case, meets(solved)))
        self.assertEqual((row["fos"], row["fos_is"]) if fos is None else (float(row["fos"]), float(row["fos_error"])),
                         ("", safety.get("fos_is")) if fos is None else (fos["value"], fos["error"]))
        self.assertEqual(row["fos_mechanism"], safety.get("mechanism") or "")
        self.assertEqual(row["meets_required"], meets(solved) or "")
        self.assertEqual(float(row["required_fos"]) if row["required_fos"] else None, required)
        if required and fos and fos["value"] > fos["error"]:
            self.assertAlmostEqual(float(row["design_utilisation"]), required / fos["value"],
                                   delta=float(row["design_utilisation_error"]) + 1e-15)
            self.assertGreaterEqual(float(row["design_utilisation_error"]), 0.99 * required * fos["error"] / fos["value"] ** 2)
        else:
            self.assertEqual(row["design_utilisation"], "")
        self.assertEqual((row["margin_deg"], row["load_case"]), ("", ""))
        self.check_bounds(row, safety)
        self.check_verdict(row, case)

    def check_verdict(self, row, case):
        verdict = worst_verdict(case)
        if verdict == "collapses":
            self.assertIn(row["verdict"], ("slides", "topples", "slides and topples", "undecided"))
        else:
            self.assertEqual(row["verdict"], {"stands": "stands", "undecided": "undecided"}.get(verdict, "may move"))

    def test_rows(self):
        draw = random.Random(59)
        texts = [scene(draw) for _ in range(rounds(12, 300))]
        for k, text in enumerate(texts):
            (self.folder / f"{k}.yaml").write_text(text, encoding="utf-8")
        table = self.folder / "table.csv"
        table.write_text("name,scene\n" + "".join(f"{k},{k}.yaml\n" for k in range(len(texts))), encoding="utf-8")
        status, out, err = run("solve", "--batch", "--csv", table)
        self.assertIn(status, (0, 1, 4), err)
        rows = list(csv.DictReader(io.StringIO(out)))
        self.assertEqual(len(rows), len(texts))
        data = json.loads(run("solve", "--batch", "--json", table)[1])["rows"]
        for row, same in zip(rows, data, strict=True):
            with self.subTest(text=texts[int(row["name"])]):
                status, out, err = run("solve", "--json", self.folder / f"{row['name']}.yaml")
                self.assertIn(status, (0, 1, 4), err)
                self.check_row(row, json.loads(out), texts[int(row["name"])])
                for key in ("at_least", "at_most"):
                    self.assertEqual(same[key], float(row[key]) if row[key] else None)
        keys = [(ORDER.index(row["standing"]), *share(row), row["name"]) for row in rows]
        self.assertEqual(keys, sorted(keys))


if __name__ == "__main__":
    main()
