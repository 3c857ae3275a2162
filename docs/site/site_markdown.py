# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Pages that are written for a code host's Markdown, made fit for MkDocs': the same names of headings, and lists that begin
right below a paragraph."""

import re

LIST = re.compile(r"(?:[-*]|\d+\.) ")


def slug(heading, separator):
    """What a link to a heading is called: as the host of the code does it, and as the tests of links expect."""
    return re.sub(r"[^\w\s-]", "", heading.lower()).strip().replace(" ", separator)


def spaced(text):
    """An empty line before each list, which this Markdown wants; not within code."""
    lines, in_code, in_list = [], False, False
    for line in text.splitlines():
        if line.startswith("```"):
            in_code = not in_code
        begins = LIST.match(line) is not None and not in_code
        if begins and not in_list and lines and lines[-1].strip():
            lines.append("")
        in_list = begins or (in_list and (line.startswith(" ") or not line.strip()))
        lines.append(line)
    return "\n".join(lines) + "\n"
