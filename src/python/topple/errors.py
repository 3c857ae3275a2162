# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What a call of the library says when it does not do what was asked: a class of exception for each
status."""

from __future__ import annotations

from ._library import ffi, lib


class ToppleError(Exception):
    """The library did not do what was asked. `str()` says what, where and what to do."""


class BadInput(ToppleError, ValueError):
    """The input is wrong."""


class NoAnswer(ToppleError):
    """No answer exists."""


class Undecided(ToppleError):
    """The precision allowed does not tell."""


class OutOfMemory(ToppleError, MemoryError):
    """A request for memory failed."""


class SystemFailed(ToppleError, OSError):
    """A file cannot be read or written."""


class DependencyFailed(ToppleError, RuntimeError):
    """A library that Topple builds on, or gnuplot, failed."""


class Caution(UserWarning):
    """A warning of what may be wrong with the input, or of what an answer does not cover."""


ERRORS = {
    lib.TP_BAD_INPUT: BadInput,
    lib.TP_NO_ANSWER: NoAnswer,
    lib.TP_UNDECIDED: Undecided,
    lib.TP_OUT_OF_MEMORY: OutOfMemory,
    lib.TP_SYSTEM_FAILED: SystemFailed,
    lib.TP_DEPENDENCY_FAILED: DependencyFailed,
}
MESSAGE = ffi.typeof("tp_message *")


def failure(status: int, message=None) -> ToppleError:
    """The exception that a status other than TP_OK is, with the message of the call or the meaning
    of the status."""
    text = ffi.string(message.text if message else lib.tp_status_meaning(status))
    return ERRORS[status](text.decode("utf-8", "replace"))


def checked(call, *arguments) -> None:
    """Call with a message after the arguments; raise what it says unless the status is TP_OK."""
    message = ffi.new(MESSAGE)
    status = call(*arguments, message)
    if status:
        raise failure(status, message)
