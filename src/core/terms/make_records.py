#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The records of Python, records.py: a dataclass for each struct of the public headers that a result is made of, with a field
for each member, typed and commented as there.

    make_records.py OUTPUT HEADER… MODULE…

A field is None where the member's comment begins with a condition that does not hold ("if has_closure: …"), where has_NAME is
false, or where its struct is not `known`. A member that counts the items of another one, or says whether it is there (has_…,
known), is no field, nor is the size of a struct. A class XMethods of a Python MODULE of the package is a base of X."""

import pathlib
import re
import sys
import textwrap

import make_words

STRUCT = re.compile(r"^typedef struct (tp_\w+) \{\n(.*?)^\} \1;", re.MULTILINE | re.DOTALL)
MEMBER = re.compile(r"((?:struct )?\w+)\s+(\w.*|\*.*)", re.DOTALL)
UNIT = re.compile(r"(_[xy])?_(deg|m|n|pa|m_s2|x|y)$")
NAME = re.compile(r"(\**)(\w+)((?:\[\w+\])*)")
PLAIN = {"tp_bounded": "Bounded", "bool": "bool", "double": "float", "float": "float", "int": "int", "long": "int",
         "unsigned": "int", "uint64_t": "int", "int64_t": "int", "size_t": "int"}
#: Records that are not called as their structs.
NAMES = {"tp_load_result": "LoadResult", "tp_claim_result": "ClaimResult", "tp_study_result": "StudyResult",
         "tp_tilt_convergence": "Convergence", "tp_tilt_convergence_case": "ConvergenceCase"}
#: What the calls return, of which all others are part.
ROOTS = ("tp_solution", "tp_batch", "tp_found", "tp_accuracy", "tp_derivation", "tp_family", "tp_profile", "tp_study_result",
         "tp_tilt_test", "tp_verification", "tp_load_cases", "tp_block_system", "tp_solid")
#: Members of these kinds are read by Python's own code.
BY_HAND = ("tp_profile_options", "tp_study_column")


def class_name(struct):
    return NAMES.get(struct) or "".join(part.capitalize() for part in struct.removeprefix("tp_").removesuffix("_result").split("_"))


def sentence(comment):
    """A comment on one line."""
    return " ".join(line.strip().removeprefix("*").strip() for line in comment.splitlines()).strip()


class Member:
    """A member, and what its comment says of it: if CONDITION, else it is not there; COUNT of them; `by SET` (of words),
    `where CONDITION`, an array of one for each word; set of WORDS, the bits of a number."""

    TOLD = re.compile(r"(?:if ([^:]*?)(?:: |$))?(?:(\w+) of them: |by (\w+)(?: where ([^:]*))?: |set of (\w+): )?(.*)")

    def __init__(self, kind, stars, name, sizes):
        self.kind, self.stars, self.name = kind.removeprefix("struct "), len(stars), name
        self.sizes = re.findall(r"\w+", sizes)
        self.tell("")

    def tell(self, comment):
        self.condition, self.count, self.by, self.where, self.bits, text = self.TOLD.fullmatch(comment).groups()
        self.comment = re.sub(r"(^|[;,] )owned by [^;]*", "", text.replace("NULL", "None")).strip()


class Struct:
    """Its members; a comment is of those of the declaration before it."""

    def __init__(self, comment, body):
        self.comment, self.members, last = sentence(comment), [], []
        for part in re.finditer(r"/\*(.*?)\*/|([^;/]+);", body, re.DOTALL):
            if part[2] is None:
                for member in last:
                    member.tell(sentence(part[1]))
                continue
            kind, names = MEMBER.fullmatch(re.sub(r"\b(const|TP_OUTSIDE)\b", "", part[2]).strip()).groups()
            last = [Member(kind, *NAME.fullmatch(name.strip()).groups()) for name in names.split(",")]
            self.members += last
        self.by_name = {member.name: member for member in self.members}
        self.conditions = {member.condition for member in self.members}

    def has(self, name, kind):
        return name in self.by_name and self.by_name[name].kind == kind

    @property
    def items(self):
        """Of a list, which has its items, their number and maybe whether it is there: the items."""
        return self.by_name.get("items") if set(self.by_name) <= {"items", "count", "run"} else None

    def count_of(self, member):
        """The member that counts the items of another one; None where all of an array are meant."""
        one = re.sub(UNIT, "", member.name)
        one = re.sub(r"ies$", "y", one) if one.endswith("ies") else re.sub(r"(?<=indic)es$|s$", "", one)
        many = member.stars > (member.kind == "char")
        for name in (member.count, f"{member.name}_count", f"{one}_count", many and "count"):
            if name and name != member.name and self.has(name, "size_t"):
                return name
        return None

    def condition_of(self, member):
        """When a value is there: as its comment says, or where has_… of its name without its unit is true."""
        for name in (member.name, re.sub(UNIT, "", member.name)):
            if member.condition is None and self.has(f"has_{name}", "bool"):
                return f"has_{name}"
        return member.condition


class Structs:
    """Those of some headers."""

    def __init__(self, headers):
        self.texts, self.read = {}, {}
        for header in headers:
            text = pathlib.Path(header).read_text(encoding="utf-8")
            for match in STRUCT.finditer(text):
                before = text[:match.start()].rstrip()
                self.texts[match[1]] = (before[before.rindex("/*") + 2:-2], match[2])

    def of(self, name):
        if name in self.texts and name not in PLAIN:
            if name not in self.read:
                self.read[name] = Struct(*self.texts[name])
            return self.read[name]
        return None


def in_python(condition):
    """A condition on members of C: the name of one, or a function of the struct."""
    if re.fullmatch(r"\w+", condition):
        return f'"{condition}"'
    text = re.sub(r"(?<![\w.])[a-z]\w*", lambda name: f"c.{name[0]}", condition)
    text = re.sub(r"!(?!=)", "not ", text.replace("&&", "and").replace("||", "or").replace("NULL", "ffi.NULL"))
    return "lambda c: " + re.sub(r"\bTP_\w+", lambda word: f"lib.{word[0]}", text)


class Field:
    """A field of a record: its type, and what record.py is told of it."""

    def __init__(self, kind, condition=None, **told):
        self.told = {key: value for key, value in told.items() if value}
        if condition:
            self.told["when"] = in_python(condition)
            kind += "" if kind.endswith(" | None") else " | None"
        self.kind = kind

    def line(self, member):
        told = ", ".join(f'"{key}": {value}' for key, value in self.told.items())
        line = f"    {member.name}: {self.kind}" + (f" = dataclasses.field(metadata={{{told}}})" if told else "")
        comment = f"  #: {member.comment}" if member.comment else ""
        if len(line + comment) <= 130:
            return line + comment + "\n"
        return textwrap.indent(textwrap.fill(member.comment, 120), "    #: ") + "\n" + line + "\n"


class Writer:
    def __init__(self, structs, methods):
        self.structs, self.methods, self.made = structs, methods, {}
        self.words = {f"tp_{name}" for name in make_words.sets()}

    def value(self, kind):
        """The type of a value of C."""
        if kind in PLAIN:
            return PLAIN[kind]
        if kind not in self.words:
            self.make(kind)
        return class_name(kind)

    def field(self, struct, member):
        """None of what the library keeps for itself, or Python has in another way."""
        inner = self.structs.of(member.kind)
        if member.kind not in PLAIN and member.kind not in self.words and member.kind != "char" and inner is None:
            return None
        if member.name in ("size", "case_size") and member.kind == "size_t":
            return None  # of structs, for programs in C
        if member.kind in BY_HAND or len(member.sizes) > 1:
            return None
        count = struct.count_of(member)
        if member.kind in PLAIN and member.stars and not count:
            return None  # storage of what others point to
        counted = f'"{count}"' if count else None
        if member.kind == "char":
            if member.stars == 2:
                return Field("tuple[str, ...]", count=counted)
            return Field("str | None" if "None" in member.comment else "str", struct.condition_of(member))
        if inner and inner.items:
            there = f'"run"' if "run" in inner.by_name else None
            return Field(f"tuple[{self.value(inner.items.kind)}, ...]" + (" | None" if there else ""), items=there or "True")
        kind, condition = self.value(member.kind), struct.condition_of(member)
        if member.bits:
            return Field(f"tuple[{class_name(f'tp_{member.bits}')}, ...]", condition, bits="True")
        if member.by and f"tp_{member.by}" in self.words:
            word = class_name(f"tp_{member.by}")
            where = member.where or ("known" if inner and "known" in inner.by_name else None)
            kind = f"tuple[{kind}, ...]" if member.stars else kind
            return Field(f"dict[{word}, {kind}]", count=counted, where=where and in_python(where))
        if member.sizes or member.stars and count:
            return Field(f"tuple[{kind}, ...]", condition, count=counted)
        if condition is None and inner and "known" in inner.by_name and "known" not in inner.conditions:
            condition = f"{member.name}.known"
        return Field(kind + (" | None" if member.stars else ""), condition)

    def make(self, name):
        """The class of a struct, after those that it is made of."""
        if name in self.made:
            return
        struct, own = self.structs.of(name), class_name(name)
        self.made[name] = ""
        fields = [(member, self.field(struct, member)) for member in struct.members]
        counts = {struct.count_of(member) for member in struct.members}
        shown = "".join(field.line(member) for member, field in fields
                        if field and member.name not in counts and not re.match("has_|known$", member.name))
        bases = f"{own}Methods, Record" if f"{own}Methods" in self.methods else "Record"
        meaning = textwrap.indent(textwrap.fill(f'"""{struct.comment}"""', 120), "    ")
        del self.made[name]  # after those that it needs
        shows = ", repr=False" if "def __repr__" in self.methods.get(f"{own}Methods", ("", ""))[1] else ""
        self.made[name] = f"@dataclasses.dataclass(frozen=True{shows})\nclass {own}({bases}):\n{meaning}\n\n{shown}\n\n"


HEAD = '''# Made by src/core/terms/make_records.py of the public headers; not to be edited.
"""What results are made of: a record for each struct of the library, with its members as fields. SI units and degrees, as the
names say; what is in the unit of the scene says so."""

from __future__ import annotations

import dataclasses

from ._library import ffi, lib
METHODSfrom .record import Bounded, Record
from .words import (WORDS)


'''


def methods_of(modules):
    """By their names, the modules of the classes of methods, and their code."""
    return {name: (pathlib.Path(module).stem, code) for module in modules
            for name, code in re.findall(r"^class (\w+Methods)\b(.*?)(?=^\S|\Z)", pathlib.Path(module).read_text(encoding="utf-8"),
                                         re.MULTILINE | re.DOTALL)}


def python(headers, modules):
    methods = methods_of(modules)
    writer = Writer(Structs(headers), methods)
    for root in ROOTS:
        writer.make(root)
    text = "".join(writer.made.values())
    words = sorted(class_name(word) for word in writer.words if re.search(rf"\b{class_name(word)}\b", text))
    listed = ", ".join(words)
    imports = "".join(f"from .{module} import ({', '.join(name for name, (own, _) in methods.items() if own == module)})\n"
                      for module in sorted({module for module, _ in methods.values()}))
    head = HEAD.replace("METHODS", imports).replace("WORDS", textwrap.fill(listed, 100, subsequent_indent=" " * 20))
    names = ", ".join(f'"{class_name(struct)}"' for struct in writer.made)
    return head + text + "__all__ = [" + textwrap.fill(names, 110, subsequent_indent="           ") + "]\n"


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit("usage: make_records.py OUTPUT HEADER… MODULE…")
    made = python([path for path in sys.argv[2:] if path.endswith(".h")], [path for path in sys.argv[2:] if path.endswith(".py")])
    pathlib.Path(sys.argv[1]).write_text(made, encoding="utf-8")
