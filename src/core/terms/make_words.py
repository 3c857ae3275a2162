#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The words of the enumerations of the public headers, from words.csv, where each stands once: a set has the name of its
type without tp_; a row without a word heads it, with the beginning of its constants that Python leaves out, the functions of C
that read and name its words, and its meaning; its other rows are in the order of C.

    make_words.py c OUTPUT         the functions of C: tp_level_name(level), tp_level_read(&level, name)
    make_words.py python OUTPUT    an enumeration of Python for each set, after words.py beside the package"""

import csv
import pathlib
import sys
import textwrap

TABLE = pathlib.Path(__file__).with_name("words.csv")


class Word:
    def __init__(self, row, head):
        self.constant, self.word, self.meaning = row["constant"], row["word"], row["meaning"]
        start = head["constant"] if self.constant.startswith(head["constant"]) else "TP_"
        self.name = self.constant.removeprefix(start)


class Set:
    def __init__(self, head):
        self.head, self.name, self.meaning, self.words = head, head["set"], head["meaning"], []
        self.type, self.functions = f"tp_{self.name}", head["word"].split()
        self.named = next((function for function in self.functions if function.endswith("_name")), None)


def sets():
    """All sets by their names."""
    found = {}
    for row in csv.DictReader(TABLE.open(encoding="utf-8")):
        if row["set"] in found:
            found[row["set"]].words.append(Word(row, found[row["set"]].head))
        else:
            found[row["set"]] = Set(row)
    return found


def function(own, name):
    if name.endswith("_name"):
        cases = "".join(f'  case {word.constant}:\n    return "{word.word}";\n' for word in own.words)
        return f"const char *{name}({own.type} value) {{\n  switch (value) {{\n{cases}  }}\n  return \"unknown\";\n}}\n\n"
    tests = "".join(f'  if (strcmp(name, "{word.word}") == 0) {{\n    *value = {word.constant};\n    return true;\n  }}\n' for word in own.words)
    return f"bool {name}({own.type} *value, const char *name) {{\n  if (value == NULL || name == NULL) return false;\n{tests}  return false;\n}}\n\n"


def c():
    made = "".join(function(own, name) for own in sets().values() for name in own.functions)
    return f"/* Made by make_words.py of words.csv; not to be edited. */\n\n#include \"terms/names.h\"\n\n#include <string.h>\n\n{made}"


def python():
    out = ["# Made by src/core/terms/make_words.py of words.csv; not to be edited.\n"
           "\"\"\"The library's enumerations. A member's value is its word, as JSON and scene files have it:\n"
           "Direction(\"left\") is Direction.LEFT. Members stand in the order of C.\"\"\"\n\nfrom .word import Word\n"]
    names = []
    for own in sets().values():
        names.append("".join(part.capitalize() for part in own.name.split("_")))
        out.append(f"\n\nclass {names[-1]}(Word):\n" + textwrap.indent(textwrap.fill(f'"""{own.meaning}"""', 96), "    ") + "\n\n")
        for word in own.words:
            if word.meaning:
                out.append(textwrap.indent(textwrap.fill(word.meaning, 92), "    #: ") + "\n")
            out.append(f'    {word.name} = "{word.word}"\n')
    out.append("\n\n__all__ = [" + ", ".join(f'"{name}"' for name in names) + "]\n")
    return "".join(out)


if __name__ == "__main__":
    if len(sys.argv) != 3 or sys.argv[1] not in ("c", "python"):
        sys.exit("usage: make_words.py c|python OUTPUT")
    pathlib.Path(sys.argv[2]).write_text({"c": c, "python": python}[sys.argv[1]](), encoding="utf-8")
