# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Strings that some language of output would take for its own, and a check for each language.

The checks share no code with the program: they are Python's parsers of JSON, XML and CSV, the C
compiler, and, where Python has none, small readers of what the page says is allowed."""

import csv
import ctypes
import io
import itertools
import json
import math
import pathlib
import re
import subprocess
import tempfile
import unicodedata
import unittest
import xml.etree.ElementTree

from harness import LONG, PROGRAM

TEXTS = [
    'x */ int evil(void){return system("id");} /* ',
    "*/\nint evil(void) { return 1; }\n/*",
    "ends in a stroke \\", "ends in a star *", "/", "??/", "*??/\n/ int evil; /*", "// evil", "*\\\n/ int evil;",
    "\n\\input{secret}\n", "^^M\\input{secret}", "100 % of $x_1^2$ & #1 ~ {a}",
    "| a | b |\n| --- | --- |", "a \\| b", "`x` ``y`` ```", "`a|b`", "<script>alert(1)</script>", "<!-- ",
    "![x](javascript:alert(1)) [y](http://x.invalid) <http://x.invalid>", "http://x.invalid www.x.invalid a@x.invalid",
    "&lt;b&gt; &#60;i&#62;", "# heading", "1. item", "- item", "    code", "---", "{{ site }} {% raw %}",
    "]]>", "<![CDATA[", "\ufffe\uffff\ufdd0", "\U0001fffe", '"><svg onload="x">', "&evil;",
    "=cmd|' /C calc'!A0", "+1+cmd", "-1+cmd", "@SUM(A1)", "\t=1+1", "'=1", 'a,"b";c\r\nd',
    "'; system 'touch evil'; '", "`touch evil`", "$(touch evil)", "@macro", "a_b^c{/:Bold d}@e&f", "%s %n %d %1$s", "\\n \\t",
    "\x1b[31mRED\x1b]0;title\x07", "\x08\x7f\x85\x9b31m", "\u202eabc\u2066\u2069\u200f\u061c", "a\u200bb\u2060\ufeff", "\u2028\u2029",
    "\u00ad\u034f\u115f\u3164\U000e0041", "Größe ≥ 3 µm, 岩塊 🪨 ⚠️", "é" * 3000, "ß" * 127 + "\u202e", "", " ", "\n\n",
]

NAMES = ["double", "int", "while", "restrict", "class", "NULL", "M_PI", "I", "unix", "linux", "errno", "EOF", "INFINITY_", "sin",
         "cos", "tan", "y0", "y1", "j0", "gamma", "sqrtf", "powl", "area", "main", "alpha", "phi", "normal", "parallel",
         "tan_critical_angle_1", "fos_elements_1", "tan_limit_left", "_", "__x", "_Bool", "__FILE__", "p_double", "p_p_double", "N", "n", "N_",
         "isnan", "signgam", "assert", "and", "a_b", "alpha_1", "E", "JRC"]

SCENE = """topple: 1
title: {title}
length_unit: mm
parameters: {{a: 30, b: 120, c: 5}}
block: {{teeth: {{count: 3, width: a, height: b, depth: c, left_end: valley}}, thickness: 20, unit_weight_kn_m3: 25}}
base: {{mated: true, beyond: {{left: 0, right: 0}}}}
friction_angle_deg: 30
tilt: {{towards: left, angle_deg: 20}}
"""
CLAIMS = """topple_claims: 1
title: {0}
source: {0}
geometries: {{slab: {{scene: slab.yaml, towards: left}}}}
claims:
- {{id: {1}, where: {0}, geometry: slab, quantity: critical_angle, printed: {2}, unit: {0}, note: {0}}}
- {{id: {3}, where: {0}, geometry: slab, quantity: area, printed: "a*b + a", note: {0}}}
"""
SLAB = """topple: 1
length_unit: m
parameters: {a: 1, b: 2}
block: {slab: {width: a, height: b}}
base: {mated: true}
tilt: {towards: left}
"""


class Case(unittest.TestCase):
    """A folder of its own, and the program run in it."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def run_bytes(self, *words, status=0):
        """Status, stdout and stderr as bytes; whatever the end, stderr is plain and short."""
        done = subprocess.run([PROGRAM, *words], cwd=self.path, capture_output=True, timeout=300)
        expected = (status,) if isinstance(status, int) else status
        self.assertIn(done.returncode, expected, (words, done.stderr))
        if done.stderr:
            plain(done.stderr, self)
        return done.stdout, done.stderr

    def scene(self, title, name="scene.yaml", text=SCENE):
        (self.path / name).write_text(text.format(title=yaml(title)), encoding="utf-8")
        return name


def unseen(character):
    """Does a character act on a terminal without being seen? By Python's tables of Unicode."""
    code = ord(character)
    return (unicodedata.category(character) in ("Cc", "Cf", "Cs", "Zl", "Zp") or code & 0xfffe == 0xfffe
            or 0xfdd0 <= code <= 0xfdef or character in "\u034f\u115f\u1160\u3164\uffa0")


def plain(data, case):
    """Bytes for a terminal: UTF-8, and nothing but what is seen on lines of the program's own."""
    text = data.decode("utf-8")
    case.assertEqual([hex(ord(c)) for c in text if c != "\n" and unseen(c)], [], text[:300])
    return text


def one_line(data, case):
    """A message: one line, bounded."""
    text = plain(data, case)
    case.assertTrue(text.endswith("\n") and text.count("\n") == 1, text)
    case.assertLess(len(text), 1400)
    return text


def yaml(text):
    """The text as a double-quoted scalar of YAML."""
    out = ""
    for c in text:
        code = ord(c)
        if 0x20 <= code < 0x7f and c not in '"\\':
            out += c
        else:
            out += f"\\x{code:02x}" if code < 0x100 else f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}"
    return f'"{out}"'


def as_json(data, case):
    """Any text is carried, and nothing acts on a terminal."""
    plain(data, case)
    return json.loads(data.decode("utf-8"))


def as_csv(data, case):
    """Rows of one length; no cell is a formula to a spreadsheet."""
    rows = list(csv.reader(io.StringIO(plain(data, case), newline="")))
    case.assertEqual({len(row) for row in rows}, {len(rows[0])})
    for cell in (cell for row in rows for cell in row):
        if cell.lstrip()[:1] in ("=", "+", "-", "@") and cell.strip():
            float(cell)
    return rows


def as_xml(data, case):
    return xml.etree.ElementTree.fromstring(data)


def as_markdown(data, case, columns):
    """Tables keep their columns, and nothing is HTML but code, an image, or a link."""
    text = plain(data, case)
    for line in text.splitlines():
        bare = re.sub(r"(`+)(?!`).*?(?<!`)\1(?!`)", "C", line) if "|" not in re.sub(r"`[^`|]*`", "", line) else re.sub(
            r"`[^`|]*`", "C", line)
        bare = bare.replace("<code>", "").replace("</code>", "")
        bare = re.sub(r"\\[!-/:-@\[-`{-~]", "E", bare)
        case.assertNotRegex(bare, r"[<>`]|\]\(|!\[|://|www\.|@|\$|\{|\}", line)
        if line.startswith("|"):
            case.assertEqual(bare.count("|"), columns + 1, line)
    return text


LATEX_COMMANDS = {"[", "]", "tan", "sin", "cos", "cot", "alpha", "phi", "mathrm", "frac", "left", "right", "ge", "_", "("}


def as_latex(data, case):
    """Comments, and displayed formulas of known commands alone, with balanced braces."""
    for line in plain(data, case).splitlines():
        if line.startswith("%") or line == "":
            continue
        case.assertTrue(line.startswith("\\[ ") and line.endswith(" \\]"), line)
        commands = re.findall(r"\\([A-Za-z]+|.)", line)
        case.assertLessEqual(set(commands), LATEX_COMMANDS, line)
        body = re.sub(r"\\_", "", line)
        case.assertEqual(body.count("{"), body.count("}"), line)
        case.assertNotRegex(body, r"[%$#&~]|_(?![{xyc])", line)


LIBRARIES = itertools.count()  # a library is loaded once under a name


def compile_c(data, case, folder, expected, thorough=True):
    """C and C++ without a warning, with the functions that are expected and no others; the library."""
    source = pathlib.Path(folder) / "derived.c"
    source.write_bytes(data)
    plain(data, case)
    library = source.with_name(f"derived_{next(LIBRARIES)}.so")
    strict = ["-Wall", "-Wextra", "-Wno-unused-parameter", "-Wcomment", "-Wtrigraphs", "-Werror"]
    for command in (["gcc", "-std=c99", "-pedantic", *strict, "-trigraphs", "-shared", "-fPIC", source, "-o", library, "-lm"],
                    ["gcc", "-std=gnu17", *strict, "-include", "complex.h", "-include", "errno.h", "-fsyntax-only", source],
                    ["g++", "-x", "c++", *strict, "-fsyntax-only", source])[:3 if thorough else 1]:
        done = subprocess.run(command, capture_output=True, text=True)
        case.assertEqual((done.returncode, done.stderr), (0, ""), data.decode()[:600])
    names = subprocess.run(["nm", "-D", "--defined-only", library], capture_output=True, text=True, check=True).stdout
    case.assertEqual({line.split()[2] for line in names.splitlines()}, set(expected))
    return library


def share(items, number):
    """A quarter of the items, for four neighbouring numbers all of them; all for each in the long rounds. So every text
    meets a quarter of the places, and every place a quarter of the texts."""
    return items[number % 4::4] if not LONG else items


def code_of_c(data, case, folder):
    """What the compiler sees of it, without a warning: comments are gone, and all that is included is there."""
    source = pathlib.Path(folder) / "derived.c"
    source.write_bytes(data)
    plain(data, case)
    done = subprocess.run(["gcc", "-std=c99", "-trigraphs", "-Wcomment", "-Wtrigraphs", "-Werror", "-E", "-P", source],
                          capture_output=True, text=True)
    case.assertEqual((done.returncode, done.stderr), (0, ""), data.decode()[:600])
    return done.stdout


def call(library, function, *numbers):
    """Its value, called from Python."""
    entry = getattr(ctypes.CDLL(str(library)), function)
    entry.restype, entry.argtypes = ctypes.c_double, [ctypes.c_double] * len(numbers)
    value = entry(*numbers)
    assert not math.isnan(value)
    return value
