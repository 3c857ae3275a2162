# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The font files that are part of the core, as a source for the assembler. c_library/fonts.c has the table of them.

Of a font the tables are kept that draw a glyph: Cairo asks for neither kerning nor ligatures (GPOS, GSUB, kern), nor for the names
of glyphs (post), which are a tenth of a file."""

import struct
from pathlib import Path

from . import tools

FOLDER = Path("/usr/share/fonts/truetype/dejavu")
FILES = {
    "sans": "DejaVuSans.ttf",
    "sans_bold": "DejaVuSans-Bold.ttf",
    "sans_oblique": "DejaVuSans-Oblique.ttf",
    "serif": "DejaVuSerif.ttf",
    "serif_italic": "DejaVuSerif-Italic.ttf",
    "mono": "DejaVuSansMono.ttf",
}
# Debian's packages that have them.
PACKAGES = {"DejaVuSans.ttf": "fonts-dejavu-core", "DejaVuSerif-Italic.ttf": "fonts-dejavu-extra"}


def missing_packages() -> list[str]:
    return sorted(package for file, package in PACKAGES.items() if not (FOLDER / file).is_file())


KEPT = [b"OS/2", b"cmap", b"cvt ", b"fpgm", b"gasp", b"glyf", b"head", b"hhea", b"hmtx", b"loca", b"maxp", b"name", b"prep"]
RECORD = struct.Struct(">4sIII")  # a table's name, checksum, offset, length
HEAD = 12


def drawing_tables(font: bytes) -> bytes:
    """A TrueType font with the tables that are kept, in their order."""
    count = struct.unpack_from(">H", font, 4)[0]
    tables = [RECORD.unpack_from(font, HEAD + RECORD.size * k) for k in range(count)]
    tables = [(name, check, font[offset:offset + length]) for name, check, offset, length in tables if name in KEPT]
    power = len(tables).bit_length() - 1
    records, bodies = b"", b""
    for name, check, body in tables:
        records += RECORD.pack(name, check, HEAD + RECORD.size * len(tables) + len(bodies), len(body))
        bodies += body + bytes(-len(body) % 4)
    return font[:4] + struct.pack(">4H", len(tables), 16 << power, power, 16 * len(tables) - (16 << power)) + records + bodies


def datum(symbol: str, size: int, content: list[str]) -> list[str]:
    return [f".globl {symbol}", ".p2align 4", f"{symbol}:", *content, f".size {symbol}, {size}"]


def assembly(folder: Path) -> str:
    """core_font_NAME, the bytes of each file, and core_font_NAME_size, between core_fonts_begin and core_fonts_end; the files are
    written into a folder."""
    lines = ['.section .fonts,"",@', *datum("core_fonts_begin", 4, [".int32 0"])]
    for name, file in FILES.items():
        content = drawing_tables((FOLDER / file).read_bytes())
        size = len(content)
        tools.written(folder / file, content)
        lines += datum(f"core_font_{name}_size", 4, [f".int32 {size}"])
        lines += datum(f"core_font_{name}", size, [f'.incbin "{folder / file}"'])
    return "\n".join([*lines, *datum("core_fonts_end", 4, [".int32 0"])]) + "\n"
