# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Options of the library's calls: its defaults, but for what is given."""

from __future__ import annotations

from typing import Any

from ._library import ffi, lib


def options_of(call: str, **given: Any) -> Any:
    """The options tp_CALL_options with its defaults, but for what is not None."""
    options = ffi.new(f"tp_{call}_options *")
    getattr(lib, f"tp_{call}_options_init")(options, ffi.sizeof(options[0]))
    for name, value in given.items():
        if value is not None:
            setattr(options, name, value)
    return options
