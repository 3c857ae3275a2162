#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The JSON Schema of what a command prints, that of the first table of results (result_tables.py).

    make_schema.py OUTPUT TABLE…"""

import json
import pathlib
import sys

from result_tables import Records

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
    if len(sys.argv) < 3:
        sys.exit("usage: make_schema.py OUTPUT TABLE…")
    write_schema(sys.argv[1], list(dict.fromkeys(sys.argv[2:])))
