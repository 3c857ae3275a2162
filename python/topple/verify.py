# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Verdicts on printed formulas and numbers."""

from __future__ import annotations


from typing import Any

from ._library import ffi, lib
from .errors import checked
from .given import File, c_path, c_text
from .record import record
from .records import Verification


def _verified(call: Any, *arguments: Any) -> Verification:
    receives = ffi.new("tp_verification **")
    checked(call, receives, *arguments)
    owner = ffi.gc(receives[0], lib.tp_verification_free)
    return record(Verification, owner[0], owner)


def verify(path: File) -> Verification:
    """Verdicts on the claims of a file."""
    return _verified(lib.tp_verify, c_path(path))


def verify_text(text: str, name: str = "claims") -> Verification:
    """The same from text; the scenes that the claims name are looked for beside a file called
    `name`."""
    return _verified(lib.tp_verify_text, c_text(text), c_path(name))
