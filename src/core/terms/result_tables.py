# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The tables of results, results/*.csv, in which each result that JSON has stands once. make_results.py, make_schema.py and
make_records.py make of them what writes, describes and mirrors it.

A table has a row for each key, in the order in which they are printed: the record that it belongs to, the key, its
type, its value in C, when it is there, how it stands on the page, and its meaning. A row without a key heads its
record: value is the type in C, `when` a call on entering it, `layout` how it is printed; of the first record, which is
what the command prints, the type is the command.

Types: bounded (a number with a proven error), factor (a tp_fos: null unless it is a number), number, fixed:N and
significant:N (so many decimals, so many digits), `number or word` (always, never: it is infinite), count (from 0; count:1
from 1), integer and integer:LEAST, truth, text, tie (bits that do not tell two results apart), range (its two ends),
fraction (of polynomials), point and ends (one point and two, of coordinates), `numbers by name` (told in a
text), `of case` and `text of case` (a number or words that a function finds of a case), a set of words.csv (with words
after a colon: these alone; after a leading comma: these besides), `one of` words, a record, and []TYPE, a list. A type
that ends in ? may be null. A key that stands twice has one type or the other.

Values: a C expression, in which .member is one of the record, *r the record, x what the report is of; for a list items
(or what is printed of item [k]) and their number, and, where some are left out, which item k stays. Empty: .key, and of
a list .key_count. After `by` the call that writes it. A dash: another file writes it.

When: a condition, else the key is absent; after a question mark a condition, else the key is null; `given`: absent where
the value is NULL.

Layout: of lists and records line, lines, list, block, aligned, flush (output/json.h); before it / for a new line, + for
the same one; of a record that is a row of a table in CSV too, csv. A key * takes in the keys of another record."""

import csv
import pathlib
import re
import sys

import make_words


def read(path):
    lines = pathlib.Path(path).read_text(encoding="utf-8").splitlines()
    return list(csv.DictReader(line for line in lines if not line.startswith("#")))


class Words:
    """The sets of words: the function of C that names them, and themselves."""

    def __init__(self):
        self.sets = {own.name: (own.named, [word.word for word in own.words]) for own in make_words.sets().values()}

    def of(self, kind):
        """(set, words) of a type; None of another one."""
        if kind.startswith("one of "):
            return None, [word.replace("\\,", ",") for word in re.split(r"(?<!\\), ", kind.removeprefix("one of "))]
        name, _, some = kind.partition(":")
        if name not in self.sets:
            return None
        function, words = self.sets[name]
        if some.startswith(" ,"):
            words = words + some[2:].strip().split(", ")
        elif some:
            words = some.strip().split(", ")
        return function, words


class Row:
    def __init__(self, row):
        self.record, self.key, self.kind = row["record"], row["key"], row["type"]
        self.value, self.meaning, self.layout = row["value"] or f".{row['key']}", row["meaning"], row["layout"].lstrip("/+")
        self.mark = row["layout"][:1] if row["layout"][:1] in ("/", "+") else ""
        self.absent, _, self.null = (part.strip() for part in row["when"].partition("?"))
        self.when = row["when"]
        self.given = self.absent == "given"
        self.is_list = self.kind.startswith("[]")
        self.item = self.kind.removeprefix("[]")


class Records:
    """The records of some tables: a head and rows for each."""

    def __init__(self, tables):
        self.heads, self.rows, self.first = {}, {}, None
        for table in tables:
            for row in map(Row, read(table)):
                if row.key:
                    self.rows[row.record].append(row)
                    continue
                if row.record in self.heads:
                    sys.exit(f"{table}: the record {row.record} stands twice")
                self.heads[row.record], self.rows[row.record] = row, []
                self.first = self.first or row.record
        self.words = Words()
        for name in self.heads.keys() & self.words.sets.keys():
            sys.exit(f"the record {name} is called as a set of words")

    def is_written(self, name):
        return self.heads[name].value != "-"

    def all_rows(self, name):
        """With those that it takes in."""
        for row in self.rows[name]:
            if row.key == "*":
                yield from self.all_rows(row.kind)
            else:
                yield row
