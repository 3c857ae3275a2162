# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Calls that take long: they report how far they are, and end when they are asked to.

While the library computes, Python handles no signal in the thread that called it. A long call is therefore made in a second
thread; the one that asked waits, hands on progress, and is interrupted by ctrl-C at once. The library reads the wish to stop,
and writes how far it is, in a struct of C (`topple_run`), so that its threads never wait for Python's lock."""

from __future__ import annotations

import sys
import threading
from typing import Any, Callable, Optional, TypeVar, Union

from ._library import ffi, lib

T = TypeVar("T")
#: A function that is asked now and then whether to stop: true ends the call with what is known by then.
Stop = Optional[Callable[[], bool]]
#: A function that is given how much is done, and of how much, or None where that is not known; True: a bar by tqdm, or without
#: it a line on the standard error.
Progress = Union[None, bool, Callable[[int, Optional[int]], object]]

#: Seconds between two looks at what a call has done.
PERIOD = 0.05


class Run:
    """A call under way: `c` is what its options need."""

    def __init__(self, stop: Stop = None, progress: Progress = None) -> None:
        self.c = ffi.new("topple_run *")
        self._stop = stop
        self._bar = Bar() if progress is True else None
        self._told = self._bar if isinstance(progress, bool) else progress
        self._done = 0
        self._interrupted: BaseException | None = None

    def options(self, progress: str) -> dict[str, Any]:
        """Those by which a call knows of this run; `progress` is the function of C by which it says how far it is."""
        return {"stop": ffi.addressof(lib, "run_stops"), "progress": ffi.addressof(lib, progress), "context": self.c}

    def call(self, function: Callable[..., Any], *arguments: Any, leaves: bool = False) -> None:
        """Make the call. What interrupts it (ctrl-C, an exception of `stop` or `progress`) is kept for `ended_with` where the
        call ends well all the same, with what was known by then, and is raised where it does not. A call that cannot be asked to
        stop is left (`leaves`): what it works on stays in use until it ends by itself."""
        ended = threading.Event()
        raised: list[BaseException] = []

        def work() -> None:
            try:
                function(*arguments)
            except BaseException as error:
                raised.append(error)
            finally:
                lib.tp_cleanup()
                ended.set()

        threading.Thread(target=work, name="topple", daemon=True).start()
        self._wait(ended, leaves)
        if self._bar is not None:
            self._bar.close()
        if raised or not ended.is_set():
            raise self._interrupted or raised[0]

    def ended_with(self, result: T) -> T:
        """The result of the call, unless it was interrupted."""
        if isinstance(self._interrupted, KeyboardInterrupt):
            raise Interrupted(result) from self._interrupted
        if self._interrupted is not None:
            raise self._interrupted
        return result

    def _wait(self, ended: threading.Event, leaves: bool) -> None:
        while not ended.is_set() and not (leaves and self._interrupted):
            try:
                ended.wait(PERIOD)
                self._tell()
                if self._stop is not None and self._stop():
                    self.c.stop = 1
            except BaseException as error:
                self._interrupted = self._interrupted or error
                self.c.stop = 1
                self._stop = self._told = None

    def _tell(self) -> None:
        done = self.c.done
        if self._told is not None and done != self._done:
            self._done = done
            self._told(done, self.c.of or None)


class Interrupted(KeyboardInterrupt):
    """A long call was interrupted by ctrl-C: `result` is what was known by then."""

    def __init__(self, result: object) -> None:
        super().__init__("interrupted; `result` has what was known by then")
        self.result = result


class Bar:
    """How far a call is, on the standard error: by tqdm where that is installed."""

    def __init__(self) -> None:
        self._bar: Any = None

    def __call__(self, done: int, of: int | None) -> None:
        try:
            from tqdm import tqdm  # type: ignore[import]
        except ImportError:
            sys.stderr.write(f"\r{done}" + (f" of {of}" if of is not None else ""))
            sys.stderr.flush()
            return
        if self._bar is None:
            self._bar = tqdm(total=of)
        self._bar.update(done - self._bar.n)

    def close(self) -> None:
        """End its line."""
        if self._bar is not None:
            self._bar.close()
        else:
            sys.stderr.write("\n")
