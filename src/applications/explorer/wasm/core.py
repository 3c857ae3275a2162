# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The build of Topple itself for WebAssembly: a build.ninja of the sources that the native build has."""

import json
import os
import shlex
import subprocess
from pathlib import Path

from . import fonts, toolchain, tools

HERE = Path(__file__).resolve().parent
TOP = HERE.parents[3]
BUILD = TOP / "build-explorer"
NATIVE = Path(os.environ.get("TOPPLE_BUILD", TOP / "build"))

DEFINED = [
    "-DNDEBUG",
    # Where the program would look for its own files: nowhere but in the file system in memory.
    '-DTP_LIBRARY_FOLDER="/lib"',
    '-DTP_LIBRARY_FROM_PROGRAM="lib"',
    '-DTP_DATA_FOLDER="/share"',
    '-DTP_DATA_FROM_PROGRAM="share"',
    '-DTP_SOURCE_FROM_BUILD="source"',
    '-DTP_FIGURE_LIBRARY="libtopple-figure.so.0"',
    '-DTP_HDF5_LIBRARY="libtopple-hdf5.so"',
    '-DTP_RANKS_LIBRARY="libtopple-ranks.so"',
    '-DTP_TRACE_LIBRARY="libtopple-trace.so"',
    '-DTP_XLSX_LIBRARY="libtopple-xlsx.so"',
]
# Instead of what needs GDAL, whose library the native program loads; and what loads others, of which there is none.
ABSENT = [TOP / "src" / "input" / "format" / "gis_absent.c", TOP / "src" / "core" / "common" / "library_beside.c"]
# It draws in another process, by a library that it loads; c_library/draw.c stands in its place.
REPLACED = [TOP / "src" / "applications" / "cli" / "draw.c"]
# CGAL's filters need directed rounding, which WebAssembly has not: they then widen each result by one double to either
# side, which holds for all that is rounded to nearest.
CGAL = [
    "-DCGAL_ALWAYS_ROUND_TO_NEAREST",
    "-DCGAL_DISABLE_ROUNDING_MATH_CHECK",
    "-DCGAL_HEADER_ONLY",
    "-DBOOST_NO_CXX98_FUNCTION_BASE",
]
EIGEN = Path("/usr/include/eigen3")  # headers alone, of the native build too
# An archive comes before those that it calls.
LIBRARIES = ["argp", "calcium", "arb", "flint", "mpfr", "gmp", "gsl", "cxsparse", "yaml", "expat", "dxflib", "cairo", "pixman", "freetype", "png", "zlib"]
LINKED = [
    "-O2",
    "-fwasm-exceptions",
    "-sSUPPORT_LONGJMP=wasm",
    "-Wl,--wrap=cairo_select_font_face,--wrap=dlopen,--wrap=dlsym,--wrap=dlerror",
    "-sALLOW_MEMORY_GROWTH=1",
    "-sMAXIMUM_MEMORY=2147483648",
    "-sTOTAL_STACK=8388608",
    "-sMODULARIZE=1",
    "-sEXPORT_NAME=createCore",
    "-sINVOKE_RUN=0",
    "-sEXIT_RUNTIME=1",
    "-sFORCE_FILESYSTEM=1",
    "-sENVIRONMENT=worker,node",
    "-sEXPORTED_RUNTIME_METHODS=ENV,FS,stackSave,stackRestore,stackAlloc",
    "-sEXPORTED_FUNCTIONS=_main,_malloc,_core_run,_core_data_end,_core_fonts",
]


def targets() -> dict[str, list[str]]:
    """The sources of the targets of the native build that the core is made of."""
    asked = ["meson", "introspect", "--targets", str(NATIVE)]
    told = json.loads(subprocess.run(asked, capture_output=True, text=True, check=True).stdout)
    libraries = {(name, "static library") for name in ("topple-geom", "topple-geom-solid", "topple-events", "topple-margins", "topple", "topple-figure")}
    wanted = libraries | {("topple", "executable")}
    # A unit of several files: the files of its wing (src/units.py).
    units = {
        unit: [file for part in target["target_sources"] for file in part["sources"]]
        for target in told
        if target["name"].endswith("-units")
        for unit in target["filename"]
    }
    sources = {}
    for target in told:
        if (target["name"], target["type"]) in wanted:
            sources[f"{target['name']} {target['type']}"] = sorted({
                file
                for part in target["target_sources"]
                for made in part["sources"] + part["generated_sources"]
                for file in units.get(made, [made])
                if not file.endswith(".h")
            })
    if len(sources) != len(wanted):
        raise SystemExit(f"{NATIVE} lacks targets of the core; run ./run --setup")
    return sources


RULES = """
rule cc
  command = {c} -MD -MF $out.d $flags -c $in -o $out
  depfile = $out.d
  deps = gcc
rule cxx
  command = {cxx} -MD -MF $out.d $flags -c $in -o $out
  depfile = $out.d
  deps = gcc
rule as
  command = {c} -Wno-unused-command-line-argument -c $in -o $out
rule link
  command = NODE_PATH=/usr/share/nodejs em++ @$out.objects $flags -o $out
  rspfile = $out.objects
  rspfile_content = $in
"""


def linked(libraries: Path) -> Path:
    """A link to the libraries that keeps its name: where their recipe changes, only what includes other headers is compiled anew."""
    link = BUILD / "libraries"
    BUILD.mkdir(parents=True, exist_ok=True)
    if not link.is_symlink() or link.readlink() != libraries:
        link.unlink(missing_ok=True)
        link.symlink_to(libraries)
    return link


def write_ninja(libraries: Path) -> None:
    """BUILD/build.ninja, with the libraries of a folder."""
    wings = sorted((TOP / "src").iterdir()) + sorted((NATIVE / "src").iterdir())  # and what is made in them
    include = [f"-I{TOP}/include/topple", *(f"-I{wing}" for wing in wings), f"-isystem{linked(libraries)}/include"]
    own = [*DEFINED, *include, "-Wall", "-Wno-unknown-pragmas"]
    lines = [RULES.format(c=shlex.join(toolchain.C), cxx=shlex.join(toolchain.CXX))]
    lines.append(f"flags_c = {shlex.join([*own, '-include', f'{HERE}/c_library/sort.h', '-std=gnu17'])}")
    lines.append(f"flags_cpp = {shlex.join([*own, f'-isystem{EIGEN}', *CGAL, '-std=c++17'])}")
    objects = []
    sources = sorted({file for files in targets().values() for file in files})
    sources += [str(file) for file in [*ABSENT, *sorted((HERE / "c_library").glob("*.c"))]]
    for source in sources:
        if Path(source) in REPLACED:
            continue
        inside = Path(source)
        name = inside.relative_to(TOP) if inside.is_relative_to(TOP) else inside.name
        language = "cpp" if inside.suffix == ".cpp" else "c"
        made = f"objects/{name}.o"
        lines += [f"build {made}: {'cxx' if language == 'cpp' else 'cc'} {source}", f"  flags = $flags_{language}"]
        objects.append(made)
    tools.written(BUILD / "fonts.s", fonts.assembly(BUILD / "fonts"))
    lines.append(f"build objects/fonts.o: as fonts.s | {' '.join(f'fonts/{file}' for file in fonts.FILES.values())}")
    objects.append("objects/fonts.o")
    archives = [str(libraries / "lib" / f"lib{name}.a") for name in LIBRARIES]
    lines += [
        f"build core_loader.js | core_loader.wasm: link {' '.join(objects)} {' '.join(archives)}",
        f"  flags = {shlex.join(LINKED)}",
    ]
    tools.written(BUILD / "build.ninja", "\n".join(lines) + "\n")
