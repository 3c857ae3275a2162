# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The font files that are part of the core, as a source for the assembler. c_library/fonts.c has the table of them."""

from pathlib import Path

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


def datum(symbol: str, size: int, content: list[str]) -> list[str]:
    return [f".globl {symbol}", ".p2align 4", f"{symbol}:", *content, f".size {symbol}, {size}"]


def assembly() -> str:
    """core_font_NAME, the bytes of each file, and core_font_NAME_size, between core_fonts_begin and core_fonts_end."""
    lines = ['.section .fonts,"",@', *datum("core_fonts_begin", 4, [".int32 0"])]
    for name, file in FILES.items():
        size = (FOLDER / file).stat().st_size
        lines += datum(f"core_font_{name}_size", 4, [f".int32 {size}"])
        lines += datum(f"core_font_{name}", size, [f'.incbin "{FOLDER / file}"'])
    return "\n".join([*lines, *datum("core_fonts_end", 4, [".int32 0"])]) + "\n"
