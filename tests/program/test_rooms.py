# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The plan of the rooms (docs/architecture.md, tests/data/rooms.csv) holds: no file includes, and no compiled code
calls, a room above its own; the command line knows the public headers alone; what lies below the public headers keeps
no data that changes, prints nothing and ends no process. Nor do modules need each other in a circle, within a room or
across: by their include lines a header with the source of its name is one, by calls each compiled file."""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

from harness import ROOT, main, table

BUILD = pathlib.Path(os.environ.get("TOPPLE_BUILD", ROOT / "build"))
ROOMS = [row["room"] for row in table("rooms.csv")]
WING_OF = {row["room"]: row["wing"] for row in table("rooms.csv")}
EXCEPTIONS = {(row["from"], row["to"]) for row in table("rooms_exceptions.csv") if row["reason"].strip()}
MADE = r"(?!results_json\.h|scene_keys\.h|partial_factors_table\.h)"  # by the build, of tables, for the room that includes it
INCLUDE = re.compile(rf'\s*#\s*include\s+"({MADE}[^"]+)"')
PUBLIC = re.compile(r"topple\w*\.h")
STANDARD = {"math.h", "float.h"}  # headers of C that a comment may name
HEAD = re.compile(r"/\* SPDX-License-Identifier: [^\n]+ \*/\n/\* SPDX-FileCopyrightText: [^\n]+ \*/\n\n"
                  r"/\*(?! ?----)(.*?)\*/", re.DOTALL)
NEVER_CALLED = {"printf", "puts", "putchar", "vprintf", "perror", "stdout", "stderr", "exit", "_exit", "quick_exit",
                "abort", "raise", "__assert_fail", "setlocale", "__printf_chk"}


def room_of(path):
    """The room of a file, by its path from the root."""
    parts = pathlib.PurePath(path).parts
    return parts[2] if parts[0] == "src" else "common"


def sources(root=ROOT):
    """Every source file of the library and the program, and its text."""
    for folder in ("src", "include"):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in (".c", ".h", ".cpp", ".hpp"):
                yield path.relative_to(root), path.read_text(encoding="utf-8")


def included(path, name, root=ROOT):
    """The file that an include of `path` names, from the root."""
    for folder in (path.parent, "include/topple", *(f"src/{wing}" for wing in dict.fromkeys(WING_OF.values()))):
        target = os.path.normpath(os.path.join(folder, name))
        if os.path.isfile(os.path.join(root, target)):
            return pathlib.PurePath(target)
    raise AssertionError(f'{path}: "{name}" is no file of the project')


def climbs(source, target):
    """Does a file of the one room that uses the other look upwards? A room that is on no list is a mistake."""
    for room in (source, target):
        if room not in ROOMS:
            raise AssertionError(f"{room} is no room of tests/data/rooms.csv: put it there (and on the plan in "
                                 "docs/architecture.md) above the rooms that it uses")
    return ROOMS.index(target) < ROOMS.index(source)


def climbing_includes(root=ROOT):
    """(from, to, line) of every include of a room above, and the number of includes looked at."""
    found, looked_at = [], 0
    for path, text in sources(root):
        for number, line in enumerate(text.splitlines(), 1):
            match = INCLUDE.match(line)
            if match is None:
                continue
            target = included(path, match.group(1), root)
            looked_at += 1
            if climbs(room_of(path), room_of(target)):
                found.append((str(path), str(target), number))
    return found, looked_at


def include_graph(root=ROOT):
    """Module to the modules that it includes; a header and the source of the same name are one module."""
    graph = {}
    for path, text in sources(root):
        own = str(path.with_suffix(""))
        others = {str(included(path, name, root).with_suffix("")) for name in INCLUDE.findall(text)}
        graph.setdefault(own, set()).update(others - {own})
    return graph


def circles(graph):
    """The strongly connected components of more than one node, each sorted (Tarjan's algorithm)."""
    order, least, stack, found = {}, {}, [], []

    def visit(node):
        order[node] = least[node] = len(order)
        stack.append(node)
        for other in sorted(graph.get(node, ())):
            if other not in order:
                visit(other)
                least[node] = min(least[node], least[other])
            elif other in stack:
                least[node] = min(least[node], order[other])
        if least[node] == order[node]:
            component = stack[stack.index(node):]
            del stack[stack.index(node):]
            if len(component) > 1:
                found.append(tuple(sorted(component)))

    for node in sorted(graph):
        if node not in order:
            visit(node)
    return found


class Circles(unittest.TestCase):
    def check(self, found, kind):
        """Those found are those of the list, and each of these is still needed."""
        listed = {tuple(row["modules"].split()) for row in table("circles.csv")
                  if row["kind"] == kind and row["reason"].strip()}
        self.assertEqual(set(found) - listed, set(), "these need each other in a circle: move what two of them share "
                         "to a module below both")
        self.assertEqual(listed - set(found), set(), "an exception of tests/data/circles.csv that is no longer needed")

    def test_of_includes(self):
        graph = include_graph()
        self.assertGreater(len(graph), 200)
        self.check(circles(graph), "include")

    def test_of_calls(self):
        graph = call_graph()
        self.assertGreater(sum(map(len, graph.values())), 1000)
        self.check(circles({source: set(names.values()) - {source} for source, names in graph.items()}), "call")

    def test_one_is_seen(self):
        """The check itself, on a small graph and on a header of number/ that includes its user, in a copy."""
        graph = {"a": {"b", "e"}, "b": {"c"}, "c": {"a", "d"}, "d": {"e"}, "e": {"f"}, "f": {"d"}, "g": {"a"}}
        self.assertEqual(sorted(circles(graph)), [("a", "b", "c"), ("d", "e", "f")])
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name in ("src", "include"):
                shutil.copytree(ROOT / name, root / name)
            header = root / "src/core/number/ball.h"
            header.write_text('#include "number/judge.h"\n' + header.read_text(encoding="utf-8"), encoding="utf-8")
            self.assertIn(("src/core/number/ball", "src/core/number/judge"), circles(include_graph(root)))


class Includes(unittest.TestCase):
    def test_none_climbs(self):
        found, looked_at = climbing_includes()
        self.assertGreater(looked_at, 500)
        for source, target, line in found:
            self.assertIn((source, target), EXCEPTIONS,
                          f"{source}:{line} includes {target} of a room above its own: move what it needs down")
        needed = {(source, target) for source, target, _ in found}
        for source, target in EXCEPTIONS:
            if target.endswith(".h"):
                self.assertIn((source, target), needed, "an exception that is no longer needed")

    def test_one_that_climbs_is_seen(self):
        """The check itself: a file of number/ that includes one of report/, in a copy."""
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name in ("src", "include"):
                shutil.copytree(ROOT / name, root / name)
            climber = root / "src/core/number/work.c"
            climber.write_text('#include "report/page.h"\n' + climber.read_text(encoding="utf-8"), encoding="utf-8")
            self.assertEqual(climbing_includes(root)[0], [("src/core/number/work.c", "src/presentation/report/page.h", 1)])

    def test_rooms_are_those_of_the_plan(self):
        """Every folder is a room of the list, and the plan on paper has the same rooms in the same order."""
        folders = {(path.parts[1], path.parts[2]) for path, _ in sources() if path.parts[0] == "src"}
        self.assertEqual(folders, {(wing, room) for room, wing in WING_OF.items()})
        plan = (ROOT / "docs/architecture.md").read_text(encoding="utf-8")
        self.assertEqual(re.findall(r"^\| `(\w+)` \|", plan, re.MULTILINE), ROOMS)
        wings = list(WING_OF.values())
        self.assertEqual(re.findall(r"^### (\w+)$", plan, re.MULTILINE), list(dict.fromkeys(wings)))
        changes = sum(one != other for one, other in zip(wings, wings[1:]))
        self.assertEqual(changes + 1, len(set(wings)), "the rooms of a wing stand together")

    def test_tests_of_a_wing(self):
        """Tests of C stand in the folder of a wing and use its rooms and those below, or in `library`, for all wings at once; what
        several of them use is in `support`, and nothing lies beside the folders."""
        order = list(dict.fromkeys(WING_OF.values()))
        listed = 0
        for path in sorted((ROOT / "tests").rglob("*.c*")):
            folder, *rest = path.relative_to(ROOT / "tests").parts
            if folder in ("fuzz", "bench", "support", "library") or path.suffix not in (".c", ".cpp"):
                continue
            self.assertTrue(folder in order and len(rest) == 1 and path.name.startswith("test_"), path)
            listed += 1
            for room in re.findall(r'^#include "(\w+)/', path.read_text(encoding="utf-8"), re.MULTILINE):
                self.assertGreaterEqual(order.index(WING_OF[room]), order.index(folder), f"{path} uses {room}, of a wing above its own")
        self.assertGreater(listed, 80)

    def test_the_command_line_sees_public_headers_alone(self):
        for path, text in sources():
            if room_of(path) != "cli":
                continue
            for name in INCLUDE.findall(text):
                own = room_of(included(path, name)) == "cli"
                self.assertTrue(own or PUBLIC.fullmatch(name), f"{path} includes {name}")

    def test_every_test_is_run(self):
        """A file of tests that tests/meson.build does not list passes unseen, as two did."""
        listed = set(re.findall(r"'(\w+)'", (ROOT / "tests/meson.build").read_text(encoding="utf-8")))
        files = [path.stem.removeprefix("test_") for path in (ROOT / "tests/program").glob("test_*.py")]
        self.assertGreater(len(files), 150)
        self.assertEqual([name for name in files if name not in listed], [])

    def test_public_headers_stand_alone(self):
        """They include each other in no circle and the standard library, nothing else, and all of them are installed."""
        build = (ROOT / "include/topple/meson.build").read_text(encoding="utf-8")
        headers = [(path, text) for path, text in sources() if PUBLIC.fullmatch(path.name)]
        self.assertGreater(len(headers), 5)
        for path, text in headers:
            self.assertIn(f"'{path.name}'", build)
            for name in re.findall(r'#include ["<]([^">]+)[">]', text):
                self.assertTrue(PUBLIC.fullmatch(name) or name in ("stdbool.h", "stddef.h", "stdint.h"), f"{path}: {name}")
        wants = {path.name: {name for name in INCLUDE.findall(text) if PUBLIC.fullmatch(name)} for path, text in headers}
        while wants:
            free = {header for header, names in wants.items() if not names & wants.keys()}
            self.assertTrue(free, f"a circle among {sorted(wants)}")
            wants = {header: names for header, names in wants.items() if header not in free}

    def test_guards_are_by_path(self):
        """Two headers with one guard shut each other out: TP_ROOM_FILE_H, of a public header its name. What ends
        in _in.h is included more than once; the explorer's headers are the browser's C library's."""
        guards = {}
        for path, text in sources():
            if path.suffix not in (".h", ".hpp") or path.stem.endswith("_in") or room_of(path) == "explorer":
                continue
            name = re.sub(r"\W", "_", path.name).upper()
            guard = name if path.parts[0] == "include" else f"TP_{room_of(path).upper()}_{name}"
            self.assertIn(f"#ifndef {guard}\n#define {guard}\n", text, path)
            self.assertEqual(guards.setdefault(guard, path), path)
        self.assertGreater(len(guards), 300)

    def test_type_names_are_unique(self):
        """One name, one type in the whole house: so that units can be compiled together, and a reader is not misled."""
        where = {}
        for path, text in sources():
            if path.suffix == ".h":
                text = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
                for name in re.findall(r"^typedef (?:struct|enum|union) (tp_\w+) \{", text, re.MULTILINE):
                    self.assertEqual(where.setdefault(name, path), path, name)
        self.assertGreater(len(where), 300)

    def test_every_file_has_a_head(self):
        """After the licence, before all code, a comment says what problem the file solves and how: at least 20
        characters; so a reader of a folder need not read its files to find the one that he wants."""
        for path, text in sources():
            head = HEAD.match(text)
            self.assertIsNotNone(head, f"{path}: no comment after the licence that says what the file is for")
            words = re.sub(r"\s*\n \*\s*", " ", head.group(1)).strip()
            self.assertGreaterEqual(len(words), 20, f"{path}: '{words}' says too little of the file")

    def test_a_file_without_a_head_is_seen(self):
        """The check itself: a file whose first comment belongs to its code, one that says nothing, and one that does."""
        licence = "/* SPDX-License-Identifier: X */\n/* SPDX-FileCopyrightText: Y */\n\n"
        self.assertIsNone(HEAD.match(licence + '#include "a.h"\n\n/* The sum of two numbers. */\nint a;\n'))
        self.assertLess(len(HEAD.match(licence + "/* Numbers. */\n\nint a;\n").group(1).strip()), 20)
        self.assertTrue(HEAD.match(licence + "/* Sums of numbers,\n * pairwise. */\n\nint a;\n"))

    def test_files_that_comments_name_are_there(self):
        """A comment sends the reader to a file by its path from src/, or by its name where that says which."""
        files = {str(path) for path, _ in sources()} | {str(path.relative_to(ROOT)) for path in ROOT.glob("docs/*.md")}
        looked_at = 0
        for path, text in sources():
            for comment in re.findall(r"/\*.*?\*/", text, re.DOTALL):
                for name in re.findall(r"(?<![\w/.<-])(?:\w+/)*\w+\.(?:c|h|md)\b", comment):
                    looked_at += 1
                    there = any(file == name or file.endswith("/" + name) for file in files)
                    self.assertTrue(there or name in STANDARD, f"{path}: a comment names {name}")
        self.assertGreater(looked_at, 100)

    def test_cpp_stays_in_its_rooms(self):
        """CGAL's in geom, Eigen's in linear_program, each behind a header of C."""
        for path, text in sources():
            for library, room in (("CGAL/", "geom"), ("Eigen/", "linear_program")):
                if f"<{library}" in text:
                    self.assertEqual(room_of(path), room, path)
            if path.suffix in (".cpp", ".hpp"):
                self.assertIn(room_of(path), ("geom", "linear_program"), path)


def call_graph(root=ROOT):
    """Each compiled source to the names of others that it uses, {name: source}: functions and tables, by what it says."""
    aside = re.compile(r"/\*.*?\*/|//[^\n]*|\"(?:[^\"\\\n]|\\.)*\"", re.DOTALL)
    definition = re.compile(r"^(?!static\b|typedef\b|extern\b)[A-Za-z_][^;{}=()]*?\b(tp_\w+)"
                            r"(?:\([^;{}]*\)\s*\{|(?:\[\w*\])* = )", re.MULTILINE)
    texts = {str(path): aside.sub(" ", text) for path, text in sources(root)
             if path.suffix in (".c", ".cpp") and room_of(path) != "explorer"}  # whose wasm/ replaces two files
    defined = {name: source for source, text in texts.items() for name in definition.findall(text)}
    return {source: {name: defined[name] for name in re.findall(r"\btp_\w+", text) if defined.get(name, source) != source}
            for source, text in texts.items()}


class Calls(unittest.TestCase):
    def test_none_climbs(self):
        """An include can be avoided by a declaration in the public headers; a call cannot hide."""
        looked_at, needed = 0, set()
        for source, names in call_graph().items():
            for name, target in names.items():
                looked_at += 1
                if climbs(room_of(source), room_of(target)):
                    needed.add((source, name))
                    self.assertIn((source, name), EXCEPTIONS,
                                  f"{source} uses {name} of {target}, a room above its own")
        self.assertGreater(looked_at, 1500)
        for source, name in EXCEPTIONS:
            if not name.endswith(".h"):
                self.assertIn((source, name), needed, "an exception that is no longer needed")


@unittest.skipUnless(shutil.which("nm"), "nm (binutils) is not installed")
class Compiled(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """The name of each unit of the library and its symbols, (name, class, section); but of C++, whose templates are CGAL's."""
        objects = [path for folder in BUILD.glob("libtopple*.p") for path in folder.glob("*.c.o")]
        if not objects:
            raise AssertionError(f"no compiled library in {BUILD}")
        lines = subprocess.run(["nm", "--format=sysv", *map(str, objects)], capture_output=True, text=True, check=True)
        cls.units = []
        for line in lines.stdout.splitlines():
            if line.startswith(("Symbols from ", "Undefined symbols from ")):
                cls.units.append((pathlib.PurePath(line.rstrip(":").split(" from ")[1]).stem, []))
            fields = [field.strip() for field in line.split("|")]
            if len(fields) == 7:
                cls.units[-1][1].append((fields[0], fields[2], fields[6]))

    def library(self):
        self.assertGreater(sum(len(symbols) for _, symbols in self.units), 5000)
        return self.units

    def test_no_data_that_changes(self):
        """Threads share nothing: there is no variable that outlives a call."""
        if any(re.match(r"__(\w*san|sanitizer)_", name) for _, all_of in self.units for name, _, _ in all_of):
            self.skipTest("a sanitizer adds data of its own")
        for source, all_of in self.library():
            for name, _, section in all_of:
                changes = re.match(r"\.(data|bss|tdata|tbss)|\*COM\*", section) and ".rel.ro" not in section
                self.assertFalse(changes, f"{source}: {name} lies in {section}")

    def test_neither_prints_nor_ends(self):
        for source, all_of in self.library():
            self.assertFalse(NEVER_CALLED & {name for name, kind, _ in all_of if kind == "U"}, source)


class Scripts(unittest.TestCase):
    def test_files_that_scripts_name_are_there(self):
        """What ./run, ./check and CI call has not moved away from them."""
        found = 0
        for script in ("run", "check", ".ci/run"):
            for name in re.findall(r'(?:\$top/|\./)((?:src|tests|python)/[\w./-]*\w)', (ROOT / script).read_text(encoding="utf-8")):
                found += 1
                self.assertTrue((ROOT / name).exists(), f"{script}: {name}")
        self.assertGreaterEqual(found, 2)


if __name__ == "__main__":
    main()
