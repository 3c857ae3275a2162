# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The build of the libraries: headers put where they are looked for, and a build.ninja of all that is compiled."""

import os
import shlex
import shutil
from pathlib import Path

from . import fetch, toolchain, tools

HERE = Path(__file__).parent
PRIVATE = HERE / "include" / "private"

# Library: the source package it is made of, and where in it its folders lie.
LIBRARIES = {
    "argp": ("glibc", "2", "."),
    "arb": ("flint-arb", "1:2", "."),
    "cairo": ("cairo", "1", "."),
    "calcium": ("flint", "3", "src/fmpz_mpoly_q"),
    "cxsparse": ("suitesparse", "1:5", "."),
    "dxflib": ("dxflib", "3", "."),
    "expat": ("expat", "2", "."),
    "flint": ("flint", "2", "."),
    "freetype": ("freetype", "2", "."),
    "gsl": ("gsl", "2", "."),
    "pixman": ("pixman", "0", "."),
    "png": ("libpng1.6", "1", "."),
    "yaml": ("libyaml", "0", "."),
    "zlib": ("zlib", "1:1", "."),
}
UNWINDING = ["-fwasm-exceptions", "-mllvm", "-wasm-enable-sjlj"]  # setjmp and longjmp, by exceptions
# What FreeType is made of here, for it and for all that include it.
FREETYPE = ["-DFT_CONFIG_OPTIONS_H=<core_options.h>", "-DFT_CONFIG_MODULES_H=<core_modules.h>"]


def source_of(work: Path, library: str) -> Path:
    """Where the sources of a library lie."""
    package, version, inside = LIBRARIES[library]
    for row in fetch.table("sources.csv"):
        if row["package"] == package and row["version"].startswith(version):
            return fetch.folder_of(work, package, row["version"]) / inside
    raise SystemExit(f"sources.csv has no {package} {version}")


def source_folder(work: Path, package: str) -> Path:
    row = next(row for row in fetch.table("sources.csv") if row["package"] == package)
    return fetch.folder_of(work, package, row["version"])


def linked(into: Path, files: list[Path]) -> None:
    """Links to files in a folder; copies of those of this checkout, which the cache outlives."""
    into.mkdir(parents=True, exist_ok=True)
    for file in files:
        link = into / file.name
        if HERE in file.parents:
            (shutil.copytree(file, link, dirs_exist_ok=True) if file.is_dir() else shutil.copy(file, link))
        elif not link.is_symlink():
            link.symlink_to(os.path.relpath(file, into))


def put_headers(work: Path) -> None:
    """What the libraries and Topple include, under work/include."""
    include = work / "include"
    flint = source_of(work, "flint")
    # As its configure does for one thread and 32 bits.
    shutil.copy(flint / "fft_tuning32.in", flint / "fft_tuning.h")
    shutil.copy(flint / "fmpz-conversions-single.in", flint / "fmpz-conversions.h")
    shutil.copy(flint / "fmpz" / "link" / "fmpz_single.c", flint / "fmpz" / "fmpz.c")
    # No table of Conway polynomials, which has a megabyte: where one is missing FLINT finds another that serves.
    tools.written(flint / "CPimport.h", "")
    linked(include / "flint", [*sorted(flint.glob("*.h")), PRIVATE / "flint-config.h"])
    linked(include, sorted(source_of(work, "arb").glob("*.h")))
    fractions = (source_of(work, "calcium").parent / "fmpz_mpoly_q.h").read_text()
    for name in ("fmpz.h", "fmpz_vec.h", "fmpz_mpoly.h", "acb_types.h"):
        before = f'#include "{name}"\n'
        if before not in fractions:
            raise SystemExit(f"fmpz_mpoly_q.h of FLINT 3 includes no {name}")
        fractions = fractions.replace(before, "")
    tools.written(include / "calcium" / "flint_3_fmpz_mpoly_q.h", fractions)
    linked(include / "calcium", [HERE / "include" / "calcium" / "fmpz_mpoly_q.h"])
    linked(include, [source_of(work, "yaml") / "include" / "yaml.h"])
    linked(include, sorted((source_of(work, "expat") / "expat" / "lib").glob("expat*.h")))
    linked(include, sorted((source_of(work, "dxflib") / "src").glob("dl_*.h")))
    sparse = source_of(work, "cxsparse")
    linked(include / "suitesparse", [sparse / "CXSparse" / "Include" / "cs.h", sparse / "SuiteSparse_config" / "SuiteSparse_config.h"])
    linked(include / "gsl", sorted(source_of(work, "gsl").glob("gsl_*.h")) + sorted(source_of(work, "gsl").glob("*/gsl_*.h")))
    put_drawing_headers(work, include)
    glibc = source_of(work, "argp")
    linked(include / "glibc", [glibc / "argp" / "argp.h", glibc / "posix" / "getopt_int.h"])
    linked(include / "glibc" / "bits", sorted((glibc / "posix" / "bits").glob("getopt_*.h")))
    linked(include, [HERE / "include" / "argp.h", HERE / "include" / "bits"])
    # Headers alone, from the packages that the native build has.
    linked(include, [Path("/usr/include/CGAL"), Path("/usr/include/boost"), Path("/usr/include/rapidjson")])


def put_drawing_headers(work: Path, include: Path) -> None:
    """What Cairo, what is under it, and the figures include."""
    cairo, png = source_of(work, "cairo") / "src", source_of(work, "png")
    # src/cairo-version.h has no numbers: the one above it has.
    public = ["cairo.h", "cairo-deprecated.h", "cairo-ft.h", "cairo-pdf.h", "cairo-svg.h"]
    linked(include, [*(cairo / name for name in public), cairo.parent / "cairo-version.h", *(HERE / "include" / "cairo").glob("cairo*.h")])
    linked(include, sorted((source_of(work, "pixman") / "pixman").glob("pixman*.h")))
    linked(include, sorted(path for path in (source_of(work, "freetype") / "include").iterdir() if path.name != "dlg"))
    linked(include, [HERE / "include" / "freetype" / "core_options.h", HERE / "include" / "freetype" / "core_modules.h"])
    linked(include, [source_of(work, "zlib") / "zlib.h", source_of(work, "zlib") / "zconf.h", png / "png.h", png / "pngconf.h"])
    shutil.copy(png / "scripts" / "pnglibconf.h.prebuilt", include / "pnglibconf.h")


def flags_of(work: Path, library: str) -> list[str]:
    """What the files of a library are compiled with besides -O2."""
    source = source_of(work, library)
    configured = ["-DHAVE_CONFIG_H", f"-I{PRIVATE}"]
    return {
        "argp": [*configured, "-D_GNU_SOURCE", "-fgnu89-inline", "-include", "config.h", f"-I{source}/argp", f"-I{work}/include/glibc", f"-I{HERE}/include"],
        "arb": [f"-I{source}", f"-I{work}/include"],
        "cairo": ["-DHAVE_CONFIG_H", f"-I{HERE}/include/cairo", *FREETYPE, *UNWINDING, f"-I{work}/include"],
        "calcium": [f"-I{HERE}/include/flint_3", f"-I{work}/include", f"-I{work}/include/flint"],
        # Of real numbers, and with whole ones of the type that its functions cs_dl_… have.
        "cxsparse": ["-DCS_LONG", "-DNCOMPLEX", f"-I{source}/CXSparse/Include", f"-I{source}/SuiteSparse_config"],
        "dxflib": [f"-I{source}/src"],
        "expat": [*configured, f"-I{source}/expat/lib"],
        "flint": [f"-I{source}", f"-I{work}/include/flint", f"-I{work}/include"],
        "freetype": ["-DFT2_BUILD_LIBRARY", *FREETYPE, *UNWINDING, f"-I{work}/include"],
        "gsl": [*configured, f"-I{work}/include", f"-I{source}"],
        "pixman": ["-DHAVE_CONFIG_H", f"-I{HERE}/include/pixman", f"-I{source}/pixman"],
        "png": [*UNWINDING, f"-I{work}/include"],
        "yaml": [*configured, f"-I{source}/include"],
        "zlib": ["-DHAVE_UNISTD_H", "-D_LARGEFILE64_SOURCE=0", f"-I{source}"],
    }[library]


def files_of(work: Path, library: str) -> list[Path]:
    """What is compiled of a library, by the rows of files.csv."""
    source, found = source_of(work, library), []
    for row in fetch.table("files.csv"):
        if row["library"] != library:
            continue
        left_out = row["left_out"].split()
        for pattern in row["files"].split():
            matched = sorted(source.glob(f"{row['folder']}/{pattern}"))
            if not matched:
                raise SystemExit(f"files.csv: {library} has no {row['folder']}/{pattern}")
            found += [path for path in matched if path.name not in left_out]
    return found


RULES = """
rule cc
  command = {c} -w -MD -MF $out.d $flags -c $in -o $out
  depfile = $out.d
  deps = gcc
rule cxx
  command = {cxx} -w -MD -MF $out.d $flags -c $in -o $out
  depfile = $out.d
  deps = gcc
rule archive
  command = rm -f $out && {ar} crD $out @$out.members
  rspfile = $out.members
  rspfile_content = $in
rule configured
  command = sh {script} {cc} $name $source $build $out > $build.log 2>&1 || {{ cat $build.log; false; }}
"""


def write_ninja(work: Path) -> None:
    """work/build.ninja, and the headers that it supposes."""
    put_headers(work)
    wrapper = work / "wasmcc"
    tools.written(
        wrapper,
        "#!/bin/sh\n# A compiler for configure, which also links; what is linked is never run.\n"
        'case " $* " in *" -c "* | *" -E "* | *" -S "*) link= ;;\n'
        f'*) link="-nostdlib -Wl,--allow-undefined,--no-entry,--export=main -L{toolchain.SYSROOT}/lib/wasm32-emscripten -lc -lcompiler_rt" ;;\n'
        f'esac\nexec {shlex.join(toolchain.C)} "$@" $link\n',
    )
    wrapper.chmod(0o755)
    rules = RULES.format(
        c=shlex.join(toolchain.C),
        cxx=shlex.join(toolchain.CXX),
        ar=toolchain.AR,
        script=HERE / "configured",
        cc=wrapper,
    )
    lines = ["ninja_required_version = 1.5", rules]
    for name, package, needs in (("gmp", "gmp", ""), ("mpfr", "mpfr4", "| lib/libgmp.a")):
        lines += [
            f"build lib/lib{name}.a: configured {needs}",
            f"  name = {name}",
            f"  source = {source_folder(work, package)}",
            f"  build = {work}/configured-{name}",
        ]
    for library in LIBRARIES:
        objects = []
        top = source_of(work, library)
        for path in files_of(work, library):
            made = f"objects/{library}/{path.relative_to(top)}.o"
            rule = "cxx" if path.suffix == ".cpp" else "cc"
            lines += [f"build {made}: {rule} {path} || lib/libmpfr.a", f"  flags = $flags_{library}"]
            objects.append(made)
        # What an assertion tells of its file is not the folder that this was built in: the same bytes wherever.
        plain = [f"-ffile-prefix-map={work}=libraries", f"-ffile-prefix-map={HERE}=wasm"]
        lines.insert(2, f"flags_{library} = {shlex.join([*flags_of(work, library), *plain])}")
        lines.append(f"build lib/lib{library}.a: archive {' '.join(objects)}")
    tools.written(work / "build.ninja", "\n".join(lines) + "\n")
