# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Texts and files that the library writes."""

from __future__ import annotations

import pathlib
import tempfile
from typing import Any, Callable

from ._library import ffi, lib
from .errors import DependencyFailed, failure
from .given import c_path, c_text
from .options import options_of
from .record import struct_of


def written(call: Any, *arguments: Any) -> str:
    """The text of a report: a call whose first argument receives it."""
    receives = ffi.new("char **")
    status = call(receives, *arguments)
    if status:
        raise failure(status)
    return taken(receives[0])


def taken(text: Any) -> str:
    """A text that the library allocated for its caller, who gives it back here."""
    try:
        return ffi.string(text).decode("utf-8", "surrogateescape")
    finally:
        lib.tp_text_free(text)


def drawn(write: Callable[[pathlib.Path], None]) -> str:
    """The SVG that a function writes into a file."""
    with tempfile.TemporaryDirectory(prefix="topple_") as folder:
        path = pathlib.Path(folder) / "figure.svg"
        write(path)
        return path.read_text(encoding="utf-8")


def drawing() -> Any:
    """The module that draws by Cairo."""
    try:
        from . import _figure
    except ImportError as error:
        raise DependencyFailed("figures and reports need libtopple-figure, which cannot be loaded:"
                               f" {error}") from error
    own, draws = (ffi.string(text).decode() for text in (lib.tp_version(), _figure.lib.tp_figure_version()))
    if own != draws:
        raise DependencyFailed(f"figures and reports are drawn by libtopple-figure {draws}, and libtopple is {own}: install both of "
                               "the same version")
    return _figure


#: What the letterhead of a sheet can say, and how it is written: keys of the scene's `report`.
LETTERHEAD = ("language", "decimal", "company", "project", "job", "author", "checker", "logo")


def sheet_options(date: str | None, times: bool, lines: int,
                  letterhead: dict[str, str] | None = None, load_cases: Any = None) -> Any:
    """What a calculation sheet states besides results; the second holds what the first points to."""
    texts: dict[str, str | None] = {"date": date}
    for key, text in (letterhead or {}).items():
        if key != "date" and key not in LETTERHEAD:
            raise TypeError(f"a letterhead has no '{key}': it has date, {', '.join(LETTERHEAD)}")
        texts["issued" if key == "date" else key] = text
    held: dict[str, Any] = {key: c_path(text) if key == "logo" else c_text(text) for key, text in texts.items() if text is not None}
    if load_cases is not None:
        held["load_cases"] = struct_of(load_cases)
    return options_of("sheet", times=int(times), lines=lines, **held), held
