# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What docs/library.md promises of the public headers as a whole, read off the headers and the tables of results: a number has
one name in C, in JSON and in Python; arguments have one order in all calls; what a call makes begins with its size and lies in
nothing else, so that it can grow. Each rule is shown to find a breach."""

import csv
import re
import unittest

from harness import ROOT, main

HEADERS = "\n".join(path.read_text(encoding="utf-8") for path in sorted((ROOT / "include" / "topple").glob("topple*.h")))
CODE = re.sub(r"/\*.*?\*/", "", HEADERS, flags=re.DOTALL)
STRUCTS = dict((name, body) for body, name in re.findall(r"typedef struct \w+ \{(.*?)\} (\w+);", CODE, re.DOTALL))
#: In JSON and not in C: `from` is a word of Python, whose names are those of C; the first mechanism and its angle are by far the
#: most used members of a case; a tilt test has two axes, and verdicts are counted, each in an array by its words.
OTHER = {("profile", "from"): "origin", ("find", "from"): "low", ("find", "to"): "high", ("block_find", "from"): "low", ("block_find", "to"): "high",
         ("interval", "from"): "low",
         ("interval", "to"): "high", ("overturning_grid", "from"): "least", ("overturning_grid", "to"): "most",
         ("first", "mechanism"): "first", ("first", "critical_angle_deg"): "first_angle_deg", ("hurst", "exponent"): "estimate",
         ("claim", "computed"): "computed_there", ("case", "pivot_count"): "candidate_count"}
BY_WORD = {"tally", "shaking", "counts"}
#: A list, a number with its state, a formula with its text: what is within them has no name in JSON.
WITHIN = r"\.(items|value|formula)$|\[k\]\.density$"


def without_unit(name):
    return re.sub(r"(_[xy])?_(deg|m|n|pa|m_s2?|bits|x0_m)$", "", name)


def other_names(rows):
    """Of results that are one member of a struct: those whose key is another word than the member, but for its unit, for the
    maps of JSON by which C's name begins (limit.holds_from, limit_holds_from), and for what a list or a factor consists of."""
    for row in rows:
        record, key = row["record"], row["key"]
        value = row["value"].split(",")[0].lstrip("*&")
        if not re.fullmatch(r"(\.\w+(\[\w+\])?)+", value) or key == "*" or not key or record.endswith("_row"):
            continue
        path = re.sub(WITHIN, "", re.sub(r"\[TP_\w+\]", "", value))
        member = without_unit(re.sub(r"\[\w+\]", "", path).rpartition(".")[2])
        word = without_unit(re.sub(r"_is$", "", key))
        whole = {word, f"{record}_{word}", f"{record.split('_')[-1]}_{word}", f"fos_{word}", f"jrc_{word}", f"{word}_least",
                 f"{word.removesuffix('s')}_count", f"{word.removesuffix('_step')}", "beginnings" if word == "can_begin" else word,
                 "settings" if word == "set" else word, record if word == "is" else word,
                 f"jrc_{record}" if word == "jrc" else word}
        if OTHER.get((record, key)) != re.sub(r".*\.", "", path) and member not in whole | BY_WORD and \
                re.sub(r"_[xy]$", "", member) not in whole | {f"{record}"}:
            yield f"{record}.{key}: {value}"


def calls():
    """Every call that can fail: its name and its parameters, each as it is declared."""
    for name, parameters in re.findall(r"TP_MUST_USE tp_status (\w+)\(([^;]*)\);", CODE):
        yield name, [" ".join(parameter.split()) for parameter in parameters.split(",")]


def disorder(name, parameters):
    """What is not in its place: first what the call makes or changes, then the path of a file that it writes, then what it is
    made of, options behind that, calls back, and the message last. None where all are."""
    def rank(parameter):
        if re.search(r"tp_message \*", parameter):
            return 5
        if re.search(r"_(sink|consent) ", parameter):
            return 4
        if re.search(r"_options \*", parameter):
            return 3
        if re.match(r"const \w+_columns \*", parameter):
            return 0  # where arrays of the caller are, which it fills
        if parameter == "const char *path" and re.search(r"_(write|write_\w+|figure\w*|sheet\w*|\w+_file)$", name) \
                and not name.endswith("_of_file"):
            return 1
        return 0 if "*" in parameter and not parameter.startswith("const ") else 2
    ranks = [rank(parameter) for parameter in parameters]
    calm = [k for k in ranks if k != 3]  # a few calls are told a form beside their options
    if name in ("tp_sweep_write", "tp_sweep_write_file", "tp_report_found"):
        ranks = calm
    return None if ranks == sorted(ranks) else f"{name}({', '.join(parameters)})"


class PublicNames(unittest.TestCase):
    def rows(self):
        for path in sorted((ROOT / "src/core/terms/results").glob("*.csv")):
            yield from csv.DictReader(path.read_text(encoding="utf-8").splitlines())

    def test_json_and_c_have_one_name(self):
        """Some thousand results; `limit_back`, which JSON calls `holds_from`, is found."""
        rows = list(self.rows())
        self.assertGreater(len(rows), 900)
        self.assertEqual(list(other_names(rows)), [])
        old = [{"record": "limit", "key": "holds_from", "value": ".limit_back"},
               {"record": "rest", "key": "contacts", "value": ".touches"},
               {"record": "study_share", "key": "samples", "value": ".count"}]
        self.assertEqual(len(list(other_names(old))), 3)

    def test_arguments_have_one_order(self):
        """The path of a chart stood behind the chart, and that of a figure before the scene."""
        every = dict(calls())
        self.assertGreater(len(every), 120)
        self.assertEqual([found for found in (disorder(*call) for call in every.items()) if found], [])
        self.assertIsNotNone(disorder("tp_report_chart_file", ["const tp_chart *chart", "const char *path", "tp_message *message"]))
        self.assertIsNotNone(disorder("tp_solve", ["const tp_scene *scene", "tp_solution **solution", "tp_message *message"]))
        self.assertIsNotNone(disorder("tp_find", ["tp_found **found", "const tp_find_options *options", "const tp_scene *scene"]))

    def test_results_can_grow(self):
        """What is freed by a call of its own is made by the library alone: it begins with its size, and no other struct has it
        by value or in an array; nor is a case of a solution in another struct, but by the pointer that knows its size."""
        made = [name for name in re.findall(r"void tp_\w+_free\((\w+) \*", CODE) if name in STRUCTS]
        self.assertGreater(len(made), 8)
        for name in made:
            self.assertRegex(STRUCTS[name], r"\A\s*size_t size;", name)
        for name in made + ["tp_case"]:
            for other, body in STRUCTS.items():
                self.assertNotRegex(body, rf"\b{name} \w+", f"{other} holds a {name}, which then cannot grow")
        self.assertRegex("  tp_case cases[2];", r"\btp_case \w+")
        self.assertRegex(STRUCTS["tp_solution"], r"size_t case_size;\s*tp_case \*cases;")


if __name__ == "__main__":
    main()
