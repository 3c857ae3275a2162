# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The words of a PDF file by Cairo: letters of Latin 1 as they are, others as numbers of glyphs, of which the font says what they mean."""

import pathlib
import re
import zlib


def objects(data):
    """By number: what precedes the stream of an object, and that stream, inflated."""
    found = {}
    for match in re.finditer(rb"(\d+) 0 obj\s(.*?)endobj", data, re.S):
        head, _, rest = match[2].partition(b"stream\n")
        stream = rest.rpartition(b"endstream")[0]
        found[int(match[1])] = head, zlib.decompress(stream) if b"FlateDecode" in head and stream else stream
    return found


def letters_of(table):
    """By glyph, from a ToUnicode table."""
    found = {}
    for lines in re.findall(rb"beginbfchar(.*?)endbfchar", table, re.S):
        for glyph, text in re.findall(rb"<([0-9a-fA-F]+)>\s*<([0-9a-fA-F]+)>", lines):
            found[int(glyph, 16)] = bytes.fromhex(text.decode()).decode("utf-16-be")
    for lines in re.findall(rb"beginbfrange(.*?)endbfrange", table, re.S):
        for first, last, text in re.findall(rb"<([0-9a-fA-F]+)>\s*<([0-9a-fA-F]+)>\s*<([0-9a-fA-F]+)>", lines):
            for k in range(int(first, 16), int(last, 16) + 1):
                found[k] = chr(int(text, 16) + k - int(first, 16))
    return found


SHOWN = rb"/(f-\d+-\d+) [\d.]+ Tf|<([0-9a-fA-F]+)>|\(((?:\\.|[^\\()])*)\)|\s(T[dmD*]|ET)\b"


def plain(text):
    """A string of a PDF, without its escapes."""
    text = re.sub(rb"\\([0-7]{3})", lambda octal: bytes([int(octal[1], 8)]), text)
    return re.sub(rb"\\(.)", rb"\1", text).decode("cp1252", errors="replace")


def words(path):
    """All of it, in the order in which it was written, with one space between words."""
    all_objects = objects(pathlib.Path(path).read_bytes())
    tables = {}  # by the name of a font
    for head, _ in all_objects.values():
        for name, number in re.findall(rb"/(f-\d+-\d+) (\d+) 0 R", head):
            to = re.search(rb"/ToUnicode (\d+) 0 R", all_objects[int(number)][0])
            if to:
                tables[name] = letters_of(all_objects[int(to[1])][1])
    told = []
    for head, stream in all_objects.values():
        font = {}
        if b"Length1" in head or b" Tf" not in stream:
            continue
        for name, glyphs, text, moves in re.findall(SHOWN, stream):
            if name:
                font = tables.get(name, {})
            told.append(" " if moves else plain(text) if text
                        else "".join(font.get(int(glyphs[k:k + 4], 16), "") for k in range(0, len(glyphs), 4)))
    return " ".join("".join(told).split())
