# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""`topple explain` knows every word that a user can meet: each key that a reader of files takes, each key of JSON that a
command prints, each term of the glossary, the verdicts. The glossary is what its table makes of it."""

import csv
import json
import pathlib
import re
import sys
import tempfile
import unittest

from harness import ROOT, main, run, schemas, solve

sys.path.insert(0, str(ROOT / "src" / "core" / "terms"))
import make

FILE_KEYS = make.rows("keys.csv")
TERMS = make.rows("terms.csv")
# By what the source calls the map whose keys it lists: the file, and how the path to the map begins or ends.
LISTED = re.compile(r"static const char \*const \w*(?:keys|kinds)\w*\[\] = \{([^}]*)\}")


def told(word):
    status, out, err = run("explain", *word.split())
    assert (status, err) == (0, ""), (word, err)
    return out


def last(path):
    return path.split(".")[-1].replace("[]", "")


def properties(tree):
    """The keys that a schema describes, wherever they stand in it."""
    parts = tree.values() if isinstance(tree, dict) else tree if isinstance(tree, list) else ()
    if isinstance(tree, dict) and isinstance(tree.get("properties"), dict):
        yield from tree["properties"]
    for part in parts:
        yield from properties(part)


class Explain(unittest.TestCase):
    def test_every_key_that_a_reader_knows(self):
        """Each word of each list of keys in the readers is the last step of a key of the table, and the other way round but
        for what is read by name alone, and for maps of a scene whose keys are read off the table."""
        known, explained = set(), {last(row["path"]) for row in FILE_KEYS}
        for folder in ("scene*", "study", "verify"):
            for path in sorted((ROOT / "src").glob(f"*/{folder}/*.c")):
                if path.name in ("chart.c",):  # columns of a figure's table, which nobody writes
                    continue
                for words in LISTED.findall(path.read_text(encoding="utf-8")):
                    known |= set(re.findall(r'"(\w+)"', words))
        self.assertGreater(len(known), 90)
        self.assertEqual(sorted(known - explained), [])
        code = "".join(path.read_text(encoding="utf-8") for folder in ("scene*", "study", "verify")
                       for path in (ROOT / "src").glob(f"*/{folder}/*.c"))
        made = {last(row["path"]) for row in FILE_KEYS if row["file"] == "scene"
                and "tp_key_map_" + re.sub(r"\W", "_", row["path"].rpartition(".")[0].replace("[]", "")) in code}
        self.assertEqual([word for word in sorted(explained - known - made) if f'"{word}"' not in code], [])

    def test_keys_have_pages(self):
        for row in FILE_KEYS:
            page, _, anchor = row["see"].partition("#")
            self.assertTrue((ROOT / "docs" / page).exists(), row)
            if anchor:
                headings = (re.sub(r"[^\w\s-]", "", line.lstrip("# ").lower()).strip().replace(" ", "-")
                            for line in (ROOT / "docs" / page).read_text(encoding="utf-8").splitlines() if line.startswith("#"))
                self.assertIn(anchor, list(headings), row)
            self.assertGreater(len(row["meaning"]), 3, row)

    def test_keys_are_taken(self):
        """A key of scenes at its place is none that the reader does not know: its complaint, if any, is another one."""
        count = 0
        for row in FILE_KEYS:
            if row["file"] != "scene" or row["path"].startswith(("topple", "length_unit")):
                continue
            text = "x"
            for step in reversed(row["path"].split(".")[1:] if "." in row["path"] else []):
                text = "{" + step.replace("[]", "") + ": " + (f"[{text}]" if step.endswith("[]") else text) + "}"
            with self.subTest(row["path"]):
                top = row["path"].split(".")[0]
                block = "" if top in ("block", "blocks", "blocks[]", "columns", "jointed_slope", "joints[]") else "block: {slab: {width: 1, height: 2}, unit_weight_kn_m3: 26}\n"
                if top == "joints[]":
                    block = "blocks: [{name: a, slab: {width: 1, height: 2}}]\n"
                scene = f"topple: 1\nlength_unit: m\n{block}{top.replace('[]', '')}: {text}\n"
                status, _, err = self.solve_text(scene)
                self.assertNotIn("unknown key", err)
                count += 1
        self.assertGreater(count, 100)

    def solve_text(self, text):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "scene.yaml").write_text(text, encoding="utf-8")
            return run("solve", "scene.yaml", folder=folder)

    def test_every_key_that_is_printed(self):
        """Of solutions as they come out, not as their schema has them."""
        def keys(tree):
            if isinstance(tree, dict):
                for key, part in tree.items():
                    yield key
                    yield from keys(part)
            elif isinstance(tree, list):
                for part in tree:
                    yield from keys(part)
        printed = set()
        for name in ("block_e_valley", "block_under_water", "resting_poses", "block_a_worn", "block_e_shifted"):
            printed |= set(keys(solve(f"examples/{name}.yaml", "--pivots=all")))
        printed |= set(keys(json.loads(run("tilt", "--json", "examples/tilt_block_f.yaml")[1])))
        self.assertGreater(len(printed), 150)
        for key in sorted(printed):
            if key not in ("wavelength_m",):
                self.assertIn("a result of topple", told(key), key)

    def test_every_key_of_a_schema(self):
        """All of them are in the table that the library has, each once by its place and meaning."""
        count = 0
        for path in schemas():
            schema = json.loads(path.read_text(encoding="utf-8"))
            described = set(properties(schema))
            made = {last(place) for _, place, _ in make.results(schema, path.stem)}
            self.assertEqual(sorted(described - made), [], path.name)
            count += len(made)
        self.assertGreater(count, 400)
        self.assertIn("Unit      degrees", told("onset_deg"))
        self.assertIn("Unit      m⁴", told("second_moment_xx_m4"))

    def test_terms(self):
        """By name, by symbol, by what others call it, in any case; each row is told whole."""
        listed = run("explain")[1].splitlines()
        self.assertEqual(len(listed), len(TERMS))
        for row in TERMS:
            for word in (row["term"], row["term"].upper(), *filter(None, row["synonyms"].split("; ")), *filter(None, row["symbol"].split(", "))):
                out = " ".join(told(word).split())
                self.assertIn(row["term"], out)
                self.assertIn(" ".join(make.plain(row["meaning"]).split()), out)
                for part in ("formula", "unit", "source"):
                    self.assertIn(" ".join(row[part].split()), out)
        self.assertLessEqual(max(len(line) for row in TERMS for line in told(row["term"]).splitlines() if "a result" not in line), 80)

    def test_verdicts(self):
        for word in ("stands", "slides", "topples", "slides and topples", "interlocked", "may move", "leaves its base", "undecided"):
            self.assertTrue(told(word).startswith(word + "\n"), word)

    def test_words_of_a_report_of_many_blocks(self):
        """What stands in one can be asked for as it stands there: the names of its factors and limits, of what blocks and joints do."""
        page = run("solve", "examples/blocks/toppling_slope.yaml")[1] + run("solve", "examples/blocks/wet_columns.yaml")[1]
        for word in ("driving loads", "strength reduction", "greatest dip that forces can hold", "Goodman and Bray", "support at the toe", "zones",
                     "passed on", "opens", "slips", "closed", "at rest", "slides and topples", "collapse"):
            self.assertIn(word.lower(), page.lower())
            self.assertIn("\n    ", told(word), word)
        for word in ("can be held", "may move", "stands", "collapses", "undecided", "critical horizontal acceleration", "line of thrust"):
            self.assertIn("\n    ", told(word), word)

    def test_formulas_by_numbers(self):
        """The formula of the factor, with the numbers of the slab of examples/slab.yaml put in."""
        self.assertIn("tan α_crit/tan α", told("FoS"))
        self.assertIn("mechanics sections 3 and 6", " ".join(told("fos").split()))

    def test_terms_name_keys_that_exist(self):
        keys = {last(row["path"]) for row in FILE_KEYS} | {
            last(place) for path in schemas()
            for _, place, _ in make.results(json.loads(path.read_text(encoding="utf-8")), path.stem)}
        for row in TERMS:
            self.assertEqual([key for key in row["keys"].split() if last(key) not in keys], [], row["term"])

    def test_unknown(self):
        """The nearest words are named; no word at all, and bytes, are told as what they are."""
        for word, said in (("tiltt", "nearest: 'tilt'"), ("frictoin_angle_deg", "'friction_angle_deg'"), ("qqqqqqq", "'topple explain'"),
                           ("\x1b[1m", "nothing is called '\\x1B[1m'"), ("x" * 300, "nothing is called")):
            status, out, err = run("explain", word)
            self.assertEqual((status, out), (3, ""), word)
            self.assertIn(said, err)
        self.assertEqual(run("explain", "x" * 600)[0], 2)

    def test_glossary(self):
        self.assertEqual((ROOT / "docs" / "glossary.md").read_text(encoding="utf-8"), make.glossary(),
                         "make it anew: src/core/terms/make.py glossary > docs/glossary.md")
        terms = [row["term"].lower() for row in TERMS]
        self.assertEqual(terms, sorted(terms))
        self.assertEqual(len(set(terms)), len(terms))
        self.assertGreater(len(list(csv.reader(terms))), 80)


if __name__ == "__main__":
    main()
