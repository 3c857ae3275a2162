# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Makes the benchmark: coordinates as CSV, manifest.json, and answers.json by `topple solve --json`; times of falls by closed forms.

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
import cases_blocks
import cases_falls
import cases_placed
import cases_shaken
import cases_solids

PLACE = "coordinates"  # the folder of the points
ANGLE_DIGITS, MOMENT_DIGITS = 9, 12  # of a bracket: places of an angle in degrees, significant digits of a length or an area
TIME_DIGITS = 9  # places of a time in seconds
PEAK_DIGITS = 6  # places of a peak in shares of gravity
REST_DIGITS = 7  # places of an angle of a block that comes to rest first
BLOCKS_DIGITS = 4  # places of an angle of many blocks, of which the program's own bound is some 1e-5 degrees
AZIMUTHS = (0, 90, 180, 270)


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
             f"block: {{outline: {own['name']}_block.csv{weight}}}", f"base: {{profile: {own['name']}_base.csv{', place: rest' if 'place' in own else ''}}}"]
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


def shape_answers(own, block):
    first = own["block"][0]
    scale = max(max(abs(float(x - first[0])), abs(float(y - first[1]))) for x, y in own["block"])
    answers = {"area_m2": significant(block["area_m2"], block["area_m2"]["value"])}
    for axis, at in (("x", first[0]), ("y", first[1])):
        offset = cases.Fraction(block[f"centroid_{axis}_m"]["digits"]) - at  # far away a double has no digit of it
        answers[f"centroid_d{axis}_m"] = significant({"value": float(offset), "error": 1e-14 * scale}, scale)
    return answers


def single_answers(own, solved):
    """Brackets of everything that is asked of one block that lies as its coordinates say."""
    (report,) = solved["cases"]
    answers = shape_answers(own, report["block"])
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


def island_answers(own, solved):
    """Both ends of the tilts at which it is certain to stand, and of those at which any forces hold it."""
    (report,) = solved["cases"]
    before, after = report["onset"]["windows"]
    return {**shape_answers(own, report["block"]),
            "stands_from_deg": bracket(before["to_deg"], ANGLE_DIGITS), "stand_deg": bracket(after["from_deg"], ANGLE_DIGITS),
            "holds_from_deg": bracket(report["limit"]["holds_from_deg"], ANGLE_DIGITS),
            "limit_deg": bracket(report["limit"]["critical_angle_deg"], ANGLE_DIGITS)}


def rest_answers(own, solved):
    """How it comes to rest, and what follows in that pose."""
    (report,) = solved["cases"]
    rest = report["rest"]
    answers = {"turned_deg": bracket(rest["turned_deg"], ANGLE_DIGITS),
               **{f"moved_{axis}_m": bracket(rest[f"moved_{axis}_m"], MOMENT_DIGITS - 1) for axis in "xy"}}
    for quantity, said in (("topple_deg", report["toppling"]), ("stand_deg", report["onset"]), ("limit_deg", report["limit"])):
        answers[quantity] = bracket(said["critical_angle_deg"], REST_DIGITS)
    return answers


def many_scene(own):
    """Many blocks as Topple reads them."""
    lines = ["topple: 1", f"title: \"{own['title']}\"", "length_unit: m", f"friction_angle_deg: {own['friction_deg']}", "blocks:"]
    for name, outline in own["blocks"].items():
        points = ", ".join(f"[{text(x)}, {text(y)}]" for x, y in outline)
        lines.append(f"  - {{name: {name}, {'ground: true, ' if name == 'ground' else ''}outline: [{points}]}}")
    return "\n".join([*lines, f"tilt: {{towards: {own['towards']}}}"]) + "\n"


def many_answers(solved):
    """The limit, proven from both sides; and between which tilts the first motion lies: certain to stand, and one that can begin."""
    (report,) = solved["cases"]
    limit = bracket(report["critical_angle_deg"], BLOCKS_DIGITS)
    first = math.floor(100 * report.get("standing_angle_deg", 0)) / 100
    can = report.get("moving_angle_deg")
    last = limit["high"] if can is None else min(limit["high"], math.ceil(100 * can) / 100)
    return {"stand_deg": {"low": first, "high": last}, "limit_deg": limit, "moves_deg": {"low": first, "high": limit["high"]}}


def solid_answers(own, report):
    """Volume, centroid, the least tilt, and the tilt towards each of AZIMUTHS at which it topples or slides."""
    points = own["solid"][0]
    first, scale = points[0], max(abs(float(v - o)) for p in points for v, o in zip(p, points[0]))
    answers = {"volume_m3": significant(report["volume_m3"], report["volume_m3"]["value"])}
    near = all(abs(v) < 1000 for v in first)  # elsewhere doubles have no twelve digits of it
    for axis, said, at in zip("xyz", report["centroid_m"] if near else (), first):
        answers[f"centroid_d{axis}_m"] = significant({"value": said["value"] - float(at), "error": said["error"] + 1e-15 * scale}, scale)
    (band,) = report["bands"]
    answers["least_tilt_deg"] = bracket(band["least"]["tilt_deg"], ANGLE_DIGITS)
    rose = {round(own["azimuth_deg"]): own for own in band["rose"]}
    for azimuth in AZIMUTHS:
        answers[f"moves_{azimuth}_deg"] = bracket(rose[azimuth]["critical_deg"], ANGLE_DIGITS)
    return answers


def asked(program, folder, *arguments):
    done = subprocess.run([program, *arguments], cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(arguments)}: exit {done.returncode}: {done.stderr}")
    return json.loads(done.stdout)


def solve(program, folder, own, lines, *options):
    path = folder / PLACE / f"{own['name']}.yaml"
    path.write_text(lines)
    solved = asked(program, path.parent, "solve", "--json", *options, path.name)
    path.unlink()
    return solved


def entry(own, **files):
    """What the manifest says of a case."""
    kept = ("group", "place", "difficulty", "title", "seed", "unit_weight_kn_m3", "friction_deg", "towards", "loads", "moved_m", "shaking")
    said = {key: own[key] for key in kept if key in own}
    return {**said, "friction_deg": str(own["friction_deg"]), **{key: f"{PLACE}/{name}" for key, name in files.items()}}


def make_single(program, folder, own):
    files = {what: f"{own['name']}_{what}.csv" for what in ("block", "base")}
    for what, name in files.items():
        write_points(folder / PLACE / name, own[what])
    found = {"islands": island_answers, "unfitting profiles": rest_answers}.get(own["group"], single_answers)
    return entry(own, **files), found(own, solve(program, folder, own, scene(own), "--digits", "32"))


def make_fall(_, folder, own):
    """Its time is a closed form, or an integral."""
    files = {what: f"{own['name']}_{what}.csv" for what in ("block", "base")}
    for what, name in files.items():
        write_points(folder / PLACE / name, own[what])
    return entry(own, **files), {"moved_s": bracket({"value": cases_falls.moved_s(own), "error": 1e-12}, TIME_DIGITS)}


def overturns(program, folder, own, peak):
    frequency = own["shaking"]["full_sine"]["frequency_hz"]
    path = folder / PLACE / f"{own['name']}.yaml"
    path.write_text(scene(own) + "tilt_test: {engine: dynamics, method: events, protocol: release, restitution: 0}\n"
                    f"shaking: {{horizontal: {{full_sine: {{peak_g: {peak:.9f}, frequency_hz: {frequency}}}}}}}\n")
    said = asked(program, path.parent, "tilt", "--json", path.name)
    path.unlink()
    return said["cases"][0]["end"] == "overturned"


def make_shaken(program, folder, own):
    """Each edge between a thousandth below and above where a scan has it."""
    files = {what: f"{own['name']}_{what}.csv" for what in ("block", "base")}
    for what, name in files.items():
        write_points(folder / PLACE / name, own[what])
    answers = {}
    for k, (quantity, near) in enumerate(zip(cases_shaken.EDGES, own["near"])):
        low, high = float(near) - 1e-3, float(near) + 1e-3
        before = k % 2 == 1  # whether it overturns below the edge
        if [overturns(program, folder, own, peak) for peak in (low, high)] != [before, not before]:
            raise SystemExit(f"{own['name']}: {quantity} is not within a thousandth of {near}")
        while high - low > 4e-7:
            middle = (low + high) / 2
            low, high = (middle, high) if overturns(program, folder, own, middle) == before else (low, middle)
        answers[quantity] = bracket({"value": (low + high) / 2, "error": (high - low) / 2}, PEAK_DIGITS)
    return entry(own, **files), answers


def make_many(program, folder, own):
    name = f"{own['name']}.csv"
    lines = [f"{block},{text(x)},{text(y)}\n" for block, outline in own["blocks"].items() for x, y in outline]
    (folder / PLACE / name).write_text("block,x_m,y_m\n" + "".join(lines))
    return entry(own, blocks=name), many_answers(solve(program, folder, own, many_scene(own)))


def make_solid(program, folder, own):
    name = f"{own['name']}.obj"
    points, faces = own["solid"]
    lines = [f"v {' '.join(map(text, p))}\n" for p in points] + [f"f {' '.join(str(k + 1) for k in face)}\n" for face in faces]
    (folder / PLACE / name).write_text("".join(lines))
    return entry(own, solid=name), solid_answers(own, asked(program, folder / PLACE, "solid", "--json", "--unit=m", "--band=0",
                                                            f"--friction={own['friction_deg']}", "--azimuths=4", name))


def rows(table):
    """JSON with one case a line, which a difference shows well."""
    return "{\n" + ",\n".join(f" {json.dumps(name)}: {json.dumps(own)}" for name, own in table.items()) + "\n}\n"


def make(program, folder, names=()):
    """Write all files into the folder; manifest and answers hold the cases that were made."""
    manifest, answers = {}, {}
    (folder / PLACE).mkdir(exist_ok=True)
    for made, found in (
            (make_single, cases.single()), (make_single, cases_placed.placed()), (make_fall, cases_falls.let_go()),
            (make_shaken, cases_shaken.let_shake()), (make_many, cases_blocks.many()), (make_solid, cases_solids.solids())):
        for own in found:
            if not names or own["name"] in names:
                manifest[own["name"]], answers[own["name"]] = made(program, folder, own)
    (folder / "manifest.json").write_text(rows(manifest))
    (folder / "answers.json").write_text(rows(answers))


if __name__ == "__main__":
    if len(sys.argv) < 2:
        raise SystemExit(__doc__)
    make(str(pathlib.Path(sys.argv[1]).resolve()),
         pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else pathlib.Path(__file__).parent, sys.argv[3:])
