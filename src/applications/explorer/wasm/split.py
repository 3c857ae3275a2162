# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The core in three parts: what the first answers need, a quarter of it, with which the page begins; the rest of its functions;
and the fonts of figures. A browser reads, unpacks and compiles a part of 1.2 MB in a fraction of the time of the whole.

Binaryen's wasm-split does it, which comes with Emscripten. A function that is not in the first part is imported there from a
placeholder, by which core/program.js knows that the rest is needed."""

import subprocess
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
EXAMPLES = HERE.parents[3] / "examples"
SPLIT = ["wasm-split", *(f"--enable-{feature}" for feature in (
    "bulk-memory", "exception-handling", "multivalue", "mutable-globals", "nontrapping-float-to-int", "reference-types", "sign-ext"))]
PARTS = ("core_first.wasm", "core_rest.wasm", "core_fonts.bin")


DATA, I32_CONST, END = 11, 0x41, 0x0B


def number(module: bytes, at: int) -> tuple[int, int]:
    """A number of WebAssembly (LEB128, of an address as unsigned), and where it ends."""
    value = shift = 0
    while True:
        byte = module[at]
        at, value, shift = at + 1, value | (byte & 127) << shift, shift + 7
        if byte < 128:
            return value, at


def data_section(module: bytes) -> int:
    at = 8  # behind its head
    while module[at] != DATA:
        size, at = number(module, at + 1)
        at += size
    return number(module, at + 1)[1]


def without(module: bytes, begin: int, end: int) -> bytes:
    """The first part with zeros between two addresses, where the fonts lie: they are nothing when packed."""
    made = bytearray(module)
    count, at = number(module, data_section(module))
    cleared = 0
    for _ in range(count):
        if module[at] != 0 or module[at + 1] != I32_CONST:
            raise ValueError("a segment of data lies at no address that is known here")
        address, at = number(module, at + 2)
        if module[at] != END:
            raise ValueError("a segment of data has an address that is computed")
        size, at = number(module, at + 1)
        low, high = max(begin, address), min(end, address + size)
        if low < high:
            made[at + low - address:at + high - address] = bytes(high - low)
            cleared += high - low
        at += size
    if cleared < 0.9 * (end - begin):
        raise ValueError("the fonts do not lie in the data of the core")
    return bytes(made)


def write(build: Path) -> None:
    """BUILD/core_first.wasm, core_rest.wasm and core_fonts.bin, where the core is newer than these."""
    core, loader = build / "core_loader.wasm", build / "core_loader.js"
    parts = [build / name for name in PARTS]
    recipe = max(path.stat().st_mtime for path in (core, Path(__file__), HERE / "profile.mjs"))
    if all(part.exists() and part.stat().st_mtime >= recipe for part in parts):
        return
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        instrumented, profile, fonts, first, rest = (folder / each for each in ("instrumented", "profile", "fonts", "first", "rest"))
        subprocess.run([*SPLIT, "--instrument", core, "-o", instrumented], check=True)
        told = subprocess.run(["node", HERE / "profile.mjs", instrumented, loader, EXAMPLES, profile, fonts], check=True, stdout=subprocess.PIPE, text=True)
        subprocess.run([*SPLIT, core, "--profile", profile, "-o1", first, "-o2", rest], check=True)
        begin = int(told.stdout)
        contents = (without(first.read_bytes(), begin, begin + fonts.stat().st_size), rest.read_bytes(), fonts.read_bytes())
    for part, content in zip(parts, contents, strict=True):
        part.write_bytes(content)
