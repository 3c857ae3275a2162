# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Makes the benchmark: coordinates as CSV, manifest.json, and answers.json by `topple solve --json`.

    python3 make.py TOPPLE [FOLDER [NAME...]]

TOPPLE is the program; FOLDER is this one unless another is given; NAMEs are of the cases to make, else all of them. The same
parameters and seeds make the same bytes. docs/benchmark_cases.md defines every quantity."""

import json
import math
import pathlib
import subprocess
import sys
import tempfile

import cases

PLACE = "coordinates"  # the folder of the points
ANGLE_DIGITS, MOMENT_DIGITS = 9, 12  # of a bracket: places of an angle in degrees, significant digits of a length or an area


def text(value):
    """An exact decimal of a rational that has one."""
    value = cases.Fraction(value)
    places = 0
    while (value * 10**places).denominator != 1:
        places += 1
    whole = abs(value.numerator * 10**places // value.denominator)
    sign = "-" if value < 0 else ""
    digits = f"{whole:0{places + 1}}"
    return sign + (f"{digits[:-places]}.{digits[-places:]}" if places else digits)


def write_points(path, points):
    path.write_text("x_m,y_m\n" + "".join(f"{text(x)},{text(y)}\n" for x, y in points))


def load_lines(loads):
    """The loads of a case as keys of a scene."""
    keys = {"seismic": [], "force": [], "pressure": []}
    for own in loads:
        keys[own["type"]].append(own)
    if keys["seismic"]:
        yield f"  seismic: {{horizontal: {keys['seismic'][0]['horizontal']}, vertical: 0, direction: down_dip}}"
    if keys["force"]:
        yield "  anchors:"
        for own in keys["force"]:
            x, y = float(own["fx_kn"]), float(own["fy_kn"])
            size = own["fx_kn"] if y == 0 else own["fy_kn"]
            yield (f"    - {{at: [{own['x_m']}, {own['y_m']}], direction_deg: {round(math.degrees(math.atan2(y, x)))}, "
                   f"force_kn: {size.lstrip('-')}, passive: false}}")
    if keys["pressure"]:
        yield "  pressures:"
        for own in keys["pressure"]:
            yield f"    - {{from: [{', '.join(own['from_m'])}], to: [{', '.join(own['to_m'])}], kpa: [{', '.join(own['kpa'])}]}}"


def scene(own):
    """The case as Topple reads it."""
    weight = f", unit_weight_kn_m3: {own['unit_weight_kn_m3']}" if "unit_weight_kn_m3" in own else ""
    lines = ["topple: 1", f"title: \"{own['title']}\"", "length_unit: m",
             f"block: {{outline: {own['name']}_block.csv{weight}}}", f"base: {{profile: {own['name']}_base.csv}}"]
    if own["loads"]:
        lines += ["loads:", *load_lines(own["loads"])]
    lines += [f"friction_angle_deg: {own['friction_deg']}", f"tilt: {{towards: {own['towards']}}}"]
    return "\n".join(lines) + "\n"


def bracket(said, places, least=-math.inf):
    """Decimals around a computed number: the nearest of so many places, and one unit of the last to both sides, which holds the
    truth as long as the program's own bound is below two fifths of a unit. The same on every machine."""
    unit = 10.0**-places
    if said["error"] > 0.4 * unit:
        raise SystemExit(f"the bound {said['error']} of {said['value']} is above 0.4e-{places}")
    middle = round(said["value"], places)
    return {"low": max(round(middle - unit, places), least), "high": round(middle + unit, places)}


def significant(said, scale):
    """A bracket of MOMENT_DIGITS digits of a length or an area of the size `scale`."""
    return bracket(said, MOMENT_DIGITS - 1 - math.floor(math.log10(scale)))


def angle_or_word(said, kind, places=ANGLE_DIGITS):
    return {"never": True} if kind == "interlocked" or said is None else bracket(said, places)


def single_answers(own, solved):
    """Brackets of everything that is asked of one block."""
    (report,) = solved["cases"]
    first = own["block"][0]
    scale = max(max(abs(float(x - first[0])), abs(float(y - first[1]))) for x, y in own["block"])
    block = report["block"]
    answers = {"area_m2": significant(block["area_m2"], block["area_m2"]["value"])}
    for axis, at in (("x", first[0]), ("y", first[1])):
        offset = cases.Fraction(block[f"centroid_{axis}_m"]["digits"]) - at  # far away a double has no digit of it
        answers[f"centroid_d{axis}_m"] = significant({"value": float(offset), "error": 1e-14 * scale}, scale)
    if report["toppling"] is not None:
        answers["topple_deg"] = angle_or_word(report["toppling"]["critical_angle_deg"], "")
    limit, onset = report["limit"], report["onset"]
    answers["stand_deg"] = angle_or_word(onset["critical_angle_deg"], onset["kind"])
    answers["limit_deg"] = angle_or_word(limit["critical_angle_deg"], report["mechanism"] if limit["critical_angle_deg"] is None else "")
    first = answers["stand_deg"].get("low", 90.0)
    answers["moves_deg"] = {"low": first, "high": answers["limit_deg"].get("high", 90.0)}
    if answers["limit_deg"].get("never"):
        answers["moves_deg"]["never"] = True
    return answers


def solve(program, folder, own):
    path = folder / PLACE / f"{own['name']}.yaml"
    path.write_text(scene(own))
    done = subprocess.run([program, "solve", "--json", "--digits", "32", path.name], cwd=path.parent, capture_output=True,
                          text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(f"{own['name']}: exit {done.returncode}: {done.stderr}")
    path.unlink()
    return json.loads(done.stdout)


def entry(own):
    """What the manifest says of a case."""
    kept = {key: own[key] for key in ("group", "difficulty", "title", "seed", "unit_weight_kn_m3") if key in own}
    return {**kept, "friction_deg": str(own["friction_deg"]), "towards": own["towards"], "loads": own["loads"],
            "block": f"{PLACE}/{own['name']}_block.csv", "base": f"{PLACE}/{own['name']}_base.csv"}


def rows(table):
    """JSON with one case a line, which a difference shows well."""
    return "{\n" + ",\n".join(f" {json.dumps(name)}: {json.dumps(own)}" for name, own in table.items()) + "\n}\n"


def make(program, folder, names=()):
    """Write all files into the folder; manifest and answers hold the cases that were made."""
    manifest, answers = {}, {}
    (folder / PLACE).mkdir(exist_ok=True)
    for own in cases.single():
        if names and own["name"] not in names:
            continue
        for what in ("block", "base"):
            write_points(folder / PLACE / f"{own['name']}_{what}.csv", own[what])
        manifest[own["name"]] = entry(own)
        answers[own["name"]] = single_answers(own, solve(program, folder, own))
    (folder / "manifest.json").write_text(rows(manifest))
    (folder / "answers.json").write_text(rows(answers))


if __name__ == "__main__":
    if len(sys.argv) < 2:
        raise SystemExit(__doc__)
    make(str(pathlib.Path(sys.argv[1]).resolve()),
         pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else pathlib.Path(__file__).parent, sys.argv[3:])
