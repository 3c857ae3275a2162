#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What is made of the tables of results, results/*.csv, in which each result that JSON has stands once:

    make_results.py c CODE,HEADER TABLE…    the C that writes a record as JSON, member by member
    make_results.py schema OUTPUT TABLE…    the JSON Schema of what a command prints, that of the first table

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
import json
import pathlib
import re
import sys

import make_words

NUMBER = {
    "description": "A computed number: the truth lies within `error` of `value`. null where it lies outside the range of a double, or "
                   "does not exist, as the key says.",
    "type": ["object", "null"], "additionalProperties": False, "required": ["value", "error"],
    "properties": {
        "value": {"description": "The number, as the nearest double.", "type": "number"},
        "error": {"description": "Proven bound of its distance from the truth.", "type": "number", "minimum": 0},
        "digits": {"description": "Where more than 15 digits were asked for (`--digits`): the truth in decimals, every digit certain.",
                   "type": "string", "pattern": r"^-?[0-9]+(\.[0-9]+)?(e[+-]?[0-9]+)?$"}}}
POINT = {
    "description": "A point.", "type": "object", "additionalProperties": False, "required": ["x_m", "y_m"],
    "properties": {"x_m": {"description": "Along the mean plane.", "$ref": "#/$defs/number"},
                   "y_m": {"description": "Normal to it.", "$ref": "#/$defs/number"}}}
FRACTION = {
    "description": "A rational function.", "type": "object", "additionalProperties": False, "required": ["numerator", "denominator"],
    "properties": {"numerator": {"description": "A polynomial in the symbols.", "type": "string"},
                   "denominator": {"description": "Likewise; 1 where there is none.", "type": "string"}}}
RANGE = {
    "description": "A range.", "type": "object", "additionalProperties": False, "required": ["least", "most"],
    "properties": {"least": {"description": "Its lower end.", "type": "number"},
                   "most": {"description": "Its upper end.", "type": "number"}}}
SHARED = {"number": NUMBER, "range": RANGE, "point": POINT, "fraction": FRACTION}
VERSION = {"description": "Version of the program that wrote this.", "type": "string"}


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


# ---- C ----------------------------------------------------------------------------------------------------------------

def c(expression):
    """A member of the record is one of *r."""
    return re.sub(r"(?<![\w\])>.])\.(?=[a-z_])", "r->", expression)


def address(value):
    """Of a record by its value."""
    return c(value.removeprefix("*") if value.startswith("*") else f"&{value}")


def in_words(function, value):
    """A value of a set as its word; what is words already stays."""
    is_text = '"' in value or re.fullmatch(r"\w+\(.*\)", value)
    return value if function is None or is_text else f"{function}({value})"


def split(value):
    """The parts of a value at its commas outside of parentheses."""
    parts, depth = [""], 0
    for letter in value:
        depth += (letter in "([") - (letter in ")]")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts]


def layout(word):
    return f"TP_JSON_{(word or 'line').upper()}"


class Writer:
    def __init__(self, records):
        self.records = records

    def simple(self, kind, key, value):
        """The call that writes a value of a type without members; None of another one."""
        words = self.records.words.of(kind)
        if words is not None:
            return f"tp_json_string(j, {key}, {in_words(words[0], value)});"
        name, _, more = kind.partition(":")
        name = name.removesuffix("?")
        if name == "text":
            return f"tp_json_string(j, {key}, {value});"
        if name in ("fixed", "significant"):
            return f"tp_json_{name}(j, {key}, {value}, {more});"
        if name in ("point", "ends", "range", "numbers by name", "number or word"):
            return f"tp_json_{name.replace(' ', '_')}(j, {key}, {value});"
        if name in ("of case", "text of case"):
            return f"tp_json_{name.replace(' ', '_')}(j, {key}, {value}, r);"
        if name == "fraction":
            return f"tp_json_fraction(j, {key}, &{value});"
        if name == "tie":
            return f"tp_json_tie(j, {key}, {value});"
        if name == "factor":
            return f"tp_json_known(j, {key}, {value}.state == TP_FOS_NUMBER, {value}.value);"
        writer = {"bounded": "bounded", "number": "double", "count": "count", "integer": "integer", "truth": "truth"}.get(name)
        return writer and f"tp_json_{writer}(j, {key}, {value});"

    def record(self, name, key, value, how):
        head = self.records.heads[name]
        return [f"tp_json_object(j, {key}, {layout(how or head.layout)});", f"members_of_{name}(j, {address(value)}, x);",
                "tp_json_close(j);"]

    def items(self, row, key, value):
        parts = split(value)
        if len(parts) == 1:
            parts = [parts[0], re.sub(r"s$", "_count", parts[0])]
        items, count = c(parts[0]), c(parts[1])
        count = f"({count})" if " " in count else count
        how = row.layout
        shape = layout("line" if how == "lines" else how)
        if how == "block or line":
            shape = f"{count} > 0 ? TP_JSON_BLOCK : TP_JSON_LINE"
        written = self.simple(row.item, "NULL", items if "[k]" in items else f"{items}[k]")
        lines = [written] if written else ["x->k = k;", *self.record(row.item, "NULL", f"*{items} + k", "")]
        if how == "lines":
            lines = ["if (k > 0) tp_json_break(j);", *lines]
        if len(parts) > 2:
            lines = [f"if (!{c(parts[2])}) continue;", *lines]
        return [f"tp_json_array(j, {key}, {shape});", f"for (size_t k = 0; k < {count}; k++) {{", *lines, "}", "tp_json_close(j);"]

    def member(self, row):
        """The statements that write a row."""
        if row.key == "*":
            return [f"members_of_{row.kind}(j, {address(row.value)}, x);"]
        key, value = f'"{row.key}"', c(row.value)
        body = [{"/": "tp_json_break(j);", "+": "tp_json_beside(j);"}[row.mark]] if row.mark else []
        if row.value.startswith("by "):
            plain = [f"{c(row.value[3:])};"]
        elif row.is_list:
            plain = self.items(row, key, row.value)
        elif row.kind in self.records.heads:
            plain = self.record(row.kind, key, value, row.layout)
        else:
            plain = [self.simple(row.kind, key, value)]
            if plain == [None]:
                sys.exit(f"{row.record}.{row.key}: there is no type {row.kind}")
        if row.null and row.kind == "bounded":
            plain = [f"tp_json_known(j, {key}, {c(row.null)}, {value});"]
        elif row.null:
            plain = [f"if ({c(row.null)}) {{", *plain, "} else {", f"tp_json_null(j, {key});", "}"]
        absent = f"({value}) != NULL" if row.given else c(row.absent)
        return [f"if ({absent}) {{", *body, *plain, "}"] if absent else body + plain

    def function(self, name):
        head, lines = self.records.heads[name], []
        if head.when:
            lines.append(f"{head.when};")
        for row in self.records.rows[name]:
            if row.value != "-":
                lines += self.member(row)
        if not any(re.search(r"(?<![\">.])\bx\b", line) for line in lines):
            lines.insert(0, "(void)x;")
        text = "".join(f"  {line}\n" for line in lines)
        return f"void members_of_{name}(tp_json *j, const {head.value} *r, tp_json_subject *x) {{\n{text}}}\n\n"

    def outer(self, name):
        """What other files call: the members of a record that stands in no other, and of what a command prints the whole."""
        declared = f"const {self.records.heads[name].value} *r, tp_json_subject *x) {{\n"
        text = f"void tp_json_members_of_{name}(tp_json *j, {declared}  members_of_{name}(j, r, x);\n}}\n\n"
        if self.records.heads[name].kind:
            text += (f"tp_status tp_json_document_of_{name}(char **text, {declared}"
                     f"  tp_json j = {{0}};\n  tp_json_report(&j);\n  members_of_{name}(&j, r, x);\n  tp_json_close(&j);\n"
                     f"  return tp_json_finish(&j, text);\n}}\n\n")
        return text


class Columns:
    """The same rows of a table in CSV: a comma before each, numbers followed by their bounds."""

    def __init__(self, records):
        self.records, self.words = records, records.words

    def names(self, name):
        keys = []
        for row in self.records.all_rows(name):
            keys.append(row.key)
            if row.kind in ("bounded", "of case"):
                keys.append(re.sub(r"_(deg|m)$", "", row.key) + "_error")
        return "".join(f",{key}" for key in keys)

    def field(self, row):
        value, known = c(row.value), c(row.null) or "true"
        if row.kind in ("of case", "text of case"):
            return f"tp_csv_{row.kind.replace(' ', '_')}(t, {value}, r);"
        if row.kind == "bounded":
            return f"tp_csv_bounded(t, {known}, {value});"
        if row.kind == "count":
            return f"tp_csv_count(t, {known}, {value});"
        return f"tp_csv_words(t, {known} ? {in_words(self.words.of(row.kind)[0], value)} : NULL);"

    def functions(self, name):
        fields = "".join(f"  {self.field(row)}\n" for row in self.records.all_rows(name))
        empty = self.names(name).count(",") * ","
        unused = "" if "x->" in fields else "  (void)x;\n"
        return (f"void tp_csv_names_of_{name}(tp_text *t) {{\n  tp_text_add(t, \"{self.names(name)}\");\n}}\n\n"
                f"void tp_csv_fields_of_{name}(tp_text *t, const {self.records.heads[name].value} *r, const tp_json_subject *x) {{\n"
                f"{unused}  if (r == NULL) {{\n    tp_text_add(t, \"{empty}\");\n    return;\n  }}\n{fields}}}\n\n")


MADE = "/* Made by core/terms/make_results.py of the tables in core/terms/results; not to be edited. */\n\n"


def write_c(sources, tables):
    """Two files, their names with a comma between: the functions, and the declarations of those that others call."""
    records = Records(tables)
    writer = Writer(records)
    written = [name for name in records.heads if records.is_written(name)]
    inner = {row.item for name in written for row in records.rows[name] if row.value != "-"}
    static = "".join(f"static {writer.function(name)}" for name in written)
    shown = "".join(writer.outer(name) for name in written if name not in inner)
    shown += "".join(Columns(records).functions(name) for name in written if records.heads[name].layout == "csv")
    early = "".join(f"static void members_of_{name}(tp_json *, const {records.heads[name].value} *, tp_json_subject *);\n" for name in written)
    code, declarations = map(pathlib.Path, sources.split(","))
    code.write_text(f"{MADE}#include \"report/results.h\"\n\n{early}\n{static}{shown}", encoding="utf-8")
    declared = "".join(f"{head};\n" for head in re.findall(r"^(\w[^{}]*\)) \{$", shown, re.MULTILINE))
    guard = "TP_RESULTS_JSON_H"
    declarations.write_text(f"{MADE}#ifndef {guard}\n#define {guard}\n\n#include \"report/row.h\"\n\n{declared}\n#endif\n", encoding="utf-8")


# ---- JSON Schema ------------------------------------------------------------------------------------------------------

class Schema:
    def __init__(self, records):
        self.records, self.used = records, []

    def of(self, kind, null):
        """The schema of a type, which may be null."""
        if kind in ("bounded", "factor"):
            self.use("number")
            return {"$ref": "#/$defs/number"}
        if kind in ("point", "fraction", "range"):
            self.use(kind)
            own = {"$ref": f"#/$defs/{kind}"}
            return {"oneOf": [own, {"type": "null"}]} if null else own
        if kind == "of case":
            return self.of("bounded", True)
        if kind == "number or word":
            return {"anyOf": [{"type": "number"}, {"enum": ["always", "never"]}]}
        if kind == "numbers by name":
            return {"type": "object", "additionalProperties": {"type": "number"}, "minProperties": 1}
        if kind == "ends":
            return {"type": "array", "items": self.of("point", False), "minItems": 2, "maxItems": 2}
        if kind.startswith("[]"):
            return {"type": ["array", "null"] if null else "array", "items": self.of(kind[2:], False)}
        words = self.records.words.of(kind)
        if words is not None:
            return {"enum": words[1] + ([None] if null else [])}
        if kind in self.records.heads:
            self.use(kind)
            own = {"$ref": f"#/$defs/{kind}"}
            return {"oneOf": [own, {"type": "null"}]} if null else own
        name, _, more = kind.partition(":")
        if name == "tie":
            return {"type": "string", "pattern": "^(exact|not distinguished by [1-9][0-9]* bits)$"}
        null = null or name.endswith("?") or name == "text of case"
        name = name.removesuffix("?")
        kinds = {"text": "string", "text of case": "string", "truth": "boolean", "count": "integer", "integer": "integer",
                 "number": "number", "fixed": "number", "significant": "number"}
        own = {"type": [kinds[name], "null"] if null else kinds[name]}
        if name == "count" or more and name == "integer":
            own["minimum"] = int(more or 0)
        return own

    def use(self, name):
        if name not in self.used:
            self.used.append(name)

    def object(self, name, head=()):
        properties, required = dict(head), [key for key, _ in head]
        keys = [row.key for row in self.records.all_rows(name)]
        for row in self.records.all_rows(name):
            own = self.of(row.kind, bool(row.null))
            if row.key in properties:
                first = {key: value for key, value in properties[row.key].items() if key != "description"}
                own = {"anyOf": [first, own]}
            properties[row.key] = {"description": row.meaning, **own}
            if (not row.absent or keys.count(row.key) > 1) and row.key not in required:
                required.append(row.key)
        return {"description": self.records.heads[name].meaning, "type": "object", "additionalProperties": False, "required": required,
                "properties": properties}

    def whole(self):
        name = self.records.first
        command = self.records.heads[name].kind
        schema = {"$schema": "https://json-schema.org/draft/2020-12/schema", "$id": f"topple-{name}.json", "title": command,
                  **self.object(name, [("topple", VERSION)]), "$defs": {}}
        for used in self.used:  # grows while it is walked
            schema["$defs"][used] = SHARED.get(used) or self.object(used)
        return schema


def write_schema(output, tables):
    text = json.dumps(Schema(Records(tables)).whole(), indent=1, ensure_ascii=False)
    pathlib.Path(output).write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) > 3 and sys.argv[1] in ("c", "schema"):
        {"c": write_c, "schema": write_schema}[sys.argv[1]](sys.argv[2], list(dict.fromkeys(sys.argv[3:])))
    else:
        sys.exit("usage: results.py c|schema OUTPUT TABLE…")
