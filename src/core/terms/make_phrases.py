#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The languages of calculation sheets, from phrases.csv: a row has an English phrase and what stands for it in each other
language, whose column bears its code. So a language is added by a column. A phrase is a format of printf; a translation has
the same arguments, numbered (%2$s) where they stand in another order. The row of '.' has the sign before decimals.

    make_phrases.py OUTPUT"""

import csv
import pathlib
import re
import sys

TABLE = pathlib.Path(__file__).with_name("phrases.csv")
ARGUMENT = re.compile(r"%(?:(\d+)\$)?([-+ 0#]*[\d.*]*(?:l|z)*[a-zA-Z%])")


def arguments(phrase):
    """The conversions of a format, in the order of the arguments that they take."""
    if "%" in ARGUMENT.sub("", phrase) or re.search("% |%$", phrase.replace("%%", "")):
        raise ValueError(f"a '%' that begins no argument is written '%%': {phrase!r}")
    found = [(int(number) if number else None, kind) for number, kind in ARGUMENT.findall(phrase) if kind != "%"]
    if any(number is None for number, _ in found):
        if any(number is not None for number, _ in found):
            raise ValueError(f"some arguments are numbered, others are not: {phrase!r}")
        return [kind for _, kind in found]
    if sorted(number for number, _ in found) != list(range(1, len(found) + 1)):
        raise ValueError(f"arguments are missing, or stand twice: {phrase!r}")
    return [kind for _, kind in sorted(found)]


def table():
    """The codes of the languages, and the rows, by column."""
    lines = [line for line in TABLE.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    rows = list(csv.DictReader(lines, strict=True))
    codes = list(rows[0])
    seen = set()
    for row in rows:
        english = row["en"]
        if english in seen:
            raise ValueError(f"twice: {english!r}")
        seen.add(english)
        for code in codes:
            if not row[code]:
                raise ValueError(f"no {code}: {english!r}")
            if arguments(row[code]) != arguments(english):
                raise ValueError(f"arguments of {code} are not those of {english!r}: {row[code]!r}")
    return codes, rows


def quoted(text):
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def write(output):
    codes, rows = table()
    rows.sort(key=lambda row: row["en"].encode())
    decimals = next(row for row in rows if row["en"] == ".")
    text = '/* Made by core/terms/make_phrases.py of phrases.csv; not to be edited. */\n\n#include "terms/phrases.h"\n\n#include <string.h>\n\n'
    for code in codes[1:]:
        lines = ",\n".join(f"  {{{quoted(row['en'])}, {quoted(row[code])}}}" for row in rows)
        text += f"static const tp_phrase phrases_{code}[] = {{\n{lines}}};\n\n"
    text += "const tp_language tp_languages[] = {\n"
    for code in codes:
        comma = "true" if decimals[code] == "," else "false"
        text += (f'  {{"{code}", {comma}, 0, NULL}},\n' if code == codes[0]
                 else f'  {{"{code}", {comma}, {len(rows)}, phrases_{code}}},\n')
    text += f'}};\n\nconst size_t tp_language_count = {len(codes)};\n\nconst char tp_language_codes[] = "{", ".join(codes)}";\n\n'
    text += ("const tp_language *tp_language_find(const char *code) {\n  for (size_t k = 0; k < tp_language_count; k++) {\n"
             "    if (strcmp(tp_languages[k].code, code) == 0) return tp_languages + k;\n  }\n  return NULL;\n}\n")
    pathlib.Path(output).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: make_phrases.py OUTPUT")
    try:
        write(sys.argv[1])
    except ValueError as error:
        sys.exit(f"{TABLE}: {error}")
