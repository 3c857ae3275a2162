# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What the builds for WebAssembly need of the machine, and where they keep what they made."""

import os
import shutil
import subprocess
from pathlib import Path

from . import toolchain

COMMANDS = {"dpkg-source": "dpkg-dev", "emcc": "emscripten", "ninja": "ninja-build", "patch": "patch"}


def missing_packages() -> list[str]:
    """Debian's names of the tools that are not here."""
    return sorted(package for command, package in COMMANDS.items() if shutil.which(command) is None)


def version() -> str:
    """What the compiled code depends on besides its sources."""
    own = (toolchain.EMSCRIPTEN / "emscripten-version.txt").read_text().strip()
    clang = subprocess.run([toolchain.C[0], "--version"], capture_output=True, text=True, check=True).stdout
    return f"emscripten {own}, {clang.splitlines()[0]}"


def cache() -> Path:
    """Where what is built once is kept."""
    base = os.environ.get("TOPPLE_EXPLORER_CACHE")
    if base:
        return Path(base)
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "topple-explorer"


def written(path: Path, content: str | bytes) -> None:
    """Write a file where it does not say so already, so that its age tells when it changed."""
    data = content.encode() if isinstance(content, str) else content
    if not path.exists() or path.read_bytes() != data:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
