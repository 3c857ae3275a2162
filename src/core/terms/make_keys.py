#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The C that reads the numbers of a scene by their keys, from keys.csv, where each key stands once.

    make_keys.py CODE,HEADER

Columns of keys.csv, of keys that hold numbers or truth values: member, where tp_scene has it, or the item of a list in whose path there is [];
rule, a tp_rule without its beginning; has, the function that says whether a scene has it, where it is not enough that it is
given, or - of a key that is read from files alone; settle, the function of what follows from it (scene_varying/slot_table.c);
example, of a key that must be given, the value that a message proposes where it is not.
Members: a tp_quantity; two with a comma between, of a pair; number and an fmpq_t; truth and a bool; points and a tp_polyline;
teeth, their number.

The header has TP_SCENE_KEYS(ROW), a row for each number that can vary in memory; TP_SCENE_LONE_NUMBERS, those that stand
alone; TP_SCENE_NUMBERS(MEMBER) and TP_NUMBERS_OF_…(MEMBER), the numbers of a scene and of an item; and tp_key_map_NAME for each
map of a scene: its keys, and its values (scene/key_map.h)."""

import csv
import pathlib
import re
import sys

TABLE = pathlib.Path(__file__).with_name("keys.csv")
#: Lists of a scene: kind, type of an item.
LISTS = {"block.holes": ("HOLES", "tp_polyline"), "block.parts": ("PARTS", "tp_part"), "block.arcs": ("ARCS", "tp_arc_description"),
         "block.rounded.corners": ("CORNERS", "tp_corner_description"), "loads.pressures": ("PRESSURES", "tp_line_load"),
         "loads.surcharges": ("SURCHARGES", "tp_line_load"), "loads.support_pressures": ("SUPPORTS", "tp_line_load"),
         "loads.anchors": ("ANCHORS", "tp_anchor_description"), "loads.forces": ("FORCES", "tp_anchor_description"),
         "joints": ("JOINTS", "tp_joint_description"),
         "friction.facets": ("FRICTIONS", "tp_facet_friction_description"),
         "tilt_test.tractions": ("TRACTIONS", "tp_traction_description")}
#: Items that are read from files alone: the type of one; and maps that have the keys of another besides their own.
ITEMS = {"blocks": "tp_listed_block", "jointed_slope.joints": "tp_joint_set",
         "solid.contacts": "tp_contact_description", "solid.parts": "tp_solid_part_description"}
INCLUDES = {"blocks": "block"}


class Key:
    def __init__(self, row):
        self.path, self.rule, self.has = row["path"], row["rule"] or "ANY", row["has"]
        self.settle, self.example = row["settle"], row["example"]
        kind, _, member = row["member"].rpartition(" ") if "," not in row["member"] else ("", "", row["member"])
        self.kind = {"": "QUANTITY", "number": "NUMBER", "truth": "TRUTH", "points": "POINT", "points of": "POINT"}.get(kind, kind)
        if row["member"] == "teeth":
            self.kind = "TEETH"
        self.members = [] if not row["member"] else [part.strip() for part in member.split(",")]
        base = next((base for base in LISTS if self.path.startswith(base) and ("[]" in self.path or self.kind == "POINT")), None)
        self.list, self.type = LISTS[base] if base else (None, "tp_scene")
        item = next((item for item in ITEMS if self.path.startswith(f"{item}[]")), None)
        self.is_item = item is not None
        self.type = ITEMS.get(item, self.type)
        self.section, _, self.name = self.path.rpartition(".")

    def offset(self, member):
        return "0" if self.kind == "TEETH" or member == "item" else f"offsetof({self.type}, {member})"

    def is_number(self):
        return self.kind == "QUANTITY" and len(self.members) == 1

    def is_value(self):
        """One that is read by its kind alone."""
        return self.is_number() or self.kind in ("NUMBER", "TRUTH")

    def stands_alone(self):
        """Of no list, with no condition but that it is given, and with nothing that follows from it."""
        return self.is_number() and not (self.list or self.is_item or self.has or self.settle)

    def rows(self):
        """Those of the numbers that can vary."""
        path = self.path.replace("[]", ".#")
        if self.kind == "POINT":
            path += ".#.#.#" if self.members == ["item"] else ".#.#"
        for k, member in enumerate(self.members if self.has != "-" and self.kind != "TRUTH" else ()):
            place = f"{path}.{k + 1}" if len(self.members) > 1 else path
            yield (f'ROW("{place}", {self.kind}, {f"TP_LIST_{self.list}" if self.list else "TP_LISTS"}, {self.offset(member)}, '
                   f'{self.rule}, {self.has or "NULL"}, {self.settle or "NULL"})')


def keys():
    lines = (line for line in TABLE.read_text(encoding="utf-8").splitlines() if not line.startswith("#"))
    return [Key(row) for row in csv.DictReader(lines) if row["file"] == "scene"]


def macro(name, argument, lines):
    return f"#define {name}({argument}) \\\n  " + " \\\n  ".join(lines) + "\n\n"


def maps(own):
    """By the names of maps, their keys."""
    found = {}
    for key in own:
        found.setdefault(key.section.replace("[]", ""), []).append(key)
    return {re.sub(r"\W", "_", name) or "scene": inside for name, inside in found.items()}


def value(key, name=None):
    """Its tp_key_value."""
    name = name or key.path
    example = f'"{name}: {key.example}"' if key.example else "NULL"
    return f'{{"{name}", TP_KEY_{key.kind}, {key.offset(key.members[0])}, TP_RULE_{key.rule}, {example}}}'


def header(own):
    numbers = dict.fromkeys(f"{member}.value" if key.kind == "QUANTITY" else member for key in own
                            if key.type == "tp_scene" and key.kind in ("QUANTITY", "NUMBER") for member in key.members)
    text = macro("TP_SCENE_KEYS", "ROW", [row for key in own for row in key.rows()])
    text += macro("TP_SCENE_NUMBERS", "MEMBER", [f"MEMBER(tp_scene, {member})" for member in numbers])
    for kind in dict.fromkeys([kind for _, kind in LISTS.values()] + list(ITEMS.values())):
        inside = dict.fromkeys(f"{member}.value" for key in own if key.type == kind and key.kind == "QUANTITY" for member in key.members)
        if inside:
            text += macro(f"TP_NUMBERS_OF_{kind.removeprefix('tp_').upper()}", "MEMBER", [f"MEMBER({kind}, {member})" for member in inside])
    lone = ", ".join(map(value, filter(Key.stands_alone, own)))
    text += f"#define TP_SCENE_LONE_NUMBERS {{{lone}}}\n\n"
    return text + "".join(f"extern const tp_key_map tp_key_map_{name};\n" for name in maps(own))


def map_of(name, inside, included):
    values = [value(key, key.name) for key in inside if key.is_value()]
    names = ", ".join(f'"{key.name}"' for key in inside + included)
    text = f"static const char *const keys_of_{name}[] = {{{names}, NULL}};\n"
    if values:
        text += f"static const tp_key_value values_of_{name}[] = {{{', '.join(values)}}};\n"
    used = f"values_of_{name}" if values else "NULL"
    return text + f"const tp_key_map tp_key_map_{name} = {{keys_of_{name}, {used}, {len(values)}}};\n\n"


MADE = "/* Made by core/terms/make_keys.py of keys.csv; not to be edited. */\n\n"


def write(code, declarations):
    own = keys()
    pathlib.Path(declarations).write_text(f"{MADE}#ifndef TP_SCENE_KEYS_H\n#define TP_SCENE_KEYS_H\n\n#include \"scene/key_map.h\"\n\n"
                                          f"{header(own)}\n#endif\n", encoding="utf-8")
    all_maps = maps(own)
    made = "".join(map_of(name, inside, all_maps.get(INCLUDES.get(name), [])) for name, inside in all_maps.items())
    pathlib.Path(code).write_text(f'{MADE}#include "scene_keys.h"\n\n{made}', encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 2 or "," not in sys.argv[1]:
        sys.exit("usage: make_keys.py CODE,HEADER")
    write(*sys.argv[1].split(","))
