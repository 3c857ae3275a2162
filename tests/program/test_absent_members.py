# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Members that a record may leave unset, in every combination, given to every writer.

A row of a batch of many blocks had no name of its load case, and the program ended by a signal. Which members may be absent is read
from the public headers: a pointer whose comment mentions NULL, what a `has_…` announces, a list that may be empty. All combinations of
them are made of rows of a batch; of larger records each by itself, and random sets. Writers run in a child process: any status will
do, a signal will not."""

import itertools
import os
import pathlib
import random
import re
import signal
import tempfile
import unittest
import warnings

from harness import ROOT, main, rounds
from python_case import ffi, topple

NULL = ffi.NULL
SECONDS = 200  # of a child, which takes a few on a quiet machine
EXAMPLES = ROOT / "examples"
MANY = """topple: 1
length_unit: m
friction_angle_deg: 35
block: {unit_weight_kn_m3: 25}
blocks:
  - {name: ground, ground: true, outline: [[-9, -1], [9, -1], [9, 0], [-9, 0]]}
  - {name: low, slab: {width: 2, height: 1}}
tilt: {towards: left, angle_deg: 10}
"""
ONE = """topple: 1
length_unit: m
block: {slab: {width: 1, height: 1}, unit_weight_kn_m3: 26}
required_fos: 1.2
friction_angle_deg: 35
slope: {dip_deg: 20, towards: right}
"""


def optional(said):
    """By struct: members whose comment in the headers says that, as a regular expression."""
    found = {}
    for header in (ROOT / "include" / "topple").glob("*.h"):
        text = header.read_text(encoding="utf-8")
        for body, name in re.findall(r"typedef struct \w+ \{\n(.*?)\n\} (\w+);", text, re.S):
            for members, comment in re.findall(r"([^;{}]*?);[ \t]*(?:\n?[ \t]*/\*(.*?)\*/)?", body, re.S):
                if re.search(said, comment):
                    found.setdefault(name, set()).update(re.findall(r"(\w+)(?:,|$)", members.split("*/")[-1]))
    return found


NULLABLE = optional(r"\bNULL\b")
MAY_BE_EMPTY = optional(r"\b0: |\b0 for |\bnone\b|\bempty\b|where there (is|are)|\bif\b")


class Switch:
    """A member, and the values that stand for its absence."""

    def __init__(self, struct, member, values, way):
        self.struct, self.member, self.values, self.way = struct, member, values, way
        self.present = getattr(struct, member)

    def restore(self):
        setattr(self.struct, self.member, self.present)


def struct_name(kind):
    return kind.cname.replace("struct ", "").strip(" *&")


def count_of(member, names):
    """The member that counts the items of a list: contact_count of contacts, count of items."""
    for name in (member + "_count", re.sub(r"ies$", "y", member) + "_count", re.sub(r"s$", "", member) + "_count",
                re.sub(r"es$", "", member) + "_count", "count"):
        if name in names:
            return name
    return None


def switches(struct, way="", kept=()):
    """All of a struct and of what it points to; of a list the first and the last item."""
    given = ffi.typeof(struct)
    kind = given.item if given.kind == "pointer" else given
    fields, found = dict(kind.fields), []
    for member, field in fields.items():
        here = f"{way}.{member}"
        if member in kept:
            continue
        of, value = field.type, getattr(struct, member)
        if of.kind == "primitive" and of.cname == "_Bool":
            if value and member.startswith("has_"):
                found.append(Switch(struct, member, [False], here))
        elif of.kind == "primitive" and (member.endswith("_count") or member == "count"):
            lists = [other for other in fields if fields[other].type.kind == "pointer" and count_of(other, fields) == member]
            empty = MAY_BE_EMPTY.get(struct_name(kind), ())
            if value and lists and any(name in empty for name in (member, *lists)):
                found.append(Switch(struct, member, [0], here))
        elif of.kind == "struct":
            found += switches(value, here, kept)
        elif of.kind == "array" and of.item.kind == "struct":
            for k in {0, of.length - 1}:
                found += switches(value[k], f"{here}[{k}]", kept)
        elif of.kind == "pointer" and value != NULL:
            if member in NULLABLE.get(struct_name(kind), ()):
                found.append(Switch(struct, member, [NULL], here))
            if of.item.kind == "struct" and of.item.fields:
                counted = count_of(member, fields)
                count = getattr(struct, counted) if counted else 1
                for k in sorted({0, count - 1} if count else ()):
                    found += switches(value[k], f"{here}[{k}]", kept)
    return found


class Absent(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)
        self.enterContext(warnings.catch_warnings())
        warnings.simplefilter("ignore", topple.Caution)

    def file(self, text, name="scene.yaml"):
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path

    def in_child(self, work, said):
        """Without a signal; what was set last is in the file `said`."""
        said.write_text("before the first", encoding="utf-8")
        child = os.fork()
        if child == 0:
            signal.alarm(SECONDS)
            try:
                work()
            except BaseException as error:  # as a status, as the child must not go on with the tests
                said.write_text(f"{said.read_text(encoding='utf-8')}: {error!r}", encoding="utf-8")
                os._exit(1)
            os._exit(0)
        _, status = os.waitpid(child, 0)
        self.assertEqual(status, 0, said.read_text(encoding="utf-8"))

    def call(self, writer):
        try:
            writer()
        except topple.ToppleError:
            pass

    def sets(self, found, seed, most):
        """Which switches are off at once, each with a value: one, then random ones."""
        draw = random.Random(seed)
        singles = [[(switch, value)] for switch in found for value in switch.values]
        yield from singles if len(singles) <= most else draw.sample(singles, most)
        for _ in range(most):
            share = draw.choice((0.02, 0.1, 0.3, 0.6, 0.95))
            yield [(switch, draw.choice(switch.values)) for switch in found if draw.random() < share]

    def every(self, record, *names, most=rounds(50, 3000), **writers):
        """All writers of a record by their names, and others, for many sets of absent members."""
        found = switches(record._c)
        self.assertGreater(len(found), 3)
        said = self.folder / "said"
        writers = {name: getattr(record, name) for name in names} | writers

        def work():
            for off in self.sets(found, 1, most):
                for switch, value in off:
                    setattr(switch.struct, switch.member, value)
                for name, writer in writers.items():
                    said.write_text(f"{name} of {', '.join(f'{switch.way} = {value}' for switch, value in off)}", encoding="utf-8")
                    self.call(writer)
                for switch, _ in reversed(off):
                    switch.restore()
        self.in_child(work, said)

    # ---- rows of a batch

    def combinations(self, batch):
        """Rows of all combinations of what the first one has."""
        row = batch._c.rows[0]
        flags = ("has_case", "has_fos_mechanism", "has_required_fos", "has_margin", "has_design_utilisation")
        texts = ("load_case", "scene")
        self.assertNotIn(NULL, [getattr(row, name) for name in texts])
        made = [(flag, text, state, standing) for flag in itertools.product((False, True), repeat=len(flags))
                for text in itertools.product((False, True), repeat=len(texts)) for state in ffi.typeof("tp_fos_state").elements
                for standing in ffi.typeof("tp_batch_standing").elements]
        rows = ffi.new("tp_batch_row[]", len(made))
        for k, (flag, text, state, standing) in enumerate(made):
            rows[k] = row
            rows[k].fos.state, rows[k].standing = state, standing
            for name, value in zip(flags, flag):
                setattr(rows[k], name, value)
            for name, value in zip(texts, text):
                if not value:
                    setattr(rows[k], name, NULL)
        return rows

    def test_batch_rows(self):
        """Every combination of absent members of a row, of one block and of many, as a table of all of them."""
        cases = "cases: [{name: static, required_fos: 1.5}, {name: b, required_fos: 1.4}]\n"
        table = self.file("name\nA\n", "survey.csv")
        said = self.folder / "said"
        for text in (ONE, MANY):
            batch = topple.batch(table, scene=self.file(text + cases))
            rows = self.combinations(batch)

            def work(batch=batch, rows=rows):
                batch._c.rows, batch._c.row_count = rows, len(rows)
                for name in ("report", "markdown", "csv", "to_json"):
                    said.write_text(name, encoding="utf-8")
                    getattr(batch, name)()
                said.write_text("page", encoding="utf-8")
                self.call(lambda: batch.write_page(self.folder / "page.html", 0))
            self.in_child(work, said)

    def test_batch(self):
        """The batch itself: its counts, faults and sources; with figures of its rows."""
        table = self.file("name,dip (deg)\nA,\nB,20\nC,x\n", "survey.csv")
        for text in (ONE, MANY):
            batch = topple.batch(table, scene=self.file(text))
            self.every(batch, "report", "markdown", "csv", "to_json")
            self.every(batch, most=rounds(1, 200), page=lambda: batch.write_page(self.folder / "page.html", 2),
                       figures=lambda: batch.write_figures(self.folder / "drawn"))

    # ---- what is solved

    def written(self, record, *scene):
        """A figure and sheets: these take longer."""
        writers = {}
        if hasattr(record, "write_figure"):
            writers["figure"] = lambda: record.write_figure(self.folder / "figure.svg")
        for ending in ("html", "md"):
            writers[ending] = lambda ending=ending: record.write_report(self.folder / f"sheet.{ending}", *scene)
        self.every(record, most=rounds(2, 300), **writers)

    def test_one_block(self):
        for name in ("slope/anchored_block", "block_e_valley", "block_seismic", "partial_contact", "resting_block"):
            scene = topple.Scene.read(EXAMPLES / f"{name}.yaml")
            solution = scene.solve(elements=name == "block_e_valley")
            self.every(solution, "report", "report_elements", "report_notes", "report_effects", "to_json", "to_json_outlines",
                       "csv", "table")
            self.written(solution)

    def test_load_cases(self):
        cases = topple.Scene.read(EXAMPLES / "slope" / "design_cases.yaml").solve_load_cases()
        self.every(cases, "report", "to_json")

    def test_many_blocks(self):
        for path in sorted((EXAMPLES / "blocks").glob("*.yaml"))[::rounds(3, 1)]:
            system = topple.Scene.read(path).solve_block_system()
            self.every(system, "report", "to_json", "to_json_outlines", "to_csv", "animation_svg", most=rounds(20, 1000))
            self.written(system)

    def test_solids(self):
        for name in ("balanced_rock", "rock_on_contacts", "rock_on_ground", "wedge", "bolted_wedge"):
            scene = topple.Scene.read(EXAMPLES / "solids" / f"{name}.yaml")
            solid = scene.solve_solid()
            self.every(solid, "report", "to_json", "csv", "row_csv", most=rounds(20, 1000))
            self.written(solid)

    # ---- what is drawn by lot, and tests

    def test_study(self):
        path = EXAMPLES / "studies" / "slab_study.yaml"
        result = topple.study(path)
        self.every(result, "report", "to_json", most=rounds(20, 1000))
        self.written(result, path)

    def test_tilt(self):
        scene = topple.Scene.read(EXAMPLES / "tilt_block_f.yaml")
        test = topple.tilt_test(scene)
        self.every(test, "report", "to_json", "csv", "frames", "animation", most=rounds(20, 1000))
        self.written(test, scene)


if __name__ == "__main__":
    main()
