# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""How C and C++ are compiled to WebAssembly with Debian's clang and the C library of Debian's emscripten.

emcc itself takes a second to start, and only links. What it would pass to clang is said here.
"""

import os
import subprocess
from pathlib import Path

EMSCRIPTEN = Path("/usr/share/emscripten")
SYSROOT = EMSCRIPTEN / "cache" / "sysroot"
LLVM = Path("/usr/lib/llvm-14/bin")

TARGET = [
    "--target=wasm32-unknown-emscripten",
    f"--sysroot={SYSROOT}",
    f"-isystem{SYSROOT}/include/compat",
    "-Dunix",
    "-D__unix",
    "-D__unix__",
]
COMMON = [*TARGET, "-O2", "-ffp-contract=off", "-mllvm", "-combiner-global-alias-analysis=false", "-mllvm", "-disable-lsr"]
C = [str(LLVM / "clang"), *COMMON]
CXX = [
    str(LLVM / "clang++"),
    *COMMON,
    "-D_LIBCPP_ABI_VERSION=2",
    "-fno-threadsafe-statics",
    "-fwasm-exceptions",
]
AR = str(LLVM / "llvm-ar")
PACKAGES = ["emscripten", "dpkg-dev", "patch", "ninja-build"]


def missing_packages(packages: list[str]) -> list[str]:
    """Those of some Debian packages that are not installed."""
    asked = ["dpkg-query", "-W", "-f", "${Package} ${Status}\n", *packages]
    told = subprocess.run(asked, capture_output=True, text=True, check=False).stdout
    installed = {line.split()[0] for line in told.splitlines() if line.endswith("ok installed")}
    return [package for package in packages if package not in installed]


def version() -> str:
    """What the compiled code depends on besides its sources."""
    own = (EMSCRIPTEN / "emscripten-version.txt").read_text().strip()
    clang = subprocess.run([C[0], "--version"], capture_output=True, text=True, check=True).stdout
    return f"emscripten {own}, {clang.splitlines()[0]}"


def cache() -> Path:
    """Where what is built once is kept."""
    base = os.environ.get("TOPPLE_EXPLORER_CACHE")
    if base:
        return Path(base)
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "topple-explorer"


def written(path: Path, text: str) -> None:
    """Write a file where it does not say so already, so that its age tells when it changed."""
    if not path.exists() or path.read_text() != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
