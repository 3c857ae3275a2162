# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What a shared library shows, as a version script for the linker: the functions that the public headers declare and
whose names match a pattern, and nothing else.

    exports.py OUTPUT VERSION PATTERN HEADER…"""

import pathlib
import re
import sys


def declared(text):
    """The functions of a header: names before parentheses, outside of comments, directives and braces; not those that are
    compiled into the caller."""
    text = re.sub(r"/\*.*?\*/|//[^\n]*", " ", text, flags=re.DOTALL)
    text = re.sub(r'^[ \t]*#(?:.*\\\n)*.*$|^extern "C" \{$', "", text, flags=re.MULTILINE)
    inner = 1
    while inner:
        text, inner = re.subn(r"\{[^{}]*\}", " ", text)
    text = re.sub(r"\bstatic inline\b[^()]*\([^()]*\)", " ", text)
    return set(re.findall(r"\b(tp_\w+)\s*\(", text))


def main(output, version, pattern, *headers):
    names = set().union(*(declared(pathlib.Path(header).read_text(encoding="utf-8")) for header in headers))
    shown = sorted(name for name in names if re.match(pattern, name))
    lines = [f"{version} {{", "global:", *(f"  {name};" for name in shown), "local:", "  *;", "};", ""]
    pathlib.Path(output).write_text("\n".join(lines), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
