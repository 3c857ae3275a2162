# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Programs of others in C and C++, compiled and run against what is installed and nothing else of the project: found by
pkg-config and by CMake, linked to the shared and to the static library. The programs are those of docs/library.md,
docs/scene_in_memory.md and docs/blocks.md, as they stand on the page, and those of examples/c."""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

from harness import ROOT, main

BUILD = os.environ.get("TOPPLE_BUILD", str(ROOT / "build"))
EXAMPLES = sorted((ROOT / "examples" / "c").glob("*.c"))
COMPILERS = (("cc", "-x", "c", "-std=c11"), ("c++", "-x", "c++", "-std=c++11"))
WARNINGS = ("-Wall", "-Wextra", "-Wpedantic", "-Werror")
DRAW = """#include <topple.h>

int main(void) {
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  const tp_solve_options options = tp_solve_options_default();
  tp_status status = tp_scene_read(&scene, "scene.yaml", NULL);
  if (status == TP_OK) status = tp_solve(&solution, scene, &options, NULL);
  if (status == TP_OK) status = tp_report_figure("block.svg", scene, solution, NULL);
  tp_solution_free(solution);
  tp_scene_free(scene);
  return tp_status_exit(status);
}
"""
BUILD_STATIC = """
if(TARGET topple::topple_static)
  add_executable(solve_static solve.c)
  target_link_libraries(solve_static topple::topple_static)
endif()
"""


def blocks_of(language, page="library.md"):
    """The blocks of a page in this language."""
    text = (ROOT / "docs" / page).read_text(encoding="utf-8")
    return re.findall(rf"^```{language}\n(.*?)^```$", text, re.M | re.S)


ARRAY, SOLVE = blocks_of("c")
ARRAY_PRINTS, SOLVE_PRINTS = blocks_of("text")
MEMORY, SYSTEM = blocks_of("c", "scene_in_memory.md")
(SYSTEM_PRINTS,) = blocks_of("text", "scene_in_memory.md")
(BLOCKS,) = blocks_of("c", "blocks.md")
(BLOCKS_PRINT,) = blocks_of("text", "blocks.md")
(CMAKE,) = blocks_of("cmake")


class Library(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="topple_library_")  # blanks are not for pkg-config
        cls.addClassCleanup(folder.cleanup)
        cls.root = pathlib.Path(folder.name) / "installed"
        subprocess.run(["meson", "install", "-C", BUILD, "--no-rebuild", "--destdir", cls.root], check=True,
                       capture_output=True)
        cls.libraries = next(cls.root.rglob("pkgconfig/topple.pc")).parent.parent
        cls.folder = pathlib.Path(folder.name) / "use"
        cls.folder.mkdir()
        for name, text in (("array.c", ARRAY), ("solve.c", SOLVE), ("memory.c", MEMORY), ("system.c", SYSTEM),
                           ("blocks.c", BLOCKS), ("draw.c", DRAW)):
            (cls.folder / name).write_text(text, encoding="utf-8")
        shutil.copy(ROOT / "examples" / "block_e_valley.yaml", cls.folder / "scene.yaml")

    def run_in(self, *command, **environment):
        """Run with nothing of the project in reach; what it printed, with a status of 0."""
        done = subprocess.run(command, cwd=self.folder, check=False, capture_output=True, encoding="utf-8",
                              env={"PATH": os.environ["PATH"], "HOME": str(self.folder), **environment})
        self.assertEqual(done.returncode, 0, f"{command}: {done.stdout}{done.stderr}")
        self.assertEqual(done.stderr, "")
        return done.stdout

    def flags(self, package, *options):
        """What pkg-config says of the package, whose prefix is in the folder of this test."""
        if shutil.which("pkg-config") is None:
            self.skipTest("pkg-config is not installed")
        text = (self.libraries / "pkgconfig" / f"{package}.pc").read_text(encoding="utf-8")
        prefix = re.search(r"^prefix=/(.*)$", text, re.M).group(1)
        return self.run_in("pkg-config", f"--define-variable=prefix={self.root / prefix}", "--cflags", "--libs",
                           *options, package, PKG_CONFIG_PATH=str(self.libraries / "pkgconfig")).split()

    def compile(self, compiler, source, flags):
        self.run_in(*compiler, *WARNINGS, source, "-x", "none", *flags, "-o", "program")
        return self.folder / "program"

    def needed(self, program):
        """The shared libraries of Topple that the program asks for."""
        return re.findall(r"NEEDED.*\[(libtopple.*)\]", self.run_in("readelf", "-d", program))

    def check_answer(self, program, **environment):
        self.assertEqual(self.run_in(program, "scene.yaml", **environment), SOLVE_PRINTS)

    def is_shared(self):
        return (self.libraries / "libtopple.so").exists()

    def test_what_else_is_installed(self):
        """Completion where the shells look for it, and pages of the manual where help2man could make them."""
        files = {str(path.relative_to(self.root)) for path in self.root.rglob("*") if path.is_file()}
        ends = ["bash-completion/completions/topple", "zsh/site-functions/_topple"]
        ends += ["man/man1/topple.1", "man/man1/topple-solve.1"] if shutil.which("help2man") else []
        for end in ends:
            self.assertEqual(len([file for file in files if file.endswith(f"share/{end}")]), 1, end)

    def test_by_pkg_config(self):
        for compiler in COMPILERS:
            program = self.compile(compiler, "solve.c", self.flags("topple"))
            self.assertEqual(self.needed(program), ["libtopple.so.0"] if self.is_shared() else [])
            self.check_answer(program, LD_LIBRARY_PATH=str(self.libraries))

    def test_block_in_an_array(self):
        """The ten lines that the page begins with: a block in an array, and nothing of the project beside it."""
        self.assertEqual(len(ARRAY.splitlines()), 10)
        self.assertLessEqual(max(map(len, ARRAY.splitlines())), 100)
        self.assertLess((ROOT / "docs" / "library.md").read_text(encoding="utf-8").find(ARRAY), 600)
        for compiler in COMPILERS:
            program = self.compile(compiler, "array.c", self.flags("topple"))
            self.assertEqual(self.run_in(program, LD_LIBRARY_PATH=str(self.libraries)), ARRAY_PRINTS)

    def test_block_in_an_array_refused(self):
        """An outline that crosses itself is no block: the ten lines say so and end with status 1."""
        crossed = ARRAY.replace("60, 0, 90, 5,", "90, 5, 60, 0,")
        (self.folder / "crossed.c").write_text(crossed, encoding="utf-8")
        program = self.compile(COMPILERS[0], "crossed.c", self.flags("topple"))
        done = subprocess.run([program], cwd=self.folder, check=False, capture_output=True, encoding="utf-8",
                              env={"LD_LIBRARY_PATH": str(self.libraries)})
        self.assertEqual((done.returncode, done.stderr), (1, ""))
        self.assertRegex(done.stdout, r"^tp_scene_set_outline:\d: .*\n$")

    def test_scene_in_memory(self):
        for compiler in COMPILERS:
            program = self.compile(compiler, "memory.c", self.flags("topple"))
            out = self.run_in(program, LD_LIBRARY_PATH=str(self.libraries))
            self.assertRegex(out, r"^\d+\.\d+ degrees\n$")

    def test_blocks_in_memory(self):
        program = self.compile(COMPILERS[0], "system.c", self.flags("topple"))
        self.assertEqual(self.run_in(program, LD_LIBRARY_PATH=str(self.libraries)), SYSTEM_PRINTS)

    def test_many_blocks(self):
        program = self.compile(COMPILERS[0], "blocks.c", self.flags("topple"))
        self.assertEqual(self.run_in(program, LD_LIBRARY_PATH=str(self.libraries)), BLOCKS_PRINT)

    def test_examples(self):
        """Each compares what it prints with closed forms of its own, and would end with another status."""
        self.assertGreaterEqual(len(EXAMPLES), 4)
        for example in EXAMPLES:
            with self.subTest(example=example.name):
                shutil.copy(example, self.folder)
                program = self.compile(COMPILERS[0], example.name, [*self.flags("topple"), "-lm"])
                out = self.run_in(program, LD_LIBRARY_PATH=str(self.libraries))
                self.assertGreater(out.count("\n"), 3)

    def test_drawing(self):
        figure = self.folder / "block.svg"
        program = self.compile(COMPILERS[0], "draw.c", self.flags("topple-figure"))
        self.assertIn("libtopple-figure.so.0", self.needed(program))
        self.run_in(program, LD_LIBRARY_PATH=str(self.libraries))
        self.assertIn("</svg>", figure.read_text(encoding="utf-8"))

    def test_static(self):
        if not (self.libraries / "libtopple.a").exists():
            self.skipTest("no static library was built (-Ddefault_library=both)")
        flags = [flag.replace("-ltopple", "-l:libtopple.a") for flag in self.flags("topple", "--static")]
        for compiler in COMPILERS:
            program = self.compile(compiler, "solve.c", flags)
            self.assertEqual(self.needed(program), [])
            self.check_answer(program)

    def test_by_cmake(self):
        """The file of the page, with a program in C++ and a drawing added."""
        if shutil.which("cmake") is None:
            self.skipTest("CMake is not installed")
        shutil.copy(self.folder / "solve.c", self.folder / "solve_too.cpp")
        more = "add_executable(solve_too solve_too.cpp)\ntarget_link_libraries(solve_too topple::topple)\n" \
               "add_executable(draw draw.c)\ntarget_link_libraries(draw topple::figure)\n"
        (self.folder / "CMakeLists.txt").write_text(CMAKE + more + BUILD_STATIC, encoding="utf-8")
        self.run_in("cmake", "-S", ".", "-B", "made", f"-Dtopple_DIR={self.libraries / 'cmake' / 'topple'}",
                    "-DCMAKE_C_FLAGS=-Wall -Werror", "-Wno-dev")
        self.run_in("cmake", "--build", "made")
        for name in ("solve", "solve_too", "solve_static"):
            if name != "solve_static" or (self.folder / "made" / name).exists():
                self.check_answer(self.folder / "made" / name)
        self.run_in(self.folder / "made" / "draw")

    def test_versions_of_cmake(self):
        """What is asked for must be no newer, and of the same series."""
        if shutil.which("cmake") is None:
            self.skipTest("CMake is not installed")
        (version,) = re.findall(r'PACKAGE_VERSION "(.*)"',
                                (self.libraries / "cmake/topple/topple-config-version.cmake").read_text())
        for asked, fits in ((version, True), ("0.1", True), ("0.1.999", False), ("0.2", False), ("0.0.9", False),
                            ("0.10", False), ("1", False)):
            script = f'set(PACKAGE_FIND_VERSION {asked})\ninclude("{self.libraries}/cmake/topple/topple-config-version.' \
                     'cmake")\nif(PACKAGE_VERSION_COMPATIBLE)\n  file(WRITE fits "")\nendif()\n'
            (self.folder / "version.cmake").write_text(script, encoding="utf-8")
            (self.folder / "fits").unlink(missing_ok=True)
            self.run_in("cmake", "-P", "version.cmake")
            self.assertEqual((self.folder / "fits").exists(), fits, asked)


if __name__ == "__main__":
    main()
