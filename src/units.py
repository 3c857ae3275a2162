# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Puts the C files of a wing together into units of compilation, some eight files each.

The compiler takes longer to start and to read headers than to compile most files; a unit pays for that once. Files that
define the same name never come into one unit, nor a macro beside a file that uses its name, so that names within a
file stay free; headers are guarded and say what they need, so that their order does not matter.

    units.py UNIT.c... -- FUNCTION... -- FILE.c...

No unit defines one of the FUNCTIONs and calls it: the linker, by which tests count such calls, sees those between units.

Each unit is a list of #include, written only where it changes: what an edit does not regroup is not compiled again.
"""

import re
import sys
from pathlib import Path

ASIDE = re.compile(r"/\*.*?\*/|//[^\n]*|\"(?:[^\"\\\n]|\\.)*\"|'(?:[^'\\\n]|\\.)*'", re.S)
# What a file defines for itself. The layout is clang-format's: what begins in the first column is of the file.
DEFINED = [
    re.compile(pattern, re.M)
    for pattern in (
        r"^static\b[^;{=]*?(\w+)\s*[(\[=;,]",
        r"^(?:typedef|static)\b[^;{}]*?\(\*(\w+)\)",
        r"^typedef\b[^;{}]*?(\w+)(?:\s*__attribute__\(\([^;]*\)\))?(?:\([^;]*\))?;",
        r"^\} (\w+);",
        r"^(?:static |const |typedef )*(?:struct|union|enum) (\w+) \{",
        r"^START_TEST\((\w+)\)",
    )
]
SEVERAL = re.compile(r"^static\b([^;{}()]*,[^;{}()]*);", re.M)  # of one type, in one declaration
ENUMERATED = re.compile(r"^(?:static |typedef )*enum\s*\w*\s*\{(.*?)\}", re.M | re.S)
MACRO = re.compile(r"^\s*#\s*define\s+(\w+)", re.M)
FUNCTION = re.compile(r"^[A-Za-z_][\w *]*?(\w+)\(", re.M)
# What must be said before the first header: a unit has one such file, and that first.
BEFORE_HEADERS = re.compile(r"^#define _\w+_SOURCE\b", re.M)


class Source:
    def __init__(self, path, functions):
        text = ASIDE.sub(" ", Path(path).read_text(encoding="utf-8"))
        self.path = path
        self.lines = text.count("\n")
        self.leads = BEFORE_HEADERS.search(text) is not None
        self.defines = {name for pattern in DEFINED for name in pattern.findall(text)}
        for names in SEVERAL.findall(text):
            self.defines.update(re.findall(r"(\w+)\s*(?:\[[^\]]*\]\s*)?(?:=[^,]*)?(?:,|$)", names))
        for body in ENUMERATED.findall(text):
            self.defines.update(re.findall(r"(?:^|,)\s*(\w+)", body))
        self.macros = set(MACRO.findall(text))
        self.words = set(re.findall(r"[A-Za-z_]\w*", text))
        self.functions = functions & set(FUNCTION.findall(text))


class Unit:
    def __init__(self, path):
        self.path = Path(path)
        self.sources = []
        self.lines = 0
        self.defines, self.macros, self.words, self.functions = set(), set(), set(), set()

    def takes(self, source):
        return not (
            self.defines & source.defines
            or self.macros & source.words
            or source.macros & self.words
            or self.functions & source.words
            or source.functions & self.words
            or (source.leads and any(held.leads for held in self.sources))
        )

    def add(self, source):
        self.sources.append(source)
        self.lines += source.lines
        self.defines |= source.defines
        self.macros |= source.macros
        self.words |= source.words
        self.functions |= source.functions

    def write(self):
        ordered = sorted(self.sources, key=lambda source: (not source.leads, source.path))
        text = "".join(f'#include "{source.path}"\n' for source in ordered)
        if not self.path.exists() or self.path.read_text(encoding="utf-8") != text:
            self.path.write_text(text, encoding="utf-8")


def held_before(unit):
    """The files of a unit as it was written the last time: where they still go together, they stay."""
    return re.findall(r'"(.*)"', unit.path.read_text(encoding="utf-8")) if unit.path.exists() else []


def main():
    before = sys.argv.index("--")
    between = sys.argv.index("--", before + 1)
    units = [Unit(path) for path in sys.argv[1:before]]
    functions = set(sys.argv[before + 1 : between])
    left = {path: Source(path, functions) for path in sys.argv[between + 1 :]}
    for unit in units:
        for path in held_before(unit):
            if path in left and unit.takes(left[path]):
                unit.add(left.pop(path))
    # The longest first, each where there is least.
    for source in sorted(left.values(), key=lambda source: (-source.lines, source.path)):
        free = [unit for unit in units if unit.takes(source)]
        if not free:
            sys.exit(f"{source.path}: its names clash with a file of every unit; give the wing more units in meson.build")
        min(free, key=lambda unit: unit.lines).add(source)
    for unit in units:
        unit.write()


if __name__ == "__main__":
    main()
