#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What words mean, from the tables that say so: terms.csv (rock mechanics), keys.csv (files that are read) and the
schemas (results). `make.py c OUTPUT SCHEMA…` writes the table that the library has, `make.py glossary` prints
docs/glossary.md."""

import csv
import json
import pathlib
import re
import sys

FOLDER = pathlib.Path(__file__).resolve().parent
HEAD = """# Glossary

Terms as rock mechanics uses them, and as Topple does where the two could differ; `topple explain TERM` prints them, and
explains keys of scenes and results as well ([explain.md](explain.md)). Sections are those of [mechanics.md](mechanics.md),
equations, tables and appendices without more those of Alejano et al. ([paper.md](paper.md)); `keys` are those of scenes
and of JSON. *Also* gives what others call it; ISRM (1978) is *Suggested methods for the quantitative description of
discontinuities in rock masses*, Int. J. Rock Mech. Min. Sci. 15, 319–368. This page is made of `src/core/terms/terms.csv`.

| term | meaning |
| --- | --- |
"""
# A key of results ends in its unit; the longest end counts.
UNITS = {"deg": "degrees", "m": "m", "m2": "m²", "m4": "m⁴", "n": "N", "nm": "N m", "n_m": "N m", "kn": "kN", "kpa": "kPa", "mpa": "MPa",
         "kn_m3": "kN/m³", "g": "g", "g_per_m": "g/m", "s": "s", "m_s": "m/s", "j": "J", "hz": "Hz", "deg_min": "degrees per minute",
         "gpa_m": "GPa/m", "seconds": "s", "w_m": "weight × m", "rad_s": "rad/s"}


# What prints a schema's keys, where it is no command of that name.
COMMANDS = {"block_system": "solve", "batch": "solve --batch", "converge": "tilt --converge"}


def rows(name):
    lines = (FOLDER / name).read_text(encoding="utf-8").splitlines()
    return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def unit_of(key):
    """By the end of the key, or none."""
    if key in ("seconds",):
        return "s"
    ends = [end for end in UNITS if key.endswith("_" + end)]
    return UNITS[max(ends, key=len)] if ends else ""


def results(schema, name):
    """(path, meaning) of every key that a schema describes, as JSON has it, in its order."""
    found = []

    def follow(part):
        while "$ref" in part:
            target = schema
            for step in part["$ref"].removeprefix("#/").split("/"):
                target = target[step]
            part = target
        return part

    def walk(part, path, above):
        part = follow(part)
        if id(part) in above:
            return
        above = above | {id(part)}
        for word in ("oneOf", "anyOf", "allOf"):
            for one in part.get(word, ()):
                walk(one, path, above)
        for word in ("if", "then", "else"):
            if isinstance(part.get(word), dict):
                walk(part[word], path, above)
        if isinstance(part.get("items"), dict):
            walk(part["items"], path + "[]", above)
        for one in part.get("prefixItems", ()):
            walk(one, path + "[]", above)
        if isinstance(part.get("additionalProperties"), dict):
            walk(part["additionalProperties"], path + ".NAME", above)
        properties = part.get("properties", {})
        is_number = "value" in properties and "error" in properties
        for key, own in properties.items():
            place = f"….{key}" if is_number else f"{path}.{key}" if path else key
            entry = (place, own.get("description") or follow(own).get("description", ""))
            if entry not in found:
                found.append(entry)
            walk(own, place, above)

    walk(schema, "", frozenset())
    return [(name, *entry) for entry in found]


def plain(text):
    """Markdown as a terminal shows it."""
    text = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", text)
    return text.replace("**", "").replace("`", "'")


def literal(text):
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("??", "?\\?") + '"'


def record(*texts):
    return "    {" + ", ".join(literal(text) for text in texts) + "},\n"


def write_c(output, schemas):
    out = ["/* Made by src/core/terms/make.py; not to be edited. */\n\n#include \"terms/table.h\"\n\n"]

    def table(kind, records):
        records = list(records)
        out.append(f"const tp_{kind} tp_{kind}s[] = {{\n{''.join(records)}}};\nconst size_t tp_{kind}_count = {len(records)};\n\n")

    table("term", (record(row["term"], row["symbol"], row["synonyms"], row["unit"], row["formula"], row["source"], row["keys"],
                          plain(row["meaning"])) for row in rows("terms.csv")))
    table("file_key", (record(row["file"], row["path"], row["unit"], row["default"], row["meaning"], row["see"]) for row in rows("keys.csv")))
    found = []
    for path in sorted(map(pathlib.Path, schemas)):
        found += results(json.loads(path.read_text(encoding="utf-8")), COMMANDS.get(path.stem, path.stem))
    table("result_key", (record(name, place, unit_of(re.split(r"[.\]]", place)[-1]), plain(meaning)) for name, place, meaning in found))
    pathlib.Path(output).write_text("".join(out), encoding="utf-8")


def sentence(text):
    return text if text.endswith(".") else text + "."


def glossary():
    out = [HEAD]
    for row in rows("terms.csv"):
        symbol = f" {row['symbol']}" if row["symbol"] else ""
        parts = [row["meaning"]]
        for word, key in (("Also", "synonyms"), ("Unit", "unit"), ("Formula", "formula"), ("Source", "source")):
            if row[key]:
                parts.append(f"*{word}:* {row[key]}")
        if row["keys"]:
            parts.append("*Keys:* " + ", ".join(f"`{key}`" for key in row["keys"].split()))
        out.append(f"| **{row['term']}**{symbol} | " + " ".join(map(sentence, parts[:-1])) + (" " if parts[:-1] else "") + parts[-1] + " |\n")
    return "".join(out)


if __name__ == "__main__":
    if sys.argv[1:2] == ["c"] and len(sys.argv) > 3:
        write_c(sys.argv[2], sys.argv[3:])
    elif sys.argv[1:] == ["glossary"]:
        sys.stdout.write(glossary())
    else:
        sys.exit("usage: make.py c OUTPUT SCHEMA… | glossary")
