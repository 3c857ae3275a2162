# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What is installed, in a folder that it was not meant for; and the scripts, from anywhere.

A header that another one includes was not installed, and no header but topple.h could be included
first; a program in an install that was moved drew no figure."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from harness import ROOT, main

BUILD = os.environ.get("TOPPLE_BUILD", str(ROOT / "build"))
EXAMPLE = ROOT / "examples" / "block_e_valley.yaml"
COMPILERS = (("cc", "-x", "c", "-std=c11"), ("c++", "-x", "c++", "-std=c++11"))
WARNINGS = ("-Wall", "-Wextra", "-Wpedantic", "-Werror")
DECOY = """#include <stdio.h>
__attribute__((constructor)) static void loaded(void) { puts("the decoy was loaded"); }
"""
USE = """int main(void) {
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_message message;
  const tp_solve_options options = tp_solve_options_default();
  tp_status status = tp_scene_read(&scene, "scene.yaml", &message);
  if (status == TP_OK) status = tp_solve(&solution, scene, &options, &message);
  tp_solution_free(solution);
  tp_scene_free(scene);
  return tp_status_exit(status);
}
"""


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="topple install ")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        subprocess.run(["meson", "install", "-C", BUILD, "--no-rebuild", "--destdir", cls.folder],
                       check=True, capture_output=True)
        (cls.program,) = cls.folder.rglob("bin/topple")
        (library,) = cls.folder.rglob("libtopple-figure.so.0")
        cls.library = library
        cls.include = next(cls.folder.rglob("include/topple.h")).parent

    def compile(self, source):
        for compiler in COMPILERS:
            done = subprocess.run([*compiler, *WARNINGS, "-fsyntax-only", "-I", self.include, "-"],
                                  input=source, cwd="/", check=False, capture_output=True, encoding="utf-8")
            self.assertEqual(done.stderr, "", source)

    def test_headers(self):
        """Each alone, each before and after the one for all, in C and in C++."""
        headers = sorted(p.name for p in self.include.glob("*.h"))
        self.assertEqual(headers, sorted(p.name for p in (ROOT / "include" / "topple").glob("topple*.h")))
        read = subprocess.run(["cc", "-MM", self.include / "topple.h"], check=True, capture_output=True,
                              encoding="utf-8").stdout
        self.assertEqual(headers, sorted(set(re.findall(r"topple\w*\.h\b", read))), "what topple.h includes")
        for header in headers:
            self.compile(f"#include <{header}>\n")
            self.compile(f"#include <{header}>\n#include <topple.h>\n{USE}")
        for order in (headers, headers[::-1]):
            self.compile("".join(f"#include <{h}>\n" for h in order) + USE)

    def test_symbols(self):
        """The shared libraries together show each function that the headers declare, once, and nothing else: not what
        they call within, nor what they hold of CGAL, GSL and the C++ library."""
        libraries = [*self.folder.rglob("libtopple.so"), self.library]
        if len(libraries) == 1:
            self.skipTest("only a static library was built (-Ddefault_library=static)")
        shown = []
        for library in libraries:
            lines = subprocess.run(["nm", "-D", "--defined-only", library], check=True, capture_output=True,
                                   encoding="utf-8").stdout.splitlines()
            symbols = [line.split()[1:] for line in lines]
            shown += [name.split("@")[0] for kind, name in symbols if kind != "A"]  # A: the versions themselves
        read = subprocess.run(["cc", "-E", "-P", self.include / "topple.h"], check=True, capture_output=True,
                              encoding="utf-8").stdout
        read = re.sub(r"^static inline [^{]*", "", read, flags=re.M)  # compiled into the caller
        declared = sorted(set(re.findall(r"\b(tp_\w+)\s*\(", read)))
        self.assertGreater(len(declared), 60)
        self.assertEqual(sorted(shown), declared)

    def draw(self, program=None, folder="/"):
        """The figure of an install that does not lie where it was meant to."""
        figure = self.folder / "figure.svg"
        figure.unlink(missing_ok=True)
        done = subprocess.run([program or self.program, "solve", "--figure", figure, EXAMPLE], cwd=folder,
                              check=False, capture_output=True, encoding="utf-8")
        self.assertNotIn("decoy", done.stdout)
        return done, figure

    def test_moved(self):
        done, figure = self.draw()
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("</svg>", figure.read_text())

    def test_examples(self):
        """The example scenes were installed, and are found from where the program lies now."""
        written = self.folder / "written.yaml"
        done = subprocess.run([self.program, "examples", "slab", "-o", written], cwd="/", check=False, capture_output=True,
                              encoding="utf-8")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(written.read_bytes(), (ROOT / "examples" / "slab.yaml").read_bytes())

    def test_through_a_link(self):
        """A link to the program elsewhere, in a folder that has a library of that name."""
        other = self.folder / "elsewhere"
        other.mkdir()
        (other / "topple").symlink_to(self.program)
        self.make_decoy(other)
        done, figure = self.draw(other / "topple", other)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertTrue(figure.exists())

    def make_decoy(self, folder):
        decoy = folder / self.library.name
        subprocess.run(["cc", "-shared", "-fPIC", "-x", "c", "-", "-o", decoy], input=DECOY, check=True,
                       encoding="utf-8")
        return decoy

    def test_library_of_someone_else(self):
        """Beside the program, but everyone may write to it, or it is of another user: passed over."""
        decoy = self.make_decoy(self.program.parent)
        self.addCleanup(decoy.unlink)
        decoy.chmod(0o777)
        self.assertEqual(self.draw()[0].returncode, 0)
        if os.geteuid() == 0:
            decoy.chmod(0o755)
            os.chown(decoy, 65534, 65534)
            self.assertEqual(self.draw()[0].returncode, 0)

    def test_without_the_library(self):
        """A program alone says what is missing."""
        alone = self.folder / "alone"
        alone.mkdir()
        shutil.copy(self.program, alone)
        meant = pathlib.Path("/") / self.library.relative_to(self.folder)
        if meant.exists():
            self.skipTest("another Topple is installed here")
        done, figure = self.draw(alone / "topple")
        self.assertEqual((done.returncode, done.stdout), (5, ""))
        self.assertIn("libtopple-figure.so", done.stderr)
        self.assertFalse(figure.exists())


OTHER = """const char *tp_version(void) { return "9.8.7"; }
const char *tp_figure_version(void) { return "9.8.7"; }
const char *tp_module_version(void) { return "9.8.7"; }
"""
CALL = """import ctypes, sys
ctypes.CDLL(sys.argv[1], mode=ctypes.RTLD_GLOBAL)
figure = ctypes.CDLL(sys.argv[2])
message, what = ctypes.create_string_buffer(4096), ctypes.create_string_buffer(4096)
print(figure.tp_report_figure(b"figure.svg", what, what, message), message.raw)
"""


class Versions(unittest.TestCase):
    """Libraries of other versions know other structs, and crashed, or drew nonsense: each pair that meets says so first."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="topple versions ")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.other = cls.folder / "libother.so"
        subprocess.run(["cc", "-shared", "-fPIC", "-x", "c", "-", "-o", cls.other], input=OTHER, check=True, encoding="utf-8")
        cls.program = shutil.copy(pathlib.Path(BUILD) / "topple", cls.folder)

    def refused(self, library, *words, status=5):
        shutil.copy(self.other, self.folder / library)
        done = subprocess.run([self.program, *words], cwd=self.folder, check=False, capture_output=True, encoding="utf-8")
        self.assertEqual((done.returncode, done.stdout), (status, ""), done.stderr)
        self.assertIn(f"{library}, which does not load (its version is 9.8.7, and that of ", done.stderr)
        self.assertIn("install both of the same version", done.stderr)

    def test_program_and_libraries(self):
        self.refused("libtopple-figure.so.0", "solve", "--figure", "f.svg", EXAMPLE)
        self.refused("libtopple-xlsx.so", "solve", "--batch", "table.xlsx")
        self.refused("libtopple-hdf5.so", "study", "--rows", "rows.h5", ROOT / "examples" / "studies" / "slab_study.yaml")
        self.refused("libtopple-trace.so", "trace", "p.png", "--outline=1,1,9,1,1,9", "--scale=1,1,2,2,1", "-o", "s.yaml")
        self.assertEqual(sorted(path.suffix for path in self.folder.iterdir() if not path.name.startswith("lib")), [""])

    def test_libraries_of_a_program(self):
        """A program that is linked with both, of two versions: the library of figures looks at neither scene nor solution."""
        figure = pathlib.Path(BUILD) / "libtopple-figure.so"
        done = subprocess.run([sys.executable, "-c", CALL, self.other, figure], cwd=self.folder, check=True, capture_output=True,
                              encoding="utf-8")
        self.assertNotEqual(done.stdout.split()[0], "0")
        self.assertIn(", and that of libtopple 9.8.7: install both of the same version", done.stdout)
        self.assertFalse((self.folder / "figure.svg").exists())

    def test_packages(self):
        """Those of pkg-config and of Debian ask for the one version."""
        version = subprocess.run([self.program, "--version"], check=True, capture_output=True, encoding="utf-8").stdout.split()[1]
        (file,) = pathlib.Path(BUILD).rglob("meson-private/topple-figure.pc")
        self.assertRegex(file.read_text(), rf"(?m)^Requires: topple = +{re.escape(version)}\b")
        control = (ROOT / "docs/packaging/debian/control").read_text().split("\n\n")
        for name, asked in (("libtopple-figure0", 1), ("python3-topple", 2), ("libtopple-dev", 2), ("topple", 1)):
            (own,) = [part for part in control if part.startswith(f"Package: {name}\n")]
            self.assertEqual(own.count("(= ${binary:Version})"), asked, name)


class Entries(unittest.TestCase):
    def test_every_entry_guards_its_caller(self):
        """Each public call that can fail begins with the guard of tests/library/test_host.c, refuses NULL for
        each of its pointers but the message, by itself or by what the calls on many blocks begin with, and is tried
        with them in tests/library/test_arguments.c or another test_*_arguments.c."""
        blocks = (ROOT / "src" / "statics" / "batch" / "blocks.h").read_text(encoding="utf-8")
        (begin,) = re.findall(r"^#define TP_BLOCKS_BEGIN\((?:.*\\\n)+.*", blocks, re.M)
        sources = {p: p.read_text(encoding="utf-8") for p in (ROOT / "src").rglob("*.c")}
        tried = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "tests").rglob("test_*arguments.c"))
        count = 0
        for header in sorted((ROOT / "include" / "topple").glob("topple*.h")):
            for name in re.findall(r"^TP_MUST_USE tp_status (\w+)\(", header.read_text(encoding="utf-8"), re.M):
                count += 1
                pattern = re.compile(rf"^tp_status {name}\(([^{{]*)\) {{\n(.*?)^}}", re.M | re.S)
                (found,) = [m for text in sources.values() for m in pattern.finditer(text)]
                parameters, body = found.groups()
                if "TP_BLOCKS_BEGIN(message, columns, summary, outlines, own, options);" in body:
                    body += begin
                self.assertTrue(body.lstrip().startswith("TP_GUARD_HOST;"), name)
                for pointer in re.findall(r"\*(\w+)(?:,|$)", parameters):
                    if pointer != "message":
                        self.assertIn(f", {pointer});", body, name)
                        self.assertIn(f"{name}(", tried, name)
        self.assertGreater(count, 30)


class Scripts(unittest.TestCase):
    def test_through_a_link(self):
        """`run` and `check` by a link with blanks in its name, from another folder."""
        with tempfile.TemporaryDirectory(prefix="topple scripts ") as name:
            folder = pathlib.Path(name)
            (folder / "run it").symlink_to(ROOT / "run")
            (folder / "twice").symlink_to("run it")
            (folder / "check it").symlink_to(ROOT / "check")
            for script in ("run it", "twice"):
                done = subprocess.run([folder / script, "--version"], cwd="/", check=False,
                                      env={**os.environ, "TOPPLE_BUILD": BUILD}, capture_output=True,
                                      encoding="utf-8")
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertIn("topple 0", done.stdout)
            for script, start in ((folder / "check it", "/"), ("./check", ROOT)):
                done = subprocess.run([script, "--nonsense"], cwd=start, check=False, capture_output=True,
                                      encoding="utf-8")
                self.assertEqual(done.returncode, 2)
                self.assertIn("./check --sanitize", done.stderr)


if __name__ == "__main__":
    main()
