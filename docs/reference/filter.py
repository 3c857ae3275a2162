# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A public header, or a page, as Doxygen wants it. Lines stay where they are, so that what it
complains of is found.

The headers are written to be read as text. A comment is about what stands on its line before it;
else about what follows, and outside of structs about every declaration up to the next empty line or
comment. What is said of several fields on one line is said of each. Backslashes and the like are
meant as they stand. Of a page, links to what is no part of the reference are their words.

    filter.py FILE"""

import pathlib
import re
import sys

COMMENT = re.compile(r"/\*(.*?)\*/", re.DOTALL)
CODE = re.compile(r"(`[^`\n]*`)")
FIELDS = re.compile(
    r"(?<=[;{/])(\s*)((?:(?:const|struct|TP_OUTSIDE) )*\w+) "
    r"((?:\**\w+(?:\[\w+\])*,\s+)+\**\w+(?:\[\w+\])*);([ \t]*/\*\*<.*?\*/)", re.DOTALL)


def plain(text):
    """A comment without what Doxygen would take for a command; code, indented or between
    backticks, as it is."""
    lines = []
    for line in text.split("\n"):
        parts = CODE.split(line)
        if not re.match(r" \* {5}", line):
            parts[::2] = [re.sub(r"[\\@<>#%&$]", r"\\\g<0>", part) for part in parts[::2]]
        lines.append("".join(parts))
    return "\n".join(lines)


def declarations(text, begin):
    """Where each declaration begins, from `begin` to the next empty line or comment."""
    stops = (text.find("\n\n", begin), text.find("/*", begin), len(text))
    starts, depth, fresh = [], 0, True
    for at in range(begin, min(stop for stop in stops if stop >= 0)):
        if fresh and not text[at].isspace():
            starts.append(at)
            fresh = False
        depth += {"{": 1, "}": -1}.get(text[at], 0)
        body = text[at] == "}" and "static inline" in text[starts[-1]:at]
        fresh = fresh or (depth == 0 and (text[at] == ";" or body))
    return starts


def is_outside(text, at):
    """No brace is open but that of extern "C"."""
    code = COMMENT.sub("", text[:at]).replace('extern "C" {', "")
    return code.count("{") == code.count("}")


def edits_of(text, comment, number):
    """Where a comment begins and ends, and what replaces it."""
    begin, end = comment.span()
    body = plain(comment[1])
    if number < 2:
        return []  # the heads of SPDX
    if number == 2:
        return [(begin - 1, end, f"/** @file\n *{body}*/")]  # from the empty line before it
    if text[text.rfind("\n", 0, begin) + 1:begin].strip():
        return [(begin, end, f"/**<{body}*/")]
    if text[end:end + 2] == "\n\n":
        return []  # about nothing
    edits = [(begin, end, f"/**{body}*/")]
    if is_outside(text, begin):
        words = " ".join(body.replace("\n *", "\n").split())
        edits += [(at, at, f"/** {words} */ ") for at in declarations(text, end)[1:]]
    return edits


def one_by_one(found):
    """`type a, b; /**< of both */` as a declaration of each with its comment, on as many lines."""
    space, kind, names, comment = found.groups()
    said = " ".join(re.sub(r"\n\s*", " ", comment).split())
    fields = " ".join(f"{kind} {name}; {said}" for name in re.split(r",\s+", names))
    return space + fields + "\n" * (found[0].count("\n") - space.count("\n"))


def converted(text):
    """The header, its comments for Doxygen."""
    edits = []
    for number, comment in enumerate(COMMENT.finditer(text)):
        edits += edits_of(text, comment, number)
    for begin, end, new in sorted(edits, reverse=True):
        text = text[:begin] + new + text[end:]
    return FIELDS.sub(one_by_one, text)


def unlinked(text):
    """The page, without links that lead out of the reference."""
    return re.sub(r"\[([^\]\n]*)\]\((?!https?:)[^)\n]*\)", r"\1", text)


def main(name):
    path = pathlib.Path(name)
    text = path.read_text(encoding="utf-8")
    sys.stdout.reconfigure(encoding="utf-8")
    print(unlinked(text) if path.suffix == ".md" else converted(text), end="")


if __name__ == "__main__":
    main(sys.argv[1])
