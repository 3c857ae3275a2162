# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Scenes of tests/hard: what their comments say, and the big files that they name.

    # Hard: why                      goes on in lines that begin with three blanks
    # Truth: how it is known
    #: let NAME = FORMULA
    #: PATH = FORMULA                of the JSON: left.toppling.critical_angle_deg; both directions
                                     where it names none; found, touching: the numbers of `find`
    #: refused LINE:COLUMN: MESSAGE  instead
    #: undecided                     even the dearest arithmetic leaves something open; see the story
    #: find KEY RESULT=VALUE LOW HIGH
    #: file NAME = GENERATOR(…)      one of those below
    #: text NAME = GENERATOR(…)      put into the scene where NAME stands
    #: big                           only where TOPPLE_HARD=all

Formulas are those of truth.py; they know `outline`, `holes`, `profile` and the parameters of the
scene, as its text gives them."""

import io
import re
from decimal import Decimal

from truth import Formula, read


def collinear(file, count):
    """The square (0, 0) (1, 0) (1, 1) (0, 1) with so many points on its underside."""
    file.writelines(f"{Decimal(k) / int(count):f}, 0\n" for k in range(int(count)))  # a power of ten
    file.write("1, 0\n1, 1\n0, 1\n")


def teeth(file, count, depth):
    """`count` teeth of width 1 below a block as high as wide, valleys at 0, peaks at depth."""
    count = int(count)
    file.writelines(f"{k}, {0 if k % 2 == 0 else depth}\n" for k in range(count + 1))
    file.write(f"{count}, {count}\n0, {count}\n")


def grid(file, columns, rows):
    """Square holes of half a unit, one in the middle of every unit of a grid."""
    file.write("[" + ", ".join(
        f"[[{x}.25, {y}.25], [{x}.75, {y}.25], [{x}.75, {y}.75], [{x}.25, {y}.75]]"
        for x in range(int(columns)) for y in range(int(rows))) + "]")


GENERATORS = {f.__name__: f for f in (collinear, teeth, grid)}


def generate(file, generator, arguments):
    GENERATORS[generator](file, *(a.strip() for a in arguments.split(",")))


DIRECTIVE = re.compile(r"#: (.*)")


def bracketed(text, key):
    """The flow list or map after a key: its text, or None."""
    found = re.search(rf"\b{key}: *(?=[\[{{])", text)
    if not found:
        return None
    depth = 0
    for k in range(found.end(), len(text)):
        depth += text[k] in "[{"
        depth -= text[k] in "]}"
        if depth == 0:
            return text[found.end():k + 1]
    raise ValueError(f"{key}: a bracket stays open")


class Case:
    def __init__(self, path):
        self.path, self.text = path, path.read_text(encoding="utf-8")
        self.story, self.how = self.comment("Hard"), self.comment("Truth")
        self.lets, self.truths, self.files, self.inserts, self.options = [], [], [], [], []
        self.refusal, self.undecided, self.big = None, False, False
        for line in self.text.splitlines():
            found = DIRECTIVE.match(line)
            if found:
                self.direct(found.group(1))
        if not self.truths and not self.refusal:
            raise ValueError(f"{path}: no truth is given")

    def comment(self, head):
        lines = re.search(rf"^# {head}: (.*(?:\n#   .*)*)", self.text, re.M).group(1)
        return re.sub(r"\n#   ", " ", lines)

    def direct(self, text):
        word, _, rest = text.partition(" ")
        if word == "let":
            name, formula = rest.split(" = ", 1)
            self.lets.append((name, Formula(formula)))
        elif word == "refused":
            self.refusal = rest
        elif word in ("undecided", "big"):
            setattr(self, word, True)
        elif word in ("file", "text"):
            own = re.fullmatch(r"(\S+) = (\w+)\((.*)\)", rest).groups()
            (self.files if word == "file" else self.inserts).append(own)
        elif word == "find":
            key, target, low, high = rest.split()
            self.options = ["--find", key, "--for", target, "--from", low, "--to", high]
        else:
            path, formula = text.split(" = ", 1)
            self.truths.append((path.split("."), Formula(formula)))

    def write(self, folder):
        """The scene, and the files that it names, into a folder."""
        scene = self.text
        for name, generator, arguments in self.inserts:
            text = io.StringIO()
            generate(text, generator, arguments)
            scene = scene.replace(name, text.getvalue())
        (folder / self.path.name).write_text(scene, encoding="utf-8")
        for name, generator, arguments in self.files:
            with open(folder / name, "w", encoding="utf-8") as file:
                generate(file, generator, arguments)

    def names(self):
        """The parameters, lists of vertices and lets of the case."""
        scene, names = re.sub(r"#.*", "", self.text).replace("^", "**"), {}
        parameters = bracketed(scene, "parameters") or "{}"
        for name, formula in re.findall(r"(\w+): *([^,}]+)", parameters):
            names[name] = read(formula, names)
        for key in ("outline", "holes", "profile"):
            points = bracketed(scene, key)
            if points and "[" in points[1:] and ":" not in points:
                names[key] = read(points, names)
        for name, formula in self.lets:
            names[name] = formula.value(names)
        return names
