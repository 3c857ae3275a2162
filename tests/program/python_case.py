# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The Python package of the build folder, for its tests. Where it was not built, or this Python cannot load it, they end
with a line that says so, and the status that meson takes for skipped."""

import os
import pathlib
import sys

from harness import ROOT

BUILD = pathlib.Path(os.environ.get("TOPPLE_BUILD", ROOT / "build"))
sys.path.insert(0, str(BUILD / "src" / "python"))
try:
    if not (BUILD / "src" / "python" / "topple").is_dir():
        raise ImportError("there is none in the build folder")
    import numpy
    import topple
    from topple._library import ffi, lib
except ImportError as error:
    if os.environ.get("TOPPLE_PYTHON") == "built":
        raise  # for this very Python
    print(f"skipped: the Python package is not built, or not for this Python: {error}")
    sys.exit(77)

__all__ = ["BUILD", "SOURCES", "ffi", "lib", "numpy", "topple"]
SOURCES = ROOT / "src" / "python" / "topple"
