# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The Python package of the build folder, for its tests. Where it was not built, or this Python cannot load it, they end
with a line that says so, and the status that meson takes for skipped."""

import os
import pathlib
import re
import sys
import warnings

from harness import ROOT

BUILD = pathlib.Path(os.environ.get("TOPPLE_BUILD", ROOT / "build"))
sys.path.insert(0, str(BUILD / "python"))
try:
    if not (BUILD / "python" / "topple").is_dir():
        raise ImportError("there is none in the build folder")
    import numpy
    import topple
    from topple._library import ffi, lib
except ImportError as error:
    if os.environ.get("TOPPLE_PYTHON") == "built":
        raise  # for this very Python
    print(f"skipped: the Python package is not built, or not for this Python: {error}")
    sys.exit(77)

__all__ = ["BLOCK", "BUILD", "SOURCES", "SQUARE", "ffi", "lib", "numpy", "said", "topple"]
SOURCES = ROOT / "python" / "topple"
SQUARE = [(0, 0), (50, 0), (50, 100), (0, 100)]
BLOCK = [(0, 0), (30, 5), (60, 0), (90, 5), (90, 125), (0, 120)]


def said(scene):
    """What the solved scene says, but for places, times and notes."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", topple.Caution)
        text = (scene.solve_block_system() if scene.block_count else scene.solve()).to_json()
    text = re.sub(r'"notes": \[[^\]]*\]', "", text)
    return re.sub(r'"called_for_by": "[^"]*"|"seconds": [^,}]*', "", text)
