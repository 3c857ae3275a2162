#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The C that writes the records of the tables of results (result_tables.py) as JSON, member by member, and the rows of tables as
CSV.

    make_results.py CODE,HEADER TABLE…"""

import pathlib
import re
import sys

from result_tables import Records


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
            lines = [f"if (!({c(parts[2])})) continue;", *lines]
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
                keys.append(re.sub(r"_(deg|g|n_m|m)$", "", row.key) + "_error")
        return "".join(f",{key}" for key in keys)

    def field(self, row):
        value, known = c(row.value), c(row.null) or "true"
        if row.kind in ("of case", "text of case"):
            return f"tp_csv_{row.kind.replace(' ', '_')}(t, {value}, r);"
        if row.kind == "bounded":
            return f"tp_csv_bounded(t, {known}, {value});"
        if row.kind == "number":
            return f"tp_csv_number(t, {known}, {value});"
        if row.kind == "text":
            return f"tp_csv_text(t, {known} ? {value} : NULL);"
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
    code.write_text(f"{MADE}#include \"report/results.h\"\n\n#include <math.h>\n\n{early}\n{static}{shown}", encoding="utf-8")
    declared = "".join(f"{head};\n" for head in re.findall(r"^(\w[^{}]*\)) \{$", shown, re.MULTILINE))
    guard = "TP_RESULTS_JSON_H"
    declarations.write_text(f"{MADE}#ifndef {guard}\n#define {guard}\n\n#include \"report/row.h\"\n\n{declared}\n#endif\n", encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit("usage: make_results.py CODE,HEADER TABLE…")
    write_c(sys.argv[1], sys.argv[2:])
