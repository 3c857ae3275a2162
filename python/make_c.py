# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The C of a module by which Python calls the library (cffi, API mode), written from the public
headers themselves: what they declare is what Python sees, and the C compiler, which reads them too,
lays out the structs.

    make_c.py OUTPUT MODULE HEADER COMPILER…

MODULE is topple._library, all but the drawing of figures and sheets; or topple._figure, that alone, of a
library of its own."""

import pathlib
import re
import subprocess
import sys
import tempfile

import cffi

#: How far a call is, and whether it is to end, in memory that both sides see: no thread of the library waits for Python.
RUN = """
typedef struct topple_run {
  int stop;           /* set by Python: the call ends with what is known by then */
  size_t done, of;    /* told by the library; of 0: nothing yet, or no number is known */
  double least, most; /* of a tilt test: the bracket by then */
} topple_run;
"""
CALLS = """
const char *built_version(void);
bool run_stops(void *run);
void run_counts(void *run, size_t done, size_t of);
void run_brackets(void *run, size_t runs, double least, double most);
"""
BODIES = """
static const char *built_version(void) {
  return TP_VERSION;
}
static bool run_stops(void *run) {
  return __atomic_load_n(&((topple_run *)run)->stop, __ATOMIC_RELAXED) != 0;
}
static void run_counts(void *run, size_t done, size_t of) {
  __atomic_store_n(&((topple_run *)run)->of, of, __ATOMIC_RELAXED);
  __atomic_store_n(&((topple_run *)run)->done, done, __ATOMIC_RELEASE);
}
static void run_brackets(void *run, size_t runs, double least, double most) {
  ((topple_run *)run)->least = least;
  ((topple_run *)run)->most = most;
  __atomic_store_n(&((topple_run *)run)->done, runs, __ATOMIC_RELEASE);
}
"""
DRAWS = re.compile(r"^ *(?:tp_status |const char \*)(tp_report_(?:figure|sheet)\w*|tp_figure_version)\([^;]*\);\n", re.MULTILINE)
INLINE = re.compile(r"^ *static inline ([^{]*?) \{\n.*?^\}", re.MULTILINE | re.DOTALL)


def declarations(header, compiler):
    """What the header and those that it includes declare; of the standard headers that they name,
    nothing."""
    with tempfile.TemporaryDirectory() as standard:
        for name in ("stdbool.h", "stddef.h", "stdint.h"):
            (pathlib.Path(standard) / name).touch()
        command = [*compiler, "-E", "-P", "-nostdinc", "-U__GNUC__", f"-I{standard}", header]
        text = subprocess.run(command, check=True, stdout=subprocess.PIPE, encoding="utf-8").stdout
    return INLINE.sub(r"\1;", text)


def main(output, module, header, *compiler):
    text = declarations(header, compiler)
    library = cffi.FFI()
    library.cdef(DRAWS.sub("", text) + RUN + CALLS + 'extern "Python" bool take_text(void *, const char *);')
    library.set_source("topple._library", "#include <topple.h>" + RUN + BODIES)
    if module == "topple._library":
        library.emit_c_code(output)
        return
    figure = cffi.FFI()
    figure.include(library)
    figure.cdef("".join(match.group() for match in DRAWS.finditer(text)))
    figure.set_source(module, "#include <topple.h>" + RUN)
    figure.emit_c_code(output)


if __name__ == "__main__":
    main(*sys.argv[1:])
