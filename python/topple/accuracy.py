# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Cost of accuracy: every method in every arithmetic, timed, against exact values."""

from __future__ import annotations

from ._library import ffi, lib
from .errors import checked
from .record import record
from .records import Accuracy
from .scene import Scene


def accuracy_of_scene(scene: Scene) -> Accuracy:
    """Measure every method that the scene calls for, in the first direction in which it tilts."""
    receives = ffi.new("tp_accuracy **")
    scene._use(lib.tp_accuracy_of_scene, receives, scene._c)
    owner = ffi.gc(receives[0], lib.tp_accuracy_free)
    return record(Accuracy, owner[0], owner)


def accuracy_sweep(least: int, most: int) -> Accuracy:
    """The same for blocks on rough bases of `least` to `most` vertices (10 to 10^7), in steps of
    ten."""
    receives = ffi.new("tp_accuracy **")
    checked(lib.tp_accuracy_sweep, receives, least, most)
    owner = ffi.gc(receives[0], lib.tp_accuracy_free)
    return record(Accuracy, owner[0], owner)
