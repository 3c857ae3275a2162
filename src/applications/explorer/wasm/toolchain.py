# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""How C and C++ are compiled to WebAssembly with Debian's clang and the C library of Debian's emscripten.

emcc itself takes a second to start, and only links. What it would pass to clang is said here.
"""

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
