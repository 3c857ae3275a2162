# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What a word of a scene or of a report means."""

from __future__ import annotations

from ._library import ffi, lib
from .errors import checked
from .given import c_text
from .report import taken, written


def explain(word: str) -> str:
    """A term of rock mechanics, a symbol, or a key of a scene, a study or a result, as `topple
    explain` prints it: meaning, unit, formula, source. `NoAnswer` names what is nearest."""
    receives = ffi.new("char **")
    checked(lib.tp_report_explained, receives, c_text(word))
    return taken(receives[0])


def terms() -> tuple[str, ...]:
    """All terms of rock mechanics that are explained."""
    return tuple(written(lib.tp_report_terms).splitlines())
